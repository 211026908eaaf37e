//! glTF 2.0 (Khronos 2021), text and GLB: the primitives of all nodes of the scene, in place. By
//! hand: readers of the whole format trust that a checked file's accessors lie within its buffers.

use std::collections::HashMap;

use glam::{DAffine3, DMat4, DQuat, DVec3};
use serde_json::Value;
use vides_engine::limits::{MAX_FILE_BYTES, MAX_MESH_CORNERS, MAX_MESH_POINTS};
use vides_engine::scene::Mesh;

use super::{Beside, Error, Problem, Result};

/// Bytes that serde_json takes for an object and its tree node, and per value in it or in a list.
const OBJECT: usize = 700;
const VALUE: usize = 160;

/// Limit on the memory of the parsed JSON.
const MAX_JSON: usize = 512 << 20;

/// Limits on placed points, and on corners: so many, and so many per byte of the file.
const ROOM: usize = 50_000;
const ROOM_PER_BYTE: usize = 4;

const MAX_PRIMITIVES: usize = 100_000;

/// Maximum depth of the node tree.
const MAX_DEPTH: usize = 256;

/// Component types of the format.
const BYTE: u64 = 5121;
const SHORT: u64 = 5123;
const INT: u64 = 5125;
const FLOAT: u64 = 5126;

const FORMAT: Error = Error::File(Problem::Format);
const END: Error = Error::File(Problem::End);
const INDICES: Error = Error::File(Problem::Indices);

pub(super) fn read(
    bytes: &[u8],
    beside: Beside<'_>,
    go_on: &mut dyn FnMut(f64) -> bool,
) -> Result<Mesh> {
    let (json, chunk) = parts(bytes)?;
    if weight(json) > MAX_JSON {
        return Err(Error::File(Problem::Long));
    }
    let document: Value = serde_json::from_slice(json).map_err(|_| FORMAT)?;
    let version = document["asset"]["version"].as_str().ok_or(FORMAT)?;
    if !version.starts_with("2.") {
        return Err(FORMAT);
    }
    known_extensions(&document["extensionsRequired"])?;
    let mut buffers: Vec<Vec<u8>> = Vec::new();
    let mut all = bytes.len();
    for (at, buffer) in list(&document["buffers"]).iter().enumerate() {
        let data = match (buffer["uri"].as_str(), chunk) {
            (Some(uri), _) => of_uri(uri, beside)?,
            (None, Some(chunk)) if at == 0 => {
                let mut copy = Vec::new();
                copy.try_reserve_exact(chunk.len())?;
                copy.extend_from_slice(chunk);
                copy
            }
            _ => return Err(Error::File(Problem::Buffer)),
        };
        all = all.saturating_add(data.len());
        if all as u64 > MAX_FILE_BYTES {
            return Err(Error::File(Problem::Long));
        }
        buffers.try_reserve(1)?;
        buffers.push(data);
    }
    let mut reader = Reader {
        document: &document,
        buffers: &buffers,
        mesh: Mesh::default(),
        room: ROOM.saturating_add(all.saturating_mul(ROOM_PER_BYTE)),
        corners: 0,
    };
    reader.scene(go_on)?;
    joined(reader.mesh)
}

/// Extensions that change how positions are read.
const UNREAD: [(&str, Problem); 3] = [
    ("KHR_draco_mesh_compression", Problem::Draco),
    ("EXT_meshopt_compression", Problem::Meshopt),
    ("KHR_mesh_quantization", Problem::Quantised),
];

/// Fails where the file demands one of these.
fn known_extensions(needed: &Value) -> Result<()> {
    let has = |name: &str| list(needed).iter().any(|needed| needed == name);
    let found = UNREAD.into_iter().find(|(name, _)| has(name));
    found.map_or(Ok(()), |(_, problem)| Err(Error::File(problem)))
}

/// Approximate bytes of the parsed JSON.
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

/// Merges points of equal position and colour: exporters split them where normals or textures
/// differ, and each seam would be an edge.
fn joined(mut mesh: Mesh) -> Result<Mesh> {
    if mesh.triangles.is_empty() && mesh.lines.is_empty() {
        return Ok(mesh);
    }
    let mut known: HashMap<([u64; 3], [u8; 3]), u32> = HashMap::new();
    known.try_reserve(mesh.points.len())?;
    let mut new: Vec<u32> = Vec::new();
    new.try_reserve_exact(mesh.points.len())?;
    let mut kept = 0;
    for at in 0..mesh.points.len() {
        // Adding 0 turns −0 into 0.
        let place = (mesh.points[at] + DVec3::ZERO).to_array().map(f64::to_bits);
        let colour = mesh.colours.get(at).copied().unwrap_or_default();
        let point = *known.entry((place, colour)).or_insert(kept as u32);
        if point as usize == kept {
            mesh.points[kept] = mesh.points[at];
            if let Some(&colour) = mesh.colours.get(at) {
                mesh.colours[kept] = colour;
            }
            kept += 1;
        }
        new.push(point);
    }
    mesh.points.truncate(kept);
    mesh.colours.truncate(kept);
    let corners = mesh.triangles.iter_mut().flatten();
    for corner in corners.chain(mesh.lines.iter_mut().flatten()) {
        *corner = new[*corner as usize];
    }
    Ok(mesh)
}

