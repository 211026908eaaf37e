//! Insertions that keep the motion, on random paths: every pose before against
//! the same pose after.

use super::*;
use crate::path::test_support::Random;
use crate::path::{CurveKind, CurveParameters, Ease, EaseKind, Pose, ZoomMode};

pub(super) fn random_path(random: &mut Random, round: usize) -> CameraPath {
    fn some(random: &mut Random) -> f64 {
        2.0 * random.unit() - 1.0
    }
    fn vector(random: &mut Random) -> DVec3 {
        DVec3::new(some(random), some(random), some(random))
    }
    let target = 3.0 * vector(random);
    let count = 2 + (random.unit() * 5.0) as usize;
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
        closed: round % 3 == 0,
        curve: [
            CurveKind::Tcb,
            CurveKind::Tcb,
            CurveKind::Cubic,
            CurveKind::Linear,
        ][round % 4],
        orientation_mode: if round % 7 == 0 {
            OrientationMode::Slerp
        } else {
            OrientationMode::Tcb
        },
        zoom_mode: if round % 5 == 0 {
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

#[test]
fn poses_stay_what_they_are() {
    let mut random = Random(41);
    let mut worst = [0.0f64; 4];
    let mut views = Vec::new();
    let mut done = 0;
    let mut bad = 0;
    for round in 0..4000 {
        let mut path = random_path(&mut random, round);
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
            if place > 1e-11 || zoom > 1e-9 || view > 0.05 {
                println!("round {round}, frame {frame}: {place:e} {view} {zoom:e}");
                bad += 1;
                if bad % 40 == 1 {
                    println!("{path:#?}")
                }
            }
            views.push(view);
            worst[0] = worst[0].max(place);
            worst[1] = worst[1].max(view);
            worst[2] = worst[2].max(zoom);
        }
    }
    views.sort_by(f64::total_cmp);
    let share = |s: f64| views[(s * (views.len() - 1) as f64) as usize];
    println!(
        "{done} insertions: worst place, view, zoom {worst:?}; views 99 % {} 99.9 % {}",
        share(0.99),
        share(0.999)
    );
    assert!(done > 4000);
    assert!(worst[1] < 0.1);
}
