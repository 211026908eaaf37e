//! Reads and writes what points and orientations own.

use std::fmt::{self, Write};
use std::sync::Arc;

use glam::{DQuat, DVec3};

use super::field::Field;
use super::write::plain;
use crate::error::{Malformed, Result, TooMany, vec_with_room};
use crate::limits;
use crate::path::Space;
use crate::path::camera_path::check_curve_speed;
use crate::path::own::distance;
use crate::path::{
    Ease, EaseKind, OrientationOverrides, Overrides, Pace, PacePart, PaceSource, Tangents,
    TurningPart, Up, UpPath, UpPathPoint, UpVector, Velocities,
};
use vides_engine::property::find;

#[derive(Default)]
pub(super) struct ReadContext {
    /// Orientations of all points.
    pub orientations: usize,
    /// The path's up paths, which other orientations may refer to.
    pub up_paths: [Option<Arc<UpPath>>; limits::MAX_UP_PATHS],
}

/// Reads fields into what an orientation owns.
pub(super) struct Reader {
    before: Overrides,
    own: Option<OrientationOverrides>,
    /// Whether an up, and a pace, has been met.
    given: [bool; 2],
}

impl Reader {
    pub(super) fn new(before: Overrides) -> Self {
        Self {
            before,
            own: None,
            given: [false; 2],
        }
    }

    /// Reads a field; false if it has no row.
    pub(super) fn read(
        &mut self,
        field: Field<'_>,
        space: Space,
        so_far: &mut ReadContext,
    ) -> Result<bool> {
        let Some(row) = find(OrientationOverrides::PROPERTIES, field.key) else {
            return Ok(false);
        };
        let own = self
            .own
            .get_or_insert_with(|| OrientationOverrides::clone(&self.before));
        let [up_given, pace_given] = &mut self.given;
        match row.key() {
            "up" if *up_given => return Err(field.error(Malformed::UpTwice)),
            "ease" if *pace_given => return Err(field.error(Malformed::PaceTwice)),
            "up" => {
                own.up = up(field, so_far)?;
                *up_given = own.up != UpVector::Axis;
            }
            "ease" => {
                *pace_given = true;
                own.pace = match field.key {
                    "ease" => Pace::Ease(ease(field)?),
                    "distance" => given_distance(field)?,
                    _ => Pace::Part(pace_part(field)?),
                };
            }
            "velocity_degrees" => own.velocities = Some(velocities(field)?),
            "turning_part" => own.turning = Some(turning_part(field)?),
            _ => field.plain(row, own)?,
        }
        field.checked((row.check)(own, space))?;
        Ok(true)
    }

    pub(super) fn owned(self) -> Result<Overrides> {
        match self.own {
            None => Ok(self.before),
            Some(read) => Ok(Overrides::NOTHING.with(|own| *own = read)?),
        }
    }
}

fn up(field: Field<'_>, so_far: &mut ReadContext) -> Result<UpVector> {
    match field.key {
        "up_point" => Ok(UpVector::Point(DVec3::from_array(field.numbers()?))),
        "up_path" if field.is_array() => {
            let Some(place) = so_far.up_paths.iter_mut().find(|path| path.is_none()) else {
                return Err(field.error(TooMany::UpPaths));
            };
            let elements = field.elements()?;
            let mut points = vec_with_room(elements.len().min(limits::MAX_UP_PATH_POINTS + 1))?;
            // One too many is enough for the error.
            for element in elements.take(limits::MAX_UP_PATH_POINTS + 1) {
                let numbers: [f64; 9] = element.numbers()?;
                let vector = |at: usize| DVec3::from_slice(&numbers[at..]);
                points.push(UpPathPoint {
                    position: vector(0),
                    before: vector(3),
                    after: vector(6),
                });
            }
            let path = field.checked(UpPath::new(points))?;
            *place = Some(path.clone());
            Ok(UpVector::Path(path))
        }
        "up_path" => {
            let number = field.integer_in(1, limits::MAX_UP_PATHS as i64)? as usize;
            match &so_far.up_paths[number - 1] {
                Some(path) => Ok(UpVector::Path(path.clone())),
                None => Err(field.error(Malformed::NoUpPath)),
            }
        }
        _ => {
            let ups = [
                UpVector::Axis,
                UpVector::Minimal,
                UpVector::Frenet,
                UpVector::Fixed(Up::Y),
                UpVector::Fixed(Up::Z),
            ];
            field.one_of(&["axis", "minimal", "frenet", "y", "z"], ups)
        }
    }
}

