//! Primitives as points, lines and triangles: of one mesh with its morph targets, or of all nodes
//! in place.

use glam::{DAffine3, DVec3};
use serde_json::Value;
use vides_engine::limits::{MAX_MESH_CORNERS, MAX_MESH_POINTS, MAX_SHAPES};
use vides_engine::scene::Mesh;

use super::accessor::{Accessor, Component};
use super::container::{Container, FORMAT, INDICES, element, index, list};
use super::join::joined;
use crate::error::{Error, Problem, Result};
use crate::srgb;

/// Limits on placed points, and on corners: a fixed number, plus a number per byte of the file.
const ROOM: usize = 50_000;
const ROOM_PER_BYTE: usize = 4;

const MAX_PRIMITIVES: usize = 100_000;

/// A mesh of a file, in its own coordinates.
#[derive(Debug, Default)]
pub struct Part {
    /// Points that are equal in every target are merged.
    pub mesh: Mesh,
    /// The points in each morph target, as many as in the mesh.
    pub targets: Vec<Vec<DVec3>>,
}

/// How much of a file may still be read: points, corners and primitives, bounded by its size.
#[derive(Clone, Debug)]
pub struct Room {
    points: usize,
    corners: usize,
    primitives: usize,
}

impl Room {
    /// The limits for a file of this size.
    #[must_use]
    pub fn of(container: &Container<'_>) -> Self {
        let points = ROOM.saturating_add(container.size().saturating_mul(ROOM_PER_BYTE));
        Self {
            points,
            corners: points.saturating_mul(3),
            primitives: MAX_PRIMITIVES,
        }
    }

    fn take(room: &mut usize, wanted: usize) -> Result<()> {
        *room = room.checked_sub(wanted).ok_or(Error::File(Problem::Long))?;
        Ok(())
    }
}

/// All nodes of the shown scene in place, without morph targets.
pub(super) fn whole(container: &Container<'_>, go_on: &mut dyn FnMut(f64) -> bool) -> Result<Mesh> {
    let nodes = container.tree()?;
    let json = container.json();
    let mut room = Room::of(container);
    let mut builder = Builder::new(container, &mut room);
    let mut places: Vec<DAffine3> = Vec::new();
    places.try_reserve_exact(nodes.len())?;
    for (done, placed) in nodes.iter().enumerate() {
        if !go_on(done as f64 / nodes.len() as f64) {
            return Err(Error::Stopped);
        }
        let local = container.local(placed.node)?.matrix();
        let place = placed.parent.map_or(local, |parent| places[parent] * local);
        places.push(place);
        if let Some(mesh) = json["nodes"][placed.node].get("mesh") {
            let mesh = element(list(&json["meshes"]), mesh)?;
            for primitive in list(&mesh["primitives"]) {
                builder.primitive(primitive, &place)?;
            }
        }
    }
    Ok(joined(builder.part)?.mesh)
}

impl Container<'_> {
    /// A mesh by its index in the file, with its morph targets.
    ///
    /// # Errors
    /// [`Error::File`] for a malformed or too large mesh; [`Error::Memory`], [`Error::Stopped`].
    pub fn part(
        &self,
        number: usize,
        room: &mut Room,
        go_on: &mut dyn FnMut(f64) -> bool,
    ) -> Result<Part> {
        let mesh = list(&self.json()["meshes"]).get(number).ok_or(INDICES)?;
        let primitives = list(&mesh["primitives"]);
        let mut builder = Builder::new(self, room);
        let targets = primitives
            .first()
            .map_or(0, |first| list(&first["targets"]).len());
        if targets > MAX_SHAPES {
            return Err(Error::File(Problem::Long));
        }
        builder.part.targets.resize_with(targets, Vec::new);
        for (done, primitive) in primitives.iter().enumerate() {
            if !go_on(done as f64 / primitives.len() as f64) {
                return Err(Error::Stopped);
            }
            builder.primitive(primitive, &DAffine3::IDENTITY)?;
        }
        joined(builder.part)
    }
}

struct Builder<'a> {
    container: &'a Container<'a>,
    room: &'a mut Room,
    part: Part,
    corners: usize,
}

fn three(accessor: &Accessor<'_>, at: usize) -> DVec3 {
    DVec3::from_array([0, 1, 2].map(|part| accessor.number(at, part)))
}

impl<'a> Builder<'a> {
    fn new(container: &'a Container<'a>, room: &'a mut Room) -> Self {
        Self {
            container,
            room,
            part: Part::default(),
            corners: 0,
        }
    }

