//! Turning between the keys of a track.

use glam::DQuat;

use super::keys::quaternion;
use crate::error::{Error, Invalid, OutOfRange, Result, vec_with_room};
use crate::math::quaternion::{angle, continue_sign, continue_signs, exp, log};
use crate::path::Tcb;
use crate::path::quaternion_spline::{bezier, normalized, tcb_section};

/// Below this angle an arc is as good as straight.
const STRAIGHT: f64 = 1e-12;

/// The keys of a rotation track, and what lies between them.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Turns {
    /// Of length 1; those that had it are kept as they were given.
    keys: Vec<DQuat>,
    sections: Sections,
}

#[derive(Debug, Clone, PartialEq)]
enum Sections {
    None,
    Arcs(Vec<GreatArc>),
    Beziers(Vec<[DQuat; 4]>),
}

/// A great arc by the shorter way.
#[derive(Debug, Clone, Copy, PartialEq)]
struct GreatArc {
    from: DQuat,
    to: DQuat,
    angle: f64,
    /// 1/sin of it; 0 where it is as good as straight.
    scale: f64,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Between {
    /// Nothing of its own.
    Keys,
    Arcs,
    /// The tcb curve.
    Smooth,
}

impl Turns {
    /// Prepares keys of four numbers, w first. `tcb` counts for smooth curves.
    pub(super) fn new(
        frames: &[f64],
        wxyz: &[f64],
        between: Between,
        tcb: impl Fn(usize) -> Tcb,
    ) -> Result<Self> {
        let mut keys = vec_with_room(frames.len())?;
        for numbers in wxyz.chunks_exact(4) {
            keys.push(unit(quaternion(numbers))?);
        }
        let sections = match between {
            Between::Keys => Sections::None,
            Between::Arcs => {
                let mut arcs = vec_with_room(keys.len().saturating_sub(1))?;
                arcs.extend(keys.windows(2).map(|pair| GreatArc::new(pair[0], pair[1])));
                Sections::Arcs(arcs)
            }
            Between::Smooth => Sections::Beziers(smooth(frames, &keys, tcb)?),
        };
        Ok(Self { keys, sections })
    }

    pub(super) fn key(&self, at: usize) -> DQuat {
        self.keys[at]
    }

    /// The orientation at the share `u` of a section.
    pub(super) fn between(&self, section: usize, u: f64) -> DQuat {
        match &self.sections {
            Sections::None => self.keys[section],
            Sections::Arcs(arcs) => arcs[section].at(u),
            Sections::Beziers(curves) => bezier(&curves[section], u).normalize(),
        }
    }

    /// `rounds` times the turn from the first key to the last one, then `q`.
    pub(super) fn offset(&self, q: DQuat, rounds: f64) -> DQuat {
        let (first, last) = (self.keys[0], self.keys[self.keys.len() - 1]);
        let turn = last * first.conjugate();
        let turn = if turn.w < 0.0 { -turn } else { turn };
        (exp(log(turn) * rounds) * q).normalize()
    }
}

impl GreatArc {
    fn new(from: DQuat, to: DQuat) -> Self {
        let (to, _) = continue_sign(from, to);
        let angle = angle(from, to);
        let scale = if angle < STRAIGHT {
            0.0
        } else {
            1.0 / angle.sin()
        };
        Self {
            from,
            to,
            angle,
            scale,
        }
    }

    /// An arc is at most a quarter of the great circle, so that the weights do not cancel.
    fn at(&self, u: f64) -> DQuat {
        if self.scale == 0.0 {
            return self.from * (1.0 - u) + self.to * u;
        }
        let a = ((1.0 - u) * self.angle).sin() * self.scale;
        let b = (u * self.angle).sin() * self.scale;
        self.from * a + self.to * b
    }
}

/// `q` with length 1; unchanged where it has that to 1e-12.
pub(super) fn unit(q: DQuat) -> Result<DQuat> {
    if (q.length_squared() - 1.0).abs() <= 1e-12 {
        return Ok(q);
    }
    normalized(q).map_err(|_| Error::Argument(Invalid::RotationZero))
}

/// The tcb curve of paths, without the limiter.
fn smooth(frames: &[f64], keys: &[DQuat], tcb: impl Fn(usize) -> Tcb) -> Result<Vec<[DQuat; 4]>> {
    let count = keys.len();
    let mut signed: Vec<DQuat> = vec_with_room(count)?;
    signed.extend_from_slice(keys);
    continue_signs(&mut signed);
    let mut sections = vec_with_room(count.saturating_sub(1))?;
    for section in 0..count.saturating_sub(1) {
        let control = tcb_section(&signed, frames, &tcb, section);
        if !control.iter().all(|q| q.is_finite()) {
            return Err(OutOfRange::KeyDistance.into());
        }
        sections.push(control);
    }
    Ok(sections)
}
