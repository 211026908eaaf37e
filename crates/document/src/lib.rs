//! The path or scene being edited (thesis 7.3, A.4 to A.6) with undo; files of paths and poses.
//!
//! The window, the C interface and scripts all change a path through [`Edit`]. An edit is checked
//! as a whole and turned into a record of the values it exchanges; applying a record returns the
//! one that undoes it, bit by bit. The crate knows nothing of windows or of C.

#![forbid(unsafe_code)]

mod cage;
mod change;
mod check;
mod computed;
mod copied;
mod copied_nodes;
mod draw;
mod edit;
mod edited_scene;
mod editing;
pub mod error;
mod fingerprint;
mod held;
mod history;
mod in_scene;
mod info;
mod keys_to_path;
mod loading;
mod mesh_file;
mod named;
mod normalise;
mod not_a_file;
mod notes;
mod path_to_keys;
mod picture;
mod place;
mod prepare;
mod property;
mod remedy;
pub mod save;
mod scene;
mod scene_edit;
mod set;
mod shown;
mod step_name;
mod target;
pub mod tool;
mod touched;
#[doc(hidden)]
pub mod vid;
mod whole;
mod wireframe;

pub use copied_nodes::CopiedNodes;
pub use edit::{At, Edit, Selection};
pub use edited_scene::EditedScene;
pub use editing::Document;
pub use error::{Error, Result};
pub use fingerprint::Fingerprint;
pub use info::{Info, Object, ObjectPoint};
pub use keys_to_path::{FittedKeys, KeysToPath, keys_to_path};
pub use mesh_file::{Watcher, load_mesh, load_object, mesh_source, reload_mesh, watch_meshes};
#[doc(hidden)]
pub use not_a_file::NotAFile;
pub use notes::Note;
pub use path_to_keys::PathToKeys;
pub use wireframe::{coarse, features, sharp_lines};

pub use prepare::no_longer_ahead;
pub use property::properties;
pub use remedy::planned::is_planned;
pub use scene::SceneDocument;
pub use shown::Poses;
pub use step_name::StepName;
pub use touched::Touched;
#[doc(hidden)]
pub use vid::read_bytes;

pub use vides_mesh as mesh;
