//! The state of a node at a frame.

use glam::{DAffine3, DMat4};

use crate::error::{Error, Invalid};
use crate::path::Pose;

/// A node at a frame, laid out as C's `V_NODE_STATE`.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[repr(C)]
pub struct NodeState {
    /// From the node's coordinates into the world's, column by column.
    pub matrix: [f64; 16],
    /// Of cameras and lights: where they are and look; of others all 0.
    pub pose: Pose,
    /// Of lights and objects.
    pub colour: [f64; 3],
    /// Of lights.
    pub intensity: f64,
    /// Of lights: half angles in degrees, inner and outer.
    pub cone: [f64; 2],
    /// 1 if it and all that it is in are visible, else 0: C's `int`.
    pub visible: i32,
}

impl NodeState {
    /// Everything but the place, of a node whose parent is seen.
    pub(super) fn begin(&mut self, looks: Looks) {
        self.pose = Pose::default();
        (self.colour, self.intensity, self.cone, _) = looks;
        self.visible = i32::from(looks.3);
    }

    pub(super) fn set_world(&mut self, world: DAffine3) {
        self.matrix = DMat4::from(world).to_cols_array();
    }

    /// [`NodeState::matrix`] as an affine map.
    #[must_use]
    pub fn world(&self) -> DAffine3 {
        let [m0, m1, m2, _, m4, m5, m6, _, m8, m9, m10, _, x, y, z, _] = self.matrix;
        DAffine3::from_cols_array(&[m0, m1, m2, m4, m5, m6, m8, m9, m10, x, y, z])
    }
}

/// What of a state is as it is in the values: colour, intensity, cone, whether it is visible.
pub(super) type Looks = ([f64; 3], f64, [f64; 2], bool);

/// What went wrong while the rest went on; the first of it is kept.
#[derive(Debug, Default)]
pub struct Warnings {
    pub(super) node: usize,
    first: Option<(usize, Invalid)>,
}

impl Warnings {
    pub(super) fn add(&mut self, what: impl FnOnce() -> Invalid) {
        if self.first.is_none() {
            self.first = Some((self.node, what()));
        }
    }

    pub(super) fn too_far(&mut self, node: usize) {
        self.node = node;
        self.add(|| Invalid::PlaceTooFar);
    }

    /// The number of the node and what went wrong there, if anything did.
    #[must_use]
    pub fn first(&self) -> Option<(usize, &Invalid)> {
        self.first.as_ref().map(|(node, what)| (*node, what))
    }

    /// The same as an error; the caller knows the place.
    #[must_use]
    pub fn into_error(self) -> Option<Error> {
        self.first.map(|(_, what)| what.into())
    }
}
