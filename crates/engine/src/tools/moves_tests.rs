use super::*;
use crate::deform::Bounds;
use crate::path::{Pose, Sampler};
use crate::tools::check::{CheckContext, Limits, check};

fn poses(path: &CameraPath) -> Vec<Pose> {
    let timeline = Timeline::new(path).unwrap();
    let sampler = Sampler::new(path, &timeline).unwrap();
    let mut poses = vec![Pose::default(); sampler.frame_count()];
    sampler.sample(1, &mut poses).unwrap();
    poses
}

/// A move with some of its numbers set.
fn made(name: &str, set: &[(&str, &[f64])]) -> Result<CameraPath> {
    let found = Move::named(name).unwrap();
    let mut numbers = found.defaults(None, Space::default()).unwrap();
    for (name, values) in set {
        let (at, parameter) = Parameter::find(found.parameters, name).unwrap();
        assert_eq!(values.len(), parameter.width);
        numbers[at..at + values.len()].copy_from_slice(values);
    }
    found.path(&numbers, Space::default(), 25.0)
}

fn place(pose: &Pose) -> DVec3 {
    DVec3::from_array(pose.vrp)
}

/// How far a target is from the middle of the picture, in radians.
fn off(pose: &Pose, target: DVec3) -> f64 {
    let to = (target - place(pose)).normalize();
    to.cross(DVec3::from_array(pose.vpn)).length()
}

#[test]
fn every_move_has_its_seconds_and_looks_at_its_target() {
    assert_eq!(
        MOVES
            .iter()
            .map(|known| known.name)
            .collect::<Vec<_>>()
            .join(", "),
        KNOWN
    );
    let target = [0.3, -0.2, 0.1];
    for known in MOVES {
        let at = if known.name == "pan" { "at" } else { "around" };
        let path = made(known.name, &[(at, &target), ("seconds", &[12.0])]).unwrap();
        let poses = poses(&path);
        assert_eq!(poses.len(), 300, "{}", known.name);
        let target = DVec3::from_array(target);
        for pose in &poses {
            if known.name == "pan" {
                assert_eq!(place(pose), target);
            } else {
                assert!(off(pose, target) < 1e-12, "{}", known.name);
            }
        }
        let by_length = made(known.name, &[("seconds", &[0.0])]).unwrap();
        assert!(
            by_length
                .points
                .iter()
                .all(|p| p.orientations[0].own.frames == 0)
        );
    }
}

#[test]
fn an_orbit_is_round_with_few_points() {
    for (turns, radius) in [(1.0, 1.2), (2.0, 1e-3), (-0.7, 300.0), (3.25, 1.0)] {
        let set: &[(&str, &[f64])] = &[("turns", &[turns]), ("radius", &[radius])];
        let path = made("orbit", set).unwrap();
        assert!((path.points.len() - 1) as f64 <= (12.0 * turns.abs()).ceil());
        let mut angle = 0.0;
        // The error of such a cubic goes with the sixth power of its angle.
        let frames = path
            .points
            .iter()
            .map(|point| point.orientations[0].own.frames);
        let widest = f64::from(frames.max().unwrap()) / 249.0 * 12.0 * turns.abs();
        let off = 3.75e-7 * widest.powi(6);
        assert!(widest < 1.11);
        let poses = poses(&path);
        for pair in poses.windows(2) {
            let [a, b] = [place(&pair[0]), place(&pair[1])];
            assert!((a.x.hypot(a.z) / radius - 1.0).abs() < off);
            assert!((a.y - 0.4).abs() < 1e-13 * radius.max(1.0));
            angle += (b.x * a.z - b.z * a.x).atan2(a.x * b.x + a.z * b.z);
        }
        assert!((angle - TAU * turns).abs() < 1e-9);
    }
}

