//! Another up axis, without turning what the camera sees (`docs/theory/path.md`, another up axis).
//!
//! Free turnings do not depend on the up axis: their keys get the roll that they have against the
//! new axis. Sections that track a target or look along the way do, so their keys keep the
//! old axis as a fixed up.

use glam::{DQuat, DVec3};

use super::ahead::{self, Look};
use super::alignment;
use super::camera_path::{CameraPath, Orientation};
use super::space::Up;
use super::timeline::{Change, Timeline};
use super::up_vector::UpVector;
use super::ups::{End, common_look};
use crate::error::{Result, vec_with_room};
use crate::math::orientation::wrap_degrees;
use crate::math::rotation_minimising::signed_angle;

/// An up that is off by more is not taken over by a roll that several keys share.
const SAME_UP: f64 = 1e-13;

/// Minimal ups are rolled by multiples of this many degrees, so that sums of plain rolls stay exact
/// and half turns go the way they went.
const GRAIN: f64 = 1.0 / (1u64 << 44) as f64;

/// Angles that are nearer, in degrees, are one.
const SAME_ANGLE: f64 = 1e-9;

/// An orientation in the order of the path.
struct Slot<'a> {
    orientation: &'a Orientation,
    at: (usize, usize),
    view: DVec3,
    /// With its roll.
    up: DVec3,
    /// Against the new axis, in degrees.
    roll: f64,
    /// Whether the old axis stays its up.
    fixed: bool,
}

impl Slot<'_> {
    fn end(&self) -> End<'_> {
        End {
            target: self.orientation.target,
            view: self.view,
            roll: self.orientation.roll,
            own: &self.orientation.own,
        }
    }
}

/// The same path with another up axis: each pose stays, between frames too, to 1e-12. Where
/// views track or follow, the former up axis becomes their fixed up; fixed ups by the new
/// axis become [`UpVector::Axis`].
///
/// # Errors
/// [`crate::Error::Memory`]; as [`CameraPath::check`].
pub fn change_up(path: &CameraPath, up: Up) -> Result<CameraPath> {
    let mut new = path.try_clone()?;
    let old = path.space.up;
    if up == old {
        return Ok(new);
    }
    let timeline = Timeline::new(path)?;
    let mut slots = slots(path, &timeline, up)?;
    decide(&mut slots, path, &timeline, up)?;
    new.space.up = up;
    let turn = turn(up) * turn(old).conjugate();
    for slot in &slots {
        let orientation = &mut new.points[slot.at.0].orientations[slot.at.1];
        let own = &slot.orientation.own;
        if slot.fixed {
            orientation.own = own.with(|own| own.up = UpVector::Fixed(old))?;
        } else if own.up.level(old) == Some(old) {
            orientation.roll = slot.roll;
        } else if own.up == UpVector::Fixed(up) {
            orientation.own = own.with(|own| own.up = UpVector::Axis)?;
        }
        if own.turning.is_some() {
            orientation.own = orientation.own.with(|own| {
                if let Some(part) = &mut own.turning {
                    part.control = part.control.map(|q| turn * q);
                }
            })?;
        }
    }
    roll_minimal(&mut new, &slots)?;
    new.check()?;
    Ok(new)
}

fn slots<'a>(path: &'a CameraPath, timeline: &Timeline, new: Up) -> Result<Vec<Slot<'a>>> {
    let mut slots = vec_with_room(path.points.iter().map(|p| p.orientations.len()).sum())?;
    for (point, here) in path.points.iter().enumerate() {
        for (number, orientation) in here.orientations.iter().enumerate() {
            let view = ahead::view(path, point, number);
            let up = alignment::up(path, timeline, point, number);
            // A wholly straight path has no normals but the upright axis.
            let straight = orientation.own.up == UpVector::Frenet && timeline.has_no_normals();
            slots.push(Slot {
                orientation,
                at: (point, number),
                view,
                up,
                roll: wrap_degrees(new.roll_from_up(view, up).to_degrees()),
                fixed: straight || orientation.own.up == UpVector::Fixed(path.space.up),
            });
        }
    }
    Ok(slots)
}

