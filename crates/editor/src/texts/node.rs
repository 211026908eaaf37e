//! Texts of the panels of a node: what it has, and the diamonds of its keys.

use super::texts;

texts! {
    NodePanel {
        points_tab: "Points", "Punkte";
        points_tab_hint: "The path's points and views", "Punkte und Blicke der Bahn";
        node_tab: "Node", "Knoten";
        node_tab_hint: "What the node has besides its path: parent, scale, motion",
            "Was der Knoten außer der Bahn hat: Überordnung, Größe, Bewegung";
        first_of: "The first of {0} selected", "Der erste von {0} gewählten";

        parent: "In: {0}", "In: {0}";
        parent_name: "Parent", "Überordnung";
        no_parent: "the scene", "Szene";
        parent_hint: "The node it moves with. A node at rest keeps its place in the world; for a moving one you choose",
            "Der Knoten, in dem er ist und mit dem er mitgeht. Wer ruht, bleibt an seinem Ort in der Welt; bewegt er sich, wird gefragt";
        aim: "Aims at: {0}", "Zielt auf: {0}";
        aim_name: "Aim", "Ziel";
        no_aim: "nothing", "nichts";
        aim_hint: "The node whose pivot it looks at", "Der Knoten, auf dessen Drehpunkt er blickt";
        aim_weight: "Aim weight", "Gewicht des Ziels";
        aim_weight_hint: "From 0, its own direction, to 1, towards the aim",
            "Von 0, der eigenen Richtung, bis 1, zum Ziel hin";
        visible: "Visible", "Sichtbar";
        visible_hint: "A hidden node hides what is in it", "Ein verborgener Knoten verbirgt, was in ihm ist";

        place: "Place", "Lage";
        position: "Position", "Position";
        position_hint: "In its parent: drag, or click and type",
            "In dem, worin er ist: ziehen, oder klicken und tippen";
        rotation: "Yaw, pitch, roll", "Gieren, Nicken, Rollen";
        rotation_hint: "In degrees: about y, then the turned x, then the turned z axis",
            "In Grad: um y, dann die gedrehte x-, dann die gedrehte z-Achse";
        yaw: "yaw", "Gieren";
        pitch: "pitch", "Nicken";
        roll: "roll", "Rollen";
        scale: "Scale", "Größe";
        scale_hint: "Factors along its own axes; negative ones mirror",
            "Faktoren längs der eigenen Achsen; negative spiegeln";
        pivot: "Pivot", "Drehpunkt";
        pivot_hint: "The point that stays in place when it turns and scales",
            "Der Punkt, der liegen bleibt, wenn er sich dreht und größer wird";

        zoom: "Zoom", "Zoom";
        zoom_hint: "Focal length in mm of a 36×24 mm camera, 1 to 2000",
            "Brennweite in mm einer Kleinbildkamera, 1 bis 2000";
        camera_roll: "Roll", "Winkel";
        camera_roll_hint: "Turns up about the direction of view, in degrees",
            "Dreht oben um die Blickrichtung, in Grad";
        near: "Nearest", "Nahebene";
        near_hint: "Distance of the nearest thing that it shows",
            "Abstand des Nächsten, das sie zeigt";
        far: "Farthest", "Fernebene";
        far_hint: "Distance of the farthest thing that it shows",
            "Abstand des Fernsten, das sie zeigt";

        directional: "Parallel", "Parallel";
        directional_hint: "From everywhere in its direction", "Von überall her in seiner Richtung";
        point: "Point", "Punkt";
        point_hint: "From its place into all directions", "Von seinem Ort in alle Richtungen";
        spot: "Spot", "Kegel";
        spot_hint: "From its place into a cone", "Von seinem Ort in einen Kegel";
        colour: "Colour", "Farbe";
        colour_hint: "Red, green and blue, linear, from 0", "Rot, Grün und Blau, linear, ab 0";
        red: "R", "R";
        green: "G", "G";
        blue: "B", "B";
        intensity: "Intensity", "Stärke";
        intensity_hint: "How bright it is, from 0", "Wie hell es ist, ab 0";
        cone: "Cone: inner and outer half angle", "Kegel: halber Winkel innen, außen";
        cone_hint: "In degrees, up to 90; between the two it fades",
            "In Grad, bis 90; dazwischen wird es dunkler";
        inner: "inner", "innen";
        outer: "outer", "außen";

        mesh: "Mesh: {0}", "Netz: {0}";
        mesh_points: "{0} points", "{0} Punkte";
        mesh_missing: "not found", "nicht gefunden";
        find_mesh: "{0} is missing · Find …", "{0} fehlt · Suchen …";
        find: "Find …", "Suchen …";
        find_hint: "Choose the file of this mesh; the document names it from its own folder, as before",
            "Die Datei dieses Netzes wählen; das Dokument nennt sie wie bisher von seinem Ordner aus";
        load: "Load …", "Laden …";
        load_mesh_hint: "A mesh or a point cloud from a file: OBJ, PLY, STL, glTF",
            "Ein Netz oder eine Punktwolke aus einer Datei: OBJ, PLY, STL, glTF";
        reload: "Read again", "Neu lesen";
        reload_hint: "Read its file as it is now", "Die Datei lesen, wie sie jetzt ist";
        mesh_gone: "{0} is gone; its last mesh stays", "{0} ist weg; das letzte Netz bleibt";
        no_mesh_file: "Its mesh comes from no file", "Das Netz stammt aus keiner Datei";
        mesh_title: "Load a mesh", "Netz laden";
        shape_title: "Load a shape", "Form laden";

        shapes: "Shapes", "Formen";
        add_shape: "+ Shape …", "+ Form …";
        add_shape_hint: "Add a shape from a mesh file with the same number of points; its weight begins at 0",
            "Eine andere Form seiner Punkte, aus einer Netzdatei mit gleich vielen; sie beginnt mit Gewicht 0";
        weight: "Weight of {0}", "Gewicht von {0}";
        weights: "Weights of the shapes", "Gewichte der Formen";
        weight_hint: "The weight of this shape; the mesh itself gets the remainder to 1",
            "Wie viel von dieser Form; das Netz nimmt, was bis 1 fehlt";
        remove_shape: "Remove the shape {0}", "Form {0} löschen";

        deformations: "Deformations", "Verformungen";
        add_deformation: "+ Deformation", "+ Verformung";
        add_deformation_hint: "Deform the object, after its other deformations, within the box of its mesh",
            "Verformt das Objekt, nach den vorhandenen, im Quader um das Netz";
        choose_box_hint: "Show its box in the space, and its numbers here",
            "Den Quader im Raum zeigen, und hier die Zahlen";
        box_low: "Box from", "Quader von";
        box_high: "Box to", "Quader bis";
        box_hint: "The deformation is relative to this box, in the object's own coordinates",
            "Die Verformung richtet sich nach diesem Quader, in den eigenen Koordinaten des Objekts";
        box_of_mesh: "Box of the mesh", "Quader des Netzes";
        box_of_mesh_of: "Box of the mesh: {0}", "Quader des Netzes: {0}";
        box_of_mesh_hint: "Let it follow the bounds of the mesh again", "Wieder nach den Grenzen des Netzes";
        bulge: "Bulge", "Ausbauchen";
        axis: "Axis of {0}", "Achse von {0}";
        bend_axis_hint: "The axis about which it bends what lies along the next one; a click chooses another",
            "Die Achse, um die sie biegt, was längs der nächsten liegt; ein Klick wählt eine andere";
        axis_hint: "The axis along which it deforms; a click chooses the next one",
            "Die Achse, längs der sie verformt; ein Klick wählt die nächste";
        earlier: "{0} earlier", "{0} früher";
        later: "{0} later", "{0} später";
        remove_deformation: "Remove {0}", "{0} löschen";
        angle: "Angle", "Winkel";
        middle_width: "Width in the middle", "Breite in der Mitte";
        first_width: "Width at the low end", "Breite unten";
        last_width: "Width at the high end", "Breite oben";
        first_angle: "First angle", "Erster Winkel";
        last_angle: "Last angle", "Letzter Winkel";
        lattice: "Control points", "Kontrollpunkte";
        parameter_hint: "A number of the deformation, which may change in time",
            "Eine Zahl der Verformung, die sich mit der Zeit ändern darf";

        values: "Values for the program", "Werte für das Programm";
        value_hint: "Numbers by keys that only the program knows how to use",
            "Zahlen durch Schlüssel, die nur das Programm zu nutzen weiß";

        motion: "Motion", "Bewegung";
        none: "None", "Keine";
        none_hint: "It rests, with the values of its last keys", "Er ruht; von Schlüsseln bleiben die letzten";
        by_keys: "Keys", "Schlüssel";
        by_keys_hint: "Its values change by keys; of a path it has one a frame",
            "Seine Werte ändern sich durch Schlüssel; aus einer Bahn einer je Bild";
        by_path: "Path", "Bahn";
        by_path_hint: "It follows its own path", "Er folgt einer eigenen Bahn";
        start: "Begins at frame", "Beginnt bei Bild";
        start_hint: "The scene's frame of the path's first pose",
            "Das Bild der Szene, in dem die Bahn beginnt";
        pinned_start: "A marker holds the path in time", "Eine Marke hält die Bahn in der Zeit fest";
        beyond: "Before and after: {0}", "Davor und danach: {0}";
        beyond_name: "Before and after", "Davor und danach";
        beyond_hint: "What it does before its path begins and after it ends",
            "Was er tut, bevor seine Bahn beginnt und nachdem sie endet";
        hold: "rests", "ruht";
        repeat: "starts over", "von vorn";
        pingpong: "back and forth", "hin und her";
        path_to_keys: "A key a frame", "Einer je Bild";
        path_to_keys_hint: "Replace the path with a key per frame: it moves the same. One step to undo",
            "Ein Schlüssel je Bild tritt an die Stelle der Bahn: Er bewegt sich gleich. Ein Schritt, der sich zurücknehmen lässt";
        few_keys: "Few keys", "Wenige";
        few_keys_hint: "Replace the path with as few keys with tangents as stay this near at each frame. One step to undo",
            "So wenige Schlüssel mit Tangenten, wie bei jedem Bild so nah an der Bahn bleiben, treten an ihre Stelle. Ein Schritt, der sich zurücknehmen lässt";
        became_few_keys: "{0} keys: at most {1} and {2}° beside the path",
            "{0} Schlüssel: höchstens {1} und {2}° neben der Bahn";
        nearness: "Nearness", "Nähe";
        nearness_hint: "How far the path may be from the keys, or few keys from the path",
            "Wie nah die Bahn den Schlüsseln kommt, oder wenige Schlüssel der Bahn";
        nearness_angle: "Nearness of the view", "Nähe des Blicks";
        nearness_angle_hint: "How many degrees the orientation may differ", "Dasselbe: um wie viel er gedreht sein darf";
        keys_to_path: "Keys to path", "Schlüssel zu Bahn";
        became_keys: "Keys in place of the path", "Schlüssel anstelle der Bahn";
        rests: "It rests", "Er ruht";

        key_of: "Key: {0}", "Schlüssel: {0}";
        key_no_track: "No keys yet: set the first one here",
            "Es bewegt sich nicht: hier einen ersten Schlüssel setzen";
        key_not_here: "No key at this frame: set one with the current value",
            "In diesem Bild kein Schlüssel: einen mit dem Wert setzen, der da ist";
        key_here: "A key at this frame: remove it; the last key's value stays",
            "In diesem Bild ein Schlüssel: ihn löschen; der Wert des letzten bleibt";
        by_its_path: "Its path moves this", "Das bewegt seine Bahn";
        more_than_half: "Keys of quaternions go the shorter way: for more than half a turn choose Angles in the menu of the track (right button)",
            "Schlüssel von Quaternionen gehen den kürzeren Weg: Für mehr als eine halbe Drehung im Menü der Spur (rechte Taste) Winkel wählen";
        turned_too_far: "{0} · More than half a turn: only keys by angles keep it",
            "{0} · Mehr als eine halbe Drehung: Nur Schlüssel aus Winkeln behalten sie";
        set_keys: "Keys for position, rotation and scale of the selected nodes",
            "Schlüssel für Ort, Drehung und Größe der gewählten Knoten";
        keys_set: "Keys for position, rotation and scale", "Schlüssel für Ort, Drehung und Größe";
        keys_are_there: "Position, rotation and scale have keys at this frame",
            "In diesem Bild gibt es Schlüssel für Ort, Drehung und Größe";
    }
}

impl NodePanel {
    /// What a number of a deformation is called.
    pub(crate) fn parameter<'a>(&self, name: &'a str) -> &'a str {
        match name {
            "angle" => self.angle,
            "a" => self.middle_width,
            "r0" => self.first_width,
            "r1" => self.last_width,
            "phi_min" => self.first_angle,
            "phi_max" => self.last_angle,
            "points" => self.lattice,
            other => other,
        }
    }
}
