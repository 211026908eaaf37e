//! What must follow a change of a path or its scene.

use std::sync::Arc;

use vides_engine::scene::pins::pinned;

use super::content::Content;
use super::scene_edit;
use crate::error::Result;
use vides_engine::path::Plan;

/// What must follow a change from `old`: the frame counts that pins require of their paths, and the
/// end of a scene in which nothing but this path is left. `plan` is that of the changed path.
pub(super) fn follow(old: &Content, content: &mut Content, plan: &Plan) -> Result<()> {
    let Some(edited) = content.scene.clone() else {
        return Ok(());
    };
    let pins = edited.pins();
    if !pins.is_empty() {
        let path = &content.path;
        let pinned = plan.timeline(path, |timeline| pinned(path, timeline, &pins))??;
        content.set_frames(pinned.fixed)?;
    }
    if old
        .scene
        .as_ref()
        .is_none_or(|old| !Arc::ptr_eq(old, &edited))
    {
        scene_edit::hold_pins(content)?;
        if edited.is_path_alone() && edited.scene().space() == content.path.space {
            scene_edit::path_again(content)?;
        }
    }
    Ok(())
}
