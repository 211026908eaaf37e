//! Texts of the questions.

use super::texts;

texts! {
    /// Texts of the questions.
    Questions {
        unsaved: "Unsaved work", "Nicht gespeicherte Arbeit";
        before_close: "{0} has changes that are not saved. Save them before the window closes?",
            "{0} hat Änderungen, die nicht gespeichert sind. Vor dem Schließen speichern?";
        before_load: "{0} has changes that are not saved. Save them before another curve is loaded?",
            "{0} hat Änderungen, die nicht gespeichert sind. Vor dem Laden einer anderen Kurve speichern?";
        this_path: "This path", "Diese Bahn";
        save: "Save", "Speichern";
        discard: "Discard", "Verwerfen";
        cancel: "Cancel", "Abbrechen";
        save_hint: "Save, then go on", "Speichern und dann fortfahren";
        discard_hint: "Go on; the changes are lost", "Fortfahren; die Änderungen gehen verloren";
        cancel_hint: "Stay here; nothing happens (Esc)", "Hier bleiben; es geschieht nichts (Esc)";
    }
}
