//! Nodes that are moved, turned or scaled together: from a motion in the space to their numbers.
//!
//! The axes are those of the parent of the first one, or its own. The numbers of each are computed
//! from those that it had when it began, so that nothing adds up, and a node that stands alone gets
//! no rounding of others' coordinates. Nothing is scaled along the parent's axes but places: that
//! would need a shear, so a single node is scaled along its own axes.

use glam::{DAffine3, DMat3, DQuat, DVec2, DVec3};
use vides_engine::math::euler::EulerAngles;
use vides_engine::scene::Channel;
use vides_engine::shared_list::SharedList;

use super::projection::{Axis, Projection};
use crate::state::Editor;
use crate::state::scene_view::Now;
use crate::state::space::{Grip, Held, NodeChange, Start};
use crate::texts::fill;
use crate::texts::refusals::reason_of;

/// A plane of axes seen with less of its area than this is taken as edge-on: nothing moves.
const EDGE_ON: f64 = 1e-3;

/// What is nearer to an axis, in its distance from the middle, lies on it.
const ON_AXIS: f64 = 1e-12;

impl Start {
    /// Its pivot in its parent.
    fn place(&self) -> DVec3 {
        self.position + self.pivot
    }
}

/// A motion in the coordinates of the first one's parent.
#[derive(Clone, Copy, Debug)]
pub(super) enum Motion {
    Move(DVec3),
    /// About an axis, in degrees; the axis by name, and whether it is the node's own.
    Turn(Option<(Axis, bool)>, DVec3, f64),
    /// Along the axes of a basis.
    Scale(DMat3, DVec3),
}

impl Held {
    /// Takes what is meant, or says why not. `places`: it is moved or turned, and not only scaled.
    pub(super) fn new(editor: &Editor, grip: Grip, places: bool) -> Result<Self, String> {
        let texts = &editor.texts().space;
        let nothing = || texts.needs_nodes.to_owned();
        let scene = editor.document.edited_scene().map(|edited| edited.scene());
        let scene = scene.ok_or_else(nothing)?;
        let nodes = scene.nodes();
        let selected = match grip {
            Grip::Nodes => editor.selected_nodes(),
            Grip::Pivot => editor.current_node().into_iter().collect(),
            Grip::Key(node, _) => vec![node],
        };
        let told = |error| reason_of(editor.language(), &error);
        let within = scene.with_all_in(&selected);
        let within = within.map_err(|error| told(error.into()))?;
        // What is in another one of these goes along with that.
        let free = |node: &usize| nodes[*node].parent.is_none_or(|parent| !within[parent]);
        let edited = editor.document.edited_scene().and_then(|of| of.node());
        let mut all = Vec::new();
        for node in selected.into_iter().filter(free) {
            let of = &nodes[node];
            if places && (of.path().is_some() || edited == Some(node)) {
                return Err(fill(texts.path_moves_it, &[&of.name]));
            }
            let three = |of| match *channel(editor, node, of).as_slice() {
                [x, y, z] => DVec3::new(x, y, z),
                _ => DVec3::ZERO,
            };
            let (rotation, angles) = turned(&channel(editor, node, Channel::Rotation));
            let mut position = three(Channel::Position);
            if let Grip::Key(_, key) = grip {
                let track = of.keys().track(&Channel::Position);
                let value = track.and_then(|track| track.values().get(3 * key..3 * key + 3));
                position = DVec3::from_slice(value.ok_or_else(nothing)?);
            }
            all.push(Start {
                node,
                parent: of.parent,
                world: DAffine3::IDENTITY,
                pivot: of.pivot,
                position,
                rotation,
                angles,
                scale: three(Channel::Scale),
            });
        }
        if all.is_empty() {
            return Err(nothing());
        }
        let found = editor.with_scene(|now| {
            for start in &mut all {
                start.world = parent_in_space(now, start.parent);
            }
        });
        found.map_err(told)?;
        let mut held = Self {
            grip,
            middle: DVec3::ZERO,
            all,
        };
        let places = held.all.iter().map(|start| held.of_first(start).1);
        #[allow(clippy::cast_precision_loss)]
        let middle = places.sum::<DVec3>() / held.all.len() as f64;
        held.middle = middle;
        Ok(held)
    }

