//! The mouse in the movement window: from egui's events, in their order, to
//! edits of the document and changes of the view. Keys go on to [`keyboard`].

use egui::{Context, CursorIcon, Event, Key, Modifiers, MouseWheelUnit, PointerButton, Pos2, Rect};
use glam::{DVec2, DVec3};

use super::drag::{self, Freedom, Handle, Outcome};
use super::keyboard::{self, NUDGES};
use super::picking;
use super::projection::{Axis, Projection, from_pos};
use crate::path::Target;
use crate::setup::View;
use crate::state::Editor;
use crate::texts::{Texts, fill};

/// A press that moves no farther than this is a press and no drag, in points:
/// hands tremble.
const STILL: f32 = 2.0;

/// With Shift a drag is so many times finer.
const FINE: f64 = 10.0;

/// Degrees for a point on the screen.
const TURN: f64 = 0.35;

/// What a step of the wheel makes of the size.
pub(super) const WHEEL: f64 = 1.1;

/// What the pointer is doing.
#[derive(Debug, Default)]
pub(super) struct PointerController {
    /// A button is down.
    hold: Option<Hold>,
    /// Keys that move something are down; a step of the document is open.
    pub(super) nudging: bool,
    /// What lies under the pointer.
    pub(super) hover: Option<Handle>,
    /// Where the last press without motion of the right button asks for a menu.
    pub(super) menu: Option<(Pos2, Option<Handle>)>,
}

/// The axis across the plane in which each button drags (thesis A.3.1).
pub(super) const PLANES: [(PointerButton, Axis); 3] = [
    (PointerButton::Primary, Axis::X),
    (PointerButton::Middle, Axis::Y),
    (PointerButton::Secondary, Axis::Z),
];

/// A button that is down.
#[derive(Clone, Copy, Debug)]
struct Hold {
    button: PointerButton,
    /// Where it was pressed.
    pressed: Pos2,
    /// Where the pointer is.
    now: Pos2,
    /// On what.
    what: Option<Handle>,
    /// In which coordinates it moves.
    freedom: Freedom,
    /// From the pointer to where it is taken to be, after fine motions.
    lag: DVec2,
    /// It goes by steps.
    snaps: bool,
    /// The view as it was.
    view: View,
    /// Empty space is shifted instead of turned.
    shifts: bool,
    /// It has moved.
    moved: bool,
}

/// Where the pointer works.
pub(super) struct PointerContext<'a> {
    pub(super) context: &'a Context,
    pub(super) viewport: Rect,
    /// Whether the pointer at a place means the movement window.
    pub(super) mine: &'a dyn Fn(Pos2) -> bool,
    /// Whether the keyboard does.
    pub(super) keyboard: bool,
}

impl PointerController {
    /// A button is down.
    pub(super) fn is_busy(&self) -> bool {
        self.hold.is_some()
    }

    /// What is dragged: what it is, and in which coordinates.
    pub(super) fn dragged(&self) -> Option<(Handle, Freedom)> {
        let hold = self.hold.filter(|hold| hold.moved)?;
        Some((hold.what?, hold.freedom))
    }

    /// Something is on its way: a handle, or the view.
    pub(super) fn moves(&self) -> bool {
        self.hold.is_some_and(|hold| hold.moved)
    }

    /// What the buttons would do with what lies under the pointer; where a drag goes
    /// while one is down.
    pub(super) fn hint(&self, texts: &Texts, projection: &Projection) -> Option<String> {
        let texts = &texts.space;
        match (self.dragged(), self.hover) {
            (Some((Handle::Vup, _)), _) => Some(texts.rolling.to_owned()),
            (Some((_, freedom)), _) => Some(match freedom.along {
                None => fill(texts.in_plane, &[&freedom.fixed.letter()]),
                Some(along) => fill(texts.on_line, &[&along.letter()]),
            }),
            (None, Some(Handle::Vup)) if !self.is_busy() => Some(texts.roll_hint.to_owned()),
            (None, Some(_)) if !self.is_busy() => {
                let [left, middle, right] =
                    PLANES.map(|(_, axis)| Freedom::of_button(projection, axis).fixed.letter());
                Some(fill(texts.drag_hint, &[&left, &middle, &right]))
            }
            _ => None,
        }
    }

