//! What is dragged in the graph of tracks: numbers of keys, in time and in value; handles of their
//! own tangents; a box that selects. As in the rows, each motion starts from the original keys.

use std::sync::Arc;

use egui::{CursorIcon, Key, Modifiers, Pos2, Rect, Response, Stroke, StrokeKind, Ui, vec2};
use vides_engine::limits::MAX_TANGENT;
use vides_engine::scene::Track;

use super::graph_paint::part_name;
use super::key_row::{FINE, bubble};
use super::track_curve::Of;
use super::track_dots;
use super::track_drag::begun;
use crate::action::{Action, TimeAction};
use crate::entry::Entry;
use crate::playing::track_dots::{Hit, Shown, has_handles, parts_of};
use crate::playing::track_rows::channel_name;
use crate::state::Editor;
use crate::state::playing::track_graph::{
    Dot, DotsDrag, HandleDrag, Held, Joints, Memory, PartOf, Parts, Side,
};
use crate::state::playing::tracks::{Change, KeyMotion, Numbers, Way};
use crate::state::scene_view::KeyAt;
use crate::state::space::Joint;
use crate::texts::fill;
use crate::theme;

/// A handle is no nearer to its key than this along the time, in points.
const LEAST: f32 = 0.5;

impl Side {
    pub(super) const fn sign(self) -> f32 {
        match self {
            Self::Before => -1.0,
            Self::After => 1.0,
        }
    }

    /// Where the tangent of a number stands among those of its key.
    const fn at(self, part: usize, width: usize) -> usize {
        match self {
            Self::Before => part,
            Self::After => width + part,
        }
    }

    const fn other(self) -> Self {
        match self {
            Self::Before => Self::After,
            Self::After => Self::Before,
        }
    }

    /// The tangent of a number of a key, where it acts.
    pub(super) fn slope(self, track: &Track, key: usize, part: usize) -> Option<f64> {
        let acts = match self {
            Self::Before => key > 0,
            Self::After => key + 1 < track.frames().len(),
        };
        let width = track.width();
        let at = 2 * width * key + self.at(part, width);
        track
            .shape()
            .get(at)
            .copied()
            .filter(|_| acts && has_handles(track))
    }
}

/// What a key does with one tangent while you drag the opposite one, by their directions.
pub(super) fn joint_of(before: f64, after: f64) -> Joint {
    let alike = |a: f64, b: f64| (a - b).abs() <= 1e-9 * a.abs().max(b.abs());
    match () {
        () if alike(before, after) => Joint::Smooth,
        () if alike(before, -after) => Joint::Mirrored,
        () => Joint::Corner,
    }
}

/// The tangent on the other side of one that is dragged.
fn follows(joint: Joint, led: f64, other: f64) -> f64 {
    match joint {
        Joint::Smooth => led,
        Joint::Mirrored => -led,
        Joint::Corner => other,
    }
}

impl DotsDrag {
    fn new(before: &Parts, shown: &Shown<'_>, dot: Dot, dots: Vec<Dot>, at: Pos2) -> Option<Self> {
        let of = shown.track_of(&dot.at)?;
        let from = (
            of.track.frames()[dot.at.key],
            of.of_key(dot.at.key, dot.part),
        );
        let mut parts = Parts::new();
        let mut keys: Vec<KeyAt> = Vec::new();
        let mut lifts = false;
        for Dot { at, part } in dots {
            let of = shown.track_of(&at)?;
            let frame = of.track.frames()[at.key];
            lifts |= !of.is_read_only();
            parts.insert((at.node, at.channel.clone(), frame.to_bits(), part));
            if keys.last() != Some(&at) {
                keys.push(at);
            }
        }
        let done = KeyMotion::new(keys.clone(), Change::By(0.0), false, Numbers::Stay);
        Some(Self {
            keys,
            before: before.union(&parts).cloned().collect(),
            parts: Arc::new(parts),
            dot,
            from,
            way: Way::begin(at.x),
            pointer: at.y,
            gone: 0.0,
            lifts,
            stays: [false; 2],
            done,
        })
    }

