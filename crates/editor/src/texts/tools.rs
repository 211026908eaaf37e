//! Texts of the tools and of their tables, in both languages, by the names in the tables.

use vides_document::tool::Tool;
use vides_engine::tools::Parameter;

use super::{Language, texts};

texts! {
    Tools {
        menu: "Tools", "Werkzeuge";
        ok: "OK", "OK";
        ok_hint: "Keep all as it is shown now", "Alles so behalten, wie es jetzt gezeigt wird";
        write: "Write …", "Schreiben …";
        write_hint: "Choose a file for these points", "Eine Datei für diese Punkte wählen";
        cancel: "Cancel", "Abbrechen";
        cancel_hint: "Close without changes", "Ohne Änderung schließen";
        result: "{0} points · {1} frames", "{0} Punkte · {1} Bilder";
        draw_now: "Draw a line with the left button: in the space, or on the object in the camera's picture",
            "Mit der linken Taste eine Linie zeichnen: in den Raum, oder im Kamerabild auf das Objekt";
        only_path: "No path is being edited", "Es wird keine Bahn bearbeitet";
        block_written: "Points {0} to {1} are written to {2}",
            "Die Punkte {0} bis {1} sind in {2} geschrieben";
    }
}

/// A word by its name in a table: English and German.
type Word = (&'static str, &'static str, &'static str);

/// Tools by their names: the title, and what they do in German.
#[rustfmt::skip]
const TOOLS: &[(&str, &str, &str, &str)] = &[
    ("orbit", "Orbit", "Umkreisen", "auf einem Kreis um ein Ziel"),
    ("spiral", "Spiral", "Spirale", "um ein Ziel, am Ende mit anderem Radius und anderer Höhe"),
    ("arc", "Arc", "Bogen", "auf einem Teil eines Kreises, von einer Richtung zu einer anderen"),
    ("flyby", "Flyby", "Vorbeiflug", "gerade an einem Ziel vorbei, das im Bild bleibt"),
    ("approach", "Approach", "Annäherung", "gerade auf ein Ziel zu"),
    ("dolly-zoom", "Dolly zoom", "Dolly-Zoom", "auf ein Ziel zu, das im Bild gleich groß bleibt"),
    ("crane", "Crane", "Kran", "gerade hinauf oder hinunter neben einem Ziel, das im Bild bleibt"),
    ("pan", "Pan", "Schwenk", "dreht sich auf der Stelle"),
    ("figure-eight", "Figure eight", "Acht", "auf einer Acht, die vor dem Ziel liegt"),
    ("draw", "Draw", "Zeichnen", "macht eine Bahn aus einer Linie, mit der linken Taste in den Raum gezeichnet"),
    ("move", "Move points", "Punkte verschieben", "verschiebt Punkte"),
    ("turn", "Turn points", "Punkte drehen", "dreht Punkte um eine Achse"),
    ("scale", "Scale points", "Punkte skalieren", "vergrößert oder verkleinert die Lage der Punkte"),
    ("mirror", "Mirror points", "Punkte spiegeln", "spiegelt Punkte längs einer Achse"),
    ("taper", "Taper", "Verjüngen", "macht ein Ende des Quaders um die Punkte schmaler"),
    ("bulge", "Bulge", "Ausbauchen", "macht die Mitte des Quaders um die Punkte breiter"),
    ("twist", "Twist", "Verdrillen", "verdrillt den Quader um die Punkte um eine Achse"),
    ("bend", "Bend", "Biegen", "biegt den Quader um die Punkte längs einer Achse"),
    ("free-form", "Free form", "Freie Form", "verformt den Quader um die Punkte durch die Quadrate im Raum, die gezogen werden"),
    ("insert", "Insert a block", "Baustein einfügen", "fügt eine Bahn aus einer Datei hinter dem aktuellen Punkt ein"),
    ("extract", "Save points as a block", "Punkte als Baustein speichern", "schreibt Punkte als eigene Bahn"),
    ("blend", "Blend with a path", "Mit einer Bahn mischen", "mischt die Bahn mit einer anderen aus einer Datei"),
    ("reverse", "Reverse", "Umkehren", "kehrt die Bahn um"),
    ("repeat", "Go several times", "Mehrmals gehen", "wiederholt die Bahn"),
    ("frames", "Number of frames", "Zahl der Bilder", "gibt Punkten eine genaue Zahl von Bildern"),
    ("retime", "Pace within limits", "Tempo in Grenzen", "berechnet das Tempo von Punkten neu, in den Grenzen der Prüfung"),
    ("steady", "Steady", "Beruhigen", "stabilisiert einen aufgezeichneten Flug"),
    ("avoid", "Clear of the object", "Frei vom Objekt", "führt die Bahn vom Objekt weg"),
    ("picture", "Keep in the picture", "Im Bild halten", "hält das Objekt ganz im Bild, so groß, wie ein Rand es erlaubt"),
    ("tour", "Tour", "Rundflug", "macht einen Flug, der das Objekt zeigt"),
    ("fit", "Fit recorded poses", "Aufgezeichnete Posen annähern", "macht aus aufgezeichneten Posen eine Bahn aus wenigen Punkten"),
];

/// Labels, by the names of the parameters.
#[rustfmt::skip]
const LABELS: &[Word] = &[
    ("around", "Around", "Um"),
    ("at", "At", "Ort"),
    ("radius", "Radius", "Radius"),
    ("height", "Height", "Höhe"),
    ("from", "From", "Von"),
    ("to", "To", "Bis"),
    ("turns", "Turns", "Runden"),
    ("zoom", "Zoom", "Zoom"),
    ("seconds", "Duration", "Dauer"),
    ("period", "Period", "Periode"),
    ("within", "Within", "Höchstens"),
    ("end-radius", "Radius at the end", "Radius am Ende"),
    ("end-height", "Height at the end", "Höhe am Ende"),
    ("distance", "Distance", "Abstand"),
    ("end-distance", "Distance at the end", "Abstand am Ende"),
    ("length", "Length", "Länge"),
    ("rise", "Rise", "Anstieg"),
    ("tilt", "Tilt", "Neigung"),
    ("width", "Width", "Breite"),
    ("put", "Where", "Wohin"),
    ("by", "By", "Um"),
    ("axis", "Axis", "Achse"),
    ("angle", "Angle", "Winkel"),
    ("about", "About", "Um"),
    ("factor", "Factor", "Faktor"),
    ("r0", "At one end", "An einem Ende"),
    ("r1", "At the other", "Am anderen"),
    ("a", "In the middle", "In der Mitte"),
    ("fit", "Place", "Platz"),
    ("with-targets", "Targets too", "Ziele auch"),
    ("first", "From point", "Von Punkt"),
    ("last", "To point", "Bis Punkt"),
    ("times", "How often", "Wie oft"),
    ("frames", "Frames", "Bilder"),
    ("tolerance", "Tolerance", "Toleranz"),
    ("clearance", "Clearance", "Abstand"),
    ("lattice", "Square", "Quadrat"),
    ("weight", "Weight", "Gewicht"),
    ("margin", "Margin", "Rand"),
    ("what", "By", "Durch"),
    ("coverage", "Coverage", "Anteil"),
    ("inside", "Inside", "Innen"),
    ("robust", "Robust", "Robust"),
    ("points", "Points", "Punkte"),
];

/// What the parameters do, in German.
#[rustfmt::skip]
const HINTS: &[(&str, &str)] = &[
    ("the place in the middle of the view", "der Ort in der Mitte des Bildes"),
    ("how far the way is from the axis", "wie weit der Weg von der Achse entfernt ist"),
    ("how far above the target the camera is", "wie weit die Kamera über dem Ziel ist"),
    ("heading at which the camera begins", "Richtung, in der die Kamera beginnt, vom Ziel aus"),
    ("heading at which it ends", "Richtung, in der sie endet"),
    ("how often round; negative: clockwise from above", "wie oft herum; negativ: von oben gesehen im Uhrzeigersinn"),
    ("focal length", "Brennweite"),
    ("focal length at the beginning", "Brennweite am Anfang"),
    ("how long; 0: as short as the limits allow", "wie lange; 0: so kurz, wie die Grenzen erlauben"),
    ("how long it takes; 0: by its length", "wie lange es dauert; 0: nach der Länge"),
    ("the radius at the end", "der Radius am Ende"),
    ("the height at the end", "die Höhe am Ende"),
    ("how near the way comes, seen from above", "wie nahe der Weg kommt, von oben gesehen"),
    ("heading of the camera when it is nearest", "Richtung der Kamera, wo sie am nächsten ist"),
    ("how long the way is", "wie lang der Weg ist"),
    ("how far from the target it begins", "wie weit vom Ziel es beginnt"),
    ("how far from the target it ends", "wie weit vom Ziel es endet"),
    ("how steeply the camera is above the target", "wie steil die Kamera über dem Ziel ist"),
    ("how far above the target it begins", "wie weit über dem Ziel es beginnt"),
    ("how far above the target it ends", "wie weit über dem Ziel es endet"),
    ("where the camera stands", "wo die Kamera steht"),
    ("heading of the first view", "Richtung des ersten Blicks"),
    ("heading of the last view", "Richtung des letzten Blicks"),
    ("how far it looks up", "wie weit sie nach oben blickt"),
    ("how far from the axis it crosses itself", "wie weit von der Achse sie sich kreuzt"),
    ("how wide it is, twice as wide as deep", "wie breit sie ist, doppelt so breit wie tief"),
    ("in place of the film, after the current point, or after the last one",
        "an Stelle des Films, hinter dem aktuellen Punkt oder hinter dem letzten"),
    ("by how much", "um wie viel"),
    ("the axis", "die Achse"),
    ("by which angle", "um welchen Winkel"),
    ("the fixed point", "der feste Punkt"),
    ("by which factor", "um welchen Faktor"),
    ("how wide it is at one end", "wie breit es an einem Ende ist"),
    ("how wide it is at the other", "wie breit es am anderen ist"),
    ("how wide it is in the middle", "wie breit es in der Mitte ist"),
    ("how it is placed there", "wie er dorthin kommt"),
    ("what the cameras see moves with it", "was die Kameras sehen, geht mit"),
    ("the first of the points", "der erste der Punkte"),
    ("the last of the points", "der letzte der Punkte"),
    ("how often", "wie oft"),
    ("how many, including the first and the last", "wie viele, einschließlich des ersten und letzten"),
    ("how far a position may be from what was given", "wie weit eine Position vom Gegebenen entfernt sein darf"),
    ("cut-off period: motion of this period is halved, faster motion is removed",
        "Grenzperiode: Bewegung dieser Periode wird halbiert, schnellere entfernt"),
    ("maximum distance any position may move; 0: no limit", "weiteste Verschiebung eines Ortes; 0: keine Grenze"),
    ("least distance from the object", "kleinster Abstand vom Objekt"),
    ("radius of a sphere around the camera that keeps the clearance", "Radius einer Kugel um die Kamera, die den Abstand hält"),
    ("one of 4 × 4 × 4 squares, and where it is in the box", "eines von 4 × 4 × 4 Quadraten, und wo es im Quader ist"),
    ("the share to keep free at each side", "der freie Anteil auf jeder Seite"),
    ("what keeps it there", "wodurch es dort gehalten wird"),
    ("how long the flight takes", "wie lange der Flug dauert"),
    ("the share of the visible surface to show",
        "der Anteil der sichtbaren Oberfläche, der gezeigt wird"),
    ("distance of the camera from what it shows; 0: automatic",
        "Abstand der Kamera von dem, was sie zeigt; 0: automatisch"),
    ("ignores outliers: poses that differ from their neighbours", "lässt Ausreißer aus: Posen, die von ihren Nachbarn abweichen"),
    ("in the object's free space, not around it", "im freien Raum des Objekts, nicht um es herum"),
    ("how much of the other path", "wie viel von der anderen Bahn"),
    ("how far view, up and field of view may be from theirs",
        "wie weit Blick, oben und Bildwinkel von ihren abweichen dürfen"),
    ("maximum number of points; the tolerance follows from it; 0: as many as the tolerance needs",
        "höchste Zahl der Punkte; die Toleranz folgt daraus; 0: so viele, wie die Toleranz braucht"),
];

/// The names of choices.
#[rustfmt::skip]
const CHOICES: &[Word] = &[
    ("x", "x", "x"),
    ("y", "y", "y"),
    ("z", "z", "z"),
    ("middle", "their middle", "ihre Mitte"),
    ("origin", "the origin", "den Ursprung"),
    ("point", "this point", "diesen Punkt"),
    ("target", "its target", "sein Ziel"),
    ("replace", "Replace the film", "Film ersetzen"),
    ("insert", "Insert here", "Hier einfügen"),
    ("append", "Add after the end", "Am Ende anhängen"),
    ("none", "where it lies", "an Ort und Stelle"),
    ("move", "moved here", "hierher verschoben"),
    ("turn", "turned too", "auch gedreht"),
    ("scale", "scaled too", "auch skaliert"),
    ("zoom", "the zoom", "den Zoom"),
    ("distance", "the distance", "den Abstand"),
    ("view", "turning", "Drehen"),
];

fn word(words: &'static [Word], language: Language, name: &'static str) -> &'static str {
    let found = words.iter().find(|word| word.0 == name);
    found.map_or(name, |&(_, english, german)| match language {
        Language::English => english,
        Language::German => german,
    })
}

