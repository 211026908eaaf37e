//! Texts of the panel of position and curve.

use super::texts;

texts! {
    Position {
        heading: "Position", "Position";
        curve: "Curve", "Kurve";
        add: "+ Point", "+ Punkt";
        add_hint: "Insert a point half-way to the next one; the flight stays as it is. With Shift: a copy of this point (Pos.+)",
            "Einen Punkt auf halbem Weg zum nächsten einfügen; der Flug bleibt, wie er ist. Mit Umschalt: eine Kopie dieses Punkts (Pos.+)";
        add_many_hint: "Insert 1 to 10 points at equal distances up to the next one; the flight stays as it is. With Shift: copies of this point (Pos.++)",
            "1 bis 10 Punkte in gleichen Abständen bis zum nächsten einfügen; der Flug bleibt, wie er ist. Mit Umschalt: Kopien dieses Punkts (Pos.++)";
        copy_hint: "Insert a copy of this point half-way to the next one. With Shift: a point that leaves the flight as it is (Pos.+)",
            "Eine Kopie dieses Punkts auf halbem Weg zum nächsten einfügen. Mit Umschalt: ein Punkt, der den Flug lässt, wie er ist (Pos.+)";
        copy_many_hint: "Insert 1 to 10 copies of this point at equal distances up to the next one. With Shift: points that leave the flight as it is (Pos.++)",
            "1 bis 10 Kopien dieses Punkts in gleichen Abständen bis zum nächsten einfügen. Mit Umschalt: Punkte, die den Flug lassen, wie er ist (Pos.++)";
        only_keep_hint: "Insert a point half-way to the next one; the flight stays as it is",
            "Einen Punkt auf halbem Weg zum nächsten einfügen; der Flug bleibt, wie er ist";
        only_copy_hint: "Insert a copy of this point half-way to the next one: all but its name",
            "Eine Kopie dieses Punkts auf halbem Weg zum nächsten einfügen: alles außer dem Namen";
        remove: "− Point", "− Punkt";
        remove_hint: "Remove this point (Pos.-)", "Diesen Punkt löschen (Pos.-)";
        previous_hint: "Go to the previous point (<< Pos.)", "Zum vorherigen Punkt (<< Pos.)";
        next_hint: "Go to the next point (Pos. >>)", "Zum nächsten Punkt (Pos. >>)";
        count: "{0} of {1}", "{0} von {1}";
        coordinate: "Position {0}", "Position {0}";
        coordinate_hint: "Where the camera is: drag, or click and type",
            "Ort der Kamera: ziehen, oder klicken und tippen";
        shape_hint: "At this point (b1, c1, t1): drag, or click and type; the point then has custom values",
            "An diesem Punkt (b1, c1, t1): ziehen, oder klicken und tippen; er hat dann eigene Werte";
        next_shape_hint: "At the next point (b2, c2, t2)", "Am nächsten Punkt (b2, c2, t2)";
        add_here: "Add point here", "Punkt hier einfügen";
        add_orientation_here: "Add view here", "Blick hier einfügen";
        add_here_hint: "Make a key of what the camera does in this frame",
            "Aus dem, was die Kamera in diesem Bild tut, einen Punkt oder einen Blick machen";
        is_a_key: "The camera is at a point in this frame: there is nothing to add",
            "In diesem Bild ist die Kamera an einem Punkt: Es gibt nichts einzufügen";
        outside: "No point can be added here: this path runs from frame {0} to {1}",
            "Kein Punkt hier: Diese Bahn läuft von Bild {0} bis {1}";
        in_between: "In between: typing adds it", "Zwischenwerte: Tippen fügt ein";
        preset: "Preset {0}", "Standard {0}";
        own: "Own values", "Eigendef.";
        choice: "Shape of the curve", "Form der Kurve";
        choice_hint: "Choose what shapes the curve at this point",
            "Wählen, was die Kurve an diesem Punkt formt";
        change: "Change …", "Ändern …";
        change_hint: "Open the window with presets and numbers",
            "Das Fenster mit Standardwerten und Zahlen öffnen";

        kind: "The whole path", "Die ganze Bahn";
        tcb: "By T, C and B", "Nach T, C und B";
        tcb_hint: "Tension, continuity and bias at each point (Kochanek and Bartels)",
            "Nach Tension, Continuity und Bias an jedem Punkt (Kochanek und Bartels)";
        centripetal: "Centripetal", "Zentripetal";
        centripetal_hint: "T, C and B as well, without loops or reversals between close points",
            "Auch nach T, C und B, ohne Schleifen und Rückwege, wo Punkte dicht stehen";
        chordal: "Chordal", "Nach Sehnenlängen";
        chordal_hint: "T, C and B as well, rounder between distant points",
            "Auch nach T, C und B, runder zwischen weit entfernten Punkten";
        cubic: "Spline (C2)", "Spline (C2)";
        cubic_hint: "Cubic spline: its curvature does not jump at the points",
            "Kubischer Spline: Die Krümmung springt an den Punkten nicht";
        linear: "Straight", "Gerade";
        linear_hint: "Straight from point to point", "Geradlinig von Punkt zu Punkt";
        tangents: "Tangents", "Tangenten";
        own_tangents: "Own tangents", "Eigene Tangenten";
        own_tangents_hint: "Make the tangents custom: the curve stays, and you can drag their ends",
            "Dem Punkt gehören die Tangenten, die er hat: Die Kurve bleibt, und an ihren Enden lässt sich ziehen";
        by_shape: "Tangents of the curve", "Tangenten der Kurve";
        by_shape_hint: "Remove the custom tangents: the kind of curve determines them again, with T, C and B",
            "Die eigenen Tangenten wegnehmen: Die Art der Kurve gibt sie wieder vor, mit T, C und B";
        smooth: "Smooth", "Glatt";
        smooth_hint: "One tangent turns with the other and keeps its length",
            "Eine Tangente dreht sich mit der anderen und behält ihre Länge";
        mirrored: "Mirrored", "Gespiegelt";
        mirrored_hint: "Both tangents have the same length, too",
            "Eine Tangente ist auch so lang wie die andere";
        corner: "Corner", "Ecke";
        corner_hint: "Drag one tangent alone (always with Alt)",
            "Eine Tangente bleibt, während man an der anderen zieht (mit Alt immer)";
        keeps_motion: "Tangents keep the motion", "Tangenten halten die Bewegung";
        keeps_motion_hint: "A point was inserted without changing the flight. These tangents are removed when this point or a neighbour moves. Click: remove them now",
            "Ein Punkt wurde eingefügt, ohne den Flug zu ändern. Diese Tangenten entfallen, sobald sich dieser Punkt oder einer daneben bewegt. Klick: jetzt wegnehmen";
        in_place_of_tangents: "This point has custom tangents; a choice here replaces them",
            "Dieser Punkt hat eigene Tangenten; was hier gewählt wird, tritt an ihre Stelle";
        no_shape_kind: "T, C and B apply to TCB curves only",
            "T, C und B formen nur Kurven der Art TCB";

        how_many: "How many points?", "Wie viele Punkte?";
        how_many_hint: "Number of points to insert after point {0}",
            "Anzahl der Punkte, die hinter Punkt {0} kommen";

        last_point: "The path ends at the last point: “Append after the last point” in the Edit menu extends it",
            "Die Bahn endet am letzten Punkt: „Hinter dem letzten Punkt anfügen“ im Menü Bearbeiten verlängert sie";
        two_remain: "Two points always remain: this one cannot be removed",
            "Zwei Punkte bleiben immer: Dieser lässt sich nicht löschen";
        too_many: "A path has at most {0} points", "Eine Bahn hat höchstens {0} Punkte";
        too_many_orientations: "The points of a path have at most {0} views together",
            "Die Punkte einer Bahn haben zusammen höchstens {0} Blicke";
        on_target: "A point must not lie on the target of one of its views",
            "Ein Punkt darf nicht auf dem Ziel eines seiner Blicke liegen";
        too_far: "A coordinate must lie between {0} and {1}",
            "Eine Koordinate muss zwischen {0} und {1} liegen";
        closed_has_no_ends: "A closed path has no ends to extend",
            "Eine geschlossene Bahn hat keine Enden zum Weiterführen";
        no_room: "There is no room beyond this end of the path",
            "Hinter diesem Ende der Bahn ist kein Platz mehr";
        no_direction: "The segment at this end has no length and therefore no direction",
            "Das Kurvenstück an diesem Ende hat keine Länge und damit keine Richtung";
    }
}
