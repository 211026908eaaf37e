//! What a check tells besides its findings: where the camera is, and what it ignored.

use std::fmt;

use glam::DVec3;
use vides_engine::scene::{Channel, Kind, Node, Scene};
use vides_engine::tools::clearance::Clearance;
use vides_engine::tools::enclosure::Enclosure;

use super::editing::Document;
use crate::error::Result;
use vides_engine::path::Pose;

/// Something to be told that is no fault.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Note {
    /// The camera is inside a closed part of the object in all frames.
    Inside,
    /// Objects move, appear or change: the check used the path's first frame.
    Moving {
        /// The name of the first.
        name: String,
        /// How many others there are.
        others: usize,
    },
    /// The check ignored what a parent, an aim, a roll or keys add to the camera.
    Camera,
}

impl fmt::Display for Note {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Inside => f.write_str("The camera is inside the object all the time."),
            Self::Moving { name, others } => {
                write!(f, "The object \"{name}\" ")?;
                match others {
                    0 => f.write_str("moves or changes: it was checked as it is"),
                    1 => {
                        f.write_str("and another one move or change: they were checked as they are")
                    }
                    _ => write!(
                        f,
                        "and {others} others move or change: they were checked as they are"
                    ),
                }?;
                f.write_str(" where the path begins.")
            }
            Self::Camera => f.write_str(
                "The camera's path was looked at alone, without what its parent, its aim, its roll \
                 and its keys add.",
            ),
        }
    }
}

/// Poses that are sampled at once.
const BLOCK: usize = 256;

impl Document {
    /// What is to be told besides the findings of a check against `object`; `own`: it is the
    /// document's own ([`Document::obstacles`]).
    ///
    /// # Errors
    /// [`vides_engine::Error::Limit`], [`vides_engine::Error::Memory`].
    pub fn notes(&self, object: Option<&Clearance>, own: bool) -> Result<Vec<Note>> {
        let mut notes = Vec::new();
        if let Some(object) = object
            && self.is_inside(object)?
        {
            notes.push(Note::Inside);
        }
        if let Some(edited) = self.edited_scene() {
            if own && let Some(note) = moving(edited.scene()) {
                notes.push(note);
            }
            if self.shows_path() == Some(false) {
                notes.push(Note::Camera);
            }
        }
        Ok(notes)
    }

    /// Whether the camera is inside closed parts of an object in all frames.
    fn is_inside(&self, object: &Clearance) -> Result<bool> {
        let sampler = self.sampler()?;
        let place = |pose: &Pose| DVec3::from_array(pose.vrp);
        let Some(around) = Enclosure::around(object, place(&sampler.pose(1.0)?))? else {
            return Ok(false);
        };
        let mut poses = [Pose::default(); BLOCK];
        let frames = sampler.frame_count();
        for first in (1..=frames).step_by(BLOCK) {
            let poses = &mut poses[..BLOCK.min(frames + 1 - first)];
            sampler.sample(first, poses)?;
            for pose in poses {
                if !around.holds(place(pose))? {
                    return Ok(false);
                }
            }
        }
        Ok(true)
    }
}

fn moving(scene: &Scene) -> Option<Note> {
    let nodes = scene.nodes();
    let moves = |node: &Node| {
        let mut tracks = node.keys().tracks().iter();
        node.path().is_some() || tracks.any(|track| shapes(track.channel()))
    };
    let is_moved = |node: &Node| {
        let up = |node: &&Node| node.parent.map(|at| &nodes[at]);
        std::iter::successors(Some(node), up).any(moves)
    };
    let mut found = nodes
        .iter()
        .filter(|node| matches!(node.kind, Kind::Object(_)) && is_moved(node));
    let name = found.next()?.name.clone();
    let others = found.count();
    Some(Note::Moving { name, others })
}

/// Whether a channel changes where an object is, how it is shaped or whether it is seen.
const fn shapes(channel: &Channel) -> bool {
    matches!(
        channel,
        Channel::Position
            | Channel::Rotation
            | Channel::Scale
            | Channel::Visible
            | Channel::Weights
            | Channel::Deformation { .. }
    )
}
