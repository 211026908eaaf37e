//! Tests of [`super`].

use egui::{pos2, vec2};
use proptest::prelude::*;
use vides_document::{At, Edit};
use vides_engine::path::SupportPoint;
use vides_engine::path::camera_path::DEFAULT_PRESETS;

use super::super::projection::tests::{view, viewport};
use super::*;
use crate::setup::View;

pub(in crate::space) struct Eye {
    pub(in crate::space) projection: Projection,
    colours: Colours,
    shown: Shown,
}

impl Eye {
    pub(in crate::space) fn new(view: &View) -> Self {
        Self {
            projection: Projection::new(view, viewport()),
            colours: Colours::DARK,
            shown: Shown::default(),
        }
    }

    pub(in crate::space) fn look(&self) -> Look<'_> {
        Look {
            sight: None,
            projection: &self.projection,
            viewport: viewport(),
            pixels_per_point: 1.0,
            colours: &self.colours,
            shown: &self.shown,
            pane: None,
        }
    }
}

pub(in crate::space) fn document(count: usize) -> Document {
    let points = (0..count)
        .map(|i| {
            let turn = i as f64 * 0.37;
            SupportPoint::new(DVec3::new(turn.cos(), (turn * 0.71).sin(), turn.sin()) * 0.9)
        })
        .collect();
    let path = CameraPath {
        points,
        ..CameraPath::default()
    };
    Document::from_parts(path, vides_document::Info::default()).unwrap()
}

