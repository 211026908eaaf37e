//! Menus and their entries.

use std::borrow::Cow;

use egui::Key;

use crate::action::Action;

pub(super) struct Entry {
    pub(super) text: Cow<'static, str>,
    /// What it does, or why it cannot be picked.
    pub(super) hint: Cow<'static, str>,
    pub(super) action: Action,
    /// Picks it while the menu is open.
    pub(super) letter: Option<Key>,
    /// Also acts when it is not in the menu.
    pub(super) other_letter: Option<Key>,
    pub(super) enabled: bool,
    /// A switch, and whether it is on.
    pub(super) on: Option<bool>,
    /// A line stands above it.
    pub(super) apart: bool,
    /// Of it and those below, above it.
    pub(super) heading: &'static str,
    /// It begins another column.
    pub(super) beside: bool,
}

impl Entry {
    pub(super) fn new(text: &'static str, hint: &'static str, action: impl Into<Action>) -> Self {
        Self {
            text: Cow::Borrowed(text),
            hint: Cow::Borrowed(hint),
            action: action.into(),
            letter: None,
            other_letter: None,
            enabled: true,
            on: None,
            apart: false,
            heading: "",
            beside: false,
        }
    }

    pub(super) const fn letter(mut self, letter: Key) -> Self {
        self.letter = Some(letter);
        self
    }

    /// Otherwise it is disabled, and its hint says why.
    pub(super) fn only_if(mut self, possible: bool, why_not: &'static str) -> Self {
        if !possible {
            self.enabled = false;
            self.hint = Cow::Borrowed(why_not);
        }
        self
    }

    pub(super) const fn on(mut self, on: bool) -> Self {
        self.on = Some(on);
        self
    }

    pub(super) const fn apart(mut self) -> Self {
        self.apart = true;
        self
    }
}

pub(super) struct Menu {
    pub(super) title: &'static str,
    /// Opens the menu with Alt.
    pub(super) letter: Key,
    pub(super) entries: Vec<Entry>,
}
