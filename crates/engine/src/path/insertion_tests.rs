//! Insertions that keep the motion, on random paths: every pose before against
//! the same pose after.

use super::*;
use crate::path::test_support::Random;
use crate::path::{
    CurveKind, CurveParameters, Ease, EaseKind, OrientationOverrides, Pose, ZoomMode, timing,
};

pub(crate) fn random_path(random: &mut Random, round: usize) -> CameraPath {
    fn some(random: &mut Random) -> f64 {
        2.0 * random.unit() - 1.0
    }
    fn vector(random: &mut Random) -> DVec3 {
        DVec3::new(some(random), some(random), some(random))
    }
    let target = 3.0 * vector(random);
    // Not a closed path of two points: it runs straight there and back.
    let closed = round.is_multiple_of(3);
    let count = 2 + usize::from(closed) + (random.unit() * 5.0) as usize;
    let points = (0..count).map(|_| {
        let orientations = 1 + (random.unit() * 1.5) as usize;
        let orientations = (0..orientations).map(|_| {
            let kind = random.unit();
            let pace = match (random.unit() * 5.0) as usize {
                0 => Pace::Ease(Ease {
                    kind: if random.unit() < 0.5 {
                        EaseKind::Sine
                    } else {
                        EaseKind::Parabolic
                    },
                    rise: random.unit() / 2.0,
                    fall: random.unit() / 2.0,
                    cruise: 20.0 + 80.0 * random.unit(),
                }),
                1 => Pace::Distance(
                    [[0.0, 0.0], [0.3, 0.2 + 0.2 * random.unit()], [1.0, 1.0]].into(),
                ),
                _ => Pace::Speeds,
            };
            let even = random.unit() < 0.3;
            Orientation {
                target: if kind < 0.4 {
                    Target::Absolute(target)
                } else {
                    Target::Relative(vector(random))
                },
                roll: if random.unit() < 0.5 {
                    0.0
                } else {
                    60.0 * some(random)
                },
                zoom: if random.unit() < 0.4 {
                    24.0
                } else {
                    20.0 + 60.0 * random.unit()
                },
                turning: if random.unit() < 0.5 {
                    Tcb::default()
                } else {
                    Tcb::new(some(random), some(random), some(random))
                },
                speeds: std::array::from_fn(|_| {
                    if even {
                        50.0
                    } else {
                        20.0 + 60.0 * random.unit()
                    }
                }),
                hold: if random.unit() < 0.2 { 3 } else { 0 },
                own: Orientation::default()
                    .own
                    .with(|own| own.pace = pace)
                    .unwrap(),
            }
        });
        let orientations = orientations.collect();
        SupportPoint {
            curve: CurveParameters::Own(Tcb::new(
                some(random) / 2.0,
                some(random) / 2.0,
                some(random) / 2.0,
            )),
            orientations,
            ..SupportPoint::new(vector(random))
        }
    });
    CameraPath {
        points: points.collect(),
        closed,
        curve: [
            CurveKind::Tcb,
            CurveKind::Tcb,
            CurveKind::Cubic,
            CurveKind::Linear,
        ][round % 4],
        orientation_mode: if round.is_multiple_of(7) {
            OrientationMode::Slerp
        } else {
            OrientationMode::Tcb
        },
        zoom_mode: if round.is_multiple_of(5) {
            ZoomMode::Linear
        } else {
            ZoomMode::Smooth
        },
        ..CameraPath::default()
    }
}

fn poses(path: &CameraPath) -> (Timeline, Vec<Pose>) {
    let timeline = Timeline::new(path).unwrap();
    let sampler = Sampler::new(path, &timeline).unwrap();
    let mut poses = vec![Pose::default(); sampler.frame_count()];
    sampler.sample(1, &mut poses).unwrap();
    (timeline, poses)
}

fn degrees(a: [f64; 3], b: [f64; 3]) -> f64 {
    let (a, b) = (DVec3::from(a), DVec3::from(b));
    (2.0 * ((a - b).length() / 2.0).min(1.0).asin()).to_degrees()
}

/// Lets each section begin with the speed with which the one before ends.
fn join(path: &mut CameraPath) {
    let mut last = None;
    for point in path.points.iter_mut() {
        for orientation in &mut point.orientations {
            orientation.speeds[0] = last.unwrap_or(orientation.speeds[0]);
            last = Some(timing::facing(orientation)[1]);
        }
    }
}