pub(in crate::space) fn edit(count: usize) -> impl Strategy<Value = Edit> {
    let position = || prop::array::uniform3(-1.4..1.4f64).prop_map(DVec3::from_array);
    prop_oneof![
        4 => (0..count, position()).prop_map(|(at, position)| Edit::set(At::Point(at), "position", position)),
        1 => (0..count, -1.0..1.0f64).prop_map(|(at, t)| Edit::set(At::Point(at), "own", Tcb::new(t, 0.0, t))),
        1 => (0..count, 0..10usize).prop_map(|(at, preset)| Edit::set(At::Point(at), "preset", preset)),
        1 => (0..10usize, -1.0..1.0f64)
            .prop_map(|(preset, b)| {
                let mut presets = DEFAULT_PRESETS;
                presets[preset].bias = b;
                Edit::set(At::Path, "presets", presets)
            }),
        1 => (0..count, position()).prop_map(|(at, position)| Edit::InsertPoint { at, position }),
        1 => (0..count).prop_map(|at| Edit::RemovePoint { at }),
        1 => any::<bool>().prop_map(|value| Edit::set(At::Path, "closed", value)),
        1 => Just(Edit::AppendAfterLast),
        1 => (0..count, prop::option::of((position(), position()))).prop_map(|(at, own)| {
            let tangents = own.map(|(before, after)| Tangents { before, after });
            Edit::set(At::Point(at), "tangents", tangents)
        }),
        1 => (0..3usize).prop_map(|kind| {
            Edit::set(At::Path, "curve", CurveKind::ALL[kind])
        }),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// Whatever was done: the scene kept up to date is the scene made anew.
    #[test]
    fn what_is_kept_equals_what_is_made_anew(
        edits in prop::collection::vec((edit(150), 0..4u8), 1..30), views in prop::array::uniform3(view()),
    ) {
        let mut document = document(150);
        let mut eye = Eye::new(&views[0]);
        let mut kept = PathLines::default();
        for (edit, also) in edits {
            // Some cannot be done; that is no change then.
            let _ = document.apply(edit);
            match also {
                0 => { document.undo(); }
                1 => eye.projection = Projection::new(&views[1], viewport()),
                2 => eye.projection = Projection::new(&views[2], viewport()),
                _ => {}
            }
            kept.update(&document, &eye.look()).unwrap();
            let mut anew = PathLines::default();
            anew.update(&document, &eye.look()).unwrap();
            prop_assert_eq!(kept.all(), anew.all());
        }
    }

    /// The drawn curve against the true one, sampled densely.
    #[test]
    fn the_curve_is_drawn_to_half_a_pixel(
        view in view(), points in prop::collection::vec(
            prop::array::uniform3(-1.0..1.0f64).prop_map(DVec3::from_array), 2..5),
    ) {
        let path = CameraPath {
            points: points.iter().copied().map(SupportPoint::new).collect(),
            ..CameraPath::default()
        };
        let document = Document::from_parts(path, vides_document::Info::default()).unwrap();
        let mut eye = Eye::new(&view);
        // Cutting at the border is tested elsewhere.
        let wide = Rect::from_center_size(viewport().center(), vec2(1e5, 1e5));
        for element in [Element::Cube, Element::Crosses, Element::Outside] {
            eye.shown.set(element, false);
        }
        let mut scene = PathLines::default();
        scene.update(&document, &Look { viewport: wide, ..eye.look() }).unwrap();
        let lines = &scene.chunks[0].curve.lines;
        let away = |p: DVec2| lines.iter().map(|line| {
            let [a, b] = [line.from, line.to].map(super::super::projection::from_pos);
            let way = b - a;
            let t = ((p - a).dot(way) / way.length_squared().max(1e-12)).clamp(0.0, 1.0);
            p.distance(a + way * t)
        }).fold(f64::INFINITY, f64::min);
        for segment in 0..document.path().segment_count() {
            let curve = curve::segment(document.path(), segment);
            for step in 0..=50 {
                let p = eye.projection.image(curve.point(f64::from(step) / 50.0));
                // A little more for single precision.
                prop_assert!(away(p) <= TOLERANCE + MERGE + 2e-3);
            }
        }
    }
}

#[test]
fn a_moved_point_makes_only_what_lies_around_it() {
    for (count, size) in [(1000, 16), (5000, 64)] {
        moved_points_make_only_what_lies_around_them(count, size);
    }
}

fn moved_points_make_only_what_lies_around_them(count: usize, size: usize) {
    let mut document = document(count);
    let eye = Eye::new(&View::default());
    let mut scene = PathLines::default();
    scene.update(&document, &eye.look()).unwrap();
    assert_eq!(scene.made, count.div_ceil(size));
    scene.update(&document, &eye.look()).unwrap();
    assert_eq!(scene.made, 0);
    // In the middle of a chunk one, at the border of two both.
    let middle = size / 2;
    for (at, chunks) in [(middle, 1), (64, 2), (127, 2), (0, 1), (count - 1, 1)] {
        let position = DVec3::splat(0.3);
        document
            .apply(Edit::set(At::Point(at), "position", position))
            .unwrap();
        scene.update(&document, &eye.look()).unwrap();
        assert_eq!(scene.made, chunks, "point {at}");
    }
    // A change of the selection touches nothing.
    document.select(500, 0).unwrap();
    scene.update(&document, &eye.look()).unwrap();
    assert_eq!(scene.made, 0);
}

/// The lines of one colour, in the order in which they are painted.
fn of_colour(scene: &PathLines, color: Color32) -> usize {
    let lines = scene.all();
    lines
        .iter()
        .flatten()
        .filter(|line| line.color == color)
        .count()
}

#[test]
fn each_element_is_shown_in_its_own_colour_and_can_be_hidden() {
    let mut document = document(4);
    let outside = Edit::set(At::Point(1), "position", DVec3::new(1.3, 0.0, 0.0));
    document.apply(outside).unwrap();
    let object = vec![
        vides_document::ObjectPoint {
            position: DVec3::ZERO,
            draw: false,
        },
        vides_document::ObjectPoint {
            position: DVec3::Y,
            draw: true,
        },
    ];
    let info = vides_document::Info {
        object: object.into(),
        ..vides_document::Info::default()
    };
    document.apply(Edit::SetInfo(Box::new(info))).unwrap();
    let mut eye = Eye::new(&View::default());
    let elements = [
        Element::Cube,
        Element::Object,
        Element::Curve,
        Element::Crosses,
        Element::Outside,
    ];
    let mut scene = PathLines::default();
    for element in elements {
        let color = eye.colours.of(element);
        scene.update(&document, &eye.look()).unwrap();
        assert!(of_colour(&scene, color) > 0, "{element:?}");
        eye.shown.set(element, false);
        scene.update(&document, &eye.look()).unwrap();
        assert_eq!(of_colour(&scene, color), 0, "{element:?}");
        eye.shown.set(element, true);
    }
}

#[test]
fn what_leaves_the_cube_is_marked_and_nothing_else() {
    let mut document = document(2);
    for (at, x) in [(0, -1.5), (1, 1.5)] {
        let position = DVec3::new(x, 0.0, 0.0);
        document
            .apply(Edit::set(At::Point(at), "position", position))
            .unwrap();
    }
    let eye = Eye::new(&View::default());
    let mut scene = PathLines::default();
    scene.update(&document, &eye.look()).unwrap();
    let unit = eye.projection.image_of_way(DVec3::X);
    let middle = eye.projection.image(DVec3::ZERO);
    for line in &scene.chunks[0].curve.lines {
        for end in [line.from, line.to] {
            let way = super::super::projection::from_pos(end) - middle;
            let x = way.dot(unit) / unit.length_squared();
            let marked = line.color == eye.colours.of(Element::Outside);
            assert!(
                if marked {
                    x.abs() >= 0.999
                } else {
                    x.abs() <= 1.001
                },
                "{x}"
            );
        }
    }
}

#[test]
fn the_last_point_of_an_open_path_begins_no_segment() {
    let mut document = document(3);
    let eye = Eye::new(&View::default());
    let color = eye.colours.of(Element::Segment);
    let has_segment = |document: &Document| {
        let lines = current(document, &eye.look()).unwrap();
        lines.lines.iter().any(|line| line.color == color)
    };
    assert!(has_segment(&document));
    document.select(2, 0).unwrap();
    assert!(!has_segment(&document));
    document.apply(Edit::set(At::Path, "closed", true)).unwrap();
    assert!(has_segment(&document));
}

#[test]
fn points_far_outside_cost_little() {
    let mut document = document(2);
    for (at, x) in [(0, -1e9), (1, 1e9)] {
        let position = DVec3::new(x, 0.1, 0.2);
        document
            .apply(Edit::set(At::Point(at), "position", position))
            .unwrap();
    }
    document
        .apply(Edit::InsertPoint {
            at: 1,
            position: DVec3::new(0.0, 1e9, 1e9),
        })
        .unwrap();
    let near = View {
        size: View::MAX_SIZE,
        ..View::default()
    };
    let eye = Eye::new(&near);
    let mut scene = PathLines::default();
    scene.update(&document, &eye.look()).unwrap();
    assert!(scene.chunks[0].pieces.len() < 20_000);
    let viewport = viewport().expand(25.0);
    for line in scene.all().iter().flatten() {
        for end in [line.from, line.to] {
            assert!(viewport.contains(pos2(end.x, end.y)), "{end}");
        }
    }
}

/// The three edges that meet in the farthest corner are dashed, the other nine
/// are drawn through.
#[test]
fn hidden_edges_are_dashed_and_visible_ones_drawn_through() {
    for (rotation, tilt) in [(28.0, 20.0), (-60.0, -35.0), (100.0, 50.0)] {
        let eye = Eye::new(&View {
            rotation,
            tilt,
            ..View::default()
        });
        let color = eye.colours.of(Element::Cube);
        let [behind, before] = still(&Object::default(), &eye.look());
        let lines = [behind.lines, before.lines].concat();
        let length = |color: Color32| -> f64 {
            let drawn = lines.iter().filter(|line| line.color == color);
            drawn
                .map(|line| f64::from((line.to - line.from).length()))
                .sum()
        };
        let [mut through, mut dashed] = [0.0; 2];
        let far = -eye.projection.toward();
        for axis in 0..3 {
            for signs in [[-1.0, -1.0], [-1.0, 1.0], [1.0, -1.0], [1.0, 1.0]] {
                let [a, b] = [(axis + 1) % 3, (axis + 2) % 3];
                let mut ends = [DVec3::ZERO; 2];
                for (end, along) in ends.iter_mut().zip([-1.0, 1.0]) {
                    end[axis] = along;
                    end[a] = signs[0];
                    end[b] = signs[1];
                }
                let [from, to] = ends.map(|end| eye.projection.image(end));
                if far[a] * signs[0] > 0.0 && far[b] * signs[1] > 0.0 {
                    dashed += from.distance(to);
                } else {
                    through += from.distance(to);
                }
            }
        }
        let drawn = length(color);
        assert!((drawn / through - 1.0).abs() < 0.01, "{drawn} {through}");
        let drawn = length(color.gamma_multiply(0.7));
        assert!((0.3..0.8).contains(&(drawn / dashed)), "{drawn} {dashed}");
    }
}
