//! A node of a scene, frame by frame, in the formats of the command `vides sample`: cameras and
//! lights as poses, others as matrices to world coordinates, column by column as in OpenGL.

use std::io::Write;

use vides_engine::scene::{NodeState, Warnings};

use super::blocks::{Progress, failed};
use super::export::{Format, HEADER, push_json_pose, push_json_text};
use super::{SceneDocument, ascii};
use crate::error::{Place, Result, TooMany, vec_with_room};
use crate::limits::MAX_FRAMES;

const BLOCK: usize = 512;

/// Expected bytes per state; more only costs a reallocation.
const BYTES: usize = 512;

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
    let mut states = vec_with_room(BLOCK)?;
    states.resize(BLOCK.min(all), NodeState::default());
    let mut text: Vec<u8> = vec_with_room(BLOCK * BYTES)?;
    head(document, node, all, format, &mut text);
    let mut done = 0;
    while done < all {
        let block = states.len().min(all - done);
        let states = &mut states[..block];
        let mut warnings = Warnings::default();
        scene.sample(node, first + done as f64, 1.0, states, &mut warnings)?;
        if let Some(error) = warnings.into_error() {
            let name = scene.node(node)?.name.as_str();
            return Err(error.at(Place::Node(name.into())).into());
        }
        for (at, state) in states.iter().enumerate() {
            let frame = first + (done + at) as f64;
            push(&mut text, format, looks, done + at, frame, state);
        }
        out.write_all(&text).map_err(failed)?;
        text.clear();
        done += block;
        progress(done, all);
    }
    if format == Format::Json {
        out.write_all(b"\n  ]\n}\n").map_err(failed)?;
    }
    Ok(())
}

fn head(document: &SceneDocument, node: usize, all: usize, format: Format, text: &mut Vec<u8>) {
    let node = &document.scene.nodes()[node];
    let looks = node.kind.looks();
    // Writing into a vector cannot fail.
    match format {
        Format::Ascii => {}
        Format::Csv if looks => text.extend_from_slice(HEADER.as_bytes()),
        Format::Csv => {
            text.extend_from_slice(b"frame");
            for column in 0..4 {
                for row in 0..4 {
                    let _ = write!(text, ",m{row}{column}");
                }
            }
            text.extend_from_slice(b",visible\n");
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

fn push(
    text: &mut Vec<u8>,
    format: Format,
    looks: bool,
    index: usize,
    frame: f64,
    state: &NodeState,
) {
    let [vrp, vpn, vup] = [state.pose.vrp, state.pose.vpn, state.pose.vup];
    match format {
        Format::Ascii if looks => ascii::push_line(text, &state.pose),
        Format::Ascii => {
            for (at, number) in state.matrix.iter().enumerate() {
                text.extend_from_slice(if at == 0 { b"" } else { b" " });
                ascii::push_number(text, *number);
            }
            text.push(b'\n');
        }
        Format::Csv => {
            let _ = write!(text, "{frame}");
            if looks {
                let numbers = [vrp, vpn, vup];
                for number in numbers.as_flattened().iter().chain([&state.pose.zoom]) {
                    let _ = write!(text, ",{number:?}");
                }
            } else {
                for number in state.matrix {
                    let _ = write!(text, ",{number:?}");
                }
                let _ = write!(text, ",{}", state.visible);
            }
            text.push(b'\n');
        }
        Format::Json => {
            text.extend_from_slice(if index == 0 { b"\n    " } else { b",\n    " });
            if looks {
                push_json_pose(text, &state.pose);
            } else {
                let visible = state.visible != 0;
                let _ = write!(
                    text,
                    "{{\"matrix\": {:?}, \"visible\": {visible}}}",
                    state.matrix
                );
            }
        }
    }
}
