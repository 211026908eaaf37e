//! One `key = value` of a file, with its line: typed access whose errors say
//! where and why.

use std::fmt::Display;

use glam::DVec3;
use toml::Spanned;
use toml::de::{DeString, DeTable, DeValue};

use crate::error::{Error, Result};

/// A piece of a file, and the whole for its line numbers.
#[derive(Clone, Copy)]
pub(crate) struct Source<'a> {
    /// The whole text.
    pub(crate) text: &'a str,
    /// Where the piece begins.
    pub(crate) start: usize,
}

impl Source<'_> {
    /// A sentence about the place at a byte offset of the piece.
    pub(crate) fn complain(self, offset: usize, reason: impl Display) -> Error {
        Error::Format(format!("line {}: {reason}", self.line(offset)).into())
    }

    /// The line of a byte offset of the piece.
    pub(crate) fn line(self, offset: usize) -> usize {
        let end = (self.start + offset).min(self.text.len());
        let before = &self.text.as_bytes()[..end];
        1 + before.iter().filter(|&&byte| byte == b'\n').count()
    }
}

/// A key (or a place in an array) and its value.
#[derive(Clone, Copy)]
pub(crate) struct Field<'a> {
    source: Source<'a>,
    /// The key; in an array, that of the array.
    pub(crate) key: &'a str,
    /// Where the complaint is: byte offset of the value, or of its key.
    offset: usize,
    value: &'a DeValue<'a>,
}

/// The fields of a table, in alphabetical order.
pub(crate) fn fields<'a>(
    source: Source<'a>,
    table: &'a DeTable<'a>,
) -> impl Iterator<Item = Field<'a>> {
    table
        .iter()
        .map(move |(key, value)| Field::new(source, key, value))
}

impl<'a> Field<'a> {
    fn new(
        source: Source<'a>,
        key: &'a Spanned<DeString<'a>>,
        value: &'a Spanned<DeValue<'a>>,
    ) -> Self {
        // A table begins at its header; of an array over several lines, the
        // line of the key tells more than that of its bracket.
        Self {
            source,
            key: key.get_ref(),
            offset: key.span().start,
            value: value.get_ref(),
        }
    }

    /// An error at this place.
    pub(crate) fn error(&self, reason: impl Display) -> Error {
        let place = format_args!("{}: {reason}", self.key);
        self.source.complain(self.offset, place)
    }

    /// The error of a check, at this place.
    pub(crate) fn checked<T>(&self, result: Result<T>) -> Result<T> {
        result.map_err(|error| match error {
            Error::Memory => error,
            other => self.error(other),
        })
    }

    /// The error of a key that does not belong here.
    pub(crate) fn unknown(&self, known: &[&str]) -> Error {
        self.source.complain(
            self.offset,
            format_args!(
                "unknown key \"{}\"; known here: {}",
                self.key.escape_debug(),
                known.join(", ")
            ),
        )
    }

    fn mismatch(&self, wanted: &str) -> Error {
        let found = match self.value {
            DeValue::String(_) => "a text",
            DeValue::Integer(_) => "a whole number",
            DeValue::Float(_) => "a decimal number",
            DeValue::Boolean(_) => "true or false",
            DeValue::Datetime(_) => "a date or time",
            DeValue::Array(_) => "an array",
            DeValue::Table(_) => "a table",
        };
        self.error(format_args!("expected {wanted}, found {found}"))
    }

    /// A finite number, written with or without a decimal point.
    pub(crate) fn number(&self) -> Result<f64> {
        let number = match self.value {
            DeValue::Float(float) => float.as_str().parse().ok(),
            DeValue::Integer(integer) if integer.radix() == 10 => integer.as_str().parse().ok(),
            DeValue::Integer(integer) => i64::from_str_radix(integer.as_str(), integer.radix())
                .ok()
                .map(|integer| integer as f64),
            _ => return Err(self.mismatch("a number")),
        };
        match number {
            Some(number) if f64::is_finite(number) => Ok(number),
            _ => Err(self.error("the number must be finite")),
        }
    }

    /// A whole number.
    pub(crate) fn integer(&self) -> Result<i64> {
        match self.value {
            DeValue::Integer(integer) => i64::from_str_radix(integer.as_str(), integer.radix())
                .map_err(|_| self.error("the number is too large")),
            _ => Err(self.mismatch("a whole number")),
        }
    }

    /// A whole number of some range.
    pub(crate) fn integer_in(&self, low: i64, high: i64) -> Result<i64> {
        let integer = self.integer()?;
        if (low..=high).contains(&integer) {
            Ok(integer)
        } else {
            Err(self.error(format_args!("must lie between {low} and {high}")))
        }
    }

    /// `true` or `false`.
    pub(crate) fn boolean(&self) -> Result<bool> {
        match self.value {
            DeValue::Boolean(boolean) => Ok(*boolean),
            _ => Err(self.mismatch("true or false")),
        }
    }

    /// A text.
    pub(crate) fn text(&self) -> Result<&'a str> {
        match self.value {
            DeValue::String(text) => Ok(text),
            _ => Err(self.mismatch("a text in quotes")),
        }
    }

    /// The fields of a table.
    pub(crate) fn fields(&self) -> Result<impl Iterator<Item = Field<'a>> + use<'a>> {
        match self.value {
            DeValue::Table(table) => Ok(fields(self.source, table)),
            _ => Err(self.mismatch("a table")),
        }
    }

    /// The elements of an array.
    pub(crate) fn elements(&self) -> Result<impl ExactSizeIterator<Item = Field<'a>> + use<'a>> {
        let DeValue::Array(array) = self.value else {
            return Err(self.mismatch("an array"));
        };
        let (source, key) = (self.source, self.key);
        Ok(array.iter().map(move |element| Field {
            source,
            key,
            offset: element.span().start,
            value: element.get_ref(),
        }))
    }

    /// An array of so many numbers.
    pub(crate) fn numbers<const N: usize>(&self) -> Result<[f64; N]> {
        let elements = self.elements()?;
        if elements.len() != N {
            return Err(self.error(format_args!(
                "expected {N} numbers, found {}",
                elements.len()
            )));
        }
        let mut numbers = [0.0; N];
        for (number, element) in numbers.iter_mut().zip(elements) {
            *number = element.number()?;
        }
        Ok(numbers)
    }

    /// Three coordinates.
    pub(crate) fn vector(&self) -> Result<DVec3> {
        let vector = DVec3::from_array(self.numbers()?);
        self.checked(crate::path::camera_path::check_coordinates(vector))?;
        Ok(vector)
    }
}
