//! A recording as the fit takes it: its poses checked, its times in frames.

use glam::{DMat3, DVec3};

use super::time_unit::TimeUnit;
use super::{Data, Options, Sample};
use crate::error::{Error, Invalid, OutOfRange, Place, Result, TooMany, vec_with_room};
use crate::limits::{MAX_FPS, MAX_FRAMES};
use crate::math::orientation::quaternion_from_view;
use crate::math::quaternion::continue_sign;
use crate::path::camera_path::{check_coordinates, check_zoom};
use crate::path::{Pose, Space, Up};

/// Times that differ by less than this, in frames, are equal.
const EQUAL_FRAMES: f64 = 1e-4;

/// Rounded times are no farther off than this, in frames.
const ROUNDED: f64 = 0.1;

impl Data {
    pub(super) fn new(
        poses: &[Pose],
        seconds: Option<&[f64]>,
        fps: f64,
        options: &Options,
    ) -> Result<Self> {
        let tolerance = options.tolerance;
        if !(fps > 0.0 && fps <= MAX_FPS) {
            return Err(OutOfRange::Fps.into());
        }
        tolerance.check()?;
        if poses.len() < 2 {
            return Err(Invalid::TooFewPoses.into());
        }
        let unit = TimeUnit::of(seconds.unwrap_or_default())?;
        let rate = fps * unit.map_or(1.0, TimeUnit::seconds);
        check_times(seconds, poses.len(), rate)?;
        let up = options.space.map_or(options.up, |space| space.up);
        let mut times: Vec<f64> = vec_with_room(poses.len() + 1)?;
        let mut raw: Vec<Sample> = vec_with_room(poses.len() + 1)?;
        let mut numbers: Vec<usize> = vec_with_room(poses.len())?;
        for (k, pose) in poses.iter().enumerate() {
            let sample = sample(pose, up).map_err(|error| error.at(Place::Pose(k)))?;
            let time = seconds.map_or(k as f64, |seconds| {
                snapped((seconds[k] - seconds[0]) * rate)
            });
            if let Some(before) = times.last()
                && time - before < EQUAL_FRAMES
            {
                continue;
            }
            let before = raw.last().map_or(sample.turn, |before| before.turn);
            times.push(time);
            numbers.push(k);
            raw.push(Sample {
                turn: continue_sign(before, sample.turn).0,
                ..sample
            });
        }
        let space = match options.space {
            Some(space) => space,
            None => space_of(&raw, up)?,
        };
        space.check()?;
        let mut left_out = vec_with_room(raw.len() + 1)?;
        left_out.resize(raw.len(), false);
        let mut data = Self {
            times,
            raw,
            numbers,
            unit,
            left_out,
            calm: Vec::new(),
            cuts: Vec::new(),
            gaps: 0,
            tolerance: tolerance.position,
            angle: tolerance.angle.to_radians(),
            near: [f64::INFINITY; 2],
            fps,
            space,
        };
        data.end_at_a_frame(rounding(seconds.unwrap_or_default(), fps, rate));
        Ok(data)
    }

    /// Poses of the recording at distinct times.
    pub(super) const fn poses(&self) -> usize {
        self.numbers.len()
    }

    /// The poses that a robust fit left out.
    pub(super) fn outliers(&self) -> impl Iterator<Item = usize> + Clone {
        let out = |(number, out): (&usize, &bool)| out.then_some(*number);
        self.numbers.iter().zip(&self.left_out).filter_map(out)
    }

    /// A recording that ends between frames goes on to the next one, as fast as in its last frame;
    /// one whose last time is a frame's but for rounding ends at it.
    fn end_at_a_frame(&mut self, rounding: f64) {
        let last = self.times.len() - 1;
        let (time, end) = (self.times[last], self.raw[last]);
        let begun = time.floor();
        if time - begun <= rounding && (last == 0 || begun > self.times[last - 1]) {
            self.times[last] = begun;
            return;
        }
        let whole = time.ceil();
        let before = self.times.partition_point(|before| *before <= time - 1.0);
        let before = before.saturating_sub(1).min(last.saturating_sub(1));
        let from = self.raw[before];
        let share = (whole - time) / (time - self.times[before]).max(f64::MIN_POSITIVE);
        let ahead = if last > 0 { share } else { 0.0 };
        self.times.push(whole);
        self.left_out.push(true);
        self.raw.push(Sample {
            position: end.position + (end.position - from.position) * ahead,
            turn: end.turn.lerp(end.turn * 2.0 - from.turn, ahead).normalize(),
            zoom: end.zoom,
        });
    }
}

/// Finite, one for each pose, none before the one before; and not too long: what follows goes
/// through all frames.
fn check_times(seconds: Option<&[f64]>, poses: usize, fps: f64) -> Result<()> {
    let span = match seconds {
        None => poses as f64 - 1.0,
        Some(seconds) => {
            if seconds.len() != poses {
                return Err(Invalid::PoseTimes.into());
            }
            // NaN is not in order either.
            let backwards = seconds
                .windows(2)
                .position(|pair| !(pair[1] >= pair[0]))
                .map(|k| k + 1);
            if let Some(at) = backwards {
                return Err(Error::from(Invalid::PoseTimes).at(Place::Pose(at)));
            }
            (seconds[poses - 1] - seconds[0]) * fps
        }
    };
    if !(span < MAX_FRAMES as f64) {
        return Err(TooMany::PoseSpan(span).into());
    }
    Ok(())
}

/// By how many frames the last of times with three to six decimals may be off; 0 if they have more.
fn rounding(times: &[f64], fps: f64, rate: f64) -> f64 {
    let off = (3..=6).find_map(|decimals| {
        let scale = 10f64.powi(decimals);
        let whole = |time: &f64| {
            let digits = time * rate / fps * scale;
            (digits - digits.round()).abs() <= 1e-15 * digits.abs() + 1e-6
        };
        times.iter().all(whole).then_some(fps / scale)
    });
    off.unwrap_or(0.0).min(ROUNDED)
}

/// A time that is nearly a whole frame is one.
fn snapped(time: f64) -> f64 {
    let whole = time.round();
    if (time - whole).abs() < EQUAL_FRAMES {
        whole
    } else {
        time
    }
}

/// The smallest space round the positions, with a tenth to spare; where they are one, a cube of
/// size 2 round it.
fn space_of(samples: &[Sample], up: Up) -> Result<Space> {
    let places = || samples.iter().map(|sample| sample.position);
    let first = samples[0].position;
    if places().any(|place| place != first) {
        return Space::around(places(), up);
    }
    let centre = first;
    Ok(Space {
        centre,
        up,
        ..Space::default()
    })
}

/// A pose as a sample: finite, its view and up made to stand at right angles and in y-up axes.
fn sample(pose: &Pose, axes: Up) -> Result<Sample> {
    let [position, view, up] = [pose.vrp, pose.vpn, pose.vup].map(DVec3::from_array);
    for v in [position, view, up] {
        check_coordinates(v)?;
    }
    check_zoom(pose.zoom)?;
    let unit = |v: DVec3| axes.upright(v).try_normalize();
    let (Some(view), Some(up)) = (unit(view), unit(up)) else {
        return Err(Invalid::LookZero.into());
    };
    let Some(side) = up.cross(view).try_normalize() else {
        return Err(Invalid::UpParallel.into());
    };
    let up = DMat3::from_cols(side, view.cross(side), view).y_axis;
    Ok(Sample {
        position,
        turn: quaternion_from_view(view, up),
        zoom: pose.zoom,
    })
}
