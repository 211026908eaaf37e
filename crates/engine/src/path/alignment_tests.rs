//! Ups against closed forms (helix, circles), against a fine integration of the
//! rotation-minimising equation u′ = −(u·v′)v, and for jumps.

use super::*;
use crate::math::rotation_minimising::shortest;
use crate::path::arc_length::ArcLength;
use crate::path::frenet::Normals;
use crate::path::insertion::tests::random_path;
use crate::path::test_support::Random;
use crate::path::ups::Alignment;
use crate::path::{
    CurveKind, Pose, Sampler, SupportPoint, Tangents, Target, Timeline, UpPath, UpVector,
};

fn set(path: &mut CameraPath, up: &UpVector, ahead: Option<f64>) {
    for orientation in path.points.iter_mut().flat_map(|p| &mut p.orientations) {
        let change = |own: &mut crate::path::OrientationOverrides| {
            own.up = up.clone();
            own.ahead = ahead;
        };
        orientation.own = orientation.own.with(change).unwrap();
    }
}

fn sampled(path: &CameraPath) -> Vec<Pose> {
    path.check().unwrap();
    let sampler = Sampler::new(path, &Timeline::new(path).unwrap()).unwrap();
    let mut all = vec![Pose::default(); sampler.frame_count()];
    sampler.sample(1, &mut all).unwrap();
    for pose in &all {
        let (view, up) = (DVec3::from(pose.vpn), DVec3::from(pose.vup));
        assert!((view.length() - 1.0).abs() < 1e-12 && (up.length() - 1.0).abs() < 1e-12);
        assert!(view.dot(up).abs() < 1e-12, "{}", view.dot(up));
    }
    all
}

/// Points on a curve, open, of kind cubic, without roll.
fn through(count: usize, at: impl Fn(f64) -> DVec3) -> CameraPath {
    let points = (0..count).map(|k| SupportPoint::new(at(k as f64 / (count - 1) as f64)));
    CameraPath {
        points: points.collect(),
        curve: CurveKind::Cubic,
        ..CameraPath::default()
    }
}

const RADIUS: f64 = 0.5;
const RISE: f64 = 0.1;

fn helix(angle: f64) -> DVec3 {
    DVec3::new(RADIUS * angle.cos(), RISE * angle, RADIUS * angle.sin())
}

/// Points that own the tangents of a helix of two turns: cubics near it.
fn helix_path(count: usize) -> CameraPath {
    let whole = 4.0 * std::f64::consts::PI;
    let step = whole / (count - 1) as f64;
    let mut path = through(count, |share| helix(whole * share));
    for (k, point) in path.points.iter_mut().enumerate() {
        let angle = step * k as f64;
        let d = DVec3::new(-RADIUS * angle.sin(), RISE, RADIUS * angle.cos()) * step;
        point.tangents = Some(Tangents {
            before: d,
            after: d,
        });
    }
    path
}

/// Up carried along the tangent of a path by the fourth order of Runge and Kutta, in
/// many steps a segment.
fn integrated(path: &CameraPath, up: DVec3, steps: usize) -> DVec3 {
    let timeline = Timeline::new(path).unwrap();
    let mut up = up;
    for segment in 0..path.segment_count() {
        let curve = timeline.curve(segment);
        let slope = |t: f64, up: DVec3| {
            let (d, dd) = (curve.derivative(t), curve.second_derivative(t));
            let view = d.normalize();
            let turn = (dd - view * view.dot(dd)) / d.length();
            -up.dot(turn) * view
        };
        let h = 1.0 / steps as f64;
        for k in 0..steps {
            let t = k as f64 * h;
            let a = slope(t, up);
            let b = slope(t + h / 2.0, up + h / 2.0 * a);
            let c = slope(t + h / 2.0, up + h / 2.0 * b);
            let d = slope(t + h, up + h * c);
            up += h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
        }
    }
    up
}

#[test]
fn minimal_up_turns_by_the_torsion_of_a_helix() {
    let mut path = helix_path(193);
    set(&mut path, &UpVector::Minimal, Some(0.0));
    let all = sampled(&path);
    // Against the normal the frame turns back by the torsion, c/(r² + c²) a length.
    let squares = RADIUS * RADIUS + RISE * RISE;
    let whole = 4.0 * std::f64::consts::PI;
    let angle_at = |pose: &Pose, angle: f64| {
        let view = DVec3::from(pose.vpn);
        let normal = -DVec3::new(angle.cos(), 0.0, angle.sin());
        let normal = perpendicular(normal, view).unwrap();
        signed_angle(normal, pose.vup.into(), view)
    };
    let first = angle_at(&all[0], 0.0);
    let last = angle_at(&all[all.len() - 1], whole);
    let torsion = RISE / squares * squares.sqrt() * whole;
    for sign in [-1.0, 1.0] {
        let missing = (last - first + sign * torsion).rem_euclid(std::f64::consts::TAU);
        if missing.min(std::f64::consts::TAU - missing) < 3e-7 {
            return;
        }
    }
    panic!("{first} {last} {torsion}");
}

