//! The mouse in the movement window: turns egui's events into actions. Keys go to [`keyboard`].

use egui::{Context, CursorIcon, Event, Key, Modifiers, MouseWheelUnit, PointerButton, Pos2, Rect};
use glam::{DVec2, DVec3};

use super::hold::place_held;
use super::keyboard::{self, NUDGES};
use super::projection::{Axis, Projection, from_pos};
use super::transform::{self, Next};
use super::typed::Typed;
use super::{arrows, drawing, of_nodes, picking};
use crate::action::{Action, PathAction, ToolAction};
use crate::keys;
use crate::space::surface::{FINE, PointerContext, STILL, WHEEL, axis_of, projection_of, resized};
use crate::state::Editor;
use crate::state::selected::SelectionChange;
use crate::state::space::{
    DragConstraint, Drawing, Gesture, Grip, Handle, Kind, PointerController, PointerPress, Side,
    Transform,
};
use crate::state::windows::ToolWindow;
use crate::texts::{Texts, fill};

/// The axis across the plane in which each button drags (thesis A.3.1).
pub(super) const PLANES: [(PointerButton, Axis); 3] = [
    (PointerButton::Primary, Axis::X),
    (PointerButton::Middle, Axis::Y),
    (PointerButton::Secondary, Axis::Z),
];

impl PointerController {
    /// The events of a pass; of successive motions only the last, unless a line is drawn.
    pub(super) fn events(&self, context: &Context) -> impl Iterator<Item = Event> + use<> {
        let mut events = context.input(|input| input.events.clone());
        let moves = |event: &Event| matches!(event, Event::PointerMoved(_));
        let all = self.drawing.is_some();
        events.dedup_by(|later, event| {
            let both = !all && moves(later) && moves(event);
            if both {
                std::mem::swap(later, event);
            }
            both
        });
        events.into_iter()
    }

    /// Whether a button is down.
    pub(super) fn is_busy(&self) -> bool {
        self.hold.is_some() || self.drawing.is_some()
    }

    /// The line that is being drawn.
    pub(super) fn stroke(&self) -> Option<&[DVec3]> {
        self.drawing.as_ref().map(Drawing::places)
    }

    /// What is held or dragged, and in which coordinates. A press with Shift or Ctrl may be a click
    /// that selects, and one on something of a scene begins another drag.
    pub(super) fn dragged(&self) -> Option<(Handle, DragConstraint)> {
        let hold = self.hold.as_deref()?;
        let what = hold.what?;
        let holds = hold.moved || what.is_of_path() && !hold.adds;
        holds.then_some((what, hold.freedom))
    }

    /// The box that selects points.
    pub(super) fn drawn_box(&self) -> Option<Rect> {
        let hold = self.hold.as_deref();
        let hold = hold.filter(|hold| hold.moved && hold.boxes)?;
        Some(Rect::from_two_pos(hold.pressed, hold.now))
    }

    /// Whether a handle, the view or a line is on its way.
    pub(super) fn moves(&self) -> bool {
        self.hold.as_ref().is_some_and(|hold| hold.moved)
            || self.transform.is_some()
            || self.drawing.is_some()
    }

