//! How near a place, a way or a picture comes to an object: a tree of boxes over its triangles,
//! lines or points, split at the median of the longest side (C. Ericson, *Real-Time Collision
//! Detection*, 2005, 5.1.5 for the nearest point of a triangle, 6.2 for the tree).

use std::hash::{BuildHasher as _, BuildHasherDefault, DefaultHasher};

use glam::DVec3;

use crate::error::{Invalid, Result, vec_with_room};
use crate::scene::Mesh;

const LEAF: usize = 4;

/// Deeper than a tree of 2⁶⁰ primitives, split at the median.
const DEPTH: usize = 64;

/// A point, a line or a triangle; corners repeat where there are fewer than three.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Primitive(pub(crate) [DVec3; 3]);

#[derive(Debug, Clone, Copy)]
pub(crate) struct BoxNode {
    pub(crate) min: DVec3,
    pub(crate) max: DVec3,
    /// First primitive of a leaf, else the second child; the first one follows.
    pub(crate) at: u32,
    /// Primitives of a leaf; 0: not one.
    count: u32,
}

impl BoxNode {
    /// Whether a ray passes the box before `most`, as wide as it is there.
    fn is_passed(&self, from: DVec3, way: DVec3, spread: f64, most: f64) -> bool {
        let far = (self.min - from).abs().max((self.max - from).abs());
        let room = DVec3::splat(far.length() * spread);
        let [low, high] = [self.min - room, self.max + room].map(|p| (p - from) / way);
        // 0/0: along a side of the box.
        let (enter, leave) = (low.min(high), low.max(high));
        let enter = enter.to_array().into_iter().fold(0.0, f64::max);
        let leave = leave.to_array().into_iter().fold(most, f64::min);
        enter <= leave
    }
}

/// The object, ready to be asked.
#[derive(Debug)]
pub struct Clearance {
    pub(crate) primitives: Vec<Primitive>,
    nodes: Vec<BoxNode>,
}

impl Clearance {
    /// Of all triangles and lines of a mesh, or of its points if it has neither. Each place counts
    /// once: with equal ones, or triangles of which two corners are equal, every question would
    /// visit all of them.
    ///
    /// # Errors
    /// As [`Mesh::check`]; [`crate::Error::Argument`] if it is empty, [`crate::Error::Memory`].
    pub fn new(mesh: &Mesh) -> Result<Self> {
        mesh.check()?;
        let at = |index: u32| mesh.points[index as usize];
        let clouds = mesh.triangles.is_empty() && mesh.lines.is_empty();
        let points = if clouds { mesh.points.len() } else { 0 };
        let count = mesh.triangles.len() + mesh.lines.len() + points;
        if count == 0 {
            return Err(Invalid::NoGeometry.into());
        }
        let mut primitives = vec_with_room(count)?;
        let triangles = mesh.triangles.iter();
        primitives.extend(triangles.map(|t| Primitive(t.map(at)).without_equal_corners()));
        let lines = mesh.lines.iter();
        primitives.extend(lines.map(|&[a, b]| Primitive([at(a), at(b), at(b)])));
        primitives.extend(mesh.points[..points].iter().map(|p| Primitive([*p; 3])));
        Self::of(primitives)
    }

    /// Of all corners, each once.
    pub(crate) fn of_corners(&self) -> Result<Self> {
        let mut corners = vec_with_room(3 * self.primitives.len())?;
        let all = self.primitives.iter().flat_map(|primitive| primitive.0);
        corners.extend(all.map(|corner| Primitive([corner; 3])));
        Self::of(corners)
    }

    fn of(mut primitives: Vec<Primitive>) -> Result<Self> {
        drop_equal(&mut primitives)?;
        let count = primitives.len();
        let mut nodes = vec_with_room(2 * count.div_ceil(LEAF / 2) + 1)?;
        build(&mut primitives, 0, &mut nodes);
        Ok(Self { primitives, nodes })
    }

