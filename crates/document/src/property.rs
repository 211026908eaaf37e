//! Properties by name: `point.2.zoom = 30` is the zoom of the first view of the second point,
//! `point.2.view.3.zoom` that of its third, `fps` that of the whole file. Keys are those of a
//! `.vid` file, and need not have the unit at their end. `node.lamp.intensity` is that of the node
//! with that name, `node.2.intensity` that of the second one.

use vides_engine::shared_list::SharedList;

use vides_engine::property::{Kind, Listed, Owner, Table, Value, find, list};
use vides_engine::scene::{Node, Values};

use crate::edit::Selection;
use crate::edit::{At, Edit};
use crate::editing::Document;
use crate::error::{EngineError, Error, Invalid, Malformed, Refused, Result};
use crate::info::{Info, Object};
use crate::named::{keys, no_property};
use crate::set;
use crate::vid::{self, PATH_KEYS, point_keys, quoted, view_keys};
use vides_engine::path::{CameraPath, Orientation, OrientationOverrides, SupportPoint};

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

/// What a name leads to.
enum Place<'a> {
    Path(&'a str),
    Point(usize, &'static str),
    View(Selection, &'static str),
    Node(usize, &'static str),
}

/// The key that is meant: itself, or that which has a unit besides.
fn full(mut known: impl Iterator<Item = &'static str>, key: &str) -> Option<&'static str> {
    let units = ["_mm", "_degrees", "_frames"];
    known.find(|&known| {
        let bare = units.iter().find_map(|unit| known.strip_suffix(unit));
        known == key || bare == Some(key)
    })
}

fn place(name: &str) -> Result<Place<'_>> {
    let none = || no_property(name, point_keys().chain(view_keys()));
    let number = |text: &str| match text.parse::<usize>() {
        Ok(number) => number.checked_sub(1),
        Err(_) => None,
    };
    let Some(rest) = name.strip_prefix("point.") else {
        let key = name.split('.').next().unwrap_or(name);
        return match PATH_KEYS.contains(&key) {
            true => Ok(Place::Path(name)),
            false => Err(no_property(
                name,
                PATH_KEYS.iter().copied().chain(["point.N."]),
            )),
        };
    };
    let (point, key) = rest.split_once('.').ok_or_else(none)?;
    let point = number(point).ok_or_else(none)?;
    if let Some(key) = full(point_keys(), key) {
        return Ok(Place::Point(point, key));
    }
    let (view, key) = match key.strip_prefix("view.").map(|view| view.split_once('.')) {
        None => (0, key),
        Some(view) => {
            let (view, key) = view.ok_or_else(none)?;
            (number(view).ok_or_else(none)?, key)
        }
    };
    match full(view_keys(), key) {
        Some(key) => Ok(Place::View(Selection::at(point, view), key)),
        None => Err(none()),
    }
}

impl Document {
    fn nodes(&self) -> &SharedList<Node> {
        self.edited_scene()
            .map_or(SharedList::EMPTY, |edited| edited.scene().nodes())
    }

    /// What a name leads to; a node is called by its number, from 1, or by its name.
    fn place<'a>(&self, name: &'a str) -> Result<Place<'a>> {
        let Some(rest) = name.strip_prefix("node.") else {
            return place(name);
        };
        let none = || no_property(name, keys::<Values>());
        let (node, key) = rest.rsplit_once('.').ok_or_else(none)?;
        let key = full(keys::<Values>(), key).ok_or_else(none)?;
        let nodes = self.nodes();
        let at = match node.parse::<usize>() {
            Ok(number) => number.checked_sub(1).filter(|&at| at < nodes.len()),
            Err(_) => nodes.iter().position(|known| known.name == node),
        };
        let missing = || match nodes.is_empty() {
            true => Error::from(Refused::NoScene),
            false => EngineError::from(Invalid::NoNodeNamed(node.into())).into(),
        };
        Ok(Place::Node(at.ok_or_else(missing)?, key))
    }

    /// Sets a property by its name to a value as in a file; texts need no quotes, and
    /// nothing gives back what a new path has. One step.
    ///
    /// # Errors
    /// `ErrorKind::Argument` or `Range` with the name and the reason; `ErrorKind::Memory`. The
    /// path is as it was then.
    pub fn set_property(&mut self, name: &str, value: &str) -> Result<()> {
        let (place, path) = (self.place(name)?, self.path());
        let told = |error| match error {
            Error::Format { cause, .. } => Error::Property {
                name: (&name).into(),
                cause,
            },
            Error::Engine(error) if !matches!(error, EngineError::Memory | EngineError::At(..)) => {
                Error::Property {
                    name: (&name).into(),
                    cause: error.into(),
                }
            }
            other => other,
        };
        let value = value.trim();
        let (at, read) = match place {
            Place::Path(key) if find(Info::PROPERTIES, key).is_some() => {
                (At::Path, read_value(key, value, self.info()))
            }
            Place::Path(key) => (At::Path, read_value(key, value, path)),
            Place::Point(at, key) => {
                let point = set::point(path, at)?;
                (At::Point(at), read_value(key, value, point))
            }
            Place::Node(at, key) => {
                let rest = &self.nodes()[at].rest;
                (At::Node(at), read_value(key, value, rest))
            }
            Place::View(Selection { point, orientation }, key) => {
                let view = set::orientation(path, point, orientation)?;
                let read = match find(Orientation::PROPERTIES, key) {
                    Some(_) => read_value(key, value, view),
                    None => read_value(key, value, &*view.own),
                };
                (At::View(point, orientation), read)
            }
        };
        let (property, value) = read.map_err(told)?;
        self.apply(Edit::set(at, property, value)).map_err(told)
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
                all.push((format!("{table}{key}"), value.to_owned()));
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

    /// The value of a property by its name, as in a file; empty if it has none.
    ///
    /// # Errors
    /// `ErrorKind::Range` if there is no such property; `ErrorKind::Memory`.
    pub fn property(&self, name: &str) -> Result<String> {
        let path = self.path();
        let (kind, value) = match self.place(name)? {
            Place::Node(at, key) => of(&self.nodes()[at].rest, key),
            Place::Point(at, key) => of(set::point(path, at)?, key),
            Place::View(at, key) => {
                let view = set::orientation(path, at.point, at.orientation)?;
                view_of(view, key)
            }
            Place::Path(key) => match key.split_once('.') {
                Some(("base_speeds", key)) => of(&path.base_frames, key),
                Some(("presets", number)) => {
                    let preset = number
                        .parse()
                        .ok()
                        .and_then(|at: usize| path.presets.get(at));
                    (Kind::Shape, preset.copied().into())
                }
                _ if find(Info::PROPERTIES, key).is_some() => of(self.info(), key),
                _ => of(path, key),
            },
        };
        Ok(if kind.has(&value) {
            value.to_string()
        } else {
            String::new()
        })
    }
}

/// A property of what has a table, and of which kind it is under this key.
fn of<T: Table>(has: &T, key: &str) -> (Kind, Value) {
    let row = find(T::PROPERTIES, key);
    row.map_or((Kind::Nested, Value::Unset), |row| {
        (row.kind(key), (row.value)(has))
    })
}

/// The same of a view, or of its custom values.
fn view_of(view: &Orientation, key: &str) -> (Kind, Value) {
    match find(Orientation::PROPERTIES, key) {
        Some(_) => of(view, key),
        None => of(&*view.own, key),
    }
}

/// Reads `key = value` as in a file; what no value of a file is, is a text. Nothing is
/// what a new one has.
fn read_value<T: Table>(key: &str, value: &str, of: &T) -> Result<(&'static str, Value)> {
    let first = key.split('.').next().unwrap_or(key);
    let row = find(T::PROPERTIES, first);
    let row = row.ok_or_else(|| no_property(key, keys::<T>()))?;
    let known = row.keys.iter().find(|known| **known == first);
    let property = known.copied().unwrap_or(row.key());
    // Where a point lies is nothing that a new one has.
    let own = row.always && !row.copied[0];
    if value.is_empty() && first == key && !own {
        return Ok((property, Value::Unset));
    }
    let new = match value {
        "" if first != key => Document::new().property(key)?,
        given => given.replace(['\n', '\r'], " "),
    };
    let as_text = || vid::value_of(&format!("{key} = {}\n", quoted(value)), of);
    let is_text = matches!(row.kind(first), Kind::Text | Kind::Choice(_));
    let read = if is_text && !value.starts_with(['"', '\'', '{']) {
        as_text()
    } else {
        // One line: more would be more keys.
        match vid::value_of(&format!("{key} = {new}\n"), of) {
            Err(Error::Format {
                cause: Malformed::Toml(_),
                ..
            }) => as_text(),
            done => done,
        }
    };
    Ok((property, read?))
}

#[cfg(test)]
#[path = "property_tests.rs"]
mod tests;
