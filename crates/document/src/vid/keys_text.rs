//! Keys alone as text, as in a scene's file: tables `[[node.track]]`, below `[[node]]` with
//! its name where they are of several nodes.

use std::fmt::{self, Write};

use super::bytes::too_large;
use super::field::{Source, fields};
use super::pieces;
use super::scene_read;
use super::scene_write;
use super::text::{Quoted, Text};
use crate::error::{EngineError, Result};
use vides_engine::limits::MAX_FILE_BYTES;
use vides_engine::scene::Track;

/// Tracks with the name of the node that they are of; one without a name is the only one.
pub(crate) type TracksOfNode = (String, Vec<Track>);

pub(crate) fn keys_to_toml(nodes: &[TracksOfNode]) -> Result<String> {
    let mut out = Text(String::new());
    let written = write(&mut out, nodes);
    written.map_err(|_| EngineError::Memory)?;
    Ok(out.0.trim_start().to_owned())
}

fn write(out: &mut Text, nodes: &[TracksOfNode]) -> fmt::Result {
    for (name, tracks) in nodes {
        if nodes.len() > 1 {
            writeln!(out, "\n[[node]]\nname = {}", Quoted(name))?;
        }
        let mut tracks = tracks.iter();
        tracks.try_for_each(|track| scene_write::track(out, track))?;
    }
    Ok(())
}

/// The tracks of a text, node by node; what else its nodes have is passed over.
pub(crate) fn keys_from_toml(text: &str) -> Result<Vec<TracksOfNode>> {
    if text.len() as u64 > MAX_FILE_BYTES {
        return Err(too_large(MAX_FILE_BYTES));
    }
    let mut source = Source { text, start: 0 };
    let mut all = Vec::new();
    loop {
        let (root, end) = pieces::parse(source)?;
        for field in fields(source, &root) {
            if field.key != "node" {
                continue;
            }
            if !field.is_array() {
                all.try_reserve(1)?;
                all.push(of_node(field)?);
                continue;
            }
            for node in field.elements()? {
                all.try_reserve(1)?;
                all.push(of_node(node)?);
            }
        }
        if end == text.len() {
            all.retain(|(_, tracks)| !tracks.is_empty());
            return Ok(all);
        }
        source.start = end;
    }
}

fn of_node(node: super::field::Field<'_>) -> Result<TracksOfNode> {
    let (mut name, mut tracks) = (String::new(), Vec::new());
    for field in node.fields()? {
        match field.key {
            "name" => field.text()?.clone_into(&mut name),
            "track" => {
                for element in field.elements()? {
                    tracks.try_reserve(1)?;
                    tracks.push(scene_read::track(element, &name)?);
                }
            }
            _ => {}
        }
    }
    Ok((name, tracks))
}