    /// The node whose pivot is held.
    pub(super) fn pivot_of(&self) -> Option<usize> {
        (self.grip == Grip::Pivot).then(|| self.first().node)
    }

    fn first(&self) -> &Start {
        &self.all[0]
    }

    /// From the first one's parent into that of this one, and its place in the first one's.
    fn of_first(&self, start: &Start) -> (DAffine3, DVec3) {
        let first = self.first();
        if start.parent == first.parent {
            return (DAffine3::IDENTITY, start.place());
        }
        let into = start.world.inverse() * first.world;
        // A flat parent has no inverse: its own axes are as good as others.
        let into = if into.is_finite() {
            into
        } else {
            DAffine3::IDENTITY
        };
        let back = into.inverse();
        let back = if back.is_finite() {
            back
        } else {
            DAffine3::IDENTITY
        };
        (into, back.transform_point3(start.place()))
    }

    /// The middle of all, in the space.
    pub(super) fn middle(&self) -> DVec3 {
        self.first().world.transform_point3(self.middle)
    }

    /// The axes in the first one's parent, of length 1: the parent's, or the node's own.
    pub(super) fn basis(&self, own: bool) -> DMat3 {
        match own {
            true => DMat3::from_quat(self.first().rotation),
            false => DMat3::IDENTITY,
        }
    }

    /// A way in the first one's parent as one in the space.
    pub(super) fn way(&self, way: DVec3) -> DVec3 {
        self.first().world.transform_vector3(way)
    }

    /// Whether the parent's coordinates are mirrored in the space.
    pub(super) fn is_mirrored(&self) -> bool {
        self.first().world.matrix3.determinant() < 0.0
    }

    /// The axis of a basis that points at the viewer most.
    pub(super) fn facing(&self, basis: DMat3, projection: &Projection) -> Axis {
        let toward = projection.toward();
        let share = |axis: Axis| {
            let way = self.way(basis.col(axis.index()));
            way.normalize_or_zero().dot(toward).abs()
        };
        let best = |best, axis| {
            if share(axis) > share(best) {
                axis
            } else {
                best
            }
        };
        Axis::ALL.into_iter().fold(Axis::Z, best)
    }

    /// How far it moves on the axes of a basis for the pointer's way: on one of them, or in
    /// the plane of two that is seen best.
    pub(super) fn followed(
        &self,
        basis: DMat3,
        along: Option<Axis>,
        projection: &Projection,
        way: DVec2,
    ) -> DVec3 {
        let image = |axis: usize| projection.image_of_way(self.way(basis.col(axis)));
        let mut by = DVec3::ZERO;
        if let Some(axis) = along.map(Axis::index) {
            let seen = image(axis);
            by[axis] = way.dot(seen) / seen.length_squared();
        } else {
            let [a, b] = self.facing(basis, projection).others().map(Axis::index);
            let (of_a, of_b) = (image(a), image(b));
            let area = of_a.perp_dot(of_b);
            if area.abs() < EDGE_ON * of_a.length() * of_b.length() {
                return by;
            }
            by[a] = way.perp_dot(of_b) / area;
            by[b] = of_a.perp_dot(way) / area;
        }
        if by.is_finite() { by } else { DVec3::ZERO }
    }

    /// Whether a turn becomes keys that go the shorter way.
    pub(super) fn turns_by_quaternions(&self, editor: &Editor) -> bool {
        let edited = editor.document.edited_scene();
        let nodes = edited.map_or(SharedList::EMPTY, |edited| edited.scene().nodes());
        self.all.iter().any(|start| {
            let node = nodes.get(start.node);
            let track = node.and_then(|node| node.keys().track(&Channel::Rotation));
            start.angles.is_none() && track.is_some()
        })
    }

