//! What is dragged in the rows of tracks: keys in time, or copies of them; the end of a selection,
//! which scales its time; the bar of a path; a box that selects.
//!
//! Each motion starts from the original keys, so that keys that were passed over
//! return, and it is one step.

use egui::{CursorIcon, Key, Modifiers, Pos2, Rect, Response, Stroke, StrokeKind, Ui, pos2};
use vides_document::Edit;
use vides_engine::scene::Part;

use super::key_row::{FINE, bubble};
use super::track_time::Time;
use crate::action::{Action, TimeAction};
use crate::entry::Entry;
use crate::playing::track_rows::{Hit, Shown, bar_of, channel_name, frame_of};
use crate::state::Editor;
use crate::state::playing::tracks::{BarDrag, Change, Held, KeyMotion, KeysDrag, Numbers, Way};
use crate::state::scene_view::KeyAt;
use crate::texts::fill;
use crate::theme;

/// Parts of a frame to which keys are moved with Shift.
const PARTS: f64 = 10.0;

impl Way {
    pub(super) fn begin(pointer: f32) -> Self {
        Self {
            pointer,
            ..Self::default()
        }
    }

    /// The frame to which `from` moves: a whole one, or a tenth of one with Shift.
    pub(super) fn go_on(
        &mut self,
        editor: &Editor,
        ui: &Ui,
        response: &Response,
        (time, from): (&Time, f64),
    ) -> f64 {
        let fine = ui.input(|input| input.modifiers.shift);
        if let Some(pointer) = response.interact_pointer_pos() {
            let share = if fine { FINE } else { 1.0 };
            let each = time.axis.frames_per_point();
            self.gone += f64::from(pointer.x - self.pointer) * each * share;
            self.pointer = pointer.x;
        }
        ui.input_mut(|input| input.events.retain(|event| !self.typed.take(event)));
        let to = self.wanted(editor, from);
        match fine {
            true => (to * PARTS).round() / PARTS,
            // What does not move stays where it is, between two frames, too.
            false if self.gone == 0.0 && self.typed.text().is_empty() => from,
            false => to.round(),
        }
    }

    /// Whether copies are dragged: with Ctrl, which stays so while a number is typed.
    fn copies(&mut self, held: Modifiers) -> bool {
        if self.typed.text().is_empty() {
            self.copies = held.ctrl || held.command;
        }
        self.copies
    }

    fn wanted(&self, editor: &Editor, from: f64) -> f64 {
        let Some(number) = self.typed.number() else {
            return from + self.gone;
        };
        let info = editor.document.info();
        // A sign: from where it stood.
        match (self.typed.has_sign(), editor.setup.ruler_frames) {
            (true, true) => from + number,
            (true, false) => from + number * info.fps,
            (false, true) => number - f64::from(info.first_frame) + 1.0,
            (false, false) => number * info.fps + 1.0,
        }
    }

    /// Where it is, in numbers, above the ruler.
    pub(super) fn tell(
        &self,
        editor: &Editor,
        ui: &Ui,
        name: &str,
        told: (&Time, f64, f64),
        top: f32,
    ) {
        let (time, from, at) = told;
        let words = self.words(editor, name, (from, at));
        bubble(ui, pos2(time.x(at), top), words);
    }

    pub(super) fn words(&self, editor: &Editor, name: &str, (from, at): (f64, f64)) -> String {
        let (language, info) = (editor.language(), editor.document.info());
        let second = language.number((at - 1.0) / info.fps, 2);
        let by = (at - from) / info.fps;
        let sign = if by > 0.0 { "+" } else { "" };
        let by = format!("{sign}{}", language.number(by, 2));
        let frame = at - 1.0 + f64::from(info.first_frame);
        let frame = match frame.fract() == 0.0 {
            true => language.number(frame, 0),
            false => language.number(frame, 1),
        };
        let texts = &editor.texts().timeline;
        let mut lines = fill(texts.moved, &[&name, &second, &by, &frame]);
        if !self.typed.text().is_empty() {
            let unit = if editor.setup.ruler_frames { "" } else { " s" };
            lines += &format!("\n› {}{unit}", self.typed.text());
        }
        lines
    }
}

impl KeysDrag {
    fn new(keys: Vec<KeyAt>, from: f64, about: Option<f64>, pointer: f32) -> Self {
        let done = KeyMotion::new(keys.clone(), Change::By(0.0), false, Numbers::Stay);
        Self {
            keys,
            from,
            about,
            way: Way::begin(pointer),
            done,
        }
    }

