//! What tables and the object of `vides info` tell alike.

use std::fmt::Write;

use vides::document::Info;
use vides::limits::ZOOM_UNIT;
use vides::path::{CameraPath, Change, Section};

use super::failure::one_line;

/// Title and comment.
pub(super) fn heading(info: &Info) -> String {
    let mut text = String::new();
    // Writing into a string cannot fail.
    if !info.title.is_empty() {
        let _ = writeln!(text, "{}\n", one_line(&info.title));
    }
    for line in info.comment.trim_end().lines() {
        let _ = writeln!(text, "  {}", one_line(line));
    }
    if !info.comment.trim_end().is_empty() {
        text.push('\n');
    }
    text
}

/// How the camera turns, and how the zoom runs, as in a file.
pub(super) const fn modes(path: &CameraPath) -> [&'static str; 2] {
    [path.orientation_mode.name(), path.zoom_mode.name()]
}

pub(super) fn last_of(first: i64, frames: usize) -> i64 {
    // Both are far below 2⁶³.
    first + frames as i64 - 1
}

/// What changes in a section, by how much and in which unit.
pub(super) fn changed(section: &Section, half_size: f64) -> (&'static str, f64, &'static str) {
    let amount = section.amount;
    match section.change {
        Change::Position => ("position", half_size * amount, ""),
        Change::View => ("view", 180.0 * amount, "degrees"),
        Change::Roll => ("roll", 90.0 * amount, "degrees"),
        Change::Zoom => ("zoom", ZOOM_UNIT * amount, "mm"),
        Change::Nothing => ("nothing", 0.0, ""),
    }
}
