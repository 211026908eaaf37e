//! What documents and their files say, in German; see [`super::german`].

use vides_document::error::{End, Error, Index, Malformed, Refused, Value, one_of};
use vides_document::mesh::{Error as MeshError, Problem};
use vides_engine::limits;

use super::Language;
use super::errors::Errors;
use super::german::{German, german, number};
use crate::host::warning::{Warning, Warnings};
use crate::texts::refusals::of_system;

german! {
    Error {
        Engine(error) => "{}", German(error);
        Refused(refused) => "{}", German(refused);
        Io { place, source } => "{place}: {}", of_system(Language::German, source);
        Format { line, key, cause } => "Zeile {line}: {key}{}", German(cause);
        Property { name, cause } => "{name}: {}", German(cause);
        FileTooLarge(most) => "die Datei ist größer als die {most} MiB, die gelesen werden";
        PieceTooLarge(line) =>
            "Zeile {line}: was hier beginnt, könnte beim Lesen mehr als {} MiB Speicher brauchen",
            limits::MAX_PARSE_BYTES >> 20;
        Mesh(error) => "{}", German(error);
        At(place, cause) => "{}: {}", German(place), German::<Error>(cause);
        In(file, cause) => "{file}: {}", German::<Error>(cause);
    }
    Refused {
        NewPoint { at, last } =>
            "ein neuer Punkt kommt an eine Stelle von 1 bis {}, nicht {}", Index(*last), Index(*at);
        TwoPointsRemain => "die letzten zwei Punkte einer Bahn lassen sich nicht löschen";
        NoSegmentAtEnd => "am letzten Punkt einer offenen Bahn beginnt kein Abschnitt";
        NoSegment { segment, last } =>
            "den Abschnitt {} gibt es nicht: die Bahn hat die Abschnitte 1 bis {}",
            Index(*segment), Index(*last);
        Division => "ein Abschnitt wird durch 1 bis 10 Punkte geteilt";
        NoEnds => "eine geschlossene Bahn hat keine Enden";
        NoDirection(end) =>
            "der {} Abschnitt hat keine Länge und damit keine Richtung, in der es weiterginge", German(end);
        NoRoom(end) => "jenseits des {}n Punktes ist im Bewegungsraum kein Platz", German(end);
        NoOrientation { orientation, point, last } =>
            "den Blick {} gibt es nicht: Punkt {} hat die Blicke 1 bis {}",
            Index(*orientation), Index(*point), Index(*last);
        NewOrientation { at, last } =>
            "ein neuer Blick kommt an eine Stelle von 1 bis {}, nicht {}",
            Index(*last), Index(*at);
        OneOrientationRemains => "der letzte Blick eines Punktes lässt sich nicht löschen";
        OnTarget { point, orientation } =>
            "Punkt {} darf nicht auf dem Ziel seines Blicks {} liegen",
            Index(*point), Index(*orientation);
        TargetTooFar => "ein Ziel in dieser Richtung läge weiter draußen als 1e9 halbe Größen";
        NoCamera => "diese Szene hat keine Kamera auf einem Pfad";
        NoPathEdited => "keine Bahn wird bearbeitet: bitte einen Knoten wählen, der einer folgt";
        NoPathOf(node) => "der Knoten „{node}“ folgt keiner Bahn";
        NoProperty { name, known } =>
            "die Eigenschaft „{name}“ gibt es nicht; hier bekannt: {known}";
        NotOfKind(name, kind) => "die Eigenschaft „{name}“ lässt sich so nicht setzen; sie ist: {kind}";
        NoScene => "es gibt keine Szene, nur eine Bahn";
        NoFile => "dieser Pfad hat noch keine Datei";
        Outside(name) =>
            "{name} liegt außerhalb des Ordners der Datei, die es nennt, und wurde nicht gelesen";
        Input(name) => "das würde {name} überschreiben, das gelesen wurde: bitte eine andere Datei nennen";
        FileChanged => "ein anderes Programm hat die Datei geändert, seit sie hier gelesen oder geschrieben wurde";
    }
    MeshError {
        Line { line, problem } => "Zeile {line}: {}", German(problem);
        File(problem) => "{}", German(problem);
        Ply(said) => "der PLY-Leser sagt: {said}";
        Extension(name) => "die Datei verlangt die Erweiterung {name}, die nicht gelesen wird";
        Memory => "der Speicher reicht nicht";
        Stopped => "das Lesen wurde abgebrochen";
        UnknownFormat => "die Namen von Dateien mit Netzen enden auf .obj, .ply, .stl, .gltf oder .glb";
        LeftOut => "dieses Programm ist ohne Netze dieses Formats gebaut";
        Changed => "das Netz hat sich geändert, seit die Szene gespeichert wurde";
        Mesh(error) => "{}", German(error);
    }
    Problem {
        Coordinates => "drei endliche Zahlen erwartet";
        Indices => "Nummern von Punkten erwartet, die in der Datei stehen";
        End => "die Datei endet zu früh";
        Expected(word) => "erwartet: „{word}“";
        Empty => "in dieser Datei sind keine Punkte";
        Buffer => "ein Puffer dieser Datei fehlt oder lässt sich nicht lesen";
        Long => "in dieser Datei ist mehr, als genommen wird";
        Draco => "ein mit Draco gepacktes Netz (KHR_draco_mesh_compression) wird nicht gelesen; ungepackt exportieren";
        Meshopt => "ein mit meshoptimizer gepacktes Netz (EXT_meshopt_compression) wird nicht gelesen; ungepackt exportieren";
        NoPart => "diese Datei hat keinen solchen Teil";
        Cycle => "ein Knoten dieser Datei liegt unter sich selbst oder an zwei Stellen; jeder darf an einer stehen";
        Format => "das ist keine Datei dieses Formats";
    }
    End {
        First => "erste";
        Last => "letzte";
    }
    Malformed {
        Toml(said) => "{}", parser(&said.to_string());
        Engine(error) => "{}", German(error);
        NotUtf8 => "das ist kein Text in UTF-8";
        NoVersion => "eine .vid-Datei beginnt mit version = 1";
        NoSuchVersion => "diese Version gibt es nicht";
        NewerVersion { version, known } =>
            "diese Datei hat die Version {version}; dieses Programm ist älter und kennt bis Version {known}";
        UnknownKey { key, known } => "unbekannter Schlüssel „{key}“; bekannt sind hier: {known}";
        Expected { wanted, found } => "{} erwartet, gefunden: {}", German(wanted), German(found);
        NumberCount { wanted, found } => "{wanted} Zahlen erwartet, gefunden: {found}";
        QuaternionCount { wanted, found } =>
            "erwartet wurden {wanted} Quaternionen, gefunden {found}";
        NotFinite => "die Zahl muss endlich sein";
        TooLarge => "die Zahl ist zu groß";
        Between { low, high } => "muss zwischen {low} und {high} liegen";
        OneOf(names) => "muss {} sein", one_of(names, "oder");
        Both(a, b) => "{a} und {b} müssen beide angegeben sein";
        Space =>
            "ein Raum wird durch centre und half_size angegeben, und alle Zahlen sind die der Welt";
        BehindPoints => "das muss vor dem ersten Punkt oder Knoten stehen";
        PresetNumber => "die Standardwerte haben die Nummern 0 bis 9";
        TooFewPoints(number) =>
            "eine Bahn braucht mindestens zwei Punkte, jeder mit seinem [[point]]; gefunden: {number}";
        NoPosition => "dieser Punkt hat keine position";
        PresetAndOwn => "ein Punkt hat entweder preset oder own";
        TargetAndOffset => "ein Blick hat entweder target oder offset";
        PaceTwice => "ein Blick hat entweder ease, distance oder pace_part";
        UpTwice => "ein Blick hat entweder up, up_point oder up_path";
        NoUpPath => "diese Bahn für oben steht nicht weiter oben in der Datei";
        PartTwice => "ein Teil gehört zu einem Ganzen";
        PartWithoutWhole => "ein Teil braucht sein Ganzes: speed_curve, ease, distance oder track";
        NoSlopes => "nur zehn Geschwindigkeiten haben Steigungen an ihren Enden";
        Scene(nodes) => "das ist eine Szene mit {nodes} Knoten, kein Pfad allein";
        KeyOfPath(key) => "in einer Szene gehört „{key}“ zum Pfad eines Knotens";
        Marker => "eine Marke hat einen Namen (name) und ein Bild (frame)";
        MarkerTwice(name) => "eine Marke „{name}“ gibt es schon";
        NoName => "dieser Knoten hat keinen Namen (name)";
        NoKind => "dieser Knoten hat keine Art (kind)";
        NotOfKind(kind) => "das hat ein Knoten der Art „{kind}“ nicht";
        RowsBefore => "hier stehen davor Zeilen von Zahlen";
        NumbersBefore => "hier stehen davor einzelne Zahlen";
        ValueCount { keys, values } =>
            "{keys} Schlüssel brauchen ebenso viele Werte, nicht {values}";
        NoDeformationKind => "diese Verformung hat keine Art (kind)";
        Checksum => "eine Prüfsumme hat bis zu 16 Ziffern 0 bis 9, a bis f";
        MeshFile => "ein Netz hat eigene Punkte, oder eine Datei: allein, oder mit Länge (bytes) und Prüfsumme (checksum), und mit der Nummer ihres Teils (part), wo sie Teile hat";
        PolylinesAndMesh => "ein Objekt hat entweder polylines oder ein eigenes Netz";
        Pin => "zum Anheften gehören ein Punkt (point) und eine Marke (marker)";
        Track => "eine Spur hat channel, interpolation, frames und values";
        SetupVersion { version, known } =>
            "das ist Version {version} des Setups; hier wird Version {known} verstanden";
        View { least, most } =>
            "außerhalb: die Neigung liegt in [−90; 90], die Größe in [{}; {}], die Verschiebung in [−4; 4]", number(*least), number(*most);
        Colour => "eine Farbe schreibt man als \"#\" und sechs Ziffern 0 bis 9, a bis f";
    }
    Value {
        Number => "eine Zahl";
        WholeNumber => "eine ganze Zahl";
        DecimalNumber => "eine Dezimalzahl";
        Text => "ein Text";
        TextInQuotes => "ein Text in Anführungszeichen";
        Boolean => "true oder false";
        DateOrTime => "ein Datum oder eine Zeit";
        Array => "eine Liste";
        Table => "eine Tabelle";
    }
}

