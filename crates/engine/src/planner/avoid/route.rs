//! A way through free space from one place to another: the shortest over a grid (Hart, Nilsson and
//! Raphael 1968), whose lines are held against the object itself, then pulled taut. Coarse and near
//! first, at last fine and all around the object.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use glam::DVec3;

use super::field::Field;
use crate::error::{Result, vec_with_room};

/// Room left around the way, in sizes of its box, and cells of its longest side; the last two: all
/// around the object.
const LEVELS: [(Option<f64>, f64); 4] = [
    (Some(0.6), 24.0),
    (Some(2.0), 40.0),
    (None, 48.0),
    (None, 96.0),
];

/// Places after which it is tried from the other end, where there may be less room.
const TURN: usize = 3000;

/// Times a line is pulled taut.
const PULLS: usize = 3;

pub(super) struct Router<'a> {
    pub field: Field<'a>,
    /// The movement space, which a way leaves only where it must.
    pub space: [DVec3; 2],
    /// What must be kept.
    pub need: f64,
}

/// What a search comes to.
enum Found {
    Way(Vec<DVec3>),
    Nothing,
    Unknown,
}

struct Grid {
    origin: DVec3,
    step: f64,
    low: [i64; 3],
    count: [i64; 3],
}

impl Grid {
    fn new(origin: DVec3, [low, high]: [DVec3; 2], cells: f64, least: f64) -> Self {
        let step = ((high - low).max_element() / cells).max(least);
        let lows = ((low - origin) / step).floor().to_array().map(|x| x as i64);
        let highs = ((high - origin) / step).ceil().to_array().map(|x| x as i64);
        Self {
            origin,
            step,
            low: lows,
            count: [0, 1, 2].map(|axis| (highs[axis] - lows[axis] + 1).max(1)),
        }
    }

    fn len(&self) -> usize {
        self.count.iter().product::<i64>() as usize
    }

    fn at(&self, index: usize) -> [i64; 3] {
        let index = index as i64;
        let [x, y, _] = self.count;
        [index % x, index / x % y, index / (x * y)]
    }

    fn index(&self, at: [i64; 3]) -> Option<usize> {
        let inside = (0..3).all(|axis| (0..self.count[axis]).contains(&at[axis]));
        let [x, y, _] = self.count;
        inside.then(|| (at[0] + x * (at[1] + y * at[2])) as usize)
    }

    fn place(&self, index: usize) -> DVec3 {
        let at = self.at(index);
        let steps = [0, 1, 2].map(|axis| (self.low[axis] + at[axis]) as f64);
        self.origin + self.step * DVec3::from_array(steps)
    }
}

