//! Meshes as wireframes.

use glam::DVec3;
use vides_engine::Result;
use vides_engine::scene::Mesh;

use crate::error::{EngineError, TooMany, vec_with_room};
use crate::info::{Object, ObjectPoint};
use vides_engine::limits;

/// The cosine of 30°: triangles that meet at a larger angle make an edge.
const SHARP: f64 = 0.866;

/// More lines cannot be told apart and cost time.
const MAX_LINES: usize = 30_000;

/// How many lines are shown of a mesh without edges, such as a ball.
const MAX_SMOOTH_LINES: usize = 3_000;

impl Object {
    /// The lines of a mesh and the edges of its triangles, each once; its points if it has neither.
    /// A mesh with triangles is kept; of one with more than [`limits::MAX_OBJECT_POINTS`] to draw,
    /// the [`features`] are drawn.
    ///
    /// # Errors
    /// As [`Mesh::check`]; `ErrorKind::Memory`; `Limit` for too many lines or points alone.
    pub fn of_mesh(mesh: Mesh) -> Result<Self> {
        mesh.check()?;
        let mut sides = sides(&mesh)?;
        sides.dedup_by_key(|(side, _)| *side);
        let edges = sides.iter().map(|(side, _)| side);
        let whole = if mesh.lines.is_empty() && sides.is_empty() {
            of_lines(&mesh, (0..).take(mesh.points.len()).map(|at| [at, at]))
        } else {
            of_lines(&mesh, mesh.lines.iter().chain(edges).copied())
        };
        Ok(match whole {
            whole if mesh.triangles.is_empty() => whole?,
            Err(EngineError::Limit(_)) => Self::features_of(mesh)?,
            whole => whole?.of(mesh),
        })
    }

    /// The [`features`] of a mesh, few enough to be drawn at once, with the mesh.
    ///
    /// # Errors
    /// As [`Mesh::check`]; `ErrorKind::Memory`.
    pub fn features_of(mesh: Mesh) -> Result<Self> {
        Ok(of_lines(&mesh, features(&mesh)?)?.of(mesh))
    }
}

fn of_lines(mesh: &Mesh, lines: impl IntoIterator<Item = [u32; 2]>) -> Result<Object> {
    let lines = lines.into_iter();
    let mut points = vec_with_room(lines.size_hint().0.min(limits::MAX_OBJECT_POINTS))?;
    let mut colours = Vec::new();
    let mut at = None;
    for [from, to] in lines {
        let begins = at != Some(from) || from == to;
        let ends = from != to;
        let count = points.len() + usize::from(begins) + usize::from(ends);
        if count > limits::MAX_OBJECT_POINTS {
            return Err(TooMany::WireframePoints.into());
        }
        points.try_reserve(2)?;
        for (index, draw, there) in [(from, false, begins), (to, true, ends)] {
            if there {
                let position = mesh.points[index as usize];
                points.push(ObjectPoint { position, draw });
                if let Some(&colour) = mesh.colours.get(index as usize) {
                    colours.try_reserve(1)?;
                    colours.push(colour);
                }
            }
        }
        at = Some(to);
    }
    Ok(Object::from(points).coloured(colours))
}

/// The lines that show a mesh's shape, as indices of its points: its own lines, and the borders and
/// sharp edges of its triangles. Without any of these, some of all edges; of a point cloud, its
/// points as lines of length zero. Thinned evenly to some ten thousand.
///
/// # Errors
/// As [`Mesh::check`]; `ErrorKind::Memory`.
#[allow(clippy::cast_possible_truncation)]
pub fn features(mesh: &Mesh) -> Result<Vec<[u32; 2]>> {
    mesh.check()?;
    if mesh.lines.is_empty() && mesh.triangles.is_empty() {
        let every = mesh.points.len().div_ceil(MAX_LINES).max(1);
        let chosen = (0..mesh.points.len() as u32).step_by(every);
        return Ok(chosen.map(|at| [at, at]).collect());
    }
    let mut all = edges(mesh)?;
    if all.is_empty() {
        let mut sides = sides(mesh)?;
        sides.dedup_by_key(|(side, _)| *side);
        all = thinned(
            sides.into_iter().map(|(side, _)| side).collect(),
            MAX_SMOOTH_LINES,
        );
    }
    all.try_reserve(mesh.lines.len())?;
    all.extend(&mesh.lines);
    Ok(thinned(all, MAX_LINES))
}

