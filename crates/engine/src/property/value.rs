//! Values of properties, and how files write them.

use std::fmt::{self, Write as _};
use std::sync::Arc;

use glam::{DQuat, DVec3};

use crate::limits::{PRESETS, SPEEDS};
use crate::path::base_frames::BaseFrames;
use crate::path::ease::Ease;
use crate::path::own_parts::{PacePart, PaceSource, TurningPart};
use crate::path::tcb::Tcb;
use crate::path::up_path::UpPath;

macro_rules! kinds {
    ($($kind:ident($type:ty) $words:literal,)*) => {
        /// What a property is.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        #[allow(missing_docs)]
        pub enum Kind {
            $($kind,)*
            /// One of these names.
            Choice(&'static [&'static str]),
            /// Two vectors of the world, by their names.
            Pair([&'static str; 2]),
            /// A structure that files write in a special way.
            Nested,
        }

        /// A value on its way into or out of a property that is not nested.
        #[derive(Clone, Debug, Default, PartialEq)]
        #[allow(missing_docs)]
        pub enum Value {
            /// Not set; set, it stands for what a new one has.
            #[default]
            Unset,
            $($kind($type),)*
            Choice(&'static str),
            Pair([&'static str; 2], [DVec3; 2]),
        }

        impl Kind {
            /// Whether a value is of this kind.
            #[must_use]
            pub fn has(self, value: &Value) -> bool {
                match value {
                    Value::Unset => false,
                    $(Value::$kind(_) => self == Self::$kind,)*
                    Value::Choice(name) => {
                        matches!(self, Self::Choice(names) if names.contains(name))
                    }
                    Value::Pair(names, _) => self == Self::Pair(*names),
                }
            }
        }

        impl fmt::Display for Kind {
            fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
                match self {
                    $(Self::$kind => out.write_str($words),)*
                    Self::Choice(names) => write!(out, "\"{}\"", names.join("\", \"")),
                    Self::Pair([one, other]) => write!(out, "two vectors, {one} and {other}"),
                    Self::Nested => out.write_str("structure"),
                }
            }
        }
    };
}

kinds! {
    Number(f64) "number",
    Whole(i64) "whole number",
    Switch(bool) "switch",
    Text(String) "text",
    Place(DVec3) "place",
    Vector(DVec3) "vector",
    Rotation(DQuat) "quaternion, w first",
    Colour([f64; 3]) "red, green, blue",
    Cone([f64; 2]) "inner and outer angle",
    Speeds([f64; SPEEDS]) "ten numbers",
    Shape(Tcb) "tension, continuity, bias",
    Presets([Tcb; PRESETS]) "ten of tension, continuity, bias",
    BaseFrames(BaseFrames) "four numbers",
    Ease(Ease) "kind, rise, fall, cruise",
    Distance(Arc<[[f64; 2]]>) "list of time and way",
    Part(PacePart) "part of a pace",
    Turning(TurningPart) "part of a turning",
    UpPath(Arc<UpPath>) "list of places with tangents",
}

impl Value {
    /// It, if it is a number.
    #[must_use]
    pub const fn number(&self) -> Option<f64> {
        match self {
            Self::Number(number) => Some(*number),
            Self::Whole(number) => Some(*number as f64),
            _ => None,
        }
    }
}

/// As files have it: TOML with the fewest digits that give the same bits back.
impl fmt::Display for Value {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unset => Ok(()),
            Self::Number(number) => write!(out, "{number:?}"),
            Self::Whole(number) => write!(out, "{number}"),
            Self::Switch(switch) => write!(out, "{switch}"),
            Self::Choice(name) => write!(out, "\"{name}\""),
            Self::Text(text) => Quoted(text).fmt(out),
            Self::Place(v) | Self::Vector(v) => write!(out, "{:?}", v.to_array()),
            Self::Rotation(q) => write!(out, "{:?}", [q.w, q.x, q.y, q.z]),
            Self::Colour(colour) => write!(out, "{colour:?}"),
            Self::Cone(angles) => write!(out, "{angles:?}"),
            Self::Pair([one, other], both) => {
                let [a, b] = both.map(|v| v.to_array());
                write!(out, "{{ {one} = {a:?}, {other} = {b:?} }}")
            }
            Self::Speeds(speeds) => write!(out, "{speeds:?}"),
            Self::Shape(tcb) => write!(
                out,
                "{{ tension = {:?}, continuity = {:?}, bias = {:?} }}",
                tcb.tension, tcb.continuity, tcb.bias
            ),
            Self::Presets(presets) => {
                let presets = presets.iter().copied().map(Self::Shape).enumerate();
                table(out, presets)
            }
            Self::BaseFrames(frames) => {
                let rows = BaseFrames::PROPERTIES.iter();
                table(out, rows.map(|row| (row.key(), (row.value)(frames))))
            }
            Self::Ease(ease) => write!(
                out,
                "{{ kind = \"{}\", rise = {:?}, fall = {:?}, cruise = {:?} }}",
                ease.kind.name(),
                ease.rise,
                ease.fall,
                ease.cruise
            ),
            Self::Distance(keys) => write!(out, "{keys:?}"),
            Self::Part(part) => pace_part(out, part),
            Self::Turning(TurningPart { control, from, to }) => {
                let control = control.map(|q| [q.w, q.x, q.y, q.z]);
                write!(
                    out,
                    "{{ from = {from:?}, to = {to:?}, control = {control:?} }}"
                )
            }
            Self::UpPath(path) => {
                let numbers = path
                    .points()
                    .iter()
                    .map(|point| [point.position, point.before, point.after].map(|v| v.to_array()));
                for (at, numbers) in numbers.enumerate() {
                    let separator = if at == 0 { "[" } else { ", " };
                    write!(out, "{separator}{:?}", numbers.as_flattened())?;
                }
                out.write_str("]")
            }
        }
    }
}

/// An inline table.
fn table(
    out: &mut fmt::Formatter<'_>,
    all: impl Iterator<Item = (impl fmt::Display, Value)>,
) -> fmt::Result {
    for (at, (key, value)) in all.enumerate() {
        let separator = if at == 0 { "{" } else { "," };
        write!(out, "{separator} {key} = {value}")?;
    }
    out.write_str(" }")
}

fn pace_part(out: &mut fmt::Formatter<'_>, part: &PacePart) -> fmt::Result {
    write!(out, "{{ from = {:?}, to = {:?}, ", part.from, part.to)?;
    match &part.of {
        PaceSource::Speeds { speeds, slopes } => {
            write!(out, "speed_curve = {speeds:?}, slopes = {slopes:?}")?;
        }
        PaceSource::Ease(ease) => write!(out, "ease = {}", Value::Ease(*ease))?,
        PaceSource::Distance(keys) => write!(out, "distance = {keys:?}")?,
        PaceSource::Track(keys) => write!(out, "track = {keys:?}")?,
    }
    out.write_str(" }")
}

/// A TOML string; multi-line if the text has several lines.
#[derive(Clone, Copy, Debug)]
pub struct Quoted<'a>(pub &'a str);

