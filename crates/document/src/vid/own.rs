//! Reads and writes by the rows of tables: what paths, points and orientations have.

use std::fmt::{self, Write};
use std::sync::Arc;

use glam::{DQuat, DVec3};

use super::field::Field;
use super::text::plain;
use crate::error::{Malformed, Result, TooMany, can_allocate, vec_with_room};
use crate::named::keys;
use vides_engine::limits;
use vides_engine::path::camera_path::check_curve_speed;
use vides_engine::path::own::{check_distance, check_track};
use vides_engine::path::speed_curve::{CurveEnd, end_slopes};
use vides_engine::path::{
    BaseFrames, Ease, EaseKind, Orientation, OrientationOverrides, PacePart, PaceSource, Space,
    Tcb, TurningPart, UpPath, UpPathPoint, UpVector,
};
use vides_engine::property::{Kind, Property, Table, Value, find};

#[derive(Default)]
pub(super) struct ReadContext {
    /// Orientations of all points.
    pub orientations: usize,
    /// The path's up paths, which other orientations may refer to.
    pub up_paths: [Option<Arc<UpPath>>; limits::MAX_UP_PATHS],
}

/// Reads fields by the rows of tables.
#[derive(Default)]
pub(super) struct Rows {
    /// The first keys of rows of which a form has been met.
    met: [Option<&'static str>; 3],
}

impl Rows {
    /// Reads a field into what has its row; false if none has.
    pub(super) fn read<T>(
        &mut self,
        field: Field<'_>,
        table: &'static [Property<T>],
        into: &mut T,
        space: Space,
        so_far: &mut ReadContext,
    ) -> Result<bool> {
        let Some(row) = find(table, field.key) else {
            return Ok(false);
        };
        if self.met.contains(&Some(row.key())) {
            return Err(field.error(match row.key() {
                "target" => Malformed::TargetAndOffset,
                "up" => Malformed::UpTwice,
                "ease" => Malformed::PaceTwice,
                _ => Malformed::PresetAndOwn,
            }));
        }
        let mut value = value(field, row, into, so_far)?;
        // An axis may stand beside a point or a path.
        if row.keys.len() > 1 && value != Value::Choice("axis") {
            let free = self.met.iter_mut().find(|met| met.is_none());
            if let Some(free) = free {
                *free = Some(row.key());
            }
        }
        (row.exchange)(into, &mut value);
        field.checked((row.check)(into, space))?;
        Ok(true)
    }
}

/// The value that a field gives a property of `of`, unchecked.
pub(super) fn value<T>(
    field: Field<'_>,
    row: &Property<T>,
    of: &T,
    so_far: &mut ReadContext,
) -> Result<Value> {
    Ok(match row.kind(field.key) {
        Kind::Ease => Value::Ease(ease(field)?),
        Kind::Distance => Value::Distance(distance_keys(field, check_distance)?),
        Kind::Part => Value::Part(pace_part(field)?),
        Kind::Turning => Value::Turning(turning_part(field)?),
        Kind::UpPath => Value::UpPath(up_path(field, so_far)?),
        // What is not given there stays.
        Kind::BaseFrames | Kind::Presets => {
            let mut value = (row.value)(of);
            match &mut value {
                Value::BaseFrames(frames) => base_speeds(field, frames)?,
                Value::Presets(all) => presets(field, all)?,
                _ => {}
            }
            value
        }
        kind => field.plain(kind, row.range)?,
    })
}

/// Reads what is said of a whole file or path by its row; false if the key is of something else.
pub(super) fn read_setting<T: Table>(field: Field<'_>, of: &mut T) -> Result<bool> {
    let so_far = &mut ReadContext::default();
    Rows::default().read(field, T::PROPERTIES, of, Space::NEW, so_far)
}

fn base_speeds(table: Field<'_>, speeds: &mut BaseFrames) -> Result<()> {
    for field in table.fields()? {
        if !read_setting(field, speeds)? {
            return Err(field.unknown(&keys::<BaseFrames>().collect::<Vec<_>>()));
        }
    }
    Ok(())
}

fn presets(table: Field<'_>, presets: &mut [Tcb; limits::PRESETS]) -> Result<()> {
    for field in table.fields()? {
        // Exactly one digit: 01 and +1 are not other names of 1.
        let preset = match field.key.as_bytes() {
            [digit @ b'0'..=b'9'] => &mut presets[usize::from(digit - b'0')],
            _ => return Err(field.error(Malformed::PresetNumber)),
        };
        *preset = field.tcb()?;
    }
    Ok(())
}

fn up_path(field: Field<'_>, so_far: &mut ReadContext) -> Result<Arc<UpPath>> {
    if !field.is_array() {
        let number = field.integer_in(1, limits::MAX_UP_PATHS as i64)? as usize;
        let known = so_far.up_paths[number - 1].clone();
        return known.ok_or_else(|| field.error(Malformed::NoUpPath));
    }
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
    Ok(path)
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
            "kind" => ease.kind = field.choice()?,
            "rise" => ease.rise = field.number()?,
            "fall" => ease.fall = field.number()?,
            "cruise" => ease.cruise = field.number()?,
            _ => return Err(field.unknown(&["kind", "rise", "fall", "cruise"])),
        }
    }
    table.checked(ease.check())?;
    Ok(ease)
}

