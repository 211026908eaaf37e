//! From frames of a scene to the timeline, and the keys that are seen there.

use std::ops::Range;

use super::axis::Axis;

/// Signs nearer to one another than this are one, in points.
pub(super) const APART: f32 = 3.0;

/// A press this near to a key means it.
pub(super) const REACH: f32 = 6.0;

/// From frames of the scene to the screen.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Time {
    pub(super) axis: Axis,
}

impl Time {
    pub(super) fn new(axis: &Axis) -> Self {
        Self { axis: *axis }
    }

    pub(super) fn x(&self, frame: f64) -> f32 {
        self.axis.place(frame)
    }

    pub(super) fn frame(&self, x: f32) -> f64 {
        self.axis.frame(x)
    }

    /// The keys that are to be seen: where their sign stands, and which ones share it.
    pub(super) fn signs(&self, frames: &[f64]) -> Vec<(f32, Range<usize>)> {
        let ends = self.axis.rail.expand(REACH);
        let last = self.frame(ends.max);
        let first = self.frame(ends.min);
        let mut at = frames.partition_point(|&key| key < first);
        let mut all = Vec::new();
        while let Some(&frame) = frames.get(at).filter(|&&key| key <= last) {
            let x = self.x(frame);
            let next = self.frame(x + APART);
            let end = at + frames[at..].partition_point(|&key| key < next).max(1);
            all.push((x, at..end));
            at = end;
        }
        all
    }

    /// The key that is nearest, if one is near.
    pub(super) fn nearest(&self, frames: &[f64], x: f32) -> Option<usize> {
        let frame = self.frame(x);
        let behind = frames.partition_point(|&key| key < frame);
        let around = [behind.checked_sub(1), Some(behind)].into_iter().flatten();
        let away = |at: &usize| (self.x(frames[*at]) - x).abs();
        let known = around.filter(|&at| at < frames.len());
        let near = known.min_by(|a, b| away(a).total_cmp(&away(b)));
        near.filter(|at| away(at) <= REACH)
    }
}
