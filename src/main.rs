//! The command `vides`: camera paths from the shell, with and without a window.

mod command;

use std::process::ExitCode;

fn main() -> ExitCode {
    command::run()
}
