//! What the library says of files, paths and a host's arguments.
//!
//! The library speaks English. Its sentences are found here by themselves, with
//! the places for their values, and each has its translation beside it. A test
//! reads the source: no sentence of a [`message!`](crate::error::message) is
//! missing here, and none stands here that nobody says.

use super::Language;
use super::errors::Errors;
use super::reasons_scene::SENTENCES as OF_SCENES;
use crate::error::{Kind, Message, Part, fill};

/// English, German.
type Pair = (&'static str, &'static str);

const SENTENCES: &[Pair] = &[
    ("{0}: {1}", "{0}: {1}"),
    ("{0}; {1}", "{0}; {1}"),
    ("line {0}: {1}", "Zeile {0}: {1}"),
    ("point {0}", "Punkt {0}"),
    ("orientation {0}", "Orientierung {0}"),
    ("object point {0}", "Objektpunkt {0}"),
    ("the name", "der Name"),
    ("the title", "der Titel"),
    ("the unit", "die Einheit"),
    ("out of memory", "der Speicher reicht nicht"),
    // Files.
    ("this is not UTF-8 text", "das ist kein Text in UTF-8"),
    (
        "the file is larger than the {0} MiB that are read",
        "die Datei ist größer als die {0} MiB, die gelesen werden",
    ),
    (
        "what begins here could take more than {0} MiB of memory to be read",
        "was hier beginnt, könnte beim Lesen mehr als {0} MiB Speicher brauchen",
    ),
    (
        "unknown key \"{0}\"; known here: {1}",
        "unbekannter Schlüssel „{0}“; bekannt sind hier: {1}",
    ),
    (
        "this was given further up already",
        "das steht weiter oben schon",
    ),
    (
        "a .vid file begins with version = 1",
        "eine .vid-Datei beginnt mit version = 1",
    ),
    ("there is no such version", "diese Version gibt es nicht"),
    (
        "this file is of version {0}, newer than this program, which knows up to version {1}",
        "diese Datei hat die Version {0}; dieses Programm ist älter und kennt bis Version {1}",
    ),
    (
        "this is version {0} of the setup; version {1} is understood here",
        "das ist Version {0} des Setups; hier wird Version {1} verstanden",
    ),
    ("expected {0}, found {1}", "{0} erwartet, gefunden: {1}"),
    (
        "expected {0} numbers, found {1}",
        "{0} Zahlen erwartet, gefunden: {1}",
    ),
    ("a number", "eine Zahl"),
    ("a whole number", "eine ganze Zahl"),
    ("a decimal number", "eine Dezimalzahl"),
    ("a text", "ein Text"),
    ("a text in quotes", "ein Text in Anführungszeichen"),
    ("true or false", "true oder false"),
    ("a date or time", "ein Datum oder eine Zeit"),
    ("an array", "eine Liste"),
    ("a table", "eine Tabelle"),
    ("the number must be finite", "die Zahl muss endlich sein"),
    ("the number is too large", "die Zahl ist zu groß"),
    (
        "must lie between {0} and {1}",
        "muss zwischen {0} und {1} liegen",
    ),
    (
        "must be \"tcb\", \"barry-goldman\" or \"slerp\"",
        "muss \"tcb\", \"barry-goldman\" oder \"slerp\" sein",
    ),
    (
        "must be \"smooth\" or \"linear\"",
        "muss \"smooth\" oder \"linear\" sein",
    ),
    (
        "must be \"system\", \"dark\" or \"light\"",
        "muss \"system\", \"dark\" oder \"light\" sein",
    ),
    (
        "must be \"system\", \"en\" or \"de\"",
        "muss \"system\", \"en\" oder \"de\" sein",
    ),
    (
        "out of range: the tilt lies in [-90, 90], the size in [{0}, {1}], the shift in [-4, 4]",
        "außerhalb: die Neigung liegt in [−90; 90], die Größe in [{0}; {1}], die Verschiebung in [−4; 4]",
    ),
    (
        "a colour is written as \"#\" and six digits 0 to 9, a to f",
        "eine Farbe schreibt man als \"#\" und sechs Ziffern 0 bis 9, a bis f",
    ),
    (
        "the presets are numbered 0 to 9",
        "die Standardwerte haben die Nummern 0 bis 9",
    ),
    (
        "a path needs at least two points, each with its [[point]], found {0}",
        "eine Bahn braucht mindestens zwei Punkte, jeder mit seinem [[point]]; gefunden: {0}",
    ),
    (
        "this point has no position",
        "dieser Punkt hat keine position",
    ),
    (
        "a point has either a preset or its own values",
        "ein Punkt hat entweder preset oder own",
    ),
    (
        "an orientation has either a target or an offset",
        "eine Orientierung hat entweder target oder offset",
    ),
    // What a path may be.
    (
        "a path has at most {0} points",
        "eine Bahn hat höchstens {0} Punkte",
    ),
    (
        "a path has at most {0} support points",
        "eine Bahn hat höchstens {0} Stützpunkte",
    ),
    (
        "a path needs at least two support points",
        "eine Bahn braucht mindestens zwei Stützpunkte",
    ),
    (
        "the last two points of a path cannot be removed",
        "die letzten zwei Punkte einer Bahn lassen sich nicht löschen",
    ),
    (
        "there is no point {0}: the path has points 0 to {1}",
        "den Punkt {0} gibt es nicht: die Bahn hat die Punkte 0 bis {1}",
    ),
    (
        "a new point must be put at 0 to {0}, not at {1}",
        "ein neuer Punkt kommt an eine Stelle von 0 bis {0}, nicht {1}",
    ),
    (
        "there is no segment {0}: the path has segments 0 to {1}",
        "den Abschnitt {0} gibt es nicht: die Bahn hat die Abschnitte 0 bis {1}",
    ),
    (
        "no segment begins in the last point of an open path",
        "am letzten Punkt einer offenen Bahn beginnt kein Abschnitt",
    ),
    (
        "a segment is divided by 1 to 10 points",
        "ein Abschnitt wird durch 1 bis 10 Punkte geteilt",
    ),
    (
        "a closed path has no ends",
        "eine geschlossene Bahn hat keine Enden",
    ),
    (
        "the first segment has no length and so no direction to go on in",
        "der erste Abschnitt hat keine Länge und damit keine Richtung, in der es weiterginge",
    ),
    (
        "the last segment has no length and so no direction to go on in",
        "der letzte Abschnitt hat keine Länge und damit keine Richtung, in der es weiterginge",
    ),
    (
        "there is no room in the movement space beyond the first point",
        "jenseits des ersten Punktes ist im Bewegungsraum kein Platz",
    ),
    (
        "there is no room in the movement space beyond the last point",
        "jenseits des letzten Punktes ist im Bewegungsraum kein Platz",
    ),
    (
        "a point has at most 10 orientations",
        "ein Punkt hat höchstens 10 Orientierungen",
    ),
    (
        "a point has between 1 and 10 orientations",
        "ein Punkt hat 1 bis 10 Orientierungen",
    ),
    (
        "the points of a path have at most {0} orientations together",
        "die Punkte einer Bahn haben zusammen höchstens {0} Orientierungen",
    ),
    (
        "there is no orientation {0}: point {1} has orientations 0 to {2}",
        "die Orientierung {0} gibt es nicht: Punkt {1} hat die Orientierungen 0 bis {2}",
    ),
    (
        "a new orientation must be put at 0 to {0}, not at {1}",
        "eine neue Orientierung kommt an eine Stelle von 0 bis {0}, nicht {1}",
    ),
    (
        "the last orientation of a point cannot be removed",
        "die letzte Orientierung eines Punktes lässt sich nicht löschen",
    ),
    (
        "point {0} must not lie on the target of its orientation {1}",
        "Punkt {0} darf nicht auf dem Ziel seiner Orientierung {1} liegen",
    ),
    (
        "the target must not lie on the camera's own position",
        "das Ziel darf nicht auf der Kameraposition liegen",
    ),
    (
        "a target in this direction would lie further out than 1e9 half sizes",
        "ein Ziel in dieser Richtung läge weiter draußen als 1e9 halbe Größen",
    ),
    (
        "a coordinate must be a finite number",
        "eine Koordinate muss eine endliche Zahl sein",
    ),
    (
        "a coordinate must not exceed 1e9",
        "eine Koordinate darf höchstens 1e9 sein",
    ),
    (
        "the roll must be a finite number",
        "der Winkel muss eine endliche Zahl sein",
    ),
    (
        "the zoom must lie between 1 and 100",
        "der Zoom muss zwischen 1 und 100 liegen",
    ),
    (
        "the {0} must lie between -1 and 1",
        "{0} muss zwischen −1 und 1 liegen",
    ),
    (
        "the preset must lie between 0 and 9",
        "der Standardwert muss zwischen 0 und 9 liegen",
    ),
    (
        "each value of a speed curve must lie between 1 and 100",
        "jeder Wert einer Zeitkurve muss zwischen 1 und 100 liegen",
    ),
    (
        "a part must begin and end between 0 and 1, its end after its start",
        "ein Teil muss zwischen 0 und 1 beginnen und enden, und zwar nach seinem Anfang",
    ),
    (
        "a given distance has between 2 and {0} keys",
        "ein vorgegebener Weg hat 2 bis {0} Schlüssel",
    ),
    (
        "the keys of a given distance must be finite numbers",
        "die Schlüssel eines vorgegebenen Wegs müssen endliche Zahlen sein",
    ),
    (
        "the keys of a given distance must lead from 0, 0 to 1, 1, with both numbers increasing",
        "die Schlüssel eines vorgegebenen Wegs müssen von 0, 0 nach 1, 1 führen, und beide Zahlen müssen steigen",
    ),
    (
        "the control quaternions of a turning must have length 1",
        "die Kontrollquaternionen einer Drehung müssen die Länge 1 haben",
    ),
    (
        "a section has at most {0} frames",
        "ein Bewegungsabschnitt hat höchstens {0} Bilder",
    ),
    (
        "the distance ahead must be a finite number",
        "der Abstand voraus muss eine endliche Zahl sein",
    ),
    (
        "the distance ahead must lie between 0 and 1e9 half sizes of the space",
        "der Abstand voraus muss zwischen 0 und 1e9 halben Größen des Raums liegen",
    ),
    (
        "a velocity or slope must be a finite number",
        "eine Geschwindigkeit oder Steigung muss eine endliche Zahl sein",
    ),
    (
        "a velocity or slope must not exceed {0}",
        "eine Geschwindigkeit oder Steigung darf höchstens {0} sein",
    ),
    (
        "the shares of time for speeding up and slowing down must not be negative, and together not exceed 1",
        "die Zeitanteile für Anfahren und Bremsen dürfen nicht negativ sein und zusammen höchstens 1",
    ),
    ("the tangents", "die Tangenten"),
    (
        "in the orientation mode barry-goldman a new key would change the views around it",
        "in der Orientierungsart barry-goldman würde ein neuer Schlüssel die Ansichten ringsum ändern",
    ),
    (
        "a frame must lie between 1 and {0}",
        "ein Bild muss zwischen 1 und {0} liegen",
    ),
    (
        "at frame {0} the camera is at a key already",
        "bei Bild {0} ist die Kamera schon an einem Schlüssel",
    ),
    (
        "at frame {0} the camera turns at point {1}, there is no way to divide",
        "bei Bild {0} dreht sich die Kamera an Punkt {1}, dort gibt es keinen Weg zu teilen",
    ),
    (
        "the place is too near to a point of the path",
        "die Stelle liegt zu nah an einem Punkt des Pfads",
    ),
    (
        "the first point of a range must not lie behind its last one",
        "der erste Punkt eines Bereichs darf nicht hinter dem letzten liegen",
    ),
    (
        "{0} frames are too few: it must have at least {1}",
        "{0} Bilder sind zu wenige: es müssen mindestens {1} sein",
    ),
    (
        "{0} frames are too many: it can have at most {1}",
        "{0} Bilder sind zu viele: es können höchstens {1} sein",
    ),
    (
        "must be \"tcb\", \"cubic\" or \"linear\"",
        "muss \"tcb\", \"cubic\" oder \"linear\" sein",
    ),
    (
        "an orientation has either an ease, a distance or a part of a pace",
        "eine Orientierung hat entweder ease, distance oder pace_part",
    ),
    (
        "both {0} and {1} must be given",
        "{0} und {1} müssen beide angegeben sein",
    ),
    (
        "expected {0} quaternions, found {1}",
        "erwartet wurden {0} Quaternionen, gefunden {1}",
    ),
    (
        "must be \"sine\" or \"parabolic\"",
        "muss \"sine\" oder \"parabolic\" sein",
    ),
    (
        "a part is one of one whole",
        "ein Teil gehört zu einem Ganzen",
    ),
    (
        "a part needs its whole: speed_curve, ease or distance",
        "ein Teil braucht sein Ganzes: speed_curve, ease oder distance",
    ),
    (
        "only ten speeds have others that face them",
        "nur zehn Geschwindigkeiten haben Nachbarn",
    ),
    (
        "the hold must lie between 0 and 1000000 frames",
        "das Halten muss zwischen 0 und 1000000 Bildern liegen",
    ),
    (
        "a base speed must be finite and greater than zero",
        "eine Grundgeschwindigkeit muss endlich und größer als null sein",
    ),
    (
        "the path would yield more than 100000000 frames; lower the base speeds",
        "die Bahn ergäbe mehr als 100000000 Bilder; die Grundgeschwindigkeiten sind zu hoch",
    ),
    (
        "a frame must lie between 1 and the number of frames",
        "ein Bild muss zwischen 1 und der Zahl der Bilder liegen",
    ),
    // The space.
    (
        "the half size of the space must lie between 1e-30 and 1e30",
        "die halbe Größe des Raums muss zwischen 1e-30 und 1e30 liegen",
    ),
    (
        "the centre of the space must be finite",
        "der Mittelpunkt des Raums muss endlich sein",
    ),
    (
        "the centre of the space must lie within 1e9 half sizes of the world's origin",
        "der Mittelpunkt des Raums darf höchstens 1e9 halbe Größen vom Ursprung der Welt entfernt sein",
    ),
    (
        "a coordinate must lie within 1e9 half sizes of the space's centre",
        "eine Koordinate darf höchstens 1e9 halbe Größen vom Mittelpunkt des Raums entfernt sein",
    ),
    (
        "a single place has no size that a space could have",
        "ein einzelner Ort hat keine Größe, die ein Raum haben könnte",
    ),
    (
        "a space is given by centre and half_size, and all numbers are the world's",
        "ein Raum wird durch centre und half_size angegeben, und alle Zahlen sind die der Welt",
    ),
    (
        "this must stand before the first point or node",
        "das muss vor dem ersten Punkt oder Knoten stehen",
    ),
    ("must be \"y\" or \"z\"", "muss \"y\" oder \"z\" sein"),
    (
        "the frames per second must be greater than 0 and at most 100000",
        "die Bilder pro Sekunde müssen größer als 0 und höchstens 100000 sein",
    ),
    (
        "the comment has at most {0} bytes",
        "der Kommentar hat höchstens {0} Byte",
    ),
    (
        "at most {0} bytes are allowed",
        "höchstens {0} Byte sind erlaubt",
    ),
    (
        "control characters are not allowed",
        "Steuerzeichen sind nicht erlaubt",
    ),
    (
        "the wireframe of an object has at most {0} points",
        "ein Drahtmodell hat höchstens {0} Punkte",
    ),
    (
        "an object has at most {0} points",
        "ein Objekt hat höchstens {0} Punkte",
    ),
    // What a host gives.
    (
        "point {0} of the object has the number {1}; the order of the array counts",
        "Punkt {0} des Objekts hat die Nummer {1}; es gilt die Reihenfolge im Feld",
    ),
    (
        "{0} is {1} and must be finite and greater than 0: {2} is taken",
        "{0} ist {1} und muss endlich und größer als 0 sein: genommen wird {2}",
    ),
    (
        "the object is not shown: {0}",
        "das Objekt wird nicht gezeigt: {0}",
    ),
    (
        "a list cannot number so many poses",
        "so viele Posen kann eine Liste nicht zählen",
    ),
];

