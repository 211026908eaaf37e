//! Rounded rectangles: how much of each pixel is covered, and that they are what egui shows.

use std::f32::consts::PI;
use std::sync::Arc;

use egui::emath::TSTransform;
use egui::epaint::{
    CircleShape, ClippedShape, CornerRadius, PaintCallback, Primitive, RectShape,
    TessellationOptions, Tessellator,
};
use egui::{ClippedPrimitive, Color32, Rect, Shape, Stroke, StrokeKind, TextureId, pos2, vec2};

use super::{Random, Screen, covered, everywhere};
use crate::rounded_rect::{RoundedRect, replace_shapes};

pub(super) fn primitive(rounded_rect: RoundedRect) -> ClippedPrimitive {
    everywhere(Primitive::Callback(PaintCallback {
        rect: Rect::EVERYTHING,
        callback: Arc::new(rounded_rect),
    }))
}

/// How much of each pixel of a square lies within a rounded rectangle's edge, brought in by
/// something.
fn coverage(rounded_rect: &RoundedRect, by: f32, side: usize) -> Vec<f64> {
    let rect = rounded_rect.rect.shrink(by);
    let [left, top, right, bottom] =
        [rect.min.x, rect.min.y, rect.max.x, rect.max.y].map(f64::from);
    let radii = rounded_rect
        .radii
        .map(|radius| f64::from((radius - by).max(0.0)));
    covered(side, |y| {
        let inset = |above: f64, below: f64| {
            let within = |radius: f64, way: f64| {
                let into = (radius - way).max(0.0);
                radius - (radius * radius - into * into).max(0.0).sqrt()
            };
            within(above, y - top).max(within(below, bottom - y))
        };
        let (from, to) = (inset(radii[0], radii[2]), inset(radii[1], radii[3]));
        (top..=bottom)
            .contains(&y)
            .then_some((left + from, right - to))
    })
}

/// The fill is red and the border green.
fn check(rounded_rect: RoundedRect) {
    const SIDE: usize = 72;
    let mut screen = Screen::new(SIDE as u32, SIDE as u32, Color32::BLACK);
    screen.paint(&[primitive(rounded_rect)]);
    let (outer, inner) = (
        coverage(&rounded_rect, 0.0, SIDE),
        coverage(&rounded_rect, rounded_rect.border, SIDE),
    );
    for (i, (outer, inner)) in outer.into_iter().zip(inner).enumerate() {
        let [r, g, b] = screen.rgb(i % SIDE, i / SIDE).map(f64::from);
        for (found, exact) in [(r, inner), (g, outer - inner), (b, 0.0)] {
            let off = found - 255.0 * exact;
            // A thirty-second of the pixel, and the rounding of the colour.
            assert!(
                off.abs() <= 255.0 / 32.0 + 1.0,
                "{rounded_rect:?} at {}, {}: {found}, exact {}",
                i % SIDE,
                i / SIDE,
                255.0 * exact
            );
        }
    }
}

fn rounded_rect(rect: [f32; 4], radii: [f32; 4], border: f32) -> RoundedRect {
    let [x0, y0, x1, y1] = rect;
    RoundedRect {
        rect: Rect::from_min_max(pos2(x0, y0), pos2(x1, y1)),
        radii,
        fill: Color32::RED,
        border,
        border_color: Color32::GREEN,
    }
}

#[test]
fn rounded_rects_cover_what_they_cover() {
    let mut random = Random(41);
    for round in 0..400 {
        let low = [random.between(1.0, 30.0), random.between(1.0, 30.0)];
        let mut size = [random.between(6.0, 40.0), random.between(6.0, 40.0)];
        if round % 4 == 0 {
            size[1] = size[0];
        }
        let most = 0.5 * size[0].min(size[1]);
        let radii = [0, 1, 2, 3].map(|corner| match (round % 4, corner) {
            // A circle.
            (0, _) => most,
            (1, 1 | 2) => 0.0,
            _ => random.between(0.0, most),
        });
        let border = [0.0, 1.0, random.between(0.0, 2.5)][round % 3];
        let rect = [low[0], low[1], low[0] + size[0], low[1] + size[1]];
        check(rounded_rect(rect, radii, border));
        check(rounded_rect(rect.map(f32::round), radii, border));
    }
}

