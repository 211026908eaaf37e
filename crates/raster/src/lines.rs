//! Straight lines in great number, as a scene is drawn of.

use std::sync::Arc;

use egui::{Color32, PaintCallback, Pos2, Rect, Shape};

/// One straight piece with round ends, in points as egui counts them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    /// One end.
    pub from: Pos2,
    /// The other end.
    pub to: Pos2,
    /// Width in points; at least one pixel is painted, the thinner the paler.
    pub width: f32,
    /// Its colour.
    pub color: Color32,
}

/// Lines that are painted together, the first one lowest.
///
/// egui's own lines become eight triangles each; these go to the raster as
/// they are, and a part of a scene that did not change can be shown again
/// without being made again.
#[derive(Clone, Debug, Default)]
pub struct Lines {
    /// The lines, in the order in which they are painted.
    pub lines: Vec<Line>,
}

impl Lines {
    /// The shape to be handed to egui's painter. `clip` is the rectangle that
    /// the lines are cut at, in points.
    pub fn shape(lines: &Arc<Self>, clip: Rect) -> Shape {
        Shape::Callback(PaintCallback {
            rect: clip,
            callback: Arc::<Self>::clone(lines),
        })
    }

    /// Whether others are the same to the last bit.
    pub(super) fn are(&self, others: &Self) -> bool {
        // egui does not compare NaN.
        let bits_of = |line: &Line| {
            let Line { from, to, .. } = line;
            let numbers = [from.x, from.y, to.x, to.y, line.width].map(f32::to_bits);
            (numbers, line.color)
        };
        let (ours, theirs) = (self.lines.iter(), others.lines.iter());
        ours.map(bits_of).eq(theirs.map(bits_of))
    }

    /// The lines that a paint callback carries, if it carries any.
    pub(super) fn of(callback: &PaintCallback) -> Option<&Self> {
        callback.callback.downcast_ref()
    }
}
