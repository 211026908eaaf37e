//! More than there may be, fewer than there must be, of other lengths than
//! belong together: refused with one sentence, before it costs anything.

use glam::{DQuat, DVec3, dvec3};
use vides::document::{Document, Edit, Info, ObjectPoint};
use vides::error::ErrorKind;
use vides::limits;
use vides::path::arc_length::ArcLength;
use vides::path::catmull_rom::{self, EndRule};
use vides::path::cubic_spline::{CubicSpline, SplineEnds};
use vides::path::hermite::Cubic;
use vides::path::{CameraPath, CurveParameters, Orientation, SupportPoint, Tcb, quaternion_spline};

/// The sentence with which it was refused.
fn said<T>(result: Result<T, impl std::fmt::Display>) -> String {
    match result {
        Ok(_) => "taken".to_owned(),
        Err(error) => error.to_string(),
    }
}

/// So many points in a row.
fn row(count: usize) -> Vec<SupportPoint> {
    let place = |i: usize| SupportPoint::new(dvec3(i as f64, 0.0, 0.0));
    (0..count).map(place).collect()
}

fn path(points: Vec<SupportPoint>) -> CameraPath {
    CameraPath {
        points: points.into(),
        ..CameraPath::default()
    }
}

#[test]
fn a_path_has_two_points_at_least_and_so_many_at_most() {
    let most = format!("a path has at most {} support points", limits::MAX_POINTS);
    let cases = [
        (1, "a path needs at least two support points"),
        (2, "taken"),
        (limits::MAX_POINTS, "taken"),
        (limits::MAX_POINTS + 1, &most),
    ];
    for (count, sentence) in cases {
        assert_eq!(said(path(row(count)).check()), sentence, "{count} points");
    }
}

#[test]
fn a_point_has_a_preset_that_there_is_and_one_to_ten_orientations() {
    let with = |change: &dyn Fn(&mut SupportPoint)| {
        let mut path = path(row(2));
        change(&mut path.points[1]);
        said(path.check())
    };
    assert_eq!(
        with(&|point| point.curve = CurveParameters::Preset(9)),
        "taken"
    );
    assert_eq!(
        with(&|point| point.curve = CurveParameters::Preset(10)),
        "point 2: there is no preset 10: they are numbered 0 to 9"
    );
    for (count, sentence) in [
        (0, "point 2: a point has between 1 and 10 orientations"),
        (1, "taken"),
        (10, "taken"),
        (11, "point 2: a point has between 1 and 10 orientations"),
    ] {
        let all = vec![Orientation::default(); count];
        assert_eq!(with(&|point| point.orientations.clone_from(&all)), sentence);
    }
}

#[test]
fn a_document_takes_no_more_points_and_orientations_than_there_may_be() {
    let document = |points| Document::from_parts(path(points), Info::default()).expect("in order");
    let mut full = document(row(limits::MAX_POINTS));
    let divide = Edit::DivideSegment {
        segment: 0,
        points: 1,
    };
    let refused = full.apply(divide.clone()).unwrap_err();
    assert_eq!(refused.kind(), ErrorKind::Limit);
    assert_eq!(full.path().points.len(), limits::MAX_POINTS);
    assert!(!full.is_modified() && !full.can_undo());

    let mut points = row(limits::MAX_ALL_ORIENTATIONS / limits::MAX_ORIENTATIONS);
    for point in &mut points {
        point.orientations = vec![Orientation::default(); limits::MAX_ORIENTATIONS];
    }
    let mut full = document(points);
    let sentence = format!(
        "the points of a path have at most {} orientations together",
        limits::MAX_ALL_ORIENTATIONS
    );
    assert_eq!(said(full.apply(divide)), sentence);
    let remove = Edit::RemoveOrientation { point: 0, at: 0 };
    full.apply(remove).expect("one fewer");
    let insert = Edit::InsertOrientation {
        point: 0,
        at: 0,
        orientation: None,
    };
    full.apply(insert).expect("as many as before");
}

#[test]
fn an_object_has_so_many_points_at_most() {
    let point = ObjectPoint {
        position: DVec3::ZERO,
        draw: false,
    };
    for (count, taken) in [
        (limits::MAX_OBJECT_POINTS, true),
        (limits::MAX_OBJECT_POINTS + 1, false),
    ] {
        let info = Info {
            object: vec![point; count].into(),
            ..Info::default()
        };
        assert_eq!(
            info.check(vides::path::Space::default()).is_ok(),
            taken,
            "{count} points"
        );
    }
}

#[test]
fn a_curve_through_quaternions_has_a_time_and_a_shape_for_each_key() {
    let keys = [DQuat::IDENTITY, DQuat::from_rotation_y(1.0)];
    let times = [0.0, 1.0, 2.0];
    let few = "a quaternion curve needs at least two keys, each with a time";
    let through =
        |keys: &[DQuat], times: &[f64]| said(quaternion_spline::barry_goldman(keys, times, 0.5));
    assert_eq!(through(&keys, &times[..2]), "taken");
    assert_eq!(through(&keys, &times), few);
    assert_eq!(through(&keys[..1], &times[..1]), few);
    let shapes = [Tcb::default(); 3];
    for (count, sentence) in [
        (1, "each key needs its tension, continuity and bias"),
        (2, "taken"),
        (3, "each key needs its tension, continuity and bias"),
    ] {
        let curve = quaternion_spline::tcb(&keys, &times[..2], Some(&shapes[..count]), 0.5);
        assert_eq!(said(curve), sentence);
    }
    let many = vec![DQuat::IDENTITY; limits::MAX_KEYS + 1];
    let times: Vec<f64> = (0..many.len()).map(|i| i as f64).collect();
    assert_eq!(
        through(&many[1..], &times[1..]),
        "the time asked for must lie between the first and the last key"
    );
    assert_eq!(
        through(&many, &times),
        "a quaternion curve has at most 1000000 keys"
    );
}

#[test]
fn a_spline_has_finite_ends_and_so_many_points_at_most() {
    let points = [DVec3::ZERO, DVec3::X, DVec3::Y];
    let knots = [0.0, 1.0, 2.0];
    let never = DVec3::new(0.0, f64::INFINITY, 0.0);
    for (from, to) in [(DVec3::X, DVec3::X), (never, DVec3::X), (DVec3::X, never)] {
        let fits = from == to;
        let sentence = |refused| if fits { "taken" } else { refused };
        let clamped = CubicSpline::new(&points, &knots, SplineEnds::Clamped(from, to));
        assert_eq!(said(clamped), sentence("an end slope must be finite"));
        let tangents = catmull_rom::open_curve(&points, EndRule::Tangents(from, to));
        assert_eq!(said(tangents), sentence("an end tangent must be finite"));
    }
}

#[test]
fn a_curve_without_length_is_at_its_start_whatever_is_asked() {
    let nowhere = Cubic::hermite(DVec3::ONE, DVec3::ONE, DVec3::ZERO, DVec3::ZERO);
    let arc = ArcLength::new(&nowhere).expect("memory");
    assert_eq!(arc.length(), 0.0);
    for s in [-1.0, 0.0, 1e-300, 1.0, f64::NAN] {
        assert_eq!(arc.parameter_at(s), 0.0);
    }
    assert_eq!((arc.length_at(0.5), arc.length_at(1.0)), (0.0, 0.0));
}
