//! What moves of a node: its values at a frame, or where nothing moves it.

use glam::{DQuat, DVec3};

use super::state::Looks;
use crate::error::{Error, Invalid, OutOfRange, Place, Quantity, Result};
use crate::limits::MAX_COORDINATE;
use crate::path::camera_path::{check_coordinates, check_zoom};
use crate::path::quaternion_spline::normalized;

/// Everything of a node that can move, at one moment.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Values {
    /// In the parent's coordinates.
    pub position: DVec3,
    /// Of any length but zero.
    pub rotation: DQuat,
    /// Factors along its own axes; negative ones mirror.
    pub scale: DVec3,
    /// Hidden nodes hide their children.
    pub visible: bool,
    /// Cameras: 1…2000, mm.
    pub zoom: f64,
    /// Cameras: degrees, turns up about the view.
    pub roll: f64,
    /// Lights and objects: linear red, green, blue, each ≥ 0.
    pub colour: [f64; 3],
    /// Lights: ≥ 0.
    pub intensity: f64,
    /// Lights: half angles in degrees, inner and outer, 0…90.
    pub cone: [f64; 2],
    /// How far it turns to what it aims at, 0…1.
    pub aim_weight: f64,
}

impl Default for Values {
    fn default() -> Self {
        Self {
            position: DVec3::ZERO,
            rotation: DQuat::IDENTITY,
            scale: DVec3::ONE,
            visible: true,
            zoom: 24.0,
            roll: 0.0,
            colour: [1.0; 3],
            intensity: 1.0,
            cone: [20.0, 30.0],
            aim_weight: 1.0,
        }
    }
}

impl Values {
    pub(super) const fn looks(&self) -> Looks {
        (self.colour, self.intensity, self.cone, self.visible)
    }

    /// Everything finite and in range.
    ///
    /// # Errors
    /// The first one that is not.
    pub fn check(&self) -> Result<()> {
        check_coordinates(self.position).map_err(|error| error.at(Place::Position))?;
        normalized(self.rotation).map_err(|_| Error::Argument(Invalid::RotationZero))?;
        check_coordinates(self.scale).map_err(|error| error.at(Place::Scale))?;
        check_zoom(self.zoom)?;
        if !self.roll.is_finite() || self.roll.abs() > MAX_COORDINATE {
            return Err(Invalid::NotFinite(Quantity::Roll).into());
        }
        let bright = |value: f64| (0.0..=MAX_COORDINATE).contains(&value);
        if !self.colour.into_iter().all(bright) {
            return Err(OutOfRange::Colour.into());
        }
        if !bright(self.intensity) {
            return Err(OutOfRange::Between(Quantity::Intensity, 0.0, MAX_COORDINATE).into());
        }
        let [inner, outer] = self.cone;
        if !(0.0 <= inner && inner <= outer && outer <= 90.0) {
            return Err(OutOfRange::Cone.into());
        }
        if !(0.0..=1.0).contains(&self.aim_weight) {
            return Err(OutOfRange::Between(Quantity::AimWeight, 0.0, 1.0).into());
        }
        Ok(())
    }
}
