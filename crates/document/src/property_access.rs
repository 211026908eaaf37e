//! Properties by name, of paths and of scenes: set and returned in the types of programs.

use vides_engine::property::Value;
use vides_engine::scene::{Part, Rest, Values};
use vides_engine::tools::check::OFF;

use crate::edit::{At, Edit};
use crate::editing::Document;
use crate::error::Result;
use crate::info::Info;
use crate::property::{Owners, told};
use crate::scene::SceneDocument;
use crate::set;
use crate::space_table;
use crate::typed::{self, Form, Given};

/// What gets properties by name: a path, a path in its scene, a scene.
macro_rules! by_name {
    ($type:ty) => {
        /// Properties by name in the types of programs. A name is that of [`Document::set_property`].
        impl $type {
            /// The value of a property, as in a file; empty if it has none.
            ///
            /// # Errors
            /// `ErrorKind::Range` if there is no such property; `ErrorKind::Memory`.
            pub fn property(&self, name: &str) -> Result<String> {
                self.owners().text(name, false)
            }

            /// The same, where texts and names of choices are as they are, without quotes.
            ///
            /// # Errors
            /// As [`Self::property`].
            pub fn text_of(&self, name: &str) -> Result<String> {
                self.owners().text(name, true)
            }

            /// A number; none if it is not set.
            ///
            /// # Errors
            /// As [`Self::property`]; `ErrorKind::Argument` if it is something else.
            pub fn number_of(&self, name: &str) -> Result<Option<f64>> {
                let value = self.owners().formed(name, Form::Number)?;
                Ok(value.as_ref().and_then(Value::number))
            }

            /// Several numbers; none if they are not set.
            ///
            /// # Errors
            /// As [`Self::number_of`].
            pub fn numbers_of(&self, name: &str) -> Result<Vec<f64>> {
                let value = self.owners().formed(name, Form::Numbers)?;
                Ok(value.as_ref().map(typed::numbers).unwrap_or_default())
            }

            /// Whether a flag is set.
            ///
            /// # Errors
            /// As [`Self::number_of`].
            pub fn flag_of(&self, name: &str) -> Result<bool> {
                Ok(self.owners().formed(name, Form::Flag)? == Some(Value::Switch(true)))
            }
        }
    };
}

by_name!(Document);
by_name!(SceneDocument);

impl SceneDocument {
    fn owners(&self) -> Owners<'_> {
        Owners {
            path: None,
            space: self.scene.space(),
            info: &self.info,
            nodes: self.scene.nodes(),
        }
    }

    /// Sets a property by its name.
    ///
    /// # Errors
    /// As [`Document::set_value`]; the scene is as it was then.
    pub fn set_value(&mut self, name: &str, given: Given<'_>) -> Result<()> {
        let owners = self.owners();
        let place = owners.place(name)?;
        let (limit, is_space) = (place.limit(), place.is_space());
        let (at, property, mut value) = owners
            .read(place, given)
            .map_err(|error| told(name, error))?;
        if is_space {
            let space = space_table::changed(self.scene.space(), property, value)?;
            let set = self.info.check(space);
            let set = set.and_then(|()| self.scene.set_space(space));
            return set.map_err(|error| told(name, error.into()));
        }
        if let At::Node(node) = at {
            let mut rest = Box::new(Rest::of(self.scene.node(node)?));
            set::exchange(&mut rest.values, property, &mut value, &Values::NEW)?;
            let applied = rest
                .values
                .check()
                .and_then(|()| self.scene.apply(Part::Rest { node, rest }));
            return applied.map_err(|error| told(name, error.into()));
        }
        let mut info = self.info.clone();
        let checked = match limit {
            Some(kind) => info.limits.set(kind, value.number().unwrap_or(OFF)),
            None => {
                let row = set::exchange(&mut info, property, &mut value, &Info::NEW)?;
                (row.check)(&info, self.scene.space())
            }
        };
        checked.map_err(|error| told(name, error.into()))?;
        self.info = info;
        Ok(())
    }
}

impl Document {
    fn owners(&self) -> Owners<'_> {
        Owners {
            path: Some(self.path()),
            space: self.path().space,
            info: self.info(),
            nodes: self.nodes(),
        }
    }

    /// Sets a property by its name to a value as in a file; texts need no quotes, and
    /// nothing gives back what a new path has. One step.
    ///
    /// # Errors
    /// `ErrorKind::Argument` or `Range` with the name and the reason; `ErrorKind::Memory`. The
    /// path is as it was then.
    pub fn set_property(&mut self, name: &str, value: &str) -> Result<()> {
        self.set_value(name, Given::File(value))
    }

    /// Sets a property by its name, in one of the types of programs. One step.
    ///
    /// # Errors
    /// As [`Document::set_property`].
    pub fn set_value(&mut self, name: &str, given: Given<'_>) -> Result<()> {
        let owners = self.owners();
        let place = owners.place(name)?;
        let (limit, is_space) = (place.limit(), place.is_space());
        let read = owners.read(place, given);
        let (at, property, value) = read.map_err(|error| told(name, error))?;
        let edit = match limit {
            Some(kind) => {
                let mut info = self.info().clone();
                let set = info.limits.set(kind, value.number().unwrap_or(OFF));
                set.map_err(|error| told(name, error.into()))?;
                Edit::SetInfo(Box::new(info))
            }
            None if is_space => Edit::SetSpace {
                space: space_table::changed(self.path().space, property, value)?,
                fit: false,
            },
            None => Edit::set(at, property, value),
        };
        self.apply(edit).map_err(|error| told(name, error))
    }
}
