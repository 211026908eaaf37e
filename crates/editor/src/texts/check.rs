//! Texts of the check window.

use vides_document::Note;
use vides_engine::tools::check::{COUNT, Finding, FindingKind};

use super::{Language, texts};

texts! {
    Check {
        menu: "Check …", "Prüfen …";
        menu_hint: "What will look wrong in the film", "Was im Film falsch aussehen wird";
        title: "Check", "Prüfung";
        nothing: "Nothing was found.", "Nichts gefunden.";
        one: "1 finding", "1 Fund";
        many: "{0} findings", "{0} Funde";
        before: "{0} before the fix", "{0} vor dem Beheben";
        old: "The path has changed since", "Die Bahn hat sich seither geändert";
        now: "Check now", "Jetzt prüfen";
        now_hint: "Check the path as it is now", "Die Bahn prüfen, wie sie jetzt ist";
        large: "Long films and large objects are checked only when you ask for it",
            "Ein so langer Film oder einer mit so großem Objekt wird auf Wunsch geprüft";
        frame: "Frame {0}", "Bild {0}";
        frames: "Frames {0}–{1}", "Bilder {0}–{1}";
        go_hint: "Go to this frame and select the key before it: point {0}",
            "Zu diesem Bild gehen und die Stelle davor wählen: Punkt {0}";
        mend: "Fix", "Beheben";
        fixed_way: "Fixed: the path keeps its distance from the object",
            "Behoben: Die Bahn hält Abstand vom Objekt";
        fixed_views: "Fixed: the views show the object", "Behoben: Die Blicke zeigen das Objekt";
        fixed_pace: "Fixed from point {0}, frame {1}: the pace is within the limits",
            "Behoben ab Punkt {0}, Bild {1}: Das Tempo liegt in den Grenzen";
        fixed_frames: "Fixed from point {0}, frame {1}: the section has more frames",
            "Behoben ab Punkt {0}, Bild {1}: Der Abschnitt hat mehr Bilder";
        fixed_ahead: "Fixed at point {0}, frame {1}: the view looks farther ahead",
            "Behoben an Punkt {0}, Bild {1}: Der Blick geht weiter voraus";
        fixed_speeds: "Fixed at point {0}, frame {1}: one speed leads into the next",
            "Behoben an Punkt {0}, Bild {1}: Die Geschwindigkeiten gehen ineinander über";
        fixed_curve: "Fixed at point {0}, frame {1}: the path is smooth there",
            "Behoben an Punkt {0}, Bild {1}: Die Bahn ist dort glatt";
        fixed_key: "Fixed: what point {0}, frame {1} did not need is removed",
            "Behoben: Was an Punkt {0}, Bild {1} überflüssig war, ist entfernt";
        no_fix: "No change was found that lessens this", "Es wurde keine Änderung gefunden, die das verringert";
        limits: "Limits", "Grenzen";
        limits_hint: "What counts as wrong in this path; it is saved with the path",
            "Was in dieser Bahn als falsch gilt; es wird mit ihr gespeichert";
        limit_hint: "Look for this", "Danach suchen";
        inside: "The camera is inside the object all the time.",
            "Die Kamera ist die ganze Zeit im Objekt.";
        moving: "The object “{0}” moves or changes: it was checked as it is where the path begins.",
            "Das Objekt „{0}“ bewegt oder ändert sich: Geprüft wurde, wie es am Anfang der Bahn steht.";
        all_moving: "The object “{0}” and {1} more move or change: they were checked as they are where \
                     the path begins.",
            "Das Objekt „{0}“ und {1} weitere bewegen oder ändern sich: Geprüft wurde, wie sie am \
             Anfang der Bahn stehen.";
        camera: "The camera’s path was checked alone, without its parent, aim, roll and keys.",
            "Geprüft wurde die Bahn der Kamera allein, ohne was Träger, Blickziel, Rollen und \
             Schlüssel beitragen.";
    }
}

