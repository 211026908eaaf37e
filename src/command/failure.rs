//! Why the command ends early, and what it tells.

use std::io::{self, Write};

use vides::error::{EngineError, reason};
use vides::property::steers;

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
        match error.is_input() {
            true => Self::Usage(error.to_string()),
            false => Self::Input(error.to_string()),
        }
    }
}

impl From<vides::formats::Error> for Failure {
    fn from(error: vides::formats::Error) -> Self {
        match error {
            vides::formats::Error::Document(error) => error.into(),
            other => Self::Input(other.to_string()),
        }
    }
}

impl From<vides::window::Error> for Failure {
    fn from(error: vides::window::Error) -> Self {
        Self::Input(error.to_string())
    }
}

pub(super) fn print(text: impl AsRef<[u8]>) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    out.write_all(text.as_ref())
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

/// A failing standard error cannot be reported.
pub(super) fn complain(message: &str) {
    let _ = writeln!(io::stderr(), "vides: {}", lines(message));
}

/// A text for one line of a terminal: what would steer it is replaced.
pub(super) fn one_line(text: &str) -> String {
    visible(text, steers)
}

/// A text of several lines for a terminal.
pub(super) fn lines(text: &str) -> String {
    visible(text, |c| c != '\n' && steers(c))
}

fn visible(text: &str, hidden: impl Fn(char) -> bool) -> String {
    let show = |c: char| match hidden(c) {
        true => char::REPLACEMENT_CHARACTER,
        false => c,
    };
    text.chars().map(show).collect()
}

/// A text in JSON, all of whose structure is ASCII.
pub(super) fn json(text: &str) -> String {
    let mut json = String::new();
    for c in text.chars() {
        match c != '\n' && steers(c) {
            true => json.push_str(&format!("\\u{:04x}", u32::from(c))),
            false => json.push(c),
        }
    }
    json
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
        assert_eq!(
            one_line("a\u{202e}b\u{2066}c\u{2028}d"),
            "a\u{fffd}b\u{fffd}c\u{fffd}d"
        );
        assert_eq!(lines("a\u{202e}\nb\t"), "a\u{fffd}\nb\u{fffd}");
    }
}