pub(super) fn tangents(table: Field<'_>, space: Space) -> Result<Tangents> {
    let [before, after] = two_vectors(table, ["before", "after"])?;
    let tangents = Tangents { before, after };
    table.checked(tangents.check(space))?;
    Ok(tangents)
}

fn two_vectors(table: Field<'_>, keys: [&'static str; 2]) -> Result<[DVec3; 2]> {
    let mut found = [None; 2];
    for field in table.fields()? {
        match keys.iter().position(|&key| key == field.key) {
            Some(at) => found[at] = Some(DVec3::from_array(field.numbers()?)),
            None => return Err(field.unknown(&keys)),
        }
    }
    match found {
        [Some(a), Some(b)] => Ok([a, b]),
        _ => Err(table.error(Malformed::Both(keys[0], keys[1]))),
    }
}

fn velocities(table: Field<'_>) -> Result<Velocities> {
    let [reach, leave] = two_vectors(table, ["reach", "leave"])?;
    Ok(Velocities { reach, leave })
}

fn turning_part(table: Field<'_>) -> Result<TurningPart> {
    let mut part = TurningPart {
        control: [DQuat::IDENTITY; 4],
        from: 0.0,
        to: 1.0,
    };
    for field in table.fields()? {
        match field.key {
            "control" => {
                let elements = field.elements()?;
                if elements.len() != part.control.len() {
                    return Err(field.error(Malformed::QuaternionCount {
                        wanted: part.control.len(),
                        found: elements.len(),
                    }));
                }
                for (q, element) in part.control.iter_mut().zip(elements) {
                    let [w, x, y, z] = element.numbers()?;
                    *q = DQuat::from_xyzw(x, y, z, w);
                }
            }
            "from" => part.from = field.number()?,
            "to" => part.to = field.number()?,
            _ => return Err(field.unknown(&["control", "from", "to"])),
        }
    }
    table.checked(part.check())?;
    Ok(part)
}

fn ease(table: Field<'_>) -> Result<Ease> {
    let mut ease = Ease {
        kind: EaseKind::Sine,
        rise: 0.0,
        fall: 0.0,
        cruise: limits::BASE_SPEED,
    };
    for field in table.fields()? {
        match field.key {
            "kind" => {
                let kinds = [EaseKind::Sine, EaseKind::Parabolic];
                ease.kind = field.one_of(&["sine", "parabolic"], kinds)?;
            }
            "rise" => ease.rise = field.number()?,
            "fall" => ease.fall = field.number()?,
            "cruise" => ease.cruise = field.number()?,
            _ => return Err(field.unknown(&["kind", "rise", "fall", "cruise"])),
        }
    }
    table.checked(ease.check())?;
    Ok(ease)
}

fn given_distance(array: Field<'_>) -> Result<Pace> {
    let elements = array.elements()?;
    let mut keys: Vec<[f64; 2]> = vec_with_room(elements.len().min(limits::MAX_DISTANCE_KEYS + 1))?;
    // One too many is enough for the error.
    for element in elements.take(limits::MAX_DISTANCE_KEYS + 1) {
        keys.push(element.numbers()?);
    }
    array.checked(distance(&keys))
}

fn pace_part(table: Field<'_>) -> Result<PacePart> {
    let (mut from, mut to) = (0.0, 1.0);
    let (mut facing_before, mut facing_after) = (None, None);
    let mut of = None;
    let mut whole = |field: Field<'_>, whole| {
        if of.replace(whole).is_some() {
            return Err(field.error(Malformed::PartTwice));
        }
        Ok(())
    };
    for field in table.fields()? {
        match field.key {
            "from" => from = field.number()?,
            "to" => to = field.number()?,
            "facing_before" => facing_before = Some(field.number()?),
            "facing_after" => facing_after = Some(field.number()?),
            "speed_curve" => {
                let speeds: [f64; limits::SPEEDS] = field.numbers()?;
                field.checked(speeds.into_iter().try_for_each(check_curve_speed))?;
                let (before, after) = (None, None);
                whole(
                    field,
                    PaceSource::Speeds {
                        speeds,
                        before,
                        after,
                    },
                )?;
            }
            "ease" => whole(field, PaceSource::Ease(ease(field)?))?,
            "distance" => {
                if let Pace::Distance(keys) = given_distance(field)? {
                    whole(field, PaceSource::Distance(keys))?;
                }
            }
            _ => {
                return Err(field.unknown(&[
                    "from",
                    "to",
                    "speed_curve",
                    "facing_before",
                    "facing_after",
                    "ease",
                    "distance",
                ]));
            }
        }
    }
    let Some(mut of) = of else {
        return Err(table.error(Malformed::PartWithoutWhole));
    };
    match &mut of {
        PaceSource::Speeds { before, after, .. } => {
            (*before, *after) = (facing_before, facing_after)
        }
        _ if facing_before.or(facing_after).is_some() => {
            return Err(table.error(Malformed::NoneFacing));
        }
        _ => {}
    }
    let part = PacePart { of, from, to };
    table.checked(part.check())?;
    Ok(part)
}

