//! The box around some points under a deformation, for display.

use glam::DVec3;
use vides_engine::deform::{Bounds, Deformation};

/// A deformed box for display.
#[derive(Debug, Clone)]
pub struct Cage {
    bounds: Bounds,
    /// The polylines on it.
    pub lines: Vec<Vec<DVec3>>,
    /// The control points of a free form; empty otherwise.
    pub nodes: Vec<DVec3>,
}

/// The box around some points, widened where it is flat if a free form is to move them out of it.
pub(super) fn bounds(kind: &str, places: &[DVec3]) -> Bounds {
    let bounds = Bounds::of(places);
    let (low, high) = (bounds.min(), bounds.max());
    let size = high - low;
    if kind != "free-form" {
        return bounds;
    }
    let flat = size.cmplt(DVec3::splat(1e-6 * size.max_element()));
    let room = DVec3::select(flat, DVec3::splat(0.25 * size.max_element()), DVec3::ZERO);
    Bounds::new(low - room, high + room).unwrap_or(bounds)
}

impl Cage {
    /// A box as a deformation makes it.
    #[must_use]
    pub fn new(bounds: Bounds, deformation: &Deformation) -> Self {
        let nodes: Vec<_> = match deformation.channel("points") {
            Some(lattice) => lattice
                .chunks_exact(3)
                .map(|node| bounds.point(DVec3::from_slice(node)))
                .collect(),
            None => Vec::new(),
        };
        // A free form shows each row of nodes, the others the edges and middles of the sides.
        let (cells, steps) = if nodes.is_empty() { (2, 16) } else { (3, 3) };
        let mut lines = Vec::with_capacity(3 * (cells + 1) * (cells + 1));
        for axis in 0..3 {
            for row in 0..(cells + 1) * (cells + 1) {
                let (i, j) = (row % (cells + 1), row / (cells + 1));
                let inner = |at: usize| at != 0 && at != cells;
                if nodes.is_empty() && inner(i) && inner(j) {
                    continue;
                }
                let mut line: Vec<_> = (0..=steps)
                    .map(|step| {
                        let mut place = [0; 3];
                        (place[axis], place[(axis + 1) % 3], place[(axis + 2) % 3]) = (step, i, j);
                        if !nodes.is_empty() {
                            return nodes[place[0] + 4 * place[1] + 16 * place[2]];
                        }
                        let side = |at: usize, of: usize| 2.0 * at as f64 / of as f64 - 1.0;
                        let mut coordinates = DVec3::ZERO;
                        coordinates[axis] = side(step, steps);
                        coordinates[(axis + 1) % 3] = side(i, cells);
                        coordinates[(axis + 2) % 3] = side(j, cells);
                        bounds.point(coordinates)
                    })
                    .collect();
                if nodes.is_empty() {
                    deformation.apply(&bounds, &mut line);
                }
                lines.push(line);
            }
        }
        Self {
            bounds,
            lines,
            nodes,
        }
    }

    /// A position in the coordinates of the box, as a free form takes them.
    #[must_use]
    pub fn coordinates(&self, place: DVec3) -> DVec3 {
        self.bounds.coordinates(place)
    }
}
