//! Texts of the check window.

use super::{Language, texts};
use crate::tools::check::Finding;

texts! {
    Check {
        menu: "Check …", "Prüfen …";
        menu_hint: "What will look wrong in the film", "Was im Film falsch aussehen wird";
        title: "Check", "Prüfung";
        nothing: "Nothing was found", "Nichts gefunden";
        one: "1 finding", "1 Fund";
        many: "{0} findings", "{0} Funde";
        old: "The path has changed since", "Die Bahn hat sich seither geändert";
        now: "Check now", "Jetzt prüfen";
        now_hint: "Check the path as it is now", "Die Bahn prüfen, wie sie jetzt ist";
        large: "So long a film, or one with so large an object, is checked when you ask for it",
            "Ein so langer Film oder einer mit so großem Objekt wird auf Wunsch geprüft";
        frame: "Frame {0}", "Bild {0}";
        frames: "Frames {0}–{1}", "Bilder {0}–{1}";
        go_hint: "Go to this frame and select the key before it: point {0}",
            "Zu diesem Bild gehen und die Stelle davor wählen: Punkt {0}";
        mend: "Fix", "Beheben";
    }
}

/// A kind of finding: its name, its message in both languages, and its remedy in German.
/// `{0}` is the worst value, `{1}` the limit.
#[rustfmt::skip]
const WORDS: [(&str, &str, &str, &str); 16] = [
    ("space", "The camera is outside the space, by {0} half sizes",
        "Die Kamera ist außerhalb des Raums, um {0} halbe Größen",
        "Punkte verschieben oder skalieren"),
    ("cusp", "The way nearly stops within a section",
        "Der Weg bleibt in einem Abschnitt fast stehen",
        "Punkte auseinanderziehen oder ihnen Tangenten geben"),
    ("speed-jump", "The speed jumps at a key",
        "Die Geschwindigkeit springt an einer Stelle",
        "den Abschnitt sanft beginnen und enden lassen"),
    ("acceleration", "The camera accelerates too much: {0} (limit {1})",
        "Die Kamera beschleunigt zu stark: {0} (Grenze {1})",
        "den Abschnitt sanft beginnen und enden lassen oder ihm mehr Bilder geben"),
    ("view-jump", "The view jumps by {0}°", "Der Blick springt um {0}°",
        "ein Stück vorausblicken oder die Ecke abrunden"),
    ("turning", "The view turns too fast: {0}°/s (limit {1})",
        "Der Blick dreht sich zu schnell: {0}°/s (Grenze {1})",
        "dem Abschnitt mehr Bilder geben"),
    ("turning-acceleration", "The turning accelerates too much: {0}°/s² (limit {1})",
        "Die Drehung beschleunigt zu stark: {0}°/s² (Grenze {1})",
        "den Abschnitt sanft beginnen und enden lassen"),
    ("half-turn", "A half turn might go either way",
        "Eine halbe Drehung könnte in beide Richtungen gehen",
        "einen Blick dazwischen einfügen"),
    ("pole", "The view is nearly straight up or down: the picture spins",
        "Der Blick geht fast senkrecht: Das Bild dreht sich",
        "den Weg daneben vorbeiführen"),
    ("target", "The target is too near: {0} half sizes (limit {1})",
        "Das Ziel ist zu nah: {0} halbe Größen (Grenze {1})",
        "den Weg daneben vorbeiführen"),
    ("clearance", "The object is too near: {0} half sizes (limit {1})",
        "Das Objekt ist zu nah: {0} halbe Größen (Grenze {1})",
        "den Weg daneben vorbeiführen"),
    ("through", "The way leads through the object", "Der Weg führt durch das Objekt",
        "den Weg daneben vorbeiführen"),
    ("nothing-to-see", "Nothing of the object is in the picture for {0} s",
        "Vom Objekt ist {0} s lang nichts im Bild",
        "die Blicke auf das Objekt richten"),
    ("zoom", "The zoom is too fast: {0} mm/s (limit {1})",
        "Der Zoom ist zu schnell: {0} mm/s (Grenze {1})",
        "dem Abschnitt mehr Bilder geben"),
    ("redundant", "Two keys stand where one would do",
        "Zwei Stellen stehen, wo eine genügte",
        "die Orientierung oder den Punkt löschen"),
    ("corner", "The way turns by {0}° at a point (limit {1})",
        "Der Weg knickt an einem Punkt um {0}° ab (Grenze {1})",
        "dem Punkt Tangenten geben"),
];

impl Language {
    /// The message of a finding, and its remedy.
    pub(crate) fn finding(self, finding: &Finding) -> (String, &'static str) {
        let number = |value: f64| {
            let decimals = if value.abs() < 1.0 { 3 } else { 1 };
            self.number(value, decimals)
        };
        let (name, remedy) = (finding.kind.name(), finding.kind.remedy());
        let words = WORDS.iter().find(|words| words.0 == name);
        let Some(&(_, english, german, helps)) = words else {
            return (name.to_owned(), remedy);
        };
        let (text, remedy) = match self {
            Self::English => (english, remedy),
            Self::German => (german, helps),
        };
        let values: [&dyn std::fmt::Display; 2] = [&number(finding.value), &number(finding.limit)];
        (super::fill(text, &values), remedy)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tools::check::FindingKind;

    #[test]
    fn each_kind_has_its_words() {
        for kind in FindingKind::all() {
            let name = kind.name();
            assert!(WORDS.iter().any(|words| words.0 == name), "{name}");
        }
    }
}
