//! What moves, as attributes: the keys of a track where they mean the same in the file, which goes
//! straight from one to the next, else a key a frame.

use std::io::Write;

use glam::{DAffine3, DMat4, DQuat, DVec3};
use vides_engine::math::orientation::quaternion_from_view;
use vides_engine::scene::{Channel, Interpolation, NodeState, Track, Warnings};

use super::text::{Double3, Quat};
use super::write::{Writer, keeps_keys, put};
use crate::blocks::{BLOCK, failed};
use crate::convention::{HALF_TURN, rolled};
use crate::error::Result;
use crate::flight::succeeded;

/// How long before a key of a step the value before it is repeated, in frames: between the two
/// the file goes from one to the other.
pub(super) const JUST_BEFORE: f64 = 1e-6;

/// Makes a value of the numbers of a channel.
type Value<'a> = &'a dyn Fn(&[f64]) -> String;

/// The numbers of a channel at a frame; no channel that is written has more.
type Numbers = [f64; 4];

impl Writer<'_, '_, '_> {
    /// The time code of a frame of the scene.
    fn code(&self, frame: f64) -> f64 {
        let (first, step) = self.flight.first_and_step();
        if step == 1.0 {
            return frame + (f64::from(self.flight.info().first_frame) - 1.0);
        }
        self.flight.number(0) + (frame - first) / step
    }

    /// The time code of a frame that is written.
    pub(super) fn code_of(&self, index: usize) -> f64 {
        self.flight.number(0) + index as f64
    }

    fn moved_by_path(&self, at: usize, channel: &Channel) -> bool {
        let by_path = matches!(
            channel,
            Channel::Position | Channel::Rotation | Channel::Zoom
        );
        by_path && self.of(at).path().is_some()
    }

    fn numbers(&self, at: usize, channel: &Channel, frame: f64) -> Result<Numbers> {
        let mut warnings = Warnings::default();
        let scene = self.flight.scene();
        let values = scene.value(at, channel, frame, &mut warnings)?;
        succeeded(warnings, self.of(at))?;
        let mut numbers = Numbers::default();
        for (number, value) in numbers.iter_mut().zip(values) {
            *number = value;
        }
        Ok(numbers)
    }

    /// A channel as an attribute.
    pub(super) fn attribute(
        &mut self,
        at: usize,
        depth: usize,
        name: &str,
        channel: &Channel,
        value: Value<'_>,
    ) -> Result<()> {
        let (first, step) = self.flight.first_and_step();
        let last = first + step * (self.flight.count() - 1) as f64;
        let track = self.of(at).keys().track(channel);
        if self.moved_by_path(at, channel) {
            return self.frames_of(at, depth, name, channel, value);
        }
        match track {
            None => {
                let value = value(&self.numbers(at, channel, first)?);
                put!(self, depth, "{name} = {value}")
            }
            Some(track) if keeps_keys(track, first, last) => {
                self.keys_of(track, depth, name, value)
            }
            Some(_) => {
                self.sampled += 1;
                self.frames_of(at, depth, name, channel, value)
            }
        }
    }

    fn keys_of(&mut self, track: &Track, depth: usize, name: &str, value: Value<'_>) -> Result<()> {
        // Tokens are held from one sample to the next, numbers are not.
        let steps = *track.interpolation() == Interpolation::Step && !name.starts_with("token");
        put!(self, depth, "{name}.timeSamples = {{")?;
        let mut before: Option<(f64, String)> = None;
        let keys = track.values().chunks_exact(track.width());
        for (&frame, numbers) in track.frames().iter().zip(keys) {
            let (code, value) = (self.code(frame), value(numbers));
            if let Some((old_code, old)) = before.filter(|_| steps)
                && old != value
                && old_code < code - JUST_BEFORE
            {
                put!(self, depth + 1, "{}: {old},", code - JUST_BEFORE)?;
            }
            put!(self, depth + 1, "{code}: {value},")?;
            before = Some((code, value));
        }
        put!(self, depth, "}}")
    }

    /// A channel as an attribute with a key a frame.
    pub(super) fn frames_of(
        &mut self,
        at: usize,
        depth: usize,
        name: &str,
        channel: &Channel,
        value: Value<'_>,
    ) -> Result<()> {
        self.frames(
            depth,
            name,
            |writer, index| writer.numbers(at, channel, writer.flight.frame(index)),
            |numbers| value(numbers),
        )
    }

    /// An attribute with a key a frame, of what is sampled one by one.
    fn frames<T: Clone + Default>(
        &mut self,
        depth: usize,
        name: &str,
        sample: impl Fn(&Self, usize) -> Result<T>,
        value: impl Fn(&T) -> String,
    ) -> Result<()> {
        self.frame_blocks(
            depth,
            name,
            |writer, from, block| {
                for (at, one) in block.iter_mut().enumerate() {
                    *one = sample(writer, from + at)?;
                }
                Ok(())
            },
            value,
        )
    }

    /// The same, sampled in blocks.
    fn frame_blocks<T: Clone + Default>(
        &mut self,
        depth: usize,
        name: &str,
        sample: impl Fn(&Self, usize, &mut [T]) -> Result<()>,
        value: impl Fn(&T) -> String,
    ) -> Result<()> {
        put!(self, depth, "{name}.timeSamples = {{")?;
        let indent = " ".repeat(4 * usize::min(depth + 1, 8));
        let mut text = Vec::new();
        let count = self.flight.count();
        let mut done = 0;
        let mut block = vides_document::error::vec_with_room(BLOCK.min(count))?;
        block.resize(BLOCK.min(count), T::default());
        while done < count {
            let part = (count - done).min(BLOCK);
            let block = &mut block[..part];
            sample(self, done, block)?;
            for (at, one) in block.iter().enumerate() {
                let code = self.code_of(done + at);
                writeln!(text, "{indent}{code}: {},", value(one)).map_err(failed)?;
            }
            self.out.write_all(&text).map_err(failed)?;
            text.clear();
            done += part;
        }
        put!(self, depth, "}}")
    }

    /// The states of a node, as an attribute with a key a frame.
    fn frames_of_state(
        &mut self,
        at: usize,
        depth: usize,
        name: &str,
        value: impl Fn(&NodeState) -> String,
    ) -> Result<()> {
        self.frame_blocks(
            depth,
            name,
            |writer, from, block| writer.flight.fill_states(at, from, block),
            value,
        )
    }

    /// The operations that place a node in its parent's coordinates; `turned` is done first. Of what
    /// aims, only `rigid` ones are turns: others have a matrix.
    pub(super) fn transform(
        &mut self,
        at: usize,
        depth: usize,
        turned: DQuat,
        rigid: bool,
    ) -> Result<()> {
        let node = self.of(at);
        if node.aim.is_some() && !rigid {
            return self.matrices(at, depth);
        }
        let flight = self.flight;
        let scale = flight.options().scale;
        let root = node.parent.is_none();
        let pivot = node.pivot;
        let place = move |v: &[f64]| {
            let place = DVec3::new(v[0], v[1], v[2]);
            if root {
                // Turned about the world's origin; the pivot itself is in the node's axes.
                let place = flight.direction(place + pivot) - pivot;
                return Double3(place * scale).to_string();
            }
            Double3(place * scale).to_string()
        };
        let mut order = vec!["xformOp:translate"];
        let name = "double3 xformOp:translate";
        self.attribute(at, depth, name, &Channel::Position, &place)?;
        if pivot != DVec3::ZERO {
            let pivot = Double3(pivot * scale);
            put!(self, depth, "double3 xformOp:translate:pivot = {pivot}")?;
            order.push("xformOp:translate:pivot");
        }
        self.orientation(at, depth, turned)?;
        order.push("xformOp:orient");
        let scales = node.keys().track(&Channel::Scale).is_some() || node.rest.scale != DVec3::ONE;
        if scales {
            let name = "double3 xformOp:scale";
            self.attribute(at, depth, name, &Channel::Scale, &|v| {
                Double3(DVec3::new(v[0], v[1], v[2])).to_string()
            })?;
            order.push("xformOp:scale");
        }
        if pivot != DVec3::ZERO {
            order.push("!invert!xformOp:translate:pivot");
        }
        put!(self, depth, "uniform token[] xformOpOrder = {order:?}")
    }

    fn orientation(&mut self, at: usize, depth: usize, turned: DQuat) -> Result<()> {
        const NAME: &str = "quatd xformOp:orient";
        let node = self.of(at);
        let flight = self.flight;
        let root = node.parent.is_none();
        let in_file = move |turn: DQuat| {
            let turn = if root { flight.rotation(turn) } else { turn };
            Quat((turn * turned).normalize()).to_string()
        };
        let quaternion = |v: &[f64]| DQuat::from_xyzw(v[1], v[2], v[3], v[0]).normalize();
        if node.aim.is_some() {
            return self.aimed(at, depth, in_file);
        }
        // Of cameras alone: others have none.
        let rolls = matches!(node.kind, vides_engine::scene::Kind::Camera(_));
        if !(rolls && node.keys().track(&Channel::Roll).is_some()) {
            let roll = if rolls { node.rest.roll } else { 0.0 };
            return self.attribute(at, depth, NAME, &Channel::Rotation, &|v| {
                in_file(rolled(quaternion(v), roll))
            });
        }
        self.sampled += 1;
        self.frames(
            depth,
            NAME,
            |writer, index| {
                let frame = writer.flight.frame(index);
                let turn = writer.numbers(at, &Channel::Rotation, frame)?;
                let [degrees, ..] = writer.numbers(at, &Channel::Roll, frame)?;
                Ok(rolled(quaternion(&turn), degrees))
            },
            |turn| in_file(*turn),
        )
    }

    /// The rotation of a camera or light that aims, in its parent, which does not scale.
    fn aimed(&mut self, at: usize, depth: usize, in_file: impl Fn(DQuat) -> String) -> Result<()> {
        let parent = self.of(at).parent;
        self.frame_blocks(
            depth,
            "quatd xformOp:orient",
            |writer, from, block: &mut [DQuat]| {
                let states = writer.flight.states(at, from, block.len())?;
                for (turn, state) in block.iter_mut().zip(&states) {
                    *turn = rotation(state);
                }
                if let Some(parent) = parent {
                    let states = writer.flight.states(parent, from, block.len())?;
                    for (turn, state) in block.iter_mut().zip(&states) {
                        let parent = DQuat::from_mat3(&state.world().matrix3).normalize();
                        *turn = parent.conjugate() * *turn;
                    }
                }
                Ok(())
            },
            |turn| in_file(*turn),
        )
    }

    /// The matrix of a node that aims below something that scales.
    fn matrices(&mut self, at: usize, depth: usize) -> Result<()> {
        let parent = self.of(at).parent;
        let flight = self.flight;
        self.frame_blocks(
            depth,
            "matrix4d xformOp:transform",
            |writer, from, block: &mut [DAffine3]| {
                let states = writer.flight.states(at, from, block.len())?;
                for (matrix, state) in block.iter_mut().zip(&states) {
                    *matrix = state.world();
                }
                let Some(parent) = parent else {
                    let to_file = flight.to_file();
                    let back = DAffine3::from_scale(DVec3::splat(flight.options().scale.recip()));
                    for matrix in block {
                        *matrix = to_file * *matrix * back;
                    }
                    return Ok(());
                };
                let states = writer.flight.states(parent, from, block.len())?;
                for (matrix, state) in block.iter_mut().zip(&states) {
                    *matrix = state.world().inverse() * *matrix;
                    matrix.translation *= flight.options().scale;
                    if !matrix.is_finite() {
                        // In what is scaled to nothing, nothing is seen.
                        *matrix = DAffine3::IDENTITY;
                    }
                }
                Ok(())
            },
            |matrix| {
                // Rows of USD's matrices are our columns.
                let [x, y, z, w] = DMat4::from(*matrix).to_cols_array_2d().map(|column| {
                    let [x, y, z, w] = column;
                    format!("({x:?}, {y:?}, {z:?}, {w:?})")
                });
                format!("({x}, {y}, {z}, {w})")
            },
        )?;
        put!(
            self,
            depth,
            "uniform token[] xformOpOrder = [\"xformOp:transform\"]"
        )
    }

    /// The pose of a camera or light in the world, frame by frame.
    pub(super) fn pose_frames(&mut self, at: usize, depth: usize) -> Result<()> {
        let flight = self.flight;
        self.frames_of_state(at, depth, "double3 xformOp:translate", |state| {
            Double3(flight.place(state.pose.vrp.into())).to_string()
        })?;
        self.frames_of_state(at, depth, "quatd xformOp:orient", |state| {
            Quat((flight.rotation(rotation(state)) * HALF_TURN).normalize()).to_string()
        })?;
        let order = ["xformOp:translate", "xformOp:orient"];
        put!(self, depth, "uniform token[] xformOpOrder = {order:?}")?;
        let nodes = self.flight.scene().nodes();
        let hides = |at: &usize| {
            let node = &nodes[*at];
            !node.rest.visible || node.keys().track(&Channel::Visible).is_some()
        };
        let mut above = std::iter::successors(Some(at), |&at| nodes[at].parent);
        if above.any(|at| hides(&at)) {
            return self.frames_of_state(at, depth, "token visibility", |state| {
                seen(state.visible != 0).to_owned()
            });
        }
        Ok(())
    }

    /// Whether a node is seen, if it ever is not.
    pub(super) fn visibility(&mut self, at: usize, depth: usize) -> Result<()> {
        let node = self.of(at);
        if node.rest.visible && node.keys().track(&Channel::Visible).is_none() {
            return Ok(());
        }
        self.attribute(at, depth, "token visibility", &Channel::Visible, &|v| {
            seen(v[0] != 0.0).to_owned()
        })
    }
}

fn seen(visible: bool) -> &'static str {
    if visible {
        "\"inherited\""
    } else {
        "\"invisible\""
    }
}

/// The rotation of a camera's or light's pose.
fn rotation(state: &NodeState) -> DQuat {
    quaternion_from_view(state.pose.vpn.into(), state.pose.vup.into())
}
