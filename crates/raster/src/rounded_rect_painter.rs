//! Rounded rectangles as pixels, by their coverage within the border and within the fill.
//!
//! In thin vertical slices the edges are known exactly, and so is the covered part of each pixel; a
//! pixel's coverage is the mean of its slices. Only the columns at the left and right, with the
//! corners, need this: between them, all pixels of a row have the same coverage.

use egui::Color32;
use glam::Vec4;

use super::hash::{bits, mix, pair};
use super::rounded_rect::RoundedRect;
use super::tile::{self, FULL, Ink, PixelRect, SIDE, Tile};

/// Coordinates are clamped to this many pixels.
const FAR: f32 = 1e6;

/// The middles of the slices in half a pixel.
const MIDDLES: Vec4 = Vec4::new(0.125, 0.375, 0.625, 0.875);

/// A rounded rectangle in pixels.
#[derive(Clone, Copy)]
struct PixelRoundedRect {
    x: [f32; 2],
    y: [f32; 2],
    /// Top left, top right, bottom left, bottom right.
    radii: [f32; 4],
}

/// A first pixel and an exclusive end.
type Range = (i32, i32);

/// A rounded rectangle ready to be painted into tiles.
pub(super) struct RoundedRectPainter {
    outer: PixelRoundedRect,
    /// The area within the border.
    inner: PixelRoundedRect,
    fill: Color32,
    border: Color32,
    /// The columns of pixels between the corners and the vertical border parts.
    across: Range,
    /// The rows between the corners and the horizontal border parts.
    down: Range,
}

fn up(v: f32) -> i32 {
    v.ceil() as i32
}

fn down(v: f32) -> i32 {
    v.floor() as i32
}

impl PixelRoundedRect {
    fn shrunk(&self, by: f32) -> Self {
        let [x, y] = [self.x, self.y].map(|[low, high]| {
            let middle = 0.5 * (low + high);
            [(low + by).min(middle), (high - by).max(middle)]
        });
        Self {
            x,
            y,
            radii: self.radii.map(|radius| (radius - by).max(0.0)),
        }
    }

    /// The part of a pixel between the left and right edge.
    fn beside(&self, x: i32) -> f32 {
        overlap(self.x, x)
    }

    /// The part of a pixel between the top and bottom edge.
    fn below(&self, y: i32) -> f32 {
        overlap(self.y, y)
    }

    /// One column of pixels in slices.
    fn column(&self, x: i32) -> Column {
        // The slices divide the covered part.
        let start = self.x[0].max(x as f32);
        let width = (self.x[1].min(x as f32 + 1.0) - start).max(0.0);
        let near = MIDDLES * (0.5 * width) + start;
        let slices = [near, near + 0.5 * width].map(|at| {
            let inset = |left: f32, right: f32| inset(self.x, at, left, right);
            let above = inset(self.radii[0], self.radii[1]);
            let below = inset(self.radii[2], self.radii[3]);
            (above + self.y[0], Vec4::splat(self.y[1]) - below)
        });
        Column { slices, width }
    }
}

/// The part of a pixel between two positions.
fn overlap([low, high]: [f32; 2], at: i32) -> f32 {
    let at = at as f32;
    (high.min(at + 1.0) - low.max(at)).max(0.0)
}

/// How far a rounded edge is inset from the straight one, in slices.
fn inset(x: [f32; 2], at: Vec4, left: f32, right: f32) -> Vec4 {
    let within = |radius: f32, way: Vec4| {
        // The distance into the corner.
        let beside = (Vec4::splat(radius) - way).clamp(Vec4::ZERO, Vec4::splat(radius));
        let square = Vec4::splat(radius * radius) - beside * beside;
        Vec4::splat(radius) - square.max(Vec4::ZERO).sqrt()
    };
    within(left, at - x[0]).max(within(right, Vec4::splat(x[1]) - at))
}

struct Column {
    /// Top and bottom edges in each slice.
    slices: [(Vec4, Vec4); 2],
    /// The part of the pixel's width that they cover.
    width: f32,
}

impl Column {
    /// The covered part of a pixel.
    #[inline]
    fn covered(&self, y: i32) -> f32 {
        let (top, bottom) = (Vec4::splat(y as f32), Vec4::splat(y as f32 + 1.0));
        let parts = self
            .slices
            .map(|(low, high)| (high.min(bottom) - low.max(top)).max(Vec4::ZERO));
        (parts[0] + parts[1]).element_sum() * (0.125 * self.width)
    }
}

impl RoundedRectPainter {
    /// `None` if there is nothing to see.
    pub(super) fn new(rounded_rect: &RoundedRect, pixels_per_point: f32) -> Option<Self> {
        let scaled = |at: f32| (at * pixels_per_point).clamp(-FAR, FAR);
        let (min, max) = (rounded_rect.rect.min, rounded_rect.rect.max);
        let outer = PixelRoundedRect {
            x: [scaled(min.x), scaled(max.x)],
            y: [scaled(min.y), scaled(max.y)],
            radii: rounded_rect.radii.map(|radius| scaled(radius).max(0.0)),
        };
        // NaN is rejected here, too.
        let real = outer.x[0] < outer.x[1] && outer.y[0] < outer.y[1];
        if !real || !outer.radii.iter().all(|radius| radius.is_finite()) {
            return None;
        }
        let border = scaled(rounded_rect.border).max(0.0);
        let inner = outer.shrunk(border);
        let [a, b, c, d] = outer.radii;
        let rim = |a: f32, b: f32| a.max(b).max(border);
        let between = |[low, high]: [f32; 2], start: f32, end: f32| {
            let start = up(low + start);
            (start, down(high - end).max(start))
        };
        Some(Self {
            across: between(outer.x, rim(a, c), rim(b, d)),
            down: between(outer.y, rim(a, b), rim(c, d)),
            outer,
            inner,
            fill: rounded_rect.fill,
            border: rounded_rect.border_color,
        })
    }

