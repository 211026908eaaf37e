//! Arc length of a cubic and its inverse (thesis 5.1; SPEC 2.4).

use super::hermite::Cubic;
use crate::error::Result;

/// A cubic together with its arc length.
#[derive(Debug, Clone)]
pub struct ArcLength {}

impl ArcLength {
    /// Measures a curve.
    pub fn new(_curve: &Cubic) -> Result<Self> {
        unimplemented!()
    }
    /// The whole length.
    pub fn length(&self) -> f64 {
        unimplemented!()
    }
    /// Length from the start to the parameter `t` in [0, 1].
    pub fn length_at(&self, _t: f64) -> f64 {
        unimplemented!()
    }
    /// Parameter at which the length from the start is `s`.
    pub fn parameter_at(&self, _s: f64) -> f64 {
        unimplemented!()
    }
}