/// Which orientations keep the old axis, and which share a roll.
fn decide(slots: &mut [Slot<'_>], path: &CameraPath, timeline: &Timeline, new: Up) -> Result<()> {
    let old = path.space.up;
    let level = |slot: &Slot<'_>| slot.orientation.own.up.level(old);
    let fix = |slots: &mut [Slot<'_>], pair: [usize; 2]| {
        for at in pair {
            slots[at].fixed |= level(&slots[at]) == Some(old);
        }
    };
    // Sections that keep view and up: their ends have one roll.
    let mut kept: Vec<[usize; 2]> = vec_with_room(slots.len())?;
    let mut moving = timeline.moving().peekable();
    let first = moving.peek().copied();
    while let Some(from) = moving.next() {
        let last = if path.closed { first } else { None };
        let to = moving.peek().copied().or(last).unwrap_or(slots.len() - 1);
        let [a, b] = [&slots[from], &slots[to]];
        let levels = [level(a), level(b)];
        match common_look(&a.end(), &b.end()) {
            Some(Look::Still) if levels == [Some(old); 2] => {
                let same = a.orientation.roll == b.orientation.roll;
                kept.extend(same.then_some([from, to]));
            }
            // Tracked or followed; or free so far, and not to be either with the new axis.
            Some(_) if levels[0].is_some() && levels[1].is_some() => fix(slots, [from, to]),
            _ => {}
        }
    }
    // Views that count as one, but do not have one yaw beside a pole.
    for section in 0..timeline.section_count() {
        let pair = [section, (section + 1) % slots.len()];
        let change = timeline.section(section).change;
        if !matches!(change, Change::Position | Change::View)
            && slots[pair[0]].view != slots[pair[1]].view
        {
            fix(slots, pair);
        }
    }
    // Twice, since the first of them may be the last one's neighbour.
    for _ in 0..2 {
        for [from, to] in &kept {
            slots[*to].roll = slots[*from].roll;
        }
    }
    for slot in slots.iter_mut().filter(|slot| level(slot) == Some(old)) {
        let up = new.up_from_roll(slot.view, slot.roll.to_radians());
        slot.fixed |= (up - slot.up).length() > SAME_UP;
    }
    let mut settled = false;
    while !settled {
        settled = true;
        for [from, to] in kept.iter().chain(kept.iter().rev()) {
            if slots[*from].fixed != slots[*to].fixed {
                settled = false;
                fix(slots, [*from, *to]);
            }
        }
    }
    Ok(())
}

/// The rotation from the world to y-up axes.
const fn turn(up: Up) -> DQuat {
    match up {
        Up::Y => DQuat::IDENTITY,
        Up::Z => DQuat::from_xyzw(-0.5, -0.5, -0.5, 0.5),
    }
}

/// A run of minimal ups begins with the up axis: with another one, all of it is rolled.
fn roll_minimal(path: &mut CameraPath, slots: &[Slot<'_>]) -> Result<()> {
    let minimal = |slot: &Slot<'_>| slot.orientation.own.up == UpVector::Minimal;
    if !slots.iter().any(minimal) {
        return Ok(());
    }
    let ups = alignment::ups(path)?;
    let begin = slots.iter().position(|slot| !minimal(slot));
    let begin = if path.closed { begin.unwrap_or(0) } else { 0 };
    let mut missing = 0.0;
    for at in (begin..slots.len()).chain(0..begin) {
        let slot = &slots[at];
        if !minimal(slot) {
            continue;
        }
        // Another angle begins with a run, and where a view turns straight about.
        let angle = signed_angle(ups[at], slot.up, slot.view).to_degrees();
        if wrap_degrees(angle - missing).abs() > SAME_ANGLE {
            missing = (angle / GRAIN).round() * GRAIN;
        }
        let orientation = &mut path.points[slot.at.0].orientations[slot.at.1];
        orientation.roll = wrap_degrees(orientation.roll + missing);
    }
    Ok(())
}

#[cfg(test)]
#[path = "change_up_tests.rs"]
mod tests;
