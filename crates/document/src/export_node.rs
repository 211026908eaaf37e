//! A node of a scene, frame by frame, in the formats of the command `vides sample`: cameras and
//! lights as poses, others as matrices to world coordinates, column by column as in OpenGL.

use std::fmt::Display;
use std::io::Write;

use vides_engine::scene::{NodeState, Warnings};

use super::blocks::{self, Progress};
use super::export::{Format, HEADER, end, push_json_begin, push_json_text, push_pose, push_row};
use super::{SceneDocument, ascii};
use crate::error::{Place, Result, TooMany};
use crate::limits::MAX_FRAMES;

/// Writes the states of a node at every whole step from the scene's first frame to its last. A host
/// interpolation that is missing or fails is an error, since nobody would notice it in a file.
///
/// # Errors
/// `ErrorKind::Range` if there is no such node; `ErrorKind::Limit` for more frames than a path may
/// have; `ErrorKind::Io` if `out` fails; as [`vides_engine::scene::Scene::sample`].
pub fn write_node(
    document: &SceneDocument,
    node: usize,
    format: Format,
    out: &mut dyn Write,
    progress: Progress<'_>,
) -> Result<()> {
    let scene = &document.scene;
    let looks = scene.node(node)?.kind.looks();
    let (first, last) = scene.frame_range();
    let all = (last - first).floor() as usize + 1;
    if all > MAX_FRAMES {
        return Err(TooMany::SceneFrames.into());
    }
    let fps = document.info.fps;
    let mut text = Vec::new();
    head(document, node, all, format, &mut text);
    let frame = |index: usize| first + index as f64;
    blocks::write(
        text,
        all,
        out,
        progress,
        |done, states: &mut [NodeState]| {
            let mut warnings = Warnings::default();
            scene.sample(node, frame(done), 1.0, states, &mut warnings)?;
            let name = || Place::Node(scene.nodes()[node].name.as_str().into());
            match warnings.into_error() {
                Some(error) => Err(error.at(name()).into()),
                None => Ok(()),
            }
        },
        |text, index, state| match looks {
            true => push_pose(text, format, index, &frame(index), &state.pose, fps),
            false => push_matrix(text, format, index, &frame(index), state, fps),
        },
    )?;
    end(format, out)
}

fn head(document: &SceneDocument, node: usize, all: usize, format: Format, text: &mut Vec<u8>) {
    let node = &document.scene.nodes()[node];
    let looks = node.kind.looks();
    // Writing into a vector cannot fail.
    match format {
        Format::Ascii | Format::Decimals(_) => {}
        Format::Csv if looks => text.extend_from_slice(HEADER.as_bytes()),
        Format::Csv => {
            text.extend_from_slice(b"frame");
            for column in 0..4 {
                for row in 0..4 {
                    let _ = write!(text, ",m{row}{column}");
                }
            }
            text.extend_from_slice(b",visible,seconds\n");
        }
        Format::Json => {
            text.extend_from_slice(b"{\n  \"title\": ");
            push_json_text(text, &document.info.title);
            text.extend_from_slice(b",\n  \"node\": ");
            push_json_text(text, &node.name);
            let _ = write!(
                text,
                ",\n  \"kind\": \"{}\",\n  \"fps\": {:?},\n  \"first_frame\": {:?},\n  \"frame_count\": {all},\n  \"{}\": [",
                node.kind.name(),
                document.info.fps,
                document.scene.frame_range().0,
                if looks { "poses" } else { "states" },
            );
        }
    }
}

fn push_matrix(
    text: &mut Vec<u8>,
    format: Format,
    index: usize,
    frame: &dyn Display,
    state: &NodeState,
    fps: f64,
) {
    let decimals = match format {
        Format::Decimals(decimals) => decimals,
        _ => ascii::DECIMALS,
    };
    match format {
        Format::Ascii | Format::Decimals(_) => {
            for (at, number) in state.matrix.iter().enumerate() {
                text.extend_from_slice(if at == 0 { b"" } else { b" " });
                ascii::push_number(text, *number, decimals);
            }
            text.push(b'\n');
        }
        Format::Csv => {
            push_row(text, frame, &state.matrix);
            let _ = writeln!(text, ",{},{:?}", state.visible, index as f64 / fps);
        }
        Format::Json => {
            push_json_begin(text, index);
            let visible = state.visible != 0;
            let _ = write!(
                text,
                "\"matrix\": {:?}, \"visible\": {visible}}}",
                state.matrix
            );
        }
    }
}
