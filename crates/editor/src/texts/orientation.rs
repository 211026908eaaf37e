//! Texts of the orientation panel.

use super::texts;

texts! {
    Orientation {
        heading: "View", "Blick";
        at_place: "looks at a place", "blickt auf einen Ort";
        in_direction: "looks in a direction", "blickt in eine Richtung";
        along_way: "looks along the way", "blickt den Weg entlang";
        add: "+ View", "+ Blick";
        add_hint: "Insert a copy of this view after it (Ori.+)",
            "Eine Kopie dieses Blicks dahinter einfügen (Ori.+)";
        remove: "− View", "− Blick";
        remove_hint: "Remove this view (Ori.-)", "Diesen Blick löschen (Ori.-)";
        absolute: "Target", "Ziel";
        absolute_hint: "The camera looks at a place that stays when the point moves (Abs.)",
            "Die Kamera blickt auf einen Ort, der beim Verschieben des Punktes bleibt (Abs.)";
        relative: "Direction", "Richtung";
        relative_hint: "The camera keeps its direction when the point moves (Rel.)",
            "Die Kamera behält ihre Richtung, wenn der Punkt verschoben wird (Rel.)";
        ahead: "Along path", "Voraus";
        ahead_hint: "The camera looks along the path",
            "Die Kamera blickt aufrecht ihren Weg entlang";
        whole: "Whole object", "Ganzes Objekt";
        whole_hint: "Look at the middle of the object and zoom so that all of it is in the picture, with a tenth free at each side",
            "Auf die Mitte des Objekts blicken und so zoomen, dass es ganz im Bild ist und auf jeder Seite ein Zehntel frei bleibt";
        distance: "Ahead", "Voraus";
        distance_hint: "How far ahead on the path it looks; 0: along the tangent",
            "Sie blickt auf den Ort so weit voraus auf ihrem Weg; 0: die Tangente entlang";
        previous_hint: "Go to the previous view of this point (<< Ori)",
            "Zum vorigen Blick dieses Punktes (<< Ori)";
        next_hint: "Go to the next view of this point (Ori >>)",
            "Zum nächsten Blick dieses Punktes (Ori >>)";
        count: "{0} of {1}", "{0} von {1}";
        target: "Target {0}", "Ziel {0}";
        target_hint: "The place that the camera looks at: drag, or click and type",
            "Ort, auf den die Kamera blickt: ziehen, oder klicken und tippen";
        direction: "Direction {0}", "Richtung {0}";
        direction_hint: "The direction that the camera looks in: drag, or click and type",
            "Richtung, in die die Kamera blickt: ziehen, oder klicken und tippen";
        roll: "Roll", "Winkel";
        roll_hint: "By how much the camera is turned about its view direction",
            "Drehung der Kamera um ihre Blickrichtung";
        up: "Up: {0}", "Oben: {0}";
        up_hint: "Which way is up for the camera before the roll",
            "Wo für die Kamera oben ist, vor dem Winkel";
        up_axis: "vertical", "senkrecht";
        up_axis_hint: "Along the up axis of the space", "Längs der senkrechten Achse des Raums";
        up_place: "a point", "ein Punkt";
        up_place_hint: "Towards a point of the space", "Zu einem Punkt des Raums hin";
        up_path: "a path", "eine Bahn";
        up_path_hint: "Towards the place at the same share of the length of the second path",
            "Zum Ort auf der zweiten Bahn beim selben Anteil der Länge hin";
        up_minimal: "minimal", "minimal";
        up_minimal_hint: "Transported from key to key, without turning about the view",
            "Von Stelle zu Stelle mitgenommen, ohne Drehung um den Blick";
        up_frenet: "curvature", "Krümmung";
        up_frenet_hint: "Towards where the curve bends (Frenet); only where the curve is a cubic spline",
            "Dorthin, wohin sich die Kurve krümmt (Frenet); nur bei kubischem Spline";
        up_y: "y axis", "y-Achse";
        up_z: "z axis", "z-Achse";
        up_fixed_hint: "Along this axis of the world, whatever the space's up axis",
            "Längs dieser Achse der Welt, was auch im Raum senkrecht steht";
        up_at: "Up towards {0}", "Oben zu {0}";
        up_at_hint: "The point that is up for the camera: drag, or click and type",
            "Der Punkt, der für die Kamera oben ist: ziehen, oder klicken und tippen";
        own_turning: "Own turning ×", "Eigene Drehung ×";
        own_turning_hint: "An insertion set a custom turning rate here. Click: remove it, so that the neighbouring views shape the turning again",
            "Die Kamera dreht sich hier in eigenem Maß, wie ein Einfügen es hinterlässt: das zurückgeben, und die Blicke ringsum formen die Drehung wieder";
        own_slope: "Own slope ×", "Steigung ×";
        own_slope_hint: "The zoom has a custom rate here. Click: remove it, so that the neighbouring views shape the zoom again",
            "Der Zoom ändert sich hier in eigenem Maß: das zurückgeben, und die Blicke ringsum formen den Zoom wieder";

        at_most: "A point has at most {0} views",
            "Ein Punkt hat höchstens {0} Blicke";
        one_remains: "One view always remains: this one cannot be removed",
            "Ein Blick bleibt immer: Dieser lässt sich nicht löschen";
        only_one: "This point has only one view", "Dieser Punkt hat nur einen Blick";
        all_aimed: "{0} views aimed at this target", "{0} Blicke auf dieses Ziel gerichtet";
        on_position: "The camera must not look at its own position",
            "Die Kamera darf nicht auf ihren eigenen Ort blicken";
    }
}