#[test]
fn a_spiral_is_linear_in_its_angle() {
    let set: &[(&str, &[f64])] = &[("turns", &[0.9]), ("from", &[20.0])];
    for pose in poses(&made("spiral", set).unwrap()) {
        let p = place(&pose);
        let share = ((p.x.atan2(p.z).to_degrees() - 20.0).rem_euclid(360.0)) / (0.9 * 360.0);
        // At the start the angle may be a hair below.
        let share = if share > 1.05 { 0.0 } else { share };
        assert!((p.x.hypot(p.z) - (1.0 - 0.5 * share)).abs() < 2e-4);
        assert!((p.y - (0.4 + 0.6 * share)).abs() < 2e-4);
    }
}

#[test]
fn a_dolly_zoom_keeps_the_size() {
    for (from, to, zoom) in [(3.0, 1.0, 60.0), (1.0, 3.9, 25.0), (2.0, 1.999, 100.0)] {
        let set: &[(&str, &[f64])] = &[
            ("distance", &[from]),
            ("end-distance", &[to]),
            ("zoom", &[zoom]),
        ];
        let path = made("dolly-zoom", set).unwrap();
        let mut seen = 0;
        for pose in poses(&path) {
            // The size in the picture is zoom/distance.
            assert!((pose.zoom / place(&pose).length() * from / zoom - 1.0).abs() < 1e-12);
            seen += 1;
        }
        assert_eq!(seen, 250);
    }
    let error = made("dolly-zoom", &[("end-distance", &[0.01])]).unwrap_err();
    assert!(error.to_string().contains("at the end"), "{error}");
}

#[test]
fn straight_moves_lead_where_they_say() {
    let path = poses(&made("flyby", &[("from", &[90.0])]).unwrap());
    let near = path
        .iter()
        .map(|pose| place(pose).length())
        .fold(9.0, f64::min);
    assert!((near - 1f64.hypot(0.4)).abs() < 1e-4);
    assert!(path.iter().all(|pose| (pose.vrp[0] - 1.0).abs() < 1e-12));
    let path = poses(&made("approach", &[("rise", &[30.0])]).unwrap());
    let (first, last) = (place(&path[0]), place(&path[path.len() - 1]));
    assert!((first - DVec3::new(0.0, 0.5, 0.75f64.sqrt())).length() < 1e-14);
    assert!((last.length() - 0.4).abs() < 1e-14);
    let path = poses(&made("crane", &[]).unwrap());
    assert_eq!(path[0].vrp, [0.0, -0.2, 1.0]);
    assert_eq!(path[path.len() - 1].vrp, [0.0, 1.0, 1.0]);
}

#[test]
fn a_pan_turns_evenly() {
    let set: &[(&str, &[f64])] = &[("from", &[-100.0]), ("to", &[290.0]), ("tilt", &[20.0])];
    let poses = poses(&made("pan", set).unwrap());
    for (k, pose) in poses.iter().enumerate() {
        let want = -100.0 + 390.0 * k as f64 / (poses.len() - 1) as f64;
        let view = DVec3::from_array(pose.vpn);
        let off = view.x.atan2(view.z) - want.to_radians();
        assert!(off.sin().abs() < 1e-9, "{k}: {off}");
        assert!((view.y - 20f64.to_radians().sin()).abs() < 1e-12);
    }
}

/// Whatever the frames and turns, all sections of a move have one speed.
#[test]
fn sections_have_one_speed() {
    let mut worst = 0.0_f64;
    for known in MOVES {
        for seconds in [
            0.0, 0.3, 0.5, 1.0, 1.7, 2.0, 4.0, 7.3, 10.0, 12.0, 31.7, 100.0,
        ] {
            for fps in [12.0, 24.0, 25.0, 30.0, 60.0, 120.0] {
                for turns in [0.05, 0.3, -0.7, 1.0, 2.0, 3.25] {
                    let mut numbers = known.defaults(None, Space::default()).unwrap();
                    let mut set = |name: &str, number: f64| {
                        let found = Parameter::find(known.parameters, name);
                        found.map(|(at, _)| numbers[at] = number).is_some()
                    };
                    set("seconds", seconds);
                    let turns =
                        set("turns", turns) || set("to", 360.0 * turns - 45.0) || turns == 1.0;
                    let Ok(path) = known.path(&numbers, Space::default(), fps) else {
                        assert!(
                            seconds > 0.0 && seconds * fps < 51.0,
                            "{} {seconds} {fps}",
                            known.name
                        );
                        continue;
                    };
                    let timeline = Timeline::new(&path).unwrap();
                    if seconds > 0.0 {
                        assert_eq!(
                            timeline.frame_count().unwrap(),
                            (seconds * fps).round() as usize
                        );
                    }
                    let speeds = timeline.moving().map(|k| {
                        let section = timeline.section(k);
                        section.amount / section.frames as f64
                    });
                    let (low, high) = speeds
                        .fold((f64::INFINITY, 0.0_f64), |(low, high), speed| {
                            (low.min(speed), high.max(speed))
                        });
                    worst = worst.max(high / low - 1.0);
                    assert!(
                        !turns || high / low < 1.001,
                        "{} {seconds} s, {fps} a second: {low} {high}",
                        known.name
                    );
                }
            }
        }
    }
    println!("{worst:e}");
}

