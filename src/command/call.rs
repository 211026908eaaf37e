//! A tool as it was called: what its subcommand was given.

use std::path::PathBuf;

use clap::{ArgMatches, FromArgMatches};
use vides::document::tool::Tool;
use vides::document::{Document, Edit};
use vides::path::CameraPath;

use super::failure::{Failure, complain};
use super::given::Given;
use super::input;
use super::output::Output;

/// A tool as it was called.
pub(super) struct Call {
    pub(super) tool: Tool,
    pub(super) given: Given,
    pub(super) output: Output,
    pub(super) matches: ArgMatches,
}

impl Call {
    /// The first file.
    pub(super) fn file(&self) -> &PathBuf {
        self.matches.get_one("file").expect("a required argument")
    }

    /// A number, or its default.
    pub(super) fn number(&self, name: &str) -> f64 {
        let parameter = self.tool.parameters().find(|known| known.name == name);
        let default = parameter.map_or(0.0, |parameter| parameter.default);
        self.given.number(name).unwrap_or(default)
    }

    /// Writes another path in the place of the document's, and what was done on standard error.
    pub(super) fn replace(
        &self,
        document: Document,
        path: CameraPath,
        report: impl IntoIterator<Item = String>,
    ) -> Result<(), Failure> {
        for line in report {
            complain(&format!("{}: {line}", input::name(self.file())));
        }
        let edit = Edit::ReplacePath(Box::new(path));
        self.output.applied(document, self.file(), edit)
    }

    /// An error with the name of the file.
    pub(super) fn at_file(&self, error: impl Into<vides::Error>) -> Failure {
        error.into().at(input::name(self.file())).into()
    }

    /// Options that are not in the table.
    pub(super) fn more<A: FromArgMatches>(&self) -> Result<A, Failure> {
        A::from_arg_matches(&self.matches).map_err(|error| Failure::Usage(error.to_string()))
    }
}
