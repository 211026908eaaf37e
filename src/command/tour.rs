//! `vides tour`: a flight that shows an object.

use std::path::PathBuf;

use clap::Args;
use vides::document::{Document, Info};
use vides::path::Up;
use vides::planner::{TourRequest, tour};

use super::failure::{Failure, complain};
use super::input;
use super::moves::{numbers, up};
use super::output::Output;
use super::progress::progress;

#[derive(Args)]
pub(super) struct Arguments {
    /// The object: a mesh (.obj, .ply, .stl, .gltf, .glb), or the object of a .vid file
    #[arg(value_name = "OBJECT")]
    object: PathBuf,
    /// Duration of the flight
    #[arg(
        long,
        value_name = "SECONDS",
        default_value_t = 60.0,
        allow_negative_numbers = true
    )]
    seconds: f64,
    /// Share of the visible surface, by area, to show
    #[arg(
        long,
        value_name = "SHARE",
        default_value_t = 0.95,
        allow_negative_numbers = true
    )]
    coverage: f64,
    /// Distance of the camera from what it shows [default: one that has the whole object in
    /// the picture]
    #[arg(long, value_name = "LENGTH", allow_negative_numbers = true)]
    distance: Option<f64>,
    /// Flies inside the object, not around it
    #[arg(long)]
    inside: bool,
    /// Where the flight begins [default: a closed round]
    #[arg(long, value_name = "X,Y,Z", value_parser = place, allow_hyphen_values = true)]
    start: Option<[f64; 3]>,
    /// The up axis
    #[arg(long, value_name = "AXIS", value_parser = up(), default_value = "y")]
    up: Up,
    /// Only the views that cover it, one per frame, for photographs; no flight
    #[arg(long, conflicts_with = "seconds")]
    stills: bool,
    #[command(flatten)]
    output: Output,
}

fn place(text: &str) -> Result<[f64; 3], String> {
    let numbers = numbers(text)?;
    <[f64; 3]>::try_from(numbers)
        .map_err(|_| "three numbers with commas between are wanted".to_owned())
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let name = input::name(&arguments.object);
    let object = input::object(&arguments.object)?;
    let mesh = object.to_mesh()?;
    let info = Info {
        object,
        ..Info::default()
    };
    let request = TourRequest {
        seconds: arguments.seconds,
        coverage: arguments.coverage,
        distance: arguments.distance.unwrap_or(0.0),
        inside: arguments.inside,
        start: arguments.start.map(Into::into),
        up: arguments.up,
        stills: arguments.stills,
        limits: info.limits,
        fps: info.fps,
        space: None,
    };
    let made = tour(&mesh, &request, &mut progress("pictures"))
        .map_err(|error| vides::Error::from(error).at(name.clone()))?;
    for line in made.to_string().lines() {
        complain(&format!("{name}: {line}"));
    }
    arguments
        .output
        .write(&Document::from_parts(made.path, info)?)
}
