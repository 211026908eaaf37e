//! Linear interpolation over a triangle.

use egui::Color32;
use egui::epaint::textures::TextureFilter;

use super::texture::Texture;
use super::triangle::{Corner, STEPS};

/// A linear function over the plane, given by its values at three corners.
pub(super) struct Plane {
    at: f64,
    /// The increment per pixel along x.
    pub(super) x: f64,
    y: f64,
}

impl Plane {
    /// `area` is [`super::triangle::twice_area`], not zero.
    pub(super) fn new(corners: &[Corner; 3], area: f64, values: [f64; 3]) -> Self {
        let [a, b, c] = corners;
        let x = |corner: &Corner| f64::from(corner.x) - f64::from(a.x);
        let y = |corner: &Corner| f64::from(corner.y) - f64::from(a.y);
        let (to_b, to_c) = (values[1] - values[0], values[2] - values[0]);
        let scale = f64::from(STEPS) / area;
        let dx = (to_b * y(c) - to_c * y(b)) * scale;
        let dy = (to_c * x(b) - to_b * x(c)) * scale;
        let middle = |at: i32| 0.5 - f64::from(at) / f64::from(STEPS);
        Self {
            at: values[0] + dx * middle(a.x) + dy * middle(a.y),
            x: dx,
            y: dy,
        }
    }

    /// The value at a pixel's centre.
    #[inline]
    pub(super) fn value(&self, x: i32, y: i32) -> f64 {
        self.at + self.x * f64::from(x) + self.y * f64::from(y)
    }
}

/// Multiplies a colour by a texel with channels 0…255.
#[inline]
pub(super) fn tinted(color: Color32, texel: [f32; 4]) -> Color32 {
    if texel == [255.0; 4] {
        return color;
    }
    let color = color.to_array();
    let [r, g, b, a] = std::array::from_fn(|i| {
        let product = f32::from(color[i]) * texel[i] * (1.0 / 255.0);
        (product + 0.5) as u8
    });
    Color32::from_rgba_premultiplied(r, g, b, a)
}

/// A triangle's interpolated colours and texture.
pub(super) struct Shader<'a> {
    texture: &'a Texture,
    filter: TextureFilter,
    colors: [Plane; 4],
    u: Plane,
    v: Plane,
}

impl<'a> Shader<'a> {
    pub(super) fn new(corners: &[Corner; 3], area: f64, texture: &'a Texture) -> Self {
        let plane = |of: &dyn Fn(&Corner) -> f32| {
            let [a, b, c] = corners;
            Plane::new(corners, area, [of(a), of(b), of(c)].map(f64::from))
        };
        let (u, v) = (plane(&|c| c.u), plane(&|c| c.v));
        let (w, h) = (texture.width as f64, texture.height as f64);
        let step = f64::hypot(u.x * w, v.x * h).max(f64::hypot(u.y * w, v.y * h));
        Self {
            texture,
            filter: texture.filter(step as f32),
            colors: std::array::from_fn(|i| plane(&|c| f32::from(c.color.to_array()[i]))),
            u,
            v,
        }
    }

    /// Blue, green, red, alpha.
    pub(super) fn color(&self, x: i32, y: i32) -> [f32; 4] {
        let (u, v) = (self.u.value(x, y) as f32, self.v.value(x, y) as f32);
        let [r, g, b, a] = self.texture.sample(u, v, self.filter);
        let texel = [r, g, b, a];
        let [r, g, b, a] = std::array::from_fn(|i| {
            let color = (self.colors[i].value(x, y) as f32).clamp(0.0, 255.0);
            color * texel[i] * (1.0 / 255.0)
        });
        [b, g, r, a]
    }
}
