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
    match (language, format.name) {
        (Language::German, "gltf") => "glTF, Text",
        (Language::German, "blender") => "Skript für Blender",
        (Language::German, "paraview") => "Skript für ParaView",
        (Language::German, "vtk") => "Skript für VTK",
        (Language::German, "html") => "Webseite",
        _ => format.title,
    }
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
    Error {
        Document(error) => "{}", refusals::reason_of(Language::German, error);
        Content { place, cause } => "{}{}", German(place), German(cause);
        NoNode(name) => "den Knoten „{name}“ gibt es nicht";
        NoClip { wanted, known } => "die Animation „{wanted}“ gibt es nicht; Animationen sind: {known}";
        NoCamera(name) => "der Knoten „{name}“ ist keine Kamera; von anderen hält dieses Format nichts";
        NoFrames { first, last } => "die Bilder gehen von {} bis {}", number(*first), number(*last);
        NoOption(name) => "die Einstellung „{name}“ gibt es nicht";
        Value { name, wanted, given } => "{name}: {wanted} ist gefragt, nicht „{given}“";
        UnknownFormat(name) => "das Format „{name}“ gibt es nicht";
        UnknownEnding(file) => "{file}: kein Format hat diese Endung";
        SharedEnding { file, formats } =>
            "{file}: das kann {} sein; bitte das Format wählen", one_of(formats, "oder");
        NotRecognised => "das ist keine Datei eines Formats, das gelesen wird";
        Foreign(kind) => "{}-Dateien werden nicht gelesen: {}", kind.name, German(&kind.way);
        NotPoses => "das ist eine Bahn oder eine Szene, keine Liste von Posen";
        Ambiguous(names) => "das kann {} sein; die Endung des Namens entscheidet", one_of(names, "oder");
        NotRead(name) => "das Format {name} wird geschrieben, nicht gelesen";
        NotWritten(name) => "das Format {name} wird gelesen, nicht geschrieben";
        Folder(name) => "das Format {name} ist ein Verzeichnis mit Dateien: bitte eines nennen";
        Whole(name) => "{name}: eine .vid-Datei hält ein ganzes Dokument, wie es ist";
        OwnTimes => "times=own gibt es für die Formate tum, euroc, osg, kitti und matrices, ohne fps";
        OtherUp { format, up } => "im Format {format} steht die Achse {up} senkrecht";
        Stopped => "es wurde angehalten";
        In(file, error) => "{file}: {}", German::<Error>(error);
    }
    Way {
        Gltf => "bitte aus dem Programm, das sie schrieb, als glTF ausgeben";
        Poses => "bitte die Posen ausgeben, etwa als TUM, CSV oder transforms.json";
        Metres => "bitte ihre Posen in Metern schreiben, etwa als TUM";
        Chan => "bitte die Kamera aus Nuke als .chan ausgeben";
        Colmap(command) => "bitte mit „{command}“ ein Modell für COLMAP ausgeben und dessen Verzeichnis nennen";
        Model => "darin sind keine Posen; bitte das Verzeichnis des Modells nennen, das „colmap mapper“ daraus macht";
        Transforms(command) =>
            "bitte die Kameras als XML ausgeben und mit „{command}“ eine transforms.json daraus machen";
        Metadata => "bitte die Metadaten auspacken, mit „unzip -p in.r3d metadata > metadata.json“";
        Log => "bitte die Posen herausziehen, etwa mit „evo_traj bag in.bag TOPIC --save_as_tum“";
        NoCameras => "sie haben Punkte und keine Kameras";
        Unpack => "bitte auspacken";
    }
    Place {
        Whole => "";
        Line(line) => "Zeile {line}: ";
        Key(key) => "{key}: ";
        Byte(byte) => "Byte {byte}: ";
    }
    Cause {
        Expected(wanted) => "{} erwartet", German(wanted);
        NumberCount { wanted, found } => "{wanted} Zahlen erwartet, {found} gefunden";
        EachPose { poses, found } => "für jede von {poses} Posen wird einer erwartet, gefunden: {found}";
        NotFinite => "die Zahl muss endlich sein";
        TooLarge => "die Zahl ist zu groß";
        NoRotation => "die Drehung ist null";
        Index { index, count } => "die Nummer {index} gibt es nicht: es sind {count}";
        Order => "die Zeiten müssen wachsen";
        Syntax(text) => "{text}";
        NotUtf8 => "das ist kein UTF-8-Text";
        End => "die Datei endet zu früh";
        Empty => "in dieser Datei sind keine Posen";
        Long => "das ist mehr, als gelesen wird";
        Deep => "das liegt tiefer, als gelesen wird";
        Cycle(name) => "{name} liegt in sich selbst";
        Missing(name) => "{name} fehlt";
        Outside(name) => "{name} liegt außerhalb des Verzeichnisses der Datei, wo nichts gelesen wird";
        Beside(name) => "auch {name} liegt dort und würde zuerst gelesen: verschieben";
        Replaced(name) => "{name} dort hat Daten, die verloren gingen: in einen anderen Ordner schreiben";
        Unsupported { name, help } => "{name} wird nicht gelesen{}",
            if help.is_empty() { String::new() } else { format!(": Text wird daraus durch „{help}“") };
    }
    Wanted {
        Number => "Zahl";
        WholeNumber => "ganze Zahl";
        PositiveNumber => "Zahl größer als 0";
        Text => "Text";
        List => "Liste";
        Object => "Objekt";
        Numbers(count) => "{count} Zahlen";
        Matrix => "Matrix mit 4 × 4 Zahlen";
        Rotation => "Matrix, die dreht und nicht spiegelt,";
        Name => "Name";
        Value => "Wert";
        Literal(text) => "„{text}“";
        LastRow => "Matrix, deren letzte Zeile 0 0 0 1 ist,";
        Matrices => "Feld von N × 4 × 4 oder N × 3 × 4 Zahlen";
        ImagePoints => "Punkte des Bildes davor oder eine leere Zeile";
    }
    Loss {
        OtherNodes(count) => "andere Knoten bleiben weg: {count}";
        OtherCameras(count) => "andere Kameras bleiben weg: {count}";
        Object => "das Objekt bleibt weg";
        Path => "aus Punkten, Zeitkurven und Pausen werden Posen, eine je Bild";
        Aims(count) => "aus Zielen werden Drehungen, eine je Bild: {count}";
        Interpolations(count) => "Spuren, deren Interpolation dem Format fehlt, bekommen einen Schlüssel je Bild: {count}";
        Deformations(count) => "verformte Objekte wie in Ruhe: {count}";
        Resampled(count) => "Bewegungen neu berechnet, ein Schlüssel je Bild, Knoten: {count}";
        Forms(count) => "verformte Objekte als Punkte, wo sie sich ändern Bild für Bild: {count}";
        Scaled(count) => "Kameras und Lichter in skalierten Knoten stehen oben, eine Pose je Bild: {count}";
        HostChannels(count) => "Kanäle des Programms bleiben weg: {count}";
        Roll(count) => "der Winkel bleibt weg, Posen: {count}";
        FieldOfView => "der Blickwinkel bleibt weg";
        FieldsClamped(count) => "Blickwinkel außerhalb von 0,69 bis 170,5 Grad, begrenzt: {count}";
        Times => "es gibt keine Zeiten: eine Pose ist ein Bild";
        Distortion(count) => "die Verzeichnung bleibt weg, Kameras: {count}";
        OffCentre(count) => "Bilder, deren Achse neben der Mitte liegt, wie in ihr: {count}";
        Skins(count) => "Netze mit Skelett wie in Ruhe: {count}";
        Sheared(count) => "Knoten ohne ihre Scherung: {count}";
        TimeUnit(unit) => "Zeiten über 1e11 sind keine Sekunden: sie zählen {}",
            if *unit == "nanoseconds" { "Nanosekunden" } else { "Mikrosekunden" };
        RepeatedTimes(count) => "Posen zur gleichen Zeit wie die vorige bleiben weg: {count}";
        LeftOut(what) => "weggelassen: {what}";
        OtherAnimations(names) => "Animationen bleiben weg: {names}; eine wählt clip";
        OtherModels { read, images, others } =>
            "andere Modelle bleiben weg: {others}; {read} hat die meisten Aufnahmen ({images})";
        FrameNumbers { first, last } =>
            "das erste Bild ist 1 und nicht {}: dort sind es ganze Zahlen von 0 bis {}", number(*first), number(*last);
        OwnSpline => "der Betrachter verbindet die Schlüssel durch eine eigene Kurve";
        Fitted { points, off, turned } =>
            "eine Bahn mit {points} Punkten, höchstens {} und {} Grad von den Posen",
            Language::German.written(format!("{off:.3e}")), Language::German.written(format!("{turned:.3}"));
        Seconds { pose, seconds, by_frame } =>
            "es gelten die Zeiten der Bilder; nach den Sekunden wäre Pose {} bei {} s, nach ihrem Bild ist sie bei {} s",
            pose + 1, number(*seconds), number(*by_frame);
        Upright(axis) => "in der Datei steht {axis} senkrecht, in diesem Dokument nicht";
        Epoch(start) => "die Zeiten beginnen bei {} s: hier zählen sie ab 0",
            Language::German.written(start.to_string());
        Keyframes(count) =>
            "Schlüssel bleiben weg, angenähert werden die Bilder: {count}; ein Import ohne Werkzeug macht sie zu Punkten";
        Rates(count) => "Bildraten außerhalb von 0 bis {MAX_FPS} bleiben weg: {count}";
        Origin(place) =>
            "zu weit vom Ursprung für 32 Bit: alle Knoten liegen in einem Knoten „origin“ bei {}",
            place.map(number).join(" ");
        Markers(count) => "Marken bleiben weg: {count}";
        PointColours => "die Farben von Punkten bleiben weg";
        ColourTracks(count) => "Farben, die sich ändern, wie am Anfang: {count}";
        Textures(count) => "Texturen bleiben weg: {count}";
        Orthographic(count) => "Kameras ohne Perspektive, wie mit ihr: {count}";
        SquarePictures => "die Größe der Aufnahmen ist unbekannt: wie quadratisch; size nennt sie";
        UnknownSize => "die Größe der Aufnahmen ist unbekannt: wie 1920x1080; size nennt sie";
        AppliedTransform =>
            "die Posen sind in der Welt nach applied_transform: Objekte aus der Welt der Aufnahme passen, mit dieser Matrix malgenommen, hinein";
        NormalisedWorld(scale) =>
            "die Posen sind in der Welt von nerfstudio: Objekte der Aufnahme passen, mit „transform“ aus dataparser_transforms.json und dann mit {} malgenommen, hinein; die von „ns-export“ passen schon",
            number(*scale);
        Oblong(count) => "Bilder, deren Pixel nicht quadratisch sind: es gilt die Höhe: {count}";
        OtherScenes(count) => "andere Szenen bleiben weg: {count}";
        OtherTracks(count) => "Animationen anderer Eigenschaften bleiben weg: {count}";
        Sizes(count) => "die Größe bleibt weg, Matrizen: {count}";
        NotTaken { what, count } => "{what} wird nicht übernommen: {count}";
    }
}
