//! Texts of the timing of a view and its section.

use super::texts;

texts! {
    Timing {
        heading: "Timing", "Zeiten";
        frames: "{0} frames · {1} s", "{0} Bilder · {1} s";
        one_frame: "1 frame · {1} s", "1 Bild · {1} s";
        no_frames: "Nothing changes", "Nichts ändert sich";
        end: "End of the path", "Ende der Bahn";
        length: "Frames of the section", "Bilder des Abschnitts";
        length_label: "Section", "Abschnitt";
        hold: "Hold", "Halt";
        hold_hint: "Frames that the camera rests here before it goes on",
            "Bilder, die die Kamera hier ruht, bevor sie weitergeht";
        hold_unit: " fr.", " B.";
    }
}
