//! What a format is.

use std::io::Write;
use std::path::Path;

use super::content::Content;
use super::error::{Error, Result};
use super::flight::Flight;
use super::loss::Report;
use super::options::Options;
use super::row::Row;
use super::source::Source;

/// A file format.
pub trait Format: Sync {
    /// Its names and what it can do.
    fn row(&self) -> &'static Row;

    /// Whether the content looks like this format; of files that several recognise the user must
    /// name the format.
    fn recognises(&self, _source: &Source) -> bool {
        false
    }

    /// Reads all of a file.
    ///
    /// # Errors
    /// One sentence with the place in the file and the reason.
    fn read(&self, _source: &Source, _options: &Options, _report: &mut Report) -> Result<Content> {
        Err(Error::NotRead(self.row().name))
    }

    /// Fails if nothing may be written into a folder.
    ///
    /// # Errors
    /// What stands in the way there.
    fn check_folder(&self, _folder: &Path) -> Result<()> {
        Ok(())
    }

    /// Writes a flight; of a format of several files the one with this index in [`Row::parts`].
    ///
    /// # Errors
    /// Those of sampling; [`Error::Document`] if `out` fails.
    fn write(
        &self,
        _flight: &mut Flight<'_>,
        _part: usize,
        _out: &mut dyn Write,
        _report: &mut Report,
    ) -> Result<()> {
        Err(Error::NotWritten(self.row().name))
    }
}
