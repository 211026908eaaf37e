//! Which nodes and keys of a scene are selected. Selecting is no step, and stands in no file.

use vides_engine::scene::Channel;

use crate::action::Action;
use crate::state::Editor;

/// A key of a track, from 0.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct KeyAt {
    pub(crate) node: usize,
    pub(crate) channel: Channel,
    pub(crate) key: usize,
}

/// What is selected of a scene.
#[derive(Debug, Default)]
pub(crate) struct SceneSelection {
    /// The current one first.
    nodes: Vec<usize>,
    keys: Vec<KeyAt>,
}

impl Editor {
    /// The selected nodes, the current one first; without a choice that whose path is edited.
    pub(crate) fn selected_nodes(&self) -> Vec<usize> {
        let Some(edited) = self.document.edited_scene() else {
            return Vec::new();
        };
        let count = edited.scene().nodes().len();
        let known = self.scene_view.selection.nodes.iter().copied();
        let known: Vec<usize> = known.filter(|&node| node < count).collect();
        match known.is_empty() {
            true => edited.node().into_iter().collect(),
            false => known,
        }
    }

    /// Whether what is done in the space is meant for the selected nodes: no path is edited, the
    /// node is shown in place of its path, or there are several.
    pub(crate) fn means_nodes(&self) -> bool {
        if self.document.edited_scene().is_none() {
            return false;
        }
        let (path, nodes) = (self.document.edits_path(), self.selected_nodes());
        !nodes.is_empty() && (!path || self.scene_view.shows_node || nodes.len() > 1)
    }

    /// The node whose numbers stand at the right.
    pub(crate) fn current_node(&self) -> Option<usize> {
        self.selected_nodes().first().copied()
    }

    /// The selected keys that there are.
    pub(crate) fn selected_keys(&self) -> Vec<KeyAt> {
        let Some(edited) = self.document.edited_scene() else {
            return Vec::new();
        };
        let nodes = edited.scene().nodes();
        let is_there = |at: &&KeyAt| {
            let track = nodes
                .get(at.node)
                .and_then(|node| node.keys().track(&at.channel));
            track.is_some_and(|track| at.key < track.frames().len())
        };
        let keys = self.scene_view.selection.keys.iter();
        keys.filter(is_there).cloned().collect()
    }

    /// Selects nodes, the current one first; the path of the current one is edited, if it has one.
    pub(crate) fn select_nodes(&mut self, nodes: Vec<usize>) {
        let edited = self.document.edited_scene();
        let path = |node: &usize| {
            let nodes = edited?.scene().nodes();
            let own = edited?.node() == Some(*node);
            (own || nodes.get(*node)?.path().is_some()).then_some(*node)
        };
        let of_path = nodes.first().and_then(path);
        let other = edited.is_some_and(|edited| edited.node() != of_path);
        self.scene_view.selection.nodes = nodes;
        if other {
            self.edit_node(of_path);
        }
    }

    pub(crate) fn select_keys(&mut self, keys: Vec<KeyAt>) {
        self.scene_view.selection.keys = keys;
    }
}

/// Selects one node.
pub(crate) fn select(node: usize) -> Action {
    Action::SelectNodes(vec![node])
}
