//! Whether a place is inside a closed part of an object: a ray from there leaves it an odd number
//! of times. Triangles are of one part if they share an edge; a part is closed if each of its edges
//! has an even number of triangles. Corners at one place are one, whatever the file numbers them.

use glam::DVec3;

use super::clearance::{Clearance, Primitive};
use crate::error::{Result, vec_with_room};

/// Directions that no model is built along. Two of three must agree, since a ray may meet an edge.
const WAYS: [DVec3; 3] = [
    DVec3::new(0.812_345_1, 0.312_356_7, 0.492_387_1),
    DVec3::new(-0.273_914_6, 0.914_617_3, 0.300_941_3),
    DVec3::new(0.173_205_1, -0.537_691_3, 0.834_159_3),
];

/// Not of a closed part.
const OPEN: u32 = u32::MAX;

/// The closed parts of an object.
#[derive(Debug)]
pub struct Enclosure<'a> {
    object: &'a Clearance,
    /// The part of each of its primitives.
    parts: Vec<u32>,
}

impl<'a> Enclosure<'a> {
    /// The closed parts around a place, if any. Quick where a ray from the place
    /// meets nothing, else it takes the time of two sortings of all corners.
    ///
    /// # Errors
    /// [`crate::Error::Memory`].
    pub fn around(object: &'a Clearance, place: DVec3) -> Result<Option<Self>> {
        let leaves = |way: DVec3| !object.is_met(place, way.normalize());
        if WAYS.iter().any(|way| leaves(*way) || leaves(-*way)) {
            return Ok(None);
        }
        let parts = closed(&object.primitives)?;
        let all = Self { object, parts };
        Ok(all.holds(place)?.then_some(all))
    }

    /// Whether a place is inside one of the parts.
    ///
    /// # Errors
    /// [`crate::Error::Memory`].
    pub fn holds(&self, place: DVec3) -> Result<bool> {
        let mut odd = Vec::new();
        for way in WAYS {
            let mut met = self.met(place, way.normalize())?;
            met.sort_unstable();
            for same in met.chunk_by(|a, b| a == b) {
                if same.len() % 2 == 1 {
                    odd.try_reserve(1)?;
                    odd.push(same[0]);
                }
            }
        }
        odd.sort_unstable();
        Ok(odd.windows(2).any(|pair| pair[0] == pair[1]))
    }

    /// The part of each triangle that a ray meets.
    fn met(&self, from: DVec3, way: DVec3) -> Result<Vec<u32>> {
        let mut met = Vec::new();
        let mut room = Ok(());
        self.object.walk(&mut |node, primitives| {
            let [low, high] = [node.min, node.max].map(|corner| (corner - from) / way);
            let (enter, leave) = (low.min(high), low.max(high));
            if enter.max_element().max(0.0) > leave.min_element() {
                return false;
            }
            for (k, primitive) in primitives.iter().enumerate() {
                let part = self.parts[node.at as usize + k];
                if part != OPEN && matches!(primitive.ahead(from, way), Some((_, None))) {
                    match met.try_reserve(1) {
                        Ok(()) => met.push(part),
                        Err(error) => room = Err(error),
                    }
                }
            }
            true
        });
        room?;
        Ok(met)
    }
}

