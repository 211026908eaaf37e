//! The scene: everything that moves, on one timeline in frames (`docs/scene.md`).
//!
//! [`Scene`] is the tree of [`Node`]s with markers and pins. What changes a node's [`Values`] is a
//! [`Motion`]: [`FollowPath`] or [`Keys`], a [`Track`] for each [`Channel`] that changes.
//!
//! It knows nothing of files, of undo or of C. A path knows nothing of it.

mod aim;
pub mod channel;
mod evaluate;
mod exchange;
mod hierarchy;
pub mod host;
mod keep_way;
mod keys;
mod markers;
pub mod mesh;
pub mod motion;
pub mod node;
mod part;
mod part_nodes;
mod part_object;
pub mod pins;
pub mod removal;
mod reparent;
mod rotation;
#[expect(clippy::module_inception)]
mod scene;
mod shown;
mod side_by_side;
mod splice;
mod state;
mod tangents;
pub mod time;
pub mod track;
mod vertices;

pub use channel::Channel;
pub use keys::Keys;
pub use markers::{Marker, Pin};
pub use mesh::{Geometry, Mesh, MeshSource, Object, Shape};
pub use motion::{FollowPath, Motion};
pub use node::{Camera, Kind, Light, Node, Values};
pub use part::{Part, Rest};
pub use part_nodes::NodeList;
pub use reparent::Keep;
pub use scene::Scene;
pub use splice::{KeyList, Manner};
pub use state::{NodeState, Warnings};
pub use time::{Extrapolation, local_frame};
pub use track::{Interpolation, Track};
pub use vertices::Form;
