//! Names and lists of names in sentences.

use std::fmt::{self, Write as _};

/// A name or another text from elsewhere; empty where there is no memory left for a copy.
#[derive(Debug, PartialEq, Eq)]
pub struct Text(String);

impl<T: fmt::Display + ?Sized> From<&T> for Text {
    fn from(text: &T) -> Self {
        struct Copy(String);
        impl fmt::Write for Copy {
            fn write_str(&mut self, s: &str) -> fmt::Result {
                for sign in s.chars() {
                    // A name from a file may hold control characters; the sentence is one line.
                    let sign = if sign.is_control() {
                        char::REPLACEMENT_CHARACTER
                    } else {
                        sign
                    };
                    let room = sign.len_utf8();
                    self.0.try_reserve(room).map_err(|_| fmt::Error)?;
                    self.0.push(sign);
                }
                Ok(())
            }
        }
        let mut copy = Copy(String::new());
        let written = write!(copy, "{text}");
        Self(written.map_or_else(|_| String::new(), |()| copy.0))
    }
}

impl Clone for Text {
    fn clone(&self) -> Self {
        self.into()
    }
}

impl fmt::Display for Text {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

/// Names, or what else there is to choose, joined by commas.
#[doc(hidden)]
#[derive(Clone, Debug)]
pub struct List<I>(pub I);

impl<I: Iterator<Item: fmt::Display> + Clone> fmt::Display for List<I> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (at, item) in self.0.clone().enumerate() {
            let comma = if at == 0 { "" } else { ", " };
            write!(f, "{comma}{item}")?;
        }
        Ok(())
    }
}
