//! Interpolations of the host's (the article's exchangeable library), for every scene: `host:NAME`.

use std::sync::{Arc, PoisonError, RwLock};

use crate::error::{Invalid, Result, TooMany, can_allocate};
use crate::limits;
use crate::path::camera_path::check_name;

/// What such a function is asked.
#[derive(Debug, Clone, Copy)]
pub struct Question<'a> {
    /// The frames of the keys, strictly increasing.
    pub frames: &'a [f64],
    /// Their values, key by key.
    pub values: &'a [f64],
    /// Numbers of each key.
    pub width: usize,
    /// A frame between the first and the last one.
    pub frame: f64,
}

/// Fills in the value at a frame; false if it cannot.
pub type Function = dyn Fn(Question<'_>, &mut [f64]) -> bool + Send + Sync;

static FUNCTIONS: RwLock<Vec<(String, Arc<Function>)>> = RwLock::new(Vec::new());

/// Registers a function as `host:NAME`, or removes it. An evaluation may still call the old one.
///
/// # Errors
/// [`crate::Error::Argument`] for the name, [`crate::Error::Limit`], [`crate::Error::Memory`].
pub fn register(name: &str, function: Option<Arc<Function>>) -> Result<()> {
    check_function_name(name)?;
    can_allocate(name.len())?;
    let mut all = FUNCTIONS.write().unwrap_or_else(PoisonError::into_inner);
    let known = all.iter().position(|(known, _)| known == name);
    // Dropped after the lock is released: what it owns may call this again.
    let old = match (known, function) {
        (Some(at), Some(function)) => Some(std::mem::replace(&mut all[at].1, function)),
        (Some(at), None) => Some(all.remove(at).1),
        (None, None) => None,
        (None, Some(_)) if all.len() >= limits::MAX_INTERPOLATIONS => {
            return Err(TooMany::Interpolations.into());
        }
        (None, Some(function)) => {
            all.try_reserve(1)?;
            all.push((name.to_owned(), function));
            None
        }
    };
    drop(all);
    drop(old);
    Ok(())
}

/// The names of those that are registered, in alphabetical order.
#[must_use]
pub fn names() -> Vec<String> {
    let all = FUNCTIONS.read().unwrap_or_else(PoisonError::into_inner);
    let mut names: Vec<String> = all.iter().map(|(name, _)| name.clone()).collect();
    names.sort_unstable();
    names
}

pub(super) fn function(name: &str) -> Option<Arc<Function>> {
    let all = FUNCTIONS.read().unwrap_or_else(PoisonError::into_inner);
    let (_, function) = all.iter().find(|(known, _)| known == name)?;
    Some(Arc::clone(function))
}

pub(super) fn check_function_name(name: &str) -> Result<()> {
    check_name(name)?;
    if name.is_empty() {
        return Err(Invalid::InterpolationWithoutName.into());
    }
    Ok(())
}
