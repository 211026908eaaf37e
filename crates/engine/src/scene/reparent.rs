//! A node that is given another parent stays where it is in the world.

use glam::{DAffine3, DMat3, DQuat};

use super::channel::Channel;
use super::hierarchy::local;
use super::node::Node;
use super::scene::Scene;
use super::state::Warnings;
use crate::error::{Error, Invalid, Place, Result};

/// How well a place must be kept, relative to its size.
const KEPT: f64 = 1e-9;

impl Scene {
    /// Changes the rest values of `new`, node `at` in another parent, to keep its world matrix.
    pub(super) fn keep_world(&self, at: usize, new: &mut Node) -> Result<()> {
        if let Some(parent) = new.parent {
            self.node(parent).map_err(|error| error.at(Place::Parent))?;
            let mut above = std::iter::successors(Some(parent), |&up| self.nodes()[up].parent);
            if above.any(|up| up == at) {
                return Err(Invalid::ParentMovesWithIt {
                    node: (&new.name).into(),
                    parent: (&self.nodes()[parent].name).into(),
                }
                .into());
            }
        }
        let mut states = self.scratch()?;
        let first = self.frame_range().0;
        self.evaluate(first, &mut states, &mut Warnings::default())?;
        let world = |parent: Option<usize>| {
            parent.map_or(DAffine3::IDENTITY, |parent| states[parent].world())
        };
        let (old, other) = (world(self.nodes()[at].parent), world(new.parent));
        if old == other {
            return Ok(());
        }
        let node = &self.nodes()[at];
        let moves = |channel| node.keys().track(&channel).is_some();
        if node.path().is_some()
            || [Channel::Position, Channel::Rotation, Channel::Scale]
                .into_iter()
                .any(moves)
        {
            return Err(Invalid::MovesInParent((&new.name).into()).into());
        }
        let wanted = other.inverse() * (old * local(new, &new.rest));
        let columns = [
            wanted.matrix3.x_axis,
            wanted.matrix3.y_axis,
            wanted.matrix3.z_axis,
        ];
        let mut scale = columns.map(|column| column.length());
        // A mirrored node stays so along its axes; one that the parents mirror is mirrored along x.
        let signs = new.rest.scale.to_array().map(f64::signum);
        for (scale, sign) in scale.iter_mut().zip(signs) {
            *scale *= sign;
        }
        let turned = wanted.matrix3.determinant() < 0.0;
        if turned != (scale.iter().product::<f64>() < 0.0) {
            scale[0] = -scale[0];
        }
        if scale.contains(&0.0) || !wanted.is_finite() {
            return Err(flat(new));
        }
        let axes = [0, 1, 2].map(|k| columns[k] / scale[k]);
        let turn = DMat3::from_cols(axes[0], axes[1], axes[2]);
        new.rest.rotation = DQuat::from_mat3(&turn).normalize();
        new.rest.scale = scale.into();
        let linear = local(new, &new.rest).matrix3;
        new.rest.position = wanted.translation - new.pivot + linear * new.pivot;
        let got = local(new, &new.rest);
        let size = scale.map(f64::abs).into_iter().fold(0.0, f64::max);
        let off = got.matrix3 - wanted.matrix3;
        let off = [off.x_axis, off.y_axis, off.z_axis].map(|v| v.length());
        if off.into_iter().any(|off| off > KEPT * size) {
            return Err(Invalid::NeedsShear((&new.name).into()).into());
        }
        new.check()
    }
}

fn flat(node: &Node) -> Error {
    Error::Argument(Invalid::ScaleZero((&node.name).into()))
}
