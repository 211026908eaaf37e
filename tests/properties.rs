//! What holds whatever the numbers are.

mod common;

use common::{Random, all_poses, prepared, set_speeds};
use glam::{DQuat, DVec3};
use proptest::prelude::*;
use vides::document::{Document, Info};
use vides::formats::{Options, by_name, export_to};
use vides::path::arc_length::ArcLength;
use vides::path::hermite::Cubic;
use vides::path::speed_curve::{CurveEnd, SpeedCurve};
use vides::path::{CameraPath, Change, CurveParameters, Pose, Target};

fn vector() -> impl Strategy<Value = DVec3> {
    prop::array::uniform3(-1.0..1.0f64).prop_map(DVec3::from_array)
}

fn cubic() -> impl Strategy<Value = Cubic> {
    (vector(), vector(), vector(), vector())
        .prop_map(|(p0, p1, r0, r1)| Cubic::hermite(p0, p1, 3.0 * r0, 3.0 * r1))
}

fn length(curve: &Cubic) -> f64 {
    ArcLength::new(curve).unwrap().length()
}

/// The part of a curve between two parameters, as a curve of its own.
fn part(curve: &Cubic, from: f64, to: f64) -> Cubic {
    let width = to - from;
    Cubic::hermite(
        curve.point(from),
        curve.point(to),
        width * curve.derivative(from),
        width * curve.derivative(to),
    )
}

fn speeds() -> impl Strategy<Value = [f64; 10]> {
    let value = prop_oneof![Just(1.0), Just(100.0), 1.0..100.0f64];
    prop::array::uniform10(value)
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn lengths_of_parts_add_up(curve in cubic(), a in 0.0..1.0f64, b in 0.0..1.0f64) {
        let (a, b) = (a.min(b), a.max(b));
        let whole = length(&curve);
        let parts = [(0.0, a), (a, b), (b, 1.0)].map(|(from, to)| length(&part(&curve, from, to)));
        prop_assert!((parts.iter().sum::<f64>() - whole).abs() < 1e-13 * whole);
        let arc = ArcLength::new(&curve).unwrap();
        let between = arc.length_at(b) - arc.length_at(a);
        prop_assert!((between - parts[1]).abs() < 1e-13 * whole);
    }

    #[test]
    fn length_is_monotone_and_never_less_than_the_chord(curve in cubic(), t in 0.0..1.0f64) {
        let arc = ArcLength::new(&curve).unwrap();
        let mut before = 0.0;
        for k in 0..=200 {
            let s = arc.length_at(t * f64::from(k) / 200.0);
            prop_assert!(s >= before);
            before = s;
        }
        let chord = (curve.point(t) - curve.point(0.0)).length();
        prop_assert!(before >= chord - 1e-15 * arc.length());
    }

    #[test]
    fn the_inverse_comes_back(curve in cubic(), share in 0.0..1.0f64) {
        let arc = ArcLength::new(&curve).unwrap();
        let s = share * arc.length();
        let t = arc.parameter_at(s);
        prop_assert!((0.0..=1.0).contains(&t));
        // Measured by the length of the part, not by the inverse's own tables.
        let reached = length(&part(&curve, 0.0, t));
        prop_assert!((reached - s).abs() < 1e-13 * arc.length());
        prop_assert_eq!(arc.parameter_at(0.0), 0.0);
        prop_assert_eq!(arc.parameter_at(arc.length()), 1.0);
    }

    /// The speed itself, from the coefficients of its integral: no clamp can
    /// hide what the distance really does.
    #[test]
    fn speed_stays_in_range(
        speeds in speeds(),
        before in prop::option::of(1.0..100.0f64),
        after in prop::option::of(1.0..100.0f64),
    ) {
        let curve = SpeedCurve::new(&speeds, [before, after].map(CurveEnd::from));
        let mut last = 0.0;
        for (i, c) in curve.fraction_coefficients().iter().enumerate() {
            for k in 0..=50 {
                let x = f64::from(k) / 50.0;
                let slope = ((4.0 * c[4] * x + 3.0 * c[3]) * x + 2.0 * c[2]) * x + c[1];
                let speed = slope * 9.0 * curve.mean();
                prop_assert!((1.0 - 1e-11..=100.0 + 1e-11).contains(&speed), "{}", speed);
                let share = curve.fraction((i as f64 + x) / 9.0);
                prop_assert!(share >= last);
                last = share;
            }
        }
        prop_assert_eq!((curve.fraction(0.0), last), (0.0, 1.0));
    }
}

