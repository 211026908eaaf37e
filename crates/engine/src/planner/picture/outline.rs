//! How far an object reaches in a picture: its outermost corners, found in a tree of boxes over the
//! corners alone, since those of large triangles would all overlap.
//!
//! In a picture the share x/d of a corner beside and before the camera is greatest at a corner of
//! the convex hull; a box of the tree is opened only if one of its corners reaches further than
//! what was found. From place to place of a flight the outermost corners are mostly the same, so
//! they are tried first.

use glam::DVec3;

use crate::error::Result;
use crate::path::Pose;
use crate::tools::clearance::{BoxNode, Clearance};

/// Half of the picture's width and height in mm, for right, left, up and down.
pub(super) const FILM: [f64; 4] = [18.0, 18.0, 12.0, 12.0];

/// Where a camera is and how it is turned.
#[derive(Debug, Clone, Copy)]
pub(super) struct Camera {
    pub eye: DVec3,
    pub view: DVec3,
    pub up: DVec3,
}

impl Camera {
    /// To the right, to the left, up and down.
    pub(super) fn sides(&self) -> [DVec3; 4] {
        let right = self.view.cross(self.up);
        [right, -right, self.up, -self.up]
    }
}

impl From<&Pose> for Camera {
    fn from(pose: &Pose) -> Self {
        Self {
            eye: pose.position(),
            view: pose.view(),
            up: pose.up(),
        }
    }
}

/// An object's corners, ready to be asked.
#[derive(Debug)]
pub(super) struct Outline {
    corners: Clearance,
    /// The outermost corners that were found last.
    last: [DVec3; 4],
}

impl Outline {
    pub(super) fn new(object: &Clearance) -> Result<Self> {
        let corners = object.of_corners()?;
        let first = corners.primitives.first();
        Ok(Self {
            last: [first.map_or(DVec3::ZERO, |one| one.0[0]); 4],
            corners,
        })
    }

    /// The box around it.
    pub(super) fn bounds(&self) -> [DVec3; 2] {
        self.corners.bounds()
    }

    pub(super) fn middle(&self) -> DVec3 {
        let [min, max] = self.bounds();
        min.midpoint(max)
    }

    /// The greatest x/d of all corners to the right, to the left, up and down; none where not all of
    /// the object is before the camera.
    pub(super) fn reach(&mut self, camera: &Camera) -> Option<[f64; 4]> {
        let Camera { eye, view, .. } = *camera;
        let sides = camera.sides();
        let mut most = [f64::NEG_INFINITY; 4];
        let mut before = true;
        let last = &mut self.last;
        let see = |corner: DVec3, most: &mut [f64; 4], last: &mut [DVec3; 4]| {
            let way = corner - eye;
            let depth = way.dot(view);
            for k in 0..4 {
                let share = way.dot(sides[k]) / depth;
                if share > most[k] {
                    (most[k], last[k]) = (share, corner);
                }
            }
            depth > 0.0
        };
        for corner in *last {
            before &= see(corner, &mut most, last);
        }
        self.corners.walk(&mut |node, primitives| {
            if !before {
                return false;
            }
            let further = |k: usize| furthest(node, sides[k] - most[k] * view, eye) > 0.0;
            if !(furthest(node, -view, eye) >= 0.0 || (0..4).any(further)) {
                return false;
            }
            for corner in primitives.iter().map(|primitive| primitive.0[0]) {
                before &= see(corner, &mut most, last);
            }
            true
        });
        (before && most.iter().all(|share| share.is_finite())).then_some(most)
    }

    /// How far the object reaches from a place in four directions, which need not be unit vectors.
    pub(super) fn furthest(&mut self, eye: DVec3, directions: [DVec3; 4]) -> [f64; 4] {
        let mut most = [f64::NEG_INFINITY; 4];
        let last = &mut self.last;
        let see = |corner: DVec3, most: &mut [f64; 4], last: &mut [DVec3; 4]| {
            for k in 0..4 {
                let far = (corner - eye).dot(directions[k]);
                if far > most[k] {
                    (most[k], last[k]) = (far, corner);
                }
            }
        };
        for corner in *last {
            see(corner, &mut most, last);
        }
        self.corners.walk(&mut |node, primitives| {
            if !(0..4).any(|k| furthest(node, directions[k], eye) > most[k]) {
                return false;
            }
            for corner in primitives.iter().map(|primitive| primitive.0[0]) {
                see(corner, &mut most, last);
            }
            true
        });
        most
    }
}

/// How far a box reaches from a place in a direction.
fn furthest(node: &BoxNode, direction: DVec3, eye: DVec3) -> f64 {
    let corner = DVec3::select(direction.cmpge(DVec3::ZERO), node.max, node.min);
    (corner - eye).dot(direction)
}
