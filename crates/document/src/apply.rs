//! Edits as functions: each changes a copy of what the document holds, or says why it cannot be.

use std::sync::Arc;

use glam::DVec3;

use super::content::Content;
use super::edit::{Edit, Selection};
use super::edited_scene;
use super::normalise::{check_all_orientations, count_orientations, move_into, normalise_point};
use super::place;
use super::scene_edit;
use super::set::{self, checked, orientation, point};
use super::target;
use crate::error::{End, Place, Refused, Result, TooMany};
use vides_engine::limits;
use vides_engine::path::fit_frames::Fixed;
use vides_engine::path::insertion::{self, Insertion};
use vides_engine::path::space::Move;
use vides_engine::path::{CameraPath, Orientation, Space, SupportPoint, Target, Timeline, Up};
use vides_engine::path::{ahead, change_up};
use vides_engine::property::SameBits;
use vides_engine::scene::Scene;
use vides_engine::tools::{block, transform};

/// Shares frames among the sections from one point to another.
pub(super) type Share =
    fn(&CameraPath, &Timeline, usize, usize, usize) -> vides_engine::Result<Vec<Fixed>>;

/// Does an edit. After an error `content` may be changed in part and is to be dropped; where nothing
/// changes it shares all with what it was copied from.
pub(super) fn apply(content: &mut Content, edit: Edit, share: Share) -> Result<()> {
    let none_edited = matches!(&content.scene, Some(edited) if edited.node().is_none());
    if none_edited && edit.needs_path() {
        return Err(Refused::NoPathEdited.into());
    }
    let path = &content.path;
    match edit {
        Edit::InsertPoint { at, position } => insert_point(content, at, position),
        Edit::AppendAfterLast => beyond(content, End::Last),
        Edit::PrependBeforeFirst => beyond(content, End::First),
        Edit::DivideSegment { segment, points } => {
            let mut room = [DVec3::ZERO; limits::MAX_DIVISION];
            let positions = place::divide(path, segment, points, &mut room)?;
            let points = copies(content, segment, positions)?;
            content.insert_points(segment + 1, points);
            Ok(())
        }
        Edit::InsertOnCurve { frame } => on_curve(content, frame),
        Edit::FitFrames {
            first,
            last,
            frames,
        } => {
            let timeline = Timeline::new(path)?;
            let fixed = share(path, &timeline, first, last, frames)?;
            content.set_frames(fixed)
        }
        Edit::RemovePoint { at } => {
            point(path, at)?;
            if path.points.len() <= limits::MIN_POINTS {
                return Err(Refused::TwoPointsRemain.into());
            }
            content.remove_point(at);
            Ok(())
        }
        Edit::MovePoint { from, to } => {
            point(path, from)?;
            point(path, to)?;
            content.move_point(from, to);
            Ok(())
        }
        Edit::Set {
            place,
            property,
            value,
        } => set::set(content, place, property, value),
        edit @ (Edit::InsertOrientation { .. }
        | Edit::RemoveOrientation { .. }
        | Edit::SetOrientation { .. }
        | Edit::SetAbsolute { .. }) => apply_to_view(content, edit),
        Edit::SetInfo(mut info) => {
            content.check_info(&info)?;
            info.normalise();
            content.info = Arc::from(info);
            Ok(())
        }
        edit @ (Edit::EditNode(_)
        | Edit::Part(_)
        | Edit::AddNodes(_)
        | Edit::CopyNodes(_)
        | Edit::SetParent { .. }
        | Edit::RenameMarker { .. }
        | Edit::ReplaceScene(_)) => apply_to_scene(content, edit),
        Edit::ReplacePath(path) => content.replace_path(*path, |point| point),
        Edit::TransformPoints {
            points,
            matrix,
            with_targets,
        } => {
            let changed = transform::transform(path, &points, &matrix, with_targets)?;
            set_points(content, changed)
        }
        Edit::DeformPoints {
            points,
            deformation,
            bounds,
            with_targets,
        } => {
            let changed = transform::deform(path, &points, &deformation, bounds, with_targets)?;
            set_points(content, changed)
        }
        Edit::InsertPath {
            at,
            block,
            fit,
            with_targets,
        } => {
            let inserted = block::insert(path, at, &block, fit, with_targets)?;
            insert_block(content, inserted)
        }
        Edit::Reverse => reverse(content),
        Edit::Repeat(times) => content.replace_path(block::repeat(path, times)?, |point| point),
        Edit::SetSpace { space, fit } => set_space(content, space, fit),
        Edit::ChangeUp(up) if up == path.space.up => Ok(()),
        Edit::ChangeUp(up) => change_up(content, up),
    }
}

