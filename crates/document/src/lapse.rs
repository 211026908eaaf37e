//! Tangents that keep the motion of an insertion: what they keep is over when their point or one
//! neighbour moves, comes or goes. They are removed then, and the curve follows as it does
//! elsewhere.

use std::collections::HashMap;
use std::sync::Arc;

use glam::DVec3;

use super::edit::{At, Edit};
use vides_engine::path::CameraPath;

/// Whether it moves points, or gives some another neighbour. What replaces the whole path or
/// inserts another one has its own tangents.
pub(super) fn moves_points(edit: &Edit) -> bool {
    match edit {
        Edit::Set {
            place: At::Point(_),
            property,
            ..
        } => *property == "position",
        Edit::InsertPoint { .. }
        | Edit::AppendAfterLast
        | Edit::PrependBeforeFirst
        | Edit::DivideSegment { .. }
        | Edit::RemovePoint { .. }
        | Edit::MovePoint { .. }
        | Edit::TransformPoints { .. }
        | Edit::DeformPoints { .. } => true,
        _ => false,
    }
}

/// Removes the tangents that such an edit has ended, by which `old` became `path`.
pub(super) fn lapse(old: &CameraPath, path: &mut Arc<CameraPath>) {
    // Elsewhere every point and its neighbours are as they were.
    let ([now, _], last) = (path.points.difference(&old.points), path.points.len() - 1);
    let around = now.start.saturating_sub(1)..(now.end + 1).min(last + 1);
    let over_the_end = [
        (now.start == 0).then_some(last),
        (now.end > last).then_some(0),
    ];
    let near = around.chain(over_the_end.into_iter().flatten());
    let near: Vec<usize> = near.filter(|&at| path.points[at].keeps_motion).collect();
    if near.is_empty() {
        return;
    }
    let known = old.points.shared().map(Arc::as_ptr);
    let known: HashMap<_, usize> = known.zip(0..).collect();
    // Where none came or went, one that is not known has been changed in its place.
    let in_place = old.points.len() == path.points.len();
    let before = |at: usize| {
        let same = known.get(&Arc::as_ptr(path.points.get_shared(at)));
        same.copied().or(in_place.then_some(at))
    };
    let moved = |at: usize| {
        let then = before(at).map(|at| old.points[at].position);
        then.is_some_and(|then| is_move(then, path.points[at].position))
    };
    let lapsed = near.into_iter().filter(|&at| {
        let Some(was) = before(at) else {
            return false;
        };
        let (now, then) = (beside(path, at), beside(old, was));
        if now.map(|beside| beside.map(before)) != then.map(|beside| beside.map(Some)) {
            return true;
        }
        let mut around = now.into_iter().flatten().chain([at]);
        around.clone().any(moved) && !around.all(moved)
    });
    let lapsed: Vec<usize> = lapsed.collect();
    for at in lapsed {
        let point = &mut Arc::make_mut(path).points[at];
        point.tangents = None;
        point.keeps_motion = false;
    }
}

/// The points before and behind one.
fn beside(path: &CameraPath, at: usize) -> [Option<usize>; 2] {
    let last = path.points.len() - 1;
    let around = |at: usize| path.closed.then_some(at);
    [
        at.checked_sub(1).or_else(|| around(last)),
        Some(at + 1).filter(|&at| at <= last).or_else(|| around(0)),
    ]
}

/// Whether two places differ by more than the rounding of a sum.
fn is_move(from: DVec3, to: DVec3) -> bool {
    let rounding = 8.0 * f64::EPSILON * from.abs().max(to.abs());
    (to - from).abs().cmpgt(rounding).any()
}
