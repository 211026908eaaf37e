//! Texts of the output field.

use super::texts;

texts! {
    Output {
        point: "Point", "Punkt";
        position: "Position", "Position";
        view: "View", "Blick";
        roll: "Roll", "Winkel";
        zoom: "Zoom", "Zoom";
        handed_over: "{0} camera settings handed over", "{0} Kameraeinstellungen übergeben";
        written: "{0} camera settings written to {1}", "{0} Kameraeinstellungen in {1} geschrieben";
        loaded: "{0} loaded", "{0} geladen";
        too_large: "{0} loaded; it is larger than the space, which can be fitted to it (Edit, Space …)",
            "{0} geladen; es ist größer als der Raum, der sich anpassen lässt (Bearbeiten, Raum …)";
        saved: "{0} saved", "{0} gespeichert";
        copied: "View copied", "Blick kopiert";
        nothing_copied: "No view has been copied yet", "Es wurde noch kein Blick kopiert";
        points_copied: "{0} points copied", "{0} Punkte kopiert";
        points_pasted: "{0} points pasted", "{0} Punkte eingefügt";
        points_removed: "{0} points removed", "{0} Punkte gelöscht";
        nothing_to_cut: "Only points that are selected together can be cut (with Shift, Ctrl or a box)",
            "Ausschneiden lassen sich nur zusammen gewählte Punkte (mit Umschalt, Strg oder einem Rahmen)";
        no_points: "What was copied last is no point of a path: nothing was pasted",
            "Zuletzt wurden keine Punkte einer Bahn kopiert: Eingefügt wurde nichts";
        not_pasted: "The copied points cannot be pasted: {0}",
            "Die kopierten Punkte lassen sich nicht einfügen: {0}";
        nothing_to_undo: "There is nothing to undo", "Es gibt nichts rückgängig zu machen";
        half_turn: "From {0} to {1} the camera makes half a turn, in either direction. Add a view in between to choose",
            "Von {0} nach {1} ist es eine halbe Drehung: Beide Richtungen sind gleich weit. Ein Blick dazwischen entscheidet";
        at_target: "Between {0} and {1} the camera reaches its target, where it keeps its direction",
            "Zwischen {0} und {1} kommt die Kamera an den Ort, auf den sie blickt: Dort behält sie ihre Richtung";
        over_target: "Between {0} and {1} the camera is straight above or below its target, where its picture flips",
            "Zwischen {0} und {1} kommt die Kamera genau über oder unter ihr Ziel: Dort dreht sich ihr Bild";
        length_changed: "The film is now {0} s long (was {1} s): Ctrl+Z undoes it",
            "Der Film dauert jetzt {0} s (vorher {1} s): Strg+Z macht es rückgängig";
        path_length_changed: "The path now takes {0} s (was {1} s): Ctrl+Z undoes it",
            "Die Bahn dauert jetzt {0} s (vorher {1} s): Strg+Z macht es rückgängig";
        nothing_to_redo: "There is nothing to redo", "Es gibt nichts zu wiederholen";
    }
}
