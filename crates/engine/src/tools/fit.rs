//! Recorded poses become a path of few points.
//!
//! First splines that are smooth and near the poses (`fit/motion.rs`); then pieces, each as long as
//! it may be (`fit/piece.rs`), that begin and end in the states of the splines, at a pace of their
//! own (`fit/pace.rs`): so directions, speeds and turning go on from one to the next, and
//! accelerations nearly; those of the turning then wholly (`fit/joins.rs`). If the path misses a
//! pose after all, it is made again with the noise left in.

mod corners;
mod joins;
mod motion;
mod pace;
mod piece;
mod whole;

use glam::{DMat3, DQuat, DVec3};

use crate::error::{Error, Invalid, OutOfRange, Place, Result, TooMany, vec_with_room};
use crate::limits::{MAX_FPS, MAX_FRAMES, MAX_POINTS};
use crate::math::orientation::{quaternion_from_view, roll_from_up, view_from_quaternion};
use crate::math::quaternion::{angle, continue_sign};
use crate::path::camera_path::{check_coordinates, check_zoom};
use crate::path::hermite::Cubic;
use crate::path::{
    CameraPath, Orientation, OrientationOverrides, Pace, Pose, Sampler, Space, SupportPoint,
    Tangents, Target, Timeline, Up, Velocities,
};

/// A pose missed by no more than so many times the tolerance counts as met.
const WITHIN: f64 = 1.001;

/// How well the path must meet the poses.
#[derive(Debug, Clone, Copy)]
pub struct Tolerance {
    /// Of the position, > 0.
    pub position: f64,
    /// Of the view, up and field of view, in degrees, > 0.
    pub angle: f64,
}

impl Tolerance {
    /// Both in range.
    ///
    /// # Errors
    /// [`crate::Error::Argument`] or [`crate::Error::Range`].
    pub fn check(self) -> Result<()> {
        if !(self.position > 0.0 && self.position.is_finite()) {
            return Err(OutOfRange::Tolerance.into());
        }
        if !(self.angle > 0.0 && self.angle <= 180.0) {
            return Err(OutOfRange::ToleranceAngle.into());
        }
        Ok(())
    }
}

/// What a fit goes by.
#[derive(Debug, Clone, Copy)]
pub struct Options {
    /// How well the poses must be met.
    pub tolerance: Tolerance,
    /// The space of the path; none: the smallest round the positions, with a tenth to spare.
    pub space: Option<Space>,
    /// What stands upright where no space says.
    pub up: Up,
    /// Poses that are off by more than the tolerance from what those around them say are left out.
    pub robust: bool,
}

impl From<Tolerance> for Options {
    fn from(tolerance: Tolerance) -> Self {
        Self {
            tolerance,
            space: None,
            up: Up::Y,
            robust: false,
        }
    }
}

/// A path, and which poses it leaves out.
#[derive(Debug)]
pub struct Fitted {
    /// The path.
    pub path: CameraPath,
    /// Indices of the poses that a robust fit did not look at.
    pub left_out: Vec<usize>,
}

/// Called now and then with the poses done and all of them; false ends the work.
pub type Progress<'a> = &'a mut dyn FnMut(usize, usize) -> bool;

struct Data {
    /// In frames from the first.
    times: Vec<f64>,
    raw: Vec<Sample>,
    /// Which of them do not count.
    left_out: Vec<bool>,
    tolerance: f64,
    /// Radians.
    angle: f64,
    fps: f64,
    space: Space,
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
    frames: u32,
    start: Sample,
    end: Sample,
    /// None on the spot.
    curve: Option<Cubic>,
    pace: Pace,
    /// Of the whole piece, on S³, leaving and reaching.
    velocities: [DVec3; 2],
    /// Slopes of the zoom for the whole piece at its ends.
    zoom_slopes: [f64; 2],
    /// Of the curve.
    length: f64,
    /// At its ends the share of the way in a frame, and by how much that grows in one.
    speeds: [[f64; 2]; 2],
    /// Nothing moves: the frames are those of a hold.
    holds: bool,
    /// It begins at a corner, where no acceleration goes on.
    corner: bool,
}

/// What a piece takes over from the one before.
#[derive(Clone, Copy)]
struct Joint {
    sample: Sample,
    /// For a frame at speed 50.
    zoom_slope: Option<f64>,
    /// Acceleration.
    bend: DVec3,
}