/// What the TOML parser says, before it goes on to what it expected. There is no
/// list of it to be held against: what is missing here, or new, is
/// [`Errors::not_here`].
const PARSER: &[Pair] = &[
    (
        "duplicate key",
        "derselbe Schlüssel steht zweimal in einer Tabelle",
    ),
    (
        "string values must be quoted",
        "ein Text muss in Anführungszeichen stehen",
    ),
    ("key with no value", "einem Schlüssel fehlt sein Wert"),
    ("missing value for key", "einem Schlüssel fehlt sein Wert"),
    ("missing value", "hier fehlt ein Wert"),
    ("invalid value", "das ist kein Wert"),
    (
        "missing assignment between key-value pairs",
        "hier fehlt ein Gleichheitszeichen",
    ),
    (
        "extra assignment between key-value pairs",
        "hier ist ein Gleichheitszeichen zu viel",
    ),
    ("extra `=`", "hier ist ein Gleichheitszeichen zu viel"),
    (
        "unexpected `=` in array",
        "in einer Liste steht kein Gleichheitszeichen",
    ),
    (
        "missing comma between array elements",
        "zwischen den Werten einer Liste fehlt ein Komma",
    ),
    (
        "missing comma between key-value pairs",
        "zwischen zwei Einträgen fehlt ein Komma",
    ),
    ("extra comma in array", "hier ist ein Komma zu viel"),
    ("extra comma in inline table", "hier ist ein Komma zu viel"),
    (
        "missing opening quote",
        "hier fehlt ein Anführungszeichen am Anfang",
    ),
    (
        "invalid basic string",
        "der Text endet nicht in seiner Zeile",
    ),
    (
        "invalid multi-line basic string",
        "der Text über mehrere Zeilen endet nicht",
    ),
    ("unclosed array", "die Liste endet nicht"),
    ("unclosed array table", "die Überschrift [[…]] endet nicht"),
    ("unclosed table", "die Überschrift […] endet nicht"),
    ("unclosed inline table", "die Tabelle {…} endet nicht"),
    ("missing array opening", "hier fehlt eine öffnende Klammer"),
    (
        "missing inline table opening",
        "hier fehlt eine öffnende Klammer",
    ),
    ("missing table open", "hier fehlt eine öffnende Klammer"),
    ("missing escaped value", "nach \\ fehlt, wofür es steht"),
    (
        "invalid comment character",
        "ein Kommentar enthält ein Steuerzeichen",
    ),
    ("unexpected leading zero", "die Zahl beginnt mit einer Null"),
    (
        "redundant integer number prefix",
        "die Zahl beginnt mit einer Null",
    ),
    ("redundant numeric sign", "die Zahl hat zwei Vorzeichen"),
    ("unexpected sign", "hier steht ein Vorzeichen zu viel"),
    ("integer number overflowed", "die Zahl ist zu groß"),
    ("floating-point number overflowed", "die Zahl ist zu groß"),
    (
        "cannot recurse further; max recursion depth met",
        "zu viele Klammern stehen ineinander",
    ),
    (
        "carriage return must be followed by newline",
        "hier steht ein Wagenrücklauf ohne Zeilenende",
    ),
];

