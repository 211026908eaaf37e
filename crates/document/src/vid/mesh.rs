//! A mesh in a file: its own points, or the name of a mesh file.

use std::fmt;

use glam::DVec3;
use vides_engine::scene::{Mesh, MeshSource};

use super::field::Field;
use super::mesh_source;
use super::text::{Text, rows};
use crate::error::{Malformed, Result, TooMany, vec_with_room};
use vides_engine::limits;

pub(super) const KEYS: [&str; 4] = ["points", "colours", "lines", "triangles"];

/// Takes a field of a mesh; false if [`KEYS`] does not have it.
pub(super) fn take(field: &Field<'_>, mesh: &mut Mesh) -> Result<bool> {
    match field.key {
        "points" => mesh.points = vectors(*field, limits::MAX_MESH_POINTS)?,
        "colours" => mesh.colours = colours(*field)?,
        "lines" => mesh.lines = indices(*field)?,
        "triangles" => mesh.triangles = indices(*field)?,
        _ => return Ok(false),
    }
    Ok(true)
}

/// A mesh: its own points, or the name of a mesh file.
pub(super) fn read(table: Field<'_>) -> Result<(Option<MeshSource>, Mesh)> {
    let mut mesh = Mesh::default();
    let mut source = mesh_source::Reading::default();
    for field in table.fields()? {
        if !source.take(&field)? && !take(&field, &mut mesh)? {
            let known: Vec<&str> = KEYS.into_iter().chain(mesh_source::KEYS).collect();
            return Err(field.unknown(&known));
        }
    }
    let alone = mesh == Mesh::default();
    Ok((source.done(&table, alone)?, mesh))
}

pub(super) fn vectors(array: Field<'_>, most: usize) -> Result<Vec<DVec3>> {
    let elements = array.elements()?;
    if elements.len() > most {
        return Err(array.error(TooMany::MeshPoints));
    }
    let mut all = vec_with_room(elements.len())?;
    for element in elements {
        all.push(element.vector()?);
    }
    Ok(all)
}

fn indices<const N: usize>(array: Field<'_>) -> Result<Vec<[u32; N]>> {
    let elements = array.elements()?;
    let mut all = vec_with_room(elements.len())?;
    for element in elements {
        let corners = element.elements()?;
        if corners.len() != N {
            return Err(element.error(Malformed::NumberCount {
                wanted: N,
                found: corners.len(),
            }));
        }
        let mut row = [0; N];
        for (index, corner) in row.iter_mut().zip(corners) {
            *index = corner.integer_in(0, u32::MAX.into())? as u32;
        }
        all.push(row);
    }
    Ok(all)
}

pub(super) fn colours(array: Field<'_>) -> Result<Vec<[u8; 3]>> {
    let rows = indices::<3>(array)?;
    let mut all = vec_with_room(rows.len())?;
    for row in rows {
        let byte = |value: u32| {
            u8::try_from(value).map_err(|_| array.error(Malformed::Between { low: 0, high: 255 }))
        };
        all.push([byte(row[0])?, byte(row[1])?, byte(row[2])?]);
    }
    Ok(all)
}

pub(super) fn write(out: &mut Text, mesh: &Mesh) -> fmt::Result {
    rows(out, "points", mesh.points.iter().map(DVec3::to_array))?;
    rows(out, "colours", &mesh.colours)?;
    rows(out, "lines", &mesh.lines)?;
    rows(out, "triangles", &mesh.triangles)
}
