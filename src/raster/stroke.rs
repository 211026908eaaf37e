//! Straight lines with round ends, each pixel by how much of it is covered.
//!
//! A line is walked along the axis that it runs more along. In thin slices
//! across, its two borders are known exactly, so that the share of every pixel
//! in the slice is too; a pixel's coverage is the mean of its slices.

use egui::Color32;

use super::lines::Line;
use super::tile::{self, Cut, SIDE, Tile};

/// Slices for each pixel.
const SLICES: usize = 8;

/// Lines are not thicker than this, in pixels.
const THICKEST: f64 = 1e6;

/// A line in the target.
pub(super) struct Stroke {
    /// Steep: x and y are exchanged below.
    steep: bool,
    /// The ends along the axis, the first one lower, and across it.
    p: [f64; 2],
    q: [f64; 2],
    radius: f64,
    color: Color32,
}

impl Stroke {
    /// `None` if nothing is to be seen.
    #[inline]
    pub(super) fn new(line: &Line, pixels_per_point: f32) -> Option<Self> {
        let scale = f64::from(pixels_per_point);
        let [x0, y0, x1, y1, width] = [line.from.x, line.from.y, line.to.x, line.to.y, line.width]
            .map(|v| f64::from(v) * scale);
        let sum = x0 + y0 + x1 + y1;
        if !sum.is_finite() || !(width > 0.0) {
            return None;
        }
        // What is thinner than a pixel becomes as much paler.
        let paler = |c: u8| (f64::from(c) * width.min(1.0) + 0.5) as u8;
        let [r, g, b, a] = line.color.to_array().map(paler);
        if [r, g, b, a] == [0; 4] {
            return None;
        }
        let steep = (y1 - y0).abs() > (x1 - x0).abs();
        let (mut p, mut q) = if steep {
            ([y0, y1], [x0, x1])
        } else {
            ([x0, x1], [y0, y1])
        };
        if p[0] > p[1] {
            p.swap(0, 1);
            q.swap(0, 1);
        }
        Some(Self {
            steep,
            p,
            q,
            radius: 0.5 * width.clamp(1.0, THICKEST),
            color: Color32::from_rgba_premultiplied(r, g, b, a),
        })
    }

    /// The pixels among which the line's are.
    pub(super) fn bounds(&self) -> Cut {
        // The conversion stops at the ends of the numbers, the addition before.
        let low = |v: f64| ((v - self.radius).floor() as i32).max(i32::MIN / 2);
        let high = |v: f64| ((v + self.radius).ceil() as i32).min(i32::MAX / 2);
        let (p0, p1) = (low(self.p[0]), high(self.p[1]));
        let (q0, q1) = (
            low(self.q[0].min(self.q[1])),
            high(self.q[0].max(self.q[1])),
        );
        self.turned(Cut {
            x0: p0,
            y0: q0,
            x1: p1,
            y1: q1,
        })
    }

    /// From x and y to along and across, or back.
    fn turned(&self, cut: Cut) -> Cut {
        if !self.steep {
            return cut;
        }
        Cut {
            x0: cut.y0,
            y0: cut.x0,
            x1: cut.y1,
            y1: cut.x1,
        }
    }

    fn slope(&self) -> f64 {
        let along = self.p[1] - self.p[0];
        if along > 0.0 {
            (self.q[1] - self.q[0]) / along
        } else {
            0.0
        }
    }

    /// Whether the line may come into a rectangle.
    pub(super) fn touches(&self, cut: Cut) -> bool {
        let cut = self.turned(cut);
        let slope = self.slope();
        let reach = self.radius * (1.0 + slope * slope).sqrt();
        let across = |p: i32| self.q[0] + slope * (f64::from(p) - self.p[0]);
        let (a, b) = (across(cut.x0), across(cut.x1));
        a.min(b) - reach < f64::from(cut.y1) && a.max(b) + reach > f64::from(cut.y0)
    }

    /// Paints the pixels within a rectangle that lies in the tile.
    pub(super) fn paint(&self, tile: &mut Tile, cut: Cut) {
        let cut = self.turned(cut.and(self.bounds()));
        if cut.is_empty() {
            return;
        }
        let slope = self.slope();
        let r = self.radius;
        let long = (1.0 + slope * slope).sqrt();
        let (reach, lean) = (r * long, r * slope / long);
        let mut coverage = [0_u8; SIDE];
        for step in cut.x0..cut.x1 {
            // Where the borders are in each slice.
            let mut borders = [(0.0, 0.0); SLICES];
            let (mut lowest, mut highest) = (f64::MAX, f64::MIN);
            for (i, border) in borders.iter_mut().enumerate() {
                let p = f64::from(step) + (i as f64 + 0.5) / SLICES as f64;
                let arc = |end: usize| {
                    let d = p - self.p[end];
                    (r * r - d * d).max(0.0).sqrt()
                };
                let middle = self.q[0] + slope * (p - self.p[0]);
                if p <= self.p[0] - r || p >= self.p[1] + r {
                    continue;
                }
                let low = if p < self.p[0] + lean {
                    self.q[0] - arc(0)
                } else if p > self.p[1] + lean {
                    self.q[1] - arc(1)
                } else {
                    middle - reach
                };
                let high = if p < self.p[0] - lean {
                    self.q[0] + arc(0)
                } else if p > self.p[1] - lean {
                    self.q[1] + arc(1)
                } else {
                    middle + reach
                };
                *border = (low, high);
                lowest = lowest.min(low);
                highest = highest.max(high);
            }
            if lowest >= highest {
                continue;
            }
            let from = (lowest.floor() as i32).max(cut.y0);
            let to = (highest.ceil() as i32).min(cut.y1);
            for q in from..to {
                let near = f64::from(q);
                let sum: f64 = borders
                    .iter()
                    .map(|&(low, high)| (high.min(near + 1.0) - low.max(near)).max(0.0))
                    .sum();
                coverage[(q - from) as usize] = (sum * (255.0 / SLICES as f64) + 0.5) as u8;
            }
            if from >= to {
                continue;
            }
            let coverage = &coverage[..(to - from) as usize];
            if self.steep {
                tile::cover(tile.span(step, from, to), coverage, self.color);
            } else {
                for (q, coverage) in (from..to).zip(coverage) {
                    let coverage = std::slice::from_ref(coverage);
                    tile::cover(tile.span(q, step, step + 1), coverage, self.color);
                }
            }
        }
    }
}
