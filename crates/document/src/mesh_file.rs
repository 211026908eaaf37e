//! Meshes in separate files, of which a scene stores name, length and checksum.

use std::cell::Cell;
use std::collections::HashMap;
use std::path::{Path, PathBuf, absolute};

use vides_engine::scene::{Kind, Mesh, MeshSource, Scene};
use vides_mesh::{Format, Opened};

use super::fingerprint::Fingerprint;
use super::info::{Info, Object};
use super::references::inside;
use super::vid::bytes::read_bytes;
use crate::error::{Cause, EngineError, Error, Place, Result};
use vides_engine::limits::MAX_FILE_BYTES;
use vides_engine::path::Space;

/// Called while a mesh is read with the share done, at last 1; returning false stops the reading.
pub type Watcher = Box<dyn FnMut(f64) -> bool>;

thread_local! {
    static WATCHER: Cell<Option<Watcher>> = const { Cell::new(None) };
}

/// Sets or removes the watcher for mesh files read on this thread. A stopped mesh counts as broken.
pub fn watch_meshes(watcher: Option<Watcher>) {
    WATCHER.set(watcher);
}

/// The mesh in an OBJ, PLY, STL or glTF file, by the file's extension.
///
/// # Errors
/// [`Error::Io`], [`Error::FileTooLarge`], [`Error::Mesh`], each with the file.
pub fn load_mesh(file: &Path) -> Result<(MeshSource, Mesh)> {
    load_part(file, None)
}

/// The mesh that a scene notes as its file has it now, with the file as it is noted then.
///
/// # Errors
/// As [`load_mesh`].
pub fn reload_mesh(source: &MeshSource) -> Result<(MeshSource, Mesh)> {
    load_part(Path::new(&source.file), source.part)
}

/// As [`load_mesh`], or the mesh of a glTF file that has this number there.
fn load_part(file: &Path, part: Option<u32>) -> Result<(MeshSource, Mesh)> {
    let name = file.display().to_string();
    let read = || {
        let (mut opened, source) = open(file, &name)?;
        let mesh = mesh_of(&mut opened, part)?;
        Ok((MeshSource { part, ..source }, mesh))
    };
    read().map_err(|error: Error| error.at(&name))
}

/// A mesh file that is open, and its name, length and checksum.
fn open(file: &Path, name: &str) -> Result<(Opened, MeshSource)> {
    let format = Format::of(file).ok_or(vides_mesh::Error::UnknownFormat)?;
    let bytes = read_bytes(file, MAX_FILE_BYTES)?;
    let source = mesh_source(name, &bytes);
    let folder = file.parent().unwrap_or(Path::new(""));
    let mut beside = |name: &str| {
        inside(folder, name).ok()?;
        read_bytes(&folder.join(name), MAX_FILE_BYTES).ok()
    };
    let opened = Opened::new(format, bytes, &mut beside)?;
    Ok((opened, source))
}

/// How a scene notes a mesh file, all of it, of this name and content.
#[must_use]
pub fn mesh_source(name: &str, bytes: &[u8]) -> MeshSource {
    let now = Fingerprint::of(bytes);
    MeshSource {
        file: name.to_owned(),
        bytes: now.bytes,
        checksum: now.hash,
        part: None,
    }
}

/// The mesh of an open file, watched.
fn mesh_of(opened: &mut Opened, part: Option<u32>) -> Result<Mesh> {
    // Taken out meanwhile, so that it may itself read meshes or set a watcher.
    let mut watcher = WATCHER.take();
    let mut go_on = |share: f64| watcher.as_mut().is_none_or(|go_on| go_on(share));
    let mesh = match part {
        None => opened.whole(&mut go_on),
        Some(part) => opened.part(part as usize, &mut go_on).map(|(mesh, _)| mesh),
    };
    go_on(1.0);
    WATCHER.set(watcher);
    Ok(mesh?)
}

/// The object ([`Object::features_of`]) of a mesh file, whose name a document stores.
///
/// # Errors
/// As [`load_mesh`] and [`Object::features_of`].
pub fn load_object(file: &Path) -> Result<Object> {
    load_object_part(file, None)
}

fn load_object_part(file: &Path, part: Option<u32>) -> Result<Object> {
    let (source, mesh) = load_part(file, part)?;
    let wireframe = Object::features_of(mesh)?;
    let file = absolute(file).unwrap_or_else(|_| file.to_owned());
    Ok(wireframe.of_source(MeshSource {
        file: file.display().to_string(),
        ..source
    }))
}

