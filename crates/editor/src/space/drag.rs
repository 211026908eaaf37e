//! What a drag makes of a point, a target or a roll: from the pointer's place to the edit.

use glam::{DVec2, DVec3};
use vides_document::{At, Document, Edit, Selection, no_longer_ahead};
use vides_engine::math::orientation;
use vides_engine::path::{Orientation, Target, UpVector, ahead};

use super::projection::{Axis, EDGE_ON, Projection};
use super::scene::FLOOR_CELLS;
use super::tangents;
use crate::state::Editor;
use crate::state::space::{DragConstraint, Handle, Joint};

/// Length of the VUP arrow, in units of the space's `half_size`.
pub(super) const VUP_LENGTH: f64 = 0.25;

impl Handle {
    /// Whether it belongs to a key of the edited path.
    pub(super) const fn is_of_path(self) -> bool {
        !matches!(self, Self::Node(_) | Self::Key(..))
    }
}

/// Snap steps in a `half_size` of the space: five between two lines of the floor.
pub(super) const SNAP: f64 = 5.0 * FLOOR_CELLS as f64 / 2.0;

/// Snap step of a roll, in degrees.
const SNAP_ROLL: f64 = 15.0;

impl DragConstraint {
    /// The plane of a button (thesis A.3.1), or of a held X, Y or Z, whose coordinate stays. If it
    /// is seen edge-on, the line in it that is seen.
    pub(super) fn keeping(projection: &Projection, kept: Axis) -> Self {
        let edge_on = Some(kept).filter(|&kept| projection.share_seen(kept) < EDGE_ON);
        let fixed = edge_on.map_or(kept, |_| projection.facing());
        let along = Axis::ALL
            .into_iter()
            .find(|&axis| fixed != kept && axis != kept && axis != fixed);
        Self {
            fixed,
            along,
            edge_on,
        }
    }

