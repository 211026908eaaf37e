//! Tests of [`super`]: what a drag makes of a motion of the pointer.

use proptest::prelude::*;
use vides_engine::path::{Orientation, UpPath};

use super::super::projection::tests::{in_cube, view, viewport};
use super::*;

fn document(positions: &[DVec3], target: Target) -> Document {
    let mut document = Document::new();
    for (at, &position) in positions.iter().enumerate() {
        if at >= 2 {
            document.apply(Edit::InsertPoint { at, position }).unwrap();
        } else {
            document
                .apply(Edit::set(At::Point(at), "position", position))
                .unwrap();
        }
    }
    document.select(0, 0).unwrap();
    let orientation = Orientation {
        target,
        ..Orientation::default()
    };
    let edit = Edit::SetOrientation {
        point: 0,
        at: 0,
        orientation,
    };
    document.apply(edit).unwrap();
    document
}

fn motion(freedom: DragConstraint, snaps: bool, pointer: DVec2) -> Motion {
    Motion {
        freedom,
        snaps,
        pointer,
        typed: None,
        joint: Joint::Smooth,
    }
}

fn pointer() -> impl Strategy<Value = DVec2> {
    (200.0..1200.0f64, 50.0..700.0f64).prop_map(|(x, y)| DVec2::new(x, y))
}

/// From the front, the right, above, and tilted where x or y is seen edge-on.
fn along_an_axis() -> impl Strategy<Value = crate::setup::View> {
    let turns = prop_oneof![Just(0.0), Just(90.0), Just(-90.0), Just(180.0), Just(37.0)];
    let tilts = prop_oneof![Just(0.0), Just(90.0), Just(-90.0), Just(20.0)];
    (turns, tilts).prop_map(|(rotation, tilt)| crate::setup::View {
        rotation,
        tilt,
        ..Default::default()
    })
}

/// Where clamping leads, coordinate by coordinate.
fn clamped(projection: &Projection, from: DVec3, fixed: Axis, pointer: DVec2) -> (DVec3, bool) {
    let free = projection.point_in_plane(from, fixed, pointer).unwrap();
    let mut kept = free;
    for axis in fixed.others() {
        kept[axis.index()] = kept[axis.index()].clamp(-1.0, 1.0);
    }
    (kept, kept == free)
}

