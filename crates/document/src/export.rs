//! Poses in the formats of the command `vides sample`.

use std::fmt::Display;
use std::io::Write;
use std::path::Path;

use super::ascii;
use super::blocks;
pub use super::blocks::Progress;
use super::editing::Document;
use super::export_node::write_node;
use super::save;
use crate::error::{Refused, Result};
use crate::path::{Pose, Space};

/// A format of poses. All but ASCII write as many digits as give the same bits back.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Format {
    /// Ten numbers a line, four decimals ([`super::ascii`]).
    #[default]
    Ascii,
    /// The same with another number of decimals, at most [`MAX_DECIMALS`].
    Decimals(usize),
    /// Comma-separated values: a header row, then frame number, ten numbers, and the seconds since
    /// the first row.
    Csv,
    /// One object: the document's info, then an array of poses.
    Json,
}

/// The most decimals of a line: what is worth writing in the smallest spaces that are used.
pub const MAX_DECIMALS: usize = 30;

impl Format {
    /// All formats, in the order they are offered.
    pub const ALL: [Self; 3] = [Self::Ascii, Self::Csv, Self::Json];

    /// The file name extension, without the dot.
    #[must_use]
    pub const fn ending(self) -> &'static str {
        match self {
            Self::Ascii | Self::Decimals(_) => "txt",
            Self::Csv => "csv",
            Self::Json => "json",
        }
    }

    /// The format by a file's extension, in either case; ASCII for any other.
    #[must_use]
    pub fn of_file(file: &Path) -> Self {
        let ending = file.extension().unwrap_or_default();
        let says = |format: &Self| ending.eq_ignore_ascii_case(format.ending());
        Self::ALL.into_iter().find(says).unwrap_or_default()
    }
}

/// Writes all poses of a document; of a scene those of the shown camera over the scene's frames.
///
/// # Errors
/// `ErrorKind::Io` if `out` fails, `ErrorKind::Limit` for too many frames, `ErrorKind::Memory`.
pub fn write(
    document: &Document,
    format: Format,
    out: &mut dyn Write,
    progress: Progress<'_>,
) -> Result<()> {
    if document.edited_scene().is_some() {
        let scene = document.scene_document()?;
        let shown = scene.scene.shown_camera().ok_or(Refused::NoCamera)?;
        return write_node(&scene, shown, format, out, progress);
    }
    let sampler = document.sampler()?;
    let (count, first) = (sampler.frame_count(), document.info().first_frame);
    let fps = document.info().fps;
    let text = match format {
        Format::Ascii | Format::Decimals(_) => Vec::new(),
        Format::Csv => HEADER.into(),
        Format::Json => json_head(document, count),
    };
    blocks::write(
        text,
        count,
        out,
        progress,
        |done, poses| Ok(sampler.sample(done + 1, poses)?),
        |text, index, pose| {
            let frame = i64::from(first) + index as i64;
            push_pose(text, format, index, &frame, pose, fps);
        },
    )?;
    end(format, out)
}

/// As [`write()`], into a file that is replaced only when all is written ([`save::save_with`]).
///
/// # Errors
/// As [`write()`], naming the file.
pub fn write_file(
    document: &Document,
    format: Format,
    file: &Path,
    progress: Progress<'_>,
) -> Result<()> {
    save::save_with(file, &mut |out| write(document, format, out, progress))
}

pub(super) const HEADER: &str =
    "frame,vrp_x,vrp_y,vrp_z,vpn_x,vpn_y,vpn_z,vup_x,vup_y,vup_z,zoom,seconds\n";

fn json_head(document: &Document, count: usize) -> Vec<u8> {
    let info = document.info();
    let mut head = Vec::new();
    head.extend_from_slice(b"{\n  \"title\": ");
    push_json_text(&mut head, &info.title);
    head.extend_from_slice(b",\n  \"comment\": ");
    push_json_text(&mut head, &info.comment);
    // Writing into a vector cannot fail.
    let _ = write!(
        head,
        ",\n  \"fps\": {:?},\n  \"first_frame\": {},\n  \"frame_count\": {count},\n  \"space\": ",
        info.fps, info.first_frame,
    );
    let Space {
        centre,
        half_size,
        up,
    } = document.path().space;
    let _ = write!(
        head,
        "{{\"centre\": {:?}, \"half_size\": {half_size:?}, \"unit\": ",
        centre.to_array()
    );
    push_json_text(&mut head, &info.unit);
    let _ = write!(head, ", \"up\": \"{}\"}},\n  \"poses\": [", up.name());
    head
}

/// Appends a pose, the `index`-th from 0.
pub(super) fn push_pose(
    text: &mut Vec<u8>,
    format: Format,
    index: usize,
    frame: &dyn Display,
    pose: &Pose,
    fps: f64,
) {
    let vectors = [("vrp", pose.vrp), ("vpn", pose.vpn), ("vup", pose.vup)];
    match format {
        Format::Ascii => ascii::push_line(text, pose, ascii::DECIMALS),
        Format::Decimals(decimals) => ascii::push_line(text, pose, decimals),
        Format::Csv => {
            push_row(
                text,
                frame,
                vectors.map(|(_, vector)| vector).as_flattened(),
            );
            let _ = writeln!(text, ",{:?},{:?}", pose.zoom, index as f64 / fps);
        }
        Format::Json => {
            push_json_begin(text, index);
            for (name, vector) in vectors {
                let _ = write!(text, "\"{name}\": {vector:?}, ");
            }
            let _ = write!(text, "\"zoom\": {:?}}}", pose.zoom);
        }
    }
}

/// Appends the begin of a row of comma-separated values.
pub(super) fn push_row(text: &mut Vec<u8>, frame: &dyn Display, numbers: &[f64]) {
    let _ = write!(text, "{frame}");
    for number in numbers {
        let _ = write!(text, ",{number:?}");
    }
}

/// Begins the `index`-th object from 0 of an array.
pub(super) fn push_json_begin(text: &mut Vec<u8>, index: usize) {
    text.extend_from_slice(if index == 0 { b"\n    {" } else { b",\n    {" });
}

/// What comes behind the last pose.
pub(super) fn end(format: Format, out: &mut dyn Write) -> Result<()> {
    match format {
        Format::Json => out.write_all(b"\n  ]\n}\n").map_err(blocks::failed),
        _ => Ok(()),
    }
}

pub(super) fn push_json_text(out: &mut Vec<u8>, text: &str) {
    out.push(b'"');
    for character in text.chars() {
        let _ = match character {
            '"' => write!(out, "\\\""),
            '\\' => write!(out, "\\\\"),
            '\n' => write!(out, "\\n"),
            '\r' => write!(out, "\\r"),
            '\t' => write!(out, "\\t"),
            control if control.is_control() => write!(out, "\\u{:04x}", u32::from(control)),
            other => write!(out, "{other}"),
        };
    }
    out.push(b'"');
}
