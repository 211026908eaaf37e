//! Tooltips of the entries of all menus.

use super::texts;

texts! {
    MenuHints {
        new: "Replace this path with an empty one", "Eine leere Bahn an Stelle dieser beginnen";
        load: "Open a path in place of this one", "Eine Bahn an Stelle dieser öffnen";
        import: "Import a scene or recorded poses from another program; poses become a path",
            "Eine Szene oder aufgezeichnete Posen eines anderen Programms übernehmen; aus Posen wird eine Bahn";
        load_object: "Show a mesh or a point cloud (OBJ, PLY, STL, glTF) in the movement window",
            "Ein Netz oder eine Punktwolke (OBJ, PLY, STL, glTF) im Bewegungsfenster zeigen";
        save: "Save the path under its name", "Die Bahn unter ihrem Namen speichern";
        save_as: "Save the path under a new name",
            "Die Bahn unter einem Namen speichern, nach dem gefragt wird";
        recent: "Open {0}", "{0} öffnen";
        quit: "Close this window; you are asked about unsaved work",
            "Dieses Fenster schließen; nach Ungespeichertem wird gefragt";

        undo: "Take the last change back", "Die letzte Änderung zurücknehmen";
        redo: "Do again what was taken back", "Zurückgenommenes wiederholen";
        append: "Add a point where the path would continue",
            "Ein neuer Punkt, wo die Bahn weiterginge";
        prepend: "Add a point where the path would have begun",
            "Ein neuer Punkt, wo die Bahn hergekommen wäre";
        close: "Connect the last point to the first",
            "Die Bahn vom letzten Punkt zum ersten zurückführen";
        open: "End the path at the last point", "Die Bahn am letzten Punkt enden lassen";
        copy_orientation: "Copy this view, to paste it elsewhere",
            "Diesen Blick merken, um ihn anderswo einzufügen";
        copy_points: "Copy the selected points to the clipboard, as the text of a .vid file",
            "Die gewählten Punkte in die Zwischenablage legen, als Text einer .vid-Datei";
        cut: "Move the selected points to the clipboard",
            "Die gewählten Punkte in die Zwischenablage legen und hier löschen";
        paste: "Insert copied points after this point, or replace this view with a copied one",
            "Kopierte Punkte hinter diesem einfügen, wie sie liegen, oder einen kopierten Blick an die Stelle von diesem";
        remove_nodes: "Remove the selected nodes with their children",
            "Die gewählten Knoten mit allem löschen, was in ihnen ist";
        all_nodes: "Dragging, typing and deleting then change all nodes at once",
            "Was dann gezogen, getippt oder gelöscht wird, ändert alle Knoten zugleich";
        copy_nodes: "Copy the selected nodes with their children to the clipboard, as the text of a .vid file",
            "Die gewählten Knoten mit allem, was in ihnen ist, in die Zwischenablage legen, als Text einer .vid-Datei";
        cut_nodes: "Move the selected nodes to the clipboard",
            "Die gewählten Knoten in die Zwischenablage legen und hier löschen";
        paste_nodes: "Paste copied nodes into the selected group, otherwise into the scene itself",
            "Kopierte Knoten in die gewählte Gruppe einfügen, sonst in die Szene selbst";
        paste_orientation: "Replace this view with the copied one",
            "Den kopierten Blick an die Stelle von diesem setzen";
        select_all: "Dragging, typing and deleting then change all points at once",
            "Was dann gezogen, getippt oder gelöscht wird, ändert alle Punkte zugleich";
        speeds: "Open the speed curve of this section, large",
            "Die Zeitkurve dieses Abschnitts groß öffnen";
        space: "Where the path is in the world: centre, size, unit, up axis",
            "Wo die Bahn in der Welt liegt: Mittelpunkt, Größe, Einheit, welche Achse senkrecht steht";
        add_object: "Add a mesh or a point cloud (OBJ, PLY, STL, glTF) to the scene, at the origin; it can move",
            "Ein Netz oder eine Punktwolke (OBJ, PLY, STL, glTF) in die Szene stellen, an den Ursprung; bewegen kann es sich auch";
        add_light: "Add a light to the scene, high in the space",
            "Ein Licht in die Szene stellen, oben in den Raum";
        add_camera: "Add a camera with the current view to the scene",
            "Eine weitere Kamera in die Szene stellen, die sieht, was jetzt zu sehen ist";
        add_group: "Add a node without geometry to the scene; its children move with it",
            "Einen Knoten ohne eigene Gestalt in die Szene stellen; was hineinkommt, bewegt sich mit";
        aim_here: "The current view becomes absolute and looks at this place of the object",
            "Der aktuelle Blick wird absolut und geht auf diese Stelle des Objekts";
        aim_all_here: "Every view of the path becomes absolute and looks at this place of the object",
            "Jeder Blick der Bahn wird absolut und geht auf diese Stelle des Objekts";
        aim_all: "Every view looks at the place of the object under the pointer; elsewhere: where this one looks",
            "Jeder Blick geht auf die Stelle des Objekts unter dem Zeiger, sonst dorthin, wohin dieser geht";

        export: "Compute all camera settings and write them to a file: lines of ten numbers, CSV or JSON",
            "Alle Kameraeinstellungen berechnen und in eine Datei schreiben: Zeilen von zehn Zahlen, CSV oder JSON";
        hand_over: "Compute all camera settings and give them to the program that opened this window",
            "Alle Kameraeinstellungen berechnen und dem Programm geben, das dieses Fenster öffnete";
        hands_over: "Give them to that program after each change, and while something is dragged",
            "Sie dem Programm nach jeder Änderung geben, und während etwas gezogen wird";

        colours: "Choose the colour of each element of the movement window",
            "Die Farbe jedes Elements im Bewegungsfenster wählen";
        display: "Choose what is shown", "Wählen, was zu sehen ist";
        as_system: "Light or dark as the desktop is", "Hell oder dunkel, wie es die Arbeitsfläche ist";
        dark: "Light letters on a dark ground", "Helle Schrift auf dunklem Grund";
        light: "Dark letters on a light ground", "Dunkle Schrift auf hellem Grund";
        load_setup: "Load colours, view and what is shown from a file",
            "Farben, Ansicht und was zu sehen ist aus einer Datei holen";
        save_setup: "Save colours, view and what is shown to a file",
            "Farben, Ansicht und was zu sehen ist in einer Datei behalten";

        keys: "Show every key and what the mouse does",
            "Alle Tasten und was die Maus tut";

        view_reset: "Size, rotation and tilt as in a new window",
            "Größe, Drehung und Kippung wie in einem neuen Fenster";
        view_along: "Look along the {0} axis", "Blick längs der {0}-Achse";
    }
}
