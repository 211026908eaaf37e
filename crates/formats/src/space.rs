//! The smallest cube round everything of a scene.

use std::borrow::Cow;
use std::collections::HashMap;

use glam::DVec3;
use vides_document::error::vec_with_room;
use vides_engine::path::{Space, Up};
use vides_engine::scene::{Channel, Kind, Light, NodeState, Scene, Warnings};

use super::content::space_around;
use super::error::Result;

/// Nodes that are placed, over all frames that are looked at.
const PLACED: usize = 100_000;

/// Points that are placed, over all frames; of objects with more their bounds' corners.
const MOST: usize = 20_000_000;

/// Round other places, and all points, cameras and lights at frames all over the scene's and at
/// the keys of those without a parent.
pub(super) fn around(scene: &Scene, others: impl Iterator<Item = DVec3>, up: Up) -> Result<Space> {
    let nodes = scene.nodes();
    let (first, last) = scene.frame_range();
    let most = (PLACED / nodes.len().max(1)).clamp(1, 1000);
    let steps = ((last - first).ceil() as usize).min(most);
    let shapes = shapes(scene, MOST / (steps + 1))?;
    let mut bounds = Bounds::default();
    others.for_each(|place| bounds.hold(place));
    let mut states = vec_with_room(nodes.len())?;
    states.resize(nodes.len(), NodeState::default());
    for step in 0..=steps {
        let frame = first + (last - first) * step as f64 / steps.max(1) as f64;
        scene.evaluate(frame, &mut states, &mut Warnings::default())?;
        for (points, state) in shapes.iter().zip(&states) {
            let world = state.world();
            for point in points.iter() {
                bounds.hold(world.transform_point3(*point));
            }
        }
    }
    for (node, points) in nodes.iter().zip(&shapes) {
        if node.parent.is_none()
            && !points.is_empty()
            && let Some(track) = node.keys().track(&Channel::Position)
        {
            for key in track.values().chunks_exact(track.width()) {
                bounds.hold(DVec3::from_slice(key));
            }
        }
    }
    let ends = bounds.0.unwrap_or_default();
    space_around(&[], &ends, up)
}

/// For each node the places that it takes, in its own coordinates: none for what has no place.
fn shapes(scene: &Scene, mut room: usize) -> Result<Vec<Cow<'_, [DVec3]>>> {
    let mut corners_of: HashMap<usize, Vec<DVec3>> = HashMap::new();
    let mut shapes = vec_with_room(scene.nodes().len())?;
    shapes.extend(scene.nodes().iter().map(|node| match &node.kind {
        Kind::Camera(_) | Kind::Light(Light::Point | Light::Spot) => {
            Cow::Borrowed(&[DVec3::ZERO][..])
        }
        Kind::Object(object) => {
            let mesh = object.mesh();
            match room.checked_sub(mesh.points.len()) {
                Some(left) => {
                    room = left;
                    Cow::Borrowed(&mesh.points[..])
                }
                None => {
                    let corners = corners_of.entry(std::ptr::from_ref(mesh).addr());
                    Cow::Owned(
                        corners
                            .or_insert_with(|| corners_round(&mesh.points))
                            .clone(),
                    )
                }
            }
        }
        Kind::Light(Light::Directional) | Kind::Group => Cow::Borrowed(&[][..]),
    }));
    Ok(shapes)
}

fn corners_round(points: &[DVec3]) -> Vec<DVec3> {
    let mut bounds = Bounds::default();
    points.iter().for_each(|point| bounds.hold(*point));
    let corners = |ends: [DVec3; 2]| {
        let corner =
            move |at: usize| DVec3::from(std::array::from_fn(|axis| ends[at >> axis & 1][axis]));
        (0..8).map(corner).collect()
    };
    bounds.0.map_or_else(Vec::new, corners)
}

/// The lowest and the highest coordinates of finite places.
#[derive(Default)]
struct Bounds(Option<[DVec3; 2]>);

impl Bounds {
    fn hold(&mut self, place: DVec3) {
        if place.is_finite() {
            let [low, high] = self.0.unwrap_or([place; 2]);
            self.0 = Some([low.min(place), high.max(place)]);
        }
    }
}
