//! Texts of the zoom panel.

use super::texts;

texts! {
    /// Texts of the zoom panel.
    Zoom {
        heading: "Zoom / field of view", "Zoom / Blickwinkel";
    }
}
