//! Meshes and shapes that an object of a scene takes from files.

use std::collections::HashMap;
use std::path::{Component, Path, PathBuf, absolute};

use vides_document::error::Result;
use vides_document::{Edit, inside, load_mesh, reload_mesh};
use vides_engine::scene::{Geometry, Kind, Mesh, MeshSource, Part, Shape};

use super::short;
use crate::state::Editor;
use crate::state::files::{MeshFiles, Purpose};
use crate::texts::fill;

impl Editor {
    /// Reads meshes of the scene again whose files another program has written since they were last
    /// looked at; called when the window gets the keyboard. Of a file that is gone the
    /// last mesh stays, as it does if the new one is not usable; a message reports both.
    pub(crate) fn look_after_meshes(&mut self) {
        let known = std::mem::take(&mut self.scene_view.mesh_files.0);
        let mut looked = HashMap::new();
        for (node, source) in self.mesh_sources() {
            if !self.may_read(node, &source) {
                continue;
            }
            let now = *looked.entry(source.file.clone()).or_insert_with(|| {
                let state = std::fs::metadata(&source.file).ok()?;
                Some((state.modified().ok()?, state.len()))
            });
            // Of one that was not looked at yet the length is known.
            let other = now.is_some_and(|(_, len)| source.bytes > 0 && len != source.bytes);
            let before = known.get(&source.file).copied();
            let before = before.or(other.then_some(None));
            let Some(before) = before.filter(|before| *before != now) else {
                continue;
            };
            let file = Path::new(&source.file);
            let done = match (before, now) {
                (_, Some(_)) => {
                    let read = reload_mesh(&source);
                    if let Ok((read, _)) = &read
                        && (read.bytes, read.checksum) == (source.bytes, source.checksum)
                    {
                        continue;
                    }
                    self.take_mesh(node, file, read)
                }
                (Some(_), None) => Err(fill(self.texts().node.mesh_gone, &[&short(file)])),
                (None, None) => continue,
            };
            if let Err(text) = done {
                self.complain(text);
            }
        }
        self.scene_view.mesh_files = MeshFiles(looked);
    }

    /// Whether a mesh that was read before is read again unasked, or one in the document's folder.
    fn may_read(&self, node: usize, source: &MeshSource) -> bool {
        let folder = self.file.as_deref().and_then(Path::parent);
        let beside = || inside(folder.unwrap_or(Path::new("")), &source.file).is_ok();
        self.missing_mesh(Some(node)).is_none() || beside()
    }

    /// The objects whose meshes come from files.
    fn mesh_sources(&self) -> Vec<(usize, MeshSource)> {
        let edited = self.document.edited_scene();
        let nodes = edited.into_iter().flat_map(|edited| edited.scene().nodes());
        let sources = nodes.enumerate().filter_map(|(at, node)| {
            let Kind::Object(object) = &node.kind else {
                return None;
            };
            Some((at, object.source()?.clone()))
        });
        sources.collect()
    }

    /// Where the mesh of an object comes from.
    fn mesh_source(&self, node: usize) -> Option<MeshSource> {
        let edited = self.document.edited_scene()?;
        let Kind::Object(object) = &edited.scene().nodes().get(node)?.kind else {
            return None;
        };
        object.source().cloned()
    }

    /// Gives an object the mesh of a file; the same part of it as before, where that was not found.
    pub(super) fn load_mesh_of(&mut self, node: usize, file: &Path) -> Result<(), String> {
        let before = self.mesh_source(node);
        let file = &self.beside_document(file, before.as_ref());
        let missing = self.missing_mesh(Some(node)).is_some();
        let read = match before.filter(|_| missing) {
            Some(before) => reload_mesh(&MeshSource {
                file: file.display().to_string(),
                ..before
            }),
            None => load_mesh(file),
        };
        self.take_mesh(node, file, read)
    }

    /// The file of a node's mesh, or of the path's own object, which was not found or could not be
    /// read.
    pub(crate) fn missing_mesh(&self, node: Option<usize>) -> Option<&str> {
        let Some(node) = node else {
            let object = &self.document.info().object;
            let source = object.source().filter(|_| object.is_empty())?;
            return Some(&source.file);
        };
        let edited = self.document.edited_scene()?;
        let Kind::Object(object) = &edited.scene().nodes().get(node)?.kind else {
            return None;
        };
        let empty = object.mesh().points.is_empty();
        Some(&object.source().filter(|_| empty)?.file)
    }

    /// The first object without a mesh, and its file.
    pub(crate) fn first_missing_mesh(&self) -> Option<(Purpose, &str)> {
        let own = self.missing_mesh(None);
        let own = own.map(|file| (Purpose::LoadObject(None), file));
        let edited = self.document.edited_scene();
        let count = edited.map_or(0, |edited| edited.scene().nodes().len());
        let of = |node| Some((Purpose::LoadMesh(node), self.missing_mesh(Some(node))?));
        own.or_else(|| (0..count).find_map(of))
    }

    /// A mesh file as it is named from the document's folder, with `..` where it lies elsewhere, if
    /// the one `before` was named from there; so document and meshes can be moved together.
    pub(super) fn beside_document(&self, file: &Path, before: Option<&MeshSource>) -> PathBuf {
        let named = || {
            let folder = absolute(self.file.as_deref()?.parent()?).ok()?;
            let before = absolute(&before?.file).ok()?;
            let [from, to] = [folder.canonicalize().ok()?, file.canonicalize().ok()?];
            let shared = from.components().zip(to.components());
            let shared = shared.take_while(|(a, b)| a == b).count();
            let up = from.components().skip(shared).map(|_| Component::ParentDir);
            let whole: PathBuf = up.chain(to.components().skip(shared)).collect();
            before.starts_with(&folder).then(|| folder.join(whole))
        };
        named().unwrap_or_else(|| file.to_owned())
    }

    /// Reads the file of an object's mesh again.
    pub(crate) fn reload_mesh(&mut self, node: usize) {
        let done = match self.mesh_source(node) {
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
            let edited = edited.ok_or(vides_document::error::Refused::NoScene)?;
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
