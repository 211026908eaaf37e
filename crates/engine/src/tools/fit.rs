//! Recorded poses become a path of few points.
//!
//! First splines that are smooth and near the poses (`fit/motion.rs`); then pieces, each as long as
//! it may be (`fit/piece.rs`), that begin and end in the states of the splines, at a pace of their
//! own (`fit/pace.rs`): so directions, speeds and turning are continuous from one to the next,
//! accelerations nearly, and those of the turning exactly, after `fit/joins.rs`. If the path misses a
//! pose after all, it is made again with the noise left in.

mod calm;
mod choice;
mod corners;
mod holds;
mod joins;
mod jumps;
mod measure;
mod motion;
mod pace;
mod piece;
mod recording;
mod report;
mod rests;
mod time_unit;
mod whole;

pub use report::{Deviation, PoseDeviation, Report};
pub use time_unit::TimeUnit;

use glam::{DQuat, DVec3};

use choice::Made;

use crate::error::{Error, Invalid, OutOfRange, Result, TooMany, vec_with_room};
use crate::limits::MAX_POINTS;
use crate::math::orientation::{quaternion_from_view, roll_from_up, view_from_quaternion};
use crate::math::quaternion::{angle, continue_sign};
use crate::path::hermite::Cubic;
use crate::path::{
    CameraPath, Orientation, OrientationOverrides, Pace, Pose, Space, SupportPoint, Tangents,
    Target, Up, Velocities,
};

/// A pose missed by at most this multiple of the tolerance counts as met.
const WITHIN: f64 = 1.001;

/// How well the path must meet the poses.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tolerance {
    /// Of the position, > 0.
    pub position: f64,
    /// Of the view, up and field of view, in degrees, > 0.
    pub angle: f64,
}

impl Tolerance {
    /// What is usual: 1/1000 of the diagonal of the positions' bounds, and half a degree; for
    /// positions that are one, a length of 0.001.
    #[must_use]
    pub fn usual(poses: &[Pose]) -> Self {
        let places = || poses.iter().map(Pose::position);
        let low = places().fold(DVec3::INFINITY, DVec3::min);
        let high = places().fold(DVec3::NEG_INFINITY, DVec3::max);
        let diagonal = 1e-3 * low.distance(high);
        Self {
            position: if diagonal > 0.0 && diagonal.is_finite() {
                diagonal
            } else {
                1e-3
            },
            angle: 0.5,
        }
    }

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
    /// The up axis, if `space` is none.
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
    /// How well it follows them, and what was found in them.
    pub report: Report,
    /// How far it is from each pose that counts, in the order of their times.
    pub deviations: Vec<PoseDeviation>,
}

/// Called now and then with the poses done and all of them; false ends the work.
pub type Progress<'a> = &'a mut dyn FnMut(usize, usize) -> bool;

struct Data {
    /// In frames from the first; those near a whole frame stand at it.
    times: Vec<f64>,
    /// One for each time. Where the recording ends between frames, the last one is not a
    /// recorded pose but what it is on its way to at the next frame.
    raw: Vec<Sample>,
    /// What the splines take for them.
    calm: Vec<Sample>,
    /// Which pose of the recording each is: poses at equal times are dropped.
    numbers: Vec<usize>,
    /// Of the times of the recording, if they are no seconds.
    unit: Option<TimeUnit>,
    /// Which of them do not count.
    left_out: Vec<bool>,
    /// The poses before a cut.
    cuts: Vec<usize>,
    gaps: usize,
    tolerance: f64,
    /// Radians.
    angle: f64,
    /// How near to the splines pieces must be, where the tolerance is for noise: a length and radians.
    near: [f64; 2],
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
    /// The mean squares by which it misses the splines: of positions, and of views and lens.
    missed: [f64; 2],
    /// Nothing moves: the frames are those of a hold.
    holds: bool,
    /// It begins at a corner, where no acceleration goes on.
    corner: bool,
}

