//! Texts of the colour window.

use super::texts;

texts! {
    /// Texts of the colour window.
    Colours {
        title: "Colours", "Farben";
    }
}
