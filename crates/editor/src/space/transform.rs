//! Moving, turning and scaling what is selected by keys: M, R or S, then the mouse or a number, X,
//! Y or Z for an axis, Enter or a click at the end.

use egui::{Event, Key, Modifiers, PointerButton};
use glam::{DMat4, DVec2, DVec3};

use super::drag::{DragConstraint, Handle, SNAP};
use super::gesture::Gesture;
use super::overlay;
use super::pointer::{FINE, PointerContext, axis_of};
use super::projection::{Axis, Projection, from_pos};
use super::projection_of;
use super::scene::Look;
use super::strokes::Strokes;
use super::typed::Typed;
use crate::action::Action;
use crate::document::{At, Edit};
use crate::number::decimals;
use crate::raster::Lines;
use crate::setup::Element;
use crate::state::Editor;
use crate::texts::{Texts, fill};

/// Snap steps: degrees, and parts of the size.
const STEP_TURN: f64 = 15.0;
const STEP_SCALE: f64 = 0.1;

/// A pointer that begins nearer than this to the middle is taken to begin [`BESIDE`] to its right,
/// in points: else the least motion would be a large one.
const NEAR: f64 = 8.0;
const BESIDE: f64 = 80.0;

/// In points: radius of the ring that turns several points, half the side of the square on it that
/// scales them, and how near the pointer must be.
const RING: f64 = 56.0;
const SQUARE: f64 = 6.0;
const REACH: f64 = 5.0;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Move,
    Turn,
    Scale,
}

/// A modal transform at work: a step of the document is open.
#[derive(Clone, Debug)]
pub(super) struct Transform {
    kind: Kind,
    /// The button that holds a handle.
    held: Option<PointerButton>,
    /// How far the pointer has gone, and where it is taken to have begun.
    way: DVec2,
    from: DVec2,
    /// Where the pointer was last.
    last: Option<DVec2>,
    snaps: bool,
    axis: Option<Axis>,
    typed: Typed,
    points: Vec<usize>,
    /// The current point, and where it was.
    current: (usize, DVec3),
    /// The middle of the points at first.
    middle: DVec3,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Next {
    GoesOn,
    Over,
}

impl Transform {
    /// The transform that a key begins.
    pub(super) fn of_key(editor: &Editor, surface: &PointerContext<'_>, key: Key) -> Option<Self> {
        let kind = match key {
            Key::M => Kind::Move,
            Key::R => Kind::Turn,
            Key::S => Kind::Scale,
            _ => return None,
        };
        Self::new(editor, surface, kind, None)
    }

    /// The transform that a button on a handle begins.
    pub(super) fn of_handle(
        editor: &Editor,
        surface: &PointerContext<'_>,
        kind: Kind,
        button: PointerButton,
    ) -> Option<Self> {
        Self::new(editor, surface, kind, Some(button))
    }

    fn new(
        editor: &Editor,
        surface: &PointerContext<'_>,
        kind: Kind,
        held: Option<PointerButton>,
    ) -> Option<Self> {
        let points = editor.all_selected();
        let path = editor.document.path();
        let middle = middle_of(editor, &points);
        let current = editor.document.selection().point;
        let projection = projection_of(editor, surface.viewport);
        let image = projection.image(middle);
        let pointer = surface.context.input(|input| input.pointer.latest_pos());
        let last = pointer.map(from_pos);
        let from = last.filter(|at| at.distance(image) >= NEAR);
        Some(Self {
            kind,
            held,
            way: DVec2::ZERO,
            from: from.unwrap_or(image + DVec2::X * BESIDE),
            last,
            snaps: false,
            axis: None,
            typed: Typed::default(),
            current: (current, path.points.get(current)?.position),
            middle,
            points,
        })
    }

    /// Whether it needs more points than are selected.
    pub(super) fn lacks_points(&self) -> bool {
        self.kind != Kind::Move && self.points.len() < 2
    }

    pub(super) fn held(&self) -> Option<PointerButton> {
        self.held
    }

