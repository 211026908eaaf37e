//! Texts of the menu bar.

use super::texts;

texts! {
    /// Texts of the menu bar.
    Menu {
        file: "File", "Datei";
        edit: "Edit", "Bearbeiten";
        output: "Output", "Ausgabe";
        settings: "Settings", "Einstellungen";
        help: "Help", "Hilfe";

        load: "Load curve …", "Lade Kurve …";
        save: "Save", "Speichern";
        save_as: "Save curve …", "Speicher Kurve …";
        quit: "Quit", "Beenden";

        undo: "Undo", "Rückgängig";
        redo: "Redo", "Wiederholen";
        add_point: "Insert a point behind this one", "Punkt dahinter einfügen";
        remove_point: "Remove this point", "Punkt löschen";
        append: "Append behind the last point", "Hinter dem letzten Punkt anfügen";
        prepend: "Put before the first point", "Vor dem ersten Punkt anfügen";
        close: "Closed path", "Geschlossene Bahn";
        copy_orientation: "Copy orientation", "Orientierung kopieren";
        paste_orientation: "Paste orientation", "Orientierung einfügen";

        export: "Write to a file …", "In Datei ausgeben …";
        hand_over: "Hand over directly", "Direkt übergeben";
        nobody_takes: "No program takes camera settings from this window",
            "Kein Programm nimmt von diesem Fenster Kameraeinstellungen entgegen";

        colours: "Colours …", "Farbe …";
        display: "Display …", "Anzeige …";
        load_setup: "Load setup …", "Lade Setup …";
        save_setup: "Save setup …", "Speicher Setup …";
        dark: "Dark", "Dunkel";
        light: "Light", "Hell";

        close_window: "Close this window", "Dieses Fenster schließen";

        keys: "Keys and mouse", "Tasten und Maus";

        control: "Ctrl", "Strg";
        shift: "Shift", "Umschalt";
        delete: "Del", "Entf";
    }
}
