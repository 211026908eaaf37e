//! What a format is.

use std::io::Write;
use std::path::Path;

use vides_engine::path::Up;

use super::content::Content;
use super::error::{Error, Result};
use super::flight::Flight;
use super::loss::Report;
use super::options::Options;
use super::source::Source;

/// Reads all of a file. What is wrong in it is one sentence with the place and the reason.
pub type Reader = fn(&Source, &Options, &mut Report) -> Result<Content>;

/// Writes a flight into a file, after what [`Holds`] asks for. Its errors are those of sampling, and
/// [`Error::Document`] if the stream fails.
pub type Writer = fn(&mut Flight<'_>, &mut dyn Write, &mut Report) -> Result<()>;

/// What of a scene a format holds. Before a file is written, losses are reported, and
/// nodes that it is not for are refused.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Holds {
    /// All, with or without a camera.
    Scene,
    /// What a camera sees; the writer reports the rest.
    View,
    /// A camera's poses and all objects; the writer reports the rest.
    Objects,
    /// A camera's poses, and the object.
    Motion,
    /// A camera's poses.
    Poses,
    /// The poses of a node that has some, the matrices of any other.
    Frames,
}

/// A file format: its names, and what it can do.
#[derive(Debug)]
pub struct Format {
    /// As `--from` and `--to` take it.
    pub name: &'static str,
    /// As people call it.
    pub title: &'static str,
    /// File name extensions, without the dot; the first is proposed. See [`Format::all_endings`].
    pub endings: &'static [&'static str],
    /// Whole file names that are always of this format.
    pub file_names: &'static [&'static str],
    /// Which axis is up in every file, if the format prescribes it.
    pub up: Option<Up>,
    /// What of a scene it holds.
    pub holds: Holds,
    /// Whether the content looks like this format; of files that several recognise the user must
    /// name the format.
    pub recognises: fn(&Source) -> bool,
    /// Reads a file, or a folder of files; none if it is written only.
    pub read: Option<Reader>,
    /// Whether its poses may be at any times, or have none.
    pub own_times: bool,
    /// Whether it also reads a folder with a file for each pose.
    pub reads_folder: bool,
    /// Writes its one file; none if it is a folder, or read only.
    pub write: Option<Writer>,
    /// Writers of files with these endings, if the format has more than one kind of file.
    pub by_ending: &'static [(&'static str, Writer)],
    /// The files of a format that is a folder, in the order in which they are written.
    pub parts: &'static [(&'static str, Writer)],
    /// Files that would be read before the parts, or together with them: into a folder that has one
    /// nothing is written.
    pub barred: &'static [&'static str],
    /// Parts that are written without data: one that has some, below its comments, is not replaced.
    pub empty: &'static [&'static str],
}

impl Format {
    /// A format of a camera's poses in one file, of which nothing else is known yet.
    pub const PLAIN: Self = Self {
        name: "",
        title: "",
        endings: &[],
        file_names: &[],
        up: None,
        holds: Holds::Poses,
        recognises: |_| false,
        read: None,
        own_times: false,
        reads_folder: false,
        write: None,
        by_ending: &[],
        parts: &[],
        barred: &[],
        empty: &[],
    };

    /// Whether it can be read.
    #[must_use]
    pub const fn reads(&self) -> bool {
        self.read.is_some()
    }

    /// Whether it can be written.
    #[must_use]
    pub const fn writes(&self) -> bool {
        self.write.is_some() || self.is_folder()
    }

    /// Whether it is a folder of files.
    #[must_use]
    pub const fn is_folder(&self) -> bool {
        !self.parts.is_empty()
    }

    /// The extensions of its files, of every kind.
    pub fn all_endings(&self) -> impl Iterator<Item = &'static str> {
        let others = self.by_ending.iter().map(|&(ending, _)| ending);
        self.endings.iter().copied().chain(others)
    }

    /// Whether a file of this name is of the format: by the whole name, or by the ending.
    #[must_use]
    pub fn is_named(&self, file: &Path) -> bool {
        self.has_name(file) || self.has_ending(file)
    }

    pub(super) fn has_name(&self, file: &Path) -> bool {
        let name = file.file_name().unwrap_or_default();
        let known = self.file_names.iter();
        let mut known = known.chain(self.parts.iter().map(|(name, _)| name));
        known.any(|known| name.eq_ignore_ascii_case(known))
    }

    pub(super) fn has_ending(&self, file: &Path) -> bool {
        let ending = file.extension().unwrap_or_default();
        let mut known = self.all_endings();
        known.any(|known| ending.eq_ignore_ascii_case(known))
    }

    /// Reads a file.
    ///
    /// # Errors
    /// [`Error::NotRead`]; those of the reader.
    pub(super) fn read(
        &self,
        source: &Source,
        options: &Options,
        report: &mut Report,
    ) -> Result<Content> {
        let read = self.read.ok_or(Error::NotRead(self.name))?;
        read(source, options, report)
    }

    /// Writes its one file, of the kind that the file's ending names.
    ///
    /// # Errors
    /// [`Error::NotWritten`]; as [`Format::write_by`].
    pub(super) fn write(
        &self,
        file: &Path,
        flight: &mut Flight<'_>,
        out: &mut dyn Write,
        report: &mut Report,
    ) -> Result<()> {
        let write = self.write.ok_or(Error::NotWritten(self.name))?;
        let ending = file.extension().unwrap_or_default();
        let mut others = self.by_ending.iter();
        let other = others.find(|(known, _)| ending.eq_ignore_ascii_case(known));
        let write = other.map_or(write, |&(_, other)| other);
        self.write_by(write, flight, out, report)
    }

    /// Writes one of its files, by its writer; reports what the format cannot hold.
    ///
    /// # Errors
    /// [`Error::NoCamera`]; those of the writer.
    pub(super) fn write_by(
        &self,
        write: Writer,
        flight: &mut Flight<'_>,
        out: &mut dyn Write,
        report: &mut Report,
    ) -> Result<()> {
        flight.tell_left_out(self.holds, report)?;
        write(flight, out, report)
    }
}
