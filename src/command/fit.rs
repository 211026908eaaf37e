//! `vides fit`: recorded poses become a path of few points.

use std::io::{self, IsTerminal};
use std::path::PathBuf;

use clap::Args;
use vides::document::{Document, Info};
use vides::tools::fit::{Tolerance, fit};

use super::output::Output;
use super::progress::Bar;
use super::{Failure, input};

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
    #[command(flatten)]
    output: Output,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let name = input::name(&arguments.file);
    let object = arguments.object.as_deref().map(input::object).transpose()?;
    let (poses, frames) = input::poses(&arguments.file)?;
    let seconds = |frames: Vec<f64>| frames.iter().map(|frame| frame / arguments.fps).collect();
    let times: Option<Vec<f64>> = frames.map(seconds);
    let tolerance = Tolerance {
        position: arguments.tolerance,
        angle: arguments.angle,
    };
    let mut bar = io::stderr()
        .is_terminal()
        .then(|| Bar::new(io::stderr(), Some("poses")));
    let path = fit(
        &poses,
        times.as_deref(),
        arguments.fps,
        tolerance,
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
    arguments.output.write(&Document::from_parts(path, info)?)
}
