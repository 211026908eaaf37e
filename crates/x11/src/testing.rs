//! X servers for tests, each of its own and gone with the test.

use std::io::{BufRead, BufReader};
use std::process::{Child, Command, Stdio};

#[path = "../../../tests/common/until.rs"]
mod waiting;
pub(crate) use waiting::{PATIENCE, until};

/// A running Xvfb.
pub(super) struct Server {
    process: Child,
    display: String,
}

impl Server {
    /// Starts one; it chooses a display's number that is free.
    pub(super) fn start() -> Self {
        Self::with(&[])
    }

    /// Starts one with more arguments.
    pub(super) fn with(arguments: &[&str]) -> Self {
        let mut process = Command::new("Xvfb")
            // Without repetition: on a busy machine a key that xdotool presses
            // may stay down for long.
            .args(["-displayfd", "1", "-nolisten", "tcp", "-noreset", "-r"])
            .args(arguments)
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .expect("Xvfb");
        let mut number = String::new();
        let output = process.stdout.take().unwrap();
        BufReader::new(output).read_line(&mut number).unwrap();
        let display = format!(":{}", number.trim());
        Self { process, display }
    }

    /// Its process.
    pub(super) fn process(&self) -> i32 {
        self.process.id().cast_signed()
    }

    /// The display's name.
    pub(super) fn display(&self) -> &str {
        &self.display
    }

    /// A program that shall run on this display.
    pub(super) fn command(&self, program: &str) -> Command {
        let mut command = Command::new(program);
        command
            .env("DISPLAY", &self.display)
            .env("XAUTHORITY", "/dev/null")
            .env_remove("WAYLAND_DISPLAY");
        command
    }

    /// Runs a program on this display and waits for it.
    pub(super) fn run(&self, program: &str, arguments: &[&str]) {
        let output = self.command(program).args(arguments).output();
        let output = output.unwrap_or_else(|error| panic!("{program}: {error}"));
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{program} {arguments:?}: {said}");
    }
}

impl Server {
    /// Kills it.
    pub(super) fn end(&mut self) {
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        self.end();
    }
}
