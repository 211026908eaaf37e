//! What holds for a whole path: base speeds, and how the curve, the turning and the zoom run.

use super::space::Space;
use crate::error::{Invalid, Result};
use crate::property::{Affects, Check, Row, Unit, choices, properties};

properties! {
    /// The four base speeds (thesis B.2.2): frames for one unit of change at speed 50, finite and > 0.
    #[derive(Copy)]
    pub struct BaseFrames {
        /// `move_speed`: frames for a way of one half size of the space.
        pub movement: f64 = 100.0 => base_speed(&["move_frames"]),
        /// `orient_speed`: frames for turning the view by 180°.
        pub turning: f64 = 100.0 => base_speed(&["turn_frames"]),
        /// `zoom_speed`: frames for the zoom from 1 to 100.
        pub zoom: f64 = 100.0 => base_speed(&["zoom_frames"]),
        /// `winkel_speed`: frames for rolling by 90°.
        pub rolling: f64 = 100.0 => base_speed(&["roll_frames"]),
    }
}

const fn base_speed(keys: &'static [&'static str]) -> Row<f64> {
    Row {
        unit: Unit::Frames,
        check: Check::By(|speed, _| check_base_speed(*speed)),
        always: true,
        affects: Affects::Frames,
        ..Row::new(keys)
    }
}

impl Default for BaseFrames {
    /// 100 each, as in the host program of Anhang C.
    fn default() -> Self {
        Self::NEW
    }
}

choices! {
    /// How the camera turns between its orientations (`docs/path.md`, orientation curve).
    pub enum OrientationMode {
        /// Cubic spherical Bézier curve with limited angular velocities.
        #[default]
        Tcb = "tcb",
        /// Barry and Goldman's curve with knots at the times (thesis 4.4.4).
        BarryGoldman = "barry-goldman",
        /// Great arcs from key to key.
        Slerp = "slerp",
    }
}

choices! {
    /// How the curve leads through its points (`docs/path.md`, position curve).
    pub enum CurveKind {
        /// Kochanek and Bartels, by tension, continuity and bias.
        #[default]
        Tcb = "tcb",
        /// Cubic spline: the second derivative is continuous too.
        Cubic = "cubic",
        /// Straight from point to point.
        Linear = "linear",
    }
}

choices! {
    /// How the zoom runs between its keys (`docs/path.md`, zoom).
    pub enum ZoomMode {
        /// Monotone cubic (Fritsch and Carlson 1980).
        #[default]
        Smooth = "smooth",
        /// Straight lines, as in the thesis.
        Linear = "linear",
    }
}

/// One base speed: finite and > 0.
///
/// # Errors
/// [`crate::Error::Argument`].
pub fn check_base_speed(speed: f64) -> Result<()> {
    if !(speed > 0.0 && speed.is_finite()) {
        return Err(Invalid::BaseSpeed.into());
    }
    Ok(())
}

/// All four finite and > 0.
///
/// # Errors
/// [`crate::Error::Argument`] otherwise.
pub fn check_base_frames(frames: BaseFrames) -> Result<()> {
    let mut rows = BaseFrames::PROPERTIES.iter();
    rows.try_for_each(|row| (row.check)(&frames, Space::NEW))
}