/// Reads an object's mesh, named relative to `folder`; returns a warning. A missing or broken mesh
/// leaves it empty; a changed one is taken.
pub(super) fn read_object(info: &mut Info, space: Space, folder: &Path) -> Result<Option<Error>> {
    let Some(known) = info.object.source().cloned() else {
        return Ok(None);
    };
    let file = folder.join(&known.file);
    let named = inside(folder, &known.file);
    let read = named.and_then(|()| {
        let object = load_object_part(&file, known.part)?;
        let with = Info {
            object: object.clone(),
            ..Info::default()
        };
        with.check(space)?;
        Ok(object)
    });
    let trouble = match read {
        Ok(object) => {
            let now = object
                .source()
                .map(|source| (source.bytes, source.checksum));
            let changed = known.bytes > 0 && now != Some((known.bytes, known.checksum));
            info.object = object;
            changed.then(|| Error::from(vides_mesh::Error::Changed).at(file.display()))
        }
        Err(Error::Engine(EngineError::Memory)) => return Err(EngineError::Memory.into()),
        Err(error) => {
            // Keep where its mesh should be.
            info.object = Object::default().of_source(MeshSource {
                file: file.display().to_string(),
                ..known
            });
            Some(error)
        }
    };
    Ok(trouble)
}

/// As [`read_object`], for all objects of a scene. Objects of one file share its meshes.
pub(super) fn read_meshes(scene: &mut Scene, folder: &Path) -> Result<Vec<Error>> {
    let mut warnings = Vec::new();
    let mut files = Files::default();
    for at in 0..scene.nodes().len() {
        let node = &scene.nodes()[at];
        let Kind::Object(object) = &node.kind else {
            continue;
        };
        let Some(known) = object.source().cloned() else {
            continue;
        };
        let place = Place::Node((&node.name).into());
        let file = folder.join(&known.file);
        let named = inside(folder, &known.file);
        let read = named.and_then(|()| files.set_mesh(scene, at, &file, &known));
        let trouble = read.err();
        if let Some(error) = trouble {
            if matches!(error, Error::Engine(EngineError::Memory)) {
                return Err(error);
            }
            warnings.try_reserve(1)?;
            warnings.push(Error::At(place, Cause::new(error)?));
        }
        // An empty object, too, keeps where its mesh should be.
        scene.name_mesh(at, file.display().to_string())?;
    }
    Ok(warnings)
}

/// What has been read of the files of a scene's meshes.
#[derive(Default)]
struct Files {
    /// Nodes with the mesh of a file, or of its part.
    nodes: HashMap<(PathBuf, Option<u32>), usize>,
    /// Files of several meshes, open.
    open: HashMap<PathBuf, (Opened, MeshSource)>,
}

impl Files {
    /// Reads the mesh of a node, or takes it from a node with the same file; reports faults.
    fn set_mesh(
        &mut self,
        scene: &mut Scene,
        at: usize,
        file: &Path,
        known: &MeshSource,
    ) -> Result<()> {
        let named = |error: Error| error.at(file.display());
        let key = (file.to_owned(), known.part);
        let source = if let Some(&from) = self.nodes.get(&key) {
            let object = match &scene.nodes()[from].kind {
                Kind::Object(object) => object.source().cloned(),
                _ => None,
            };
            let source = object.unwrap_or_else(|| known.clone());
            let shared = scene.share_mesh(at, from, source.clone());
            shared.map_err(|error| named(error.into()))?;
            source
        } else {
            let (source, mesh) = self.read(file, known.part)?;
            let set = scene.set_mesh_of(at, source.clone(), mesh);
            set.map_err(|error| named(error.into()))?;
            self.nodes.try_reserve(1)?;
            self.nodes.insert(key, at);
            source
        };
        let same = (source.bytes, source.checksum) == (known.bytes, known.checksum);
        match known.bytes == 0 || same {
            true => Ok(()),
            false => Err(named(vides_mesh::Error::Changed.into())),
        }
    }

    fn read(&mut self, file: &Path, part: Option<u32>) -> Result<(MeshSource, Mesh)> {
        if part.is_none() {
            return load_mesh(file);
        }
        let name = file.display().to_string();
        if !self.open.contains_key(file) {
            let opened = open(file, &name).map_err(|error| error.at(&name))?;
            self.open.try_reserve(1)?;
            self.open.insert(file.to_owned(), opened);
        }
        let (opened, source) = self.open.get_mut(file).ok_or(EngineError::Memory)?;
        let mesh = mesh_of(opened, part).map_err(|error| error.at(&name))?;
        Ok((
            MeshSource {
                part,
                ..source.clone()
            },
            mesh,
        ))
    }
}

/// A mesh's name for a file in `folder`: relative if the mesh lies in or below it.
pub(super) fn name_from(folder: Option<&Path>, file: &str) -> String {
    let within = || -> Option<PathBuf> {
        let folder = absolute(folder?).ok()?;
        let file = absolute(file).ok()?;
        Some(
            file.strip_prefix(folder)
                .map_or(file.clone(), Path::to_owned),
        )
    };
    within().map_or_else(|| file.to_owned(), |path| path.display().to_string())
}

#[cfg(test)]
#[path = "mesh_file_tests.rs"]
mod tests;
