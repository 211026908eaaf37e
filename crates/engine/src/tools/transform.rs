//! Points moved, turned, scaled, mirrored or deformed (lecture 9.3.1), with their tangents and, if
//! asked, with what their cameras see. A tangent goes by the derivative of the map: its matrix, or
//! for deformations differences of the fourth order (1e-9 of its length).

use glam::{DMat3, DMat4, DQuat, DVec3};

use super::keep::picked;
use crate::deform::{Bounds, Deformation};
use crate::error::{Invalid, Place, Result, vec_with_room};
use crate::math::orientation::{unit, wrap_degrees};
use crate::path::{
    CameraPath, Orientation, SupportPoint, Tangents, Target, Up, Velocities, ahead, alignment,
};

/// Columns of a matrix without shear are at right angles within this.
const SQUARE: f64 = 1e-9;

/// A side pressed to this share of another is pressed flat.
const FLAT: f64 = 1e-12;

/// The largest scale: from the smallest space to the largest (1e60), and there from what is resolved
/// to the largest coordinate (1e18).
const LARGE: f64 = 1e78;

/// Step of the differences, in the largest side of the box.
const STEP: f64 = 1e-3;

/// Points with their numbers.
pub type Changed = Vec<(usize, SupportPoint)>;

/// A map of space: where a place goes, and the derivative there.
struct Map<'a> {
    place: &'a dyn Fn(DVec3) -> DVec3,
    derivative: &'a dyn Fn(DVec3) -> DMat3,
    /// The same derivative everywhere.
    linear: bool,
}

/// The matrix that scales about a place, turns about it, and then moves by a way.
#[must_use]
pub fn matrix(about: DVec3, scale: DVec3, turn: DQuat, by: DVec3) -> DMat4 {
    DMat4::from_scale_rotation_translation(scale, turn, about + by)
        * DMat4::from_translation(-about)
}

/// Checks that a matrix only moves, turns, scales and mirrors.
///
/// # Errors
/// [`crate::Error::Argument`] if it is not finite, shears, projects or presses flat.
pub fn check_matrix(matrix: &DMat4) -> Result<()> {
    if !matrix.is_finite() {
        return Err(Invalid::MatrixNotFinite.into());
    }
    let [x, y, z] = [0, 1, 2].map(|k| matrix.col(k).truncate());
    let square = |a: DVec3, b: DVec3| a.dot(b).abs() <= SQUARE * a.length() * b.length();
    let lengths = DVec3::new(x.length(), y.length(), z.length());
    let (least, most) = (lengths.min_element(), lengths.max_element());
    if !(1.0 / LARGE..=LARGE).contains(&most) {
        return Err(Invalid::MatrixScale.into());
    }
    if !(least > FLAT * most) {
        return Err(Invalid::MatrixFlat.into());
    }
    let row = matrix.row(3).to_array();
    if row != [0.0, 0.0, 0.0, 1.0] || !square(x, y) || !square(y, z) || !square(z, x) {
        return Err(Invalid::Matrix.into());
    }
    Ok(())
}

/// Some points of a path, moved by a matrix.
///
/// # Errors
/// [`crate::Error::Argument`] as [`check_matrix`], if no point is selected, or where a point would
/// lie on its own target; [`crate::Error::Range`], [`crate::Error::Memory`].
pub fn transform(
    path: &CameraPath,
    points: &[usize],
    matrix: &DMat4,
    with_targets: bool,
) -> Result<Changed> {
    let picked = picked(path, points)?;
    check_matrix(matrix)?;
    let linear = DMat3::from_mat4(*matrix);
    let map = Map {
        place: &|place| matrix.transform_point3(place),
        derivative: &|_| linear,
        linear: true,
    };
    mapped(path, &picked, &map, with_targets)
}

/// Some points of a path, deformed. Without a box that of these points' positions.
///
/// # Errors
/// As [`transform`].
pub fn deform(
    path: &CameraPath,
    points: &[usize],
    deformation: &Deformation,
    bounds: Option<Bounds>,
    with_targets: bool,
) -> Result<Changed> {
    let mut places = vec_with_room(path.points.len())?;
    let picked = picked(path, points)?;
    for (point, _) in path
        .points
        .iter()
        .zip(&picked)
        .filter(|(_, picked)| **picked)
    {
        places.push(point.position);
    }
    let bounds = bounds.unwrap_or_else(|| Bounds::of(&places));
    let place = |place: DVec3| {
        let mut place = [place];
        deformation.apply(&bounds, &mut place);
        place[0]
    };
    let derivative = |at: DVec3| {
        let columns =
            [0, 1, 2].map(|axis| slope(&place, &bounds, 1e-3 * path.space.half_size, at, axis));
        DMat3::from_cols_array_2d(&columns.map(|column| column.to_array()))
    };
    let map = Map {
        place: &place,
        derivative: &derivative,
        linear: false,
    };
    mapped(path, &picked, &map, with_targets)
}

