//! Texts of the file windows.

use super::texts;

texts! {
    Files {
        load_path: "Open a path or an object", "Bahn oder Objekt öffnen";
        save_path: "Save path", "Bahn speichern";
        load_object: "Open object", "Objekt öffnen";
        add_object: "Add an object", "Objekt hinzufügen";
        export: "Write to a file", "In Datei ausgeben";
        load_setup: "Load setup", "Setup laden";
        save_setup: "Save setup", "Setup speichern";
        load_block: "Insert a block", "Baustein einfügen";
        save_block: "Save points as a block", "Punkte als Baustein speichern";
        import: "Import a scene or recorded poses", "Szene oder aufgezeichnete Posen importieren";
        block: "block", "Baustein";
        one_file: "One file can be dropped at a time", "Ablegen lässt sich nur eine Datei auf einmal";
        not_here: "{0} is no file of this machine", "{0} ist keine Datei dieses Rechners";

        folder: "Directory", "Verzeichnis";
        folder_hint: "Type a directory and press Enter", "Ein Verzeichnis eintippen und Enter drücken";
        up: "Up", "Hoch";
        up_hint: "Go to the parent folder (Alt+Up)",
            "Zum übergeordneten Verzeichnis (Alt und Pfeil auf)";
        home: "Home", "Persönlich";
        home_hint: "Go to your own directory", "Zum persönlichen Verzeichnis";
        contents: "Contents of the directory", "Inhalt des Verzeichnisses";
        name: "Name", "Name";
        name_hint: "The file's name, or a path that ends in it; Enter takes it",
            "Der Name der Datei oder ein Pfad, der mit ihm endet; Enter übernimmt ihn";
        filter: "Filter", "Filter";
        filter_hint: "Files to be shown: * stands for any letters, ? for one",
            "Dateien, die gezeigt werden: * steht für beliebige Zeichen, ? für eines";
        format: "Format", "Format";
        format_hint: "How it is written; the name's ending follows", "Wie geschrieben wird; die Endung des Namens folgt";
        hidden: "Hidden files", "Versteckte Dateien";
        hidden_hint: "Also show files whose names begin with a full stop",
            "Auch Dateien zeigen, deren Namen mit einem Punkt beginnen";
        load: "Load", "Laden";
        take_hint: "Take the file of this name (Enter)", "Die Datei dieses Namens nehmen (Enter)";
        overwrite_hint: "Replace the old file with the new one",
            "Die neue Datei an die Stelle der alten setzen";
        cancel_hint: "Go back without doing anything (Esc)", "Zurück, ohne etwas zu tun (Esc)";
        save: "Save", "Speichern";
        write: "Write", "Schreiben";
        cancel: "Cancel", "Abbrechen";
        reading: "Reading …", "Wird gelesen …";
        empty: "Nothing to show here", "Hier gibt es nichts zu zeigen";
        more: "Only the first {0} entries are shown", "Nur die ersten {0} Einträge werden gezeigt";
        no_name: "A name is missing", "Es fehlt ein Name";

        exists: "{0} exists already. Overwrite it?", "{0} gibt es schon. Überschreiben?";
        overwrite: "Overwrite", "Überschreiben";
        proposal: "curve", "kurve";
        poses: "poses", "bilder";
    }
}
