//! From the text of a `.vid` file to its document.

use std::iter::once;

use super::bytes::{OFF_NAME, VERSION};
use super::field::{Field, Source, fields};
use super::own::{self, ReadContext, read_setting};
use super::path_read::{points, space};
use super::pieces;
use super::scene_read::Drafts;
use super::{mesh, mesh_source, tree};
use crate::error::{Invalid, Malformed, Refused, Result, TooMany, can_allocate};
use crate::info::{Info, Object, ObjectPoint};
use crate::named::keys;
use vides_engine::limits;
use vides_engine::path::{CameraPath, Space};
use vides_engine::property::{Table, Value, find};
use vides_engine::scene::{Mesh, Scene};
use vides_engine::shared_list::SharedList;
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

/// Bytes for a point with several views, and for what is taken beside points.
const ROOM_OF_POINT: usize = 2000;
const ROOM_BESIDE: usize = 64 << 10;

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
        // Points are shared, which std cannot refuse where memory has run out.
        can_allocate(ROOM_BESIDE + ROOM_OF_POINT * text.matches("[[point]]").count())?;
        let mut reader = Self {
            path: CameraPath {
                points: SharedList::new(),
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
            return Err(end.complain(end.text.trim_end().len(), reason));
        }
        let mut scene = self.scene.finish(end.text)?;
        scene.set_space(self.path.space)?;
        Ok((scene, self.info))
    }

    fn path(self, end: Source<'_>) -> Result<(CameraPath, Info)> {
        let count = self.path.points.len();
        if count < limits::MIN_POINTS {
            let reason = Malformed::TooFewPoints(count);
            return Err(end.complain(end.text.trim_end().len(), reason));
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
    let mut own = Mesh::default();
    let mut source = mesh_source::Reading::default();
    for field in table.fields()? {
        if source.take(&field)? || mesh::take(&field, &mut own)? {
            continue;
        }
        if field.key != "polylines" {
            let known = ["polylines"].into_iter().chain(mesh::KEYS);
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
    let own_mesh = own != Mesh::default();
    let source = source.done(&table, object.is_empty() && !own_mesh)?;
    if own_mesh && !object.is_empty() {
        return Err(table.error(Malformed::PolylinesAndMesh));
    }
    Ok(match source {
        Some(source) => Object::default().of_source(source),
        None if own_mesh => table.checked(Object::of_mesh(own))?,
        None => object.into(),
    })
}

/// The value that `key = value`, as in a file, gives a property of `of`, except its
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
