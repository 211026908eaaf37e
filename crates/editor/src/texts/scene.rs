//! Texts of the list of a scene's nodes.

use super::texts;

texts! {
    Scene {
        title: "Scene", "Szene";
        below: "In no node", "In keinem Knoten";
        below_hint: "Click: select nothing; drag a node here: give it no parent",
            "Klick: nichts auswählen; einen Knoten hierher ziehen: in keinen tun";
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
        runs_by_keys: "{0} moves by keys, not along a path: the flight of this camera can be watched and written to a file, but there are no points to edit.",
            "{0} bewegt sich durch Schlüsselwerte, nicht auf einer Bahn: Der Flug dieser Kamera lässt sich ansehen und ausgeben, aber es gibt keine Punkte zu bearbeiten.";
        keys_to_path: "Make it a path", "Zu einer Bahn machen";
        keys_to_path_hint: "Replace its keys with a path of few points that flies nearly the same; the message says how nearly. One step to undo",
            "Eine Bahn aus wenigen Punkten tritt an die Stelle der Schlüssel und fliegt fast dasselbe; wie genau, wird gesagt. Ein Schritt, der sich zurücknehmen lässt";
        became_path: "A path of {0} points: at most {1} and {2}° beside the keys",
            "Eine Bahn aus {0} Punkten: höchstens {1} und {2}° neben den Schlüsseln";
        list: "List of the scene", "Liste der Szene";
        row_hint: "Double click or F2: rename; drag onto a node: make it a child; Del: remove; Ctrl+D, Ctrl+C: copy",
            "Doppelklick oder F2: umbenennen; auf einen anderen ziehen: hineintun; Entf: löschen; Strg+D, Strg+C: kopieren";
        name: "Name of the node", "Name des Knotens";
        needs_name: "{0} needs a name", "{0} braucht einen Namen";
        filter: "Look for a name", "Namen suchen";
        filter_hint: "Only nodes whose names contain this, and their parents",
            "Nur Knoten, deren Namen dies enthalten, und worin sie liegen";
        not_found: "No node is called so", "Kein Knoten heißt so";
        fold: "Fold {0}", "{0} zuklappen";
        unfold: "Unfold {0}", "{0} aufklappen";
        hide: "Hide {0}", "{0} verbergen";
        show: "Show {0}", "{0} zeigen";
        eye_hint: "What is in it is hidden with it", "Was darin liegt, ist mit verborgen";
        eye_key_hint: "Sets a key at this frame", "Setzt einen Schlüssel bei diesem Bild";
        goes_along: "{0} moves: its values stay, and it moves with its new parent",
            "{0} bewegt sich: Die eigenen Zahlen bleiben, und mitgenommen wird es von dem, worin es jetzt liegt";
        shown_camera: "Shown camera", "Gezeigte Kamera";
        shown_camera_hint: "Click: choose the camera that is shown; its poses are handed over and written",
            "Klick: die Kamera wählen, die gezeigt wird; ihre Posen werden übergeben und geschrieben";
        keeps_way: "{0} moves as before, with other values",
            "{0} bewegt sich wie zuvor, mit anderen eigenen Zahlen";
        other_parent: "Another parent", "Andere Überordnung";
        one_moves: "{0} moves. What does it keep?", "{0} bewegt sich. Was bleibt?";
        several_move: "{0} and others move, {1} in all. What do they keep?",
            "{0} und andere bewegen sich, zusammen {1}. Was bleibt?";
        go_along: "Follow parent", "Mitbewegen";
        go_along_hint: "Its values stay; it moves with its new parent",
            "Die eigenen Zahlen bleiben; mitgenommen wird es von dem, worin es dann liegt";
        keep_way: "Keep motion", "Bewegung behalten";
        keep_way_hint: "It moves through the world as before: its keys are recomputed, one per frame where a parent moves",
            "Es bewegt sich durch die Welt wie zuvor: Die Schlüssel werden neu berechnet, einer je Bild, wo sich eine Überordnung bewegt";
        nothing_copied: "No node is selected", "Kein Knoten ist gewählt";
        nodes_copied: "Nodes copied: {0}", "Knoten kopiert: {0}";
        nodes_pasted: "Nodes pasted: {0}", "Knoten eingefügt: {0}";
        pasted_without_aim: "Nodes pasted: {0}. Missing aim targets: {1}",
            "Knoten eingefügt: {0}. Ihr Ziel gibt es hier nicht: {1}";
        no_nodes: "What was copied last is no node of a scene: nothing was pasted",
            "Das zuletzt Kopierte ist kein Knoten einer Szene: Nichts wurde eingefügt";
        nodes_not_pasted: "The copied nodes cannot be pasted: {0}",
            "Die kopierten Knoten lassen sich nicht einfügen: {0}";
        aims_lost: "What they aimed at is gone: {0}", "Ihr Ziel ist gelöscht: {0}";
        aim_became_views: ". Its aim has become views of the points",
            ". Sein Ziel ist zu Blicken der Punkte geworden";
        no_camera: "no camera", "keine Kamera";
        at_frame: "{0}, frame {1}", "{0}, Bild {1}";
    }
}
