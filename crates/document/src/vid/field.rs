//! Typed access to the `key = value` fields of a file, with errors that give line and reason.

use glam::{DQuat, DVec3};
use toml::de::Error as ParseError;

use super::tree::{Placed, Table, Value as Node};
use crate::error::{EngineError, Error, Key, Malformed, Quantity, Result, Value};
use vides_engine::path::camera_path::check_shape;
use vides_engine::path::{Space, Tcb};
use vides_engine::property::{self, Kind, Stored};

/// A piece of a file, with the whole text for line numbers.
#[derive(Clone, Copy)]
pub struct Source<'a> {
    /// The whole text.
    pub text: &'a str,
    /// Where the piece begins.
    pub start: usize,
}

impl Source<'_> {
    /// A parser error, in the parser's words.
    pub fn not_toml(self, error: &ParseError) -> Error {
        let offset = error.span().map_or(0, |span| span.start);
        self.complain(offset, Malformed::Toml(error.message().into()))
    }

    /// An error at a byte offset of the piece.
    pub fn complain(self, offset: usize, cause: impl Into<Malformed>) -> Error {
        at_line(self.line(offset), cause)
    }

    /// The line of a byte offset of the piece.
    pub fn line(self, offset: usize) -> usize {
        let end = (self.start + offset).min(self.text.len());
        let before = &self.text.as_bytes()[..end];
        1 + before.iter().filter(|&&byte| byte == b'\n').count()
    }
}

/// An error in a line.
pub fn at_line(line: usize, cause: impl Into<Malformed>) -> Error {
    Error::Format {
        line,
        key: Key(None),
        cause: cause.into(),
    }
}

/// A key, or an element of an array, and its value.
#[derive(Clone, Copy)]
pub struct Field<'a> {
    source: Source<'a>,
    /// The key; for an element, that of its array.
    pub key: &'a str,
    /// Where errors are reported: byte offset of the key, or of the element.
    offset: usize,
    value: &'a Node<'a>,
}

/// The fields of a table, in alphabetical order.
pub fn fields<'a>(source: Source<'a>, table: &'a Table<'a>) -> impl Iterator<Item = Field<'a>> {
    let entries = table.entries.iter();
    entries.map(move |(key, placed)| Field::new(source, key, placed))
}

impl<'a> Field<'a> {
    fn new(source: Source<'a>, key: &'a str, (offset, value): &'a Placed<'a>) -> Self {
        Self {
            source,
            key,
            offset: *offset,
            value,
        }
    }

    /// Its line; takes time proportional to the file.
    pub fn line(&self) -> usize {
        self.source.line(self.offset)
    }

    /// Its byte offset in the file.
    pub fn offset(&self) -> usize {
        self.source.start + self.offset
    }

    /// Whether it is an array.
    pub fn is_array(&self) -> bool {
        matches!(self.value, Node::Array(_))
    }

