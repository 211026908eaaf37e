//! The records of whole paths and scenes.

use super::change::{Change, Prepared, State, Whole};
use super::edit::Selection;
use super::edited_scene::{self, EditedScene};
use super::normalise::{move_into, normalise};
use super::vid::comments::Comments;
use crate::error::{Result, can_allocate, try_box};
use vides_engine::path::{CameraPath, Space};

/// Another path, in which a point has this number.
pub(super) fn replaced(
    state: &State,
    mut path: CameraPath,
    number: impl Fn(usize) -> usize,
) -> Result<Prepared> {
    normalise(&mut path)?;
    state.info.check(path.space)?;
    let pins = match &state.edited_scene {
        Some(edited) => Some(edited.pins_in(path.points.len(), number)?),
        None => None,
    };
    let change = Change::Whole(Whole {
        path: Some(try_box(path)?),
        pins,
        comments: Some(state.comments.without_points(state.node())?),
        ..Whole::default()
    });
    Ok((change, Some(Selection::default())))
}

pub(super) fn exchanged_scene(
    edited: Option<EditedScene>,
    mut path: CameraPath,
    comments: Comments,
) -> Result<Prepared> {
    normalise(&mut path)?;
    can_allocate(size_of::<EditedScene>())?;
    let change = Change::Whole(Whole {
        path: Some(try_box(path)?),
        comments: Some(comments),
        scene: Some(edited.map(Box::new)),
        ..Whole::default()
    });
    Ok((change, Some(Selection::default())))
}

/// The scene with its edited path in another space.
pub(super) fn scene_in(
    edited: &EditedScene,
    path: &CameraPath,
    comments: &Comments,
    space: Space,
    fit: bool,
) -> Result<Prepared> {
    let mut path = path.try_clone()?;
    match fit {
        true => move_into(&mut path, space)?,
        false => path.space = space,
    }
    let mut scene = edited.with(&path)?;
    scene.set_space(space)?;
    let (edited, path) = edited_scene::edit(scene, edited.node())?;
    let (change, _) = exchanged_scene(Some(edited), path, comments.try_clone()?)?;
    Ok((change, None))
}
