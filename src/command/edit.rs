//! `vides edit`: the editor in a window, until it is closed.

use std::path::Path;

use super::failure::Failure;
use super::input;

pub(super) fn run(file: Option<&Path>, object: Option<&Path>) -> Result<(), Failure> {
    if file.is_some_and(input::is_standard_stream) {
        return Err(Failure::Usage(
            "the editor needs a file that it can save to, and not -".to_owned(),
        ));
    }
    vides::window::edit(file, object).map_err(|error| match (&error, file) {
        (vides::window::Error::Document(_), Some(file)) => input::refused(file, &error),
        _ => error.into(),
    })
}
