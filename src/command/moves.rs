//! The camera moves: each makes a path.

use std::path::PathBuf;

use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use vides::document::Info;
use vides::document::tool::moved;
use vides::path::{Space, Up};
use vides::tools::Parameter;
use vides::tools::moves::{MOVES, Move};

use super::call::Call;
use super::failure::Failure;
use super::input;

#[derive(Args)]
pub(super) struct Options {
    /// Frames per second
    #[arg(long, value_name = "NUMBER", default_value_t = 25.0)]
    fps: f64,
    /// The up axis [default: that of --object, else y]
    #[arg(long, value_name = "AXIS", value_parser = up())]
    up: Option<Up>,
    /// Fits the defaults to this object: a mesh (.obj, .ply, .stl, .gltf, .glb) with a space
    /// around it, or that of a .vid file in its space
    #[arg(long, value_name = "FILE")]
    object: Option<PathBuf>,
}

/// An up axis.
pub(super) fn up() -> impl TypedValueParser<Value = Up> {
    PossibleValuesParser::new([Up::Y.name(), Up::Z.name()])
        .map(|name| if name == Up::Z.name() { Up::Z } else { Up::Y })
}

fn named(name: &str) -> Option<&'static Move> {
    MOVES.iter().find(|known| known.name == name)
}

pub(super) fn run(call: &Call) -> Result<(), Failure> {
    let options: Options = call.more()?;
    let chosen = named(call.tool.name).expect("a move");
    let mut space = Space::default();
    let mut info = Info {
        fps: options.fps,
        ..Info::default()
    };
    if let Some(file) = &options.object {
        let (path, of_file) = input::around(file)?.into_parts();
        space = path.space;
        (info.unit, info.object) = (of_file.unit, of_file.object);
    }
    space.up = options.up.unwrap_or(space.up);
    // Only the space of a file was chosen by somebody.
    let grows = !options.object.as_deref().is_some_and(input::is_path);
    let document = moved(chosen, space, &info, grows, |numbers| {
        let place = |name: &str| Parameter::find(chosen.parameters, name).map(|(at, _)| at);
        call.given.replace(numbers, place);
        Ok::<_, Failure>(())
    })?;
    call.output.write(&document)
}
