//! The path or scene being edited (thesis 7.3, A.4 to A.6) with undo; files of paths and poses.
//!
//! The window, the C interface and scripts all change a path through [`Edit`]. What a document holds
//! is a value that shares all it has with its copies: an edit makes another one of it, the history
//! is a list of them, and what has changed is where two of them share nothing. The crate knows
//! nothing of windows or of C.

#![forbid(unsafe_code)]
// Standard output is the host's.
#![cfg_attr(not(test), warn(clippy::print_stdout))]

mod apply;
mod cage;
mod check;
mod computed;
mod content;
mod copied;
mod copied_nodes;
mod draw;
mod edit;
mod edited_scene;
mod editing;
pub mod error;
mod fingerprint;
mod first;
mod held;
mod history;
mod in_scene;
mod info;
mod inputs;
mod keep_times;
mod key_times;
mod keys_to_path;
mod lapse;
mod loading;
mod mesh_file;
mod named;
mod normalise;
mod not_a_file;
mod notes;
mod path_to_keys;
mod picture;
mod place;
mod property;
mod property_access;
mod rate;
mod references;
mod remedy;
pub mod save;
mod scene;
mod scene_edit;
mod set;
mod shown;
mod space_table;
mod step_name;
mod target;
pub mod tool;
mod touched;
mod typed;
#[doc(hidden)]
pub mod vid;
mod wireframe;

pub use copied_nodes::CopiedNodes;
pub use edit::{At, Edit, Selection};
pub use edited_scene::EditedScene;
pub use editing::Document;
pub use error::{Error, Result};
pub use fingerprint::Fingerprint;
pub use info::{Info, Object, ObjectPoint};
#[doc(hidden)]
pub use inputs::{may_replace, note_input, protect_inputs};
pub use keys_to_path::{FittedKeys, KeysToPath, keys_to_path};
pub use mesh_file::{Watcher, load_mesh, load_object, mesh_source, reload_mesh, watch_meshes};
#[doc(hidden)]
pub use not_a_file::NotAFile;
pub use notes::Note;
pub use path_to_keys::PathToKeys;
pub use wireframe::{coarse, features, sharp_lines};

pub use apply::no_longer_ahead;
pub use property::{limit_scale, properties};
pub use references::{inside, trusting};
pub use remedy::planned::is_planned;
pub use scene::SceneDocument;
pub use shown::Poses;
pub use space_table::SpaceTable;
pub use step_name::StepName;
pub use touched::Touched;
pub use typed::{Form, Given};
#[doc(hidden)]
pub use vid::read_bytes;

pub use vides_mesh as mesh;
