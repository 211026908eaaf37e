//! Straight lines with round ends, each pixel by how much of it is covered.
//!
//! A line is walked along the axis that it runs more along, pixel by pixel. In
//! thin slices across, its two borders are known exactly, and with them the
//! covered part of every pixel in the slice; a pixel's coverage is the mean of
//! its slices. A border climbs by at most one pixel for a pixel along, so that
//! four slices are off by at most 1/128 where it enters another pixel. The
//! round ends climb more and take eight.
//!
//! Where a curve's piece goes on in the next one, neither has an end: the pixel
//! of the joint is the one's, with its borders as straight as before. Two round
//! ends would cost more than all between them, and lie twice over their rims.

use egui::Color32;
use glam::Vec4;

use super::lines::Line;
use super::tile::{FULL, Ink, Kind, PixelRect, SIDE, Tile};

/// Slices for each pixel.
const SLICES: usize = 4;

/// Where a pixel's slices are.
const MIDDLES: Vec4 = Vec4::new(0.125, 0.375, 0.625, 0.875);

/// Pixels whose coverage is computed together.
const RUN: usize = 4;

/// Lines are not thicker than this, in pixels.
const THICKEST: f32 = 1e6;

/// Up to so many pixels from the tile, numbers of 32 bits are exact enough.
const NEAR: f32 = 2048.0;

/// Two lines are joined if from one to the other the slope differs by no more:
/// so far the border may be off, in pixels, at the end of the joint's pixel.
const BEND: f32 = 0.2;

/// What is joined is not thicker and not longer, in pixels: the outer side of a
/// thick joint is round, and of a long line only a part may be looked at.
const JOINED_WIDTH: f32 = 4.0;
const JOINED_LENGTH: f32 = 1000.0;

/// A line in the target.
#[derive(Clone, Copy)]
pub(super) struct Stroke {
    /// Both ends, in pixels.
    x: [f32; 2],
    y: [f32; 2],
    radius: f32,
    color: Color32,
    /// Whether another line goes on there.
    joined: [bool; 2],
}

/// Whether the second line goes on where the first one ends, so little bent
/// that both are one.
pub(super) fn joined(first: &Line, second: &Line, pixels_per_point: f32) -> bool {
    // Numbers, since egui does not compare NaN.
    let [end, start] = [first.to, second.from].map(|at| (at.x, at.y));
    if end != start || first.width != second.width || first.color != second.color {
        return false;
    }
    let [a, b] = [first, second].map(|line| (line.to - line.from) * pixels_per_point);
    // Along the axis and across.
    let flat = a.y.abs() <= a.x.abs();
    if flat != (b.y.abs() <= b.x.abs()) {
        return false;
    }
    let [a, b] = [a, b].map(|way| if flat { (way.x, way.y) } else { (way.y, way.x) });
    first.width * pixels_per_point <= JOINED_WIDTH
        && a.0 * b.0 > 0.0
        && a.0.abs().max(b.0.abs()) < JOINED_LENGTH
        && (a.1 / a.0 - b.1 / b.0).abs() <= BEND
}

impl Stroke {
    /// One that goes on before its beginning or behind its end; `None` if nothing is to
    /// be seen.
    #[inline]
    pub(super) fn new(line: &Line, joined: [bool; 2], pixels_per_point: f32) -> Option<Self> {
        let scale = pixels_per_point;
        let (x0, y0) = (line.from.x * scale, line.from.y * scale);
        let (x1, y1) = (line.to.x * scale, line.to.y * scale);
        let width = line.width * scale;
        // A sum of squares: NaN and infinities show in it, and
        // such as are beyond all sense.
        let size = x0 * x0 + y0 * y0 + x1 * x1 + y1 * y1;
        if !size.is_finite() || !(width > 0.0) {
            return None;
        }
        // What is thinner than a pixel becomes as much paler.
        let color = if width < 1.0 {
            let paler = |c: u8| (f32::from(c) * width + 0.5) as u8;
            let [r, g, b, a] = line.color.to_array().map(paler);
            Color32::from_rgba_premultiplied(r, g, b, a)
        } else {
            line.color
        };
        (color != Color32::TRANSPARENT).then(|| Self {
            x: [x0, x1],
            y: [y0, y1],
            radius: 0.5 * width.clamp(1.0, THICKEST),
            color,
            joined,
        })
    }