    /// Handles an event.
    pub(super) fn take(
        &mut self,
        editor: &Editor,
        surface: &PointerContext<'_>,
        event: &Event,
        actions: &mut Vec<Action>,
    ) -> Next {
        let over = |gesture, actions: &mut Vec<Action>| {
            actions.push(Action::Gesture(gesture));
            Next::Over
        };
        match event {
            event if self.typed.take(event) => {}
            Event::PointerMoved(pos) => {
                let fine = surface.context.input(|input| input.modifiers.shift);
                let pos = from_pos(*pos);
                let way = pos - self.last.unwrap_or(pos);
                self.way += if fine { way / FINE } else { way };
                self.last = Some(pos);
            }
            Event::PointerButton {
                button,
                pressed: false,
                ..
            } if self.held == Some(*button) => return over(Gesture::End, actions),
            Event::PointerButton {
                button,
                pressed: true,
                ..
            } => {
                return over(
                    match button {
                        PointerButton::Secondary => Gesture::Cancel,
                        _ => Gesture::End,
                    },
                    actions,
                );
            }
            Event::Key {
                key, pressed: true, ..
            } => match key {
                Key::Escape | Key::Enter => {
                    (surface.context).input_mut(|input| input.consume_key(Modifiers::NONE, *key));
                    let ends = *key == Key::Enter;
                    let gesture = if ends { Gesture::End } else { Gesture::Cancel };
                    return over(gesture, actions);
                }
                Key::Tab => return over(Gesture::End, actions),
                key => match axis_of(*key) {
                    Some(axis) => self.axis = (self.axis != Some(axis)).then_some(axis),
                    None => return Next::GoesOn,
                },
            },
            _ => return Next::GoesOn,
        }
        self.snaps = surface.context.input(|input| input.modifiers.ctrl);
        let projection = projection_of(editor, surface.viewport);
        actions.push(Action::Gesture(self.gesture(editor, &projection)));
        Next::GoesOn
    }

    fn gesture(&self, editor: &Editor, projection: &Projection) -> Gesture {
        match self.kind {
            Kind::Move => {
                let (at, from) = self.current;
                let position = from + self.moved(projection);
                Gesture::Move(
                    Handle::Point(at),
                    Edit::set(At::Point(at), "position", position),
                )
            }
            Kind::Turn | Kind::Scale => {
                let to_middle = DMat4::from_translation(-self.middle);
                let back = DMat4::from_translation(self.middle);
                let matrix = match self.kind {
                    Kind::Turn => {
                        let angle = self.amount(projection).to_radians();
                        DMat4::from_axis_angle(self.about(projection).unit(), angle)
                    }
                    _ => {
                        let factor = self.amount(projection);
                        let mut scale = DVec3::splat(factor);
                        if let Some(axis) = self.axis {
                            scale = DVec3::ONE;
                            scale[axis.index()] = factor;
                        }
                        DMat4::from_scale(scale)
                    }
                };
                let edit = Edit::TransformPoints {
                    points: self.points.clone(),
                    matrix: back * matrix * to_middle,
                    with_targets: false,
                };
                Gesture::Transform(edit, self.words(editor, projection))
            }
        }
    }

    /// The axis that it turns about.
    fn about(&self, projection: &Projection) -> Axis {
        self.axis.unwrap_or_else(|| projection.facing())
    }

    fn moved(&self, projection: &Projection) -> DVec3 {
        if let Some(number) = self.typed.number() {
            return self.axis.unwrap_or(Axis::X).unit() * number;
        }
        let middle = self.middle;
        let pointer = projection.image(middle) + self.way;
        let to = match self.axis {
            Some(axis) => projection.point_on_line(middle, axis, pointer),
            None => projection.point_in_plane(middle, projection.facing(), pointer),
        };
        let mut by = to.map_or(DVec3::ZERO, |to| to - middle);
        if self.snaps {
            let step = projection.space().half_size / SNAP;
            by = (by / step).round() * step;
        }
        by
    }

    /// Degrees of turning, or the factor of scaling.
    fn amount(&self, projection: &Projection) -> f64 {
        if let Some(number) = self.typed.number() {
            return number;
        }
        let middle = projection.image(self.middle);
        let [from, to] = [self.from - middle, self.from + self.way - middle];
        let snapped = |value: f64, step: f64| match self.snaps {
            true => (value / step).round() * step,
            false => value,
        };
        if self.kind == Kind::Scale {
            return snapped(to.length() / from.length(), STEP_SCALE);
        }
        // Negative, since y runs downwards on the screen.
        let seen = -from.perp_dot(to).atan2(from.dot(to)).to_degrees();
        let away = projection.toward()[self.about(projection).index()] < 0.0;
        snapped(if away { -seen } else { seen }, STEP_TURN)
    }

