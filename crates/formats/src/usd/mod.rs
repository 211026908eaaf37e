//! OpenUSD's text, `.usda` (openusd.org, "USD File Formats" and the schemas of UsdGeom and UsdLux):
//! the whole scene out and in. Cameras and lights look along −z; times are in time codes, one a
//! frame; `metersPerUnit` says how long the unit is; lenses are in tenths of a unit.

mod curve;
mod geometry_in;
mod geometry_out;
mod lexer;
mod looks_in;
mod motion_out;
mod ops;
mod read;
mod role;
mod stage;
mod text;
mod unit;
mod write;

#[cfg(test)]
mod hostile_tests;
#[cfg(test)]
mod read_tests;
#[cfg(test)]
mod tests;

use super::content::Content;
use super::error::{Cause, Place, Result, Wanted};
use super::format::{Format, Holds};
use super::loss::Report;
use super::options::Options;
use super::source::Source;

pub(super) static USDA: Format = Format {
    name: "usda",
    title: "OpenUSD",
    endings: &["usda", "usd"],
    holds: Holds::Scene,
    recognises: |source| source.bytes.starts_with(TEXT) || binary(source).is_some(),
    read: Some(read),
    write: Some(write::write),
    ..Format::PLAIN
};

fn read(source: &Source, options: &Options, report: &mut Report) -> Result<Content> {
    if let Some(name) = binary(source) {
        return Err(Place::Whole.wrong(Cause::Unsupported {
            name: name.into(),
            help: "usdcat in.usdc -o out.usda",
        }));
    }
    if !source.bytes.starts_with(TEXT) {
        return Err(Place::Line(1).expected(Wanted::Literal("#usda 1.0")));
    }
    read::read(source.text()?, options, report)
}

/// How a file begins.
const TEXT: &[u8] = b"#usda ";

/// What a file is that holds the same in another way than as text.
fn binary(source: &Source) -> Option<&'static str> {
    let bytes = &source.bytes;
    if bytes.starts_with(b"PXR-USDC") {
        return Some("a binary file of OpenUSD (.usdc)");
    }
    // The first of an archive is the stage, its name 30 bytes behind the start.
    let name = bytes.get(30..bytes.len().min(30 + 256))?;
    let stage = name.windows(4).any(|end| end == b".usd");
    (bytes.starts_with(b"PK\x03\x04") && stage).then_some("an archive of OpenUSD (.usdz)")
}
