//! A software rasterizer for egui's output and for anti-aliased lines.
//!
//! The window must open on any X server, even over a network and without OpenGL, and a program from
//! 1994 that links the library must not get a second graphics stack. Only what has changed is
//! repainted.
//!
//! This crate knows triangles, lines and a pixel buffer, but neither X nor cameras.

#![forbid(unsafe_code)]
// Standard output is the host's.
#![cfg_attr(not(test), warn(clippy::print_stdout))]

mod area;
mod backdrop;
mod grid;
mod hash;
mod key;
mod layer;
mod lines;
mod pieces;
mod plane;
mod quad;
mod rounded_rect;
mod rounded_rect_painter;
mod spans;
mod stroke;
mod surfaces;
#[cfg(test)]
mod tests;
mod texture;
mod tile;
mod triangle;

pub use area::Area;
pub use lines::{Line, Lines};
pub use surfaces::{Corner3, Surfaces};

use backdrop::{Backdrop, Step};
use grid::{Areas, Tiles, pixels_of};
use hash::mix;
use key::Key;
use layer::Layer;
use texture::Textures;
use tile::{PixelRect, SIDE, Tile};

use egui::epaint::{ClippedShape, Tessellator};
use egui::{ClippedPrimitive, Color32, Context, TexturesDelta};

/// The pixels to paint into: rows from the top, each pixel `0x00RRGGBB`.
pub struct Target<'a> {
    /// At least `stride * (height - 1) + width` pixels.
    pub pixels: &'a mut [u32],
    /// Pixels from one row to the next, at least `width`.
    pub stride: usize,
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
}

/// Converts egui's shapes for [`Raster::paint`]: into many small meshes, and callbacks for what the
/// raster paints itself. It replaces [`Context::tessellate`], which makes triangles of everything.
pub fn primitives(
    context: &Context,
    mut shapes: Vec<ClippedShape>,
    pixels_per_point: f32,
) -> Vec<ClippedPrimitive> {
    rounded_rect::replace_shapes(&mut shapes, pixels_per_point);
    pieces::in_pieces(&mut shapes);
    let options = context.options(|options| options.tessellation_options);
    let letters = context.fonts(|fonts| fonts.font_image_size());
    // No prerendered discs: circles are painted as rounded rectangles.
    Tessellator::new(pixels_per_point, options, letters, Vec::new()).tessellate_shapes(shapes)
}

/// How many of the last call's layers to search for an equal one.
const LOOK_AHEAD: usize = 32;

/// Paints one window. Remembers what each tile of the target shows, so pass the same target again,
/// unmodified, until [`Raster::forget`].
pub struct Raster {
    background: Color32,
    textures: Textures,
    /// The hash of each tile as shown in the target, row by row.
    shown: Vec<u64>,
    /// The parameters of `shown`: width, height, pixels per point.
    shown_for: Option<(u32, u32, f32)>,
    /// The same parameters of `layers`.
    sorted_for: Option<(u32, u32, f32)>,
    layers: Vec<Layer>,
    /// Textures have changed since the last call, so any primitive may look different.
    other_textures: bool,
    /// Tiles that may have changed. This and the scratch buffers below are reused to save
    /// allocations.
    touched: Vec<bool>,
    backdrop: Vec<Backdrop>,
    /// The layers that reach the current row of tiles, and those in the current tile.
    row: Vec<u32>,
    steps: Vec<Step>,
    tile: Tile,
}

impl Raster {
    /// A raster that has painted nothing yet.
    pub fn new(background: Color32) -> Self {
        Self {
            background,
            textures: Textures::default(),
            shown: Vec::new(),
            shown_for: None,
            sorted_for: None,
            layers: Vec::new(),
            other_textures: false,
            touched: Vec::new(),
            backdrop: Vec::new(),
            row: Vec::new(),
            steps: Vec::new(),
            tile: Tile::new(),
        }
    }

    /// Sets the colour where nothing is painted. A change repaints everything.
    pub fn set_background(&mut self, background: Color32) {
        if self.background != background {
            self.background = background;
            self.forget();
        }
    }

    /// Repaints everything next time, because the target was replaced or its pixels were lost.
    pub fn forget(&mut self) {
        self.shown_for = None;
    }