#[test]
fn minimal_up_is_that_of_a_fine_integration() {
    let mut random = Random(71);
    for round in 0..60 {
        let mut path = random_path(&mut random, round);
        path.closed = false;
        for point in &mut path.points {
            point.tangents = None;
            point.orientations.truncate(1);
            point.orientations[0].roll = 0.0;
        }
        path.curve = CurveKind::Cubic;
        set(&mut path, &UpVector::Minimal, Some(0.0));
        let timeline = Timeline::new(&path).unwrap();
        let slow = (0..path.segment_count()).any(|k| {
            let curve = timeline.curve(k);
            let speed = |i: usize| curve.derivative(i as f64 / 200.0).length();
            (0..=200).any(|i| speed(i) < 0.05 * speed(0).max(speed(200)))
        });
        if slow || path.segment_count() < 2 {
            continue;
        }
        let all = ups(&path).unwrap();
        let wanted = integrated(&path, all[0], 4000);
        let error = (all[all.len() - 1] - wanted).length();
        assert!(
            error < 1e-7 * path.segment_count() as f64,
            "{round}: {error}"
        );
        // Between the keys too.
        sampled(&path);
    }
}

#[test]
fn minimal_up_of_a_closed_path_has_no_seam() {
    let mut path = through(9, |share| {
        let a = std::f64::consts::TAU * share;
        DVec3::new(
            a.cos(),
            0.4 * (2.0 * a).sin() + 0.2 * (3.0 * a + 1.0).sin(),
            a.sin(),
        ) * 0.7
    });
    path.points.pop();
    path.closed = true;
    set(&mut path, &UpVector::Minimal, Some(0.0));
    for point in &mut path.points {
        let own = &mut point.orientations[0].own;
        *own = own.with(|own| own.frames = 4000).unwrap();
    }
    let all = sampled(&path);
    // What up turns by for a length.
    let rate = |k: usize| {
        let far = |a: [f64; 3], b: [f64; 3]| (DVec3::from(a) - DVec3::from(b)).length();
        far(all[k].vup, all[k + 1].vup) / far(all[k].vrp, all[k + 1].vrp)
    };
    let (before, after) = (rate(all.len() - 2), rate(0));
    assert!((before / after - 1.0).abs() < 0.01, "{before} {after}");
    // The angle that is missing without the spreading is not nothing.
    let timeline = Timeline::new(&path).unwrap();
    let alignment = Alignment::new(&path, timeline.guides().rail.unwrap()).unwrap();
    let turn = alignment.carried[7].as_ref().unwrap().turn;
    assert!(turn[1].abs() > 0.01, "{turn:?}");
    let share = 1.0 - timeline.segment_length(7) / timeline.length();
    assert!((turn[0] / turn[1] - share).abs() < 1e-12);
}

#[test]
fn a_minimal_up_does_not_spin_over_a_pole() {
    // A loop in an upright plane: straight up and down on the way.
    let mut path = through(13, |share| {
        let a = std::f64::consts::TAU * share;
        DVec3::new(a.sin(), 1.0 - a.cos(), 0.0) * 0.5
    });
    set(&mut path, &UpVector::Minimal, Some(0.0));
    for pose in sampled(&path) {
        // The axis of the loop stays where it is in the picture.
        let right = DVec3::from(pose.vpn).cross(pose.vup.into());
        assert!((right - DVec3::Z).length() < 1e-9, "{pose:?}");
    }
}

#[test]
fn the_normal_of_a_helix_points_to_its_axis() {
    let turns = std::f64::consts::TAU * 2.0;
    let mut path = through(97, |share| helix(turns * share));
    set(&mut path, &UpVector::Frenet, Some(0.0));
    let all = sampled(&path);
    let inner = all.len() / 8..7 * all.len() / 8;
    for pose in &all[inner] {
        let place = DVec3::from(pose.vrp);
        let wanted = DVec3::new(-place.x, 0.0, -place.z).normalize();
        // The second derivative of a cubic spline is of the second order.
        assert!((DVec3::from(pose.vup) - wanted).length() < 3e-3, "{pose:?}");
    }
}