/// All of a path.
struct Pieces {
    all: Vec<Piece>,
    /// Where the last one ends.
    end: Sample,
    /// Whether positions and views move evenly.
    even: [bool; 2],
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

/// A path that passes all poses within a tolerance at their times: non-decreasing `seconds`, or one
/// pose a frame. Its points stand at whole frames, so poses between them may be missed, where the
/// camera jerks from one to the next; the report has by how much. Of poses at equal times the first
/// counts.
///
/// # Errors
/// [`crate::Error::Argument`] or [`crate::Error::Range`] for fewer than two poses, for numbers that
/// are not finite, times that run backwards, a bad tolerance or space, and where `progress` ends
/// it; [`crate::Error::Limit`], [`crate::Error::Memory`].
pub fn fit(
    poses: &[Pose],
    seconds: Option<&[f64]>,
    fps: f64,
    options: &Options,
    progress: Progress<'_>,
) -> Result<Fitted> {
    let mut data = Data::new(poses, seconds, fps, options)?;
    let mut made = data.made(options, poses.len(), progress)?;
    if !options.robust {
        let robust = Options {
            robust: true,
            ..*options
        };
        let data = Data::new(poses, seconds, fps, &robust)?;
        made.report.robust = data.robust(&made.report, progress)?;
    }
    // Poses that are wrong cost no tolerance.
    if made.report.robust.is_none() {
        made.report.better = data.better(&made.report, progress)?;
    }
    Ok(made)
}

/// The path of at most so many points, at least 2, that needs the least tolerance, to within a
/// twentieth; and that tolerance. [`Options::tolerance`] has the ratio of length and angle.
///
/// # Errors
/// As [`fit`]; [`crate::Error::Range`] for fewer than two points or where no tolerance up to 1,000
/// times that of the options leads to so few.
pub fn fit_points(
    poses: &[Pose],
    seconds: Option<&[f64]>,
    fps: f64,
    options: &Options,
    points: usize,
    progress: Progress<'_>,
) -> Result<(Fitted, Tolerance)> {
    options.tolerance.check()?;
    let with = |times: f64| Options {
        tolerance: Tolerance {
            position: times * options.tolerance.position,
            angle: (times * options.tolerance.angle).min(180.0),
        },
        ..*options
    };
    let mut best: Option<(Fitted, Tolerance)> = None;
    // Powers of two by halving the interval of their exponents.
    let [mut low, mut high] = [-10.0_f64, 10.0];
    while high - low > 0.07 {
        let middle = match best {
            None if low == -10.0 => 0.0,
            _ => 0.5 * (low + high),
        };
        let options = with(middle.exp2());
        let made = Data::new(poses, seconds, fps, &options)?.made(&options, poses.len(), progress);
        match made {
            Ok(made) if made.path.points.len() <= points => {
                high = middle;
                best = Some((made, options.tolerance));
            }
            // Or more than any path may have.
            Ok(_) | Err(Error::Limit(_)) => low = middle,
            Err(error) => return Err(error),
        }
    }
    best.ok_or_else(|| OutOfRange::TooFewFittedPoints.into())
}

/// How closely a path follows its poses.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Follow {
    /// Without their noise.
    Smoothly,
    /// Through each at a whole frame.
    Exactly,
    /// With points at the poses only.
    ByPoints,
}

impl Data {
    fn made(&mut self, options: &Options, poses: usize, progress: Progress<'_>) -> Result<Fitted> {
        if options.robust {
            self.leave_out()?;
        }
        (self.cuts, self.gaps) = self.jumps()?;
        let Made { path, measured, .. } = self.best(progress)?;
        let outliers = self.outliers();
        let mut left_out = vec_with_room(outliers.clone().count())?;
        left_out.extend(outliers);
        let report = self.report(&path, &measured, poses)?;
        Ok(Fitted {
            path,
            left_out,
            report,
            deviations: measured.each,
        })
    }

    /// Whether all poses are one within the tolerance.
    fn stands(&self) -> bool {
        let start = &self.calm[0];
        self.calm.iter().all(|sample| {
            sample.position.distance(start.position) <= self.tolerance
                && start.off(sample.turn, sample.zoom) <= self.angle
        })
    }

    const fn joint(&self, sample: Sample) -> Joint {
        Joint {
            sample,
            zoom_slope: None,
            bend: DVec3::ZERO,
        }
    }

    /// The pieces; none if they are more than `most`.
    fn pieces(
        &mut self,
        follow: Follow,
        most: usize,
        progress: Progress<'_>,
    ) -> Result<Option<Pieces>> {
        let last = self.raw.len() - 1;
        let mut go_on = |done: usize| {
            if progress(done, last) {
                return Ok(());
            }
            Err(Error::from(Invalid::Cancelled))
        };
        let exact = follow != Follow::Smoothly;
        let motion = self.motion(follow, &mut || go_on(0))?;
        let mut pieces: Vec<Piece> = Vec::new();
        let mut joint = self.joint(motion.stretches[0].at(0.0).sample);
        let (mut number, mut moving) = (0, 0);
        while number < motion.parts.len() {
            let cut = self.is_cut(&motion.parts[number]);
            let (over, mut whole) = match follow {
                _ if cut => (1, Some(self.crossing(&motion, number, joint)?)),
                Follow::ByPoints => (1, None),
                _ => self.over_corners(&motion, number, joint, exact)?,
            };
            let stretch = &motion.stretches[number];
            let [begin, end] = stretch.frames;
            let (mut at, mut guess) = (begin, 8.0);
            while at < end {
                let mut piece = match whole.take() {
                    Some(piece) => piece,
                    None if follow == Follow::ByPoints => {
                        let next = self.next_pose(at).min(end);
                        self.to_next_pose(stretch, [at, next], joint)?
                    }
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
                    if moving >= most {
                        return Ok(None);
                    }
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
        Ok(Some(Pieces {
            all: pieces,
            end: joint.sample,
            even: motion.peaks.even,
        }))
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
            self.rest(&mut points, piece.start, hold, [before, Some(piece)])?;
            (before, hold) = (Some(piece), 0);
        }
        self.rest(&mut points, end, hold, [before, None])?;
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

/// The vertical field of view (radians) of a picture 24 mm high.
fn view_angle(zoom: f64) -> f64 {
    2.0 * (12.0 / zoom).atan()
}

#[cfg(test)]
#[path = "fit_tests.rs"]
mod tests;
