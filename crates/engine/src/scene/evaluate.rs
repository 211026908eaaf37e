//! The scene at a frame.

use std::collections::HashSet;

use glam::{DAffine3, DMat3, DQuat, DVec3};

use super::aim;
use super::channel::Channel;
use super::hierarchy::{local, needs, orthonormal};
use super::motion::{Motion, check_frame};
use super::node::{Kind, Node, Values};
use super::rotation::wxyz;
use super::scene::Scene;
use super::side_by_side::{GROUP, Group, Pack};
use super::state::{NodeState, Warnings};
use super::track::Track;
use super::vertices::Form;
use crate::error::{Invalid, OutOfRange, Place, Result, vec_with_room};
use crate::math::orientation::view_from_quaternion;
use crate::path::Pose;

/// How far away in frames a last direction is looked for: from 2⁻²⁰ on, doubled.
const FIRST_STEP: f64 = 1.0 / (1 << 20) as f64;
const STEPS: usize = 33;

/// Halvings between a frame with a direction and one without: to the last bit of a frame.
const HALVINGS: usize = 40;

/// Whether a camera without a direction looks for its last one.
enum Search {
    /// With room that is made when the first one looks.
    Back(Room),
    Own,
}

/// What those need that look for their last direction.
#[derive(Default)]
struct Room {
    /// Of all nodes.
    states: Vec<NodeState>,
    /// Whether each, or what its state depends on, ever moves; as far as that was asked.
    moves: Vec<Option<bool>>,
}

impl Node {
    fn values(&self, frame: f64, warnings: &mut Warnings) -> Result<Values> {
        let mut values = self.rest;
        if let Some(path) = &self.path {
            path.at(frame, &mut values, warnings)?;
        }
        self.keys.at(frame, &mut values, warnings)?;
        Ok(values)
    }

    /// Whether anything of it is another at another frame.
    fn may_change(&self) -> bool {
        self.path.is_some() || !self.keys.tracks().is_empty()
    }

    /// The same, with a camera's roll in its rotation.
    fn values_turned(&self, frame: f64, warnings: &mut Warnings) -> Result<Values> {
        let mut values = self.values(frame, warnings)?;
        if matches!(self.kind, Kind::Camera(_)) && values.roll != 0.0 {
            values.rotation *= DQuat::from_rotation_z(values.roll.to_radians());
        }
        Ok(values)
    }
}

impl Scene {
    /// The states of all nodes at a frame, by their numbers. Where a host's function fails,
    /// `warnings` tells, its channel steps from key to key, and the rest plays.
    ///
    /// [`crate::Error::Argument`] or [`crate::Error::Range`] for the frame, the latter also if
    /// `states` are not as many as the nodes; [`crate::Error::Memory`].
    pub fn evaluate(
        &self,
        frame: f64,
        states: &mut [NodeState],
        warnings: &mut Warnings,
    ) -> Result<()> {
        check_frame(frame)?;
        if states.len() != self.nodes.len() {
            return Err(OutOfRange::States {
                nodes: self.nodes.len(),
                given: states.len(),
            }
            .into());
        }
        let packs = self.nodes.packs(&self.order, self.numbers);
        let search = &mut Search::Back(Room::default());
        self.run(&self.order, packs, frame, states, warnings, search)
    }

    /// Whether no host's function interpolates and no node aims: once prepared, it needs no memory.
    #[must_use]
    pub fn is_plain(&self) -> bool {
        self.plain().0
    }

    /// The same, and whether no node follows a path.
    fn plain(&self) -> (bool, bool) {
        *self.nodes.plain.get_or_init(|| {
            let plain = |node: &Node| {
                let mut tracks = node.keys.tracks().iter();
                node.aim.is_none() && !tracks.any(Track::asks_host)
            };
            let still = |node: &Node| node.path.is_none();
            (self.nodes.iter().all(plain), self.nodes.iter().all(still))
        })
    }

    /// Prepares all paths for sampling, so that a lack of memory shows before anything is written.
    ///
    /// # Errors
    /// [`crate::Error::Argument`], [`crate::Error::Range`] for the frame; [`crate::Error::Memory`].
    pub fn prepare(&self, frame: f64) -> Result<()> {
        check_frame(frame)?;
        if self.plain().1 {
            return Ok(());
        }
        let mut paths = self.nodes.iter().filter_map(Node::path);
        paths.try_for_each(|path| path.sampler().map(drop))
    }

