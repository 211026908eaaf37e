//! `vides steady`: stabilises a recorded flight.

use std::path::PathBuf;

use clap::Args;
use vides::document::Edit;
use vides::planner::{SteadyRequest, steady};

use super::failure::{Failure, complain};
use super::input;
use super::output::Output;
use super::progress::progress;

#[derive(Args)]
pub(super) struct Arguments {
    /// The path; - is standard input
    #[arg(value_name = "FILE.vid")]
    file: PathBuf,
    /// Cut-off period: motion of this period is halved, faster motion is removed
    #[arg(long, value_name = "SECONDS")]
    seconds: f64,
    /// Maximum distance any position may move
    #[arg(long, value_name = "LENGTH")]
    within: Option<f64>,
    #[command(flatten)]
    output: Output,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    if arguments.within.is_some_and(|within| !(within > 0.0)) {
        return Err(Failure::Usage("--within must be greater than 0".to_owned()));
    }
    let document = input::load(&arguments.file)?;
    let name = input::name(&arguments.file);
    let request = SteadyRequest {
        seconds: arguments.seconds,
        within: arguments.within.unwrap_or(0.0),
        fps: document.info().fps,
    };
    let made = steady(document.path(), &request, &mut progress("poses"))
        .map_err(|error| vides::Error::from(error).at(name.clone()))?;
    complain(&format!(
        "{name}: {} points; places went {:.6} at most, views turned {:.3} degrees",
        made.path.points.len(),
        made.furthest,
        made.turned
    ));
    let edit = Edit::ReplacePath(Box::new(made.path));
    arguments.output.applied(document, &arguments.file, edit)
}
