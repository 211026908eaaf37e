//! STL. Written by hand: other readers take every file that begins with `solid` for text, although
//! many binary ones do, and keep only 32 bits of numbers in text.

use std::collections::HashMap;

use glam::DVec3;
use vides_engine::scene::Mesh;

use super::error::{Error, Problem, Result};
use super::shared::{EVERY, coordinates, lines};

/// Bytes before the first triangle: a comment and the number of triangles.
const HEAD: usize = 84;

/// Bytes of a triangle: its normal, three corners, and two more bytes.
const RECORD: usize = 50;

pub(super) fn read(bytes: &[u8], go_on: &mut dyn FnMut(f64) -> bool) -> Result<Mesh> {
    let count = bytes
        .get(80..HEAD)
        .and_then(|count| Some(u32::from_le_bytes(count.try_into().ok()?) as usize));
    let records = bytes.get(HEAD..).unwrap_or_default();
    let is_text = bytes.trim_ascii_start().starts_with(b"solid");
    match count {
        // Some writers leave bytes after the last triangle.
        Some(count)
            if count <= records.len() / RECORD && (!is_text || is_whole(count, records)) =>
        {
            binary(&records[..count * RECORD], go_on)
        }
        _ if is_text => text(bytes, go_on),
        Some(_) => Err(Error::File(Problem::End)),
        None => Err(Error::File(Problem::Format)),
    }
}

fn is_whole(count: usize, records: &[u8]) -> bool {
    records.len() == count * RECORD
}

#[derive(Default)]
struct Corners {
    mesh: Mesh,
    known: HashMap<[u64; 3], u32>,
}

impl Corners {
    fn add(&mut self, triangle: [DVec3; 3]) -> Result<()> {
        let mut corners = [0; 3];
        for (corner, point) in corners.iter_mut().zip(triangle) {
            self.known.try_reserve(1)?;
            self.mesh.points.try_reserve(1)?;
            // Adding 0 turns −0 into 0.
            let key = (point + DVec3::ZERO).to_array().map(f64::to_bits);
            *corner = *self.known.entry(key).or_insert_with(|| {
                self.mesh.points.push(point);
                (self.mesh.points.len() - 1) as u32
            });
        }
        self.mesh.triangles.try_reserve(1)?;
        self.mesh.triangles.push(corners);
        Ok(())
    }
}

fn binary(records: &[u8], go_on: &mut dyn FnMut(f64) -> bool) -> Result<Mesh> {
    let mut corners = Corners::default();
    for (at, record) in records.chunks_exact(RECORD).enumerate() {
        if at % EVERY == 0 && !go_on((at * RECORD) as f64 / records.len() as f64) {
            return Err(Error::Stopped);
        }
        let number = |at: usize| {
            let bytes = [0, 1, 2, 3].map(|byte| record[4 * at + byte]);
            f64::from(f32::from_le_bytes(bytes))
        };
        corners.add([3, 6, 9].map(|at| DVec3::new(number(at), number(at + 1), number(at + 2))))?;
    }
    Ok(corners.mesh)
}

fn text(bytes: &[u8], go_on: &mut dyn FnMut(f64) -> bool) -> Result<Mesh> {
    let mut corners = Corners::default();
    let mut triangle: Vec<DVec3> = Vec::with_capacity(3);
    let mut facet = false;
    for statement in lines(bytes, go_on) {
        let (line, mut words) = statement?;
        let wrong = |problem| Err(Error::Line { line, problem });
        match (words.next().unwrap_or_default(), facet) {
            ("facet", false) => facet = true,
            ("facet" | "endsolid", true) => return wrong(Problem::Expected("endfacet")),
            ("vertex", true) if triangle.len() < 3 => match coordinates(&mut words) {
                Some(point) => triangle.push(point),
                None => return wrong(Problem::Coordinates),
            },
            ("endfacet", true) => {
                let Ok(corner) = <[DVec3; 3]>::try_from(triangle.as_slice()) else {
                    return wrong(Problem::Expected("vertex"));
                };
                corners.add(corner)?;
                triangle.clear();
                facet = false;
            }
            ("outer" | "endloop", true) | ("solid" | "endsolid" | "color", false) => {}
            (_, true) => return wrong(Problem::Expected("endfacet")),
            (_, false) => return wrong(Problem::Expected("facet")),
        }
    }
    if facet {
        return Err(Error::File(Problem::End));
    }
    Ok(corners.mesh)
}
