//! What a node of the file has beside its place.

use super::extensions;
use crate::tree::At;

/// What is ours at a place of the file.
pub(super) fn ours(at: At<'_>) -> Option<At<'_>> {
    at.get("extras")?.get("vides")
}

/// Whether we wrote a node as this part of the one above.
pub(super) fn part_of(at: At<'_>, part: &str) -> bool {
    ours(at)
        .and_then(|vides| vides.get("part"))
        .is_some_and(|found| found.value == part)
}

/// Whether a node has neither mesh nor camera nor light.
pub(super) fn is_empty(at: At<'_>) -> bool {
    at.get("mesh").is_none() && at.get("camera").is_none() && light_of(at).is_none()
}

pub(super) fn is_visible(at: At<'_>) -> bool {
    at.get("extensions")
        .and_then(|all| all.get(extensions::VISIBILITY)?.get("visible"))
        .is_none_or(|visible| visible.value != false)
}

/// The light of a node.
pub(super) fn light_of(node: At<'_>) -> Option<At<'_>> {
    node.get("extensions")?
        .get(extensions::LIGHTS)?
        .get("light")
}
