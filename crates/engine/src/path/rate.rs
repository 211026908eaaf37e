//! A path brought to another frame rate: every key keeps its second.

use super::base_frames::check_base_frames;
use super::camera_path::CameraPath;
use super::own::OrientationOverrides;
use super::timeline::{Change, Timeline};
use crate::error::Result;

/// The path at `ratio` times as many frames a second; the timeline is that of `path`.
///
/// Frames and holds that are set are rounded so that each key stays within half a frame of its
/// second, and the last pose rests until the path ends. Sections that go by length do so at base
/// speeds of `ratio` times as many frames; rates and curve times follow.
///
/// # Errors
/// [`crate::Error::Range`] or [`crate::Error::Argument`] where something is then beyond its limits,
/// [`crate::Error::Memory`].
pub fn at_rate(path: &CameraPath, timeline: &Timeline, ratio: f64) -> Result<CameraPath> {
    let mut made = path.try_clone()?;
    let base = &mut made.base_frames;
    for frames in [
        &mut base.movement,
        &mut base.turning,
        &mut base.zoom,
        &mut base.rolling,
    ] {
        *frames *= ratio;
    }
    check_base_frames(made.base_frames)?;
    for point in &mut made.points {
        for orientation in &mut point.orientations {
            if !orientation.own.is_empty() {
                orientation.own = orientation.own.with(|own| scale_rates(own, ratio))?;
            }
        }
    }
    let by_length = Timeline::new(&made)?;
    let at = |frames: usize| (frames as f64 * ratio).round() as usize;
    let (mut old, mut new) = (0, 0);
    for number in 0..timeline.section_count() {
        let section = timeline.section(number);
        let orientation = &mut made.points[section.point].orientations[section.orientation];
        let hold = orientation.hold as usize;
        if section.change == Change::Nothing {
            orientation.hold = at(hold) as u32;
            continue;
        }
        let rest = at(old + hold).saturating_sub(new);
        orientation.hold = rest as u32;
        (old, new) = (old + hold + section.frames, new + rest);
        new += if orientation.own.frames == 0 {
            by_length.section(number).frames
        } else {
            let frames = at(old).saturating_sub(new).max(1);
            orientation.own = orientation.own.with(|own| own.frames = frames as u32)?;
            frames
        };
    }
    if !path.closed
        && let Some(end) = made.points.last_mut()
        && let Some(end) = end.orientations.last_mut()
    {
        end.hold = at(timeline.frame_count()?).saturating_sub(1 + new) as u32;
    }
    made.check()?;
    Ok(made)
}

/// What counts by frames at speed 50.
fn scale_rates(own: &mut OrientationOverrides, ratio: f64) {
    if let Some(time) = &mut own.curve_time {
        *time *= ratio;
    }
    if let Some(velocities) = &mut own.velocities {
        velocities.reach /= ratio;
        velocities.leave /= ratio;
    }
    for slope in [&mut own.roll_slope, &mut own.zoom_slope]
        .into_iter()
        .flatten()
    {
        *slope /= ratio;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::path::Sampler;
    use crate::path::fit_frames::fit_frames;
    use crate::path::insertion::tests::random_path;
    use crate::path::test_support::Random;

    fn poses(path: &CameraPath) -> Vec<[f64; 10]> {
        let sampler = Sampler::new(path, &Timeline::new(path).unwrap()).unwrap();
        let numbers = |pose: crate::path::Pose| {
            let all = [pose.vrp, pose.vpn, pose.vup].concat();
            std::array::from_fn(|k| if k < 9 { all[k] } else { pose.zoom })
        };
        sampler.iter().map(|pose| numbers(pose.unwrap())).collect()
    }

    /// Twice the rate has each pose at its second, and the way back is the path of before.
    #[test]
    fn twice_the_rate_is_the_same_flight() {
        let mut random = Random(71);
        for round in 0..300 {
            let mut path = random_path(&mut random, round);
            let timeline = Timeline::new(&path).unwrap();
            let last = path.points.len() - 1;
            for fixed in fit_frames(&path, &timeline, 0, last, 400).unwrap() {
                fixed.apply(&mut path).unwrap();
            }
            let timeline = Timeline::new(&path).unwrap();
            let fine = at_rate(&path, &timeline, 2.0).unwrap();
            let (a, b) = (poses(&path), poses(&fine));
            assert_eq!(b.len(), 2 * a.len() - usize::from(path.closed));
            for (k, pose) in a.iter().enumerate() {
                let far = pose.iter().zip(b[2 * k]).map(|(a, b)| (a - b).abs());
                assert!(far.fold(0.0, f64::max) < 1e-9, "round {round}, pose {k}");
            }
            let back = at_rate(&fine, &Timeline::new(&fine).unwrap(), 0.5).unwrap();
            assert_eq!(poses(&back), a, "round {round}");
        }
    }

    /// 24 to 25 and 25 to 29.97: keys stay within half a frame of their seconds.
    #[test]
    fn keys_keep_their_seconds() {
        let mut random = Random(72);
        for round in 0..300 {
            let mut path = random_path(&mut random, round);
            let timeline = Timeline::new(&path).unwrap();
            let last = path.points.len() - 1;
            for fixed in fit_frames(&path, &timeline, 0, last, 500).unwrap() {
                fixed.apply(&mut path).unwrap();
            }
            for (from, to) in [(24.0, 25.0), (25.0, 30_000.0 / 1001.0), (60.0, 24.0)] {
                let before = Timeline::new(&path).unwrap();
                // A section has a frame at least.
                if before.moving().any(|k| before.section(k).frames < 4) {
                    continue;
                }
                let made = at_rate(&path, &before, to / from).unwrap();
                let after = Timeline::new(&made).unwrap();
                let samplers = [
                    Sampler::new(&path, &before).unwrap(),
                    Sampler::new(&made, &after).unwrap(),
                ];
                for section in before.moving() {
                    let [a, b] = samplers
                        .each_ref()
                        .map(|all| all.first_frame(section) as f64 - 2.0);
                    assert!(
                        (b / to - a / from).abs() <= 0.5001 / to,
                        "round {round}: {a} {b}"
                    );
                }
                let [a, b] = samplers.map(|all| all.frame_count() as f64);
                let end = if path.closed { 1.0 } else { 0.0 };
                // At a lower rate one pose lasts longer than the end of the path.
                let most = if to < from { 1.5 } else { 0.5001 };
                assert!(((b - end) / to - (a - end) / from).abs() <= most / to);
            }
        }
    }
}
