//! Texts of the movement window.

use super::texts;

texts! {
    /// Texts of the movement window.
    Space {
        edge_on: "This plane is seen edge-on: rotate or tilt the space first",
            "Diese Ebene ist nur von der Kante zu sehen: erst den Raum drehen oder kippen";
    }
}
