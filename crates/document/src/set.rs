//! Edits that set a property, or all values of an orientation.

use std::sync::Arc;

use glam::DVec3;

use super::content::Content;
use super::edit::At;
use super::info::Info;
use super::named::{keys, no_property};
use super::scene_edit;
use crate::error::{Error, OutOfRange, Refused, Result};
use vides_engine::limits;
use vides_engine::math::orientation::wrap_degrees;
use vides_engine::path::{
    CameraPath, Orientation, OrientationOverrides, Pace, Space, SupportPoint, Target, Timeline,
};
use vides_engine::property::{Property, Table, Value, find};
use vides_engine::scene::{Part, Rest, Values};
use vides_engine::shared_list::SharedList;

/// Sets a property.
pub(super) fn set(
    content: &mut Content,
    place: At,
    property: &'static str,
    mut value: Value,
) -> Result<()> {
    let path = &*content.path;
    if value == Value::Text(String::new()) {
        value = Value::Unset;
    }
    match place {
        At::Path if find(Info::PROPERTIES, property).is_some() => {
            return set_info(content, property, value);
        }
        At::Path => {
            let settings = CameraPath {
                points: SharedList::new(),
                ..*path
            };
            if let Some(settings) = changed(path, settings, property, &mut value, path.space)? {
                let points = path.points.try_clone()?;
                content.path = Arc::new(CameraPath { points, ..settings });
            }
        }
        At::Point(at) => {
            let there = point(path, at)?;
            if let ("position", Value::Place(position)) = (property, &value) {
                check_position(there, at, *position, path.space)?;
            }
            let mut own = there.clone();
            // Tangents that are set are the user's.
            own.keeps_motion &= property != "tangents";
            if let Some(point) = changed(there, own, property, &mut value, path.space)? {
                content.set_point(at, point);
            }
        }
        At::View(point, at) => {
            let mut new = orientation(path, point, at)?.clone();
            if find(OrientationOverrides::PROPERTIES, property).is_some() {
                let mut own = OrientationOverrides::clone(&new.own);
                exchange(&mut own, property, &mut value, &OrientationOverrides::NEW)?;
                new.own = new.own.with(|there| *there = own)?;
            } else {
                let fresh = Orientation::new_in(path.space);
                let row = exchange(&mut new, property, &mut value, &fresh)?;
                if row.key() == "target" {
                    new.own = new.own.with(|own| own.ahead = None)?;
                }
            }
            return set_view(content, point, at, new);
        }
        At::Node(node) => {
            let part = rest(content, node, property, value)?;
            return scene_edit::edit(content, |content| scene_edit::part(content, part));
        }
    }
    Ok(())
}

/// What a node has where nothing moves it, with a property set.
fn rest(content: &Content, node: usize, property: &'static str, mut value: Value) -> Result<Part> {
    let edited = content.scene.as_ref().ok_or(Refused::NoScene)?;
    let mut rest = Box::new(Rest::of(edited.scene().node(node)?));
    let row = exchange(&mut rest.values, property, &mut value, &Values::NEW)?;
    (row.check)(&rest.values, content.path.space)?;
    Ok(Part::Rest { node, rest })
}

/// Sets what the file has besides the path.
fn set_info(content: &mut Content, property: &'static str, mut value: Value) -> Result<()> {
    let mut info = Info::clone(&content.info);
    let row = exchange(&mut info, property, &mut value, &Info::NEW)?;
    content.check_info(&info)?;
    if !(row.same)(&info, &content.info) {
        content.info = Arc::new(info);
    }
    Ok(())
}

/// Exchanges a property for a value; one that is not set is that of `new`.
pub(super) fn exchange<T: Table>(
    of: &mut T,
    property: &'static str,
    value: &mut Value,
    new: &T,
) -> Result<&'static Property<T>> {
    let row = find(T::PROPERTIES, property);
    let row = row.ok_or_else(|| no_property(property, keys::<T>()))?;
    if *value == Value::Unset {
        *value = (row.value)(new);
    }
    match (row.exchange)(of, value) {
        true => Ok(row),
        false => Err(Refused::NotOfKind(property, row.kind(property)).into()),
    }
}