fn outcome(document: &Document, projection: &Projection, held: Handle, motion: &Motion) -> Outcome {
    super::outcome(document, projection, held, motion, cube(projection))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn a_point_follows_the_pointer(
        view in view(), from in in_cube(), axis in 0..3usize, pointer in pointer(),
    ) {
        let projection = Projection::new(&view, viewport());
        let wanted = Axis::ALL[axis];
        let freedom = DragConstraint::keeping(&projection, wanted);
        // Seen edge-on, it goes along a line: see the next one.
        prop_assume!(freedom.along.is_none());
        let axis = freedom.fixed.index();
        let mut document = document(&[from, -from], Target::Relative(DVec3::X));
        match outcome(&document, &projection, Handle::Point(0), &motion(freedom, false, pointer)) {
            Outcome::Edit(edit) => {
                document.apply(edit).unwrap();
                let moved = document.path().points[0].position;
                prop_assert_eq!(moved[axis].to_bits(), from[axis].to_bits());
                prop_assert!(moved.abs().max_element() <= 1.0);
                let (expected, inside) =
                    clamped(&projection, from, freedom.fixed, pointer);
                prop_assert_eq!(moved, expected);
                if inside {
                    prop_assert!((projection.image(moved) - pointer).length() < 1e-6);
                }
            }
            other => prop_assert!(false, "{other:?}"),
        }
        // The button's own plane wherever that can be seen.
        let good = projection.share_seen(wanted) >= EDGE_ON;
        prop_assert_eq!(freedom.fixed == wanted, good);
        prop_assert!(projection.share_seen(freedom.fixed) >= EDGE_ON);
    }

    #[test]
    fn a_key_keeps_its_coordinate_in_every_view(
        view in prop_oneof![view(), along_an_axis()],
        from in in_cube(), axis in 0..3usize, pointer in pointer(),
    ) {
        let projection = Projection::new(&view, viewport());
        let kept = Axis::ALL[axis];
        let freedom = DragConstraint::keeping(&projection, kept);
        let mut document = document(&[from, -from], Target::Relative(DVec3::X));
        let Outcome::Edit(edit) =
            outcome(&document, &projection, Handle::Point(0), &motion(freedom, false, pointer))
        else {
            return Err(TestCaseError::fail("refused"));
        };
        document.apply(edit).unwrap();
        let moved = document.path().points[0].position;
        prop_assert_eq!(moved[axis].to_bits(), from[axis].to_bits());
        prop_assert_eq!(freedom.along.is_some(), projection.share_seen(kept) < EDGE_ON);
        if let Some(along) = freedom.along {
            // One coordinate moves, and no place on its line is nearer to the pointer.
            let [a, b, c] = Axis::ALL.map(|axis| moved[axis.index()] == from[axis.index()]);
            prop_assert!(u8::from(a) + u8::from(b) + u8::from(c) >= 2);
            let at = along.index();
            if moved[at].abs() < 1.0 {
                let away = |by: f64| {
                    let mut place = moved;
                    place[at] += by;
                    projection.image(place).distance(pointer)
                };
                prop_assert!(away(0.0) <= away(1e-3) && away(0.0) <= away(-1e-3));
            }
        }
    }

    #[test]
    fn what_snaps_lies_on_the_grid(
        view in view(), from in in_cube(), axis in 0..3usize, pointer in pointer(),
    ) {
        let projection = Projection::new(&view, viewport());
        let freedom = DragConstraint::keeping(&projection, Axis::ALL[axis]);
        prop_assume!(freedom.along.is_none());
        let mut document = document(&[from, -from], Target::Relative(DVec3::X));
        let held = Handle::Point(0);
        let Outcome::Edit(edit) =
            outcome(&document, &projection, held, &motion(freedom, true, pointer)) else { return Ok(()) };
        document.apply(edit).unwrap();
        let moved = document.path().points[0].position;
        let (free, _) = clamped(&projection, from, freedom.fixed, pointer);
        for axis in freedom.fixed.others().map(Axis::index) {
            // Written as a person would: 0.15, not 0.15000000000000002.
            let text = format!("{:.2}", moved[axis]);
            prop_assert_eq!(moved[axis], text.parse::<f64>().unwrap());
            let fives = (moved[axis] * 100.0).round() / 5.0;
            prop_assert_eq!(fives, fives.round());
            prop_assert!((moved[axis] - free[axis]).abs() <= 0.025 + 1e-12);
        }
    }

    #[test]
    fn a_target_follows_the_pointer(
        view in view(), at in in_cube(), target in in_cube(), axis in 0..3usize,
        absolute: bool, pointer in pointer(),
    ) {
        let projection = Projection::new(&view, viewport());
        let freedom = DragConstraint::keeping(&projection, Axis::ALL[axis]);
        prop_assume!(freedom.along.is_none());
        let (fixed, axis) = (freedom.fixed, freedom.fixed.index());
        let target = if absolute { Target::Absolute(target) } else { Target::Relative(target) };
        let mut document = document(&[at, -at], target);
        let Outcome::Edit(edit) =
            outcome(&document, &projection, Handle::Vpn, &motion(freedom, false, pointer))
        else { return Ok(()) };
        document.apply(edit).unwrap();
        let moved = document.path().points[0].orientations[0].target;
        let (from, to) = match (target, moved) {
            (Target::Absolute(a), Target::Absolute(b))
            | (Target::Relative(a), Target::Relative(b)) => (a, b),
            _ => panic!("it stays what it is"),
        };
        prop_assert_eq!(from[axis].to_bits(), to[axis].to_bits());
        let tip = tip_of(moved, at);
        let (expected, inside) = clamped(&projection, tip_of(target, at), fixed, pointer);
        prop_assert!((tip - expected).length() < 1e-12);
        if inside {
            prop_assert!((projection.image(tip) - pointer).length() < 1e-6);
        }
    }

    #[test]
    fn vup_points_to_the_pointer(
        view in view(), at in in_cube(), target in in_cube(), pointer in pointer(),
    ) {
        let projection = Projection::new(&view, viewport());
        let mut document = document(&[at, -at], Target::Relative(target));
        let direction = orientation::unit(target);
        let freedom = DragConstraint::keeping(&projection, Axis::X);
        match outcome(&document, &projection, Handle::Vup, &motion(freedom, false, pointer)) {
            Outcome::Edit(edit) => {
                document.apply(edit).unwrap();
                let roll = document.path().points[0].orientations[0].roll;
                let up = orientation::up_from_roll(direction, roll.to_radians());
                let image = projection.image_of_way(up);
                let wanted = pointer - projection.image(at);
                let angle = image.perp_dot(wanted).atan2(image.dot(wanted)).to_degrees();
                prop_assert!(angle.abs() < 0.1);
                prop_assert!(angle.abs() < 1e-6);
                prop_assert!(roll > -180.0 && roll <= 180.0);
            }
            other => {
                prop_assert_eq!(other, Outcome::CircleEdgeOn);
                prop_assert!(direction.dot(projection.toward()).abs() < EDGE_ON);
            }
        }
    }
}

