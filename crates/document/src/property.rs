//! Properties by name: `point.2.zoom = 30` is the zoom of the first view of the second point,
//! `point.2.view.3.zoom` that of its third, `fps` that of the whole file. Keys are those of a
//! `.vid` file, and need not have the unit at their end. `node.lamp.intensity` is that of the node
//! with that name, `node.2.intensity` that of the second one.

use vides_engine::shared_list::SharedList;

use vides_engine::property::{Kind, Listed, Owner, Property, Table, Value, find, list};
use vides_engine::scene::{Node, Values};
use vides_engine::tools::check::{FindingKind, OFF};

use crate::edit::At;
use crate::edit::Selection;
use crate::editing::Document;
use crate::error::{EngineError, Error, Invalid, Malformed, Refused, Result};
use crate::info::{Info, Object, check_comment};
use crate::named::{keys, no_property};
use crate::set;
use crate::space_table::SpaceTable;
use crate::typed::{self, Form, Given};
use crate::vid::{self, PATH_KEYS, point_keys, quoted, view_keys};
use vides_engine::path::camera_path::check_name;
use vides_engine::path::{
    BaseFrames, CameraPath, Orientation, OrientationOverrides, Space, SupportPoint, Tcb,
};

/// What is known of all properties, key by key in the order of files.
#[must_use]
pub fn properties() -> Vec<Listed> {
    let mut all = Vec::new();
    list(Owner::Path, &Info::NEW, &mut all);
    list(Owner::Path, &CameraPath::NEW, &mut all);
    list(Owner::Point, &SupportPoint::NEW, &mut all);
    list(Owner::View, &Orientation::NEW, &mut all);
    list(Owner::View, &OrientationOverrides::NEW, &mut all);
    list(Owner::Node, &Values::NEW, &mut all);
    all
}

