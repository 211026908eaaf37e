//! Straight lines with round caps, anti-aliased by coverage.
//!
//! A line is traversed pixel by pixel along its major axis. In thin slices across, both borders are
//! known exactly, and so is the covered part of each pixel; a pixel's coverage is the mean of its
//! slices. A border climbs at most one pixel per pixel, so with four slices the error is at most
//! 1/128 where it enters another pixel. The caps climb faster and take eight.
//!
//! Where a polyline continues, neither piece has a cap: the joint's pixel belongs to one of them,
//! whose borders remain straight. Two caps would cost more than everything between them, and blend
//! twice at their rims.

use egui::Color32;
use glam::Vec4;

use super::lines::Line;
use super::tile::{Blend, FULL, Ink, PixelRect, SIDE, Tile};

const SLICES: usize = 4;

/// The middles of a pixel's slices.
const MIDDLES: Vec4 = Vec4::new(0.125, 0.375, 0.625, 0.875);

/// Pixels computed at a time.
const RUN: usize = 4;

/// The greatest width, in pixels.
const THICKEST: f32 = 1e6;

/// Within this many pixels of the tile, 32-bit floats are exact enough.
const NEAR: f32 = 2048.0;

/// The greatest change of slope at a joint; the border is off by as many pixels at its end.
const BEND: f32 = 0.2;

/// Only lines up to this size, in pixels, are joined: the outside of a thick joint is round, and
/// long lines are clipped near a tile.
const JOINED_WIDTH: f32 = 4.0;
const JOINED_LENGTH: f32 = 1000.0;

#[derive(Clone, Copy)]
pub(super) struct Stroke {
    /// The coordinates of both ends, in pixels.
    x: [f32; 2],
    y: [f32; 2],
    radius: f32,
    color: Color32,
    joined: [bool; 2],
}

