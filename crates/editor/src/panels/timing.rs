//! How long the camera rests at the current view, and how long the section behind it takes. Its pace
//! is edited in the timeline.

use egui::Ui;
use vides_engine::path::{Change, Section};

use crate::action::Action;
use crate::number::Number;
use crate::panels::parts::{Heading, share};
use crate::setup::Fold;
use crate::state::Editor;
use crate::texts::fill;

pub(super) fn show(editor: &Editor, ui: &mut Ui, actions: &mut Vec<Action>) {
    let texts = &editor.texts().timing;
    let Some(shown) = editor.shown() else { return };
    let section = section(editor);
    let words = section.map_or_else(|| texts.end.to_owned(), |section| frames(editor, section));
    let heading = Heading {
        editor,
        fold: Fold::Timing,
        text: texts.heading,
        remark: &words,
    };
    if !heading.show(ui, actions).0 {
        return;
    }
    let missing = shown.has_no_orientation();
    let (selection, current) = (shown.at, &shown.orientation);
    let language = editor.language();
    let width = share(ui, 2);
    ui.horizontal(|ui| {
        let hold = Number::new(texts.hold, f64::from(current.hold))
            .of_view("hold_frames")
            .label(texts.hold)
            .hint(texts.hold_hint)
            .faint(missing)
            .unit(texts.hold_unit)
            .show(ui, language, "hold", width);
        let hold = hold.try_map(|hold| editor.with_number(selection, current, "hold_frames", hold));
        actions.push(Action::enter(missing, hold));
        let Some(section) = section.filter(|section| section.frames > 0 && !missing) else {
            return;
        };
        let entry = Number::new(texts.length, section.frames as f64)
            .of_view("frames")
            .label(texts.length_label)
            .hint(editor.texts().speed_window.frames_hint)
            .faint(current.own.frames == 0)
            .show(ui, language, "section.frames", width);
        let entry =
            entry.try_map(|frames| editor.with_number(selection, current, "frames", frames));
        actions.push(Action::Enter(entry));
    });
}

/// The section of the current view; an open path's last one begins none.
fn section(editor: &Editor) -> Option<Section> {
    let selection = editor.document.selection();
    let found = editor.document.timeline(|timeline| {
        let section = timeline.section_from(selection.point, selection.orientation)?;
        Some(timeline.section(section))
    });
    found.ok().flatten()
}

/// Frames and seconds of a section.
fn frames(editor: &Editor, section: Section) -> String {
    let texts = &editor.texts().timing;
    if section.change == Change::Nothing {
        return texts.no_frames.to_owned();
    }
    let fps = editor.document.info().fps;
    let seconds = editor.language().number(section.frames as f64 / fps, 2);
    let text = if section.frames == 1 {
        texts.one_frame
    } else {
        texts.frames
    };
    fill(text, &[&section.frames, &seconds])
}