    /// The box around all of it: lowest and highest corner.
    #[must_use]
    pub fn bounds(&self) -> [DVec3; 2] {
        let all = self.nodes.first();
        all.map_or([DVec3::ZERO; 2], |node| [node.min, node.max])
    }

    /// The distance from a place to the nearest of it, if that is below `most`.
    #[must_use]
    pub fn distance(&self, place: DVec3, most: f64) -> Option<f64> {
        let mut best = most * most;
        let reach = |at: u32| {
            let node = &self.nodes[at as usize];
            (place.clamp(node.min, node.max) - place).length_squared()
        };
        let mut found = false;
        // The nearer child first: what is near rules out the rest.
        let mut stack = [(0_u32, 0.0); DEPTH];
        stack[0].1 = reach(0);
        let mut depth = 1;
        while depth > 0 {
            depth -= 1;
            let (index, far) = stack[depth];
            if far > best {
                continue;
            }
            let node = &self.nodes[index as usize];
            for primitive in self.leaf(node) {
                let far = (primitive.nearest(place) - place).length_squared();
                found |= far < best;
                best = best.min(far);
            }
            if node.count == 0 {
                let children = [index + 1, node.at].map(|at| (at, reach(at)));
                let near = usize::from(children[1].1 < children[0].1);
                (stack[depth], stack[depth + 1]) = (children[1 - near], children[near]);
                depth += 2;
            }
        }
        found.then(|| best.sqrt())
    }

    /// Whether a ray meets any of it; `way` has length 1.
    #[must_use]
    pub fn is_met(&self, from: DVec3, way: DVec3) -> bool {
        let mut met = false;
        self.walk(&mut |node, primitives| {
            if met || !node.is_passed(from, way, 0.0, f64::INFINITY) {
                return false;
            }
            let meets = |primitive: &Primitive| {
                let ahead = primitive.ahead(from, way);
                ahead.is_some_and(|(_, beside)| beside.is_none_or(|beside| beside <= 0.0))
            };
            met |= primitives.iter().any(meets);
            true
        });
        met
    }

    /// Whether the straight way from `a` to `b` goes through a triangle.
    #[must_use]
    pub fn is_crossed(&self, a: DVec3, b: DVec3) -> bool {
        let (low, high) = (a.min(b), a.max(b));
        let mut crossed = false;
        self.walk(&mut |node, primitives| {
            if crossed || node.min.cmpgt(high).any() || node.max.cmplt(low).any() {
                return false;
            }
            crossed |= primitives
                .iter()
                .any(|primitive| primitive.is_crossed(a, b));
            true
        });
        crossed
    }

    /// How far ahead a ray first meets it; `way` has length 1. Of lines and points within `spread`
    /// times the distance the one nearest to the ray by angle counts, if no triangle is before it.
    #[must_use]
    pub fn ahead(&self, from: DVec3, way: DVec3, spread: f64) -> Option<f64> {
        let mut nearest = f64::INFINITY;
        // The closest line: how far beside the ray for each unit ahead, and where.
        let mut line = (spread, f64::INFINITY);
        self.walk(&mut |node, primitives| {
            if !node.is_passed(from, way, spread, nearest) {
                return false;
            }
            for primitive in primitives {
                match primitive.ahead(from, way) {
                    Some((far, None)) => nearest = nearest.min(far),
                    Some((far, Some(off))) if (off, far) <= line => line = (off, far),
                    _ => {}
                }
            }
            true
        });
        let first = nearest.min(line.1);
        first.is_finite().then_some(first)
    }

    /// Whether any of it is on the inner side of all planes (normal · p ≥ offset).
    #[must_use]
    pub fn is_seen(&self, planes: &[(DVec3, f64); 5]) -> bool {
        let mut seen = false;
        self.walk(&mut |node, primitives| {
            // The corner of the box that is furthest in.
            let out = |(normal, offset): &(DVec3, f64)| {
                let corner = DVec3::select(normal.cmpge(DVec3::ZERO), node.max, node.min);
                normal.dot(corner) < *offset
            };
            if seen || planes.iter().any(out) {
                return false;
            }
            seen |= primitives.iter().any(|primitive| primitive.is_seen(planes));
            true
        });
        seen
    }

