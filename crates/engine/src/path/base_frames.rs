//! The base speeds of a path.

use super::cube::Space;
use crate::error::{Invalid, Result};
use crate::property::table::{Affects, Check, Row, Unit, properties};

properties! {
    /// The four base speeds (thesis B.2.2): frames for one unit of change at speed 50, finite and > 0.
    #[derive(Copy)]
    pub struct BaseFrames {
        /// `move_speed`: frames for half the edge of the space.
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
