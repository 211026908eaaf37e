//! Moving, turning and scaling what is selected by keys: M, R or S, then the mouse or a number, X,
//! Y or Z for an axis, Enter or a click at the end. What is selected are points of the edited path,
//! or nodes of the scene ([`super::held_nodes`]), whose pivot P moves.

use egui::{Event, Key, Modifiers, PointerButton};
use glam::{DMat3, DMat4, DVec2, DVec3};
use vides_document::{At, Edit};
use vides_raster::Lines;

use super::drag::SNAP;
use super::held_nodes::Motion;
use super::overlay;
use super::projection::{Axis, Projection, from_pos};
use super::scene::Look;
use super::strokes::Strokes;
use super::typed::Typed;
use crate::action::Action;
use crate::number::decimals;
use crate::setup::Element;
use crate::space::surface::{FINE, PointerContext, axis_of, projection_of};
use crate::state::Editor;
use crate::state::space::{DragConstraint, Gesture, Grip, Handle, Held, Kind, Transform};
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

impl Kind {
    /// What a key begins.
    pub(super) const fn of_key(key: Key) -> Option<Self> {
        match key {
            Key::M => Some(Self::Move),
            Key::R => Some(Self::Turn),
            Key::S => Some(Self::Scale),
            _ => None,
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Next {
    GoesOn,
    Over,
}

impl Transform {
    /// The transform that a key begins.
    pub(super) fn of_key(editor: &Editor, surface: &PointerContext<'_>, key: Key) -> Option<Self> {
        Self::new(editor, surface, Kind::of_key(key)?, None)
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
        let current = (current, path.points.get(current)?.position);
        Some(Self {
            current,
            points,
            ..Self::at(surface, (kind, held), middle, &projection)
        })
    }

    /// One that begins at the pointer, with nothing selected yet.
    fn at(
        surface: &PointerContext<'_>,
        (kind, held): (Kind, Option<PointerButton>),
        middle: DVec3,
        projection: &Projection,
    ) -> Self {
        let image = projection.image(middle);
        let pointer = surface.context.input(|input| input.pointer.latest_pos());
        let last = pointer.map(from_pos);
        let from = last.filter(|at| at.distance(image) >= NEAR);
        Self {
            kind,
            held,
            way: DVec2::ZERO,
            from: from.unwrap_or(image + DVec2::X * BESIDE),
            last,
            snaps: false,
            axis: None,
            own: false,
            typed: Typed::default(),
            nodes: None,
            current: (0, DVec3::ZERO),
            middle,
            points: Vec::new(),
        }
    }

    /// That of nodes, or a reason.
    pub(super) fn of_nodes(
        editor: &Editor,
        surface: &PointerContext<'_>,
        kind: Kind,
        grip: Grip,
        held: Option<PointerButton>,
    ) -> Result<Self, String> {
        let nodes = Held::new(editor, grip, kind != Kind::Scale)?;
        let projection = projection_of(editor, surface.viewport);
        Ok(Self {
            nodes: Some(Box::new(nodes.clone())),
            ..Self::at(surface, (kind, held), nodes.middle(), &projection)
        })
    }

    /// What a button took lay here at first.
    pub(super) fn pressed_at(mut self, at: DVec2) -> Self {
        self.last = Some(at);
        self
    }

    /// Chooses an axis: of the parent, then the node's own, then none.
    fn choose_axis(&mut self, axis: Axis) {
        let again = self.axis == Some(axis);
        (self.axis, self.own) = match (again, self.own) {
            (false, _) => (Some(axis), false),
            (true, false) if self.nodes.is_some() => (Some(axis), true),
            (true, _) => (None, false),
        };
    }

    /// Whether it needs more points than are selected.
    pub(super) fn lacks_points(&self) -> bool {
        self.nodes.is_none() && self.kind != Kind::Move && self.points.len() < 2
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
                    Some(axis) => self.choose_axis(axis),
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
        if let Some(nodes) = &self.nodes {
            return self.of_held(editor, nodes, projection);
        }
        match self.kind {
            Kind::Move => {
                let (at, from) = self.current;
                let [low, high] = editor.room_of(at);
                let position = (from + self.moved(projection)).clamp(low, high);
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
                    _ => DMat4::from_scale(self.factors(projection)),
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

    /// The same of nodes.
    fn of_held(&self, editor: &Editor, nodes: &Held, projection: &Projection) -> Gesture {
        let basis = nodes.basis(self.own);
        let motion = match self.kind {
            Kind::Move => Motion::Move(basis * self.moved(projection)),
            Kind::Turn => {
                let axis = self.about(projection);
                let named = self.axis.map(|axis| (axis, self.own));
                Motion::Turn(named, basis.col(axis.index()), self.amount(projection))
            }
            Kind::Scale => Motion::Scale(basis, self.factors(projection)),
        };
        match nodes.changed(motion) {
            Some(change) => Gesture::Nodes(change, self.words(editor, projection)),
            None => Gesture::Refused(editor.texts().space.pivot_of_flat),
        }
    }

    /// Along which axes it scales, and how much.
    fn factors(&self, projection: &Projection) -> DVec3 {
        let factor = self.amount(projection);
        let mut factors = DVec3::splat(factor);
        if let Some(axis) = self.axis {
            factors = DVec3::ONE;
            factors[axis.index()] = factor;
        }
        factors
    }

    /// The axis that it turns about.
    fn about(&self, projection: &Projection) -> Axis {
        let facing = || match &self.nodes {
            Some(nodes) => nodes.facing(nodes.basis(false), projection),
            None => projection.facing(),
        };
        self.axis.unwrap_or_else(facing)
    }

    /// Whether the axis that it turns about points away from the viewer.
    fn turns_away(&self, projection: &Projection) -> bool {
        let axis = self.about(projection);
        let Some(nodes) = &self.nodes else {
            return projection.toward()[axis.index()] < 0.0;
        };
        let way = nodes.way(nodes.basis(self.own).col(axis.index()));
        (way.dot(projection.toward()) < 0.0) != nodes.is_mirrored()
    }

    fn moved(&self, projection: &Projection) -> DVec3 {
        if let Some(number) = self.typed.number() {
            return self.axis.unwrap_or(Axis::X).unit() * number;
        }
        let middle = self.middle;
        let mut by = if let Some(nodes) = &self.nodes {
            nodes.followed(nodes.basis(self.own), self.axis, projection, self.way)
        } else {
            let pointer = projection.image(middle) + self.way;
            let to = match self.axis {
                Some(axis) => projection.point_on_line(middle, axis, pointer),
                None => projection.point_in_plane(middle, projection.facing(), pointer),
            };
            to.map_or(DVec3::ZERO, |to| to - middle)
        };
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
        let away = self.turns_away(projection);
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
                let of_points = points.get(at).map(|now| now.position - from);
                let by = match &self.nodes {
                    Some(nodes) => nodes.basis(self.own) * self.moved(projection),
                    None => of_points.unwrap_or_default(),
                };
                let [x, y, z] = by
                    .to_array()
                    .map(|by| language.number(by, decimals(half_size)));
                let pivot = self.nodes.as_ref().and_then(|nodes| nodes.pivot_of());
                let Some(node) = pivot else {
                    return fill(texts.moved_by, &[&x, &y, &z]);
                };
                let words = fill(texts.pivot_moved, &[&x, &y, &z]);
                match editor.pivot_makes_keys(node) {
                    true => fill(texts.pivot_keys, &[&words]),
                    false => words,
                }
            }
            Kind::Turn => {
                let axis = self.letter(editor, self.about(projection));
                let amount = self.amount(projection);
                let degrees = language.number(amount, 1);
                let words = fill(texts.turned_by, &[&axis, &degrees]);
                let nodes = self.nodes.as_ref().filter(|_| amount.abs() > 180.0);
                match nodes.is_some_and(|nodes| nodes.turns_by_quaternions(editor)) {
                    true => fill(editor.texts().node.turned_too_far, &[&words]),
                    false => words,
                }
            }
            Kind::Scale => {
                let factor = language.number(self.amount(projection), 3);
                match self.axis {
                    Some(axis) => {
                        let axis = self.letter(editor, axis);
                        fill(texts.scaled_along, &[&axis, &factor])
                    }
                    None => fill(texts.scaled_by, &[&factor]),
                }
            }
        }
    }

    /// The name of an axis.
    fn letter(&self, editor: &Editor, axis: Axis) -> String {
        match self.own {
            true => fill(editor.texts().space.own_axis, &[&axis.letter()]),
            false => axis.letter().to_owned(),
        }
    }

    pub(super) fn hint(&self, editor: &Editor, projection: &Projection) -> String {
        let texts: &Texts = editor.texts();
        let words = self.words(editor, projection);
        fill(texts.space.tool_hint, &[&words])
    }

    /// Where its guides lead through, and along which axis or in which plane.
    /// Those of nodes are drawn by `trail::guides`.
    pub(super) fn guides(
        &self,
        editor: &Editor,
        projection: &Projection,
    ) -> Option<(DVec3, DragConstraint)> {
        if self.nodes.is_some() {
            return None;
        }
        let through = match self.kind {
            Kind::Move => editor.point().map_or(self.middle, |point| point.position),
            _ => self.middle,
        };
        let along = match self.kind {
            Kind::Turn => Some(self.about(projection)),
            _ => self.axis,
        };
        let fixed = projection.facing();
        let edge_on = None;
        Some((
            through,
            DragConstraint {
                fixed,
                along,
                edge_on,
            },
        ))
    }

    /// Where nodes are held, and the ways in the space along which they move or turn.
    pub(super) fn lines(&self, projection: &Projection) -> Option<(DVec3, Vec<DVec3>)> {
        let nodes = self.nodes.as_deref()?;
        let basis: DMat3 = nodes.basis(self.own);
        let one = match self.kind {
            Kind::Turn => Some(self.about(projection)),
            _ => self.axis,
        };
        let shown = Axis::ALL.into_iter();
        let shown = shown.filter(|axis| one.is_none_or(|one| one == *axis));
        let ways = shown.map(|axis| nodes.way(basis.col(axis.index())));
        Some((nodes.middle(), ways.collect()))
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

/// The middle of the ring of handles, if several points or any nodes are selected.
pub(super) fn handles(editor: &Editor, projection: &Projection) -> Option<DVec2> {
    if editor.means_nodes() {
        return Some(projection.image(super::nodes::middle(editor)?));
    }
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