    /// What is to be done, if that is another.
    fn go_on(
        &mut self,
        editor: &Editor,
        ui: &Ui,
        response: &Response,
        shown: &Shown<'_>,
    ) -> Option<Action> {
        for (stays, key) in [Key::X, Key::Y].into_iter().enumerate() {
            if ui.input_mut(|input| input.consume_key(Modifiers::NONE, key)) {
                let held = !self.stays[stays];
                self.stays = [false; 2];
                self.stays[stays] = held;
            }
        }
        let held = ui.input(|input| input.modifiers);
        let [time_stays, number_stays] = self.stays;
        let (time, from) = (&shown.time, self.from.0);
        let to = self.way.go_on(editor, ui, response, (time, from));
        if let Some(pointer) = response.interact_pointer_pos() {
            let share = if held.shift { FINE } else { 1.0 };
            self.gone -= f64::from(pointer.y - self.pointer) * shown.fit.per_point * share;
            self.pointer = pointer.y;
        }
        let by = if time_stays { 0.0 } else { to - from };
        let numbers = match number_stays || !self.lifts || self.gone == 0.0 {
            true => Numbers::Stay,
            false => Numbers::By(self.gone, Arc::clone(&self.parts)),
        };
        let copies = held.ctrl || held.command;
        let wanted = KeyMotion::new(self.keys.clone(), Change::By(by), copies, numbers);
        let same = wanted == self.done || wanted.is_nothing() && self.done.is_nothing();
        (!same).then(|| {
            self.done = wanted.clone();
            Action::Time(TimeAction::MoveKeys(Box::new(wanted)))
        })
    }

    /// A number of a key as the key lies now.
    fn moved(&self, (node, channel, frame, part): &PartOf) -> PartOf {
        let frame = self.done.frame_of(f64::from_bits(*frame));
        (*node, channel.clone(), frame.to_bits(), *part)
    }

    /// The numbers that are selected, where the keys lie now and, for undo, where they lay.
    fn parts_now(&self) -> Parts {
        let moved = self.parts.iter().map(|of| self.moved(of));
        moved.chain(self.before.iter().cloned()).collect()
    }

    fn tell(&self, editor: &Editor, ui: &Ui, shown: &Shown<'_>, top: f32) {
        let texts = &editor.texts().timeline;
        let Some(of) = shown.track_of(&self.dot.at) else {
            return;
        };
        let mut name = name_of(editor, &of, self.dot.part);
        let read_only = of.is_read_only();
        let value = match (self.done.lift(), read_only) {
            (by, false) => self.done.number(of.track.channel(), self.from.1 + by),
            (_, true) => self.from.1,
        };
        if self.keys.len() > 1 {
            name = fill(texts.keys_selected, &[&self.keys.len()]);
        }
        if self.done.copies() && !self.done.is_nothing() {
            name = fill(texts.copy_of, &[&name]);
        }
        let at = self.done.frame_of(self.from.0);
        let mut words = self.way.words(editor, &name, (self.from.0, at));
        words += &format!("\n= {}", editor.language().number(value, 4));
        let also = match self.stays {
            [true, _] => texts.time_stays,
            [_, true] => texts.number_stays,
            _ if read_only && self.gone != 0.0 => texts.read_only,
            _ => "",
        };
        if !also.is_empty() {
            words += &format!("\n{also}");
        }
        bubble(ui, egui::pos2(shown.time.x(at), top), words);
    }
}

fn name_of(editor: &Editor, of: &Of<'_>, part: usize) -> String {
    let node = &of.scene.nodes()[of.node].name;
    let channel = channel_name(editor, of.track.channel());
    let name = format!("{channel} {}", part_name(editor, of, part));
    fill(editor.texts().timeline.channel_of, &[&name.trim(), &node])
}

