//! The JSON of `vides sample`: one object with what belongs to the document, then an array of
//! poses, or of matrices for nodes that have none.

use std::io::Write;

use glam::{DMat4, DVec4};
use vides_engine::math::camera::CameraAxes;
use vides_engine::path::{Pose, Space};

use super::blocks;
use super::content::{Content, DEFAULT_ZOOM, Recording};
use super::error::Result;
use super::flight::Flight;
use super::format::{Format, Holds};
use super::loss::{Loss, Report};
use super::options::Options;
use super::source::Source;
use super::tree::{self, At};

pub(super) static JSON: Format = Format {
    name: "json",
    title: "JSON",
    endings: &["json"],
    holds: Holds::Frames,
    recognises,
    read: Some(read),
    write: Some(write),
    ..Format::PLAIN
};

fn recognises(source: &Source) -> bool {
    let text = source.beginning();
    text.trim_start().starts_with('{')
        && text.contains("\"title\":")
        && text.contains("\"frame_count\":")
}

fn read(source: &Source, _: &Options, report: &mut Report) -> Result<Content> {
    let document = tree::parse(&source.bytes)?;
    let root = At::root(&document);
    let space = root.get("space");
    let in_space = |key| space.and_then(|space| space.get(key));
    let mut recording = Recording {
        title: text(root.get("title"))?,
        comment: text(root.get("comment"))?,
        unit: text(in_space("unit"))?,
        fps: root.get("fps").map(At::positive).transpose()?,
        first_frame: root.get("first_frame").map(At::number).transpose()?,
        up: in_space("up").map(At::up).transpose()?,
        ..Recording::default()
    };
    if let Some(states) = root.get("states") {
        report.add(Loss::FieldOfView);
        let (mut hidden, mut sized) = (0, 0);
        for state in states.list()? {
            let visible = state.get("visible").and_then(|at| at.value.as_bool());
            hidden += usize::from(visible == Some(false));
            let at = state.need("matrix")?;
            let matrix = DMat4::from_cols_array(&at.numbers()?);
            let unit = |column: DVec4| (column.length() - 1.0).abs() <= 1e-9;
            let axes = [matrix.x_axis, matrix.y_axis, matrix.z_axis];
            sized += usize::from(!axes.into_iter().all(unit));
            recording.push(at.pose(matrix, CameraAxes::Vides, DEFAULT_ZOOM)?)?;
        }
        report.not_taken("visible", hidden);
        report.count(sized, Loss::Sizes);
        return Ok(Content::Poses(recording));
    }
    for pose in root.need("poses")?.list()? {
        let vector = |name| pose.need(name)?.numbers::<3>();
        recording.push(Pose {
            vrp: vector("vrp")?,
            vpn: vector("vpn")?,
            vup: vector("vup")?,
            zoom: pose.need("zoom")?.number()?,
        })?;
    }
    Ok(Content::Poses(recording))
}

fn write(flight: &mut Flight<'_>, out: &mut dyn Write, _: &mut Report) -> Result<()> {
    let head = match flight.path_alone() {
        Some(_) => head(flight),
        None => node_head(flight),
    };
    // Writing into a vector cannot fail.
    if flight.looks() {
        flight.write_poses(head, out, |_, text, index, pose| {
            push_begin(text, index);
            for (name, vector) in [("vrp", pose.vrp), ("vpn", pose.vpn), ("vup", pose.vup)] {
                let _ = write!(text, "\"{name}\": {vector:?}, ");
            }
            let _ = write!(text, "\"zoom\": {:?}}}", pose.zoom);
        })?;
    } else {
        flight.write_states(head, out, |flight, text, index, state| {
            push_begin(text, index);
            let (matrix, visible) = (flight.matrix(state), state.visible != 0);
            let _ = write!(text, "\"matrix\": {matrix:?}, \"visible\": {visible}}}");
        })?;
    }
    out.write_all(b"\n  ]\n}\n").map_err(blocks::failed)
}

/// A text of the file, empty if missing.
pub(super) fn text(at: Option<At<'_>>) -> Result<String> {
    Ok(at.map_or(Ok(""), At::text)?.to_owned())
}

fn head(flight: &Flight<'_>) -> Vec<u8> {
    let info = flight.info();
    let mut head = Vec::new();
    head.extend_from_slice(b"{\n  \"title\": ");
    push_text(&mut head, &info.title);
    head.extend_from_slice(b",\n  \"comment\": ");
    push_text(&mut head, &info.comment);
    let _ = write!(
        head,
        ",\n  \"fps\": {:?},\n  \"first_frame\": {},\n  \"frame_count\": {},\n  \"space\": ",
        flight.fps(),
        flight.number(0),
        flight.count(),
    );
    let Space {
        centre, half_size, ..
    } = flight.scene().space();
    let centre = flight.place(centre);
    let half_size = half_size * flight.options().scale;
    let _ = write!(
        head,
        "{{\"centre\": {:?}, \"half_size\": {half_size:?}, \"unit\": ",
        centre.to_array()
    );
    push_text(&mut head, &info.unit);
    let up = flight.up().name();
    let _ = write!(head, ", \"up\": \"{up}\"}},\n  \"poses\": [");
    head
}

fn node_head(flight: &Flight<'_>) -> Vec<u8> {
    let node = &flight.scene().nodes()[flight.node()];
    let mut head = Vec::new();
    head.extend_from_slice(b"{\n  \"title\": ");
    push_text(&mut head, &flight.info().title);
    head.extend_from_slice(b",\n  \"node\": ");
    push_text(&mut head, &node.name);
    let _ = write!(
        head,
        ",\n  \"kind\": \"{}\",\n  \"fps\": {:?},\n  \"first_frame\": {:?},\n  \"frame_count\": {},\n  \"{}\": [",
        node.kind.name(),
        flight.fps(),
        flight.number(0),
        flight.count(),
        if flight.looks() { "poses" } else { "states" },
    );
    head
}

/// Begins the `index`-th object from 0 of an array.
fn push_begin(text: &mut Vec<u8>, index: usize) {
    text.extend_from_slice(if index == 0 { b"\n    {" } else { b",\n    {" });
}

/// Appends a text in quotes, in one line.
pub(super) fn push_text(out: &mut Vec<u8>, text: &str) {
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
