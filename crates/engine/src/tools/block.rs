//! Blocks: parts of paths taken out, put in, turned round, repeated (thesis chapter 8).
//!
//! Points keep the curve that they had: where the rule of its kind would give others, they own
//! their tangents. So a block has exactly its shape in another path, and so has that path.

use std::collections::HashSet;
use std::ops::Range;
use std::sync::Arc;

use glam::{DMat4, DQuat, DVec3};

pub use super::backwards::reverse;
use super::keep::{self, check_upright, keep_tangents, shape_in, tangents};
use super::transform::transform;
use crate::error::{
    Error, Invalid, OutOfRange, Quantity, Result, TooMany, can_allocate, vec_with_room,
};
use crate::limits::{MAX_NAME_BYTES, MAX_POINTS};
use crate::path::up_vector::check_ups;
use crate::path::{CameraPath, SupportPoint, Tangents, Up, alignment};
use crate::shared_list::SharedList;

/// The least length that has a direction, in units of `half_size`.
const LEAST: f64 = 1e-9;

/// How a block is put in.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Fit {
    /// Unchanged.
    None,
    /// Moved, so that it begins where the path is.
    #[default]
    Move,
    /// Turned too, so that it goes on in the direction of travel.
    Turn,
    /// Moved, turned and scaled, so that it also ends at the next point.
    Scale,
}

/// A block that has been put in.
#[derive(Debug)]
pub struct Inserted {
    /// The whole path.
    pub path: CameraPath,
    /// The number of the first new point.
    pub at: usize,
    /// How many are new.
    pub count: usize,
    /// Old points that have changed, by their numbers in the new path.
    pub changed: Vec<usize>,
}

/// The points from `first` to `last` as an open path; on a closed one a range may lead over the
/// seam. The curve stays; turning and pace next to its ends are as at the ends of any path.
///
/// # Errors
/// [`Error::Range`] if there is no such range or it has fewer than two points; [`Error::Memory`].
pub fn extract(path: &CameraPath, first: usize, last: usize) -> Result<CameraPath> {
    let count = path.points.len();
    if let Some(&point) = [first, last].iter().find(|&&point| point >= count) {
        return Err(path.no_point(point));
    }
    if first > last && !path.closed {
        return Err(OutOfRange::PointOrder { first, last }.into());
    }
    let taken = (last + count - first) % count + 1;
    let all = tangents(path)?;
    let mut points = SharedList::new();
    let mut wanted = vec_with_room(taken)?;
    for k in 0..taken {
        let point = (first + k) % count;
        points.push(Arc::clone(path.points.get_shared(point)));
        wanted.push(all[point]);
    }
    let mut block = CameraPath {
        points,
        closed: false,
        ..*path
    };
    block.check()?;
    keep_tangents(&mut block, &wanted)?;
    check_ups(&block)?;
    let ups = keep::ups(path)?;
    if !ups.is_empty() {
        let mut taken_ups = vec_with_room(taken)?;
        taken_ups.extend((0..taken).map(|k| ups[(first + k) % count].as_slice()));
        alignment::keep_ups(&mut block, &taken_ups.concat())?;
    }
    Ok(block)
}

/// The same way as an open path: a closed one ends where it begins.
fn opened(path: &CameraPath) -> Result<CameraPath> {
    let mut open = path.try_clone()?;
    if !path.closed {
        return Ok(open);
    }
    let mut wanted = tangents(path)?;
    wanted.try_reserve(1)?;
    wanted.push(wanted[0]);
    let mut end = path.points[0].try_clone()?;
    end.orientations.truncate(1);
    end.name = None;
    open.points.try_reserve(1)?;
    open.points.push(end);
    open.closed = false;
    keep_tangents(&mut open, &wanted)?;
    Ok(open)
}

/// The rotation from one direction to another, about the vertical first, so that level stays level.
fn level_turn(axis: Up, from: DVec3, to: DVec3) -> DQuat {
    let [from, to] = [from, to].map(|v| axis.upright(v.normalize()));
    let turn = upright_turn(from, to);
    let v = axis.world(DVec3::new(turn.x, turn.y, turn.z));
    DQuat::from_xyzw(v.x, v.y, v.z, turn.w)
}

