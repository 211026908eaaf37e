//! What the times of a recording count.

use crate::error::{Result, vec_with_room};

/// Times beyond are no seconds: they would be 3,000 years.
const LATEST_SECONDS: f64 = 1e11;

/// What times count if they are too great for seconds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TimeUnit {
    /// 1e-6 s.
    Microseconds,
    /// 1e-9 s.
    Nanoseconds,
}

impl TimeUnit {
    /// The unit of times in order; none if they are seconds: the last is not beyond 1e11.
    ///
    /// A median step from 1e7 on is one of nanoseconds (100 Hz), below 1e5 of microseconds (10 Hz);
    /// between the two, times since 1970 differ by their size.
    ///
    /// # Errors
    /// [`crate::Error::Memory`].
    pub fn of(times: &[f64]) -> Result<Option<Self>> {
        let Some(&last) = times.last() else {
            return Ok(None);
        };
        if !(last.is_finite() && last > LATEST_SECONDS) {
            return Ok(None);
        }
        let mut steps: Vec<f64> = vec_with_room(times.len())?;
        steps.extend(times.windows(2).map(|pair| pair[1] - pair[0]));
        let middle = steps.len() / 2;
        let step = match steps.is_empty() {
            true => 0.0,
            false => *steps.select_nth_unstable_by(middle, f64::total_cmp).1,
        };
        let micro = step < 1e5 || step < 1e7 && (1e14..1e17).contains(&last);
        Ok(Some(if micro {
            Self::Microseconds
        } else {
            Self::Nanoseconds
        }))
    }

    /// How many seconds one is.
    pub const fn seconds(self) -> f64 {
        match self {
            Self::Microseconds => 1e-6,
            Self::Nanoseconds => 1e-9,
        }
    }

    /// Its plural.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Microseconds => "microseconds",
            Self::Nanoseconds => "nanoseconds",
        }
    }
}
