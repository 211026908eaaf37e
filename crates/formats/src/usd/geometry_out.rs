//! Geometry as prims: triangles a mesh, lines curves, clouds points. What is morphed or deformed
//! goes out point by point, frame by frame where it moves.

use std::fmt::Display;
use std::io::Write;

use glam::{DQuat, DVec3};
use vides_document::error::vec_with_room;
use vides_engine::scene::{Channel, Mesh, Object, Warnings};
use vides_mesh::srgb;

use super::role;
use super::text::{self, Float3, single};
use super::write::{Writer, put};
use crate::blocks::failed;
use crate::error::Result;
use crate::flight::succeeded;

/// The width of lines and dots, in diagonals of what they are part of.
const WIDTH: f64 = 1.0 / 500.0;

const COLOURS: &str = "color3f[] primvars:displayColor";

/// What of a mesh a prim holds.
#[derive(Clone, Copy)]
enum Part {
    Triangles,
    Lines,
    Points,
}

impl Part {
    const fn kind(self) -> &'static str {
        match self {
            Self::Triangles => "Mesh",
            Self::Lines => "BasisCurves",
            Self::Points => "Points",
        }
    }

    fn of(mesh: &Mesh) -> Vec<Self> {
        let parts = [
            (Self::Triangles, !mesh.triangles.is_empty()),
            (Self::Lines, !mesh.lines.is_empty()),
            (
                Self::Points,
                !mesh.points.is_empty() && mesh.triangles.is_empty() && mesh.lines.is_empty(),
            ),
        ];
        let there = parts.into_iter().filter(|(_, there)| *there);
        there.map(|(part, _)| part).collect()
    }

    /// Lines that follow each other as curves: the corners of all, and how many each has.
    fn curves(self, mesh: &Mesh) -> Result<(Vec<u32>, Vec<u32>)> {
        match self {
            Self::Lines => curves(&mesh.lines),
            Self::Triangles | Self::Points => Ok(Default::default()),
        }
    }
}

fn curves(lines: &[[u32; 2]]) -> Result<(Vec<u32>, Vec<u32>)> {
    let (mut corners, mut counts) = (vec_with_room(2 * lines.len())?, Vec::new());
    for &[from, to] in lines {
        if corners.last() == Some(&from)
            && let Some(count) = counts.last_mut()
        {
            *count += 1;
        } else {
            corners.push(from);
            counts.try_reserve(1)?;
            counts.push(2);
        }
        corners.push(to);
    }
    Ok((corners, counts))
}

fn bounds(points: &[DVec3]) -> [DVec3; 2] {
    if points.is_empty() {
        return [DVec3::ZERO; 2];
    }
    let low = points.iter().copied().fold(DVec3::INFINITY, DVec3::min);
    let high = points.iter().copied().fold(DVec3::NEG_INFINITY, DVec3::max);
    [low, high]
}