    /// Frees caches that speed up animation; call it when nothing moves any more.
    pub fn trim(&mut self) {
        self.backdrop.iter_mut().for_each(Backdrop::trim);
        self.layers.iter_mut().for_each(Layer::trim);
    }

    /// Applies egui's texture changes. Call it with every output of egui, before [`Raster::paint`].
    pub fn update_textures(&mut self, delta: TexturesDelta) {
        self.other_textures |= !delta.is_empty();
        self.textures.update(delta);
    }

    /// Paints what has changed since the last call, and returns the painted areas. It only paints
    /// callbacks made by [`primitives`], [`Lines::shape`] and [`Surfaces::shape`]. A target with
    /// fewer pixels than it claims is not painted.
    pub fn paint(
        &mut self,
        primitives: &[ClippedPrimitive],
        pixels_per_point: f32,
        target: &mut Target<'_>,
    ) -> Vec<Area> {
        // On an early return, what the target shows is no longer known.
        let shown_for = self.shown_for.take();
        let Some(whole) = target.whole() else {
            return Vec::new();
        };
        let tiles = Tiles::of(whole);
        let now = Some((target.width, target.height, pixels_per_point));
        let anew = shown_for != now;
        self.shown_for = now;
        self.touched.clear();
        self.touched.resize(tiles.count(), false);
        let other = self.sort(primitives, pixels_per_point, whole);
        if !other && !anew {
            return Vec::new();
        }
        self.shown.resize(tiles.count(), 0);
        if anew {
            self.backdrop.iter_mut().for_each(Backdrop::forget);
        }
        self.backdrop.resize_with(tiles.count(), Backdrop::default);
        let mut areas = Areas::default();
        let mut indices = 0..tiles.count();
        for y in tiles.y0..tiles.y1 {
            self.row.clear();
            for (x, index) in (tiles.x0..tiles.x1).zip(&mut indices) {
                if !self.touched[index] && !anew {
                    continue;
                }
                if self.row.is_empty() {
                    let numbered = (0..).zip(&self.layers);
                    let reach = numbered.filter(|(_, layer)| layer.reaches(y));
                    self.row.extend(reach.map(|(number, _)| number));
                }
                let ground = steps(&self.layers, &self.row, (x, y), &mut self.steps);
                let hash = self.steps.last().map_or(0, |step| step.hash);
                if std::mem::replace(&mut self.shown[index], hash) == hash && !anew {
                    continue;
                }
                let cut = pixels_of(x, y).intersect(whole);
                areas.add(cut);
                self.paint_tile(index, cut, ground, primitives, pixels_per_point, target);
            }
            areas.end_row();
        }
        areas.into_areas()
    }

    /// Paints a tile, whose pixels are `cut`, from its `steps`; `ground` is what they began with.
    fn paint_tile(
        &mut self,
        index: usize,
        cut: PixelRect,
        (ground, bare): (Option<u32>, bool),
        primitives: &[ClippedPrimitive],
        pixels_per_point: f32,
        target: &mut Target<'_>,
    ) {
        let backdrop = &mut self.backdrop[index];
        let ground = ground.unwrap_or_else(|| tile::pixel(self.background));
        if bare {
            backdrop.pass_over();
            target.fill(cut, ground);
            return;
        }
        let at = (cut.x0 as usize / SIDE, cut.y0 as usize / SIDE);
        let (textures, tile) = (&self.textures, &mut self.tile);
        (tile.x, tile.y) = (cut.x0, cut.y0);
        let (painted, keep) = backdrop.begin(&self.steps, ground, tile);
        for (count, step) in (1..).zip(&self.steps).skip(painted) {
            let number = step.layer as usize;
            let primitive = &primitives[number];
            self.layers[number].paint(at, primitive, textures, pixels_per_point, tile);
            if keep == Some(count) {
                backdrop.keep(step.hash, tile);
            }
        }
        target.put(cut, tile);
    }

