//! The keyboard of the rows of tracks: what is selected there is removed, all is selected; and the
//! playhead goes from key to key.

use egui::{Context, Key, Modifiers};

use super::key_motion::removed;
use super::{markers, ruler, track_clipboard};
use crate::action::Action;
use crate::playing::track_rows::id;
use crate::state::Editor;
use crate::state::playing::tracks::Row;
use crate::state::scene_view::KeyAt;

/// Handles the timeline's keys before any other widget.
pub(crate) fn take_keys(editor: &mut Editor, context: &Context) {
    if context.text_edit_focused() || editor.document.in_step() {
        return;
    }
    let pressed = |modifiers, key| context.input_mut(|input| input.consume_key(modifiers, key));
    markers::take_keys(editor, context);
    let rows = context.memory(|memory| memory.has_focus(id()));
    // In the space they roll the camera.
    if !rows && !context.memory(|memory| memory.has_focus(ruler::id())) {
        return;
    }
    for (key, forward) in [(Key::Comma, false), (Key::Period, true)] {
        if pressed(Modifiers::NONE, key)
            && let Some(frame) = beside(editor, forward)
        {
            editor.scrub(frame);
        }
    }
    track_clipboard::take_keys(editor, context, rows);
    if !rows {
        return;
    }
    let keys = editor.selected_keys();
    if !keys.is_empty() && pressed(Modifiers::NONE, Key::Delete) {
        editor.act(Action::Edits(removed(&editor.document, &keys)), context);
        editor.select_keys(Vec::new());
    }
    if pressed(Modifiers::CTRL, Key::A) {
        editor.select_keys(all(editor));
    }
}

/// All keys of the selected nodes.
fn all(editor: &Editor) -> Vec<KeyAt> {
    let Some(edited) = editor.document.edited_scene() else {
        return Vec::new();
    };
    let mut keys = Vec::new();
    for node in editor.selected_nodes() {
        for of in (Row { node, track: None }).tracks(edited) {
            keys.extend((0..of.track.frames().len()).map(|key| of.key(key)));
        }
    }
    keys
}

/// The scene's frame of the nearest key before or after the playhead.
fn beside(editor: &Editor, forward: bool) -> Option<f64> {
    let at = editor.position_on_bar();
    let marks = &editor.playing.marks;
    let (first, last) = marks.range;
    let mut near: Option<f64> = None;
    let mut offer = |frame: f64| {
        let there = (first..=last).contains(&frame);
        let better = near.is_none_or(|known| (frame < known) == forward);
        if there && better && frame != at && (frame > at) == forward {
            near = Some(frame);
        }
    };
    let of_path = marks.keys.iter();
    of_path.for_each(|mark| offer(editor.document.frame_of_scene(mark.first())));
    if let Some(edited) = editor.document.edited_scene() {
        for node in editor.selected_nodes() {
            for track in edited.scene().nodes()[node].keys().tracks() {
                let frames = track.frames();
                let behind = frames.partition_point(|&key| key < at);
                let here = frames.get(behind).is_some_and(|&key| key == at);
                let next = match forward {
                    true => Some(behind + usize::from(here)),
                    false => behind.checked_sub(1),
                };
                if let Some(&frame) = next.and_then(|next| frames.get(next)) {
                    offer(frame);
                }
            }
        }
    }
    near
}