/// What a name leads to; it exists.
pub(super) enum Place<'a> {
    Path(&'a str),
    Space(&'static str),
    Limit(FindingKind),
    Point(usize, &'static str),
    View(Selection, &'static str),
    Node(usize, &'static str),
}

impl Place<'_> {
    pub(super) const fn is_space(&self) -> bool {
        matches!(self, Self::Space(_))
    }

    /// The finding of which it is a limit.
    pub(super) const fn limit(&self) -> Option<FindingKind> {
        match self {
            Self::Limit(kind) => Some(*kind),
            _ => None,
        }
    }
}

/// The key that is meant: itself, or that which has a unit besides.
fn full(mut known: impl Iterator<Item = &'static str>, key: &str) -> Option<&'static str> {
    let units = ["_mm", "_degrees", "_frames"];
    known.find(|&known| {
        let bare = units.iter().find_map(|unit| known.strip_suffix(unit));
        known == key || bare == Some(key)
    })
}

/// What has properties: a path alone, a path in its scene, or a scene alone.
pub(super) struct Owners<'a> {
    pub(super) path: Option<&'a CameraPath>,
    pub(super) space: Space,
    pub(super) info: &'a Info,
    pub(super) nodes: &'a SharedList<Node>,
}

impl Owners<'_> {
    /// What a name leads to; a node is called by its number, from 1, or by its name.
    pub(super) fn place<'a>(&self, name: &'a str) -> Result<Place<'a>> {
        if let Some(rest) = name.strip_prefix("node.") {
            return self.node(name, rest);
        }
        if let Some(kind) = name.strip_prefix("check.") {
            let none = |_| no_property(name, FindingKind::all().map(FindingKind::name));
            return Ok(Place::Limit(FindingKind::parse(kind).map_err(none)?));
        }
        if let Some(key) = name.strip_prefix("space.") {
            let known = keys::<SpaceTable>().find(|known| *known == key);
            let none = || no_property(name, keys::<SpaceTable>());
            return Ok(Place::Space(known.ok_or_else(none)?));
        }
        let known = |key: &str| match self.path {
            Some(_) => PATH_KEYS.contains(&key),
            None => find(Info::PROPERTIES, key).is_some(),
        };
        match (self.path, name.strip_prefix("point.")) {
            (Some(path), Some(rest)) => point_or_view(path, name, rest),
            _ if known(name.split('.').next().unwrap_or(name)) => Ok(Place::Path(name)),
            (path, _) => {
                let own = PATH_KEYS.iter().copied().filter(|&key| known(key));
                let others = ["space.NAME", "check.NAME", "node.N."].into_iter();
                let points = path.map(|_| "point.N.").into_iter();
                Err(no_property(name, own.chain(points).chain(others)))
            }
        }
    }

    fn node<'a>(&self, name: &str, rest: &str) -> Result<Place<'a>> {
        let none = || no_property(name, keys::<Values>());
        let (node, key) = rest.rsplit_once('.').ok_or_else(none)?;
        let key = full(keys::<Values>(), key).ok_or_else(none)?;
        let at = match node.parse::<usize>() {
            Ok(number) => number.checked_sub(1).filter(|&at| at < self.nodes.len()),
            Err(_) => self.nodes.iter().position(|known| known.name == node),
        };
        let missing = || match self.nodes.is_empty() {
            true => Error::from(Refused::NoScene),
            false => EngineError::from(Invalid::NoNodeNamed(node.into())).into(),
        };
        Ok(Place::Node(at.ok_or_else(missing)?, key))
    }

    fn path(&self) -> Result<&CameraPath> {
        Ok(self.path.ok_or(Refused::NoPathEdited)?)
    }

    /// Which property is meant, and what is given for it.
    pub(super) fn read(
        &self,
        place: Place<'_>,
        given: Given<'_>,
    ) -> Result<(At, &'static str, Value)> {
        let (at, (property, value)) = match place {
            Place::Path(key) if find(Info::PROPERTIES, key).is_some() => {
                (At::Path, read_value(key, given, self.info)?)
            }
            Place::Path(key) => (At::Path, read_value(key, given, self.path()?)?),
            Place::Space(key) => (
                At::Path,
                read_value(key, given, &SpaceTable::from(self.space))?,
            ),
            Place::Point(at, key) => {
                let point = set::point(self.path()?, at)?;
                (At::Point(at), read_value(key, given, point)?)
            }
            Place::Node(at, key) => {
                let rest = &self.nodes[at].rest;
                (At::Node(at), read_value(key, given, rest)?)
            }
            Place::View(Selection { point, orientation }, key) => {
                let view = set::orientation(self.path()?, point, orientation)?;
                let read = match find(Orientation::PROPERTIES, key) {
                    Some(_) => read_value(key, given, view)?,
                    None => read_value(key, given, &*view.own)?,
                };
                (At::View(point, orientation), read)
            }
            Place::Limit(kind) => {
                let limit = read_limit(kind, given, self.space)?;
                (At::Path, (kind.name(), limit.into()))
            }
        };
        Ok((at, property, value))
    }

    /// The kind and the value of a property.
    fn value(&self, name: &str) -> Result<(Kind, Value)> {
        Ok(match self.place(name)? {
            Place::Limit(kind) => {
                let limit = self.info.limits.get(kind) * limit_scale(kind, self.space);
                (Kind::Number, limit.into())
            }
            Place::Space(key) => of(&SpaceTable::from(self.space), key),
            Place::Node(at, key) => of(&self.nodes[at].rest, key),
            Place::Point(at, key) => of(set::point(self.path()?, at)?, key),
            Place::View(at, key) => {
                let view = set::orientation(self.path()?, at.point, at.orientation)?;
                match find(Orientation::PROPERTIES, key) {
                    Some(_) => of(view, key),
                    None => of(&*view.own, key),
                }
            }
            Place::Path(key) if find(Info::PROPERTIES, key).is_some() => of(self.info, key),
            Place::Path(key) => {
                let path = self.path()?;
                match key.split_once('.') {
                    Some(("base_speeds", key)) => of(&path.base_frames, key),
                    Some(("presets", number)) => {
                        let mut presets = path.presets;
                        let preset = preset_mut(&mut presets, number);
                        (
                            Kind::Shape,
                            (*preset.map_err(|error| told(name, error))?).into(),
                        )
                    }
                    _ => of(path, key),
                }
            }
        })
    }

    /// The value as in a file, or a text as it is; empty if it has none.
    pub(super) fn text(&self, name: &str, plain: bool) -> Result<String> {
        let (kind, value) = self.value(name)?;
        Ok(match value {
            Value::Text(text) if plain => text,
            Value::Choice(choice) if plain && kind.has(&value) => choice.to_owned(),
            Value::Number(OFF) => "off".to_owned(),
            value if kind.has(&value) => value.to_string(),
            _ => String::new(),
        })
    }

    /// The value, if it is asked for in the form that its kind has; none if it is not set.
    pub(super) fn formed(&self, name: &str, asked: Form) -> Result<Option<Value>> {
        let (kind, value) = self.value(name)?;
        let is = Form::of(kind);
        if is != asked {
            return Err(told(name, typed::other_form(is, asked)));
        }
        Ok(kind.has(&value).then_some(value))
    }
}