/// A rounded rectangle hides what is below it where it is whole, and only there.
#[test]
fn what_hides_all_below_does_so_only_within() {
    let mut random = Random(42);
    for _ in 0..200 {
        let mut at = || random.between(-30.0, 200.0).round();
        let (x, y) = ([at(), at()], [at(), at()]);
        let rect = [
            x[0].min(x[1]),
            y[0].min(y[1]),
            x[0].max(x[1]),
            y[0].max(y[1]),
        ];
        let most = 0.5 * (rect[2] - rect[0]).min(rect[3] - rect[1]);
        let radii = [0, 1, 2, 3].map(|_| random.between(-20.0, 40.0).clamp(0.0, most));
        let border = random.between(-1.0, 2.0).max(0.0);
        let mut pixels = [255, 254].map(|alpha| {
            let mut rounded_rect = rounded_rect(rect, radii, border);
            // All but opaque, it hides no tile.
            rounded_rect.fill = Color32::from_rgba_premultiplied(alpha, 0, 0, alpha);
            let mut screen = Screen::new(170, 140, Color32::BLACK);
            let below = self::rounded_rect([-9.0, -9.0, 300.0, 300.0], [0.0; 4], 0.0);
            let blue = RoundedRect {
                fill: Color32::BLUE,
                ..below
            };
            screen.paint(&[primitive(blue), primitive(rounded_rect)]);
            screen.pixels.into_iter()
        });
        for at in 0..170 * 140 {
            let [a, b] = [0, 1].map(|i| pixels[i].next().expect("a pixel").to_be_bytes());
            let near = a.iter().zip(b).all(|(&a, b)| a.abs_diff(b) <= 2);
            assert!(near, "{rect:?} {radii:?} {border}, pixel {at}: {a:?} {b:?}");
        }
    }
}

fn triangles(shapes: Vec<ClippedShape>, scale: f32) -> Vec<ClippedPrimitive> {
    let options = TessellationOptions::default();
    Tessellator::new(scale, options, [64, 32], Vec::new()).tessellate_shapes(shapes)
}

fn shape(shape: impl Into<Shape>) -> ClippedShape {
    ClippedShape::new(Rect::EVERYTHING, shape.into())
}

/// Whether all of the shapes are exchanged.
fn exchanged(shapes: &[ClippedShape], scale: f32) -> Option<Vec<ClippedShape>> {
    let mut rounded_rects = shapes.to_vec();
    replace_shapes(&mut rounded_rects, scale);
    let all = |shape: &ClippedShape| matches!(shape.shape, Shape::Callback(_));
    rounded_rects.iter().all(all).then_some(rounded_rects)
}

fn painted(primitives: &[ClippedPrimitive], scale: f32) -> Screen {
    let mut screen = Screen::new(120, 120, Color32::from_rgb(30, 40, 50));
    screen.scale = scale;
    screen.paint(primitives);
    screen
}

/// What egui makes of the same shapes is softer at its rims; otherwise it is the same.
#[test]
fn rounded_rects_are_where_egui_shows_the_shapes() {
    let mut random = Random(43);
    for round in 0..300 {
        let scale = [1.0, 1.25, 1.5, 2.0][round % 4];
        let low = pos2(random.between(3.0, 15.0), random.between(3.0, 15.0));
        let rect = Rect::from_min_size(
            low,
            vec2(random.between(8.0, 40.0), random.between(8.0, 40.0)),
        );
        let stroke = match random.below(3) {
            0 => Stroke::NONE,
            1 => Stroke::new(1.0, Color32::WHITE),
            _ => Stroke::new(2.0, Color32::from_rgb(200, 60, 0)),
        };
        let fill = match random.below(4) {
            0 if !stroke.is_empty() => Color32::TRANSPARENT,
            1 => Color32::from_rgba_premultiplied(60, 90, 20, 128),
            _ => Color32::from_rgb(220, 180, 60),
        };
        let kind = [StrokeKind::Inside, StrokeKind::Middle, StrokeKind::Outside];
        let radius = CornerRadius::same([0, 2, 3, 4][random.below(4)]);
        let one = if random.below(4) == 0 {
            shape(CircleShape {
                center: rect.center(),
                radius: 0.5 * rect.size().min_elem(),
                fill,
                stroke,
            })
        } else {
            shape(RectShape::new(
                rect,
                radius,
                fill,
                stroke,
                kind[random.below(3)],
            ))
        };
        let rounded_rects = exchanged(std::slice::from_ref(&one), scale).expect("a rounded_rect");
        let [theirs, ours] = [vec![one.clone()], rounded_rects]
            .map(|shapes| painted(&triangles(shapes, scale), scale));
        let mut sum = 0.0;
        for (their, our) in theirs.pixels.iter().zip(&ours.pixels) {
            let (their, our) = (their.to_be_bytes(), our.to_be_bytes());
            let off = their.iter().zip(our).map(|(&a, b)| a.abs_diff(b));
            sum += f64::from(off.max().unwrap_or(0));
        }
        // For each pixel of the rim. egui's circles have corners.
        let rim = f64::from(rect.size().x + rect.size().y) * 2.0 * f64::from(scale);
        let mean = sum / rim;
        let square =
            matches!(&one.shape, Shape::Rect(rect) if rect.corner_radius == CornerRadius::ZERO);
        let bound = if square { 3.0 } else { 60.0 };
        assert!(mean <= bound, "{mean} at {scale}: {:?}", one.shape);
    }
}

