//! From an edit that sets a property, or all values of an orientation, to its record.

use glam::DVec3;

use super::change::{Change, IDLE, Prepared, State};
use super::edit::At;
use super::info::{Info, copy_text};
use super::named::{keys, no_property};
use super::scene_edit;
use crate::error::{Error, OutOfRange, Refused, Result, can_allocate, vec_with_room};
use vides_engine::math::orientation::wrap_degrees;
use vides_engine::path::fit_frames::Fixed;
use vides_engine::path::{
    CameraPath, Orientation, OrientationOverrides, Pace, Space, SupportPoint, Target,
};
use vides_engine::property::{Property, Table, Value, find};
use vides_engine::scene::{Part, Rest, Values};

/// The record of setting a property.
pub(super) fn set(
    state: &State,
    place: At,
    property: &'static str,
    mut value: Value,
) -> Result<Prepared> {
    let path = &state.path;
    if value == Value::Text(String::new()) {
        value = Value::Unset;
    }
    let change = match place {
        At::Path if find(Info::PROPERTIES, property).is_some() => set_info(state, property, value)?,
        At::Path => {
            let points = Vec::new();
            let own = CameraPath { points, ..*path };
            match changed(path, own, property, &mut value, path.space)? {
                Some(settings) => Change::settings(settings)?,
                None => IDLE,
            }
        }
        At::Point(at) => {
            let there = point(path, at)?;
            if let ("position", Value::Place(position)) = (property, &value) {
                check_position(there, at, *position, path.space)?;
            }
            let name = there.name.as_deref().map(copy_text).transpose()?;
            let orientations = Vec::new();
            let own = SupportPoint {
                name,
                orientations,
                ..*there
            };
            let point = changed(there, own, property, &mut value, path.space)?;
            point.map_or(IDLE, |point| Change::Point(at, point))
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
            view(path, point, at, new)?
        }
        At::Node(node) => {
            let part = rest(state, node, property, value)?;
            return scene_edit::prepare(state, |edits| edits.part(part));
        }
    };
    Ok((change, None))
}

/// What a node has where nothing moves it, with a property set.
fn rest(state: &State, node: usize, property: &'static str, mut value: Value) -> Result<Part> {
    let edited = state.edited_scene.as_ref().ok_or(Refused::NoScene)?;
    let mut rest = Rest::of(edited.scene().node(node)?);
    let row = exchange(&mut rest.values, property, &mut value, &Values::NEW)?;
    (row.check)(&rest.values, state.path.space)?;
    can_allocate(size_of::<Rest>())?;
    Ok(Part::Rest {
        node,
        rest: Box::new(rest),
    })
}

/// That of setting what the file has besides the path.
fn set_info(state: &State, property: &'static str, mut value: Value) -> Result<Change> {
    let mut info = Box::new(state.info.try_clone()?);
    let row = exchange(&mut *info, property, &mut value, &Info::NEW)?;
    state.check_info(&info)?;
    Ok(match (row.same)(&info, &state.info) {
        true => IDLE,
        false => Change::info(info),
    })
}

/// Exchanges a property for a value; one that is not set is that of `new`.
fn exchange<T: Table>(
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

/// What is there with a checked value, `own` being a copy of it; none if it has it.
fn changed<T: Table>(
    there: &T,
    mut own: T,
    property: &'static str,
    value: &mut Value,
    space: Space,
) -> Result<Option<T>> {
    let row = exchange(&mut own, property, value, &T::NEW)?;
    (row.check)(&own, space)?;
    Ok((!(row.same)(&own, there)).then_some(own))
}

/// The record of setting all values of an orientation.
pub(super) fn view(path: &CameraPath, point: usize, at: usize, new: Orientation) -> Result<Change> {
    let old = orientation(path, point, at)?;
    let new = checked(new, path.points[point].position, path.space)?;
    let orientation = without_the_outdated(old, new)?;
    Ok(Change::View([point, at], true, Some(orientation), 0))
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

pub(super) fn with_frames(path: &CameraPath, fixed: Vec<Fixed>) -> Result<Vec<Change>> {
    let mut changes = vec_with_room(fixed.len())?;
    for fixed in fixed {
        let mut orientation = path.points[fixed.point].orientations[fixed.orientation].clone();
        orientation.own = orientation.own.with(|own| own.frames = fixed.frames)?;
        let place = [fixed.point, fixed.orientation];
        changes.push(Change::View(place, true, Some(orientation), 0));
    }
    Ok(changes)
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