fn upright_turn(from: DVec3, to: DVec3) -> DQuat {
    let heading = |v: DVec3| (v.x.hypot(v.z) > 1e-9).then(|| v.x.atan2(v.z));
    let (Some(a), Some(b)) = (heading(from), heading(to)) else {
        return DQuat::from_rotation_arc(from, to);
    };
    let yaw = DQuat::from_rotation_y(b - a);
    DQuat::from_rotation_arc(yaw * from, to) * yaw
}

/// The direction in which the path reaches a point, or leaves its first one.
fn travel(path: &CameraPath, at: usize) -> Result<DVec3> {
    let own = crate::path::curve::tangents(path, at);
    let first = at == 0 && !path.closed;
    let tangent = if first { own.after } else { own.before };
    let found = if tangent.length() > LEAST * path.space.half_size {
        tangent
    } else {
        direction(path, at, first)
    };
    if found == DVec3::ZERO {
        return Err(no_direction());
    }
    Ok(found.normalize())
}

fn no_direction() -> Error {
    Invalid::NoDirection.into()
}

/// The chord beside a point.
fn direction(path: &CameraPath, at: usize, forwards: bool) -> DVec3 {
    let count = path.points.len();
    let beside = if forwards { at + 1 } else { at + count - 1 } % count;
    let chord = path.points[beside].position - path.points[at].position;
    if forwards { chord } else { -chord }
}

/// The matrix that brings a block to its place behind point `at`.
fn placing(path: &CameraPath, at: usize, block: &CameraPath, fit: Fit) -> Result<DMat4> {
    let start = block.points[0].position;
    let place = path.points[at].position;
    let about = |turn: DQuat, scale: f64| {
        DMat4::from_translation(place)
            * DMat4::from_scale_rotation_translation(DVec3::splat(scale), turn, DVec3::ZERO)
            * DMat4::from_translation(-start)
    };
    Ok(match fit {
        Fit::None => DMat4::IDENTITY,
        Fit::Move => DMat4::from_translation(place - start),
        Fit::Turn => about(
            level_turn(path.space.up, travel(block, 0)?, travel(path, at)?),
            1.0,
        ),
        Fit::Scale => {
            let next = at + 1;
            if next >= path.points.len() && !path.closed {
                return Err(OutOfRange::NoNextPoint.into());
            }
            let way = path.points[next % path.points.len()].position - place;
            let chord = block.points[block.points.len() - 1].position - start;
            let least = [path, block].map(|path| LEAST * path.space.half_size);
            if !(way.length() > least[0] && chord.length() > least[1]) {
                return Err(no_direction());
            }
            about(
                level_turn(path.space.up, chord, way),
                way.length() / chord.length(),
            )
        }
    })
}

/// A block put in behind a point (`docs/reference/tools.md`, blocks); `with_targets` moves its targets, too.
///
/// # Errors
/// [`Error::Range`], [`Error::Argument`], [`Error::Limit`] or [`Error::Memory`].
pub fn insert(
    path: &CameraPath,
    at: usize,
    block: &CameraPath,
    fit: Fit,
    with_targets: bool,
) -> Result<Inserted> {
    if at >= path.points.len() {
        return Err(path.no_point(at));
    }
    block.check()?;
    check_upright(&[path, block])?;
    let block = placed(path, at, block, fit, with_targets)?;
    let put = usize::from(fit != Fit::None)..block.points.len() - usize::from(fit == Fit::Scale);
    let count = put.len();
    if path.points.len() + count > MAX_POINTS {
        return Err(TooMany::SupportPoints.into());
    }
    let merge = Merge {
        path,
        at,
        block: &block,
        put,
        fit,
    };
    let mut points = merge.points()?;
    merge.hand_on_pace(&mut points)?;
    let mut whole = CameraPath { points, ..*path };
    whole.check()?;
    keep_tangents(&mut whole, &merge.tangents()?)?;
    check_ups(&whole)?;
    merge.keep_ups(&mut whole)?;
    let mut changed = vec_with_room(path.points.len())?;
    for (number, old) in path.points.iter().enumerate() {
        let new = number + if number > at { count } else { 0 };
        if whole.points[new] != *old {
            changed.push(new);
        }
    }
    Ok(Inserted {
        path: whole,
        at: at + 1,
        count,
        changed,
    })
}

