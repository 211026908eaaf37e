//! Whose window it is: unsaved work is kept for that program and offered to it again.

use std::time::SystemTime;

/// The program that a window belongs to.
#[derive(Clone, Debug)]
pub(crate) struct Program {
    /// Its name, as its user knows it.
    pub(crate) name: String,
    /// It offers the unsaved work of all programs, and not only its own.
    pub(crate) offers_all: bool,
    /// After a hand-over nothing is unsaved: the program has it.
    pub(crate) hand_over_saves: bool,
    /// A time as a clock on the wall shows it; none where nobody can tell.
    pub(crate) local_time: fn(SystemTime) -> Option<Date>,
}

/// A day and a time of day.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Date {
    pub(crate) year: i32,
    /// 1…12.
    pub(crate) month: i32,
    /// 1…31.
    pub(crate) day: i32,
    pub(crate) hour: i32,
    pub(crate) minute: i32,
}

#[cfg(test)]
impl Program {
    /// One for tests, on a day of theirs.
    pub(crate) fn of_tests(name: &str) -> Self {
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
