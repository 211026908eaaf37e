//! Texts of the orientation panel.

use super::texts;

texts! {
    /// Texts of the orientation panel.
    Orientation {
        heading: "Orientation", "Orientierung";
    }
}
