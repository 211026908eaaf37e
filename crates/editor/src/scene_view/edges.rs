//! What is drawn of the meshes of a scene, or of the path's own object.

use std::collections::HashMap;

use vides_document::{Object, coarse, features, sharp_lines};
use vides_engine::scene::Mesh;

/// Meshes of more triangles have a coarser copy that is drawn during motion.
const MANY: usize = 30_000;

/// Meshes of more triangles show by their faces alone what they are; lines on them would be noise.
const DENSE: usize = 20_000;

/// Made of a mesh when first asked for. Without memory nothing is drawn, which does no other harm.
#[derive(Debug, Default)]
pub(crate) struct Drawn {
    wires: Option<Vec<[u32; 2]>>,
    sharp: Option<Vec<[u32; 2]>>,
    coarse: Option<Vec<[u32; 3]>>,
}

impl Drawn {
    /// The lines that show it alone; points are lines without length.
    pub(crate) fn wires(&mut self, mesh: &Mesh) -> &[[u32; 2]] {
        self.wires
            .get_or_insert_with(|| features(mesh).unwrap_or_default())
    }

    /// The lines on its faces.
    pub(crate) fn sharp(&mut self, mesh: &Mesh) -> &[[u32; 2]] {
        let few = || mesh.triangles.len() <= DENSE;
        let lines = || few().then(|| sharp_lines(mesh).ok()).flatten();
        self.sharp
            .get_or_insert_with(|| lines().unwrap_or_default())
    }

    /// Its faces; while things move, of a large mesh fewer.
    pub(crate) fn faces<'a>(&'a mut self, mesh: &'a Mesh, moves: bool) -> &'a [[u32; 3]] {
        if !moves || mesh.triangles.len() <= MANY {
            return &mesh.triangles;
        }
        self.coarse
            .get_or_insert_with(|| coarse(mesh).unwrap_or_default())
    }
}

#[derive(Debug, Default)]
pub(crate) struct Edges {
    /// Their meshes: [`vides_document::EditedScene::meshes`].
    number: u64,
    of_nodes: HashMap<usize, Drawn>,
    /// Held so that no other object gets its address.
    object: Object,
    of_object: Drawn,
}

impl Edges {
    pub(super) fn of(&mut self, number: u64, node: usize) -> &mut Drawn {
        if self.number != number {
            self.number = number;
            self.of_nodes.clear();
        }
        self.of_nodes.entry(node).or_default()
    }

    /// That of the path's own object.
    pub(crate) fn of_object(&mut self, object: &Object) -> &mut Drawn {
        if !std::ptr::eq::<[_]>(&**object, &*self.object) {
            (self.object, self.of_object) = (object.clone(), Drawn::default());
        }
        &mut self.of_object
    }
}
