//! The parts of [`vides_x11`] that a window uses, as a trait, so that tests need no X server.

use std::os::fd::{AsFd as _, BorrowedFd};
use std::time::Instant;

use egui::{PlatformOutput, RawInput};

use vides_raster::{Area, Target};
use vides_x11::{PanePlace, PaneWindow, PollResult, Result, Window};

/// The methods are those of [`Window`].
pub(super) trait Screen {
    fn connection(&self) -> BorrowedFd<'_>;
    fn poll(&mut self) -> Result<PollResult>;
    fn deadline(&self) -> Option<Instant>;
    fn still(&self) -> bool;
    fn take_input(&mut self) -> RawInput;
    fn target(&mut self) -> Option<Target<'_>>;
    fn present(&mut self, areas: &[Area]) -> Result<()>;
    fn take_output(&mut self, output: PlatformOutput) -> Result<()>;
    fn ask_for_clipboard(&mut self) -> Result<()>;
    fn set_title(&mut self, title: &str) -> Result<()>;
    fn raise(&mut self) -> Result<()>;
    fn place_pane(&mut self, place: Option<&PanePlace>) -> Result<bool>;
    fn pane(&self) -> Option<PaneWindow>;
    fn flush(&mut self) -> Result<()>;
}

impl Screen for Window {
    fn connection(&self) -> BorrowedFd<'_> {
        self.as_fd()
    }

    fn poll(&mut self) -> Result<PollResult> {
        self.poll()
    }

    fn deadline(&self) -> Option<Instant> {
        self.deadline()
    }

    fn still(&self) -> bool {
        self.still()
    }

    fn take_input(&mut self) -> RawInput {
        self.take_input()
    }

    fn target(&mut self) -> Option<Target<'_>> {
        self.target()
    }

    fn present(&mut self, areas: &[Area]) -> Result<()> {
        self.present(areas)
    }

    fn take_output(&mut self, output: PlatformOutput) -> Result<()> {
        self.take_output(output)
    }

    fn ask_for_clipboard(&mut self) -> Result<()> {
        self.ask_for_clipboard()
    }

    fn set_title(&mut self, title: &str) -> Result<()> {
        self.set_title(title)
    }

    fn raise(&mut self) -> Result<()> {
        self.raise()
    }

    fn place_pane(&mut self, place: Option<&PanePlace>) -> Result<bool> {
        self.place_pane(place)
    }

    fn pane(&self) -> Option<PaneWindow> {
        self.pane()
    }

    fn flush(&mut self) -> Result<()> {
        self.flush()
    }
}