fn apart(a: &Pose, b: &Pose) -> f64 {
    let far = |a: [f64; 3], b: [f64; 3]| (DVec3::from(a) - DVec3::from(b)).length();
    far(a.vrp, b.vrp)
        .max(far(a.vpn, b.vpn))
        .max(far(a.vup, b.vup))
        .max((a.zoom - b.zoom).abs())
}

/// A random path, now and then with sections of thousands of frames.
fn some_path(random: &mut Random) -> CameraPath {
    let speed = [5.0, 60.0, 300.0, 3000.0][random.below(4)];
    random.path(speed)
}

/// Wherever a part begins, it has the same bits as in the whole.
#[test]
fn a_part_is_the_same_part_of_the_whole() {
    let mut random = Random::new(51);
    for round in 0..500 {
        let path = some_path(&mut random);
        let (_, sampler) = prepared(&path);
        let whole = all_poses(&sampler);
        // Another sampler, so that what one call prepares helps no other.
        let (_, fresh) = prepared(&path);
        for _ in 0..25 {
            let first = 1 + random.below(whole.len());
            let count = match random.below(3) {
                0 => 1,
                1 => random.below(40),
                _ => random.below(2000),
            };
            let count = count.min(whole.len() + 1 - first);
            let mut part = vec![Pose::default(); count];
            fresh.sample(first, &mut part).unwrap();
            for (k, pose) in part.iter().enumerate() {
                let same = &whole[first - 1 + k];
                assert_eq!(
                    pose,
                    same,
                    "round {round}: {} of {first}+{count}",
                    first + k
                );
            }
        }
        let beyond = &mut [Pose::default(); 2];
        assert!(fresh.sample(whole.len(), beyond).is_err());
        assert!(fresh.sample(0, &mut beyond[..1]).is_err());
        assert!(fresh.sample(whole.len() + 1, &mut []).is_ok());
        assert!(fresh.pose(0.999).is_err() && fresh.pose(f64::NAN).is_err());
        assert!(fresh.pose(whole.len() as f64 + 0.001).is_err());
    }
}

#[test]
fn between_frames_the_poses_run_on() {
    let mut random = Random::new(52);
    for _ in 0..200 {
        let path = random.path(100.0);
        let (_, sampler) = prepared(&path);
        let poses = all_poses(&sampler);
        let frame = 1 + random.below(poses.len());
        assert!(apart(&sampler.pose(frame as f64).unwrap(), &poses[frame - 1]) < 1e-12);
        if frame < poses.len() {
            // Just after a frame one is still there: the way is at most a
            // millionth of that to the next frame at a hundredfold speed.
            let next = sampler.pose(frame as f64 + 1e-6).unwrap();
            let step = DVec3::from(next.vrp) - DVec3::from(poses[frame - 1].vrp);
            let timeline = prepared(&path).0;
            assert!(step.length() <= 1e-4 * timeline.length() + 1e-15);
        }
    }
}

/// Powers of two scale without rounding: places come out twice as large to
/// the last bit, everything else the same.
#[test]
fn scaling_by_powers_of_two_is_exact() {
    let mut random = Random::new(53);
    for _ in 0..200 {
        let path = random.path(80.0);
        let scale = 2f64.powi(random.below(12) as i32 - 6);
        let mut scaled = path.clone();
        scaled.base_frames.movement /= scale;
        for point in &mut scaled.points {
            point.position *= scale;
            for orientation in &mut point.orientations {
                match &mut orientation.target {
                    Target::Absolute(v) | Target::Relative(v) => *v *= scale,
                }
            }
        }
        let [small, large] = [&path, &scaled].map(|path| all_poses(&prepared(path).1));
        assert_eq!(small.len(), large.len());
        for (a, b) in small.iter().zip(&large) {
            assert_eq!(a.vrp.map(|x| x * scale), b.vrp);
            assert_eq!((a.vpn, a.vup, a.zoom), (b.vpn, b.vup, b.zoom));
        }
    }
}

