//! What a node has at a frame.

use glam::DQuat;
use vides_document::error::vec_with_room;
use vides_engine::path::Pose;
use vides_engine::scene::{Channel, Kind, Motion, Node, Values, Warnings};

use crate::convention;
use crate::error::Result;
use crate::flight::Flight;

/// What holds at a frame of a node's own values.
pub(super) fn values(node: &Node, frame: f64, warnings: &mut Warnings) -> Result<Values> {
    let mut values = node.rest;
    if let Some(path) = node.path() {
        path.at(frame, &mut values, warnings)?;
    }
    node.keys().at(frame, &mut values, warnings)?;
    Ok(values)
}

/// The poses of a node whose place is a path's alone, at whole frames of it; else none.
pub(super) fn path_poses(
    flight: &Flight<'_>,
    node: &Node,
    from: usize,
    count: usize,
) -> Result<Vec<Pose>> {
    let Some(path) = node.path() else {
        return Ok(Vec::new());
    };
    let (first, step) = flight.first_and_step();
    let start = flight.frame(from) - path.start_frame() + 1.0;
    let inside = start >= 1.0 && start + (count - 1) as f64 <= path.count() as f64;
    if !node.keys().tracks().is_empty()
        || step != 1.0
        || start.fract() != 0.0
        || first.fract() != path.start_frame().fract()
        || !inside
    {
        return Ok(Vec::new());
    }
    let mut poses = vec_with_room(count)?;
    poses.resize(count, Pose::default());
    path.sampler()?.sample(start as usize, &mut poses)?;
    Ok(poses)
}

/// The vertical field of view in radians.
pub(super) fn field(zoom: f64) -> [f32; 1] {
    [convention::field_of_view(zoom) as f32]
}

pub(super) fn aims(node: &Node) -> bool {
    node.aim.is_some()
        && (node.rest.aim_weight > 0.0 || node.keys().track(&Channel::AimWeight).is_some())
}

/// A camera's roll goes into its rotation.
pub(super) fn rolls(node: &Node) -> bool {
    matches!(node.kind, Kind::Camera(_))
        && (node.rest.roll != 0.0 || node.keys().track(&Channel::Roll).is_some())
}

pub(super) fn rolled(node: &Node, values: &Values) -> DQuat {
    let rotation = values.rotation.normalize();
    match rolls(node) {
        true => convention::rolled(rotation, values.roll),
        false => rotation,
    }
}
