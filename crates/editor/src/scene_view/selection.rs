//! Which nodes and keys of a scene are selected. Selecting is no step, and stands in no file.

use vides_document::{Document, EditedScene};

use crate::action::Action;
use crate::state::Editor;
use crate::state::scene_view::{KeyAt, KnownNode, SceneSelection};

impl SceneSelection {
    #[cfg(test)]
    pub(super) fn numbers(&self) -> &[usize] {
        &self.nodes
    }

    #[cfg(test)]
    pub(super) fn names(&self) -> Vec<String> {
        let names = self.known.iter().map(|known| known.name.clone());
        names.collect()
    }

    /// Brings it up to date with the document.
    pub(crate) fn follow(&mut self, document: &Document) {
        let Some(edited) = document.edited_scene() else {
            *self = Self::default();
            return;
        };
        if self.made_of == edited.number() {
            return;
        }
        let scene = edited.scene();
        // In another scene nodes are found by their names.
        let number = |known: &KnownNode| {
            let here = known.id.and_then(|id| scene.number_of(id));
            here.or_else(|| scene.find(&known.name))
        };
        self.nodes = self.known.iter().filter_map(number).collect();
        let keys = self.keys.drain(..).zip(&self.frames);
        let keys = keys.filter_map(|(at, (frame, known))| {
            let (frame, node) = (*frame, number(known)?);
            let track = scene.nodes()[node].keys().track(&at.channel)?;
            let there = |key: &usize| track.frames().get(*key) == Some(&frame);
            let key = Some(at.key).filter(there).or_else(|| {
                let key = track.frames().partition_point(|key| *key < frame);
                Some(key).filter(there)
            })?;
            Some(KeyAt { node, key, ..at })
        });
        self.keys = keys.collect();
        self.take_down(edited);
    }

    /// Takes down what tells nodes and keys apart when numbers change.
    fn take_down(&mut self, edited: &EditedScene) {
        self.made_of = edited.number();
        let scene = edited.scene();
        let nodes = scene.nodes();
        let known = |node: usize| KnownNode {
            id: scene.ids().get(node).copied(),
            name: nodes
                .get(node)
                .map_or_else(String::new, |of| of.name.clone()),
        };
        self.known = self.nodes.iter().map(|&node| known(node)).collect();
        let frame = |at: &KeyAt| {
            let track = nodes.get(at.node)?.keys().track(&at.channel)?;
            track.frames().get(at.key).copied()
        };
        let keys = self.keys.iter();
        let frames = keys.map(|at| (frame(at).unwrap_or(f64::NAN), known(at.node)));
        self.frames = frames.collect();
    }
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

    /// Selects every node; the current one stays that.
    pub(crate) fn select_all_nodes(&mut self) {
        let Some(edited) = self.document.edited_scene() else {
            return;
        };
        let current = self.current_node();
        let others = (0..edited.scene().nodes().len()).filter(|&node| Some(node) != current);
        self.select_nodes(current.into_iter().chain(others).collect());
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

    /// The selected keys that exist.
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
        // Keys are where they were before nodes get other numbers.
        self.scene_view.selection.follow(&self.document);
        self.scene_view.selection.nodes = nodes;
        if let Some(edited) = self.document.edited_scene() {
            self.scene_view.selection.take_down(edited);
        }
        if other {
            self.edit_node(of_path);
        }
    }

    pub(crate) fn select_keys(&mut self, keys: Vec<KeyAt>) {
        let selection = &mut self.scene_view.selection;
        selection.follow(&self.document);
        selection.keys = keys;
        if let Some(edited) = self.document.edited_scene() {
            selection.take_down(edited);
        }
    }

    /// Selects the nodes and keys that undo or redo has changed; those that are selected stay so
    /// where all of these are among them.
    pub(crate) fn select_touched(&mut self) {
        self.scene_view.selection.follow(&self.document);
        let touched = self.document.touched();
        let mut nodes = touched.nodes().to_vec();
        if nodes.is_empty() {
            return;
        }
        let keys = touched.keys().flat_map(|(node, channel, keys)| {
            keys.iter().map(move |&key| KeyAt {
                node,
                channel: channel.clone(),
                key,
            })
        });
        let keys: Vec<KeyAt> = keys.collect();
        let selected = self.selected_nodes();
        if nodes.iter().all(|node| selected.contains(node)) {
            nodes = selected;
        } else if let Some(current) = selected.first()
            && let Ok(at) = nodes.binary_search(current)
        {
            nodes[..=at].rotate_right(1);
        }
        self.select_nodes(nodes);
        if !keys.is_empty() {
            self.select_keys(keys);
        }
    }
}

/// Selects one node.
pub(crate) fn select(node: usize) -> Action {
    Action::SelectNodes(vec![node])
}
