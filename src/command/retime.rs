//! `vides retime`: recomputes the speed profile of a path within limits.

use vides::planner::{Request, retime};

use super::call::Call;
pub(super) use super::check::LimitOption as Options;
use super::failure::Failure;
use super::given::Numbers;
use super::input;
use super::progress::progress;

pub(super) fn run(call: &Call) -> Result<(), Failure> {
    let document = input::load(call.file())?;
    let numbers = Numbers::new(&call.tool, &call.given, &document)?;
    let request = Request {
        limits: call.more::<Options>()?.over(&document)?,
        fps: document.info().fps,
        points: Some([numbers.point("first"), numbers.point("last")]),
        seconds: numbers.one("seconds"),
    };
    let made = retime(document.path(), &request, &mut progress("rounds"))
        .map_err(|error| call.at_file(error))?;
    let rests = made.rests.iter().map(ToString::to_string);
    let report = rests.chain([format!("{:.3} s", made.seconds)]);
    call.replace(document, made.path, report.collect::<Vec<_>>())
}
