//! Texts of the output field.

use super::texts;

texts! {
    /// Texts of the output field.
    Output {
        handed_over: "{0} camera settings handed over", "{0} Kameraeinstellungen übergeben";
    }
}
