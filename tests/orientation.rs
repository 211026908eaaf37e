//! The turning of the camera from key to key: angular velocities at the keys,
//! their limit, and a turning about one axis in closed form.

mod common;

use std::f64::consts::PI;

use common::turning::{at_target, busy_path, free, looking, moving, rotation, span, turned, yawed};
use common::{Random, all_poses, path_through, prepared, set_speeds};
use glam::DVec3;
use vides::path::{
    CameraPath, CurveParameters, Orientation, OrientationMode, Sampler, Target, Tcb, Timeline,
};

const ROUNDING: f64 = 1e-12;

/// Angular velocity in curve time at the beginning (or end) of a section: the
/// limit of rotation / time, extrapolated from steps of 1/5000 of the section
/// and less (Richardson).
fn velocity(
    path: &CameraPath,
    timeline: &Timeline,
    sampler: &Sampler,
    section: usize,
    end: bool,
) -> DVec3 {
    let facts = timeline.section(section);
    let frames = facts.frames as f64;
    let start = sampler.first_frame(section) as f64 - 1.0;
    let speeds = &path.points[facts.point].orientations[facts.orientation].speeds;
    let (key, sign, speed) = if end {
        (start + frames, -1.0, speeds[9])
    } else {
        (start, 1.0, speeds[0])
    };
    let here = sampler.pose(key).unwrap();
    // dτ/du = frames · v/50, v being the speed at that end.
    let time = frames * speed / 50.0;
    let rate = |step: f64| {
        let there = sampler.pose(key + sign * step * frames).unwrap();
        rotation(&here, &there).0 / (sign * step * time)
    };
    let mut rates = [2e-4, 1e-4, 5e-5, 2.5e-5, 1.25e-5].map(rate);
    for order in 1..rates.len() {
        let factor = f64::from(1u32 << order);
        for k in 0..rates.len() - order {
            rates[k] = (factor * rates[k + 1] - rates[k]) / (factor - 1.0);
        }
    }
    rates[0]
}

/// Sections that meet at a key, with frames on either side.
fn meetings(path: &CameraPath, timeline: &Timeline) -> Vec<(usize, usize)> {
    let moving: Vec<usize> = (0..timeline.section_count())
        .filter(|&section| timeline.section(section).frames > 0)
        .collect();
    let mut meetings: Vec<_> = moving.windows(2).map(|two| (two[0], two[1])).collect();
    if path.closed {
        meetings.push((moving[moving.len() - 1], moving[0]));
    }
    meetings
}

#[test]
fn angular_velocity_is_continuous_at_free_keys() {
    let mut random = Random::new(32);
    let mut keys = 0;
    for round in 0..300 {
        let mut path = busy_path(&mut random, |random| {
            let mut orientation = free(random);
            orientation.turning = random.tcb();
            orientation.turning.continuity = 0.0;
            orientation
        });
        if round % 4 == 0 {
            path.orientation_mode = OrientationMode::BarryGoldman;
        }
        let (timeline, sampler) = prepared(&path);
        for (before, after) in meetings(&path, &timeline) {
            let reach = velocity(&path, &timeline, &sampler, before, true);
            let leave = velocity(&path, &timeline, &sampler, after, false);
            // The natural size of a velocity here.
            let size = [before, after].map(|section| {
                let (time, angle) = span(&timeline, &sampler, section);
                angle / time
            });
            let size = size[0] + size[1];
            let jump = (reach - leave).length();
            assert!(jump < 1e-6 * size, "round {round}: {reach} {leave}");
            keys += 1;
        }
    }
    println!("{keys} keys");
}

/// At a key between a section that tracks or keeps and a free one the free one
/// takes over the velocity, scaled down only where it would swing out.
#[test]
fn free_sections_take_over_the_velocity_of_their_neighbours() {
    let mut random = Random::new(33);
    let (mut taken, mut rests, mut limited) = (0, 0, 0);
    for round in 0..400 {
        let target = DVec3::new(0.2, 4.0, -3.0);
        let (kept, roll) = (random.vector(), random.between(-90.0, 90.0));
        let mut path = busy_path(&mut random, |random| match random.below(5) {
            0 | 1 => at_target(target, random.between(-60.0, 60.0)),
            2 | 3 => looking(kept, roll),
            _ => free(random),
        });
        for point in &mut path.points {
            point.curve = CurveParameters::Own(Tcb::new(0.2, 0.0, 0.3));
        }
        let (timeline, sampler) = prepared(&path);
        let count = path.points.len();
        // −1: free, 0: keeps, 1: tracks.
        let kind = |section: usize| {
            let facts = timeline.section(section);
            let point = &path.points[facts.point];
            let from = &point.orientations[facts.orientation];
            let to = point.orientations.get(facts.orientation + 1);
            let to = to.unwrap_or(&path.points[(facts.point + 1) % count].orientations[0]);
            match (from.target, to.target) {
                (Target::Absolute(_), Target::Absolute(_)) => 1,
                (Target::Relative(a), Target::Relative(b)) if a == b && from.roll == to.roll => 0,
                _ => -1,
            }
        };
        for (before, after) in meetings(&path, &timeline) {
            let reach = velocity(&path, &timeline, &sampler, before, true);
            let leave = velocity(&path, &timeline, &sampler, after, false);
            let (given, took, free) = match (kind(before), kind(after)) {
                (-1, kind) if kind >= 0 => (leave, reach, before),
                (kind, -1) if kind >= 0 => (reach, leave, after),
                _ => continue,
            };
            // Half the rotation is the angle that the limit counts.
            let (time, angle) = span(&timeline, &sampler, free);
            let third = 0.5 * given.length() * time / 3.0;
            let bound = 0.45 * (PI - angle);
            let scale = if third > bound { bound / third } else { 1.0 };
            limited += i32::from(scale < 1.0);
            if given.length() < 1e-9 {
                rests += 1;
            } else {
                taken += 1;
            }
            let size = given.length() + angle / time;
            let wrong = (given * scale - took).length();
            assert!(wrong < 1e-6 * size, "round {round}: {given} {took} {scale}");
        }
    }
    println!("{taken} taken over ({limited} scaled), {rests} at rest");
    assert!(taken > 100 && rests > 100);
}