    /// The primitives of a leaf.
    fn leaf(&self, node: &BoxNode) -> &[Primitive] {
        // Of an inner node `at` is a node.
        match node.count as usize {
            0 => &[],
            count => &self.primitives[node.at as usize..node.at as usize + count],
        }
    }

    /// Walks the tree; `look` gets a node with a leaf's primitives and returns whether to go
    /// deeper.
    pub(crate) fn walk(&self, look: &mut dyn FnMut(&BoxNode, &[Primitive]) -> bool) {
        let mut stack = [0_u32; DEPTH];
        let mut depth = 1;
        while depth > 0 {
            depth -= 1;
            let index = stack[depth];
            let node = &self.nodes[index as usize];
            if look(node, self.leaf(node)) && node.count == 0 {
                stack[depth] = node.at;
                stack[depth + 1] = index + 1;
                depth += 2;
            }
        }
    }
}

/// Keeps the first of each that are equal, whatever the order of their corners.
fn drop_equal(primitives: &mut Vec<Primitive>) -> Result<()> {
    let hasher = BuildHasherDefault::<DefaultHasher>::default();
    let mut order: Vec<(u64, usize)> = vec_with_room(primitives.len())?;
    let hashes = primitives.iter().map(|one| hasher.hash_one(one.key()));
    order.extend(hashes.zip(0..));
    order.sort_unstable();
    let mut dropped = vec_with_room(primitives.len())?;
    dropped.resize(primitives.len(), false);
    for same in order.chunk_by(|a, b| a.0 == b.0) {
        let key = primitives[same[0].1].key();
        for &(_, at) in &same[1..] {
            dropped[at] = primitives[at].key() == key;
        }
    }
    let mut dropped = dropped.into_iter();
    primitives.retain(|_| !dropped.next().unwrap_or_default());
    Ok(())
}

/// The nodes over some primitives, which begin at `first` among all.
#[allow(clippy::cast_possible_truncation)]
fn build(primitives: &mut [Primitive], first: usize, nodes: &mut Vec<BoxNode>) {
    let all = primitives.iter().flat_map(|primitive| primitive.0);
    let start = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    let (min, max) = all.fold(start, |(min, max), p| (min.min(p), max.max(p)));
    let here = nodes.len();
    nodes.push(BoxNode {
        min,
        max,
        at: first as u32,
        count: primitives.len() as u32,
    });
    if primitives.len() <= LEAF {
        return;
    }
    let size = max - min;
    let axis = (0..3)
        .max_by(|a, b| size[*a].total_cmp(&size[*b]))
        .unwrap_or(0);
    let key = |primitive: &Primitive| primitive.0.iter().map(|p| p[axis]).sum::<f64>();
    let middle = primitives.len() / 2;
    primitives.select_nth_unstable_by(middle, |a, b| key(a).total_cmp(&key(b)));
    let (low, high) = primitives.split_at_mut(middle);
    build(low, first, nodes);
    nodes[here].at = nodes.len() as u32;
    nodes[here].count = 0;
    build(high, first + middle, nodes);
}

impl Primitive {
    /// A triangle with two equal corners as its edge.
    fn without_equal_corners(self) -> Self {
        let [a, b, c] = self.0;
        match a == b {
            true => Self([a, c, c]),
            false if b == c || c == a => Self([a, b, b]),
            false => self,
        }
    }

    /// The same for the same place, whatever the order of the corners.
    fn key(&self) -> [[u64; 3]; 3] {
        // Not -0, which is equal to 0.
        let mut corners = self
            .0
            .map(|corner| (corner + 0.0).to_array().map(f64::to_bits));
        corners.sort_unstable();
        if corners[0] == corners[1] {
            corners[1] = corners[2]; // one end of a line stands twice, either
        }
        corners
    }

