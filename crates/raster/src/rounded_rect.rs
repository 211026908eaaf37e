//! Rectangles with rounded corners and an inner border, circles, and vertical and horizontal lines.
//! egui tessellates each into dozens of triangles, mostly for the feathered rims; here each is one
//! primitive, painted by coverage.

use std::sync::Arc;

use egui::emath::GuiRounding as _;
use egui::epaint::{CircleShape, ClippedShape, ColorMode, PathStroke, RectShape, StrokeKind};
use egui::{Color32, PaintCallback, Pos2, Rect, Shape, Stroke, Vec2};

use super::lines::{Line, Lines};

/// A rectangle with optionally rounded corners and a border.
#[derive(Clone, Copy, Debug)]
pub(super) struct RoundedRect {
    /// The outer edges, in points.
    pub(super) rect: Rect,
    /// The radii of the outer corners, in points: top left, top right, bottom left, bottom right.
    pub(super) radii: [f32; 4],
    /// The colour within the border.
    pub(super) fill: Color32,
    /// The width of the border, in points.
    pub(super) border: f32,
    pub(super) border_color: Color32,
}

/// Replaces rectangles and circles by rounded rectangles, and other lines by [`Lines`], if the
/// result looks the same. The number of shapes is unchanged.
pub(super) fn replace_shapes(shapes: &mut [ClippedShape], pixels_per_point: f32) {
    for shape in shapes {
        // Shapes transformed later are not aligned with pixels here.
        if shape.transform_after_tessellation == egui::emath::TSTransform::IDENTITY {
            replace_shape(&mut shape.shape, pixels_per_point);
        }
    }
}

fn replace_shape(shape: &mut Shape, pixels_per_point: f32) {
    let (rounded_rect, lines) = match shape {
        Shape::Vec(shapes) => {
            for shape in shapes {
                replace_shape(shape, pixels_per_point);
            }
            return;
        }
        Shape::Rect(rect) => (RoundedRect::of_rect(rect, pixels_per_point), None),
        Shape::Circle(circle) => (RoundedRect::of_circle(circle), None),
        Shape::LineSegment { points, stroke } => {
            let rounded_rect = RoundedRect::of_line(*points, *stroke, pixels_per_point);
            let line = || lines(&*points, stroke.width, stroke.color);
            (rounded_rect, rounded_rect.is_none().then(line))
        }
        Shape::Path(path) => match path.stroke {
            PathStroke {
                width,
                color: ColorMode::Solid(color),
                kind: StrokeKind::Middle,
            } if path.fill == Color32::TRANSPARENT && !path.closed => {
                (None, Some(lines(&path.points, width, color)))
            }
            _ => return,
        },
        _ => return,
    };
    if let Some(rounded_rect) = rounded_rect {
        *shape = Shape::Callback(PaintCallback {
            rect: rounded_rect.rect.expand(1.0 / pixels_per_point),
            callback: Arc::new(rounded_rect),
        });
    } else if let Some(lines) = lines {
        *shape = Lines::shape(&Arc::new(lines), Rect::EVERYTHING);
    }
}

fn lines(points: &[Pos2], width: f32, color: Color32) -> Lines {
    let lines = points.windows(2).map(|ends| Line {
        from: ends[0],
        to: ends[1],
        width,
        color,
    });
    Lines {
        lines: lines.collect(),
    }
}

/// Normalizes an invisible stroke to [`Stroke::NONE`].
fn seen(stroke: Stroke) -> Stroke {
    if stroke.is_empty() {
        Stroke::NONE
    } else {
        stroke
    }
}

impl RoundedRect {
    /// Bitwise equality.
    pub(super) fn same_bits(&self, other: &Self) -> bool {
        // egui's comparison rejects NaN.
        let bits = |rounded_rect: &Self| {
            let Rect { min, max } = rounded_rect.rect;
            let [a, b, c, d] = rounded_rect.radii;
            [min.x, min.y, max.x, max.y, a, b, c, d, rounded_rect.border].map(f32::to_bits)
        };
        let colors = |rounded_rect: &Self| [rounded_rect.fill, rounded_rect.border_color];
        bits(self) == bits(other) && colors(self) == colors(other)
    }