    /// Takes the events of a pass.
    pub(super) fn work(editor: &mut Editor, surface: &PointerContext<'_>) {
        let events = surface.context.input(|input| input.events.clone());
        let mut events = events.into_iter().peekable();
        while let Some(event) = events.next() {
            // Of a row of motions only where it leads to counts.
            let more = matches!(
                (&event, events.peek()),
                (Event::PointerMoved(_), Some(Event::PointerMoved(_)))
            );
            if !more {
                take(editor, surface, event);
            }
        }
        // Ctrl may come and go while the pointer rests.
        let snaps = surface.context.input(|input| input.modifiers.ctrl);
        if let Some(hold) = editor.space.pointer.hold
            && hold.moved
            && hold.snaps != snaps
        {
            motion(editor, surface.context, surface.viewport, hold.now);
        }
        // The release may have been lost with the window's focus.
        let (down, nudged) = surface.context.input(|input| {
            let hold = editor.space.pointer.hold;
            let down = hold.is_none_or(|hold| input.pointer.button_down(hold.button));
            let nudged = NUDGES.iter().any(|&key| input.key_down(key));
            (down, nudged)
        });
        if !down {
            release(editor);
        }
        if !nudged {
            keyboard::end_nudge(editor);
        }
        let projection = Projection::new(&editor.setup.view, surface.viewport);
        let controller = &editor.space.pointer;
        let pointer = surface.context.input(|input| input.pointer.latest_pos());
        let hover = match (&controller.hold, pointer) {
            (Some(hold), _) => hold.what,
            (None, Some(at)) if (surface.mine)(at) => picking::pick(
                &editor.document,
                &projection,
                &editor.setup.shown,
                from_pos(at),
                true,
            ),
            _ => None,
        };
        editor.space.pointer.hover = hover;
    }

    /// The shape of the pointer.
    pub(super) fn cursor(&self) -> CursorIcon {
        match (&self.hold, self.hover) {
            (Some(hold), _) if hold.moved && hold.what.is_some() => CursorIcon::Crosshair,
            (Some(hold), _) if hold.shifts => CursorIcon::Move,
            (Some(_), _) => CursorIcon::Grabbing,
            (None, Some(_)) => CursorIcon::Grab,
            (None, None) => CursorIcon::Default,
        }
    }
}

fn take(editor: &mut Editor, surface: &PointerContext<'_>, event: Event) {
    match event {
        Event::PointerButton {
            pos,
            button,
            pressed: true,
            modifiers,
        } if editor.space.pointer.hold.is_none() && (surface.mine)(pos) => {
            press(editor, surface, pos, button, modifiers);
        }
        Event::PointerButton {
            pos,
            button,
            pressed: false,
            ..
        } if editor
            .space
            .pointer
            .hold
            .is_some_and(|hold| hold.button == button) =>
        {
            motion(editor, surface.context, surface.viewport, pos);
            release(editor);
        }
        Event::PointerMoved(pos) => motion(editor, surface.context, surface.viewport, pos),
        Event::MouseWheel { unit, delta, .. } => {
            let at = surface.context.input(|input| input.pointer.latest_pos());
            if let Some(at) = at.filter(|&at| (surface.mine)(at)) {
                let steps = match unit {
                    MouseWheelUnit::Line => f64::from(delta.y),
                    MouseWheelUnit::Point => f64::from(delta.y) / 50.0,
                    MouseWheelUnit::Page => f64::from(delta.y) * 5.0,
                };
                resize(
                    &mut editor.setup.view,
                    surface.viewport,
                    Some(at),
                    WHEEL.powf(steps),
                );
            }
        }
        Event::Key {
            key: Key::Escape,
            pressed: true,
            ..
        } if editor.space.pointer.hold.is_some() => {
            cancel(editor);
            surface
                .context
                .input_mut(|input| input.consume_key(Modifiers::NONE, Key::Escape));
        }
        Event::Key {
            key,
            pressed: true,
            modifiers,
            ..
        } => {
            if let Some(kept) = axis_of(key)
                && let Some(hold) = &mut editor.space.pointer.hold
                && matches!(hold.what, Some(Handle::Point(_) | Handle::Vpn))
            {
                let projection = Projection::new(&editor.setup.view, surface.viewport);
                hold.freedom = Freedom::of_key(&projection, kept);
                let now = hold.now;
                motion(editor, surface.context, surface.viewport, now);
            } else if surface.keyboard && editor.space.pointer.hold.is_none() {
                keyboard::press(editor, surface, key, modifiers);
            }
        }
        _ => {}
    }
}

