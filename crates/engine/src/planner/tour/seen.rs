//! What a picture shows of a surface: a depth buffer of its triangles, against which the middle of
//! each is held.

use glam::{DVec2, DVec3};

use super::depths::{Depths, SIZE, pixel};
use crate::error::{Invalid, Result, vec_with_room};
use crate::path::Up;
use crate::scene::Mesh;

/// A middle counts as hidden by what is nearer by more than this share of the distance: about two
/// pixels, what a surface that is not flat rises within one.
const BEFORE: f64 = 0.005;

/// The least size in the picture by that of the same triangle straight before a camera at the
/// distance of the tour: nothing is shown at a grazing angle or from too far away.
pub(super) const LEAST: f64 = 0.1;

/// Nearer than this share of the tour's distance nothing is drawn.
const NEAR: f64 = 1e-3;

/// A set of triangles, a bit each.
pub(super) type Set = Vec<u64>;

/// The triangles of an object.
pub(super) struct Surface<'a> {
    pub mesh: &'a Mesh,
    pub middles: Vec<DVec3>,
    /// Across, as long as the area is large; towards the side that counts, if only one does.
    pub across: Vec<DVec3>,
    pub areas: Vec<f64>,
    pub total: f64,
    /// Only the side that `across` points to counts.
    pub one_sided: bool,
    /// It has no edge where one could see the other side from outside.
    closed: bool,
    pub distance: f64,
}

/// A camera, level.
#[derive(Clone, Copy, Debug)]
pub(super) struct Camera {
    pub eye: DVec3,
    view: DVec3,
    right: DVec3,
    up: DVec3,
    /// Half the width and half the height of the picture at distance 1.
    half: DVec2,
}

impl Camera {
    pub(super) fn new(eye: DVec3, target: DVec3, up: Up, zoom: f64) -> Option<Self> {
        let view = (target - eye).try_normalize()?;
        let above = up.up_from_roll(view, 0.0);
        Some(Self {
            eye,
            view,
            right: view.cross(above),
            up: above,
            half: DVec2::new(18.0, 12.0) / zoom,
        })
    }

    /// Whether a place is in the picture, whatever is before it.
    #[cfg(test)]
    pub(super) fn holds(&self, place: DVec3) -> bool {
        is_in_picture(self.project(place))
    }

    /// A place in the picture in pixels, and 1 / depth, which is 0 or less behind the eye.
    fn project(&self, place: DVec3) -> [f64; 3] {
        let way = place - self.eye;
        let depth = 1.0 / way.dot(self.view);
        let [wide, high] = SIZE.map(|size| 0.5 * size as f64);
        [
            wide + wide * way.dot(self.right) * depth / self.half.x,
            high + high * way.dot(self.up) * depth / self.half.y,
            depth,
        ]
    }

    /// The way of length 1 along the view that a place in the picture shows.
    fn way(&self, x: f64, y: f64) -> DVec3 {
        let share = |at: f64, size: usize| 2.0 * at / size as f64 - 1.0;
        self.view
            + share(x, SIZE[0]) * self.half.x * self.right
            + share(y, SIZE[1]) * self.half.y * self.up
    }
}

impl<'a> Surface<'a> {
    /// Of a mesh; inside of it either side counts.
    pub(super) fn new(mesh: &'a Mesh, inside: bool) -> Result<Self> {
        let count = mesh.triangles.len();
        let (mut middles, mut across) = (vec_with_room(count)?, vec_with_room(count)?);
        let mut areas = vec_with_room(count)?;
        for corners in &mesh.triangles {
            let [a, b, c] = corners.map(|at| mesh.points[at as usize]);
            middles.push(a + ((b - a) + (c - a)) / 3.0);
            let normal = 0.5 * (b - a).cross(c - a);
            areas.push(normal.length());
            across.push(normal);
        }
        let total: f64 = areas.iter().sum();
        if !(total > 0.0 && total.is_finite()) {
            return Err(Invalid::NoSurface.into());
        }
        let (agrees, closed) = if inside { (false, false) } else { sides(mesh)? };
        let mut made = Self {
            mesh,
            middles,
            across,
            areas,
            total,
            one_sided: agrees,
            closed,
            distance: 1.0,
        };
        made.turn_out();
        Ok(made)
    }