    /// What the buttons would do under the pointer, or where a drag goes. `several`: how many
    /// points are selected, if more than one; `draws`: the left button draws a line; `nodes`:
    /// nodes are meant.
    pub(super) fn hint(
        &self,
        texts: &Texts,
        projection: &Projection,
        several: usize,
        [draws, nodes]: [bool; 2],
    ) -> Option<String> {
        let texts = &texts.space;
        let of_tangent = |what: Handle, hint: String| match what {
            Handle::Tangent(Side::Before) => fill(texts.tangent_hint, &[&texts.before, &hint]),
            Handle::Tangent(Side::After) => fill(texts.tangent_hint, &[&texts.after, &hint]),
            _ => hint,
        };
        let in_freedom = |freedom: DragConstraint| match (freedom.along, freedom.edge_on) {
            (None, _) => fill(texts.in_plane, &[&freedom.fixed.letter()]),
            (Some(along), None) => fill(texts.on_line, &[&along.letter()]),
            (Some(along), Some(kept)) => fill(texts.edge_on, &[&kept.letter(), &along.letter()]),
        };
        match (self.dragged(), self.hover) {
            (None, None) if self.arrow.is_some() => self.arrow.map(in_freedom),
            (None, None) if self.begun.is_some() => Some(texts.begin_next.to_owned()),
            (None, None) if draws && !self.is_busy() => Some(texts.draw_hint.to_owned()),
            (None, None) if self.meant == Some(Kind::Turn) => Some(texts.turn_hint.to_owned()),
            (None, None) if self.meant.is_some() => Some(texts.scale_hint.to_owned()),
            (Some((Handle::Vup, _)), _) => Some(texts.rolling.to_owned()),
            (Some((what, freedom)), _) => Some(of_tangent(what, in_freedom(freedom))),
            (None, Some(Handle::Vup)) if !self.is_busy() => Some(texts.roll_hint.to_owned()),
            (None, Some(Handle::Node(_))) if !self.is_busy() => Some(texts.node_hint.to_owned()),
            (None, Some(Handle::Key(..))) if !self.is_busy() => Some(texts.key_hint.to_owned()),
            (None, Some(what)) if !self.is_busy() => {
                let [left, middle, right] = PLANES.map(|(_, axis)| match DragConstraint::keeping(
                    projection, axis,
                )
                .along
                {
                    None => axis.letter().to_owned(),
                    Some(along) => fill(texts.only_along, &[&axis.letter(), &along.letter()]),
                });
                let hint = fill(texts.drag_hint, &[&left, &middle, &right]);
                Some(of_tangent(what, hint))
            }
            (None, None) if several > 0 && !self.is_busy() => {
                Some(fill(texts.several_hint, &[&several]))
            }
            (None, None) if self.over && nodes && !self.is_busy() => {
                Some(texts.nodes_hint.to_owned())
            }
            (None, None) if self.over && !self.is_busy() => Some(texts.empty_hint.to_owned()),
            _ => None,
        }
    }

    /// Brings the state in line with the devices after the events of a pass.
    pub(super) fn settle(
        &mut self,
        editor: &Editor,
        surface: &PointerContext<'_>,
        actions: &mut Vec<Action>,
    ) {
        // Ctrl and Alt may come and go while the pointer rests.
        let held = surface.context.input(|input| input.modifiers);
        if let Some(hold) = self.hold.as_deref()
            && hold.moved
            && (hold.snaps, hold.alone) != (held.ctrl, held.alt)
        {
            let now = hold.now;
            self.motion(editor, surface, now, actions);
        }
        // The release may have been lost with the window's focus.
        if !surface.context.input(|input| input.pointer.primary_down()) {
            self.drawing = None;
        }
        let (down, nudged) = surface.context.input(|input| {
            let down =
                (self.hold.as_ref()).is_none_or(|hold| input.pointer.button_down(hold.button));
            let nudged = NUDGES.iter().any(|&key| input.key_down(key));
            (down, nudged)
        });
        if !down {
            self.release(editor, surface.viewport, actions);
        }
        if !nudged {
            self.end_nudge(actions);
        }
        let held = self.transform.as_ref().and_then(Transform::held);
        let held = held.map(|held| {
            surface
                .context
                .input(|input| input.pointer.button_down(held))
        });
        if held == Some(false) {
            self.transform = None;
            actions.push(Action::Gesture(Gesture::End));
        }
    }

    pub(super) fn point(&mut self, editor: &Editor, surface: &PointerContext<'_>) {
        let pointer = surface.context.input(|input| input.pointer.latest_pos());
        self.over = pointer.is_some_and(|at| (surface.mine)(at));
        self.hover = match (&self.hold, pointer) {
            (Some(hold), _) => hold.what,
            (None, Some(at)) if (surface.mine)(at) && !drawing::is_wanted(editor) => {
                let projection = projection_of(editor, surface.viewport);
                handle_at(editor, &projection, at, true)
            }
            _ => None,
        };
        let free = self.over && self.hold.is_none() && self.transform.is_none();
        let free = free && self.hover.is_none() && !drawing::is_wanted(editor);
        self.arrow = pointer.filter(|_| free).and_then(|at| {
            let projection = projection_of(editor, surface.viewport);
            let (_, freedom, _) = arrows::grasped(editor, &projection, from_pos(at))?;
            Some(freedom)
        });
        self.meant = pointer
            .filter(|_| self.over && self.hold.is_none())
            .and_then(|at| {
                let projection = projection_of(editor, surface.viewport);
                let free = self.transform.is_none() && self.hover.is_none();
                let free = free && !drawing::is_wanted(editor);
                let found = transform::handle_at(editor, &projection, from_pos(at));
                found.filter(|_| free)
            });
    }