/// A kind of finding in German: its name, what its limit limits and in which unit, its sentence
/// ([`FindingKind::sentence`]) and its remedy.
#[rustfmt::skip]
const GERMAN: [(&str, &str, &str, &str, &str); COUNT] = [
    ("space", "außerhalb des Raums", "halbe Größen",
        "Ab Punkt {2}, Blick {3} ist die Kamera bis zu {0} halbe Größen außerhalb des Raums (Grenze {1}).",
        "Punkte verschieben oder skalieren."),
    ("cusp", "Geschwindigkeit im Abschnitt", "der mittleren",
        "Ab Punkt {2}, Blick {3} bleibt der Weg im Abschnitt fast stehen, bei {0} der mittleren Geschwindigkeit (Grenze {1}).",
        "Punkte auseinanderziehen oder ihnen glatte Tangenten geben."),
    ("speed-jump", "Sprung der Geschwindigkeit", "mittlere",
        "An Punkt {2}, Blick {3} springt die Geschwindigkeit um {0} mittlere Geschwindigkeiten (Grenze {1}).",
        "Die Geschwindigkeiten beider Abschnitte verbinden, oder sie ruhend enden und beginnen lassen."),
    ("acceleration", "Beschleunigung", "halbe Größen/s²",
        "Ab Punkt {2}, Blick {3} beschleunigt die Kamera mit {0} halben Größen/s² (Grenze {1}).",
        "Den Abschnitt sanft beginnen und enden lassen oder ihm mehr Bilder geben."),
    ("view-jump", "Sprung des Blicks", "°",
        "Ab Punkt {2}, Blick {3} springt der Blick um {0}° (Grenze {1}°).",
        "Ein Stück vorausblicken oder die Ecke abrunden."),
    ("turning", "Drehung", "°/s",
        "Ab Punkt {2}, Blick {3} dreht sich der Blick mit {0}°/s (Grenze {1}°/s).",
        "Dem Abschnitt mehr Bilder geben."),
    ("turning-acceleration", "Beschleunigung der Drehung", "°/s²",
        "Ab Punkt {2}, Blick {3} beschleunigt die Drehung mit {0}°/s² (Grenze {1}°/s²).",
        "Den Abschnitt sanft beginnen und enden lassen."),
    ("half-turn", "Abstand von der halben Drehung", "°",
        "Ab Punkt {2}, Blick {3} macht der Blick bis auf {0}° eine halbe Drehung, die in beide Richtungen gehen könnte (Grenze {1}°).",
        "Einen Blick dazwischen einfügen."),
    ("pole", "Abstand von der Senkrechten", "°",
        "Ab Punkt {2}, Blick {3} kommt der Blick der Senkrechten bis auf {0}° nahe, wo sich das Bild dreht (Grenze {1}°).",
        "Den Weg daneben vorbeiführen."),
    ("target", "Abstand vom Ziel", "halbe Größen",
        "Ab Punkt {2}, Blick {3} kommt die Kamera ihrem Ziel bis auf {0} halbe Größen nahe (Grenze {1}).",
        "Den Weg daneben vorbeiführen."),
    ("clearance", "Abstand vom Objekt", "halbe Größen",
        "Ab Punkt {2}, Blick {3} kommt die Kamera dem Objekt bis auf {0} halbe Größen nahe (Grenze {1}).",
        "Den Weg daneben vorbeiführen."),
    ("through", "Weg durch das Objekt", "",
        "Ab Punkt {2}, Blick {3} führt der Weg durch das Objekt.",
        "Den Weg daneben vorbeiführen."),
    ("nothing-to-see", "nichts vom Objekt im Bild", "s",
        "Ab Punkt {2}, Blick {3} ist {0} s lang nichts vom Objekt im Bild (Grenze {1} s).",
        "Die Blicke auf das Objekt richten."),
    ("zoom", "Geschwindigkeit des Zooms", "mm/s",
        "Ab Punkt {2}, Blick {3} ändert sich der Zoom mit {0} mm/s (Grenze {1} mm/s).",
        "Dem Abschnitt mehr Bilder geben."),
    ("redundant", "Änderung durch eine Stelle", "× (0,001 halbe Größen, 0,1°, 0,1 mm)",
        "Ohne Punkt {2}, Blick {3} wären die Posen dieselben.",
        "Den Blick oder den Punkt löschen."),
    ("corner", "Knick des Wegs an einem Punkt", "°",
        "An Punkt {2}, Blick {3} knickt der Weg um {0}° ab (Grenze {1}°).",
        "Dem Punkt glatte Tangenten geben."),
    ("jerk", "Änderung der Beschleunigung", "halbe Größen/s³",
        "Ab Punkt {2}, Blick {3} ändert sich die Beschleunigung um {0} halbe Größen/s³ (Grenze {1}).",
        "Den Abschnitt sanft beginnen und enden lassen oder ihm mehr Bilder geben."),
    ("speed", "Geschwindigkeit", "halbe Größen/s",
        "Ab Punkt {2}, Blick {3} bewegt sich die Kamera mit {0} halben Größen/s (Grenze {1}).",
        "Dem Abschnitt mehr Bilder geben."),
    ("crossing", "Zeit, in der etwas das Bild durchquert", "s",
        "Ab Punkt {2}, Blick {3} durchquert, wohin die Kamera blickt, das Bild in {0} s (Grenze {1} s).",
        "Dem Abschnitt mehr Bilder geben."),
    ("backwards", "Rückweg, obwohl die Punkte weiterführen", "halbe Größen",
        "Ab Punkt {2}, Blick {3} geht der Weg um {0} halbe Größen zurück, obwohl die Punkte weiterführen (Grenze {1}).",
        "Die Kurve zentripetal machen oder die Punkte auseinanderziehen."),
];

