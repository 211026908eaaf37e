//! How many frames a path has, counted by hand; that every key is hit to the
//! last bit; and that bringing a timeline up to date equals a new one.

mod common;

use common::{Random, all_poses, closed, path_through, prepared, set_speeds, shaped};
use glam::DVec3;
use vides::error::{EngineError, TooMany};
use vides::limits::MAX_FRAMES;
use vides::math::orientation;
use vides::path::{
    BaseFrames, CameraPath, Change, CurveParameters, Orientation, Pose, Sampler, Target, Tcb,
    Timeline,
};

/// Tells the four base speeds apart.
const SPEEDS: BaseFrames = BaseFrames {
    movement: 10.0,
    turning: 20.0,
    zoom: 40.0,
    rolling: 80.0,
};

fn ahead() -> Orientation {
    Orientation {
        target: Target::Relative(DVec3::Z),
        ..Orientation::default()
    }
}

fn yawed(degrees: f64) -> Orientation {
    let (sin, cos) = degrees.to_radians().sin_cos();
    Orientation {
        target: Target::Relative(DVec3::new(sin, 0.0, cos)),
        ..Orientation::default()
    }
}

/// Pans through these, then moves by 1 along x: that takes 10 frames.
fn pans(orientations: Vec<Orientation>) -> CameraPath {
    let mut path = path_through(&[[0.0; 3], [1.0, 0.0, 0.0]]);
    path.points[0].orientations = orientations;
    path.base_frames = SPEEDS;
    path
}

/// What changes in each section, and its frames.
fn sections(path: &CameraPath) -> Vec<(Change, usize)> {
    let timeline = prepared(path).0;
    (0..timeline.section_count())
        .map(|index| timeline.section(index))
        .map(|section| (section.change, section.frames))
        .collect()
}

/// One pan from the orientation ahead to another one.
fn pan(to: Orientation) -> (Change, usize) {
    sections(&pans(vec![ahead(), to]))[0]
}

#[test]
fn each_change_counts_with_its_own_speed() {
    let with = |roll: f64, zoom: f64| Orientation {
        roll,
        zoom,
        ..ahead()
    };
    // Position: length 2.5 · 10.
    let mut path = path_through(&[[0.0; 3], [1.5, 0.0, 2.0]]);
    path.base_frames = SPEEDS;
    assert_eq!(sections(&path), [(Change::Position, 25)]);
    // It is the length that counts, whatever else changes meanwhile.
    path.points[1].orientations[0] = Orientation {
        target: Target::Relative(DVec3::X),
        roll: 90.0,
        zoom: 99.0,
        ..ahead()
    };
    assert_eq!(sections(&path), [(Change::Position, 25)]);
    // View: a rotation by 180° takes 20.
    assert_eq!(pan(yawed(180.0)), (Change::View, 20));
    assert_eq!(pan(yawed(-90.0)), (Change::View, 10));
    assert_eq!(pan(yawed(135.0)), (Change::View, 15));
    // The angle between the quaternions has the roll in it: yaw 90° and roll
    // 90° together are a third of a whole turn, 120°: 13.33.
    let both = Orientation {
        roll: 90.0,
        ..yawed(90.0)
    };
    assert_eq!(pan(both), (Change::View, 13));
    // Roll: 90° take 80, by the shorter way.
    assert_eq!(pan(with(45.0, 24.0)), (Change::Roll, 40));
    assert_eq!(pan(with(-135.0, 24.0)), (Change::Roll, 120));
    let across = sections(&pans(vec![with(170.0, 24.0), with(-170.0, 90.0)]))[0];
    // 17.78, not 302.
    assert_eq!(across, (Change::Roll, 18));
    // Zoom: 1 to 100 take 40.
    let zooms = sections(&pans(vec![
        with(0.0, 1.0),
        with(0.0, 100.0),
        with(0.0, 50.5),
    ]));
    assert_eq!(zooms[..2], [(Change::Zoom, 40), (Change::Zoom, 20)]);
    // The unit stays 99 mm, however long the lens: 19 of them take 760, 19 mm 7.68.
    let long = [with(0.0, 100.0), with(0.0, 1981.0), with(0.0, 2000.0)];
    let zooms = sections(&pans(long.to_vec()));
    assert_eq!(zooms[..2], [(Change::Zoom, 760), (Change::Zoom, 8)]);
    // Nothing.
    let all = sections(&pans(vec![ahead(), ahead()]));
    assert_eq!(all, [(Change::Nothing, 0), (Change::Position, 10)]);
}

