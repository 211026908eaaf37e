//! JSON read from hostile files: values that know where they stand.

use std::fmt;

use glam::{DMat4, DVec3};
use serde_json::Value;
use vides_engine::math::camera::CameraAxes;
use vides_engine::path::{Pose, Up};

use super::error::{Cause, Place, Result, Wanted};

/// Bytes that the parser takes, by a generous estimate, for an object and for any other value.
const OBJECT: usize = 700;
const VALUE: usize = 160;

/// Limit on the memory of what is parsed.
const MAX_PARSED: usize = 2 << 30;

/// The value of a whole text; the parser's words name line and column.
///
/// # Errors
/// [`Cause::Syntax`]; [`Cause::Long`] if parsing could take too much memory.
pub(super) fn parse(bytes: &[u8]) -> Result<Value> {
    // Some editors put a mark of the byte order before a text.
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    let weight = bytes.iter().fold(2 * bytes.len(), |weight, byte| {
        weight
            + match byte {
                b'{' => OBJECT,
                b'[' | b',' | b':' => VALUE,
                _ => 0,
            }
    });
    if weight > MAX_PARSED {
        return Err(Place::Whole.wrong(Cause::Long));
    }
    vides_document::error::can_allocate(weight)?;
    // serde_json itself refuses what lies deeper than 128 levels.
    serde_json::from_slice(bytes).map_err(|error| {
        // The parser repeats the line.
        let said = error.to_string();
        let words = said.split(" at line ").next().unwrap_or(&said);
        let said = format!("{words} (column {})", error.column());
        Place::Line(error.line()).wrong(Cause::Syntax(said.as_str().into()))
    })
}

/// A value and the keys that lead to it.
#[derive(Clone, Copy)]
pub(super) struct At<'a> {
    pub(super) value: &'a Value,
    /// The way from the root; what lies deeper than this is named by the first steps.
    way: [Step<'a>; 6],
    depth: usize,
}

#[derive(Clone, Copy)]
enum Step<'a> {
    None,
    Key(&'a str),
    Index(usize),
}

impl<'a> At<'a> {
    pub(super) const fn root(value: &'a Value) -> Self {
        Self {
            value,
            way: [Step::None; 6],
            depth: 0,
        }
    }

    fn step(self, step: Step<'a>, value: &'a Value) -> Self {
        let mut way = self.way;
        if let Some(place) = way.get_mut(self.depth) {
            *place = step;
        }
        Self {
            value,
            way,
            depth: self.depth + 1,
        }
    }

    /// The value of a key; none if missing, or null.
    pub(super) fn get(self, key: &'a str) -> Option<Self> {
        let value = self.value.get(key).filter(|value| !value.is_null())?;
        Some(self.step(Step::Key(key), value))
    }

    /// The value of a key.
    ///
    /// # Errors
    /// [`Cause::Missing`].
    pub(super) fn need(self, key: &'a str) -> Result<Self> {
        self.get(key)
            .ok_or_else(|| self.wrong(Cause::Missing(key.into())))
    }

    /// The elements of an array.
    ///
    /// # Errors
    /// [`Wanted::List`].
    pub(super) fn list(self) -> Result<impl ExactSizeIterator<Item = Self> + Clone> {
        let Value::Array(list) = self.value else {
            return Err(self.expected(Wanted::List));
        };
        let element = move |(at, value)| self.step(Step::Index(at), value);
        Ok(list.iter().enumerate().map(element))
    }

    /// An element of an array.
    ///
    /// # Errors
    /// [`Wanted::List`], [`Cause::Index`].
    pub(super) fn element(self, index: usize) -> Result<Self> {
        let Value::Array(list) = self.value else {
            return Err(self.expected(Wanted::List));
        };
        let found = list.get(index).ok_or_else(|| {
            self.wrong(Cause::Index {
                index: index as u64,
                count: list.len(),
            })
        })?;
        Ok(self.step(Step::Index(index), found))
    }

    /// # Errors
    /// [`Wanted::WholeNumber`].
    pub(super) fn index(self) -> Result<usize> {
        let index = self.value.as_u64().and_then(|index| index.try_into().ok());
        index.ok_or_else(|| self.expected(Wanted::WholeNumber))
    }