/// The JSON and the binary chunk, if any.
fn parts(bytes: &[u8]) -> Result<(&[u8], Option<&[u8]>)> {
    if !bytes.starts_with(b"glTF") {
        return Ok((bytes, None));
    }
    let word = |at: usize| {
        let word = bytes.get(at..at + 4)?;
        Some(u32::from_le_bytes(word.try_into().ok()?) as usize)
    };
    let chunk = |at: usize, kind: &[u8; 4]| {
        let length = word(at)?;
        let known = bytes.get(at + 4..at + 8)? == kind;
        known.then(|| bytes.get(at + 8..(at + 8).checked_add(length)?))?
    };
    if word(4) != Some(2) {
        return Err(FORMAT);
    }
    let json = chunk(12, b"JSON").ok_or(END)?;
    Ok((json, chunk(20 + json.len(), b"BIN\0")))
}

fn list(value: &Value) -> &[Value] {
    value.as_array().map_or(&[], Vec::as_slice)
}

fn index(value: &Value) -> Option<usize> {
    usize::try_from(value.as_u64()?).ok()
}

/// The element of a list that has this number.
fn element<'a, T>(list: &'a [T], number: &Value) -> Result<&'a T> {
    index(number).and_then(|at| list.get(at)).ok_or(INDICES)
}

fn numbers<const N: usize>(value: &Value) -> Option<[f64; N]> {
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

/// RFC 4648; none if invalid.
fn base64(text: &str) -> Option<Vec<u8>> {
    const ALPHABET: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let signs = text.trim_end_matches('=').as_bytes();
    let mut bytes = Vec::new();
    bytes.try_reserve_exact(signs.len() / 4 * 3 + 3).ok()?;
    for four in signs.chunks(4) {
        let mut word = 0_u32;
        for &byte in four {
            let value = ALPHABET.iter().position(|known| *known == byte)?;
            word = word << 6 | value as u32;
        }
        word <<= 6 * (4 - four.len());
        bytes.extend_from_slice(&word.to_be_bytes()[1..four.len()]);
    }
    Some(bytes)
}

struct Reader<'a> {
    document: &'a Value,
    buffers: &'a [Vec<u8>],
    mesh: Mesh,
    /// Limit on points and corners.
    room: usize,
    corners: usize,
}

struct Accessor<'a> {
    bytes: &'a [u8],
    count: usize,
    stride: usize,
    component: u64,
}

impl Accessor<'_> {
    fn number(&self, at: usize, part: usize) -> f64 {
        let size = size_of_component(self.component);
        let start = at * self.stride + part * size;
        let bytes = self.bytes.get(start..start + size).unwrap_or_default();
        match *bytes {
            [a] => f64::from(a),
            [a, b] => f64::from(u16::from_le_bytes([a, b])),
            [a, b, c, d] if self.component == FLOAT => f64::from(f32::from_le_bytes([a, b, c, d])),
            [a, b, c, d] => f64::from(u32::from_le_bytes([a, b, c, d])),
            _ => 0.0,
        }
    }

    /// A linear colour component as a byte of sRGB (IEC 61966-2-1).
    fn colour(&self, at: usize, part: usize) -> u8 {
        let most = match self.component {
            BYTE => 255.0,
            SHORT => 65535.0,
            _ => 1.0,
        };
        let linear = self.number(at, part) / most;
        let share = if linear <= 0.003_130_8 {
            12.92 * linear
        } else {
            1.055 * linear.powf(1.0 / 2.4) - 0.055
        };
        (255.0 * share).round() as u8
    }
}

const fn size_of_component(component: u64) -> usize {
    match component {
        BYTE => 1,
        SHORT => 2,
        _ => 4,
    }
}