    /// The field of a table with this key.
    pub fn find(&self, key: &str) -> Result<Option<Field<'a>>> {
        Ok(self.fields()?.find(|field| field.key == key))
    }

    /// An error at this field.
    pub fn error(&self, cause: impl Into<Malformed>) -> Error {
        Error::Format {
            line: self.line(),
            key: Key(Some(self.key.into())),
            cause: cause.into(),
        }
    }

    /// Reports the error of a check at this field.
    pub fn checked<T>(&self, result: Result<T, EngineError>) -> Result<T> {
        result.map_err(|error| match error {
            EngineError::Memory => error.into(),
            other => self.error(other),
        })
    }

    /// The error for an unknown key.
    pub fn unknown(&self, known: &[&str]) -> Error {
        self.source.complain(
            self.offset,
            Malformed::UnknownKey {
                key: (&self.key.escape_debug()).into(),
                known: (&known.join(", ")).into(),
            },
        )
    }

    fn mismatch(&self, wanted: Value) -> Error {
        let found = match self.value {
            Node::Text(_) => Value::Text,
            Node::Integer(..) => Value::WholeNumber,
            Node::Float(_) => Value::DecimalNumber,
            Node::Boolean(_) => Value::Boolean,
            Node::Date => Value::DateOrTime,
            Node::Array(_) => Value::Array,
            Node::Table(_) => Value::Table,
        };
        self.error(Malformed::Expected { wanted, found })
    }

    /// A finite number, with or without a decimal point.
    pub fn number(&self) -> Result<f64> {
        match self.value {
            Node::Float(number) | Node::Integer(number, _) if number.is_finite() => Ok(*number),
            Node::Float(_) | Node::Integer(..) => Err(self.error(Malformed::NotFinite)),
            _ => Err(self.mismatch(Value::Number)),
        }
    }

    /// An integer.
    pub fn integer(&self) -> Result<i64> {
        match self.value {
            Node::Integer(_, Some(whole)) => Ok(*whole),
            Node::Integer(..) => Err(self.error(Malformed::TooLarge)),
            _ => Err(self.mismatch(Value::WholeNumber)),
        }
    }

    /// An integer from `low` to `high`.
    pub fn integer_in(&self, low: i64, high: i64) -> Result<i64> {
        let integer = self.integer()?;
        if (low..=high).contains(&integer) {
            Ok(integer)
        } else {
            Err(self.error(Malformed::Between { low, high }))
        }
    }

    /// The value of a property of a kind that has nothing below it; others are unset.
    pub fn plain(&self, kind: Kind, range: Option<(f64, f64)>) -> Result<property::Value> {
        Ok(match kind {
            Kind::Number => self.number()?.into(),
            Kind::Whole => {
                let (least, most) = range.unwrap_or((0.0, f64::from(u32::MAX)));
                property::Value::Whole(self.integer_in(least as i64, most as i64)?)
            }
            Kind::Switch => self.boolean()?.into(),
            Kind::Choice(names) => property::Value::Choice(self.name_of(names)?),
            Kind::Text => self.text()?.to_owned().into(),
            Kind::Place => property::Value::Place(DVec3::from_array(self.numbers()?)),
            Kind::Vector => property::Value::Vector(DVec3::from_array(self.numbers()?)),
            Kind::Rotation => {
                let [w, x, y, z] = self.numbers()?;
                DQuat::from_xyzw(x, y, z, w).into()
            }
            Kind::Colour => property::Value::Colour(self.numbers()?),
            Kind::Cone => property::Value::Cone(self.numbers()?),
            Kind::Pair(names) => property::Value::Pair(names, self.pair(names)?),
            Kind::Speeds => property::Value::Speeds(self.numbers()?),
            Kind::Shape => self.tcb()?.into(),
            _ => property::Value::Unset,
        })
    }

    /// Two vectors, both given.
    fn pair(&self, names: [&'static str; 2]) -> Result<[DVec3; 2]> {
        let mut found = [None; 2];
        for field in self.fields()? {
            match names.iter().position(|&name| name == field.key) {
                Some(at) => found[at] = Some(DVec3::from_array(field.numbers()?)),
                None => return Err(field.unknown(&names)),
            }
        }
        match found {
            [Some(a), Some(b)] => Ok([a, b]),
            _ => Err(self.error(Malformed::Both(names[0], names[1]))),
        }
    }

    /// Tension, continuity and bias; each is 0 unless given.
    pub fn tcb(&self) -> Result<Tcb> {
        let mut tcb = Tcb::default();
        for field in self.fields()? {
            let (value, what) = match field.key {
                "tension" => (&mut tcb.tension, Quantity::Tension),
                "continuity" => (&mut tcb.continuity, Quantity::Continuity),
                "bias" => (&mut tcb.bias, Quantity::Bias),
                _ => return Err(field.unknown(&["tension", "continuity", "bias"])),
            };
            *value = field.number()?;
            field.checked(check_shape(*value, what))?;
        }
        Ok(tcb)
    }

    /// `true` or `false`.
    pub fn boolean(&self) -> Result<bool> {
        match self.value {
            Node::Boolean(boolean) => Ok(*boolean),
            _ => Err(self.mismatch(Value::Boolean)),
        }
    }

    /// A string.
    pub fn text(&self) -> Result<&'a str> {
        match self.value {
            Node::Text(text) => Ok(text),
            _ => Err(self.mismatch(Value::TextInQuotes)),
        }
    }

    /// One of these names.
    pub fn name_of(&self, names: &'static [&'static str]) -> Result<&'static str> {
        let name = self.text()?;
        let found = names.iter().find(|known| **known == name);
        found
            .copied()
            .ok_or_else(|| self.error(Malformed::OneOf(names)))
    }

    /// One of a choice, by its name.
    pub fn choice<T: Stored + Default>(&self) -> Result<T> {
        let name = self.plain(T::KINDS[0], None)?;
        Ok(T::of(name).unwrap_or_default())
    }

    /// The value that one of these names stands for.
    pub fn one_of<T, const N: usize>(
        &self,
        names: &'static [&'static str; N],
        values: [T; N],
    ) -> Result<T> {
        let name = self.name_of(names)?;
        let mut known = names.iter().zip(values);
        let found = known.find_map(|(known, value)| (*known == name).then_some(value));
        found.ok_or_else(|| self.error(Malformed::OneOf(names)))
    }

    /// The fields of a table.
    pub fn fields(&self) -> Result<impl Iterator<Item = Field<'a>> + use<'a>> {
        match self.value {
            Node::Table(table) => Ok(fields(self.source, table)),
            _ => Err(self.mismatch(Value::Table)),
        }
    }

    /// The elements of an array.
    pub fn elements(&self) -> Result<impl ExactSizeIterator<Item = Field<'a>> + use<'a>> {
        let Node::Array(array) = self.value else {
            return Err(self.mismatch(Value::Array));
        };
        let (source, key) = (self.source, self.key);
        Ok(array
            .iter()
            .map(move |element| Field::new(source, key, element)))
    }

    /// An array of exactly `N` numbers.
    pub fn numbers<const N: usize>(&self) -> Result<[f64; N]> {
        let elements = self.elements()?;
        if elements.len() != N {
            return Err(self.error(Malformed::NumberCount {
                wanted: N,
                found: elements.len(),
            }));
        }
        let mut numbers = [0.0; N];
        for (number, element) in numbers.iter_mut().zip(elements) {
            *number = element.number()?;
        }
        Ok(numbers)
    }

    /// A position within a space.
    pub fn place_in(&self, space: Space) -> Result<DVec3> {
        let place = DVec3::from_array(self.numbers()?);
        self.checked(space.check_place(place))?;
        Ok(place)
    }

    /// Three coordinates.
    pub fn vector(&self) -> Result<DVec3> {
        let vector = DVec3::from_array(self.numbers()?);
        self.checked(vides_engine::path::camera_path::check_coordinates(vector))?;
        Ok(vector)
    }
}
