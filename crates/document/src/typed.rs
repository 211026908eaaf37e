//! Values of properties in the types that programs have: numbers, lists of them, texts, flags.

use glam::{DQuat, DVec3};
use vides_engine::limits::PRESETS;
use vides_engine::path::{BaseFrames, Ease, EaseKind, Tcb, UpPath, UpPathPoint, own};
use vides_engine::property::{Kind, Stored, Value};

use crate::error::{self, Error, Malformed, Result};

/// A value as a program gives it.
#[derive(Clone, Copy, Debug)]
pub enum Given<'a> {
    /// As in a file; texts need no quotes, and an empty one restores what a new path has.
    File(&'a str),
    /// A text or the name of a choice as it is; for other properties, a value as in a file.
    Text(&'a str),
    /// A number.
    Number(f64),
    /// Several; none restores what a new path has.
    Numbers(&'a [f64]),
    /// Yes or no.
    Flag(bool),
}

/// The type in which a property is set and returned.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// One number.
    Number,
    /// Several numbers.
    Numbers,
    /// A text, the name of a choice, or a structure as in a file.
    Text,
    /// Yes or no.
    Flag,
}

impl Form {
    /// The form of a kind.
    #[must_use]
    pub const fn of(kind: Kind) -> Self {
        match kind {
            Kind::Number | Kind::Whole => Self::Number,
            Kind::Switch => Self::Flag,
            Kind::Text | Kind::Choice(_) | Kind::Part | Kind::Turning | Kind::Nested => Self::Text,
            _ => Self::Numbers,
        }
    }

    /// How many numbers a list of this kind has; 0 if it may have any number, or is no list.
    #[must_use]
    pub const fn width(kind: Kind) -> usize {
        match kind {
            Kind::Cone => 2,
            Kind::Place | Kind::Vector | Kind::Colour | Kind::Shape => 3,
            Kind::Rotation | Kind::BaseFrames | Kind::Ease => 4,
            Kind::Pair(_) => 6,
            Kind::Speeds => 10,
            Kind::Presets => 3 * PRESETS,
            _ => 0,
        }
    }
}

impl From<Form> for error::Value {
    fn from(form: Form) -> Self {
        match form {
            Form::Number => Self::Number,
            Form::Numbers => Self::Array,
            Form::Text => Self::Text,
            Form::Flag => Self::Boolean,
        }
    }
}

impl Given<'_> {
    /// Its form.
    pub(super) const fn form(&self) -> Form {
        match self {
            Self::File(_) | Self::Text(_) => Form::Text,
            Self::Number(_) => Form::Number,
            Self::Numbers(_) => Form::Numbers,
            Self::Flag(_) => Form::Flag,
        }
    }
}

/// An error without a place, to which the property's name is added.
pub(super) fn malformed(cause: Malformed) -> Error {
    Error::Property {
        name: (&"").into(),
        cause,
    }
}

/// Something of another form than the property has.
pub(super) fn other_form(wanted: Form, found: Form) -> Error {
    malformed(Malformed::Expected {
        wanted: wanted.into(),
        found: found.into(),
    })
}

/// The value of a kind that is given as a number, numbers or a flag, unchecked except for the range of
/// whole numbers.
pub(super) fn value(kind: Kind, given: Given<'_>, range: Option<(f64, f64)>) -> Result<Value> {
    Ok(match (kind, given) {
        (Kind::Number, Given::Number(number)) => number.into(),
        (Kind::Whole, Given::Number(number)) => whole(number, range).map_err(malformed)?,
        (Kind::Switch, Given::Flag(on)) => on.into(),
        (kind, Given::Numbers([])) if Form::of(kind) == Form::Numbers => Value::Unset,
        (kind, Given::Numbers(numbers)) if Form::of(kind) == Form::Numbers => {
            of_numbers(kind, numbers)?
        }
        (kind, given) => return Err(other_form(Form::of(kind), given.form())),
    })
}

#[allow(clippy::cast_possible_truncation)] // in the range
fn whole(number: f64, range: Option<(f64, f64)>) -> Result<Value, Malformed> {
    let (low, high) = range.unwrap_or((f64::from(i32::MIN), f64::from(i32::MAX)));
    if number.fract() != 0.0 {
        return Err(Malformed::Expected {
            wanted: error::Value::WholeNumber,
            found: error::Value::Number,
        });
    }
    match (low..=high).contains(&number) {
        true => Ok(Value::Whole(number as i64)),
        false => Err(Malformed::Between {
            low: low as i64,
            high: high as i64,
        }),
    }
}

