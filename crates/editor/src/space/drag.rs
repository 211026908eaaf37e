//! What a drag makes of a point, a target or a roll: from the pointer's place to the edit.

use glam::{DVec2, DVec3};

use super::projection::{Axis, EDGE_ON, Projection};
use super::scene::FLOOR_CELLS;
use super::tangents;
use crate::document::{At, Document, Edit, Selection, no_longer_ahead};
use crate::math::orientation;
use crate::path::{Orientation, Target, UpVector, ahead};
use crate::state::space::{DragConstraint, Handle, Joint};

/// Length of the VUP arrow, in half sizes of the movement space.
pub(super) const VUP_LENGTH: f64 = 0.25;

impl Handle {
    /// Whether it belongs to a key of the edited path.
    pub(super) const fn is_of_path(self) -> bool {
        !matches!(self, Self::Node(_) | Self::Key(..))
    }
}

/// Snap steps for a half size of the space: five between two lines of the floor.
pub(super) const SNAP: f64 = 5.0 * FLOOR_CELLS as f64 / 2.0;

/// Snap step of a roll, in degrees.
const SNAP_ROLL: f64 = 15.0;

impl DragConstraint {
    /// The plane of a button (thesis A.3.1), or the plane seen best if that one is edge-on.
    pub(super) fn of_button(projection: &Projection, button: Axis) -> Self {
        let fixed = if projection.share_seen(button) < EDGE_ON {
            projection.facing()
        } else {
            button
        };
        Self { fixed, along: None }
    }

