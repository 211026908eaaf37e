//! What must follow a change of a path or its scene.

use vides_engine::scene::pins::pinned;

use super::change::{Change, State};
use super::prepare::with_frames;
use super::scene_edit;
use crate::error::{Result, vec_with_room};
use crate::path::Plan;

/// What must follow a change, of the scene and of its pins: the frame counts that pins require of
/// their paths, and the end of a scene in which nothing but this path is left.
pub(super) fn what_follows(
    state: &State,
    plan: &Plan,
    [of_scene, of_pins]: [bool; 2],
) -> Result<Option<Change>> {
    let Some(edited) = &state.edited_scene else {
        return Ok(None);
    };
    let path = &state.path;
    let pins = edited.pins();
    let mut held = match pins.is_empty() {
        true => None,
        false => {
            let pinned = plan.timeline(path, |timeline| pinned(path, timeline, &pins))??;
            let fixed = Some(pinned.fixed).filter(|fixed| !fixed.is_empty());
            fixed.map(|fixed| with_frames(path, fixed)).transpose()?
        }
    };
    if of_pins {
        let others = scene_edit::held_by_pins(edited)?;
        if !others.is_empty() {
            held = Some(both(held, Change::Several(others))?);
        }
    }
    if of_scene && edited.is_path_alone() && edited.scene().space() == path.space {
        held = Some(both(held, scene_edit::path_again(state, edited)?)?);
    }
    Ok(held)
}

fn both(first: Option<Change>, second: Change) -> Result<Change> {
    let Some(first) = first else {
        return Ok(second);
    };
    let mut both = vec_with_room(2)?;
    both.extend([first, second]);
    Ok(Change::Several(both))
}
