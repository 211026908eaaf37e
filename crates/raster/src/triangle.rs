//! Triangles of a mesh. Corners are rounded to 1/256 pixel; from then on all inside tests use
//! integers ([`super::spans`]).

use egui::epaint::Vertex;
use egui::{Color32, Mesh};

use super::plane::{self, Plane};
use super::spans::Spans;
use super::texture::Texture;
use super::tile::{self, FULL, Ink, PixelRect, Tile};

/// Subpixel steps per pixel.
pub(super) const STEPS: i32 = 256;

/// Coordinates are clamped to this many steps, a million pixels, so that products do not overflow.
const FARTHEST: f32 = (1_u32 << 28) as f32;

#[derive(Clone, Copy, Debug)]
pub(super) struct Corner {
    /// In subpixel steps from the left.
    pub(super) x: i32,
    /// In subpixel steps from the top.
    pub(super) y: i32,
    pub(super) u: f32,
    pub(super) v: f32,
    pub(super) color: Color32,
}

impl Corner {
    /// `None` if the position is not finite.
    #[inline]
    pub(super) fn new(vertex: &Vertex, pixels_per_point: f32) -> Option<Self> {
        let step = |at: f32| {
            let at = at * (pixels_per_point * STEPS as f32);
            let at = at.clamp(-FARTHEST, FARTHEST);
            (at + 0.5f32.copysign(at)) as i32
        };
        (vertex.pos.x.is_finite() && vertex.pos.y.is_finite()).then(|| Self {
            x: step(vertex.pos.x),
            y: step(vertex.pos.y),
            u: vertex.uv.x,
            v: vertex.uv.y,
            color: vertex.color,
        })
    }
}

/// The first pixel whose centre is not left of a position.
#[inline]
pub(super) fn first_pixel(at: i32) -> i32 {
    (at + STEPS / 2 - 1) >> 8
}

#[inline]
pub(super) fn corners(mesh: &Mesh, triangle: usize, pixels_per_point: f32) -> Option<[Corner; 3]> {
    let &[a, b, c] = mesh.indices.get(triangle * 3..triangle * 3 + 3)? else {
        return None;
    };
    let corner = |index: u32| Corner::new(mesh.vertices.get(index as usize)?, pixels_per_point);
    Some([corner(a)?, corner(b)?, corner(c)?])
}

#[inline]
pub(super) fn bounds(corners: &[Corner; 3]) -> PixelRect {
    let [a, b, c] = corners;
    PixelRect {
        x0: first_pixel(a.x.min(b.x).min(c.x)),
        y0: first_pixel(a.y.min(b.y).min(c.y)),
        x1: first_pixel(a.x.max(b.x).max(c.x)),
        y1: first_pixel(a.y.max(b.y).max(c.y)),
    }
}

/// `x * dx + y * dy + rest` is non-negative for pixels whose centres are inside.
#[derive(Clone, Copy)]
pub(super) struct Edge {
    dx: i64,
    dy: i64,
    rest: i64,
}

impl Edge {
    /// The inside is to the right when going from `a` to `b`, with y down (clockwise).
    fn new(a: &Corner, b: &Corner) -> Self {
        let (ax, ay) = (i64::from(a.x), i64::from(a.y));
        let (along_x, along_y) = (i64::from(b.x) - ax, i64::from(b.y) - ay);
        // Top edges run right, left edges up. Other edges exclude centres on them.
        let own = (along_y == 0 && along_x > 0) || along_y < 0;
        let (dx, dy) = (-along_y, along_x);
        let half = i64::from(STEPS) / 2;
        let rest = dx * (half - ax) + dy * (half - ay) - i64::from(!own);
        Self {
            dx: dx * i64::from(STEPS),
            dy: dy * i64::from(STEPS),
            rest,
        }
    }

    #[inline]
    fn at(&self, x: i32, y: i32) -> i64 {
        i64::from(x) * self.dx + i64::from(y) * self.dy + self.rest
    }

    /// Whether a pixel of the non-empty rectangle is inside.
    #[inline]
    pub(super) fn touches(&self, cut: PixelRect) -> bool {
        let x = if self.dx > 0 { cut.x1 - 1 } else { cut.x0 };
        let y = if self.dy > 0 { cut.y1 - 1 } else { cut.y0 };
        self.at(x, y) >= 0
    }
}

