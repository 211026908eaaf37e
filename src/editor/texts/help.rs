//! Texts of the window that lists keys and mouse actions.

use super::texts;

texts! {
    /// Texts of the window that lists keys and mouse actions.
    Help {
        title: "Keys and mouse", "Tasten und Maus";
    }
}
