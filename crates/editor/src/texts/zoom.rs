//! Texts of the zoom panel.

use super::texts;

texts! {
    Zoom {
        heading: "Zoom / field of view", "Zoom / Blickwinkel";
        slider: "Zoom", "Zoom";
        value: "Zoom value", "Zoomwert";
        hint: "Focal length in mm of a 36×24 mm camera, 1 to 2000",
            "Brennweite in mm einer Kleinbildkamera, 1 bis 2000";
        sensor: "Sensor height", "Sensorhöhe";
        sensor_hint: "The height of another camera's picture: which lens sees the same on it",
            "Die Bildhöhe einer anderen Kamera: welches Objektiv auf ihr dasselbe sieht";
        lens: "Focal length there", "Brennweite darauf";
        lens_hint: "Focal length in mm that has this field of view on that sensor",
            "Brennweite in mm, die auf diesem Sensor diesen Blickwinkel hat";
        angle_hint: "Vertical field of view", "Senkrechter Blickwinkel";
    }
}
