//! What the window shows and what the user does in it (thesis chapters 6 and 7.3, Anhang A), drawn
//! with egui.
//!
//! Every change of the path is an edit of [`vides_document`], so that it can be undone. What leaves
//! the window (poses for the host, closing) is a [`Request`] to the program that runs the editor.
//!
//! It knows no X, no C and no host, and has no unsafe code, so that all of it runs in tests without
//! a screen.

#![forbid(unsafe_code)]
// Standard output is the host's.
#![cfg_attr(not(test), warn(clippy::print_stdout))]

mod action;
mod actions;
mod background;
mod clipboard;
mod entry;
mod files;
mod frame;
mod host;
#[cfg(any(test, fuzzing))]
pub mod hostile;
mod keys;
mod length;
mod menu;
mod number;
mod obstacles;
mod panels;
mod playing;
mod points_list;
mod row;
mod scene_view;
mod selected;
mod setup;
mod space;
mod state;
mod texts;
mod theme;
mod typed;
mod windows;

#[cfg(test)]
mod screenshots;
#[cfg(test)]
mod tests;

pub use background::Start;
pub use files::Folders;
pub use host::{Date, Program, Warning, Warnings, begin_at, check_view};
pub use state::host::{HostPane, PlayheadState};
pub use state::{Editor, HostView, Options, Reason, Request};
pub use texts::Language;
