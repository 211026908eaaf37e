//! Texts of the curve window.

use super::texts;

texts! {
    /// Texts of the curve window.
    Curve {
        title: "Curve parameters", "Kurvenparameter";
    }
}
