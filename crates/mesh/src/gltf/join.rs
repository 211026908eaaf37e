//! Merges points at one position: exporters split them where normals or textures differ, and each
//! seam would look like an edge.

use std::hash::{BuildHasher, Hash, Hasher, RandomState};

use glam::DVec3;

use super::geometry::Part;
use crate::error::Result;

/// No point has this index.
const FREE: u32 = u32::MAX;

/// Adding 0 turns −0 into 0.
fn bits(point: DVec3) -> [u64; 3] {
    (point + DVec3::ZERO).to_array().map(f64::to_bits)
}

/// Hashes everything that makes two points equal.
fn hash(part: &Part, at: usize, hasher: &RandomState) -> u64 {
    let mut hasher = hasher.build_hasher();
    for points in std::iter::once(&part.mesh.points).chain(&part.targets) {
        for number in bits(points[at]) {
            hasher.write_u64(number);
        }
    }
    part.mesh.colours.get(at).hash(&mut hasher);
    hasher.finish()
}

fn same(part: &Part, a: usize, b: usize) -> bool {
    let mut all = std::iter::once(&part.mesh.points).chain(&part.targets);
    part.mesh.colours.get(a) == part.mesh.colours.get(b)
        && all.all(|points| bits(points[a]) == bits(points[b]))
}

fn shift(part: &mut Part, from: usize, to: usize) {
    for points in std::iter::once(&mut part.mesh.points).chain(&mut part.targets) {
        points[to] = points[from];
    }
    let colours = &mut part.mesh.colours;
    if let Some(&colour) = colours.get(from) {
        colours[to] = colour;
    }
}

/// Merges points of equal position and colour that are equal in every target too.
pub(super) fn joined(mut part: Part) -> Result<Part> {
    let count = part.mesh.points.len();
    if part.mesh.triangles.is_empty() && part.mesh.lines.is_empty() {
        return Ok(part);
    }
    // Indices of the points that are kept, by hash; at most half full. A table of whole points
    // would take more memory than the mesh.
    let size = count.saturating_mul(2).next_power_of_two();
    let mut table: Vec<u32> = Vec::new();
    table.try_reserve_exact(size)?;
    table.resize(size, FREE);
    let hasher = RandomState::new();
    let mut new: Vec<u32> = Vec::new();
    new.try_reserve_exact(count)?;
    let mut kept = 0;
    for at in 0..count {
        let mut place = hash(&part, at, &hasher) as usize & (size - 1);
        while table[place] != FREE && !same(&part, table[place] as usize, at) {
            place = (place + 1) & (size - 1);
        }
        if table[place] == FREE {
            table[place] = kept as u32;
            shift(&mut part, at, kept);
            kept += 1;
        }
        new.push(table[place]);
    }
    for points in std::iter::once(&mut part.mesh.points).chain(&mut part.targets) {
        points.truncate(kept);
    }
    part.mesh.colours.truncate(kept);
    let corners = part.mesh.triangles.iter_mut().flatten();
    for corner in corners.chain(part.mesh.lines.iter_mut().flatten()) {
        *corner = new[*corner as usize];
    }
    Ok(part)
}
