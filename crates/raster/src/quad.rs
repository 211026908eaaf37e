//! Two triangles that form an axis-aligned rectangle: filled areas, glyphs, images. The result is
//! that of the triangles, but faster: glyphs map texels to pixels one to one and need no filtering.

use egui::{Color32, Mesh};

use super::plane::{self, Shader};
use super::texture::{Texels, Texture};
use super::tile::{self, FULL, Ink, PixelRect, Tile};
use super::triangle::{self, Corner, STEPS};

/// Texels this close to pixel positions count as aligned.
const NEAR: f32 = 1.0 / 64.0;

/// An axis-aligned rectangle of one vertex colour.
pub(super) struct Quad {
    pub(super) low: Corner,
    pub(super) high: Corner,
}

impl Quad {
    /// The rectangle that starts with this triangle, if its vertices are in egui's usual order.
    /// Others may still be found by [`Quad::new`], which checks everything and is slower.
    #[inline]
    pub(super) fn of_egui(mesh: &Mesh, triangle: usize, pixels_per_point: f32) -> Option<Self> {
        let indices = mesh.indices.get(triangle * 3..triangle * 3 + 6)?;
        let first = indices[0] as usize;
        let end = first.checked_add(4)?;
        let &[a, b, c, d] = mesh.vertices.get(first..end)? else {
            return None;
        };
        // The vertices exist, so these indices do not overflow.
        let i = indices[0];
        if *indices != [i, i + 1, i + 2, i + 2, i + 1, i + 3] {
            return None;
        }
        let upright = a.pos.x == c.pos.x
            && b.pos.x == d.pos.x
            && a.pos.y == b.pos.y
            && c.pos.y == d.pos.y
            && a.uv.x == c.uv.x
            && b.uv.x == d.uv.x
            && a.uv.y == b.uv.y
            && c.uv.y == d.uv.y;
        if !upright || a.color != b.color || a.color != c.color || a.color != d.color {
            return None;
        }
        let low = Corner::new(&a, pixels_per_point)?;
        let high = Corner::new(&d, pixels_per_point)?;
        (low.x < high.x && low.y < high.y).then_some(Self { low, high })
    }

    /// The rectangle formed by two consecutive triangles, if they form one.
    pub(super) fn new(first: &[Corner; 3], next: &[Corner; 3]) -> Option<Self> {
        let all = || first.iter().chain(next);
        let mut low = first[0];
        let mut high = first[0];
        for corner in all() {
            (low.x, low.y) = (low.x.min(corner.x), low.y.min(corner.y));
            (high.x, high.y) = (high.x.max(corner.x), high.y.max(corner.y));
        }
        // The corners that each triangle lacks: one each, at opposite corners.
        let mut lacking = [0b1111_u8; 2];
        for (lacking, triangle) in lacking.iter_mut().zip([first, next]) {
            for corner in triangle {
                let (right, below) = (corner.x == high.x, corner.y == high.y);
                if (!right && corner.x != low.x) || (!below && corner.y != low.y) {
                    return None;
                }
                *lacking &= !(1 << (usize::from(right) + 2 * usize::from(below)));
            }
        }
        if !matches!(lacking, [1, 8] | [8, 1] | [2, 4] | [4, 2]) {
            return None;
        }
        let at = |x: i32, y: i32| all().find(move |c| c.x == x && c.y == y);
        (low, high) = (*at(low.x, low.y)?, *at(high.x, high.y)?);
        let fits = all().all(|corner| {
            let u = if corner.x == low.x { low.u } else { high.u };
            let v = if corner.y == low.y { low.v } else { high.v };
            corner.color == low.color && corner.u == u && corner.v == v
        });
        fits.then_some(Self { low, high })
    }

    pub(super) fn bounds(&self) -> PixelRect {
        PixelRect {
            x0: triangle::first_pixel(self.low.x),
            y0: triangle::first_pixel(self.low.y),
            x1: triangle::first_pixel(self.high.x),
            y1: triangle::first_pixel(self.high.y),
        }
    }

    /// Its colour, if uniform.
    pub(super) fn ink(&self, texture: &Texture) -> Option<Ink> {
        let (u, v) = (self.low.u, self.low.v);
        if (u, v) != (self.high.u, self.high.v) {
            return None;
        }
        let texel = texture.plain(u, v);
        Some(Ink::new(plane::tinted(self.low.color, texel)))
    }