impl HandleDrag {
    fn new(joints: &Joints, shown: &Shown<'_>, (dot, side): (Dot, Side), at: Pos2) -> Option<Self> {
        let of = shown.track_of(&dot.at)?;
        let (width, key) = (of.track.width(), dot.at.key);
        let before = of.track.shape()[2 * width * key..][..2 * width].to_vec();
        let [a, b] = [Side::Before, Side::After].map(|side| before[side.at(dot.part, width)]);
        let frame = of.track.frames()[key].to_bits();
        let chosen = joints.get(&(dot.at.node, dot.at.channel.clone(), frame, dot.part));
        let joint = chosen.copied().unwrap_or_else(|| joint_of(a, b));
        let way = shown.handle(&of, &dot, side)? - shown.place(&of, key, dot.part);
        Some(Self {
            dot,
            side,
            joint,
            pointer: at,
            way,
            done: before.clone(),
            before,
        })
    }

    fn go_on(&mut self, ui: &Ui, response: &Response, shown: &Shown<'_>) -> Option<Action> {
        let pointer = response.interact_pointer_pos()?;
        let fine = ui.input(|input| input.modifiers.shift);
        #[allow(clippy::cast_possible_truncation)]
        let share = if fine { FINE as f32 } else { 1.0 };
        self.way += (pointer - self.pointer) * share;
        let moved = pointer != self.pointer;
        self.pointer = pointer;
        if !moved {
            return None;
        }
        let sign = self.side.sign();
        let along = (self.way.x * sign).max(LEAST) * sign;
        let slope = shown.slope(vec2(along, self.way.y));
        let slope = slope.clamp(-MAX_TANGENT, MAX_TANGENT);
        let (width, part) = (self.before.len() / 2, self.dot.part);
        let other = self.side.other().at(part, width);
        let mut wanted = self.before.clone();
        wanted[self.side.at(part, width)] = slope;
        wanted[other] = follows(self.joint, slope, self.before[other]);
        if wanted == self.done {
            return None;
        }
        self.done.clone_from(&wanted);
        let keys = vec![self.dot.at.clone()];
        let motion = KeyMotion::new(keys, Change::By(0.0), false, Numbers::Tangents(wanted));
        Some(Action::Time(TimeAction::MoveKeys(Box::new(motion))))
    }

    fn tell(&self, editor: &Editor, ui: &Ui, shown: &Shown<'_>, top: f32) {
        let texts = &editor.texts().timeline;
        let Some(of) = shown.track_of(&self.dot.at) else {
            return;
        };
        let slope = self.done[self.side.at(self.dot.part, self.done.len() / 2)];
        let slope = slope * editor.document.info().fps;
        let name = name_of(editor, &of, self.dot.part);
        let words = fill(texts.tangent, &[&name, &editor.language().number(slope, 3)]);
        let x = shown.place(&of, self.dot.at.key, self.dot.part).x;
        bubble(ui, egui::pos2(x, top), words);
    }
}

/// Takes what is under the pointer when a drag begins, and goes on with what is held.
pub(super) fn show(
    editor: &Editor,
    memory: &mut Memory,
    ui: &Ui,
    response: &Response,
    (shown, top): (&Shown<'_>, f32),
    actions: &mut Vec<Action>,
) {
    if let Some(begun) = begun(ui, response) {
        memory.held = taken(memory, shown, begun, actions);
    }
    if !response.dragged() {
        ended(memory, ui, response, actions);
        return;
    }
    // It remembers what is selected, too.
    let mut held = std::mem::take(&mut memory.held);
    match &mut held {
        Held::Nothing => {}
        Held::Dots(drag) => {
            actions.extend(drag.go_on(editor, ui, response, shown));
            memory.parts = drag.parts_now();
            drag.tell(editor, ui, shown, top);
            ui.set_cursor_icon(match drag.done.copies() {
                true => CursorIcon::Copy,
                false => CursorIcon::Move,
            });
        }
        Held::Handle(drag) => {
            actions.extend(drag.go_on(ui, response, shown));
            drag.tell(editor, ui, shown, top);
            ui.set_cursor_icon(CursorIcon::Move);
        }
        Held::Box { from, besides } => {
            if let Some(pointer) = response.interact_pointer_pos() {
                boxed(memory, ui, shown, (*from, pointer, besides), actions);
            }
        }
    }
    memory.held = held;
    let steps = matches!(memory.held, Held::Dots(_) | Held::Handle(_));
    if steps && ui.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Enter)) {
        ui.ctx().stop_dragging();
        memory.held = Held::Nothing;
        actions.push(Action::Enter(Entry::End));
    }
}

