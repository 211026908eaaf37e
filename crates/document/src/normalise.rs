//! The form in which paths are edited: what a path must be as a whole.

use crate::error::{Result, TooMany};
use vides_engine::limits;
use vides_engine::math::orientation::wrap_degrees;
use vides_engine::path::space::Move;
use vides_engine::path::{CameraPath, Space, SupportPoint};
use vides_engine::shared_list::SharedList;

pub(super) fn count_orientations(points: &SharedList<SupportPoint>) -> usize {
    points.iter().map(|point| point.orientations.len()).sum()
}

/// Maps a path into another space, as far as the spaces differ.
pub(super) fn move_into(path: &mut CameraPath, space: Space) -> Result<()> {
    let to = Move::new(path.space, space);
    if path.space != space {
        for point in &mut path.points {
            *point = to.point(point)?;
        }
    }
    path.space = space;
    Ok(())
}

/// Checks a path and normalises it: rolls in (−180, 180], no empty names.
pub(super) fn normalise(path: &mut CameraPath) -> Result<()> {
    path.check()?;
    check_all_orientations(count_orientations(&path.points))?;
    for at in 0..path.points.len() {
        if !is_normal(&path.points[at]) {
            normalise_point(&mut path.points[at]);
        }
    }
    Ok(())
}

fn is_normal(point: &SupportPoint) -> bool {
    let mut rolls = point.orientations.iter().map(|view| view.roll);
    point.name.as_deref() != Some("")
        && rolls.all(|roll| wrap_degrees(roll).to_bits() == roll.to_bits())
}

pub(super) fn normalise_point(point: &mut SupportPoint) {
    point.name = point.name.take().filter(|name| !name.is_empty());
    for orientation in &mut point.orientations {
        orientation.roll = wrap_degrees(orientation.roll);
    }
}

pub(super) fn check_all_orientations(count: usize) -> Result<()> {
    if count > limits::MAX_ALL_ORIENTATIONS {
        return Err(TooMany::AllOrientations.into());
    }
    Ok(())
}