/// A path that passes all poses within a tolerance at their times: increasing `seconds`, or one a
/// frame. Its points stand at whole frames; poses that move too much between them are refused.
///
/// # Errors
/// [`crate::Error::Argument`] or [`crate::Error::Range`] for too few or bad poses, a bad tolerance
/// or space, and where `progress` ends it; [`crate::Error::Limit`], [`crate::Error::Memory`].
pub fn fit(
    poses: &[Pose],
    seconds: Option<&[f64]>,
    fps: f64,
    options: &Options,
    progress: Progress<'_>,
) -> Result<Fitted> {
    let mut data = Data::new(poses, seconds, fps, options)?;
    if options.robust {
        data.leave_out()?;
    }
    let mut path = data.fitted(false, progress)?;
    if data.worst(&path)?.is_some() {
        path = data.fitted(true, progress)?;
        if let Some((at, times)) = data.worst(&path)? {
            return Err(Error::from(Invalid::PoseMissed(times)).at(Place::Pose(at)));
        }
    }
    let all = || (0..poses.len()).filter(|k| data.left_out[*k]);
    let mut left_out = vec_with_room(all().count())?;
    left_out.extend(all());
    Ok(Fitted { path, left_out })
}

impl Data {
    /// `exact`: with the noise left in.
    fn fitted(&self, exact: bool, progress: Progress<'_>) -> Result<CameraPath> {
        let last = self.raw.len() - 1;
        let mut go_on = |done: usize| {
            if progress(done, last) {
                return Ok(());
            }
            Err(Error::from(Invalid::Cancelled))
        };
        let motion = self.motion(exact, &mut || go_on(0))?;
        let mut pieces: Vec<Piece> = Vec::new();
        let mut joint = Joint {
            sample: motion.stretches[0].at(0.0).sample,
            zoom_slope: None,
            bend: DVec3::ZERO,
        };
        let (mut number, mut moving) = (0, 0);
        while number < motion.parts.len() {
            let (over, mut whole) = self.over_corners(&motion, number, joint, exact)?;
            let stretch = &motion.stretches[number];
            let [begin, end] = [stretch.first, stretch.last].map(|k| self.times[k].round());
            let (mut at, mut guess) = (begin, 8.0);
            while at < end {
                let mut piece = match whole.take() {
                    Some(piece) => piece,
                    None => self.longest(stretch, motion.peaks, [begin, at, end], joint, guess)?,
                };
                piece.corner = at == begin && number > 0 && motion.corner(number - 1);
                guess = f64::from(piece.frames);
                at += guess;
                joint.sample = piece.end;
                joint.bend = piece.bend(1);
                if !piece.holds {
                    joint.zoom_slope = Some(piece.zoom_slopes[1] / guess);
                    moving += 1;
                    if moving >= MAX_POINTS {
                        return Err(TooMany::FittedPoints.into());
                    }
                }
                pieces.try_reserve(1)?;
                pieces.push(piece);
                go_on(self.times.partition_point(|time| *time < at).min(last))?;
            }
            number += over;
        }
        self.even_out(&mut pieces)?;
        self.path(&pieces, joint.sample)
    }

    /// The pose that a path misses most, and by how many times the tolerance; none if it meets all.
    fn worst(&self, path: &CameraPath) -> Result<Option<(usize, f64)>> {
        let sampler = Sampler::new(path, &Timeline::new(path)?)?;
        let last = sampler.frame_count() as f64;
        let mut worst = (0, WITHIN);
        for (at, (sample, time)) in self.raw.iter().zip(&self.times).enumerate() {
            if self.left_out[at] {
                continue;
            }
            let pose = sampler.pose((1.0 + time).clamp(1.0, last))?;
            let far = DVec3::from_array(pose.vrp).distance(sample.position);
            let turn = self.turn(pose.vpn.into(), pose.vup.into());
            let off = sample.off(turn, pose.zoom);
            let times = (far / self.tolerance).max(off / self.angle);
            if times > worst.1 {
                worst = (at, times);
            }
        }
        Ok((worst.1 > WITHIN).then_some(worst))
    }

