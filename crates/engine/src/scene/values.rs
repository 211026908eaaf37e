//! What moves of a node: its values at a frame, or where nothing moves it.

use glam::{DQuat, DVec3};

use super::channel::Channel;
use super::state::Looks;
use crate::error::{Error, Invalid, OutOfRange, Place, Quantity, Result};
use crate::limits::{MAX_COORDINATE, MAX_ZOOM, MIN_ZOOM};
use crate::path::camera_path::check_coordinates;
use crate::path::quaternion_spline::normalized;
use crate::path::space::Space;
use crate::property::{Check, Row, Unit, properties};

properties! {
    /// Everything of a node that can move, at one moment.
    #[derive(Copy)]
    pub struct Values {
        /// In the parent's coordinates.
        pub position: DVec3 = DVec3::ZERO => Row {
            check: Check::By(|place, _| finite(*place, Place::Position)),
            unit: Unit::Length,
            ..Row::new(&["position"])
        },
        /// Of any length but zero.
        pub rotation: DQuat = DQuat::IDENTITY => Row {
            check: Check::By(|q, _| {
                let error = |_| Error::Argument(Invalid::RotationZero);
                normalized(*q).map(drop).map_err(error)
            }),
            ..Row::new(&["rotation"])
        },
        /// Factors along its own axes; negative ones mirror.
        pub scale: DVec3 = DVec3::ONE => Row {
            check: Check::By(|factors, _| finite(*factors, Place::Scale)),
            ..Row::new(&["scale"])
        },
        /// Lights and objects: linear red, green, blue, each ≥ 0.
        pub colour: [f64; 3] = [1.0; 3] => Row {
            check: Check::By(|colour, _| {
                let bright = colour.iter().all(|part| (0.0..=MAX_COORDINATE).contains(part));
                bright.then_some(()).ok_or(OutOfRange::Colour.into())
            }),
            ..Row::new(&["colour"])
        },
        /// Lights: half angles, inner and outer, 0…90.
        pub cone: [f64; 2] = [20.0, 30.0] => Row {
            check: Check::By(|&[inner, outer], _| {
                let nested = 0.0 <= inner && inner <= outer && outer <= 90.0;
                nested.then_some(()).ok_or(OutOfRange::Cone.into())
            }),
            unit: Unit::Degrees,
            ..Row::new(&["cone_degrees"])
        },
        /// Cameras: focal length, 1…2000.
        pub zoom: f64 = 24.0 => Row {
            check: Check::Between(Quantity::Zoom, MIN_ZOOM, MAX_ZOOM),
            unit: Unit::Millimetres,
            ..Row::new(&["zoom_mm"])
        },
        /// Cameras: turns up about the view.
        pub roll: f64 = 0.0 => Row {
            check: Check::By(|roll, _| {
                let finite = (-MAX_COORDINATE..=MAX_COORDINATE).contains(roll);
                finite.then_some(()).ok_or(Invalid::NotFinite(Quantity::Roll).into())
            }),
            unit: Unit::Degrees,
            ..Row::new(&["roll_degrees"])
        },
        /// Lights: ≥ 0.
        pub intensity: f64 = 1.0 => Row {
            check: Check::Between(Quantity::Intensity, 0.0, MAX_COORDINATE),
            ..Row::new(&["intensity"])
        },
        /// How far it turns to what it aims at.
        pub aim_weight: f64 = 1.0 => Row {
            check: Check::Between(Quantity::AimWeight, 0.0, 1.0),
            ..Row::new(&["aim_weight"])
        },
        /// Hidden nodes hide their children.
        pub visible: bool = true => Row::new(&["visible"]),
    }
}

fn finite(vector: DVec3, place: Place) -> Result<()> {
    check_coordinates(vector).map_err(|error| error.at(place))
}

impl Default for Values {
    fn default() -> Self {
        Self::NEW
    }
}

impl Values {
    pub(super) const fn looks(&self) -> Looks {
        (self.colour, self.intensity, self.cone, self.visible)
    }

    /// Sets the numbers of a channel; false if it is not one of these, or has another number of
    /// values.
    pub fn set(&mut self, channel: &Channel, numbers: &[f64]) -> bool {
        match (channel, numbers) {
            (Channel::Position, &[x, y, z]) => self.position = DVec3::new(x, y, z),
            (Channel::Rotation, &[w, x, y, z]) => self.rotation = DQuat::from_xyzw(x, y, z, w),
            (Channel::Scale, &[x, y, z]) => self.scale = DVec3::new(x, y, z),
            (Channel::Visible, &[visible]) => self.visible = visible != 0.0,
            (Channel::Zoom, &[zoom]) => self.zoom = zoom,
            (Channel::Roll, &[roll]) => self.roll = roll,
            (Channel::Colour, &[r, g, b]) => self.colour = [r, g, b],
            (Channel::Intensity, &[intensity]) => self.intensity = intensity,
            (Channel::Cone, &[inner, outer]) => self.cone = [inner, outer],
            (Channel::AimWeight, &[weight]) => self.aim_weight = weight,
            _ => return false,
        }
        true
    }

    /// Everything finite and in range.
    ///
    /// # Errors
    /// The first one that is not.
    pub fn check(&self) -> Result<()> {
        let mut rows = Self::PROPERTIES.iter();
        rows.try_for_each(|row| (row.check)(self, Space::default()))
    }
}