/// The lines to draw on a mesh whose faces are seen: its own, borders and sharp edges, thinned as
/// [`features`]; a ball has none.
///
/// # Errors
/// As [`features`].
pub fn sharp_lines(mesh: &Mesh) -> Result<Vec<[u32; 2]>> {
    mesh.check()?;
    let mut all = edges(mesh)?;
    all.try_reserve(mesh.lines.len())?;
    all.extend(&mesh.lines);
    Ok(thinned(all, MAX_LINES))
}

/// Cells along each side of a mesh's box in which one point stands for all others.
const CELLS: usize = 80;

/// Some ten thousand triangles that look like the mesh from afar, as indices of its points (Rossignac
/// and Borrel 1993: points in a cell of a grid become one).
///
/// # Errors
/// `ErrorKind::Memory`.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
pub fn coarse(mesh: &Mesh) -> Result<Vec<[u32; 3]>> {
    let points = || mesh.points.iter().copied();
    let low = points().fold(DVec3::INFINITY, DVec3::min);
    let size = points().fold(DVec3::NEG_INFINITY, DVec3::max) - low;
    let unit = CELLS as f64 / size.max_element().max(f64::MIN_POSITIVE);
    let cell = |point: DVec3| {
        let at = ((point - low) * unit)
            .to_array()
            .map(|x| (x as usize).min(CELLS - 1));
        (at[0] * CELLS + at[1]) * CELLS + at[2]
    };
    let mut of_cell = vec_with_room(CELLS * CELLS * CELLS)?;
    of_cell.resize(CELLS * CELLS * CELLS, u32::MAX);
    let mut of_point = vec_with_room(mesh.points.len())?;
    for (number, point) in (0_u32..).zip(points()) {
        let first = &mut of_cell[cell(point)];
        *first = number.min(*first);
        of_point.push(*first);
    }
    let mut all = Vec::new();
    for &triangle in &mesh.triangles {
        let [a, b, c] = triangle.map(|at| of_point[at as usize]);
        if a != b && b != c && c != a {
            all.try_reserve(1)?;
            // Equal ones come to lie beside each other.
            all.push(match a.min(b).min(c) {
                least if least == a => [a, b, c],
                least if least == b => [b, c, a],
                _ => [c, a, b],
            });
        }
    }
    all.sort_unstable();
    all.dedup();
    Ok(all)
}

fn thinned(all: Vec<[u32; 2]>, most: usize) -> Vec<[u32; 2]> {
    let every = all.len().div_ceil(most).max(1);
    if every == 1 {
        return all;
    }
    all.into_iter().step_by(every).collect()
}

/// The sides of the triangles, equal ones beside each other, and the triangle that each is of.
fn sides(mesh: &Mesh) -> Result<Vec<([u32; 2], usize)>> {
    let mut sides = vec_with_room(3 * mesh.triangles.len())?;
    for (at, &[a, b, c]) in mesh.triangles.iter().enumerate() {
        let side = |[a, b]: [u32; 2]| ([a.min(b), a.max(b)], at);
        sides.extend([[a, b], [b, c], [c, a]].map(side));
    }
    sides.sort_unstable();
    Ok(sides)
}

