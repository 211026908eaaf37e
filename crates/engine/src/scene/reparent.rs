//! A node gets another parent: it keeps its place in the world, or moves with the parent.

use glam::{DAffine3, DMat3, DQuat, DVec3};

use super::hierarchy::local;
use super::node::{Node, Values};
use super::part::Rest;
use super::scene::{Scene, copy};
use crate::error::{Error, Invalid, Place, Result};

/// How well a place must be kept, relative to its size.
pub(super) const KEPT: f64 = 1e-9;

/// What a node keeps that is given another parent.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Keep {
    /// Its place in the world at the scene's first frame, as [`Scene::set_node`] does.
    #[default]
    Place,
    /// Its numbers, path and tracks, so that it moves with the new parent.
    Numbers,
    /// Its way through the world at every frame of the scene, by other numbers ([`Scene::way_in`]).
    Way,
}

impl Scene {
    /// Gives a node another parent; none: it stands in the scene itself.
    ///
    /// # Errors
    /// [`Error::Range`] if there is no such node, [`Error::Argument`] if the parent is in it or
    /// moves with it, [`Error::Limit`] for too many levels; for [`Keep::Place`] as
    /// [`Scene::set_node`], for [`Keep::Way`] as [`Scene::way_in`]. Nothing has changed then.
    pub fn set_parent(&mut self, at: usize, parent: Option<usize>, keep: Keep) -> Result<()> {
        if keep == Keep::Way {
            let parts = self.way_in(at, parent)?;
            return parts.into_iter().try_for_each(|part| self.apply(part));
        }
        let node = self.node(at)?;
        if keep == Keep::Place {
            let values = Node {
                kind: node.kind.clone(),
                parent,
                aim: node.aim,
                pivot: node.pivot,
                rest: node.rest,
                ..Node::default()
            };
            return self.set_node(at, &values);
        }
        let aim = node.aim;
        self.check_parent(at, parent)?;
        self.link(at, parent, aim)
    }

    /// What a node has at rest that keeps its place in another parent ([`Keep::Place`]).
    ///
    /// # Errors
    /// As [`Scene::set_parent`].
    pub fn rest_in(&self, at: usize, parent: Option<usize>) -> Result<Rest> {
        let old = self.node(at)?;
        let mut new = Node {
            name: copy(&old.name)?,
            parent,
            pivot: old.pivot,
            rest: old.rest,
            ..Node::default()
        };
        self.keep_world(at, &mut new)?;
        Ok(Rest {
            values: new.rest,
            ..Rest::of(old)
        })
    }

    /// Checks that a parent is there, and neither the node itself nor in it.
    pub(super) fn check_parent(&self, at: usize, parent: Option<usize>) -> Result<()> {
        let Some(parent) = parent else {
            return Ok(());
        };
        let name = |at: usize| (&self.nodes()[at].name).into();
        self.node(parent).map_err(|error| error.at(Place::Parent))?;
        if parent == at {
            return Err(Error::from(Invalid::InItself).at(Place::Node(name(at))));
        }
        let mut above = std::iter::successors(Some(parent), |&up| self.nodes()[up].parent);
        if above.any(|up| up == at) {
            return Err(Invalid::ParentMovesWithIt {
                node: name(at),
                parent: name(parent),
            }
            .into());
        }
        Ok(())
    }

    /// Changes the rest values of `new`, node `at` in another parent, to keep its world matrix.
    pub(super) fn keep_world(&self, at: usize, new: &mut Node) -> Result<()> {
        self.check_parent(at, new.parent)?;
        let first = self.frame_range().0;
        let old = self.world_of(self.nodes()[at].parent, first)?;
        let other = self.world_of(new.parent, first)?;
        if old == other {
            return Ok(());
        }
        let node = &self.nodes()[at];
        if node.moves() {
            return Err(Invalid::MovesInParent((&new.name).into()).into());
        }
        let wanted = other.inverse() * (old * local(new, &new.rest));
        new.rest = without_shear(new, &wanted, new.rest.scale)?;
        new.check()
    }
}

/// The values at rest with position, rotation and scale of a local matrix; the scale has the signs
/// of `like`: one that is mirrored stays so along its axes, one that the parents mirror is along x.
pub(super) fn without_shear(node: &Node, wanted: &DAffine3, like: DVec3) -> Result<Values> {
    let linear = wanted.matrix3;
    let columns = [linear.x_axis, linear.y_axis, linear.z_axis];
    let mut scale = columns.map(|column| column.length());
    for (scale, sign) in scale.iter_mut().zip(like.to_array().map(f64::signum)) {
        *scale *= sign;
    }
    let turned = linear.determinant() < 0.0;
    if turned != (scale.iter().product::<f64>() < 0.0) {
        scale[0] = -scale[0];
    }
    if scale.contains(&0.0) || !wanted.is_finite() {
        return Err(flat(node));
    }
    let axes = [0, 1, 2].map(|k| columns[k] / scale[k]);
    let turn = DMat3::from_cols(axes[0], axes[1], axes[2]);
    let mut values = Values {
        rotation: DQuat::from_mat3(&turn).normalize(),
        scale: scale.into(),
        ..node.rest
    };
    let got = local(node, &values).matrix3;
    values.position = wanted.translation - node.pivot + got * node.pivot;
    let size = scale.map(f64::abs).into_iter().fold(0.0, f64::max);
    let off = got - linear;
    let off = [off.x_axis, off.y_axis, off.z_axis].map(|v| v.length());
    if off.into_iter().any(|off| off > KEPT * size) {
        return Err(Invalid::NeedsShear((&node.name).into()).into());
    }
    Ok(values)
}

fn flat(node: &Node) -> Error {
    Error::Argument(Invalid::ScaleZero((&node.name).into()))
}

#[cfg(test)]
#[path = "reparent_tests.rs"]
mod tests;