/// Does an edit of an orientation.
fn apply_to_view(content: &mut Content, edit: Edit) -> Result<()> {
    let path = &content.path;
    match edit {
        Edit::InsertOrientation {
            point,
            at,
            orientation,
        } => new_orientation(content, point, at, orientation),
        Edit::RemoveOrientation { point, at } => {
            orientation(path, point, at)?;
            if path.points[point].orientations.len() == 1 {
                return Err(Refused::OneOrientationRemains.into());
            }
            content.remove_view([point, at]);
            Ok(())
        }
        Edit::SetOrientation {
            point,
            at,
            orientation: new,
        } => set::set_view(content, point, at, new),
        Edit::SetAbsolute {
            point,
            at,
            absolute,
        } => {
            let mut view = no_longer_ahead(path, point, at)?;
            let position = path.points[point].position;
            view.target = target::switched(view.target, position, absolute, path.space)?;
            content.set_view([point, at], view);
            Ok(())
        }
        _ => Ok(()),
    }
}

/// Does an edit of the scene.
fn apply_to_scene(content: &mut Content, edit: Edit) -> Result<()> {
    match edit {
        Edit::EditNode(node) => match (&content.scene, node) {
            (Some(_), _) => scene_edit::edit_node(content, node),
            (None, Some(0)) => Ok(()),
            (None, _) => Err(Refused::NoScene.into()),
        },
        Edit::Part(part) => scene_edit::edit(content, |of| scene_edit::part(of, *part)),
        Edit::AddNodes(nodes) => scene_edit::edit(content, |of| scene_edit::add(of, nodes)),
        Edit::CopyNodes(nodes) => scene_edit::edit(content, |of| scene_edit::copy(of, &nodes)),
        Edit::SetParent { node, parent, keep } => {
            scene_edit::edit(content, |of| scene_edit::parent(of, node, parent, keep))
        }
        Edit::RenameMarker { from, to } => {
            scene_edit::edit(content, |of| scene_edit::rename_marker(of, from, to))
        }
        Edit::ReplaceScene(scene) => replace_scene(content, *scene),
        _ => Ok(()),
    }
}

fn insert_point(content: &mut Content, at: usize, position: DVec3) -> Result<()> {
    let last = content.path.points.len();
    if at > last {
        return Err(Refused::NewPoint { at, last }.into());
    }
    let points = copies(content, at.saturating_sub(1), &[position])?;
    content.insert_points(at, points);
    Ok(())
}

/// A point beyond an end.
fn beyond(content: &mut Content, end: End) -> Result<()> {
    let at = match end {
        End::First => 0,
        End::Last => content.path.points.len(),
    };
    let position = place::beyond(&content.path, end)?;
    insert_point(content, at, position)
}

fn replace_scene(content: &mut Content, scene: Scene) -> Result<()> {
    let (edited, path) = edited_scene::as_shown(scene)?;
    content.info.check(edited.scene().space())?;
    content.scene = (!edited.is_path_alone()).then(|| Arc::new(edited));
    content.comments = Arc::new(content.comments.of_file());
    content.put_path(path);
    content.selection = Selection::default();
    Ok(())
}

/// Another space; `fit`: what is there is mapped into it.
fn set_space(content: &mut Content, space: Space, fit: bool) -> Result<()> {
    let path = &content.path;
    space.check()?;
    content.info.check(space)?;
    let mut moved = path.try_clone()?;
    if fit && path.space != space {
        let to = Move::new(path.space, space);
        for (at, point) in path.points.iter().enumerate() {
            let point = to.point(point)?;
            let checked = point.check(space);
            checked.map_err(|error| error.at(Place::Point(at)))?;
            moved.points.set(at, point);
        }
    } else {
        path.check_in(space)?;
    }
    // A scene that lies where its path does goes along, whatever stands upright in either.
    let up = path.space.up;
    let goes_along = |edited: &&Arc<edited_scene::EditedScene>| {
        let there = edited.scene().space();
        path.space == Space { up, ..there }
    };
    if let Some(edited) = content.scene.as_ref().filter(goes_along) {
        let mut moved = path.try_clone()?;
        match fit {
            true => move_into(&mut moved, space)?,
            false => moved.space = space,
        }
        let mut scene = edited.with(&moved)?;
        scene.set_space(space)?;
        let (edited, path) = edited_scene::edit(scene, edited.node())?;
        content.scene = Some(Arc::new(edited));
        content.put_path(path);
    } else if !path.space.same_bits(&space) {
        moved.space = space;
        content.put_path(moved);
    }
    Ok(())
}

