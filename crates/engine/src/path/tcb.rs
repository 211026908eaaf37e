//! Tension, continuity and bias (Kochanek and Bartels).

use super::checks::check_shape;
use crate::error::{Quantity, Result};
use crate::property::same_bits::SameBits;

/// Tension, continuity and bias, each in [−1, 1] (Kochanek and Bartels 1984;
/// thesis 3.6.2, where tension is called a).
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Tcb {
    /// −1 round, 0 normal, 1 tight.
    pub tension: f64,
    /// −1 corner, 0 smooth, 1 inverted corner.
    pub continuity: f64,
    /// −1 turns before the point, 0 even, 1 turns after it ("overshoot").
    pub bias: f64,
}

impl Tcb {
    /// The three values in the order of their name.
    #[must_use]
    pub const fn new(tension: f64, continuity: f64, bias: f64) -> Self {
        Self {
            tension,
            continuity,
            bias,
        }
    }

    /// Checks that each is in [−1, 1].
    ///
    /// # Errors
    /// [`crate::Error::Range`] names the value that is not.
    pub fn check(self) -> Result<()> {
        check_shape(self.tension, Quantity::Tension)?;
        check_shape(self.continuity, Quantity::Continuity)?;
        check_shape(self.bias, Quantity::Bias)
    }
}

impl SameBits for Tcb {
    fn same_bits(&self, other: &Self) -> bool {
        let numbers = |tcb: &Self| [tcb.tension, tcb.continuity, tcb.bias];
        numbers(self).same_bits(&numbers(other))
    }
}
