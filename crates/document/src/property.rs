//! Properties by name: `point.2.zoom = 30` is the zoom of the first view of the second point,
//! `point.2.view.3.zoom` that of its third, `fps` that of the whole file. Keys are those of a
//! `.vid` file, and need not have the unit at their end.

use vides_engine::property::{Kind, Listed, Owner, Table, Value, find, list};

use crate::edit::{At, Edit};
use crate::editing::{Document, Selection};
use crate::error::{Error, Malformed, Refused, Result};
use crate::info::{Info, Object};
use crate::path::{CameraPath, Orientation, OrientationOverrides, SupportPoint};
use crate::prepare;
use crate::vid::{self, PATH_KEYS, point_keys, quoted, view_keys};

/// What is known of all properties, key by key in the order of files.
#[must_use]
pub fn properties() -> Vec<Listed> {
    let mut all = Vec::new();
    list(Owner::Path, &Info::NEW, &mut all);
    list(Owner::Path, &CameraPath::NEW, &mut all);
    list(Owner::Point, &SupportPoint::NEW, &mut all);
    list(Owner::View, &Orientation::NEW, &mut all);
    list(Owner::View, &OrientationOverrides::NEW, &mut all);
    all
}

/// What a name leads to.
enum Place<'a> {
    Path(&'a str),
    Point(usize, &'static str),
    View(Selection, &'static str),
}

/// Keys whose values are texts, which need no quotes in a value that is set.
const TEXTS: [&str; 7] = [
    "title",
    "comment",
    "name",
    "curve",
    "orientation_mode",
    "zoom_mode",
    "up",
];

/// The key that is meant: itself, or that which has a unit besides.
fn full(mut known: impl Iterator<Item = &'static str>, key: &str) -> Option<&'static str> {
    let units = ["_mm", "_degrees", "_frames"];
    known.find(|&known| {
        let bare = units.iter().find_map(|unit| known.strip_suffix(unit));
        known == key || bare == Some(key)
    })
}

fn place(name: &str) -> Result<Place<'_>> {
    let none = || Error::from(Refused::NoProperty((&name.escape_debug()).into()));
    let number = |text: &str| match text.parse::<usize>() {
        Ok(number) => number.checked_sub(1),
        Err(_) => None,
    };
    let Some(rest) = name.strip_prefix("point.") else {
        let key = name.split('.').next().unwrap_or(name);
        return match PATH_KEYS.contains(&key) {
            true => Ok(Place::Path(name)),
            false => Err(none()),
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
    /// Sets a property by its name to a value as it stands in a file; texts need no quotes, and
    /// nothing gives back what a new path has. One step.
    ///
    /// # Errors
    /// `ErrorKind::Argument` or `Range` with the name and the reason; `ErrorKind::Memory`. The
    /// path is as it was then.
    pub fn set_property(&mut self, name: &str, value: &str) -> Result<()> {
        let (place, value) = (place(name)?, value.trim());
        let told = |error| match error {
            Error::Format { cause, .. } => Error::Property {
                name: (&name).into(),
                cause,
            },
            other => other,
        };
        let path = self.path();
        match place {
            Place::Path(key) => {
                let mut info = self.info().clone();
                let mut new = CameraPath {
                    points: Vec::new(),
                    ..*path
                };
                let read = |text: &str| vid::change_path(text, &mut new, &mut info);
                let new_value = match value {
                    "" => Self::new().property(key)?,
                    given => given.to_owned(),
                };
                read_value(key, &new_value, read).map_err(told)?;
                let key = key.split('.').next().unwrap_or(key);
                let info = find(Info::PROPERTIES, key).map(|row| (row.key(), (row.value)(&info)));
                let path = find(CameraPath::PROPERTIES, key);
                let path = path.map(|row| (row.key(), (row.value)(&new)));
                let (key, value) = info.or(path).unwrap_or((TEXTS[0], Value::Unset));
                self.apply(Edit::set(At::Path, key, value))
            }
            Place::Point(at, key) => {
                let mut new = prepare::point(path, at)?.clone();
                let row = find(SupportPoint::PROPERTIES, key);
                // A position has no value that it had when it was new.
                let value = if value.is_empty() && key != "position" {
                    Value::Unset
                } else {
                    let read = |text: &str| vid::change_point(text, &mut new, path.space);
                    read_value(key, value, read).map_err(told)?;
                    row.map_or(Value::Unset, |row| (row.value)(&new))
                };
                self.apply(Edit::set(At::Point(at), key, value))
            }
            Place::View(Selection { point, orientation }, key) => {
                let position = prepare::point(path, point)?.position;
                let mut new = prepare::orientation(path, point, orientation)?.clone();
                let value = if value.is_empty() {
                    Value::Unset
                } else {
                    let read = |text: &str| vid::change_view(text, &mut new, position, path.space);
                    read_value(key, value, read).map_err(told)?;
                    view_of(&new, key).1
                };
                self.apply(Edit::set(At::View(point, orientation), key, value))
            }
        }
    }

    /// All properties by their full names, each with its value as it stands in a file; those that
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
        if !self.info().comment.is_empty() {
            all.push(("comment".to_owned(), quoted(&self.info().comment)));
        }
        Ok(all)
    }

    /// The value of a property by its name, as it stands in a file; empty if it has none.
    ///
    /// # Errors
    /// `ErrorKind::Range` if there is no such property; `ErrorKind::Memory`.
    pub fn property(&self, name: &str) -> Result<String> {
        let path = self.path();
        let (kind, value) = match place(name)? {
            Place::Point(at, key) => of(prepare::point(path, at)?, key),
            Place::View(at, key) => {
                let view = prepare::orientation(path, at.point, at.orientation)?;
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

/// The same of a view, or of what it has of its own.
fn view_of(view: &Orientation, key: &str) -> (Kind, Value) {
    match find(Orientation::PROPERTIES, key) {
        Some(_) => of(view, key),
        None => of(&*view.own, key),
    }
}

/// Reads `key = value` as it stands in a file; what no value of a file is, is a text.
fn read_value(key: &str, value: &str, mut read: impl FnMut(&str) -> Result<()>) -> Result<()> {
    let as_text = format!("{key} = {}\n", quoted(value));
    let is_text = TEXTS.contains(&key.rsplit('.').next().unwrap_or(key));
    if is_text && !value.starts_with(['"', '\'', '{']) {
        return read(&as_text);
    }
    // One line: more would be more keys.
    match read(&format!("{key} = {}\n", value.replace(['\n', '\r'], " "))) {
        Err(Error::Format {
            cause: Malformed::Toml(_),
            ..
        }) => read(&as_text),
        done => done,
    }
}

#[cfg(test)]
#[path = "property_tests.rs"]
mod tests;
