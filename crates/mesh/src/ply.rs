//! PLY, read by `ply-rs-bw` straight into the records below.

use glam::DVec3;
use ply_rs_bw::parser::{ParseError, Parser, Reader};
use ply_rs_bw::ply::{ElementDef, Header, Property, PropertyAccess, PropertyAccessResult};
use vides_engine::error::can_allocate;
use vides_engine::scene::Mesh;

use super::error::{Error, Problem, Result};
use super::shared::fan;

impl From<ParseError> for Error {
    fn from(error: ParseError) -> Self {
        // On one line: the reader quotes the file's contents on separate lines.
        let words = error.to_string();
        let between = |letter: char| letter.is_whitespace() || letter.is_control();
        let words = words.split(between).filter(|word| !word.is_empty());
        let words: Vec<_> = words.take(60).collect();
        Self::Ply(words.join(" "))
    }
}

pub(super) fn read(bytes: &[u8], go_on: &mut dyn FnMut(f64) -> bool) -> Result<Mesh> {
    if !bytes.starts_with(b"ply") {
        return Err(Error::File(Problem::Format));
    }
    let mut reader = Reader::new(bytes);
    let header = Parser::<Nothing>::new().read_header(&mut reader)?;
    let mut mesh = Mesh::default();
    for (name, element) in &header.elements {
        let left = reader.get_ref().len();
        if !go_on(1.0 - left as f64 / bytes.len() as f64) {
            return Err(Error::Stopped);
        }
        // A record takes at least one byte, which bounds the count; a record without properties
        // takes none.
        if element.properties.is_empty() {
            continue;
        }
        if element.count > left {
            return Err(Error::File(Problem::End));
        }
        match name.as_str() {
            "vertex" => {
                let records: Vec<Vertex> = records(&header, element, &mut reader)?;
                let coloured = ["red", "green", "blue"].iter().all(|name| {
                    element
                        .properties
                        .keys()
                        .any(|is| colour(is) == colour(name))
                });
                mesh.points.try_reserve_exact(records.len())?;
                mesh.points
                    .extend(records.iter().map(|vertex| vertex.position));
                if coloured {
                    mesh.colours.try_reserve_exact(records.len())?;
                    mesh.colours
                        .extend(records.iter().map(|vertex| vertex.colour));
                }
            }
            "face" => {
                for face in records::<Polygon>(&header, element, &mut reader)? {
                    fan(&face.corners, &mut mesh.triangles)?;
                }
            }
            "edge" => {
                let records: Vec<Edge> = records(&header, element, &mut reader)?;
                mesh.lines.try_reserve_exact(records.len())?;
                mesh.lines.extend(records.iter().map(|edge| edge.ends));
            }
            _ => {
                let _: Vec<Nothing> = records(&header, element, &mut reader)?;
            }
        }
    }
    Ok(mesh)
}

fn records<R: PropertyAccess>(
    header: &Header,
    element: &ElementDef,
    reader: &mut Reader<&[u8]>,
) -> Result<Vec<R>> {
    can_allocate(2 * element.count * size_of::<R>())?;
    Ok(Parser::new().read_payload_for_element(reader, element, header)?)
}

fn number(property: &Property) -> Option<f64> {
    match *property {
        Property::Char(value) => Some(value.into()),
        Property::UChar(value) => Some(value.into()),
        Property::Short(value) => Some(value.into()),
        Property::UShort(value) => Some(value.into()),
        Property::Int(value) => Some(value.into()),
        Property::UInt(value) => Some(value.into()),
        Property::Float(value) => Some(value.into()),
        Property::Double(value) => Some(value),
        _ => None,
    }
}

fn colour(name: &str) -> Option<usize> {
    match name {
        "red" | "r" | "diffuse_red" => Some(0),
        "green" | "g" | "diffuse_green" => Some(1),
        "blue" | "b" | "diffuse_blue" => Some(2),
        _ => None,
    }
}

#[derive(Default)]
struct Vertex {
    position: DVec3,
    colour: [u8; 3],
}

impl PropertyAccess for Vertex {
    fn new() -> Self {
        Self::default()
    }

    fn set_property(&mut self, name: &str, property: Property) -> PropertyAccessResult {
        let axis = ["x", "y", "z"].iter().position(|axis| *axis == name);
        if let Some((axis, value)) = axis.zip(number(&property)) {
            self.position[axis] = value;
        } else if let Some((at, value)) = colour(name).zip(property.to_u8_color_lossy()) {
            self.colour[at] = value;
        }
        PropertyAccessResult::Set
    }
}

#[derive(Default)]
struct Polygon {
    corners: Vec<u32>,
}

impl PropertyAccess for Polygon {
    fn new() -> Self {
        Self::default()
    }

    fn set_property(&mut self, name: &str, property: Property) -> PropertyAccessResult {
        if matches!(name, "vertex_indices" | "vertex_index") {
            match property.to_u32_list() {
                Some(corners) => self.corners = corners,
                None => return PropertyAccessResult::UnsupportedType,
            }
        }
        PropertyAccessResult::Set
    }
}

#[derive(Default)]
struct Edge {
    ends: [u32; 2],
}

impl PropertyAccess for Edge {
    fn new() -> Self {
        Self::default()
    }

    fn set_property(&mut self, name: &str, property: Property) -> PropertyAccessResult {
        let end = ["vertex1", "vertex2"].iter().position(|end| *end == name);
        if let Some(end) = end {
            let index = number(&property).filter(|index| (0.0..4e9).contains(index));
            match index {
                Some(index) => self.ends[end] = index as u32,
                None => return PropertyAccessResult::UnsupportedType,
            }
        }
        PropertyAccessResult::Set
    }
}

/// A record that is skipped.
struct Nothing;

impl PropertyAccess for Nothing {
    fn new() -> Self {
        Self
    }

    fn set_property(&mut self, _: &str, _: Property) -> PropertyAccessResult {
        PropertyAccessResult::Ignored
    }
}