/// The axis that a key stands for.
fn axis_of(key: Key) -> Option<Axis> {
    match key {
        Key::X => Some(Axis::X),
        Key::Y => Some(Axis::Y),
        Key::Z => Some(Axis::Z),
        _ => None,
    }
}

fn press(
    editor: &mut Editor,
    surface: &PointerContext<'_>,
    pos: Pos2,
    button: PointerButton,
    modifiers: Modifiers,
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
    keyboard::end_nudge(editor);
    let left = button == PointerButton::Primary;
    let projection = Projection::new(&editor.setup.view, surface.viewport);
    let freedom = match held {
        Some(kept) if left => Freedom::of_key(&projection, kept),
        _ => Freedom::of_button(&projection, plane),
    };
    let what = picking::pick(
        &editor.document,
        &projection,
        &editor.setup.shown,
        from_pos(pos),
        left && held.is_none(),
    );
    editor.message = None;
    if what.is_some() {
        // All that can be taken hold of belongs to a key.
        editor.playing.leave();
    }
    if let Some(Handle::Point(at)) = what {
        make_current(editor, at);
    }
    editor.space.pointer.hold = Some(Hold {
        button,
        pressed: pos,
        now: pos,
        what,
        freedom,
        lag: DVec2::ZERO,
        snaps: false,
        view: editor.setup.view,
        shifts: what.is_none() && (button == PointerButton::Middle || modifiers.shift),
        moved: false,
    });
}

/// Makes another point current.
pub(super) fn make_current(editor: &mut Editor, at: usize) {
    if at != editor.document.selection().point
        && let Err(error) = editor.document.select(at, 0)
    {
        editor.complain_of(&error);
    }
}

pub(super) fn motion(editor: &mut Editor, context: &Context, viewport: Rect, pos: Pos2) {
    let Some(mut hold) = editor.space.pointer.hold else {
        return;
    };
    let modifiers = context.input(|input| input.modifiers);
    if modifiers.shift {
        hold.lag -= (from_pos(pos) - from_pos(hold.now)) * (1.0 - 1.0 / FINE);
    }
    hold.snaps = modifiers.ctrl;
    hold.now = pos;
    if !hold.moved {
        let way = pos - hold.pressed;
        if way.x.abs().max(way.y.abs()) <= STILL {
            editor.space.pointer.hold = Some(hold);
            return;
        }
        hold.moved = true;
        if hold.what.is_some() {
            editor.document.begin_step();
        }
    }
    editor.space.pointer.hold = Some(hold);
    match hold.what {
        Some(what) => pull(editor, viewport, what, &hold),
        None => turn(&mut editor.setup.view, viewport, &hold),
    }
}

/// Brings what is held under the pointer.
fn pull(editor: &mut Editor, viewport: Rect, what: Handle, hold: &Hold) {
    // Somebody else ended the step (an undo while the button is down): what
    // follows would not belong to it.
    if !editor.document.in_step() {
        editor.space.pointer.hold = None;
        return;
    }
    let projection = Projection::new(&editor.setup.view, viewport);
    let texts = &editor.texts().space;
    let pointer = from_pos(hold.now) + hold.lag;
    let (document, freedom) = (&editor.document, hold.freedom);
    match drag::outcome(document, &projection, what, freedom, hold.snaps, pointer) {
        Outcome::Edit(edit) => {
            if editor.edit(edit) {
                tell_place(editor, what);
            }
        }
        Outcome::CircleEdgeOn => editor.complain(texts.circle_edge_on),
        Outcome::Nothing => {}
    }
}

