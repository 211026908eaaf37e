//! Faults in a host's options that VIDES corrected.

use std::fmt;
use std::sync::Arc;

use vides_document::error::{EngineError, Error, Text};

/// One thing that was wrong.
#[derive(Clone, Debug, thiserror::Error)]
pub enum Warning {
    /// The points of an object are not numbered 1, 2, 3 ….
    #[error("point {place} of the object has the number {number}; the order of the array counts")]
    Misnumbered {
        /// Which one, counted from 1.
        place: i32,
        /// Its number.
        number: i32,
    },
    /// A base speed is not finite or not positive.
    #[error("{name} is {given} and must be finite and greater than 0: {taken} is taken")]
    Speed {
        /// The host's name for it.
        name: &'static str,
        /// What the host gave.
        given: f64,
        /// What is taken in its place.
        taken: f64,
    },
    /// The object cannot be shown.
    #[error("the object is not shown: {0}")]
    NotShown(EngineError),
    /// The object cannot be read; only programs get the reason.
    #[error("the object is not shown: {0}")]
    NotRead(Text),
    /// What was wrong with a mesh of a scene.
    #[error(transparent)]
    Mesh(Arc<Error>),
}

/// Everything that was wrong, as one sentence.
#[derive(Clone, Debug, Default)]
pub struct Warnings(Vec<Warning>);

impl Warnings {
    /// Adds one, if there is memory for it.
    pub fn add(&mut self, warning: Warning) {
        if self.0.try_reserve(1).is_ok() {
            self.0.push(warning);
        }
    }

    /// Adds what was wrong with the meshes of a scene.
    pub fn add_meshes(&mut self, errors: Vec<Error>) {
        let errors = errors.into_iter().map(Arc::new);
        errors.for_each(|error| self.add(Warning::Mesh(error)));
    }

    /// Whether nothing was wrong.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Files that were not read since they lie outside the folder of the file that names them.
    pub(crate) fn outside(&self) -> impl Iterator<Item = String> {
        self.0.iter().filter_map(|warning| match warning {
            Warning::Mesh(error) => error.outside().map(ToString::to_string),
            _ => None,
        })
    }

    pub(crate) fn iter(&self) -> impl Iterator<Item = &Warning> {
        self.0.iter()
    }
}

impl fmt::Display for Warnings {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (at, warning) in self.0.iter().enumerate() {
            let between = if at == 0 { "" } else { "; " };
            write!(f, "{between}{warning}")?;
        }
        Ok(())
    }
}
