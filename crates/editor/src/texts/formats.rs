//! What the files of other programs say: why they are refused, and what is lost in them.

use vides_document::error::one_of;
use vides_document::error::{EngineError, TooMany};
use vides_engine::limits::{MAX_FPS, MAX_FRAMES};
use vides_formats::{Cause, Error, Format, Loss, Place, Report, Wanted, Way};

use super::german::{German, german, number};
use super::{Language, fill, refusals};
use crate::state::Editor;

/// Why a file could not be read or written, without its name.
pub(crate) fn reason_of(editor: &Editor, error: &Error) -> String {
    let language = editor.language();
    match error {
        Error::In(_, error) => reason_of(editor, error),
        Error::Document(vides_document::Error::Engine(EngineError::Limit(TooMany::Frames))) => {
            fill(editor.texts().errors.frames, &[&MAX_FRAMES])
        }
        Error::Document(error) => editor.without_name(error),
        _ if language == Language::German => German(error).to_string(),
        _ => error.to_string(),
    }
}

/// A format's title; most are the same in every language.
pub(crate) fn title_of(language: Language, format: &Format) -> &'static str {
    language.word("format", format.name, format.title)
}

/// What is lost, a sentence each.
pub(crate) fn losses_of(language: Language, report: &Report) -> Vec<String> {
    let losses = report.losses().iter();
    let said = |loss: &Loss| match language {
        Language::German => German(loss).to_string(),
        Language::English => loss.to_string(),
    };
    losses.map(said).collect()
}

german! {
    FORMATS "formats":
    Error {
        Document(error) => refusals::reason_of(Language::German, error);
        Content { place, cause } => German(place), German(cause);
        NoNode(name) => name;
        NoClip { wanted, known } => wanted, known;
        NoCamera(name) => name;
        NoFrames { first, last } => number(*first), number(*last);
        NoOption(name) => name;
        Value { name, wanted, given } => name, wanted, given;
        UnknownFormat(name) => name;
        UnknownEnding(file) => file;
        SharedEnding { file, formats } => file, one_of(formats, "oder");
        NotRecognised;
        Foreign(kind) => kind.name, German(&kind.way);
        NotPoses;
        Ambiguous(names) => one_of(names, "oder");
        NotRead(name) => name;
        NotWritten(name) => name;
        Folder(name) => name;
        Whole(name) => name;
        OwnTimes;
        OtherUp { format, up } => format, up;
        Stopped;
        In(file, error) => file, German::<Error>(error);
    }
    Way {
        Gltf;
        Poses;
        Metres;
        Chan;
        Colmap(command) => command;
        Model;
        Transforms(command) => command;
        Metadata;
        Log;
        NoCameras;
        Unpack;
    }
    Place {
        Whole;
        Line(line) => line;
        Key(key) => key;
        Byte(byte) => byte;
    }
    Cause {
        Expected(wanted) => German(wanted);
        NumberCount { wanted, found } => wanted, found;
        EachPose { poses, found } => poses, found;
        NotFinite;
        TooLarge;
        NoRotation;
        Index { index, count } => index, count;
        Order;
        Syntax(text) => text;
        NotUtf8;
        End;
        Empty;
        Long;
        Deep;
        Cycle(name) => name;
        Missing(name) => name;
        Outside(name) => name;
        Beside(name) => name;
        Replaced(name) => name;
        Unsupported { name, help } => name, if help.is_empty() { String::new() } else { format!(": Text wird daraus durch „{help}“") };
    }
    Wanted {
        Number;
        WholeNumber;
        PositiveNumber;
        Text;
        List;
        Object;
        Numbers(count) => count;
        Matrix;
        Rotation;
        Name;
        Value;
        Literal(text) => text;
        LastRow;
        Matrices;
        ImagePoints;
    }
    Loss {
        OtherNodes(count) => count;
        OtherCameras(count) => count;
        Object;
        Path;
        Aims(count) => count;
        Interpolations(count) => count;
        Deformations(count) => count;
        Resampled(count) => count;
        Forms(count) => count;
        Scaled(count) => count;
        HostChannels(count) => count;
        Roll(count) => count;
        FieldOfView;
        FieldsClamped(count) => count;
        Times;
        Distortion(count) => count;
        OffCentre(count) => count;
        Skins(count) => count;
        Sheared(count) => count;
        TimeUnit(unit) => if *unit == "nanoseconds" { "Nanosekunden" } else { "Mikrosekunden" };
        RepeatedTimes(count) => count;
        LeftOut(what) => what;
        OtherAnimations(names) => names;
        OtherModels { read, images, others } => others, read, images;
        FrameNumbers { first, last } => number(*first), number(*last);
        OwnSpline;
        Fitted { points, off, turned } => points, Language::German.written(format!("{off:.3e}")), Language::German.written(format!("{turned:.3}"));
        Seconds { pose, seconds, by_frame } => pose + 1, number(*seconds), number(*by_frame);
        Upright(axis) => axis;
        Epoch(start) => Language::German.written(start.to_string());
        Keyframes(count) => count;
        Rates(count) => MAX_FPS, count;
        Origin(place) => place.map(number).join(" ");
        Markers(count) => count;
        PointColours;
        ColourTracks(count) => count;
        Textures(count) => count;
        Orthographic(count) => count;
        SquarePictures;
        UnknownSize;
        AppliedTransform;
        NormalisedWorld(scale) => number(*scale);
        Oblong(count) => count;
        OtherScenes(count) => count;
        OtherTracks(count) => count;
        Sizes(count) => count;
        NotTaken { what, count } => what, count;
    }
}
