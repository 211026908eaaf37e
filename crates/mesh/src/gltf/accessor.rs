//! Typed numbers in buffers: all component types, normalised or not, with strides, sparse or dense.

use serde_json::Value;

use super::container::{Container, END, FORMAT, INDICES, count_or, element, index, list};
use crate::error::{Error, Problem, Result};

/// The type of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Component {
    /// Eight bits with a sign.
    I8,
    /// Eight bits.
    U8,
    /// Sixteen bits with a sign.
    I16,
    /// Sixteen bits.
    U16,
    /// Thirty-two bits.
    U32,
    /// IEEE 754, thirty-two bits.
    F32,
}

impl Component {
    fn of(value: &Value) -> Result<Self> {
        Ok(match value.as_u64() {
            Some(5120) => Self::I8,
            Some(5121) => Self::U8,
            Some(5122) => Self::I16,
            Some(5123) => Self::U16,
            Some(5125) => Self::U32,
            Some(5126) => Self::F32,
            _ => return Err(FORMAT),
        })
    }

    const fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::U32 | Self::F32 => 4,
        }
    }

    /// Whether it may be the type of point indices.
    #[must_use]
    pub const fn counts(self) -> bool {
        matches!(self, Self::U8 | Self::U16 | Self::U32)
    }

    /// The value that stands for 1 if numbers are normalised.
    const fn one(self) -> f64 {
        match self {
            Self::I8 => 127.0,
            Self::U8 => 255.0,
            Self::I16 => 32767.0,
            Self::U16 => 65535.0,
            Self::U32 => 4_294_967_295.0,
            Self::F32 => 1.0,
        }
    }

    /// The number at the beginning of the bytes; 0 if there are too few.
    #[inline]
    fn number(self, bytes: &[u8]) -> f64 {
        match (self, bytes) {
            (Self::F32, &[a, b, c, d, ..]) => f64::from(f32::from_le_bytes([a, b, c, d])),
            (Self::U32, &[a, b, c, d, ..]) => f64::from(u32::from_le_bytes([a, b, c, d])),
            (Self::I16, &[a, b, ..]) => f64::from(i16::from_le_bytes([a, b])),
            (Self::U16, &[a, b, ..]) => f64::from(u16::from_le_bytes([a, b])),
            (Self::I8, &[a, ..]) => f64::from(a as i8),
            (Self::U8, &[a, ..]) => f64::from(a),
            _ => 0.0,
        }
    }
}

/// Elements of one or more numbers each. All of them are within their buffers.
#[derive(Clone, Debug)]
pub struct Accessor<'a> {
    /// `None`: all are 0.
    bytes: Option<&'a [u8]>,
    stride: usize,
    count: usize,
    width: usize,
    component: Component,
    normalised: bool,
    sparse: Option<Sparse<'a>>,
}

/// Elements that replace others.
#[derive(Clone, Copy, Debug)]
struct Sparse<'a> {
    count: usize,
    indices: &'a [u8],
    component: Component,
    values: &'a [u8],
}

