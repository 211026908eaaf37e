//! Tiles, the small squares painted one at a time, and blending.
//!
//! Blending is egui's: premultiplied alpha in gamma space. A tile fits into the L1 cache, and its
//! rows have fixed addresses whatever the target.

use egui::Color32;

/// In pixels.
pub(super) const SIDE: usize = 32;

/// A rectangle of whole pixels in the target; x1 and y1 are exclusive.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct PixelRect {
    pub(super) x0: i32,
    pub(super) y0: i32,
    pub(super) x1: i32,
    pub(super) y1: i32,
}

impl PixelRect {
    pub(super) fn intersect(self, other: Self) -> Self {
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

    pub(super) fn contains(self, other: Self) -> bool {
        self.x0 <= other.x0 && self.y0 <= other.y0 && self.x1 >= other.x1 && self.y1 >= other.y1
    }
}

pub(super) struct Tile {
    pixels: Box<[u32; SIDE * SIDE]>,
    /// The position of its first pixel in the target.
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

    /// The pixels from `x0` to `x1` of row `y`, in target coordinates, clipped to the tile.
    #[inline]
    pub(super) fn span(&mut self, y: i32, x0: i32, x1: i32) -> &mut [u32] {
        let row = (y - self.y).clamp(0, SIDE as i32 - 1) as usize * SIDE;
        let from = (x0 - self.x).clamp(0, SIDE as i32) as usize;
        let to = (x1 - self.x).clamp(from as i32, SIDE as i32) as usize;
        &mut self.pixels[row + from..row + to]
    }

    pub(super) fn row(&self, y: usize) -> &[u32; SIDE] {
        let (rows, _) = self.pixels.as_chunks();
        &rows[y]
    }

    pub(super) fn pixels(&mut self) -> &mut [u32; SIDE * SIDE] {
        &mut self.pixels
    }
}

/// A colour as a pixel, without alpha.
pub(super) fn pixel(color: Color32) -> u32 {
    let [r, g, b, _] = color.to_array();
    u32::from_be_bytes([0, r, g, b])
}

/// The channels in the order blue, green, red, alpha.
#[inline]
pub(super) fn channels(color: Color32) -> [u8; 4] {
    let [r, g, b, a] = color.to_array();
    [b, g, r, a]
}

/// The weight of full coverage.
pub(super) const FULL: u32 = 256;

/// A colour prepared for blending.
#[derive(Clone, Copy)]
pub(super) struct Ink {
    /// Laid out as by [`spread`].
    color: u64,
    /// Opacity in parts of 65536, rounded up.
    alpha: u32,
    /// A channel exceeds alpha: the colour adds light and must saturate at white.
    additive: bool,
    /// The pixel, if the colour is opaque.
    opaque: Option<u32>,
}

#[derive(Clone, Copy)]
pub(super) enum Blend {
    Opaque,
    Translucent,
    /// The colour adds light.
    Additive,
}

/// One half in each channel of a product, for rounding.
const HALVES: u64 = 0x0080_0080_0080;

/// Spreads the channels to 16 bits each: blue, red, green from the lowest.
#[inline(always)]
fn spread(pixel: u32) -> u64 {
    let pixel = u64::from(pixel);
    pixel & 0x00FF_00FF | (pixel & 0xFF00) << 24
}

/// The inverse of [`spread`].
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
            additive: r > a || g > a || b > a,
            opaque: (a == 255).then(|| pixel(color)),
        }
    }

    pub(super) fn opaque(&self) -> Option<u32> {
        self.opaque
    }

    #[inline]
    pub(super) fn blend(&self) -> Blend {
        if self.additive {
            Blend::Additive
        } else if self.opaque.is_some() {
            Blend::Opaque
        } else {
            Blend::Translucent
        }
    }

    /// Blends over a pixel, weight up to [`FULL`]; only for [`Blend::Opaque`]. Off by at most one.
    #[inline(always)]
    pub(super) fn over_opaque(&self, below: u32, weight: u32) -> u32 {
        let mixed = spread(below) * u64::from(FULL - weight) + self.color * u64::from(weight);
        gathered((mixed + HALVES) >> 8)
    }

    /// Blends over a pixel, weight up to [`FULL`]; not for [`Blend::Additive`]. Off by less than
    /// two.
    #[inline(always)]
    pub(super) fn over_translucent(&self, below: u32, weight: u32) -> u32 {
        // Channels do not exceed alpha, so no sum overflows 16 bits: 255·(256 − hidden) +
        // channel·weight + 128 ≤ 65 535.
        let hidden = (self.alpha * weight + 0x8000) >> 16;
        let mixed = spread(below) * u64::from(FULL - hidden) + self.color * u64::from(weight);
        gathered((mixed + HALVES) >> 8)
    }

    /// Blends over a pixel with a weight up to [`FULL`], for every [`Blend`].
    #[inline]
    pub(super) fn over_additive(&self, below: u32, weight: u32) -> u32 {
        let hidden = (self.alpha * weight + 0x8000) >> 16;
        let below = spread(below);
        let mixed = [0, 16, 32].map(|shift| {
            let channel = |of: u64| (of >> shift & 255) as u32;
            let sum = channel(below) * (FULL - hidden) + channel(self.color) * weight + 128;
            u64::from((sum >> 8).min(255)) << shift
        });
        gathered(mixed[0] | mixed[1] | mixed[2])
    }

    #[inline]
    pub(super) fn fill(&self, pixels: &mut [u32]) {
        if let Some(color) = self.opaque {
            pixels.fill(color);
        } else {
            self.lay(pixels, std::iter::repeat(FULL));
        }
    }

    #[inline]
    pub(super) fn lay_evenly(&self, pixels: &mut [u32], weight: u32) {
        if self.color == 0 && self.alpha == 0 {
            // Transparent.
        } else if weight == FULL {
            self.fill(pixels);
        } else if weight > 0 {
            self.lay(pixels, std::iter::repeat(weight));
        }
    }

    /// Blends over pixels, each with its weight up to [`FULL`].
    #[inline(always)]
    pub(super) fn lay(&self, pixels: &mut [u32], weights: impl Iterator<Item = u32>) {
        let pairs = pixels.iter_mut().zip(weights);
        match self.blend() {
            Blend::Opaque => pairs.for_each(|(p, weight)| *p = self.over_opaque(*p, weight)),
            Blend::Translucent => {
                pairs.for_each(|(p, weight)| *p = self.over_translucent(*p, weight))
            }
            Blend::Additive => pairs.for_each(|(p, weight)| *p = self.over_additive(*p, weight)),
        }
    }
}

/// Blends a colour with fractions (blue, green, red, alpha; 0…255) over a pixel.
#[inline(always)]
pub(super) fn over_exact(below: u32, [b, g, r, a]: [f32; 4]) -> u32 {
    let rest = 1.0 - a * (1.0 / 255.0);
    let mixed = |below: u32, source: f32| {
        let value = below as f32 * rest + source + 0.5;
        (value as i32).clamp(0, 255) as u32
    };
    mixed(below >> 16 & 255, r) << 16 | mixed(below >> 8 & 255, g) << 8 | mixed(below & 255, b)
}