    /// What is to be done, if that is another.
    fn go_on(
        &mut self,
        editor: &Editor,
        ui: &Ui,
        response: &Response,
        time: &Time,
    ) -> Option<Action> {
        let held = ui.input(|input| input.modifiers);
        let to = self.way.go_on(editor, ui, response, (time, self.from));
        let (to, copies) = match self.about {
            None => (Change::By(to - self.from), self.way.copies(held)),
            Some(about) => {
                let least = if held.shift { 1.0 / PARTS } else { 1.0 };
                let from = self.from;
                let to = match from < about {
                    true => to.min(about - least),
                    false => to.max(about + least),
                };
                (Change::Scale { about, from, to }, false)
            }
        };
        let wanted = KeyMotion::new(self.keys.clone(), to, copies, Numbers::Stay);
        let same = wanted == self.done || wanted.is_nothing() && self.done.is_nothing();
        (!same).then(|| {
            self.done = wanted.clone();
            Action::Time(TimeAction::MoveKeys(Box::new(wanted)))
        })
    }

    fn tell(&self, editor: &Editor, ui: &Ui, time: &Time, top: f32) {
        let texts = &editor.texts().timeline;
        let name = match (&self.keys[..], editor.document.edited_scene()) {
            ([one], Some(edited)) => {
                let node = edited.scene().nodes().get(one.node);
                let node = node.map_or("", |node| node.name.as_str());
                fill(
                    texts.channel_of,
                    &[&channel_name(editor, &one.channel), &node],
                )
            }
            (all, _) => fill(texts.keys_selected, &[&all.len()]),
        };
        let name = match self.done.copies() && !self.done.is_nothing() {
            true => fill(texts.copy_of, &[&name]),
            false => name,
        };
        let at = self.done.frame_of(self.from);
        self.way.tell(editor, ui, &name, (time, self.from, at), top);
    }
}

impl BarDrag {
    fn new(editor: &Editor, node: usize, pointer: f32) -> Option<Self> {
        let edited = editor.document.edited_scene()?;
        let (from, _) = bar_of(editor, edited, node)?;
        let path = edited.scene().nodes().get(node)?.path()?;
        let scene = editor.document.scene().ok()?;
        let free = scene.pins().iter().all(|pin| pin.node != node);
        Some(Self {
            node,
            from,
            at: from,
            beyond: path.extrapolation(),
            free,
            way: Way::begin(pointer),
        })
    }

    fn go_on(
        &mut self,
        editor: &Editor,
        ui: &Ui,
        response: &Response,
        time: &Time,
    ) -> Option<Action> {
        let to = self.way.go_on(editor, ui, response, (time, self.from));
        if to == self.at || !self.free {
            return None;
        }
        self.at = to;
        let edit = Edit::Part(Box::new(Part::Start {
            node: self.node,
            start_frame: to,
            beyond: self.beyond,
        }));
        Some(Action::Enter(Entry::Drag(edit)))
    }

    fn tell(&self, editor: &Editor, ui: &Ui, time: &Time, top: f32) {
        let texts = &editor.texts().timeline;
        if !self.free {
            return bubble(ui, pos2(time.x(self.from), top), texts.is_pinned.to_owned());
        }
        let nodes = editor
            .document
            .edited_scene()
            .map(|edited| edited.scene().nodes());
        let node = nodes.and_then(|nodes| nodes.get(self.node));
        let name = fill(
            texts.path_of,
            &[&node.map_or("", |node| node.name.as_str())],
        );
        self.way
            .tell(editor, ui, &name, (time, self.from, self.at), top);
    }
}

/// Where a drag begins in this pass, and whether it adds to what is selected.
pub(super) fn begun(ui: &Ui, response: &Response) -> Option<(Pos2, bool)> {
    let at = ui.input(|input| {
        let other = input.pointer.middle_down() || input.pointer.secondary_down();
        let adds = input.modifiers.ctrl || input.modifiers.shift;
        Some((input.pointer.press_origin()?, adds)).filter(|_| !other)
    });
    let at = at.filter(|_| response.drag_started())?;
    response.request_focus();
    Some(at)
}

