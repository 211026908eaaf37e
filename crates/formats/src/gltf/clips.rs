//! Which animations of a file are read. Exporters write one for each object that moves, so all
//! that move different things are read together; of those that move the same, one.

use std::collections::HashSet;

use vides_document::error::vec_with_room;

use super::motion::{pointer_of, target_of};
use crate::error::{Error, Result};
use crate::tree::At;

/// The animations that are read, and the names of the others.
pub(super) struct Clips<'a> {
    pub(super) taken: Vec<At<'a>>,
    pub(super) left: Vec<String>,
}

/// Something that an animation moves.
#[derive(PartialEq, Eq, Hash, Clone, Copy)]
enum Target<'a> {
    Node(usize, &'a str),
    Pointer(&'a str),
}

fn targets(clip: At<'_>) -> Result<HashSet<Target<'_>>> {
    let mut found = HashSet::new();
    for channel in clip.need("channels")?.list()? {
        let pointer = || channel.get("target").and_then(pointer_of);
        let target = match target_of(channel) {
            Some((node, path)) => Some(Target::Node(node, path)),
            None => pointer().map(Target::Pointer),
        };
        found.try_reserve(1)?;
        found.extend(target);
    }
    Ok(found)
}

fn name(at: usize, clip: At<'_>) -> String {
    let name = clip.get("name").and_then(|name| name.value.as_str());
    name.map_or_else(|| format!("animation {at}"), ToOwned::to_owned)
}

impl<'a> Clips<'a> {
    /// The animation `wanted`, or else those that can be read together: first those that move the
    /// nodes `seen`, on which the camera hangs.
    ///
    /// # Errors
    /// [`Error::NoClip`]; what is wrong in the file.
    pub(super) fn of(root: At<'a>, wanted: Option<&str>, seen: &HashSet<usize>) -> Result<Self> {
        let mut clips = Self {
            taken: Vec::new(),
            left: Vec::new(),
        };
        let Some(all) = root.get("animations") else {
            return match wanted {
                Some(wanted) => Err(clips.none(wanted)),
                None => Ok(clips),
            };
        };
        let all = all.list()?;
        let mut order: Vec<(usize, At<'a>, HashSet<Target<'a>>)> = vec_with_room(all.len())?;
        for (at, clip) in all.enumerate() {
            order.push((at, clip, targets(clip)?));
        }
        if let Some(wanted) = wanted {
            for (at, clip, _) in order {
                match name(at, clip) {
                    name if name == wanted && clips.taken.is_empty() => clips.taken.push(clip),
                    name => clips.left.push(name),
                }
            }
            return match clips.taken.is_empty() {
                true => Err(clips.none(wanted)),
                false => Ok(clips),
            };
        }
        let moves_the_camera = |target: &Target<'_>| match *target {
            Target::Node(node, path) => path != "weights" && seen.contains(&node),
            Target::Pointer(pointer) => pointer.starts_with("/cameras/"),
        };
        order.sort_by_key(|(.., targets)| !targets.iter().any(moves_the_camera));
        let mut moved = HashSet::new();
        for (at, clip, targets) in order {
            if targets.is_disjoint(&moved) {
                moved.try_reserve(targets.len())?;
                moved.extend(targets);
                clips.taken.push(clip);
            } else {
                clips.left.push(name(at, clip));
            }
        }
        Ok(clips)
    }

    fn none(&self, wanted: &str) -> Error {
        let known = match self.left.is_empty() {
            true => "none".to_owned(),
            false => self.left.join(", "),
        };
        Error::NoClip {
            wanted: wanted.into(),
            known: (&known).into(),
        }
    }
}
