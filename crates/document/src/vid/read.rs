//! From the text of a `.vid` file to its document.

use std::iter::once;

use glam::DVec3;

use super::field::{Field, Source, fields};
use super::own::{self, ReadContext, Rows};
use super::pieces;
use super::scene_read::{Drafts, MESH_KEYS, take_mesh};
use super::{OFF_NAME, VERSION, mesh_source, tree};
use crate::error::{Invalid, Malformed, Refused, Result, TooMany, vec_with_room};
use crate::info::{Info, Object, ObjectPoint};
use crate::limits;
use crate::math::orientation::wrap_degrees;
use crate::path::camera_path::check_name;
use crate::path::{
    BaseFrames, CameraPath, Orientation, OrientationOverrides, Overrides, Space, SupportPoint, Tcb,
    space,
};
use crate::set::keys;
use vides_engine::property::{Table, Value, find};
use vides_engine::scene::{Mesh, Scene};
use vides_engine::tools::check::{FindingKind, Limits, OFF};

/// The keys of a file; those from `title` to `presets` are one value of the whole path each.
const KEYS: [&str; 19] = [
    "version",
    "title",
    "comment",
    "fps",
    "first_frame",
    "closed",
    "curve",
    "orientation_mode",
    "zoom_mode",
    "base_speeds",
    "presets",
    "space",
    "check",
    "object",
    "point",
    "camera",
    "range",
    "marker",
    "node",
];

/// The keys of a whole path that are neither places nor lists.
pub(crate) const PATH_KEYS: &[&str] = KEYS.split_at(11).0.split_at(1).1;

/// Arrays of tables, which may recur in each piece of a file.
const REPEATED: [&str; 3] = ["point", "marker", "node"];

/// The keys of a path, which in a scene belong to its nodes.
fn of_path() -> impl Iterator<Item = &'static str> {
    keys::<CameraPath>().chain(once("point"))
}

pub(crate) fn from_toml(text: &str) -> Result<(CameraPath, Info)> {
    let (reader, end) = Reader::of(text)?;
    if reader.is_scene() {
        let nodes = reader.scene.count();
        let reason = Malformed::Scene(if reader.has("node") { nodes } else { 1 });
        return Err(end.complain(text.len(), reason));
    }
    reader.path(end)
}

/// The shown camera's path, the info, and whether the file holds just a path.
pub(crate) fn shown_from_toml(text: &str) -> Result<(CameraPath, Info, bool)> {
    let (reader, end) = Reader::of(text)?;
    if !reader.is_scene() {
        let (path, info) = reader.path(end)?;
        return Ok((path, info, true));
    }
    let (scene, info) = reader.scene(end)?;
    let shown = scene.shown_camera().and_then(|at| scene.nodes()[at].path());
    match shown {
        Some(follow) => Ok((follow.path().clone(), info, false)),
        None => Err(Refused::NoCamera.into()),
    }
}

pub(crate) fn scene_from_toml(text: &str) -> Result<(Scene, Info)> {
    let (reader, end) = Reader::of(text)?;
    reader.scene(end)
}

/// The nodes of a text, and which of them aim at nodes that are not in it, by name; there they aim
/// at none.
pub(crate) fn nodes_from_toml(text: &str) -> Result<(Scene, Vec<(usize, String)>)> {
    let (mut reader, end) = Reader::of(text)?;
    let aims = reader.scene.take_aims_beyond()?;
    Ok((reader.scene(end)?.0, aims))
}

struct Reader {
    path: CameraPath,
    info: Info,
    so_far: ReadContext,
    /// Which of [`KEYS`] have been met.
    seen: [bool; KEYS.len()],
    scene: Drafts,
}

impl Reader {
    /// Reads a text; returns the source of its last piece as well.
    fn of(text: &str) -> Result<(Self, Source<'_>)> {
        let mut reader = Self {
            path: CameraPath {
                points: Vec::new(),
                ..CameraPath::default()
            },
            info: Info::default(),
            so_far: ReadContext::default(),
            seen: [false; KEYS.len()],
            scene: Drafts::default(),
        };
        let mut source = Source { text, start: 0 };
        loop {
            let (root, end) = pieces::parse(source)?;
            reader.read(source, &root)?;
            if end == text.len() {
                return Ok((reader, source));
            }
            source.start = end;
        }
    }