#[test]
fn the_normal_does_not_turn_over_at_an_inflection() {
    // A wave in a plane that lies askew.
    let (a, b) = (
        DVec3::new(1.0, 0.3, -0.2).normalize(),
        DVec3::new(0.2, 1.0, 0.5),
    );
    let b = perpendicular(b, a).unwrap();
    let mut path = through(15, |share| {
        (2.0 * share - 1.0) * 0.8 * a + 0.2 * (9.0 * share + 0.3).sin() * b
    });
    set(&mut path, &UpVector::Frenet, Some(0.0));
    let all = sampled(&path);
    for pair in all.windows(2) {
        let [p, q] = [0, 1].map(|k| DVec3::from(pair[k].vup));
        assert!(p.dot(q) > 0.9, "{pair:?}");
    }
    // It stays in the plane, on one side of the way.
    let out = a.cross(b);
    for pose in &all {
        let view = DVec3::from(pose.vpn);
        let side = out.cross(view).dot(pose.vup.into());
        assert!((side.abs() - 1.0).abs() < 1e-9);
        assert!(side * out.cross(all[0].vpn.into()).dot(all[0].vup.into()) > 0.0);
    }
}

#[test]
fn a_straight_run_carries_the_normal_on() {
    // Bent in one plane, straight, then bent in another: cubics whose second
    // derivatives are nothing where they join.
    let segment = |p: DVec3, a: DVec3, c: DVec3| {
        crate::path::hermite::Cubic::hermite(p, p + a + c, c, 3.0 * a + c)
    };
    let first = {
        let c = segment(DVec3::ZERO, 0.2 * DVec3::Y, DVec3::X);
        // Backwards: it ends where it has no curvature.
        crate::path::hermite::Cubic::hermite(
            c.point(1.0),
            c.point(0.0),
            -c.derivative(1.0),
            -c.derivative(0.0),
        )
    };
    let along = first.derivative(1.0);
    let begin = first.point(1.0);
    let middle = segment(begin, DVec3::ZERO, along);
    let askew = DVec3::new(0.0, 0.1, 0.2);
    let last = segment(middle.point(1.0), askew, along);
    let curves = [first, middle, last];
    let lengths: Vec<f64> = curves.iter().map(crate::path::dispatch::length).collect();
    let starts = [
        0.0,
        lengths[0],
        lengths[0] + lengths[1],
        lengths.iter().sum(),
    ];
    let normals = Normals::new(&curves, &starts, false).unwrap().unwrap();
    let at = |segment: usize, t: f64| normals.at(segment, t, t).unwrap();
    let [from, to] = [at(0, 1.0), at(2, 0.0)];
    let whole = signed_angle(from, to, along.normalize());
    assert!(
        whole.abs() <= std::f64::consts::FRAC_PI_2 + 1e-12 && whole.abs() > 0.1,
        "{whole}"
    );
    for k in 0..=10 {
        let share = f64::from(k) / 10.0;
        let turned = signed_angle(from, at(1, share), along.normalize());
        assert!(
            (turned - whole * share).abs() < 1e-9,
            "{share}: {turned} {whole}"
        );
    }
}

#[test]
fn a_wholly_straight_path_has_the_axis() {
    let mut path = through(5, |share| DVec3::new(share, 0.5 * share, 0.0));
    set(&mut path, &UpVector::Frenet, Some(0.0));
    let frenet = sampled(&path);
    set(&mut path, &UpVector::Axis, Some(0.0));
    for (a, b) in frenet.iter().zip(sampled(&path)) {
        assert!((DVec3::from(a.vup) - DVec3::from(b.vup)).length() < 1e-12);
    }
}

#[test]
fn a_normal_that_would_jump_is_refused() {
    let mut path = through(5, |share| helix(3.0 * share));
    set(&mut path, &UpVector::Frenet, Some(0.0));
    path.check().unwrap();
    path.curve = CurveKind::Tcb;
    assert!(path.check().unwrap_err().to_string().contains("minimal"));
    path.curve = CurveKind::Cubic;
    let d = DVec3::X;
    path.points[2].tangents = Some(Tangents {
        before: d,
        after: d,
    });
    assert!(path.check().is_err());
}