    /// `None` for shapes that egui must paint: images, shadows, rotated or very thin rectangles.
    fn of_rect(shape: &RectShape, pixels_per_point: f32) -> Option<Self> {
        let stroke = seen(shape.stroke);
        let plain = shape.brush.is_none() && shape.blur_width <= 0.0 && shape.angle == 0.0;
        if !plain || (shape.fill == Color32::TRANSPARENT && stroke.is_empty()) {
            return None;
        }
        let outside = match shape.stroke_kind {
            StrokeKind::Inside => 0.0,
            StrokeKind::Middle => 0.5 * stroke.width,
            StrokeKind::Outside => stroke.width,
        };
        let mut rect = shape.rect;
        if shape.round_to_pixels.unwrap_or(true) {
            if shape.stroke_kind == StrokeKind::Middle && !stroke.is_empty() {
                for at in [
                    &mut rect.min.x,
                    &mut rect.min.y,
                    &mut rect.max.x,
                    &mut rect.max.y,
                ] {
                    stroke.round_center_to_pixel(pixels_per_point, at);
                }
            } else {
                rect = rect.round_to_pixels(pixels_per_point);
            }
        }
        let rect = rect.expand(outside);
        // egui aligns thinner ones in a different way.
        let thin = 2.0 * stroke.width.max(1.0 / pixels_per_point);
        let size = rect.size().min_elem();
        if !rect.is_finite() || !(size > thin + 0.5 / pixels_per_point) {
            return None;
        }
        let radius = shape.corner_radius;
        let radii = [radius.nw, radius.ne, radius.sw, radius.se].map(|radius| match radius {
            0 => 0.0,
            _ => (f32::from(radius) + outside).min(0.5 * size),
        });
        Some(Self {
            rect,
            radii,
            fill: shape.fill,
            border: stroke.width,
            border_color: stroke.color,
        })
    }

    /// A vertical or horizontal line, aligned with the pixels.
    fn of_line([a, b]: [Pos2; 2], stroke: Stroke, pixels_per_point: f32) -> Option<Self> {
        if (a.x != b.x && a.y != b.y) || stroke.is_empty() {
            return None;
        }
        let pixel = 1.0 / pixels_per_point;
        let mut rect = Rect::from_two_pos(a, b);
        // Shortened a little, so that an end between two pixels does not round outwards on both
        // sides; then to whole pixels.
        let along = |low: &mut f32, high: &mut f32| {
            *low = (*low + 0.25 * pixel).round_to_pixel_center(pixels_per_point) - 0.5 * pixel;
            *high = (*high - 0.25 * pixel).round_to_pixel_center(pixels_per_point) + 0.5 * pixel;
        };
        let across = |low: &mut f32, high: &mut f32| {
            stroke.round_center_to_pixel(pixels_per_point, low);
            (*low, *high) = (*low - 0.5 * stroke.width, *low + 0.5 * stroke.width);
        };
        let Rect { min, max } = &mut rect;
        if a.x == b.x {
            across(&mut min.x, &mut max.x);
            along(&mut min.y, &mut max.y);
        } else {
            along(&mut min.x, &mut max.x);
            across(&mut min.y, &mut max.y);
        }
        rect.is_finite().then_some(Self {
            rect,
            radii: [0.0; 4],
            fill: stroke.color,
            border: 0.0,
            border_color: Color32::TRANSPARENT,
        })
    }

    fn of_circle(shape: &CircleShape) -> Option<Self> {
        let stroke = seen(shape.stroke);
        let radius = shape.radius + stroke.width;
        let rect = Rect::from_center_size(shape.center, Vec2::splat(2.0 * radius));
        (shape.radius > 0.0 && rect.is_finite()).then_some(Self {
            rect,
            radii: [radius; 4],
            fill: shape.fill,
            border: stroke.width,
            border_color: stroke.color,
        })
    }
}
