//! Where outputs are written: standard output, a pipe or a device, a file.

use std::fs::{self, File, OpenOptions};
use std::io::Write;
use std::path::{Path, PathBuf};

use clap::Args;
use vides::document::{Document, Edit, may_replace, save};

use super::failure::{Failure, print};
use super::input;

/// Where the path goes that is made.
#[derive(Args)]
pub(super) struct Output {
    /// The output file; - is standard output
    #[arg(short, long, value_name = "OUT.vid", default_value = "-")]
    output: PathBuf,
}

/// The kind of thing that an output's name refers to.
pub(super) enum Sink {
    Standard,
    /// A pipe or a device, which cannot be replaced as a file is.
    Stream(File),
    File,
}

impl Sink {
    pub(super) fn of(out: &Path) -> Result<Self, Failure> {
        if is_standard_output(out) {
            return Ok(Self::Standard);
        }
        if is_file(out) {
            return Ok(Self::File);
        }
        let opened = OpenOptions::new().write(true).open(out);
        opened.map(Self::Stream).map_err(|error| failed(out, error))
    }
}

/// Whether the name means standard output, which is appended to and not replaced.
pub(super) fn is_standard_output(out: &Path) -> bool {
    let names = ["-", "/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"];
    names.iter().any(|name| out.as_os_str() == *name)
}

/// Whether the name means a file, there or not.
pub(super) fn is_file(out: &Path) -> bool {
    !is_standard_output(out) && !fs::metadata(out).is_ok_and(|metadata| input::is_stream(&metadata))
}

pub(super) fn failed(out: &Path, source: std::io::Error) -> Failure {
    let place = out.display().to_string();
    vides::Error::Io { place, source }.into()
}

/// Writes all of an output.
pub(super) fn write(out: &Path, bytes: &[u8]) -> Result<(), Failure> {
    match Sink::of(out)? {
        Sink::Standard => print(bytes),
        Sink::Stream(mut stream) => stream.write_all(bytes).map_err(|error| failed(out, error)),
        Sink::File => Ok(save::save(out, bytes)?),
    }
}

/// Writes a document; meshes beside a file are named relative to it.
pub(super) fn write_document(out: &Path, document: &Document) -> Result<(), Failure> {
    match is_file(out) {
        true => Ok(document.save(out)?),
        false => write(out, document.to_toml()?.as_bytes()),
    }
}

impl Output {
    pub(super) fn to(output: PathBuf) -> Self {
        Self { output }
    }

    pub(super) fn write(&self, document: &Document) -> Result<(), Failure> {
        write_document(&self.output, document)
    }

    /// Applies an edit to a document that was read from the file, which may be edited in place, and
    /// writes the result.
    pub(super) fn applied(
        &self,
        document: Document,
        file: &Path,
        edit: Edit,
    ) -> Result<(), Failure> {
        let mut document = document.without_history();
        document
            .apply(edit)
            .map_err(|error| Failure::from(error.at(input::name(file))))?;
        may_replace(file);
        self.write(&document)
    }
}
