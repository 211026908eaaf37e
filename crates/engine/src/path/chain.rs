//! Cubics one after the other, by their length.

use glam::DVec3;

use super::arc_length::ArcLength;
use super::hermite::Cubic;
use crate::error::{Result, vec_with_room};

#[derive(Debug, Clone, PartialEq)]
pub(super) struct Chain {
    pub curves: Vec<Cubic>,
    /// Length before each curve, and of them all.
    pub starts: Vec<f64>,
}

impl Chain {
    /// Of at least one curve, each with its length.
    pub(super) fn new(all: impl ExactSizeIterator<Item = (Cubic, f64)>) -> Result<Self> {
        let mut curves = vec_with_room(all.len())?;
        let mut starts = vec_with_room(all.len() + 1)?;
        let mut length = 0.0;
        starts.push(length);
        for (curve, its) in all {
            curves.push(curve);
            length += its;
            starts.push(length);
        }
        Ok(Self { curves, starts })
    }

    pub(super) fn length(&self) -> f64 {
        self.starts[self.curves.len()]
    }

    /// The place at a length, none without memory.
    pub(super) fn place(&self, s: f64) -> Option<DVec3> {
        let at = self.starts.partition_point(|&start| start <= s).max(1) - 1;
        let at = at.min(self.curves.len() - 1);
        let arc = ArcLength::new(&self.curves[at]).ok()?;
        Some(self.curves[at].point(arc.parameter_at(s - self.starts[at])))
    }
}
