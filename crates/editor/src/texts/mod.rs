//! Every word that the window shows, German and English.
//!
//! One file for each panel and sub-window, and each text with its translation on the next line, so
//! that neither is forgotten. `{0}`, `{1}` … stand for values; [`fill`] puts them in.
//!
//! ```text
//! texts! {
//!     Space {
//!         whole_meaning: "See all of it as at first",
//!             "Alles sehen wie am Anfang";
//!     }
//! }
//! ```
//!
//! The library's own sentences are English; `german` and `german_files` translate its errors.

use std::fmt::{Display, Write};

mod ambiguities;
mod check;
mod colours;
mod compare;
mod curve;
mod display;
mod errors;
mod files;
mod fit;
pub(crate) mod formats;
mod german;
mod german_files;
mod help;
mod menu;
mod menu_hints;
mod node;
mod orientation;
mod output;
mod points_list;
mod position;
mod questions;
mod recovery;
pub(crate) mod refusals;
mod scene;
mod setup;
mod space;
mod space_window;
mod speed_window;
mod steps;
mod timeline;
mod timing;
mod tools;
mod zoom;

/// The window's language.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Language {
    /// English.
    #[default]
    English,
    /// German.
    German,
}

impl Language {
    /// The environment's language: the first of `LC_ALL`, `LC_MESSAGES`, `LANG` not empty.
    pub fn of_environment() -> Self {
        let name = ["LC_ALL", "LC_MESSAGES", "LANG"]
            .iter()
            .filter_map(std::env::var_os)
            .find(|value| !value.is_empty());
        name.map_or(Self::English, |name| {
            Self::of_locale(name.as_encoded_bytes())
        })
    }

    /// The language of a locale's name: `de`, `de_AT.UTF-8`, `German`.
    pub fn of_locale(name: &[u8]) -> Self {
        let letters = name.iter().take_while(|byte| byte.is_ascii_alphabetic());
        let word: Vec<u8> = letters.map(u8::to_ascii_lowercase).take(8).collect();
        match word.as_slice() {
            b"de" | b"deu" | b"ger" | b"deutsch" | b"german" => Self::German,
            _ => Self::English,
        }
    }

    pub(super) const fn texts(self) -> &'static Texts {
        match self {
            Self::English => &Texts::ENGLISH,
            Self::German => &Texts::GERMAN,
        }
    }

    /// A number with this language's decimal sign and a minus as wide as a digit; never minus zero.
    pub(super) fn number(self, value: f64, decimals: usize) -> String {
        self.written(format!("{value:.decimals$}"))
    }

    /// A number with a power of ten, such as 1.50e9.
    pub(super) fn power(self, value: f64, decimals: usize) -> String {
        self.written(format!("{value:.decimals$e}"))
    }

    /// A number as people write it, from how programs do.
    fn written(self, mut text: String) -> String {
        if let Some(digits) = text.strip_prefix('-') {
            let zero = digits.bytes().all(|byte| matches!(byte, b'0' | b'.'));
            text = if zero {
                digits.to_owned()
            } else {
                format!("−{digits}")
            };
        }
        match self {
            Self::English => text,
            Self::German => text.replace('.', ","),
        }
    }
}

/// Declares the texts of one part of the window: `name: English, German;`.
macro_rules! texts {
    ($group:ident { $($name:ident: $english:literal, $german:literal;)* }) => {
        pub(in crate) struct $group {
            $(pub(in crate) $name: &'static str,)*
        }

        impl $group {
            pub(super) const ENGLISH: Self = Self { $($name: $english,)* };
            pub(super) const GERMAN: Self = Self { $($name: $german,)* };

            /// Name, English and German of each.
            #[cfg(test)]
            pub(super) const ALL: &'static [(&'static str, &'static str, &'static str)] =
                &[$((concat!(stringify!($group), ".", stringify!($name)), $english, $german),)*];
        }
    };
}
use texts;

