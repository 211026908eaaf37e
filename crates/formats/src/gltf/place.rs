//! Where nodes are, and how they move.

use glam::{DAffine3, DQuat, DVec3};
use vides_document::error::vec_with_room;
use vides_engine::math::camera::CameraAxes;
use vides_engine::math::orientation::quaternion_from_view;
use vides_engine::path::Pose;
use vides_engine::scene::{Channel, Kind, Node, NodeState, Track, Values, Warnings};

use super::keys::{self, Keys, Place, Target};
use super::of_node::{aims, field, path_poses, rolled, rolls, values};
use super::write::Writer;
use crate::blocks::BLOCK;
use crate::convention::{self, Continued};
use crate::error::Result;
use crate::flight::{Flight, succeeded};

/// A rotation by less than this is none.
const HAIR: f64 = 1e-15;

/// What has a key a frame.
#[derive(Clone, Copy, Default, PartialEq)]
pub(super) struct Sample {
    positions: bool,
    rotations: bool,
    scales: bool,
}

/// Where a node is in its parent, in the file's coordinates.
#[derive(Clone, Copy)]
pub(super) struct Local {
    position: DVec3,
    rotation: DQuat,
    scale: DVec3,
    zoom: f64,
}

impl Writer<'_, '_> {
    /// Places a node. Numbers in JSON are doubles, unlike those of keys and vertices.
    pub(super) fn set_place(&mut self, at: usize, position: DVec3, rotation: DQuat, scale: DVec3) {
        let json = &mut self.nodes[at].json;
        if position != DVec3::ZERO {
            let position = position.to_array();
            json.insert("translation".into(), position[..].into());
        }
        let rotation = rotation.normalize();
        if rotation.xyz().abs().max_element() > HAIR {
            let rotation = rotation.to_array();
            json.insert("rotation".into(), rotation[..].into());
        }
        if scale != DVec3::ONE {
            let scale = scale.to_array();
            json.insert("scale".into(), scale[..].into());
        }
    }

    pub(super) fn place(&self, node: &Node, look: DQuat) -> Place {
        let flight = self.flight;
        // What lies below is turned with its root.
        let to = match node.parent {
            None => flight.up(),
            Some(_) => flight.document_up(),
        };
        let origin = match node.parent {
            None => self.origin,
            Some(_) => DVec3::ZERO,
        };
        let from = flight.document_up();
        Place {
            turn: convention::turn(from, to),
            from,
            to,
            scale: flight.options().scale,
            pivot: node.pivot,
            origin,
            look,
        }
    }

    pub(super) fn scaled_above(&self, node: &Node) -> bool {
        let nodes = self.flight.scene().nodes();
        std::iter::successors(node.parent, |&at| nodes[at].parent).any(|at| {
            let above = &nodes[at];
            above.rest.scale != DVec3::ONE || above.keys().track(&Channel::Scale).is_some()
        })
    }

    /// A node with its place, its motion and whether it is seen.
    pub(super) fn moved(
        &mut self,
        at: usize,
        node: &Node,
        name: &str,
        look: DQuat,
        scales: bool,
    ) -> Result<usize> {
        let own = self.push(name)?;
        let mut place = self.place(node, look);
        let flight = self.flight;
        let track = |channel| node.keys().track(&channel);
        let path = node.path().is_some();
        if let Some(parent) = node
            .parent
            .filter(|_| path || track(Channel::Position).is_some())
        {
            // Keys in a parent may be far from it.
            let here = self.locals(at, node, &place, 0, 1, Sample::default())?[0];
            place.origin = flight.origin(here.position, self.scales[parent])?;
            self.put_below(own, place.origin)?;
        }
        let by_keys = |track: Option<&Track>,
                       keys: fn(&Flight<'_>, &Track, Place) -> Option<Keys>| {
            track.and_then(|track| keys(flight, track, place))
        };
        let positions = by_keys(track(Channel::Position), keys::positions);
        let rotations = match aims(node) || rolls(node) {
            true => None,
            false => by_keys(track(Channel::Rotation), keys::rotations),
        };
        let scale = track(Channel::Scale).filter(|_| scales);
        let scale_keys = scale.and_then(|track| keys::numbers(flight, track));
        let moves = |channel| track(channel).is_some();
        let mut sample = Sample {
            positions: path || (moves(Channel::Position) && positions.is_none()),
            rotations: path
                || aims(node)
                || moves(Channel::Roll)
                || (moves(Channel::Rotation) && rotations.is_none()),
            scales: scale.is_some() && scale_keys.is_none(),
        };
        if aims(node) && scales {
            // Only its place in the world says what the aim does to axes of other lengths.
            sample.positions = true;
            sample.scales = true;
        }
        let frame = flight.frame(0);
        let first = self.locals(at, node, &place, 0, 1, sample)?[0];
        self.set_place(
            own,
            first.position,
            first.rotation,
            if scales { first.scale } else { DVec3::ONE },
        );
        let target = |path| Target::Node(own, path);
        for (keys, path, width) in [
            (positions.filter(|_| !sample.positions), "translation", 3),
            (rotations.filter(|_| !sample.rotations), "rotation", 4),
            (scale_keys.filter(|_| !sample.scales), "scale", 3),
        ] {
            if let Some(keys) = keys {
                self.animation
                    .keys(&mut self.binary, target(path), &keys, width)?;
            }
        }
        self.sampled(at, node, own, &place, sample)?;
        self.visible(own, node, frame)?;
        Ok(own)
    }