/// The closed part of each primitive.
#[allow(clippy::cast_possible_truncation)] // a mesh has fewer than 2³² corners
fn closed(primitives: &[Primitive]) -> Result<Vec<u32>> {
    let count = primitives.len();
    // −0 becomes 0.
    let corner = |k: u32| primitives[k as usize / 3].0[k as usize % 3] + DVec3::ZERO;
    let compared = |a: u32, b: u32| {
        let (a, b) = (corner(a).to_array(), corner(b).to_array());
        let axes = a.iter().zip(&b).map(|(a, b)| a.total_cmp(b));
        axes.fold(std::cmp::Ordering::Equal, std::cmp::Ordering::then)
    };
    let mut order = vec_with_room(3 * count)?;
    order.extend(0..3 * count as u32);
    order.sort_unstable_by(|a, b| compared(*a, *b));
    let mut places = vec_with_room(3 * count)?;
    places.resize(3 * count, 0);
    for same in order.chunk_by(|a, b| compared(*a, *b).is_eq()) {
        same.iter().for_each(|k| places[*k as usize] = same[0]);
    }
    drop(order);
    let mut edges = vec_with_room(3 * count)?;
    for (at, three) in places.chunks_exact(3).enumerate() {
        let &[a, b, c] = three else { continue };
        if a != b && b != c && c != a {
            let edge = |a: u32, b: u32| (a.min(b), a.max(b), at as u32);
            edges.extend([edge(a, b), edge(b, c), edge(c, a)]);
        }
    }
    edges.sort_unstable();
    let mut parts = vec_with_room(count)?;
    parts.extend(0..count as u32);
    let groups = || edges.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1));
    for pair in groups().flat_map(|group| group.windows(2)) {
        let (a, b) = (first(&mut parts, pair[0].2), first(&mut parts, pair[1].2));
        parts[a.max(b) as usize] = a.min(b);
    }
    let mut open = vec_with_room(count)?;
    open.resize(count, true);
    // A part without edges, such as a line, stays open.
    edges
        .iter()
        .for_each(|edge| open[first(&mut parts, edge.2) as usize] = false);
    for group in groups().filter(|group| group.len() % 2 == 1) {
        open[first(&mut parts, group[0].2) as usize] = true;
    }
    for at in 0..count as u32 {
        let part = first(&mut parts, at);
        parts[at as usize] = part;
    }
    parts.iter_mut().for_each(|part| {
        if open[*part as usize] {
            *part = OPEN;
        }
    });
    Ok(parts)
}

/// The first member of a part, halving the way there.
fn first(parts: &mut [u32], mut at: u32) -> u32 {
    while parts[at as usize] != at {
        let next = parts[parts[at as usize] as usize];
        parts[at as usize] = next;
        at = next;
    }
    at
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Mesh;

    /// A box with a side left out, or none; each triangle with separate corners.
    fn soup(half: f64, at: DVec3, without: Option<usize>) -> Vec<[DVec3; 3]> {
        let mut all = Vec::new();
        for side in (0..6).filter(|side| Some(*side) != without) {
            let axis = side % 3;
            let sign = if side < 3 { half } else { -half };
            let corner = |u: f64, v: f64| {
                let mut p = [0.0; 3];
                (p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3]) = (sign, u * half, v * half);
                at + DVec3::from_array(p)
            };
            let [a, b] = [corner(-1.0, -1.0), corner(1.0, -1.0)];
            let [c, d] = [corner(1.0, 1.0), corner(-1.0, 1.0)];
            all.extend([[a, b, c], [c, a, d]]);
        }
        all
    }

    fn tree(triangles: &[[DVec3; 3]]) -> Clearance {
        let points: Vec<DVec3> = triangles.iter().flatten().copied().collect();
        let corners = (0..points.len() as u32).step_by(3);
        Clearance::new(&Mesh {
            triangles: corners.map(|k| [k, k + 1, k + 2]).collect(),
            points,
            ..Mesh::default()
        })
        .unwrap()
    }

    fn holds(triangles: &[[DVec3; 3]], place: DVec3) -> bool {
        let tree = tree(triangles);
        Enclosure::around(&tree, place).unwrap().is_some()
    }

    #[test]
    fn inside_is_what_a_closed_box_is_around() {
        let closed = soup(1.0, DVec3::ZERO, None);
        let places = [-1.5, -0.7, 0.0, 0.3, 1.2];
        for (x, y, z) in (0..125).map(|k| (places[k % 5], places[k / 5 % 5], places[k / 25])) {
            let place = DVec3::new(x, y, z);
            let inside = place.abs().max_element() < 1.0;
            assert_eq!(holds(&closed, place), inside, "{place}");
            for side in 0..6 {
                let open = soup(1.0, DVec3::ZERO, Some(side));
                assert!(!holds(&open, place), "{place} {side}");
            }
        }
    }

    #[test]
    fn an_open_part_beside_or_within_changes_nothing() {
        let mut both = soup(1.0, DVec3::ZERO, None);
        both.extend(soup(0.2, DVec3::splat(0.5), Some(1)));
        assert!(holds(&both, DVec3::ZERO) && holds(&both, DVec3::splat(0.5)));
        assert!(!holds(&both, DVec3::X * 3.0));
        // A hollow box: between its walls, and in its hollow, which both boxes are around.
        let mut hollow = soup(1.0, DVec3::ZERO, None);
        hollow.extend(soup(0.5, DVec3::ZERO, None));
        assert!(holds(&hollow, DVec3::X * 0.75) && holds(&hollow, DVec3::ZERO));
    }
}