/// What was held is let go, or given back.
fn ended(memory: &mut Memory, ui: &Ui, response: &Response, actions: &mut Vec<Action>) {
    let held = std::mem::take(&mut memory.held);
    if !response.drag_stopped() || matches!(held, Held::Nothing | Held::Box { .. }) {
        return;
    }
    let end = Entry::of_end(ui.ctx());
    let given_back = end == Entry::Cancel;
    actions.push(Action::Enter(end));
    match held {
        Held::Dots(drag) if given_back => {
            memory.parts = (*drag.parts).clone();
            actions.push(Action::SelectKeys(drag.keys));
        }
        // A key keeps what was chosen for it at its new frame.
        Held::Dots(drag) if !drag.done.copies() => {
            for of in drag.parts.iter() {
                if let Some(joint) = memory.joints.remove(of) {
                    memory.joints.insert(drag.moved(of), joint);
                }
            }
        }
        _ => {}
    }
}

fn taken(
    memory: &mut Memory,
    shown: &Shown<'_>,
    (at, adds): (Pos2, bool),
    actions: &mut Vec<Action>,
) -> Held {
    let drag = match shown.hit(&memory.parts, at) {
        Hit::Nothing => {
            let besides = match adds {
                true => shown.dots(&memory.parts),
                false => Vec::new(),
            };
            return Held::Box { from: at, besides };
        }
        Hit::Handle(dot, side) => HandleDrag::new(&memory.joints, shown, (dot, side), at)
            .map(|drag| Held::Handle(Box::new(drag))),
        Hit::Dot(dot) => {
            let mut dots = all_dots(&memory.parts, shown);
            if !dots.contains(&dot) {
                dots = vec![dot.clone()];
                track_dots::select(memory, shown, dots.clone(), actions);
            }
            DotsDrag::new(&memory.parts, shown, dot, dots, at)
                .map(|drag| Held::Dots(Box::new(drag)))
        }
    };
    let Some(drag) = drag else {
        return Held::Nothing;
    };
    actions.push(Action::Enter(Entry::Begin));
    drag
}

/// The selected numbers of the curves that are shown, in sight or not.
fn all_dots(parts: &Parts, shown: &Shown<'_>) -> Vec<Dot> {
    let mut all = Vec::new();
    for at in &shown.selected {
        if let Some(of) = shown.track_of(at) {
            let chosen = parts_of(parts, at, of.track.frames()[at.key], of.width());
            all.extend(chosen.map(|part| Dot {
                at: at.clone(),
                part,
            }));
        }
    }
    all
}

/// Selects the numbers of keys in a box, and these besides.
fn boxed(
    memory: &mut Memory,
    ui: &Ui,
    shown: &Shown<'_>,
    (from, to, besides): (Pos2, Pos2, &[Dot]),
    actions: &mut Vec<Action>,
) {
    let palette = theme::palette(ui);
    let place = Rect::from_two_pos(from, to);
    let painter = ui.painter_at(shown.ground.intersect(ui.clip_rect()));
    painter.rect_filled(place, 0.0, palette.accent.gamma_multiply(0.15));
    let line = Stroke::new(1.0, palette.accent);
    painter.rect_stroke(place, 0.0, line, StrokeKind::Inside);
    let mut dots = shown.within(place);
    dots.extend(besides.iter().cloned());
    track_dots::select(memory, shown, dots, actions);
}

#[cfg(test)]
#[path = "graph_drag_tests.rs"]
pub(super) mod tests;