    /// The plane of a held X, Y or Z, whose coordinate stays; if it is edge-on, the line in the
    /// plane seen best that keeps the coordinate.
    pub(super) fn of_key(projection: &Projection, kept: Axis) -> Self {
        let Self { fixed, .. } = Self::of_button(projection, kept);
        let along = Axis::ALL
            .into_iter()
            .find(|&axis| fixed != kept && axis != kept && axis != fixed);
        Self { fixed, along }
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
    [low, high]: [DVec3; 2],
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

/// The corners of the movement space.
pub(super) fn cube(projection: &Projection) -> [DVec3; 2] {
    [projection.space().low(), projection.space().high()]
}

/// The edit that moves what is held to the pointer.
pub(super) fn outcome(
    document: &Document,
    projection: &Projection,
    held: Handle,
    motion: &Motion,
) -> Outcome {
    let cube = cube(projection);
    let edit = match held {
        Handle::Vup => return roll(document, projection, motion),
        Handle::Vpn => {
            let Some(tip) = current_tip(document) else {
                return Outcome::Nothing;
            };
            let to = follow(projection, tip, motion, cube);
            to.and_then(|to| move_target(document, to))
        }
        Handle::Control(_) | Handle::Node(_) | Handle::Key(..) => return Outcome::Nothing,
        Handle::Point(at) => {
            let Some(point) = document.path().points.get(at) else {
                return Outcome::Nothing;
            };
            let to = follow(projection, point.position, motion, cube);
            to.map(|position| Edit::set(At::Point(at), "position", position))
        }
        Handle::Tangent(side) => {
            let Some(tip) = tangents::tip(document, side) else {
                return Outcome::Nothing;
            };
            // Tangents of a point near a face reach beyond it.
            let [low, high] = cube;
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
mod tests {
    use proptest::prelude::*;

    use super::super::projection::tests::{in_cube, view, viewport};
    use super::*;
    use crate::path::{Orientation, UpPath};

    fn document(positions: &[DVec3], target: Target) -> Document {
        let mut document = Document::new();
        for (at, &position) in positions.iter().enumerate() {
            if at >= 2 {
                document.apply(Edit::InsertPoint { at, position }).unwrap();
            } else {
                document
                    .apply(Edit::set(At::Point(at), "position", position))
                    .unwrap();
            }
        }
        document.select(0, 0).unwrap();
        let orientation = Orientation {
            target,
            ..Orientation::default()
        };
        let edit = Edit::SetOrientation {
            point: 0,
            at: 0,
            orientation,
        };
        document.apply(edit).unwrap();
        document
    }

    fn motion(freedom: DragConstraint, snaps: bool, pointer: DVec2) -> Motion {
        Motion {
            freedom,
            snaps,
            pointer,
            typed: None,
            joint: Joint::Smooth,
        }
    }

    fn pointer() -> impl Strategy<Value = DVec2> {
        (200.0..1200.0f64, 50.0..700.0f64).prop_map(|(x, y)| DVec2::new(x, y))
    }

    /// From the front, the right, above, and tilted where x or y is seen edge-on.
    fn along_an_axis() -> impl Strategy<Value = crate::setup::View> {
        let turns = prop_oneof![Just(0.0), Just(90.0), Just(-90.0), Just(180.0), Just(37.0)];
        let tilts = prop_oneof![Just(0.0), Just(90.0), Just(-90.0), Just(20.0)];
        (turns, tilts).prop_map(|(rotation, tilt)| crate::setup::View {
            rotation,
            tilt,
            ..Default::default()
        })
    }

    /// Where clamping leads, coordinate by coordinate.
    fn clamped(projection: &Projection, from: DVec3, fixed: Axis, pointer: DVec2) -> (DVec3, bool) {
        let free = projection.point_in_plane(from, fixed, pointer).unwrap();
        let mut kept = free;
        for axis in fixed.others() {
            kept[axis.index()] = kept[axis.index()].clamp(-1.0, 1.0);
        }
        (kept, kept == free)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(1000))]

        #[test]
        fn a_point_follows_the_pointer(
            view in view(), from in in_cube(), axis in 0..3usize, pointer in pointer(),
        ) {
            let projection = Projection::new(&view, viewport());
            let wanted = Axis::ALL[axis];
            let freedom = DragConstraint::of_button(&projection, wanted);
            let axis = freedom.fixed.index();
            let mut document = document(&[from, -from], Target::Relative(DVec3::X));
            match outcome(&document, &projection, Handle::Point(0), &motion(freedom, false, pointer)) {
                Outcome::Edit(edit) => {
                    document.apply(edit).unwrap();
                    let moved = document.path().points[0].position;
                    prop_assert_eq!(moved[axis].to_bits(), from[axis].to_bits());
                    prop_assert!(moved.abs().max_element() <= 1.0);
                    let (expected, inside) =
                        clamped(&projection, from, freedom.fixed, pointer);
                    prop_assert_eq!(moved, expected);
                    if inside {
                        prop_assert!((projection.image(moved) - pointer).length() < 1e-6);
                    }
                }
                other => prop_assert!(false, "{other:?}"),
            }
            // The button's own plane wherever that can be seen.
            let good = projection.share_seen(wanted) >= EDGE_ON;
            prop_assert_eq!(freedom.fixed == wanted, good);
            prop_assert!(projection.share_seen(freedom.fixed) >= EDGE_ON);
        }

        #[test]
        fn a_key_keeps_its_coordinate_in_every_view(
            view in prop_oneof![view(), along_an_axis()],
            from in in_cube(), axis in 0..3usize, pointer in pointer(),
        ) {
            let projection = Projection::new(&view, viewport());
            let kept = Axis::ALL[axis];
            let freedom = DragConstraint::of_key(&projection, kept);
            let mut document = document(&[from, -from], Target::Relative(DVec3::X));
            let Outcome::Edit(edit) =
                outcome(&document, &projection, Handle::Point(0), &motion(freedom, false, pointer))
            else {
                return Err(TestCaseError::fail("refused"));
            };
            document.apply(edit).unwrap();
            let moved = document.path().points[0].position;
            prop_assert_eq!(moved[axis].to_bits(), from[axis].to_bits());
            prop_assert_eq!(freedom.along.is_some(), projection.share_seen(kept) < EDGE_ON);
            if let Some(along) = freedom.along {
                // One coordinate moves, and no place on its line is nearer to the pointer.
                let [a, b, c] = Axis::ALL.map(|axis| moved[axis.index()] == from[axis.index()]);
                prop_assert!(u8::from(a) + u8::from(b) + u8::from(c) >= 2);
                let at = along.index();
                if moved[at].abs() < 1.0 {
                    let away = |by: f64| {
                        let mut place = moved;
                        place[at] += by;
                        projection.image(place).distance(pointer)
                    };
                    prop_assert!(away(0.0) <= away(1e-3) && away(0.0) <= away(-1e-3));
                }
            }
        }

        #[test]
        fn what_snaps_lies_on_the_grid(
            view in view(), from in in_cube(), axis in 0..3usize, pointer in pointer(),
        ) {
            let projection = Projection::new(&view, viewport());
            let freedom = DragConstraint::of_button(&projection, Axis::ALL[axis]);
            let mut document = document(&[from, -from], Target::Relative(DVec3::X));
            let held = Handle::Point(0);
            let Outcome::Edit(edit) =
                outcome(&document, &projection, held, &motion(freedom, true, pointer)) else { return Ok(()) };
            document.apply(edit).unwrap();
            let moved = document.path().points[0].position;
            let (free, _) = clamped(&projection, from, freedom.fixed, pointer);
            for axis in freedom.fixed.others().map(Axis::index) {
                // Written as a person would: 0.15, not 0.15000000000000002.
                let text = format!("{:.2}", moved[axis]);
                prop_assert_eq!(moved[axis], text.parse::<f64>().unwrap());
                let fives = (moved[axis] * 100.0).round() / 5.0;
                prop_assert_eq!(fives, fives.round());
                prop_assert!((moved[axis] - free[axis]).abs() <= 0.025 + 1e-12);
            }
        }

        #[test]
        fn a_target_follows_the_pointer(
            view in view(), at in in_cube(), target in in_cube(), axis in 0..3usize,
            absolute: bool, pointer in pointer(),
        ) {
            let projection = Projection::new(&view, viewport());
            let freedom = DragConstraint::of_button(&projection, Axis::ALL[axis]);
            let (fixed, axis) = (freedom.fixed, freedom.fixed.index());
            let target = if absolute { Target::Absolute(target) } else { Target::Relative(target) };
            let mut document = document(&[at, -at], target);
            let Outcome::Edit(edit) =
                outcome(&document, &projection, Handle::Vpn, &motion(freedom, false, pointer))
            else { return Ok(()) };
            document.apply(edit).unwrap();
            let moved = document.path().points[0].orientations[0].target;
            let (from, to) = match (target, moved) {
                (Target::Absolute(a), Target::Absolute(b))
                | (Target::Relative(a), Target::Relative(b)) => (a, b),
                _ => panic!("it stays what it is"),
            };
            prop_assert_eq!(from[axis].to_bits(), to[axis].to_bits());
            let tip = tip_of(moved, at);
            let (expected, inside) = clamped(&projection, tip_of(target, at), fixed, pointer);
            prop_assert!((tip - expected).length() < 1e-12);
            if inside {
                prop_assert!((projection.image(tip) - pointer).length() < 1e-6);
            }
        }

        #[test]
        fn vup_points_to_the_pointer(
            view in view(), at in in_cube(), target in in_cube(), pointer in pointer(),
        ) {
            let projection = Projection::new(&view, viewport());
            let mut document = document(&[at, -at], Target::Relative(target));
            let direction = orientation::unit(target);
            let freedom = DragConstraint::of_button(&projection, Axis::X);
            match outcome(&document, &projection, Handle::Vup, &motion(freedom, false, pointer)) {
                Outcome::Edit(edit) => {
                    document.apply(edit).unwrap();
                    let roll = document.path().points[0].orientations[0].roll;
                    let up = orientation::up_from_roll(direction, roll.to_radians());
                    let image = projection.image_of_way(up);
                    let wanted = pointer - projection.image(at);
                    let angle = image.perp_dot(wanted).atan2(image.dot(wanted)).to_degrees();
                    prop_assert!(angle.abs() < 0.1);
                    prop_assert!(angle.abs() < 1e-6);
                    prop_assert!(roll > -180.0 && roll <= 180.0);
                }
                other => {
                    prop_assert_eq!(other, Outcome::CircleEdgeOn);
                    prop_assert!(direction.dot(projection.toward()).abs() < EDGE_ON);
                }
            }
        }
    }

    #[test]
    fn the_thesiss_bisection_finds_the_same_roll() {
        let projection = Projection::new(&crate::setup::View::default(), viewport());
        let view = orientation::unit(DVec3::new(0.3, -0.2, -0.8));
        let image =
            |roll: f64| projection.image_of_way(orientation::up_from_roll(view, roll.to_radians()));
        for step in 0..360 {
            let way = DVec2::from_angle(f64::from(step).to_radians()) * 80.0;
            // 6.2.3: which half, then halve. The images go round one way.
            let turn = image(0.0).perp_dot(image(90.0)).signum();
            let side = |roll: f64| image(roll).perp_dot(way) * turn >= 0.0;
            let (mut low, mut high) = if side(0.0) {
                (0.0, 180.0)
            } else {
                (180.0, 360.0)
            };
            for _ in 0..40 {
                let middle = (low + high) / 2.0;
                if side(middle) {
                    low = middle;
                } else {
                    high = middle;
                }
            }
            let axes = projection.space().up.level_axes(view);
            let found = roll_towards(&projection, axes, way).unwrap();
            let difference = orientation::wrap_degrees(found - low);
            assert!(difference.abs() < 1e-6, "{found} and {low}");
        }
    }

    #[test]
    fn at_the_centre_of_the_circle_nothing_turns() {
        let projection = Projection::new(&crate::setup::View::default(), viewport());
        let view = orientation::unit(DVec3::new(0.3, -0.2, -0.8));
        let axes = projection.space().up.level_axes(view);
        assert_eq!(roll_towards(&projection, axes, DVec2::ZERO), None);
    }

    /// The camera of the film has its up where the pointer is, whatever its up is.
    #[test]
    fn every_up_is_turned_to_the_pointer() {
        let projection = Projection::new(&crate::setup::View::default(), viewport());
        let positions = [
            DVec3::new(-0.6, 0.1, 0.7),
            DVec3::new(0.5, 0.4, 0.2),
            DVec3::new(0.1, -0.3, -0.6),
        ];
        let place = DVec3::new(0.3, 0.9, -0.4);
        let up_path = UpPath::of(Document::new().path()).unwrap();
        let ups = [
            UpVector::Point(place),
            UpVector::Minimal,
            UpVector::Path(up_path),
            UpVector::Frenet,
        ];
        for up in ups {
            let mut document = document(&positions, Target::Relative(DVec3::NEG_Z));
            let cubic = Edit::set(At::Path, "curve", crate::path::CurveKind::Cubic);
            document.apply(cubic).unwrap();
            for (point, ahead) in [(0, None), (1, Some(0.0)), (2, None)] {
                let orientation = Orientation {
                    target: Target::Relative(DVec3::new(0.5, -0.3, -0.8)),
                    roll: 35.0,
                    ..Orientation::default()
                };
                let own = orientation.own.with(|own| {
                    own.up = up.clone();
                    own.ahead = ahead;
                });
                let orientation = Orientation {
                    own: own.unwrap(),
                    ..orientation
                };
                let at = 0;
                let edit = Edit::SetOrientation {
                    point,
                    at,
                    orientation,
                };
                document.apply(edit).unwrap();
            }
            for point in 0..3 {
                document.select(point, 0).unwrap();
                let foot = projection.image(document.path().points[point].position);
                for step in 0..12 {
                    let way = DVec2::from_angle(f64::from(30 * step).to_radians()) * 80.0;
                    let freedom = DragConstraint::of_button(&projection, Axis::X);
                    let held = Handle::Vup;
                    let Outcome::Edit(edit) = outcome(
                        &document,
                        &projection,
                        held,
                        &motion(freedom, false, foot + way),
                    ) else {
                        panic!("{up:?} {point}");
                    };
                    document.apply(edit).unwrap();
                    let frame = document
                        .timeline(|timeline| {
                            let from = timeline.section_from(point, 0);
                            from.map(|section| {
                                (0..section)
                                    .map(|k| timeline.section(k).frames)
                                    .sum::<usize>()
                            })
                        })
                        .unwrap();
                    let sampler = document.sampler().unwrap();
                    let frame = frame.map_or(sampler.frame_count(), |before| before + 1);
                    let pose = sampler.pose(frame as f64).unwrap();
                    let image = projection.image_of_way(DVec3::from_array(pose.vup));
                    let turn = image.normalize().perp_dot(way.normalize());
                    assert!(
                        turn.abs() < 1e-6 && image.dot(way) > 0.0,
                        "{up:?} {point} {turn}"
                    );
                }
            }
        }
    }

    #[test]
    fn what_is_gone_is_not_moved() {
        let document = document(&[DVec3::X, DVec3::Y], Target::Relative(DVec3::X));
        let projection = Projection::new(&crate::setup::View::default(), viewport());
        let held = Handle::Point(7);
        let freedom = DragConstraint::of_button(&projection, Axis::X);
        let found = outcome(
            &document,
            &projection,
            held,
            &motion(freedom, false, DVec2::ZERO),
        );
        assert_eq!(found, Outcome::Nothing);
    }
}