    fn words(&self, editor: &Editor, projection: &Projection) -> String {
        let texts = &editor.texts().space;
        let language = editor.language();
        match self.kind {
            Kind::Move => {
                let half_size = projection.space().half_size;
                // Not the pointer's way: the space may have held them back.
                let (at, from) = self.current;
                let points = &editor.document.path().points;
                let by = points
                    .get(at)
                    .map_or(DVec3::ZERO, |now| now.position - from);
                let [x, y, z] = by
                    .to_array()
                    .map(|by| language.number(by, decimals(half_size)));
                fill(texts.moved_by, &[&x, &y, &z])
            }
            Kind::Turn => {
                let axis = self.about(projection).letter();
                let degrees = language.number(self.amount(projection), 1);
                fill(texts.turned_by, &[&axis, &degrees])
            }
            Kind::Scale => {
                let factor = language.number(self.amount(projection), 3);
                match self.axis {
                    Some(axis) => fill(texts.scaled_along, &[&axis.letter(), &factor]),
                    None => fill(texts.scaled_by, &[&factor]),
                }
            }
        }
    }

    pub(super) fn hint(&self, editor: &Editor, projection: &Projection) -> String {
        let texts: &Texts = editor.texts();
        let words = self.words(editor, projection);
        fill(texts.space.tool_hint, &[&words])
    }

    /// Where its guides lead through, and along which axis or in which plane.
    pub(super) fn guides(
        &self,
        editor: &Editor,
        projection: &Projection,
    ) -> (DVec3, DragConstraint) {
        let through = match self.kind {
            Kind::Move => editor.point().map_or(self.middle, |point| point.position),
            _ => self.middle,
        };
        let along = match self.kind {
            Kind::Turn => Some(self.about(projection)),
            _ => self.axis,
        };
        let fixed = projection.facing();
        (through, DragConstraint { fixed, along })
    }
}

fn middle_of(editor: &Editor, points: &[usize]) -> DVec3 {
    let path = editor.document.path();
    let places = || points.iter().filter_map(|&at| path.points.get(at));
    let sum: DVec3 = places().map(|point| point.position).sum();
    #[allow(clippy::cast_precision_loss)]
    let count = places().count().max(1) as f64;
    sum / count
}

/// The middle of the ring of handles, if several points are selected.
pub(super) fn handles(editor: &Editor, projection: &Projection) -> Option<DVec2> {
    let points = editor.several()?;
    Some(projection.image(middle_of(editor, points)))
}

pub(super) fn handle_at(editor: &Editor, projection: &Projection, pointer: DVec2) -> Option<Kind> {
    let way = pointer - handles(editor, projection)?;
    if (way - square()).abs().max_element() <= SQUARE + 2.0 {
        return Some(Kind::Scale);
    }
    ((way.length() - RING).abs() <= REACH).then_some(Kind::Turn)
}

/// Offset of the square from the middle of the ring.
fn square() -> DVec2 {
    DVec2::new(RING, -RING) * std::f64::consts::FRAC_1_SQRT_2
}

/// Draws the handles; `meant` is the one under the pointer.
pub(super) fn show_handles(look: &Look<'_>, middle: DVec2, meant: Option<Kind>) -> Lines {
    let mut strokes = Strokes::new(look.projection, look.viewport);
    let color = look.colours.of(Element::Segment);
    let width = |kind| if meant == Some(kind) { 2.4 } else { 1.2 };
    for (from, to) in overlay::corners(look, RING) {
        strokes.flat(
            middle + from * RING,
            middle + to * RING,
            width(Kind::Turn),
            color,
        );
    }
    let centre = middle + square();
    let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    let corners = corners.map(|corner| centre + DVec2::from(corner) * SQUARE);
    let ground = look.colours.of(Element::Background);
    strokes.flat(
        centre - DVec2::X * SQUARE,
        centre + DVec2::X * SQUARE,
        2.0 * SQUARE as f32,
        ground,
    );
    for k in 0..4 {
        strokes.flat(corners[k], corners[(k + 1) % 4], width(Kind::Scale), color);
    }
    strokes.finish()
}
