//! `vides fit`: recorded poses become a path of few points.

use std::io::{self, IsTerminal};
use std::path::PathBuf;

use clap::Args;
use vides::document::{Document, Info};
use vides::path::{Space, Up};
use vides::tools::fit::{Options, Tolerance, fit};

use super::moves::{numbers, up};
use super::output::Output;
use super::progress::Bar;
use super::{Failure, complain, input};

#[derive(Args)]
pub(super) struct Arguments {
    /// The poses, as `vides sample` writes them: ten numbers a line, with or without the
    /// frame's number before and seconds behind; - is standard input
    #[arg(value_name = "POSES")]
    file: PathBuf,
    /// How far a position may be from its pose
    #[arg(long, value_name = "LENGTH", default_value_t = 0.01)]
    tolerance: f64,
    /// How far view, up and field of view may be from theirs
    #[arg(long, value_name = "DEGREES", default_value_t = 0.5)]
    angle: f64,
    /// Frames in a second
    #[arg(long, value_name = "NUMBER", default_value_t = 25.0)]
    fps: f64,
    /// The object that is shown with the path: a mesh (.obj, .ply, .stl, .gltf, .glb),
    /// or the object of a .vid file
    #[arg(long, value_name = "FILE")]
    object: Option<PathBuf>,
    /// Which axis stands upright
    #[arg(long, value_name = "AXIS", value_parser = up(), default_value = "y")]
    up: Up,
    /// The space of the path: its centre and half its size; else the smallest
    /// round the positions, with a tenth to spare
    #[arg(long, value_name = "X,Y,Z,HALF", value_parser = cube, allow_hyphen_values = true)]
    space: Option<Space>,
    /// Leaves out poses that are off by more than the tolerance from what those
    /// around them say, and tells how many
    #[arg(long)]
    robust: bool,
    #[command(flatten)]
    output: Output,
}

/// A centre and half a size.
fn cube(text: &str) -> Result<Space, String> {
    let &[x, y, z, half_size] = numbers(text)?.as_slice() else {
        return Err("four numbers with commas between are wanted".to_owned());
    };
    Ok(Space {
        centre: [x, y, z].into(),
        half_size,
        ..Space::default()
    })
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let name = input::name(&arguments.file);
    let object = arguments.object.as_deref().map(input::object).transpose()?;
    let (poses, frames) = input::poses(&arguments.file)?;
    let seconds = |frames: Vec<f64>| frames.iter().map(|frame| frame / arguments.fps).collect();
    let times: Option<Vec<f64>> = frames.map(seconds);
    let options = Options {
        tolerance: Tolerance {
            position: arguments.tolerance,
            angle: arguments.angle,
        },
        space: arguments.space.map(|space| Space {
            up: arguments.up,
            ..space
        }),
        up: arguments.up,
        robust: arguments.robust,
    };
    let mut bar = io::stderr()
        .is_terminal()
        .then(|| Bar::new(io::stderr(), Some("poses")));
    let fitted = fit(
        &poses,
        times.as_deref(),
        arguments.fps,
        &options,
        &mut |done, all| {
            if let Some(bar) = &mut bar {
                bar.update(done, all);
            }
            true
        },
    )
    .map_err(|error| vides::Error::from(error).at(name))?;
    let info = Info {
        fps: arguments.fps,
        object: object.unwrap_or_default(),
        ..Info::default()
    };
    if arguments.robust {
        let (left_out, all) = (fitted.left_out, poses.len());
        let are = if left_out == 1 { "is" } else { "are" };
        complain(&format!("{left_out} of {all} poses {are} left out"));
    }
    let document = Document::from_parts(fitted.path, info)?;
    arguments.output.write(&document)
}