    /// The states of one node at the frames `first`, `first + step` and so on.
    ///
    /// # Errors
    /// As [`Scene::evaluate`]; [`crate::Error::Range`] for the node.
    pub fn sample(
        &self,
        node: usize,
        first: f64,
        step: f64,
        states: &mut [NodeState],
        warnings: &mut Warnings,
    ) -> Result<()> {
        self.node(node)?;
        check_frame(first)?;
        check_frame(step).map_err(|error| error.at(Place::Step))?;
        check_frame(first + step * states.len().saturating_sub(1) as f64)?;
        let chain = self.chain(node)?;
        let asks = |at: &usize| self.nodes[*at].keys.tracks().iter().any(Track::asks_host);
        let aims = chain.iter().filter_map(|&at| self.nodes[at].aim);
        let mut asked = vec_with_room(chain.len())?;
        asked.extend(aims.filter(asks));
        let packs = Pack::all(&self.nodes, &chain, states.len()).unwrap_or_default();
        let mut scratch = self.scratch()?;
        let search = &mut Search::Back(Room::default());
        for (at, state) in states.iter_mut().enumerate() {
            let frame = first + step * at as f64;
            self.run(&chain, &packs, frame, &mut scratch, warnings, search)?;
            // Of a node that is only aimed at nothing else tells what went wrong.
            for &aim in &asked {
                warnings.node = aim;
                self.nodes[aim].values(frame, warnings)?;
            }
            *state = scratch[node];
        }
        Ok(())
    }

    /// The numbers of a channel of a node at a frame, with or without a track.
    ///
    /// # Errors
    /// As [`Scene::evaluate`]; the same for the node and the channel.
    pub fn value(
        &self,
        node: usize,
        channel: &Channel,
        frame: f64,
        warnings: &mut Warnings,
    ) -> Result<Vec<f64>> {
        let at = node;
        let node = self.node(at)?;
        check_frame(frame)?;
        warnings.node = at;
        let track = node.keys.track(channel);
        let mut out = vec_with_room(16)?;
        match (channel, track) {
            (Channel::Value { .. }, Some(track)) => {
                out.resize(track.width(), 0.0);
                track.numbers(frame, &mut out, warnings);
                return Ok(out);
            }
            (Channel::Value { .. }, None) => {
                return Err(Invalid::NoChannelOfNode {
                    node: (&node.name).into(),
                    channel: (&channel).into(),
                }
                .into());
            }
            _ => {}
        }
        let width = channel.width(node)?;
        out.try_reserve(width)?;
        match (channel, &node.kind) {
            (Channel::Weights | Channel::Deformation { .. }, Kind::Object(object)) => {
                out.resize(width, 0.0);
                let rest = match channel {
                    Channel::Deformation { at, parameter } => object.deformations()[*at]
                        .0
                        .channel(parameter)
                        .unwrap_or_default(),
                    _ => object.weights(),
                };
                out.copy_from_slice(rest);
                if let Some(track) = track {
                    track.numbers(frame, &mut out, warnings);
                }
            }
            _ => {
                let values = node.values(frame, warnings)?;
                match channel {
                    Channel::Position => out.extend(values.position.to_array()),
                    Channel::Rotation => out.extend(wxyz(values.rotation.normalize())),
                    Channel::Scale => out.extend(values.scale.to_array()),
                    Channel::Visible => out.push(f64::from(u8::from(values.visible))),
                    Channel::Zoom => out.push(values.zoom),
                    Channel::Roll => out.push(values.roll),
                    Channel::Colour => out.extend(values.colour),
                    Channel::Intensity => out.push(values.intensity),
                    Channel::Cone => out.extend(values.cone),
                    _ => out.push(values.aim_weight),
                }
            }
        }
        Ok(out)
    }

    /// The points of an object's mesh at a frame, morphed and deformed, in its own coordinates.
    ///
    /// # Errors
    /// As [`Scene::evaluate`]; the same for the node and the length of `out`.
    pub fn vertices(
        &self,
        node: usize,
        frame: f64,
        out: &mut [DVec3],
        warnings: &mut Warnings,
    ) -> Result<()> {
        let form = self.form(node, frame, warnings)?;
        let count = self.mesh_points(node)?;
        if out.len() != count {
            return Err(OutOfRange::PointRoom {
                points: count,
                given: out.len(),
            }
            .into());
        }
        form.points(out);
        Ok(())
    }

    /// The colours of an object's points at a frame; empty if it has none.
    ///
    /// # Errors
    /// As [`Scene::vertices`].
    pub fn vertex_colours(
        &self,
        node: usize,
        frame: f64,
        warnings: &mut Warnings,
    ) -> Result<Vec<[u8; 3]>> {
        self.form(node, frame, warnings)?.colours()
    }