/// Turning a path about the y axis and moving it away turns and moves its
/// poses: roll counts from that axis.
#[test]
fn a_path_turned_about_the_vertical_gives_turned_poses() {
    let mut random = Random::new(54);
    for _ in 0..200 {
        let mut path = random.path(60.0);
        for point in &mut path.points {
            for orientation in &mut point.orientations {
                // At a pole the yaw is fixed in the world; and a target on the
                // way is at one.
                let offset = orientation.target.offset_from(point.position);
                if offset.x.hypot(offset.z) < 0.1 * offset.length() {
                    orientation.target = Target::Relative(DVec3::new(0.3, offset.y, 0.4));
                }
                if let Target::Absolute(_) = orientation.target {
                    orientation.target = Target::Absolute(DVec3::new(9.0, -3.0, 20.0));
                }
            }
        }
        let turn = DQuat::from_rotation_y(random.between(-3.0, 3.0));
        let shift = random.vector();
        let mut turned = path.clone();
        for point in &mut turned.points {
            point.position = turn * point.position + shift;
            for orientation in &mut point.orientations {
                match &mut orientation.target {
                    Target::Absolute(v) => *v = turn * *v + shift,
                    Target::Relative(v) => *v = turn * *v,
                }
            }
        }
        let [plain, moved] = [&path, &turned].map(|path| all_poses(&prepared(path).1));
        assert_eq!(plain.len(), moved.len());
        for (pose, got) in plain.iter().zip(&moved) {
            let want = Pose {
                vrp: (turn * DVec3::from(pose.vrp) + shift).to_array(),
                vpn: (turn * DVec3::from(pose.vpn)).to_array(),
                vup: (turn * DVec3::from(pose.vup)).to_array(),
                zoom: pose.zoom,
            };
            assert!(apart(&want, got) < 1e-11, "{want:?} {got:?}");
        }
    }
}

/// The same way back: points and orientations in reverse order, biases with
/// the other sign. Speeds are even, since a section's belong to its beginning.
#[test]
fn a_path_backwards_gives_the_poses_backwards() {
    let mut random = Random::new(55);
    for _ in 0..200 {
        let mut path = random.path(60.0);
        path.closed = false;
        for point in &mut path.points {
            for orientation in &mut point.orientations {
                orientation.speeds = [50.0; 10];
                orientation.hold = 0;
                // No two are one key, which would be the later one's.
                orientation.zoom = random.between(1.0, 2000.0);
                // From pole to pole is half a turn, and that goes by a rule.
                let offset = orientation.target.offset_from(point.position);
                if offset.x.hypot(offset.z) < 1e-3 {
                    orientation.target = Target::Relative(DVec3::new(0.1, offset.y, 0.3));
                }
            }
        }
        let mut back = path.clone();
        back.points = path.points.shared().rev().cloned().collect();
        for (i, point) in back.points.iter_mut().enumerate() {
            let mut tcb = path.tcb(path.points.len() - 1 - i);
            tcb.bias = -tcb.bias;
            point.curve = CurveParameters::Own(tcb);
            point.orientations.reverse();
            for orientation in &mut point.orientations {
                orientation.turning.bias = -orientation.turning.bias;
            }
        }
        let [there, back] = [&path, &back].map(|path| all_poses(&prepared(path).1));
        assert_eq!(there.len(), back.len());
        for (a, b) in there.iter().zip(back.iter().rev()) {
            assert!(apart(a, b) < 1e-9, "{a:?} {b:?}");
        }
    }
}

/// A monotone curve keeps between its keys; so does a straight line.
#[test]
fn zoom_stays_between_its_keys() {
    let mut random = Random::new(56);
    let mut beyond = 0.0f64;
    for _ in 0..2000 {
        let mut path = random.path(1.0);
        set_speeds(&mut path, 40.0);
        for point in &mut path.points {
            for orientation in &mut point.orientations {
                if random.chance(0.3) {
                    orientation.zoom = [1.0, 100.0, 2000.0][random.below(3)];
                }
            }
        }
        let (timeline, sampler) = prepared(&path);
        let poses = all_poses(&sampler);
        for index in 0..timeline.section_count() {
            let section = timeline.section(index);
            if section.frames == 0 {
                continue;
            }
            let begin = sampler.first_frame(index) - 2;
            let zooms: Vec<f64> = poses[begin..=begin + section.frames]
                .iter()
                .map(|pose| pose.zoom)
                .collect();
            let (first, last) = (zooms[0], zooms[zooms.len() - 1]);
            for pair in zooms.windows(2) {
                let (low, high) = (first.min(last), first.max(last));
                beyond = beyond.max(low - pair[1]).max(pair[1] - high);
                // One way only, to rounding.
                assert!((pair[1] - pair[0]) * (last - first).signum() >= -1e-12);
            }
        }
    }
    println!("{beyond:e} beyond the keys");
    assert!(beyond <= 0.0);
}

