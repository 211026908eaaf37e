//! Texts of the questions.

use super::texts;

texts! {
    Questions {
        unsaved: "Unsaved work", "Nicht gespeicherte Arbeit";
        before_close: "{0} has changes that are not saved. Save them before the window closes?",
            "{0} hat Änderungen, die nicht gespeichert sind. Vor dem Schließen speichern?";
        before_load: "{0} has changes that are not saved. Save them before another path is opened?",
            "{0} hat Änderungen, die nicht gespeichert sind. Vor dem Öffnen einer anderen Bahn speichern?";
        before_new: "{0} has changes that are not saved. Save them before it is replaced by an empty path?",
            "{0} hat Änderungen, die nicht gespeichert sind. Speichern, bevor eine leere Bahn an ihre Stelle tritt?";
        before_restore: "{0} has changes that are not saved. Save them before it is replaced by the recovered work?",
            "{0} hat Änderungen, die nicht gespeichert sind. Speichern, bevor die gefundene Arbeit an ihre Stelle tritt?";
        changed: "The file has changed", "Die Datei hat sich geändert";
        changed_since: "Another program has changed {0} since you opened or saved it. Overwriting loses those changes, reloading loses yours.",
            "{0} wurde von anderer Seite geändert, seit sie hier gelesen oder gespeichert wurde. Beim Überschreiben gehen jene Änderungen verloren, beim Neuladen die hiesigen.";
        newer: "{0} has been changed by another program. Read it again?",
            "{0} wurde von einem anderen Programm geändert. Neu lesen?";
        newer_unsaved: "{0} has been changed by another program. To read it again loses what has been changed here.",
            "{0} wurde von einem anderen Programm geändert. Beim Neulesen geht verloren, was hier geändert wurde.";
        keep: "Leave", "So lassen";
        keep_hint: "Go on with what is here; saving asks again",
            "Mit dem weitermachen, was hier ist; das Speichern fragt noch einmal";
        reload: "Reload", "Neu laden";
        reload_hint: "Open the file as it is now; the changes made here are lost",
            "Die Datei öffnen, wie sie jetzt ist; die Änderungen von hier gehen verloren";
        save_as: "Save as …", "Speichern als …";
        save_as_hint: "Save under another name; the file stays as it is",
            "Unter einem anderen Namen speichern; die Datei bleibt, wie sie ist";
        this_path: "This path", "Diese Bahn";
        save: "Save", "Speichern";
        discard: "Discard", "Verwerfen";
        cancel: "Cancel", "Abbrechen";
        save_hint: "Save, then go on", "Speichern und dann fortfahren";
        discard_hint: "Go on; the changes are lost", "Fortfahren; die Änderungen gehen verloren";
        cancel_hint: "Stay here; nothing happens (Esc)", "Hier bleiben; es geschieht nichts (Esc)";

        upright: "Up axis", "Senkrechte Achse";
        which_upright: "{0} does not say which axis is up. Which one is it?",
            "{0} sagt nicht, welche Achse senkrecht steht. Welche ist es?";
        y_up: "y up", "y senkrecht";
        y_up_hint: "As in OpenGL, glTF and Maya", "Wie in OpenGL, glTF und Maya";
        z_up: "z up", "z senkrecht";
        z_up_hint: "As in Blender, ROS and maps", "Wie in Blender, ROS und Landkarten";

        outside: "Files from elsewhere", "Dateien von anderswo";
        names_outside: "{0} names files outside its folder. Read them only if you know who made it:",
            "{0} nennt Dateien außerhalb ihres Ordners. Nur lesen, wenn bekannt ist, von wem sie kommt:";
        read_outside: "Read", "Lesen";
        read_outside_hint: "Open the file again, with the meshes that it names",
            "Die Datei noch einmal öffnen, mit den Netzen, die sie nennt";
        leave_outside: "Do not read", "Nicht lesen";
        leave_outside_hint: "Go on without these meshes (Esc)", "Ohne diese Netze weitermachen (Esc)";

        losses: "What the file cannot hold", "Was die Datei nicht fasst";
        lossy: "{0} cannot hold everything:",
            "In {0} bleibt etwas weg oder wird anders übernommen:";
        write_hint: "Write it all the same", "Trotzdem schreiben";
    }
}