    fn has(&self, key: &str) -> bool {
        KEYS.iter()
            .zip(self.seen)
            .any(|(known, seen)| seen && *known == key)
    }

    fn is_scene(&self) -> bool {
        ["node", "marker", "camera", "range"]
            .iter()
            .any(|key| self.has(key))
    }

    fn scene(mut self, end: Source<'_>) -> Result<(Scene, Info)> {
        if !self.has("node") {
            let drafts = std::mem::take(&mut self.scene);
            let (path, info) = self.path(end)?;
            return Ok((drafts.mark(Scene::of_path(path)?, end.text)?, info));
        }
        if let Some(key) = of_path().find(|key| self.has(key)) {
            let reason = Malformed::KeyOfPath(key);
            return Err(end.complain(end.text.len(), reason));
        }
        let mut scene = self.scene.finish(end.text)?;
        scene.set_space(self.path.space)?;
        Ok((scene, self.info))
    }

    fn path(self, end: Source<'_>) -> Result<(CameraPath, Info)> {
        let count = self.path.points.len();
        if count < limits::MIN_POINTS {
            let reason = Malformed::TooFewPoints(count);
            return Err(end.complain(end.text.len(), reason));
        }
        Ok((self.path, self.info))
    }

    fn read(&mut self, source: Source<'_>, root: &tree::Table<'_>) -> Result<()> {
        if source.start == 0 {
            check_version(source, root)?;
        }
        // The space first, since positions are checked against it.
        if let Some(field) = fields(source, root).find(|field| field.key == "space") {
            if !self.has("space") && (self.has("point") || self.has("node")) {
                return Err(field.error(Malformed::BehindPoints));
            }
            space(field, &mut self.path.space, Some(&mut self.info.unit))?;
        }
        let (info, path) = (&mut self.info, &mut self.path);
        for field in fields(source, root) {
            let Some(key) = KEYS.iter().position(|&key| key == field.key) else {
                return Err(field.unknown(&KEYS));
            };
            // Within a piece the parser has checked that.
            if std::mem::replace(&mut self.seen[key], true) && !REPEATED.contains(&field.key) {
                return Err(field.error(Malformed::Engine(Invalid::GivenTwice.into())));
            }
            match field.key {
                "check" => info.limits = limits_of_checks(field)?,
                "object" => info.object = object(field, path.space)?,
                "point" => points(field, &mut path.points, &mut self.so_far, path.space)?,
                "marker" => self.scene.markers(field)?,
                "node" => self.scene.nodes(field, &mut self.so_far, path.space)?,
                // Version and space are already read.
                _ => {
                    let _ = read_setting(field, info)?
                        || read_setting(field, path)?
                        || self.scene.shown.take(field)?;
                }
            }
        }
        Ok(())
    }
}

/// Before anything else, since a newer version may have unknown keys.
fn check_version(source: Source<'_>, root: &tree::Table<'_>) -> Result<()> {
    let Some(field) = fields(source, root).find(|field| field.key == "version") else {
        return Err(source.complain(0, Malformed::NoVersion));
    };
    let version = field.integer()?;
    if version > VERSION {
        return Err(field.error(Malformed::NewerVersion {
            version,
            known: VERSION,
        }));
    }
    if version < 1 {
        return Err(field.error(Malformed::NoSuchVersion));
    }
    Ok(())
}

pub(super) fn one_line(field: Field<'_>) -> Result<String> {
    let line = field.text()?;
    field.checked(check_name(line))?;
    Ok(line.to_owned())
}

/// Reads what is said of a whole file or path by its row; false if the key is of something else.
pub(super) fn read_setting<T: Table>(field: Field<'_>, of: &mut T) -> Result<bool> {
    let so_far = &mut ReadContext::default();
    Rows::default().read(field, T::PROPERTIES, of, Space::NEW, so_far)
}