    fn nearest(&self, p: DVec3) -> DVec3 {
        let [a, b, c] = self.0;
        let (ab, ac) = (b - a, c - a);
        let normal = ab.cross(ac);
        if normal.length_squared() > 0.0 {
            // Inside of all three edges: the foot on the plane.
            let inside = |from: DVec3, to: DVec3| (to - from).cross(p - from).dot(normal) >= 0.0;
            if inside(a, b) && inside(b, c) && inside(c, a) {
                return p - normal * ((p - a).dot(normal) / normal.length_squared());
            }
        }
        let on = |from: DVec3, to: DVec3| {
            let way = to - from;
            let square = way.length_squared();
            if square > 0.0 {
                from + way * ((p - from).dot(way) / square).clamp(0.0, 1.0)
            } else {
                from
            }
        };
        let far = |q: &DVec3| (*q - p).length_squared();
        let edges = [on(a, b), on(b, c), on(c, a)];
        edges
            .into_iter()
            .min_by(|a, b| far(a).total_cmp(&far(b)))
            .unwrap_or(a)
    }

    /// How far ahead a ray meets a triangle, or passes a line, then with its distance from it per unit
    /// of the way.
    pub(super) fn ahead(&self, from: DVec3, way: DVec3) -> Option<(f64, Option<f64>)> {
        let [a, b, c] = self.0.map(|corner| corner - from);
        let normal = (b - a).cross(c - a);
        let (far, off) = if normal.length_squared() > 0.0 {
            let round = |u: DVec3, v: DVec3| way.dot(u.cross(v));
            let sides = [round(a, b), round(b, c), round(c, a)];
            let inside = sides.iter().all(|s| *s >= 0.0) || sides.iter().all(|s| *s <= 0.0);
            inside.then(|| (a.dot(normal) / way.dot(normal), None))?
        } else {
            let aside = |v: DVec3| v.reject_from_normalized(way);
            let (start, side) = (aside(a), aside(b - a));
            let square = side.length_squared();
            let share = if square > 0.0 {
                (-start.dot(side) / square).clamp(0.0, 1.0)
            } else {
                0.0
            };
            let far = way.dot(a + share * (b - a));
            (far, Some((start + share * side).length() / far))
        };
        (far >= 0.0 && far.is_finite()).then_some((far, off))
    }

    /// Whether the way from `p` to `q` crosses it: to the other side, the same way round all edges.
    fn is_crossed(&self, p: DVec3, q: DVec3) -> bool {
        let [a, b, c] = self.0;
        let normal = (b - a).cross(c - a);
        let (before, behind) = (normal.dot(p - a), normal.dot(q - a));
        if before * behind > 0.0 || before == behind {
            return false;
        }
        let way = q - p;
        let round = |u: DVec3, v: DVec3| way.dot((u - p).cross(v - p));
        let sides = [round(a, b), round(b, c), round(c, a)];
        sides.iter().all(|s| *s >= 0.0) || sides.iter().all(|s| *s <= 0.0)
    }

