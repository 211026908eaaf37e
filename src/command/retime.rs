//! `vides retime`: recomputes the speed profile of a path within limits.

use std::path::PathBuf;

use clap::Args;
use vides::document::Edit;
use vides::planner::{Request, retime};
use vides::tools::check::FindingKind;

use super::check::limit;
use super::failure::{Failure, complain};
use super::input;
use super::output::Output;
use super::progress::progress;

#[derive(Args)]
pub(super) struct Arguments {
    /// The path; - is standard input
    #[arg(value_name = "FILE.vid")]
    file: PathBuf,
    /// Overrides a limit of the file, as in turning=90; turning=off removes it. Used here: speed,
    /// acceleration, jerk, turning, turning-acceleration, zoom, crossing
    #[arg(long, value_name = "KIND=LIMIT", value_parser = limit)]
    limit: Vec<(FindingKind, f64)>,
    /// The first point; sections before it are unchanged
    #[arg(long, value_name = "POINT")]
    from: Option<usize>,
    /// The last point; sections after it are unchanged
    #[arg(long, value_name = "POINT")]
    to: Option<usize>,
    /// Exact duration, with the lowest peaks [default: as short as the limits allow]
    #[arg(long, value_name = "SECONDS")]
    seconds: Option<f64>,
    #[command(flatten)]
    output: Output,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let document = input::load(&arguments.file)?;
    let name = input::name(&arguments.file);
    let at_file = |error: vides::Error| Failure::from(error.at(name.clone()));
    let (info, path) = (document.info(), document.path());
    let mut limits = info.limits;
    for (kind, limit) in &arguments.limit {
        limits.set(*kind, *limit)?;
    }
    if arguments.seconds.is_some_and(|seconds| !(seconds > 0.0)) {
        return Err(Failure::Usage(
            "--seconds must be greater than 0".to_owned(),
        ));
    }
    let point = |given: Option<usize>, or: usize| match given {
        Some(0) => Err(Failure::Usage("points count from 1".to_owned())),
        Some(point) => Ok(point - 1),
        None => Ok(or),
    };
    let points = [
        point(arguments.from, 0)?,
        point(arguments.to, path.points.len() - 1)?,
    ];
    let request = Request {
        limits,
        fps: info.fps,
        points: Some(points),
        seconds: arguments.seconds.unwrap_or(0.0),
    };
    let made =
        retime(path, &request, &mut progress("rounds")).map_err(|error| at_file(error.into()))?;
    for rest in &made.rests {
        complain(&format!("{name}: {rest}"));
    }
    complain(&format!("{name}: {:.3} s", made.seconds));
    let edit = Edit::ReplacePath(Box::new(made.path));
    arguments.output.applied(document, &arguments.file, edit)
}
