//! From an edit to its record. All checks are here, so that an edit is done wholly or not at all.

use glam::DVec3;

use super::change::{Change, IDLE, Prepared, State};
use super::edit::{Edit, Selection};
use super::edited_scene;
use super::normalise::{check_all_orientations, count_orientations, normalise_point};
use super::place;
use super::scene_edit;
use super::set::{self, checked, orientation, point, view, with_frames};
use super::target;
use super::whole::{exchanged_scene, replaced, scene_in};
use crate::error::{End, Place, Refused, Result, TooMany, vec_with_room};
use vides_engine::limits;
use vides_engine::path::fit_frames::fit_frames;
use vides_engine::path::insertion::{self, Insertion};
use vides_engine::path::space::Move;
use vides_engine::path::{CameraPath, Orientation, Space, SupportPoint, Target, Timeline};
use vides_engine::path::{ahead, change_up};
use vides_engine::property::SameBits;
use vides_engine::scene::Scene;
use vides_engine::tools::{block, transform};

pub(super) fn prepare(state: &State, edit: Edit) -> Result<Prepared> {
    let none_edited = matches!(&state.edited_scene, Some(edited) if edited.node().is_none());
    if none_edited && edit.needs_path() {
        return Err(Refused::NoPathEdited.into());
    }
    let path = &state.path;
    match edit {
        Edit::InsertPoint { at, position } => insert_point(state, at, position),
        Edit::AppendAfterLast => beyond(state, End::Last),
        Edit::PrependBeforeFirst => beyond(state, End::First),
        Edit::DivideSegment { segment, points } => {
            let mut room = [DVec3::ZERO; limits::MAX_DIVISION];
            let positions = place::divide(path, segment, points, &mut room)?;
            Ok(inserted(segment + 1, copies(state, segment, positions)?))
        }
        Edit::InsertOnCurve { frame } => on_curve(state, frame),
        Edit::FitFrames {
            first,
            last,
            frames,
        } => fitted(path, first, last, frames),
        Edit::RemovePoint { at } => remove_point(path, at),
        Edit::MovePoint { from, to } => {
            point(path, from)?;
            point(path, to)?;
            Ok((Change::MovePoint(from, to), Some(Selection::at(to, 0))))
        }
        Edit::Set {
            place,
            property,
            value,
        } => set::set(state, place, property, value),
        Edit::InsertOrientation {
            point,
            at,
            orientation,
        } => new_orientation(state, point, at, orientation),
        Edit::RemoveOrientation { point, at } => remove_orientation(path, point, at),
        Edit::SetOrientation {
            point,
            at,
            orientation: new,
        } => alone(view(path, point, at, new)?),
        Edit::SetAbsolute {
            point,
            at,
            absolute,
        } => aimed(path, point, at, absolute),
        Edit::SetInfo(mut info) => {
            state.check_info(&info)?;
            info.normalise();
            alone(Change::info(info))
        }
        Edit::EditNode(node) => other_node(state, node),
        Edit::Part(part) => scene_edit::prepare(state, |edits| edits.part(*part)),
        Edit::AddNodes(nodes) => scene_edit::prepare(state, |edits| edits.add(nodes)),
        Edit::CopyNodes(nodes) => scene_edit::prepare(state, |edits| edits.copy(&nodes)),
        Edit::SetParent { node, parent, keep } => {
            scene_edit::prepare(state, |edits| edits.parent(node, parent, keep))
        }
        Edit::RenameMarker { from, to } => {
            scene_edit::prepare(state, |edits| edits.rename_marker(from, to))
        }
        Edit::ReplaceScene(scene) => replaced_scene(state, *scene),
        Edit::ReplacePath(path) => replaced(state, *path, |point| point),
        Edit::TransformPoints {
            points,
            matrix,
            with_targets,
        } => exchanged(transform::transform(path, &points, &matrix, with_targets)?),
        Edit::DeformPoints {
            points,
            deformation,
            bounds,
            with_targets: targets,
        } => exchanged(transform::deform(
            path,
            &points,
            &deformation,
            bounds,
            targets,
        )?),
        Edit::InsertPath {
            at,
            block,
            fit,
            with_targets,
        } => insert_block(state, block::insert(path, at, &block, fit, with_targets)?),
        Edit::Reverse => reversed(state),
        Edit::Repeat(times) => replaced(state, block::repeat(path, times)?, |point| point),
        Edit::SetSpace { space, fit } => in_other_space(state, space, fit),
        Edit::ChangeUp(up) if up == path.space.up => Ok((IDLE, None)),
        Edit::ChangeUp(up) => {
            let changed = change_up::change_up(path, up)?;
            alone(replaced(state, changed, |point| point)?.0)
        }
    }
}