#[test]
fn poses_stay_what_they_are() {
    let mut random = Random(41);
    let mut worst = [0.0f64; 3];
    let mut done = 0;
    for round in 0..4000 {
        let mut path = random_path(&mut random, round);
        if round % 2 == 1 {
            join(&mut path);
        }
        let first = poses(&path).1;
        for _ in 0..1 + round % 3 {
            let frame = 1.0 + random.unit() * (first.len() - 1) as f64;
            let Ok(inserted) = on_curve(&path, frame) else {
                continue;
            };
            path = inserted.path;
            done += 1;
        }
        let (_, after) = poses(&path);
        assert_eq!(after.len(), first.len(), "round {round}");
        for (frame, (a, b)) in first.iter().zip(&after).enumerate() {
            let place = (DVec3::from(a.vrp) - DVec3::from(b.vrp)).length();
            let view = degrees(a.vpn, b.vpn).max(degrees(a.vup, b.vup));
            let zoom = (a.zoom / b.zoom - 1.0).abs();
            let place_of = || format!("round {round}, frame {frame}");
            assert!(place < 1e-12, "{}: {place}", place_of());
            assert!(zoom < 1e-12, "{}: {zoom}", place_of());
            assert!(view < 1e-5, "{}: {view}", place_of());
            worst[0] = worst[0].max(place);
            worst[1] = worst[1].max(view);
            worst[2] = worst[2].max(zoom);
        }
    }
    println!("{done} insertions: worst place, view, zoom {worst:?}");
    assert!(done > 4000);
}

#[test]
fn where_there_is_no_way_to_divide_it_says_so() {
    let mut path = CameraPath::default();
    path.points[0].orientations.push(Orientation {
        roll: 40.0,
        ..Orientation::default()
    });
    path.points[1].orientations[0].hold = 5;
    let timeline = Timeline::new(&path).unwrap();
    let (pan, all) = (timeline.section(0).frames, timeline.frame_count().unwrap());
    let refused = |path: &CameraPath, frame: f64| on_curve(path, frame).unwrap_err().to_string();
    let pan_end = (pan + 1) as f64;
    for (frame, why) in [
        (0.5, "there is no frame 0.5: they go from 1 to "),
        (f64::NAN, "there is no frame NaN"),
        ((all + 1) as f64, "they go from 1 to "),
        (1.0, "at a key already"),
        (5.0, "turns at point 1"),
        (pan_end, "at a key already"),
        (all as f64, "at a key already"),
        (all as f64 - 4.5, "at a key already"),
    ] {
        let said = refused(&path, frame);
        assert!(said.contains(why), "{frame}: {said}");
    }
    let inserted = on_curve(&path, pan_end + 0.2).unwrap();
    assert_eq!(inserted.at, 1);
    path.orientation_mode = OrientationMode::BarryGoldman;
    assert!(refused(&path, pan_end + 3.0).contains("barry-goldman"));
}

/// Without frames between its ends a section is divided where it is asked for.
#[test]
fn a_section_of_one_frame_becomes_two() {
    let mut path = CameraPath::default();
    path.base_frames.movement = 0.5;
    assert_eq!(poses(&path).1.len(), 2);
    let inserted = on_curve(&path, 1.25).unwrap();
    let place = inserted.path.points[1].position;
    assert!((place - DVec3::new(-0.3, 0.2, 0.8)).length() < 1e-15);
    assert_eq!(poses(&inserted.path).1.len(), 3);
}

#[test]
fn fixed_frames_are_shared() {
    let mut path = CameraPath::default();
    let own = &mut path.points[0].orientations[0].own;
    let lock = |own: &mut OrientationOverrides| (own.frames, own.locked) = (77, true);
    *own = own.with(lock).unwrap();
    assert_eq!(poses(&path).1.len(), 78);
    let inserted = on_curve(&path, 20.4).unwrap();
    let locked = |at: usize| inserted.path.points[at].orientations[0].own.locked;
    assert_eq!([0, 1, 2].map(locked), [true, true, false]);
    let frames = |at: usize| inserted.path.points[at].orientations[0].own.frames;
    assert_eq!((frames(0), frames(1), frames(2)), (19, 58, 0));
}
