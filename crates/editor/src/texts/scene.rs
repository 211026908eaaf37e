//! Texts of the list of a scene's nodes.

use super::texts;

texts! {
    Scene {
        title: "Scene", "Szene";
        whole: "Whole scene", "Ganze Szene";
        whole_hint: "Play all of it; no path is edited",
            "Alles abspielen; keine Bahn wird bearbeitet";
        edit_hint: "Edit the path of this node", "Die Bahn dieses Knotens bearbeiten";
        by_keys: "Moves by keys, not along a path",
            "Bewegt sich durch Schlüsselwerte, nicht auf einer Bahn";
        still: "Follows no path", "Folgt keiner Bahn";
        group: "group", "Gruppe";
        object: "object", "Objekt";
        light: "light", "Licht";
        camera: "camera", "Kamera";
        no_path: "No path is edited. In the list of the scene, choose a node that moves on a path.",
            "Keine Bahn wird bearbeitet. Bitte in der Liste der Szene einen Knoten wählen, \
             der sich auf einer Bahn bewegt.";
        at_frame: "{0}, frame {1}", "{0}, Bild {1}";
    }
}
