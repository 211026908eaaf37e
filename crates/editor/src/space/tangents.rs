//! The tangents that the current point owns: their handles, a third of a tangent away as the inner
//! points of a Bézier curve are, and how the tangent on one side follows the other.

use glam::DVec3;
use vides_document::{At, Document, Edit};
use vides_engine::path::{Tangents, curve};
use vides_raster::Lines;

use super::scene::Look;
use super::strokes::Strokes;
use crate::setup::Element;
use crate::state::Editor;
use crate::state::space::{Joint, Side};

/// Two tangents whose directions differ by less than this, in radians, make no corner.
const STRAIGHT: f64 = 1e-6;

/// Radius of a handle, in points, and the width of the line to it.
const HANDLE: f64 = 3.5;
const WIDTH: f32 = 1.2;

impl Side {
    const BOTH: [Self; 2] = [Self::Before, Self::After];
}

impl Joint {
    pub(crate) const ALL: [Self; 3] = [Self::Smooth, Self::Mirrored, Self::Corner];

    /// The `other` tangent after one was dragged to `led`.
    fn follow(self, led: DVec3, other: DVec3) -> DVec3 {
        match self {
            Self::Smooth => {
                let way = led.try_normalize();
                way.map_or(other, |way| way * other.length())
            }
            Self::Mirrored => led,
            Self::Corner => other,
        }
    }

    /// The tangents joined this way: along their mean direction, with the mean length if mirrored.
    fn of(self, tangents: Tangents) -> Tangents {
        let Tangents { before, after } = tangents;
        let sum = before.normalize_or_zero() + after.normalize_or_zero();
        // If they are opposite, the direction after the point counts.
        let way = sum.try_normalize().or_else(|| after.try_normalize());
        let (Some(way), false) = (way, self.holds(tangents)) else {
            return tangents;
        };
        let mean = f64::midpoint(before.length(), after.length());
        let with = |before: f64, after: f64| Tangents {
            before: way * before,
            after: way * after,
        };
        match self {
            Self::Smooth => with(before.length(), after.length()),
            Self::Mirrored => with(mean, mean),
            Self::Corner => tangents,
        }
    }

    fn holds(self, Tangents { before, after }: Tangents) -> bool {
        match self {
            Self::Smooth => {
                let [one, other] = [before, after].map(DVec3::try_normalize);
                let ways = one.zip(other);
                ways.is_none_or(|(one, other)| one.distance(other) <= STRAIGHT)
            }
            Self::Mirrored => before.distance(after) <= STRAIGHT * before.length(),
            Self::Corner => true,
        }
    }
}

/// The handle of a tangent that the current point owns, if the curve has that side.
pub(super) fn tip(document: &Document, side: Side) -> Option<DVec3> {
    let path = document.path();
    let at = document.selection().point;
    let point = path.points.get(at)?;
    let tangents = point.tangents?;
    match side {
        Side::Before if at > 0 || path.closed => Some(point.position - tangents.before / 3.0),
        Side::After if at < path.segment_count() => Some(point.position + tangents.after / 3.0),
        _ => None,
    }
}

pub(super) fn tips(document: &Document) -> impl Iterator<Item = (Side, DVec3)> {
    let tips = Side::BOTH.map(|side| tip(document, side).map(|tip| (side, tip)));
    tips.into_iter().flatten()
}

/// The edit that moves the handle of a tangent.
pub(super) fn moved(document: &Document, side: Side, to: DVec3, joint: Joint) -> Option<Edit> {
    let at = document.selection().point;
    let point = document.path().points.get(at)?;
    let (from, old) = (tip(document, side)?, point.tangents?);
    let (mut led, other) = match side {
        Side::Before => (old.before, old.after),
        Side::After => (old.after, old.before),
    };
    let way = match side {
        Side::Before => point.position - to,
        Side::After => to - point.position,
    };
    // Coordinates that stay keep every bit.
    for axis in 0..3 {
        if to[axis].to_bits() != from[axis].to_bits() {
            led[axis] = 3.0 * way[axis];
        }
    }
    let other = joint.follow(led, other);
    let tangents = Some(match side {
        Side::Before => Tangents {
            before: led,
            after: other,
        },
        Side::After => Tangents {
            before: other,
            after: led,
        },
    });
    Some(Edit::set(At::Point(at), "tangents", tangents))
}

pub(super) fn show(document: &Document, look: &Look<'_>) -> Lines {
    let mut strokes = Strokes::new(look.projection, look.viewport);
    let color = look.colours.of(Element::Segment);
    let selection = document.selection();
    if let Some(point) = document.path().points.get(selection.point) {
        for (_, tip) in tips(document) {
            strokes.line(point.position, tip, WIDTH, color);
            strokes.disc(look.projection.image(tip), HANDLE, color);
        }
    }
    strokes.finish()
}

impl Editor {
    /// How the tangents of the current point are joined, if it owns them.
    pub(crate) fn joint(&self) -> Option<Joint> {
        let tangents = self.point()?.tangents?;
        let (at, chosen) = self.joint;
        let chosen = (at == self.document.selection().point).then_some(chosen);
        let chosen = chosen.unwrap_or_default();
        let holds = [chosen, Joint::Smooth].into_iter();
        let mut holds = holds.filter(|joint| joint.holds(tangents));
        Some(holds.next().unwrap_or(Joint::Corner))
    }

    /// Joins the tangents of all selected points this way.
    pub(crate) fn join(&mut self, joint: Joint) {
        let path = self.document.path();
        let selected = self.all_selected().into_iter();
        let changed = selected.filter_map(|at| {
            let old = path.points.get(at)?.tangents?;
            let new = joint.of(old);
            (new != old).then_some(Edit::set(At::Point(at), "tangents", Some(new)))
        });
        let changed: Vec<Edit> = changed.collect();
        if changed.is_empty() || self.edit_all(changed) {
            self.joint = (self.document.selection().point, joint);
        }
    }

    /// Makes all selected points own the tangents that they have, or takes these away.
    pub(crate) fn set_own_tangents(&mut self, own: bool) {
        let path = self.document.path();
        let selected = self.all_selected().into_iter();
        let edits = selected.map(|at| {
            Edit::set(
                At::Point(at),
                "tangents",
                own.then(|| curve::tangents(path, at)),
            )
        });
        let edits: Vec<Edit> = edits.collect();
        self.edit_all(edits);
    }
}
