//! A scene with its info: made, loaded, saved.

use std::io::Read;
use std::path::Path;

use super::info::Info;
use super::mesh_file;
use super::vid::{self, Comments};
use crate::error::{Error, Result};
use vides_engine::path::CameraPath;
use vides_engine::scene::{FollowPath, Scene};

/// A scene and its info. A file with just a path is a scene of one camera on it.
#[derive(Debug)]
pub struct SceneDocument {
    /// Everything that moves.
    pub scene: Scene,
    /// What the file holds besides the scene.
    pub info: Info,
    /// Comments of the file it was read from.
    comments: Comments,
    warnings: Vec<Error>,
}

/// The folder that mesh names in `file` are relative to.
pub(super) fn folder_of(file: &Path) -> &Path {
    file.parent().unwrap_or(Path::new(""))
}

/// Ignores comments and warnings.
impl PartialEq for SceneDocument {
    fn eq(&self, other: &Self) -> bool {
        self.scene == other.scene && self.info == other.info
    }
}

impl SceneDocument {
    /// One camera on the path a new window begins with.
    ///
    /// # Errors
    /// `ErrorKind::Memory`.
    pub fn try_new() -> Result<Self> {
        let scene = Scene::of_path(CameraPath::try_new()?)?;
        Ok(Self::of(scene, Info::default()))
    }

    /// A scene with an info that fits it.
    ///
    /// # Errors
    /// What is wrong with the info: `ErrorKind::Argument`, `Range` or `Limit`.
    pub fn new(scene: Scene, mut info: Info) -> Result<Self> {
        info.check(scene.space())?;
        info.normalise();
        Ok(Self::of(scene, info))
    }

    pub(crate) fn of(scene: Scene, info: Info) -> Self {
        Self {
            scene,
            info,
            comments: Comments::default(),
            warnings: Vec::new(),
        }
    }

    /// Loads the scene in a `.vid` file.
    ///
    /// # Errors
    /// `ErrorKind::Io` if it cannot be read; `ErrorKind::Format` with file, line and reason.
    pub fn load(file: &Path) -> Result<Self> {
        vid::load(file, |text| {
            Self::from_toml(text)?.with_meshes(folder_of(file))
        })
    }

    /// As [`SceneDocument::load`], from `reader`, which messages call `name`.
    ///
    /// # Errors
    /// As [`SceneDocument::load`].
    pub fn load_from(reader: &mut dyn Read, name: &str) -> Result<Self> {
        vid::load_from(reader, name, |text| {
            Self::from_toml(text)?.with_meshes(Path::new(""))
        })
    }

    fn with_meshes(mut self, folder: &Path) -> Result<Self> {
        self.warnings = mesh_file::read_meshes(&mut self.scene, folder)?;
        let space = self.scene.space();
        let of_path = mesh_file::read_object(&mut self.info, space, folder)?;
        self.warnings.extend(of_path);
        Ok(self)
    }

    /// What was wrong with mesh files: their objects are empty, or the mesh has changed since
    /// saving.
    #[must_use]
    pub fn warnings(&self) -> &[Error] {
        &self.warnings
    }

    /// The scene in the text of a `.vid` file; mesh files are not read.
    ///
    /// # Errors
    /// `ErrorKind::Format` with line and reason.
    pub fn from_toml(text: &str) -> Result<Self> {
        let (scene, mut info) = vid::scene_from_toml(text)?;
        info.check(scene.space())?;
        info.normalise();
        let comments = Comments::of_scene(text, &scene)?;
        Ok(Self {
            comments,
            ..Self::of(scene, info)
        })
    }

    /// As [`SceneDocument::from_toml`]; mesh files named in it are read, relative to `folder`.
    ///
    /// # Errors
    /// As [`SceneDocument::load`], without the file's name.
    pub fn from_toml_in(text: &str, folder: &Path) -> Result<Self> {
        Self::from_toml(text)?.with_meshes(folder)
    }

    /// The text of a `.vid` file. Loading it gives the same scene, bit by bit.
    ///
    /// # Errors
    /// `ErrorKind::Memory`; `ErrorKind::Limit` if it is too long to be read again.
    pub fn to_toml(&self) -> Result<String> {
        self.text(None)
    }

    fn text(&self, folder: Option<&Path>) -> Result<String> {
        vid::scene_to_toml(&self.scene, &self.info, &self.comments, folder)
    }

    /// Saves as a `.vid` file, atomically and durably ([`super::save`]).
    ///
    /// # Errors
    /// `ErrorKind::Io`, the old file being whole; as [`SceneDocument::to_toml`].
    pub fn save(&self, file: &Path) -> Result<()> {
        super::save::save(file, self.text(Some(folder_of(file)))?.as_bytes())
    }

    /// The path, if the scene is nothing but one camera on it.
    #[must_use]
    pub fn path_alone(&self) -> Option<&CameraPath> {
        vid::alone(&self.scene).map(FollowPath::path)
    }

    /// A copy without warnings.
    ///
    /// # Errors
    /// `ErrorKind::Memory`.
    pub fn try_clone(&self) -> Result<Self> {
        let info = self.info.try_clone()?;
        Ok(Self {
            comments: self.comments.clone(),
            ..Self::of(self.scene.clone(), info)
        })
    }
}