impl Language {
    /// What the library says, in this language.
    pub(crate) fn reason(self, message: &Message) -> String {
        match self {
            Self::English => message.to_string(),
            Self::German => german(message),
        }
    }
}

fn german(message: &Message) -> String {
    let mut said = String::new();
    let sentence = translated(message.sentence()).unwrap_or(Errors::GERMAN.not_here);
    // Writing into a text cannot fail.
    let _ = fill(&mut said, sentence, |said, at| {
        if let Some(part) = message.values().get(at) {
            said.push_str(&value(part));
        }
        Ok(())
    });
    said
}

fn value(part: &Part) -> String {
    match &part.0 {
        Kind::Message(message) => german(message),
        Kind::Number(number) => number.to_string().replace('.', ","),
        _ => part.to_string(),
    }
}

fn translated(sentence: &str) -> Option<&'static str> {
    let find = |pairs: &[Pair], wanted: &str| {
        let found = pairs.iter().find(|(english, _)| *english == wanted);
        found.map(|(_, german)| *german)
    };
    let parser = || {
        let said = sentence.split(", expected ").next().unwrap_or(sentence);
        find(PARSER, said)
    };
    find(SENTENCES, sentence)
        .or_else(|| find(OF_SCENES, sentence))
        .or_else(parser)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::Document;
    use crate::error::message;
    use crate::texts::tests::placeholders;
    use std::collections::BTreeSet;
    use std::path::Path;

    /// The sentences of all `message!` in a file and what lies in a folder.
    fn said(at: &Path, found: &mut BTreeSet<String>) {
        if at.is_dir() {
            for entry in std::fs::read_dir(at).unwrap() {
                said(&entry.unwrap().path(), found);
            }
        } else {
            let source = std::fs::read_to_string(at).unwrap();
            let source = source.split("\nmod tests {").next().unwrap();
            for behind in source.split("message!(").skip(1) {
                if let Some(text) = behind.trim_start().strip_prefix('"') {
                    let end = text.replace("\\\"", "''").find('"').unwrap();
                    found.insert(text[..end].replace("\\\"", "\""));
                }
            }
        }
    }

    #[test]
    fn every_sentence_of_the_library_stands_here_and_no_other() {
        let mut found = BTreeSet::new();
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
        for folder in ["src", "crates"] {
            said(&root.join(folder), &mut found);
        }
        let all = || SENTENCES.iter().chain(OF_SCENES);
        let here: BTreeSet<String> = all().map(|(e, _)| (*e).to_owned()).collect();
        assert_eq!(here.len(), all().count(), "one stands here twice");
        let missing: Vec<_> = found.difference(&here).collect();
        assert!(missing.is_empty(), "not translated: {missing:#?}");
        let unsaid: Vec<_> = here.difference(&found).collect();
        assert!(unsaid.is_empty(), "said by nobody: {unsaid:#?}");
        for (english, german) in all() {
            assert_eq!(placeholders(english), placeholders(german), "{english}");
        }
    }

    #[test]
    fn a_sentence_is_translated_with_all_that_is_in_it() {
        let inner = message!(
            "expected {0}, found {1}",
            message!("a number"),
            message!("a text")
        );
        let message = message!(
            "line {0}: {1}",
            3_usize,
            message!("{0}: {1}", "zoom_mm", inner)
        );
        let english = "line 3: zoom_mm: expected a number, found a text";
        assert_eq!(Language::English.reason(&message), english);
        let german = "Zeile 3: zoom_mm: eine Zahl erwartet, gefunden: ein Text";
        assert_eq!(Language::German.reason(&message), german);
        let value = message!(
            "{0} is {1} and must be finite and greater than 0: {2} is taken",
            "x",
            -0.5,
            100.0
        );
        assert!(
            Language::German
                .reason(&value)
                .starts_with("x ist -0,5 und")
        );
        // What nobody can translate is not shown in another language.
        let foreign = message!("line {0}: {1}", 2_usize, Message::from("odd".to_owned()));
        let german = format!("Zeile 2: {}", Errors::GERMAN.not_here);
        assert_eq!(Language::German.reason(&foreign), german);
        let parser = Message::from("unclosed array, expected `]`".to_owned());
        assert_eq!(Language::German.reason(&parser), "die Liste endet nicht");
    }

    /// The broken files that are kept for the reader: what is wrong with each can
    /// be said in German.
    #[test]
    fn what_is_wrong_with_a_file_is_said_in_german() {
        let corpus = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/corpus");
        let mut count = 0;
        for entry in std::fs::read_dir(corpus).unwrap() {
            let file = entry.unwrap().path();
            if !file.is_file() {
                continue;
            }
            let Err(error) = Document::load(&file) else {
                continue;
            };
            let message = error.into_message();
            let said = Language::German.reason(&message);
            assert_ne!(said, Language::English.reason(&message));
            assert!(
                !said.contains(Errors::GERMAN.not_here),
                "{}: {said}",
                file.display()
            );
            count += 1;
        }
        assert!(count > 20, "{count}");
    }
}
