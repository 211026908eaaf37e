//! Out of a document into a file, and back: what command, window and C call.

use std::io::{self, BufRead, Write};
use std::path::Path;

use vides_document::{Error as DocumentError, SceneDocument, keys_to_path, save};
use vides_engine::tools::fit::Tolerance;

use super::all::formats;
use super::blocks::Progress;
use super::content::{Content, Recording};
use super::error::{Cause, Error, Place, Result};
use super::flight::Flight;
use super::foreign::Foreign;
use super::format::Format;
use super::loss::{Loss, Report};
use super::options::{As, Options, Times};
use super::saving::{kept, save_with, saved};
use super::source::Source;

/// A scene that was read.
#[derive(Debug)]
pub struct Imported {
    /// The scene.
    pub document: SceneDocument,
    /// The name of the format that it was in.
    pub format: &'static str,
    /// What was lost, and how well a path was fitted.
    pub report: Report,
    /// Of a list of poses the time of the first in the file, in seconds.
    pub start: Option<f64>,
}

impl Imported {
    /// Chooses that poses of a list keep their times in a format that has them, unless a rate or
    /// frames were chosen; what is restored by that is no loss.
    pub fn keep_times(&mut self, to: &Format, options: &mut Options) {
        let keeps = to.own_times && options.fps.is_none() && options.frames.is_none();
        let Some(start) = self.start.filter(|_| keeps) else {
            return;
        };
        options.times = options.times.or(Some(Times::Own));
        let start = *options.start.get_or_insert(start);
        let restored = |loss: &Loss| matches!(loss, Loss::Epoch(first) if *first == start);
        self.report.losses.retain(|loss| !restored(loss));
    }
}

/// Writes into a file, or the files of a folder, each replaced only when it is whole.
///
/// # Errors
/// Those of [`Flight::new`], of a [`super::Writer`] and of the system, with the file's name;
/// [`Error::NoCamera`], [`Error::NotWritten`], [`Cause::Beside`].
pub fn export(
    document: &SceneDocument,
    file: &Path,
    format: &Format,
    options: &Options,
    progress: Progress<'_>,
) -> Result<Report> {
    let mut report = Report::default();
    let mut flight = Flight::new(document, options, format, progress)?;
    if !format.is_folder() {
        save_with(file, &mut |out| {
            format.write(file, &mut flight, out, &mut report)
        })?;
        return Ok(report);
    }
    // A file of the folder may stand for it.
    let named = file.file_name().is_some_and(|name| {
        let mut parts = format.parts.iter();
        parts.any(|(part, _)| name.eq_ignore_ascii_case(part))
    });
    let folder = if named {
        file.parent().unwrap_or(Path::new(""))
    } else {
        file
    };
    if let Some(name) = format.barred.iter().find(|name| folder.join(name).exists()) {
        let barred = Place::Whole.wrong(Cause::Beside((*name).into()));
        return Err(barred.at(&folder.display().to_string()));
    }
    let mut empty = format.empty.iter();
    if let Some(name) = empty.find(|name| has_data(&folder.join(name))) {
        let replaced = Place::Whole.wrong(Cause::Replaced((*name).into()));
        return Err(replaced.at(&folder.display().to_string()));
    }
    let io = |source| DocumentError::Io {
        place: folder.display().to_string(),
        source,
    };
    let is_new = !folder.as_os_str().is_empty() && !folder.exists();
    if is_new {
        std::fs::create_dir(folder).map_err(io)?;
    }
    let files = format.parts.iter().map(|(name, _)| folder.join(name));
    let files: Vec<_> = files.collect();
    let saved = saved(|failure| {
        save::save_all(&files, &mut |part, out| {
            let (_, write) = format.parts[part];
            let written = format.write_by(write, &mut flight, out, &mut report);
            written.map_err(|error| kept(failure, error))
        })
    });
    if is_new && saved.is_err() {
        let _ = std::fs::remove_dir(folder);
    }
    saved.map(|()| report)
}

/// Whether a file of text has lines that are no comments.
fn has_data(file: &Path) -> bool {
    let Ok(file) = std::fs::File::open(file) else {
        return false;
    };
    let mut lines = io::BufReader::new(file)
        .split(b'\n')
        .map_while(|line| line.ok());
    lines.any(|line| {
        let line = line.trim_ascii();
        !line.is_empty() && line[0] != b'#'
    })
}

/// Writes onto a stream.
///
/// # Errors
/// As [`export`]; [`Error::Folder`] for a format of several files.
pub fn export_to(
    document: &SceneDocument,
    out: &mut dyn Write,
    format: &Format,
    options: &Options,
    progress: Progress<'_>,
) -> Result<Report> {
    if format.is_folder() {
        return Err(Error::Folder(format.name));
    }
    let mut report = Report::default();
    let mut flight = Flight::new(document, options, format, progress)?;
    format.write(Path::new(""), &mut flight, out, &mut report)?;
    Ok(report)
}

/// What would be lost: all is written to nowhere.
///
/// # Errors
/// As [`export`].
pub fn losses(document: &SceneDocument, format: &Format, options: &Options) -> Result<Report> {
    let mut report = Report::default();
    let mut ignored = |_, _| {};
    let mut flight = Flight::new(document, options, format, &mut ignored)?;
    if format.is_folder() {
        for &(_, write) in format.parts {
            format.write_by(write, &mut flight, &mut io::sink(), &mut report)?;
        }
    } else {
        format.write(Path::new(""), &mut flight, &mut io::sink(), &mut report)?;
    }
    Ok(report)
}

