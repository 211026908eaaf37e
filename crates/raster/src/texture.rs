//! Copies of egui's textures. The font atlas is white with varying alpha; such textures are stored
//! as one byte per texel, a quarter of egui's size.

use std::collections::{HashMap, HashSet};

use egui::epaint::ImageDelta;
use egui::epaint::textures::{TextureFilter, TextureOptions, TextureWrapMode};
use egui::{Color32, ImageData, Mesh, Pos2, Rect, TextureId, TexturesDelta, pos2};

pub(super) enum Texels {
    /// White with premultiplied alpha: only the alpha.
    Coverage(Vec<u8>),
    Color(Vec<Color32>),
}

pub(super) struct Texture {
    pub(super) texels: Texels,
    pub(super) width: usize,
    pub(super) height: usize,
    options: TextureOptions,
    /// A new number for each change of the content.
    pub(super) generation: u64,
    changed: Changed,
}

/// Texels changed since [`Textures::all_seen`].
#[derive(PartialEq)]
enum Changed {
    None,
    /// Those in the marked blocks, row by row.
    In(Vec<bool>),
    All,
}

/// The side of a block, in texels.
const BLOCK: usize = 8;

#[derive(Default)]
pub(super) struct Textures {
    textures: HashMap<TextureId, Texture>,
    /// Freed by egui, but still used by the frame that is being painted.
    released: HashSet<TextureId>,
    generation: u64,
}

impl Textures {
    pub(super) fn get(&self, id: TextureId) -> Option<&Texture> {
        self.textures.get(&id)
    }

    /// Applies egui's changes. Textures are dropped one call late, because the frame that comes
    /// with the changes may still show them.
    pub(super) fn update(&mut self, mut delta: TexturesDelta) {
        for id in self.released.drain() {
            self.textures.remove(&id);
        }
        for (id, images) in delta.set.drain() {
            for image in images {
                self.generation += 1;
                match image.pos {
                    None => match Texture::new(&image, self.generation) {
                        Some(texture) => drop(self.textures.insert(id, texture)),
                        None => drop(self.textures.remove(&id)),
                    },
                    Some(at) => {
                        if let Some(texture) = self.textures.get_mut(&id) {
                            texture.patch(&image, at, self.generation);
                        }
                    }
                }
            }
        }
        self.released.extend(delta.free.drain());
    }

    /// Call it once everything that shows changed texels is known.
    pub(super) fn all_seen(&mut self) {
        for texture in self.textures.values_mut() {
            texture.changed = Changed::None;
        }
    }
}

/// The alpha, if the colour is white times alpha.
fn coverage(color: Color32) -> Option<u8> {
    let [r, g, b, a] = color.to_array();
    (r == a && g == a && b == a).then_some(a)
}

impl Texture {
    fn new(delta: &ImageDelta, generation: u64) -> Option<Self> {
        let ImageData::Color(image) = &delta.image;
        let [width, height] = image.size;
        if width == 0 || height == 0 || width.checked_mul(height)? != image.pixels.len() {
            return None;
        }
        let texels = match image.pixels.iter().copied().map(coverage).collect() {
            Some(alphas) => Texels::Coverage(alphas),
            None => Texels::Color(image.pixels.clone()),
        };
        Some(Self {
            texels,
            width,
            height,
            options: delta.options,
            generation,
            changed: Changed::All,
        })
    }

    /// Whether a mesh shows changed texels of this texture. A new glyph in the font atlas changes
    /// no text that is already shown.
    pub(super) fn is_changed_for(&self, mesh: &Mesh) -> bool {
        let marks = match &self.changed {
            Changed::None => return false,
            Changed::In(marks) if self.options.wrap_mode == TextureWrapMode::ClampToEdge => marks,
            // Wrapping blends opposite edges.
            _ => return true,
        };
        let across = self.width.div_ceil(BLOCK);
        mesh.indices.chunks(3).any(|corners| {
            let corners = corners
                .iter()
                .filter_map(|&at| mesh.vertices.get(at as usize));
            let mut bounds = Rect::NOTHING;
            for corner in corners {
                bounds.extend_with(corner.uv);
            }
            // Include adjacent texels, because of filtering.
            let blocks = |low: f32, high: f32, count: usize| {
                let at = |v: f32| (v * count as f32) as usize / BLOCK;
                let beside = 1.0 / count as f32;
                at(low - beside)..=at(high + beside).min((count - 1) / BLOCK)
            };
            // UVs outside wrap, or are not finite.
            let within = Rect::from_min_max(Pos2::ZERO, pos2(1.0, 1.0));
            !within.contains_rect(bounds)
                || blocks(bounds.min.y, bounds.max.y, self.height).any(|y| {
                    blocks(bounds.min.x, bounds.max.x, self.width).any(|x| marks[y * across + x])
                })
        })
    }

