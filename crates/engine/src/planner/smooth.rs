//! A pace smoothed, so that its acceleration does not jump: the mean over a window of time.
//!
//! What speeds up by a and cruises becomes, over a window of a/j, the shortest pace with the jerk j.
//! The mean of piecewise cubics is one of higher degree between twice as many knots; of a pace whose
//! acceleration is constant in pieces it is cubic, so knots with their rates are all of it.

use super::course::Course;
use super::track::Knot;
use crate::error::{Result, vec_with_room};
use crate::math::monotone_cubic::{cubic, slope, value};

/// Sections that are flown without rest, one after the other: their knots as one pace, its way in
/// shares of the first section, as fast as that where sections meet.
#[derive(Debug)]
pub(super) struct Flight {
    /// How far before each section, and behind the last.
    begins: Vec<f64>,
    /// What the sections' shares are in shares of the first.
    scales: Vec<f64>,
    knots: Vec<Knot>,
    /// Areas below the way up to each knot.
    areas: Vec<f64>,
    /// Whether the end is the beginning again; else it rests at both.
    ring: bool,
}

impl Flight {
    /// Of the knots of each section, and the squares of the rates of each by the one before it.
    pub(super) fn new(sections: &[Vec<Knot>], gains: &[f64], ring: bool) -> Result<Self> {
        let count = sections.iter().map(Vec::len).sum();
        let mut flight = Self {
            begins: vec_with_room(sections.len() + 1)?,
            scales: vec_with_room(sections.len())?,
            knots: vec_with_room(count)?,
            areas: vec_with_room(count)?,
            ring,
        };
        let (mut way, mut time, mut scale) = (0.0, 0.0, 1.0);
        for (k, section) in sections.iter().enumerate() {
            if k > 0 {
                scale /= gains[k].sqrt();
            }
            flight.begins.push(way);
            flight.scales.push(scale);
            for knot in &section[usize::from(k > 0)..] {
                flight
                    .knots
                    .push([time + knot[0], way + knot[1] * scale, knot[2] * scale]);
            }
            time += section[section.len() - 1][0];
            way += scale;
        }
        flight.begins.push(way);
        let mut area = 0.0;
        flight.areas.push(area);
        for k in 1..flight.knots.len() {
            area += flight.area_of(k, 1.0);
            flight.areas.push(area);
        }
        Ok(flight)
    }

    fn piece(&self, k: usize) -> (f64, [f64; 4]) {
        let (from, to) = (self.knots[k - 1], self.knots[k]);
        let time = to[0] - from[0];
        (time, cubic(from[1], to[1] - from[1], time, from[2], to[2]))
    }

    /// The area below the piece that ends with a knot, up to a share of it.
    fn area_of(&self, k: usize, x: f64) -> f64 {
        let (time, c) = self.piece(k);
        time * x * (c[0] + x * (c[1] / 2.0 + x * (c[2] / 3.0 + x * c[3] / 4.0)))
    }

    fn seconds(&self) -> f64 {
        self.knots[self.knots.len() - 1][0]
    }

    fn way(&self) -> f64 {
        self.begins[self.begins.len() - 1]
    }

    /// Way and area below it at any time.
    fn at(&self, time: f64) -> [f64; 2] {
        let (all, way) = (self.seconds(), self.way());
        let last = self.areas[self.areas.len() - 1];
        if self.ring {
            let laps = (time / all).floor();
            let [within, area] = self.within((time - laps * all).clamp(0.0, all));
            let before = laps * last + way * all * 0.5 * laps * (laps - 1.0);
            let rest = time - laps * all;
            return [laps * way + within, before + area + laps * way * rest];
        }
        if time <= 0.0 {
            [0.0; 2]
        } else if time >= all {
            [way, last + way * (time - all)]
        } else {
            self.within(time)
        }
    }

    fn within(&self, time: f64) -> [f64; 2] {
        let last = self.knots.len() - 1;
        let k = self.knots.partition_point(|knot| knot[0] <= time);
        let k = k.clamp(1, last);
        let (length, c) = self.piece(k);
        let x = ((time - self.knots[k - 1][0]) / length).clamp(0.0, 1.0);
        [value(&c, x), self.areas[k - 1] + self.area_of(k, x)]
    }

    /// The mean over a window of seconds: between two rests as much longer.
    pub(super) fn smoothed(&self, window: f64) -> Result<Vec<Knot>> {
        let all = self.seconds();
        let (from, to) = if self.ring {
            (0.0, all)
        } else {
            (-0.5 * window, all + 0.5 * window)
        };
        let mut times: Vec<f64> = vec_with_room(6 * self.knots.len() + 2)?;
        for knot in &self.knots {
            for side in [-0.5, 0.5] {
                let time = knot[0] + side * window;
                let laps = if self.ring {
                    [-all, 0.0, all]
                } else {
                    [0.0; 3]
                };
                let inside = laps.iter().map(|lap| time + lap);
                times.extend(inside.filter(|time| *time > from && *time < to));
            }
        }
        times.push(from);
        times.push(to);
        times.sort_unstable_by(f64::total_cmp);
        let near = 1e-3 * window;
        let mut found: Vec<Knot> = vec_with_room(times.len())?;
        for time in times {
            if found
                .last()
                .is_some_and(|last| time - from - last[0] < near)
            {
                if time < to {
                    continue;
                }
                found.pop();
            }
            let [ahead, behind] = [0.5, -0.5].map(|side| self.at(time + side * window));
            let way = (ahead[1] - behind[1]) / window;
            found.push([time - from, way, ((ahead[0] - behind[0]) / window).max(0.0)]);
        }
        if !self.ring {
            let last = found.len() - 1;
            found[0] = [0.0; 3];
            found[last] = [to - from, self.way(), 0.0];
        }
        Ok(found)
    }