    /// The texel at pixel (0, 0), if texels map to pixels one to one.
    fn texels(&self, texture: &Texture) -> Option<[i32; 2]> {
        let along = |low: i32, high: i32, from: f32, to: f32, count: usize| {
            let count = count as f32;
            let steps = STEPS as f32;
            let (start, end) = (low as f32 / steps, high as f32 / steps);
            let (from, to) = (from * count - start, to * count - end);
            let whole = (from + 0.5f32.copysign(from)) as i32;
            let near = |at: f32| (at - whole as f32).abs() < NEAR;
            (near(from) && near(to)).then_some(whole)
        };
        let (low, high) = (&self.low, &self.high);
        Some([
            along(low.x, high.x, low.u, high.u, texture.width)?,
            along(low.y, high.y, low.v, high.v, texture.height)?,
        ])
    }

    /// Paints its pixels within `cut`, which is in the tile.
    pub(super) fn paint(&self, tile: &mut Tile, texture: &Texture, cut: PixelRect) {
        let cut = cut.intersect(self.bounds());
        if cut.is_empty() {
            return;
        }
        if let Some(ink) = self.ink(texture) {
            for y in cut.y0..cut.y1 {
                ink.fill(tile.span(y, cut.x0, cut.x1));
            }
            return;
        }
        if let Some(rows) = self
            .texels(texture)
            .and_then(|at| Rows::new(texture, at, cut))
        {
            rows.paint(tile, self.low.color, cut);
            return;
        }
        let corner = |right: bool, below: bool| {
            let pick = |high: bool, of: fn(&Corner) -> i32, uv: fn(&Corner) -> f32| {
                let corner = if high { &self.high } else { &self.low };
                (of(corner), uv(corner))
            };
            let (x, u) = pick(right, |c| c.x, |c| c.u);
            let (y, v) = pick(below, |c| c.y, |c| c.v);
            Corner {
                x,
                y,
                u,
                v,
                color: self.low.color,
            }
        };
        let half = [
            corner(false, false),
            corner(true, false),
            corner(false, true),
        ];
        let shader = Shader::new(&half, triangle::twice_area(&half) as f64, texture);
        for y in cut.y0..cut.y1 {
            for (x, pixel) in (cut.x0..cut.x1).zip(tile.span(y, cut.x0, cut.x1)) {
                *pixel = tile::over_exact(*pixel, shader.color(x, y));
            }
        }
    }
}

/// A part of a texture aligned with the pixels.
struct Rows<'a> {
    texture: &'a Texture,
    /// The first pixel's texel.
    left: usize,
    top: usize,
}

impl<'a> Rows<'a> {
    /// `None` unless it is entirely within the texture.
    fn new(texture: &'a Texture, [x, y]: [i32; 2], cut: PixelRect) -> Option<Self> {
        let start = |at: i32, from: i32, to: i32, count: usize| {
            let end = usize::try_from(at.checked_add(to)?).ok()?;
            let from = usize::try_from(at.checked_add(from)?).ok()?;
            (end <= count).then_some(from)
        };
        Some(Self {
            left: start(x, cut.x0, cut.x1, texture.width)?,
            top: start(y, cut.y0, cut.y1, texture.height)?,
            texture,
        })
    }

    fn paint(&self, tile: &mut Tile, color: Color32, cut: PixelRect) {
        let width = (cut.x1 - cut.x0) as usize;
        let ink = Ink::new(color);
        for (row, y) in (cut.y0..cut.y1).enumerate() {
            let start = (self.top + row) * self.texture.width + self.left;
            let pixels = tile.span(y, cut.x0, cut.x1);
            match &self.texture.texels {
                Texels::Coverage(alphas) => {
                    if let Some(alphas) = alphas.get(start..start + width) {
                        let part = |&alpha: &u8| u32::from(alpha) + u32::from(alpha >> 7);
                        ink.lay(pixels, alphas.iter().map(part));
                    }
                }
                Texels::Color(colors) => {
                    let Some(colors) = colors.get(start..start + width) else {
                        continue;
                    };
                    for (pixel, texel) in pixels.iter_mut().zip(colors) {
                        let texel = texel.to_array().map(f32::from);
                        let ink = Ink::new(plane::tinted(color, texel));
                        ink.lay(std::slice::from_mut(pixel), std::iter::once(FULL));
                    }
                }
            }
        }
    }
}
