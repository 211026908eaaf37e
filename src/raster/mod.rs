//! What egui asks to be painted, and anti-aliased lines, become pixels.
//!
//! Why our own: the window must come up on any X server, also over a network
//! and without OpenGL, and a second copy of a graphics stack has no place in a
//! library that a 1994 program links. Only what changed is painted again.
//!
//! It knows no X and no camera: triangles, lines and a buffer of pixels.

mod grid;
mod hash;
mod layer;
mod lines;
mod stroke;
#[cfg(test)]
pub(crate) mod testing;
mod texture;
mod tile;
mod triangle;

pub(crate) use lines::{Line, Lines};

use grid::{Areas, Tiles, pixels_of};
use layer::Layer;
use texture::Textures;
use tile::{Cut, Tile};

use egui::{ClippedPrimitive, Color32, TexturesDelta};

/// A rectangle of whole pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Area {
    /// Left edge.
    pub(crate) x: u32,
    /// Upper edge.
    pub(crate) y: u32,
    /// Pixels across.
    pub(crate) width: u32,
    /// Pixels down.
    pub(crate) height: u32,
}

/// Where the pixels go: rows from the top, each pixel `0x00RRGGBB`.
pub(crate) struct Target<'a> {
    /// At least `stride * height` pixels.
    pub(crate) pixels: &'a mut [u32],
    /// Pixels from one row to the next, at least `width`.
    pub(crate) stride: usize,
    /// Pixels across.
    pub(crate) width: u32,
    /// Pixels down.
    pub(crate) height: u32,
}

/// Paints one window. It remembers what stands in each tile of the target, so
/// the same target must come again, untouched, until [`Raster::forget`].
pub(crate) struct Raster {
    background: Color32,
    textures: Textures,
    /// The fingerprints of the tiles as they stand in the target, row by row.
    shown: Vec<u64>,
    /// What `shown` holds for: width, height, pixels per point.
    shown_for: Option<(u32, u32, f32)>,
    tile: Tile,
}

impl Raster {
    /// Nothing painted yet.
    pub(crate) fn new(background: Color32) -> Self {
        Self {
            background,
            textures: Textures::default(),
            shown: Vec::new(),
            shown_for: None,
            tile: Tile::new(),
        }
    }

    /// What shows where nothing is painted. Everything is painted anew after
    /// a change.
    pub(crate) fn set_background(&mut self, background: Color32) {
        if self.background != background {
            self.background = background;
            self.forget();
        }
    }

    /// The target's pixels are lost or another target comes: all is painted anew.
    pub(crate) fn forget(&mut self) {
        self.shown_for = None;
    }

    /// Takes over new and changed textures, and drops those that egui frees.
    /// To be called with every output of egui, before [`Raster::paint`].
    pub(crate) fn update_textures(&mut self, delta: TexturesDelta) {
        self.textures.update(delta);
    }

    /// Paints what changed since the last call, and says which areas that were.
    /// A paint callback must carry [`Lines`]; any other is left out. A target
    /// that is smaller than it says is left alone.
    pub(crate) fn paint(
        &mut self,
        primitives: &[ClippedPrimitive],
        pixels_per_point: f32,
        target: &mut Target<'_>,
    ) -> Vec<Area> {
        let (Ok(x1), Ok(y1)) = (i32::try_from(target.width), i32::try_from(target.height)) else {
            return Vec::new();
        };
        let whole = Cut {
            x0: 0,
            y0: 0,
            x1,
            y1,
        };
        let room = target.stride.saturating_mul(y1.max(1) as usize - 1) + x1 as usize;
        if whole.is_empty() || target.stride < x1 as usize || target.pixels.len() < room {
            return Vec::new();
        }
        let tiles = Tiles::of(whole);
        let layers: Vec<Layer> = primitives
            .iter()
            .map(|primitive| Layer::new(primitive, &self.textures, pixels_per_point, whole))
            .collect();
        let now = Some((target.width, target.height, pixels_per_point));
        let anew = self.shown_for != now;
        self.shown_for = now;
        self.shown.resize(tiles.count(), 0);
        let mut areas = Areas::default();
        let mut shown = self.shown.iter_mut();
        for y in tiles.y0..tiles.y1 {
            for x in tiles.x0..tiles.x1 {
                let hash = layers.iter().fold(0, |hash, layer| layer.hash(x, y, hash));
                let Some(shown) = shown.next() else { continue };
                if *shown == hash && !anew {
                    continue;
                }
                *shown = hash;
                let cut = pixels_of(x, y).and(whole);
                self.tile
                    .start(cut.x0, cut.y0, tile::pixel(self.background));
                for (layer, primitive) in layers.iter().zip(primitives) {
                    layer.paint(
                        (x, y),
                        primitive,
                        &self.textures,
                        pixels_per_point,
                        &mut self.tile,
                    );
                }
                let width = (cut.x1 - cut.x0) as usize;
                for (row, y) in (cut.y0..cut.y1).enumerate() {
                    let start = y as usize * target.stride + cut.x0 as usize;
                    target.pixels[start..start + width]
                        .copy_from_slice(&self.tile.row(row)[..width]);
                }
                areas.add(cut);
            }
            areas.end_row();
        }
        areas.into_areas()
    }
}