    pub(super) fn cursor(&self) -> CursorIcon {
        match (&self.hold, self.hover) {
            (Some(hold), _) if hold.moved && hold.what.is_some() => CursorIcon::Crosshair,
            (Some(hold), _) if hold.boxes => CursorIcon::Crosshair,
            (Some(hold), _) if hold.shifts => CursorIcon::Move,
            (Some(_), _) => CursorIcon::Grabbing,
            (None, None) if self.transform.is_some() || self.drawing.is_some() => {
                CursorIcon::Crosshair
            }
            (None, _) if self.meant.is_some() || self.arrow.is_some() => CursorIcon::Grab,
            (None, Some(_)) => CursorIcon::Grab,
            (None, None) => CursorIcon::Default,
        }
    }

    pub(super) fn take(
        &mut self,
        editor: &Editor,
        surface: &PointerContext<'_>,
        event: Event,
        actions: &mut Vec<Action>,
    ) {
        let of_wheel = matches!(event, Event::MouseWheel { .. });
        if !of_wheel && let Some(mut transform) = self.transform.take() {
            if !editor.document.in_step() {
                // Something else ended the step.
                return;
            }
            if transform.take(editor, surface, &event, actions) == Next::GoesOn {
                self.transform = Some(transform);
            }
            return;
        }
        if let Some(drawing) = self.drawing.take() {
            self.drawing = drawing.take(editor, surface, &event, actions);
            return;
        }
        let held = self.hold.as_deref();
        let held = held.filter(|hold| hold.moved && hold.what.is_some());
        if let Some(now) = held.map(|hold| hold.now)
            && self.typed.take(&event)
        {
            self.motion(editor, surface, now, actions);
            return;
        }
        match event {
            Event::PointerButton {
                pos,
                button,
                pressed: true,
                modifiers,
            } if self.hold.is_none() && (surface.mine)(pos) => {
                self.press(editor, surface, (pos, button, modifiers), actions);
            }
            Event::PointerButton {
                pos,
                button,
                pressed: false,
                ..
            } if (self.hold.as_ref()).is_some_and(|hold| hold.button == button) => {
                self.motion(editor, surface, pos, actions);
                self.release(editor, surface.viewport, actions);
            }
            Event::PointerMoved(pos) => self.motion(editor, surface, pos, actions),
            Event::MouseWheel { unit, delta, .. } => {
                actions.extend(wheel(editor, surface, unit, delta.y));
            }
            Event::Key {
                key: Key::Escape,
                pressed: true,
                ..
            } if self.begun.take().is_some() => {
                keys::consume_escape(surface.context);
            }
            Event::Key {
                key: Key::Escape,
                pressed: true,
                ..
            } if self.hold.is_none() && surface.keyboard && editor.several().is_some() => {
                actions.push(Action::Choose(SelectionChange::Current));
                keys::consume_escape(surface.context);
            }
            Event::Key {
                key: Key::Escape,
                pressed: true,
                ..
            } if self.hold.is_some() => {
                self.cancel(actions);
                keys::consume_escape(surface.context);
            }
            Event::Key {
                key,
                pressed: true,
                modifiers,
                ..
            } => self.key(editor, surface, (key, modifiers), actions),
            _ => {}
        }
    }

    /// A key that goes on with a drag, or begins something.
    fn key(
        &mut self,
        editor: &Editor,
        surface: &PointerContext<'_>,
        (key, modifiers): (Key, Modifiers),
        actions: &mut Vec<Action>,
    ) {
        if let Some(kept) = axis_of(key)
            && let Some(hold) = &mut self.hold
            && matches!(
                hold.what,
                Some(Handle::Point(_) | Handle::Vpn | Handle::Control(_) | Handle::Tangent(_))
            )
        {
            let projection = projection_of(editor, surface.viewport);
            hold.freedom = DragConstraint::keeping(&projection, kept);
            let now = hold.now;
            self.motion(editor, surface, now, actions);
        } else if surface.keyboard
            && self.hold.is_none()
            && !editor.is_first_screen()
            && !(modifiers.is_none() && self.begin_transform(editor, surface, key, actions))
        {
            keyboard::press(self, editor, surface.viewport, (key, modifiers), actions);
        }
    }

    /// Begins the transform of a key; false if the key has none.
    fn begin_transform(
        &mut self,
        editor: &Editor,
        surface: &PointerContext<'_>,
        key: Key,
        actions: &mut Vec<Action>,
    ) -> bool {
        if self.begins_with_nodes(editor, surface, key, actions) {
            return true;
        }
        let transform = Transform::of_key(editor, surface, key);
        let Some(transform) = transform.filter(|_| editor.document.edits_path()) else {
            return false;
        };
        self.begin(editor, transform, actions);
        true
    }

