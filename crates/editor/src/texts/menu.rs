//! Texts of the menu bar.

use super::texts;

texts! {
    Menu {
        file: "File", "Datei";
        edit: "Edit", "Bearbeiten";
        output: "Export", "Ausgabe";
        settings: "Settings", "Einstellungen";
        help: "Help", "Hilfe";

        new: "New", "Neu";
        load: "Open …", "Öffnen …";
        save: "Save", "Speichern";
        save_as: "Save as …", "Speichern unter …";
        load_object: "Open object …", "Objekt öffnen …";
        import: "Import …", "Importieren …";
        quit: "Quit", "Beenden";

        undo: "Undo", "Rückgängig";
        redo: "Redo", "Wiederholen";
        add_point: "Insert a point after this one", "Punkt dahinter einfügen";
        add_copy: "Insert a copy of this point", "Kopie des Punkts einfügen";
        add_keeping: "Insert a point, same flight", "Punkt ohne Änderung des Flugs";
        add_points: "Insert several points …", "Mehrere Punkte einfügen …";
        remove_point: "Remove this point", "Punkt löschen";
        remove_points: "Remove {0} points", "{0} Punkte löschen";
        append: "Append after the last point", "Hinter dem letzten Punkt anfügen";
        prepend: "Put before the first point", "Vor dem ersten Punkt einfügen";
        close: "Closed path", "Geschlossene Bahn";
        add_orientation: "New view", "Neuer Blick";
        remove_orientation: "Remove this view", "Blick löschen";
        copy_orientation: "Copy view", "Blick kopieren";
        copy_points: "Copy points", "Punkte kopieren";
        cut: "Cut points", "Punkte ausschneiden";
        remove_nodes: "Remove nodes", "Knoten löschen";
        all_nodes: "Select all nodes", "Alle Knoten auswählen";
        copy_nodes: "Copy nodes", "Knoten kopieren";
        cut_nodes: "Cut nodes", "Knoten ausschneiden";
        paste: "Paste", "Einfügen";
        paste_orientation: "Paste view", "Blick einfügen";
        speeds: "Speed curve …", "Zeitkurve …";
        space: "Space …", "Raum …";
        add_object: "Add an object from a file …", "Objekt aus einer Datei hinzufügen …";
        add_light: "Add a light", "Licht hinzufügen";
        add_camera: "Add a camera", "Kamera hinzufügen";
        add_group: "Add a group", "Gruppe hinzufügen";
        aim_all: "Aim all cameras at this target", "Alle Kameras auf dieses Ziel richten";

        export: "Export …", "Datei exportieren …";
        hand_over: "Hand over directly", "Direkt übergeben";
        hands_over: "Hand over continuously", "Laufend übergeben";
        nobody_takes: "No program takes camera settings from this window",
            "Kein Programm nimmt von diesem Fenster Kameraeinstellungen entgegen";

        colours: "Colours …", "Farben …";
        display: "Display …", "Anzeige …";
        load_setup: "Load setup …", "Setup laden …";
        save_setup: "Save setup …", "Setup speichern …";
        as_system: "As the system", "Wie das System";
        dark: "Dark", "Dunkel";
        light: "Light", "Hell";

        close_window: "Close this window", "Dieses Fenster schließen";

        keys: "Keys and mouse", "Tasten und Maus";

        control: "Ctrl", "Strg";
        shift: "Shift", "Umschalt";
        insert: "Ins", "Einfg";
        delete: "Del", "Entf";
        page_up: "Page Up", "Bild auf";
        page_down: "Page Down", "Bild ab";
    }
}