/// The three edges; `None` if the area is zero.
pub(super) fn edges(corners: &[Corner; 3]) -> Option<[Edge; 3]> {
    let [a, b, c] = corners;
    match twice_area(corners) {
        0 => None,
        1.. => Some([Edge::new(a, b), Edge::new(b, c), Edge::new(c, a)]),
        _ => Some([Edge::new(a, c), Edge::new(c, b), Edge::new(b, a)]),
    }
}

/// Positive if the corners turn clockwise, with y down.
pub(super) fn twice_area([a, b, c]: &[Corner; 3]) -> i64 {
    let x = |corner: &Corner| i64::from(corner.x) - i64::from(a.x);
    let y = |corner: &Corner| i64::from(corner.y) - i64::from(a.y);
    x(b) * y(c) - x(c) * y(b)
}

enum Paint {
    Plain(Ink),
    /// One colour fading from corner to corner: egui's feathered edges.
    Faded(Ink, [f64; 3]),
    /// Any colours, at one point of the texture.
    Shaded([Color32; 3]),
    Textured,
}

/// Whether all corners have the same texture coordinates.
pub(super) fn is_plain(corners: &[Corner]) -> bool {
    corners
        .iter()
        .all(|c| c.u == corners[0].u && c.v == corners[0].v)
}

impl Paint {
    fn of(corners: &[Corner; 3], texture: &Texture) -> Self {
        if !is_plain(corners) {
            return Self::Textured;
        }
        let texel = texture.plain(corners[0].u, corners[0].v);
        let colors = corners.map(|corner| plane::tinted(corner.color, texel));
        let none = Color32::TRANSPARENT;
        let some = colors.into_iter().find(|&c| c != none).unwrap_or(none);
        if colors == [some; 3] {
            return Self::Plain(Ink::new(some));
        }
        if colors.iter().all(|&c| c == some || c == none) {
            let full = f64::from(FULL);
            let weights = colors.map(|c| if c == some { full } else { 0.0 });
            return Self::Faded(Ink::new(some), weights);
        }
        Self::Shaded(colors)
    }
}

pub(super) fn paint(tile: &mut Tile, corners: &[Corner; 3], texture: &Texture, cut: PixelRect) {
    let cut = cut.intersect(bounds(corners));
    let area = twice_area(corners);
    if cut.is_empty() || area == 0 {
        return;
    }
    let area = area as f64;
    let mut spans = Spans::new(cut);
    let [a, b, c] = corners.map(|corner| (corner.x, corner.y));
    spans.add(a, b);
    spans.add(b, c);
    spans.add(c, a);
    match Paint::of(corners, texture) {
        Paint::Plain(ink) => {
            for (y, x0, x1) in spans.rows() {
                ink.fill(tile.span(y, x0, x1));
            }
        }
        Paint::Faded(ink, weights) => {
            let weight = Plane::new(corners, area, weights);
            let step = weight.x as f32;
            for (y, x0, x1) in spans.rows() {
                let start = weight.value(x0, y) as f32 + 0.5;
                let weights = (0..).map(|i: i32| {
                    let weight = (start + step * i as f32) as i32;
                    weight.clamp(0, FULL as i32) as u32
                });
                ink.lay(tile.span(y, x0, x1), weights);
            }
        }
        Paint::Shaded(colors) => {
            let channels = colors.map(tile::channels);
            let plane = |i: usize| Plane::new(corners, area, channels.map(|c| f64::from(c[i])));
            let planes: [Plane; 4] = std::array::from_fn(plane);
            let steps: [f32; 4] = std::array::from_fn(|i| planes[i].x as f32);
            for (y, x0, x1) in spans.rows() {
                let start: [f32; 4] = std::array::from_fn(|i| planes[i].value(x0, y) as f32);
                for (i, pixel) in tile.span(y, x0, x1).iter_mut().enumerate() {
                    let color: [f32; 4] =
                        std::array::from_fn(|c| (start[c] + steps[c] * i as f32).clamp(0.0, 255.0));
                    *pixel = tile::over_exact(*pixel, color);
                }
            }
        }
        Paint::Textured => {
            let shader = plane::Shader::new(corners, area, texture);
            for (y, x0, x1) in spans.rows() {
                for (x, pixel) in (x0..x1).zip(tile.span(y, x0, x1)) {
                    *pixel = tile::over_exact(*pixel, shader.color(x, y));
                }
            }
        }
    }
}
