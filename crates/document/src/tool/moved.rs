//! A ready-made move as a separate document.

use vides_engine::deform::Bounds;
use vides_engine::path::Space;
use vides_engine::tools::moves::Move;

use crate::editing::Document;
use crate::error::{Error, Result};
use crate::info::Info;

/// A path by a move in a space. Its defaults fit the object of `info`, if there is one; `put`
/// replaces those that were given. With `grows`, the space grows if the path leaves it.
///
/// # Errors
/// Those of `put` and of the move; the first value of `info` that is invalid.
pub fn moved<E: From<Error>>(
    chosen: &'static Move,
    space: Space,
    info: &Info,
    grows: bool,
    put: impl FnOnce(&mut [f64]) -> Result<(), E>,
) -> Result<Document, E> {
    // Moves use the frame rate: check it first.
    info.check(space).map_err(Error::from)?;
    let places: Vec<_> = info.object.iter().map(|point| point.position).collect();
    let bounds = (!places.is_empty()).then(|| Bounds::of(&places));
    let mut numbers = chosen
        .defaults(bounds.as_ref(), space)
        .map_err(Error::from)?;
    put(&mut numbers)?;
    let make = |space| -> Result<_> {
        Document::from_parts(chosen.path(&numbers, space, info.fps)?, info.clone())
    };
    let made = make(space)?;
    match grows && made.points_outside() > 0 {
        true => Ok(make(made.space_around_all()?)?),
        false => Ok(made),
    }
}
