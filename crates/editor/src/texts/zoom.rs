//! Texts of the zoom panel.

use super::texts;

texts! {
    Zoom {
        heading, slider, value, hint, sensor, sensor_hint, lens, lens_hint, angle_hint,
    }
}
