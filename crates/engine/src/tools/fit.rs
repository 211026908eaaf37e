//! Recorded poses become a path of few points.
//!
//! Noise is taken out first (`smooth.rs`); then pieces, each as long as it may be, are fitted one
//! after the other (Schneider 1990; `docs/tools.md`, fit). If the path misses a pose after all, it
//! is made again with the noise left in.

mod piece;

use glam::{DMat3, DQuat, DVec3};

use super::smooth::{Row, noise, smoothed};
use crate::error::{Error, Invalid, OutOfRange, Place, Result, TooMany, vec_with_room};
use crate::limits::{MAX_FPS, MAX_POINTS, MAX_ZOOM, MIN_ZOOM};
use crate::math::orientation::{quaternion_from_view, roll_from_up, view_from_quaternion};
use crate::math::quaternion::{angle, continue_sign};
use crate::path::camera_path::{check_coordinates, check_zoom};
use crate::path::hermite::Cubic;
use crate::path::{
    CameraPath, Orientation, Own, Pace, Pose, Sampler, SupportPoint, Tangents, Target, Timeline,
    Velocities,
};

/// A pose missed by no more than so many times the tolerance counts as met.
const WITHIN: f64 = 1.001;

/// Rounds of a fit; most settle sooner.
const ROUNDS: usize = 24;

/// How well the path must meet the poses.
#[derive(Debug, Clone, Copy)]
pub struct Tolerance {
    /// Of the position, > 0.
    pub position: f64,
    /// Of the view, up and field of view, in degrees, > 0.
    pub angle: f64,
}

/// Called now and then with the poses done and all of them; false ends the work.
pub type Progress<'a> = &'a mut dyn FnMut(usize, usize) -> bool;

struct Data {
    /// In frames from the first.
    times: Vec<f64>,
    raw: Vec<Sample>,
    smooth: Vec<Sample>,
    tolerance: f64,
    /// Radians.
    angle: f64,
}

#[derive(Clone, Copy)]
struct Sample {
    position: DVec3,
    turn: DQuat,
    zoom: f64,
}

impl Sample {
    /// By which angle a view misses it, or its field of view.
    fn off(&self, turn: DQuat, zoom: f64) -> f64 {
        let turned = 2.0 * angle(self.turn, continue_sign(self.turn, turn).0);
        turned.max((view_angle(self.zoom) - view_angle(zoom)).abs())
    }
}

struct Piece {
    first: usize,
    last: usize,
    frames: u32,
    curve: Option<Cubic>,
    pace: Pace,
    /// Of the whole piece, on S³, leaving and reaching.
    velocities: [DVec3; 2],
    /// Slopes of the zoom for the whole piece at its ends.
    zoom_slopes: [f64; 2],
    /// Nothing moves: the frames are those of a hold.
    holds: bool,
}

/// What a piece takes over from the one before.
#[derive(Clone, Copy, Default)]
struct Joint {
    direction: Option<DVec3>,
    /// For a frame.
    zoom_slope: Option<f64>,
}

/// A path that passes all poses within a tolerance at their times: increasing `seconds`, or one a
/// frame. Its points stand at whole frames; poses that move too much between them are refused.
///
/// # Errors
/// [`crate::Error::Argument`] or [`crate::Error::Range`] for too few or bad poses, a bad tolerance,
/// and where `progress` ends it; [`crate::Error::Limit`], [`crate::Error::Memory`].
pub fn fit(
    poses: &[Pose],
    seconds: Option<&[f64]>,
    fps: f64,
    tolerance: Tolerance,
    progress: Progress<'_>,
) -> Result<CameraPath> {
    let mut data = Data::new(poses, seconds, fps, tolerance)?;
    let path = data.fitted(progress)?;
    if data.worst(&path)?.is_none() {
        return Ok(path);
    }
    data.smooth.clone_from(&data.raw);
    let path = data.fitted(progress)?;
    match data.worst(&path)? {
        None => Ok(path),
        Some((at, times)) => Err(Error::from(Invalid::PoseMissed(times)).at(Place::Pose(at))),
    }
}

impl Data {
    fn fitted(&self, progress: Progress<'_>) -> Result<CameraPath> {
        let (data, last) = (self, self.raw.len() - 1);
        let mut pieces: Vec<Piece> = Vec::new();
        let (mut at, mut joint, mut guess) = (0, Joint::default(), 8);
        while at < last {
            let Some(piece) = data.longest(at, joint, guess)? else {
                // The rest is within one frame.
                break;
            };
            guess = piece.last - piece.first;
            at = piece.last;
            joint = Joint {
                direction: piece
                    .curve
                    .and_then(|curve| curve.derivative(1.0).try_normalize()),
                zoom_slope: if piece.holds {
                    joint.zoom_slope
                } else {
                    Some(piece.zoom_slopes[1] / f64::from(piece.frames))
                },
            };
            pieces.try_reserve(1)?;
            pieces.push(piece);
            if !progress(at, last) {
                return Err(Invalid::Cancelled.into());
            }
        }
        data.path(&pieces)
    }