    /// A pixel rectangle that contains it.
    pub(super) fn bounds(&self) -> PixelRect {
        let PixelRoundedRect { x, y, .. } = self.outer;
        PixelRect {
            x0: down(x[0]),
            y0: down(y[0]),
            x1: up(x[1]),
            y1: up(y[1]),
        }
    }

    /// Its hash, the same for each tile.
    pub(super) fn hash(&self) -> u64 {
        let PixelRoundedRect { x, y, radii } = self.outer;
        let place = mix(mix(0, pair(x[0], y[0])), pair(x[1], y[1]));
        let round = mix(
            mix(place, pair(radii[0], radii[1])),
            pair(radii[2], radii[3]),
        );
        let colors = [self.fill, self.border].map(bits);
        let word = u64::from(colors[0]) << 32 | u64::from(colors[1]);
        mix(mix(round, word), u64::from(self.inner.x[0].to_bits()))
    }

    /// Whether the fill alone covers these pixels completely.
    pub(super) fn fills(&self, cut: PixelRect) -> bool {
        let within = |(low, high): Range, from: i32, to: i32| low <= from && to <= high;
        let whole = |[low, high]: [f32; 2]| (up(low), down(high));
        let PixelRoundedRect { x, y, .. } = self.inner;
        (within(self.across, cut.x0, cut.x1) && within(whole(y), cut.y0, cut.y1))
            || (within(whole(x), cut.x0, cut.x1) && within(self.down, cut.y0, cut.y1))
    }

    pub(super) fn fill(&self) -> Color32 {
        self.fill
    }

    /// Paints its pixels within `cut`, which is in the tile.
    pub(super) fn paint(&self, tile: &mut Tile, cut: PixelRect) {
        let cut = cut.intersect(self.bounds());
        if cut.is_empty() {
            return;
        }
        let start = self.across.0.clamp(cut.x0, cut.x1);
        let end = self.across.1.clamp(start, cut.x1);
        let inks = Inks::new(self.fill, self.border);
        for x in (cut.x0..start).chain(end..cut.x1) {
            self.paint_column(tile, cut, x, &inks);
        }
        if start == end {
            return;
        }
        // Everything between the top and bottom border is fill.
        let from = up(self.inner.y[0]).clamp(cut.y0, cut.y1);
        let to = down(self.inner.y[1]).clamp(from, cut.y1);
        for y in (cut.y0..from).chain(to..cut.y1) {
            let parts = (self.outer.below(y), self.inner.below(y));
            inks.lay(tile.span(y, start, end), parts);
        }
        if self.fill != Color32::TRANSPARENT {
            for y in from..to {
                inks.fill.fill(tile.span(y, start, end));
            }
        }
    }

    fn paint_column(&self, tile: &mut Tile, cut: PixelRect, x: i32, inks: &Inks) {
        let (outer, inner) = (self.outer.column(x), self.inner.column(x));
        // Between the corners all pixels have the same coverage.
        let start = self.down.0.clamp(cut.y0, cut.y1);
        let end = self.down.1.clamp(start, cut.y1);
        for y in (cut.y0..start).chain(end..cut.y1) {
            let parts = (outer.covered(y), inner.covered(y));
            inks.lay(tile.span(y, x, x + 1), parts);
        }
        let parts = (self.outer.beside(x), self.inner.beside(x));
        let column = (x - tile.x) as usize;
        let rows = (start - tile.y) as usize..(end - tile.y) as usize;
        let pixels = &mut tile.pixels()[rows.start * SIDE..rows.end * SIDE];
        for row in pixels.chunks_exact_mut(SIDE) {
            inks.lay(&mut row[column..=column], parts);
        }
    }
}

struct Inks {
    fill: Ink,
    border: Ink,
    /// Their channels as floats.
    exact: [Vec4; 2],
}

impl Inks {
    fn new(fill: Color32, border: Color32) -> Self {
        let exact =
            [fill, border].map(|color| Vec4::from_array(tile::channels(color).map(f32::from)));
        Self {
            fill: Ink::new(fill),
            border: Ink::new(border),
            exact,
        }
    }

    /// Blends both colours over pixels covered by these parts of the outer and inner rectangle.
    #[inline]
    fn lay(&self, pixels: &mut [u32], (outer, inner): (f32, f32)) {
        let border = outer - inner;
        let part = |part: f32| (part * FULL as f32 + 0.5) as u32;
        if border <= 0.0 {
            self.fill.lay_evenly(pixels, part(inner));
        } else if inner <= 0.0 {
            self.border.lay_evenly(pixels, part(outer));
        } else {
            let color = self.exact[0] * inner + self.exact[1] * border;
            for pixel in pixels {
                *pixel = tile::over_exact(*pixel, color.to_array());
            }
        }
    }
}
