//! Draws a path: where it leads in space, and how fast.
//!
//! ```sh
//! cargo run --release -p vides-picture -- FLIGHT.vid PICTURE.svg
//! ```
//!
//! It stands on the library's public interface: [`vides::document::Document`]
//! for the path and its poses, and the segments' own cubics for the curve.

mod chart;
mod film;
mod scene;
mod side;
mod style;
mod svg;
#[cfg(test)]
mod tests;

use std::ffi::OsString;
use std::path::Path;
use std::process::ExitCode;

use vides::document::{Document, save};

use style::{HEIGHT, INK, MARGIN, QUIET, WIDTH};
use svg::{Anchor, Svg};

/// What can go wrong: only what the library says.
type Problem = vides::Error;

/// Width of the legend and the list beside the scene.
const SIDE: f64 = 300.0;

/// Where the scene begins and where it ends.
const SCENE: (f64, f64) = (84.0, 560.0);

/// Where the charts begin.
const CHARTS: f64 = 592.0;

fn main() -> ExitCode {
    let arguments: Vec<OsString> = std::env::args_os().skip(1).collect();
    let [from, to] = arguments.as_slice() else {
        eprintln!("usage: picture FLIGHT.vid PICTURE.svg");
        return ExitCode::from(2);
    };
    let drawn = Document::load(Path::new(from))
        .and_then(|document| picture(&document))
        .and_then(|text| save::save(Path::new(to), text.as_bytes()));
    match drawn {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("picture: {error}");
            ExitCode::FAILURE
        }
    }
}

/// The picture of a path, as the text of an SVG file.
fn picture(document: &Document) -> Result<String, Problem> {
    let title = match document.info().title.as_str() {
        "" => "Camera path",
        title => title,
    };
    let pieces = film::pieces(document)?;
    let paces = film::paces(document)?;
    let inner = WIDTH - 2.0 * MARGIN;
    let mut svg = Svg::new(WIDTH, HEIGHT, title);

    let heading = format!("fill=\"{INK}\" font-size=\"21\" font-weight=\"bold\"");
    svg.text(
        (MARGIN, 40.0),
        Anchor::Start,
        &svg::cut(title, 560.0),
        &heading,
    );
    let quiet = format!("fill=\"{QUIET}\"");
    svg.text(
        (MARGIN, 62.0),
        Anchor::Start,
        &film::summary(document)?,
        &quiet,
    );

    let (top, bottom) = SCENE;
    let scene_width = inner - SIDE - MARGIN;
    scene::draw(&mut svg, document, (MARGIN, top), scene_width, bottom - top)?;
    let side = WIDTH - MARGIN - SIDE;
    let reached = side::legend(
        &mut svg,
        (side, top + 10.0),
        !document.info().object.is_empty(),
    );
    let list = reached + 16.0;
    side::sections(&mut svg, &pieces, (side, list), SIDE, bottom - list);

    let film = chart::Film {
        pieces: &pieces,
        paces: &paces,
        frames: document.sampler()?.frame_count(),
        first_frame: document.info().first_frame.into(),
    };
    chart::draw(
        &mut svg,
        &film,
        (MARGIN, CHARTS),
        inner,
        HEIGHT - CHARTS - 12.0,
    );
    Ok(svg.finish())
}
