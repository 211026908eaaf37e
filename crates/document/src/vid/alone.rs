//! Which scenes are nothing but a path, and so are written as one.

use vides_engine::scene::{Camera, Extrapolation, FollowPath, Kind, Scene, Values};

/// The path of a scene that is nothing but a camera on it.
pub(crate) fn alone(scene: &Scene) -> Option<&FollowPath> {
    let [node] = scene.nodes() else {
        return None;
    };
    let path = node.path()?;
    let plain = node.name == "camera"
        && node.kind == Kind::Camera(Camera::default())
        && node.aim.is_none()
        && same(&node.pivot.to_array(), &[0.0; 3])
        && node.rest.visible
        && rest(&node.rest)
            .iter()
            .zip(&rest(&Values::default()))
            .all(|(own, default)| same(&own.1, &default.1))
        && node.keys().tracks().is_empty()
        && scene.markers().is_empty()
        && scene.camera().is_none()
        && scene.range().is_none()
        && path.start_frame() == 1.0
        && path.extrapolation() == Extrapolation::Hold
        && path.path().space == scene.space();
    plain.then_some(path)
}

/// Bitwise equality: −0 must come back as −0.
pub(super) fn same(a: &[f64], b: &[f64]) -> bool {
    a.len() == b.len() && a.iter().zip(b).all(|(a, b)| a.to_bits() == b.to_bits())
}

/// The written rest values of a node, by key.
pub(super) fn rest(values: &Values) -> [(&'static str, Vec<f64>); 9] {
    let q = values.rotation;
    [
        ("position", values.position.to_array().to_vec()),
        ("rotation", vec![q.w, q.x, q.y, q.z]),
        ("scale", values.scale.to_array().to_vec()),
        ("colour", values.colour.to_vec()),
        ("cone_degrees", values.cone.to_vec()),
        ("zoom_mm", vec![values.zoom]),
        ("roll_degrees", vec![values.roll]),
        ("intensity", vec![values.intensity]),
        ("aim_weight", vec![values.aim_weight]),
    ]
}
