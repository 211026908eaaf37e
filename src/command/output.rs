//! Where a tool's path is written.

use std::path::{Path, PathBuf};

use clap::Args;
use vides::document::{Document, Edit};

use super::failure::{Failure, print};
use super::input;

/// Where the path goes that is made.
#[derive(Args)]
pub(super) struct Output {
    /// Where the path goes; - is standard output
    #[arg(short, long, value_name = "OUT.vid", default_value = "-")]
    output: PathBuf,
}

impl Output {
    pub(super) fn to(output: PathBuf) -> Self {
        Self { output }
    }

    pub(super) fn write(&self, document: &Document) -> Result<(), Failure> {
        if input::is_standard_stream(&self.output) {
            return print(&document.to_toml()?);
        }
        Ok(document.save(&self.output)?)
    }

    /// Applies an edit to a file's path and writes the result.
    pub(super) fn edited(&self, file: &Path, edit: Edit) -> Result<(), Failure> {
        self.applied(input::load(file)?, file, edit)
    }

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
        self.write(&document)
    }
}