/// A block in the path's space, opened and brought to its place behind point `at`.
fn placed(
    path: &CameraPath,
    at: usize,
    block: &CameraPath,
    fit: Fit,
    with_targets: bool,
) -> Result<CameraPath> {
    let mut block = opened(block)?;
    let matrix = placing(path, at, &block, fit)?;
    block.space = path.space;
    let mut all = vec_with_room(block.points.len())?;
    all.extend(0..block.points.len());
    for (number, point) in transform(&block, &all, &matrix, with_targets)? {
        block.points[number] = point;
    }
    Ok(block)
}

/// Two paths that become one.
struct Merge<'a> {
    path: &'a CameraPath,
    /// The point behind which the block is put.
    at: usize,
    block: &'a CameraPath,
    /// The points of the block that are put in; its others are points of the path.
    put: Range<usize>,
    fit: Fit,
}

impl Merge<'_> {
    fn points(&self) -> Result<SharedList<SupportPoint>> {
        let mut of_path = self.path.points.shared().cloned();
        let before = of_path.by_ref().take(self.at + 1);
        let mut points = SharedList::new();
        points.try_reserve(self.path.points.len() + self.put.len())?;
        points.extend(before);
        let mut names = Names::of(self.path)?;
        for point in self.block.points.range(self.put.clone()) {
            let mut new = point.try_clone()?;
            new.curve = shape_in(self.path, self.block, new.curve);
            new.name = new.name.map(|name| names.unique(name)).transpose()?;
            points.push(new);
        }
        points.extend(of_path);
        Ok(points)
    }

    /// The tangents that all points had, joined where the two meet.
    fn tangents(&self) -> Result<Vec<Option<Tangents>>> {
        let (path, at, fit, count) = (self.path, self.at, self.fit, self.put.len());
        let (mut old, mine) = (tangents(path)?, tangents(self.block)?);
        if path.curve.is_straight() {
            for (old, point) in old.iter_mut().zip(&path.points) {
                *old = old.filter(|_| point.tangents.is_some());
            }
        }
        let mut wanted = vec_with_room(old.len() + count)?;
        wanted.extend_from_slice(&old[..=at]);
        wanted.extend_from_slice(&mine[self.put.clone()]);
        wanted.extend_from_slice(&old[at + 1..]);
        let first = at == 0 && !path.closed;
        if let (true, Some(there), Some(block)) = (fit != Fit::None, wanted[at], mine[0]) {
            wanted[at] = Some(joined(there.before, block.after, first, fit));
        }
        let next = (at + count + 1) % wanted.len();
        let end = mine.get(self.put.end).copied().flatten();
        if let (true, Some(there), Some(block)) = (fit == Fit::Scale, wanted[next], end) {
            wanted[next] = Some(joined(block.before, there.after, false, fit));
        }
        if let (Fit::None, Some(Some(own))) = (fit, wanted.get_mut(at + 1)) {
            own.before = own.after;
        }
        if fit != Fit::Scale
            && let Some(Some(own)) = wanted.get_mut(at + count)
        {
            own.after = if count > 0 { own.before } else { own.after };
        }
        Ok(wanted)
    }

    /// The pace of the way that began at the joint goes on behind the block.
    fn hand_on_pace(&self, points: &mut SharedList<SupportPoint>) -> Result<()> {
        let Some(begin) = points[self.at].orientations.last_mut() else {
            return Ok(());
        };
        begin.own = begin.own.with(|own| {
            own.frames = 0;
            own.curve_time = None;
            own.turning = None;
            own.velocities = None;
        })?;
        let pace = self.block.points[0].orientations.last();
        let Some(pace) = pace.filter(|_| self.fit != Fit::None) else {
            return Ok(());
        };
        let (speeds, rest) = (begin.speeds, begin.own.pace.clone());
        let locked = begin.own.locked;
        begin.speeds = pace.speeds;
        begin.own = begin.own.with(|own| {
            own.pace = pace.own.pace.clone();
            own.frames = pace.own.frames;
            own.locked = pace.own.locked;
            own.curve_time = pace.own.curve_time;
        })?;
        let count = self.put.len();
        if self.fit != Fit::Scale
            && count > 0
            && let Some(end) = points[self.at + count].orientations.last_mut()
        {
            end.speeds = speeds;
            end.own = end.own.with(|own| {
                own.pace = rest;
                own.frames = 0;
                own.locked = locked;
                own.curve_time = None;
            })?;
        }
        Ok(())
    }

    fn keep_ups(&self, whole: &mut CameraPath) -> Result<()> {
        if !alignment::any(whole) {
            return Ok(());
        }
        let (old, mine) = (alignment::ups(self.path)?, alignment::ups(self.block)?);
        let before = |path: &CameraPath, point: usize| -> usize {
            let points = path.points.range(..point);
            points.map(|point| point.orientations.len()).sum()
        };
        let split = before(self.path, self.at + 1);
        let [from, to] = [self.put.start, self.put.end].map(|k| before(self.block, k));
        let all = [&old[..split], &mine[from..to], &old[split..]].concat();
        let all: Vec<Option<DVec3>> = all.into_iter().map(Some).collect();
        alignment::keep_ups(whole, &all)?;
        Ok(())
    }
}

