//! What is dragged along the time.

use crate::space::typed::Typed;

/// What is held, and how far it has gone.
#[derive(Debug)]
pub(crate) struct Drag<T> {
    pub(crate) of: T,
    /// What it is called.
    pub name: String,
    /// The scene's frame at which what was taken stood.
    pub(crate) from: f64,
    /// The pointer of the last pass, and the frames that it went.
    pub(crate) pointer: f32,
    pub(crate) gone: f64,
    pub(crate) typed: Typed,
    /// Ctrl is held, or was when a number was typed.
    pub(crate) copies: bool,
}