pub(super) fn write_tangents(out: &mut impl Write, tangents: &Tangents) -> fmt::Result {
    let [before, after] = [tangents.before, tangents.after].map(|v| v.to_array());
    writeln!(
        out,
        "tangents = {{ before = {before:?}, after = {after:?} }}"
    )
}

/// The up paths written so far, by number.
pub(super) type UpPaths<'a> = [Option<&'a UpVector>; limits::MAX_UP_PATHS];

fn write_up<'a>(out: &mut impl Write, up: &'a UpVector, written: &mut UpPaths<'a>) -> fmt::Result {
    match up {
        UpVector::Axis => Ok(()),
        UpVector::Point(place) => writeln!(out, "up_point = {:?}", place.to_array()),
        UpVector::Path(path) => {
            let same = |known: &Option<&UpVector>| known.is_none_or(|known| known == up);
            let place = written.iter().position(same).unwrap_or(0);
            if written[place].replace(up).is_some() {
                return writeln!(out, "up_path = {}", place + 1);
            }
            write!(out, "up_path = ")?;
            for (k, point) in path.points().iter().enumerate() {
                let numbers = [point.position, point.before, point.after].map(|v| v.to_array());
                let separator = if k == 0 { "[" } else { ", " };
                write!(out, "{separator}{:?}", numbers.as_flattened())?;
            }
            writeln!(out, "]")
        }
        UpVector::Minimal | UpVector::Frenet | UpVector::Fixed(_) => {
            writeln!(out, "up = \"{}\"", up.name())
        }
    }
}

pub(super) fn write<'a>(
    out: &mut impl Write,
    owned: &'a Overrides,
    written: &mut UpPaths<'a>,
) -> fmt::Result {
    if owned.is_empty() {
        return Ok(());
    }
    let own: &OrientationOverrides = owned;
    for row in OrientationOverrides::PROPERTIES {
        match row.key() {
            "up" => write_up(out, &own.up, written)?,
            "ease" => write_pace(out, &own.pace)?,
            "velocity_degrees" => {
                if let Some(Velocities { reach, leave }) = own.velocities {
                    let [reach, leave] = [reach, leave].map(|v| v.to_array());
                    writeln!(
                        out,
                        "velocity_degrees = {{ reach = {reach:?}, leave = {leave:?} }}"
                    )?;
                }
            }
            "turning_part" => {
                if let Some(TurningPart { control, from, to }) = own.turning {
                    let control = control.map(|q| [q.w, q.x, q.y, q.z]);
                    writeln!(
                        out,
                        "turning_part = {{ from = {from:?}, to = {to:?}, control = {control:?} }}"
                    )?;
                }
            }
            _ => plain(out, row, own, &Overrides::NOTHING)?,
        }
    }
    Ok(())
}

fn write_pace(out: &mut impl Write, pace: &Pace) -> fmt::Result {
    match pace {
        Pace::Speeds => Ok(()),
        Pace::Ease(ease) => {
            write_ease(out, ease)?;
            writeln!(out)
        }
        Pace::Distance(keys) => writeln!(out, "distance = {keys:?}"),
        Pace::Part(part) => {
            write!(
                out,
                "pace_part = {{ from = {:?}, to = {:?}, ",
                part.from, part.to
            )?;
            match &part.of {
                PaceSource::Speeds {
                    speeds,
                    before,
                    after,
                } => {
                    write!(out, "speed_curve = {speeds:?}")?;
                    if let Some(before) = before {
                        write!(out, ", facing_before = {before:?}")?;
                    }
                    if let Some(after) = after {
                        write!(out, ", facing_after = {after:?}")?;
                    }
                }
                PaceSource::Ease(ease) => write_ease(out, ease)?,
                PaceSource::Distance(keys) => write!(out, "distance = {keys:?}")?,
            }
            writeln!(out, " }}")
        }
    }
}

fn write_ease(out: &mut impl Write, ease: &Ease) -> fmt::Result {
    let kind = match ease.kind {
        EaseKind::Sine => "sine",
        EaseKind::Parabolic => "parabolic",
    };
    let Ease {
        rise, fall, cruise, ..
    } = ease;
    write!(
        out,
        "ease = {{ kind = \"{kind}\", rise = {rise:?}, fall = {fall:?}, cruise = {cruise:?} }}"
    )
}
