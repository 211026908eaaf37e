//! Texts of the menu bar.

use super::texts;

texts! {
    /// Texts of the menu bar.
    Menu {
        file: "File", "Datei";
        undo: "Undo", "Rückgängig";
        redo: "Redo", "Wiederholen";
        colours: "Colours …", "Farbe …";
        display: "Display …", "Anzeige …";
        quit: "Quit", "Beenden";
    }
}
