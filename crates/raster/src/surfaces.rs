//! Flat triangles with hidden surfaces removed: a depth buffer (Catmull 1974).

use std::collections::TryReserveError;
use std::sync::Arc;

use egui::{Color32, PaintCallback, Rect, Shape};

use super::area::Area;
use super::tile::PixelRect;

/// Triangles painted into a separate buffer, with the nearness of each pixel.
#[derive(Clone, Debug, Default)]
pub struct Surfaces {
    area: Area,
    /// The number of samples along each side of a pixel.
    fine: u32,
    colors: Vec<Color32>,
    /// Greater is nearer; −∞ if nothing is painted.
    nearness: Vec<f32>,
}

/// A corner: x and y in pixels of the target, and its nearness, which is linear on the screen.
pub type Corner3 = [f64; 3];

fn filled<T: Clone>(value: T, count: usize) -> Result<Vec<T>, TryReserveError> {
    let mut all = Vec::new();
    all.try_reserve_exact(count)?;
    all.resize(count, value);
    Ok(all)
}

impl Surfaces {
    /// An empty buffer for these pixels of the target. `fine` smooths outlines, for four times the
    /// time, once [`Surfaces::settle`] is called.
    ///
    /// # Errors
    /// Out of memory.
    pub fn new(area: Area, fine: bool) -> Result<Self, TryReserveError> {
        let fine = 1 + u32::from(fine);
        let count = area.width as usize * area.height as usize * (fine * fine) as usize;
        Ok(Self {
            area,
            fine,
            colors: filled(Color32::TRANSPARENT, count)?,
            nearness: filled(f32::NEG_INFINITY, count)?,
        })
    }

    /// A shape for egui's painter; `clip` is the clip rectangle in points.
    pub fn shape(surfaces: &Arc<Self>, clip: Rect) -> Shape {
        Shape::Callback(PaintCallback {
            rect: clip,
            callback: Arc::<Self>::clone(surfaces),
        })
    }

