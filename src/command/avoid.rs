//! `vides avoid`: the way of a path led clear of an object.

use std::path::PathBuf;

use clap::Args;
use vides::document::Edit;
use vides::planner::{AvoidRequest, avoid_object};

use super::failure::{Failure, complain};
use super::input;
use super::output::Output;
use super::progress::progress;

#[derive(Args)]
pub(super) struct Arguments {
    /// The path; - is standard input
    #[arg(value_name = "FILE.vid")]
    file: PathBuf,
    /// Minimum distance from the object, in the path's unit
    #[arg(long, value_name = "LENGTH", allow_negative_numbers = true)]
    clearance: f64,
    /// The radius of a sphere around the camera that keeps it
    #[arg(
        long,
        value_name = "RADIUS",
        default_value_t = 0.0,
        allow_negative_numbers = true
    )]
    around: f64,
    /// Replaces the path's object: a mesh (.obj, .ply, .stl, .gltf, .glb)
    /// or the object of a .vid file
    #[arg(long, value_name = "FILE")]
    object: Option<PathBuf>,
    #[command(flatten)]
    output: Output,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let document = input::load(&arguments.file)?;
    let object = arguments.object.as_deref().map(input::object).transpose()?;
    let object = object.map(|object| object.to_mesh()).transpose()?;
    let name = input::name(&arguments.file);
    let at_file = |error: vides::Error| Failure::from(error.at(name.clone()));
    let object = document.solid(object.as_ref()).map_err(at_file)?;
    let request = AvoidRequest {
        clearance: arguments.clearance,
        radius: arguments.around,
    };
    let made = avoid_object(document.path(), &object, &request, &mut progress("places"));
    let made = made.map_err(|error| at_file(error.into()))?;
    for part in &made.parts {
        complain(&format!("{name}: {part}"));
    }
    if made.parts.is_empty() {
        complain(&format!("{name}: the way is clear as it is"));
    }
    let edit = Edit::ReplacePath(Box::new(made.path));
    arguments.output.applied(document, &arguments.file, edit)
}
