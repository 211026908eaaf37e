//! `.vid` files: a whole document as TOML, to be read and written by people too.
//!
//! The parsed tree is read by hand, so that every error names its line and speaks of cameras.
//! Unknown keys are refused, since a typo must not vanish. Missing values have the defaults of a
//! new path. Numbers are written with as few digits as give the same bits back.
//!
//! ```toml
//! version = 1
//! title = "Two looks"
//!
//! [[point]]
//! name = "start"
//! position = [-0.6, 0.2, 0.8]
//! preset = 5
//!
//! [[point.orientation]]
//! target = [0.0, 0.0, 0.0]        # looks at this place, wherever the point is
//! roll_degrees = 15.0
//!
//! [[point]]
//! position = [0.6, 0.2, 0.8]
//! own = { tension = 0.2, continuity = 0.0, bias = 0.5 }
//!
//! [[point.orientation]]
//! offset = [0.0, 0.0, -0.4]       # looks in this direction
//! zoom_mm = 50.0
//! hold_frames = 12
//! speed_curve = [1.0, 20.0, 50.0, 50.0, 50.0, 50.0, 50.0, 50.0, 50.0, 50.0]
//! ```

pub(crate) mod alone;
pub mod bytes;
pub(crate) mod comments;
pub mod field;
mod keys_text;
mod mesh;
mod mesh_source;
mod own;
mod path_read;
mod pieces;
mod read;
mod scene_read;
mod scene_write;
mod shown;
mod statements;
mod text;
pub mod tree;
mod weight;
mod write;

pub(super) use alone::alone;
pub(super) use bytes::{load, load_from};
pub use bytes::{read_bytes, read_text};
pub(super) use comments::Comments;
pub(super) use keys_text::{keys_from_toml, keys_to_toml};
pub(super) use path_read::{point_keys, view_keys};
pub(super) use read::{
    PATH_KEYS, from_toml, nodes_from_toml, scene_from_toml, shown_from_toml, value_of,
};
pub(super) use scene_write::{nodes_to_toml, scene_to_toml};
pub(super) use text::quoted;
pub(super) use write::{to_toml, view_to_toml};