pub(super) fn base_speeds(table: Field<'_>, speeds: &mut BaseFrames) -> Result<()> {
    for field in table.fields()? {
        if !read_setting(field, speeds)? {
            return Err(field.unknown(&keys::<BaseFrames>().collect::<Vec<_>>()));
        }
    }
    Ok(())
}

pub(super) fn presets(table: Field<'_>, presets: &mut [Tcb; limits::PRESETS]) -> Result<()> {
    for field in table.fields()? {
        // Exactly one digit: 01 and +1 are not other names of 1.
        let preset = match field.key.as_bytes() {
            [digit @ b'0'..=b'9'] => &mut presets[usize::from(digit - b'0')],
            _ => return Err(field.error(Malformed::PresetNumber)),
        };
        *preset = field.tcb()?;
    }
    Ok(())
}

/// A space; only that of a whole file has a unit.
pub(super) fn space(
    table: Field<'_>,
    space: &mut Space,
    mut unit: Option<&mut String>,
) -> Result<()> {
    for field in table.fields()? {
        match (field.key, &mut unit) {
            ("centre", _) => space.centre = DVec3::from_array(field.numbers()?),
            ("half_size", _) => {
                space.half_size = field.number()?;
                field.checked(space::check_half_size(space.half_size))?;
            }
            ("up", _) => space.up = field.choice()?,
            ("unit", Some(unit)) => **unit = one_line(field)?,
            ("scale" | "origin", _) => {
                return Err(field.error(Malformed::Space));
            }
            (_, Some(_)) => return Err(field.unknown(&["centre", "half_size", "unit", "up"])),
            (_, None) => return Err(field.unknown(&["centre", "half_size", "up"])),
        }
    }
    table.checked(space.check())
}

fn limits_of_checks(table: Field<'_>) -> Result<Limits> {
    let mut limits = Limits::default();
    for field in table.fields()? {
        let limit = match field.text() {
            Ok(OFF_NAME) => OFF,
            _ => field.number()?,
        };
        let kind = field.checked(FindingKind::parse(field.key))?;
        field.checked(limits.set(kind, limit))?;
    }
    Ok(limits)
}

fn object(table: Field<'_>, space: Space) -> Result<Object> {
    let mut object = Vec::new();
    let mut mesh = Mesh::default();
    let mut source = mesh_source::Reading::default();
    for field in table.fields()? {
        if source.take(&field)? || take_mesh(&field, &mut mesh)? {
            continue;
        }
        if field.key != "polylines" {
            let known = ["polylines"].into_iter().chain(MESH_KEYS);
            let known: Vec<&str> = known.chain(mesh_source::KEYS).collect();
            return Err(field.unknown(&known));
        }
        for polyline in field.elements()? {
            let points = polyline.elements()?;
            if points.len() > limits::MAX_OBJECT_POINTS - object.len() {
                return Err(polyline.error(TooMany::ObjectPoints));
            }
            object.try_reserve(points.len())?;
            for (index, point) in points.enumerate() {
                object.push(ObjectPoint {
                    position: point.place_in(space)?,
                    draw: index > 0,
                });
            }
        }
    }
    let own_mesh = mesh != Mesh::default();
    let source = source.done(&table, object.is_empty() && !own_mesh)?;
    if own_mesh && !object.is_empty() {
        return Err(table.error(Malformed::PolylinesAndMesh));
    }
    Ok(match source {
        Some(source) => Object::default().of_source(source),
        None if own_mesh => table.checked(Object::of_mesh(mesh))?,
        None => object.into(),
    })
}

pub(super) fn points(
    array: Field<'_>,
    points: &mut Vec<SupportPoint>,
    so_far: &mut ReadContext,
    space: Space,
) -> Result<()> {
    let elements = array.elements()?;
    points.try_reserve(elements.len().min(limits::MAX_POINTS))?;
    for element in elements {
        if points.len() == limits::MAX_POINTS {
            return Err(element.error(TooMany::SupportPoints));
        }
        let point = point(element, space, so_far)?;
        so_far.orientations += point.orientations.len();
        if so_far.orientations > limits::MAX_ALL_ORIENTATIONS {
            return Err(element.error(TooMany::AllOrientations));
        }
        points.push(point);
    }
    Ok(())
}

