//! What documents and their files say, in German; see [`super::german`].

use vides_document::error::{End, Error, Index, Malformed, Refused, Value, one_of};
use vides_document::mesh::{Error as MeshError, Problem};
use vides_engine::limits;

use super::Language;
use super::german::{German, german, number};
use crate::host::warning::{Warning, Warnings};
use crate::texts::refusals::of_system;

german! {
    DOCUMENT "document":
    Error {
        Engine(error) => German(error);
        Refused(refused) => German(refused);
        Io { place, source } => place, of_system(Language::German, source);
        Format { line, key, cause } => line, key, German(cause);
        Property { name, cause } => name, German(cause);
        FileTooLarge(most) => most;
        PieceTooLarge(line) => line, limits::MAX_PARSE_BYTES >> 20;
        Mesh(error) => German(error);
        At(place, cause) => German(place), German::<Error>(cause);
        In(file, cause) => file, German::<Error>(cause);
    }
    Refused {
        NewPoint { at, last } => Index(*last), Index(*at);
        TwoPointsRemain;
        NoSegmentAtEnd;
        NoSegment { segment, last } => Index(*segment), Index(*last);
        Division;
        NoEnds;
        NoDirection(end) => German(end);
        NoRoom(end) => German(end);
        NoOrientation { orientation, point, last } => Index(*orientation), Index(*point), Index(*last);
        NewOrientation { at, last } => Index(*last), Index(*at);
        OneOrientationRemains;
        OnTarget { point, orientation } => Index(*point), Index(*orientation);
        TargetTooFar;
        NoCamera;
        NoPathEdited;
        NoPathOf(node) => node;
        NoProperty { name, known } => name, known;
        NotOfKind(name, kind) => name, kind;
        NoScene;
        NoFile;
        Outside(name) => name;
        Input(name) => name;
        FileChanged;
    }
    MeshError {
        Line { line, problem } => line, German(problem);
        File(problem) => German(problem);
        Ply(said) => said;
        Extension(name) => name;
        Memory;
        Stopped;
        UnknownFormat;
        LeftOut;
        Changed;
        Mesh(error) => German(error);
    }
    Problem {
        Coordinates;
        Indices;
        End;
        Expected(word) => word;
        Empty;
        Buffer;
        Long;
        Draco;
        Meshopt;
        NoPart;
        Cycle;
        Format;
    }
    End {
        First;
        Last;
    }
    Malformed {
        Toml(said) => parser(&said.to_string());
        Engine(error) => German(error);
        NotUtf8;
        NoVersion;
        NoSuchVersion;
        NewerVersion { version, known } => version, known;
        UnknownKey { key, known } => key, known;
        Expected { wanted, found } => German(wanted), German(found);
        NumberCount { wanted, found } => wanted, found;
        QuaternionCount { wanted, found } => wanted, found;
        NotFinite;
        TooLarge;
        Between { low, high } => low, high;
        OneOf(names) => one_of(names, "oder");
        Both(a, b) => a, b;
        Space;
        BehindPoints;
        PresetNumber;
        TooFewPoints(number) => number;
        NoPosition;
        PresetAndOwn;
        TargetAndOffset;
        PaceTwice;
        UpTwice;
        NoUpPath;
        PartTwice;
        PartWithoutWhole;
        NoSlopes;
        Scene(nodes) => nodes;
        KeyOfPath(key) => key;
        Marker;
        MarkerTwice(name) => name;
        NoName;
        NoKind;
        NotOfKind(kind) => kind;
        RowsBefore;
        NumbersBefore;
        ValueCount { keys, values } => keys, values;
        NoDeformationKind;
        Checksum;
        MeshFile;
        PolylinesAndMesh;
        Pin;
        Track;
        SetupVersion { version, known } => version, known;
        View { least, most } => number(*least), number(*most);
        Colour;
    }
    Value {
        Number;
        WholeNumber;
        DecimalNumber;
        Text;
        TextInQuotes;
        Boolean;
        DateOrTime;
        Array;
        Table;
    }
}

german! {
    WARNINGS "warnings":
    Warning {
        Misnumbered { place, number } => place, number;
        Speed { name, given, taken } => name, number(*given), number(*taken);
        NotShown(error) => German(error);
        Mesh(error) => German::<Error>(error);
        NotRead(_said) => not_here();
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

/// What the TOML parser says, before it goes on to what it expected.
fn parser(said: &str) -> &'static str {
    let said = said.split(", expected ").next().unwrap_or_default();
    let found = Language::German.catalogue().find("toml", said);
    found.unwrap_or(not_here())
}

fn not_here() -> &'static str {
    Language::German.texts().errors.not_here
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
        assert_eq!(German(&foreign).to_string(), not_here());
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
            assert!(!said.contains(not_here()), "{said}");
            count += 1;
        }
        assert!(count > 20, "{count}");
    }
}
