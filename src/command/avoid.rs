//! `vides avoid`: moves a path away from an object.

use vides::planner::{AvoidRequest, avoid_object};

use super::call::Call;
use super::failure::Failure;
use super::given::Numbers;
use super::input;
pub(super) use super::input::ObjectOption as Options;
use super::progress::progress;

pub(super) fn run(call: &Call) -> Result<(), Failure> {
    let document = input::load(call.file())?;
    let object = call.more::<Options>()?.mesh()?;
    let object = document.solid(object.as_ref());
    let object = object.map_err(|error| call.at_file(error))?;
    let numbers = Numbers::new(&call.tool, &call.given, &document)?;
    let request = AvoidRequest {
        clearance: numbers.one("clearance"),
        radius: numbers.one("radius"),
    };
    let made = avoid_object(document.path(), &object, &request, &mut progress("places"))
        .map_err(|error| call.at_file(error))?;
    let mut report: Vec<_> = made.parts.iter().map(ToString::to_string).collect();
    if report.is_empty() {
        report.push("the way is clear as it is".to_owned());
    }
    call.replace(document, made.path, report)
}
