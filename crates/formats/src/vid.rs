//! `.vid` files: all of a document, to the last bit.

use std::io::Write;

use super::blocks;
use super::content::Content;
use super::error::Result;
use super::flight::Flight;
use super::format::{Format, Row};
use super::loss::Report;
use super::options::Options;
use super::source::Source;
use crate::document::SceneDocument;

pub(super) struct Vid;

const ROW: Row = Row {
    name: "vid",
    title: "VIDES",
    endings: &["vid"],
    ..Row::PLAIN
};

impl Format for Vid {
    fn row(&self) -> &'static Row {
        &ROW
    }

    fn recognises(&self, source: &Source) -> bool {
        super::rows::rows(source.beginning())
            .next()
            .is_some_and(|(_, row)| row.replace(' ', "").starts_with("version="))
    }

    fn read(&self, source: &Source, _: &Options, _: &mut Report) -> Result<Content> {
        let folder = source.folder.as_deref().unwrap_or(std::path::Path::new(""));
        let document = SceneDocument::from_toml_in(source.text()?, folder)?;
        Ok(Content::Scene(Box::new(document)))
    }

    fn write(
        &self,
        flight: &mut Flight<'_>,
        _: usize,
        out: &mut dyn Write,
        _: &mut Report,
    ) -> Result<()> {
        let text = flight.document().to_toml()?;
        out.write_all(text.as_bytes()).map_err(blocks::failed)
    }
}
