//! One tile: the small square in which everything is painted, and how colours
//! are laid over pixels.
//!
//! Blending is egui's: colours with premultiplied alpha, in the space in which
//! they are shown. A tile fits into the processor's nearest cache, and the rows
//! of every tile lie at the same places whatever the target looks like.

use egui::Color32;

/// Pixels along a side of a tile.
pub(super) const SIDE: usize = 32;

/// A rectangle of whole pixels in the target: from (x0, y0) up to, without,
/// (x1, y1).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct PixelRect {
    pub(super) x0: i32,
    pub(super) y0: i32,
    pub(super) x1: i32,
    pub(super) y1: i32,
}

impl PixelRect {
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
    pub(super) fn row(&self, y: usize) -> &[u32; SIDE] {
        let (rows, _) = self.pixels.as_chunks();
        &rows[y]
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

/// The channels of a colour: blue, green, red, alpha.
#[inline]
pub(super) fn channels(color: Color32) -> [u8; 4] {
    let [r, g, b, a] = color.to_array();
    [b, g, r, a]
}

/// Weights by which a colour is laid on are counted in this many parts.
pub(super) const FULL: u32 = 256;

/// A colour made ready to be laid over pixels.
#[derive(Clone, Copy)]
pub(super) struct Ink {
    /// See [`spread`].
    color: u64,
    /// Its opacity in 65 536 parts, rounded up.
    alpha: u32,
    /// A channel is more than its opacity: light is added, and has to be
    /// stopped at white.
    glows: bool,
    /// As a pixel, where it hides what is below.
    opaque: Option<u32>,
}

/// How a colour is laid over what is below it.
#[derive(Clone, Copy)]
pub(super) enum Kind {
    /// Hides it.
    Opaque,
    /// Lets it shine through, or is not there at all.
    Clear,
    /// Adds light.
    Glowing,
}

/// A half in each channel of a product, for rounding.
const HALVES: u64 = 0x0080_0080_0080;

/// The channels with 16 bits for each: blue, red, green from the lowest.
#[inline(always)]
fn spread(pixel: u32) -> u64 {
    let pixel = u64::from(pixel);
    pixel & 0x00FF_00FF | (pixel & 0xFF00) << 24
}

/// Back from [`spread`].
#[inline(always)]
fn gathered(channels: u64) -> u32 {
    (channels & 0x00FF_00FF | channels >> 24 & 0xFF00) as u32
}

impl Ink {
    #[inline]
    pub(super) fn new(color: Color32) -> Self {
        let [r, g, b, a] = color.to_array();
        Self {
            color: spread(pixel(color)),
            alpha: (u32::from(a) * 65_536).div_ceil(255),
            glows: r > a || g > a || b > a,
            opaque: (a == 255).then(|| pixel(color)),
        }
    }

    /// The pixel that results if it hides all that is below.
    pub(super) fn opaque(&self) -> Option<u32> {
        self.opaque
    }

    /// How the ink is laid over pixels.
    #[inline]
    pub(super) fn kind(&self) -> Kind {
        if self.glows {
            Kind::Glowing
        } else if self.opaque.is_some() {
            Kind::Opaque
        } else {
            Kind::Clear
        }
    }

    /// Laid over a pixel with a weight up to [`FULL`], if it is
    /// [`Kind::Opaque`]. Off by one at most from the exact value.
    #[inline(always)]
    pub(super) fn over_opaque(&self, below: u32, weight: u32) -> u32 {
        let mixed = spread(below) * u64::from(FULL - weight) + self.color * u64::from(weight);
        gathered((mixed + HALVES) >> 8)
    }

    /// Laid over a pixel with a weight up to [`FULL`], unless it is
    /// [`Kind::Glowing`]. Off by less than two from the exact value.
    #[inline(always)]
    pub(super) fn over_clear(&self, below: u32, weight: u32) -> u32 {
        // A channel is at most its opacity, and then no sum passes 16 bits:
        // 255·(256 − hidden) + channel·weight + 128 ≤ 65 535.
        let hidden = (self.alpha * weight + 0x8000) >> 16;
        let mixed = spread(below) * u64::from(FULL - hidden) + self.color * u64::from(weight);
        gathered((mixed + HALVES) >> 8)
    }

    /// Laid over a pixel with a weight up to [`FULL`], whatever it is.
    #[inline]
    pub(super) fn over_glowing(&self, below: u32, weight: u32) -> u32 {
        let hidden = (self.alpha * weight + 0x8000) >> 16;
        let below = spread(below);
        let mixed = [0, 16, 32].map(|shift| {
            let channel = |of: u64| (of >> shift & 255) as u32;
            let sum = channel(below) * (FULL - hidden) + channel(self.color) * weight + 128;
            u64::from((sum >> 8).min(255)) << shift
        });
        gathered(mixed[0] | mixed[1] | mixed[2])
    }

    /// Laid over pixels.
    #[inline]
    pub(super) fn fill(&self, pixels: &mut [u32]) {
        if let Some(color) = self.opaque {
            pixels.fill(color);
        } else {
            self.lay(pixels, std::iter::repeat(FULL));
        }
    }

    /// Laid over pixels, each with the same weight up to [`FULL`].
    #[inline]
    pub(super) fn lay_evenly(&self, pixels: &mut [u32], weight: u32) {
        if self.color == 0 && self.alpha == 0 {
            // Nothing to be seen.
        } else if weight == FULL {
            self.fill(pixels);
        } else if weight > 0 {
            self.lay(pixels, std::iter::repeat(weight));
        }
    }

    /// Laid over pixels, each by its weight up to [`FULL`].
    #[inline(always)]
    pub(super) fn lay(&self, pixels: &mut [u32], weights: impl Iterator<Item = u32>) {
        let pairs = pixels.iter_mut().zip(weights);
        match self.kind() {
            Kind::Opaque => pairs.for_each(|(p, weight)| *p = self.over_opaque(*p, weight)),
            Kind::Clear => pairs.for_each(|(p, weight)| *p = self.over_clear(*p, weight)),
            Kind::Glowing => pairs.for_each(|(p, weight)| *p = self.over_glowing(*p, weight)),
        }
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
