//! Why the command ends early, and what it tells.

use std::io::{self, Write};

use vides::error::{EngineError, reason};

/// Why the command ends early or not with success.
pub(super) enum Failure {
    /// The arguments do not fit together.
    Usage(String),
    /// A file is invalid, or the system refused.
    Input(String),
    /// All was done, and a check found something.
    Findings,
    /// The reader of our standard output closed it (`vides … | head`).
    ReaderGone,
}

impl From<EngineError> for Failure {
    fn from(error: EngineError) -> Self {
        vides::Error::from(error).into()
    }
}

impl From<vides::Error> for Failure {
    fn from(error: vides::Error) -> Self {
        Self::Input(error.to_string())
    }
}

impl From<vides::formats::Error> for Failure {
    fn from(error: vides::formats::Error) -> Self {
        Self::Input(error.to_string())
    }
}

impl From<vides::window::Error> for Failure {
    fn from(error: vides::window::Error) -> Self {
        Self::Input(error.to_string())
    }
}

pub(super) fn print(text: &str) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    out.write_all(text.as_bytes())
        .and_then(|()| out.flush())
        .map_err(|error| output_failed(&error))
}

pub(super) fn output_failed(error: &io::Error) -> Failure {
    if error.kind() == io::ErrorKind::BrokenPipe {
        Failure::ReaderGone
    } else {
        Failure::Input(format!("standard output: {}", reason(error)))
    }
}

/// Nobody could be told of a failing standard error.
pub(super) fn complain(message: &str) {
    let _ = writeln!(io::stderr(), "vides: {message}");
}

/// A text for one line of a terminal: control characters are replaced.
pub(super) fn one_line(text: &str) -> String {
    let show = |c: char| {
        if c.is_control() {
            char::REPLACEMENT_CHARACTER
        } else {
            c
        }
    };
    text.chars().map(show).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_message_stays_on_its_line() {
        assert_eq!(
            one_line("point \u{1b}[2J\n3 – ü"),
            "point \u{fffd}[2J\u{fffd}3 – ü"
        );
    }
}