/// Keys of `N` numbers each.
fn distance_keys<const N: usize>(
    array: Field<'_>,
    check: fn(&[[f64; N]]) -> std::result::Result<(), vides_engine::Error>,
) -> Result<Arc<[[f64; N]]>> {
    let elements = array.elements()?;
    let mut keys: Vec<[f64; N]> = vec_with_room(elements.len().min(limits::MAX_DISTANCE_KEYS + 1))?;
    // One too many is enough for the error.
    for element in elements.take(limits::MAX_DISTANCE_KEYS + 1) {
        keys.push(element.numbers()?);
    }
    array.checked(check(&keys))?;
    can_allocate(size_of_val(&keys[..]) + 2 * size_of::<usize>())?;
    Ok(keys.into())
}

fn pace_part(table: Field<'_>) -> Result<PacePart> {
    let (mut from, mut to) = (0.0, 1.0);
    let (mut of, mut ends) = (None, None);
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
            "slopes" => ends = Some(field.numbers()?),
            "speed_curve" => {
                let speeds: [f64; limits::SPEEDS] = field.numbers()?;
                field.checked(speeds.into_iter().try_for_each(check_curve_speed))?;
                let slopes = end_slopes(&speeds, [CurveEnd::Free; 2]);
                whole(field, PaceSource::Speeds { speeds, slopes })?;
            }
            "ease" => whole(field, PaceSource::Ease(ease(field)?))?,
            "distance" => {
                whole(
                    field,
                    PaceSource::Distance(distance_keys(field, check_distance)?),
                )?;
            }
            "track" => whole(field, PaceSource::Track(distance_keys(field, check_track)?))?,
            _ => {
                return Err(field.unknown(&[
                    "from",
                    "to",
                    "speed_curve",
                    "slopes",
                    "ease",
                    "distance",
                ]));
            }
        }
    }
    let Some(mut of) = of else {
        return Err(table.error(Malformed::PartWithoutWhole));
    };
    match (&mut of, ends) {
        (_, None) => {}
        (PaceSource::Speeds { slopes, .. }, Some(ends)) => *slopes = ends,
        _ => return Err(table.error(Malformed::NoSlopes)),
    }
    let part = PacePart { of, from, to };
    table.checked(part.check())?;
    Ok(part)
}

/// The up paths written so far, by number.
pub(super) type UpPaths<'a> = [Option<&'a UpVector>; limits::MAX_UP_PATHS];

/// An orientation with what it owns.
pub(super) fn write<'a>(
    out: &mut impl Write,
    view: &'a Orientation,
    written: &mut UpPaths<'a>,
) -> fmt::Result {
    for row in Orientation::PROPERTIES {
        plain(out, row, view, &Orientation::NEW)?;
    }
    if view.own.is_empty() {
        return Ok(());
    }
    for row in OrientationOverrides::PROPERTIES {
        match (row.key(), &view.own.up) {
            ("up", up @ UpVector::Path(_)) => {
                let same = |known: &Option<&UpVector>| known.is_none_or(|known| known == up);
                let place = written.iter().position(same).unwrap_or(0);
                if written[place].replace(up).is_some() {
                    writeln!(out, "up_path = {}", place + 1)?;
                } else {
                    writeln!(out, "up_path = {}", (row.value)(&view.own))?;
                }
            }
            _ => plain(out, row, &view.own, &OrientationOverrides::NEW)?,
        }
    }
    Ok(())
}
