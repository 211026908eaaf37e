//! Properties by name: `point.2.zoom = 30` is the zoom of the first view of the second point,
//! `point.2.view.3.zoom` that of its third, `fps` that of the whole file. Keys are those of a
//! `.vid` file, and need not have the unit at their end.

use vides_engine::property::find;

use crate::editing::{Document, Selection};
use crate::error::{Error, Malformed, Refused, Result};
use crate::info::{Info, Object};
use crate::path::{CameraPath, CurveParameters, Orientation, OrientationOverrides, Overrides};
use crate::prepare;
use crate::vid::{self, PATH_KEYS, POINT_KEYS, view_keys};
use crate::{Edit, vid::quoted};

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

/// What stands where a file says nothing.
const UNSAID: [(&str, &str); 4] = [
    ("title", "\"\""),
    ("comment", "\"\""),
    ("curve", "\"tcb\""),
    ("up", "\"axis\""),
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
    if let Some(key) = full(POINT_KEYS.into_iter(), key) {
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
                let presets = new.presets.into_iter().enumerate();
                let presets = presets.map(|(preset, tcb)| Edit::SetPreset { preset, tcb });
                let others = [
                    Edit::SetClosed(new.closed),
                    Edit::SetCurveKind(new.curve),
                    Edit::SetModes(new.orientation_mode, new.zoom_mode),
                    Edit::SetBaseFrames(new.base_frames),
                ];
                let told = (info != *self.info()).then(|| Edit::SetInfo(Box::new(info)));
                self.apply_all(others.into_iter().chain(told).chain(presets))
            }
            Place::Point(at, key) => {
                let mut new = prepare::point(path, at)?.clone();
                // A position has no value that it had when it was new.
                if value.is_empty() && key != "position" {
                    match key {
                        "name" => new.name = None,
                        "tangents" => new.tangents = None,
                        "preset" | "own" => new.curve = CurveParameters::Preset(0),
                        _ => {}
                    }
                } else {
                    let read = |text: &str| vid::change_point(text, &mut new, path.space);
                    read_value(key, value, read).map_err(told)?;
                }
                self.apply(match (key, new.curve) {
                    ("name", _) => Edit::SetName { at, name: new.name },
                    ("tangents", _) => Edit::SetTangents {
                        at,
                        tangents: new.tangents,
                    },
                    ("position", _) => Edit::SetPosition {
                        at,
                        position: new.position,
                    },
                    (_, CurveParameters::Own(tcb)) => Edit::SetOwn { at, tcb },
                    (_, CurveParameters::Preset(preset)) => Edit::UsePreset {
                        at,
                        preset: preset.into(),
                    },
                })
            }
            Place::View(Selection { point, orientation }, key) => {
                let position = prepare::point(path, point)?.position;
                let mut new = prepare::orientation(path, point, orientation)?.clone();
                if value.is_empty() {
                    let fresh = Orientation::new_in(path.space);
                    if let Some(row) = find(Orientation::PROPERTIES, key) {
                        (row.take)(&mut new, &fresh);
                    } else if let Some(row) = find(OrientationOverrides::PROPERTIES, key) {
                        new.own = new.own.with(|own| (row.take)(own, &Overrides::NOTHING))?;
                    }
                } else {
                    let read = |text: &str| vid::change_view(text, &mut new, position, path.space);
                    read_value(key, value, read).map_err(told)?;
                }
                // Aiming at something ends looking along the path.
                if matches!(key, "target" | "offset") {
                    new.own = new.own.with(|own| own.ahead = None)?;
                }
                self.apply(Edit::SetOrientation {
                    point,
                    at: orientation,
                    orientation: new,
                })
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
        let (full, key) = match place(name)? {
            Place::Path(key) => (key.to_owned(), key),
            Place::Point(at, key) => {
                prepare::point(self.path(), at)?;
                (format!("point.{}.{key}", at + 1), key)
            }
            Place::View(at, key) => {
                let view = prepare::orientation(self.path(), at.point, at.orientation)?;
                if let Some(value) =
                    find(Orientation::PROPERTIES, key).and_then(|row| (row.value)(view))
                {
                    return Ok(value.to_string());
                }
                if let Some(value) = find(OrientationOverrides::PROPERTIES, key)
                    .and_then(|row| (row.value)(&view.own))
                {
                    return Ok(value.to_string());
                }
                let (point, view) = (at.point + 1, at.orientation + 1);
                (format!("point.{point}.view.{view}.{key}"), key)
            }
        };
        let found = self
            .properties()?
            .into_iter()
            .find(|(name, _)| *name == full);
        let unsaid = || UNSAID.iter().find(|(known, _)| *known == key);
        Ok(match found {
            Some((_, value)) => value,
            None => unsaid().map_or(String::new(), |(_, value)| (*value).to_owned()),
        })
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
