//! What `customData = { string vides = "…" }` says of a prim that we wrote.

/// Holds everything, and is no node.
pub(super) const WORLD: &str = "world";
/// The camera or light of the prim that it is in.
pub(super) const LOOKS: &str = "looks";
/// Geometry of the prim that it is in.
pub(super) const PART: &str = "part";
/// The document's wireframe.
pub(super) const WIREFRAME: &str = "wireframe";