/// Borders and sharp edges.
fn edges(mesh: &Mesh) -> Result<Vec<[u32; 2]>> {
    let place = |at: u32| mesh.points[at as usize];
    let normal = |&[a, b, c]: &[u32; 3]| {
        let across = (place(b) - place(a)).cross(place(c) - place(a));
        across.try_normalize().unwrap_or(DVec3::ZERO)
    };
    let mut normals = vec_with_room(mesh.triangles.len())?;
    normals.extend(mesh.triangles.iter().map(normal));
    let sides = sides(mesh)?;
    let groups = || sides.chunk_by(|a, b| a.0 == b.0);
    let sharp = |group: &&[([u32; 2], usize)]| match group {
        [(_, a), (_, b)] => {
            let (a, b) = (normals[*a], normals[*b]);
            // A degenerate triangle has no angle.
            a != DVec3::ZERO && b != DVec3::ZERO && a.dot(b) < SHARP
        }
        _ => true,
    };
    let found = groups().filter(sharp).map(|group| group[0].0);
    // The tip of a cone may be many points at one place.
    Ok(found.filter(|&[a, b]| place(a) != place(b)).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_go_on_and_edges_of_two_triangles_are_drawn_once() {
        let points: Vec<DVec3> = (0..4).map(|n| DVec3::splat(f64::from(n))).collect();
        let drawn = |lines: Vec<[u32; 2]>, triangles: Vec<[u32; 3]>| {
            let mesh = Mesh {
                points: points.clone(),
                lines,
                triangles,
                ..Mesh::default()
            };
            let object = Object::of_mesh(mesh).expect("a wireframe");
            let numbers = object.iter().map(|point| (point.position.x, point.draw));
            numbers.collect::<Vec<_>>()
        };
        let chain = drawn(vec![[0, 1], [1, 2], [3, 0]], vec![]);
        let expected = [
            (0.0, false),
            (1.0, true),
            (2.0, true),
            (3.0, false),
            (0.0, true),
        ];
        assert_eq!(chain, expected);
        let square = drawn(vec![], vec![[0, 1, 2], [0, 2, 3]]);
        assert_eq!(square.iter().filter(|(_, draw)| *draw).count(), 5);
        assert_eq!(drawn(vec![], vec![]).len(), 4);
        assert!(drawn(vec![], vec![]).iter().all(|(_, draw)| !draw));
    }

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
        let found = features(&box_of(1.0)).unwrap();
        assert_eq!(found.len(), 12);
        let one_way = |&[a, b]: &[u32; 2]| (a ^ b).count_ones() == 1;
        assert!(found.iter().all(one_way), "{found:?}");
    }

    #[test]
    fn a_sheet_has_its_border() {
        let mut sheet = box_of(1.0);
        sheet.triangles = vec![[0, 3, 1], [0, 2, 3]];
        let mut found = features(&sheet).unwrap();
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
        assert_eq!(sharp_lines(&ball).unwrap(), [[0_u32; 2]; 0]);
        let found = features(&ball).unwrap().len();
        assert!(
            (MAX_SMOOTH_LINES / 2..=MAX_SMOOTH_LINES).contains(&found),
            "{found}"
        );
    }

    #[test]
    fn a_mesh_whose_corners_are_missing_is_refused() {
        for (lines, triangles) in [(vec![[0, 8]], vec![]), (vec![], vec![[0, 1, 8]])] {
            let broken = Mesh {
                lines,
                triangles,
                ..box_of(1.0)
            };
            assert!(features(&broken).is_err());
        }
    }

    #[test]
    fn clouds_and_large_meshes_are_thinned_evenly() {
        let cloud = Mesh {
            points: vec![DVec3::ZERO; 100_000],
            ..Mesh::default()
        };
        let found = features(&cloud).unwrap();
        assert!((MAX_LINES / 2..=MAX_LINES).contains(&found.len()));
        assert!(found.iter().all(|[a, b]| a == b) && found.last().unwrap()[0] > 99_990);
        assert!(features(&Mesh::default()).unwrap().is_empty());
    }
}