/// Where the curve has no tangent the camera still moves on at full speed, and
/// the velocity of the tracking is that of this movement.
#[test]
fn velocity_is_taken_over_where_the_curve_has_no_tangent() {
    let target = DVec3::new(0.4, 0.9, -0.8);
    let mut path = path_through(&[[-0.8, 0.0, 0.3], [0.1, 0.4, 0.6], [0.9, -0.3, 0.2]]);
    path.points[1].curve = CurveParameters::Own(Tcb::new(1.0, 0.0, 0.0));
    for point in &mut path.points {
        point.orientations = vec![at_target(target, 10.0)];
    }
    path.points[2].orientations = vec![yawed(40.0)];
    set_speeds(&mut path, 60.0);
    let (timeline, sampler) = prepared(&path);
    let key = (sampler.first_frame(1) - 1) as f64;
    let here = sampler.pose(key).unwrap();
    // The place runs with s + O(s^1.5), so the step must be small.
    let rate = |section: usize, sign: f64| {
        let facts = timeline.section(section);
        let step = 1e-8 * facts.frames as f64;
        rotation(&here, &sampler.pose(key + sign * step).unwrap()).0 / (sign * step)
    };
    let (reach, leave) = (rate(0, -1.0), rate(1, 1.0));
    assert!(reach.length() > 1e-3);
    assert!(
        (reach - leave).length() < 1e-3 * reach.length(),
        "{reach} {leave}"
    );
}

/// Half angles of a turning about one axis: there the sphere is a circle, and
/// all of it is a cubic polynomial in every section. Written down from Kochanek
/// and Bartels' formulas for unequal times, and the limit.
fn half_yaws(half: &[f64], times: &[f64], shapes: &[Tcb]) -> Vec<[f64; 4]> {
    let last = times.len();
    let mean = |k: usize| (half[k + 1] - half[k]) / times[k];
    let shaped = |k: usize, shape: Tcb| {
        let (a, b) = (times[k - 1], times[k]);
        let (before, after) = (b * mean(k - 1) / (a + b), a * mean(k) / (a + b));
        let Tcb {
            tension: t,
            continuity: c,
            bias,
        } = shape;
        let reach = (1.0 - c) * (1.0 + bias) * before + (1.0 + c) * (1.0 - bias) * after;
        let leave = (1.0 + c) * (1.0 + bias) * before + (1.0 - c) * (1.0 - bias) * after;
        [(1.0 - t) * reach, (1.0 - t) * leave]
    };
    let velocities: Vec<[f64; 2]> = (0..=last)
        .map(|k| {
            let loose = 1.0 - shapes[k].tension;
            let [reach, leave] = if last == 1 {
                [mean(0); 2]
            } else if k == 0 {
                [loose * (2.0 * mean(0) - shaped(1, Tcb::default())[0]); 2]
            } else if k == last {
                [loose * (2.0 * mean(k - 1) - shaped(k - 1, Tcb::default())[1]); 2]
            } else {
                shaped(k, shapes[k])
            };
            let allowed = |section: usize, velocity: f64| {
                let angle = mean(section).abs() * times[section];
                let bound = angle.min(0.45 * (PI - angle));
                (bound / (velocity.abs() * times[section] / 3.0)).min(1.0)
            };
            let mut scale = 1.0f64;
            if k > 0 && reach != 0.0 {
                scale = scale.min(allowed(k - 1, reach));
            }
            if k < last && leave != 0.0 {
                scale = scale.min(allowed(k, leave));
            }
            [scale * reach, scale * leave]
        })
        .collect();
    (0..last)
        .map(|k| {
            let third = times[k] / 3.0;
            [
                half[k],
                half[k] + third * velocities[k][1],
                half[k + 1] - third * velocities[k + 1][0],
                half[k + 1],
            ]
        })
        .collect()
}