/// Shows in the output field where what is held has come to.
pub(super) fn tell_place(editor: &mut Editor, what: Handle) {
    let selection = editor.document.selection();
    let Some(point) = editor.document.path().points.get(selection.point) else {
        return;
    };
    let Some(orientation) = point.orientations.get(selection.orientation) else {
        return;
    };
    let texts = &editor.texts().space;
    let number = |value: f64| editor.language().number(value, 3);
    let place = |text: &str, v: DVec3| fill(text, &[&number(v.x), &number(v.y), &number(v.z)]);
    let text = match what {
        Handle::Point(_) => place(texts.position_at, point.position),
        Handle::Vpn => match orientation.target {
            Target::Absolute(target) => place(texts.target_at, target),
            Target::Relative(offset) => place(texts.offset_at, offset),
        },
        Handle::Vup => fill(
            texts.roll_at,
            &[&editor.language().number(orientation.roll, 1)],
        ),
    };
    editor.say(text);
}

/// Turns or shifts the space by a drag in its empty part.
fn turn(view: &mut View, viewport: Rect, hold: &Hold) {
    let way = from_pos(hold.now) - from_pos(hold.pressed);
    let mut changed = hold.view;
    if hold.shifts {
        let scale = Projection::new(&hold.view, viewport).scale();
        changed.shift[0] += way.x / scale;
        changed.shift[1] -= way.y / scale;
    } else {
        changed.rotation += way.x * TURN;
        changed.tilt += way.y * TURN;
    }
    *view = changed.in_range();
}

/// Changes the size. What lies under the pointer stays there; the smaller the
/// space gets, the more it comes back to the middle.
pub(super) fn resize(view: &mut View, viewport: Rect, pointer: Option<Pos2>, factor: f64) {
    let size = (view.size * factor).clamp(View::MIN_SIZE, View::MAX_SIZE);
    if let Some(pointer) = pointer.filter(|_| size > view.size) {
        let away = from_pos(pointer) - from_pos(viewport.center());
        let unit = Projection::new(view, viewport).scale();
        let grown = unit * size / view.size;
        view.shift[0] += away.x / grown - away.x / unit;
        view.shift[1] -= away.y / grown - away.y / unit;
    } else if size < view.size {
        let share = ((size - 1.0) / (view.size - 1.0)).clamp(0.0, 1.0);
        let share = if view.size > 1.0 { share } else { 0.0 };
        view.shift = view.shift.map(|shift| shift * share);
    }
    view.size = size;
    *view = view.in_range();
}

fn release(editor: &mut Editor) {
    let Some(hold) = editor.space.pointer.hold.take() else {
        return;
    };
    if hold.moved {
        if hold.what.is_some() {
            editor.let_go();
        }
    } else if hold.button == PointerButton::Secondary {
        editor.space.pointer.menu = Some((hold.pressed, hold.what));
    }
}

/// Takes back what was begun.
fn cancel(editor: &mut Editor) {
    let Some(hold) = editor.space.pointer.hold.take() else {
        return;
    };
    if hold.moved {
        match hold.what {
            Some(_) => editor.document.cancel_step(),
            None => editor.setup.view = hold.view,
        }
        editor.message = None;
    }
}

/// The place that a drag's guides lead through.
pub(super) fn place_held(editor: &Editor, what: Handle) -> Option<DVec3> {
    match what {
        Handle::Point(at) => {
            let points = &editor.document.path().points;
            points.get(at).map(|point| point.position)
        }
        Handle::Vpn => drag::current_tip(&editor.document),
        Handle::Vup => None,
    }
}