#[test]
fn what_is_no_change_decides_the_row() {
    let tilted = |radians: f64| Orientation {
        target: Target::Relative(DVec3::new(radians, 0.0, 1.0)),
        roll: 45.0,
        ..ahead()
    };
    assert_eq!(pan(tilted(0.9e-9)), (Change::Roll, 40));
    // 45° of 180° · 20.
    assert_eq!(pan(tilted(1.1e-9)), (Change::View, 5));
    let rolled = |roll: f64, zoom: f64| Orientation {
        roll,
        zoom,
        ..ahead()
    };
    // 49.5 of 99 · 40.
    assert_eq!(pan(rolled(0.9e-9, 73.5)), (Change::Zoom, 20));
    assert_eq!(pan(rolled(1.1e-9, 73.5)), (Change::Roll, 1));
    assert_eq!(pan(rolled(0.0, 24.0 + 0.9e-9)), (Change::Nothing, 0));
    assert_eq!(pan(rolled(0.0, 24.0 + 1.1e-9)), (Change::Zoom, 1));
    // A segment shorter than 1e-9 does not move.
    let step = |length: f64| {
        let mut path = path_through(&[[0.0; 3], [length, 0.0, 0.0]]);
        path.points[1].orientations[0].zoom = 73.5;
        path.base_frames = SPEEDS;
        sections(&path)[0]
    };
    assert_eq!(step(0.9e-9), (Change::Zoom, 20));
    assert_eq!(step(1.1e-9), (Change::Position, 1));
}

#[test]
fn frames_are_rounded_and_never_none() {
    let frames = |length: f64| {
        let mut path = path_through(&[[0.0; 3], [length, 0.0, 0.0]]);
        path.base_frames = SPEEDS;
        prepared(&path).0.section(0).frames
    };
    // 0.1, 1.4, 1.5 (half away from zero), 1.6, 2.5.
    let lengths = [0.01, 0.14, 0.15625, 0.16, 0.25];
    assert_eq!(lengths.map(frames), [1, 1, 2, 2, 3]);
}

/// ∫v by hand: the Catmull–Rom cubic has (v₀+v₁)/2 + (m₀−m₁)/12 in each of its
/// nine intervals, and the slopes inside cancel.
#[test]
fn the_speed_curve_divides_the_frames() {
    let way = |speeds: [f64; 10]| {
        let mut path = path_through(&[[0.0; 3], [3.0, 0.0, 0.0]]);
        path.base_frames.movement = 100.0;
        path.points[0].orientations[0].speeds = speeds;
        path
    };
    let count = |path: &CameraPath| prepared(path).0.section(0).frames;
    assert_eq!(count(&way([50.0; 10])), 300);
    assert_eq!(count(&way([100.0; 10])), 150);
    assert_eq!(count(&way([1.0; 10])), 15_000);
    // From 10 to 64 in a straight line: the mean is 37; 15000/37 = 405.4.
    let line = std::array::from_fn(|k| 10.0 + 6.0 * k as f64);
    assert_eq!(count(&way(line)), 405);
    // One point at 77 among 50s: (27 + 0)/9 more, 53; 15000/53 = 283.02.
    let mut bump = [50.0; 10];
    bump[4] = 77.0;
    assert_eq!(count(&way(bump)), 283);
    // The first at 86, half an interval more: 18. Its slope is that of the
    // parabola, (−3·86 + 4·50 − 50)/2 = −54, the next one's (50 − 86)/2 = −18:
    // 468 − 3 − 1.5 = 463.5, mean 51.5; 15000/51.5 = 291.26.
    let mut first = [50.0; 10];
    first[0] = 86.0;
    assert_eq!(count(&way(first)), 291);
    // At 100 with 1s beside it: the parabola's slope is −148.5 and stays, since
    // 100 − 148.5/3 ≥ 1; the next is clipped flat, or 1 would be undershot.
    // (101/2 − 148.5/12 + 8)/9 = 5.125; 15000/5.125 = 2926.8.
    let mut cliff = [1.0; 10];
    cliff[0] = 100.0;
    assert_eq!(count(&way(cliff)), 2927);
}

