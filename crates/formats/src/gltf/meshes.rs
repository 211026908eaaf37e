//! Meshes that are written: one for each that objects share, with its shapes and colour.

use std::collections::HashMap;

use glam::DVec3;
use serde_json::{Value, json};
use vides_document::Object as Wires;
use vides_document::error::vec_with_room;
use vides_engine::scene::{Channel, Mesh, Node, Object, Warnings};

use super::binary::{Binary, Use, linear};
use super::keys::{Animation, Target};
use super::of_node::values;
use crate::error::Result;
use crate::flight::Flight;

#[derive(Default)]
pub(super) struct Meshes {
    pub(super) json: Vec<Value>,
    pub(super) materials: Vec<Value>,
    /// By where a mesh without shapes lies, its material, and whether its vertices count from
    /// elsewhere.
    known: HashMap<(usize, usize, bool), (usize, DVec3)>,
    /// Materials that do not change, by the bits of their colour.
    colours: HashMap<[u32; 3], usize>,
    pub(super) coloured_shapes: bool,
}

fn scaled(
    points: impl Iterator<Item = DVec3>,
    count: usize,
    scale: f64,
    origin: DVec3,
) -> Result<Vec<f32>> {
    let mut all = vec_with_room(3 * count)?;
    all.extend(points.flat_map(|point| (point * scale - origin).as_vec3().to_array()));
    Ok(all)
}

/// What the vertices of a mesh count from in the file.
fn origin(flight: &Flight<'_>, points: &[DVec3], world_scale: f64) -> Result<DVec3> {
    let low = points.iter().copied().fold(DVec3::INFINITY, DVec3::min);
    let high = points.iter().copied().fold(DVec3::NEG_INFINITY, DVec3::max);
    flight.origin(low.midpoint(high) * flight.options().scale, world_scale)
}

impl Meshes {
    /// The mesh of an object and what its vertices count from; none if it is empty.
    pub(super) fn of_object(
        &mut self,
        flight: &Flight<'_>,
        binary: &mut Binary,
        animation: &mut Animation,
        node: &Node,
        object: &Object,
        world_scale: f64,
    ) -> Result<Option<(usize, DVec3)>> {
        let mesh = object.mesh();
        if mesh.points.is_empty() {
            return Ok(None);
        }
        let material = self.material(flight, binary, animation, node)?;
        let origin = origin(flight, &mesh.points, world_scale)?;
        let key = (
            std::ptr::from_ref(mesh).addr(),
            material,
            origin != DVec3::ZERO,
        );
        let alone = object.shapes().is_empty();
        if let Some(&known) = self.known.get(&key).filter(|_| alone) {
            return Ok(Some(known));
        }
        let scale = flight.options().scale;
        let mut targets: Vec<Value> = Vec::new();
        let mut names: Vec<Value> = Vec::new();
        for shape in object.shapes() {
            let pairs = shape.points.iter().zip(&mesh.points);
            let moved = pairs.map(|(to, from)| *to - *from);
            let moved = scaled(moved, mesh.points.len(), scale, DVec3::ZERO)?;
            targets.push(json!({"POSITION": binary.floats(&moved, 3, Use::Points)?}));
            names.push(shape.name.as_str().into());
            self.coloured_shapes |= !shape.colours.is_empty();
        }
        let mut json = self.primitives(binary, mesh, (scale, origin), material, &targets)?;
        json["name"] = node.name.as_str().into();
        if !alone {
            json["weights"] = object.weights().iter().map(|&w| w as f32).collect();
            json["extras"] = json!({"targetNames": names});
        }
        let at = self.add(json)?;
        if alone {
            self.known.try_reserve(1)?;
            self.known.insert(key, (at, origin));
        }
        Ok(Some((at, origin)))
    }