/// Whether the second line continues the first with a bend so small that both are painted as one.
pub(super) fn joined(first: &Line, second: &Line, pixels_per_point: f32) -> bool {
    // Plain floats, because egui's comparison rejects NaN.
    let [end, start] = [first.to, second.from].map(|at| (at.x, at.y));
    if end != start || first.width != second.width || first.color != second.color {
        return false;
    }
    let [a, b] = [first, second].map(|line| (line.to - line.from) * pixels_per_point);
    // Along the major axis and across.
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
    /// `joined` is whether another line continues at each end. `None` if there is nothing to see.
    #[inline]
    pub(super) fn new(line: &Line, joined: [bool; 2], pixels_per_point: f32) -> Option<Self> {
        let scale = pixels_per_point;
        let (x0, y0) = (line.from.x * scale, line.from.y * scale);
        let (x1, y1) = (line.to.x * scale, line.to.y * scale);
        let width = line.width * scale;
        // The sum of squares reveals NaN, infinities and absurdly large values.
        let size = x0 * x0 + y0 * y0 + x1 * x1 + y1 * y1;
        if !size.is_finite() || !(width > 0.0) {
            return None;
        }
        // Below one pixel, lower the opacity instead of the width.
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

    #[inline]
    pub(super) fn bounds(&self) -> PixelRect {
        // Rounded outwards by up to one extra pixel. `far` keeps the sums within i32.
        let far = (1 << 30) as f32;
        // Joined ends extend to the end of the joint's pixel, by less than one.
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

    pub(super) fn touches(&self, cut: PixelRect) -> bool {
        // Compares the corners with the infinite line, in f64 so that rounding loses no pixel.
        let [x, y] = [self.x, self.y].map(|v| v.map(f64::from));
        let (dx, dy) = (x[1] - x[0], y[1] - y[0]);
        let middle = [cut.x0 + cut.x1, cut.y0 + cut.y1].map(|v| f64::from(v) * 0.5);
        let half = [cut.x1 - cut.x0, cut.y1 - cut.y0].map(|v| f64::from(v) * 0.5);
        let beside = (middle[0] - x[0]) * dy - (middle[1] - y[0]) * dx;
        let reach = half[0] * dy.abs() + half[1] * dx.abs();
        let radius = f64::from(self.radius) + 0.01;
        beside.abs() <= reach + radius * (dx * dx + dy * dy).sqrt()
    }

    pub(super) fn paint(&self, tile: &mut Tile, cut: PixelRect) {
        let cut = cut.intersect(self.bounds());
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
        match ink.blend() {
            Blend::Opaque => band.paint(pixels, cut, along, |a, b| ink.over_opaque(a, b)),
            Blend::Translucent => band.paint(pixels, cut, along, |a, b| ink.over_translucent(a, b)),
            Blend::Additive => band.paint_additive(pixels, cut, along, &ink),
        }
    }

    /// The ends relative to the tile; a line that extends far beyond is shortened.
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
        // The part of the line, 0…1, within reach of the tile.
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

/// Index steps along the axes of a [`Band`].
#[derive(Clone, Copy)]
struct Along {
    p: usize,
    q: usize,
}

/// A line along its major axis `p`, from (p0, q0) to (p1, q1) with p0 ≤ p1.
struct Band {
    p0: f32,
    q0: f32,
    p1: f32,
    radius: f32,
    slope: f32,
    /// The offset along `p` from a disc's centre to where it touches the upper border.
    lean: f32,
    /// Whether it continues before p0 and after p1.
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

    /// The line is the area swept by a disc. For each slice, returns the centre of the disc that
    /// reaches farthest, and how far: towards the upper border for `lean`, the lower for `-lean`.
    #[inline(always)]
    fn farthest(&self, p: Vec4, lean: f32) -> (Vec4, Vec4) {
        let (p0, p1) = (Vec4::splat(self.p0), Vec4::splat(self.p1));
        let middle = (p - lean).max(p0).min(p1);
        let beside = p - middle;
        let square = Vec4::splat(self.radius * self.radius) - beside * beside;
        let q = (middle - p0) * self.slope + self.q0;
        (q, square.max(Vec4::ZERO).sqrt())
    }

    /// The borders in slices anywhere; outside the line they enclose nothing.
    #[inline(always)]
    fn borders(&self, p: Vec4) -> (Vec4, Vec4) {
        let (upper, up) = self.farthest(p, self.lean);
        let (lower, down) = self.farthest(p, -self.lean);
        (upper - up, lower + down)
    }

    /// `cut` has p as x and q as y; `over` blends the colour over a pixel with a weight.
    #[inline(always)]
    fn paint(
        &self,
        pixels: &mut [u32; SIDE * SIDE],
        cut: PixelRect,
        along: Along,
        over: impl Fn(u32, u32) -> u32,
    ) {
        // Both borders are straight from `first` to `last`. A joint's pixel belongs to the line
        // that ends there.
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

    /// Not inlined, because colours that add light are rare.
    #[inline(never)]
    fn paint_additive(
        &self,
        pixels: &mut [u32; SIDE * SIDE],
        cut: PixelRect,
        along: Along,
        ink: &Ink,
    ) {
        self.paint(pixels, cut, along, |a, b| ink.over_additive(a, b));
    }

    #[inline(always)]
    fn end(
        &self,
        pixels: &mut [u32; SIDE * SIDE],
        cut: PixelRect,
        step: i32,
        along: Along,
        over: &impl Fn(u32, u32) -> u32,
    ) {
        // The slices divide the part of the pixel that the line reaches.
        let start = (step as f32).max(self.p0 - self.radius);
        let width = (step as f32 + 1.0).min(self.p1 + self.radius) - start;
        // The bounds are slightly too wide.
        if width <= 0.0 {
            return;
        }
        let near = MIDDLES * (0.5 * width) + start;
        let borders = [self.borders(near), self.borders(near + 0.5 * width)];
        lay(pixels, cut, step, borders, width, along, over);
    }
}

/// Paints the pixels of one step; `share` is the part of the step that the slices cover.
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
        // No check for zero weights: mispredicted branches cost more. A zero weight changes no
        // pixel, not even one wrapped around the tile's end.
        for weight in weights(&borders, q, share) {
            let pixel = &mut pixels[at % (SIDE * SIDE)];
            *pixel = over(*pixel, weight);
            at += along.q;
        }
        q += RUN as f32;
    }
}

#[inline(always)]
fn up(v: f32, low: i32, high: i32) -> i32 {
    let v = v.max(low as f32).min(high as f32);
    let whole = v as i32;
    whole + i32::from((whole as f32) < v)
}

/// Adding this to a small number rounds it to an integer in the sum's lowest bits.
const WHOLE: f32 = (3 << 22) as f32;

/// The largest integer below `v`, or `v` itself or one less if it is whole. For 0 ≤ v ≤ 4096.
#[inline(always)]
fn below(v: f32) -> u32 {
    (v - 0.5 + WHOLE).to_bits() - WHOLE.to_bits()
}

/// The coverage of [`RUN`] pixels from `q`, where full coverage in one slice counts `share`.
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
