//! The data of a script: written between two lines, and found there again.

use std::io::Write;

use glam::DVec3;
use vides_engine::scene::{Camera, Kind};

use crate::blocks;
use crate::error::{Cause, Error, Place, Result};
use crate::flight::Flight;
use crate::loss::{Loss, Report};

/// The line before the data.
const BEGIN: &str = "# ---- data, JSON: nothing of it is run ----";
/// What begins and ends the string.
const OPEN: &str = "DATA = r'''";
const CLOSE: &str = "'''";

/// Points, lines and triangles beyond which an object is left out: text is no place for them.
pub(super) const MOST_PIECES: usize = 100_000;

/// The text of a script before and behind its data.
fn around(script: &'static str) -> [&'static str; 2] {
    let at = script
        .find("\n{}\n")
        .expect("scripts have a place for data");
    [&script[..at + 1], &script[at + 3..]]
}

/// Appends a text in quotes: letters, digits and harmless signs of ASCII, all else by number.
pub(super) fn push_text(out: &mut Vec<u8>, text: &str) {
    out.push(b'"');
    for unit in text.encode_utf16() {
        match u8::try_from(unit) {
            Ok(byte) if byte.is_ascii_alphanumeric() || b" !()*+,-./:;=?_".contains(&byte) => {
                out.push(byte);
            }
            // Writing into a vector cannot fail.
            _ => drop(write!(out, "\\u{unit:04x}")),
        }
    }
    out.push(b'"');
}

/// The script up to what is appended before its frames, by [`begin_frames`]: what belongs to the
/// flight, and the object if it is taken.
pub(super) fn head(
    flight: &Flight<'_>,
    script: &'static str,
    first: i64,
    report: &mut Report,
) -> Result<Vec<u8>> {
    let mut text = around(script)[0].as_bytes().to_vec();
    let info = flight.info();
    let node = &flight.scene().nodes()[flight.node()];
    for (open, value) in [
        ("{\n\"title\": ", &info.title),
        (",\n\"camera\": ", &node.name),
        (",\n\"unit\": ", &info.unit),
    ] {
        text.extend_from_slice(open.as_bytes());
        push_text(&mut text, value);
    }
    let half_size = flight.scene().space().half_size * flight.options().scale;
    let planes = match node.kind {
        Kind::Camera(camera) => camera,
        _ => Camera::default(),
    };
    let [near, far] = flight.planes(planes)?;
    let [width, height] = flight.pixels();
    let (fps, up) = (flight.fps(), flight.up().name());
    let _ = write!(
        text,
        ",\n\"up\": \"{up}\",\n\"half_size\": {half_size:?},\n\"clip\": [{near:?}, {far:?}],\n\"fps\": {fps:?},\n\
         \"first_frame\": {first},\n\"size\": [{width}, {height}],\n"
    );
    push_object(&mut text, flight, report);
    Ok(text)
}

/// Appends what comes before the frames.
pub(super) fn begin_frames(text: &mut Vec<u8>) {
    text.extend_from_slice(b"\"frames\": [");
}

/// Appends the object's points, lines and triangles, in the file's coordinates.
fn push_object(text: &mut Vec<u8>, flight: &Flight<'_>, report: &mut Report) {
    let object = &flight.info().object;
    if object.is_empty() {
        return;
    }
    if object.pieces() > MOST_PIECES {
        report.add(Loss::Object);
        return;
    }
    text.extend_from_slice(b"\"object\": {\n\"points\": [");
    let place = |position: DVec3| flight.place(position).to_array();
    if let Some(mesh) = object.mesh() {
        push_rows(text, mesh.points.iter().map(|&point| place(point)));
        text.extend_from_slice(b"],\n\"lines\": [");
        push_rows(text, &mesh.lines);
        text.extend_from_slice(b"],\n\"triangles\": [");
        push_rows(text, &mesh.triangles);
    } else {
        push_rows(text, object.iter().map(|point| place(point.position)));
        text.extend_from_slice(b"],\n\"lines\": [");
        let drawn = object.iter().enumerate().filter(|(_, point)| point.draw);
        push_rows(
            text,
            drawn.filter_map(|(at, _)| Some([at.checked_sub(1)?, at])),
        );
        text.extend_from_slice(b"],\n\"triangles\": [");
    }
    text.extend_from_slice(b"]\n},\n");
    let coloured = match object.mesh() {
        Some(mesh) => !mesh.colours.is_empty(),
        None => object.lines().any(|(_, colour)| colour.is_some()),
    };
    if coloured {
        report.add(Loss::PointColours);
    }
}

pub(super) fn push_rows<T: std::fmt::Debug>(text: &mut Vec<u8>, rows: impl IntoIterator<Item = T>) {
    for (at, row) in rows.into_iter().enumerate() {
        let comma = if at == 0 { "" } else { "," };
        let _ = write!(text, "{comma}\n{row:?}");
    }
}

/// Appends one frame.
pub(super) fn push_frame(text: &mut Vec<u8>, index: usize, numbers: &[f64]) {
    let comma = if index == 0 { "" } else { "," };
    let _ = write!(text, "{comma}\n{numbers:?}");
}

/// What follows the frames.
pub(super) fn finish(script: &'static str, out: &mut dyn Write) -> Result<()> {
    let end = ["\n]\n}", around(script)[1]].concat();
    out.write_all(end.as_bytes()).map_err(blocks::failed)
}

/// The data of a script, and how many lines come before them.
///
/// # Errors
/// [`Cause::Missing`].
pub(super) fn data(text: &str) -> Result<(&str, usize)> {
    let missing = |what: &str| Place::Whole.wrong(Cause::Missing(what.into()));
    let begin = text.find(BEGIN).ok_or_else(|| missing(BEGIN))?;
    let behind = &text[begin..];
    let open = behind.find(OPEN).ok_or_else(|| missing(OPEN))?;
    let start = begin + open + OPEN.len();
    let (json, _) = text[start..]
        .split_once(CLOSE)
        .ok_or_else(|| Place::Whole.wrong(Cause::End))?;
    Ok((json, text[..start].matches('\n').count()))
}

/// An error in the data, its line counted in the whole file.
pub(super) fn in_file(error: Error, lines: usize) -> Error {
    match error {
        Error::Content {
            place: Place::Line(line),
            cause,
        } => Place::Line(line + lines).wrong(cause),
        other => other,
    }
}

#[cfg(test)]
#[path = "script_tests.rs"]
mod tests;
