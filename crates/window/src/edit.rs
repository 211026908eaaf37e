//! The editor window for a Rust program: opened on a file, run until it is closed. The command
//! `vides edit` is no more than that.

use std::path::Path;
use std::rc::Rc;

use crate::document::{Document, Edit, load_object};
use crate::editor::{self, Folders, Warnings};
use crate::error::{Error, Result};
use crate::{Host, Options, document_of, main_loop, open, own_program};

/// Opens the editor in a window of its own and returns when it is closed; other windows of the
/// calling thread are served meanwhile. `file` is what is edited and saved to, a new path if it
/// does not exist yet. `object` is a mesh (OBJ, PLY, STL, glTF) shown in place of the path's own;
/// a new path gets a space around it.
///
/// # Errors
/// `ErrorKind::Display`: no X server, or it goes away; as [`Document::load`] and [`load_object`].
pub fn edit(file: Option<&Path>, object: Option<&Path>) -> Result<()> {
    let (mut document, warnings) = match file {
        Some(file) => document_of(file)?,
        None => (Document::try_new()?, Vec::new()),
    };
    if let Some(object) = object {
        let mut info = document.info().clone();
        info.object = load_object(object)?;
        document.apply(Edit::SetInfo(Box::new(info)))?;
        if file.is_none_or(|file| !file.exists()) {
            let space = document.space_around_object()?;
            document.apply(Edit::SetSpace { space, fit: true })?;
        }
    }
    let mut about_meshes = Warnings::default();
    about_meshes.add_meshes(warnings);
    open(Options {
        editor: editor::Options {
            document,
            file: file.map(Path::to_path_buf),
            title: None,
            language: None,
            host_takes_poses: false,
            fixed_speeds: false,
            folders: Folders::of_environment(),
            program: own_program(),
            host_view: editor::HostView::default(),
        },
        display: None,
        application: None,
        parent: None,
        transient_for: None,
        warnings: about_meshes,
        host: Rc::new(Nobody),
    })?;
    match main_loop()?.lost {
        None => Ok(()),
        Some(lost) => Err(Error::Lost(lost.why)),
    }
}

/// Takes no poses, and lets the user close at will.
struct Nobody;

impl Host for Nobody {
    fn lost(&self, _: &str) {}
}