/// Takes what is under the pointer when a drag begins, and goes on with what is held.
pub(super) fn show(
    editor: &Editor,
    held: &mut Held,
    ui: &Ui,
    response: &Response,
    (shown, top): (&Shown<'_>, f32),
    actions: &mut Vec<Action>,
) {
    if let Some(begun) = begun(ui, response) {
        *held = taken(editor, shown, begun, actions);
    }
    let time = &shown.time;
    if !response.dragged() {
        let keys = match held {
            Held::Keys(drag) => Some(drag.keys.clone()),
            _ => None,
        };
        let is_step = matches!(held, Held::Keys(_) | Held::Bar(_));
        *held = Held::Nothing;
        if response.drag_stopped() && is_step {
            let end = Entry::of_end(ui.ctx());
            let given_back = end == Entry::Cancel;
            actions.push(Action::Enter(end));
            actions.extend(keys.filter(|_| given_back).map(Action::SelectKeys));
        }
        return;
    }
    match held {
        Held::Nothing => {}
        Held::Keys(drag) => {
            actions.extend(drag.go_on(editor, ui, response, time));
            drag.tell(editor, ui, time, top);
            ui.set_cursor_icon(match drag.done.copies() {
                true => CursorIcon::Copy,
                false => CursorIcon::ResizeHorizontal,
            });
        }
        Held::Bar(drag) => {
            actions.extend(drag.go_on(editor, ui, response, time));
            drag.tell(editor, ui, time, top);
            ui.set_cursor_icon(match drag.free {
                true => CursorIcon::Grabbing,
                false => CursorIcon::NotAllowed,
            });
        }
        Held::Box { x, row, besides } => {
            if let Some(pointer) = response.interact_pointer_pos() {
                let from = pos2(*x, shown.top + *row * super::track_rows::ROW);
                boxed(editor, ui, shown, (from, pointer, besides), actions);
            }
        }
    }
    let enter = ui.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Enter));
    if enter && matches!(held, Held::Keys(_) | Held::Bar(_)) {
        ui.ctx().stop_dragging();
        *held = Held::Nothing;
        actions.push(Action::Enter(Entry::End));
    }
}

fn taken(
    editor: &Editor,
    shown: &Shown<'_>,
    (at, adds): (Pos2, bool),
    actions: &mut Vec<Action>,
) -> Held {
    let drag = match shown.hit(editor, at) {
        Hit::Nothing => {
            let row = shown.number_at(at.y);
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
        Hit::Bar(node) => BarDrag::new(editor, node, at.x).map(|drag| Held::Bar(Box::new(drag))),
        Hit::End { first } => shown.ends.map(|(low, high)| {
            let (from, about) = if first { (low, high) } else { (high, low) };
            let keys = shown.selected.clone();
            Held::Keys(Box::new(KeysDrag::new(keys, from, Some(about), at.x)))
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
            from.map(|from| Held::Keys(Box::new(KeysDrag::new(all, from, None, at.x))))
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
    editor: &Editor,
    ui: &Ui,
    shown: &Shown<'_>,
    (from, to, besides): (Pos2, Pos2, &[KeyAt]),
    actions: &mut Vec<Action>,
) {
    let palette = theme::palette(ui);
    let place = Rect::from_two_pos(from, to);
    let painter = ui.painter_at(shown.ground.intersect(ui.clip_rect()));
    painter.rect_filled(place, 0.0, palette.accent.gamma_multiply(0.15));
    let line = Stroke::new(1.0, palette.accent);
    painter.rect_stroke(place, 0.0, line, StrokeKind::Inside);
    let Some(edited) = editor.document.edited_scene() else {
        return;
    };
    let [first, last] = [place.left(), place.right()].map(|x| shown.time.frame(x));
    let mut keys = Vec::new();
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    let number = |y: f32| shown.number_at(y).max(0.0) as usize;
    let rows = number(place.top())..=number(place.bottom());
    for row in shown.rows.iter().take(rows.end() + 1).skip(*rows.start()) {
        let Some(track) = row.track(edited) else {
            continue;
        };
        let frames = track.frames();
        let low = frames.partition_point(|&key| key < first);
        let high = frames.partition_point(|&key| key <= last);
        keys.extend((low..high).map(|key| KeyAt {
            node: row.node,
            channel: track.channel().clone(),
            key,
        }));
    }
    let others = besides.iter().filter(|at| !keys.contains(at));
    let others: Vec<KeyAt> = others.cloned().collect();
    keys.extend(others);
    if keys != shown.selected {
        actions.push(Action::SelectKeys(keys));
    }
}
