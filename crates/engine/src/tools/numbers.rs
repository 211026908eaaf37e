//! The numbers that are given to a tool, checked.

use super::parameter::Parameter;
use crate::error::{Invalid, OutOfRange, Result, vec_with_room};

impl Parameter {
    /// Checks one of its numbers for a space of this `half_size`.
    ///
    /// # Errors
    /// [`crate::Error::Argument`] if it is not finite, [`crate::Error::Range`].
    pub fn check(&self, number: f64, half_size: f64) -> Result<()> {
        if !number.is_finite() {
            return Err(Invalid::NumberNotFinite(self.name).into());
        }
        let [least, most] = [self.least, self.most].map(|bound| bound * self.scale(half_size));
        if !(least..=most).contains(&number) {
            let [least, most] = [inwards(least, f64::ceil), inwards(most, f64::floor)];
            return Err(OutOfRange::NumberBetween(self.name, least, most).into());
        }
        Ok(())
    }

    /// All numbers of a tool in a space of this `half_size`, checked: those given, in the order of
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

/// A bound as a person reads it: rounded to three digits by `round`, which leads into the range.
fn inwards(bound: f64, round: fn(f64) -> f64) -> f64 {
    let digits = 2.0 - bound.abs().log10().floor();
    // A power of ten above 1 is exact, one below it is not.
    let power = 10f64.powf(digits.abs());
    let whole = if digits < 0.0 {
        bound / power
    } else {
        bound * power
    };
    let is_short = (whole - whole.round()).abs() <= 1e-9 * whole.abs();
    if is_short || !power.is_finite() {
        return bound;
    }
    let rounded = round(whole);
    if digits < 0.0 {
        rounded * power
    } else {
        rounded / power
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tools::parameter::Unit;

    /// Bounds of a length in a space of any size have three digits, and lie within the range.
    #[test]
    fn bounds_in_an_error_are_short_and_valid() {
        let parameter = Parameter {
            name: "tolerance",
            does: "",
            unit: Unit::Length,
            width: 1,
            least: 2e-5,
            most: 1e3,
            default: 1e-3,
        };
        for (half_size, words) in [
            (
                4_170.837_504_171,
                "tolerance must lie between 0.0835 and 4170000",
            ),
            (1.0, "tolerance must lie between 0.00002 and 1000"),
            (33.3333, "tolerance must lie between 0.000667 and 33300"),
        ] {
            let refused = parameter.check(0.0, half_size).expect_err("below");
            assert_eq!(refused.to_string(), words);
            for bound in words.split(' ').filter_map(|word| word.parse::<f64>().ok()) {
                assert!(parameter.check(bound, half_size).is_ok(), "{bound}");
            }
        }
    }
}