/// A record that leaves the selection.
const fn alone(change: Change) -> Result<Prepared> {
    Ok((change, None))
}

fn insert_point(state: &State, at: usize, position: DVec3) -> Result<Prepared> {
    let last = state.path.points.len();
    if at > last {
        return Err(Refused::NewPoint { at, last }.into());
    }
    Ok(inserted(
        at,
        copies(state, at.saturating_sub(1), &[position])?,
    ))
}

/// The record of a point beyond an end.
fn beyond(state: &State, end: End) -> Result<Prepared> {
    let at = match end {
        End::First => 0,
        End::Last => state.path.points.len(),
    };
    insert_point(state, at, place::beyond(&state.path, end)?)
}

fn remove_point(path: &CameraPath, at: usize) -> Result<Prepared> {
    point(path, at)?;
    if path.points.len() <= limits::MIN_POINTS {
        return Err(Refused::TwoPointsRemain.into());
    }
    Ok((
        Change::Splice(at, 1, vec_with_room(1)?, 0),
        Some(Selection::at(at.saturating_sub(1), 0)),
    ))
}

fn remove_orientation(path: &CameraPath, point: usize, at: usize) -> Result<Prepared> {
    orientation(path, point, at)?;
    if path.points[point].orientations.len() == 1 {
        return Err(Refused::OneOrientationRemains.into());
    }
    let change = Change::View([point, at], true, None, 0);
    Ok((change, Some(Selection::at(point, at.saturating_sub(1)))))
}

/// The record of aiming at a place, or in a direction.
fn aimed(path: &CameraPath, point: usize, at: usize, absolute: bool) -> Result<Prepared> {
    let mut orientation = no_longer_ahead(path, point, at)?;
    let position = path.points[point].position;
    orientation.target = target::switched(orientation.target, position, absolute, path.space)?;
    alone(Change::View([point, at], true, Some(orientation), 0))
}

fn replaced_scene(state: &State, scene: Scene) -> Result<Prepared> {
    let (edited, path) = edited_scene::as_shown(scene)?;
    state.info.check(edited.scene().space())?;
    let edited = Some(edited).filter(|edited| !edited.is_path_alone());
    exchanged_scene(edited, path, state.comments.of_file()?)
}

fn reversed(state: &State) -> Result<Prepared> {
    let path = &state.path;
    let count = path.points.len();
    // A closed path still begins at its first point.
    let begin = if path.closed { count } else { count - 1 };
    replaced(state, block::reverse(path)?, |point| {
        (begin - point) % count
    })
}

/// The record of another space; `fit`: what is there is mapped into it.
fn in_other_space(state: &State, space: Space, fit: bool) -> Result<Prepared> {
    let path = &state.path;
    space.check()?;
    state.info.check(space)?;
    let change = if fit && path.space != space {
        moved(path, space)?
    } else {
        path.check_in(space)?;
        in_space(path, space)?
    };
    match &state.edited_scene {
        // A scene that lies where its path does goes along.
        Some(edited) if edited.scene().space() == path.space => {
            scene_in(edited, path, &state.comments, space, fit)
        }
        _ => alone(change),
    }
}

/// The record of setting the space alone.
fn in_space(path: &CameraPath, space: Space) -> Result<Change> {
    if path.space.same_bits(&space) {
        return Ok(IDLE);
    }
    let points = Vec::new();
    Change::settings(CameraPath {
        space,
        points,
        ..*path
    })
}

fn other_node(state: &State, node: Option<usize>) -> Result<Prepared> {
    if state.edited_scene.is_some() {
        return scene_edit::prepare(state, |edits| edits.edit_node(node));
    }
    match node {
        Some(0) => Ok((IDLE, None)),
        _ => Err(Refused::NoScene.into()),
    }
}

fn exchanged(points: transform::Changed) -> Result<Prepared> {
    let mut changes = vec_with_room(points.len())?;
    for (at, point) in points {
        changes.push(Change::Point(at, point));
    }
    alone(Change::Several(changes))
}

fn insert_block(state: &State, inserted: block::Inserted) -> Result<Prepared> {
    let block::Inserted {
        at,
        count,
        mut path,
        changed,
    } = inserted;
    let orientations = count_orientations(&path.points) - state.orientations;
    check_room(state, count, orientations)?;
    let mut take = |at: usize| std::mem::replace(&mut path.points[at], SupportPoint::nowhere());
    let mut changes = vec_with_room(1 + changed.len())?;
    if count > 0 {
        let mut points = vec_with_room(count)?;
        points.extend((at..at + count).map(&mut take));
        points.iter_mut().for_each(normalise_point);
        changes.push(Change::Splice(at, 0, points, 0));
    }
    for at in changed {
        let point = take(at);
        changes.push(Change::Point(at, point));
    }
    Ok((
        Change::Several(changes),
        Some(Selection::at(at.min(path.points.len() - 1), 0)),
    ))
}

