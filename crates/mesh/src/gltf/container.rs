//! Splits a file into its JSON and the buffers named in it.

use std::borrow::Cow;
use std::ops::Range;

use serde_json::Value;
use vides_engine::limits::MAX_FILE_BYTES;

use crate::error::{Beside, Error, Problem, Result};

pub(super) const FORMAT: Error = Error::File(Problem::Format);
pub(super) const END: Error = Error::File(Problem::End);
pub(super) const INDICES: Error = Error::File(Problem::Indices);

/// Bytes that serde_json needs for an object and its tree node, and for each value in an object or
/// list.
const OBJECT: usize = 700;
const VALUE: usize = 160;

/// Limit on the memory of the parsed JSON.
const MAX_JSON: usize = 512 << 20;

/// Required extensions that do not change what is read, or that readers of scenes handle.
const KNOWN: [&str; 5] = [
    "KHR_mesh_quantization",
    "KHR_texture_transform",
    "KHR_lights_punctual",
    "KHR_node_visibility",
    "KHR_animation_pointer",
];

/// Prefixes of extensions for materials and textures, which are not read.
const LOOKS: [&str; 4] = [
    "KHR_materials_",
    "KHR_technique",
    "KHR_texture_",
    "EXT_texture_",
];

/// Extensions that compress what is read, each with a message that says what helps.
const COMPRESSED: [(&str, Problem); 3] = [
    ("KHR_draco_mesh_compression", Problem::Draco),
    ("EXT_meshopt_compression", Problem::Meshopt),
    ("KHR_meshopt_compression", Problem::Meshopt),
];

/// A glTF file, text or GLB, and its buffers.
#[derive(Debug)]
pub struct Container<'a> {
    document: Value,
    file: Cow<'a, [u8]>,
    buffers: Vec<Buffer>,
    size: usize,
}

#[derive(Debug)]
enum Buffer {
    /// The binary chunk of a GLB.
    Chunk(Range<usize>),
    Own(Vec<u8>),
}

impl<'a> Container<'a> {
    /// Splits a file; `beside` returns external buffers by name.
    ///
    /// # Errors
    /// [`Error::File`] for a malformed file, a missing buffer or a file beyond the limits;
    /// [`Error::Extension`] if it requires an extension that is not supported; [`Error::Memory`].
    pub fn open(file: Cow<'a, [u8]>, beside: Beside<'_>) -> Result<Self> {
        let (json, chunk) = parts(&file)?;
        let json = &file[json];
        if weight(json) > MAX_JSON {
            return Err(Error::File(Problem::Long));
        }
        let document: Value = serde_json::from_slice(json).map_err(|_| FORMAT)?;
        let version = document["asset"]["version"].as_str().ok_or(FORMAT)?;
        if !version.starts_with("2.") {
            return Err(FORMAT);
        }
        known_extensions(&document["extensionsRequired"])?;
        let mut buffers: Vec<Buffer> = Vec::new();
        let mut size = file.len();
        for (at, buffer) in list(&document["buffers"]).iter().enumerate() {
            let data = match (buffer["uri"].as_str(), &chunk) {
                (Some(uri), _) => Buffer::Own(of_uri(uri, beside)?),
                (None, Some(chunk)) if at == 0 => Buffer::Chunk(chunk.clone()),
                _ => return Err(Error::File(Problem::Buffer)),
            };
            if let Buffer::Own(data) = &data {
                size = size.saturating_add(data.len());
            }
            if size as u64 > MAX_FILE_BYTES {
                return Err(Error::File(Problem::Long));
            }
            buffers.try_reserve(1)?;
            buffers.push(data);
        }
        Ok(Self {
            document,
            file,
            buffers,
            size,
        })
    }

    /// The JSON.
    #[must_use]
    pub const fn json(&self) -> &Value {
        &self.document
    }

    /// The number of bytes in the file and all buffers.
    #[must_use]
    pub const fn size(&self) -> usize {
        self.size
    }

    /// The bytes of a buffer view from an offset on, and the view's stride, if any.
    pub(super) fn view(&self, number: &Value, offset: usize) -> Result<(&[u8], Option<usize>)> {
        let view = element(list(&self.document["bufferViews"]), number)?;
        let buffer = match element(&self.buffers, &view["buffer"])? {
            Buffer::Chunk(range) => &self.file[range.clone()],
            Buffer::Own(bytes) => bytes,
        };
        let start = count_or(&view["byteOffset"], 0)?;
        let length = count_or(&view["byteLength"], 0)?;
        let bytes = start
            .checked_add(length)
            .and_then(|end| buffer.get(start..end))
            .and_then(|view| view.get(offset..))
            .ok_or(END)?;
        let stride = match &view["byteStride"] {
            Value::Null => None,
            stride => Some(index(stride).ok_or(FORMAT)?),
        };
        Ok((bytes, stride))
    }
}