    /// Whether any of it is within all planes, cut off one by one (Sutherland and Hodgman 1974).
    fn is_seen(&self, planes: &[(DVec3, f64); 5]) -> bool {
        // Each of five planes adds one corner at most.
        let (mut corners, mut count) = ([DVec3::ZERO; 8], 3);
        corners[..3].copy_from_slice(&self.0);
        for (normal, offset) in planes {
            let (old, before) = (corners, count);
            count = 0;
            for k in 0..before {
                let (p, q) = (old[k], old[(k + 1) % before]);
                let (a, b) = (normal.dot(p) - offset, normal.dot(q) - offset);
                if a >= 0.0 && count < 8 {
                    corners[count] = p;
                    count += 1;
                }
                if (a >= 0.0) != (b >= 0.0) && count < 8 {
                    corners[count] = p + (q - p) * (a / (a - b));
                    count += 1;
                }
            }
            if count == 0 {
                return false;
            }
        }
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::path::test_support::Random;

    fn vector(random: &mut Random) -> DVec3 {
        DVec3::from_array(std::array::from_fn(|_| 2.0 * random.unit() - 1.0))
    }

    fn soup(random: &mut Random, count: u32) -> Mesh {
        let mut points = Vec::new();
        for _ in 0..count {
            let at = vector(random);
            points.extend([(); 3].map(|()| at + 0.1 * vector(random)));
        }
        Mesh {
            points,
            triangles: (0..count).map(|k| [3 * k, 3 * k + 1, 3 * k + 2]).collect(),
            ..Mesh::default()
        }
    }

    /// The nearest point by trying many: a grid over the triangle.
    #[test]
    fn the_nearest_is_that_of_all() {
        let mut random = Random(8);
        let mesh = soup(&mut random, 300);
        let clearance = Clearance::new(&mesh).unwrap();
        for _ in 0..200 {
            let place = 1.5 * vector(&mut random);
            let mut least = f64::INFINITY;
            for triangle in &mesh.triangles {
                let [a, b, c] = triangle.map(|k| mesh.points[k as usize]);
                for i in 0..=20 {
                    for j in 0..=20 - i {
                        let (u, v) = (f64::from(i) / 20.0, f64::from(j) / 20.0);
                        let p = a + u * (b - a) + v * (c - a);
                        least = least.min((p - place).length());
                    }
                }
            }
            let found = clearance.distance(place, f64::INFINITY).unwrap();
            assert!(
                found <= least + 1e-12 && found > least - 0.02,
                "{found} {least}"
            );
            assert!(clearance.distance(place, 0.99 * found).is_none());
        }
    }

    /// Else each question would visit all of them.
    #[test]
    fn equal_and_degenerate_triangles_leave_the_tree_and_distances_stay() {
        let mut random = Random(3);
        let mut mesh = soup(&mut random, 40);
        let once = Clearance::new(&mesh).unwrap();
        let places: Vec<DVec3> = (0..50).map(|_| 1.5 * vector(&mut random)).collect();
        for k in 0..3 {
            let turned = mesh.triangles[..40]
                .iter()
                .map(|t| [t[k], t[(k + 1) % 3], t[(k + 2) % 3]]);
            let turned: Vec<_> = turned
                .flat_map(|[a, b, c]| [[a, b, c], [c, b, a]])
                .collect();
            mesh.triangles.extend(turned);
        }
        // On the edges that are there already.
        mesh.triangles
            .extend((0..40).map(|k| [3 * k, 3 * k, 3 * k + 1]));
        mesh.triangles
            .extend((0..40).map(|k| [3 * k + 1, 3 * k, 3 * k]));
        let tree = Clearance::new(&mesh).unwrap();
        assert_eq!(tree.primitives.len(), 80);
        for place in places {
            let far = |tree: &Clearance| tree.distance(place, 9.0).map(f64::to_bits);
            assert_eq!(far(&tree), far(&once));
        }
        let equal = Mesh {
            points: vec![DVec3::ZERO, -DVec3::X, DVec3::Y, -DVec3::ZERO],
            triangles: [[0, 1, 2], [2, 1, 3], [0, 3, 0], [3, 3, 3]].repeat(10_000),
            ..Mesh::default()
        };
        let tree = Clearance::new(&equal).unwrap();
        assert_eq!(tree.primitives.len(), 2, "a triangle and a point");
    }

    #[test]
    fn ways_and_pictures_meet_what_they_meet() {
        let mesh = Mesh {
            points: vec![DVec3::ZERO, DVec3::X, DVec3::Y],
            triangles: vec![[0, 1, 2]],
            ..Mesh::default()
        };
        let clearance = Clearance::new(&mesh).unwrap();
        let crossed = |x: f64, y: f64, from: f64, to: f64| {
            clearance.is_crossed(DVec3::new(x, y, from), DVec3::new(x, y, to))
        };
        assert!(crossed(0.3, 0.3, -1.0, 1.0) && crossed(0.3, 0.3, 1.0, -1.0));
        assert!(!crossed(0.6, 0.6, -1.0, 1.0) && !crossed(0.3, 0.3, 0.1, 1.0));
        // A view along −z from z = 1, with a slope of 0.2: it sees the middle of the
        // triangle and none of its corners or edges.
        let planes = |x: f64, y: f64, sign: f64| {
            let eye = DVec3::new(x, y, 1.0);
            let side = |n: DVec3| (n, n.dot(eye));
            [
                side(DVec3::new(1.0, 0.0, -0.2 * sign)),
                side(DVec3::new(-1.0, 0.0, -0.2 * sign)),
                side(DVec3::new(0.0, 1.0, -0.2 * sign)),
                side(DVec3::new(0.0, -1.0, -0.2 * sign)),
                side(DVec3::new(0.0, 0.0, -sign)),
            ]
        };
        assert!(clearance.is_seen(&planes(0.25, 0.25, 1.0)));
        assert!(!clearance.is_seen(&planes(1.3, 0.25, 1.0)));
        assert!(!clearance.is_seen(&planes(0.25, 0.25, -1.0)));
        assert!(Clearance::new(&Mesh::default()).is_err());
    }

    /// Triangles: where Cramer's rule puts a ray in the plane of each; lines and points:
    /// along a dense row of places on them.
    #[test]
    fn a_ray_meets_what_is_first() {
        let mut random = Random(77);
        let mesh = soup(&mut random, 300);
        let tree = Clearance::new(&mesh).unwrap();
        let mut met = 0;
        for _ in 0..400 {
            let from = 1.5 * vector(&mut random);
            let Some(way) = (0.3 * vector(&mut random) - from).try_normalize() else {
                continue;
            };
            let mut first = f64::INFINITY;
            for corners in &mesh.triangles {
                let [a, b, c] = corners.map(|at| mesh.points[at as usize]);
                let all = glam::DMat3::from_cols(b - a, c - a, -way);
                let at = all.inverse() * (from - a);
                if at.x >= 0.0 && at.y >= 0.0 && at.x + at.y <= 1.0 && at.z >= 0.0 {
                    first = first.min(at.z);
                }
            }
            let found = tree.ahead(from, way, 0.0).unwrap_or(f64::INFINITY);
            met += u32::from(first.is_finite());
            assert_eq!(tree.is_met(from, way), found.is_finite());
            assert!(
                found == first || (found - first).abs() < 1e-9 * first,
                "{found} {first}"
            );
        }
        assert!(met > 50, "{met}");

        let points = vec![DVec3::new(0.0, 0.1, 2.0), DVec3::new(1.0, 0.1, 3.0)];
        let line = Mesh {
            points: points.clone(),
            lines: vec![[0, 1]],
            ..Mesh::default()
        };
        let tree = Clearance::new(&line).unwrap();
        for k in 0..50 {
            let way = DVec3::new(f64::from(k) / 100.0, 0.0, 1.0).normalize();
            let near = (0..=100_000).map(|part| {
                let place = points[0].lerp(points[1], f64::from(part) / 100_000.0);
                let far = way.dot(place);
                (place.distance(far * way), far)
            });
            let (off, far) = near.min_by(|a, b| a.0.total_cmp(&b.0)).unwrap();
            let seen = off <= 0.04 * far;
            assert_eq!(tree.ahead(DVec3::ZERO, way, 0.04).is_some(), seen, "{k}");
            if let Some(found) = tree.ahead(DVec3::ZERO, way, 0.2) {
                assert!((found - far).abs() < 1e-3, "{k}: {found} {far}");
            }
        }
        assert!(tree.ahead(DVec3::ZERO, DVec3::NEG_Z, 0.2).is_none());
    }
}
