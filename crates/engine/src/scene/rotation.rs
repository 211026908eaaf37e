//! Turning between the keys of a track.

use glam::DQuat;

use crate::error::{Error, Invalid, OutOfRange, Result, vec_with_room};
use crate::math::quaternion::{angle, continue_sign, continue_signs, exp, log};
use crate::math::vector::{Vector, each, horner};
use crate::path::Tcb;
use crate::path::quaternion_spline::{bezier, normalized, tcb_section};

pub(super) fn quaternion(wxyz: &[f64]) -> DQuat {
    DQuat::from_xyzw(wxyz[1], wxyz[2], wxyz[3], wxyz[0])
}

pub(super) fn wxyz(q: DQuat) -> [f64; 4] {
    [q.w, q.x, q.y, q.z]
}

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

/// sin θ/θ in powers of θ² ≤ (π/2)²; error 2.3e-17. A Chebyshev fit.
const SINC: [f64; 9] = [
    1.0,
    -0.16666666666666666,
    0.008333333333333316,
    -0.00019841269841254974,
    2.755731921916323e-06,
    -2.5052107616995878e-08,
    1.6058977312444268e-10,
    -7.643970296165793e-13,
    2.73144475909634e-15,
];

/// A great arc by the shorter way.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct GreatArc {
    pub from: DQuat,
    pub to: DQuat,
    /// Of the angle; 0 where it is as good as straight.
    pub square: f64,
    /// The angle by its sine.
    pub inverse: f64,
}

/// The weights of both ends of an arc at the share `u`: polynomials instead of three sines, so that
/// arcs side by side take no branch. At most a quarter of the great circle, they do not cancel.
#[inline(always)]
pub(super) fn arc_weights<V: Vector>(square: V, inverse: V, u: V) -> [V; 2] {
    each!(share in [V::splat(1.0).sub(u), u] => {
        let sinc = horner::<V, 9>(&SINC, share.mul(share).mul(square));
        share.mul(sinc).mul(inverse)
    })
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Between {
    /// No rotation.
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

    /// The great arc of a section, if it is one; the last key stays.
    pub(super) fn arc(&self, section: usize) -> Option<GreatArc> {
        match &self.sections {
            Sections::Arcs(arcs) => Some(match arcs.get(section) {
                Some(arc) => *arc,
                None => GreatArc::still(self.keys[section]),
            }),
            _ => None,
        }
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
    /// One that stays.
    pub(super) const fn still(q: DQuat) -> Self {
        Self {
            from: q,
            to: q,
            square: 0.0,
            inverse: 1.0,
        }
    }

    fn new(from: DQuat, to: DQuat) -> Self {
        let (to, _) = continue_sign(from, to);
        let angle = angle(from, to);
        let (square, inverse) = if angle < STRAIGHT {
            (0.0, 1.0)
        } else {
            (angle * angle, angle / angle.sin())
        };
        Self {
            from,
            to,
            square,
            inverse,
        }
    }

    fn at(&self, u: f64) -> DQuat {
        let [a, b] = arc_weights(self.square, self.inverse, u);
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