macro_rules! parts {
    ($($part:ident: $group:ident;)*) => {
        /// All texts in one language.
        pub(super) struct Texts {
            $(pub(super) $part: $part::$group,)*
        }

        impl Texts {
            const ENGLISH: Self = Self { $($part: $part::$group::ENGLISH,)* };
            const GERMAN: Self = Self { $($part: $part::$group::GERMAN,)* };

            #[cfg(test)]
            pub(super) const ALL: &'static [&'static [(&'static str, &'static str, &'static str)]] =
                &[$($part::$group::ALL,)*];
        }
    };
}

parts! {
    check: Check;
    colours: Colours;
    compare: Compare;
    curve: Curve;
    display: DisplayWindow;
    errors: Errors;
    files: Files;
    fit: Fit;
    help: Help;
    menu: Menu;
    menu_hints: MenuHints;
    node: NodePanel;
    orientation: Orientation;
    output: Output;
    points_list: PointsList;
    position: Position;
    questions: Questions;
    recovery: Recovery;
    scene: Scene;
    setup: Setup;
    space: Space;
    space_window: SpaceWindow;
    speed_window: SpeedWindow;
    timing: Timing;
    steps: Steps;
    timeline: Timeline;
    tools: Tools;
    zoom: Zoom;
}

/// A text with its values put in: `{0}` is the first. Placeholders without a value stay.
pub(super) fn fill(text: &str, values: &[&dyn Display]) -> String {
    let mut filled = String::with_capacity(text.len() + 16);
    let mut rest = text;
    while let Some((before, behind)) = rest.split_once('{') {
        filled.push_str(before);
        let place = behind.split_once('}').and_then(|(at, after)| {
            let at: usize = at.parse().ok()?;
            Some((values.get(at)?, after))
        });
        if let Some((value, after)) = place {
            // Writing to a string cannot fail.
            let _ = write!(filled, "{value}");
            rest = after;
        } else {
            filled.push('{');
            rest = behind;
        }
    }
    filled.push_str(rest);
    filled
}

#[cfg(test)]
mod tests {
    use super::*;

    fn placeholders(text: &str) -> Vec<&str> {
        let mut found: Vec<&str> = text
            .split('{')
            .skip(1)
            .filter_map(|part| part.split_once('}').map(|(number, _)| number))
            .collect();
        found.sort_unstable();
        found
    }

    #[test]
    fn every_text_stands_in_both_languages_with_the_same_values() {
        let mut count = 0;
        for (name, english, german) in Texts::ALL.iter().copied().flatten().copied() {
            assert!(!english.trim().is_empty(), "{name}");
            assert!(!german.trim().is_empty(), "{name}");
            assert_eq!(placeholders(english), placeholders(german), "{name}");
            count += 1;
        }
        assert!(count > 10);
    }

    #[test]
    fn values_are_put_where_the_language_wants_them() {
        assert_eq!(fill("{0} of {1}", &[&3, &6]), "3 of 6");
        assert_eq!(fill("{1}: {0}", &[&3, &"x"]), "x: 3");
        assert_eq!(fill("a {b", &[]), "a {b");
        assert_eq!(fill("plain", &[&1]), "plain");
    }

    #[test]
    fn locales_name_their_language() {
        for german in ["de", "de_DE.UTF-8", "de_AT", "German", "de@euro"] {
            assert_eq!(Language::of_locale(german.as_bytes()), Language::German);
        }
        for other in ["", "C", "en_GB.UTF-8", "dese", "fr_FR", "POSIX"] {
            assert_eq!(Language::of_locale(other.as_bytes()), Language::English);
        }
    }

    #[test]
    fn numbers_have_the_languages_sign() {
        assert_eq!(Language::German.number(-0.5, 2), "−0,50");
        assert_eq!(Language::English.number(-0.5, 2), "−0.50");
        assert_eq!(Language::English.number(-0.0004, 3), "0.000");
        assert_eq!(Language::German.number(1.25, 1), "1,2");
    }
}
