//! Texts of the timeline's ruler, keys and graph.

use super::texts;

texts! {
    Timeline {
        unit: "What the ruler counts", "Was das Lineal zählt";
        unit_tip: "The ruler counts seconds or frames: click for the other",
            "Das Lineal zählt Sekunden oder Bilder: Klick wechselt";
        seconds: "Seconds", "Sekunden";
        frames: "Frames", "Bilder";
        all_sections: "Sections", "Abschnitte";
        keys: "Points and views", "Punkte und Blicke";
        key: "Time of {0}", "Zeitpunkt von {0}";
        key_at: "{0} · {1} s · frame {2}", "{0} · {1} s · Bild {2}";
        slow_past: "Slow down here", "Hier abbremsen";
        slow_past_hint: "Slower up to here and faster from here on, without a jerk: a quarter of the neighbouring speed",
            "Bis hierher langsamer und von hier an schneller, ohne Ruck: ein Viertel der Geschwindigkeit daneben";
        no_slow_past: "The camera begins, ends, rests or turns in one place here",
            "Hier beginnt, endet, ruht oder dreht sich die Kamera";
        rest: "Rest here for 1 s", "Hier 1 s verweilen";
        rest_hint: "The camera stands still here; how long is a number at the right",
            "Die Kamera steht hier still; wie lange, ist eine Zahl rechts";
        no_rest: "No rest here", "Hier nicht verweilen";
        no_rest_hint: "The camera goes on at once", "Die Kamera fährt sofort weiter";
        key_tip: "Drag: shift frames between the two sections around it · type a number: to that time; +, −: by that time · Shift: ten times finer · Ctrl: a copy · Esc: back · right button: slow down or rest here",
            "Ziehen: die Abschnitte daneben bekommen mehr Bilder und weniger · Zahl tippen: zu dieser Zeit; +, −: um so viel · Umschalt: zehnmal feiner · Strg: eine Kopie · Esc: zurück · rechte Taste: hier abbremsen oder verweilen";
        moved: "{0}: {1} s ({2} s) · frame {3}", "{0}: {1} s ({2} s) · Bild {3}";
        copy_of: "Copy of {0}", "Kopie von {0}";
        sections: "{0} frames before it · {1} behind it", "{0} Bilder davor · {1} dahinter";
        section: "{0} frames before it", "{0} Bilder davor";
        first_stays: "The first one stays at the beginning", "Der erste bleibt am Anfang";
        no_copy: "No copy here: there is a key, or nothing would move between two equal ones",
            "Hier keine Kopie: es gibt schon einen Schlüssel, oder zwischen zwei gleichen bewegte sich nichts";
        along: "What follows moves along", "Folgendes rückt mit";
        along_tip: "A key that is dragged takes all behind it along, and the flight gets longer or shorter",
            "Ein gezogener Schlüssel nimmt alles dahinter mit, und der Flug wird länger oder kürzer";
        height: "Height of the graph", "Höhe des Verlaufs";
        limit: "limit {0}", "Grenze {0}";
        move_keys: "Ctrl + arrow keys on the ruler", "Strg + Pfeiltasten auf dem Lineal";
        move_meaning: "Move the current key in time by one frame; Shift: by ten",
            "Aktuellen Schlüssel um ein Bild in der Zeit bewegen; Umschalt: um zehn";
        tracks: "Keys of nodes", "Schlüssel der Knoten";
        tracks_of: "Tracks of {0}", "Spuren von {0}";
        channel_of: "{0} of {1}", "{0} von {1}";
        path_of: "Path of {0}", "Bahn von {0}";
        keys_selected: "{0} keys", "{0} Schlüssel";
        is_pinned: "A marker holds the time of this path: a point of it is pinned to it",
            "Eine Marke hält die Zeit dieser Bahn: ein Punkt von ihr ist dort festgesteckt";
        position: "Position", "Position";
        rotation: "Rotation", "Drehung";
        scale: "Scale", "Größe";
        visible: "Visible", "Sichtbar";
        zoom: "Zoom", "Zoom";
        roll: "Roll", "Rollen";
        colour: "Colour", "Farbe";
        intensity: "Intensity", "Helligkeit";
        cone: "Cone", "Kegel";
        weights: "Shapes", "Formen";
        aim_weight: "Aim", "Zielen";
        deformation: "Deformation {0}: {1}", "Verformung {0}: {1}";
        step: "Steps", "Stufen";
        linear: "Straight", "Gerade";
        ramp: "Slow at the keys", "Langsam an den Schlüsseln";
        sine: "Slow at the keys, by a sine", "Langsam an den Schlüsseln, mit Sinus";
        parabolic: "Slow at the keys, by parabolas", "Langsam an den Schlüsseln, mit Parabeln";
        catmull_rom: "Smooth (Catmull-Rom)", "Glatt (Catmull-Rom)";
        hermite: "Own tangents", "Eigene Tangenten";
        tcb: "Tension, continuity, bias", "Spannung, Stetigkeit, Neigung";
        cubic: "Smoothest (cubic spline)", "Am glattesten (kubischer Spline)";
        euler_linear: "Angles, straight", "Winkel, gerade";
        euler_catmull_rom: "Angles, smooth", "Winkel, glatt";
        manner_hint: "How the value goes from key to key: frames and values of the keys stay, their own tangents or tensions go; undo brings them back",
            "Wie der Wert von Schlüssel zu Schlüssel geht: Bilder und Werte der Schlüssel bleiben, eigene Tangenten oder Spannungen gehen; Rückgängig bringt sie wieder";
        before: "Before the first key", "Vor dem ersten Schlüssel";
        after: "After the last key", "Nach dem letzten Schlüssel";
        beyond: "Before and after the path", "Vor und nach der Bahn";
        holds: "Stays", "Bleibt stehen";
        repeats: "Repeats", "Wiederholt sich";
        back_and_forth: "Back and forth", "Hin und zurück";
        goes_on: "Repeats from where it ended", "Wiederholt sich von dort, wo es endete";
        track_mouse: "Drag keys of a node on the timeline", "Schlüssel eines Knotens auf der Zeitleiste ziehen";
        track_meaning: "To whole frames; Shift: tenths; Ctrl: copies; a number: to that time; a bracket: scales the time between",
            "Zu ganzen Bildern; Umschalt: Zehntel; Strg: Kopien; eine Zahl: zu dieser Zeit; eine Klammer: dehnt die Zeit dazwischen";
        beside_keys: "Comma, period", "Komma, Punkt";
        beside_meaning: "On the timeline, to the key before, after", "Auf der Zeitleiste zum vorigen, nächsten Schlüssel";
        graph_of_keys: "Graph of keys", "Verlauf der Schlüssel";
        graph_switch: "Keys as a graph", "Schlüssel als Verlauf";
        graph_tip: "The numbers of the keys over the frames, or rows of keys",
            "Die Zahlen der Schlüssel über den Bildern, oder Zeilen von Schlüsseln";
        curve_tip: "Show this one; Ctrl: add or remove it",
            "Diese zeigen; Strg: zu den anderen, oder nicht mehr";
        read_only: "Quaternions are shown as angles, which can only be read; Angles in the track's menu can be dragged",
            "Quaternionen stehen hier als Winkel, nur zum Lesen; ziehen lassen sich Winkel aus dem Menü der Spur";
        time_stays: "X: the time stays", "X: die Zeit bleibt";
        number_stays: "Y: the value stays", "Y: der Wert bleibt";
        tangent: "{0}: {1} a second", "{0}: {1} je Sekunde";
        smooth_hint: "The opposite tangent follows: no corner in the graph",
            "Die andere Tangente geht mit: kein Knick im Verlauf";
        mirrored_hint: "The other tangent is its mirror image: back as it came",
            "Die andere Tangente ist ihr Spiegelbild: zurück, wie es kam";
        corner_hint: "The other tangent stays", "Die andere Tangente bleibt";
        graph_mouse: "Drag keys in the graph", "Schlüssel im Verlauf ziehen";
        graph_meaning: "In time and in value; X: the time stays, Y: the value stays; else as in the rows. Handles: the tangents of selected keys",
            "In der Zeit und im Wert; X: die Zeit bleibt, Y: der Wert bleibt; sonst wie in den Zeilen. Griffe: die Tangenten gewählter Schlüssel";
        keys_clipboard: "Ctrl + C, X, V on the timeline", "Strg + C, X, V auf der Zeitleiste";
        turns_lost: "Quaternions go the shorter way: turns of more than a half between two keys are lost. Undo brings them back",
            "Quaternionen gehen den kürzeren Weg: Drehungen um mehr als eine halbe zwischen zwei Schlüsseln gehen verloren. Rückgängig bringt sie wieder";
        clipboard_meaning: "Copy and cut the selected keys of nodes; put them in at the playhead, into the selected nodes",
            "Gewählte Schlüssel von Knoten kopieren und ausschneiden; an der Abspielmarke in die gewählten Knoten einfügen";
        no_keys_selected: "No key of a node is selected", "Kein Schlüssel eines Knotens ist gewählt";
        keys_copied: "Keys copied: {0}", "Kopierte Schlüssel: {0}";
        keys_pasted: "Keys pasted at the playhead: {0}", "An der Abspielmarke eingefügte Schlüssel: {0}";
        no_keys: "What was copied last is no keys of a node: nothing was pasted",
            "Was zuletzt kopiert wurde, sind keine Schlüssel eines Knotens: nichts wurde eingefügt";
        keys_not_pasted: "The copied keys cannot be pasted: {0}",
            "Die kopierten Schlüssel lassen sich nicht einfügen: {0}";
        as_many_nodes: "The copied keys are of {0} nodes, and {1} are selected: nothing was pasted",
            "Die kopierten Schlüssel sind von {0} Knoten, und gewählt sind {1}: nichts wurde eingefügt";
        fits_no_channel: "The copied keys fit no channel of the selected nodes: nothing was pasted",
            "Die kopierten Schlüssel passen zu keinem Kanal der gewählten Knoten: nichts wurde eingefügt";
        pin_to: "Pin to", "Anheften an";
        pin_hint: "The path is at this point at the marker's frame: the first pin moves its start, the sections between two share the frames",
            "Die Bahn ist beim Bild der Marke an diesem Punkt: der erste festgesteckte verschiebt den Anfang, die Abschnitte zwischen zweien teilen sich die Bilder";
        no_marker: "No marker", "Keine Marke";
        no_markers: "There is no marker: a double click on the ruler makes one",
            "Es gibt keine Marke: ein Doppelklick auf das Lineal macht eine";
        home_keys: "Shift + Home on the timeline", "Umschalt + Pos1 auf der Zeitleiste";
        home_meaning: "See the selected keys, else all that moves the selected nodes; Home: everything",
            "Die gewählten Schlüssel sehen, sonst alles, was die gewählten Knoten bewegt; Pos1: alles";
        marker: "Marker {0}", "Marke {0}";
        new_marker: "Marker {0}", "Marke {0}";
        marker_name: "Name of the marker", "Name der Marke";
        marker_tip: "Drag: to another frame, with what is pinned to it · F2: another name · Del: remove",
            "Ziehen: zu einem anderen Bild, mit allem, was daran festgesteckt ist · F2: anderer Name · Entf: entfernen";
        rename_marker: "Another name …", "Anderer Name …";
        remove_marker: "Remove this marker", "Marke löschen";
        remove_marker_hint: "What is pinned to it is free then", "Was daran festgesteckt ist, ist dann frei";
        marker_mouse: "Double click on the ruler", "Doppelklick auf das Lineal";
        marker_meaning: "A marker there, in a scene; F2: another name, Del: remove",
            "Dort eine Marke, in einer Szene; F2: anderer Name, Entf: entfernen";
        zoom_mouse: "Wheel, middle button on the timeline", "Mausrad, mittlere Taste auf der Zeitleiste";
        zoom_meaning: "See less or more of the time, and move it, as Shift + wheel does; Home on the ruler shows all",
            "Weniger oder mehr von der Zeit sehen, und sie verschieben wie Umschalt + Mausrad; Pos1 auf dem Lineal zeigt alles";
        drag_mouse: "Drag a key on the timeline", "Einen Schlüssel auf der Zeitleiste ziehen";
        drag_meaning: "Another time for it; a number while dragging: to that time; Ctrl: a copy; right button: slow down or rest there",
            "Ein anderer Zeitpunkt für ihn; Zahl beim Ziehen: zu dieser Zeit; Strg: eine Kopie; rechte Taste: dort abbremsen oder verweilen";
    }
}