    /// What a motion makes of what is held; none: there is no such motion of it.
    pub(super) fn changed(&self, motion: Motion) -> Option<NodeChange> {
        let first = self.first();
        match (self.grip, motion) {
            (Grip::Key(node, key), Motion::Move(by)) => {
                Some(NodeChange::Key(node, key, first.position + by))
            }
            (Grip::Pivot, Motion::Move(by)) => {
                let own = DMat3::from_quat(first.rotation) * DMat3::from_diagonal(first.scale);
                let by = own.inverse() * by;
                let moved = NodeChange::Pivot(first.node, first.pivot + by);
                by.is_finite().then_some(moved)
            }
            (Grip::Nodes, motion) => {
                let all = self.all.iter();
                let values = all.flat_map(|start| self.values(start, motion));
                Some(NodeChange::Values(values.collect()))
            }
            _ => None,
        }
    }

    fn values(&self, start: &Start, motion: Motion) -> Vec<(usize, Channel, Vec<f64>)> {
        let (into, place) = self.of_first(start);
        let several = self.all.len() > 1;
        let from = place - self.middle;
        let placed = |from: DVec3| {
            let place = into.transform_point3(self.middle + from);
            (
                start.node,
                Channel::Position,
                (place - start.pivot).to_array().to_vec(),
            )
        };
        let mut values = Vec::new();
        match motion {
            Motion::Move(by) => {
                let position = start.position + into.transform_vector3(by);
                values.push((start.node, Channel::Position, position.to_array().to_vec()));
            }
            Motion::Turn(named, about, degrees) => {
                let turn = DQuat::from_axis_angle(about, degrees.to_radians());
                let rotation = match (start.angles, named) {
                    // As far as it is turned, more than once round too.
                    (Some([yaw, pitch, roll]), Some((Axis::Y, false))) if !several => {
                        vec![yaw + degrees, pitch, roll]
                    }
                    (Some([yaw, pitch, roll]), Some((Axis::Z, true))) if !several => {
                        vec![yaw, pitch, roll + degrees]
                    }
                    _ => {
                        let mirrored = into.matrix3.determinant() < 0.0;
                        let about = into.transform_vector3(about).normalize_or(about);
                        let angle = if mirrored { -degrees } else { degrees };
                        let turn = DQuat::from_axis_angle(about, angle.to_radians());
                        let now = (turn * start.rotation).normalize();
                        vec![now.w, now.x, now.y, now.z]
                    }
                };
                values.push((start.node, Channel::Rotation, rotation));
                // What lies on the axis stays there.
                if several && from.cross(about).length() > ON_AXIS * from.length() {
                    values.push(placed(turn * from));
                }
            }
            Motion::Scale(basis, factors) => {
                let scale = start.scale * factors;
                values.push((start.node, Channel::Scale, scale.to_array().to_vec()));
                if several {
                    values.push(placed(basis * (factors * (basis.transpose() * from))));
                }
            }
        }
        values
    }
}

/// From a parent's coordinates into those of the space.
pub(super) fn parent_in_space(now: &Now, parent: Option<usize>) -> DAffine3 {
    let world = parent.map_or(DAffine3::IDENTITY, |at| now.states[at].world());
    now.into_path * world
}

fn channel(editor: &Editor, node: usize, channel: Channel) -> Vec<f64> {
    editor.channel_value(node, &channel).unwrap_or_default()
}

/// A rotation as its quaternion, and as angles if it has these.
fn turned(value: &[f64]) -> (DQuat, Option<[f64; 3]>) {
    match *value {
        [w, x, y, z] => (DQuat::from_xyzw(x, y, z, w).normalize(), None),
        [yaw, pitch, roll] => {
            let [a, b, c] = [yaw, pitch, roll].map(f64::to_radians);
            let angles = EulerAngles {
                yaw: a,
                pitch: b,
                roll: c,
            };
            (angles.quaternion(), Some([yaw, pitch, roll]))
        }
        _ => (DQuat::IDENTITY, None),
    }
}
