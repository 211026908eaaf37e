//! What is dragged in the rows of tracks: keys in time, or copies of them; the end of a selection,
//! which scales its time; the bar of a path; a box that selects.
//!
//! Each motion starts from the original keys, so that keys that were passed over
//! return, and it is one step.

use egui::{CursorIcon, Pos2, Rect, pos2};
use vides_document::Edit;
use vides_engine::scene::Part;

use super::drag::{Moves, PARTS, Pass, To, begun, select_box};
use crate::action::{Action, TimeAction};
use crate::entry::Entry;
use crate::playing::track_dots::keys_between;
use crate::playing::track_rows::{Hit, Shown, bar_of, channel_name, frame_of};
use crate::state::Editor;
use crate::state::playing::drag::Drag;
use crate::state::playing::tracks::{BarDrag, Change, Held, KeyMotion, KeysDrag, Numbers};
use crate::state::scene_view::KeyAt;
use crate::texts::fill;

impl KeyMotion {
    /// Begins with keys that stay.
    pub(super) const fn none(keys: Vec<KeyAt>) -> Self {
        Self::new(keys, Change::By(0.0), false, Numbers::Stay)
    }

    /// Turns into another; what is to be done, if that is another.
    pub(super) fn turn_into(&mut self, wanted: Self) -> Option<Action> {
        let same = wanted == *self || wanted.is_nothing() && self.is_nothing();
        (!same).then(|| {
            *self = wanted.clone();
            Action::Time(TimeAction::MoveKeys(Box::new(wanted)))
        })
    }
}

/// What keys are called together, or the one.
fn name_of(editor: &Editor, keys: &[KeyAt]) -> String {
    let texts = &editor.texts().timeline;
    match (keys, editor.document.edited_scene()) {
        ([one], Some(edited)) => {
            let node = edited.scene().nodes().get(one.node);
            let node = node.map_or("", |node| node.name.as_str());
            let channel = channel_name(editor, &one.channel);
            fill(texts.channel_of, &[&channel, &node])
        }
        (all, _) => fill(texts.keys_selected, &[&all.len()]),
    }
}

/// Takes keys; `about`: their time is scaled, as this frame stays.
fn keys_drag(
    editor: &Editor,
    keys: Vec<KeyAt>,
    (from, about): (f64, Option<f64>),
    at: Pos2,
) -> Held {
    let name = name_of(editor, &keys);
    let done = KeyMotion::none(keys);
    let of = KeysDrag { about, done };
    Held::Keys(Drag::new(of, name, from, at))
}

impl Moves for KeysDrag {
    fn go_on(&mut self, _pass: &Pass<'_>, to: &To) -> Option<Action> {
        let from = to.from;
        let (change, copies) = match self.about {
            None => (Change::By(to.frame - from), to.copies),
            Some(about) => {
                let least = if to.fine { 1.0 / PARTS } else { 1.0 };
                let to = match from < about {
                    true => to.frame.min(about - least),
                    false => to.frame.max(about + least),
                };
                (Change::Scale { about, from, to }, false)
            }
        };
        let keys = self.done.keys.clone();
        let wanted = KeyMotion::new(keys, change, copies, Numbers::Stay);
        self.done.turn_into(wanted)
    }

    fn at(&self, _editor: &Editor, from: f64) -> f64 {
        self.done.frame_of(from)
    }

    fn copies(&self) -> bool {
        self.done.copies()
    }
}

fn bar_drag(editor: &Editor, node: usize, at: Pos2) -> Option<Held> {
    let edited = editor.document.edited_scene()?;
    let (from, _) = bar_of(editor, edited, node)?;
    let of = edited.scene().nodes().get(node)?;
    let scene = editor.document.scene().ok()?;
    let drag = BarDrag {
        node,
        at: from,
        beyond: of.path()?.extrapolation(),
        free: scene.pins().iter().all(|pin| pin.node != node),
    };
    let name = fill(editor.texts().timeline.path_of, &[&of.name]);
    Some(Held::Bar(Drag::new(drag, name, from, at)))
}

impl Moves for BarDrag {
    fn go_on(&mut self, _pass: &Pass<'_>, to: &To) -> Option<Action> {
        if to.frame == self.at || !self.free {
            return None;
        }
        self.at = to.frame;
        let edit = Edit::Part(Box::new(Part::Start {
            node: self.node,
            start_frame: to.frame,
            beyond: self.beyond,
        }));
        Some(Action::Enter(Entry::Drag(edit)))
    }

