//! The scene: everything that moves, on one timeline in frames (`docs/reference/scene.md`).
//!
//! [`Scene`] is the tree of [`Node`]s with markers and pins. What changes a node's [`Values`] is a
//! [`Motion`]: [`FollowPath`] or [`Keys`], a [`Track`] for each [`Channel`] that changes.
//!
//! It knows nothing of files, of undo or of C. A path knows nothing of it.

mod aim;
mod apply;
pub mod channel;
mod evaluate;
mod hierarchy;
pub mod host;
pub(crate) mod interpolation;
mod keep_way;
mod key_list;
mod keys;
mod marker;
mod markers;
mod membership;
pub mod mesh;
pub mod motion;
mod named;
pub mod node;
mod order;
mod part;
mod part_object;
pub mod pins;
mod rate;
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
mod values;
mod vertices;

pub use channel::Channel;
pub use interpolation::Interpolation;
pub use key_list::{KeyList, Manner};
pub use keys::Keys;
pub use marker::{Marker, Pin};
pub use membership::NodeId;
pub use mesh::{Geometry, Mesh, MeshSource, Object, Shape};
pub use motion::{FollowPath, Motion};
pub use node::{Camera, Kind, Light, Node};
pub use part::{Part, Rest};
pub use reparent::Keep;
pub use scene::Scene;
pub use state::{NodeState, Warnings};
pub use time::{Extrapolation, local_frame};
pub use track::Track;
pub use values::Values;
pub use vertices::Form;
