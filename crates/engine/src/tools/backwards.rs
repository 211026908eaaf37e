//! A path the other way round.

use std::sync::Arc;

use super::keep;
use crate::error::{Result, can_allocate, vec_with_room};
use crate::path::own::{distance_backwards, track_backwards};
use crate::path::{
    CameraPath, Change, CurveParameters, Ease, Orientation, Pace, PacePart, PaceSource, Tangents,
    Tcb, Timeline, TurningPart, UpVector, Velocities, alignment,
};

/// The path backwards: its poses in reverse order, but views along the way look along the new one.
///
/// # Errors
/// [`crate::Error::Memory`].
pub fn reverse(path: &CameraPath) -> Result<CameraPath> {
    let path = &merged(path)?;
    let count = path.points.len();
    // A closed path still begins at its first point.
    let old = |number: usize| {
        if path.closed {
            (count - number) % count
        } else {
            count - 1 - number
        }
    };
    let mut points = vec_with_room(count)?;
    let mut slots: Vec<&Orientation> = vec_with_room(
        path.points
            .iter()
            .map(|point| point.orientations.len())
            .sum(),
    )?;
    slots.extend(path.points.iter().flat_map(|point| &point.orientations));
    let all = slots.len();
    // New slot j has the pace of the old section that it goes along.
    let begins = if path.closed {
        path.points[0].orientations.len() + all - 2
    } else {
        all + all - 2
    };
    let mut slot = 0;
    for number in 0..count {
        let from = &path.points[old(number)];
        let mut new = from.try_clone()?;
        new.orientations.reverse();
        let tcb = path.tcb(old(number));
        if tcb.bias != 0.0 {
            new.curve = CurveParameters::Own(mirrored(tcb));
        }
        new.tangents = from.tangents.map(|own| Tangents {
            before: -own.after,
            after: -own.before,
        });
        for orientation in &mut new.orientations {
            let section = if !path.closed && slot == all - 1 {
                all - 1
            } else {
                (begins - slot) % all
            };
            *orientation = backwards(orientation, slots[section])?;
            slot += 1;
        }
        points.push(new);
    }
    let mut reversed = CameraPath {
        points: points.into(),
        ..*path
    };
    let mut ups = keep::ups(path)?;
    if !ups.is_empty() {
        ups.iter_mut().for_each(|ups| ups.reverse());
        let mut wanted = vec_with_room(count)?;
        wanted.extend((0..count).map(|number| ups[old(number)].as_slice()));
        alignment::keep_ups(&mut reversed, &wanted.concat())?;
    }
    Ok(reversed)
}

/// Keys between which nothing changes are one with the properties of the later: here both have
/// them, since their order is reversed.
fn merged(path: &CameraPath) -> Result<CameraPath> {
    let timeline = Timeline::new(path)?;
    let mut path = path.try_clone()?;
    for number in (0..timeline.section_count()).rev() {
        let section = timeline.section(number);
        if section.change != Change::Nothing {
            continue;
        }
        let (point, at) = (section.point, section.orientation);
        let here = &path.points[point].orientations;
        let later = match here.get(at + 1) {
            Some(later) => later.clone(),
            None => path.points[(point + 1) % path.points.len()].orientations[0].clone(),
        };
        let earlier = &mut path.points[point].orientations[at];
        (earlier.hold, earlier.turning) = (later.hold, later.turning);
        earlier.own = earlier.own.with(|own| {
            own.velocities = later.own.velocities;
            own.roll_slope = later.own.roll_slope;
            own.zoom_slope = later.own.zoom_slope;
        })?;
    }
    Ok(path)
}

fn mirrored(tcb: Tcb) -> Tcb {
    Tcb {
        bias: if tcb.bias == 0.0 { 0.0 } else { -tcb.bias },
        ..tcb
    }
}

/// An orientation of a path gone backwards, with the pace of `section`.
fn backwards(old: &Orientation, section: &Orientation) -> Result<Orientation> {
    let mut new = old.clone();
    new.turning = mirrored(old.turning);
    new.speeds = section.speeds;
    new.speeds.reverse();
    if old.own.is_empty() && section.own.is_empty() {
        return Ok(new);
    }
    let keys = match &section.own.pace {
        Pace::Distance(keys)
        | Pace::Part(PacePart {
            of: PaceSource::Distance(keys),
            ..
        }) => keys.len(),
        Pace::Part(PacePart {
            of: PaceSource::Track(keys),
            ..
        }) => 5 * keys.len(),
        _ => 0,
    };
    can_allocate(64 + 16 * keys)?;
    let distance = |keys: &[[f64; 2]]| -> Arc<[[f64; 2]]> { distance_backwards(keys).into() };
    let ease = |ease: &Ease| Ease {
        rise: ease.fall,
        fall: ease.rise,
        ..*ease
    };
    let up = match &old.own.up {
        UpVector::Path(path) => UpVector::Path(path.reversed()?),
        up => up.clone(),
    };
    new.own = old.own.with(|own| {
        own.up = up;
        own.frames = section.own.frames;
        own.locked = section.own.locked;
        own.curve_time = section.own.curve_time;
        own.pace = match &section.own.pace {
            Pace::Speeds => Pace::Speeds,
            Pace::Ease(whole) => Pace::Ease(ease(whole)),
            Pace::Distance(keys) => Pace::Distance(distance(keys)),
            Pace::Part(part) => Pace::Part(PacePart {
                of: match &part.of {
                    PaceSource::Speeds { speeds, slopes } => {
                        let mut speeds = *speeds;
                        speeds.reverse();
                        PaceSource::Speeds {
                            speeds,
                            slopes: [-slopes[1], -slopes[0]],
                        }
                    }
                    PaceSource::Ease(whole) => PaceSource::Ease(ease(whole)),
                    PaceSource::Distance(keys) => PaceSource::Distance(distance(keys)),
                    PaceSource::Track(keys) => PaceSource::Track(track_backwards(keys).into()),
                },
                from: 1.0 - part.to,
                to: 1.0 - part.from,
            }),
        };
        own.turning = section.own.turning.map(|part| {
            let [a, b, c, d] = part.control;
            TurningPart {
                control: [d, c, b, a],
                from: 1.0 - part.to,
                to: 1.0 - part.from,
            }
        });
        own.velocities = own.velocities.map(|own| Velocities {
            reach: -own.leave,
            leave: -own.reach,
        });
        own.roll_slope = own.roll_slope.map(|slope| -slope);
        own.zoom_slope = own.zoom_slope.map(|slope| -slope);
    })?;
    Ok(new)
}