/// What a file holds, in its format or the one that its content shows.
///
/// # Errors
/// [`Error::NotRecognised`], [`Error::Foreign`], [`Error::Ambiguous`], [`Error::NotRead`],
/// [`Cause::Empty`]; those of the format; each with the file's name.
pub fn read(
    source: &Source,
    format: Option<&Format>,
    options: &Options,
    report: &mut Report,
) -> Result<(&'static str, Content)> {
    let mut whole = || {
        let format = match format {
            Some(format) => format,
            None => recognised(source)?,
        };
        if source.is_folder && !format.is_folder() && !format.reads_folder {
            let directory = io::Error::other(vides_document::NotAFile::Directory);
            return Err(Error::Document(DocumentError::Io {
                place: source.name.clone(),
                source: directory,
            }));
        }
        let mut content = format.read(source, options, report)?;
        if let Content::Poses(recording) = &mut content {
            if recording.poses.is_empty() {
                return Err(Place::Whole.wrong(Cause::Empty));
            }
            recording.count_seconds(report)?;
            recording.tell_epoch(report);
        }
        Ok((format.name, content))
    };
    whole().map_err(|error: Error| error.at(&source.name))
}

/// The format of a file: by the content; of several formats that it may be, or if it looks like
/// none, by the name.
///
/// # Errors
/// [`Error::Foreign`], [`Error::NotRecognised`], [`Error::Ambiguous`].
pub fn recognised(source: &Source) -> Result<&'static Format> {
    let read = formats().iter().copied();
    let read: Vec<_> = read.filter(|format| format.reads()).collect();
    let fits = |format: &&Format| (format.recognises)(source);
    let found: Vec<_> = read.iter().copied().filter(fits).collect();
    let file = Path::new(&source.name);
    match *found {
        [] => match Foreign::of((!source.is_folder).then_some(file), &source.bytes) {
            Some(foreign) => Err(Error::Foreign(foreign)),
            None => named(file, &read).ok_or(Error::NotRecognised),
        },
        [one] => Ok(one),
        _ => named(file, &found)
            .ok_or_else(|| Error::Ambiguous(found.iter().map(|format| format.name).collect())),
    }
}

/// The only one of some formats that a file has by its whole name, else by its ending.
fn named(file: &Path, among: &[&'static Format]) -> Option<&'static Format> {
    [Format::has_name, Format::has_ending]
        .iter()
        .find_map(|has| {
            let mut named = among.iter().filter(|format| has(format, file));
            named.next().filter(|_| named.next().is_none()).copied()
        })
}

/// The scene in a file: poses become a path or keys, as the options say.
///
/// # Errors
/// As [`read`]; those of the fit.
pub fn import(source: &Source, format: Option<&Format>, options: &Options) -> Result<Imported> {
    let mut report = Report::default();
    let (format, content) = read(source, format, options, &mut report)?;
    let mut start = None;
    let document = match content {
        Content::Scene(document) => with_path(*document, options, &mut report),
        Content::Poses(recording) => {
            let seconds = recording.seconds.as_ref().and_then(|all| all.first());
            start = Some(seconds.copied().unwrap_or(0.0));
            recording.into_scene(options, &mut report)
        }
    };
    Ok(Imported {
        document: document.map_err(|error| error.at(&source.name))?,
        format,
        report,
        start,
    })
}

/// The scene, with its shown camera on a path if that is asked for.
fn with_path(
    mut document: SceneDocument,
    options: &Options,
    report: &mut Report,
) -> Result<SceneDocument> {
    let shown = document.scene.shown_camera();
    if let (Some(As::Path), Some(camera)) = (options.as_, shown)
        && document.scene.nodes()[camera].path().is_none()
    {
        let half_size = document.scene.space().half_size;
        let tolerance = Tolerance {
            position: options.tolerance.unwrap_or(1e-3 * half_size),
            angle: options.angle,
        };
        let fps = document.info.fps;
        let made = keys_to_path(&mut document.scene, camera, fps, tolerance)?;
        report.add(Loss::Fitted {
            points: made.points,
            off: made.off,
            turned: made.turned,
        });
    }
    Ok(document)
}

/// The poses in a file, in its format or the one that its content shows, and else as lines of ten
/// numbers. Reports keyframes, which are left out.
///
/// # Errors
/// As [`read`]; [`Error::NotPoses`] for a scene.
pub fn recording(
    source: &Source,
    format: Option<&Format>,
    options: &Options,
    report: &mut Report,
) -> Result<Recording> {
    let content = match read(source, format, options, report) {
        // The reader of lines says what is wrong with them.
        Err(Error::In(_, error)) if matches!(*error, Error::NotRecognised) => {
            read(source, Some(&super::ascii::ASCII), options, report)
        }
        content => content,
    };
    match content?.1 {
        Content::Poses(recording) => {
            recording.tell_keyframes(report);
            Ok(recording)
        }
        Content::Scene(_) => Err(Error::NotPoses.at(&source.name)),
    }
}
