//! The editor window for a Rust program: opens a file and runs until the window is closed. The
//! command `vides edit` does the same.

use std::path::Path;
use std::rc::Rc;

use crate::error::{Error, Result};
use crate::{Host, Options, document_of, main_loop, open, own_program};
use vides_document::{Document, Edit, load_object};
use vides_editor::{Folders, Warnings};

/// Opens the editor in a window and returns when it is closed; other windows of the calling thread
/// are served meanwhile. `file` is loaded and saved to; if it does not exist, it becomes a new
/// path. `object` is a mesh (OBJ, PLY, STL, glTF) to show instead of the path's object; a new path
/// gets a space around it.
///
/// # Errors
/// `ErrorKind::Display` if there is no X server or it goes away; those of [`Document::load`] and
/// [`load_object`].
pub fn edit(file: Option<&Path>, object: Option<&Path>) -> Result<()> {
    let (document, warnings) = beginning(file, object)?;
    let mut about_meshes = Warnings::default();
    about_meshes.add_meshes(warnings);
    let _window = open(Options {
        editor: vides_editor::Options {
            document,
            file: file.map(Path::to_path_buf),
            title: None,
            language: None,
            host_takes_poses: false,
            fixed_speeds: false,
            folders: Folders::of_environment(),
            program: own_program(),
            host_view: vides_editor::HostView::default(),
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

/// The document of the new window. Setting the object does not count as a change.
fn beginning(
    file: Option<&Path>,
    object: Option<&Path>,
) -> Result<(Document, Vec<vides_document::Error>)> {
    let object = object.map(load_object).transpose()?;
    let (mut document, warnings) = match (file, &object) {
        (Some(file), None) => document_of(file)?,
        (Some(file), Some(_)) if file.exists() => document_of(file)?,
        (_, Some(object)) => return Ok((Document::around(object.clone())?, Vec::new())),
        (None, None) => (Document::try_new()?, Vec::new()),
    };
    if let Some(object) = object {
        let mut info = document.info().clone();
        info.object = object;
        document.apply(Edit::SetInfo(Box::new(info)))?;
    }
    Ok((document.as_opened(), warnings))
}

/// A host that takes no poses and lets the user close the window.
struct Nobody;

impl Host for Nobody {
    fn lost(&self, _: &str) {}
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_window_with_an_object_opens_unchanged() {
        let examples = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples"));
        let folder = tempfile::tempdir().unwrap();
        let object = folder.path().join("house.obj");
        std::fs::write(&object, "v 0 0 0\nv 3 0 0\nv 0 3 0\nl 1 2 3\n").unwrap();
        let pyramid = examples.join("pyramid.vid");
        for file in [None, Some(pyramid.as_path())] {
            let (plain, _) = beginning(file, None).unwrap();
            let (document, _) = beginning(file, Some(&object)).unwrap();
            assert_ne!(plain.info().object, document.info().object);
            assert!(!document.is_modified() && !document.can_undo());
            assert_eq!(plain.fingerprint(), document.fingerprint());
        }
    }
}
