//! Which scenes are nothing but a path, and so are written as one.

use glam::DVec3;
use vides_engine::property::SameBits;
use vides_engine::scene::{Camera, Extrapolation, FollowPath, Kind, Scene, Values};

/// The path of a scene that is nothing but a camera on it.
pub(crate) fn alone(scene: &Scene) -> Option<&FollowPath> {
    if scene.nodes().len() > 1 {
        return None;
    }
    let node = scene.nodes().first()?;
    let path = node.path()?;
    let plain = node.name == "camera"
        && node.kind == Kind::Camera(Camera::default())
        && node.aim.is_none()
        && node.pivot.same_bits(&DVec3::ZERO)
        && node.rest.same_bits(&Values::NEW)
        && node.keys().tracks().is_empty()
        && scene.markers().is_empty()
        && scene.camera().is_none()
        && scene.range().is_none()
        && path.start_frame() == 1.0
        && path.extrapolation() == Extrapolation::Hold
        && path.path().space == scene.space();
    plain.then_some(path)
}