    /// Turns the sides of an object that is inside out.
    fn turn_out(&mut self) {
        let centre = self.middle_of(|_| true).unwrap_or_default();
        let sides = self.middles.iter().zip(&self.across);
        let volume: f64 = sides.map(|(m, n)| (m - centre).dot(*n)).sum();
        if volume < -1e-3 * self.total.powf(1.5) {
            self.across.iter_mut().for_each(|normal| *normal = -*normal);
        }
    }

    /// The mean of the middles, by area, of some triangles.
    pub(super) fn middle_of(&self, which: impl Fn(usize) -> bool) -> Option<DVec3> {
        let (mut sum, mut area) = (DVec3::ZERO, 0.0);
        for at in (0..self.areas.len()).filter(|at| which(*at)) {
            sum += self.areas[at] * self.middles[at];
            area += self.areas[at];
        }
        (area > 0.0).then(|| sum / area)
    }

    pub(super) fn area_of(&self, set: &Set) -> f64 {
        members(set).map(|at| self.areas[at]).sum()
    }

    /// An empty set.
    pub(super) fn nothing(&self) -> Result<Set> {
        let words = self.areas.len().div_ceil(64);
        let mut set = vec_with_room(words)?;
        set.resize(words, 0);
        Ok(set)
    }

    /// Whether a triangle is seen well enough from a place, if nothing is between.
    pub(super) fn faces(&self, at: usize, eye: DVec3) -> bool {
        let way = eye - self.middles[at];
        let mut towards = self.across[at].dot(way);
        if !(towards > 0.0) {
            if self.one_sided {
                return false;
            }
            towards = -towards;
        }
        let far = way.length_squared();
        let shrunk = (self.distance * self.distance / far).min(1.0);
        towards * shrunk > LEAST * self.areas[at] * far.sqrt()
    }
}

/// The triangles of a set.
pub(super) fn members(set: &Set) -> impl Iterator<Item = usize> + '_ {
    set.iter().enumerate().flat_map(|(word, bits)| {
        let mut left = *bits;
        std::iter::from_fn(move || {
            let bit = left.trailing_zeros() as usize;
            (left != 0).then(|| {
                left &= left - 1;
                64 * word + bit
            })
        })
    })
}

/// Whether nearly all triangles with a common edge follow it in opposite directions.
/// Corners at one place are one. And whether each has two such triangles.
#[allow(clippy::cast_possible_truncation)] // a mesh has fewer than 2³² points
fn sides(mesh: &Mesh) -> Result<(bool, bool)> {
    let count = mesh.points.len();
    let key = |k: u32| (mesh.points[k as usize] + DVec3::ZERO).to_array();
    let compared = |a: u32, b: u32| {
        let (a, b) = (key(a), key(b));
        let axes = a.iter().zip(&b).map(|(a, b)| a.total_cmp(b));
        axes.fold(std::cmp::Ordering::Equal, std::cmp::Ordering::then)
    };
    let mut order = vec_with_room(count)?;
    order.extend(0..count as u32);
    order.sort_unstable_by(|a, b| compared(*a, *b).then(a.cmp(b)));
    let mut same = vec_with_room(count)?;
    same.resize(count, 0_u32);
    for group in order.chunk_by(|a, b| compared(*a, *b).is_eq()) {
        group.iter().for_each(|k| same[*k as usize] = group[0]);
    }
    drop(order);
    // Both ends of an edge, the smaller first, and which way it is gone.
    let mut edges = vec_with_room(3 * mesh.triangles.len())?;
    for corners in &mesh.triangles {
        let [a, b, c] = corners.map(|at| same[at as usize]);
        if a != b && b != c && c != a {
            let edge = |a: u32, b: u32| (a.min(b), a.max(b), a < b);
            edges.extend([edge(a, b), edge(b, c), edge(c, a)]);
        }
    }
    edges.sort_unstable();
    let (mut all, mut shared, mut good) = (0_usize, 0_usize, 0_usize);
    for group in edges.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1)) {
        all += 1;
        shared += usize::from(group.len() > 1);
        good += usize::from(group.len() == 2 && group[0].2 != group[1].2);
    }
    let agrees = shared > 0 && good as f64 >= 0.99 * shared as f64;
    Ok((agrees, agrees && good == all))
}

