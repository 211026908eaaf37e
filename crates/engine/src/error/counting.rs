//! How a sentence counts what the library counts from 0, and what it calls things. People see points and orientations
//! numbered from 1 in the window and the command; a C program counts its arrays from 0. (What has
//! a number only there or in files, as nodes and the points of a mesh, says "counted from 0" to
//! everybody.)
//!
//! Errors hold indices from 0 and are put into words once, by [`Index`]. How it counts is known
//! only where the sentence is read, and formatters of nested errors hand no flag down: so
//! [`FromZero`] tells the thread for as long as it writes.

use std::cell::Cell;
use std::fmt;

#[derive(Clone, Copy)]
enum Counting {
    FromOne,
    /// And whether the sentence has named it.
    FromZero(bool),
}

thread_local! {
    static COUNTING: Cell<Counting> = const { Cell::new(Counting::FromOne) };
}

/// An index, from 0, in a sentence: counted from 1, or as [`FromZero`] says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Index(pub usize);

impl fmt::Display for Index {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match COUNTING.get() {
            Counting::FromOne => self.0.saturating_add(1).fmt(f),
            Counting::FromZero(true) => self.0.fmt(f),
            Counting::FromZero(false) => {
                COUNTING.set(Counting::FromZero(true));
                write!(f, "{} (counted from 0)", self.0)
            }
        }
    }
}

/// What people call something, and what the header of the C interface does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Called(pub &'static str, pub &'static str);

impl fmt::Display for Called {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match COUNTING.get() {
            Counting::FromOne => self.0,
            Counting::FromZero(_) => self.1,
        })
    }
}

/// Where something stands in an array of a C program, before a sentence about it; people have no
/// such array.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Entry(pub &'static str, pub usize);

impl fmt::Display for Entry {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match COUNTING.get() {
            Counting::FromOne => Ok(()),
            Counting::FromZero(_) => write!(f, "{}[{}]: ", self.0, self.1),
        }
    }
}

/// A sentence for those who count from 0, which it says at the first number that it counts so.
#[derive(Clone, Copy, Debug)]
pub struct FromZero<T>(pub T);

impl<T: fmt::Display> fmt::Display for FromZero<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        struct Before(Counting);
        impl Drop for Before {
            fn drop(&mut self) {
                COUNTING.set(self.0);
            }
        }
        let _before = Before(COUNTING.replace(Counting::FromZero(false)));
        self.0.fmt(f)
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Error, OutOfRange, Place};
    use super::*;

    #[test]
    fn people_count_from_1_and_programs_from_0() {
        let error = Error::from(OutOfRange::Hold)
            .at(Place::Orientation(1))
            .at(Place::Point(2));
        let hold = "the hold must lie between 0 and 1000000 frames";
        let people = format!("point 3: orientation 2: {hold}");
        assert_eq!(error.to_string(), people);
        assert_eq!(
            FromZero(&error).to_string(),
            "point 2 (counted from 0): orientation 1: hold must lie between 0 and 1000000 frames"
        );
        assert_eq!(error.to_string(), people);
        let missing = OutOfRange::NoPoint { point: 4, last: 3 };
        assert_eq!(
            FromZero(&missing).to_string(),
            "there is no point 4 (counted from 0): the path has points 0 to 3"
        );
        assert_eq!(
            missing.to_string(),
            "there is no point 5: the path has points 1 to 4"
        );
    }
}