/// The JSON and the binary chunk, if any.
fn parts(bytes: &[u8]) -> Result<(Range<usize>, Option<Range<usize>>)> {
    if !bytes.starts_with(b"glTF") {
        return Ok((0..bytes.len(), None));
    }
    let word = |at: usize| {
        let word = bytes.get(at..at.checked_add(4)?)?;
        Some(u32::from_le_bytes(word.try_into().ok()?) as usize)
    };
    let chunk = |at: usize, kind: &[u8; 4]| {
        let length = word(at)?;
        let known = bytes.get(at + 4..at + 8)? == kind;
        let range = at + 8..(at + 8).checked_add(length)?;
        (known && bytes.get(range.clone()).is_some()).then_some(range)
    };
    if word(4) != Some(2) {
        return Err(FORMAT);
    }
    let json = chunk(12, b"JSON").ok_or(END)?;
    let behind = json.end;
    Ok((json, chunk(behind, b"BIN\0")))
}

/// Fails if the file requires an extension without which it would be read wrongly.
fn known_extensions(needed: &Value) -> Result<()> {
    for name in list(needed).iter().filter_map(Value::as_str) {
        if let Some((_, problem)) = COMPRESSED.iter().find(|(known, _)| *known == name) {
            return Err(Error::File(*problem));
        }
        if !KNOWN.contains(&name) && !LOOKS.iter().any(|looks| name.starts_with(looks)) {
            let plain = |c: &char| c.is_ascii_alphanumeric() || *c == '_';
            return Err(Error::Extension(
                name.chars().filter(plain).take(64).collect(),
            ));
        }
    }
    Ok(())
}

/// The approximate number of bytes of the parsed JSON.
fn weight(json: &[u8]) -> usize {
    json.iter().fold(2 * json.len(), |weight, byte| {
        weight
            + match byte {
                b'{' => OBJECT,
                b'[' | b',' | b':' => VALUE,
                _ => 0,
            }
    })
}

pub(super) fn list(value: &Value) -> &[Value] {
    value.as_array().map_or(&[], Vec::as_slice)
}

pub(super) fn index(value: &Value) -> Option<usize> {
    usize::try_from(value.as_u64()?).ok()
}

/// A whole number, or `none` if it is missing.
pub(super) fn count_or(value: &Value, none: usize) -> Result<usize> {
    match value {
        Value::Null => Ok(none),
        value => index(value).ok_or(FORMAT),
    }
}

/// The element of a list with this index.
pub(super) fn element<'a, T>(list: &'a [T], number: &Value) -> Result<&'a T> {
    index(number).and_then(|at| list.get(at)).ok_or(INDICES)
}

pub(super) fn numbers<const N: usize>(value: &Value) -> Option<[f64; N]> {
    let found = list(value);
    let mut numbers = [0.0; N];
    for (number, value) in numbers.iter_mut().zip(found) {
        *number = value.as_f64()?;
    }
    (found.len() == N).then_some(numbers)
}

fn of_uri(uri: &str, beside: Beside<'_>) -> Result<Vec<u8>> {
    let found = match uri.strip_prefix("data:") {
        Some(data) => data
            .split_once(";base64,")
            .and_then(|(_, text)| base64(text)),
        None => unescaped(uri).and_then(|name| beside(&name)),
    };
    found.ok_or(Error::File(Problem::Buffer))
}

/// Decodes the percent encoding of RFC 3986.
fn unescaped(uri: &str) -> Option<String> {
    let mut bytes = Vec::new();
    let mut rest = uri.as_bytes();
    while let Some((&byte, behind)) = rest.split_first() {
        bytes.try_reserve(1).ok()?;
        let two = behind.get(..2).filter(|_| byte == b'%');
        let code = two.and_then(|two| u8::from_str_radix(str::from_utf8(two).ok()?, 16).ok());
        bytes.push(code.unwrap_or(byte));
        rest = if code.is_some() { &behind[2..] } else { behind };
    }
    String::from_utf8(bytes).ok()
}

/// Not a character of base64.
const NO_SIGN: u8 = 64;

/// The value of each character (RFC 4648).
const SIGNS: [u8; 256] = {
    let alphabet = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut signs = [NO_SIGN; 256];
    let mut at = 0;
    while at < alphabet.len() {
        signs[alphabet[at] as usize] = at as u8;
        at += 1;
    }
    signs
};

/// RFC 4648; `None` if invalid.
fn base64(text: &str) -> Option<Vec<u8>> {
    let signs = text.trim_end_matches('=').as_bytes();
    let mut bytes = Vec::new();
    bytes.try_reserve_exact(signs.len() / 4 * 3 + 3).ok()?;
    for four in signs.chunks(4) {
        let mut word = 0_u32;
        for &byte in four {
            let value = SIGNS[usize::from(byte)];
            if value == NO_SIGN {
                return None;
            }
            word = word << 6 | u32::from(value);
        }
        word <<= 6 * (4 - four.len());
        bytes.extend_from_slice(&word.to_be_bytes()[1..four.len()]);
    }
    Some(bytes)
}
