//! Texts of the speed-curve window.

use super::texts;

texts! {
    /// Texts of the speed-curve window.
    SpeedWindow {
        title: "Speed curve", "Zeitkurve";
    }
}
