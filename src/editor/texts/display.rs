//! Texts of the display window.

use super::texts;

texts! {
    /// Texts of the display window.
    DisplayWindow {
        title: "Display", "Anzeige";
    }
}
