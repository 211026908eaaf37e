//! What is selected of a scene and remembered of its nodes, and what can be asked for of them.

use std::cell::RefCell;

use glam::DAffine3;
use vides_document::Edit;
use vides_document::error::Error;
use vides_engine::scene::{Channel, Keep, NodeId, NodeState, Scene};
use vides_engine::tools::fit::Tolerance;

use crate::entry::Entry;
use crate::scene_view::edges::Edges;
use crate::scene_view::rows::Rows;
use crate::state::files::{MeshFiles, Purpose};
use crate::state::points_list::NameField;

/// What is done to nodes.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum NodeCommand {
    /// Ask for a file of a mesh, to be added as an object.
    AddObject,
    Add(NewNode),
    /// Give a node another name.
    Rename(usize, String),
    /// Remove the selected ones with all that is in them.
    Remove,
    /// Copy the selected ones with all that is in them.
    Copy,
    /// Add those of a text.
    Paste(String),
    /// Put these into a node, or into the scene itself.
    PutInto(Vec<usize>, Option<usize>),
    /// The same, where those that move keep this.
    PutAs(Vec<usize>, Option<usize>, Keep),
}

/// A node that begins without a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum NewNode {
    /// High in the space, shining into all directions.
    Light,
    /// As the view that is shown now.
    Camera,
    /// At the origin.
    Group,
}

/// What is asked for in the panels of a node.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum NodeAction {
    /// An entry into what the node has.
    Enter(Box<Entry<Edit>>),
    /// An entry into a channel, see [`crate::Editor::set_channel`].
    Value(usize, Channel, Entry<Vec<f64>>),
    /// A click on a diamond.
    SwitchKey(usize, Channel),
    /// Keys for position, rotation and scale of the selected nodes.
    SetKeys,
    Motion(usize, Moves),
    /// Few keys in place of its path.
    FewKeys(usize),
    /// How near: position, and degrees.
    Near(f64, f64),
    /// Read its mesh again.
    Reload(usize),
    /// Ask for a file.
    AskFile(Purpose),
    /// Show what the node has besides its path.
    ShowNode(bool),
    /// Show the box of a deformation of a node, or no longer.
    ShowBox(Option<(usize, usize)>),
}

/// What moves a node.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Moves {
    Nothing,
    Keys,
    Path,
}

/// A key of a track, from 0.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct KeyAt {
    pub(crate) node: usize,
    pub(crate) channel: Channel,
    pub(crate) key: usize,
}

/// A node, whatever number it has.
#[derive(Debug)]
pub(crate) struct KnownNode {
    pub(crate) id: Option<NodeId>,
    pub(crate) name: String,
}

/// What is selected of a scene. It follows numbers that change: those of keys by their frames.
#[derive(Debug, Default)]
pub(crate) struct SceneSelection {
    /// The current one first.
    pub(crate) nodes: Vec<usize>,
    /// Which nodes these are.
    pub(crate) known: Vec<KnownNode>,
    pub(crate) keys: Vec<KeyAt>,
    /// Their frames, and their nodes.
    pub(crate) frames: Vec<(f64, KnownNode)>,
    /// [`vides_document::EditedScene::number`] of the scene that it belongs to.
    pub(crate) made_of: u64,
}

#[derive(Debug, Default)]
pub(crate) struct SceneList {
    pub(crate) rows: Rows,
    pub(crate) filter: String,
    /// The node whose name is being typed.
    pub(crate) renaming: Option<(usize, NameField)>,
    /// The node whose row is being dragged.
    pub(crate) dragged: Option<usize>,
    /// The current node when it was last shown.
    pub(crate) shown: Option<usize>,
    /// Where to scroll while something is dragged.
    pub(crate) wanted: Option<f32>,
    /// Top and bottom of what the scroll area has shown.
    pub(crate) seen: (f32, f32),
    /// The pass in which it was last shown.
    pub(crate) pass: u64,
}

#[derive(Debug, Default)]
pub(crate) struct SceneView {
    pub(crate) selection: SceneSelection,
    /// The deformation whose box is shown: its node and its number there.
    pub(crate) deformation: Option<(usize, usize)>,
    /// What a node has besides its path is at the right, not the path's points.
    pub(crate) shows_node: bool,
    pub(crate) mesh_files: MeshFiles,
    /// How near a path comes to keys and keys to a path; none: as usual.
    pub(crate) tolerance: Option<Tolerance>,
    pub(crate) list: RefCell<SceneList>,
    pub(crate) now: RefCell<Option<Now>>,
    pub(crate) edges: RefCell<Edges>,
}

/// The scene at the playhead.
#[derive(Debug)]
pub(crate) struct Now {
    pub(crate) scene: Scene,
    /// By node number.
    pub(crate) states: Vec<NodeState>,
    /// Of the scene, not of the path.
    pub(crate) frame: f64,
    /// The node whose path is edited.
    pub(crate) edited: Option<usize>,
    /// From the world into the coordinates of the edited path.
    pub(crate) into_path: DAffine3,
    /// A node that cannot move as it should, and why.
    pub(crate) trouble: Option<(usize, Error)>,
    /// [`vides_document::EditedScene::meshes`].
    pub(crate) meshes: u64,
    /// [`vides_document::EditedScene::number`] and [`vides_document::Document::revision`].
    pub(crate) made_of: (u64, u64),
}
