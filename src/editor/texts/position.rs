//! Texts of the panel of position and curve.

use super::texts;

texts! {
    /// Texts of the panel of position and curve.
    Position {
        heading: "Position and curve", "Position und Kurve";
    }
}