impl Language {
    pub(crate) fn tool(self, name: &'static str) -> &'static str {
        let found = TOOLS.iter().find(|known| known.0 == name);
        found.map_or(name, |known| match self {
            Self::English => known.1,
            Self::German => known.2,
        })
    }

    /// What a tool does.
    pub(crate) fn tool_hint(self, tool: &Tool) -> &'static str {
        match self {
            Self::English => tool.does,
            Self::German => {
                let found = TOOLS.iter().find(|known| known.0 == tool.name);
                found.map_or(tool.does, |known| known.3)
            }
        }
    }

    pub(crate) fn parameter(self, name: &'static str) -> &'static str {
        word(LABELS, self, name)
    }

    pub(crate) fn parameter_hint(self, parameter: &Parameter) -> &'static str {
        let found = HINTS.iter().find(|hint| hint.0 == parameter.does);
        match (self, found) {
            (Self::German, Some(&(_, german))) => german,
            _ => parameter.does,
        }
    }

    pub(crate) fn choice(self, name: &'static str) -> &'static str {
        word(CHOICES, self, name)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use vides_document::tool::tools;
    use vides_engine::tools::Unit;

    #[test]
    fn each_word_of_the_tables_stands_in_both_languages() {
        for tool in tools() {
            assert!(TOOLS.iter().any(|known| known.0 == tool.name), "{tool:?}");
            for parameter in tool.parameters() {
                let (name, does) = (parameter.name, parameter.does);
                assert!(LABELS.iter().any(|known| known.0 == name), "{name}");
                assert!(HINTS.iter().any(|known| known.0 == does), "{does}");
                if let Unit::Choice(names) = parameter.unit {
                    for name in names {
                        assert!(CHOICES.iter().any(|known| known.0 == *name), "{name}");
                    }
                }
            }
        }
        assert_eq!(TOOLS.len(), tools().count());
    }
}
