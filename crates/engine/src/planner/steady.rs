//! Stabilises a recorded flight: its poses pass a low-pass filter without lag, then become a path
//! of few points again.
//!
//! The low pass is the smoothing spline (C. Reinsch, *Smoothing by spline functions*, 1967): of a
//! wave with a period of T frames it leaves 1/(1 + (T₀/T)⁴), as a Butterworth filter of second order
//! that runs there and back, but it needs nothing beyond the ends and keeps what is even.
//! Rotations are unrolled: the turns from pose to pose of the smooth motion, one added to the
//! other, and at each pose what is left to turn to it, are vectors that can be smoothed as places are.

use glam::{DQuat, DVec3};

use crate::error::{Invalid, OutOfRange, Result, TooMany, vec_with_room};
use crate::limits::{MAX_FPS, MAX_SAMPLED_FRAMES, MAX_ZOOM, MIN_ZOOM};
use crate::math::orientation::{quaternion_from_view, roll_from_up, view_from_quaternion};
use crate::math::quaternion::{angle, continue_sign, exp, log};
use crate::path::{CameraPath, Pose, Sampler, Target, Timeline};
use crate::tools::fit::{Options, Progress, Tolerance, fit};
use crate::tools::smooth::Spline;

/// The most frames of a low pass: with twice as many its rounding is 16 times as large.
pub const MOST_FRAMES: f64 = 2000.0;

/// Rounds in which rotations are unrolled along what the last one found.
const UNROLLED: usize = 4;

/// The share of what was taken out that the new path may miss; and the least and the most, in shares
/// of the way's size and in degrees.
const SHARE: f64 = 0.1;
const PLACES: [f64; 2] = [1e-4, 1e-3];
const DEGREES: [f64; 2] = [0.02, 0.5];

/// The share of a bound that the new path may miss.
const OF_BOUND: f64 = 0.1;

/// Rounds in which a bound is made closer, since the new path broke it.
const ROUNDS: usize = 4;

/// What is asked for.
#[derive(Debug, Clone, Copy)]
pub struct SteadyRequest {
    /// The cut-off period in seconds: the low pass halves motion of this period, and leaves hardly
    /// anything of quicker ones; > 0, at most 2,000 frames.
    pub period: f64,
    /// Maximum distance any position may move, ≥ 0; 0: no limit.
    pub within: f64,
    /// Frames a second.
    pub fps: f64,
}

/// A flight that was made steady.
#[derive(Debug)]
pub struct Steadied {
    /// The path: of as many frames, open, each point with one view.
    pub path: CameraPath,
    /// How far a place went, at most.
    pub furthest: f64,
    /// Degrees that a view turned, at most.
    pub turned: f64,
}

