//! Texts of the questions.

use super::texts;

texts! {
    /// Texts of the questions.
    Questions {
        save: "Save", "Speichern";
    }
}
