//! glTF 2.0 (Khronos 2021), text and GLB: nodes, cameras, lights, meshes and one animation, out
//! and in.
//!
//! Times are seconds of 32 bits, y is up, cameras and lights look along −z. What is ours
//! and has no place in the format stands in `extras.vides`.

mod became;
mod binary;
mod channels;
mod clips;
mod compact;
mod extensions;
mod extras;
mod key_rate;
mod keys;
mod lights;
mod looks;
mod meshes;
mod motion;
mod of_node;
mod place;
mod read;
#[cfg(test)]
mod tests;
#[cfg(test)]
mod tests_far;
#[cfg(test)]
mod tests_marks;
#[cfg(test)]
mod tests_read;
mod write;
mod wrong;

use std::io::{self, Write};

use vides_engine::path::Up;

use super::base64;
use super::blocks::failed;
use super::content::Content;
use super::error::{Cause, Place, Result};
use super::flight::Flight;
use super::format::{Format, Holds};
use super::loss::Report;
use super::options::Options;
use super::source::Source;

/// The text form.
pub(super) static GLTF: Format = Format {
    name: "gltf",
    title: "glTF, text",
    endings: &["gltf"],
    up: Some(Up::Y),
    holds: Holds::Scene,
    recognises: |source| read::is_text(&source.bytes),
    read: Some(read),
    write: Some(write_text),
    ..Format::PLAIN
};

/// The binary form.
pub(super) static GLB: Format = Format {
    name: "glb",
    title: "glTF",
    endings: &["glb"],
    recognises: |source| source.bytes.starts_with(b"glTF"),
    write: Some(write_binary),
    ..GLTF
};

fn read(source: &Source, options: &Options, report: &mut Report) -> Result<Content> {
    let scene = read::read(source, options, report)?;
    Ok(Content::Scene(Box::new(scene)))
}

fn write_text(flight: &mut Flight<'_>, out: &mut dyn Write, report: &mut Report) -> Result<()> {
    let (json, bytes) = written(flight, report)?;
    let json = serde_json::to_vec(&json).map_err(|error| failed(error.into()))?;
    // Into the object behind its last value: no copy of the whole buffer as text.
    let mut text = || -> io::Result<()> {
        out.write_all(&json[..json.len() - 1])?;
        if !bytes.is_empty() {
            let length = bytes.len();
            write!(
                out,
                ",\"buffers\":[{{\"byteLength\":{length},\
                 \"uri\":\"data:application/octet-stream;base64,"
            )?;
            base64::write(&bytes, out)?;
            out.write_all(b"\"}]")?;
        }
        out.write_all(b"}\n")
    };
    text().map_err(failed)
}

fn write_binary(flight: &mut Flight<'_>, out: &mut dyn Write, report: &mut Report) -> Result<()> {
    let (mut json, bytes) = written(flight, report)?;
    if !bytes.is_empty() {
        let buffer = serde_json::json!([{"byteLength": bytes.len()}]);
        json.insert("buffers".into(), buffer);
    }
    let mut json = serde_json::to_vec(&json).map_err(|error| failed(error.into()))?;
    json.resize(json.len().next_multiple_of(4), b' ');
    // The bytes of each accessor are whole words.
    let chunk = if bytes.is_empty() { 0 } else { 8 + bytes.len() };
    let all = u32::try_from(12 + 8 + json.len() + chunk);
    let all = all.map_err(|_| Place::Whole.wrong(Cause::Long))?;
    let mut head = b"glTF\x02\0\0\0".to_vec();
    head.extend(all.to_le_bytes());
    // Shorter than all.
    head.extend((json.len() as u32).to_le_bytes());
    head.extend(b"JSON");
    let mut whole = || -> io::Result<()> {
        out.write_all(&head)?;
        out.write_all(&json)?;
        if !bytes.is_empty() {
            out.write_all(&(bytes.len() as u32).to_le_bytes())?;
            out.write_all(b"BIN\0")?;
            out.write_all(&bytes)?;
        }
        Ok(())
    };
    whole().map_err(failed)
}

fn written(
    flight: &mut Flight<'_>,
    report: &mut Report,
) -> Result<(serde_json::Map<String, serde_json::Value>, Vec<u8>)> {
    let mut progress = flight.take_progress();
    let mut write = || {
        let mut writer = write::Writer::new(flight)?;
        writer.document(&mut |done, all| {
            if let Some(progress) = &mut progress {
                progress(done, all);
            }
        })?;
        writer.tell(report);
        Ok(writer.finish())
    };
    let done = write();
    flight.give_progress(progress);
    done
}
