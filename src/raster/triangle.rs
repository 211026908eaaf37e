//! Triangles of a mesh.
//!
//! Corners are brought to 1/256 of a pixel, and from there on all decisions
//! about which pixel is inside are made in whole numbers, so that along an edge
//! that two triangles share every pixel belongs to exactly one of them: a pixel
//! belongs to a triangle if its middle does; a middle on an edge, if the edge is
//! a left or an upper one.

use egui::epaint::Vertex;
use egui::{Color32, Mesh};

use super::texture::Texture;
use super::tile::{self, Cut, Tile};

/// Steps of a corner within a pixel.
pub(super) const STEPS: i32 = 256;

/// Corners farther out than this many steps are brought back to it, so that
/// products of coordinates fit: a million pixels.
const FARTHEST: f32 = (1_u32 << 28) as f32;

/// A corner in the target.
#[derive(Clone, Copy, Debug)]
pub(super) struct Corner {
    /// Steps of 1/256 pixel from the left.
    pub(super) x: i32,
    /// Steps from the top.
    pub(super) y: i32,
    pub(super) u: f32,
    pub(super) v: f32,
    pub(super) color: Color32,
}

impl Corner {
    /// `None` if the place is not finite.
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

/// The first pixel whose middle is not left of a place.
#[inline]
pub(super) fn first_pixel(at: i32) -> i32 {
    (at + STEPS / 2 - 1) >> 8
}

/// One triangle of a mesh, if it has corners that are there and finite.
#[inline]
pub(super) fn corners(mesh: &Mesh, triangle: usize, pixels_per_point: f32) -> Option<[Corner; 3]> {
    let &[a, b, c] = mesh.indices.get(triangle * 3..triangle * 3 + 3)? else {
        return None;
    };
    let corner = |index: u32| Corner::new(mesh.vertices.get(index as usize)?, pixels_per_point);
    Some([corner(a)?, corner(b)?, corner(c)?])
}

/// The pixels among which a triangle's are.
#[inline]
pub(super) fn bounds(corners: &[Corner; 3]) -> Cut {
    let [a, b, c] = corners;
    Cut {
        x0: first_pixel(a.x.min(b.x).min(c.x)),
        y0: first_pixel(a.y.min(b.y).min(c.y)),
        x1: first_pixel(a.x.max(b.x).max(c.x)),
        y1: first_pixel(a.y.max(b.y).max(c.y)),
    }
}

/// The line through two corners: `x * dx + y * dy + rest` is not negative on
/// the middles of pixels that are inside.
#[derive(Clone, Copy)]
pub(super) struct Edge {
    dx: i64,
    dy: i64,
    rest: i64,
}

impl Edge {
    /// The inside is to the right of the way from `a` to `b`, seen with y
    /// downwards and turning clockwise.
    fn new(a: &Corner, b: &Corner) -> Self {
        let (ax, ay) = (i64::from(a.x), i64::from(a.y));
        let (along_x, along_y) = (i64::from(b.x) - ax, i64::from(b.y) - ay);
        // Upper: to the right; left: upwards. Others lose their middles.
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

    /// Whether a pixel of the rectangle, which is not empty, is inside.
    #[inline]
    pub(super) fn touches(&self, cut: Cut) -> bool {
        let x = if self.dx > 0 { cut.x1 - 1 } else { cut.x0 };
        let y = if self.dy > 0 { cut.y1 - 1 } else { cut.y0 };
        self.at(x, y) >= 0
    }
}

/// The three edges; `None` if the triangle has no area.
pub(super) fn edges(corners: &[Corner; 3]) -> Option<[Edge; 3]> {
    let [a, b, c] = corners;
    match twice_area(corners) {
        0 => None,
        1.. => Some([Edge::new(a, b), Edge::new(b, c), Edge::new(c, a)]),
        _ => Some([Edge::new(a, c), Edge::new(c, b), Edge::new(b, a)]),
    }
}

/// Positive if the corners turn clockwise, y being downwards.
fn twice_area([a, b, c]: &[Corner; 3]) -> i64 {
    let x = |corner: &Corner| i64::from(corner.x) - i64::from(a.x);
    let y = |corner: &Corner| i64::from(corner.y) - i64::from(a.y);
    x(b) * y(c) - x(c) * y(b)
}

/// The pixels of row `y` from `x0` up to `x1` that are inside of all edges.
#[inline]
fn row(edges: &[Edge; 3], y: i32, x0: i32, x1: i32) -> (i32, i32) {
    let (mut from, mut to) = (0, i64::from(x1 - x0));
    for edge in edges {
        let start = edge.at(x0, y);
        if start >= 0 && edge.dx >= 0 {
            continue;
        }
        if start < 0 && edge.dx <= 0 {
            return (x0, x0);
        }
        // The number of steps to the place where the sign changes; the
        // quotient is off by one at most.
        let mut steps = (-start as f64 / edge.dx as f64) as i64;
        if edge.dx > 0 {
            if steps > to {
                return (x0, x0);
            }
            while start + steps * edge.dx < 0 {
                steps += 1;
            }
            while start + (steps - 1) * edge.dx >= 0 {
                steps -= 1;
            }
            from = from.max(steps);
        } else if steps <= to {
            while start + steps * edge.dx < 0 {
                steps -= 1;
            }
            while start + (steps + 1) * edge.dx >= 0 {
                steps += 1;
            }
            to = to.min(steps + 1);
        }
    }
    (x0 + from as i32, x0 + to.max(from) as i32)
}

/// A quantity that is given at three corners, over the plane.
struct Plane {
    at: f64,
    x: f64,
    y: f64,
}

impl Plane {
    fn new(corners: &[Corner; 3], area: f64, values: [f64; 3]) -> Self {
        let [a, b, c] = corners;
        let x = |corner: &Corner| f64::from(corner.x) - f64::from(a.x);
        let y = |corner: &Corner| f64::from(corner.y) - f64::from(a.y);
        let (to_b, to_c) = (values[1] - values[0], values[2] - values[0]);
        let dx = (to_b * y(c) - to_c * y(b)) / area * f64::from(STEPS);
        let dy = (to_c * x(b) - to_b * x(c)) / area * f64::from(STEPS);
        let middle = |at: i32| 0.5 - f64::from(at) / f64::from(STEPS);
        Self {
            at: values[0] + dx * middle(a.x) + dy * middle(a.y),
            x: dx,
            y: dy,
        }
    }

