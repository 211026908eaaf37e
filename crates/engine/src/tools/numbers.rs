//! The numbers that are given to a tool, checked.

use super::parameter::Parameter;
use crate::error::{Invalid, OutOfRange, Result, vec_with_room};

impl Parameter {
    /// Checks one of its numbers for a space of such a half size.
    ///
    /// # Errors
    /// [`crate::Error::Argument`] if it is not finite, [`crate::Error::Range`].
    pub fn check(&self, number: f64, half_size: f64) -> Result<()> {
        if !number.is_finite() {
            return Err(Invalid::NumberNotFinite(self.name).into());
        }
        let [least, most] = [self.least, self.most].map(|bound| bound * self.scale(half_size));
        if !(least..=most).contains(&number) {
            return Err(OutOfRange::NumberBetween(self.name, least, most).into());
        }
        Ok(())
    }

    /// All numbers of a tool in a space of such a half size, checked: those given, in the order of
    /// its table, then defaults.
    ///
    /// # Errors
    /// As [`Parameter::check`]; [`crate::Error::Range`] for too many; [`crate::Error::Memory`].
    pub fn numbers(all: &[Self], given: &[f64], half_size: f64) -> Result<Vec<f64>> {
        let count = Self::count(all);
        if given.len() > count {
            return Err(OutOfRange::NumbersGiven {
                given: given.len(),
                most: count,
            }
            .into());
        }
        let mut numbers = vec_with_room(count)?;
        numbers.extend_from_slice(given);
        let mut start = 0;
        for parameter in all {
            let end = start + parameter.width;
            while numbers.len() < end {
                numbers.push(parameter.default * parameter.scale(half_size));
            }
            numbers[start..end]
                .iter()
                .try_for_each(|number| parameter.check(*number, half_size))?;
            start = end;
        }
        Ok(numbers)
    }
}