fn point(table: Field<'_>, space: Space, so_far: &mut ReadContext) -> Result<SupportPoint> {
    // The position first, since targets are checked against it.
    let Some(position) = table.fields()?.find(|field| field.key == "position") else {
        return Err(table.error(Malformed::NoPosition));
    };
    let mut point = SupportPoint {
        position: position.place_in(space)?,
        ..SupportPoint::NEW
    };
    let mut rows = Rows::default();
    for field in table.fields()? {
        if field.key == "orientation" {
            point.orientations = orientations(field, point.position, space, so_far)?;
        } else if !rows.read(field, SupportPoint::PROPERTIES, &mut point, space, so_far)? {
            return Err(field.unknown(&point_keys().chain(once("orientation")).collect::<Vec<_>>()));
        }
    }
    if point.orientations.is_empty() {
        point.orientations = orientations_of_new_point(space)?;
    }
    Ok(point)
}

fn orientations_of_new_point(space: Space) -> Result<Vec<Orientation>> {
    let mut orientations = vec_with_room(1)?;
    orientations.push(Orientation::new_in(space));
    Ok(orientations)
}

fn orientations(
    array: Field<'_>,
    position: DVec3,
    space: Space,
    so_far: &mut ReadContext,
) -> Result<Vec<Orientation>> {
    let elements = array.elements()?;
    let mut orientations = vec_with_room(elements.len().min(limits::MAX_ORIENTATIONS))?;
    for element in elements {
        if orientations.len() == limits::MAX_ORIENTATIONS {
            return Err(element.error(TooMany::Orientations));
        }
        orientations.push(orientation(element, position, space, so_far)?);
    }
    Ok(orientations)
}

fn orientation(
    table: Field<'_>,
    position: DVec3,
    space: Space,
    so_far: &mut ReadContext,
) -> Result<Orientation> {
    let mut orientation = Orientation::new_in(space);
    read_view(table.fields()?, &mut orientation, position, space, so_far)?;
    Ok(orientation)
}

/// Reads fields of an orientation; the others stay.
fn read_view<'a>(
    fields: impl Iterator<Item = Field<'a>>,
    into: &mut Orientation,
    position: DVec3,
    space: Space,
    so_far: &mut ReadContext,
) -> Result<()> {
    let mut rows = Rows::default();
    let mut own: Option<OrientationOverrides> = None;
    for field in fields {
        if find(OrientationOverrides::PROPERTIES, field.key).is_some() {
            let own = own.get_or_insert_with(|| OrientationOverrides::clone(&into.own));
            rows.read(field, OrientationOverrides::PROPERTIES, own, space, so_far)?;
        } else if !rows.read(field, Orientation::PROPERTIES, into, space, so_far)? {
            return Err(field.unknown(&view_keys().collect::<Vec<_>>()));
        } else if matches!(field.key, "target" | "offset") {
            field.checked(into.target.check(position, space))?;
        }
    }
    into.roll = wrap_degrees(into.roll);
    if let Some(read) = own {
        into.own = Overrides::NOTHING.with(|own| *own = read)?;
    }
    Ok(())
}

/// The keys of an orientation.
pub(crate) fn view_keys() -> impl Iterator<Item = &'static str> {
    keys::<Orientation>().chain(keys::<OrientationOverrides>())
}

/// The keys of a point, but for its orientations.
pub(crate) fn point_keys() -> impl Iterator<Item = &'static str> {
    keys::<SupportPoint>()
}

/// The value that `key = value`, as it stands in a file, gives a property of `of`, but for its
/// check.
pub(crate) fn value_of<T: Table>(text: &str, of: &T) -> Result<Value> {
    let source = Source { text, start: 0 };
    let (root, _) = pieces::parse(source)?;
    let field = fields(source, &root).next();
    let found = field.and_then(|field| Some((field, find(T::PROPERTIES, field.key)?)));
    found.map_or(Ok(Value::Unset), |(field, row)| {
        own::value(field, row, of, &mut ReadContext::default())
    })
}