fn point_or_view<'a>(path: &CameraPath, name: &str, rest: &str) -> Result<Place<'a>> {
    let none = || no_property(name, point_keys().chain(view_keys()));
    let number = |text: &str| match text.parse::<usize>() {
        Ok(number) => number.checked_sub(1),
        Err(_) => None,
    };
    let (point, key) = rest.split_once('.').ok_or_else(none)?;
    let point = number(point).ok_or_else(none)?;
    if let Some(key) = full(point_keys(), key) {
        set::point(path, point)?;
        return Ok(Place::Point(point, key));
    }
    let (view, key) = match key.strip_prefix("view.").map(|view| view.split_once('.')) {
        None => (0, key),
        Some(view) => {
            let (view, key) = view.ok_or_else(none)?;
            (number(view).ok_or_else(none)?, key)
        }
    };
    let key = full(view_keys(), key).ok_or_else(none)?;
    set::orientation(path, point, view)?;
    Ok(Place::View(Selection::at(point, view), key))
}

/// An error with the name of the property before it.
pub(super) fn told(name: &str, error: Error) -> Error {
    let cause = match error {
        Error::Format { cause, .. } | Error::Property { cause, .. } => cause,
        Error::Engine(error) if !matches!(error, EngineError::Memory | EngineError::At(..)) => {
            error.into()
        }
        other => return other,
    };
    Error::Property {
        name: name.into(),
        cause,
    }
}

impl Document {
    pub(super) fn nodes(&self) -> &SharedList<Node> {
        self.edited_scene()
            .map_or(SharedList::EMPTY, |edited| edited.scene().nodes())
    }

    /// All properties by their full names, each with its value as in a file; those that
    /// are as in a new path and need not be told are left out.
    ///
    /// # Errors
    /// `ErrorKind::Memory`.
    pub fn properties(&self) -> Result<Vec<(String, String)>> {
        let info = Info {
            object: Object::default(),
            comment: String::new(),
            ..self.info().clone()
        };
        let text = vid::to_toml(self.path(), &info, &vid::Comments::default(), None)?;
        let (mut point, mut view) = (0, 0);
        let mut table = String::new();
        let mut all = Vec::new();
        for line in text.lines() {
            if let Some(header) = line.strip_prefix('[') {
                table = match header {
                    "[point]]" => {
                        (point, view) = (point + 1, 0);
                        format!("point.{point}.")
                    }
                    "[point.orientation]]" => {
                        view += 1;
                        format!("point.{point}.view.{view}.")
                    }
                    other => format!("{}.", other.trim_end_matches(']')),
                };
            } else if let Some((key, value)) = line.split_once(" = ") {
                let name = format!("{table}{key}");
                let value = match table == "check." {
                    true => self.property(&name)?,
                    false => value.to_owned(),
                };
                all.push((name, value));
            }
        }
        for node in self.nodes() {
            for row in Values::PROPERTIES
                .iter()
                .filter(|row| !(row.same)(&node.rest, &Values::NEW))
            {
                let name = format!("node.{}.{}", node.name, row.key());
                all.push((name, (row.value)(&node.rest).to_string()));
            }
        }
        if !self.info().comment.is_empty() {
            all.push(("comment".to_owned(), quoted(&self.info().comment)));
        }
        Ok(all)
    }
}

/// A property of what has a table, and of which kind it is under this key.
fn of<T: Table>(has: &T, key: &str) -> (Kind, Value) {
    let row = find(T::PROPERTIES, key);
    row.map_or((Kind::Nested, Value::Unset), |row| {
        (row.kind(key), (row.value)(has))
    })
}

/// By what a limit of a check, or what it finds, is multiplied to be in the lengths of the world: the
/// engine and files count them in half sizes of the space.
#[must_use]
pub fn limit_scale(kind: FindingKind, space: Space) -> f64 {
    match kind.unit().starts_with("half sizes") {
        true => space.half_size,
        false => 1.0,
    }
}

