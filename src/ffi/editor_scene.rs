//! The scene of an editor window.

use std::ffi::c_int;

use super::border::border;
use super::editor::{CLOSED, opened, replace_with};
use super::pointers::Out;
use super::scene_handles::{insert, read};
use super::scene_types::V_SCENE;
use super::status::{V_ERR_INTERNAL, V_OK};
use super::types::V_EDITOR;
use crate::document::{At, Document, Edit, SceneDocument};
use crate::error::Result;
use crate::instance;

/// Gets a copy of the scene in a window; if the window has only a path, a scene with a
/// camera on it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_editor_get_scene(
    editor: *const V_EDITOR,
    scene: *mut *mut V_SCENE,
) -> c_int {
    border(V_ERR_INTERNAL, || {
        let out = Out::new(scene, "scene")?;
        let window = opened(editor)?.window;
        let copy = instance::read(window, Document::scene_document).ok_or(CLOSED)??;
        let made = insert(copy)?;
        // SAFETY: room for a handle, as the header says.
        unsafe { out.answer(made) }
    })
}

/// Replaces the scene in a window, in one step that the user can undo, with its
/// space, title, comment and so on, and its wireframe object if it has one.
///
/// If the new scene has a node with the name of the edited one and a path, that path
/// is edited; otherwise that of the camera shown, if it has one, with the base speeds
/// given when the window was opened. A scene with nothing but one camera on a path is
/// treated as that path. A drag in progress ends. The playhead stays
/// if it can.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_editor_set_scene(editor: *mut V_EDITOR, scene: *const V_SCENE) -> c_int {
    border(V_ERR_INTERNAL, || {
        let found = opened(editor)?;
        let copy = read(scene, |document| Ok(document.try_clone()?))?;
        instance::command(found.window, |editor| {
            editor.change(|document| replace(document, copy, found.fixed_speeds))
        })
        .ok_or(CLOSED)??;
        Ok(V_OK)
    })
}

/// Replaces the contents by a scene.
fn replace(document: &mut Document, by: SceneDocument, fixed_speeds: bool) -> Result<()> {
    let speeds = document.path().base_frames;
    let edited = document.edited_scene().and_then(|edited| {
        let name = &edited.scene().nodes()[edited.node()?].name;
        let node = by.scene.find(name)?;
        by.scene.nodes()[node].path().map(|_| node)
    });
    replace_with(document, by.info, |document| {
        document.apply(Edit::ReplaceScene(Box::new(by.scene)))?;
        if fixed_speeds && document.edits_path() {
            document.apply(Edit::set(At::Path, "base_speeds", speeds))?;
        }
        if document.edited_scene().is_some() && edited.is_some() {
            document.apply(Edit::EditNode(edited))?;
        }
        Ok(())
    })
}