impl Writer<'_, '_, '_> {
    /// The prim of an object, open if there are nodes `inside` it: the geometry itself, if it is
    /// one and nothing is inside, else a place with parts.
    pub(super) fn object(
        &mut self,
        at: usize,
        object: &Object,
        ident: &str,
        depth: usize,
        inside: bool,
    ) -> Result<()> {
        let name = self.of(at).name.as_str();
        let parts = Part::of(object.mesh());
        let one = match parts[..] {
            [one] if !inside => Some(one),
            _ => None,
        };
        let kind = one.map_or("Xform", Part::kind);
        self.open(depth, kind, ident, Some(name), None, "")?;
        self.transform(at, depth + 1, DQuat::IDENTITY, true)?;
        self.visibility(at, depth + 1)?;
        if let Some(part) = one {
            self.part(at, object, part, depth + 1)?;
        } else {
            for part in parts {
                let ident = self.ident(&format!("{ident}_{}", part.kind().to_lowercase()));
                self.open(depth + 1, part.kind(), &ident, None, Some(role::PART), "")?;
                self.part(at, object, part, depth + 2)?;
                put!(self, depth + 1, "}}")?;
            }
        }
        if self.changes(at, object) {
            self.formed += 1;
        }
        Ok(())
    }

    /// Whether the object's points are others than those of its mesh.
    fn changes(&self, at: usize, object: &Object) -> bool {
        self.moves(at)
            || !object.deformations().is_empty()
            || object.weights().iter().any(|weight| *weight != 0.0)
    }

    /// Whether they move.
    fn moves(&self, at: usize) -> bool {
        let mut tracks = self.of(at).keys().tracks().iter();
        tracks.any(|track| {
            matches!(
                track.channel(),
                Channel::Weights | Channel::Deformation { .. }
            )
        })
    }

    fn part(&mut self, at: usize, object: &Object, part: Part, depth: usize) -> Result<()> {
        let mesh = object.mesh();
        let (corners, counts) = part.curves(mesh)?;
        self.topology(mesh, part, &counts, depth)?;
        self.colours(at, mesh, &corners, depth)?;
        let moves = self.moves(at);
        let mut points = vec_with_room(mesh.points.len())?;
        points.resize(mesh.points.len(), DVec3::ZERO);
        let mut shown = vec_with_room(corners.len())?;
        let end = if moves { self.flight.count() } else { 1 };
        // The extent of all frames.
        let (mut low, mut high) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        let name = "point3f[] points";
        if moves {
            put!(self, depth, "{name}.timeSamples = {{")?;
        }
        for index in 0..end {
            self.vertices(at, index, &mut points)?;
            shown.clear();
            shown.extend(corners.iter().map(|&corner| points[corner as usize]));
            let shown = if corners.is_empty() { &points } else { &shown };
            let [lowest, highest] = bounds(shown);
            (low, high) = (low.min(lowest), high.max(highest));
            let head = if moves {
                format!("{}:", self.code_of(index))
            } else {
                format!("{name} =")
            };
            let tail = if moves { "," } else { "" };
            let shown = shown.iter().map(|point| Float3(*point));
            self.list(depth + usize::from(moves), &head, shown, tail)?;
        }
        if moves {
            put!(self, depth, "}}")?;
        }
        self.extent(part, [low, high], depth)
    }

    fn vertices(&self, at: usize, index: usize, points: &mut [DVec3]) -> Result<()> {
        let mut warnings = Warnings::default();
        let frame = self.flight.frame(index);
        let scene = self.flight.scene();
        scene.vertices(at, frame, points, &mut warnings)?;
        succeeded(warnings, self.of(at))?;
        let scale = self.flight.options().scale;
        for point in points {
            *point *= scale;
        }
        Ok(())
    }

    fn topology(&mut self, mesh: &Mesh, part: Part, counts: &[u32], depth: usize) -> Result<()> {
        match part {
            Part::Triangles => {
                put!(self, depth, "uniform token subdivisionScheme = \"none\"")?;
                put!(self, depth, "uniform bool doubleSided = 1")?;
                let threes = std::iter::repeat_n(3, mesh.triangles.len());
                self.list(depth, "int[] faceVertexCounts =", threes, "")?;
                let corners = mesh.triangles.as_flattened().iter();
                self.list(depth, "int[] faceVertexIndices =", corners, "")
            }
            Part::Lines => {
                put!(self, depth, "uniform token type = \"linear\"")?;
                self.list(depth, "int[] curveVertexCounts =", counts.iter(), "")
            }
            Part::Points => Ok(()),
        }
    }

    fn extent(&mut self, part: Part, [low, high]: [DVec3; 2], depth: usize) -> Result<()> {
        let width = if matches!(part, Part::Triangles) {
            0.0
        } else {
            WIDTH * low.distance(high)
        };
        if !matches!(part, Part::Triangles) {
            let width = single(width);
            put!(
                self,
                depth,
                "float[] widths = [{width:?}] (interpolation = \"constant\")"
            )?;
        }
        // Half the width is left and right of a line.
        let [low, high] = [low - 0.5 * width, high + 0.5 * width].map(Float3);
        put!(self, depth, "float3[] extent = [{low}, {high}]")
    }

    fn colours(&mut self, at: usize, mesh: &Mesh, corners: &[u32], depth: usize) -> Result<()> {
        if mesh.colours.is_empty() {
            return self.attribute(at, depth, COLOURS, &Channel::Colour, &|v| {
                format!("[{}]", text::colour(v))
            });
        }
        self.point_colours(mesh, corners, depth)
    }

    /// The colours of the points, or of corners among them.
    fn point_colours(&mut self, mesh: &Mesh, corners: &[u32], depth: usize) -> Result<()> {
        let linear = |colour: &[u8; 3]| Float3(colour.map(srgb::linear).into());
        let tail = " (interpolation = \"vertex\")";
        let head = format!("{COLOURS} =");
        if corners.is_empty() {
            return self.list(depth, &head, mesh.colours.iter().map(linear), tail);
        }
        let of_corners = corners
            .iter()
            .map(|&corner| linear(&mesh.colours[corner as usize]));
        self.list(depth, &head, of_corners, tail)
    }

    /// `head [a, b, …]tail`, on one line.
    fn list<T: Display>(
        &mut self,
        depth: usize,
        head: &str,
        items: impl Iterator<Item = T>,
        tail: &str,
    ) -> Result<()> {
        let write = || {
            write!(self.out, "{:1$}{head} [", "", 4 * depth.min(8))?;
            for (at, item) in items.enumerate() {
                if at > 0 {
                    write!(self.out, ", ")?;
                }
                write!(self.out, "{item}")?;
            }
            writeln!(self.out, "]{tail}")
        };
        write().map_err(failed)
    }

    /// The document's wireframe, or the mesh that it was made of; it lies in the world.
    pub(super) fn wireframe(&mut self, depth: usize) -> Result<()> {
        let object = &self.flight.info().object;
        if object.is_empty() {
            return Ok(());
        }
        let ident = self.ident("object");
        let flight = self.flight;
        if let Some(mesh) = object.mesh() {
            for part in Part::of(mesh) {
                let ident = self.ident(&format!("object_{}", part.kind().to_lowercase()));
                self.open(depth, part.kind(), &ident, None, None, "")?;
                let (corners, counts) = part.curves(mesh)?;
                self.topology(mesh, part, &counts, depth + 1)?;
                if !mesh.colours.is_empty() {
                    self.point_colours(mesh, &corners, depth + 1)?;
                }
                let place = |point: &DVec3| flight.place(*point);
                let points: Vec<DVec3> = match part {
                    Part::Lines => {
                        let corners = corners.iter();
                        corners
                            .map(|&at| place(&mesh.points[at as usize]))
                            .collect()
                    }
                    _ => mesh.points.iter().map(place).collect(),
                };
                self.list(
                    depth + 1,
                    "point3f[] points =",
                    points.iter().map(|p| Float3(*p)),
                    "",
                )?;
                self.extent(part, bounds(&points), depth + 1)?;
                put!(self, depth, "}}")?;
            }
            return Ok(());
        }
        let (mut points, mut counts) = (vec_with_room(object.len())?, vec![]);
        for (point, next) in object
            .iter()
            .zip(object.iter().skip(1).map(Some).chain([None]))
        {
            points.push(flight.place(point.position));
            match counts.last_mut() {
                Some(count) if point.draw => *count += 1,
                _ => counts.push(1),
            }
            // A point by itself is a line of no length.
            if !point.draw && !next.is_some_and(|next| next.draw) {
                points.push(flight.place(point.position));
                *counts.last_mut().unwrap_or(&mut 0) += 1;
            }
        }
        self.open(
            depth,
            "BasisCurves",
            &ident,
            None,
            Some(role::WIREFRAME),
            "",
        )?;
        put!(self, depth + 1, "uniform token type = \"linear\"")?;
        self.list(depth + 1, "int[] curveVertexCounts =", counts.iter(), "")?;
        self.list(
            depth + 1,
            "point3f[] points =",
            points.iter().map(|p| Float3(*p)),
            "",
        )?;
        self.extent(Part::Lines, bounds(&points), depth + 1)?;
        put!(self, depth, "}}")
    }
}
