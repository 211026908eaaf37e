//! Recordings as devices make them: at any rate, with jitter, noise, pauses, gaps, cuts, outliers.

use super::super::*;
use super::{TOLERANCE, eased, turned, waves};
use crate::path::test_support::Random;
use crate::path::{Sampler, Timeline};

/// What is recorded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Flight {
    /// Carried by hand.
    Hand,
    Line,
    Rotation,
    Translation,
    /// Forth and back with stops.
    Reversal,
    /// An even pan on an eased way.
    EvenPan,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Noise {
    None,
    /// Its standard deviation.
    Gaussian(f64),
    /// Its greatest deviation.
    Uniform(f64),
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Event {
    None,
    Pause,
    Gap,
    Cut,
    Outliers,
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Recording {
    pub(super) flight: Flight,
    /// Poses a second.
    pub(super) rate: f64,
    /// Greatest deviation of a time, in steps.
    pub(super) jitter: f64,
    /// Share of poses lost.
    pub(super) drops: f64,
    pub(super) noise: Noise,
    pub(super) event: Event,
}

pub(super) const PLAIN: Recording = Recording {
    flight: Flight::Hand,
    rate: 30.0,
    jitter: 0.0,
    drops: 0.0,
    noise: Noise::None,
    event: Event::None,
};

const SECONDS: f64 = 20.0;

fn pose(flight: Flight, t: f64) -> Pose {
    let wave = |size: f64, number: f64| waves(size, number, t)[0];
    match flight {
        Flight::Hand => turned(
            [wave(2.5, 1.0), wave(0.6, 2.0), wave(2.5, 3.0)],
            wave(1.2, 4.0),
            wave(0.3, 5.0),
        ),
        Flight::Line => turned([0.3 * t, 0.1 * t, 0.0], 0.4, 0.1),
        Flight::Rotation => turned([1.0, 2.0, 3.0], wave(1.2, 4.0), wave(0.3, 5.0)),
        Flight::Translation => turned([wave(2.5, 1.0), wave(0.6, 2.0), wave(2.5, 3.0)], 0.4, 0.1),
        Flight::Reversal => turned([2.0 * (0.5 * t).sin(), 0.0, 0.0], 0.05 * t, 0.0),
        Flight::EvenPan => turned([2.0 * eased(t / SECONDS)[0], 0.0, 0.0], 0.05 * t, 0.0),
    }
}

/// Poses, seconds, and the clean poses at these.
pub(super) fn recorded(what: Recording, random: &mut Random) -> (Vec<Pose>, Vec<f64>, Vec<Pose>) {
    let (mut poses, mut seconds, mut clean) = (Vec::new(), Vec::new(), Vec::new());
    let mut signed = || 2.0 * random.unit() - 1.0;
    for k in 0..=(SECONDS * what.rate) as usize {
        let when = (k as f64 + 0.5 * what.jitter * signed()) / what.rate;
        let lost = 0.5 * (signed() + 1.0) < what.drops;
        if k > 0 && (lost || what.event == Event::Gap && (8.0..8.5).contains(&when)) {
            continue;
        }
        let moved = match what.event {
            Event::Pause if when > 8.0 => 8.0 + (when - 9.0).max(0.0),
            _ => when,
        };
        let mut at = pose(what.flight, moved);
        if what.event == Event::Cut && when >= 9.0 {
            at.vrp[0] += 5.0;
        }
        clean.push(at);
        let mut off = || match what.noise {
            Noise::None => 0.0,
            Noise::Gaussian(deviation) => deviation * (0..12).map(|_| signed()).sum::<f64>() / 2.0,
            Noise::Uniform(most) => most / 3f64.sqrt() * signed(),
        };
        at.vrp = at.vrp.map(|x| x + off());
        if what.event == Event::Outliers && k % 97 == 50 {
            at.vrp[1] += 0.7;
        }
        poses.push(at);
        seconds.push(when);
    }
    (poses, seconds, clean)
}

pub(super) fn made(poses: &[Pose], seconds: &[f64], fps: f64, options: &Options) -> Fitted {
    fit(poses, Some(seconds), fps, options, &mut |_, _| true).unwrap()
}

/// Greatest and root mean square distance from the clean flight.
pub(super) fn from_clean(path: &CameraPath, seconds: &[f64], fps: f64, clean: &[Pose]) -> [f64; 2] {
    let sampler = Sampler::new(path, &Timeline::new(path).unwrap()).unwrap();
    let (mut most, mut sum) = (0.0_f64, 0.0);
    for (when, pose) in seconds.iter().zip(clean) {
        let at = sampler.pose(1.0 + (when - seconds[0]) * fps).unwrap();
        let off = DVec3::from(at.vrp).distance(pose.vrp.into());
        most = most.max(off);
        sum += off * off;
    }
    [most, (sum / clean.len() as f64).sqrt()]
}

#[test]
fn each_kind_of_recording_becomes_a_path() {
    let noises = [
        Noise::None,
        Noise::Gaussian(0.002),
        Noise::Uniform(0.0088),
        Noise::Gaussian(0.02),
    ];
    let flights = [
        Flight::Hand,
        Flight::Line,
        Flight::Rotation,
        Flight::Translation,
        Flight::Reversal,
        Flight::EvenPan,
    ];
    let mut all = Vec::new();
    for flight in flights {
        all.extend(noises.map(|noise| Recording {
            flight,
            noise,
            ..PLAIN
        }));
    }
    for rate in [10.0, 24.3, 60.0, 200.0, 1000.0] {
        for noise in [Noise::None, Noise::Uniform(0.0088)] {
            all.push(Recording {
                rate,
                noise,
                ..PLAIN
            });
            let (jitter, drops) = (0.5, 0.1);
            all.push(Recording {
                rate,
                noise,
                jitter,
                drops,
                ..PLAIN
            });
        }
    }
    for event in [Event::Pause, Event::Gap, Event::Cut, Event::Outliers] {
        all.extend(noises.map(|noise| Recording {
            event,
            noise,
            ..PLAIN
        }));
    }
    let mut random = Random(51);
    for what in all {
        let (poses, seconds, clean) = recorded(what, &mut random);
        let fps = what.rate.min(30.0);
        let fitted = made(&poses, &seconds, fps, &TOLERANCE.into());
        let report = &fitted.report;
        let [most, _] = from_clean(&fitted.path, &seconds, fps, &clean);
        let quiet = what.noise != Noise::Gaussian(0.02);
        let steady = matches!(what.event, Event::None | Event::Pause | Event::Gap);
        assert!(
            !(quiet && steady) || most <= 2.0 * TOLERANCE.position,
            "{what:?}: {most}"
        );
        assert!(report.points <= poses.len());
    }
}

/// Four thousand frames with noise of a little less than the tolerance.
#[test]
fn noise_below_the_tolerance_costs_few_points() {
    for flight in [
        Flight::Hand,
        Flight::Rotation,
        Flight::Translation,
        Flight::Line,
    ] {
        for rate in [30.0, 200.0] {
            let plain = Recording {
                flight,
                rate,
                ..PLAIN
            };
            let (poses, seconds, _) = recorded(plain, &mut Random(7));
            let clean = made(&poses, &seconds, 30.0, &TOLERANCE.into())
                .report
                .points;
            for most in [0.003, 0.006, 0.0088, 0.0097] {
                let noise = Noise::Uniform(most);
                let (poses, seconds, _) = recorded(Recording { noise, ..plain }, &mut Random(9));
                let fitted = made(&poses, &seconds, 30.0, &TOLERANCE.into());
                assert!(
                    fitted.report.points <= 2 * clean && fitted.report.position.greatest <= 0.01001,
                    "{flight:?} {rate} {most}: {clean} {}",
                    fitted.report
                );
            }
        }
    }
}

#[test]
fn a_larger_tolerance_gives_no_more_points() {
    for outlier in [0.0, 0.7, 2.0] {
        for flight in [Flight::Hand, Flight::Reversal, Flight::EvenPan] {
            let what = Recording {
                flight,
                rate: 10.0,
                ..PLAIN
            };
            let (mut poses, seconds, _) = recorded(what, &mut Random(3));
            poses[100].vrp[1] += outlier;
            let points: Vec<usize> = [0.001, 0.003, 0.01, 0.03, 0.05, 0.1, 0.3, 0.6, 1.0, 3.0]
                .iter()
                .map(|position| {
                    let tolerance = Tolerance {
                        position: *position,
                        ..TOLERANCE
                    };
                    made(&poses, &seconds, 10.0, &tolerance.into())
                        .report
                        .points
                })
                .collect();
            for pair in points.windows(2) {
                assert!(
                    pair[1] as f64 <= 1.1 * pair[0] as f64 + 1.0,
                    "{flight:?} {outlier}: {points:?}"
                );
            }
        }
    }
}

/// A pause of a few equal poses is a hold, exactly as long.
#[test]
fn pauses_become_holds() {
    for (count, from) in [(26, 10), (40, 3), (60, 30)] {
        for equal in 2..16 {
            let pose = |k: usize| {
                let t = (k.min(from) + k.saturating_sub(from + equal - 1)) as f64 / 25.0;
                turned([2.0 * t, (3.0 * t).sin(), 0.0], t, 0.1 * t)
            };
            let poses: Vec<Pose> = (0..count).map(pose).collect();
            let fitted = fit(&poses, None, 25.0, &TOLERANCE.into(), &mut |_, _| true).unwrap();
            let report = &fitted.report;
            assert!(report.position.greatest <= 0.01001 && report.view.greatest <= 0.5005);
            assert_eq!(report.holds, usize::from(equal >= 5), "{equal}");
            if equal >= 5 {
                let held = |point: &SupportPoint| point.orientations[0].hold as usize;
                assert_eq!(fitted.path.points.iter().map(held).max(), Some(equal - 1));
            }
        }
    }
}

#[test]
fn times_of_few_digits_have_as_many_frames_as_poses() {
    for (fps, digit) in [(30.0, 1e-4), (30.0, 1e-3), (60.0, 1e-3), (29.97, 1e-4)] {
        for count in 50..70 {
            let rounded = |k: i32| (f64::from(k) / fps / digit).round() * digit;
            let seconds: Vec<f64> = (0..count).map(rounded).collect();
            let poses: Vec<Pose> = seconds
                .iter()
                .map(|when| turned([*when, 0.0, 0.0], 0.3, 0.0))
                .collect();
            let fitted = made(&poses, &seconds, fps, &TOLERANCE.into());
            let frames = Timeline::new(&fitted.path).unwrap().frame_count().unwrap();
            assert_eq!(frames as i32, count, "{fps} {digit}");
        }
    }
}

#[test]
fn a_line_may_end_between_frames() {
    for last in [20.3, 20.5, 20.7, 20.01, 0.3, 1.6] {
        let count = 21;
        let seconds: Vec<f64> = (0..count)
            .map(|k| 5.0 + f64::from(k) / f64::from(count - 1) * last / 25.0)
            .collect();
        let line = |when: &f64| turned([3.0 * (when - 5.0), 0.5 * when, 0.0], 0.3, 0.0);
        let poses: Vec<Pose> = seconds.iter().map(line).collect();
        let fitted = made(&poses, &seconds, 25.0, &TOLERANCE.into());
        let frames = Timeline::new(&fitted.path).unwrap().frame_count().unwrap();
        assert_eq!(frames as f64, 1.0 + last.ceil());
        assert_eq!(fitted.report.points, 2);
        assert!(
            fitted.report.position.greatest < 1e-3,
            "{:?}",
            fitted.report
        );
    }
}

#[test]
fn of_poses_at_equal_times_the_first_counts() {
    let (mut poses, mut seconds, _) = recorded(PLAIN, &mut Random(1));
    for k in [5, 40, 41, 500] {
        seconds.insert(k + 1, seconds[k]);
        let mut other = poses[k];
        other.vrp[0] += 9.0;
        poses.insert(k + 1, other);
    }
    let fitted = made(&poses, &seconds, 30.0, &TOLERANCE.into());
    assert_eq!((fitted.report.dropped, fitted.report.poses), (4, 605));
    assert!(fitted.report.position.greatest <= 0.01001 && fitted.report.points < 80);
}

/// Two poses, equal ones, some far from each other in time: each becomes a path of no more points
/// than poses.
#[test]
fn few_poses_are_enough() {
    let at = |k: usize| pose(Flight::Hand, 0.7 * k as f64);
    let poses: Vec<Pose> = (0..32).map(at).collect();
    let seconds: Vec<f64> = (0..32).map(|k| 0.7 * f64::from(k)).collect();
    for count in 2..32 {
        for fps in [25.0, 23.7] {
            let fitted = made(&poses[..count], &seconds[..count], fps, &TOLERANCE.into());
            assert!(fitted.report.points <= count);
        }
        let still = vec![poses[0]; count];
        let fitted = made(&still, &seconds[..count], 10.0, &TOLERANCE.into());
        let frames = Timeline::new(&fitted.path).unwrap().frame_count().unwrap();
        assert_eq!((fitted.report.points, frames), (2, 7 * (count - 1) + 1));
        let at_once = made(&poses[..count], &vec![3.0; count], 25.0, &TOLERANCE.into());
        assert_eq!(
            (at_once.report.points, at_once.report.dropped),
            (2, count - 1)
        );
    }
}

#[test]
fn even_turning_on_an_eased_way_needs_few_points() {
    for count in [40, 60, 100, 240] {
        let share = |k: i32| f64::from(k) / f64::from(count - 1);
        let pans: Vec<Pose> = (0..count)
            .map(|k| turned([2.0 * eased(share(k))[0], 0.0, 0.0], share(k), 0.0))
            .collect();
        let moves: Vec<Pose> = (0..count)
            .map(|k| turned([2.0 * share(k), 0.0, 0.0], eased(share(k))[0], 0.0))
            .collect();
        for (what, poses) in [("pan", pans), ("move", moves)] {
            for angle in [0.1, 0.5, 2.0, 30.0] {
                let tolerance = Tolerance { angle, ..TOLERANCE };
                let fitted = fit(&poses, None, 25.0, &tolerance.into(), &mut |_, _| true).unwrap();
                let points = fitted.report.points;
                assert!(
                    2 * points <= poses.len(),
                    "{what} {count} {angle}: {points}"
                );
            }
        }
    }
}

#[test]
fn stamps_may_count_nanoseconds_or_microseconds() {
    for rate in [4.0, 30.0, 200.0] {
        let (poses, seconds, _) = recorded(Recording { rate, ..PLAIN }, &mut Random(2));
        let plain = made(&poses, &seconds, 25.0, &TOLERANCE.into());
        assert_eq!(plain.report.unit, None);
        for (unit, epoch) in [
            (TimeUnit::Nanoseconds, 1.7e9),
            (TimeUnit::Microseconds, 1.7e9),
            (TimeUnit::Nanoseconds, 4000.0),
        ] {
            let stamp = |when: &f64| ((when + epoch) / unit.seconds()).round();
            let stamps: Vec<f64> = seconds.iter().map(stamp).collect();
            let fitted = made(&poses, &stamps, 25.0, &TOLERANCE.into());
            assert_eq!(fitted.report.unit, Some(unit), "{rate} {epoch}");
            let points = plain.report.points;
            assert!(fitted.report.points.abs_diff(points) <= 2 + points / 10);
        }
    }
}

#[test]
fn numbers_beyond_all_measure_are_refused_by_a_sentence() {
    let (poses, _, _) = recorded(PLAIN, &mut Random(2));
    for bad in [1e300, f64::NAN, f64::INFINITY, -1e308] {
        for part in 0..4 {
            let mut poses = poses.clone();
            match part {
                0 => poses[7].vrp[1] = bad,
                1 => poses[7].vpn[0] = bad,
                2 => poses[7].vup[2] = bad,
                _ => poses[7].zoom = bad,
            }
            let made = fit(&poses, None, 25.0, &TOLERANCE.into(), &mut |_, _| true);
            // A direction may be of any length.
            if let Err(error) = made {
                assert!(error.to_string().starts_with("pose 8: "), "{error}");
            } else {
                assert!((1..3).contains(&part) && bad.is_finite());
            }
        }
        let mut seconds: Vec<f64> = (0..poses.len()).map(|k| k as f64).collect();
        seconds[poses.len() - 1] = bad;
        let made = fit(
            &poses,
            Some(&seconds),
            25.0,
            &TOLERANCE.into(),
            &mut |_, _| true,
        );
        assert!(made.is_err(), "{bad}");
    }
}

/// How far from the chord of a gap a curve goes at most.
fn from_chord(ends: [DVec3; 2], at: impl Fn(f64) -> DVec3) -> f64 {
    let along = (ends[1] - ends[0]).normalize();
    let off = |k: i32| {
        let from = at(f64::from(k) / 100.0) - ends[0];
        (from - along * from.dot(along).clamp(0.0, ends[0].distance(ends[1]))).length()
    };
    (0..=100).map(off).fold(0.0, f64::max)
}

#[test]
fn gaps_are_crossed_as_a_clean_flight_crosses_them() {
    let noises = [
        Noise::None,
        Noise::Gaussian(0.002),
        Noise::Uniform(0.0088),
        Noise::Gaussian(0.02),
    ];
    for flight in [Flight::Hand, Flight::Translation, Flight::Reversal] {
        for noise in noises {
            let what = Recording {
                flight,
                noise,
                event: Event::Gap,
                ..PLAIN
            };
            let (poses, seconds, clean) = recorded(what, &mut Random(4));
            let fitted = made(&poses, &seconds, 30.0, &TOLERANCE.into());
            let after = seconds.iter().position(|when| *when > 8.2).unwrap();
            let ends = [after - 1, after].map(|k| DVec3::from(clean[k].vrp));
            let places: Vec<[f64; 3]> = clean.iter().map(|pose| pose.vrp).collect();
            let spline = crate::tools::smooth::Spline::near(
                &seconds,
                &places,
                &vec![0.0; places.len()],
                0.0,
                false,
                &mut || Ok(()),
            )
            .unwrap();
            let when =
                |share: f64| seconds[after - 1] + share * (seconds[after] - seconds[after - 1]);
            let interpolant =
                from_chord(ends, |share| DVec3::from_array(spline.at(when(share))[0]));
            let sampler =
                Sampler::new(&fitted.path, &Timeline::new(&fitted.path).unwrap()).unwrap();
            let path = from_chord(ends, |share| {
                sampler.pose(1.0 + when(share) * 30.0).unwrap().position()
            });
            assert_eq!((fitted.report.gaps, fitted.report.cuts), (1, 0));
            let most = match noise {
                // Beyond the tolerance it is met, not crossed.
                Noise::Gaussian(deviation) if deviation > 0.01 => 6.0 * deviation,
                _ => TOLERANCE.position,
            };
            assert!(
                path <= 1.2 * interpolant + most,
                "{flight:?} {noise:?}: {path} beside {interpolant}"
            );
        }
    }
}

#[test]
fn cuts_meet_both_sides() {
    for flight in [Flight::Hand, Flight::Translation, Flight::Rotation] {
        for rate in [10.0, 30.0, 120.0] {
            for noise in [Noise::None, Noise::Gaussian(0.002)] {
                let what = Recording {
                    flight,
                    noise,
                    rate,
                    event: Event::Cut,
                    ..PLAIN
                };
                let (poses, seconds, clean) = recorded(what, &mut Random(4));
                let fps = 30.0;
                let fitted = made(&poses, &seconds, fps, &TOLERANCE.into());
                let plain = Recording {
                    event: Event::None,
                    ..what
                };
                let (plain, times, _) = recorded(plain, &mut Random(4));
                let plain = made(&plain, &times, fps, &TOLERANCE.into());
                let sampler =
                    Sampler::new(&fitted.path, &Timeline::new(&fitted.path).unwrap()).unwrap();
                let cut = 9.0;
                let mut off: f64 = 0.0;
                for k in 0..2400 {
                    let when = f64::from(k) / 120.0;
                    if when > cut - 1.0 / rate - 1.0 / fps && when < cut + 1.0 / fps {
                        continue;
                    }
                    let mut at = DVec3::from(pose(flight, when).vrp);
                    if when >= cut {
                        at.x += 5.0;
                    }
                    off = off.max(
                        sampler
                            .pose(1.0 + when * fps)
                            .unwrap()
                            .position()
                            .distance(at),
                    );
                }
                let [off_all, _] = from_clean(&fitted.path, &seconds, fps, &clean);
                assert!(
                    rate > fps || off_all < 0.0101,
                    "{flight:?} {rate} {off_all}"
                );
                assert!(off < 0.0101, "{flight:?} {rate} {noise:?}: {off}");
                assert_eq!((fitted.report.gaps, fitted.report.cuts), (0, 1));
                if noise == Noise::None {
                    let [with, without] = [&fitted, &plain].map(|made| made.report.points);
                    assert!(with <= without + 4, "{flight:?} {rate}: {with} {without}");
                }
            }
        }
    }
}

/// What to do about a point a pose is said, and is true.
#[test]
fn a_report_names_a_better_tolerance() {
    let noise = Noise::Gaussian(0.02);
    let (poses, seconds, _) = recorded(Recording { noise, ..PLAIN }, &mut Random(6));
    let fitted = made(&poses, &seconds, 30.0, &TOLERANCE.into());
    let (tolerance, points) = fitted.report.better.unwrap();
    assert!(
        (fitted.report.noise / 0.02 - 1.0).abs() < 0.2,
        "{}",
        fitted.report.noise
    );
    assert!(2 * points <= fitted.report.points);
    let again = made(&poses, &seconds, 30.0, &tolerance.into());
    assert_eq!(again.report.points, points);
    assert!(again.report.better.is_none());
    let told = fitted.report.to_string();
    assert!(
        told.contains("noise of about 2") && told.ends_with(&format!("gives {points} points")),
        "{told}"
    );
    let (poses, seconds, _) = recorded(PLAIN, &mut Random(6));
    let told = made(&poses, &seconds, 30.0, &TOLERANCE.into())
        .report
        .to_string();
    assert!(
        !told.contains("noise") && told.lines().count() == 1,
        "{told}"
    );
}

/// A few outliers that cost most of the points are named, with the points of a fit without them; and
/// the deviations of the poses are those of the report.
#[test]
fn a_report_names_outliers_that_cost_points() {
    let (mut poses, seconds, _) = recorded(PLAIN, &mut Random(6));
    let clean = made(&poses, &seconds, 30.0, &TOLERANCE.into());
    assert_eq!(clean.report.robust, None);
    let outliers: Vec<usize> = (1..8).map(|k| k * poses.len() / 9).collect();
    for &at in &outliers {
        poses[at].vrp[1] += 50.0 * TOLERANCE.position;
    }
    let fitted = made(&poses, &seconds, 30.0, &TOLERANCE.into());
    let (left_out, points) = fitted.report.robust.unwrap();
    assert_eq!(left_out, outliers.len());
    let options = Options {
        robust: true,
        ..TOLERANCE.into()
    };
    let again = made(&poses, &seconds, 30.0, &options);
    assert_eq!((&again.left_out, again.report.points), (&outliers, points));
    assert!(3 * points <= 2 * fitted.report.points && again.report.robust.is_none());
    let told = fitted.report.to_string();
    assert!(
        told.contains(&format!("leaves out so many and gives {points} points")),
        "{told}"
    );
    let most = |of: fn(&PoseDeviation) -> f64| again.deviations.iter().map(of).fold(0.0, f64::max);
    assert_eq!(again.deviations.len(), poses.len() - outliers.len());
    assert_eq!(most(|off| off.position), again.report.position.greatest);
    let turned = again.report.view.greatest.max(again.report.lens.greatest);
    assert_eq!(most(|off| off.angle), turned);
}

/// As many points as one asks for, and no tolerance that needs much less would do.
#[test]
fn so_many_points() {
    let (poses, seconds, _) = recorded(PLAIN, &mut Random(8));
    for wanted in [5, 12, 40, 100] {
        let choice = TOLERANCE.into();
        let go_on = &mut |_, _| true;
        let (made, tolerance) =
            fit_points(&poses, Some(&seconds), 30.0, &choice, wanted, go_on).unwrap();
        assert!(made.path.points.len() <= wanted);
        assert!(made.report.position.greatest <= 1.01 * tolerance.position);
        let half = Tolerance {
            position: 0.5 * tolerance.position,
            angle: 0.5 * tolerance.angle,
        };
        let half = fit(&poses, Some(&seconds), 30.0, &half.into(), go_on).unwrap();
        assert!(half.path.points.len() > wanted, "{wanted}");
    }
    let refused = fit_points(
        &poses,
        Some(&seconds),
        30.0,
        &TOLERANCE.into(),
        1,
        &mut |_, _| true,
    );
    assert!(
        refused
            .unwrap_err()
            .to_string()
            .starts_with("no path of so few points")
    );
}
