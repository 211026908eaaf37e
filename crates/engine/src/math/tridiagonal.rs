//! Tridiagonal equations by elimination without pivots, which diagonally dominant rows do not need.

use std::ops::{Add, Div, Mul, Sub};

/// One equation for three neighbouring unknowns. The first `lower` and the last `upper` of a chain
/// are read by [`solve_periodic`] alone.
pub(crate) struct Row<T> {
    lower: f64,
    diagonal: f64,
    upper: f64,
    /// The right side, then the unknown.
    pub right: T,
    /// A second right side: what each unit of a periodic chain's joint adds.
    share: f64,
}

impl<T> Row<T> {
    pub(crate) const fn new([lower, diagonal, upper]: [f64; 3], right: T) -> Self {
        Self {
            lower,
            diagonal,
            upper,
            right,
            share: 0.0,
        }
    }
}

/// What a right side is made of.
pub(crate) trait Side:
    Copy
    + Default
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<f64, Output = Self>
    + Div<f64, Output = Self>
{
}

impl Side for f64 {}
impl Side for glam::DVec3 {}

/// Puts the unknowns in the places of the right sides.
pub(crate) fn solve<T: Side>(rows: &mut [Row<T>]) {
    for k in 1..rows.len() {
        let (done, rest) = rows.split_at_mut(k);
        let (above, row) = (&done[k - 1], &mut rest[0]);
        let factor = row.lower / above.diagonal;
        row.diagonal -= factor * above.upper;
        row.right = row.right - above.right * factor;
        row.share -= factor * above.share;
    }
    let (mut right, mut share) = (T::default(), 0.0);
    for row in rows.iter_mut().rev() {
        right = (row.right - right * row.upper) / row.diagonal;
        share = (row.share - share * row.upper) / row.diagonal;
        (row.right, row.share) = (right, share);
    }
}

/// The same where a joint is beside both ends of the chain; gives the joint's unknown. The chain is
/// solved first, up to the joint's share in it.
pub(crate) fn solve_periodic<T: Side>(rows: &mut [Row<T>], mut joint: Row<T>) -> T {
    if let Some(first) = rows.first_mut() {
        first.share -= first.lower;
    }
    if let Some(last) = rows.last_mut() {
        last.share -= last.upper;
    }
    solve(rows);
    let beside = [(rows.first(), joint.upper), (rows.last(), joint.lower)];
    for (row, factor) in beside {
        if let Some(row) = row {
            joint.right = joint.right - row.right * factor;
            joint.diagonal += row.share * factor;
        }
    }
    let found = joint.right / joint.diagonal;
    for row in rows {
        row.right = row.right + found * row.share;
    }
    found
}
