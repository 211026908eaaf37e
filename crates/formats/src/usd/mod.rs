//! OpenUSD's text, `.usda` (openusd.org, "USD File Formats" and the schemas of UsdGeom and UsdLux):
//! the whole scene out and in. Cameras and lights look along −z; times are in time codes, one a
//! frame; `metersPerUnit` says how long the unit is; lenses are in tenths of a unit.

mod geometry_out;
mod motion_out;
mod text;
mod unit;
mod write;

use std::io::Write;

use super::error::Result;
use super::flight::Flight;
use super::format::{Format, Row};
use super::loss::Report;

pub(super) struct Usda;

const ROW: Row = Row {
    name: "usda",
    title: "OpenUSD",
    endings: &["usda", "usd"],
    ..Row::PLAIN
};

impl Format for Usda {
    fn row(&self) -> &'static Row {
        &ROW
    }

    fn write(
        &self,
        flight: &mut Flight<'_>,
        _: usize,
        out: &mut dyn Write,
        report: &mut Report,
    ) -> Result<()> {
        write::write(flight, out, report)
    }
}

/// What `customData = { string vides = "…" }` says of a prim that we wrote.
mod role {
    /// Holds everything, and is no node.
    pub(super) const WORLD: &str = "world";
    /// The camera or light of the prim that it is in.
    pub(super) const LOOKS: &str = "looks";
    /// Geometry of the prim that it is in.
    pub(super) const PART: &str = "part";
    /// The document's wireframe.
    pub(super) const WIREFRAME: &str = "wireframe";
}

/// The colours of others are linear; those of points are bytes of sRGB (IEC 61966-2-1).
fn linear(byte: u8) -> f64 {
    let value = f64::from(byte) / 255.0;
    if value <= 0.04045 {
        value / 12.92
    } else {
        ((value + 0.055) / 1.055).powf(2.4)
    }
}

/// Red, green and blue of a channel, as they are.
fn colour(v: &[f64]) -> String {
    text::Float3(glam::DVec3::new(v[0], v[1], v[2])).to_string()
}
