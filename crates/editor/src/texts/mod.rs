//! Every word that the window shows, German and English.
//!
//! The texts stand in `texts/english.txt` and `texts/german.txt`, one a line; here are their names, in a
//! file for each panel that has code for them, all others in `names.rs`. `{0}`, `{1}` … stand for values; [`fill`] puts them in.
//!
//! The library's own sentences are English; `german` and `german_files` say which values go into
//! those of its errors in another language.

#[cfg(test)]
use std::collections::BTreeSet;
use std::fmt::{Display, Write};
use std::sync::OnceLock;

mod ambiguities;
mod catalogue;
mod check;
mod curve;
mod display;
pub(crate) mod formats;
mod german;
mod german_files;
mod names;
mod node;
pub(crate) mod refusals;
mod steps;
mod tools;

use catalogue::Catalogue;

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

    pub(super) fn texts(self) -> &'static Texts {
        &self.loaded().1
    }

    fn catalogue(self) -> &'static Catalogue {
        &self.loaded().0
    }

    /// The word of the catalogue for a name in a table of the library, or what the table says.
    fn word(self, part: &str, name: &str, says: &'static str) -> &'static str {
        self.catalogue().find(part, name).unwrap_or(says)
    }

    /// That a part of the catalogue holds exactly these names.
    #[cfg(test)]
    fn has_exactly(self, part: &str, names: &[&str]) {
        let catalogue = self.catalogue().names().filter(|(of, _)| *of == part);
        let found: BTreeSet<&str> = catalogue.map(|(_, name)| name).collect();
        assert_eq!(found, names.iter().copied().collect(), "{self:?} {part}");
    }

    /// What the language says, read when it is first needed.
    fn loaded(self) -> &'static (Catalogue, Texts) {
        static ENGLISH: OnceLock<(Catalogue, Texts)> = OnceLock::new();
        static GERMAN: OnceLock<(Catalogue, Texts)> = OnceLock::new();
        let (language, file) = match self {
            Self::English => (&ENGLISH, include_str!("../../texts/english.txt")),
            Self::German => (&GERMAN, include_str!("../../texts/german.txt")),
        };
        language.get_or_init(|| {
            let catalogue = Catalogue::new(file);
            let texts = Texts::of(&catalogue);
            (catalogue, texts)
        })
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

/// Declares the names of the texts of one part of the window.
macro_rules! texts {
    ($(#[$about:meta])* $group:ident { $($name:ident,)* }) => {
        $(#[$about])*
        pub(in crate) struct $group {
            $(pub(in crate) $name: &'static str,)*
        }

        impl $group {
            #[cfg(test)]
            pub(super) const NAMES: &'static [&'static str] = &[$(stringify!($name)),*];

            pub(super) fn of(catalogue: &$crate::texts::catalogue::Catalogue, part: &str) -> Self {
                let [$($name),*] = catalogue.texts(part, [$(stringify!($name)),*]);
                Self { $($name),* }
            }
        }
    };
}
use texts;

macro_rules! parts {
    ($($part:ident: $group:ident in $file:ident;)*) => {
        /// All texts in one language.
        pub(super) struct Texts {
            $(pub(super) $part: $file::$group,)*
        }

        impl Texts {
            fn of(catalogue: &Catalogue) -> Self {
                Self { $($part: $file::$group::of(catalogue, stringify!($part)),)* }
            }

            /// The names of each part.
            #[cfg(test)]
            const NAMES: &'static [(&'static str, &'static [&'static str])] =
                &[$((stringify!($part), $file::$group::NAMES)),*];

            /// Name, English and German of each; empty where a catalogue lacks it.
            #[cfg(test)]
            pub(super) fn all() -> impl Iterator<Item = (String, &'static str, &'static str)> {
                let names = Self::NAMES.iter();
                let names = names.flat_map(|(part, names)| names.iter().map(move |name| (*part, *name)));
                let [english, german] = [Language::English, Language::German].map(Language::catalogue);
                names.map(move |(part, name)| {
                    let [english, german] = [english, german].map(|language| language.find(part, name));
                    (format!("{part}.{name}"), english.unwrap_or_default(), german.unwrap_or_default())
                })
            }
        }
    };
}

parts! {
    check: Check in check;
    colours: Colours in names;
    compare: Compare in names;
    curve: Curve in curve;
    display: DisplayWindow in display;
    errors: Errors in names;
    files: Files in names;
    fit: Fit in names;
    help: Help in names;
    menu: Menu in names;
    menu_hints: MenuHints in names;
    node: NodePanel in node;
    orientation: Orientation in names;
    output: Output in names;
    points_list: PointsList in names;
    position: Position in names;
    questions: Questions in names;
    recovery: Recovery in names;
    scene: Scene in names;
    setup: Setup in names;
    space: Space in names;
    space_window: SpaceWindow in names;
    speed_window: SpeedWindow in names;
    timing: Timing in names;
    steps: Steps in steps;
    timeline: Timeline in names;
    tools: Tools in tools;
    zoom: Zoom in names;
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

    /// Parts whose names stand in tables of the library, or of the TOML parser, which has none.
    const TABLES: [&str; 11] = [
        "toml",
        "tool",
        "tool_does",
        "parameter",
        "parameter_does",
        "choice",
        "limit",
        "limit_unit",
        "finding",
        "remedy",
        "format",
    ];

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
        for (name, english, german) in Texts::all() {
            assert!(!english.trim().is_empty(), "{name}");
            assert!(!german.trim().is_empty(), "{name}");
            assert_eq!(placeholders(english), placeholders(german), "{name}");
            count += 1;
        }
        assert!(count > 10);
    }

    /// Part, name and number of values of the texts of errors.
    fn errors() -> impl Iterator<Item = (&'static str, &'static str, usize)> {
        let lists = [
            german::ENGINE,
            german_files::DOCUMENT,
            german_files::WARNINGS,
            formats::FORMATS,
        ];
        lists.into_iter().flatten().copied()
    }

    #[test]
    fn every_error_has_a_text_with_its_values() {
        for (part, name, values) in errors() {
            let text = Language::German.catalogue().find(part, name);
            let text = text.unwrap_or_else(|| panic!("{part}.{name} is missing"));
            let mut found = placeholders(text);
            found.dedup();
            let wanted: Vec<String> = (0..values).map(|at| at.to_string()).collect();
            assert_eq!(found, wanted, "{part}.{name}");
        }
    }

    #[test]
    fn no_text_is_there_in_vain() {
        let window = Texts::NAMES.iter();
        let window = window.flat_map(|(part, names)| names.iter().map(move |name| (*part, *name)));
        let errors = errors().map(|(part, name, _)| (part, name));
        let used: BTreeSet<_> = window.chain(errors).collect();
        for language in [Language::English, Language::German] {
            let names = language.catalogue().names();
            for name in names.filter(|(part, _)| !TABLES.contains(part)) {
                assert!(used.contains(&name), "{language:?}: {name:?}");
            }
        }
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