    /// A pace of the whole, as one of each section. Of a ring it begins where that does.
    pub(super) fn cut(&self, knots: &[Knot]) -> Result<Vec<Vec<Knot>>> {
        let sections = self.scales.len();
        let mut found = vec_with_room(sections)?;
        let mut next = 0;
        // Smoothed, the first place of a ring is reached a little earlier or later.
        let first = if self.ring {
            ahead_of(knots, self.begins[0])
        } else {
            knots[0]
        };
        let mut begin = first;
        for k in 0..sections {
            let (way, scale) = (self.begins[k], self.scales[k]);
            let end = match k + 1 < sections {
                true => ahead_of(knots, self.begins[k + 1]),
                false if self.ring => {
                    let all = self.seconds();
                    [first[0] + all, first[1] + self.way(), first[2]]
                }
                false => knots[knots.len() - 1],
            };
            let mut section: Vec<Knot> = vec_with_room(knots.len() + 2)?;
            let own = |knot: Knot| [knot[0] - begin[0], (knot[1] - way) / scale, knot[2] / scale];
            section.push([0.0, 0.0, begin[2] / scale]);
            let near = 1e-9 * (end[0] - begin[0]);
            let lap = [self.seconds(), self.way()];
            loop {
                let wrapped = next >= knots.len();
                let knot = match knots.get(next % knots.len()) {
                    Some(knot) if wrapped && self.ring && next < 2 * knots.len() => {
                        [knot[0] + lap[0], knot[1] + lap[1], knot[2]]
                    }
                    Some(knot) if !wrapped => *knot,
                    _ => break,
                };
                if knot[0] >= end[0] - near {
                    break;
                }
                if knot[0] > begin[0] + near {
                    let made = own(knot);
                    if section[section.len() - 1][0] < made[0] - near {
                        section.push(made);
                    }
                }
                next += 1;
            }
            section.push([end[0] - begin[0], 1.0, end[2] / scale]);
            found.push(section);
            begin = end;
        }
        Ok(found)
    }
}

/// Where a pace reaches a way. Before its first knot: as fast as there.
fn ahead_of(knots: &[Knot], way: f64) -> Knot {
    let k = knots.partition_point(|knot| knot[1] < way);
    if k == 0 || k == knots.len() {
        let knot = knots[k.min(knots.len() - 1)];
        let time = if knot[2] > 0.0 {
            (way - knot[1]) / knot[2]
        } else {
            0.0
        };
        return [knot[0] + time, way, knot[2]];
    }
    let (from, to) = (knots[k - 1], knots[k]);
    let time = to[0] - from[0];
    let c = cubic(from[1], to[1] - from[1], time, from[2], to[2]);
    let mut ends = [0.0, 1.0];
    for _ in 0..60 {
        let x = 0.5 * (ends[0] + ends[1]);
        ends[usize::from(value(&c, x) >= way)] = x;
    }
    let x = 0.5 * (ends[0] + ends[1]);
    [from[0] + x * time, way, slope(&c, x) / time]
}

/// Places in a frame at which the acceleration is looked at.
const STEPS: usize = 10;

/// The greatest third difference over frames, at any phase of them, of a flight through sections,
/// for one frame as seconds.
pub(super) fn jerk(
    sections: &[Vec<Knot>],
    courses: &[&Course],
    ring: bool,
    fps: f64,
) -> Result<f64> {
    let step = 1.0 / fps / STEPS as f64;
    let seconds: f64 = sections.iter().map(|knots| knots[knots.len() - 1][0]).sum();
    let count = (seconds / step).ceil() as usize + 1;
    let around = 3 * STEPS;
    let mut all = vec_with_room(count + 2 * around)?;
    all.resize(around, glam::DVec3::ZERO);
    let (mut begin, mut time) = (0.0, 0.5 * step);
    for (knots, course) in sections.iter().zip(courses) {
        let last = knots.len() - 1;
        let mut k = 1;
        while time < begin + knots[last][0] {
            while k < last && begin + knots[k][0] < time {
                k += 1;
            }
            let (from, to) = (knots[k - 1], knots[k]);
            let length = to[0] - from[0];
            let c = cubic(from[1], to[1] - from[1], length, from[2], to[2]);
            let x = ((time - begin - from[0]) / length).clamp(0.0, 1.0);
            let rate = slope(&c, x) / length;
            let change = (6.0 * c[3] * x + 2.0 * c[2]) / (length * length);
            let ask = course.at(value(&c, x));
            all.push(ask.tangent * change + ask.bend * rate * rate);
            time += step;
        }
        begin += knots[last][0];
    }
    let end = all.len();
    if ring && end >= 2 * around {
        for k in 0..around {
            let at = end - around + k;
            all[k] = all[at];
            let first = all[around + k];
            all.push(first);
        }
    } else {
        all.resize(end + around, glam::DVec3::ZERO);
    }
    // The acceleration over frames is a mean over two windows of one frame each.
    for _ in 0..2 {
        let mut sum: glam::DVec3 = all[..STEPS].iter().sum();
        for k in 0..all.len() - STEPS {
            let first = all[k];
            let next = all[k + STEPS];
            all[k] = sum / STEPS as f64;
            sum += next - first;
        }
        all.truncate(all.len() - STEPS);
    }
    let differences = all.iter().zip(&all[STEPS.min(all.len())..]);
    let most = differences.fold(0.0_f64, |most, (a, b)| most.max((*b - *a).length()));
    Ok(most * fps)
}