impl Router<'_> {
    /// A taut way that keeps `clear`, at its ends as far as they have it. `around` is a box that it
    /// will not have to leave by far. None if the finest grid has no route.
    pub(super) fn way(
        &self,
        [from, to]: [DVec3; 2],
        around: [DVec3; 2],
        clear: f64,
    ) -> Result<Option<Vec<DVec3>>> {
        let level = |p: DVec3| self.field.far(p, clear).min(clear);
        let ends = [level(from), level(to)];
        if self.field.is_free(from, to, ends[0].min(ends[1])) {
            let mut line = vec_with_room(2)?;
            line.extend([from, to]);
            return Ok(Some(line));
        }
        let inside = |p: DVec3| p.cmpge(self.space[0]).all() && p.cmple(self.space[1]).all();
        let passes = if inside(from) && inside(to) {
            &[true, false][..]
        } else {
            &[false]
        };
        let object = self.field.object.bounds();
        for &within in passes {
            for (room, cells) in LEVELS {
                let size = (around[1] - around[0]).max_element();
                let mut area = match room {
                    Some(room) => {
                        let room = room * size + 3.0 * clear;
                        [around[0] - room, around[1] + room]
                    }
                    None => {
                        let room = 3.0 * clear + 0.02 * (object[1] - object[0]).max_element();
                        [
                            around[0].min(object[0]) - room,
                            around[1].max(object[1]) + room,
                        ]
                    }
                };
                if within {
                    area = [area[0].max(self.space[0]), area[1].min(self.space[1])];
                }
                let search = |ends: [DVec3; 2], most: usize| {
                    let grid = Grid::new(ends[0], area, cells, 0.2 * clear);
                    self.search(&grid, ends, clear, most)
                };
                let found = match search([from, to], TURN)? {
                    Found::Unknown => match search([to, from], usize::MAX)? {
                        Found::Way(mut line) => {
                            line.reverse();
                            Found::Way(line)
                        }
                        other => other,
                    },
                    other => other,
                };
                if let Found::Way(line) = found {
                    return self.taut(line, clear, ends).map(Some);
                }
            }
        }
        Ok(None)
    }

    fn search(
        &self,
        grid: &Grid,
        [from, to]: [DVec3; 2],
        clear: f64,
        most: usize,
    ) -> Result<Found> {
        let count = grid.len();
        let mut costs = vec_with_room(count)?;
        costs.resize(count, f64::INFINITY);
        let mut fars = vec_with_room(count)?;
        fars.resize(count, f64::NAN);
        let mut came = vec_with_room(count)?;
        came.resize(count, u32::MAX);
        let mut heap = BinaryHeap::new();
        let start = grid.low.map(|low| -low);
        let Some(start) = grid.index(start) else {
            return Ok(Found::Nothing);
        };
        costs[start] = 0.0;
        heap.try_reserve(1)?;
        heap.push((Reverse(from.distance(to).to_bits()), Reverse(start)));
        let mut done = 0;
        while let Some((Reverse(key), Reverse(index))) = heap.pop() {
            let here = grid.place(index);
            if f64::from_bits(key) > costs[index] + here.distance(to) {
                continue;
            }
            done += 1;
            if done > most {
                return Ok(Found::Unknown);
            }
            self.field.watch.check()?;
            if here.distance(to) <= 1.8 * grid.step && self.field.is_free(here, to, self.need) {
                let mut line = vec_with_room(2)?;
                line.push(to);
                let mut at = index as u32;
                while at != u32::MAX {
                    line.try_reserve(1)?;
                    line.push(grid.place(at as usize));
                    at = came[at as usize];
                }
                line.reverse();
                return Ok(Found::Way(line));
            }
            let keep = if index == start { self.need } else { clear };
            let known = if index == start {
                self.field.far(here, clear + 2.0 * grid.step)
            } else {
                fars[index]
            };
            let at = grid.at(index);
            for k in (0..27).filter(|k| *k != 13) {
                let [x, y, z] = [k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1];
                let Some(next) = grid.index([at[0] + x, at[1] + y, at[2] + z]) else {
                    continue;
                };
                let length = grid.step * ((x * x + y * y + z * z) as f64).sqrt();
                let cost = costs[index] + length;
                if cost >= costs[next] {
                    continue;
                }
                let there = grid.place(next);
                if fars[next].is_nan() {
                    fars[next] = self.field.far(there, clear + 2.0 * grid.step);
                }
                let far = fars[next];
                if far < clear
                    || (0.5 * (known + far - length) < keep
                        && !self.field.is_free(here, there, keep))
                {
                    continue;
                }
                costs[next] = cost;
                came[next] = index as u32;
                heap.try_reserve(1)?;
                let key = (cost + there.distance(to)).to_bits();
                heap.push((Reverse(key), Reverse(next)));
            }
        }
        Ok(Found::Nothing)
    }

    /// A line with fewer corners and shorter, as free as it was.
    fn taut(&self, mut line: Vec<DVec3>, clear: f64, ends: [f64; 2]) -> Result<Vec<DVec3>> {
        let (first, last) = (line[0], line[line.len() - 1]);
        let free = |a: DVec3, b: DVec3| {
            let mut keep = clear;
            for (end, level) in [first, last].into_iter().zip(ends) {
                if a == end || b == end {
                    keep = keep.min(level);
                }
            }
            self.field.is_free(a, b, keep)
        };
        for _ in 0..PULLS {
            let mut pulled = vec_with_room(line.len())?;
            pulled.push(line[0]);
            let (mut at, end) = (0, line.len() - 1);
            while at < end {
                let (mut best, mut beyond, mut step) = (at + 1, end + 1, 1);
                while best + 1 < beyond {
                    let next = if beyond > end {
                        (best + step).min(end)
                    } else {
                        usize::midpoint(best, beyond)
                    };
                    if free(line[at], line[next]) {
                        best = next;
                        step *= 2;
                    } else {
                        beyond = next;
                    }
                }
                at = best;
                pulled.push(line[at]);
            }
            for k in 1..pulled.len() - 1 {
                let (a, p, b) = (pulled[k - 1], pulled[k], pulled[k + 1]);
                let way = b - a;
                let share = (p - a).dot(way) / way.length_squared().max(f64::MIN_POSITIVE);
                let foot = a + way * share.clamp(0.0, 1.0);
                let mut ends = [0.0, 1.0];
                for _ in 0..6 {
                    let middle = 0.5 * (ends[0] + ends[1]);
                    let q = p.lerp(foot, middle);
                    ends[usize::from(!(free(a, q) && free(q, b)))] = middle;
                }
                pulled[k] = p.lerp(foot, ends[0]);
            }
            line = pulled;
        }
        Ok(line)
    }
}