/// Buffers for pictures, used again and again.
pub(super) struct Picture {
    depths: Depths,
    corners: Vec<[f64; 3]>,
}

impl Picture {
    pub(super) fn new(surface: &Surface) -> Result<Self> {
        let mut corners = vec_with_room(surface.mesh.points.len())?;
        corners.resize(surface.mesh.points.len(), [0.0; 3]);
        let depths = Depths::new()?;
        Ok(Self { depths, corners })
    }

    /// Puts what a camera shows into an empty set.
    pub(super) fn look(&mut self, surface: &Surface, camera: &Camera, seen: &mut Set) {
        self.draw(surface, camera);
        let near = 1.0 / (NEAR * surface.distance);
        for (at, middle) in surface.middles.iter().enumerate() {
            if !surface.faces(at, camera.eye) {
                continue;
            }
            let [x, y, depth] = camera.project(*middle);
            if !(is_in_picture([x, y, depth]) && depth < near) {
                continue;
            }
            // The plane of the triangle in the middle of the pixel.
            let (column, row) = (pixel(x), pixel(y));
            let normal = surface.across[at];
            let way = camera.way(column as f64 + 0.5, row as f64 + 0.5);
            let own = normal.dot(way) / normal.dot(*middle - camera.eye);
            let nearest = self.depths.nearest(column, row);
            if own * (1.0 + BEFORE) >= nearest {
                seen[at / 64] |= 1 << (at % 64);
            }
        }
    }

    fn draw(&mut self, surface: &Surface, camera: &Camera) {
        self.depths.clear();
        let near = NEAR * surface.distance;
        for (corner, point) in self.corners.iter_mut().zip(&surface.mesh.points) {
            *corner = camera.project(*point);
        }
        let behind = |corner: &[f64; 3]| !(corner[2] > 0.0 && corner[2] * near < 1.0);
        for (at, triangle) in surface.mesh.triangles.iter().enumerate() {
            // From outside a closed surface the back is behind the front.
            if surface.closed && surface.across[at].dot(camera.eye - surface.middles[at]) < 0.0 {
                continue;
            }
            let corners = triangle.map(|at| self.corners[at as usize]);
            match corners.iter().filter(|corner| behind(corner)).count() {
                0 => self.depths.fill(corners),
                3 => {}
                _ => {
                    let places = triangle.map(|at| surface.mesh.points[at as usize]);
                    clip(&mut self.depths, camera, places, near);
                }
            }
        }
    }
}

/// Whether what was projected lies in the picture.
fn is_in_picture([x, y, depth]: [f64; 3]) -> bool {
    x >= 0.0 && y >= 0.0 && x < SIZE[0] as f64 && y < SIZE[1] as f64 && depth > 0.0
}

/// Draws what is before the plane `near` of a triangle that it cuts.
fn clip(depths: &mut Depths, camera: &Camera, places: [DVec3; 3], near: f64) {
    let depth = places.map(|place| (place - camera.eye).dot(camera.view) - 1.01 * near);
    let (mut kept, mut count) = ([[0.0; 3]; 4], 0);
    for k in 0..3 {
        let next = (k + 1) % 3;
        if depth[k] >= 0.0 {
            kept[count] = camera.project(places[k]);
            count += 1;
        }
        if (depth[k] >= 0.0) != (depth[next] >= 0.0) {
            let share = depth[k] / (depth[k] - depth[next]);
            kept[count] = camera.project(places[k].lerp(places[next], share));
            count += 1;
        }
    }
    for k in 2..count {
        depths.fill([kept[0], kept[k - 1], kept[k]]);
    }
}