    fn new(poses: &[Pose], seconds: Option<&[f64]>, fps: f64, options: &Options) -> Result<Self> {
        let tolerance = options.tolerance;
        if !(fps > 0.0 && fps <= MAX_FPS) {
            return Err(OutOfRange::Fps.into());
        }
        tolerance.check()?;
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
        // Before any work: what follows goes through all frames.
        let span = times.last().copied().unwrap_or(0.0);
        if span >= MAX_FRAMES as f64 {
            return Err(TooMany::PoseSpan(span).into());
        }
        let up = options.space.map_or(options.up, |space| space.up);
        let mut raw: Vec<Sample> = vec_with_room(poses.len())?;
        for (k, pose) in poses.iter().enumerate() {
            let sample = sample(pose, up).map_err(|error| error.at(Place::Pose(k)))?;
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
        let (start, angle) = (raw[0], tolerance.angle.to_radians());
        let near = |sample: &Sample| {
            sample.position.distance(start.position) <= tolerance.position
                && start.off(sample.turn, sample.zoom) <= angle
        };
        if raw.iter().all(near) {
            return Err(Invalid::WithinTolerance.into());
        }
        let space = match options.space {
            Some(space) => space,
            None => space_of(&raw, up)?,
        };
        space.check()?;
        let mut left_out = vec_with_room(raw.len())?;
        left_out.resize(raw.len(), false);
        Ok(Self {
            times,
            raw,
            left_out,
            tolerance: tolerance.position,
            angle,
            fps,
            space,
        })
    }

    /// View and up of the world as a quaternion in y-up axes.
    fn turn(&self, view: DVec3, up: DVec3) -> DQuat {
        let axes = self.space.up;
        quaternion_from_view(axes.upright(view), axes.upright(up))
    }

    fn path(&self, pieces: &[Piece], end: Sample) -> Result<CameraPath> {
        let mut points: Vec<SupportPoint> = vec_with_room(pieces.len() + 1)?;
        let (mut before, mut hold) = (None, 0);
        for piece in pieces {
            if piece.holds {
                hold += piece.frames;
                continue;
            }
            points.push(self.point(&piece.start, hold, [before, Some(piece)])?);
            (before, hold) = (Some(piece), 0);
        }
        points.push(self.point(&end, hold, [before, None])?);
        if points.len() == 1 {
            return Err(Invalid::WithinTolerance.into());
        }
        let mut path = CameraPath::try_new()?;
        path.points = points.into();
        path.space = self.space;
        path.check()?;
        Ok(path)
    }

    /// The point between two pieces: its pose, and how long it rests there.
    fn point(&self, at: &Sample, hold: u32, pieces: [Option<&Piece>; 2]) -> Result<SupportPoint> {
        // What one of the two does not say is as the other has it.
        fn sides<T: Copy>(
            [before, after]: [Option<&Piece>; 2],
            of: impl Fn(&Piece, usize) -> T,
        ) -> Option<[T; 2]> {
            let reach = before.map(|piece| of(piece, 1));
            let leave = after.map(|piece| of(piece, 0));
            Some([reach.or(leave)?, leave.or(reach)?])
        }
        let axes = self.space.up;
        let mut point = SupportPoint::try_new(at.position)?;
        point.tangents = sides(pieces, |piece, side| {
            let derivative = |curve: Cubic| curve.derivative([0.0, 1.0][side]);
            piece.curve.map_or(DVec3::ZERO, derivative)
        })
        .map(|[before, after]| Tangents { before, after });
        let velocities = sides(pieces, |piece, side| {
            // A rotation counts twice its angle on S³.
            axes.world(piece.velocities[side]) * (2f64.to_degrees() / f64::from(piece.frames))
        })
        .map(|[reach, leave]| Velocities { reach, leave });
        let zooms =
            |piece: &&Piece| piece.start.zoom != piece.end.zoom || piece.zoom_slopes != [0.0; 2];
        let zooms = pieces.iter().flatten().any(zooms);
        let slope = |piece: &Piece, side| piece.zoom_slopes[side] / f64::from(piece.frames);
        let zoom_slope = sides(pieces, slope).map(|slopes| slopes[0]);
        let (view, up) = view_from_quaternion(at.turn);
        let own = |own: &mut OrientationOverrides| {
            own.velocities = velocities;
            own.zoom_slope = zoom_slope.filter(|_| zooms);
            if let Some(piece) = pieces[1] {
                own.pace = piece.pace.clone();
                own.frames = piece.frames;
            }
        };
        point.orientations[0] = Orientation {
            target: Target::Relative(self.space.offset(view)),
            roll: roll_from_up(view, up).to_degrees(),
            zoom: at.zoom,
            hold,
            ..Orientation::default()
        };
        point.orientations[0].own = point.orientations[0].own.with(own)?;
        Ok(point)
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

/// The vertical field of view (radians) of a picture 24 mm high.
fn view_angle(zoom: f64) -> f64 {
    2.0 * (12.0 / zoom).atan()
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

#[cfg(test)]
#[path = "fit_tests.rs"]
mod tests;
