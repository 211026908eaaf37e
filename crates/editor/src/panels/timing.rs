//! How long the camera rests at the current view, and how long the section behind it takes. Its pace
//! is edited in the timeline.

use egui::Ui;
use vides_engine::limits::{MAX_FRAMES, MAX_HOLD};
use vides_engine::path::{Change, Section};

use crate::action::Action;
use crate::number::Number;
use crate::panels::parts::{Heading, share};
use crate::setup::Fold;
use crate::state::{Editor, with};
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
            .label(texts.hold)
            .hint(texts.hold_hint)
            .faint(missing)
            .unit(texts.hold_unit)
            .whole()
            .range(0.0..=f64::from(MAX_HOLD))
            .steps(1.0, 0.2)
            .show(ui, language, "hold", width);
        // Whole, and in the range of a u32.
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        let hold = hold.map(|hold| with(selection, current, |new| new.hold = hold as u32));
        actions.push(Action::enter(missing, hold));
        let Some(section) = section.filter(|section| section.frames > 0 && !missing) else {
            return;
        };
        let entry = Number::new(texts.length, section.frames as f64)
            .label(texts.length_label)
            .hint(editor.texts().speed_window.frames_hint)
            .faint(current.own.frames == 0)
            .whole()
            .range(0.0..=MAX_FRAMES as f64)
            .steps(1.0, 0.5)
            .show(ui, language, "section.frames", width);
        let entry = entry.try_map(|frames| {
            // Whole, and in the range of a u32.
            #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
            editor.with_own(selection, current, |own| own.frames = frames as u32)
        });
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