    /// A key a frame for what is asked for.
    pub(super) fn sampled(
        &mut self,
        at: usize,
        node: &Node,
        own: usize,
        place: &Place,
        sample: Sample,
    ) -> Result<()> {
        if sample == Sample::default() {
            return Ok(());
        }
        let count = self.flight.count();
        let room = |wanted: bool| if wanted { count } else { 0 };
        let mut positions: Vec<[f64; 3]> = vec_with_room(room(sample.positions))?;
        let mut rotations: Vec<[f64; 4]> = vec_with_room(room(sample.rotations))?;
        let mut scales: Vec<f32> = vec_with_room(3 * room(sample.scales))?;
        let zooms = matches!(node.kind, Kind::Camera(_)) && node.path().is_some();
        self.fields = vec_with_room(room(zooms))?;
        let mut continued = Continued::default();
        for from in (0..count).step_by(BLOCK) {
            let block = BLOCK.min(count - from);
            for local in self.locals(at, node, place, from, block, sample)? {
                if zooms {
                    self.fields.push(field(local.zoom));
                }
                if sample.positions {
                    positions.push(local.position.to_array());
                }
                if sample.rotations {
                    rotations.push(continued.next(local.rotation.normalize()).to_array());
                }
                if sample.scales {
                    scales.extend(local.scale.as_vec3().to_array());
                }
            }
        }
        let (animation, binary) = (&mut self.animation, &mut self.binary);
        if sample.positions {
            animation.sampled(self.flight, binary, own, &positions)?;
        }
        if sample.rotations {
            animation.sampled(self.flight, binary, own, &rotations)?;
        }
        if sample.scales {
            let target = Target::Node(own, "scale");
            animation.a_key_a_frame(self.flight, binary, target, &scales, 3)?;
        }
        Ok(())
    }

    /// Places of a node in its parent, in the file's coordinates, from a frame on.
    pub(super) fn locals(
        &mut self,
        at: usize,
        node: &Node,
        place: &Place,
        from: usize,
        count: usize,
        sample: Sample,
    ) -> Result<Vec<Local>> {
        let flight = self.flight;
        let mut locals = vec_with_room(count)?;
        let mut warnings = Warnings::default();
        let mut poses: Vec<Pose> = Vec::new();
        if !aims(node) {
            poses = path_poses(flight, node, from, count)?;
        }
        let (mut own, mut above): (Vec<NodeState>, Vec<NodeState>) = (Vec::new(), Vec::new());
        if aims(node) {
            own = flight.states(at, from, count)?;
            if let Some(parent) = node.parent {
                above = flight.states(parent, from, count)?;
            }
        }
        for index in 0..count {
            let frame = flight.frame(from + index);
            if let Some(pose) = poses.get(index) {
                let turn = quaternion_from_view(pose.view(), pose.up());
                let values = Values {
                    rotation: turn,
                    ..node.rest
                };
                let rotation = place.rotation(rolled(node, &values));
                locals.push(Local {
                    position: place.position(pose.position()),
                    rotation,
                    scale: node.rest.scale,
                    zoom: pose.zoom,
                });
                continue;
            }
            let values = values(node, frame, &mut warnings)?;
            let mut local = Local {
                position: place.position(values.position),
                rotation: place.rotation(rolled(node, &values)),
                scale: values.scale,
                zoom: values.zoom,
            };
            if let Some(state) = own.get(index) {
                let parent = above
                    .get(index)
                    .map_or(DAffine3::IDENTITY, NodeState::world);
                let inside = parent.inverse() * state.world();
                let parts = convention::parts(inside);
                self.counts.sheared +=
                    usize::from(parts.sheared && sample.scales && from + index == 0);
                local = Local {
                    position: place.position(parts.position),
                    rotation: place.rotation(parts.rotation),
                    scale: parts.scale,
                    zoom: values.zoom,
                };
            }
            locals.push(local);
        }
        succeeded(warnings, node)?;
        Ok(locals)
    }

    /// A camera or light that stands at the top, frame by frame.
    pub(super) fn at_the_top(&mut self, at: usize, node: &Node) -> Result<()> {
        let top = self.push(&node.name)?;
        let (flight, count) = (self.flight, self.flight.count());
        let mut positions: Vec<[f64; 3]> = vec_with_room(count)?;
        let mut rotations: Vec<[f64; 4]> = vec_with_room(count)?;
        let mut seen: Vec<u8> = vec_with_room(count)?;
        let mut continued = Continued::default();
        for from in (0..count).step_by(BLOCK) {
            for state in flight.states(at, from, BLOCK.min(count - from))? {
                let pose = flight.pose(state.pose);
                let turn = convention::rotation(&pose, CameraAxes::OpenGl);
                seen.push(u8::from(state.visible != 0));
                positions.push((pose.position() - self.origin).to_array());
                rotations.push(continued.next(turn).to_array());
            }
        }
        let (place, turn) = (
            DVec3::from_array(positions[0]),
            DQuat::from_array(rotations[0]),
        );
        self.set_place(top, place, turn, DVec3::ONE);
        if positions.iter().any(|other| *other != positions[0]) {
            self.animation
                .sampled(flight, &mut self.binary, top, &positions)?;
        }
        if rotations.iter().any(|other| *other != rotations[0]) {
            self.animation
                .sampled(flight, &mut self.binary, top, &rotations)?;
        }
        if matches!(node.kind, Kind::Light(_)) {
            // What hides it stands elsewhere.
            self.seen(top, &seen)?;
        }
        self.roots.push(top);
        self.view(node, top)
    }
}
