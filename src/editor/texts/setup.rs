//! Texts of the setup file.

use super::texts;

texts! {
    /// Texts of the setup file.
    Setup {
        loaded: "Setup loaded from {0}", "Setup geladen aus {0}";
        saved: "Setup saved as {0}", "Setup gespeichert als {0}";
    }
}
