//! Texts of the space window.

use super::texts;

texts! {
    SpaceWindow {
        title: "Space", "Raum";
        centre: "Centre", "Mittelpunkt";
        centre_hint: "The middle of the movement space in the world",
            "Die Mitte des Bewegungsraums in der Welt";
        half_size: "Half size", "Halbe Größe";
        half_size_hint: "From the middle of the movement space to a face; base speeds are relative to it",
            "Von der Mitte des Bewegungsraums bis zu einer Fläche; Grundgeschwindigkeiten zählen Wege darin";
        unit: "Unit", "Einheit";
        unit_hint: "What a length of 1 is called, such as m", "Wie eine Länge von 1 heißt, etwa m";
        up: "Up axis", "Senkrecht";
        up_hint: "The axis of the world that is up", "Die Achse der Welt, die senkrecht steht";
        path: "The path", "Die Bahn";
        keep: "stays as it is", "bleibt, wie sie ist";
        keep_hint: "Points keep their coordinates and views show the same; rolls count from the new up axis",
            "Punkte behalten ihre Koordinaten, Blicke zeigen dasselbe; das Rollen zählt von der neuen senkrechten Achse";
        fit: "moves with it", "bewegt sich mit";
        fit_hint: "It lies in the new space as it did in the old one; the object stays where it is",
            "Sie liegt im neuen Raum, wie sie im alten lag; das Objekt bleibt, wo es ist";
        to_object: "Around the object", "Um das Objekt";
        to_object_hint: "Fit centre and size to the object", "Mittelpunkt und Größe an das Objekt anpassen";
        no_object: "This path has no object", "Diese Bahn hat kein Objekt";
        to_path: "Around the path", "Um die Bahn";
        to_path_hint: "Fit centre and size to the path", "Mittelpunkt und Größe an die Bahn anpassen";
        apply: "Apply", "Übernehmen";
        apply_hint: "Change the space and leave this window open", "Den Raum ändern und dieses Fenster offen lassen";
        ok: "OK", "OK";
        ok_hint: "Change the space and close this window", "Den Raum ändern und dieses Fenster schließen";
    }
}