#[test]
fn points_and_paths_stand_where_up_is() {
    let place = DVec3::new(0.2, 3.0, -0.4);
    let mut second = through(4, |share| {
        DVec3::new(share, 2.0 + share, 1.0 - share * share)
    });
    second.curve = CurveKind::Tcb;
    let up_path = UpPath::of(&second).unwrap();
    let lines = Timeline::new(&second).unwrap();
    for look in [None, Some(0.0), Some(0.3)] {
        let mut path = through(7, |share| helix(5.0 * share));
        set(&mut path, &UpVector::Point(place), look);
        for pose in sampled(&path) {
            let wanted = perpendicular(place - DVec3::from(pose.vrp), pose.vpn.into()).unwrap();
            assert!((wanted - DVec3::from(pose.vup)).length() < 1e-12);
        }
        set(&mut path, &UpVector::Path(up_path.clone()), look);
        let timeline = Timeline::new(&path).unwrap();
        for (k, up) in ups(&path).unwrap().into_iter().enumerate() {
            let before: f64 = (0..k).map(|k| timeline.segment_length(k)).sum();
            let mut s = before / timeline.length() * lines.length();
            let mut segment = 0;
            while segment < 2 && s > lines.segment_length(segment) {
                s -= lines.segment_length(segment);
                segment += 1;
            }
            let arc = ArcLength::new(lines.curve(segment)).unwrap();
            let there = lines.curve(segment).point(arc.parameter_at(s));
            let view = ahead::view(&path, k, 0);
            let wanted = perpendicular(there - path.points[k].position, view).unwrap();
            assert!((wanted - up).length() < 1e-9, "{look:?} {k}");
        }
        sampled(&path);
    }
}

#[test]
fn a_target_is_tracked_with_the_up_of_its_keys() {
    let target = DVec3::new(0.1, 0.2, 0.3);
    let mut path = through(6, |share| helix(4.0 * share));
    for point in &mut path.points {
        point.orientations[0].target = Target::Absolute(target);
    }
    for up in [
        UpVector::Point(DVec3::new(2.0, 0.5, 0.0)),
        UpVector::Minimal,
        UpVector::Frenet,
    ] {
        set(&mut path, &up, None);
        for pose in sampled(&path) {
            let wanted = (target - DVec3::from(pose.vrp)).normalize();
            assert!((wanted - DVec3::from(pose.vpn)).length() < 1e-12);
        }
    }
    // A minimal one never turns about the view: its rate is a small part of a turn.
    set(&mut path, &UpVector::Minimal, None);
    for pair in sampled(&path).windows(2) {
        let carried = shortest(pair[0].vup.into(), pair[0].vpn.into(), pair[1].vpn.into());
        let turned = (carried - DVec3::from(pair[1].vup)).length();
        let moved = (DVec3::from(pair[0].vpn) - DVec3::from(pair[1].vpn)).length();
        assert!(turned < 0.05 * moved * moved + 1e-7, "{turned} {moved}");
    }
}

#[test]
fn no_up_jumps() {
    let mut random = Random(72);
    let mut fast = 0;
    for round in 0..150 {
        let mut path = random_path(&mut random, round);
        path.curve = CurveKind::Cubic;
        for point in &mut path.points {
            point.tangents = None;
        }
        let up = match round % 3 {
            0 => UpVector::Minimal,
            1 => UpVector::Frenet,
            _ => UpVector::Point(DVec3::new(0.3, 9.0, 0.2)),
        };
        let look = [None, Some(0.0), Some(0.4)][round / 3 % 3];
        set(&mut path, &up, look);
        let sampler = Sampler::new(&path, &Timeline::new(&path).unwrap()).unwrap();
        for (k, pair) in sampled(&path).windows(2).enumerate() {
            let far = |a: &Pose, b: &Pose| {
                let far = |a: [f64; 3], b: [f64; 3]| (DVec3::from(a) - DVec3::from(b)).length();
                (far(a.vup, b.vup), far(a.vpn, b.vpn))
            };
            if far(&pair[0], &pair[1]).0 < 0.2 {
                continue;
            }
            // What is left of a fast turn when its time is halved again and again.
            fast += 1;
            let mut ends = [k as f64 + 1.0, k as f64 + 2.0];
            let mut poses = [pair[0], pair[1]];
            for _ in 0..30 {
                let middle = 0.5 * (ends[0] + ends[1]);
                let pose = sampler.pose(middle).unwrap();
                let first = far(&poses[0], &pose).0 > far(&pose, &poses[1]).0;
                ends[usize::from(first)] = middle;
                poses[usize::from(first)] = pose;
            }
            let (up, view) = far(&poses[0], &poses[1]);
            // Where the view itself jumps, so does up.
            assert!(
                up < 1e-3 || view > 1e-3,
                "{round} {k} {look:?}: {up} {view}"
            );
        }
    }
    assert!(fast > 20, "{fast}");
}