/// The orientation with a view ahead along the path replaced by an equal relative target.
///
/// # Errors
/// `ErrorKind::Range` if there is no such orientation; `ErrorKind::Memory`.
pub fn no_longer_ahead(path: &CameraPath, point: usize, at: usize) -> Result<Orientation> {
    let mut new = orientation(path, point, at)?.clone();
    if new.own.ahead.is_some() {
        let far = new.target.offset_from(path.points[point].position).length();
        new.target = Target::Relative(ahead::view(path, point, at) * far);
        new.own = new.own.with(|own| own.ahead = None)?;
    }
    Ok(new)
}

/// The record of an inserted point that keeps the motion.
fn on_curve(state: &State, frame: f64) -> Result<Prepared> {
    check_room(state, 1, 1)?;
    let Insertion { at, path, changed } = insertion::on_curve(&state.path, frame)?;
    let count = 1;
    insert_block(
        state,
        block::Inserted {
            at,
            count,
            path,
            changed,
        },
    )
}

/// The record of mapping the path into another space.
fn moved(path: &CameraPath, space: Space) -> Result<Change> {
    let to = Move::new(path.space, space);
    let mut changes = vec_with_room(1 + path.points.len())?;
    changes.push(in_space(path, space)?);
    for (at, point) in path.points.iter().enumerate() {
        let point = to.point(point)?;
        let checked = point.check(space);
        checked.map_err(|error| error.at(Place::Point(at)))?;
        changes.push(Change::Point(at, point));
    }
    Ok(Change::Several(changes))
}

fn fitted(path: &CameraPath, first: usize, last: usize, frames: usize) -> Result<Prepared> {
    let timeline = Timeline::new(path)?;
    let fixed = fit_frames(path, &timeline, first, last, frames)?;
    alone(Change::Several(with_frames(path, fixed)?))
}

fn check_room(state: &State, points: usize, orientations: usize) -> Result<()> {
    if state.path.points.len() + points > limits::MAX_POINTS {
        return Err(TooMany::SupportPoints.into());
    }
    check_all_orientations(state.orientations + orientations)
}

/// Inserts new points; the first becomes current.
fn inserted(at: usize, points: Vec<SupportPoint>) -> Prepared {
    (Change::Splice(at, 0, points, 0), Some(Selection::at(at, 0)))
}

/// New points at `positions` with the properties of point `from`.
fn copies(state: &State, from: usize, positions: &[DVec3]) -> Result<Vec<SupportPoint>> {
    let source = &state.path.points[from];
    let orientations = positions.len() * source.orientations.len();
    check_room(state, positions.len(), orientations)?;
    let mut points = vec_with_room(positions.len())?;
    for &position in positions {
        state.path.space.check_place(position)?;
        let mut orientations = vec_with_room(source.orientations.len())?;
        for old in &source.orientations {
            let mut new = old.clone();
            if new.target == Target::Absolute(position) {
                new.target =
                    target::switched(old.target, source.position, false, state.path.space)?;
            }
            new.own = old.own.for_a_copy()?;
            orientations.push(new);
        }
        let mut new = SupportPoint::nowhere();
        for row in SupportPoint::PROPERTIES
            .iter()
            .filter(|row| row.copied[0] && !row.keys.is_empty())
        {
            (row.take)(&mut new, source);
        }
        (new.position, new.orientations) = (position, orientations);
        points.push(new);
    }
    Ok(points)
}

fn new_orientation(
    state: &State,
    number: usize,
    at: usize,
    given: Option<Orientation>,
) -> Result<Prepared> {
    let point = point(&state.path, number)?;
    let count = point.orientations.len();
    if at > count {
        return Err(Refused::NewOrientation { at, last: count }.into());
    }
    if count == limits::MAX_ORIENTATIONS {
        return Err(TooMany::Orientations.into());
    }
    check_all_orientations(state.orientations + 1)?;
    let orientation = match given {
        None => point.orientations[at.saturating_sub(1)].clone(),
        Some(orientation) => checked(orientation, point.position, state.path.space)?,
    };
    let change = Change::View([number, at], false, Some(orientation), 0);
    Ok((change, Some(Selection::at(number, at))))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::error::ErrorKind;

    #[test]
    fn no_orientation_that_is_missing_looks_elsewhere() {
        let path = CameraPath::default();
        assert!(no_longer_ahead(&path, 1, 0).is_ok());
        for (point, at) in [(2, 0), (0, 1), (usize::MAX, usize::MAX)] {
            let error = no_longer_ahead(&path, point, at).unwrap_err();
            assert_eq!(error.kind(), ErrorKind::Range);
        }
    }
}