    /// The pixels among which the line's are.
    #[inline]
    pub(super) fn bounds(&self) -> PixelRect {
        // Toward the outside, by up to one pixel more than needed. The sums
        // stay far inside of the numbers.
        let far = (1 << 30) as f32;
        // To the end of a joint's pixel it goes on by less than one.
        let reach = self.radius + f32::from(u8::from(self.joined != [false; 2]));
        let low = |a: f32, b: f32| ((a.min(b) - reach).max(-far) as i32) - 1;
        let high = |a: f32, b: f32| ((a.max(b) + reach).min(far) as i32) + 1;
        PixelRect {
            x0: low(self.x[0], self.x[1]),
            y0: low(self.y[0], self.y[1]),
            x1: high(self.x[0], self.x[1]),
            y1: high(self.y[0], self.y[1]),
        }
    }

    /// Whether the line may come into a rectangle.
    pub(super) fn touches(&self, cut: PixelRect) -> bool {
        // The rectangle's corners beside the line that goes on for ever. In
        // 64 bits, so that a rounding does not lose a pixel.
        let [x, y] = [self.x, self.y].map(|v| v.map(f64::from));
        let (dx, dy) = (x[1] - x[0], y[1] - y[0]);
        let middle = [cut.x0 + cut.x1, cut.y0 + cut.y1].map(|v| f64::from(v) * 0.5);
        let half = [cut.x1 - cut.x0, cut.y1 - cut.y0].map(|v| f64::from(v) * 0.5);
        let beside = (middle[0] - x[0]) * dy - (middle[1] - y[0]) * dx;
        let reach = half[0] * dy.abs() + half[1] * dx.abs();
        let radius = f64::from(self.radius) + 0.01;
        beside.abs() <= reach + radius * (dx * dx + dy * dy).sqrt()
    }

    /// Paints the pixels within a rectangle that lies in the tile.
    pub(super) fn paint(&self, tile: &mut Tile, cut: PixelRect) {
        let cut = cut.and(self.bounds());
        if cut.is_empty() {
            return;
        }
        let [[x0, x1], [y0, y1]] = self.seen_from(tile);
        let cut = PixelRect {
            x0: cut.x0 - tile.x,
            y0: cut.y0 - tile.y,
            x1: cut.x1 - tile.x,
            y1: cut.y1 - tile.y,
        };
        let (x, y) = ([x0, x1], [y0, y1]);
        if (y1 - y0).abs() > (x1 - x0).abs() {
            let turned = PixelRect {
                x0: cut.y0,
                y0: cut.x0,
                x1: cut.y1,
                y1: cut.x1,
            };
            let along = Along { p: SIDE, q: 1 };
            let band = Band::new(y, x, self.radius, self.joined);
            self.paint_band(&band, tile, turned, along);
        } else {
            let along = Along { p: 1, q: SIDE };
            let band = Band::new(x, y, self.radius, self.joined);
            self.paint_band(&band, tile, cut, along);
        }
    }

    #[inline(always)]
    fn paint_band(&self, band: &Band, tile: &mut Tile, cut: PixelRect, along: Along) {
        let ink = Ink::new(self.color);
        let pixels = tile.pixels();
        match ink.kind() {
            Kind::Opaque => band.paint(pixels, cut, along, |a, b| ink.over_opaque(a, b)),
            Kind::Clear => band.paint(pixels, cut, along, |a, b| ink.over_clear(a, b)),
            Kind::Glowing => band.paint_glowing(pixels, cut, along, &ink),
        }
    }