/// Places, views and zoom of a path through a low pass of a time, at whole frames, made a path of few
/// points again by a fit; the first and the last pose stay. A closed path comes back open.
///
/// # Errors
/// [`crate::Error::Range`] for a time or a bound that will not do; [`crate::Error::Argument`] for a
/// path that does not move, a bound too close for a path of whole frames, and where `progress` ends
/// it; [`crate::Error::Limit`], [`crate::Error::Memory`].
pub fn steady(
    path: &CameraPath,
    request: &SteadyRequest,
    progress: Progress<'_>,
) -> Result<Steadied> {
    let SteadyRequest { within, fps, .. } = *request;
    if !(fps > 0.0 && fps <= MAX_FPS) {
        return Err(OutOfRange::Fps.into());
    }
    let frames = request.period * fps;
    if !(frames > 0.0 && frames <= MOST_FRAMES) {
        return Err(OutOfRange::SteadyPeriod(MOST_FRAMES / fps).into());
    }
    if !(within >= 0.0 && within.is_finite()) {
        return Err(OutOfRange::SteadyWithin.into());
    }
    let sampler = Sampler::new(path, &Timeline::new(path)?)?;
    if sampler.frame_count() > MAX_SAMPLED_FRAMES {
        return Err(TooMany::SampledFrames(sampler.frame_count()).into());
    }
    let mut poses = vec_with_room(sampler.frame_count())?;
    poses.resize(sampler.frame_count(), Pose::default());
    sampler.sample(1, &mut poses)?;
    if poses.iter().all(|pose| *pose == poses[0]) {
        return Err(Invalid::NoWay.into());
    }
    let mut flight = Flight::new(path, &poses, frames)?;
    let turns = flight.turns(progress)?;
    let zooms = flight.zooms(progress)?;
    let mut share = 1.0;
    for _ in 0..ROUNDS {
        let places = flight.places(share * (1.0 - OF_BOUND) * within, progress)?;
        let made = flight.poses(&places, &turns, &zooms)?;
        let [furthest, turned] = apart(&poses, &made);
        let tolerance = flight.tolerance(furthest, turned, within);
        let options = Options {
            space: Some(path.space),
            ..tolerance.into()
        };
        let mut fitted = fit(&made, None, fps, &options, progress)?.path;
        fitted.base_frames = path.base_frames;
        pin(&mut fitted, [poses[0], poses[poses.len() - 1]]);
        let sampler = Sampler::new(&fitted, &Timeline::new(&fitted)?)?;
        let mut again = made;
        let last = sampler.frame_count() as f64;
        for (k, pose) in again.iter_mut().enumerate() {
            *pose = sampler.pose((1.0 + k as f64).min(last))?;
        }
        let [furthest, turned] = apart(&poses, &again);
        if within == 0.0 || furthest <= within {
            return Ok(Steadied {
                path: fitted,
                furthest,
                turned: turned.to_degrees(),
            });
        }
        share *= 0.5;
    }
    Err(Invalid::SteadyBound(within).into())
}

/// Brings the ends to poses that the fit may have missed by a little.
fn pin(path: &mut CameraPath, ends: [Pose; 2]) {
    let (axes, space, last) = (path.space.up, path.space, path.points.len() - 1);
    for (at, pose) in [0, last].into_iter().zip(ends) {
        let point = &mut path.points[at];
        let [view, up] = [pose.vpn, pose.vup].map(|v| axes.upright(v.into()));
        point.position = pose.vrp.into();
        let orientation = &mut point.orientations[0];
        orientation.target = Target::Relative(space.offset(view));
        orientation.roll = roll_from_up(view, up).to_degrees();
        orientation.zoom = pose.zoom;
    }
}

/// How far poses are from others at most: their places, and their views and ups in radians.
fn apart(a: &[Pose], b: &[Pose]) -> [f64; 2] {
    let mut most = [0.0_f64; 2];
    for (a, b) in a.iter().zip(b) {
        let far = DVec3::from(a.vrp).distance(b.vrp.into());
        let turned = 2.0 * angle(turn(a), continue_sign(turn(a), turn(b)).0);
        most = [most[0].max(far), most[1].max(turned)];
    }
    most
}

fn turn(pose: &Pose) -> DQuat {
    quaternion_from_view(pose.vpn.into(), pose.vup.into())
}

/// The poses of a path, at times that are frames.
struct Flight {
    times: Vec<f64>,
    /// Counted from the middle of their box.
    places: Vec<[f64; 3]>,
    centre: DVec3,
    /// Of the box.
    size: f64,
    turns: Vec<DQuat>,
    zooms: Vec<[f64; 1]>,
    /// The ends are met, all else as `frames` says.
    free: Vec<f64>,
    light: f64,
}

impl Flight {
    fn new(path: &CameraPath, poses: &[Pose], frames: f64) -> Result<Self> {
        let count = poses.len();
        let at = |pose: &Pose| DVec3::from(pose.vrp);
        let low = poses.iter().map(at).fold(DVec3::INFINITY, DVec3::min);
        let high = poses.iter().map(at).fold(DVec3::NEG_INFINITY, DVec3::max);
        let centre = 0.5 * low + 0.5 * high;
        let size = match low.distance(high) {
            size if size > 0.0 => size,
            _ => path.space.half_size,
        };
        let mut flight = Self {
            times: vec_with_room(count)?,
            places: vec_with_room(count)?,
            centre,
            size,
            turns: vec_with_room(count)?,
            zooms: vec_with_room(count)?,
            free: vec_with_room(count)?,
            light: (frames / std::f64::consts::TAU).powi(4),
        };
        for (k, pose) in poses.iter().enumerate() {
            flight.times.push(k as f64);
            flight.places.push((at(pose) - centre).to_array());
            let before = flight.turns.last().copied();
            let turn = turn(pose);
            flight
                .turns
                .push(continue_sign(before.unwrap_or(turn), turn).0);
            flight.zooms.push([pose.zoom]);
            let end = k == 0 || k + 1 == count;
            flight.free.push(if end { 0.0 } else { f64::INFINITY });
        }
        Ok(flight)
    }

