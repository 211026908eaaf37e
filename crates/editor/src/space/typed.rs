//! A number that is typed while the mouse moves something.

use egui::{Event, Key};

/// Most characters that it keeps.
const MOST: usize = 24;

#[derive(Clone, Debug, Default)]
pub(super) struct Typed(String);

impl Typed {
    /// Handles a digit, a sign or Backspace; returns whether that changed anything.
    pub(super) fn take(&mut self, event: &Event) -> bool {
        match event {
            Event::Key {
                key: Key::Backspace,
                pressed: true,
                ..
            } => self.0.pop().is_some(),
            Event::Text(text) => {
                let before = self.0.len();
                let signs = text
                    .chars()
                    .filter(|c| matches!(c, '0'..='9' | '.' | ',' | '-'));
                self.0.extend(signs);
                self.0.truncate(MOST);
                self.0.len() != before
            }
            _ => false,
        }
    }

    /// The number, if it is one by now.
    pub(super) fn number(&self) -> Option<f64> {
        let number = self.0.replace(',', ".").parse().ok();
        number.filter(|number: &f64| number.is_finite())
    }
}
