//! A number that is typed while the mouse moves something.

use egui::{Event, Key};

/// Most characters that it keeps.
const MOST: usize = 24;

#[derive(Clone, Debug, Default)]
pub(crate) struct Typed(String);

impl Typed {
    /// Handles a digit, a sign or Backspace; returns whether that changed anything.
    pub(crate) fn take(&mut self, event: &Event) -> bool {
        match event {
            Event::Key {
                key: Key::Backspace,
                pressed: true,
                ..
            } => self.0.pop().is_some(),
            // With Ctrl a digit is no text.
            Event::Key {
                key,
                pressed: true,
                modifiers,
                ..
            } if modifiers.ctrl => match key.symbol_or_name() {
                digit if digit.len() == 1 && digit.as_bytes()[0].is_ascii_digit() => {
                    self.0.push_str(digit);
                    self.0.truncate(MOST);
                    true
                }
                _ => false,
            },
            Event::Text(text) => {
                let before = self.0.len();
                let signs = text
                    .chars()
                    .filter(|c| matches!(c, '0'..='9' | '.' | ',' | '-' | '+'));
                self.0.extend(signs);
                self.0.truncate(MOST);
                self.0.len() != before
            }
            _ => false,
        }
    }

    /// As it was typed.
    pub(crate) fn text(&self) -> &str {
        &self.0
    }

    /// Whether it begins with a sign.
    pub(crate) fn has_sign(&self) -> bool {
        self.0.starts_with(['-', '+'])
    }

    /// The number, if it is one by now.
    pub(crate) fn number(&self) -> Option<f64> {
        let number = self.0.replace(',', ".").parse().ok();
        number.filter(|number: &f64| number.is_finite())
    }
}