german! {
    Warning {
        Misnumbered { place, number } =>
            "Punkt {place} des Objekts hat die Nummer {number}; es gilt die Reihenfolge im Feld";
        Speed { name, given, taken } =>
            "{name} ist {} und muss endlich und größer als 0 sein: genommen wird {}",
            number(*given), number(*taken);
        NotShown(error) => "das Objekt wird nicht gezeigt: {}", German(error);
        Mesh(error) => "{}", German::<Error>(error);
        NotRead(_said) => "das Objekt wird nicht gezeigt: {}", Errors::GERMAN.not_here;
    }
}

impl Language {
    pub(crate) fn warnings(self, warnings: &Warnings) -> String {
        match self {
            Self::English => warnings.to_string(),
            Self::German => {
                let each = warnings.iter().map(|warning| German(warning).to_string());
                each.collect::<Vec<_>>().join("; ")
            }
        }
    }
}

/// What the TOML parser says before it goes on to what it expected. There is no list to hold this
/// against: what is missing here, or new, becomes [`Errors::not_here`].
const PARSER: &[(&str, &str)] = &[
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

fn parser(said: &str) -> &'static str {
    let said = said.split(", expected ").next().unwrap_or_default();
    let found = PARSER.iter().find(|(english, _)| *english == said);
    found.map_or(Errors::GERMAN.not_here, |(_, german)| german)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;
    use vides_document::Document;

    #[test]
    fn an_error_is_translated_with_all_that_is_in_it() {
        for (text, english, german) in [
            (
                "version = \"1\"",
                "line 1: version: expected a whole number, found a text",
                "Zeile 1: version: eine ganze Zahl erwartet, gefunden: ein Text",
            ),
            (
                "version = 1\nfps = 0",
                "line 2: fps: the frames per second must be greater than 0 and at most 100000",
                "Zeile 2: fps: die Bilder pro Sekunde müssen größer als 0 und höchstens 100000 sein",
            ),
            (
                "version = 1\nfps = [",
                "line 2: unclosed array, expected `]`",
                "Zeile 2: die Liste endet nicht",
            ),
        ] {
            let error = Document::from_toml(text).expect_err("a broken file");
            assert_eq!(error.to_string(), english);
            assert_eq!(German(&error).to_string(), german);
        }
        // What nobody can translate is not shown in another language.
        let foreign = Malformed::Toml("odd".into());
        assert_eq!(German(&foreign).to_string(), Errors::GERMAN.not_here);
    }

    /// The broken files that are kept for the reader: what is wrong with each can
    /// be said in German.
    #[test]
    fn what_is_wrong_with_a_file_is_said_in_german() {
        let corpus = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/corpus");
        let mut count = 0;
        for entry in std::fs::read_dir(corpus).unwrap() {
            let file = entry.unwrap().path();
            let Some(error) = file
                .is_file()
                .then(|| Document::load(&file).err())
                .flatten()
            else {
                continue;
            };
            let said = German(&error).to_string();
            assert_ne!(said, error.to_string());
            assert!(!said.contains(Errors::GERMAN.not_here), "{said}");
            count += 1;
        }
        assert!(count > 20, "{count}");
    }
}
