//! `vides edit`: the editor in a window, until it is closed.

use std::path::Path;

use super::{Failure, input};

pub(super) fn run(file: Option<&Path>, object: Option<&Path>) -> Result<(), Failure> {
    if file.is_some_and(input::is_standard_stream) {
        return Err(Failure::Usage(
            "the editor needs a file that it can save to, and not -".to_owned(),
        ));
    }
    Ok(vides::window::edit(file, object)?)
}