    #[inline]
    fn value(&self, x: i32, y: i32) -> f64 {
        self.at + self.x * f64::from(x) + self.y * f64::from(y)
    }
}

/// Blue, green, red, alpha of a colour, in which a texel is taken in.
fn tinted(color: Color32, [r, g, b, a]: [f32; 4]) -> [f32; 4] {
    let [cr, cg, cb, ca] = color.to_array().map(f32::from);
    [cb * b, cg * g, cr * r, ca * a].map(|c| c / 255.0)
}

/// Paints the pixels of a triangle within a rectangle that lies in the tile.
pub(super) fn paint(tile: &mut Tile, corners: &[Corner; 3], texture: &Texture, cut: Cut) {
    let cut = cut.and(bounds(corners));
    let Some(edges) = edges(corners) else { return };
    if cut.is_empty() {
        return;
    }
    let area = twice_area(corners) as f64;
    let [a, b, c] = corners;
    let plane = |values: [f32; 3]| Plane::new(corners, area, values.map(f64::from));
    let us = [a.u, b.u, c.u];
    let vs = [a.v, b.v, c.v];
    let plain = us == [a.u; 3] && vs == [a.v; 3];
    if plain {
        let filter = texture.filter(0.0);
        let texel = texture.sample(a.u, a.v, filter);
        let colors = corners.map(|corner| tinted(corner.color, texel));
        if colors[0] == colors[1] && colors[0] == colors[2] {
            let [b, g, r, a] = colors[0].map(|c| (c + 0.5) as u8);
            let color = Color32::from_rgba_premultiplied(r, g, b, a);
            for y in cut.y0..cut.y1 {
                let (x0, x1) = row(&edges, y, cut.x0, cut.x1);
                tile::fill(tile.span(y, x0, x1), color);
            }
            return;
        }
        let planes: [Plane; 4] = std::array::from_fn(|i| plane(colors.map(|c| c[i])));
        let steps: [f32; 4] = std::array::from_fn(|i| planes[i].x as f32);
        for y in cut.y0..cut.y1 {
            let (x0, x1) = row(&edges, y, cut.x0, cut.x1);
            let start: [f32; 4] = std::array::from_fn(|i| planes[i].value(x0, y) as f32);
            for (i, pixel) in tile.span(y, x0, x1).iter_mut().enumerate() {
                let color: [f32; 4] =
                    std::array::from_fn(|c| (start[c] + steps[c] * i as f32).clamp(0.0, 255.0));
                *pixel = tile::over_exact(*pixel, color);
            }
        }
        return;
    }
    let colors = corners.map(|corner| {
        let [r, g, b, a] = corner.color.to_array().map(f32::from);
        [b, g, r, a]
    });
    let planes: [Plane; 4] = std::array::from_fn(|i| plane(colors.map(|c| c[i])));
    let (u, v) = (plane(us), plane(vs));
    let (w, h) = (texture.width as f64, texture.height as f64);
    let per_pixel = f64::hypot(u.x * w, v.x * h).max(f64::hypot(u.y * w, v.y * h));
    let filter = texture.filter(per_pixel as f32);
    for y in cut.y0..cut.y1 {
        let (x0, x1) = row(&edges, y, cut.x0, cut.x1);
        for x in x0..x1 {
            let [r, g, b, a] = texture.sample(u.value(x, y) as f32, v.value(x, y) as f32, filter);
            let texel = [b, g, r, a];
            let color: [f32; 4] = std::array::from_fn(|c| {
                (planes[c].value(x, y) as f32).clamp(0.0, 255.0) * texel[c] * (1.0 / 255.0)
            });
            for pixel in tile.span(y, x, x + 1) {
                *pixel = tile::over_exact(*pixel, color);
            }
        }
    }
}