    fn note_change(&mut self, x: usize, y: usize) {
        let across = self.width.div_ceil(BLOCK);
        if self.changed == Changed::None {
            let count = across * self.height.div_ceil(BLOCK);
            self.changed = Changed::In(vec![false; count]);
        }
        if let Changed::In(marks) = &mut self.changed {
            marks[y / BLOCK * across + x / BLOCK] = true;
        }
    }

    fn patch(&mut self, delta: &ImageDelta, [left, top]: [usize; 2], generation: u64) {
        let ImageData::Color(image) = &delta.image;
        let [width, height] = image.size;
        if width == 0 || width.checked_mul(height) != Some(image.pixels.len()) {
            return;
        }
        self.generation = generation;
        if self.options != delta.options {
            (self.options, self.changed) = (delta.options, Changed::All);
        }
        if let Texels::Coverage(alphas) = &self.texels
            && image.pixels.iter().any(|&color| coverage(color).is_none())
        {
            let colors = alphas
                .iter()
                .map(|&a| Color32::from_rgba_premultiplied(a, a, a, a));
            (self.texels, self.changed) = (Texels::Color(colors.collect()), Changed::All);
        }
        let across = width.min(self.width.saturating_sub(left));
        let down = height.min(self.height.saturating_sub(top));
        for y in 0..down {
            let from = &image.pixels[y * width..][..across];
            let start = (top + y) * self.width + left;
            for (x, &color) in from.iter().enumerate() {
                let other = match &mut self.texels {
                    Texels::Coverage(alphas) => replaced(&mut alphas[start + x], color.a()),
                    Texels::Color(colors) => replaced(&mut colors[start + x], color),
                };
                if other {
                    self.note_change(left + x, top + y);
                }
            }
        }
    }

    fn texel(&self, x: usize, y: usize) -> [f32; 4] {
        let at = y * self.width + x;
        match &self.texels {
            Texels::Coverage(alphas) => [f32::from(alphas[at]); 4],
            Texels::Color(colors) => colors[at].to_array().map(f32::from),
        }
    }

    /// The filter for a scale of this many texels per pixel.
    pub(super) fn filter(&self, texels_per_pixel: f32) -> TextureFilter {
        if texels_per_pixel > 1.0 {
            self.options.minification
        } else {
            self.options.magnification
        }
    }

    /// The colour of an area that shows a single point of the texture.
    #[inline]
    pub(super) fn plain(&self, u: f32, v: f32) -> [f32; 4] {
        // egui's white texel for untextured shapes; not filtered.
        if (u, v) == (0.0, 0.0) && self.options.wrap_mode == TextureWrapMode::ClampToEdge {
            return self.texel(0, 0);
        }
        self.sample(u, v, self.filter(0.0))
    }

    /// Texture coordinates are 0…1, channels 0…255.
    pub(super) fn sample(&self, u: f32, v: f32, filter: TextureFilter) -> [f32; 4] {
        let mode = self.options.wrap_mode;
        let (x, y) = (u * self.width as f32, v * self.height as f32);
        match filter {
            TextureFilter::Nearest => self.texel(
                wrap(floor(x), self.width, mode),
                wrap(floor(y), self.height, mode),
            ),
            TextureFilter::Linear => {
                let (x, y) = (x - 0.5, y - 0.5);
                let (left, top) = (floor(x), floor(y));
                let (fx, fy) = (x - left, y - top);
                let (x0, x1) = (
                    wrap(left, self.width, mode),
                    wrap(left + 1.0, self.width, mode),
                );
                let (y0, y1) = (
                    wrap(top, self.height, mode),
                    wrap(top + 1.0, self.height, mode),
                );
                let [a, b] = [self.texel(x0, y0), self.texel(x1, y0)];
                let [c, d] = [self.texel(x0, y1), self.texel(x1, y1)];
                std::array::from_fn(|i| {
                    let upper = a[i] + (b[i] - a[i]) * fx;
                    let lower = c[i] + (d[i] - c[i]) * fx;
                    upper + (lower - upper) * fy
                })
            }
        }
    }
}

fn replaced<T: PartialEq>(old: &mut T, new: T) -> bool {
    let other = *old != new;
    *old = new;
    other
}

/// Rounds down. (Not every x86-64 has an instruction for it, and a call to the C library is slow.
/// Huge values have no fraction.)
#[inline]
fn floor(x: f32) -> f32 {
    let whole = x as i32 as f32;
    if x.abs() >= 1e9 {
        x
    } else if whole > x {
        whole - 1.0
    } else {
        whole
    }
}

/// The texel index for an integral position, also outside the texture.
fn wrap(at: f32, count: usize, mode: TextureWrapMode) -> usize {
    let n = count as f32;
    let at = match mode {
        TextureWrapMode::ClampToEdge => at,
        TextureWrapMode::Repeat => at.rem_euclid(n),
        TextureWrapMode::MirroredRepeat => {
            let at = at.rem_euclid(2.0 * n);
            if at < n { at } else { 2.0 * n - 1.0 - at }
        }
    };
    // NaN becomes 0.
    (at.max(0.0) as usize).min(count - 1)
}
