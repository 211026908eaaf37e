//! The binary part of a file that is written: numbers of 32 bits and less, with their accessors.

use serde_json::{Value, json};

use crate::error::{Cause, Place, Result};

/// What an accessor is used for.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Use {
    /// Numbers of points.
    Points,
    /// Corners of lines and triangles.
    Corners,
    /// Times of keys.
    Times,
    /// Values of keys.
    Keys,
}

/// Component types of the format.
const BYTE: u32 = 5121;
const SHORT: u32 = 5123;
const INT: u32 = 5125;
const FLOAT: u32 = 5126;

/// The largest corner that fits 16 bits; 65535 restarts primitives.
const LAST_SHORT: usize = 65_534;

/// All numbers, and the accessors that find them.
#[derive(Default)]
pub(super) struct Binary {
    pub(super) bytes: Vec<u8>,
    pub(super) views: Vec<Value>,
    pub(super) accessors: Vec<Value>,
}

const fn type_name(width: usize) -> &'static str {
    match width {
        2 => "VEC2",
        3 => "VEC3",
        4 => "VEC4",
        _ => "SCALAR",
    }
}

impl Binary {
    /// Floats, `width` an element; returns the number of their accessor.
    ///
    /// # Errors
    /// [`Cause::TooLarge`] for what 32 bits cannot hold; a lack of memory.
    pub(super) fn floats(&mut self, numbers: &[f32], width: usize, usage: Use) -> Result<usize> {
        if !numbers.iter().all(|number| number.is_finite()) {
            return Err(Place::Whole.wrong(Cause::TooLarge));
        }
        let start = self.bytes.len();
        self.bytes.try_reserve(4 * numbers.len())?;
        for number in numbers {
            self.bytes.extend_from_slice(&number.to_le_bytes());
        }
        let mut accessor = json!({"componentType": FLOAT, "count": numbers.len() / width});
        if usage != Use::Keys {
            let mut low = [f32::INFINITY; 4];
            let mut high = [f32::NEG_INFINITY; 4];
            for element in numbers.chunks_exact(width) {
                for (at, &number) in element.iter().enumerate() {
                    low[at] = low[at].min(number);
                    high[at] = high[at].max(number);
                }
            }
            accessor["min"] = low[..width].into();
            accessor["max"] = high[..width].into();
        }
        self.add(start, width, usage, accessor)
    }

    /// Four shares of 16 bits a point.
    pub(super) fn colours(&mut self, colours: &[[u16; 4]]) -> Result<usize> {
        let start = self.bytes.len();
        self.bytes.try_reserve(8 * colours.len())?;
        for share in colours.as_flattened() {
            self.bytes.extend_from_slice(&share.to_le_bytes());
        }
        let accessor = json!({"componentType": SHORT, "normalized": true, "count": colours.len()});
        self.add(start, 4, Use::Points, accessor)
    }

    /// Corners among a number of points.
    pub(super) fn corners(&mut self, corners: &[u32], points: usize) -> Result<usize> {
        let start = self.bytes.len();
        let short = points <= LAST_SHORT + 1;
        self.bytes.try_reserve(4 * corners.len() + 3)?;
        for &corner in corners {
            if short {
                self.bytes.extend_from_slice(&(corner as u16).to_le_bytes());
            } else {
                self.bytes.extend_from_slice(&corner.to_le_bytes());
            }
        }
        let component = if short { SHORT } else { INT };
        let accessor = json!({"componentType": component, "count": corners.len()});
        self.add(start, 1, Use::Corners, accessor)
    }

    /// A switch a key.
    pub(super) fn switches(&mut self, switches: &[u8]) -> Result<usize> {
        let start = self.bytes.len();
        self.bytes.try_reserve(switches.len() + 3)?;
        self.bytes.extend_from_slice(switches);
        let accessor = json!({"componentType": BYTE, "count": switches.len()});
        self.add(start, 1, Use::Keys, accessor)
    }

    /// The accessor of all bytes from `start` on, which are filled up to whole words.
    fn add(
        &mut self,
        start: usize,
        width: usize,
        usage: Use,
        mut accessor: Value,
    ) -> Result<usize> {
        let mut view = json!({
            "buffer": 0,
            "byteOffset": start,
            "byteLength": self.bytes.len() - start,
        });
        match usage {
            Use::Points => view["target"] = 34962.into(),
            Use::Corners => view["target"] = 34963.into(),
            Use::Times | Use::Keys => {}
        }
        self.bytes.try_reserve(3)?;
        let end = self.bytes.len().next_multiple_of(4);
        self.bytes.resize(end, 0);
        accessor["bufferView"] = self.views.len().into();
        accessor["type"] = type_name(width).into();
        self.views.try_reserve(1)?;
        self.views.push(view);
        self.accessors.try_reserve(1)?;
        self.accessors.push(accessor);
        Ok(self.accessors.len() - 1)
    }
}

/// A byte of sRGB as a linear share of 16 bits.
pub(super) fn linear(byte: u8) -> u16 {
    (65535.0 * vides_mesh::srgb::linear(byte)).round() as u16
}