impl fmt::Display for Quoted<'_> {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let lines = self.0.contains('\n');
        // The line break after the opening quotes is not part of the string.
        out.write_str(if lines { "\"\"\"\n" } else { "\"" })?;
        let mut characters = self.0.chars().peekable();
        while let Some(character) = characters.next() {
            match character {
                '\\' => out.write_str("\\\\")?,
                // A single quote may stand unescaped in a multi-line string.
                '"' if lines && characters.peek().is_some_and(|&next| next != '"') => {
                    out.write_char('"')?;
                }
                '"' => out.write_str("\\\"")?,
                '\n' => out.write_char('\n')?,
                '\t' => out.write_char('\t')?,
                // Escaped, since editors may change line ends.
                '\r' => out.write_str("\\r")?,
                hidden if steers(hidden) => write!(out, "\\u{:04X}", u32::from(hidden))?,
                other => out.write_char(other)?,
            }
        }
        out.write_str(if lines { "\"\"\"" } else { "\"" })
    }
}

/// Whether a character would steer a terminal and is not seen there: control characters, ends of
/// lines and paragraphs, and what turns the direction of writing (Unicode Standard Annex 9), by
/// which a text can look like another.
#[must_use]
pub fn steers(character: char) -> bool {
    character.is_control()
        || matches!(
            character,
            '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}'
        )
}
