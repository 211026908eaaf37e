//! `vides tour`: a flight that shows an object.

use clap::Args;
use vides::document::{Document, Info};
use vides::path::Up;
use vides::planner::{TourRequest, tour};

use super::call::Call;
use super::failure::{Failure, complain};
use super::given::exactly;
use super::input;
use super::moves::up;
use super::progress::progress;

#[derive(Args)]
pub(super) struct Options {
    /// Where the flight begins [default: a closed round]
    #[arg(long, value_name = "X,Y,Z", value_parser = exactly::<3>, allow_hyphen_values = true)]
    start: Option<[f64; 3]>,
    /// The up axis
    #[arg(long, value_name = "AXIS", value_parser = up(), default_value = "y")]
    up: Up,
    /// Only the views that cover it, one per frame, for photographs; no flight
    #[arg(long, conflicts_with = "seconds")]
    stills: bool,
}

pub(super) fn run(call: &Call) -> Result<(), Failure> {
    let options: Options = call.more()?;
    let name = input::name(call.file());
    let object = input::object(call.file())?;
    let mesh = object.to_mesh()?;
    let info = Info {
        object,
        ..Info::default()
    };
    let request = TourRequest {
        seconds: call.number("seconds"),
        coverage: call.number("coverage"),
        distance: call.number("distance"),
        inside: call.number("inside") != 0.0,
        start: options.start.map(Into::into),
        up: options.up,
        stills: options.stills,
        limits: info.limits,
        fps: info.fps,
        space: None,
    };
    let made =
        tour(&mesh, &request, &mut progress("pictures")).map_err(|error| call.at_file(error))?;
    for line in made.to_string().lines() {
        complain(&format!("{name}: {line}"));
    }
    call.output.write(&Document::from_parts(made.path, info)?)
}
