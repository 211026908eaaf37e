//! Lines: how much of each pixel is covered.

use std::sync::Arc;

use egui::{ClippedPrimitive, Color32, Pos2, Rect, Shape, pos2, vec2};

use super::{Random, Screen, covered, everywhere};
use crate::{Line, Lines};

pub(super) fn primitive(lines: &Arc<Lines>) -> ClippedPrimitive {
    let Shape::Callback(callback) = Lines::shape(lines, Rect::EVERYTHING) else {
        unreachable!("lines are a callback");
    };
    everywhere(egui::epaint::Primitive::Callback(callback))
}

fn one(line: Line) -> ClippedPrimitive {
    primitive(&Arc::new(Lines { lines: vec![line] }))
}

/// How much of each pixel of a square lies within half a width of a piece.
fn coverage(line: Line, side: usize) -> Vec<f64> {
    let [x0, y0, x1, y1] = [line.from.x, line.from.y, line.to.x, line.to.y].map(f64::from);
    let radius = f64::from(line.width).max(1.0) / 2.0;
    let length = (x1 - x0).hypot(y1 - y0);
    covered(side, |y| {
        let mut ends = Vec::new();
        for (cx, cy) in [(x0, y0), (x1, y1)] {
            let square = radius * radius - (y - cy) * (y - cy);
            if square > 0.0 {
                ends.extend([cx - square.sqrt(), cx + square.sqrt()]);
            }
        }
        if length > 0.0 {
            let (nx, ny) = ((y0 - y1) / length * radius, (x1 - x0) / length * radius);
            let corners = [
                (x0 + nx, y0 + ny),
                (x1 + nx, y1 + ny),
                (x1 - nx, y1 - ny),
                (x0 - nx, y0 - ny),
            ];
            for i in 0..4 {
                let ((ax, ay), (bx, by)) = (corners[i], corners[(i + 1) % 4]);
                if (ay < y) != (by < y) {
                    ends.push(ax + (bx - ax) * (y - ay) / (by - ay));
                }
            }
        }
        let from = ends.iter().copied().fold(f64::MAX, f64::min);
        let to = ends.iter().copied().fold(f64::MIN, f64::max);
        Some((from, to))
    })
}

fn check(line: Line) {
    const SIDE: usize = 48;
    let mut screen = Screen::new(SIDE as u32, SIDE as u32, Color32::BLACK);
    screen.paint(&[one(line)]);
    let exact = coverage(line, SIDE);
    for (i, exact) in exact.iter().enumerate() {
        let found = f64::from(screen.rgb(i % SIDE, i / SIDE)[1]);
        let paler = f64::from(line.width).min(1.0);
        let off = found - 255.0 * exact * paler;
        // A sixty-fourth of the pixel, and the rounding of the colour.
        assert!(
            off.abs() <= 255.0 / 64.0 + 1.0,
            "{line:?} at {}, {}: {found}, exact {}",
            i % SIDE,
            i / SIDE,
            255.0 * exact * paler
        );
    }
}

fn white(from: [f32; 2], to: [f32; 2], width: f32) -> Line {
    Line {
        from: from.into(),
        to: to.into(),
        width,
        color: Color32::WHITE,
    }
}

#[test]
fn lines_cover_what_they_cover() {
    let mut random = Random(1);
    for _ in 0..400 {
        let from = [random.between(5.0, 43.0), random.between(5.0, 43.0)];
        let (angle, length) = (random.between(0.0, 6.3), random.between(0.0, 30.0));
        let to = pos2(from[0], from[1]) + length * vec2(angle.cos(), angle.sin());
        let width = random.between(0.3, 6.0);
        check(white(from, to.into(), width));
    }
}

/// How much of each pixel of a square lies within half a width of one of some
/// pieces, by many samples.
fn coverage_of_all(lines: &[Line], side: usize) -> Vec<f64> {
    const SAMPLES: usize = 12;
    let radius = lines[0].width / 2.0;
    let covered = |at: Pos2| {
        lines.iter().any(|line| {
            let way = line.to - line.from;
            let part = (at - line.from).dot(way) / way.length_sq().max(1e-12);
            at.distance(line.from + way * part.clamp(0.0, 1.0)) <= radius
        })
    };
    let pixel = |i: usize| {
        let samples = (0..SAMPLES * SAMPLES).map(|k| {
            let part = |k: usize| (k as f32 + 0.5) / SAMPLES as f32;
            pos2(
                (i % side) as f32 + part(k % SAMPLES),
                (i / side) as f32 + part(k / SAMPLES),
            )
        });
        samples.filter(|&at| covered(at)).count() as f64 / (SAMPLES * SAMPLES) as f64
    };
    (0..side * side).map(pixel).collect()
}

