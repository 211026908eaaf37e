//! Documents from files and texts, and back.

use std::io::Read;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::editing::Document;
use super::fingerprint::Fingerprint;
use super::scene::{SceneDocument, folder_of};
use super::vid::{self, Comments};
use super::{edited_scene, mesh_file};
use crate::error::{Error, Result};

impl Document {
    /// Loads a path or scene from a `.vid` file, with the warnings of [`SceneDocument::warnings`].
    /// Of a scene the shown camera's path is edited, if it has one; the rest is kept.
    ///
    /// # Errors
    /// As [`Document::load`].
    pub fn load_scene(file: &Path) -> Result<(Self, Vec<Error>)> {
        vid::load(file, |text| {
            Self::scene_from_toml(text, &absolute_folder_of(file))
        })
    }

    /// As [`Document::load_scene`], from `reader`, which messages call `name`. Mesh names are
    /// relative to the working directory.
    ///
    /// # Errors
    /// As [`Document::load`].
    pub fn load_scene_from(reader: &mut dyn Read, name: &str) -> Result<(Self, Vec<Error>)> {
        let folder = Path::new(".");
        vid::load_from(reader, name, |text| Self::scene_from_toml(text, folder))
    }

    /// As [`Document::load_scene`], from a text. Mesh names are relative to `folder`.
    ///
    /// # Errors
    /// `ErrorKind::Format` with line and reason.
    pub fn scene_from_toml(text: &str, folder: &Path) -> Result<(Self, Vec<Error>)> {
        let (scene, info) = vid::scene_from_toml(text)?;
        if vid::alone(&scene).is_some() {
            let mut document = Self::from_toml(text)?;
            let warnings = document.read_object(folder)?;
            return Ok((document, Vec::from_iter(warnings)));
        }
        let mut loaded = SceneDocument::of(scene, info);
        loaded.info.check(loaded.scene.space())?;
        loaded.info.normalise();
        let mut warnings = mesh_file::read_meshes(&mut loaded.scene, folder)?;
        let space = loaded.scene.space();
        warnings.extend(mesh_file::read_object(&mut loaded.info, space, folder)?);
        let (edited, path) = edited_scene::as_shown(loaded.scene)?;
        let mut document = Self::from_parts(path, loaded.info)?;
        document.content.comments = Arc::new(Comments::of_scene(text, edited.scene())?);
        document.content.scene = Some(Arc::new(edited));
        document.fingerprint = Some(Fingerprint::of(text.as_bytes()));
        Ok((document, warnings))
    }

    /// Loads the path in a `.vid` file.
    ///
    /// # Errors
    /// `ErrorKind::Io` if it cannot be read; `ErrorKind::Format` with file, line and reason.
    pub fn load(file: &Path) -> Result<Self> {
        vid::load(file, |text| Self::from_toml(text)?.with_object(file))
    }

    /// Reads the object's mesh file, if it has one; returns a warning.
    fn read_object(&mut self, folder: &Path) -> Result<Option<Error>> {
        let space = self.content.path.space;
        mesh_file::read_object(Arc::make_mut(&mut self.content.info), space, folder)
    }

    fn with_object(mut self, file: &Path) -> Result<Self> {
        // Warnings are reported by `load_scene` only.
        self.read_object(&absolute_folder_of(file))?;
        Ok(self)
    }

    /// As [`Document::load`], but of a scene it takes the shown camera's path and drops the rest.
    ///
    /// # Errors
    /// As [`Document::load`]; `ErrorKind::Argument` if the scene has no camera on a path.
    pub fn load_shown(file: &Path) -> Result<Self> {
        vid::load(file, |text| Self::shown(text)?.with_object(file))
    }

    /// As [`Document::load_shown`], from `reader`, which messages call `name`.
    ///
    /// # Errors
    /// As [`Document::load_shown`].
    pub fn load_shown_from(reader: &mut dyn Read, name: &str) -> Result<Self> {
        vid::load_from(reader, name, Self::shown)
    }

    fn shown(text: &str) -> Result<Self> {
        let (path, info, alone) = vid::shown_from_toml(text)?;
        let document = Self::from_parts(path, info)?;
        if alone {
            document.read_from(text)
        } else {
            Ok(document)
        }
    }

    /// With what else belongs to the text it was read from.
    fn read_from(mut self, text: &str) -> Result<Self> {
        self.fingerprint = Some(Fingerprint::of(text.as_bytes()));
        self.content.comments = Arc::new(Comments::of(text, &[])?);
        Ok(self)
    }

    /// As [`Document::load`], from `reader`, which messages call `name`.
    ///
    /// # Errors
    /// As [`Document::load`].
    pub fn load_from(reader: &mut dyn Read, name: &str) -> Result<Self> {
        vid::load_from(reader, name, Self::from_toml)
    }

    /// The document in the text of a `.vid` file.
    ///
    /// # Errors
    /// `ErrorKind::Format` with line and reason.
    pub fn from_toml(text: &str) -> Result<Self> {
        let (path, info) = vid::from_toml(text)?;
        Self::from_parts(path, info)?.read_from(text)
    }

    /// The text of a `.vid` file, with the comments of the text it was read from, except those of
    /// removed points. Loading it gives the same document, bit by bit.
    ///
    /// # Errors
    /// `ErrorKind::Memory`.
    pub fn to_toml(&self) -> Result<String> {
        self.text_in(None)
    }

    /// As [`Document::to_toml`], with meshes in or below the file's folder named relative to it.
    ///
    /// # Errors
    /// As [`Document::to_toml`]; `ErrorKind::Limit` if a scene is too long to be read again.
    pub fn to_toml_for(&self, file: &Path) -> Result<String> {
        self.text_in(Some(folder_of(file)))
    }

    fn text_in(&self, folder: Option<&Path>) -> Result<String> {
        let content = &self.content;
        let Some(edited) = &content.scene else {
            return vid::to_toml(&content.path, &content.info, &content.comments, folder);
        };
        let scene = edited.with(&content.path)?;
        vid::scene_to_toml(&scene, &content.info, &content.comments, folder)
    }

    /// Saves atomically and durably ([`super::save`]); see [`Document::mark_saved`].
    ///
    /// # Errors
    /// `ErrorKind::Io` with the file and the system's reason; the old file is whole then.
    pub fn save(&self, file: &Path) -> Result<()> {
        super::save::save(file, self.to_toml_for(file)?.as_bytes())
    }
}

/// Absolute, so that a change of the working directory does no harm.
fn absolute_folder_of(file: &Path) -> PathBuf {
    let folder = folder_of(file);
    std::path::absolute(folder).unwrap_or_else(|_| folder.to_owned())
}