impl<'a> Reader<'a> {
    /// All nodes of the shown scene, or of the whole tree if there is none.
    fn scene(&mut self, go_on: &mut dyn FnMut(f64) -> bool) -> Result<()> {
        let document = self.document;
        let nodes = list(&document["nodes"]);
        let scenes = list(&document["scenes"]);
        let mut waiting: Vec<(usize, DAffine3, usize)> = Vec::new();
        let mut seen = Vec::new();
        seen.try_reserve_exact(nodes.len())?;
        seen.resize(nodes.len(), false);
        let mut push = |waiting: &mut Vec<_>, node: &Value, transform: DAffine3, depth: usize| {
            let at = index(node).ok_or(INDICES)?;
            // Each node has at most one parent, so there are no cycles.
            if std::mem::replace(seen.get_mut(at).ok_or(INDICES)?, true) {
                return Err(Error::File(Problem::Cycle));
            }
            if depth > MAX_DEPTH {
                return Err(Error::File(Problem::Long));
            }
            waiting.try_reserve(1)?;
            waiting.push((at, transform, depth));
            Ok(())
        };
        let shown = match &document["scene"] {
            Value::Null => scenes.first(),
            number => Some(element(scenes, number)?),
        };
        if let Some(scene) = shown {
            for node in list(&scene["nodes"]).iter().rev() {
                push(&mut waiting, node, DAffine3::IDENTITY, 0)?;
            }
        } else {
            let mut below = vec![false; nodes.len()];
            for child in nodes.iter().flat_map(|node| list(&node["children"])) {
                *index(child)
                    .and_then(|at| below.get_mut(at))
                    .ok_or(INDICES)? = true;
            }
            for at in (0..nodes.len()).rev().filter(|&at| !below[at]) {
                push(&mut waiting, &at.into(), DAffine3::IDENTITY, 0)?;
            }
            if waiting.is_empty() && !nodes.is_empty() {
                return Err(Error::File(Problem::Cycle));
            }
        }
        let (mut done, mut placed) = (0, 0);
        while let Some((at, transform, depth)) = waiting.pop() {
            if !go_on(done as f64 / nodes.len() as f64) {
                return Err(Error::Stopped);
            }
            done += 1;
            let node = &nodes[at];
            let transform = transform * local_transform(node)?;
            if let Some(mesh) = node.get("mesh") {
                let mesh = element(list(&document["meshes"]), mesh)?;
                for primitive in list(&mesh["primitives"]) {
                    placed += 1;
                    if placed > MAX_PRIMITIVES {
                        return Err(Error::File(Problem::Long));
                    }
                    self.primitive(primitive, &transform)?;
                }
            }
            for child in list(&node["children"]).iter().rev() {
                push(&mut waiting, child, transform, depth + 1)?;
            }
        }
        Ok(())
    }

    fn primitive(&mut self, primitive: &Value, transform: &DAffine3) -> Result<()> {
        let attributes = &primitive["attributes"];
        let Some(positions) = attributes.get("POSITION") else {
            return Ok(());
        };
        let positions = self.accessor(positions, 3, &[FLOAT])?;
        let first = self.mesh.points.len();
        let room = self.room.min(MAX_MESH_POINTS);
        if positions.count > room.saturating_sub(first) {
            return Err(Error::File(Problem::Long));
        }
        let colours = match attributes.get("COLOR_0") {
            None => None,
            Some(colours) => Some(self.accessor(colours, 0, &[BYTE, SHORT, FLOAT])?),
        };
        let colours = colours.filter(|colours| colours.count == positions.count);
        if colours.is_some() || !self.mesh.colours.is_empty() {
            let room = first + positions.count - self.mesh.colours.len();
            self.mesh.colours.try_reserve(room)?;
            self.mesh.colours.resize(first, [255; 3]);
            self.mesh.colours.extend((0..positions.count).map(|at| {
                colours.as_ref().map_or([255; 3], |colours| {
                    [0, 1, 2].map(|part| colours.colour(at, part))
                })
            }));
        }
        self.mesh.points.try_reserve(positions.count)?;
        self.mesh.points.extend((0..positions.count).map(|at| {
            let point = [0, 1, 2].map(|part| positions.number(at, part));
            transform.transform_point3(DVec3::from_array(point))
        }));
        let corners = match primitive.get("indices") {
            None => None,
            Some(indices) => Some(self.accessor(indices, 1, &[BYTE, SHORT, INT])?),
        };
        let count = corners.as_ref().map_or(positions.count, |c| c.count);
        // A strip or fan makes up to three corners per index.
        self.corners = self.corners.saturating_add(3 * count);
        if self.corners > MAX_MESH_CORNERS.min(3 * self.room) {
            return Err(Error::File(Problem::Long));
        }
        let corner = |at: usize| -> Result<u32> {
            let number = corners
                .as_ref()
                .map_or(at, |corners| corners.number(at, 0) as usize);
            // There are fewer than 2³² points.
            (number < positions.count)
                .then_some((first + number) as u32)
                .ok_or(INDICES)
        };
        // Mirrored triangles are reversed, or they would face inwards.
        let turned = transform.matrix3.determinant() < 0.0;
        let lines = &mut self.mesh.lines;
        let mut line = |from: usize, to: usize| -> Result<()> {
            lines.try_reserve(1)?;
            lines.push([corner(from)?, corner(to)?]);
            Ok(())
        };
        let triangles = &mut self.mesh.triangles;
        let mut triangle = |a: usize, b: usize, c: usize| -> Result<()> {
            let [b, c] = if turned { [c, b] } else { [b, c] };
            triangles.try_reserve(1)?;
            triangles.push([corner(a)?, corner(b)?, corner(c)?]);
            Ok(())
        };
        match primitive.get("mode").map_or(Some(4), index) {
            Some(0) => Ok(()),
            Some(1) => (0..count / 2).try_for_each(|at| line(2 * at, 2 * at + 1)),
            Some(2) if count > 1 => (0..count).try_for_each(|at| line(at, (at + 1) % count)),
            Some(2 | 3) => (1..count).try_for_each(|at| line(at - 1, at)),
            Some(4) => (0..count / 3).try_for_each(|at| triangle(3 * at, 3 * at + 1, 3 * at + 2)),
            Some(5) => (2..count).try_for_each(|at| {
                let odd = at % 2;
                triangle(at - 2, at - 1 + odd, at - odd)
            }),
            Some(6) => (2..count).try_for_each(|at| triangle(0, at - 1, at)),
            _ => Err(FORMAT),
        }
    }

