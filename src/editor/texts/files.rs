//! Texts of the file windows.

use super::texts;

texts! {
    /// Texts of the file windows.
    Files {
        cancel: "Cancel", "Abbrechen";
    }
}