    /// The ends, from the tile's corner. Of a line that goes far beyond it
    /// only the part near the tile.
    fn seen_from(&self, tile: &Tile) -> [[f32; 2]; 2] {
        let (left, top) = (tile.x as f32, tile.y as f32);
        let x = self.x.map(|x| x - left);
        let y = self.y.map(|y| y - top);
        if x.iter().chain(&y).all(|v| v.abs() < NEAR) {
            return [x, y];
        }
        let from = |v: [f32; 2], start: i32| v.map(|v| f64::from(v) - f64::from(start));
        let (x, y) = (from(self.x, tile.x), from(self.y, tile.y));
        let reach = 2.0 * (f64::from(self.radius) + SIDE as f64);
        // The part of the line, 0…1, that lies within reach of the tile.
        let (mut start, mut end) = (0.0_f64, 1.0_f64);
        for v in [x, y] {
            let along = v[1] - v[0];
            if along != 0.0 {
                let (a, b) = ((-reach - v[0]) / along, (reach - v[0]) / along);
                start = start.max(a.min(b));
                end = end.min(a.max(b));
            }
        }
        let end = end.max(start);
        [x, y].map(|v| [start, end].map(|t| (v[0] + t * (v[1] - v[0])) as f32))
    }
}

/// From one pixel to the next along the axes of a [`Band`].
#[derive(Clone, Copy)]
struct Along {
    p: usize,
    q: usize,
}

/// A line along an axis `p`, flatter than the diagonal: from (p0, q0) to
/// (p1, q1), p0 ≤ p1.
struct Band {
    p0: f32,
    q0: f32,
    p1: f32,
    radius: f32,
    slope: f32,
    /// How far along the axis the place where a disc touches the upper border
    /// is from the disc's middle.
    lean: f32,
    /// Whether it goes on before p0 and behind p1.
    joined: [bool; 2],
}

impl Band {
    #[inline]
    fn new(p: [f32; 2], q: [f32; 2], radius: f32, joined: [bool; 2]) -> Self {
        let ([p0, p1], [q0, q1], joined) = if p[0] <= p[1] {
            (p, q, joined)
        } else {
            ([p[1], p[0]], [q[1], q[0]], [joined[1], joined[0]])
        };
        let along = p1 - p0;
        let slope = if along > 0.0 { (q1 - q0) / along } else { 0.0 };
        Self {
            p0,
            q0,
            p1,
            radius,
            slope,
            lean: radius * slope / (1.0 + slope * slope).sqrt(),
            joined,
        }
    }

    /// The line is what a disc passes over. This is the middle of the disc
    /// that goes farthest in each slice: to the upper border if `lean` is so,
    /// to the lower if it is reversed; and how far it goes.
    #[inline(always)]
    fn farthest(&self, p: Vec4, lean: f32) -> (Vec4, Vec4) {
        let (p0, p1) = (Vec4::splat(self.p0), Vec4::splat(self.p1));
        let middle = (p - lean).max(p0).min(p1);
        let beside = p - middle;
        let square = Vec4::splat(self.radius * self.radius) - beside * beside;
        let q = (middle - p0) * self.slope + self.q0;
        (q, square.max(Vec4::ZERO).sqrt())
    }

    /// The borders in slices anywhere; where the line is not, nothing is
    /// between them.
    #[inline(always)]
    fn borders(&self, p: Vec4) -> (Vec4, Vec4) {
        let (upper, up) = self.farthest(p, self.lean);
        let (lower, down) = self.farthest(p, -self.lean);
        (upper - up, lower + down)
    }

    /// Paints; `cut` has p as x and q as y. `over` lays the colour over a pixel by a
    /// weight.
    #[inline(always)]
    fn paint(
        &self,
        pixels: &mut [u32; SIDE * SIDE],
        cut: PixelRect,
        along: Along,
        over: impl Fn(u32, u32) -> u32,
    ) {
        // From here to there both borders are straight. A joint's pixel is the
        // line's that ends there.
        let bend = self.lean.abs();
        let first = self.p0 + if self.joined[0] { 0.0 } else { bend };
        let last = self.p1 - if self.joined[1] { 0.0 } else { bend + 1.0 };
        let first = up(first, cut.x0, cut.x1);
        let last = up(last, first, cut.x1);
        let half = Vec4::splat(self.radius * (1.0 + self.slope * self.slope).sqrt());
        let middles = MIDDLES * self.slope + self.q0;
        for step in first..last {
            let middle = middles + (step as f32 - self.p0) * self.slope;
            let borders = [(middle - half, middle + half)];
            lay(pixels, cut, step, borders, 1.0, along, &over);
        }
        let before = if self.joined[0] { first } else { cut.x0 };
        let behind = if self.joined[1] { last } else { cut.x1 };
        for step in (before..first).chain(last..behind) {
            self.end(pixels, cut, step, along, &over);
        }
    }