/// What is counted beforehand is what is sampled, and what every file holds.
#[test]
fn every_count_of_frames_is_the_same() {
    let mut random = Random::new(57);
    for _ in 0..200 {
        let path = some_path(&mut random);
        let (timeline, sampler) = prepared(&path);
        let poses = all_poses(&sampler);
        let counted = timeline.frame_count().unwrap();
        assert_eq!((counted, sampler.frame_count()), (poses.len(), poses.len()));
        let document = Document::from_parts(path, Info::default()).unwrap();
        for (format, heading) in [("ascii", 0), ("csv", 1)] {
            let mut text = Vec::new();
            let scene = document.scene_document().unwrap();
            let format = by_name(format).unwrap();
            export_to(
                &scene,
                &mut text,
                format,
                &Options::default(),
                &mut |_, _| {},
            )
            .unwrap();
            let lines = text.iter().filter(|&&byte| byte == b'\n').count();
            assert_eq!(lines, heading + poses.len());
            assert_eq!(text.last(), Some(&b'\n'));
        }
    }
}

/// Frame n of N stands where the integral of the speed curve says, measured
/// along the segment: with any speeds, not only even ones.
#[test]
fn distances_follow_the_speed_curve() {
    let mut random = Random::new(58);
    let (mut worst, mut uneven) = (0.0f64, 0);
    for _ in 0..300 {
        let path = random.path(60.0);
        let (timeline, sampler) = prepared(&path);
        let poses = all_poses(&sampler);
        for index in 0..timeline.section_count() {
            let section = timeline.section(index);
            if section.change != Change::Position {
                continue;
            }
            let curve = timeline.curve(section.point);
            let arc = ArcLength::new(curve).unwrap();
            let speed = timeline.speed_curve(&path, index).unwrap();
            let first = sampler.first_frame(index) - 1;
            for n in 1..section.frames {
                let u = n as f64 / section.frames as f64;
                let share = speed.fraction(u);
                uneven += usize::from((share - u).abs() > 0.01);
                let should = curve.point(arc.parameter_at(share * arc.length()));
                let is = DVec3::from(poses[first + n - 1].vrp);
                worst = worst.max((is - should).length() / arc.length());
            }
        }
    }
    println!("{worst:e} of a segment's length, {uneven} frames where the speed is uneven");
    assert!(uneven > 1000 && worst < 1e-9, "{worst:e} {uneven}");
}

/// Of a relative offset only the direction counts.
#[test]
fn the_length_of_an_offset_changes_nothing() {
    let mut random = Random::new(59);
    for _ in 0..300 {
        let path = random.path(60.0);
        let mut other = path.clone();
        for point in &mut other.points {
            for orientation in &mut point.orientations {
                if let Target::Relative(offset) = &mut orientation.target {
                    // A power of two: the direction is the same to the last bit.
                    *offset *= 2f64.powi(random.below(20) as i32 - 10);
                }
            }
        }
        let [one, two] = [&path, &other].map(|path| all_poses(&prepared(path).1));
        assert_eq!(one, two);
    }
}

/// A closed path that begins at another of its points runs through the same
/// poses, from there on.
#[test]
fn a_closed_path_has_no_beginning() {
    let mut random = Random::new(60);
    let mut worst = 0.0f64;
    for _ in 0..300 {
        let mut path = random.path(60.0);
        path.closed = true;
        for point in &mut path.points {
            for orientation in &mut point.orientations {
                // The first key's hold counts at the start, and not again at the end.
                orientation.hold = 0;
                // No two are one key; none is half a turn from the next by a pole.
                orientation.zoom = random.between(1.0, 2000.0);
                let offset = orientation.target.offset_from(point.position);
                if offset.x.hypot(offset.z) < 1e-3 {
                    orientation.target = Target::Relative(DVec3::new(0.1, offset.y, 0.3));
                }
            }
        }
        let begin = random.below(path.points.len());
        let mut turned = path.clone();
        turned.points.drain(..begin);
        turned
            .points
            .extend(path.points.shared().take(begin).cloned());
        let (timeline, sampler) = prepared(&path);
        let poses = all_poses(&sampler);
        let others = all_poses(&prepared(&turned).1);
        assert_eq!(poses.len(), others.len());
        let section = timeline.section_from(begin, 0).unwrap();
        let first = sampler.first_frame(section) - 2;
        let round = poses.len() - 1;
        for (k, other) in others.iter().enumerate() {
            worst = worst.max(apart(&poses[(first + k) % round], other));
        }
    }
    println!("{worst:e} apart");
    assert!(worst < 1e-9, "{worst:e}");
}
