//! What menus, shortcuts and buttons do, each under one name.

use super::setup::Theme;
use super::state::{Editor, Request};
use super::windows::{self, ColourWindow, CurveWindow, DisplayWindow, SpeedWindow};

/// Something that a menu entry, a key or a button stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Action {
    /// Close the window.
    Quit,
    /// Take the last step back.
    Undo,
    /// Do it again.
    Redo,
    /// Hand the poses over to the host.
    HandOver,
    /// Open the curve window.
    Curve,
    /// Open the speed-curve window.
    SpeedCurve,
    /// Open the colour window.
    Colours,
    /// Open the display window.
    Display,
    /// Light or dark.
    Theme(Theme),
}

impl Editor {
    /// Does it.
    pub(super) fn act(&mut self, action: Action, context: &egui::Context) {
        self.message = None;
        match action {
            Action::Quit => self.ask_to_close(),
            Action::Undo => {
                self.document.undo();
            }
            Action::Redo => {
                self.document.redo();
            }
            Action::HandOver => self.requests.push(Request::HandOver),
            Action::Curve => windows::open::<CurveWindow>(self, context),
            Action::SpeedCurve => windows::open::<SpeedWindow>(self, context),
            Action::Colours => windows::open::<ColourWindow>(self, context),
            Action::Display => windows::open::<DisplayWindow>(self, context),
            Action::Theme(theme) => self.setup.theme = theme,
        }
    }
}
