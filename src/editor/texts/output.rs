//! Texts of the output field.

use super::texts;

texts! {
    /// Texts of the output field.
    Output {
        point: "Point", "Punkt";
        position: "Position", "Position";
        view: "View", "Blick";
        roll: "Roll", "Winkel";
        zoom: "Zoom", "Zoom";
        handed_over: "{0} camera settings handed over", "{0} Kameraeinstellungen übergeben";
        written: "{0} camera settings written to {1}", "{0} Kameraeinstellungen in {1} geschrieben";
        loaded: "{0} loaded", "{0} geladen";
        saved: "{0} saved", "{0} gespeichert";
        copied: "Orientation copied", "Orientierung kopiert";
        nothing_copied: "No orientation has been copied yet", "Es wurde noch keine Orientierung kopiert";
        nothing_to_undo: "There is nothing to undo", "Es gibt nichts rückgängig zu machen";
        nothing_to_redo: "There is nothing to redo", "Es gibt nichts zu wiederholen";
    }
}
