//! `vides plot`: a path as a picture: three views of the way, the view directions on the sphere
//! with ticks for up (as the thesis asked for), and charts over the frames with findings marked.

mod charts;
mod png;
mod svg;
mod views;

use std::path::PathBuf;

use clap::Args;
use vides::document::{Document, Note, Object, save};
use vides::path::{Pose, Timeline};
use vides::scene::Mesh;
use vides::tools::check::Finding;
use vides::tools::clearance::Clearance;
use vides::tools::profile;

use super::{Failure, complain, input, one_line, print};
use svg::{Anchor, Svg};

#[derive(Args)]
pub(super) struct Arguments {
    /// The path, or a scene: the path of the camera that is shown; - is standard input
    #[arg(value_name = "FILE.vid")]
    file: PathBuf,
    /// Where the picture goes, as .svg or .png; - is standard output, as SVG
    #[arg(short, long, value_name = "OUT", default_value = "-")]
    output: PathBuf,
    /// The object in place of the path's: a mesh (.obj, .ply, .stl, .gltf, .glb),
    /// or the object of a .vid file
    #[arg(long, value_name = "FILE")]
    object: Option<PathBuf>,
    /// On a dark ground
    #[arg(long)]
    dark: bool,
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

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let to_file = !input::is_standard_stream(&arguments.output);
    let ending = arguments.output.extension();
    let ends = |wanted: &str| ending.is_some_and(|ending| ending.eq_ignore_ascii_case(wanted));
    if to_file && !ends("svg") && !ends("png") {
        return Err(Failure::Usage(format!(
            "{}: a plot is written as .svg or .png",
            arguments.output.display()
        )));
    }
    let document = input::load_shown(&arguments.file)?;
    let object = arguments.object.as_deref().map(input::object).transpose()?;
    let style = if arguments.dark { &DARK } else { &LIGHT };
    let svg = picture(&document, object.as_ref(), style)
        .map_err(|error| Failure::from(error.at(input::name(&arguments.file))))?;
    if to_file && ends("png") {
        let png = png::of(&svg).map_err(Failure::Usage)?;
        return Ok(save::save(&arguments.output, &png)?);
    }
    let text = svg.finish();
    if to_file {
        Ok(save::save(&arguments.output, text.as_bytes())?)
    } else {
        print(&text)
    }
}

fn picture(document: &Document, object: Option<&Object>, style: &Style) -> vides::Result<Svg> {
    let sampler = document.sampler()?;
    let frames = sampler.frame_count();
    let obstacles = match object {
        Some(object) => Some(object.to_mesh()?),
        None => document.obstacles()?,
    };
    let clearance = obstacles.as_ref().map(Clearance::new).transpose()?;
    let notes = document.notes(clearance.as_ref(), object.is_none())?;
    for note in &notes {
        complain(&one_line(&note.to_string()));
    }
    let film = Film {
        document,
        style,
        samples: profile::samples(sampler, POSES)?,
        found: document.check_against(clearance.as_ref())?,
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
    Ok(svg)
}
