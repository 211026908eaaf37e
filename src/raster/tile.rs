//! One tile: the small square in which everything is painted, and how colours
//! are laid over pixels.
//!
//! Blending is egui's: colours with premultiplied alpha, in the space in which
//! they are shown. A tile fits into the processor's nearest cache, and the rows
//! of every tile lie at the same places whatever the target looks like.

use egui::Color32;

/// Pixels along a side of a tile.
pub(super) const SIDE: usize = 64;

/// A rectangle of whole pixels in the target: from (x0, y0) up to, without,
/// (x1, y1).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Cut {
    pub(super) x0: i32,
    pub(super) y0: i32,
    pub(super) x1: i32,
    pub(super) y1: i32,
}

impl Cut {
    pub(super) fn and(self, other: Self) -> Self {
        Self {
            x0: self.x0.max(other.x0),
            y0: self.y0.max(other.y0),
            x1: self.x1.min(other.x1),
            y1: self.y1.min(other.y1),
        }
    }

    pub(super) fn is_empty(self) -> bool {
        self.x0 >= self.x1 || self.y0 >= self.y1
    }

    /// Whether all of `other` lies within.
    pub(super) fn holds(self, other: Self) -> bool {
        self.x0 <= other.x0 && self.y0 <= other.y0 && self.x1 >= other.x1 && self.y1 >= other.y1
    }
}

/// The pixels of one tile.
pub(super) struct Tile {
    pixels: Box<[u32; SIDE * SIDE]>,
    /// Where its first pixel stands in the target.
    pub(super) x: i32,
    pub(super) y: i32,
}

impl Tile {
    pub(super) fn new() -> Self {
        Self {
            pixels: Box::new([0; SIDE * SIDE]),
            x: 0,
            y: 0,
        }
    }

    /// Moves to another place and takes one colour.
    pub(super) fn start(&mut self, x: i32, y: i32, color: u32) {
        (self.x, self.y) = (x, y);
        self.pixels.fill(color);
    }

    /// The pixels from `x0` to `x1` of a row, in the target's numbers. What
    /// lies outside the tile is left out.
    #[inline]
    pub(super) fn span(&mut self, y: i32, x0: i32, x1: i32) -> &mut [u32] {
        let row = (y - self.y).clamp(0, SIDE as i32 - 1) as usize * SIDE;
        let from = (x0 - self.x).clamp(0, SIDE as i32) as usize;
        let to = (x1 - self.x).clamp(from as i32, SIDE as i32) as usize;
        &mut self.pixels[row + from..row + to]
    }

    /// One row, by its number within the tile.
    pub(super) fn row(&self, y: usize) -> &[u32] {
        &self.pixels[y * SIDE..][..SIDE]
    }

    /// All pixels.
    pub(super) fn pixels(&mut self) -> &mut [u32; SIDE * SIDE] {
        &mut self.pixels
    }
}

/// A colour as a pixel, without its alpha.
pub(super) fn pixel(color: Color32) -> u32 {
    let [r, g, b, _] = color.to_array();
    u32::from_be_bytes([0, r, g, b])
}

/// Blue, green, red and alpha: the order of a pixel's bytes from the lowest.
#[inline(always)]
pub(super) fn channels(color: Color32) -> [u32; 4] {
    let [r, g, b, a] = color.to_array();
    [b, g, r, a].map(u32::from)
}

/// `value / 255` rounded to the nearest, for values up to 65 535.
#[inline(always)]
fn by_255(value: u32) -> u32 {
    let value = value + 128;
    (value + (value >> 8)) >> 8
}

/// Lays one colour over pixels.
pub(super) fn fill(pixels: &mut [u32], color: Color32) {
    if color.a() == 255 {
        pixels.fill(pixel(color));
        return;
    }
    let source = channels(color);
    for pixel in pixels {
        *pixel = over(*pixel, source);
    }
}

/// A colour (see [`channels`]) over a pixel.
#[inline(always)]
pub(super) fn over(below: u32, [b, g, r, a]: [u32; 4]) -> u32 {
    let rest = 255 - a;
    let blue = (by_255((below & 255) * rest) + b).min(255);
    let green = (by_255((below >> 8 & 255) * rest) + g).min(255);
    let red = (by_255((below >> 16 & 255) * rest) + r).min(255);
    red << 16 | green << 8 | blue
}

/// Lays a colour over pixels, each by its coverage.
pub(super) fn cover(pixels: &mut [u32], coverage: &[u8], color: Color32) {
    let source = channels(color);
    for (pixel, &coverage) in pixels.iter_mut().zip(coverage) {
        *pixel = over(*pixel, source.map(|c| by_255(c * u32::from(coverage))));
    }
}

/// A colour with fractions (blue, green, red, alpha; 0…255) over a pixel.
#[inline(always)]
pub(super) fn over_exact(below: u32, [b, g, r, a]: [f32; 4]) -> u32 {
    let rest = 1.0 - a * (1.0 / 255.0);
    let mixed = |below: u32, source: f32| {
        let value = below as f32 * rest + source + 0.5;
        (value as i32).clamp(0, 255) as u32
    };
    mixed(below >> 16 & 255, r) << 16 | mixed(below >> 8 & 255, g) << 8 | mixed(below & 255, b)
}
