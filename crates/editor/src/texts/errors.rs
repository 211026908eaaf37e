//! What could not be done, and why.

use super::texts;

texts! {
    Errors {
        no_number: "{0}: “{1}” is not a number", "{0}: „{1}“ ist keine Zahl";
        no_unit: "{0}: the unit “{1}” does not fit here", "{0}: Die Einheit „{1}“ passt hier nicht";
        not_whole: "{0} must be a whole number", "{0} muss eine ganze Zahl sein";
        out_of_range: "{0} must lie between {1} and {2}", "{0} muss zwischen {1} und {2} liegen";
        memory: "There is not enough memory for this", "Dafür reicht der Speicher nicht";
        frames: "The path would yield more than {0} frames: the base speeds are too high",
            "Die Bahn ergäbe mehr als {0} Bilder: Die Grundgeschwindigkeiten sind zu hoch";
        refused: "This is not possible: {0}", "Das geht nicht: {0}";

        cannot_load: "{0} cannot be loaded: {1}", "{0} lässt sich nicht laden: {1}";
        cannot_save: "{0} cannot be saved: {1}", "{0} lässt sich nicht speichern: {1}";
        cannot_write: "{0} cannot be written: {1}", "{0} lässt sich nicht schreiben: {1}";
        cannot_hand_over: "Handing over failed: {0}", "Die Übergabe ist misslungen: {0}";
        cannot_list: "{0} cannot be read: {1}", "{0} lässt sich nicht lesen: {1}";

        not_found: "there is no such file or directory", "das gibt es nicht";
        permission: "permission denied", "die Berechtigung fehlt";
        is_directory: "this is a directory", "das ist ein Verzeichnis";
        not_directory: "this is not a directory", "das ist kein Verzeichnis";
        not_regular: "this is not a regular file", "das ist keine gewöhnliche Datei";
        full: "there is no room left on the disk", "der Datenträger ist voll";
        read_only: "the disk is read-only", "der Datenträger ist schreibgeschützt";
        long_name: "the name is too long", "der Name ist zu lang";
        too_large: "the file is too large", "die Datei ist zu groß";
        not_here: "this does not belong here", "das gehört nicht hierher";
        system: "the system says: {0}", "das System meldet: {0}";
        interrupted: "the system broke it off", "das System hat es abgebrochen";
    }
}
