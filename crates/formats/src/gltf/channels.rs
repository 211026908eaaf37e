//! What changes of nodes beside their place.

use serde_json::json;
use vides_document::error::vec_with_room;
use vides_engine::scene::{Channel, Node, Values, Warnings};

use super::extensions;
use super::keys::{self, Target};
use super::of_node::{field, path_poses, values};
use super::write::Writer;
use crate::blocks::BLOCK;
use crate::error::Result;
use crate::flight::succeeded;

impl Writer<'_, '_> {
    /// The field of view at the first frame; its keys where it changes.
    pub(super) fn zoom(&mut self, node: &Node, camera: usize) -> Result<f32> {
        let pointer = || format!("/cameras/{camera}/perspective/yfov");
        let moves = node.path().is_some() || node.keys().track(&Channel::Zoom).is_some();
        // What moves along a path has been sampled with its place.
        let mut fields = std::mem::take(&mut self.fields);
        if fields.is_empty() {
            fields = self.channel(node, moves, |values| field(values.zoom))?;
        }
        self.pointer(pointer, &fields)?;
        Ok(fields[0][0])
    }

    /// Something of a node's values in each frame, or in the first alone if nothing moves it.
    pub(super) fn channel<const N: usize>(
        &self,
        node: &Node,
        moves: bool,
        take: impl Fn(&Values) -> [f32; N],
    ) -> Result<Vec<[f32; N]>> {
        let count = if moves { self.flight.count() } else { 1 };
        let mut all = vec_with_room(count)?;
        let mut warnings = Warnings::default();
        for from in (0..count).step_by(BLOCK) {
            let block = BLOCK.min(count - from);
            let poses = path_poses(self.flight, node, from, block)?;
            for index in 0..block {
                if let Some(pose) = poses.get(index) {
                    let zoom = pose.zoom;
                    all.push(take(&Values { zoom, ..node.rest }));
                } else {
                    let frame = self.flight.frame(from + index);
                    all.push(take(&values(node, frame, &mut warnings)?));
                }
            }
        }
        succeeded(warnings, node)?;
        Ok(all)
    }

    /// A key a frame for what a pointer says, where it changes.
    pub(super) fn pointer<const N: usize>(
        &mut self,
        pointer: impl FnOnce() -> String,
        all: &[[f32; N]],
    ) -> Result<()> {
        if all.iter().all(|one| *one == all[0]) {
            return Ok(());
        }
        let target = Target::Pointer(pointer());
        let numbers = all.as_flattened();
        self.animation
            .a_key_a_frame(self.flight, &mut self.binary, target, numbers, N)
    }

    pub(super) fn weights(&mut self, own: usize, node: &Node) -> Result<()> {
        let Some(track) = node.keys().track(&Channel::Weights) else {
            return Ok(());
        };
        let (flight, width) = (self.flight, track.width());
        let target = Target::Node(own, "weights");
        if let Some(keys) = keys::numbers(flight, track) {
            return self.animation.keys(&mut self.binary, target, &keys, width);
        }
        let mut all: Vec<f32> = vec_with_room(width * flight.count())?;
        let mut numbers = vec![0.0; width];
        let mut warnings = Warnings::default();
        for at in 0..flight.count() {
            track.numbers(flight.frame(at), &mut numbers, &mut warnings);
            all.extend(numbers.iter().map(|&number| number as f32));
        }
        succeeded(warnings, node)?;
        self.animation
            .a_key_a_frame(flight, &mut self.binary, target, &all, width)
    }

    pub(super) fn visible(&mut self, own: usize, node: &Node, frame: f64) -> Result<()> {
        let flight = self.flight;
        let mut warnings = Warnings::default();
        let Some(track) = node.keys().track(&Channel::Visible) else {
            return self.seen(own, &[u8::from(node.rest.visible)]);
        };
        if let Some(keys) = keys::numbers(flight, track) {
            let seen = values(node, frame, &mut warnings)?.visible;
            self.hides = true;
            self.extend(own, extensions::VISIBILITY, json!({"visible": seen}));
            return self.animation.keys(&mut self.binary, switch(own), &keys, 1);
        }
        let mut switches: Vec<u8> = vec_with_room(flight.count())?;
        for at in 0..flight.count() {
            let mut seen = [0.0];
            track.numbers(flight.frame(at), &mut seen, &mut warnings);
            switches.push(u8::from(seen != [0.0]));
        }
        self.seen(own, &switches)
    }

    /// Whether a node is seen in each frame, or all the time.
    pub(super) fn seen(&mut self, own: usize, switches: &[u8]) -> Result<()> {
        if switches.iter().all(|&seen| seen == 1) {
            return Ok(());
        }
        self.hides = true;
        let first = json!({"visible": switches[0] == 1});
        self.extend(own, extensions::VISIBILITY, first);
        if switches.iter().all(|&seen| seen == 0) {
            return Ok(());
        }
        let target = switch(own);
        let (flight, binary) = (self.flight, &mut self.binary);
        self.animation
            .a_switch_a_frame(flight, binary, target, switches)
    }
}

/// What hides and shows a node.
fn switch(own: usize) -> Target {
    let name = extensions::VISIBILITY;
    Target::Pointer(format!("/nodes/{own}/extensions/{name}/visible"))
}
