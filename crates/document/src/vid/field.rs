//! One `key = value` of a file, with its line: typed access whose errors say
//! where and why.

use glam::DVec3;
use toml::Spanned;
use toml::de::{DeString, DeTable, DeValue, Error as ParseError};

use crate::error::{Error, Message, Result, message};
use crate::path::Space;

/// A piece of a file, and the whole for its line numbers.
#[derive(Clone, Copy)]
pub struct Source<'a> {
    /// The whole text.
    pub text: &'a str,
    /// Where the piece begins.
    pub start: usize,
}

impl Source<'_> {
    /// What the parser stumbled over, in the parser's words.
    pub fn not_toml(self, error: &ParseError) -> Error {
        let offset = error.span().map_or(0, |span| span.start);
        let words = Message::from(error.message().to_owned());
        self.complain(offset, words)
    }

    /// A sentence about the place at a byte offset of the piece.
    pub fn complain(self, offset: usize, reason: Message) -> Error {
        Error::Format(message!("line {0}: {1}", self.line(offset), reason))
    }

    /// The line of a byte offset of the piece.
    pub fn line(self, offset: usize) -> usize {
        let end = (self.start + offset).min(self.text.len());
        let before = &self.text.as_bytes()[..end];
        1 + before.iter().filter(|&&byte| byte == b'\n').count()
    }
}

/// A key (or a place in an array) and its value.
#[derive(Clone, Copy)]
pub struct Field<'a> {
    source: Source<'a>,
    /// The key; in an array, that of the array.
    pub key: &'a str,
    /// Where the complaint is: byte offset of the value, or of its key.
    offset: usize,
    value: &'a DeValue<'a>,
}

/// The fields of a table, in alphabetical order.
pub fn fields<'a>(source: Source<'a>, table: &'a DeTable<'a>) -> impl Iterator<Item = Field<'a>> {
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

    /// Its line in the file. To find it takes time in proportion to the file.
    pub fn line(&self) -> usize {
        self.source.line(self.offset)
    }

    /// Its place in the file: a byte offset.
    pub fn place(&self) -> usize {
        self.source.start + self.offset
    }

    /// Whether it is an array.
    pub fn is_array(&self) -> bool {
        matches!(self.value, DeValue::Array(_))
    }

    /// The field of a table with this key.
    pub fn find(&self, key: &str) -> Result<Option<Field<'a>>> {
        Ok(self.fields()?.find(|field| field.key == key))
    }

    /// An error at this place.
    pub fn error(&self, reason: Message) -> Error {
        let reason = message!("{0}: {1}", self.key, reason);
        self.source.complain(self.offset, reason)
    }

    /// The error of a check, at this place.
    pub fn checked<T>(&self, result: Result<T>) -> Result<T> {
        result.map_err(|error| match error {
            Error::Memory => error,
            other => self.error(other.into_message()),
        })
    }

    /// The error of a key that does not belong here.
    pub fn unknown(&self, known: &[&str]) -> Error {
        self.source.complain(
            self.offset,
            message!(
                "unknown key \"{0}\"; known here: {1}",
                self.key.escape_debug().to_string(),
                known.join(", ")
            ),
        )
    }

    fn mismatch(&self, wanted: Message) -> Error {
        let found = match self.value {
            DeValue::String(_) => message!("a text"),
            DeValue::Integer(_) => message!("a whole number"),
            DeValue::Float(_) => message!("a decimal number"),
            DeValue::Boolean(_) => message!("true or false"),
            DeValue::Datetime(_) => message!("a date or time"),
            DeValue::Array(_) => message!("an array"),
            DeValue::Table(_) => message!("a table"),
        };
        self.error(message!("expected {0}, found {1}", wanted, found))
    }

    /// A finite number, written with or without a decimal point.
    pub fn number(&self) -> Result<f64> {
        let number = match self.value {
            DeValue::Float(float) => float.as_str().parse().ok(),
            DeValue::Integer(integer) if integer.radix() == 10 => integer.as_str().parse().ok(),
            DeValue::Integer(integer) => i64::from_str_radix(integer.as_str(), integer.radix())
                .ok()
                .map(|integer| integer as f64),
            _ => return Err(self.mismatch(message!("a number"))),
        };
        match number {
            Some(number) if f64::is_finite(number) => Ok(number),
            _ => Err(self.error(message!("the number must be finite"))),
        }
    }

    /// A whole number.
    pub fn integer(&self) -> Result<i64> {
        match self.value {
            DeValue::Integer(integer) => i64::from_str_radix(integer.as_str(), integer.radix())
                .map_err(|_| self.error(message!("the number is too large"))),
            _ => Err(self.mismatch(message!("a whole number"))),
        }
    }

    /// A whole number of some range.
    pub fn integer_in(&self, low: i64, high: i64) -> Result<i64> {
        let integer = self.integer()?;
        if (low..=high).contains(&integer) {
            Ok(integer)
        } else {
            Err(self.error(message!("must lie between {0} and {1}", low, high)))
        }
    }

    /// `true` or `false`.
    pub fn boolean(&self) -> Result<bool> {
        match self.value {
            DeValue::Boolean(boolean) => Ok(*boolean),
            _ => Err(self.mismatch(message!("true or false"))),
        }
    }

    /// A text.
    pub fn text(&self) -> Result<&'a str> {
        match self.value {
            DeValue::String(text) => Ok(text),
            _ => Err(self.mismatch(message!("a text in quotes"))),
        }
    }

    /// The fields of a table.
    pub fn fields(&self) -> Result<impl Iterator<Item = Field<'a>> + use<'a>> {
        match self.value {
            DeValue::Table(table) => Ok(fields(self.source, table)),
            _ => Err(self.mismatch(message!("a table"))),
        }
    }

    /// The elements of an array.
    pub fn elements(&self) -> Result<impl ExactSizeIterator<Item = Field<'a>> + use<'a>> {
        let DeValue::Array(array) = self.value else {
            return Err(self.mismatch(message!("an array")));
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
    pub fn numbers<const N: usize>(&self) -> Result<[f64; N]> {
        let elements = self.elements()?;
        if elements.len() != N {
            return Err(self.error(message!(
                "expected {0} numbers, found {1}",
                N,
                elements.len()
            )));
        }
        let mut numbers = [0.0; N];
        for (number, element) in numbers.iter_mut().zip(elements) {
            *number = element.number()?;
        }
        Ok(numbers)
    }

    /// A place in a space.
    pub fn place_in(&self, space: Space) -> Result<DVec3> {
        let place = DVec3::from_array(self.numbers()?);
        self.checked(space.check_place(place))?;
        Ok(place)
    }

    /// Three coordinates.
    pub fn vector(&self) -> Result<DVec3> {
        let vector = DVec3::from_array(self.numbers()?);
        self.checked(crate::path::camera_path::check_coordinates(vector))?;
        Ok(vector)
    }
}
