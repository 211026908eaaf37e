//! What is drawn of the meshes of a scene.

use std::collections::HashMap;

use vides_engine::scene::Mesh;

use crate::document::features;

#[derive(Debug, Default)]
pub(super) struct Edges {
    /// Their scene: [`crate::document::EditedScene::number`].
    number: u64,
    of_nodes: HashMap<usize, Vec<[u32; 2]>>,
}

impl Edges {
    /// The lines of a node's mesh; points are lines without length.
    pub(super) fn of(&mut self, number: u64, node: usize, mesh: &Mesh) -> &[[u32; 2]] {
        if self.number != number {
            *self = Self {
                number,
                ..Self::default()
            };
        }
        self.of_nodes.entry(node).or_insert_with(|| {
            // Without memory nothing is drawn, which does no other harm.
            features(mesh).unwrap_or_default()
        })
    }
}
