//! `vides steady`: stabilises a recorded flight.

use vides::planner::{SteadyRequest, steady};

use super::call::Call;
use super::failure::Failure;
use super::given::Numbers;
use super::input;
use super::progress::progress;

pub(super) fn run(call: &Call) -> Result<(), Failure> {
    let document = input::load(call.file())?;
    let numbers = Numbers::new(&call.tool, &call.given, &document)?;
    let request = SteadyRequest {
        period: numbers.one("period"),
        within: numbers.one("within"),
        fps: document.info().fps,
    };
    let made = steady(document.path(), &request, &mut progress("poses"))
        .map_err(|error| call.at_file(error))?;
    let report = format!(
        "{} points; places went {:.6} at most, views turned {:.3} degrees",
        made.path.points.len(),
        made.furthest,
        made.turned
    );
    call.replace(document, made.path, [report])
}
