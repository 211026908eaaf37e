//! Matrices from camera to world as text: 16 or 12 numbers a line, or four lines of four numbers
//! (Replica, 7-Scenes, ScanNet), with or without the frame's number before them (KITTI-360), and as
//! NumPy's arrays. The camera has x right, y down, z forward. There are neither times nor fields of
//! view. Lines of 12 numbers alone are recognised as `kitti`.

use std::io::Write;

use glam::{DMat3, DMat4};
use vides_engine::limits::MAX_FILE_BYTES;
use vides_engine::math::camera::CameraAxes;

use super::content::{Content, DEFAULT_ZOOM, Recording};
use super::error::{Cause, Error, Place, Result, Wanted};
use super::flight::Flight;
use super::format::Format;
use super::loss::{Loss, Report};
use super::options::Options;
use super::source::Source;
use super::{convention, npy, rows};

pub(super) static MATRICES: Format = Format {
    name: "matrices",
    title: "4 × 4 matrices",
    endings: &["matrices"],
    file_names: &["traj.txt"],
    recognises,
    read: Some(read),
    own_times: true,
    reads_folder: true,
    write: Some(write),
    by_ending: &[("npy", npy::write)],
    ..Format::PLAIN
};

fn recognises(source: &Source) -> bool {
    if source.is_folder {
        let first = source.first_of(is_pose);
        return first.is_some_and(|first| is_matrices(first.beginning()));
    }
    npy::is_array(&source.bytes) || is_matrices(source.beginning())
}

/// Whether a file has this name in a folder of poses: `frame-000000.pose.txt` or `0.txt`.
fn is_pose(name: &str) -> bool {
    let stem = name.strip_suffix(".txt").unwrap_or_default();
    let is_number = !stem.is_empty() && stem.bytes().all(|byte| byte.is_ascii_digit());
    is_number || stem.ends_with(".pose")
}

/// How far the last row may be from 0 0 0 1.
const NEARLY: f64 = 1e-6;

/// Whether this begins with a matrix whose last row is 0 0 0 1, or with a frame and a matrix.
fn is_matrices(beginning: &str) -> bool {
    let whole = rows::first::<16>(beginning);
    let whole = whole.or_else(|| rows::first::<17>(beginning).map(|[_, matrix @ ..]| matrix));
    if let Some([.., a, b, c, d]) = whole {
        return is_last_row([a, b, c, d]);
    }
    if let Some([_, matrix @ ..]) = rows::first::<13>(beginning) {
        let matrix = DMat3::from_mat4(rows::matrix(matrix));
        return convention::rotation_of(matrix).is_ok();
    }
    let mut rows = rows::rows(beginning).map(|(place, row)| rows::numbers(&place, row));
    let mut next = || rows.next().and_then(Result::ok);
    matches!([next(), next(), next(), next()], [Some(_), Some(_), Some(_), Some(row)] if is_last_row(row))
}

fn is_last_row(row: [f64; 4]) -> bool {
    let wanted = [0.0, 0.0, 0.0, 1.0];
    row.iter()
        .zip(wanted)
        .all(|(found, wanted)| (found - wanted).abs() <= NEARLY)
}

/// Four rows as a matrix.
///
/// # Errors
/// [`Wanted::LastRow`].
pub(super) fn of_rows(place: &Place, numbers: [f64; 16]) -> Result<DMat4> {
    let [.., a, b, c, d] = numbers;
    if is_last_row([a, b, c, d]) {
        Ok(DMat4::from_cols_array(&numbers).transpose())
    } else {
        Err(place.clone().expected(Wanted::LastRow))
    }
}

/// The matrix of this line and the next three.
///
/// # Errors
/// Those of [`rows::numbers`] and [`of_rows`]; [`Cause::End`].
pub(super) fn of_four_lines<'a>(
    first: (Place, &'a str),
    lines: &mut impl Iterator<Item = (Place, &'a str)>,
) -> Result<DMat4> {
    let mut numbers = [0.0; 16];
    let (start, mut line) = (first.0.clone(), first);
    for at in 0..4 {
        if at > 0 {
            let before = line.0;
            line = lines.next().ok_or_else(|| before.wrong(Cause::End))?;
        }
        numbers[4 * at..][..4].copy_from_slice(&rows::numbers::<4>(&line.0, line.1)?);
    }
    of_rows(&start, numbers)
}

fn read(source: &Source, _: &Options, report: &mut Report) -> Result<Content> {
    report.add(Loss::FieldOfView);
    if npy::is_array(&source.bytes) {
        report.add(Loss::Times);
        return npy::read(&source.bytes);
    }
    let mut recording = Recording::default();
    let mut frames: Vec<f64> = Vec::new();
    if source.is_folder {
        let mut lost = 0;
        for name in source.names(is_pose)? {
            let file = Source::of_bytes(&name, source.beside(&name, MAX_FILE_BYTES)?);
            let read = read_file(&file, &mut recording, &mut Vec::new());
            match read {
                // ScanNet has no numbers where the camera was lost.
                Err(Error::Content {
                    cause: Cause::NotFinite,
                    ..
                }) => lost += 1,
                read => {
                    read.map_err(|error| error.at(&format!("{}/{name}", source.name)))?;
                    frames.try_reserve(1)?;
                    frames.extend(Source::number_of(&name));
                }
            }
        }
        report.not_taken("a pose that is not finite", lost);
    } else {
        read_file(source, &mut recording, &mut frames)?;
    }
    let each = frames.len() == recording.poses.len() && frames.is_sorted_by(|a, b| a < b);
    if each && !frames.is_empty() {
        recording.frames = Some(frames);
    } else {
        report.add(Loss::Times);
    }
    Ok(Content::Poses(recording))
}

/// Appends the poses of a file, and the numbers of their frames if it has some.
fn read_file(source: &Source, recording: &mut Recording, frames: &mut Vec<f64>) -> Result<()> {
    let mut lines = rows::rows(source.text()?);
    let width = lines.clone().next();
    let width = width.map_or(0, |(_, row)| rows::words(row).count());
    while let Some((place, row)) = lines.next() {
        let (frame, matrix) = match width {
            4 => (None, of_four_lines((place.clone(), row), &mut lines)?),
            12 => (None, rows::matrix(rows::numbers(&place, row)?)),
            13 => {
                let [frame, matrix @ ..] = rows::numbers::<13>(&place, row)?;
                (Some(frame), rows::matrix(matrix))
            }
            17 => {
                let [frame, matrix @ ..] = rows::numbers::<17>(&place, row)?;
                (Some(frame), of_rows(&place, matrix)?)
            }
            _ => (None, of_rows(&place, rows::numbers(&place, row)?)?),
        };
        if let Some(frame) = frame {
            if frames.last().is_some_and(|&before| frame <= before) {
                return Err(place.wrong(Cause::Order));
            }
            frames.try_reserve(1)?;
            frames.push(frame);
        }
        recording.push(place.matrix(matrix, CameraAxes::OpenCv, DEFAULT_ZOOM)?)?;
    }
    Ok(())
}

fn write(flight: &mut Flight<'_>, out: &mut dyn Write, report: &mut Report) -> Result<()> {
    report.add(Loss::Times);
    report.add(Loss::FieldOfView);
    flight.write_poses(Vec::new(), out, |_, text, _, pose| {
        let rows = convention::matrix(pose, CameraAxes::OpenCv).transpose();
        rows::push(text, rows.to_cols_array(), " ");
        text.push(b'\n');
    })
}