    fn smooth<const N: usize>(
        &self,
        rows: &[[f64; N]],
        allowed: &[f64],
        progress: Progress<'_>,
    ) -> Result<Spline<N>> {
        let all = rows.len();
        let mut round = || {
            if progress(0, all) {
                return Ok(());
            }
            Err(Invalid::Cancelled.into())
        };
        Spline::low_pass(&self.times, rows, allowed, self.light, &mut round)
    }

    /// No place farther than a bound; 0: none.
    fn places(&self, bound: f64, progress: Progress<'_>) -> Result<Spline<3>> {
        let mut allowed: Vec<f64> = vec_with_room(self.free.len())?;
        // The splines keep to it but for a tenth.
        let bound = if bound > 0.0 {
            bound / 1.1
        } else {
            f64::INFINITY
        };
        allowed.extend(self.free.iter().map(|free| free.min(bound)));
        self.smooth(&self.places, &allowed, progress)
    }

    fn zooms(&self, progress: Progress<'_>) -> Result<Spline<1>> {
        self.smooth(&self.zooms, &self.free, progress)
    }

    fn turns(&mut self, progress: Progress<'_>) -> Result<Vec<DQuat>> {
        let mut smooth = vec_with_room(self.turns.len())?;
        smooth.extend_from_slice(&self.turns);
        let mut unrolled: Vec<DVec3> = vec_with_room(smooth.len())?;
        let mut rows: Vec<[f64; 3]> = vec_with_room(smooth.len())?;
        for _ in 0..UNROLLED {
            unrolled.clear();
            rows.clear();
            let (mut sum, mut before) = (DVec3::ZERO, smooth[0]);
            for (now, raw) in smooth.iter().zip(&self.turns) {
                sum += log(*now * before.conjugate());
                before = *now;
                unrolled.push(sum);
                rows.push((sum + log(*raw * now.conjugate())).to_array());
            }
            let spline = self.smooth(&rows, &self.free, progress)?;
            for (k, (turn, was)) in smooth.iter_mut().zip(&unrolled).enumerate() {
                let by = DVec3::from_array(*spline.value(k)) - *was;
                *turn = (exp(by) * *turn).normalize();
            }
        }
        Ok(smooth)
    }

    fn poses(&self, places: &Spline<3>, turns: &[DQuat], zooms: &Spline<1>) -> Result<Vec<Pose>> {
        let mut poses = vec_with_room(turns.len())?;
        poses.extend(turns.iter().enumerate().map(|(k, turn)| {
            let (view, up) = view_from_quaternion(*turn);
            Pose {
                vrp: (DVec3::from_array(*places.value(k)) + self.centre).to_array(),
                vpn: view.to_array(),
                vup: up.to_array(),
                zoom: zooms.value(k)[0].clamp(MIN_ZOOM, MAX_ZOOM),
            }
        }));
        Ok(poses)
    }

    /// How near the new path must be: what it misses is little beside what was taken out.
    fn tolerance(&self, furthest: f64, turned: f64, within: f64) -> Tolerance {
        let [least, most] = PLACES.map(|share| share * self.size);
        let position = (SHARE * furthest).clamp(least, most);
        let bound = if within > 0.0 {
            0.5 * OF_BOUND * within
        } else {
            f64::INFINITY
        };
        Tolerance {
            position: position.min(bound),
            angle: (SHARE * turned.to_degrees()).clamp(DEGREES[0], DEGREES[1]),
        }
    }
}

#[cfg(test)]
#[path = "steady_tests.rs"]
mod tests;
