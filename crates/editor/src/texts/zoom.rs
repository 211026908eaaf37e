//! Texts of the zoom panel.

use super::texts;

texts! {
    Zoom {
        heading: "Zoom / field of view", "Zoom / Blickwinkel";
        slider: "Zoom", "Zoom";
        value: "Zoom value", "Zoomwert";
        hint: "Focal length in mm of a 36×24 mm camera, 1 to 100",
            "Brennweite in mm einer Kleinbildkamera, 1 bis 100";
        angle_hint: "Vertical field of view", "Senkrechter Blickwinkel";
    }
}
