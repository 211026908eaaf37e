//! What is dragged in the graph of tracks: numbers of keys, in time and in value; handles of their
//! own tangents; a box that selects. As in the rows, each motion starts from the original keys.

use std::sync::Arc;

use egui::{CursorIcon, Key, Modifiers, Pos2, Rect, Response, Ui, vec2};
use vides_engine::limits::MAX_TANGENT;
use vides_engine::scene::Track;

use super::drag::{FINE, Moves, Pass, To, begun, bubble, ended, select_box};
use super::graph_paint::part_name;
use super::track_curve::Of;
use super::track_dots;
use crate::action::{Action, TimeAction};
use crate::entry::Entry;
use crate::playing::track_dots::{Hit, Shown, has_handles};
use crate::playing::track_rows::channel_name;
use crate::state::Editor;
use crate::state::playing::drag::Drag;
use crate::state::playing::track_graph::{
    Dot, DotsDrag, HandleDrag, Held, Joints, Memory, PartOf, Parts, Side,
};
use crate::state::playing::tracks::{Change, KeyMotion, Numbers};
use crate::state::scene_view::KeyAt;
use crate::state::space::Joint;
use crate::texts::fill;

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

/// Takes these numbers of keys by the one under the pointer.
fn dots_drag(
    editor: &Editor,
    before: &Parts,
    shown: &Shown<'_>,
    (dot, dots): (Dot, Vec<Dot>),
    at: Pos2,
) -> Option<Box<Drag<DotsDrag>>> {
    let of = shown.track_of(&dot.at)?;
    let from = of.track.frames()[dot.at.key];
    let mut parts = Parts::new();
    let mut keys: Vec<KeyAt> = Vec::new();
    let mut lifts = false;
    for Dot { at, part } in dots {
        let of = shown.track_of(&at)?;
        let frame = of.track.frames()[at.key];
        lifts |= !of.is_read_only();
        parts.insert(of.part(frame, part));
        if keys.last() != Some(&at) {
            keys.push(at);
        }
    }
    let name = match keys.len() {
        0 | 1 => name_of(editor, &of, dot.part),
        many => fill(editor.texts().timeline.keys_selected, &[&many]),
    };
    let drag = DotsDrag {
        before: before.union(&parts).cloned().collect(),
        parts: Arc::new(parts),
        value: of.of_key(dot.at.key, dot.part),
        read_only: of.is_read_only(),
        channel: dot.at.channel,
        pointer: at.y,
        each: shown.fit.per_point,
        gone: 0.0,
        lifts,
        stays: [false; 2],
        done: KeyMotion::none(keys),
    };
    Some(Drag::new(drag, name, from, at))
}

impl Moves for DotsDrag {
    fn go_on(&mut self, pass: &Pass<'_>, to: &To) -> Option<Action> {
        for (stays, key) in [Key::X, Key::Y].into_iter().enumerate() {
            let pressed = |input: &mut egui::InputState| input.consume_key(Modifiers::NONE, key);
            if pass.ui.input_mut(pressed) {
                let held = !self.stays[stays];
                self.stays = [false; 2];
                self.stays[stays] = held;
            }
        }
        let [time_stays, number_stays] = self.stays;
        if let Some(pointer) = pass.response.interact_pointer_pos() {
            let share = if to.fine { FINE } else { 1.0 };
            self.gone -= f64::from(pointer.y - self.pointer) * self.each * share;
            self.pointer = pointer.y;
        }
        let by = if time_stays { 0.0 } else { to.frame - to.from };
        let numbers = match number_stays || !self.lifts || self.gone == 0.0 {
            true => Numbers::Stay,
            false => Numbers::By(self.gone, Arc::clone(&self.parts)),
        };
        let keys = self.done.keys.clone();
        let wanted = KeyMotion::new(keys, Change::By(by), to.copies, numbers);
        self.done.turn_into(wanted)
    }

    fn at(&self, _editor: &Editor, from: f64) -> f64 {
        self.done.frame_of(from)
    }

    fn copies(&self) -> bool {
        self.done.copies()
    }

    fn more(&self, editor: &Editor) -> Vec<String> {
        let texts = &editor.texts().timeline;
        let value = match self.read_only {
            true => self.value,
            false => (self.done).number(&self.channel, self.value + self.done.lift()),
        };
        let also = match self.stays {
            [true, _] => Some(texts.time_stays),
            [_, true] => Some(texts.number_stays),
            _ => (self.read_only && self.gone != 0.0).then_some(texts.read_only),
        };
        let value = format!("= {}", editor.language().number(value, 4));
        std::iter::once(value)
            .chain(also.map(str::to_owned))
            .collect()
    }

