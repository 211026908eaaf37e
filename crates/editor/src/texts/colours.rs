//! Texts of the colour window.

use super::texts;

texts! {
    Colours {
        title: "Colours", "Farben";
        red: "Red", "Rot";
        green: "Green", "Grün";
        blue: "Blue", "Blau";
        reset: "Reset", "Zurücksetzen";
        reset_hint: "Give this element its first colour back", "Diesem Element seine erste Farbe zurückgeben";
        reset_all: "Reset all", "Alle zurücksetzen";
        reset_all_hint: "Give all elements their first colours back",
            "Allen Elementen ihre erste Farbe zurückgeben";
        of_theme: "Theme: {0}", "Erscheinungsbild: {0}";
    }
}