    /// Updates `layers` from the primitives and returns whether any changed. Marks the tiles that
    /// changed layers touch, or touched before.
    fn sort(
        &mut self,
        primitives: &[ClippedPrimitive],
        pixels_per_point: f32,
        target: PixelRect,
    ) -> bool {
        let now = Some((target.x1 as u32, target.y1 as u32, pixels_per_point));
        if self.sorted_for != now {
            self.layers.clear();
            self.sorted_for = now;
        }
        let textures = &self.textures;
        let key = |primitive| Key::new(primitive, textures, pixels_per_point, target);
        let keys: Vec<Key> = if self.other_textures {
            let changed = |primitive| key(primitive).with_changes_of(primitive, textures);
            primitives.iter().map(changed).collect()
        } else {
            primitives.iter().map(key).collect()
        };
        if std::mem::take(&mut self.other_textures) {
            self.textures.all_seen();
        }
        let same = |(layer, key): (&Layer, &Key)| layer.key == *key;
        if keys.len() == self.layers.len() && self.layers.iter().zip(&keys).all(same) {
            return false;
        }
        let tiles = Tiles::of(target);
        // Reuse a former layer if it is near its old index.
        let mut old: Vec<Option<Layer>> = self.layers.drain(..).map(Some).collect();
        let mut start = 0;
        let found: Vec<Option<Layer>> = keys
            .iter()
            .map(|key| {
                let near = old.iter().enumerate().skip(start).take(LOOK_AHEAD);
                let found = near.filter_map(|(i, layer)| Some((i, layer.as_ref()?)));
                let at = found.into_iter().find(|(_, layer)| layer.key == *key)?.0;
                start = at + 1;
                old[at].take()
            })
            .collect();
        for layer in old.iter().flatten() {
            layer.note(tiles, &mut self.touched);
        }
        let mut unused = old.into_iter().flatten();
        let (textures, touched) = (&self.textures, &mut self.touched);
        let sorted = keys.into_iter().zip(found).zip(primitives);
        let sorted = sorted.map(|((key, found), primitive)| {
            found.unwrap_or_else(|| {
                let memory = unused.next();
                let layer = Layer::new(key, primitive, textures, pixels_per_point, target, memory);
                layer.note(tiles, touched);
                layer
            })
        });
        self.layers.extend(sorted);
        true
    }
}

/// Collects a tile's layers, from the topmost that covers the whole tile. Returns the colour with
/// which it does so, and whether nothing is above it. `row` lists the layers that reach this row of
/// tiles.
fn steps(
    layers: &[Layer],
    row: &[u32],
    at: (usize, usize),
    steps: &mut Vec<Step>,
) -> (Option<u32>, bool) {
    steps.clear();
    let mut hash = 0;
    let mut ground = None;
    let mut bare = true;
    for &layer in row {
        let Some(part) = layers[layer as usize].part(at) else {
            continue;
        };
        if part.ground.is_some() {
            steps.clear();
            (hash, ground) = (part.hash, part.ground);
            bare = !part.items;
        } else {
            hash = mix(hash, part.hash);
            bare = false;
        }
        steps.push(Step { hash, layer });
    }
    (ground, bare)
}

impl Target<'_> {
    /// All its pixels; `None` if the target has none, or fewer than it claims.
    fn whole(&self) -> Option<PixelRect> {
        let (width, rows) = (self.width as usize, (self.height as usize).checked_sub(1)?);
        let room = self.stride.saturating_mul(rows).saturating_add(width);
        let whole = PixelRect {
            x0: 0,
            y0: 0,
            x1: self.width.try_into().ok()?,
            y1: self.height.try_into().ok()?,
        };
        let sound = width > 0 && self.stride >= width && self.pixels.len() >= room;
        sound.then_some(whole)
    }

    fn rows(&mut self, cut: PixelRect) -> impl Iterator<Item = &mut [u32]> {
        let rows = self.pixels.chunks_mut(self.stride).skip(cut.y0 as usize);
        let rows = rows.take((cut.y1 - cut.y0) as usize);
        rows.map(move |row| &mut row[cut.x0 as usize..cut.x1 as usize])
    }

    fn fill(&mut self, cut: PixelRect, color: u32) {
        for row in self.rows(cut) {
            row.fill(color);
        }
    }

    fn put(&mut self, cut: PixelRect, tile: &Tile) {
        for (y, row) in self.rows(cut).enumerate() {
            match <&mut [u32; SIDE]>::try_from(&mut *row) {
                // A copy of constant length needs no call.
                Ok(row) => *row = *tile.row(y),
                Err(_) => row.copy_from_slice(&tile.row(y)[..row.len()]),
            }
        }
    }
}
