//! Texts of the window that lists keys and mouse actions.

use super::texts;

texts! {
    Help {
        title: "Keys and mouse", "Tasten und Maus";

        mouse: "Movement window", "Bewegungsfenster";
        left_button: "Drag, left button", "Ziehen, linke Taste";
        left_meaning: "Move a point or the tip of the view's arrow in the plane x = const",
            "Punkt oder Spitze des Blickpfeils in der Ebene x = const bewegen";
        middle_button: "Drag, middle button", "Ziehen, mittlere Taste";
        middle_meaning: "Move it in the plane y = const", "In der Ebene y = const bewegen";
        right_button: "Drag, right button", "Ziehen, rechte Taste";
        right_meaning: "Move it in the plane z = const", "In der Ebene z = const bewegen";
        held_letters: "X, Y, Z held, left button", "X, Y, Z gehalten, linke Taste";
        held_meaning: "The same with one button", "Dasselbe mit einer Taste";
        vup_tip: "Drag the tip of the arrow up", "Spitze des Pfeils nach oben ziehen";
        vup_meaning: "Roll the camera", "Kamera um die Blickrichtung drehen";
        empty: "Drag elsewhere", "Daneben ziehen";
        empty_meaning: "Rotate and tilt the space", "Raum drehen und kippen";
        wheel: "Wheel", "Mausrad";
        wheel_meaning: "Size of the space", "Größe des Raumes";
        context: "Right click on a point", "Rechtsklick auf einen Punkt";
        context_meaning: "What can be done with it", "Was sich mit ihm tun lässt";

        drop: "Drop a file", "Eine Datei ablegen";
        drop_meaning: "Open a path (.vid), show an object (OBJ, PLY, STL, glTF), or import any other file",
            "Eine Bahn (.vid) öffnen, ein Objekt (OBJ, PLY, STL, glTF) zeigen oder eine andere Datei importieren";

        shortcuts: "Shortcuts", "Tastenkürzel";

        absolute: "Switch between {0} and {1}", "Zwischen {0} und {1} wechseln";

        copy: "Copy the selected points, else the view",
            "Die gewählten Punkte kopieren, sonst den Blick";
        paste: "Paste copied points behind this one, or a copied view in place of this one",
            "Kopierte Punkte hinter diesem einfügen, oder einen kopierten Blick an die Stelle von diesem";

        menus: "Menus", "Menüs";
        open_menu: "Open the menu {0}", "Menü {0} öffnen";
        first_menu: "Open the first menu", "Das erste Menü öffnen";
        arrows: "Arrow keys, Enter", "Pfeiltasten, Enter";
        arrows_meaning: "Move through the menus, choose an entry",
            "Durch die Menüs gehen, Eintrag wählen";
        letter: "Underlined letter", "Unterstrichener Buchstabe";
        letter_meaning: "Pick that entry of the open menu", "Diesen Eintrag des offenen Menüs wählen";

        squares: "Drag a square, arrow keys", "Quadrat ziehen, Pfeiltasten";
        squares_meaning: "Change the pace of the section; Shift: ten times finer when dragged, ten steps by keys",
            "Tempo des Abschnitts ändern; Umschalt: gezogen zehnmal feiner, mit Tasten zehn Schritte";
        on_way: "Click on the curve of a distance", "Klick auf die Kurve eines Weges";
        on_way_meaning: "A new key of the distance", "Ein neuer Schlüssel des Weges";
        way_key: "Right click on its key, Delete", "Rechtsklick auf dessen Schlüssel, Entf";
        way_key_meaning: "Remove the key", "Schlüssel entfernen";

        several: "Ctrl+click, Shift+click", "Strg+Klick, Umschalt+Klick";
        several_meaning: "Select several nodes", "Mehrere Knoten wählen";
        rename: "Double click", "Doppelklick";
        rename_meaning: "Rename the node", "Den Knoten umbenennen";
        put_into: "Drag onto another row", "Auf eine andere Zeile ziehen";
        put_into_meaning: "Make the selected nodes children of that one",
            "Die gewählten Knoten in jenen tun";
        remove_meaning: "Remove the selected nodes with their children",
            "Die gewählten Knoten löschen, mit allem, was darin liegt";
        copy_meaning: "Copy them with all that is in them", "Sie kopieren, mit allem, was darin liegt";
        clipboard_meaning: "Copy, cut and paste them, from window to window too",
            "Sie kopieren, ausschneiden, einfügen, auch von Fenster zu Fenster";
        all_meaning: "Select all nodes", "Alle Knoten wählen";
        tree: "Arrow keys", "Pfeiltasten";
        tree_meaning: "Move in the tree, fold and unfold", "Durch den Baum gehen, zu- und aufklappen";

        fields: "Numbers", "Zahlen";
        drag: "Drag", "Ziehen";
        drag_meaning: "Change the value; Shift: ten times finer",
            "Wert ändern; Umschalt: zehnmal feiner";
        click: "Click", "Klicken";
        click_meaning: "Type a value: 1.5, 2s, 48fr, 0.5m, 2*3, +10%",
            "Wert eintippen: 1,5, 2s, 48fr, 0,5m, 2*3, +10%";
        enter: "Enter, Tab", "Enter, Tab";
        enter_meaning: "Apply it; Tab goes on", "Übernehmen; Tab geht weiter";
        escape: "Esc", "Esc";
        escape_meaning: "Keep the old value; close a window", "Alten Wert behalten; Fenster schließen";
        up_down: "Arrow up, arrow down", "Pfeil auf, Pfeil ab";
        up_down_meaning: "One step more or less", "Ein Schritt mehr oder weniger";
        tab: "Tab, Shift+Tab", "Tab, Umschalt+Tab";
        tab_meaning: "Next, previous control", "Nächstes, voriges Bedienelement";
    }
}
