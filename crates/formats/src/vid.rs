//! `.vid` files: all of a document, to the last bit.

use std::io::Write;

use vides_document::SceneDocument;

use super::blocks;
use super::content::Content;
use super::error::{Error, Result};
use super::flight::Flight;
use super::format::{Format, Holds};
use super::loss::Report;
use super::options::Options;
use super::source::Source;

pub(super) static VID: Format = Format {
    name: "vid",
    title: "VIDES",
    endings: &["vid"],
    holds: Holds::Scene,
    recognises: |source| {
        super::rows::rows(source.beginning())
            .next()
            .is_some_and(|(_, row)| row.replace(' ', "").starts_with("version="))
    },
    read: Some(read),
    write: Some(write),
    ..Format::PLAIN
};

fn read(source: &Source, _: &Options, _: &mut Report) -> Result<Content> {
    let folder = source.folder.as_deref().unwrap_or(std::path::Path::new(""));
    let document = SceneDocument::from_toml_in(source.text()?, folder)?;
    Ok(Content::Scene(Box::new(document)))
}

fn write(flight: &mut Flight<'_>, out: &mut dyn Write, _: &mut Report) -> Result<()> {
    let (options, info) = (flight.options(), flight.info());
    for (name, chosen) in [
        ("node", options.node.is_some()),
        ("frames", options.frames.is_some()),
        ("scale", options.scale != 1.0),
        ("fps", options.fps.is_some_and(|fps| fps != info.fps)),
        ("up", flight.up() != flight.document_up()),
    ] {
        if chosen {
            return Err(Error::Whole(name));
        }
    }
    let text = flight.document().to_toml()?;
    out.write_all(text.as_bytes()).map_err(blocks::failed)
}
