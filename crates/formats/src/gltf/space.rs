//! The smallest cube round everything of a scene.

use std::collections::HashMap;

use glam::{DAffine3, DVec3};
use vides_document::error::vec_with_room;
use vides_engine::scene::{Channel, Kind, NodeState, Scene, Warnings};

use crate::content::Recording;
use crate::error::Result;
use crate::path::{Space, Up};

/// More points than this are taken as the corners of their objects' bounds.
const MOST: usize = 20_000_000;

/// Round all points at the first frame, and all places that keys move nodes to.
pub(super) fn around(scene: &Scene, up: Up) -> Result<Space> {
    let nodes = scene.nodes();
    let mut states = vec_with_room(nodes.len())?;
    states.resize(nodes.len(), NodeState::default());
    let (first, _) = scene.frame_range();
    scene.evaluate(first, &mut states, &mut Warnings::default())?;
    let (mut low, mut high) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    let mut hold = |place: DVec3| {
        if place.is_finite() {
            low = low.min(place);
            high = high.max(place);
        }
    };
    let mut room = MOST;
    let mut boxes: HashMap<usize, [DVec3; 8]> = HashMap::new();
    for (node, state) in nodes.iter().zip(&states) {
        let world = state.world();
        match &node.kind {
            Kind::Object(object) => {
                let points = &object.mesh().points;
                match room.checked_sub(points.len()) {
                    Some(left) => {
                        room = left;
                        points
                            .iter()
                            .for_each(|point| hold(world.transform_point3(*point)));
                    }
                    None => {
                        let mesh = std::ptr::from_ref(object.mesh()).addr();
                        let bounds = boxes.entry(mesh).or_insert_with(|| corners(points));
                        bounds
                            .iter()
                            .for_each(|point| hold(world.transform_point3(*point)));
                    }
                }
            }
            Kind::Group => {}
            _ => hold(world.translation),
        }
        let above = node
            .parent
            .map_or(DAffine3::IDENTITY, |parent| states[parent].world());
        if let Some(track) = node.keys().track(&Channel::Position) {
            for key in track.values().chunks_exact(track.width()) {
                hold(above.transform_point3(DVec3::from_slice(key)));
            }
        }
    }
    if !(low.x <= high.x) {
        (low, high) = (DVec3::ZERO, DVec3::ZERO);
    }
    let mut corners: Vec<DVec3> = vec_with_room(2)?;
    corners.extend([low, high]);
    let bounds = Recording {
        points: corners,
        ..Recording::default()
    };
    bounds.space(up)
}

fn corners(points: &[DVec3]) -> [DVec3; 8] {
    let low = points.iter().copied().fold(DVec3::INFINITY, DVec3::min);
    let high = points.iter().copied().fold(DVec3::NEG_INFINITY, DVec3::max);
    std::array::from_fn(|at| {
        let side = |bit: usize, low: f64, high: f64| if at & bit == 0 { low } else { high };
        DVec3::new(
            side(1, low.x, high.x),
            side(2, low.y, high.y),
            side(4, low.z, high.z),
        )
    })
}