fn reverse(content: &mut Content) -> Result<()> {
    let path = &content.path;
    let count = path.points.len();
    // A closed path still begins at its first point.
    let begin = if path.closed { count } else { count - 1 };
    content.replace_path(block::reverse(path)?, |point| (begin - point) % count)
}

/// Another up axis, with the same poses.
fn change_up(content: &mut Content, up: Up) -> Result<()> {
    let changed = change_up::change_up(&content.path, up)?;
    let selection = content.selection;
    content.replace_path(changed, |point| point)?;
    content.selection = selection;
    Ok(())
}

fn set_points(content: &mut Content, points: transform::Changed) -> Result<()> {
    for (at, point) in points {
        content.set_point(at, point);
    }
    Ok(())
}

fn insert_block(content: &mut Content, inserted: block::Inserted) -> Result<()> {
    let block::Inserted {
        at,
        count,
        mut path,
        changed,
    } = inserted;
    let orientations = count_orientations(&path.points) - content.orientations;
    check_room(content, count, orientations)?;
    let selection = Selection::at(at.min(path.points.len() - 1), 0);
    if count > 0 {
        let points = &mut path.points;
        (at..at + count).for_each(|at| normalise_point(&mut points[at]));
        content.insert_points(at, points.shared().skip(at).take(count).cloned().collect());
    }
    for at in changed {
        content.set_point(at, path.points[at].clone());
    }
    content.selection = selection;
    Ok(())
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

/// A point inserted on the curve that keeps the motion.
fn on_curve(content: &mut Content, frame: f64) -> Result<()> {
    check_room(content, 1, 1)?;
    let Insertion {
        at,
        mut path,
        changed,
    } = insertion::on_curve(&content.path, frame)?;
    for &number in changed.iter().chain([&at]) {
        let points = &content.path.points;
        let before = points.get(number - usize::from(number > at));
        let owned = number != at && before.is_some_and(|before| before.tangents.is_some());
        let point = &mut path.points[number];
        point.keeps_motion |= point.tangents.is_some() && !owned;
    }
    let count = 1;
    insert_block(
        content,
        block::Inserted {
            at,
            count,
            path,
            changed,
        },
    )
}

fn check_room(content: &Content, points: usize, orientations: usize) -> Result<()> {
    if content.path.points.len() + points > limits::MAX_POINTS {
        return Err(TooMany::SupportPoints.into());
    }
    check_all_orientations(content.orientations + orientations)
}

/// New points at `positions` with the properties of point `from`.
fn copies(content: &Content, from: usize, positions: &[DVec3]) -> Result<Vec<Arc<SupportPoint>>> {
    let source = &content.path.points[from];
    let space = content.path.space;
    let orientations = positions.len() * source.orientations.len();
    check_room(content, positions.len(), orientations)?;
    let mut points = Vec::new();
    for &position in positions {
        space.check_place(position)?;
        let mut new = SupportPoint::nowhere();
        for old in &source.orientations {
            let mut view = old.clone();
            if view.target == Target::Absolute(position) {
                view.target = target::switched(old.target, source.position, false, space)?;
            }
            view.own = old.own.for_a_copy()?;
            new.orientations.push(view);
        }
        for row in SupportPoint::PROPERTIES
            .iter()
            .filter(|row| row.copied[0] && !row.keys.is_empty())
        {
            (row.take)(&mut new, source);
        }
        new.position = position;
        points.push(Arc::new(new));
    }
    Ok(points)
}

fn new_orientation(
    content: &mut Content,
    number: usize,
    at: usize,
    given: Option<Orientation>,
) -> Result<()> {
    let path = &content.path;
    let point = point(path, number)?;
    let count = point.orientations.len();
    if at > count {
        return Err(Refused::NewOrientation { at, last: count }.into());
    }
    if count == limits::MAX_ORIENTATIONS {
        return Err(TooMany::Orientations.into());
    }
    check_all_orientations(content.orientations + 1)?;
    let view = match given {
        None => point.orientations[at.saturating_sub(1)].clone(),
        Some(orientation) => checked(orientation, point.position, path.space)?,
    };
    content.insert_view([number, at], view);
    Ok(())
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
