//! The raster held against plain, slow ways to the same pixels.

mod blending;
mod frames;
mod harmless;
mod lines;
mod pieces;
mod rounded_rects;
mod surfaces;
mod triangles;

use egui::epaint::textures::TextureOptions;
use egui::epaint::{ImageDelta, Primitive, Vertex};
use egui::{ClippedPrimitive, Color32, ColorImage, Mesh, Rect, TextureId, TexturesDelta, pos2};

use super::{Area, Raster, Target};

/// Random numbers that are the same in every run.
pub(super) struct Random(pub(super) u64);

impl Random {
    fn bits(&mut self) -> u64 {
        // Steele, Lea, Flood: SplitMix64.
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// Below `end`.
    fn below(&mut self, end: usize) -> usize {
        (self.bits() % end as u64) as usize
    }

    fn between(&mut self, low: f32, high: f32) -> f32 {
        low + (high - low) * ((self.bits() >> 40) as f32 / (1 << 24) as f32)
    }

    /// Any colour with premultiplied alpha.
    fn color(&mut self) -> Color32 {
        let [r, g, b, a] = (self.bits() as u32).to_ne_bytes();
        let a = if self.below(3) == 0 { 255 } else { a };
        let part = |c: u8| (u32::from(c) * u32::from(a) / 255) as u8;
        Color32::from_rgba_premultiplied(part(r), part(g), part(b), a)
    }
}

/// A raster and its pixels.
pub(super) struct Screen {
    pub(super) raster: Raster,
    pub(super) pixels: Vec<u32>,
    pub(super) width: u32,
    pub(super) height: u32,
    pub(super) scale: f32,
}

impl Screen {
    /// With a texture 0 as egui's: white at its beginning, then letters.
    fn new(width: u32, height: u32, background: Color32) -> Self {
        let mut raster = Raster::new(background);
        raster.update_textures(texture(
            TextureId::default(),
            letters(),
            TextureOptions::LINEAR,
        ));
        Self {
            raster,
            pixels: vec![0x00AB_CDEF; width as usize * height as usize],
            width,
            height,
            scale: 1.0,
        }
    }

    fn paint(&mut self, primitives: &[ClippedPrimitive]) -> Vec<Area> {
        let mut target = Target {
            pixels: &mut self.pixels,
            stride: self.width as usize,
            width: self.width,
            height: self.height,
        };
        let scale = self.scale;
        self.raster.paint(primitives, scale, &mut target)
    }

    /// Red, green and blue of a pixel.
    fn rgb(&self, x: usize, y: usize) -> [u8; 3] {
        let [_, r, g, b] = self.pixels[y * self.width as usize + x].to_be_bytes();
        [r, g, b]
    }
}

fn texture(id: TextureId, image: ColorImage, options: TextureOptions) -> TexturesDelta {
    let mut delta = TexturesDelta::default();
    delta.push(id, ImageDelta::full(image, options));
    delta
}

/// An image of white with varying alpha; its first texel is opaque.
fn letters() -> ColorImage {
    let mut random = Random(7);
    let alpha = |i: usize, random: &mut Random| if i == 0 { 255 } else { random.below(256) as u8 };
    let pixels = (0..64 * 32).map(|i| Color32::from_white_alpha(alpha(i, &mut random)));
    ColorImage::new([64, 32], pixels.collect())
}

fn everywhere(primitive: Primitive) -> ClippedPrimitive {
    ClippedPrimitive {
        clip_rect: Rect::EVERYTHING,
        primitive,
    }
}

fn vertex(x: f32, y: f32, color: Color32) -> Vertex {
    Vertex::untextured(pos2(x, y), color)
}

fn mesh(vertices: Vec<Vertex>, indices: Vec<u32>) -> ClippedPrimitive {
    everywhere(Primitive::Mesh(Mesh {
        indices,
        vertices,
        texture_id: TextureId::default(),
    }))
}

/// How much of each pixel of a square is covered: many rows, in each of which is known
/// exactly from where to where it is.
fn covered(side: usize, row: impl Fn(f64) -> Option<(f64, f64)>) -> Vec<f64> {
    const ROWS: usize = 200;
    let mut covered = vec![0.0; side * side];
    for number in 0..side * ROWS {
        let Some((from, to)) = row((number as f64 + 0.5) / ROWS as f64) else {
            continue;
        };
        for x in 0..side {
            let part = to.min(x as f64 + 1.0) - from.max(x as f64);
            covered[number / ROWS * side + x] += part.max(0.0) / ROWS as f64;
        }
    }
    covered
}