    /// An object's weights and deformations at a frame. Only this asks functions of the host's.
    ///
    /// # Errors
    /// As [`Scene::vertices`].
    pub fn form(&self, node: usize, frame: f64, warnings: &mut Warnings) -> Result<Form<'_>> {
        check_frame(frame)?;
        warnings.node = node;
        Form::at(self.node(node)?, frame, warnings)
    }

    fn mesh_points(&self, node: usize) -> Result<usize> {
        Ok(match &self.node(node)?.kind {
            Kind::Object(object) => object.mesh().points.len(),
            _ => 0,
        })
    }

    /// A node and all that its state depends on, each after what it needs; costs what it holds.
    pub(super) fn chain(&self, node: usize) -> Result<Vec<usize>> {
        let mut chain = Vec::new();
        let mut placed = HashSet::new();
        let mut open = vec_with_room(1)?;
        open.push(node);
        while let Some(&at) = open.last() {
            let needed = needs(&self.nodes, at).into_iter().flatten();
            open.try_reserve(2)?;
            let before = open.len();
            open.extend(needed.filter(|next| !placed.contains(next)));
            if open.len() == before {
                open.pop();
                placed.try_reserve(1)?;
                chain.try_reserve(1)?;
                if placed.insert(at) {
                    chain.push(at);
                }
            }
        }
        Ok(chain)
    }

    /// The world matrix of a node; of none, the identity. Costs as much as the node's ancestors are,
    /// unless one of them aims at a node.
    pub(super) fn world_of(&self, node: Option<usize>, frame: f64) -> Result<DAffine3> {
        let Some(node) = node else {
            return Ok(DAffine3::IDENTITY);
        };
        let chain = self.chain(node)?;
        let warnings = &mut Warnings::default();
        if chain.iter().any(|&at| self.nodes[at].aim.is_some()) {
            let mut states = self.scratch()?;
            let search = &mut Search::Back(Room::default());
            self.run(&chain, &[], frame, &mut states, warnings, search)?;
            return Ok(states[node].world());
        }
        let mut world = DAffine3::IDENTITY;
        for &at in &chain {
            let node = &self.nodes[at];
            let values = node.values_turned(frame, warnings)?;
            world *= local(node, &values);
        }
        Ok(world)
    }

    pub(super) fn scratch(&self) -> Result<Vec<NodeState>> {
        let mut scratch = vec_with_room(self.nodes.len())?;
        scratch.resize(self.nodes.len(), NodeState::default());
        Ok(scratch)
    }

    fn run(
        &self,
        order: &[usize],
        packs: &[Option<Pack>],
        frame: f64,
        states: &mut [NodeState],
        warnings: &mut Warnings,
        search: &mut Search,
    ) -> Result<()> {
        let mut group = Group::default();
        for (at, nodes) in order.chunks(GROUP).enumerate() {
            if let Some(Some(pack)) = packs.get(at)
                && pack.place(&self.nodes, frame, &mut group, states, warnings)
            {
                continue;
            }
            for &at in nodes {
                let node = &self.nodes[at];
                warnings.node = at;
                if !node.kind.looks() && node.path.is_none() {
                    states[at].begin(group.add(at, node, frame, warnings).looks());
                    continue;
                }
                let values = node.values_turned(frame, warnings)?;
                states[at].begin(values.looks());
                group.put(at, node, &values);
                if node.kind.looks() {
                    // It may turn when it is placed, and what is in it with it.
                    group.place(states, warnings);
                    self.look(at, frame, &values, states, search)?;
                }
            }
            group.place(states, warnings);
        }
        Ok(())
    }

    /// The pose of a camera or light that has its place, turned to what it aims at.
    fn look(
        &self,
        at: usize,
        frame: f64,
        values: &Values,
        states: &mut [NodeState],
        search: &mut Search,
    ) -> Result<()> {
        let mut world = states[at].world();
        let mut q = orthonormal(world.matrix3);
        if let Some(target) = self.nodes[at].aim
            && values.aim_weight > 0.0
        {
            let turned = self.aimed(at, target, frame, (q, world), *values, states, search)?;
            world.matrix3 = DMat3::from_quat(turned * q.conjugate()) * world.matrix3;
            q = turned;
            states[at].set_world(world);
        }
        let node = &self.nodes[at];
        let plain = node.parent.is_none() && node.aim.is_none();
        if let Some(path) = node.path()
            && plain
            && values.roll == 0.0
            && values.scale == DVec3::ONE
        {
            // As the path gives it, to the last bit.
            states[at].pose = path.pose(frame)?;
            return Ok(());
        }
        let (view, up) = view_from_quaternion(q);
        states[at].pose = Pose {
            vrp: world.translation.to_array(),
            vpn: view.to_array(),
            vup: up.to_array(),
            zoom: values.zoom,
        };
        Ok(())
    }

    #[expect(clippy::too_many_arguments)]
    fn aimed(
        &self,
        at: usize,
        target: usize,
        frame: f64,
        (own, world): (DQuat, DAffine3),
        values: Values,
        states: &[NodeState],
        search: &mut Search,
    ) -> Result<DQuat> {
        let pivot = self.pivot(target, frame, states)?;
        let direction = aim::direction(world.translation, pivot, self.space());
        let up = self.space().up;
        let good = |view: DVec3| !aim::steep(view, up);
        let own_view = view_from_quaternion(own).0;
        let (view, last) = match direction {
            Some(view) if good(view) => (view, None),
            other => {
                let last = match search {
                    Search::Back(room) => {
                        self.last_view(at, target, frame, other.is_some(), room)?
                    }
                    Search::Own => None,
                };
                let view = other.or(last).unwrap_or(own_view);
                (view, last.or(Some(own_view)).filter(|&view| good(view)))
            }
        };
        let aimed = aim::aimed(view, last, values.roll.to_radians(), up);
        Ok(aim::blend(own, aimed, values.aim_weight))
    }

    /// Where in the world a node's pivot is; its parent has been evaluated.
    fn pivot(&self, at: usize, frame: f64, states: &[NodeState]) -> Result<DVec3> {
        let node = &self.nodes[at];
        // Warnings are told when the node itself is evaluated.
        let values = node.values(frame, &mut Warnings::default())?;
        let place = values.position + node.pivot;
        Ok(match node.parent {
            Some(parent) => states[parent].world().transform_point3(place),
            None => place,
        })
    }

    /// Whether a node moves, or something that its state depends on; `known` has what was found before.
    fn depends_on_motion(&self, node: usize, known: &mut Vec<Option<bool>>) -> Result<bool> {
        if known.is_empty() {
            known.try_reserve(self.nodes.len())?;
            known.resize(self.nodes.len(), None);
        }
        let mut open = vec_with_room(1)?;
        open.push(node);
        while let Some(&at) = open.last() {
            let above = needs(&self.nodes, at).into_iter().flatten();
            if let Some(next) = above.clone().find(|&up| known[up].is_none()) {
                open.try_reserve(1)?;
                open.push(next);
                continue;
            }
            let aimed_at = self.nodes[at]
                .aim
                .is_some_and(|aim| self.nodes[aim].may_change());
            let moves = aimed_at || self.nodes[at].may_change();
            known[at] = Some(moves || above.into_iter().any(|up| known[up] == Some(true)));
            open.pop();
        }
        Ok(known[node] == Some(true))
    }

    /// The last direction, not steep if `with_yaw`, in which a node saw its target; else the next.
    fn last_view(
        &self,
        at: usize,
        target: usize,
        frame: f64,
        with_yaw: bool,
        room: &mut Room,
    ) -> Result<Option<DVec3>> {
        // Where nothing moves it is never another: so many that hang in one another cost no more than
        // each once.
        let mut moves = |at: usize| -> Result<bool> {
            let parent = self.nodes[at].parent;
            let above =
                parent.map_or(Ok(false), |up| self.depends_on_motion(up, &mut room.moves))?;
            Ok(above || self.nodes[at].may_change())
        };
        if !moves(at)? && !moves(target)? {
            return Ok(None);
        }
        let room = &mut room.states;
        let mut chain = self.chain(at)?;
        chain.pop(); // the node itself
        if room.is_empty() {
            *room = self.scratch()?;
        }
        let mut look = |frame: f64| -> Result<Option<DVec3>> {
            let none = &mut Warnings::default();
            self.run(&chain, &[], frame, room, none, &mut Search::Own)?;
            let eye = self.pivot(at, frame, room)?;
            let pivot = self.pivot(target, frame, room)?;
            let view = aim::direction(eye, pivot, self.space());
            Ok(view.filter(|&view| !with_yaw || !aim::steep(view, self.space().up)))
        };
        for sign in [-1.0, 1.0] {
            for k in 0..STEPS {
                let mut far = FIRST_STEP * (1_u64 << k) as f64;
                let Some(mut found) = look(frame + sign * far)? else {
                    continue;
                };
                let mut near = if k == 0 { far } else { far / 2.0 };
                for _ in 0..HALVINGS {
                    let middle = near + (far - near) / 2.0;
                    if middle <= near || middle >= far {
                        break;
                    }
                    match look(frame + sign * middle)? {
                        Some(view) => (far, found) = (middle, view),
                        None => near = middle,
                    }
                }
                return Ok(Some(found));
            }
        }
        Ok(None)
    }
}
