//! The three files as `.bin`: little-endian, each with the number of its entries before them.
//! Counts are believed only as far as the bytes reach.

use glam::{DQuat, DVec3};

use super::model::{Image, KINDS, Model, unknown_kind};
use crate::error::{Cause, Place, Result};

/// What is left of a file.
struct Bytes<'a> {
    rest: &'a [u8],
    length: usize,
}

impl<'a> Bytes<'a> {
    const fn new(bytes: &'a [u8]) -> Self {
        Self {
            rest: bytes,
            length: bytes.len(),
        }
    }

    const fn place(&self) -> Place {
        Place::Byte((self.length - self.rest.len()) as u64)
    }

    fn take(&mut self, count: u64) -> Result<&'a [u8]> {
        let end = usize::try_from(count).ok();
        let split = end.and_then(|end| self.rest.split_at_checked(end));
        let (taken, rest) = split.ok_or_else(|| self.place().wrong(Cause::End))?;
        self.rest = rest;
        Ok(taken)
    }

    fn array<const N: usize>(&mut self) -> Result<[u8; N]> {
        let (taken, rest) = self
            .rest
            .split_first_chunk()
            .ok_or_else(|| self.place().wrong(Cause::End))?;
        self.rest = rest;
        Ok(*taken)
    }

    fn u32(&mut self) -> Result<u32> {
        self.array().map(u32::from_le_bytes)
    }

    fn u64(&mut self) -> Result<u64> {
        self.array().map(u64::from_le_bytes)
    }

    fn number(&mut self) -> Result<f64> {
        let place = self.place();
        let number = self.array().map(f64::from_le_bytes)?;
        if number.is_finite() {
            Ok(number)
        } else {
            Err(place.wrong(Cause::NotFinite))
        }
    }

    fn numbers<const N: usize>(&mut self) -> Result<[f64; N]> {
        let mut numbers = [0.0; N];
        for number in &mut numbers {
            *number = self.number()?;
        }
        Ok(numbers)
    }

    /// Skips a number of entries of a size.
    fn skip(&mut self, count: u64, size: u64) -> Result<()> {
        let bytes = count.checked_mul(size);
        let bytes = bytes.ok_or_else(|| self.place().wrong(Cause::TooLarge))?;
        self.take(bytes).map(|_| ())
    }

    /// A text that ends with a zero.
    fn name(&mut self) -> Result<String> {
        let end = self.rest.iter().position(|&byte| byte == 0);
        let end = end.ok_or_else(|| self.place().wrong(Cause::End))?;
        let name = String::from_utf8_lossy(self.take(end as u64)?).into_owned();
        self.take(1)?;
        Ok(name)
    }

    /// The place of each entry, as many as are said to be there.
    fn entries(&mut self, mut read: impl FnMut(&mut Self, Place) -> Result<()>) -> Result<()> {
        for _ in 0..self.u64()? {
            let place = self.place();
            read(self, place)?;
        }
        Ok(())
    }
}

/// Entries of number, kind, width, height, parameters.
pub(super) fn cameras(bytes: &[u8], model: &mut Model) -> Result<()> {
    Bytes::new(bytes).entries(|bytes, place| {
        let id = bytes.u32()?.into();
        let number = bytes.u32()?;
        let kind = usize::try_from(number).ok().and_then(|at| KINDS.get(at));
        let kind = kind.ok_or_else(|| unknown_kind(&place, &number.to_string()))?;
        let size = [bytes.u64()? as f64, bytes.u64()? as f64];
        let mut parameters = [0.0; 16];
        for parameter in &mut parameters[..kind.parameters] {
            *parameter = bytes.number()?;
        }
        model.add_camera(id, &place, kind, size, &parameters[..kind.parameters])
    })
}

/// Entries of number, rotation, translation, camera, name, points of 24 bytes.
pub(super) fn images(bytes: &[u8], model: &mut Model) -> Result<()> {
    Bytes::new(bytes).entries(|bytes, place| {
        bytes.u32()?;
        let [w, x, y, z] = bytes.numbers()?;
        let image = Image {
            rotation: DQuat::from_xyzw(x, y, z, w),
            translation: DVec3::from_array(bytes.numbers()?),
            camera: bytes.u32()?.into(),
            name: bytes.name()?,
        };
        let points = bytes.u64()?;
        bytes.skip(points, 24)?;
        model.add_image(&place, image)
    })
}

/// Entries of number, place, colour, error, track of 8 bytes each.
pub(super) fn points(bytes: &[u8], model: &mut Model) -> Result<()> {
    Bytes::new(bytes).entries(|bytes, _| {
        bytes.u64()?;
        let place = bytes.numbers()?;
        bytes.skip(3 + 8, 1)?;
        let track = bytes.u64()?;
        bytes.skip(track, 8)?;
        model.add_point(place)
    })
}
