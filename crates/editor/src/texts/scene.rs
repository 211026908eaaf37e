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
        runs_by_keys: "The camera {0} moves by keys, not along a path: its flight can be watched and written to a file, but there are no points to edit.",
            "Die Kamera {0} bewegt sich durch Schlüsselwerte, nicht auf einer Bahn: Ihr Flug lässt sich ansehen und ausgeben, aber es gibt keine Punkte zu bearbeiten.";
        keys_to_path: "Make it a path", "Zu einer Bahn machen";
        keys_to_path_hint: "A path of few points takes the place of its keys and flies nearly the same; how nearly is told. One step, which can be undone",
            "Eine Bahn aus wenigen Punkten tritt an die Stelle der Schlüssel und fliegt fast dasselbe; wie genau, wird gesagt. Ein Schritt, der sich zurücknehmen lässt";
        became_path: "A path of {0} points: at most {1} and {2}° beside the keys",
            "Eine Bahn aus {0} Punkten: höchstens {1} und {2}° neben den Schlüsseln";
        at_frame: "{0}, frame {1}", "{0}, Bild {1}";
    }
}