/// Tangents of a point at which two ways meet: one direction, each its length.
fn joined(before: DVec3, after: DVec3, first: bool, fit: Fit) -> Tangents {
    if first {
        return Tangents {
            before: after,
            after,
        };
    }
    let (a, b) = (before.normalize_or_zero(), after.normalize_or_zero());
    let middle = match fit {
        Fit::Turn if a != DVec3::ZERO => a,
        _ => (a + b).try_normalize().unwrap_or(b),
    };
    Tangents {
        before: if middle == a {
            before
        } else {
            before.length() * middle
        },
        after: after.length() * middle,
    }
}

struct Names(HashSet<String>);

impl Names {
    fn of(path: &CameraPath) -> Result<Self> {
        let named = || path.points.iter().filter_map(|point| point.name.as_ref());
        let bytes: usize = named().map(String::len).sum();
        // Without memory the set would abort.
        can_allocate(bytes + 64 * path.points.len())?;
        Ok(Self(named().cloned().collect()))
    }

    fn unique(&mut self, name: String) -> Result<String> {
        can_allocate(2 * name.len() + 256)?;
        let mut found = name.clone();
        let mut number = 2;
        while self.0.contains(&found) {
            let end = format!(" ({number})");
            let mut keep = name.len().min(MAX_NAME_BYTES - end.len());
            while !name.is_char_boundary(keep) {
                keep -= 1;
            }
            found = format!("{}{end}", &name[..keep]);
            number += 1;
        }
        self.0.insert(found.clone());
        Ok(found)
    }
}

/// A path several times, each from where the one before ended, its targets with it.
///
/// # Errors
/// [`Error::Range`], [`Error::Limit`], [`Error::Memory`].
pub fn repeat(path: &CameraPath, times: usize) -> Result<CameraPath> {
    let count = path.points.len();
    if times == 0 || times > MAX_POINTS {
        return Err(OutOfRange::Between(Quantity::Times, 1.0, MAX_POINTS as f64).into());
    }
    if count.saturating_mul(times) > MAX_POINTS {
        return Err(TooMany::SupportPoints.into());
    }
    let mut all = path.try_clone()?;
    if path.closed {
        let mut names = Names::of(path)?;
        all.points.try_reserve(count * (times - 1))?;
        for at in count..count * times {
            let mut point = path.points[at % count].try_clone()?;
            if let Some(name) = point.name {
                point.name = Some(names.unique(name)?);
            }
            all.points.push(point);
        }
        return Ok(all);
    }
    let mut done = 1;
    while done < times {
        let more = done.min(times - done);
        let block = extract(&all, 0, more * (count - 1))?;
        let last = all.points.len() - 1;
        all = insert(&all, last, &block, Fit::Move, true)?.path;
        done += more;
    }
    Ok(all)
}

#[cfg(test)]
#[path = "block_tests.rs"]
mod tests;
