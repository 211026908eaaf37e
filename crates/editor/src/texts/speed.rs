//! Texts of the speed panel.

use super::texts;

texts! {
    Speed {
        heading: "Speed curve", "Zeitkurve";
        section: "{0} – {1}", "{0} – {1}";
        frames: "{0} frames · {1} s", "{0} Bilder · {1} s";
        one_frame: "1 frame · {1} s", "1 Bild · {1} s";
        no_frames: "Nothing changes", "Nichts ändert sich";
        end: "End of the path", "Ende der Bahn";
        picture: "Speed in this section", "Geschwindigkeit in diesem Abschnitt";
        picture_hint: "The speed in this section from its start to its end, 1 to 100; click to change it",
            "Die Geschwindigkeit in diesem Abschnitt vom Anfang bis zum Ende, 1 bis 100; zum Ändern klicken";
        change: "Change speed curve …", "Zeitkurve ändern …";
        change_hint: "Open the speed curve of this section, large",
            "Die Zeitkurve dieses Abschnitts groß öffnen";
    }
}