    fn begin(&mut self, editor: &Editor, transform: Transform, actions: &mut Vec<Action>) {
        self.end_nudge(actions);
        if transform.lacks_points() {
            let words = editor.texts().space.needs_several;
            actions.push(Action::Say(words.to_owned()));
            return;
        }
        let current = Handle::Point(editor.document.selection().point);
        actions.push(Action::Gesture(Gesture::Press(Some(current))));
        actions.push(Action::Gesture(Gesture::Begin));
        self.transform = Some(transform);
    }

    fn press(
        &mut self,
        editor: &Editor,
        surface: &PointerContext<'_>,
        (pos, button, modifiers): (Pos2, PointerButton, Modifiers),
        actions: &mut Vec<Action>,
    ) {
        let held = surface.context.input(|input| {
            [Key::X, Key::Y, Key::Z]
                .into_iter()
                .find(|&key| input.key_down(key))
                .and_then(axis_of)
        });
        let Some((_, plane)) = PLANES.into_iter().find(|&(its, _)| its == button) else {
            return;
        };
        self.end_nudge(actions);
        let left = button == PointerButton::Primary;
        let projection = projection_of(editor, surface.viewport);
        if left && drawing::is_wanted(editor) {
            self.drawing = Some(Drawing::begin(editor, surface, pos));
            return;
        }
        let kept = held.filter(|_| left).unwrap_or(plane);
        let freedom = DragConstraint::keeping(&projection, kept);
        let what = handle_at(editor, &projection, pos, left && held.is_none());
        let plain = left && what.is_none() && modifiers.is_none();
        let handle = transform::handle_at(editor, &projection, from_pos(pos)).filter(|_| plain);
        if let Some(kind) = handle.filter(|_| editor.means_nodes()) {
            let held = Some((button, pos));
            self.begin_nodes(editor, surface, (kind, Grip::Nodes, held), actions);
            return;
        }
        let transform = handle.and_then(|kind| Transform::of_handle(editor, surface, kind, button));
        if let Some(transform) = transform {
            self.begin(editor, transform, actions);
            return;
        }
        let arrow = arrows::grasped(editor, &projection, from_pos(pos)).filter(|_| plain);
        let (what, freedom, lag) = match arrow {
            Some((point, freedom, lag)) => (Some(point), freedom, lag),
            None => (what, freedom, DVec2::ZERO),
        };
        let adds = left && (modifiers.shift || modifiers.ctrl);
        // A click selects one more, a drag is fine: which one it is shows later.
        if !(adds && matches!(what, Some(Handle::Point(_)))) {
            actions.push(Action::Gesture(Gesture::Press(what)));
        }
        let boxes = what.is_none() && left && modifiers.ctrl;
        self.typed = Typed::default();
        self.hold = Some(Box::new(PointerPress {
            button,
            pressed: pos,
            now: pos,
            what,
            from: what
                .and_then(|what| place_held(editor, what))
                .unwrap_or_default(),
            freedom,
            lag,
            snaps: false,
            alone: false,
            joint: editor.joint().unwrap_or_default(),
            view: editor.setup.view,
            shifts: what.is_none() && (button == PointerButton::Middle || modifiers.shift),
            boxes,
            adds: if boxes { modifiers.shift } else { adds },
            moved: false,
        }));
    }

    fn motion(
        &mut self,
        editor: &Editor,
        surface: &PointerContext<'_>,
        pos: Pos2,
        actions: &mut Vec<Action>,
    ) {
        let Some(hold) = &mut self.hold else {
            return;
        };
        let modifiers = surface.context.input(|input| input.modifiers);
        if modifiers.shift {
            hold.lag -= (from_pos(pos) - from_pos(hold.now)) * (1.0 - 1.0 / FINE);
        }
        (hold.snaps, hold.alone) = (modifiers.ctrl, modifiers.alt);
        hold.now = pos;
        if !hold.moved {
            let way = pos - hold.pressed;
            if way.x.abs().max(way.y.abs()) <= STILL {
                return;
            }
            let grip = match hold.what {
                Some(Handle::Node(_)) => Some(Grip::Nodes),
                Some(Handle::Key(node, key)) => Some(Grip::Key(node, key)),
                _ => None,
            };
            if let Some(grip) = grip {
                let held = Some((hold.button, hold.pressed));
                self.hold = None;
                self.begin_nodes(editor, surface, (Kind::Move, grip, held), actions);
                if let Some(transform) = &mut self.transform {
                    transform.take(editor, surface, &Event::PointerMoved(pos), actions);
                }
                return;
            }
            hold.moved = true;
            if hold.what.is_some() && !hold.controls() {
                if hold.adds {
                    actions.push(Action::Gesture(Gesture::Press(hold.what)));
                }
                actions.push(Action::Gesture(Gesture::Begin));
            }
        } else if hold.what.is_some() && !hold.controls() && !editor.document.in_step() {
            // An undo with the button down ended the step: what follows would not belong to it.
            self.hold = None;
            return;
        }
        actions.extend(match hold.what {
            Some(what) => hold.pull(editor, surface.viewport, what, &self.typed),
            None if hold.boxes => None,
            None => Some(Action::View(hold.turned(surface.viewport))),
        });
    }

