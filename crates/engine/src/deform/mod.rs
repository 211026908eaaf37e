//! Deformations of space (lecture 9.3.1): taper, twist, bend and free form.
//!
//! Each acts on points in the coordinates u, v, w of a box, −1…1 from side to side; the coordinate
//! across a flat side stays. Axes run cyclically, right-handed: beside axis k lie k + 1 and k + 2.
//! It knows nothing of who asks: objects of a scene and points of a path are deformed alike.

mod bend;
mod bounds;
pub(crate) mod formula;
mod free_form;

use glam::DVec3;

use crate::error::{Error, Invalid, OutOfRange, Quantity, Result, vec_with_room};

pub use bounds::Bounds;
use formula::{FORMULAS, Formula};
pub use formula::{LATTICE, counts};
pub use free_form::identity_lattice;

/// The largest angle in degrees: a thousand turns.
const MAX_ANGLE: f64 = 360_000.0;

/// A deformation: its kind and its numbers, in the order in which a caller gives them.
#[derive(Debug, Clone, PartialEq)]
pub struct Deformation {
    formula: Formula,
    parameters: Vec<f64>,
}

impl Deformation {
    /// By its kind, `taper`, `twist`, `bend` or `free-form`; angles in degrees, axes 0, 1, 2.
    ///
    /// # Errors
    /// [`Error::Argument`] for the kind; that, [`Error::Range`] for parameters; [`Error::Memory`].
    pub fn new(kind: &str, parameters: &[f64]) -> Result<Self> {
        let Some(known) = FORMULAS.iter().find(|formula| formula.kind() == kind) else {
            return Err(Invalid::NoDeformation(kind.into()).into());
        };
        let formula = FORMULAS
            .into_iter()
            .find(|formula| formula.kind() == kind && formula.count() == parameters.len())
            .ok_or_else(|| {
                Error::Range(OutOfRange::DeformationNumbers {
                    deformation: known.kind(),
                    given: parameters.len(),
                })
            })?;
        let mut kept = vec_with_room(parameters.len())?;
        kept.extend_from_slice(parameters);
        let made = Self {
            formula,
            parameters: kept,
        };
        made.check()?;
        Ok(made)
    }

    fn check(&self) -> Result<()> {
        let (axes, numbers) = self.parameters.split_at(self.formula.axes());
        if !axes.iter().all(|axis| [0.0, 1.0, 2.0].contains(axis)) {
            return Err(OutOfRange::DeformationAxis.into());
        }
        if self.formula == Formula::Polar && axes[0] == axes[1] {
            return Err(Invalid::BendAxes.into());
        }
        numbers.iter().try_for_each(|&number| check_number(number))
    }

    /// The name of the kind.
    #[must_use]
    pub const fn kind(&self) -> &'static str {
        self.formula.kind()
    }

    /// The parameters as they were given.
    #[must_use]
    pub fn parameters(&self) -> &[f64] {
        &self.parameters
    }

    /// The names of the parameters that may change in time, with their widths.
    pub fn channels(&self) -> impl Iterator<Item = (&'static str, usize)> + use<> {
        let channels = self.formula.channels().iter();
        channels.map(|&(name, _, width)| (name, width))
    }

    /// The numbers of one of these parameters, or which there are.
    pub(crate) fn parameter(&self, name: &str) -> Result<&[f64]> {
        self.channel(name).ok_or_else(|| {
            let missing = Invalid::NoParameter {
                deformation: self.formula.kind(),
                parameter: name.into(),
                parameters: self.formula.channels(),
            };
            missing.into()
        })
    }

    /// The numbers of one of these parameters.
    #[must_use]
    pub fn channel(&self, name: &str) -> Option<&[f64]> {
        Some(&self.parameters[self.formula.range(name)?])
    }

    /// The same, to be changed. Numbers that are not finite make points that are not: check before.
    pub fn channel_mut(&mut self, name: &str) -> Option<&mut [f64]> {
        Some(&mut self.parameters[self.formula.range(name)?])
    }

    /// Deforms points. Outside the box taper, twist and the lecture's bend clamp the coordinate
    /// that they depend on, the bend by an angle goes on straight, free form leaves points alone.
    pub fn apply(&self, bounds: &Bounds, points: &mut [DVec3]) {
        let p = &self.parameters[..];
        let axis = |at: usize| p[at] as usize;
        match self.formula {
            Formula::Bulge => taper(bounds, axis(0), points, |u| {
                1.0 + (p[1] - 1.0) * (1.0 - u * u)
            }),
            Formula::Taper => taper(bounds, axis(0), points, |u| {
                p[1] * ((1.0 - u) / 2.0) + p[2] * ((1.0 + u) / 2.0)
            }),
            Formula::Twist => twist(bounds, axis(0), p[1].to_radians(), points),
            Formula::Bend => bend::by_angle(bounds, axis(0), p[1].to_radians(), points),
            Formula::Polar => {
                let angles = [p[4].to_radians(), p[5].to_radians()];
                bend::polar(bounds, [axis(0), axis(1)], [p[2], p[3]], angles, points);
            }
            Formula::Lattice => free_form::apply(bounds, p, points),
        }
    }
}

/// One number of a deformation: finite, and small enough to compute with.
///
/// # Errors
/// [`Error::Argument`] or [`Error::Range`].
pub fn check_number(number: f64) -> Result<()> {
    if !number.is_finite() {
        return Err(Invalid::NotFinite(Quantity::Parameter).into());
    }
    if number.abs() > MAX_ANGLE {
        return Err(OutOfRange::Exceeds(Quantity::Parameter, MAX_ANGLE).into());
    }
    Ok(())
}

/// Scales across an axis by a function of the coordinate along it.
fn taper(bounds: &Bounds, axis: usize, points: &mut [DVec3], scale: impl Fn(f64) -> f64) {
    let (a, b) = ((axis + 1) % 3, (axis + 2) % 3);
    for point in points {
        let r = scale(bounds.coordinate(*point, axis).clamp(-1.0, 1.0));
        for k in [a, b] {
            let along = bounds.coordinate(*point, k);
            bounds.place(point, k, r * along);
        }
    }
}

/// Turns about an axis by `angle` (radians) from end to end.
fn twist(bounds: &Bounds, axis: usize, angle: f64, points: &mut [DVec3]) {
    let (a, b) = ((axis + 1) % 3, (axis + 2) % 3);
    let (low, high) = (bounds.min(), bounds.max());
    let middle = low / 2.0 + high / 2.0;
    let size = [0, 1, 2].map(|axis| bounds.size(axis));
    // Of one side in the other, since u and v turn into each other; a flat side has coordinate 0.
    let ratio = |of: usize, by: usize| {
        if size[by] > 0.0 {
            size[of] / size[by]
        } else {
            0.0
        }
    };
    let (uv, vu) = (ratio(a, b), ratio(b, a));
    let (begin, step) = if size[axis] > 0.0 {
        (0.0, angle / size[axis])
    } else {
        (angle / 2.0, 0.0)
    };
    for point in points {
        let along = point[axis].clamp(low[axis], high[axis]) - low[axis];
        let (sin, cos) = (begin + step * along).sin_cos();
        let (u, v) = (point[a] - middle[a], point[b] - middle[b]);
        if size[a] > 0.0 {
            point[a] = middle[a] + (cos * u - sin * (uv * v));
        }
        if size[b] > 0.0 {
            point[b] = middle[b] + (sin * (vu * u) + cos * v);
        }
    }
}

#[cfg(test)]
mod tests;