/// The last speed of the section before and the first of the one after shape
/// the ends; sections without frames are looked past; paths close.
#[test]
fn neighbours_shape_the_speed_curve() {
    let with = |orientation: Orientation, first: f64, last: f64| {
        let mut speeds = [50.0; 10];
        (speeds[0], speeds[9]) = (first, last);
        Orientation {
            speeds,
            ..orientation
        }
    };
    // Zoom back and forth at one place, 2000 frames at speed 50.
    let mut path = pans(vec![
        with(yawed(0.0), 50.0, 80.0),
        yawed(180.0),
        with(yawed(0.0), 26.0, 50.0),
        yawed(180.0),
    ]);
    path.base_frames.turning = 1e6;
    let mean = |path: &CameraPath, section| prepared(path).0.section(section).mean_speed;
    // Slopes (50 − 80)/2 at the beginning and (26 − 50)/2 at the end.
    let both = (450.0 + (-15.0 + 12.0) / 12.0) / 9.0;
    assert!((mean(&path, 1) - both).abs() < 1e-12);
    assert_eq!(
        prepared(&path).0.section(1).frames,
        (1e6 * 50.0f64 / both).round() as usize
    );
    // Between them the same again with the same speeds: looked past.
    let mut twice = path.clone();
    let orientations = &mut twice.points[0].orientations;
    orientations.insert(2, with(yawed(180.0), 50.0, 50.0));
    orientations.swap(1, 2);
    orientations[1].speeds = [7.0; 10];
    let timeline = prepared(&twice).0;
    assert_eq!(timeline.section(1).change, Change::Nothing);
    assert!((timeline.section(2).mean_speed - both).abs() < 1e-12);
    // 26 at the beginning of section 2 with 50 on either side: flat there, and
    // 12 at the next knot, which the two intervals beside it cancel.
    assert!((mean(&path, 2) - 438.0 / 9.0).abs() < 1e-12);
    // Closed: the last section's last speed faces the first one's beginning.
    let mut ring = closed(path_through(&[[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]));
    assert_eq!(mean(&ring, 0), 50.0);
    ring.points[2].orientations[0] = with(ahead(), 50.0, 80.0);
    assert!((mean(&ring, 0) - (450.0 - 15.0 / 12.0) / 9.0).abs() < 1e-12);
    ring.closed = false;
    assert_eq!(mean(&ring, 0), 50.0);
}

#[test]
fn holds_rest_where_they_stand() {
    let held = |orientation: Orientation, hold: u32| Orientation {
        hold,
        ..orientation
    };
    let mut path = pans(vec![
        held(yawed(0.0), 3),
        held(yawed(90.0), 2),
        // One key with the one before it: its own hold counts, not the other.
        held(yawed(90.0), 5),
    ]);
    path.points[1].orientations[0].hold = 4;
    // 1 + 3 rests + 10 turning + 5 rests + 10 moving + 4 rests.
    let (timeline, sampler) = prepared(&path);
    assert_eq!(timeline.frame_count().unwrap(), 33);
    assert_eq!(sampler.frame_count(), 33);
    assert_eq!(
        [0, 1, 2].map(|section| sampler.first_frame(section)),
        [5, 14, 20]
    );
    let poses = all_poses(&sampler);
    for rest in [0..4, 13..19, 28..33] {
        for pose in &poses[rest.clone()] {
            assert_eq!(pose, &poses[rest.start]);
        }
        assert!(rest.end == 33 || poses[rest.end] != poses[rest.start]);
    }
    // A closed path rests at its first key when it sets off, not again when it
    // comes back: 1 + 3 + 10 + 5 + 10 + 4 + 10.
    path.closed = true;
    let (timeline, sampler) = prepared(&path);
    assert_eq!(timeline.segment_length(1), 1.0);
    assert_eq!(sampler.frame_count(), 43);
    let poses = all_poses(&sampler);
    assert_eq!(poses[42], poses[0]);
    assert_ne!(poses[41], poses[0]);
}

#[test]
fn a_path_in_which_nothing_changes_has_one_pose() {
    let mut path = path_through(&[[0.2; 3], [0.2; 3]]);
    assert_eq!(prepared(&path).1.frame_count(), 1);
    path.points[1].orientations[0].hold = 6;
    path.points[0].orientations[0].hold = 9;
    // The two are one key, with the later one's hold.
    let (_, sampler) = prepared(&path);
    assert_eq!(all_poses(&sampler).len(), 7);
    assert_eq!(sampler.pose(7.0).unwrap(), sampler.pose(1.0).unwrap());
    path.closed = true;
    let poses = all_poses(&prepared(&path).1);
    assert!(poses.iter().all(|pose| pose.vrp == [0.2; 3]));
}

#[test]
fn coincident_points_with_a_loop_between_them_move() {
    let mut path = path_through(&[
        [-1.0, 0.0, 0.0],
        [0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
    ]);
    let (timeline, sampler) = prepared(&path);
    // P(t) = t(1−t)²·(½, 0, 0) − t²(1−t)·(0, ½, 0): a loop of length 0.19…
    let section = timeline.section(1);
    assert_eq!(section.change, Change::Position);
    let chords: f64 = (0..100_000)
        .map(|k| {
            let place = |t: f64| {
                DVec3::new(
                    0.5 * t * (1.0 - t) * (1.0 - t),
                    -0.5 * t * t * (1.0 - t),
                    0.0,
                )
            };
            let t = f64::from(k) / 1e5;
            (place(t + 1e-5) - place(t)).length()
        })
        .sum();
    assert!((section.amount - chords).abs() < 1e-9 * chords);
    assert_eq!(section.frames, (100.0 * chords).round() as usize);
    let middle = sampler.pose(sampler.first_frame(1) as f64 + 0.5 * section.frames as f64);
    assert!(DVec3::from(middle.unwrap().vrp).length() > 0.05);
    // Without tangents there is no loop, and the two points are one key.
    path = shaped(path, Tcb::new(1.0, 0.0, 0.0));
    assert_eq!(prepared(&path).0.section(1).change, Change::Nothing);
}

#[test]
fn too_many_frames_are_refused_before_they_take_memory() {
    let mut path = path_through(&[[0.0; 3], [1.0, 0.0, 0.0]]);
    path.base_frames.movement = (MAX_FRAMES - 1) as f64;
    let timeline = Timeline::new(&path).unwrap();
    assert_eq!(timeline.frame_count().unwrap(), MAX_FRAMES);
    let sampler = Sampler::new(&path, &timeline).unwrap();
    assert_eq!(
        sampler.pose(MAX_FRAMES as f64).unwrap().vrp,
        [1.0, 0.0, 0.0]
    );
    for speed in [MAX_FRAMES as f64, 1e15, 1e300, f64::MAX] {
        path.base_frames.movement = speed;
        path.check().unwrap();
        let timeline = Timeline::new(&path).unwrap();
        assert!(matches!(
            timeline.frame_count(),
            Err(EngineError::Limit(TooMany::Frames))
        ));
        let sampler = Sampler::new(&path, &timeline);
        assert!(matches!(sampler, Err(EngineError::Limit(TooMany::Frames))));
    }
    // Many sections and holds together, too.
    let mut path = path_through(&vec![[0.0; 3]; 101]);
    for (i, point) in path.points.iter_mut().enumerate() {
        point.position.x = i as f64;
        point.orientations[0].hold = 1_000_000;
    }
    let timeline = Timeline::new(&path).unwrap();
    assert!(matches!(
        timeline.frame_count(),
        Err(EngineError::Limit(TooMany::Frames))
    ));
    path.points[0].orientations[0].hold = 0;
    path.points[1].orientations[0].hold = 0;
    // 1 + 100 moves of 100 frames + 99 rests.
    assert_eq!(
        Timeline::new(&path).unwrap().frame_count().unwrap(),
        1 + 100 * 100 + 99 * 1_000_000
    );
}

/// The pose of a key, from its own values by the formulas of the thesis,
/// 4.4.5; the up vector only to rounding.
fn check_key(path: &CameraPath, slot: (usize, usize), pose: &Pose) {
    let point = &path.points[slot.0];
    let key = &point.orientations[slot.1];
    assert_eq!(pose.vrp, point.position.to_array());
    assert_eq!(pose.zoom, key.zoom);
    assert_eq!(pose.vpn, key.view(point.position).to_array());
    let view = match key.target {
        Target::Absolute(target) => target - point.position,
        Target::Relative(offset) => offset,
    }
    .normalize();
    assert!((DVec3::from(pose.vpn) - view).length() < 1e-15);
    if view.x.hypot(view.z) > 1e-6 {
        let level = (DVec3::Y - view * view.y).normalize();
        let (sin, cos) = key.roll.to_radians().sin_cos();
        let up = level * cos - level.cross(view) * sin;
        assert!((DVec3::from(pose.vup) - up).length() < 1e-9);
    }
    let roll = orientation::roll_from_up(DVec3::from(pose.vpn), DVec3::from(pose.vup));
    let off = orientation::wrap_degrees(roll.to_degrees() - key.roll);
    assert!(off.abs() < 1e-9, "{off}");
}

#[test]
fn every_key_is_hit_to_the_last_bit() {
    let mut random = Random::new(41);
    let mut keys = 0;
    for round in 0..400 {
        let path = random.path(if round % 20 == 0 { 2000.0 } else { 60.0 });
        let (timeline, sampler) = prepared(&path);
        let poses = all_poses(&sampler);
        let mut first = true;
        for index in 0..timeline.section_count() {
            let section = timeline.section(index);
            if section.frames == 0 {
                continue;
            }
            // The pose in which a section begins, and the one in which it ends.
            let begin = sampler.first_frame(index) - 2;
            let from = (section.point, section.orientation);
            let hold = path.points[from.0].orientations[from.1].hold as usize;
            if !first || !path.closed {
                check_key(&path, from, &poses[begin]);
                keys += 1;
            }
            first = false;
            for rest in begin - hold..begin {
                assert_eq!(poses[rest], poses[begin]);
            }
            assert_eq!(sampler.pose((begin + 1) as f64).unwrap(), poses[begin]);
        }
        let last = poses[poses.len() - 1];
        if path.closed {
            assert_eq!(last, poses[0]);
        } else {
            let point = path.points.len() - 1;
            let orientation = path.points[point].orientations.len() - 1;
            check_key(&path, (point, orientation), &last);
        }
    }
    println!("{keys} keys");
}

/// Everything that can be seen of two timelines is equal.
fn assert_same(path: &CameraPath, a: &Timeline, b: &Timeline) {
    assert_eq!(a.frame_count().unwrap(), b.frame_count().unwrap());
    assert_eq!(a.length(), b.length());
    assert_eq!(a.section_count(), b.section_count());
    for index in 0..a.section_count() {
        assert_eq!(a.section(index), b.section(index), "section {index}");
        let curves = [a, b].map(|timeline| timeline.speed_curve(path, index).unwrap());
        assert_eq!(curves[0], curves[1], "section {index}");
    }
    assert_eq!(a.segment_count(), b.segment_count());
    for index in 0..a.segment_count() {
        assert_eq!(a.curve(index), b.curve(index), "segment {index}");
        assert_eq!(a.segment_length(index), b.segment_length(index));
    }
}

#[test]
fn a_timeline_brought_up_to_date_equals_a_new_one() {
    let mut random = Random::new(42);
    for _ in 0..400 {
        let mut path = random.path(50.0);
        let count = 2 + random.below(7);
        while path.points.len() < count {
            let extra = random.path(50.0);
            path.points.extend(extra.points);
        }
        path.points.truncate(count);
        // Half of the facing speeds are equal.
        let meet = |orientation: &mut Orientation, random: &mut Random| {
            let [first, .., last] = &mut orientation.speeds;
            [*first, *last] = [0; 2].map(|_| [30.0, 60.0][random.below(2)]);
        };
        let all = path.points.iter_mut().flat_map(|p| &mut p.orientations);
        all.for_each(|orientation| meet(orientation, &mut random));
        let mut timeline = Timeline::new(&path).unwrap();
        for _ in 0..12 {
            let index = random.below(path.points.len());
            let neighbour = path.points[(index + 1) % path.points.len()].clone();
            let edited = &mut path.points[index];
            let which = random.below(edited.orientations.len());
            match random.below(7) {
                0 => edited.position = random.vector(),
                1 => edited.curve = CurveParameters::Own(random.tcb()),
                2 => edited.orientations[which] = random.orientation(edited.position),
                3 => edited.orientations[which].hold = random.below(50) as u32,
                // Onto the next point, and with its view: nothing changes there.
                4 => {
                    edited.position = neighbour.position;
                    edited.orientations.fill(neighbour.orientations[0].clone());
                }
                5 => edited.orientations[which].speeds = random.orientation(DVec3::ZERO).speeds,
                _ => edited.curve = CurveParameters::Preset(random.below(10) as u8),
            }
            for orientation in &mut edited.orientations {
                meet(orientation, &mut random);
                if orientation
                    .target
                    .check(edited.position, path.space)
                    .is_err()
                {
                    orientation.target = Target::Relative(DVec3::Z);
                }
            }
            path.check().unwrap();
            timeline.update_point(&path, index).unwrap();
            let new = Timeline::new(&path).unwrap();
            assert_same(&path, &timeline, &new);
        }
    }
}

/// The number of poses is the sum of what the sections say, for any path.
#[test]
fn the_frames_add_up() {
    let mut random = Random::new(43);
    for _ in 0..500 {
        let mut path = random.path(1.0);
        set_speeds(&mut path, 10f64.powf(random.between(-2.0, 3.0)));
        let (timeline, sampler) = prepared(&path);
        let mut frames = 1;
        for index in 0..timeline.section_count() {
            let section = timeline.section(index);
            if section.frames > 0 {
                let orientation = &path.points[section.point].orientations[section.orientation];
                frames += orientation.hold as usize;
                assert_eq!(sampler.first_frame(index), frames + 1);
                frames += section.frames;
            } else {
                assert_eq!(sampler.first_frame(index), frames);
            }
        }
        if !path.closed {
            let last = &path.points[path.points.len() - 1].orientations;
            frames += last[last.len() - 1].hold as usize;
        }
        assert_eq!(sampler.frame_count(), frames);
    }
}
