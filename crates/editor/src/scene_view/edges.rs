//! The edges of a mesh at which one sees what it is: where it ends, and where two
//! triangles meet at an angle.

use std::collections::HashMap;

use glam::DVec3;
use vides_engine::scene::Mesh;

/// The cosine of the angle from which on two triangles make an edge: 30°.
const SHARP: f64 = 0.866;

/// More lines of a mesh than this are not drawn, but evenly chosen ones: more would not
/// be told apart, and cost time.
const MOST: usize = 30_000;

/// Of a mesh without edges, such as a ball, so many of all are drawn.
const OF_SMOOTH: usize = 3_000;

/// Those of all meshes of a scene.
#[derive(Debug, Default)]
pub(super) struct Edges {
    /// The scene of which they are: [`crate::document::Around::number`].
    number: u64,
    of_nodes: HashMap<usize, Vec<[u32; 2]>>,
}

impl Edges {
    /// The lines to be drawn of a node's mesh; points are lines without length.
    pub(super) fn of(&mut self, number: u64, node: usize, mesh: &Mesh) -> &[[u32; 2]] {
        if self.number != number {
            *self = Self {
                number,
                ..Self::default()
            };
        }
        self.of_nodes.entry(node).or_insert_with(|| lines(mesh))
    }
}

#[allow(clippy::cast_possible_truncation)]
fn lines(mesh: &Mesh) -> Vec<[u32; 2]> {
    if mesh.lines.is_empty() && mesh.triangles.is_empty() {
        let every = mesh.points.len().div_ceil(MOST).max(1);
        let chosen = (0..mesh.points.len() as u32).step_by(every);
        return chosen.map(|at| [at, at]).collect();
    }
    let mut all = features(mesh);
    all.extend(&mesh.lines);
    thinned(all, MOST)
}

fn thinned(all: Vec<[u32; 2]>, most: usize) -> Vec<[u32; 2]> {
    let every = all.len().div_ceil(most).max(1);
    if every == 1 {
        return all;
    }
    all.into_iter().step_by(every).collect()
}

fn features(mesh: &Mesh) -> Vec<[u32; 2]> {
    let place = |at: u32| mesh.points[at as usize];
    let normal = |&[a, b, c]: &[u32; 3]| {
        let across = (place(b) - place(a)).cross(place(c) - place(a));
        across.try_normalize().unwrap_or(DVec3::ZERO)
    };
    let normals: Vec<DVec3> = mesh.triangles.iter().map(normal).collect();
    let mut sides: Vec<([u32; 2], usize)> = Vec::with_capacity(3 * mesh.triangles.len());
    for (at, &[a, b, c]) in mesh.triangles.iter().enumerate() {
        let of_side = |[a, b]: [u32; 2]| ([a.min(b), a.max(b)], at);
        sides.extend([[a, b], [b, c], [c, a]].map(of_side));
    }
    sides.sort_unstable();
    let groups = || sides.chunk_by(|a, b| a.0 == b.0);
    let sharp = |group: &&[([u32; 2], usize)]| match group {
        [(_, a), (_, b)] => {
            let (a, b) = (normals[*a], normals[*b]);
            // One without an area has no angle.
            a != DVec3::ZERO && b != DVec3::ZERO && a.dot(b) < SHARP
        }
        _ => true,
    };
    let found = groups().filter(sharp).map(|group| group[0].0);
    // The tip of a cone may be many points at one place.
    let found: Vec<[u32; 2]> = found.filter(|&[a, b]| place(a) != place(b)).collect();
    if found.is_empty() {
        let all = groups().map(|group| group[0].0).collect();
        return thinned(all, OF_SMOOTH);
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    fn box_of(side: f64) -> Mesh {
        let at = |bit: usize, k: usize| if k >> bit & 1 == 1 { side } else { -side };
        let points = (0..8).map(|k| DVec3::new(at(0, k), at(1, k), at(2, k)));
        Mesh {
            points: points.collect(),
            triangles: vec![
                [0, 3, 1],
                [0, 2, 3],
                [4, 7, 6],
                [4, 5, 7],
                [0, 5, 4],
                [0, 1, 5],
                [2, 7, 3],
                [2, 6, 7],
                [0, 6, 2],
                [0, 4, 6],
                [1, 7, 5],
                [1, 3, 7],
            ],
            ..Mesh::default()
        }
    }

    #[test]
    fn a_box_has_its_twelve_edges_and_no_diagonal() {
        let found = lines(&box_of(1.0));
        assert_eq!(found.len(), 12);
        let one_way = |&[a, b]: &[u32; 2]| (a ^ b).count_ones() == 1;
        assert!(found.iter().all(one_way), "{found:?}");
    }

    #[test]
    fn a_sheet_has_its_border() {
        let mut sheet = box_of(1.0);
        sheet.triangles = vec![[0, 3, 1], [0, 2, 3]];
        let mut found = lines(&sheet);
        found.sort_unstable();
        assert_eq!(found, [[0, 1], [0, 2], [1, 3], [2, 3]]);
    }

    #[test]
    fn what_has_no_edges_is_shown_by_some_of_all() {
        let at = |ring: u32, turn: u32| {
            let tilt = f64::from(ring) * std::f64::consts::PI / 40.0;
            let turn = f64::from(turn) * std::f64::consts::TAU / 80.0;
            DVec3::new(tilt.sin() * turn.cos(), tilt.cos(), tilt.sin() * turn.sin())
        };
        let point = |ring: u32, turn: u32| ring * 80 + turn % 80;
        let mut ball = Mesh::default();
        for ring in 0..=40 {
            // At the poles all points of a ring are one place, to the last bit.
            let pole = ring == 0 || ring == 40;
            let all = (0..80).map(|turn| at(ring, if pole { 0 } else { turn }));
            ball.points
                .extend(all.map(|p| if pole { DVec3::Y * p.y.signum() } else { p }));
        }
        for (ring, turn) in (0..40).flat_map(|ring| (0..80).map(move |turn| (ring, turn))) {
            let [a, b] = [0, 1].map(|more| point(ring, turn + more));
            let [c, d] = [0, 1].map(|more| point(ring + 1, turn + more));
            ball.triangles.extend([[a, b, c], [b, d, c]]);
        }
        let found = lines(&ball).len();
        assert!((OF_SMOOTH / 2..=OF_SMOOTH).contains(&found), "{found}");
    }

    #[test]
    fn clouds_and_large_meshes_are_thinned_evenly() {
        let cloud = Mesh {
            points: vec![DVec3::ZERO; 100_000],
            ..Mesh::default()
        };
        let found = lines(&cloud);
        assert!((MOST / 2..=MOST).contains(&found.len()));
        assert!(found.iter().all(|[a, b]| a == b) && found.last().unwrap()[0] > 99_990);
        assert!(lines(&Mesh::default()).is_empty());
    }
}