    /// # Errors
    /// [`Wanted::Number`], [`Cause::NotFinite`].
    pub(super) fn number(self) -> Result<f64> {
        let number = self
            .value
            .as_f64()
            .ok_or_else(|| self.expected(Wanted::Number))?;
        if number.is_finite() {
            Ok(number)
        } else {
            Err(self.wrong(Cause::NotFinite))
        }
    }

    /// # Errors
    /// As [`At::number`]; [`Wanted::PositiveNumber`].
    pub(super) fn positive(self) -> Result<f64> {
        let number = self.number()?;
        if number > 0.0 {
            Ok(number)
        } else {
            Err(self.expected(Wanted::PositiveNumber))
        }
    }

    /// # Errors
    /// [`Wanted::Text`].
    pub(super) fn text(self) -> Result<&'a str> {
        self.value
            .as_str()
            .ok_or_else(|| self.expected(Wanted::Text))
    }

    /// An up axis, by its name.
    ///
    /// # Errors
    /// [`Wanted::Text`], [`Cause::Unsupported`].
    pub(super) fn up(self) -> Result<Up> {
        let name = self.text()?;
        Up::named(name).ok_or_else(|| {
            self.wrong(Cause::Unsupported {
                name: name.chars().take(64).collect::<String>().as_str().into(),
                help: "",
            })
        })
    }

    /// A list of exactly this many numbers.
    ///
    /// # Errors
    /// [`Wanted::List`], [`Cause::NumberCount`], those of [`At::number`].
    pub(super) fn numbers<const N: usize>(self) -> Result<[f64; N]> {
        let list = self.list()?;
        if list.len() != N {
            return Err(self.wrong(Cause::NumberCount {
                wanted: N,
                found: list.len(),
            }));
        }
        let mut numbers = [0.0; N];
        for (number, value) in numbers.iter_mut().zip(list) {
            *number = value.number()?;
        }
        Ok(numbers)
    }

    /// Four rows of four numbers, or three, the last being 0 0 0 1.
    ///
    /// # Errors
    /// [`Wanted::Matrix`], those of [`At::numbers`].
    pub(super) fn rows(self) -> Result<DMat4> {
        let rows = self.list()?;
        if !(3..=4).contains(&rows.len()) {
            return Err(self.expected(Wanted::Matrix));
        }
        let mut matrix = DMat4::IDENTITY.transpose().to_cols_array_2d();
        for (row, value) in matrix.iter_mut().zip(rows) {
            *row = value.numbers()?;
        }
        Ok(DMat4::from_cols_array_2d(&matrix).transpose())
    }

    /// Three rows of three numbers.
    ///
    /// # Errors
    /// [`Cause::NumberCount`], those of [`At::numbers`].
    pub(super) fn vectors(self) -> Result<[DVec3; 3]> {
        let rows = self.list()?;
        if rows.len() != 3 {
            let (wanted, found) = (3, rows.len());
            return Err(self.wrong(Cause::NumberCount { wanted, found }));
        }
        let mut vectors = [DVec3::ZERO; 3];
        for (vector, value) in vectors.iter_mut().zip(rows) {
            *vector = value.numbers()?.into();
        }
        Ok(vectors)
    }

    /// The pose of a camera with these axes whose matrix to world coordinates this is.
    ///
    /// # Errors
    /// [`Wanted::Rotation`], [`Cause::NotFinite`].
    pub(super) fn pose(self, matrix: DMat4, axes: CameraAxes, zoom: f64) -> Result<Pose> {
        self.place().matrix(matrix, axes, zoom)
    }

    /// An error here.
    pub(super) fn wrong(self, cause: Cause) -> super::error::Error {
        self.place().wrong(cause)
    }

    /// An error here: something else is expected.
    pub(super) fn expected(self, wanted: Wanted) -> super::error::Error {
        self.place().expected(wanted)
    }

    /// Its place in the file.
    pub(super) fn place(self) -> Place {
        match self.depth {
            0 => Place::Whole,
            _ => Place::Key((&self).into()),
        }
    }
}

impl fmt::Display for At<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (at, step) in self.way.iter().take(self.depth).enumerate() {
            match step {
                Step::None => {}
                Step::Key(key) if at == 0 => write!(f, "{key}")?,
                Step::Key(key) => write!(f, ".{key}")?,
                Step::Index(index) => write!(f, "[{index}]")?,
            }
        }
        Ok(())
    }
}
