//! Where two sections meet at equal speeds the acceleration goes on too (thesis 5.2.1;
//! `docs/theory/path.md`, joints).

use super::camera_path::Orientation;
use super::own::Pace;
use super::speed_curve::{CurveEnd, INTERVALS, SpeedCurve};
use super::timing::{Timing, facing};
use crate::error::Result;

/// Facing speeds that differ by no more are equal: those of a part of a pace are rounded.
const EQUAL: f64 = 1e-9;

/// How much steeper a joint may be than a step from it to the next of the ten speeds. So a curve
/// rises and falls there only where its speeds do. The section may take longer by its slopes than
/// the step is measured by; up to 1.62 that still leaves it in [1, 100].
const STEEPEST: f64 = 1.5;

/// A section that moves, as its neighbours' speed curves see it.
#[derive(Debug, Clone, Copy)]
pub struct Neighbour<'a> {
    /// The orientation with which it begins.
    pub orientation: &'a Orientation,
    /// Its frames at a mean speed of 1, not rounded. Without any it has no joints.
    pub work: f64,
}

/// What a section brings to one of its ends.
enum Side {
    /// The frames of the outermost of nine intervals, were the ten speeds joined by straight
    /// lines, and the change of the speed per frame there.
    Step(f64, f64),
    /// The change of the speed per frame of another pace than ten speeds.
    Own(f64),
}

impl<'a> Neighbour<'a> {
    /// Its pace between two others.
    ///
    /// # Errors
    /// [`crate::Error::Memory`].
    pub fn timing(self, before: Option<Self>, after: Option<Self>) -> Result<Timing> {
        Timing::new(self.orientation, self.curve_ends(before, after)?)
    }

    /// What shapes the curve of its ten speeds between two others.
    ///
    /// # Errors
    /// [`crate::Error::Memory`].
    pub fn curve_ends(self, before: Option<Self>, after: Option<Self>) -> Result<[CurveEnd; 2]> {
        let mut ends = [CurveEnd::Free; 2];
        if self.orientation.own.pace != Pace::Speeds {
            return Ok(ends);
        }
        let mut joints = [None; 2];
        if let Some(before) = before {
            ends[0] = CurveEnd::Facing(facing(before.orientation)[1]);
            joints[0] = joint(before, self)?;
        }
        if let Some(after) = after {
            ends[1] = CurveEnd::Facing(facing(after.orientation)[0]);
            joints[1] = joint(self, after)?;
        }
        let [start, end] = joints.map(Option::unwrap_or_default);
        for side in 0..2 {
            if joints[side].is_some() {
                ends[side] = CurveEnd::Slope(0.0);
            }
        }
        if start == 0.0 && end == 0.0 {
            return Ok(ends);
        }
        let frames = match self.orientation.own.frames {
            // The mean speed is a + b·frames, and frames · mean is the work: the smaller root.
            0 => {
                let a = SpeedCurve::new(&self.orientation.speeds, ends).mean();
                let b = (start - end) / (12 * INTERVALS * INTERVALS) as f64;
                2.0 * self.work / (a + (a * a + 4.0 * b * self.work).max(0.0).sqrt())
            }
            fixed => f64::from(fixed),
        };
        for side in 0..2 {
            if let Some(acceleration) = joints[side] {
                ends[side] = CurveEnd::Slope(acceleration * frames);
            }
        }
        Ok(ends)
    }

    fn frames(self, mean: f64) -> f64 {
        match self.orientation.own.frames {
            0 => self.work / mean,
            fixed => f64::from(fixed),
        }
    }

    /// What it brings to its beginning (0) or its end (1).
    fn side(self, side: usize) -> Result<Side> {
        let Orientation { speeds: v, own, .. } = self.orientation;
        if own.pace != Pace::Speeds {
            let timing = Timing::new(self.orientation, [CurveEnd::Free; 2])?;
            // Within the part also where the acceleration of its whole jumps.
            let u = [0.0, 1.0 - 4.0 * f64::EPSILON][side];
            return Ok(Side::Own(
                timing.acceleration(u) / self.frames(timing.mean()),
            ));
        }
        let sum: f64 = v
            .windows(2)
            .map(|pair| f64::midpoint(pair[0], pair[1]))
            .sum();
        let length = self.frames(sum / INTERVALS as f64) / INTERVALS as f64;
        let rise = [v[1] - v[0], v[INTERVALS] - v[INTERVALS - 1]][side];
        Ok(Side::Step(length, rise / length))
    }
}

/// The change of the speed per frame where one section goes over into the next; `None` where the
/// facing speeds do not hold at one instant or differ.
fn joint(before: Neighbour<'_>, after: Neighbour<'_>) -> Result<Option<f64>> {
    let [left, right] = [facing(before.orientation)[1], facing(after.orientation)[0]];
    let moves = before.work > 0.0 && after.work > 0.0;
    if !moves || after.orientation.hold > 0 || (left - right).abs() > EQUAL {
        return Ok(None);
    }
    let sides = [before.side(1)?, after.side(0)?];
    let mut acceleration = match sides {
        // The derivative of the parabola through the three speeds.
        [Side::Step(a, rise), Side::Step(b, next)] => (b * rise + a * next) / (a + b),
        [Side::Own(own), _] | [_, Side::Own(own)] => own,
    };
    for side in sides {
        if let Side::Step(_, step) = side {
            let most = STEEPEST * step;
            acceleration = acceleration.max(most.min(0.0)).min(most.max(0.0));
        }
    }
    Ok(Some(acceleration))
}

#[cfg(test)]
#[path = "joint_tests.rs"]
mod tests;