/// The pieces of a curve are one line, without thick spots where they meet.
#[test]
fn pieces_of_a_curve_are_one() {
    const SIDE: usize = 48;
    let mut random = Random(3);
    let mut sums = (0.0, 0.0);
    for round in 0..40 {
        let radius = random.between(30.0, 300.0);
        let start = random.between(0.0, 6.3);
        let turn = if round % 2 == 0 { 1.0 } else { -1.0 };
        // As far as they may stray from the arc, a quarter of a pixel.
        let step = (8.0 * 0.25 / radius).sqrt() * turn;
        let middle = pos2(24.0, 24.0) - radius * vec2(start.cos(), start.sin());
        let at = |i: f32| {
            let angle = start + step * i;
            middle + radius * vec2(angle.cos(), angle.sin())
        };
        let width = random.between(1.0, 3.0);
        let piece = |i: i16| {
            white(
                at(f32::from(i)).into(),
                at(f32::from(i) + 1.0).into(),
                width,
            )
        };
        let lines: Vec<Line> = (-1..2).map(piece).collect();
        let exact = coverage_of_all(&lines, SIDE);
        let off = |primitives: &[ClippedPrimitive]| {
            let mut screen = Screen::new(SIDE as u32, SIDE as u32, Color32::BLACK);
            screen.paint(primitives);
            let offs = exact.iter().enumerate().map(|(i, exact)| {
                let found = f64::from(screen.rgb(i % SIDE, i / SIDE)[1]);
                (found / 255.0 - exact).abs()
            });
            offs.collect::<Vec<f64>>()
        };
        let joined = off(&[primitive(&Arc::new(Lines {
            lines: lines.clone(),
        }))]);
        let apart: Vec<_> = lines.iter().map(|&line| one(line)).collect();
        let apart = off(&apart);
        let most = |offs: &[f64]| offs.iter().copied().fold(0.0, f64::max);
        let sum = |offs: &[f64]| offs.iter().sum::<f64>();
        // A border is off by no more than the bend of a joint.
        let bound = most(&apart).max(0.2);
        assert!(most(&joined) <= bound, "round {round}: {}", most(&joined));
        assert!(sum(&joined) <= sum(&apart), "round {round}");
        sums = (sums.0 + sum(&joined), sums.1 + sum(&apart));
    }
    // About the diagonal, where the axis changes, pieces stay apart.
    assert!(sums.0 < 0.7 * sums.1, "{sums:?}");
}

#[test]
fn upright_flat_and_diagonal_lines_and_dots() {
    for shift in [0.0, 0.25, 0.5, 0.9] {
        for width in [0.5, 1.0, 1.5, 2.0, 7.0] {
            let a = 20.0 + shift;
            for to in [
                [50.0, a],
                [a, 50.0],
                [a + 30.0, a + 30.0],
                [a, a],
                [50.0, 21.0],
            ] {
                check(white([a, a], to, width));
                check(white(to, [a, a], width));
            }
        }
    }
}

#[test]
fn a_line_is_the_same_from_either_end() {
    let mut random = Random(2);
    for _ in 0..100 {
        let mut point = || [random.between(-40.0, 120.0), random.between(-40.0, 120.0)];
        let (a, b) = (point(), point());
        let pixels = |from, to| {
            let mut screen = Screen::new(80, 80, Color32::BLACK);
            screen.paint(&[one(white(from, to, 1.5))]);
            screen.pixels
        };
        assert_eq!(pixels(a, b), pixels(b, a));
    }
}

/// A line that begins and ends far away passes where it should.
#[test]
fn long_lines_stay_straight() {
    for reach in [1e4, 1e6, 1e7] {
        for slope in [0.0, 0.3, 1.0, -0.7] {
            let mut screen = Screen::new(80, 80, Color32::BLACK);
            let far = white(
                [40.5 - reach, 40.5 - slope * reach],
                [40.5 + reach, 40.5 + slope * reach],
                3.0,
            );
            screen.paint(&[one(far)]);
            assert_eq!(screen.rgb(40, 40), [255; 3], "{reach} {slope}");
            assert_eq!(screen.rgb(10, (40.0 - 30.0 * slope) as usize), [255; 3]);
            assert_eq!(screen.rgb(70, (40.0 + 30.0 * slope) as usize), [255; 3]);
            assert_eq!(screen.rgb(60, (40.0 + 20.0 * slope) as usize - 8), [0; 3]);
        }
    }
}

#[test]
fn the_clip_cuts_and_the_scale_scales() {
    let mut screen = Screen::new(60, 60, Color32::BLACK);
    screen.scale = 2.0;
    let lines = Arc::new(Lines {
        lines: vec![white([0.0, 10.0], [30.0, 10.0], 2.0)],
    });
    let clip = Rect::from_min_max(pos2(5.0, 0.0), pos2(10.0, 30.0));
    let Shape::Callback(callback) = Lines::shape(&lines, clip) else {
        unreachable!("lines are a callback");
    };
    let mut primitive = everywhere(egui::epaint::Primitive::Callback(callback));
    primitive.clip_rect = Rect::from_min_max(pos2(0.0, 0.0), pos2(30.0, 10.0));
    screen.paint(&[primitive]);
    for y in 0..60 {
        for x in 0..60 {
            let inside = (10..20).contains(&x) && (18..20).contains(&y);
            assert_eq!(
                screen.rgb(x, y),
                [if inside { 255 } else { 0 }; 3],
                "{x} {y}"
            );
        }
    }
}
