//! Input files: regular files, standard input, pipes and the like.

use std::fs::{self, File, Metadata};
use std::io::{self, Read};
use std::os::unix::fs::FileTypeExt;
use std::path::{Path, PathBuf};

use clap::Args;
use vides::document::mesh::Format;
use vides::document::{Document, Object, SceneDocument, inside, load_object, note_input};
use vides::error::reason;
use vides::formats::{Error, Source, recognised};
use vides::limits::MAX_FILE_BYTES;
use vides::scene::Mesh;

use super::failure::{Failure, complain, one_line};

/// An object instead of the path's own.
#[derive(Args)]
pub(super) struct ObjectOption {
    /// Replaces the path's object: a mesh (.obj, .ply, .stl, .gltf, .glb)
    /// or the object of a .vid file
    #[arg(long, value_name = "FILE")]
    object: Option<PathBuf>,
}

impl ObjectOption {
    pub(super) fn load(&self) -> Result<Option<Object>, Failure> {
        self.object.as_deref().map(object).transpose()
    }

    pub(super) fn mesh(&self) -> Result<Option<Mesh>, Failure> {
        let object = self.load()?;
        Ok(object.map(|object| object.to_mesh()).transpose()?)
    }
}

pub(super) fn load(file: &Path) -> Result<Document, Failure> {
    match stream(file)? {
        Some(mut stream) => Ok(Document::load_from(&mut stream, &name(file))?),
        None => {
            let document = Document::load(file).map_err(|error| refused(file, &error))?;
            warn(&name(file), not_read(file, &document).as_slice());
            Ok(document)
        }
    }
}

/// Why the object of a path was not read, if that was not allowed.
fn not_read(file: &Path, document: &Document) -> Option<vides::Error> {
    let object = &document.info().object;
    let source = object.source().filter(|_| object.is_empty())?;
    inside(file.parent()?, &source.file).err()
}

/// Reports faults in the meshes that a file names.
pub(super) fn warn(name: &str, warnings: &[vides::Error]) {
    for warning in warnings {
        complain(&one_line(&format!("{name}: {warning}")));
    }
    if warnings.iter().any(|warning| warning.outside().is_some()) {
        complain(&one_line(&format!("{name}: with --trust it is read")));
    }
}

/// Why a file is not loaded; what helps where it is one of another format.
pub(super) fn refused(file: &Path, error: &dyn std::fmt::Display) -> Failure {
    let name = file.display();
    let found = Source::open(file).and_then(|source| recognised(&source).map(|format| format.name));
    Failure::Input(match found {
        Ok(other) if other != "vid" => format!(
            "{name}: this is no .vid file but one of the format {other}: \"vides convert {name} \
             OUT.vid\" makes one of it"
        ),
        Err(Error::Ambiguous(formats)) => format!(
            "{name}: this is no .vid file but one of the format {}: \"vides convert {name} OUT.vid \
             --from FORMAT\" makes one of it",
            formats.join(" or ")
        ),
        Err(foreign @ Error::Foreign(_)) => format!("{name}: {foreign}"),
        _ => error.to_string(),
    })
}

/// A file of another program, or a folder of files.
pub(super) fn source(file: &Path) -> Result<Source, Failure> {
    let Some(stream) = stream(file)? else {
        return Ok(Source::open(file)?);
    };
    let mut bytes = Vec::new();
    let read = stream.take(MAX_FILE_BYTES + 1).read_to_end(&mut bytes);
    read.map_err(|error| Failure::Input(format!("{}: {}", name(file), reason(&error))))?;
    if bytes.len() as u64 > MAX_FILE_BYTES {
        return Err(vides::Error::FileTooLarge(MAX_FILE_BYTES >> 20)
            .at(name(file))
            .into());
    }
    Ok(Source::of_bytes(&name(file), bytes))
}

/// Loads a path, or of a scene the shown camera's path; what is missing then is among
/// [`Document::notes`].
pub(super) fn load_shown(file: &Path) -> Result<Document, Failure> {
    let document = load_whole(file)?;
    if document.shows_path().is_none() {
        return Err(vides::Error::from(vides::error::Refused::NoCamera)
            .at(name(file))
            .into());
    }
    Ok(document)
}

/// Loads a path or a scene.
pub(super) fn load_whole(file: &Path) -> Result<Document, Failure> {
    let name = name(file);
    let (document, warnings) = match stream(file)? {
        Some(mut stream) => Document::load_scene_from(&mut stream, &name)?,
        None => Document::load_scene(file).map_err(|error| refused(file, &error))?,
    };
    warn(&name, &warnings);
    Ok(document)
}

/// The object of a mesh file, or that of a path.
pub(super) fn object(file: &Path) -> Result<Object, Failure> {
    if Format::of(file).is_some() {
        return Ok(load_object(file)?);
    }
    let object = load_whole(file)?.info().object.clone();
    if object.is_empty() {
        return Err(Failure::Input(format!(
            "{}: there is no object in it",
            name(file)
        )));
    }
    Ok(object)
}

/// Whether a file holds a path, not a mesh.
pub(super) fn is_path(file: &Path) -> bool {
    Format::of(file).is_none()
}

/// A path with an object in its space: that of a file, or a new one around a mesh.
pub(super) fn around(file: &Path) -> Result<Document, Failure> {
    if is_path(file) {
        return load(file);
    }
    Ok(Document::around(load_object(file)?)?)
}

/// Loads a scene; a file with just a path is one, too.
pub(super) fn load_scene(file: &Path) -> Result<SceneDocument, Failure> {
    let document = match stream(file)? {
        Some(mut stream) => SceneDocument::load_from(&mut stream, &name(file))?,
        None => SceneDocument::load(file).map_err(|error| refused(file, &error))?,
    };
    warn(&name(file), document.warnings());
    Ok(document)
}

/// A stream in a file's place, as in `vides info <(make-a-path)`. The library refuses pipes, since
/// a window must not block on one.
fn stream(file: &Path) -> Result<Option<Box<dyn Read>>, Failure> {
    if is_standard_stream(file) {
        // A file behind it is an input as others are.
        if let Ok(metadata) = fs::metadata("/proc/self/fd/0") {
            note_input(&metadata, "standard input");
        }
        return Ok(Some(Box::new(io::stdin().lock())));
    }
    if fs::metadata(file).is_ok_and(|metadata| is_stream(&metadata)) {
        let opened = File::open(file)
            .map_err(|error| Failure::Input(format!("{}: {}", name(file), reason(&error))))?;
        return Ok(Some(Box::new(opened)));
    }
    Ok(None)
}

/// The file's name in messages.
pub(super) fn name(file: &Path) -> String {
    if is_standard_stream(file) {
        "standard input".to_owned()
    } else {
        file.display().to_string()
    }
}

/// Whether the name is `-`, standard input or output; `./-` is a file.
pub(super) fn is_standard_stream(file: &Path) -> bool {
    file.as_os_str() == "-"
}

/// Whether it can only be read or written in sequence: a pipe, a terminal, `/dev/null`.
pub(super) fn is_stream(metadata: &Metadata) -> bool {
    metadata.file_type().is_fifo() || metadata.file_type().is_char_device()
}