    /// Light is rarely added: one function for both directions.
    #[inline(never)]
    fn paint_glowing(
        &self,
        pixels: &mut [u32; SIDE * SIDE],
        cut: PixelRect,
        along: Along,
        ink: &Ink,
    ) {
        self.paint(pixels, cut, along, |a, b| ink.over_glowing(a, b));
    }

    /// Paints the pixels of one step where the line is round, in twice as
    /// many slices.
    #[inline(always)]
    fn end(
        &self,
        pixels: &mut [u32; SIDE * SIDE],
        cut: PixelRect,
        step: i32,
        along: Along,
        over: &impl Fn(u32, u32) -> u32,
    ) {
        // The slices lie in the part of the pixel that the line is in.
        let start = (step as f32).max(self.p0 - self.radius);
        let width = (step as f32 + 1.0).min(self.p1 + self.radius) - start;
        // The bounds are a little wide.
        if width <= 0.0 {
            return;
        }
        let near = MIDDLES * (0.5 * width) + start;
        let borders = [self.borders(near), self.borders(near + 0.5 * width)];
        lay(pixels, cut, step, borders, width, along, over);
    }
}

/// Paints the pixels of one step. `share` is the part of the step that the
/// slices stand for.
#[inline(always)]
fn lay<const N: usize>(
    pixels: &mut [u32; SIDE * SIDE],
    cut: PixelRect,
    step: i32,
    borders: [(Vec4, Vec4); N],
    share: f32,
    along: Along,
    over: &impl Fn(u32, u32) -> u32,
) {
    let (top, bottom) = (Vec4::splat(cut.y0 as f32), Vec4::splat(cut.y1 as f32));
    let borders = borders.map(|(low, high)| (low.max(top), high.min(bottom)));
    let (mut low, mut high) = borders[0];
    for border in &borders[1..] {
        (low, high) = (low.min(border.0), high.max(border.1));
    }
    let (lowest, highest) = (low.min_element(), high.max_element());
    let share = share * (FULL as f32 / (SLICES * N) as f32);
    let mut at = step as usize * along.p + below(lowest) as usize * along.q;
    let mut q = below(lowest) as f32;
    while q < highest {
        // Without a look whether there is anything to do: a guess that fails
        // costs more. No weight leaves a pixel as it is, also one that is met
        // by going beyond the tile's end.
        for weight in weights(&borders, q, share) {
            let pixel = &mut pixels[at % (SIDE * SIDE)];
            *pixel = over(*pixel, weight);
            at += along.q;
        }
        q += RUN as f32;
    }
}

/// The next higher whole number, within bounds.
#[inline(always)]
fn up(v: f32, low: i32, high: i32) -> i32 {
    let v = v.max(low as f32).min(high as f32);
    let whole = v as i32;
    whole + i32::from((whole as f32) < v)
}

/// A number that keeps no fractions when a small one is added: in the lowest
/// bits of the sum stands the small one, rounded to a whole number.
const WHOLE: f32 = (3 << 22) as f32;

/// The next lower whole number, or one less if the number is itself whole.
/// For 0 ≤ v ≤ 4096.
#[inline(always)]
fn below(v: f32) -> u32 {
    (v - 0.5 + WHOLE).to_bits() - WHOLE.to_bits()
}

/// How much of each of some pixels lies between the borders, of which each
/// slice counts `share` parts.
#[inline(always)]
fn weights(borders: &[(Vec4, Vec4)], q: f32, share: f32) -> [u32; RUN] {
    let near = Vec4::new(0.0, 1.0, 2.0, 3.0) + q;
    let far = near + 1.0;
    let covered = |low: f32, high: f32| {
        let part = far.min(Vec4::splat(high)) - near.max(Vec4::splat(low));
        part.max(Vec4::ZERO)
    };
    let mut sum = Vec4::ZERO;
    for &(low, high) in borders {
        sum += (covered(low.x, high.x) + covered(low.y, high.y))
            + (covered(low.z, high.z) + covered(low.w, high.w));
    }
    (sum * share + WHOLE)
        .to_array()
        .map(|part| part.to_bits() & 0xFFF)
}