/// How the image of a place changes along an axis. At a side of the box a deformation may have an
/// edge, and the outermost points lie there: it is the slope on their own side. A box counts as at
/// least so large.
fn slope(
    place: &impl Fn(DVec3) -> DVec3,
    bounds: &Bounds,
    least: f64,
    at: DVec3,
    axis: usize,
) -> DVec3 {
    let size = bounds.max() - bounds.min();
    let mut step = STEP * size.max_element().max(least);
    if size[axis] > 0.0 {
        step = step.min(size[axis] / 8.0);
    }
    let (low, high) = (at[axis] - bounds.min()[axis], bounds.max()[axis] - at[axis]);
    let near = |away: f64| size[axis] > 0.0 && away.abs() < step;
    let way = match (near(low), near(high)) {
        (true, _) => step.copysign(if low < 0.0 { -1.0 } else { 1.0 }),
        (_, true) => step.copysign(if high < 0.0 { 1.0 } else { -1.0 }),
        _ => {
            let at = |h: f64| place(at + DVec3::AXES[axis] * h);
            let central = |h: f64| (at(h) - at(-h)) / (2.0 * h);
            return (4.0 * central(step / 2.0) - central(step)) / 3.0;
        }
    };
    let ahead = |steps: f64| place(at + DVec3::AXES[axis] * (steps * way));
    let [a, b, c, d, e] = [0.0, 1.0, 2.0, 3.0, 4.0].map(ahead);
    (-25.0 * a + 48.0 * b - 36.0 * c + 16.0 * d - 3.0 * e) / (12.0 * way)
}

fn mapped(
    path: &CameraPath,
    picked: &[bool],
    map: &Map<'_>,
    with_targets: bool,
) -> Result<Changed> {
    let mut changed = vec_with_room(picked.iter().filter(|picked| **picked).count())?;
    for (number, _) in picked.iter().enumerate().filter(|(_, picked)| **picked) {
        let old = &path.points[number];
        let mut new = old.try_clone()?;
        new.position = (map.place)(old.position);
        let derivative = (map.derivative)(old.position);
        new.tangents = old.tangents.map(|own| Tangents {
            before: derivative * own.before,
            after: derivative * own.after,
        });
        if with_targets {
            for (at, orientation) in new.orientations.iter_mut().enumerate() {
                let view = ahead::view(path, number, at);
                *orientation = seen(
                    orientation,
                    (old.position, view),
                    map,
                    (&derivative, path.space.up),
                )?;
            }
        }
        new.check(path.space)
            .map_err(|error| error.at(Place::Point(number)))?;
        changed.push((number, new));
    }
    if with_targets && alignment::any(path) {
        turn_ups(path, map, &mut changed)?;
    }
    Ok(changed)
}

/// Gives changed points whose up is not the axis the rolls with which their ups follow.
fn turn_ups(path: &CameraPath, map: &Map<'_>, changed: &mut Changed) -> Result<()> {
    let mut whole = path.try_clone()?;
    for (number, point) in changed.iter() {
        whole.points[*number] = point.try_clone()?;
    }
    let old = alignment::ups(path)?;
    let mut wanted = vec_with_room(old.len())?;
    for (number, point) in path.points.iter().enumerate() {
        let goes = changed.iter().any(|(at, _)| *at == number);
        let derivative = (map.derivative)(point.position);
        for _ in &point.orientations {
            let up = old[wanted.len()];
            wanted.push(goes.then_some(derivative * up));
        }
    }
    alignment::keep_ups(&mut whole, &wanted)?;
    for (number, point) in changed.iter_mut() {
        point
            .orientations
            .clone_from(&whole.points[*number].orientations);
    }
    Ok(())
}

/// An orientation whose camera moves with it: target, roll, velocities.
fn seen(
    old: &Orientation,
    (position, view): (DVec3, DVec3),
    map: &Map<'_>,
    (derivative, axis): (&DMat3, Up),
) -> Result<Orientation> {
    let mut new = old.clone();
    new.target = match old.target {
        Target::Absolute(target) => Target::Absolute((map.place)(target)),
        Target::Relative(offset) if map.linear => Target::Relative(*derivative * offset),
        Target::Relative(offset) => {
            Target::Relative((map.place)(position + offset) - (map.place)(position))
        }
    };
    if !old.own.up.is_level() {
        let direction = |at, v| (map.derivative)(at) * v;
        let up = old.own.up.map(map.place, direction)?;
        new.own = new.own.with(|own| own.up = up)?;
    }
    let scale = derivative.x_axis.length();
    let turn = *derivative * (1.0 / scale);
    let rigid = map.linear && (turn.transpose() * turn).abs_diff_eq(DMat3::IDENTITY, SQUARE);
    if rigid && turn.abs_diff_eq(DMat3::IDENTITY, 0.0) {
        return Ok(new);
    }
    let new_view = if old.own.ahead.is_some() {
        *derivative * view
    } else {
        new.target.offset_from((map.place)(position))
    };
    if let Some(level) = old.own.up.level(axis) {
        let up = *derivative * level.up_from_roll(view, old.roll.to_radians());
        if new_view.cross(up) != DVec3::ZERO {
            new.roll = wrap_degrees(level.roll_from_up(unit(new_view), up).to_degrees());
        }
    }
    if old.own.is_empty() {
        return Ok(new);
    }
    let hand = turn.determinant().signum();
    new.own = new.own.with(|own| {
        own.roll_slope = own.roll_slope.map(|slope| hand * slope);
        if !rigid {
            own.velocities = None;
        }
        own.velocities = own.velocities.map(|own| Velocities {
            reach: hand * (turn * own.reach),
            leave: hand * (turn * own.leave),
        });
        if !rigid || hand < 0.0 {
            own.turning = None;
        } else if let Some(part) = &mut own.turning {
            // Its quaternions are those of upright axes.
            let turn = DQuat::from_mat3(&turn);
            let xyz = axis.upright(DVec3::new(turn.x, turn.y, turn.z));
            let turn = DQuat::from_xyzw(xyz.x, xyz.y, xyz.z, turn.w);
            part.control = part.control.map(|q| (turn * q).normalize());
        }
    })?;
    Ok(new)
}

#[cfg(test)]
#[path = "transform_tests.rs"]
mod tests;
