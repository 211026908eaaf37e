//! From the text of a `.vid` file to the points of a path, and where it lies.

use std::iter::once;

use glam::DVec3;

use super::field::Field;
use super::own::{ReadContext, Rows};
use crate::error::{Malformed, Result, TooMany, vec_with_room};
use crate::named::keys;
use vides_engine::limits;
use vides_engine::math::orientation::wrap_degrees;
use vides_engine::path::camera_path::check_name;
use vides_engine::path::{
    Orientation, OrientationOverrides, Overrides, Space, SupportPoint, space,
};
use vides_engine::property::find;
use vides_engine::shared_list::SharedList;

pub(super) fn points(
    array: Field<'_>,
    points: &mut SharedList<SupportPoint>,
    so_far: &mut ReadContext,
    space: Space,
) -> Result<()> {
    let elements = array.elements()?;
    points.try_reserve(elements.len().min(limits::MAX_POINTS))?;
    for element in elements {
        if points.len() == limits::MAX_POINTS {
            return Err(element.error(TooMany::SupportPoints));
        }
        let point = point(element, space, so_far)?;
        so_far.orientations += point.orientations.len();
        if so_far.orientations > limits::MAX_ALL_ORIENTATIONS {
            return Err(element.error(TooMany::AllOrientations));
        }
        points.push(point);
    }
    Ok(())
}

fn point(table: Field<'_>, space: Space, so_far: &mut ReadContext) -> Result<SupportPoint> {
    // The position first, since targets are checked against it.
    let Some(position) = table.fields()?.find(|field| field.key == "position") else {
        // It may be misspelt.
        let known: Vec<_> = point_keys().chain(once("orientation")).collect();
        let odd = table.fields()?.find(|field| !known.contains(&field.key));
        let missing = || table.error(Malformed::NoPosition);
        return Err(odd.map_or_else(missing, |field| field.unknown(&known)));
    };
    let mut point = SupportPoint {
        position: position.place_in(space)?,
        ..SupportPoint::NEW
    };
    let mut rows = Rows::default();
    for field in table.fields()? {
        if field.key == "orientation" {
            point.orientations = orientations(field, point.position, space, so_far)?;
        } else if !rows.read(field, SupportPoint::PROPERTIES, &mut point, space, so_far)? {
            return Err(field.unknown(&point_keys().chain(once("orientation")).collect::<Vec<_>>()));
        }
    }
    if point.orientations.is_empty() {
        point.orientations = orientations_of_new_point(space)?;
    }
    Ok(point)
}

fn orientations_of_new_point(space: Space) -> Result<Vec<Orientation>> {
    let mut orientations = vec_with_room(1)?;
    orientations.push(Orientation::new_in(space));
    Ok(orientations)
}

fn orientations(
    array: Field<'_>,
    position: DVec3,
    space: Space,
    so_far: &mut ReadContext,
) -> Result<Vec<Orientation>> {
    let elements = array.elements()?;
    let mut orientations = vec_with_room(elements.len().min(limits::MAX_ORIENTATIONS))?;
    for element in elements {
        if orientations.len() == limits::MAX_ORIENTATIONS {
            return Err(element.error(TooMany::Orientations));
        }
        orientations.push(orientation(element, position, space, so_far)?);
    }
    Ok(orientations)
}

fn orientation(
    table: Field<'_>,
    position: DVec3,
    space: Space,
    so_far: &mut ReadContext,
) -> Result<Orientation> {
    let mut orientation = Orientation::new_in(space);
    read_view(table.fields()?, &mut orientation, position, space, so_far)?;
    Ok(orientation)
}

/// Reads fields of an orientation; missing ones are unchanged.
fn read_view<'a>(
    fields: impl Iterator<Item = Field<'a>>,
    into: &mut Orientation,
    position: DVec3,
    space: Space,
    so_far: &mut ReadContext,
) -> Result<()> {
    let mut rows = Rows::default();
    let mut own: Option<OrientationOverrides> = None;
    for field in fields {
        if find(OrientationOverrides::PROPERTIES, field.key).is_some() {
            let own = own.get_or_insert_with(|| OrientationOverrides::clone(&into.own));
            rows.read(field, OrientationOverrides::PROPERTIES, own, space, so_far)?;
        } else if !rows.read(field, Orientation::PROPERTIES, into, space, so_far)? {
            return Err(field.unknown(&view_keys().collect::<Vec<_>>()));
        } else if matches!(field.key, "target" | "offset") {
            field.checked(into.target.check(position, space))?;
        }
    }
    into.roll = wrap_degrees(into.roll);
    if let Some(read) = own {
        into.own = Overrides::NOTHING.with(|own| *own = read)?;
    }
    Ok(())
}

/// The keys of an orientation.
pub(crate) fn view_keys() -> impl Iterator<Item = &'static str> {
    keys::<Orientation>().chain(keys::<OrientationOverrides>())
}

/// The keys of a point, except its orientations.
pub(crate) fn point_keys() -> impl Iterator<Item = &'static str> {
    keys::<SupportPoint>()
}

/// A space; only that of a whole file has a unit.
pub(super) fn space(
    table: Field<'_>,
    space: &mut Space,
    mut unit: Option<&mut String>,
) -> Result<()> {
    for field in table.fields()? {
        match (field.key, &mut unit) {
            ("centre", _) => space.centre = DVec3::from_array(field.numbers()?),
            ("half_size", _) => {
                space.half_size = field.number()?;
                field.checked(space::check_half_size(space.half_size))?;
            }
            ("up", _) => space.up = field.choice()?,
            ("unit", Some(unit)) => **unit = one_line(field)?,
            ("scale" | "origin", _) => {
                return Err(field.error(Malformed::Space));
            }
            (_, Some(_)) => return Err(field.unknown(&["centre", "half_size", "unit", "up"])),
            (_, None) => return Err(field.unknown(&["centre", "half_size", "up"])),
        }
    }
    table.checked(space.check())
}

pub(super) fn one_line(field: Field<'_>) -> Result<String> {
    let line = field.text()?;
    field.checked(check_name(line))?;
    Ok(line.to_owned())
}
