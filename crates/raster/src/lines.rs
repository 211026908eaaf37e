//! Large numbers of lines, as in drawings of scenes.

use std::sync::Arc;

use egui::{Color32, PaintCallback, Pos2, Rect, Shape};

/// A line segment with round caps, in egui's points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    /// One end.
    pub from: Pos2,
    /// The other end.
    pub to: Pos2,
    /// Width in points; below one pixel the line is painted fainter instead of thinner.
    pub width: f32,
    /// Its colour.
    pub color: Color32,
}

/// Lines painted together, the first one lowest. egui would make eight triangles of each; these go
/// to the raster as they are, and an unchanged part of a scene can be shown again without
/// rebuilding it.
#[derive(Clone, Debug, Default)]
pub struct Lines {
    /// The lines in painting order.
    pub lines: Vec<Line>,
}

impl Lines {
    /// A shape for egui's painter; `clip` is the clip rectangle in points.
    pub fn shape(lines: &Arc<Self>, clip: Rect) -> Shape {
        Shape::Callback(PaintCallback {
            rect: clip,
            callback: Arc::<Self>::clone(lines),
        })
    }

    /// Bitwise equality.
    pub(super) fn same_bits(&self, others: &Self) -> bool {
        // egui's comparison rejects NaN.
        let bits_of = |line: &Line| {
            let Line { from, to, .. } = line;
            let numbers = [from.x, from.y, to.x, to.y, line.width].map(f32::to_bits);
            (numbers, line.color)
        };
        let (ours, theirs) = (self.lines.iter(), others.lines.iter());
        ours.map(bits_of).eq(theirs.map(bits_of))
    }

    /// The lines in a paint callback, if it is ours.
    pub(super) fn of(callback: &PaintCallback) -> Option<&Self> {
        callback.callback.downcast_ref()
    }
}
