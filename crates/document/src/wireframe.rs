//! A mesh as the wireframe that a path shows.

use crate::error::{Result, TooMany, vec_with_room};
use crate::info::{Object, ObjectPoint};
use crate::limits;
use vides_engine::scene::Mesh;

impl Object {
    /// The lines of a mesh and the edges of its triangles, each edge once; of a mesh
    /// with neither its points.
    ///
    /// # Errors
    /// As [`Mesh::check`]; `ErrorKind::Limit` for a wireframe of more than
    /// [`limits::MAX_OBJECT_POINTS`]; `ErrorKind::Memory`.
    pub fn of_mesh(mesh: &Mesh) -> Result<Self> {
        mesh.check()?;
        let mut edges = vec_with_room(3 * mesh.triangles.len())?;
        for &[a, b, c] in &mesh.triangles {
            edges.extend([[a, b], [b, c], [c, a]].map(|[a, b]| [a.min(b), a.max(b)]));
        }
        edges.sort_unstable();
        edges.dedup();
        let lines = mesh.lines.iter().chain(&edges);
        let alone = mesh.lines.is_empty() && edges.is_empty();
        let most = if alone {
            mesh.points.len()
        } else {
            2 * (mesh.lines.len() + edges.len())
        };
        let mut points = vec_with_room(most.min(limits::MAX_OBJECT_POINTS + 2))?;
        let mut add = |index: u32, draw| {
            points.push(ObjectPoint {
                position: mesh.points[index as usize],
                draw,
            });
        };
        if alone {
            (0..)
                .zip(&mesh.points)
                .for_each(|(index, _)| add(index, false));
        }
        let (mut at, mut count) = (None, 0);
        for &[from, to] in lines {
            let begins = at != Some(from);
            count += 1 + usize::from(begins);
            if count > limits::MAX_OBJECT_POINTS {
                return Err(TooMany::WireframePoints.into());
            }
            if begins {
                add(from, false);
            }
            add(to, true);
            at = Some(to);
        }
        Ok(points.into())
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

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
            let object = Object::of_mesh(&mesh).expect("a wireframe");
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
}