#[test]
fn a_figure_of_eight_is_geronos() {
    for pose in poses(&made("figure-eight", &[]).unwrap()) {
        let [x, y, z] = pose.vrp;
        let (across, away) = (x / 0.6, (z - 0.7) / 0.3);
        let want = 4.0 * across * across * (1.0 - across * across);
        assert!((away * away - want).abs() < 1e-3 && (y - 0.4).abs() < 1e-15);
    }
}

/// As they come, they stay within the space, and nothing in them looks wrong.
#[test]
fn a_check_finds_nothing_in_them() {
    for made_of in MOVES {
        let path = made(made_of.name, &[]).unwrap();
        let space = path.space;
        let against = CheckContext {
            fps: 25.0,
            space: Some(Bounds::new(space.low(), space.high()).unwrap()),
            object: None,
            limits: Limits::default(),
        };
        let found = check(&path, &against).unwrap();
        assert!(found.is_empty(), "{}: {found:?}", made_of.name);
    }
}

#[test]
fn numbers_that_do_not_do_are_refused() {
    for (name, set) in [
        ("orbit", ("radius", 0.0)),
        ("orbit", ("radius", f64::NAN)),
        ("orbit", ("turns", 0.0)),
        ("orbit", ("zoom", 0.5)),
        ("orbit", ("seconds", 0.01)),
        ("arc", ("to", -45.0)),
        ("pan", ("to", -45.0)),
        ("pan", ("tilt", 90.0)),
        ("crane", ("end-height", f64::INFINITY)),
        ("crane", ("radius", 2e9)),
    ] {
        assert!(made(name, &[(set.0, &[set.1])]).is_err(), "{name} {set:?}");
    }
    assert!(Move::named("loop").is_err());
    let orbit = Move::named("orbit").unwrap();
    assert!(orbit.path(&[0.0; 10], Space::default(), 25.0).is_err());
    assert!(orbit.path(&[], Space::default(), 25.0).is_ok());
    assert!(orbit.path(&[0.5, 0.5, 0.5], Space::default(), 25.0).is_ok());
}

#[test]
fn an_object_gives_the_place_and_the_size() {
    let bounds = Bounds::new(DVec3::new(1.0, 2.0, 3.0), DVec3::new(3.0, 5.0, 9.0)).unwrap();
    let numbers = Move::named("orbit")
        .unwrap()
        .defaults(Some(&bounds), Space::default())
        .unwrap();
    assert_eq!(numbers[..5], [2.0, 3.5, 6.0, 7.0, 0.4 * 7.0]);
}

#[test]
fn a_space_with_z_upright_has_the_same_move_turned() {
    use crate::path::Up;
    let space = Space {
        centre: DVec3::new(10.0, 20.0, 30.0),
        half_size: 5.0,
        up: Up::Z,
    };
    let orbit = Move::named("orbit").unwrap();
    let numbers = orbit.defaults(None, space).unwrap();
    let path = orbit.path(&numbers, space, 25.0).unwrap();
    for pose in poses(&path) {
        let p = place(&pose) - space.centre;
        assert!((p.x.hypot(p.y) - 5.0).abs() < 1e-5 && (p.z - 2.0).abs() < 1e-12);
        assert!(pose.vup[2] > 0.9);
    }
}
