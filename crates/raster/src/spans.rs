//! Scan conversion of convex outlines.
//!
//! The pixels of a row between the crossings of two edges are inside. A crossing is computed in
//! integers from its edge alone. So along a shared edge every pixel belongs to exactly one outline:
//! the one that contains its centre or, for a centre on the edge, has it as a left or top edge.

use super::tile::{PixelRect, SIDE};
use super::triangle::{STEPS, first_pixel};

/// The rows of an outline within a tile.
pub(super) struct Spans {
    from: [i32; SIDE],
    to: [i32; SIDE],
    cut: PixelRect,
}

impl Spans {
    /// An empty outline; `cut` is within one tile.
    #[inline]
    pub(super) fn new(cut: PixelRect) -> Self {
        Self {
            from: [cut.x1; SIDE],
            to: [cut.x0; SIDE],
            cut,
        }
    }

    /// Adds an edge in either direction. Everything between a row's first and last crossing is
    /// inside, so inner edges are harmless.
    #[inline]
    pub(super) fn add(&mut self, a: (i32, i32), b: (i32, i32)) {
        let (a, b) = if a.1 <= b.1 { (a, b) } else { (b, a) };
        // An edge crosses a row if it crosses its centre line, or begins on it.
        let first = first_pixel(a.1).max(self.cut.y0);
        let end = first_pixel(b.1).min(self.cut.y1);
        if first >= end {
            return;
        }
        let rows = (first - self.cut.y0) as usize..(end - self.cut.y0) as usize;
        let (froms, tos) = (&mut self.from[rows.clone()], &mut self.to[rows]);
        let mut crossings = Crossings::new(a, b, first);
        for (from, to) in froms.iter_mut().zip(tos) {
            let x = crossings.next();
            let x = x.clamp(i64::from(self.cut.x0), i64::from(self.cut.x1)) as i32;
            *from = x.min(*from);
            *to = x.max(*to);
        }
    }

    /// Yields each row as (y, first x, end x).
    #[inline]
    pub(super) fn rows(&self) -> impl Iterator<Item = (i32, i32, i32)> {
        let each = self.from.iter().zip(&self.to);
        let rows = (self.cut.y0..self.cut.y1).zip(each);
        rows.filter_map(|(y, (&from, &to))| (from < to).then_some((y, from, to)))
    }
}

/// The first pixels whose centres are not left of an edge, row by row.
struct Crossings {
    /// The pixel is `whole`, and the crossing is `part` of `parts` further.
    whole: i64,
    part: i64,
    parts: i64,
    /// Increments per row.
    whole_step: i64,
    part_step: i64,
}

impl Crossings {
    /// For the edge from `a` down to `b`, starting at row `y`.
    #[inline]
    fn new(a: (i32, i32), b: (i32, i32), y: i32) -> Self {
        let wide = |(x, y): (i32, i32)| (i64::from(x), i64::from(y));
        let ((ax, ay), (bx, by)) = (wide(a), wide(b));
        let (dx, dy) = (bx - ax, by - ay);
        let steps = i64::from(STEPS);
        let half = steps / 2;
        let parts = dy * steps;
        let inverse = 1.0 / parts as f64;
        // Coordinates have 29 bits, so the products fit. Rounded up, because a centre on the edge
        // is not left of it.
        let middle = i64::from(y) * steps + half;
        let (whole, part) = divided(
            (ax - half) * dy + (middle - ay) * dx + parts - 1,
            parts,
            inverse,
        );
        let (whole_step, part_step) = divided(dx * steps, parts, inverse);
        Self {
            whole,
            part,
            parts,
            whole_step,
            part_step,
        }
    }

    #[inline]
    fn next(&mut self) -> i64 {
        let x = self.whole;
        self.whole += self.whole_step;
        self.part += self.part_step;
        let over = self.part >= self.parts;
        self.whole += i64::from(over);
        self.part -= if over { self.parts } else { 0 };
        x
    }
}

/// Quotient and non-negative remainder. 64-bit division is slow; with the inverse the quotient is
/// nearly right and then corrected.
#[inline]
fn divided(number: i64, by: i64, inverse: f64) -> (i64, i64) {
    let mut whole = (number as f64 * inverse) as i64;
    let mut rest = number - whole * by;
    while rest < 0 {
        rest += by;
        whole -= 1;
    }
    while rest >= by {
        rest -= by;
        whole += 1;
    }
    (whole, rest)
}