    /// The elements of an accessor, `width` numbers each (0: three or four).
    fn accessor(&self, number: &Value, width: usize, components: &[u64]) -> Result<Accessor<'a>> {
        let accessor = element(list(&self.document["accessors"]), number)?;
        let found = match accessor["type"].as_str() {
            Some("SCALAR") => 1,
            Some("VEC3") => 3,
            Some("VEC4") => 4,
            _ => return Err(FORMAT),
        };
        let component = accessor["componentType"].as_u64().unwrap_or(0);
        let fits = found == width || (width == 0 && found > 1);
        if accessor.get("sparse").is_some() {
            return Err(Error::File(Problem::Sparse));
        }
        if components == [FLOAT] && (5120..=5123).contains(&component) {
            return Err(Error::File(Problem::Quantised));
        }
        if !fits || !components.contains(&component) {
            return Err(FORMAT);
        }
        let view = element(list(&self.document["bufferViews"]), &accessor["bufferView"])?;
        let buffer = element(self.buffers, &view["buffer"])?;
        let offset = |value: &Value| match value {
            Value::Null => Ok(0),
            value => index(value).ok_or(FORMAT),
        };
        let (start, length) = (offset(&view["byteOffset"])?, offset(&view["byteLength"])?);
        let bytes = start
            .checked_add(length)
            .and_then(|end| buffer.get(start..end))
            .and_then(|view| view.get(offset(&accessor["byteOffset"]).ok()?..))
            .ok_or(END)?;
        let size = found * size_of_component(component);
        let stride = offset(&view["byteStride"])?.max(size);
        let count = index(&accessor["count"]).ok_or(FORMAT)?;
        let needed = count
            .saturating_sub(1)
            .checked_mul(stride)
            .and_then(|before| before.checked_add(if count > 0 { size } else { 0 }));
        if needed.is_none_or(|needed| needed > bytes.len()) {
            return Err(END);
        }
        Ok(Accessor {
            bytes,
            count,
            stride,
            component,
        })
    }
}

/// Transform of a node relative to its parent.
fn local_transform(node: &Value) -> Result<DAffine3> {
    if let Some(matrix) = node.get("matrix") {
        let matrix = numbers::<16>(matrix).ok_or(FORMAT)?;
        return Ok(DAffine3::from_mat4(DMat4::from_cols_array(&matrix)));
    }
    let part = |name: &str, rest: DVec3| match node.get(name) {
        None => Some(rest),
        Some(value) => numbers::<3>(value).map(DVec3::from_array),
    };
    let rotation = match node.get("rotation") {
        None => Some(DQuat::IDENTITY),
        Some(value) => numbers(value).map(DQuat::from_array),
    };
    let (Some(at), Some(rotation), Some(scale)) = (
        part("translation", DVec3::ZERO),
        rotation,
        part("scale", DVec3::ONE),
    ) else {
        return Err(FORMAT);
    };
    let rotation = rotation.normalize();
    Ok(DAffine3::from_scale_rotation_translation(
        scale, rotation, at,
    ))
}