/// Lines are where egui shows them: upright and level ones on whole pixels, others to
/// within the ends, which are round here.
#[test]
fn lines_are_where_egui_shows_them() {
    let mut random = Random(44);
    for round in 0..400 {
        let scale = [1.0, 1.25, 1.5, 2.0][round % 4];
        let mut place = || pos2(random.between(3.0, 55.0), random.between(3.0, 55.0));
        let (a, mut b) = (place(), place());
        let stroke = Stroke::new([1.0, 1.5, 2.0][round % 3], Color32::WHITE);
        let upright = round % 5;
        match upright {
            0 => b.x = a.x,
            1 => b.y = a.y,
            _ => {}
        }
        let one = if upright == 2 {
            let middle = a.lerp(b, 0.4);
            shape(Shape::line(vec![a, middle, b], stroke))
        } else {
            shape(Shape::line_segment([a, b], stroke))
        };
        let ours = exchanged(std::slice::from_ref(&one), scale).expect("a line");
        let [theirs, ours] =
            [vec![one.clone()], ours].map(|shapes| painted(&triangles(shapes, scale), scale));
        let pairs = theirs.pixels.iter().zip(&ours.pixels);
        let off = |(a, b): (&u32, &u32)| f64::from((a & 255).abs_diff(b & 255));
        let sum: f64 = pairs.map(off).sum();
        let length = f64::from(a.distance(b) * scale) + 1.0;
        // All of it in another place were 410 for each pixel of its area.
        let width = f64::from(stroke.width * scale);
        let ends = 205.0 * width * width;
        assert!(
            sum <= 10.0 * length + ends,
            "{sum} of {length} at {scale}: {:?}",
            one.shape
        );
    }
}

#[test]
fn what_egui_shows_in_another_way_stays() {
    let rect = Rect::from_min_size(pos2(5.0, 5.0), vec2(30.0, 20.0));
    let plain = RectShape::filled(rect, 3.0, Color32::RED);
    assert!(exchanged(&[shape(plain.clone())], 1.0).is_some());
    let image = plain.clone().with_texture(TextureId::default(), rect);
    let shadow = plain.clone().with_blur_width(4.0);
    let turned = plain.clone().with_angle(PI / 5.0);
    let mut thin = plain.clone();
    thin.rect.max.y = thin.rect.min.y + 1.5;
    let mut filled_by_stroke = plain.clone();
    (filled_by_stroke.stroke, filled_by_stroke.rect.max.y) = (Stroke::new(3.0, Color32::RED), 10.0);
    filled_by_stroke.stroke_kind = StrokeKind::Inside;
    let mut nothing = plain.clone();
    nothing.fill = Color32::TRANSPARENT;
    let mut endless = plain.clone();
    endless.rect = Rect::EVERYTHING;
    for stays in [
        image,
        shadow,
        turned,
        thin,
        filled_by_stroke,
        nothing,
        endless,
    ] {
        assert!(
            exchanged(&[shape(stays.clone())], 1.0).is_none(),
            "{stays:?}"
        );
    }
    let mut moved = shape(plain.clone());
    moved.transform_after_tessellation = TSTransform::from_translation(vec2(3.0, 0.0));
    assert!(exchanged(&[moved], 1.0).is_none());
    // In a row of shapes each by itself.
    let row = Shape::Vec(vec![plain.into(), Shape::Noop]);
    let mut row = vec![shape(row)];
    replace_shapes(&mut row, 1.0);
    let Shape::Vec(row) = &row[0].shape else {
        panic!("a row");
    };
    assert!(matches!(row[..], [Shape::Callback(_), Shape::Noop]));
}
