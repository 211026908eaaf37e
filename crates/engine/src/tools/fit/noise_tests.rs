//! Noise on recordings of which one knows what they are.

use super::super::*;
use super::recordings::{Event, Flight, Noise, PLAIN, Recording, from_clean, made, recorded};
use super::{TOLERANCE, turned};
use crate::limits::MAX_HOLD;
use crate::path::Timeline;
use crate::path::test_support::Random;

/// About a fixed axis the angle is a cubic, whose second derivative is known.
#[test]
fn the_acceleration_of_a_small_turn_is_no_rounding() {
    for size in [1e-7, 1e-4, 0.3] {
        let sample = |turned: f64| Sample {
            position: DVec3::ZERO,
            turn: crate::math::quaternion::exp(DVec3::X * (size * turned)),
            zoom: 30.0,
        };
        let piece = Piece {
            start: sample(0.0),
            end: sample(1.0),
            velocities: [1.5, 0.2].map(|spin| DVec3::X * (size * spin)),
            speeds: [[1.0, 0.0]; 2],
            ..Piece::creep(sample(0.0)).unwrap()
        };
        for (side, known) in [
            (0, 6.0 - 4.0 * 1.5 - 2.0 * 0.2),
            (1, -6.0 + 2.0 * 1.5 + 4.0 * 0.2),
        ] {
            let found = piece.twist(side) / size;
            assert!(
                found.distance(DVec3::X * known) < 1e-3,
                "{size} {side}: {found}"
            );
        }
    }
}

/// At most twice the points of the clean flight, where a pause is a hold.
#[test]
fn noise_hides_no_pause() {
    for flight in [
        Flight::Hand,
        Flight::Rotation,
        Flight::Translation,
        Flight::Line,
    ] {
        for rate in [30.0, 100.0, 400.0] {
            for noise in [Noise::Gaussian(0.002), Noise::Uniform(0.006)] {
                let plain = Recording {
                    flight,
                    rate,
                    event: Event::Pause,
                    ..PLAIN
                };
                let (poses, seconds, _) = recorded(plain, &mut Random(7));
                let clean = made(&poses, &seconds, rate, &TOLERANCE.into());
                let noisy = Recording { noise, ..plain };
                let (mut poses, seconds, _) = recorded(noisy, &mut Random(9));
                let mut random = Random(11);
                for pose in &mut poses {
                    let off = [0.0; 3].map(|_| 0.002 * (random.unit() - 0.5));
                    let turn = quaternion_from_view(pose.vpn.into(), pose.vup.into());
                    let turn = crate::math::quaternion::exp(off.into()) * turn;
                    let (view, up) = view_from_quaternion(turn);
                    (pose.vpn, pose.vup) = (view.to_array(), up.to_array());
                }
                let fitted = made(&poses, &seconds, rate, &TOLERANCE.into());
                let what = format!("{noisy:?}: {} {}", clean.report.points, fitted.report);
                assert!(fitted.report.points <= 2 * clean.report.points, "{what}");
                assert_eq!((clean.report.holds, fitted.report.holds), (1, 1), "{what}");
                let held = |fitted: &Fitted| {
                    let holds = fitted.path.points.iter();
                    f64::from(holds.map(|point| point.orientations[0].hold).max().unwrap())
                };
                let longer = (held(&fitted) - held(&clean)).abs() / rate;
                assert!(longer <= 0.15, "{what}: {longer} s");
            }
        }
    }
}

/// Where a motion slows down and goes back it does not rest.
#[test]
fn noise_makes_no_pause() {
    for rate in [30.0, 200.0, 800.0] {
        for noise in [Noise::None, Noise::Gaussian(0.001), Noise::Uniform(0.006)] {
            let what = Recording {
                flight: Flight::Reversal,
                rate,
                noise,
                ..PLAIN
            };
            let (poses, seconds, _) = recorded(what, &mut Random(5));
            let fitted = made(&poses, &seconds, rate, &TOLERANCE.into());
            assert_eq!(fitted.report.holds, 0, "{what:?}: {}", fitted.report);
        }
    }
}

