//! The nodes of a file's scene, and their transformations.

use glam::{DAffine3, DMat4, DQuat, DVec3};
use serde_json::Value;

use super::container::{Container, FORMAT, INDICES, element, index, list, numbers};
use crate::error::{Error, Problem, Result};

/// Maximum depth of the node tree.
const MAX_DEPTH: usize = 256;

/// A node of the shown scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Placed {
    /// Its index in the file.
    pub node: usize,
    /// The position of its parent in the list, before its own.
    pub parent: Option<usize>,
    depth: usize,
}

/// The transformation of a node relative to its parent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Local {
    /// By a matrix.
    Matrix(DAffine3),
    /// Scaled, then rotated by a quaternion of any length, then moved.
    Parts {
        /// The translation.
        translation: DVec3,
        /// The rotation.
        rotation: DQuat,
        /// The scale along its own axes.
        scale: DVec3,
    },
}

impl Local {
    /// As a matrix.
    #[must_use]
    pub fn matrix(self) -> DAffine3 {
        match self {
            Self::Matrix(matrix) => matrix,
            Self::Parts {
                translation,
                rotation,
                scale,
            } => {
                DAffine3::from_scale_rotation_translation(scale, rotation.normalize(), translation)
            }
        }
    }
}

impl Container<'_> {
    /// All nodes of the shown scene, or of the whole tree if there is no scene; parents come first.
    ///
    /// # Errors
    /// [`Error::File`] for a node that is its own ancestor or has two parents, an index that does
    /// not exist, or too many levels.
    pub fn tree(&self) -> Result<Vec<Placed>> {
        let document = self.json();
        let nodes = list(&document["nodes"]);
        let scenes = list(&document["scenes"]);
        let mut waiting: Vec<Placed> = Vec::new();
        let mut seen = Vec::new();
        seen.try_reserve_exact(nodes.len())?;
        seen.resize(nodes.len(), false);
        let mut push = |waiting: &mut Vec<_>, node: &Value, parent, depth: usize| {
            let at = index(node).ok_or(INDICES)?;
            // Each node has at most one parent, so there are no cycles.
            if std::mem::replace(seen.get_mut(at).ok_or(INDICES)?, true) {
                return Err(Error::File(Problem::Cycle));
            }
            if depth > MAX_DEPTH {
                return Err(Error::File(Problem::Long));
            }
            waiting.try_reserve(1)?;
            waiting.push(Placed {
                node: at,
                parent,
                depth,
            });
            Ok(())
        };
        let shown = match &document["scene"] {
            Value::Null => scenes.first(),
            number => Some(element(scenes, number)?),
        };
        if let Some(scene) = shown {
            for node in list(&scene["nodes"]).iter().rev() {
                push(&mut waiting, node, None, 0)?;
            }
        } else {
            let mut below = Vec::new();
            below.try_reserve_exact(nodes.len())?;
            below.resize(nodes.len(), false);
            for child in nodes.iter().flat_map(|node| list(&node["children"])) {
                *index(child)
                    .and_then(|at| below.get_mut(at))
                    .ok_or(INDICES)? = true;
            }
            for at in (0..nodes.len()).rev().filter(|&at| !below[at]) {
                push(&mut waiting, &at.into(), None, 0)?;
            }
            if waiting.is_empty() && !nodes.is_empty() {
                return Err(Error::File(Problem::Cycle));
            }
        }
        let mut placed: Vec<Placed> = Vec::new();
        placed.try_reserve_exact(nodes.len())?;
        while let Some(next) = waiting.pop() {
            let parent = placed.len();
            placed.push(next);
            for child in list(&nodes[next.node]["children"]).iter().rev() {
                push(&mut waiting, child, Some(parent), next.depth + 1)?;
            }
        }
        Ok(placed)
    }

    /// The transformation of a node relative to its parent.
    ///
    /// # Errors
    /// [`Error::File`] if it is not valid or has the wrong number of numbers.
    pub fn local(&self, node: usize) -> Result<Local> {
        let node = &self.json()["nodes"][node];
        if let Some(matrix) = node.get("matrix") {
            let matrix = numbers::<16>(matrix).ok_or(FORMAT)?;
            let matrix = DMat4::from_cols_array(&matrix);
            return Ok(Local::Matrix(DAffine3::from_mat4(matrix)));
        }
        let part = |name: &str, rest: DVec3| match node.get(name) {
            None => Some(rest),
            Some(value) => numbers::<3>(value).map(DVec3::from_array),
        };
        let rotation = match node.get("rotation") {
            None => Some(DQuat::IDENTITY),
            Some(value) => numbers(value).map(DQuat::from_array),
        };
        match (
            part("translation", DVec3::ZERO),
            rotation,
            part("scale", DVec3::ONE),
        ) {
            (Some(translation), Some(rotation), Some(scale)) => Ok(Local::Parts {
                translation,
                rotation,
                scale,
            }),
            _ => Err(FORMAT),
        }
    }
}