    /// Paints a triangle where it is nearer than what is there. One that is not finite is ignored.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    pub fn triangle(&mut self, corners: [Corner3; 3], color: Color32) {
        let fine = f64::from(self.fine);
        let (left, top) = (f64::from(self.area.x), f64::from(self.area.y));
        let mut corners = corners.map(|[x, y, z]| [(x - left) * fine, (y - top) * fine, z]);
        corners.sort_by(|a, b| a[1].total_cmp(&b[1]));
        let [a, b, c] = corners;
        let wide = (self.area.width * self.fine) as usize;
        let high = (self.area.height * self.fine) as usize;
        // Samples are in the middles. NaN becomes 0.
        let first = |at: f64, end: usize| ((at + 0.5).max(0.0) as usize).min(end);
        let rows = first(a[1], high)..first(c[1], high);
        let [to_b, to_c] = [b, c].map(|p| [p[0] - a[0], p[1] - a[1], p[2] - a[2]]);
        let twice = to_b[0] * to_c[1] - to_c[0] * to_b[1];
        // The plane of a sliver is inexact, so the corners bound it.
        let low = a[2].min(b[2]).min(c[2]) as f32;
        let top = a[2].max(b[2]).max(c[2]) as f32;
        if rows.is_empty() || twice == 0.0 || !twice.is_finite() || low.is_nan() {
            return;
        }
        let along = (to_b[2] * to_c[1] - to_c[2] * to_b[1]) / twice;
        let down = (to_c[2] * to_b[0] - to_b[2] * to_c[0]) / twice;
        let [long, upper, lower] =
            [(a, c), (a, b), (b, c)].map(|(p, q)| [p[0], p[1], (q[0] - p[0]) / (q[1] - p[1])]);
        let at = |[x, y, slope]: Corner3, row: f64| x + slope * (row - y);
        for row in rows {
            let y = row as f64 + 0.5;
            let long = at(long, y);
            let short = at(if y < b[1] { upper } else { lower }, y);
            let (from, to) = (first(long.min(short), wide), first(long.max(short), wide));
            let begins = a[2] + along * (from as f64 + 0.5 - a[0]) + down * (y - a[1]);
            let (begins, along) = (begins as f32, along as f32);
            let places = row * wide + from..row * wide + to.max(from);
            let known = self.nearness[places.clone()].iter_mut();
            // Written unconditionally, so that several are filled at once.
            for (step, (known, shown)) in (0_i32..).zip(known.zip(&mut self.colors[places])) {
                let near = (begins + along * step as f32).max(low).min(top);
                let nearer = near > *known;
                *known = if nearer { near } else { *known };
                *shown = if nearer { color } else { *shown };
            }
        }
    }

    /// Combines the samples to pixels. Call it after all triangles.
    ///
    /// # Errors
    /// Out of memory.
    pub fn settle(&mut self) -> Result<(), TryReserveError> {
        if self.fine == 1 {
            return Ok(());
        }
        let (wide, high) = (self.area.width as usize, self.area.height as usize);
        let mut colors = filled(Color32::TRANSPARENT, wide * high)?;
        let mut nearness = filled(f32::NEG_INFINITY, wide * high)?;
        for (at, (color, near)) in colors.iter_mut().zip(&mut nearness).enumerate() {
            let first = at / wide * 4 * wide + at % wide * 2;
            let samples = [first, first + 1, first + 2 * wide, first + 2 * wide + 1];
            let shown = samples.map(|sample| self.colors[sample].to_array());
            let [r, g, b, a] = std::array::from_fn(|part| {
                let sum: u16 = shown.iter().map(|color| u16::from(color[part])).sum();
                ((sum + 2) / 4) as u8
            });
            *color = Color32::from_rgba_premultiplied(r, g, b, a);
            // The farthest sample, so that a position at an outline is visible.
            *near = samples
                .map(|sample| self.nearness[sample])
                .into_iter()
                .fold(f32::INFINITY, f32::min);
        }
        (self.fine, self.colors, self.nearness) = (1, colors, nearness);
        Ok(())
    }

    /// Whether nothing was painted.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.colors.is_empty()
    }

    /// The pixels of the target that it covers.
    #[must_use]
    pub fn area(&self) -> Area {
        self.area
    }

    /// Whether a position is hidden: behind what is painted in its pixel and in the neighbouring
    /// ones.
    #[must_use]
    pub fn hides(&self, [x, y, near]: Corner3) -> bool {
        let Some([x, y]) = self.pixel([x, y]) else {
            return false;
        };
        let (wide, high) = (self.area.width as usize, self.area.height as usize);
        // Anything beyond the area is invisible.
        let columns = x.saturating_sub(1)..=(x + 1).min(wide - 1);
        let rows = y.saturating_sub(1)..=(y + 1).min(high - 1);
        let across = columns.map(|x| y * wide + x);
        let along = rows.map(|y| y * wide + x);
        let hidden = |at: usize| {
            self.nearness
                .get(at)
                .is_some_and(|&known| f64::from(known) > near)
        };
        across.chain(along).all(hidden)
    }

    /// The nearness of what is painted at a position; none where nothing is.
    #[must_use]
    pub fn nearness(&self, at: [f64; 2]) -> Option<f64> {
        let [x, y] = self.pixel(at)?;
        let known = self.nearness.get(y * self.area.width as usize + x)?;
        known.is_finite().then(|| f64::from(*known))
    }

    /// The column and row within the area of the pixel at a position.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    fn pixel(&self, [x, y]: [f64; 2]) -> Option<[usize; 2]> {
        let place = [x - f64::from(self.area.x), y - f64::from(self.area.y)];
        let size = [self.area.width, self.area.height].map(f64::from);
        let inside = (0..2).all(|at| (0.0..size[at]).contains(&place[at]));
        inside.then(|| place.map(|at| at as usize))
    }

    pub(super) fn bounds(&self) -> PixelRect {
        let [x0, y0] = [self.area.x, self.area.y].map(|at| i32::try_from(at).unwrap_or(i32::MAX));
        let [wide, high] =
            [self.area.width, self.area.height].map(|size| i32::try_from(size).unwrap_or(i32::MAX));
        PixelRect {
            x0,
            y0,
            x1: x0.saturating_add(wide),
            y1: y0.saturating_add(high),
        }
    }

    /// Its rows within `within`: y, the first x, and the colours.
    pub(super) fn rows(&self, within: PixelRect) -> impl Iterator<Item = (i32, i32, &[Color32])> {
        let all = self.bounds();
        let cut = if self.is_empty() {
            PixelRect { x1: all.x0, ..all }
        } else {
            all.intersect(within)
        };
        let rows = if cut.is_empty() { 0..0 } else { cut.y0..cut.y1 };
        rows.filter_map(move |y| {
            let row = (y - all.y0) as usize * self.area.width as usize;
            let [from, to] = [cut.x0, cut.x1].map(|x| row + (x - all.x0) as usize);
            Some((y, cut.x0, self.colors.get(from..to)?))
        })
    }
}
