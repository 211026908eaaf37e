//! What must follow a change of a path or its scene.

use vides_engine::scene::pins::pinned;

use super::change::{Change, State};
use super::scene_edit;
use super::set::with_frames;
use crate::error::Result;
use vides_engine::path::Plan;

/// What must follow a change, of the scene and of its pins: the frame counts that pins require of
/// their paths, and the end of a scene in which nothing but this path is left.
pub(super) fn what_follows(
    state: &State,
    plan: &Plan,
    [of_scene, of_pins]: [bool; 2],
) -> Result<Vec<Change>> {
    let mut held = Vec::new();
    let Some(edited) = &state.edited_scene else {
        return Ok(held);
    };
    let path = &state.path;
    let pins = edited.pins();
    if !pins.is_empty() {
        let pinned = plan.timeline(path, |timeline| pinned(path, timeline, &pins))??;
        held = with_frames(path, pinned.fixed)?;
    }
    let mut follow = |mut others: Vec<Change>| -> Result<()> {
        held.try_reserve(others.len())?;
        held.append(&mut others);
        Ok(())
    };
    if of_pins {
        follow(scene_edit::held_by_pins(edited)?)?;
    }
    if of_scene && edited.is_path_alone() && edited.scene().space() == path.space {
        follow(scene_edit::path_again(state, edited)?)?;
    }
    Ok(held)
}
