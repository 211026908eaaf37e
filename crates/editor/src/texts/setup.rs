//! Texts of the setup file.

use super::texts;

texts! {
    Setup {
        loaded: "Setup loaded from {0}", "Setup geladen aus {0}";
        saved: "Setup saved as {0}", "Setup gespeichert als {0}";
        not_loaded: "{0} cannot be loaded: {1}", "{0} lässt sich nicht laden: {1}";
        not_saved: "{0} cannot be saved: {1}", "{0} lässt sich nicht speichern: {1}";
        ignored: "The setup in {0} is not used: {1}", "Das Setup in {0} wird nicht verwendet: {1}";
    }
}