#[test]
fn the_thesiss_bisection_finds_the_same_roll() {
    let projection = Projection::new(&crate::setup::View::default(), viewport());
    let view = orientation::unit(DVec3::new(0.3, -0.2, -0.8));
    let image =
        |roll: f64| projection.image_of_way(orientation::up_from_roll(view, roll.to_radians()));
    for step in 0..360 {
        let way = DVec2::from_angle(f64::from(step).to_radians()) * 80.0;
        // 6.2.3: which half, then halve. The images go round one way.
        let turn = image(0.0).perp_dot(image(90.0)).signum();
        let side = |roll: f64| image(roll).perp_dot(way) * turn >= 0.0;
        let (mut low, mut high) = if side(0.0) {
            (0.0, 180.0)
        } else {
            (180.0, 360.0)
        };
        for _ in 0..40 {
            let middle = (low + high) / 2.0;
            if side(middle) {
                low = middle;
            } else {
                high = middle;
            }
        }
        let axes = projection.space().up.level_axes(view);
        let found = roll_towards(&projection, axes, way).unwrap();
        let difference = orientation::wrap_degrees(found - low);
        assert!(difference.abs() < 1e-6, "{found} and {low}");
    }
}

#[test]
fn at_the_centre_of_the_circle_nothing_turns() {
    let projection = Projection::new(&crate::setup::View::default(), viewport());
    let view = orientation::unit(DVec3::new(0.3, -0.2, -0.8));
    let axes = projection.space().up.level_axes(view);
    assert_eq!(roll_towards(&projection, axes, DVec2::ZERO), None);
}

/// The camera of the film has its up where the pointer is, whatever its up is.
#[test]
fn every_up_is_turned_to_the_pointer() {
    let projection = Projection::new(&crate::setup::View::default(), viewport());
    let positions = [
        DVec3::new(-0.6, 0.1, 0.7),
        DVec3::new(0.5, 0.4, 0.2),
        DVec3::new(0.1, -0.3, -0.6),
    ];
    let place = DVec3::new(0.3, 0.9, -0.4);
    let up_path = UpPath::of(Document::new().path()).unwrap();
    let ups = [
        UpVector::Point(place),
        UpVector::Minimal,
        UpVector::Path(up_path),
        UpVector::Frenet,
    ];
    for up in ups {
        let mut document = document(&positions, Target::Relative(DVec3::NEG_Z));
        let cubic = Edit::set(At::Path, "curve", vides_engine::path::CurveKind::Cubic);
        document.apply(cubic).unwrap();
        for (point, ahead) in [(0, None), (1, Some(0.0)), (2, None)] {
            let orientation = Orientation {
                target: Target::Relative(DVec3::new(0.5, -0.3, -0.8)),
                roll: 35.0,
                ..Orientation::default()
            };
            let own = orientation.own.with(|own| {
                own.up = up.clone();
                own.ahead = ahead;
            });
            let orientation = Orientation {
                own: own.unwrap(),
                ..orientation
            };
            let at = 0;
            let edit = Edit::SetOrientation {
                point,
                at,
                orientation,
            };
            document.apply(edit).unwrap();
        }
        for point in 0..3 {
            document.select(point, 0).unwrap();
            let foot = projection.image(document.path().points[point].position);
            for step in 0..12 {
                let way = DVec2::from_angle(f64::from(30 * step).to_radians()) * 80.0;
                let freedom = DragConstraint::keeping(&projection, Axis::X);
                let held = Handle::Vup;
                let Outcome::Edit(edit) = outcome(
                    &document,
                    &projection,
                    held,
                    &motion(freedom, false, foot + way),
                ) else {
                    panic!("{up:?} {point}");
                };
                document.apply(edit).unwrap();
                let frame = document
                    .timeline(|timeline| {
                        let from = timeline.section_from(point, 0);
                        from.map(|section| {
                            (0..section)
                                .map(|k| timeline.section(k).frames)
                                .sum::<usize>()
                        })
                    })
                    .unwrap();
                let sampler = document.sampler().unwrap();
                let frame = frame.map_or(sampler.frame_count(), |before| before + 1);
                let pose = sampler.pose(frame as f64).unwrap();
                let image = projection.image_of_way(DVec3::from_array(pose.vup));
                let turn = image.normalize().perp_dot(way.normalize());
                assert!(
                    turn.abs() < 1e-6 && image.dot(way) > 0.0,
                    "{up:?} {point} {turn}"
                );
            }
        }
    }
}

#[test]
fn what_is_gone_is_not_moved() {
    let document = document(&[DVec3::X, DVec3::Y], Target::Relative(DVec3::X));
    let projection = Projection::new(&crate::setup::View::default(), viewport());
    let held = Handle::Point(7);
    let freedom = DragConstraint::keeping(&projection, Axis::X);
    let found = outcome(
        &document,
        &projection,
        held,
        &motion(freedom, false, DVec2::ZERO),
    );
    assert_eq!(found, Outcome::Nothing);
}