    fn at(&self, _editor: &Editor, _from: f64) -> f64 {
        self.at
    }

    fn more(&self, editor: &Editor) -> Vec<String> {
        let pinned = editor.texts().timeline.is_pinned;
        (!self.free)
            .then(|| pinned.to_owned())
            .into_iter()
            .collect()
    }

    fn cursor(&self) -> CursorIcon {
        match self.free {
            true => CursorIcon::Grabbing,
            false => CursorIcon::NotAllowed,
        }
    }
}

/// Takes what is under the pointer when a drag begins, and goes on with what is held.
pub(super) fn show(held: &mut Held, pass: &Pass<'_>, shown: &Shown<'_>, actions: &mut Vec<Action>) {
    if let Some(at) = begun(pass.ui, pass.response) {
        pass.response.request_focus();
        *held = taken(pass, shown, at, actions);
    }
    let ended = match held {
        Held::Nothing => false,
        Held::Keys(drag) => {
            let end = drag.go_on(pass, actions);
            if end == Some(Entry::Cancel) {
                actions.push(Action::SelectKeys(drag.of.done.keys.clone()));
            }
            end.is_some()
        }
        Held::Bar(drag) => drag.go_on(pass, actions).is_some(),
        Held::Box { x, row, besides } => {
            let pointer = pass.response.interact_pointer_pos();
            if let Some(pointer) = pointer.filter(|_| pass.response.dragged()) {
                let from = pos2(*x, shown.top + *row * super::track_rows::ROW);
                boxed(pass, shown, (from, pointer, besides), actions);
            }
            !pass.response.dragged()
        }
    };
    if ended {
        *held = Held::Nothing;
    }
}

fn taken(pass: &Pass<'_>, shown: &Shown<'_>, at: Pos2, actions: &mut Vec<Action>) -> Held {
    let editor = pass.editor;
    let drag = match shown.hit(editor, at) {
        Hit::Nothing => {
            let row = shown.number_at(at.y);
            let adds = pass
                .ui
                .input(|input| input.modifiers.ctrl || input.modifiers.shift);
            let besides = match adds {
                true => shown.selected.clone(),
                false => Vec::new(),
            };
            return Held::Box {
                x: at.x,
                row,
                besides,
            };
        }
        Hit::Bar(node) => bar_drag(editor, node, at),
        Hit::End { first } => shown.ends.map(|(low, high)| {
            let (from, about) = if first { (low, high) } else { (high, low) };
            keys_drag(editor, shown.selected.clone(), (from, Some(about)), at)
        }),
        Hit::Keys(keys) => {
            let edited = editor.document.edited_scene();
            let from = edited.and_then(|edited| frame_of(edited, keys.first()?));
            let all = match keys.iter().all(|key| shown.selected.contains(key)) {
                true => shown.selected.clone(),
                false => {
                    actions.push(Action::SelectKeys(keys.clone()));
                    keys
                }
            };
            from.map(|from| keys_drag(editor, all, (from, None), at))
        }
    };
    let Some(drag) = drag else {
        return Held::Nothing;
    };
    actions.push(Action::Enter(Entry::Begin));
    drag
}

/// Selects the keys in a box, and these besides.
fn boxed(
    pass: &Pass<'_>,
    shown: &Shown<'_>,
    (from, to, besides): (Pos2, Pos2, &[KeyAt]),
    actions: &mut Vec<Action>,
) {
    let place = Rect::from_two_pos(from, to);
    select_box(pass.ui, shown.ground, place);
    let Some(edited) = pass.editor.document.edited_scene() else {
        return;
    };
    let ends = [place.left(), place.right()].map(|x| shown.axis.frame(x));
    let mut keys = Vec::new();
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    let number = |y: f32| shown.number_at(y).max(0.0) as usize;
    let rows = number(place.top())..=number(place.bottom());
    for row in shown.rows.iter().take(rows.end() + 1).skip(*rows.start()) {
        if let Some(of) = row.of(edited) {
            keys.extend(keys_between(of.track, ends).map(|key| of.key(key)));
        }
    }
    let others = besides.iter().filter(|at| !keys.contains(at));
    let others: Vec<KeyAt> = others.cloned().collect();
    keys.extend(others);
    if keys != shown.selected {
        actions.push(Action::SelectKeys(keys));
    }
}
