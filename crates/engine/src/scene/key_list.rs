//! Keys on their way into a track or out of it, and how one goes from key to key.

use super::interpolation::Interpolation;
use super::time::Extrapolation;
use crate::error::{Result, vec_with_room};

/// Keys, as [`super::Track::new`] takes them.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct KeyList {
    /// Their frames, strictly increasing.
    pub frames: Vec<f64>,
    /// Their values, key by key.
    pub values: Vec<f64>,
    /// Tangents of `hermite`; tension, continuity, bias of `tcb`; else empty.
    pub shape: Vec<f64>,
}

impl KeyList {
    /// Room for `keys` keys of `width` numbers.
    pub(super) fn with_room(keys: usize, [width, shape]: [usize; 2]) -> Result<Self> {
        Ok(Self {
            frames: vec_with_room(keys)?,
            values: vec_with_room(keys * width)?,
            shape: vec_with_room(keys * shape)?,
        })
    }

    /// How many keys there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.frames.len()
    }

    /// Whether it is empty.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.frames.is_empty()
    }

    pub(super) fn push(&mut self, from: &Self, key: usize, [width, shape]: [usize; 2]) {
        self.frames.push(from.frames[key]);
        self.values.extend(&from.values[width * key..][..width]);
        self.shape.extend(&from.shape[shape * key..][..shape]);
    }
}

/// How a track goes from key to key, and beyond its ends.
#[derive(Debug, Clone, PartialEq)]
pub struct Manner {
    /// From key to key.
    pub interpolation: Interpolation,
    /// As [`KeyList::shape`], of all keys.
    pub shape: Vec<f64>,
    /// Before the first key.
    pub before: Extrapolation,
    /// After the last one.
    pub after: Extrapolation,
}
