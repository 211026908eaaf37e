//! Names of the extensions that we know.

pub(super) const LIGHTS: &str = "KHR_lights_punctual";
pub(super) const VISIBILITY: &str = "KHR_node_visibility";
pub(super) const POINTER: &str = "KHR_animation_pointer";
