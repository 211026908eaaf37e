//! Nodes that come into a scene, with what leads to them.

use super::marker::Pin;
use super::node::Node;

/// Nodes that come into a scene. All numbers are those that nodes have when these are in it.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct NodeList {
    /// The numbers that they get, rising.
    pub(super) places: Vec<usize>,
    pub(super) nodes: Vec<Node>,
    /// Nodes that are there, and which of these they aim at then.
    pub(super) aims: Vec<(usize, usize)>,
    pub(super) pins: Vec<Pin>,
    /// Which of these is the camera that was chosen to be shown.
    pub(super) camera: Option<usize>,
}

impl NodeList {
    pub(super) fn heap_size(&self) -> usize {
        let nodes = self.nodes.iter().map(Node::heap_size).sum::<usize>();
        nodes + 8 * self.places.len() + 16 * self.aims.len() + 300 * self.pins.len()
    }

    /// The nodes.
    #[must_use]
    pub fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    /// The numbers that they get, rising.
    #[must_use]
    pub fn places(&self) -> &[usize] {
        &self.places
    }
}
