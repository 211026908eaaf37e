//! Where a camera might stand and what it might look at, before anybody knows what that shows.

use glam::DVec3;

use super::round::STEEPEST;
use crate::deform::Bounds;
use crate::error::{Result, vec_with_room};
use crate::path::Up;
use crate::planner::directions::directions;
use crate::tools::clearance::Clearance;
use crate::tools::watch::Watch;

/// Directions from which an object is tried from outside, at the tour's distance and nearer.
const AROUND: [(usize, f64); 2] = [(200, 1.0), (100, 0.45)];

/// Cells of the grid in an object, along its longest side.
const CELLS: f64 = 14.0;

/// Places in an object from which views are tried.
const INSIDE: usize = 40;

/// Directions of views from a place in an object: how many round, and how steep, in degrees.
const VIEWS: [(u32, f64); 3] = [(8, 0.0), (6, 42.0), (6, -42.0)];

/// How many rays are cast from a place, and how many must meet the object if it is inside.
const RAYS: [usize; 2] = [64, 46];

/// A view that may become part of a tour.
#[derive(Clone, Copy, Debug)]
pub(super) struct View {
    /// Index of the place where it stands.
    pub at: usize,
    pub target: DVec3,
}

/// Whether a view is too near to straight up or down.
pub(super) fn is_steep(eye: DVec3, target: DVec3, up: Up) -> bool {
    let view = (target - eye).normalize_or_zero();
    !(view.dot(up.world(DVec3::Y)).abs() <= STEEPEST)
}

/// What a camera outside first looks at: straight ahead of it, but not at the ends of the object.
pub(super) fn ahead(bounds: &Bounds, eye: DVec3) -> DVec3 {
    let (low, high) = (bounds.min(), bounds.max());
    let (middle, half) = (low + 0.5 * (high - low), 0.5 * (high - low));
    middle + (eye - middle).clamp(-0.4 * half, 0.4 * half)
}

/// Places around an object, all as far from it.
pub(super) fn outside(
    object: &Clearance,
    bounds: &Bounds,
    distance: f64,
    (up, effort): (Up, f64),
    watch: &Watch<'_>,
) -> Result<(Vec<DVec3>, Vec<View>)> {
    let half = 0.5 * (bounds.max() - bounds.min());
    let middle = bounds.min() + half;
    // Near to a large object it takes more.
    let more = effort * (half.length() / distance).clamp(1.0, 2.0);
    let all: usize = AROUND.iter().map(|(count, _)| scaled(*count, more)).sum();
    let (mut places, mut views) = (vec_with_room(all)?, vec_with_room(all)?);
    for (count, share) in AROUND {
        for way in directions(scaled(count, more)) {
            watch.check()?;
            let far = share * distance;
            let start = middle + 3_f64.sqrt() * half * way + far * way;
            let Some(eye) = at_distance(object, start, ahead(bounds, start), far) else {
                continue;
            };
            let target = ahead(bounds, eye);
            if !is_steep(eye, target, up) {
                views.push(View {
                    at: places.len(),
                    target,
                });
                places.push(eye);
            }
        }
    }
    Ok((places, views))
}

#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // a few hundred
fn scaled(count: usize, by: f64) -> usize {
    (count as f64 * by) as usize
}

/// The place on the line from a start to a target at a distance from the object, found in steps
/// that go nowhere nearer (sphere tracing: Hart 1996).
fn at_distance(object: &Clearance, start: DVec3, target: DVec3, far: f64) -> Option<DVec3> {
    let way = (target - start).try_normalize()?;
    let mut eye = start;
    for _ in 0..40 {
        let gap = object.distance(eye, f64::INFINITY)? - far;
        if gap.abs() <= 1e-3 * far {
            return Some(eye);
        }
        eye += gap * way;
    }
    let near = object.distance(eye, f64::INFINITY)?;
    (near > 0.8 * far && near < 2.0 * far).then_some(eye)
}

/// The free places of a grid in an object and how far the farthest is from it, with the views from
/// some of them.
pub(super) fn inside(
    object: &Clearance,
    bounds: &Bounds,
    least: f64,
    up: Up,
    watch: &Watch<'_>,
) -> Result<(Vec<DVec3>, Vec<View>, f64)> {
    let (low, size) = (bounds.min(), bounds.max() - bounds.min());
    let step = size.max_element() / CELLS;
    let counts = (size / step)
        .to_array()
        .map(|cells| scaled(1, cells.ceil().max(1.0)));
    let mut found: Vec<(DVec3, f64)> = vec_with_room(counts.iter().product())?;
    for x in 0..counts[0] {
        for y in 0..counts[1] {
            for z in 0..counts[2] {
                watch.check()?;
                let cells = [x, y, z].map(|k| k as f64 + 0.5);
                let share = DVec3::from_array(cells) / DVec3::from(counts.map(|k| k as f64));
                let place = low + size * share;
                let far = object.distance(place, f64::INFINITY).unwrap_or(0.0);
                if far > least && is_inside(object, place) {
                    found.push((place, far));
                }
            }
        }
    }
    let widest = found.iter().fold(0.0, |most: f64, (_, far)| most.max(*far));
    found.retain(|(_, far)| *far > 0.2 * widest);
    // The freest first, then always the one that is farthest from all before.
    let mut apart: Vec<f64> = vec_with_room(found.len())?;
    apart.extend(found.iter().map(|(_, far)| far.min(0.5 * widest)));
    let mut views = vec_with_room(INSIDE * 20)?;
    let mut places = vec_with_room(found.len())?;
    places.extend(found.iter().map(|(place, _)| *place));
    let mut first = true;
    for _ in 0..INSIDE {
        let last = |a: &usize, b: &usize| apart[*a].total_cmp(&apart[*b]).then(b.cmp(a));
        let Some(at) = (0..places.len()).max_by(last) else {
            break;
        };
        if !(first || apart[at] > 0.0) {
            break;
        }
        for (far, place) in apart.iter_mut().zip(&places) {
            let near = place.distance(places[at]);
            *far = if first { near } else { far.min(near) };
        }
        first = false;
        watch.check()?;
        look_round(object, at, (places[at], up), widest, &mut views);
    }
    Ok((places, views, widest))
}

fn is_inside(object: &Clearance, place: DVec3) -> bool {
    let met = |way: &DVec3| object.is_met(place, *way);
    directions(RAYS[0]).filter(met).count() >= RAYS[1]
}

/// Views from a place in all directions.
fn look_round(
    object: &Clearance,
    at: usize,
    (eye, up): (DVec3, Up),
    far: f64,
    views: &mut Vec<View>,
) {
    for (count, steep) in VIEWS {
        let (rise, flat) = f64::to_radians(steep).sin_cos();
        for k in 0..count {
            let (sin, cos) = (f64::from(k) * std::f64::consts::TAU / f64::from(count)).sin_cos();
            views.push(View {
                at,
                target: DVec3::new(flat * cos, rise, flat * sin),
            });
        }
    }
    let from = views.len()
        - VIEWS
            .iter()
            .map(|(count, _)| *count as usize)
            .sum::<usize>();
    for view in &mut views[from..] {
        let way = up.world(view.target);
        let ahead = object.ahead(eye, way, 0.0).unwrap_or(far);
        view.target = eye + way * ahead;
    }
}
