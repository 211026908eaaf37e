//! The text of an error: a sentence with places for values, and the values.
//!
//! It is English as it stands. Kept apart, so that whoever shows it to a person
//! can say the same sentence in another language: the sentence itself, with its
//! `{0}` and `{1}`, is what it is found by. A message that can reach a person in
//! a window is written by [`message!`](crate::error::message); the others need
//! no translation.

use std::borrow::Cow;
use std::fmt::{self, Write};

/// The text of an error. Without values it is a fixed text mostly, so that
/// failing costs no memory.
#[derive(Clone, Debug, PartialEq)]
pub struct Message {
    sentence: Cow<'static, str>,
    /// In the places of `{0}`, `{1}` …; without any the sentence stands as it is.
    values: Vec<Part>,
}

/// A value in a message.
#[derive(Clone, Debug, PartialEq)]
pub struct Part(#[doc(hidden)] pub Kind);

/// What a value is, for those who translate.
#[derive(Clone, Debug, PartialEq)]
pub enum Kind {
    /// A whole number.
    Whole(i128),
    /// Any number.
    Number(f64),
    /// A name or a text from elsewhere: the same in every language.
    Name(String),
    /// A sentence, or a part of one.
    Message(Message),
}

impl Message {
    /// A sentence with values. Where there is no memory left for them, one that
    /// says so: a wrong index must not end a program that has run out of it.
    #[doc(hidden)]
    #[must_use]
    pub fn with<const N: usize>(sentence: &'static str, values: [Part; N]) -> Self {
        let mut room = Vec::new();
        if room.try_reserve_exact(N).is_err() {
            return NO_MEMORY;
        }
        room.extend(values);
        Self {
            sentence: Cow::Borrowed(sentence),
            values: room,
        }
    }

    /// The sentence with its places, English.
    #[doc(hidden)]
    #[must_use]
    pub fn sentence(&self) -> &str {
        &self.sentence
    }

    /// What stands in its places.
    #[doc(hidden)]
    #[must_use]
    pub fn values(&self) -> &[Part] {
        &self.values
    }
}

/// A message for those who read English: programs, and whoever has no window.
#[must_use]
pub fn sentence(words: fmt::Arguments<'_>) -> Message {
    written(words).map_or(NO_MEMORY, Message::from)
}

const NO_MEMORY: Message = Message {
    sentence: Cow::Borrowed("not as it must be; there is no memory left to say more"),
    values: Vec::new(),
};

/// A text, if there is memory for it.
fn written(words: fmt::Arguments<'_>) -> Option<String> {
    struct Text(String);
    impl Write for Text {
        fn write_str(&mut self, s: &str) -> fmt::Result {
            self.0.try_reserve(s.len()).map_err(|_| fmt::Error)?;
            self.0.push_str(s);
            Ok(())
        }
    }
    let mut text = Text(String::new());
    fmt::write(&mut text, words).ok().map(|()| text.0)
}

/// Writes a sentence with `value` called for each of its places: `{0}` is the
/// first one. A place that is none stays as it is.
pub fn fill<W: Write + ?Sized>(
    out: &mut W,
    sentence: &str,
    mut value: impl FnMut(&mut W, usize) -> fmt::Result,
) -> fmt::Result {
    let mut rest = sentence;
    while let Some((before, behind)) = rest.split_once('{') {
        out.write_str(before)?;
        let place = behind
            .split_once('}')
            .and_then(|(number, after)| Some((number.parse().ok()?, after)));
        if let Some((at, after)) = place {
            value(out, at)?;
            rest = after;
        } else {
            out.write_char('{')?;
            rest = behind;
        }
    }
    out.write_str(rest)
}

impl fmt::Display for Message {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.values.is_empty() {
            return f.write_str(&self.sentence);
        }
        fill(f, &self.sentence, |f, at| match self.values.get(at) {
            Some(part) => part.fmt(f),
            None => Ok(()),
        })
    }
}

impl fmt::Display for Part {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.0 {
            Kind::Whole(number) => number.fmt(f),
            Kind::Number(number) => number.fmt(f),
            Kind::Name(name) => f.write_str(name),
            Kind::Message(message) => message.fmt(f),
        }
    }
}

impl From<&'static str> for Message {
    fn from(sentence: &'static str) -> Self {
        Self {
            sentence: Cow::Borrowed(sentence),
            values: Vec::new(),
        }
    }
}

impl From<String> for Message {
    fn from(words: String) -> Self {
        Self {
            sentence: Cow::Owned(words),
            values: Vec::new(),
        }
    }
}

impl From<Message> for Part {
    fn from(message: Message) -> Self {
        Self(Kind::Message(message))
    }
}

impl From<&str> for Part {
    fn from(name: &str) -> Self {
        let copy = written(format_args!("{name}"));
        Self(Kind::Name(copy.unwrap_or_default()))
    }
}

impl From<String> for Part {
    fn from(name: String) -> Self {
        Self(Kind::Name(name))
    }
}

impl From<f64> for Part {
    fn from(number: f64) -> Self {
        Self(Kind::Number(number))
    }
}

macro_rules! whole {
    ($($type:ty),*) => {$(
        impl From<$type> for Part {
            fn from(number: $type) -> Self {
                // No type of these has more than 64 bits.
                Self(Kind::Whole(number as i128))
            }
        }
    )*};
}
whole!(i32, u32, i64, u64, usize);

#[cfg(test)]
mod tests {
    use super::*;
    use crate::error::message;

    #[test]
    fn values_stand_in_their_places() {
        let inner = message!("{0} of {1}", 3_usize, "a {0}");
        assert_eq!(inner.to_string(), "3 of a {0}");
        let outer = message!("{1}: {0}; {x} {2}{", inner, -1.5, 7_u32);
        assert_eq!(outer.to_string(), "-1.5: 3 of a {0}; {x} 7{");
        assert_eq!(message!("{0} {9}", 1_i32).to_string(), "1 ");
    }

    #[test]
    fn without_values_a_sentence_stands_as_it_is() {
        assert_eq!(Message::from("a {0}").to_string(), "a {0}");
        assert_eq!(Message::from("b {1}".to_owned()).to_string(), "b {1}");
        assert_eq!(sentence(format_args!("{}{{", 1)).to_string(), "1{");
    }
}