    fn cursor(&self) -> CursorIcon {
        match self.copies() {
            true => CursorIcon::Copy,
            false => CursorIcon::Move,
        }
    }
}

impl DotsDrag {
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
        let chosen = joints.get(&of.part(of.track.frames()[key], dot.part));
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

    fn tell(&self, pass: &Pass<'_>, shown: &Shown<'_>) {
        let (editor, texts) = (pass.editor, &pass.editor.texts().timeline);
        let Some(of) = shown.track_of(&self.dot.at) else {
            return;
        };
        let slope = self.done[self.side.at(self.dot.part, self.done.len() / 2)];
        let slope = slope * editor.document.info().fps;
        let name = name_of(editor, &of, self.dot.part);
        let words = fill(texts.tangent, &[&name, &editor.language().number(slope, 3)]);
        let x = shown.place(&of, self.dot.at.key, self.dot.part).x;
        bubble(pass.ui, egui::pos2(x, pass.top), words);
    }
}

/// Takes what is under the pointer when a drag begins, and goes on with what is held.
pub(super) fn show(
    memory: &mut Memory,
    pass: &Pass<'_>,
    shown: &Shown<'_>,
    actions: &mut Vec<Action>,
) {
    let (ui, response) = (pass.ui, pass.response);
    if let Some(at) = begun(ui, response) {
        response.request_focus();
        memory.held = taken(memory, pass, shown, at, actions);
    }
    // It remembers what is selected, too.
    let mut held = std::mem::take(&mut memory.held);
    let end = match &mut held {
        Held::Nothing => return,
        Held::Dots(drag) => {
            let end = drag.go_on(pass, actions);
            if response.dragged() {
                memory.parts = drag.of.parts_now();
            }
            end
        }
        Held::Handle(drag) => {
            if response.dragged() {
                actions.extend(drag.go_on(ui, response, shown));
                drag.tell(pass, shown);
                ui.set_cursor_icon(CursorIcon::Move);
            }
            ended(ui, response, actions)
        }
        Held::Box { from, besides } => {
            if !response.dragged() {
                return;
            }
            if let Some(pointer) = response.interact_pointer_pos() {
                let place = Rect::from_two_pos(*from, pointer);
                select_box(ui, shown.ground, place);
                let mut dots = shown.within(place);
                dots.extend(besides.iter().cloned());
                track_dots::select(memory, shown, dots, actions);
            }
            None
        }
    };
    match (held, end) {
        (held, None) => memory.held = held,
        (Held::Dots(drag), Some(Entry::Cancel)) => {
            memory.parts = (*drag.of.parts).clone();
            actions.push(Action::SelectKeys(drag.of.done.keys));
        }
        // A key keeps what was chosen for it at its new frame.
        (Held::Dots(drag), _) if !drag.of.done.copies() => {
            for of in drag.of.parts.iter() {
                if let Some(joint) = memory.joints.remove(of) {
                    memory.joints.insert(drag.of.moved(of), joint);
                }
            }
        }
        _ => {}
    }
}

fn taken(
    memory: &mut Memory,
    pass: &Pass<'_>,
    shown: &Shown<'_>,
    at: Pos2,
    actions: &mut Vec<Action>,
) -> Held {
    let drag = match shown.hit(&memory.parts, at) {
        Hit::Nothing => {
            let adds = pass
                .ui
                .input(|input| input.modifiers.ctrl || input.modifiers.shift);
            let besides = match adds {
                true => shown.dots(&memory.parts),
                false => Vec::new(),
            };
            return Held::Box { from: at, besides };
        }
        Hit::Handle(dot, side) => HandleDrag::new(&memory.joints, shown, (dot, side), at)
            .map(|drag| Held::Handle(Box::new(drag))),
        Hit::Dot(dot) => {
            let mut dots = shown.all_dots(&memory.parts, |_| true);
            if !dots.contains(&dot) {
                dots = vec![dot.clone()];
                track_dots::select(memory, shown, dots.clone(), actions);
            }
            dots_drag(pass.editor, &memory.parts, shown, (dot, dots), at).map(Held::Dots)
        }
    };
    let Some(drag) = drag else {
        return Held::Nothing;
    };
    actions.push(Action::Enter(Entry::Begin));
    drag
}

#[cfg(test)]
#[path = "graph_drag_tests.rs"]
pub(super) mod tests;
