//! Files that are replaced only when they are whole, written with our errors.

use std::io::Write;
use std::path::Path;

use vides_document::error::EngineError;
use vides_document::{Error as DocumentError, save};

use super::error::{Error, Result};

/// [`save::save_with`] for what writes with our errors.
pub(super) fn save_with(
    file: &Path,
    write: &mut dyn FnMut(&mut dyn Write) -> Result<()>,
) -> Result<()> {
    saved(|failure| {
        save::save_with(file, &mut |out| {
            write(out).map_err(|error| kept(failure, error))
        })
    })
}

/// Saves with what fails by our errors, which are kept aside.
pub(super) fn saved(
    save: impl FnOnce(&mut Option<Error>) -> Result<(), DocumentError>,
) -> Result<()> {
    let mut failure = None;
    let saved = save(&mut failure);
    match failure {
        Some(error) => Err(error),
        None => Ok(saved?),
    }
}

pub(super) fn kept(failure: &mut Option<Error>, error: Error) -> DocumentError {
    match error {
        Error::Document(error) => error,
        other => {
            *failure = Some(other);
            EngineError::Memory.into()
        }
    }
}