/// A way forth and back of few directions has noise across it, too.
#[test]
fn reversals_in_noise_need_at_most_twice_the_points() {
    for rate in [30.0, 200.0, 800.0] {
        let plain = Recording {
            flight: Flight::Reversal,
            rate,
            ..PLAIN
        };
        let (poses, seconds, _) = recorded(plain, &mut Random(5));
        let clean = made(&poses, &seconds, rate, &TOLERANCE.into())
            .report
            .points;
        for noise in [Noise::Gaussian(0.001), Noise::Uniform(0.006)] {
            let (poses, seconds, _) = recorded(Recording { noise, ..plain }, &mut Random(6));
            let report = made(&poses, &seconds, rate, &TOLERANCE.into()).report;
            assert!(
                report.points <= 2 * clean,
                "{rate} {noise:?}: {clean} {report}"
            );
        }
    }
}

/// No path meets what is beyond the tolerance between its frames: then it is smooth, near the flight.
#[test]
fn more_poses_than_frames_average_their_noise() {
    for flight in [Flight::Hand, Flight::Line, Flight::EvenPan] {
        let noise = Noise::Gaussian(0.01);
        let what = Recording {
            flight,
            rate: 120.0,
            noise,
            ..PLAIN
        };
        let (poses, seconds, clean) = recorded(what, &mut Random(5));
        let fitted = made(&poses, &seconds, 25.0, &TOLERANCE.into());
        let [_, off] = from_clean(&fitted.path, &seconds, 25.0, &clean);
        let what = format!("{flight:?}: {off} {}", fitted.report);
        // Half of what the poses are off by.
        let near = off <= 0.5 * 0.01 * 3f64.sqrt();
        assert!(near && fitted.report.points <= 100, "{what}");
    }
}

/// A rest is as long as it was, though no point may rest so long.
#[test]
fn a_rest_has_any_length() {
    let hold = f64::from(MAX_HOLD);
    for frames in [hold - 1.0, hold, hold + 1.0, hold + 2.0, 3.5 * hold] {
        for moves in [false, true] {
            let step = |k: usize| {
                f64::from(u8::from(moves)) * 0.1 * (k.min(20) + k.saturating_sub(21)) as f64
            };
            let poses: Vec<Pose> = (0..40)
                .map(|k| turned([step(k), 0.0, 0.0], 0.2, 0.0))
                .collect();
            let when = |k: usize| k as f64 + if k > 20 { frames - 1.0 } else { 0.0 };
            let seconds: Vec<f64> = (0..40).map(when).collect();
            let fitted = made(&poses, &seconds, 1.0, &TOLERANCE.into());
            let count = Timeline::new(&fitted.path).unwrap().frame_count().unwrap();
            assert_eq!(count as f64, 39.0 + frames, "{frames} {moves}");
            let report = fitted.report;
            assert!(
                report.points < 20 && report.position.greatest < 0.01,
                "{report}"
            );
            assert!(report.lens.greatest < 1e-3, "{report}");
        }
    }
}

/// Where a cut lies between two frames, the path is on the other side at the next one.
#[test]
fn cuts_between_frames_meet_both_sides() {
    for flight in [Flight::Rotation, Flight::Hand] {
        for seed in 0..20 {
            let what = Recording {
                flight,
                jitter: 0.4,
                event: Event::Cut,
                ..PLAIN
            };
            let (poses, seconds, _) = recorded(what, &mut Random(seed));
            let report = made(&poses, &seconds, 30.0, &TOLERANCE.into()).report;
            assert_eq!(report.cuts, 1);
            assert!(
                report.position.greatest <= 0.01001,
                "{what:?} {seed}: {report}"
            );
        }
    }
}
