//! How well a path follows the poses that it was made of.

use std::fmt;

use super::Tolerance;
use super::time_unit::TimeUnit;

/// How far poses are missed.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Deviation {
    /// The greatest distance.
    pub greatest: f64,
    /// The root of the mean of its squares.
    pub rms: f64,
}

/// How far a path is from one of the poses that it was made of.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PoseDeviation {
    /// Where in the path, in frames from 1.
    pub frame: f64,
    /// The distance of the positions.
    pub position: f64,
    /// Of view with up, or of the vertical field of view, the greater, in degrees.
    pub angle: f64,
}

/// How well a path follows its poses, and what was found in them. Poses that were left out or
/// dropped do not count.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Report {
    /// Points of the path.
    pub points: usize,
    /// Poses of the recording.
    pub poses: usize,
    /// Of positions, in the unit of the poses.
    pub position: Deviation,
    /// Of views with their up, in degrees.
    pub view: Deviation,
    /// Of vertical fields of view, in degrees.
    pub lens: Deviation,
    /// Frames per second.
    pub fps: f64,
    /// Points at which the camera rests.
    pub holds: usize,
    /// Times between poses that are more than five times as long as usual.
    pub gaps: usize,
    /// Poses at which the camera is suddenly elsewhere; poses within the frame in which the path
    /// crosses a cut do not count.
    pub cuts: usize,
    /// Poses that a robust fit left out.
    pub outliers: usize,
    /// Poses at the time of the one before, which were dropped.
    pub dropped: usize,
    /// What the times count, if they were too great for seconds.
    pub unit: Option<TimeUnit>,
    /// Standard deviation of the noise of a coordinate of the positions, estimated from their third
    /// differences.
    pub noise: f64,
    /// Likewise of the noise of the views about an axis, in degrees.
    pub turning_noise: f64,
    /// A larger tolerance that needs at most half as many points, and how many, where more than a
    /// third of the poses became points.
    pub better: Option<(Tolerance, usize)>,
    /// Outliers that a robust fit leaves out, and the points that it then needs, where these are at
    /// most two thirds as many and the fit was not robust.
    pub robust: Option<(usize, usize)>,
}

impl fmt::Display for Report {
    /// A line for the path, one for what was found in the recording if anything was, one for what
    /// helps if there are too many points.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { points, poses, .. } = self;
        let [place, view, lens] = [self.position, self.view, self.lens];
        write!(
            f,
            "{points} points for {poses} poses at {} frames per second; greatest and RMS deviation: \
             position {:.3e} and {:.3e}, view {:.3}° and {:.3}°, field of view {:.3}° and {:.3}°",
            self.fps, place.greatest, place.rms, view.greatest, view.rms, lens.greatest, lens.rms,
        )?;
        let found = [
            (self.holds, "hold"),
            (self.gaps, "gap"),
            (self.cuts, "cut"),
            (self.outliers, "outlier"),
            (self.dropped, "repeated time"),
        ];
        let mut between = "\nfound: ";
        for (count, what) in found.into_iter().filter(|found| found.0 > 0) {
            let several = if count == 1 { "" } else { "s" };
            write!(f, "{between}{count} {what}{several}")?;
            between = ", ";
        }
        if let Some(unit) = self.unit {
            write!(f, "{between}times in {}", unit.name())?;
        }
        if let Some((tolerance, points)) = self.better {
            write!(
                f,
                "\nnoise of about {:.1e} and {:.2}°: a tolerance of {:.1e} with an angle of {}° gives \
                 {points} points",
                self.noise, self.turning_noise, tolerance.position, tolerance.angle,
            )?;
        }
        if let Some((outliers, points)) = self.robust {
            let several = if outliers == 1 { "" } else { "s" };
            write!(
                f,
                "\n{outliers} outlier{several}: a robust fit leaves out so many and gives {points} points"
            )?;
        }
        Ok(())
    }
}

/// By how much a path misses the poses.
pub(super) struct Measured {
    /// In tolerances.
    pub worst: f64,
    pub position: Deviation,
    pub view: Deviation,
    pub lens: Deviation,
    pub each: Vec<PoseDeviation>,
}

impl Deviation {
    pub(super) fn add(&mut self, off: f64) {
        self.greatest = self.greatest.max(off);
        self.rms += off * off;
    }

    pub(super) fn mean(self, count: usize) -> Self {
        Self {
            rms: (self.rms / count.max(1) as f64).sqrt(),
            ..self
        }
    }
}