#[test]
fn turning_about_one_axis_is_a_curve_on_a_line() {
    let mut random = Random::new(34);
    for round in 0..500 {
        let count = 2 + random.below(5);
        let mut yaws = vec![random.between(-180.0, 180.0)];
        for k in 1..count {
            let turn = random.between(-179.0, 179.0);
            yaws.push(yaws[k - 1] + turn);
        }
        let orientations = yaws.iter().map(|&yaw| Orientation {
            turning: random.tcb(),
            speeds: [random.between(5.0, 95.0); 10],
            ..yawed(yaw)
        });
        let mut path = moving(orientations.collect());
        for point in &mut path.points {
            point.position.x *= random.between(0.5, 2.0);
        }
        path.base_frames.movement = 30.0;
        let (timeline, sampler) = prepared(&path);
        let half: Vec<f64> = yaws.iter().map(|yaw| 0.5 * yaw.to_radians()).collect();
        let sections: Vec<_> = (0..count - 1).map(|k| timeline.section(k)).collect();
        let times: Vec<f64> = sections
            .iter()
            .map(|section| section.frames as f64 * section.mean_speed / 50.0)
            .collect();
        let shapes: Vec<Tcb> = path
            .points
            .iter()
            .map(|point| point.orientations[0].turning)
            .collect();
        let control = half_yaws(&half, &times, &shapes);
        let poses = all_poses(&sampler);
        for (k, section) in sections.iter().enumerate() {
            let curve = timeline.speed_curve(&path, k).unwrap();
            for n in 1..section.frames {
                let x = curve.fraction(n as f64 / section.frames as f64);
                let y = 1.0 - x;
                let [a, b, c, d] = control[k];
                let yaw = 2.0 * (y * y * (y * a + 3.0 * x * b) + x * x * (3.0 * y * c + x * d));
                let want = DVec3::new(yaw.sin(), 0.0, yaw.cos());
                let pose = &poses[sampler.first_frame(k) + n - 2];
                let wrong = (DVec3::from(pose.vpn) - want).length();
                assert!(wrong < ROUNDING, "round {round}, {k} {n}: {wrong:e}");
                assert!(pose.vup[1] > 1.0 - ROUNDING);
            }
        }
    }
}

/// 0°, 30°, 50° in equal times with continuity c at the middle: by hand the
/// curve reaches it with ((1−c)·30 + (1+c)·20)/2 and leaves it with the c's
/// exchanged.
#[test]
fn continuity_makes_a_corner_in_the_turning() {
    for c in [-0.5, 0.25, 1.0] {
        let mut path = moving(vec![yawed(0.0), yawed(30.0), yawed(50.0)]);
        path.points[1].orientations[0].turning = Tcb::new(0.0, c, 0.0);
        let (timeline, sampler) = prepared(&path);
        let time = timeline.section(0).frames as f64;
        assert_eq!(timeline.section(1).frames as f64, time);
        let reach = velocity(&path, &timeline, &sampler, 0, true) * time;
        let leave = velocity(&path, &timeline, &sampler, 1, false) * time;
        let want = |c: f64| DVec3::Y * (0.5 * ((1.0 - c) * 30.0 + (1.0 + c) * 20.0)).to_radians();
        assert!((reach - want(c)).length() < 1e-8, "{c}: {reach}");
        assert!((leave - want(-c)).length() < 1e-8, "{c}: {leave}");
    }
}

/// 90° in 10 frames and then 30° in 100: without a limit the second section
/// would swing on by 226°. The limit keeps it between the control points: not
/// more than 30° beyond either key, and on the whole not farther than along
/// the control polygon.
#[test]
fn a_quick_turn_does_not_swing_out_into_a_slow_one() {
    let mut path = moving(vec![yawed(0.0), yawed(90.0), yawed(120.0)]);
    path.points[1].position.x = 0.1;
    path.points[2].position.x = 1.1;
    // Straight from point to point: 10 and 100 frames at the default speed.
    for point in &mut path.points {
        point.curve = CurveParameters::Own(Tcb::new(1.0, 0.0, 0.0));
    }
    let (timeline, sampler) = prepared(&path);
    assert_eq!(timeline.section(0).frames, 10);
    assert_eq!(timeline.section(1).frames, 100);
    let poses = all_poses(&sampler);
    let second = &poses[10..=110];
    let mut swing = 0.0;
    for pair in second.windows(2) {
        swing += turned(&pair[0], &pair[1]).to_degrees();
        let yaw = pair[1].vpn[0].atan2(pair[1].vpn[2]).to_degrees();
        assert!((60.0..=150.0).contains(&yaw), "{yaw}");
    }
    println!("{swing}°");
    assert!((30.0 - 1e-9..90.0).contains(&swing), "{swing}");
}