    /// The pose that a path misses most, and by how many times the tolerance; none if it meets all.
    fn worst(&self, path: &CameraPath) -> Result<Option<(usize, f64)>> {
        let sampler = Sampler::new(path, &Timeline::new(path)?)?;
        let last = sampler.frame_count() as f64;
        let mut worst = (0, WITHIN);
        for (at, (sample, time)) in self.raw.iter().zip(&self.times).enumerate() {
            let pose = sampler.pose((1.0 + time).clamp(1.0, last))?;
            let far = DVec3::from_array(pose.vrp).distance(sample.position);
            let turn = quaternion_from_view(pose.vpn.into(), pose.vup.into());
            let off = self.off(at, turn, pose.zoom);
            let times = (far / self.tolerance).max(off / self.angle);
            if times > worst.1 {
                worst = (at, times);
            }
        }
        Ok((worst.1 > WITHIN).then_some(worst))
    }

    fn new(
        poses: &[Pose],
        seconds: Option<&[f64]>,
        fps: f64,
        tolerance: Tolerance,
    ) -> Result<Self> {
        if !(fps > 0.0 && fps <= MAX_FPS) {
            return Err(OutOfRange::Fps.into());
        }
        if !(tolerance.position > 0.0 && tolerance.position.is_finite()) {
            return Err(OutOfRange::Tolerance.into());
        }
        if !(tolerance.angle > 0.0 && tolerance.angle <= 180.0) {
            return Err(OutOfRange::ToleranceAngle.into());
        }
        if poses.len() < 3 {
            return Err(Invalid::TooFewPoses.into());
        }
        let mut times = vec_with_room(poses.len())?;
        match seconds {
            None => times.extend((0..poses.len()).map(|k| k as f64)),
            Some(seconds) => {
                times.extend(seconds.iter().map(|when| (when - seconds[0]) * fps));
                if times.len() != poses.len() || !times.windows(2).all(|pair| pair[1] > pair[0]) {
                    return Err(Invalid::PoseTimes.into());
                }
            }
        }
        let mut raw: Vec<Sample> = vec_with_room(poses.len())?;
        for (k, pose) in poses.iter().enumerate() {
            let sample = sample(pose).map_err(|error| error.at(Place::Pose(k)))?;
            let before = raw.last().map_or(sample.turn, |before| before.turn);
            raw.push(Sample {
                turn: continue_sign(before, sample.turn).0,
                ..sample
            });
        }
        let first = poses[0];
        if poses.iter().all(|pose| *pose == first) {
            return Err(Invalid::SamePoses.into());
        }
        let mut data = Self {
            times,
            smooth: Vec::new(),
            raw,
            tolerance: tolerance.position,
            angle: tolerance.angle.to_radians(),
        };
        data.smooth = data.without_noise()?;
        Ok(data)
    }

    /// The samples with the noise taken out, if there is any to speak of.
    fn without_noise(&self) -> Result<Vec<Sample>> {
        let mut rows: Vec<Row> = vec_with_room(self.raw.len())?;
        rows.extend(self.raw.iter().map(|sample| {
            let (p, q) = (sample.position, sample.turn);
            [p.x, p.y, p.z, q.x, q.y, q.z, q.w, sample.zoom]
        }));
        let noise = noise(&rows)?;
        let place = noise[0].max(noise[1]).max(noise[2]);
        // On S³ an angle counts half.
        let turn = 2.0 * noise[3..7].iter().fold(0.0, |a: f64, b| a.max(*b));
        let mut smooth = vec_with_room(self.raw.len())?;
        if place < 0.01 * self.tolerance && turn < 0.01 * self.angle {
            smooth.extend_from_slice(&self.raw);
            return Ok(smooth);
        }
        // Noise may miss by all of its own, and motion by a little more.
        let allowed = |noise: f64, most: f64| (3.3 * noise).clamp(0.6 * most, 0.93 * most);
        let (place, turn) = (allowed(place, self.tolerance), allowed(turn, self.angle));
        let misses = |is: &Row, fitted: &Row| {
            let far = |range: std::ops::Range<usize>| {
                let squares = range.map(|k| (is[k] - fitted[k]).powi(2));
                squares.sum::<f64>().sqrt()
            };
            let seen = (view_angle(is[7]) - view_angle(fitted[7])).abs();
            (far(0..3) / place)
                .max(2.0 * far(3..7) / turn)
                .max(seen / turn)
        };
        for (row, raw) in smoothed(&self.times, &rows, &misses)?.iter().zip(&self.raw) {
            let turn = DQuat::from_xyzw(row[3], row[4], row[5], row[6]);
            let found = Sample {
                position: DVec3::new(row[0], row[1], row[2]),
                turn: turn.normalize(),
                zoom: row[7].clamp(MIN_ZOOM, MAX_ZOOM),
            };
            // What is no noise, a jump or more than is allowed, stays.
            let far = found.position.distance(raw.position);
            let kept = far > self.tolerance || raw.off(found.turn, found.zoom) > self.angle;
            smooth.push(if kept { *raw } else { found });
        }
        Ok(smooth)
    }

    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    fn frames(&self, first: usize, last: usize) -> u32 {
        (self.times[last].round() - self.times[first].round()) as u32
    }

