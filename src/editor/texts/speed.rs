//! Texts of the speed panel.

use super::texts;

texts! {
    /// Texts of the speed panel.
    Speed {
        heading: "Speed curve", "Zeitkurve";
    }
}
