//! Meshes and shapes that an object of a scene takes from files.

use std::path::{Path, absolute};

use vides_engine::scene::{Geometry, Kind, Mesh, MeshSource, Part, Shape};

use super::short;
use crate::document::{Edit, load_mesh, reload_mesh};
use crate::error::Result;
use crate::state::Editor;
use crate::texts::fill;

impl Editor {
    /// Gives an object the mesh of a file.
    pub(super) fn load_mesh_of(&mut self, node: usize, file: &Path) -> Result<(), String> {
        self.take_mesh(node, file, load_mesh(file))
    }

    /// Reads the file of an object's mesh again.
    pub(crate) fn reload_mesh(&mut self, node: usize) {
        let source = self.document.edited_scene().and_then(|edited| {
            let of = edited.scene().nodes().get(node)?;
            let Kind::Object(object) = &of.kind else {
                return None;
            };
            object.source().cloned()
        });
        let done = match source {
            None => Err(self.texts().node.no_mesh_file.to_owned()),
            Some(source) => {
                let read = reload_mesh(&source);
                self.take_mesh(node, Path::new(&source.file), read)
            }
        };
        if let Err(text) = done {
            self.complain(text);
        }
    }

    fn take_mesh(
        &mut self,
        node: usize,
        file: &Path,
        read: Result<(MeshSource, Mesh)>,
    ) -> Result<(), String> {
        let done = read.and_then(|(source, mesh)| {
            let file = absolute(file).unwrap_or_else(|_| file.to_owned());
            let source = MeshSource {
                file: file.display().to_string(),
                ..source
            };
            let mesh = Geometry::new(mesh, Some(source))?;
            self.exchange(Part::Mesh { node, mesh })
        });
        self.loaded_of(file, done)
    }

    /// Gives an object another shape of its points, those of a file's mesh.
    pub(super) fn load_shape(&mut self, node: usize, file: &Path) -> Result<(), String> {
        let done = load_mesh(file).and_then(|(_, mesh)| {
            let edited = self.document.edited_scene();
            let edited = edited.ok_or(crate::error::Refused::NoScene)?;
            let at = edited.scene().object(node)?.shapes().len();
            let shape = Shape {
                name: short(Path::new(file.file_stem().unwrap_or_default())),
                points: mesh.points,
                colours: mesh.colours,
            };
            self.exchange(Part::insert_shape(node, at, shape)?)
        });
        self.loaded_of(file, done)
    }

    fn exchange(&mut self, part: Part) -> Result<()> {
        self.document.end_step();
        self.document.apply(Edit::Part(Box::new(part)))
    }

    fn loaded_of(&mut self, file: &Path, done: Result<()>) -> Result<(), String> {
        let texts = self.texts();
        done.map_err(|error| self.refusal(texts.errors.cannot_load, file, &error))?;
        self.say(fill(texts.output.loaded, &[&short(file)]));
        Ok(())
    }
}
