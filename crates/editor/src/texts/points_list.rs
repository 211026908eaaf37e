//! Texts of the list of points.

use super::texts;

texts! {
    PointsList {
        heading: "Points", "Punkte";
        fold: "Fold the list of points", "Punktliste einklappen";
        unfold: "List of points", "Punktliste";
        point: "Point {0}", "Punkt {0}";
        view: "Point {0}, view {1}", "Punkt {0}, Blick {1}";
        name: "Name of the point", "Name des Punkts";
        hint: "Click: go there; Ctrl, Shift: select several; double click or F2: name; drag: another order",
            "Klick: dorthin; Strg, Umschalt: mehrere auswählen; Doppelklick oder F2: Name; Ziehen: andere Reihenfolge";
    }
}
