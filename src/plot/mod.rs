//! A path as a picture: three views of the way, the view directions on the sphere with ticks for
//! up (as the thesis asked for), and charts over the frames with findings marked.
//!
//! The SVG is written by hand; the command makes its PNG of the same marks ([`svg`]).

mod charts;
#[doc(hidden)]
pub mod svg;
mod views;

use crate::Result;
use crate::document::{Document, Note, Object};
use crate::path::{Pose, Timeline};
use crate::scene::Mesh;
use crate::tools::check::Finding;
use crate::tools::clearance::Clearance;
use crate::tools::profile;
use svg::{Anchor, Svg};

/// A picture, and what is to be told besides.
pub struct Picture {
    svg: Svg,
    notes: Vec<Note>,
}

impl Picture {
    /// As an SVG file.
    #[must_use]
    pub fn into_svg(self) -> String {
        self.svg.finish()
    }

    /// Where the camera is, and what was not looked at.
    #[must_use]
    pub fn notes(&self) -> &[Note] {
        &self.notes
    }

    /// What is drawn, for other picture formats.
    #[doc(hidden)]
    #[must_use]
    pub const fn drawn(&self) -> &Svg {
        &self.svg
    }
}

struct Style {
    ground: &'static str,
    ink: &'static str,
    /// Explanations.
    quiet: &'static str,
    /// Thin separating and measuring lines.
    hair: &'static str,
    /// Bands behind every other section.
    band: &'static str,
    way: &'static str,
    view: &'static str,
    object: &'static str,
    wrong: &'static str,
}

const LIGHT: Style = Style {
    ground: "#ffffff",
    ink: "#1d2733",
    quiet: "#66717e",
    hair: "#d9dee4",
    band: "#f3f5f8",
    way: "#1f62b5",
    view: "#c8541b",
    object: "#8a929b",
    wrong: "#d02f3f",
};

const DARK: Style = Style {
    ground: "#16191e",
    ink: "#e8ebef",
    quiet: "#98a2ae",
    hair: "#39414b",
    band: "#1e232a",
    way: "#6ea8f0",
    view: "#f0945c",
    object: "#77818c",
    wrong: "#ff6b78",
};

const WIDTH: f64 = 960.0;
const MARGIN: f64 = 28.0;

/// Poses sampled: more than a chart has columns.
const POSES: usize = 2_000;

/// What the picture is drawn from.
struct Film<'a> {
    document: &'a Document,
    style: &'a Style,
    /// Frames from 1, whole ones unless there are too many.
    samples: Vec<(f64, Pose)>,
    found: Vec<Finding>,
    notes: Vec<Note>,
    obstacles: Option<Mesh>,
    clearance: Option<Clearance>,
    frames: usize,
}

/// The picture of a path, or of the path that a scene's shown camera follows. `object` takes the
/// place of the document's own; `dark` is the ground. `progress` is called with the frames checked
/// and their number, and ends the work by returning false.
///
/// # Errors
/// As [`Document::sampler`], [`Document::check_against`] and [`Document::notes`].
pub fn picture(
    document: &Document,
    object: Option<&Object>,
    dark: bool,
    progress: &mut dyn FnMut(usize, usize) -> bool,
) -> Result<Picture> {
    let style = if dark { &DARK } else { &LIGHT };
    let sampler = document.sampler()?;
    let frames = sampler.frame_count();
    let obstacles = match object {
        Some(object) => Some(object.to_mesh()?),
        None => document.obstacles()?,
    };
    let clearance = obstacles.as_ref().map(Clearance::new).transpose()?;
    let notes = document.notes(clearance.as_ref(), object.is_none())?;
    let film = Film {
        document,
        style,
        samples: profile::samples(sampler, POSES)?,
        found: document.check_against(clearance.as_ref(), progress)?,
        notes,
        obstacles,
        clearance,
        frames,
    };
    let title = match document.info().title.as_str() {
        "" => "Camera path",
        title => title,
    };
    let charts = charts::of(&film)?;
    let top = 98.0;
    let side = (WIDTH - 4.0 * MARGIN) / 3.0;
    let middle = top + side + 44.0;
    let bottom = middle + side + 44.0;
    let height = bottom + charts::height(charts.len());
    let mut svg = Svg::new(WIDTH, height, title, style.ground);
    let ink = format!(
        "fill=\"{}\" font-size=\"21\" font-weight=\"bold\"",
        style.ink
    );
    svg.text((MARGIN, 40.0), Anchor::Start, &svg::cut(title, 560.0), &ink);
    let length = document.timeline(Timeline::length)?;
    let summary = format!(
        "{} points, length {length:.2}, {frames} frames, {:.1} seconds",
        document.path().points.len(),
        frames as f64 / document.info().fps,
    );
    let quiet = format!("fill=\"{}\"", style.quiet);
    svg.text((MARGIN, 62.0), Anchor::Start, &summary, &quiet);
    views::draw(&mut svg, &film, top, side);
    views::sphere(&mut svg, &film, (MARGIN, middle), side);
    views::findings(&mut svg, &film, (2.0 * MARGIN + side, middle), 2.0 * side);
    charts::draw(&mut svg, &film, &charts, bottom);
    Ok(Picture {
        svg,
        notes: film.notes,
    })
}