    fn release(&mut self, editor: &Editor, viewport: Rect, actions: &mut Vec<Action>) {
        let Some(hold) = self.hold.take() else {
            return;
        };
        if hold.moved {
            if hold.what.is_some() {
                actions.push(Action::Gesture(Gesture::End));
            } else if hold.boxes {
                actions.push(hold.within(editor, viewport));
            }
        } else if editor.is_first_screen() {
            if hold.button == PointerButton::Primary {
                let place = drawing::place_in(editor, viewport, hold.pressed);
                match self.begun.filter(|begun| *begun != place) {
                    None => self.begun = Some(place),
                    Some(begun) => {
                        self.begun = None;
                        actions.push(Action::Path(PathAction::Begin([begun, place])));
                    }
                }
            }
        } else if hold.button == PointerButton::Secondary {
            self.menu = Some((hold.pressed, hold.what.filter(|what| what.is_of_path())));
        } else if self.clicks_node(editor, viewport, &hold, actions) {
            // A node lies there.
        } else {
            actions.extend(match hold.what {
                Some(Handle::Control(at)) => Some(Action::Tool(ToolAction::MoveControl {
                    at,
                    place: hold.from,
                })),
                // A click selects one more or one less, or the current one alone.
                Some(Handle::Point(at)) if hold.adds => {
                    Some(Action::Choose(SelectionChange::Switch(at)))
                }
                Some(Handle::Point(_)) | None if !hold.adds && !hold.boxes => {
                    Some(Action::Choose(SelectionChange::Current))
                }
                _ => None,
            });
        }
    }

    fn cancel(&mut self, actions: &mut Vec<Action>) {
        let Some(hold) = self.hold.take().filter(|hold| hold.moved) else {
            return;
        };
        match hold.what {
            None => actions.push(Action::View(hold.view)),
            Some(Handle::Control(at)) => actions.push(Action::Tool(ToolAction::MoveControl {
                at,
                place: hold.from,
            })),
            Some(_) => {}
        }
        actions.push(Action::Gesture(Gesture::Cancel));
    }

    /// Ends the step that the keys opened.
    pub(super) fn end_nudge(&mut self, actions: &mut Vec<Action>) {
        if std::mem::take(&mut self.nudging) {
            actions.push(Action::Gesture(Gesture::End));
        }
    }
}

/// What lies under the pointer: a control point of a tool's box before all else.
fn handle_at(
    editor: &Editor,
    projection: &Projection,
    pos: Pos2,
    with_vup: bool,
) -> Option<Handle> {
    if editor.is_first_screen() {
        return None;
    }
    let pointer = from_pos(pos);
    let cage = editor.windows.tool.as_ref().and_then(ToolWindow::cage);
    let nodes = cage.map_or(&[][..], |cage| &cage.nodes);
    picking::nearest(projection, nodes.iter().copied(), pointer)
        .map(Handle::Control)
        .or_else(|| {
            let shown = &editor.setup.shown;
            picking::pick(&editor.document, projection, shown, pointer, with_vup)
        })
        .or_else(|| of_nodes::grip_at(editor, projection, pointer))
}

/// The view that the wheel turns to, about what is under the pointer.
fn wheel(
    editor: &Editor,
    surface: &PointerContext<'_>,
    unit: MouseWheelUnit,
    turned: f32,
) -> Option<Action> {
    let at = surface.context.input(|input| input.pointer.latest_pos());
    let at = at.filter(|&at| (surface.mine)(at))?;
    let steps = match unit {
        MouseWheelUnit::Line => f64::from(turned),
        MouseWheelUnit::Point => f64::from(turned) / 50.0,
        MouseWheelUnit::Page => f64::from(turned) * 5.0,
    };
    let (view, factor) = (&editor.setup.view, WHEEL.powf(steps));
    let view = resized(view, surface.viewport, Some(at), factor);
    Some(Action::View(view))
}