impl Sparse<'_> {
    fn index(&self, at: usize) -> usize {
        let start = at * self.component.size();
        self.component
            .number(self.indices.get(start..).unwrap_or_default()) as usize
    }

    /// The position of an element in this list.
    fn find(&self, element: usize) -> Option<usize> {
        let (mut low, mut high) = (0, self.count);
        while low < high {
            let middle = low + (high - low) / 2;
            if self.index(middle) < element {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        (low < self.count && self.index(low) == element).then_some(low)
    }
}

impl Accessor<'_> {
    /// The number of elements.
    #[must_use]
    pub const fn count(&self) -> usize {
        self.count
    }

    /// The number of numbers in an element: 1 to 4.
    #[must_use]
    pub const fn width(&self) -> usize {
        self.width
    }

    /// The type of the numbers.
    #[must_use]
    pub const fn component(&self) -> Component {
        self.component
    }

    /// A number of an element, normalised if the file requires it; 0 beyond the ends.
    #[must_use]
    #[inline]
    pub fn number(&self, at: usize, part: usize) -> f64 {
        let size = self.component.size();
        let found = self.sparse.as_ref().and_then(|sparse| {
            let row = sparse.find(at)?;
            sparse.values.get((row * self.width + part) * size..)
        });
        let plain = || {
            self.bytes?
                .get(at.checked_mul(self.stride)? + part * size..)
        };
        let bytes = found.or_else(plain).unwrap_or_default();
        let number = self.component.number(bytes);
        if self.normalised {
            (number / self.component.one()).max(-1.0)
        } else {
            number
        }
    }

    /// A share from 0 to 1: integers are always normalised, whatever the file requires.
    #[must_use]
    pub fn share(&self, at: usize, part: usize) -> f64 {
        let number = self.number(at, part);
        if self.normalised {
            number
        } else {
            number / self.component.one()
        }
    }
}

/// The bytes of `count` elements, each `size` bytes and `stride` apart.
fn enough(bytes: &[u8], count: usize, stride: usize, size: usize) -> Result<&[u8]> {
    let needed = count
        .saturating_sub(1)
        .checked_mul(stride)
        .and_then(|before| before.checked_add(if count > 0 { size } else { 0 }));
    needed.and_then(|needed| bytes.get(..needed)).ok_or(END)
}

impl Container<'_> {
    /// An accessor by its index. Without a buffer it has at most `most` elements.
    ///
    /// # Errors
    /// [`Error::File`] if it exceeds its buffer or is not valid.
    pub fn accessor(&self, number: &Value, most: usize) -> Result<Accessor<'_>> {
        let accessor = element(list(&self.json()["accessors"]), number)?;
        let width = match accessor["type"].as_str() {
            Some("SCALAR") => 1,
            Some("VEC2") => 2,
            Some("VEC3") => 3,
            Some("VEC4") => 4,
            _ => return Err(FORMAT),
        };
        let component = Component::of(&accessor["componentType"])?;
        let count = index(&accessor["count"]).ok_or(FORMAT)?;
        let size = width * component.size();
        let (bytes, stride) = match &accessor["bufferView"] {
            Value::Null => {
                // No buffer bounds the count.
                if count > most {
                    return Err(Error::File(Problem::Long));
                }
                (None, size)
            }
            view => {
                let (bytes, stride) = self.view(view, count_or(&accessor["byteOffset"], 0)?)?;
                let stride = stride.unwrap_or(size).max(size);
                (Some(enough(bytes, count, stride, size)?), stride)
            }
        };
        let sparse = match accessor.get("sparse") {
            None => None,
            Some(sparse) => Some(self.sparse(sparse, count, size)?),
        };
        Ok(Accessor {
            bytes,
            stride,
            count,
            width,
            component,
            normalised: accessor["normalized"] == true && component != Component::F32,
            sparse,
        })
    }

    fn sparse(&self, json: &Value, elements: usize, size: usize) -> Result<Sparse<'_>> {
        let count = index(&json["count"]).ok_or(FORMAT)?;
        let rows = |what: &Value, size: usize| {
            let offset = count_or(&what["byteOffset"], 0)?;
            let (bytes, _) = self.view(&what["bufferView"], offset)?;
            enough(bytes, count, size, size)
        };
        let component = Component::of(&json["indices"]["componentType"])?;
        if !component.counts() {
            return Err(FORMAT);
        }
        let sparse = Sparse {
            count,
            component,
            indices: rows(&json["indices"], component.size())?,
            values: rows(&json["values"], size)?,
        };
        let sorted = (1..count).all(|at| sparse.index(at - 1) < sparse.index(at));
        if !sorted || (count > 0 && sparse.index(count - 1) >= elements) {
            return Err(INDICES);
        }
        Ok(sparse)
    }
}