    fn moving(self) -> impl Iterator<Item = Axis> {
        let others = self.fixed.others().into_iter();
        others.filter(move |&axis| self.along.is_none_or(|along| along == axis))
    }
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Motion {
    pub(super) freedom: DragConstraint,
    pub(super) snaps: bool,
    /// The pointer, or where fine dragging takes it to be.
    pub(super) pointer: DVec2,
    /// Where it began, and a typed distance towards the pointer; for a roll, the roll in degrees.
    pub(super) typed: Option<(DVec3, f64)>,
    /// What the other tangent does if one is dragged.
    pub(super) joint: Joint,
}

#[derive(Clone, Debug, PartialEq)]
// One is made at a time.
#[allow(clippy::large_enum_variant)]
pub(super) enum Outcome {
    Edit(Edit),
    /// The circle of VUP is seen edge-on: nothing moves.
    CircleEdgeOn,
    /// The pointer is at the centre of the circle, or what was held is gone.
    Nothing,
}

/// The point under the pointer in the plane or on the line through `point`, its moving coordinates
/// clamped to a box; none if the plane is seen edge-on.
pub(super) fn follow(
    projection: &Projection,
    point: DVec3,
    motion: &Motion,
    [low, high]: Room,
) -> Option<DVec3> {
    let &Motion {
        freedom, pointer, ..
    } = motion;
    let mut found = match freedom.along {
        None => projection.point_in_plane(point, freedom.fixed, pointer)?,
        Some(axis) => projection.point_on_line(point, axis, pointer)?,
    };
    if let Some((from, far)) = motion.typed {
        found = from + (found - from).normalize_or_zero() * far;
    }
    let snaps = motion.snaps && motion.typed.is_none();
    let space = projection.space();
    for at in freedom.moving().map(Axis::index) {
        let (coordinate, centre) = (&mut found[at], space.centre[at]);
        if snaps {
            let steps = ((*coordinate - centre) / space.half_size * SNAP).round();
            *coordinate = centre + steps * space.half_size / SNAP;
        }
        // Turns −0 into 0, since it is shown.
        *coordinate = coordinate.clamp(low[at], high[at]) + 0.0;
    }
    Some(found)
}

/// Two corners of a box, the low one first.
pub(super) type Room = [DVec3; 2];

/// The movement space.
pub(super) fn cube(projection: &Projection) -> Room {
    [projection.space().low(), projection.space().high()]
}

impl Editor {
    /// Where a selected point may go with all others that are selected: none of them leaves the
    /// movement space, and one outside goes no farther out.
    pub(super) fn room_of(&self, at: usize) -> Room {
        let path = self.document.path();
        let [low, high] = [path.space.low(), path.space.high()];
        let place = |at: usize| path.points.get(at).map(|point| point.position);
        let Some(here) = place(at) else {
            return [low, high];
        };
        let selected = self.all_selected();
        let others = selected.iter().filter(|&&other| other != at);
        let others = others.filter_map(|&other| place(other));
        others.fold([low.min(here), high.max(here)], |[from, to], other| {
            [
                from.max(here + (low - other).min(DVec3::ZERO)),
                to.min(here + (high - other).max(DVec3::ZERO)),
            ]
        })
    }
}

/// The edit that moves what is held to the pointer; a point or a target stays in its room.
pub(super) fn outcome(
    document: &Document,
    projection: &Projection,
    held: Handle,
    motion: &Motion,
    room: Room,
) -> Outcome {
    let edit = match held {
        Handle::Vup => return roll(document, projection, motion),
        Handle::Vpn => {
            let Some(tip) = current_tip(document) else {
                return Outcome::Nothing;
            };
            let to = follow(projection, tip, motion, room);
            to.and_then(|to| move_target(document, to))
        }
        Handle::Control(_) | Handle::Node(_) | Handle::Key(..) => return Outcome::Nothing,
        Handle::Point(at) => {
            let Some(point) = document.path().points.get(at) else {
                return Outcome::Nothing;
            };
            let to = follow(projection, point.position, motion, room);
            to.map(|position| Edit::set(At::Point(at), "position", position))
        }
        Handle::Tangent(side) => {
            let Some(tip) = tangents::tip(document, side) else {
                return Outcome::Nothing;
            };
            // Tangents of a point near a face reach beyond it.
            let [low, high] = cube(projection);
            let wide = [low.min(tip) - (high - low), high.max(tip) + (high - low)];
            let to = follow(projection, tip, motion, wide);
            to.and_then(|to| tangents::moved(document, side, to, motion.joint))
        }
    };
    edit.map_or(Outcome::Nothing, Outcome::Edit)
}

pub(super) fn current_tip(document: &Document) -> Option<DVec3> {
    let selection = document.selection();
    let point = document.path().points.get(selection.point)?;
    let orientation = current(document)?;
    Some(tip_of(orientation.target, point.position))
}

/// The current orientation, with a target in its view direction if it looks ahead.
fn current(document: &Document) -> Option<Orientation> {
    let Selection { point, orientation } = document.selection();
    document
        .path()
        .points
        .get(point)?
        .orientations
        .get(orientation)?;
    no_longer_ahead(document.path(), point, orientation).ok()
}

/// The edit that moves the current target; coordinates that stay keep every bit, also of an offset.
pub(super) fn move_target(document: &Document, to: DVec3) -> Option<Edit> {
    let selection = document.selection();
    let (point, at) = (selection.point, selection.orientation);
    let support = document.path().points.get(point)?;
    let mut orientation = current(document)?;
    let position = support.position;
    let tip = tip_of(orientation.target, position);
    match &mut orientation.target {
        Target::Absolute(target) => *target = to,
        Target::Relative(offset) => {
            for axis in Axis::ALL.map(Axis::index) {
                if to[axis].to_bits() != tip[axis].to_bits() {
                    offset[axis] = to[axis] - position[axis];
                }
            }
        }
    }
    Some(Edit::SetOrientation {
        point,
        at,
        orientation,
    })
}

pub(super) fn tip_of(target: Target, position: DVec3) -> DVec3 {
    match target {
        Target::Absolute(target) => target,
        Target::Relative(offset) => position + offset,
    }
}

/// The edit that turns the current VUP towards the pointer.
fn roll(document: &Document, projection: &Projection, motion: &Motion) -> Outcome {
    let selection = document.selection();
    let Some(support) = document.path().points.get(selection.point) else {
        return Outcome::Nothing;
    };
    let Some(orientation) = support.orientations.get(selection.orientation) else {
        return Outcome::Nothing;
    };
    let view = ahead::view(document.path(), selection.point, selection.orientation);
    let rolled = match motion.typed {
        Some((_, typed)) => orientation::wrap_degrees(typed),
        None if circle_share(projection, view) < EDGE_ON => return Outcome::CircleEdgeOn,
        None => match rolled(document, projection, (orientation, view), motion) {
            Some(rolled) => rolled,
            None => return Outcome::Nothing,
        },
    };
    Outcome::Edit(Edit::SetOrientation {
        point: selection.point,
        at: selection.orientation,
        orientation: Orientation {
            roll: rolled,
            ..orientation.clone()
        },
    })
}

/// The roll at which the current VUP points to the pointer.
fn rolled(
    document: &Document,
    projection: &Projection,
    (current, view): (&Orientation, DVec3),
    motion: &Motion,
) -> Option<f64> {
    let Selection { point, orientation } = document.selection();
    let support = document.path().points.get(point)?;
    let way = motion.pointer - projection.image(support.position);
    // Relative to the level axes, or else to the up vector that the current roll gives.
    let (axes, counted) = match current.own.up {
        UpVector::Axis => (projection.space().up.level_axes(view), 0.0),
        _ => {
            let up = document.up(point, orientation).ok()?;
            ((up.cross(view), up), current.roll)
        }
    };
    let turn = roll_towards(projection, axes, way)?;
    let roll = orientation::wrap_degrees(counted + turn);
    Some(match motion.snaps {
        true => (roll / SNAP_ROLL).round() * SNAP_ROLL + 0.0,
        false => roll,
    })
}

/// The visible share of the VUP circle's area.
pub(super) fn circle_share(projection: &Projection, view: DVec3) -> f64 {
    projection.toward().dot(view).abs()
}

/// The roll in degrees with which the image of VUP points along `way`, if U₀ and V₀ are right and
/// up without it; none if that has no direction.
///
/// VUP is V₀·cos φ − U₀·sin φ. With the images a and b of V₀ and U₀, φ follows directly from
/// way × (a·cos φ − b·sin φ) = 0, where the thesis halves an interval (6.2.3).
pub(super) fn roll_towards(
    projection: &Projection,
    (u, v): (DVec3, DVec3),
    way: DVec2,
) -> Option<f64> {
    let (a, b) = (projection.image_of_way(v), projection.image_of_way(u));
    let (sin, cos) = (way.perp_dot(a), way.perp_dot(b));
    if !(sin != 0.0 || cos != 0.0) {
        return None;
    }
    let angle = sin.atan2(cos);
    let image = a * angle.cos() - b * angle.sin();
    let turned = if image.dot(way) < 0.0 {
        angle + std::f64::consts::PI
    } else {
        angle
    };
    Some(orientation::wrap_degrees(turned.to_degrees()))
}

#[cfg(test)]
#[path = "drag_tests.rs"]
mod tests;
