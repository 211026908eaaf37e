//! Whose window it is: unsaved work is kept for that program and offered to it again.

use std::time::SystemTime;

/// The program that a window belongs to.
#[derive(Clone, Debug)]
pub struct Program {
    /// Its name, as its user knows it.
    pub name: String,
    /// It offers the unsaved work of all programs, not only its own.
    pub offers_all: bool,
    /// Marks everything as saved after a hand-over.
    pub hand_over_saves: bool,
    /// Converts to local time; `None` where that is unknown.
    pub local_time: fn(SystemTime) -> Option<Date>,
}

/// A date and a time of day.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Date {
    /// In the Gregorian calendar.
    pub year: i32,
    /// 1…12.
    pub month: i32,
    /// 1…31.
    pub day: i32,
    /// 0…23.
    pub hour: i32,
    /// 0…59.
    pub minute: i32,
}

#[cfg(test)]
impl Program {
    /// One for tests, on a day of theirs.
    pub fn of_tests(name: &str) -> Self {
        Self {
            name: name.to_owned(),
            offers_all: false,
            hand_over_saves: false,
            local_time: |_| {
                Some(Date {
                    year: 2026,
                    month: 3,
                    day: 9,
                    hour: 14,
                    minute: 5,
                })
            },
        }
    }
}