    /// Positions: floats, or integers as in `KHR_mesh_quantization`.
    fn places(&self, number: &Value) -> Result<Accessor<'a>> {
        let places = self.container.accessor(number, self.room.points)?;
        if places.width() != 3 || places.component() == Component::U32 {
            return Err(FORMAT);
        }
        Ok(places)
    }

    fn primitive(&mut self, primitive: &Value, transform: &DAffine3) -> Result<()> {
        Room::take(&mut self.room.primitives, 1)?;
        let attributes = &primitive["attributes"];
        let Some(positions) = attributes.get("POSITION") else {
            return Ok(());
        };
        let positions = self.places(positions)?;
        let count = positions.count();
        let first = self.part.mesh.points.len();
        if count > MAX_MESH_POINTS - first.min(MAX_MESH_POINTS) {
            return Err(Error::File(Problem::Long));
        }
        let copies = 1 + self.part.targets.len();
        Room::take(&mut self.room.points, count.saturating_mul(copies))?;
        self.colours(attributes, first, count)?;
        let points = &mut self.part.mesh.points;
        points.try_reserve(count)?;
        points.extend((0..count).map(|at| transform.transform_point3(three(&positions, at))));
        self.targets(primitive, &positions)?;
        self.connect(primitive, first, count, transform)
    }

    fn colours(&mut self, attributes: &Value, first: usize, count: usize) -> Result<()> {
        let colours = match attributes.get("COLOR_0") {
            None => None,
            Some(colours) => Some(self.container.accessor(colours, self.room.points)?),
        };
        let fits = |colours: &Accessor<'_>| {
            use Component::{F32, U8, U16};
            colours.width() >= 3 && matches!(colours.component(), U8 | U16 | F32)
        };
        if colours.as_ref().is_some_and(|colours| !fits(colours)) {
            return Err(FORMAT);
        }
        let colours = colours.filter(|colours| colours.count() == count);
        let all = &mut self.part.mesh.colours;
        if colours.is_none() && all.is_empty() {
            return Ok(());
        }
        all.try_reserve(first + count - all.len())?;
        all.resize(first, [255; 3]);
        all.extend((0..count).map(|at| {
            colours.as_ref().map_or([255; 3], |colours| {
                [0, 1, 2].map(|part| srgb::byte(colours.share(at, part)))
            })
        }));
        Ok(())
    }

    /// The points of the primitive in each target; a target without positions moves none.
    fn targets(&mut self, primitive: &Value, positions: &Accessor<'_>) -> Result<()> {
        let given = list(&primitive["targets"]);
        let wanted = self.part.targets.len();
        if wanted > 0 && given.len() != wanted {
            return Err(FORMAT);
        }
        for at in 0..wanted {
            let moved = match given[at].get("POSITION") {
                None => None,
                Some(moved) => Some(self.places(moved)?),
            };
            if moved
                .as_ref()
                .is_some_and(|moved| moved.count() != positions.count())
            {
                return Err(FORMAT);
            }
            let target = &mut self.part.targets[at];
            target.try_reserve(positions.count())?;
            target.extend((0..positions.count()).map(|point| {
                let by = moved
                    .as_ref()
                    .map_or(DVec3::ZERO, |moved| three(moved, point));
                three(positions, point) + by
            }));
        }
        Ok(())
    }

    /// Lines and triangles, by the modes of OpenGL.
    fn connect(
        &mut self,
        primitive: &Value,
        first: usize,
        points: usize,
        transform: &DAffine3,
    ) -> Result<()> {
        let corners = match primitive.get("indices") {
            None => None,
            Some(indices) => Some(self.container.accessor(indices, self.room.points)?),
        };
        if corners
            .as_ref()
            .is_some_and(|corners| corners.width() != 1 || !corners.component().counts())
        {
            return Err(FORMAT);
        }
        let count = corners.as_ref().map_or(points, Accessor::count);
        let mode = primitive.get("mode").map_or(Some(4), index);
        // A strip or fan has up to three corners per index.
        let made = match mode {
            Some(1 | 4) => count,
            _ => count.saturating_mul(3),
        };
        Room::take(&mut self.room.corners, made)?;
        self.corners = self.corners.saturating_add(made);
        if self.corners > MAX_MESH_CORNERS {
            return Err(Error::File(Problem::Long));
        }
        let corner = |at: usize| -> Result<u32> {
            let number = corners
                .as_ref()
                .map_or(at, |corners| corners.number(at, 0) as usize);
            // There are fewer than 2³² points.
            (number < points)
                .then_some((first + number) as u32)
                .ok_or(INDICES)
        };
        // Mirrored triangles are reversed, otherwise they would face inwards.
        let turned = transform.matrix3.determinant() < 0.0;
        let lines = &mut self.part.mesh.lines;
        let mut line = |from: usize, to: usize| -> Result<()> {
            lines.try_reserve(1)?;
            lines.push([corner(from)?, corner(to)?]);
            Ok(())
        };
        let triangles = &mut self.part.mesh.triangles;
        if mode == Some(4) {
            triangles.try_reserve_exact(count / 3)?;
        }
        let mut triangle = |a: usize, b: usize, c: usize| -> Result<()> {
            let [b, c] = if turned { [c, b] } else { [b, c] };
            triangles.try_reserve(1)?;
            triangles.push([corner(a)?, corner(b)?, corner(c)?]);
            Ok(())
        };
        match mode {
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
}