/// `own`, a copy of `there`, with a checked value; none if nothing changes.
fn changed<T: Table>(
    there: &T,
    mut own: T,
    property: &'static str,
    value: &mut Value,
    space: Space,
) -> Result<Option<T>> {
    let row = exchange(&mut own, property, value, &T::NEW)?;
    (row.check)(&own, space)?;
    let same = |row: &Property<T>| row.keys.is_empty() || (row.same)(&own, there);
    Ok((!T::PROPERTIES.iter().all(same)).then_some(own))
}

/// Sets all values of an orientation.
pub(super) fn set_view(
    content: &mut Content,
    point: usize,
    at: usize,
    new: Orientation,
) -> Result<()> {
    let path = &content.path;
    let old = orientation(path, point, at)?;
    let new = checked(new, path.points[point].position, path.space)?;
    let new = without_the_outdated(old, new)?;
    check_frames(path, [point, at], &new)?;
    content.set_view([point, at], new);
    Ok(())
}

/// Refuses frames and holds that grow beyond what a path can count.
fn check_frames(path: &CameraPath, [point, at]: [usize; 2], new: &Orientation) -> Result<()> {
    let given = |view: &Orientation| view.own.frames as usize + view.hold as usize;
    let old = given(&path.points[point].orientations[at]);
    if given(new) <= old {
        return Ok(());
    }
    // What the other sections have by their length is counted only near the limit.
    let views = path.points.iter().flat_map(|point| &point.orientations);
    let all = views.map(given).sum::<usize>() - old + given(new);
    if all <= limits::MAX_FRAMES / 2 {
        return Ok(());
    }
    let mut changed = path.try_clone()?;
    changed.points[point].orientations[at] = new.clone();
    Timeline::new(&changed)?.frame_count()?;
    Ok(())
}

/// Checks an orientation and wraps its roll into (−180, 180].
pub(super) fn checked(
    mut orientation: Orientation,
    position: DVec3,
    space: Space,
) -> Result<Orientation> {
    orientation.check(position, space)?;
    orientation.roll = wrap_degrees(orientation.roll);
    Ok(orientation)
}

/// Drops what an orientation owned for values that change, unless it is set in the same edit.
fn without_the_outdated(old: &Orientation, mut new: Orientation) -> Result<Orientation> {
    if new.own.is_empty() || new.own != old.own {
        return Ok(new);
    }
    let seen = new.target == old.target && new.roll == old.roll && new.turning == old.turning;
    let (zoomed, paced) = (new.zoom != old.zoom, new.speeds != old.speeds);
    new.own = new.own.with(|own| {
        if !seen {
            own.velocities = None;
            own.turning = None;
            own.roll_slope = None;
        }
        if zoomed {
            own.zoom_slope = None;
        }
        if paced && matches!(own.pace, Pace::Part(_)) {
            own.pace = Pace::Speeds;
        }
    })?;
    Ok(new)
}

pub(super) fn check_position(
    point: &SupportPoint,
    at: usize,
    position: DVec3,
    space: Space,
) -> Result<()> {
    space.check_place(position)?;
    for (index, orientation) in point.orientations.iter().enumerate() {
        if orientation.target == Target::Absolute(position) {
            return Err(Refused::OnTarget {
                point: at,
                orientation: index,
            }
            .into());
        }
    }
    Ok(())
}

pub(super) fn point(path: &CameraPath, at: usize) -> Result<&SupportPoint> {
    path.points.get(at).ok_or_else(|| {
        Error::from(OutOfRange::NoPoint {
            point: at,
            last: path.points.len() - 1,
        })
    })
}

pub(super) fn orientation(path: &CameraPath, number: usize, at: usize) -> Result<&Orientation> {
    let point = point(path, number)?;
    point.orientations.get(at).ok_or_else(|| {
        Error::from(Refused::NoOrientation {
            orientation: at,
            point: number,
            last: point.orientations.len() - 1,
        })
    })
}