fn german(
    kind: FindingKind,
) -> Option<&'static (
    &'static str,
    &'static str,
    &'static str,
    &'static str,
    &'static str,
)> {
    GERMAN.iter().find(|words| words.0 == kind.name())
}

impl Language {
    /// The sentence of a finding, and its remedy.
    pub(crate) fn finding(self, finding: &Finding) -> (String, &'static str) {
        let kind = finding.kind;
        let (sentence, remedy) = match (self, german(kind)) {
            (Self::German, Some(words)) => (words.3, words.4),
            _ => (kind.sentence(), kind.remedy()),
        };
        let say = |value: f64, decimals: usize| self.number(value, decimals);
        (finding.say(sentence, say), remedy)
    }

    /// What the fix of a finding did, at its point and frame.
    pub(crate) fn mended(self, kind: FindingKind) -> &'static str {
        let texts = &self.texts().check;
        match kind {
            FindingKind::Through | FindingKind::Clearance => texts.fixed_way,
            FindingKind::NothingToSee => texts.fixed_views,
            FindingKind::Turning | FindingKind::Zoom => texts.fixed_frames,
            FindingKind::ViewJump => texts.fixed_ahead,
            FindingKind::SpeedJump => texts.fixed_speeds,
            FindingKind::Corner | FindingKind::Cusp => texts.fixed_curve,
            FindingKind::Redundant => texts.fixed_key,
            _ => texts.fixed_pace,
        }
    }

    /// What a kind's limit limits, and its unit.
    pub(crate) fn limit(self, kind: FindingKind) -> [&'static str; 2] {
        match (self, german(kind)) {
            (Self::German, Some(words)) => [words.1, words.2],
            _ => [kind.limit().does, kind.unit()],
        }
    }

    pub(crate) fn note(self, note: &Note) -> String {
        let texts = &self.texts().check;
        match note {
            Note::Inside => texts.inside.to_owned(),
            Note::Moving { name, others: 0 } => super::fill(texts.moving, &[name]),
            Note::Moving { name, others } => super::fill(texts.all_moving, &[name, others]),
            Note::Camera => texts.camera.to_owned(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_kind_has_whole_sentences_with_the_same_numbers() {
        for kind in FindingKind::all() {
            let words = german(kind).expect("German words");
            for (sentence, remedy) in [(words.3, words.4), (kind.sentence(), kind.remedy())] {
                for text in [sentence, remedy] {
                    assert!(
                        text.starts_with(char::is_uppercase) && text.ends_with('.'),
                        "{text}"
                    );
                }
            }
            for place in ["{0}", "{1}", "{2}", "{3}"] {
                let there = [words.3, kind.sentence()].map(|text| text.contains(place));
                assert_eq!(there[0], there[1], "{place} {}", words.0);
            }
        }
    }
}