    fn path(&self, pieces: &[Piece]) -> Result<CameraPath> {
        let mut points: Vec<SupportPoint> = vec_with_room(pieces.len() + 2)?;
        let mut start = Start::default();
        for piece in pieces {
            if piece.holds {
                let hold = start.hold + piece.frames;
                start = Start { hold, ..start };
                continue;
            }
            points.push(self.point(&start, Some(piece))?);
            start = Start {
                at: piece.last,
                hold: 0,
                before: Some(piece),
            };
        }
        points.push(self.point(&start, None)?);
        if points.len() == 1 {
            return Err(Invalid::WithinTolerance.into());
        }
        if points.len() > MAX_POINTS {
            return Err(TooMany::FittedPoints.into());
        }
        let mut path = CameraPath::try_new()?;
        path.points = points;
        path.check()?;
        Ok(path)
    }

    fn point(&self, start: &Start<'_>, next: Option<&Piece>) -> Result<SupportPoint> {
        let at = &self.smooth[start.at];
        let before = start.before;
        let mut point = SupportPoint::try_new(at.position)?;
        let tangent = |piece: Option<&Piece>, t: f64| {
            Some(
                piece?
                    .curve
                    .map_or(DVec3::ZERO, |curve| curve.derivative(t)),
            )
        };
        let (reach, leave) = (tangent(before, 1.0), tangent(next, 0.0));
        point.tangents = Some(Tangents {
            before: reach.or(leave).unwrap_or_default(),
            after: leave.or(reach).unwrap_or_default(),
        });
        let (view, up) = view_from_quaternion(at.turn);
        let rate = |piece: Option<&Piece>, side: usize| {
            // A rotation counts twice its angle on S³.
            let piece = piece?;
            Some(piece.velocities[side] * (2f64.to_degrees() / f64::from(piece.frames)))
        };
        let (reach, leave) = (rate(before, 1), rate(next, 0));
        let slope = |piece: &Piece, side: usize| piece.zoom_slopes[side] / f64::from(piece.frames);
        let zoom_slope = before
            .map(|piece| slope(piece, 1))
            .or_else(|| next.map(|piece| slope(piece, 0)));
        let zooms = |piece: Option<&Piece>| {
            piece.is_some_and(|piece| {
                let ends = [piece.first, piece.last].map(|k| self.smooth[k].zoom);
                ends[0] != ends[1] || piece.zoom_slopes != [0.0; 2]
            })
        };
        let zooms = zooms(before) || zooms(next);
        let own = |own: &mut Own| {
            own.velocities = Some(Velocities {
                reach: reach.or(leave).unwrap_or_default(),
                leave: leave.or(reach).unwrap_or_default(),
            });
            own.zoom_slope = zoom_slope.filter(|_| zooms);
            if let Some(piece) = next {
                own.pace = piece.pace.clone();
                own.frames = piece.frames;
            }
        };
        point.orientations[0] = Orientation {
            target: Target::Relative(view),
            roll: roll_from_up(view, up).to_degrees(),
            zoom: at.zoom,
            hold: start.hold,
            ..Orientation::default()
        };
        point.orientations[0].own = point.orientations[0].own.with(own)?;
        Ok(point)
    }
}

/// The next point: its pose, how long it rests there, and the piece that leads to it.
#[derive(Clone, Copy, Default)]
struct Start<'a> {
    at: usize,
    hold: u32,
    before: Option<&'a Piece>,
}

/// The vertical field of view (radians) of a picture 24 mm high.
fn view_angle(zoom: f64) -> f64 {
    2.0 * (12.0 / zoom).atan()
}

/// A pose as a sample: finite, its view and up made to stand at right angles.
fn sample(pose: &Pose) -> Result<Sample> {
    let [position, view, up] = [pose.vrp, pose.vpn, pose.vup].map(DVec3::from_array);
    for v in [position, view, up] {
        check_coordinates(v)?;
    }
    check_zoom(pose.zoom)?;
    let (Some(view), Some(up)) = (view.try_normalize(), up.try_normalize()) else {
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

#[cfg(test)]
#[path = "fit_tests.rs"]
mod tests;