fn exactly<const N: usize>(given: &[f64]) -> Result<[f64; N]> {
    <[f64; N]>::try_from(given).map_err(|_| {
        malformed(Malformed::NumberCount {
            wanted: N,
            found: given.len(),
        })
    })
}

/// Pieces of that length.
fn pieces<const N: usize>(given: &[f64]) -> Result<&[[f64; N]]> {
    match given.as_chunks() {
        (pieces, []) => Ok(pieces),
        (pieces, _) => Err(malformed(Malformed::NumberCount {
            wanted: N * (pieces.len() + 1),
            found: given.len(),
        })),
    }
}

fn of_numbers(kind: Kind, given: &[f64]) -> Result<Value> {
    let tcb = |[tension, continuity, bias]: [f64; 3]| Tcb::new(tension, continuity, bias);
    let vector = |at: &[f64; 3]| DVec3::from_array(*at);
    Ok(match kind {
        Kind::Place => Value::Place(exactly(given)?.into()),
        Kind::Vector => Value::Vector(exactly(given)?.into()),
        Kind::Rotation => {
            let [w, x, y, z] = exactly(given)?;
            Value::Rotation(DQuat::from_xyzw(x, y, z, w))
        }
        Kind::Colour => Value::Colour(exactly(given)?),
        Kind::Cone => Value::Cone(exactly(given)?),
        Kind::Speeds => Value::Speeds(exactly(given)?),
        Kind::Shape => Value::Shape(tcb(exactly(given)?)),
        Kind::Presets => {
            let all = exactly::<{ 3 * PRESETS }>(given)?;
            let (all, _) = all.as_chunks();
            Value::Presets(std::array::from_fn(|at| tcb(all[at])))
        }
        Kind::BaseFrames => {
            let [movement, turning, zoom, rolling] = exactly(given)?;
            Value::BaseFrames(BaseFrames {
                movement,
                turning,
                zoom,
                rolling,
            })
        }
        Kind::Ease => {
            let [kind, rise, fall, cruise] = exactly(given)?;
            let known = EaseKind::ALL
                .into_iter()
                .find(|known| f64::from(*known as u8) == kind);
            let kind = known.ok_or(malformed(Malformed::OneOf(EaseKind::NAMES)))?;
            Value::Ease(Ease {
                kind,
                rise,
                fall,
                cruise,
            })
        }
        Kind::Distance => own::distance(pieces(given)?)?.value(),
        Kind::Pair(names) => {
            let both = exactly::<6>(given)?;
            let (both, _) = both.as_chunks();
            Value::Pair(names, [vector(&both[0]), vector(&both[1])])
        }
        Kind::UpPath => {
            let points = pieces::<9>(given)?.iter().map(|numbers| {
                let (vectors, _) = numbers.as_chunks();
                UpPathPoint {
                    position: vector(&vectors[0]),
                    before: vector(&vectors[1]),
                    after: vector(&vectors[2]),
                }
            });
            Value::UpPath(UpPath::new(points.collect())?)
        }
        other => return Err(other_form(Form::of(other), Form::Numbers)),
    })
}

/// The numbers of a value that has several.
pub(super) fn numbers(value: &Value) -> Vec<f64> {
    let tcb = |tcb: &Tcb| [tcb.tension, tcb.continuity, tcb.bias];
    match value {
        Value::Place(v) | Value::Vector(v) => v.to_array().to_vec(),
        Value::Rotation(q) => vec![q.w, q.x, q.y, q.z],
        Value::Colour(colour) => colour.to_vec(),
        Value::Cone(angles) => angles.to_vec(),
        Value::Speeds(speeds) => speeds.to_vec(),
        Value::Shape(shape) => tcb(shape).to_vec(),
        Value::Presets(presets) => presets.iter().flat_map(tcb).collect(),
        Value::BaseFrames(frames) => {
            vec![frames.movement, frames.turning, frames.zoom, frames.rolling]
        }
        Value::Ease(ease) => vec![
            f64::from(ease.kind as u8),
            ease.rise,
            ease.fall,
            ease.cruise,
        ],
        Value::Distance(keys) => keys.as_flattened().to_vec(),
        Value::Pair(_, pair) => pair.iter().flat_map(DVec3::to_array).collect(),
        Value::UpPath(path) => {
            let vectors = path
                .points()
                .iter()
                .flat_map(|point| [point.position, point.before, point.after]);
            vectors.flat_map(|v| v.to_array()).collect()
        }
        _ => Vec::new(),
    }
}