/// Reads a limit: a number, or "off"; nothing is the default.
fn read_limit(kind: FindingKind, given: Given<'_>, space: Space) -> Result<f64> {
    let scale = limit_scale(kind, space);
    match given {
        Given::Number(limit) => Ok(limit / scale),
        Given::File(text) | Given::Text(text) => match text.trim() {
            "" => Ok(kind.limit().default),
            "off" | "\"off\"" => Ok(OFF),
            other => {
                let none = |_| typed::other_form(Form::Number, Form::Text);
                Ok(other.parse::<f64>().map_err(none)? / scale)
            }
        },
        other => Err(typed::other_form(Form::Number, other.form())),
    }
}

/// Whether it is nothing that a new one has: where a point lies.
fn is_own<T>(row: &Property<T>) -> bool {
    row.always && !row.copied[0]
}

/// Reads what is given for a key.
fn read_value<T: Table>(key: &str, given: Given<'_>, of: &T) -> Result<(&'static str, Value)> {
    let (first, part) = key
        .split_once('.')
        .map_or((key, false), |(first, _)| (first, true));
    let row = find(T::PROPERTIES, first);
    let row = row.ok_or_else(|| no_property(key, keys::<T>()))?;
    let known = row.keys.iter().find(|known| **known == first);
    let property = known.copied().unwrap_or(row.key());
    let kind = match row.kind(first) {
        Kind::Presets if part => Kind::Shape,
        Kind::BaseFrames if part => Kind::Number,
        kind => kind,
    };
    let value = match given {
        Given::File(value) => read_from_file(key, value.trim(), of)?,
        Given::Text(text) if kind == Kind::Text => {
            // Checked before it is copied, since it may be of any length.
            match property {
                "comment" => check_comment(text)?,
                _ => check_name(text)?,
            }
            let mut copy = String::new();
            copy.try_reserve_exact(text.len())?;
            copy.push_str(text);
            Value::Text(copy)
        }
        Given::Text(text) => read_from_file(key, text, of)?,
        other if part => match typed::value(kind, other, None)? {
            Value::Unset => read_from_file(key, "", of)?,
            new => with_part((row.value)(of), &key[first.len() + 1..], new)?,
        },
        other => match typed::value(kind, other, row.range)? {
            Value::Unset if is_own(row) => {
                let wanted = Form::width(kind);
                return Err(typed::malformed(Malformed::NumberCount {
                    wanted,
                    found: 0,
                }));
            }
            value => value,
        },
    };
    Ok((property, value))
}

/// A value of which a part becomes another.
fn with_part(whole: Value, part: &str, mut new: Value) -> Result<Value> {
    match (whole, new.clone()) {
        (Value::Presets(mut presets), Value::Shape(shape)) => {
            *preset_mut(&mut presets, part)? = shape;
            Ok(Value::Presets(presets))
        }
        (Value::BaseFrames(mut frames), _) => {
            let row = find(BaseFrames::PROPERTIES, part);
            let row = row.ok_or_else(|| no_property(part, keys::<BaseFrames>()))?;
            (row.exchange)(&mut frames, &mut new);
            Ok(Value::BaseFrames(frames))
        }
        (whole, _) => Ok(whole),
    }
}

/// The preset of a number, one digit.
fn preset_mut<'a>(presets: &'a mut [Tcb], number: &str) -> Result<&'a mut Tcb> {
    let at = number.parse::<usize>().ok();
    let found = at.and_then(|at| presets.get_mut(at));
    found.ok_or_else(|| typed::malformed(Malformed::PresetNumber))
}

/// Reads `key = value` as in a file; what no value of a file is, is a text. Nothing is
/// what a new one has.
fn read_from_file<T: Table>(key: &str, value: &str, of: &T) -> Result<Value> {
    let first = key.split('.').next().unwrap_or(key);
    let row = find(T::PROPERTIES, first);
    let row = row.ok_or_else(|| no_property(key, keys::<T>()))?;
    if value.is_empty() && first == key && !is_own(row) {
        return Ok(Value::Unset);
    }
    let new = match value {
        "" if first != key => Document::new().property(key)?,
        given => given.replace(['\n', '\r'], " "),
    };
    let as_text = || vid::value_of(&format!("{key} = {}\n", quoted(value)), of);
    let is_text = matches!(row.kind(first), Kind::Text | Kind::Choice(_));
    if is_text && !value.starts_with(['"', '\'', '{']) {
        return as_text();
    }
    // One line: more would be more keys.
    match vid::value_of(&format!("{key} = {new}\n"), of) {
        Err(Error::Format {
            cause: Malformed::Toml(_),
            ..
        }) => as_text(),
        done => done,
    }
}

#[cfg(test)]
#[path = "property_tests.rs"]
mod tests;
