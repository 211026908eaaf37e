//! Shapes in pieces: the same picture, in more meshes.

use egui::epaint::{ClippedShape, TessellationOptions, Tessellator};
use egui::{ClippedPrimitive, Color32, Rect, Shape, pos2, vec2};

use super::{Random, Screen};
use crate::pieces::in_pieces;

/// Rounded rectangles, in rows that are cut alike.
fn at_random(count: usize) -> Vec<ClippedShape> {
    let mut random = Random(5);
    let clips = [0.0, 3.5, 20.0].map(|x| Rect::from_min_max(pos2(x, 2.0), pos2(90.0 - x, 70.5)));
    (0..count)
        .map(|at| {
            let place = pos2(random.between(-5.0, 90.0), random.between(-5.0, 70.0));
            let size = vec2(random.between(1.0, 30.0), random.between(1.0, 30.0));
            let rect = Rect::from_min_size(place, size);
            let shape = Shape::rect_filled(rect, 3.0, random.color());
            ClippedShape::new(clips[at / 40 % 3], shape)
        })
        .collect()
}

fn triangles(shapes: Vec<ClippedShape>, pixels_per_point: f32) -> Vec<ClippedPrimitive> {
    let options = TessellationOptions::default();
    Tessellator::new(pixels_per_point, options, [64, 32], Vec::new()).tessellate_shapes(shapes)
}

fn painted(primitives: &[ClippedPrimitive], pixels_per_point: f32) -> Vec<u32> {
    let mut screen = Screen::new(200, 160, Color32::BLACK);
    screen.scale = pixels_per_point;
    screen.paint(primitives);
    screen.pixels
}

/// Pieces of a row are told apart by where they are cut, and nobody sees it.
#[test]
fn pieces_are_small_and_show_the_same() {
    for pixels_per_point in [1.0, 1.25, 1.5, 2.0] {
        let whole = at_random(200);
        let mut pieces = whole.clone();
        in_pieces(&mut pieces);
        let [whole, pieces] = [whole, pieces].map(|shapes| triangles(shapes, pixels_per_point));
        assert_eq!(whole.len(), 5);
        // Of some pieces egui leaves out everything, since nothing is to be seen.
        assert!((45..=50).contains(&pieces.len()), "{}", pieces.len());
        let same = painted(&whole, pixels_per_point) == painted(&pieces, pixels_per_point);
        assert!(same, "at {pixels_per_point}");
    }
}

#[test]
fn clips_without_end_or_inside_do_no_harm() {
    in_pieces(&mut []);
    let circle = Shape::circle_filled(pos2(1.0, 1.0), 1.0, Color32::RED);
    for clip in [Rect::EVERYTHING, Rect::NOTHING] {
        let mut shapes = vec![ClippedShape::new(clip, circle.clone()); 20];
        in_pieces(&mut shapes);
    }
}
