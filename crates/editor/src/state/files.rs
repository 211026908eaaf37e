//! What the windows that ask for files, and about them, remember.

use std::cell::RefCell;
use std::collections::HashMap;
use std::ffi::OsString;
use std::fs::ReadDir;
use std::path::PathBuf;
use std::time::SystemTime;

use egui::{Pos2, Vec2};
use vides_document::tool::Tool;

use crate::background::Background;
use crate::files::recovery::Found;

/// What a file is chosen for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Purpose {
    LoadPath,
    /// And what is to be done after that.
    SavePath(Option<AfterSave>),
    /// A mesh or a point cloud to be shown, and the tool that waits for it.
    LoadObject(Option<Tool>),
    /// A mesh or a point cloud to be a node of the scene.
    AddObject,
    Export,
    LoadSetup,
    SaveSetup,
    /// A path to be put into this one.
    LoadBlock,
    /// Points to be saved as a separate path.
    SaveBlock,
    /// Another program's file: a scene, or poses to make a path of.
    Import,
    /// The mesh of an object of the scene.
    LoadMesh(usize),
    /// Another shape for an object of the scene.
    LoadShape(usize),
}

/// What waits until unsaved work is saved or given up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum AfterSave {
    Close,
    /// An empty path takes its place.
    New,
    Load,
    /// The example takes its place.
    Example,
    /// A recent file is loaded, by its number.
    Recent(usize),
    /// The path that was dropped on the window is loaded.
    Dropped,
    /// Unsaved work that was found takes its place, by its number.
    Restore(usize),
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Item {
    /// Its name, of any bytes.
    pub(crate) name: OsString,
    pub(crate) shown: String,
    pub(crate) is_folder: bool,
    pub(crate) written: Option<SystemTime>,
    /// In bytes.
    pub(crate) size: u64,
}

/// In which order the files of a directory are listed: by name, the newest or the largest first.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Order {
    #[default]
    Name,
    Date,
    Size,
}

/// A directory that is being or has been read.
#[derive(Debug)]
pub(crate) struct Folder {
    pub(crate) path: PathBuf,
    /// What was found so far, directories first, then by name.
    pub(crate) items: Vec<Item>,
    pub(crate) reading: Option<ReadDir>,
    /// There are more than are kept.
    pub(crate) more: bool,
}

/// When a file was written, and how long it is; none: it is gone.
pub(crate) type Written = Option<(SystemTime, u64)>;

/// The files of meshes, as they were when they were last looked at.
#[derive(Debug, Default)]
pub(crate) struct MeshFiles(pub(crate) HashMap<String, Written>);

/// The edges of the movement space, the curve, and what is to be seen there.
#[derive(Debug)]
pub(crate) struct Picture {
    pub(crate) size: Vec2,
    pub(crate) edges: Vec<[Pos2; 2]>,
    pub(crate) curve: Vec<Pos2>,
    pub(crate) things: Vec<[Pos2; 2]>,
    /// A scene without an edited path.
    pub(crate) of_scene: bool,
}

/// Pictures that are made beside the window when they are first shown, and what they are of.
#[derive(Debug)]
pub(crate) struct Pictures<K>(pub(crate) RefCell<Option<Made<K>>>);

#[derive(Debug)]
pub(crate) struct Made<K> {
    pub(crate) of: K,
    pub(crate) work: Background<Vec<Option<Picture>>>,
    pub(crate) pictures: Vec<Option<Picture>>,
}

#[derive(Clone, Debug)]
pub(crate) enum About {
    Unsaved(AfterSave),
    Changed(Option<AfterSave>),
    /// Another program has written the file.
    Newer,
    /// Which axis is up in this file of poses.
    Upright(PathBuf),
    /// The open file names these outside its folder.
    Outside(Vec<String>),
    /// Something would be lost in a file of this format.
    Losses {
        file: PathBuf,
        format: &'static str,
        lost: Vec<String>,
    },
}

#[derive(Debug)]
pub(crate) struct Question {
    pub(crate) about: About,
    pub(crate) fresh: bool,
}

#[derive(Debug)]
pub(crate) struct FileWindow {
    pub(crate) purpose: Purpose,
    pub(crate) folder: Folder,
    pub(crate) place: String,
    pub name: String,
    /// The true name of what was chosen, which may be impossible to type.
    pub(crate) chosen: Option<OsString>,
    pub(crate) filter: String,
    /// That of what the file is chosen for.
    pub(crate) own_filter: String,
    pub(crate) order: Order,
    /// The name of the format that is written.
    pub(crate) format: Option<&'static str>,
    pub(crate) hidden: bool,
    pub(crate) trouble: Option<String>,
    pub(crate) overwrite: Option<PathBuf>,
    /// It or its question has just opened: the keyboard goes there.
    pub(crate) fresh: bool,
    /// Scrolls the list to the chosen row.
    pub(crate) scroll: bool,
    /// The file chosen last, and its picture if it has one.
    pub(crate) picture: Option<(PathBuf, Option<Picture>)>,
}

#[derive(Debug)]
pub(crate) struct Offered {
    pub(crate) found: Found,
    /// `None` if it is broken.
    pub(crate) picture: Option<Picture>,
    /// A click more, and it is gone for good.
    pub(crate) goes: bool,
}

#[derive(Debug)]
pub(crate) struct RecoveryWindow {
    pub(crate) offered: Vec<Offered>,
}