    /// The mesh, or else the wireframe, that a path is shown with.
    pub(super) fn of_document(
        &mut self,
        flight: &Flight<'_>,
        binary: &mut Binary,
        object: &Wires,
    ) -> Result<(usize, DVec3)> {
        let scale = flight.options().scale;
        let material = self.of_colour([1.0; 3])?;
        let origin;
        let json = match object.mesh() {
            Some(mesh) => {
                origin = self::origin(flight, &mesh.points, 1.0)?;
                self.primitives(binary, mesh, (scale, origin), material, &[])?
            }
            None => {
                let mut wires = Mesh {
                    points: vec_with_room(object.len())?,
                    ..Mesh::default()
                };
                wires
                    .points
                    .extend(object.iter().map(|point| point.position));
                let drawn = object.iter().enumerate().filter(|(_, point)| point.draw);
                for (at, _) in drawn {
                    wires.lines.try_reserve(1)?;
                    // The first point is never drawn to.
                    wires.lines.push([at as u32 - 1, at as u32]);
                }
                origin = self::origin(flight, &wires.points, 1.0)?;
                self.primitives(binary, &wires, (scale, origin), material, &[])?
            }
        };
        Ok((self.add(json)?, origin))
    }

    fn add(&mut self, json: Value) -> Result<usize> {
        self.json.try_reserve(1)?;
        self.json.push(json);
        Ok(self.json.len() - 1)
    }

    fn primitives(
        &self,
        binary: &mut Binary,
        mesh: &Mesh,
        (scale, origin): (f64, DVec3),
        material: usize,
        targets: &[Value],
    ) -> Result<Value> {
        let count = mesh.points.len();
        let points = scaled(mesh.points.iter().copied(), count, scale, origin)?;
        let mut attributes = json!({"POSITION": binary.floats(&points, 3, Use::Points)?});
        drop(points);
        if !mesh.colours.is_empty() {
            let mut colours = vec_with_room(count)?;
            colours.extend(
                mesh.colours.iter().map(|&[red, green, blue]| {
                    [linear(red), linear(green), linear(blue), u16::MAX]
                }),
            );
            attributes["COLOR_0"] = binary.colours(&colours)?.into();
        }
        let mut primitives = Vec::new();
        let mut primitive = |mode: u32, indices: Option<usize>| {
            let mut json = json!({"attributes": attributes, "material": material, "mode": mode});
            if let Some(indices) = indices {
                json["indices"] = indices.into();
            }
            if !targets.is_empty() {
                json["targets"] = targets.into();
            }
            primitives.push(json);
        };
        if !mesh.triangles.is_empty() {
            primitive(
                4,
                Some(binary.corners(mesh.triangles.as_flattened(), count)?),
            );
        }
        if !mesh.lines.is_empty() {
            primitive(1, Some(binary.corners(mesh.lines.as_flattened(), count)?));
        }
        if mesh.triangles.is_empty() && mesh.lines.is_empty() {
            primitive(0, None);
        }
        Ok(json!({"primitives": primitives}))
    }

    /// The material of an object: its colour, which points' colours are multiplied with.
    fn material(
        &mut self,
        flight: &Flight<'_>,
        binary: &mut Binary,
        animation: &mut Animation,
        node: &Node,
    ) -> Result<usize> {
        let share = |colour: [f64; 3]| colour.map(|part| part.clamp(0.0, 1.0) as f32);
        if node.keys().track(&Channel::Colour).is_none() {
            return self.of_colour(share(node.rest.colour));
        }
        let at = self.materials.len();
        let mut all: Vec<f32> = vec_with_room(4 * flight.count())?;
        let mut warnings = Warnings::default();
        for index in 0..flight.count() {
            let values = values(node, flight.frame(index), &mut warnings)?;
            all.extend(share(values.colour));
            all.push(1.0);
        }
        self.add_material([all[0], all[1], all[2]])?;
        let pointer = format!("/materials/{at}/pbrMetallicRoughness/baseColorFactor");
        animation.a_key_a_frame(flight, binary, Target::Pointer(pointer), &all, 4)?;
        Ok(at)
    }

    fn of_colour(&mut self, colour: [f32; 3]) -> Result<usize> {
        let key = colour.map(f32::to_bits);
        if let Some(&known) = self.colours.get(&key) {
            return Ok(known);
        }
        let at = self.add_material(colour)?;
        self.colours.try_reserve(1)?;
        self.colours.insert(key, at);
        Ok(at)
    }

    fn add_material(&mut self, [red, green, blue]: [f32; 3]) -> Result<usize> {
        self.materials.try_reserve(1)?;
        self.materials.push(json!({
            "pbrMetallicRoughness": {
                "baseColorFactor": [red, green, blue, 1.0],
                "metallicFactor": 0.0,
                "roughnessFactor": 1.0,
            },
            "doubleSided": true,
        }));
        Ok(self.materials.len() - 1)
    }
}
