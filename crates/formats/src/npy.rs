//! Matrices as an array of NumPy's `.npy` (NEP 1), N × 4 × 4 or N × 3 × 4, row by row: numbers of 32
//! or 64 bits, little-endian. Those that are written have 64 bits.

use std::io::Write;

use vides_engine::math::camera::CameraAxes;

use super::content::{Content, DEFAULT_ZOOM, Recording};
use super::error::{Cause, Place, Result, Wanted};
use super::flight::Flight;
use super::loss::{Loss, Report};
use super::{convention, matrices, rows};

const MAGIC: &[u8] = b"\x93NUMPY";

pub(super) fn is_array(bytes: &[u8]) -> bool {
    bytes.starts_with(MAGIC)
}

/// The poses of an array of matrices.
///
/// # Errors
/// [`Wanted::Matrices`], [`Cause::Unsupported`], [`Cause::End`], those of matrices, with the byte.
pub(super) fn read(bytes: &[u8]) -> Result<Content> {
    let end = || Place::Byte(bytes.len() as u64).wrong(Cause::End);
    let byte = |at: usize| bytes.get(at).map(|&byte| usize::from(byte)).ok_or_else(end);
    let (start, length) = match byte(6)? {
        1 => (10, byte(8)? | byte(9)? << 8),
        _ => (
            12,
            byte(8)? | byte(9)? << 8 | byte(10)? << 16 | byte(11)? << 24,
        ),
    };
    let header = bytes.get(start..).ok_or_else(end)?;
    let (header, data) = header.split_at_checked(length).ok_or_else(end)?;
    let header = String::from_utf8_lossy(header);
    let place = Place::Byte(start as u64);
    let value = |key: &'static str| {
        let found = header.split_once(key).map(|(_, rest)| rest);
        let found = found.and_then(|rest| rest.split_once(':'));
        found
            .map(|(_, rest)| rest.trim_start())
            .ok_or_else(|| place.clone().expected(Wanted::Literal(key)))
    };
    let unsupported = |name: &str| {
        let plain = name.chars().filter(|c| !c.is_control());
        let name = plain.take(64).collect::<String>().as_str().into();
        place.clone().wrong(Cause::Unsupported { name, help: "" })
    };
    let kind = value("descr")?.split(',').next().unwrap_or_default();
    let size = match kind.trim_matches(['\'', '"', ' ']) {
        "<f4" => 4,
        "<f8" => 8,
        _ => return Err(unsupported(&format!("descr {kind}"))),
    };
    if !value("fortran_order")?.starts_with("False") {
        return Err(unsupported("fortran_order True"));
    }
    let (count, rows) = shape(value("shape")?).ok_or_else(|| place.expected(Wanted::Matrices))?;
    let width = 4 * rows * size;
    let needed = count.checked_mul(width);
    let data = needed
        .and_then(|needed| data.get(..needed))
        .ok_or_else(end)?;
    let mut recording = Recording::default();
    for (index, matrix) in data.chunks_exact(width).enumerate() {
        let place = Place::Byte((start + length + index * width) as u64);
        let mut numbers = [0.0; 16];
        numbers[15] = 1.0;
        for (number, bytes) in numbers.iter_mut().zip(matrix.chunks_exact(size)) {
            *number = match *bytes {
                [a, b, c, d] => f32::from_le_bytes([a, b, c, d]).into(),
                [a, b, c, d, e, f, g, h] => f64::from_le_bytes([a, b, c, d, e, f, g, h]),
                _ => f64::NAN,
            };
        }
        if !numbers.iter().all(|number| number.is_finite()) {
            return Err(place.wrong(Cause::NotFinite));
        }
        let matrix = matrices::of_rows(&place, numbers)?;
        recording.push(place.matrix(matrix, CameraAxes::OpenCv, DEFAULT_ZOOM)?)?;
    }
    Ok(Content::Poses(recording))
}

/// The number of matrices and of rows in each; one matrix may stand alone.
fn shape(text: &str) -> Option<(usize, usize)> {
    let inner = text.strip_prefix('(')?.split_once(')')?.0;
    let sides = rows::words(inner).map(|side| side.parse().ok());
    let sides: Vec<Option<usize>> = sides.take(4).collect();
    match *sides {
        [Some(count), Some(rows @ 3..=4), Some(4)] => Some((count, rows)),
        [Some(rows @ 3..=4), Some(4)] => Some((1, rows)),
        _ => None,
    }
}

pub(super) fn write(
    flight: &mut Flight<'_>,
    out: &mut dyn Write,
    report: &mut Report,
) -> Result<()> {
    report.add(Loss::Times);
    report.add(Loss::FieldOfView);
    let count = flight.count();
    let header = format!("{{'descr': '<f8', 'fortran_order': False, 'shape': ({count}, 4, 4), }}");
    // The data begin at a multiple of 64 bytes.
    let mut head = [MAGIC, b"\x01\x00\x76\x00"].concat();
    let _ = writeln!(head, "{header:<117}");
    flight.write_poses(head, out, |_, bytes, _, pose| {
        let rows = convention::matrix(pose, CameraAxes::OpenCv).transpose();
        let numbers = rows.to_cols_array();
        bytes.extend(numbers.iter().flat_map(|number| number.to_le_bytes()));
    })
}
