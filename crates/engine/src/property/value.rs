//! Values of properties, and how files write them.

use std::fmt::{self, Write as _};
use std::sync::Arc;

use glam::DVec3;

use crate::limits::{PRESETS, SPEEDS};
use crate::path::{BaseFrames, Ease, PacePart, PaceSource, Tcb, TurningPart, UpPath};

/// A value on its way into or out of a property that is not nested. [`super::Kind`] says what each
/// is.
#[derive(Clone, Debug, Default, PartialEq)]
#[allow(missing_docs)]
pub enum Value {
    /// Not set; set, it stands for what a new one has.
    #[default]
    Unset,
    Number(f64),
    Whole(i64),
    Switch(bool),
    Choice(&'static str),
    Text(String),
    Place(DVec3),
    Vector(DVec3),
    /// By the names of their kind.
    Pair([&'static str; 2], [DVec3; 2]),
    Speeds([f64; SPEEDS]),
    Shape(Tcb),
    Presets([Tcb; PRESETS]),
    BaseFrames(BaseFrames),
    Ease(Ease),
    Distance(Arc<[[f64; 2]]>),
    Part(PacePart),
    Turning(TurningPart),
    UpPath(Arc<UpPath>),
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
            Self::Presets(presets) => list(out, presets.iter().copied().map(Self::Shape)),
            Self::BaseFrames(frames) => {
                for (at, row) in BaseFrames::PROPERTIES.iter().enumerate() {
                    let separator = if at == 0 { "{" } else { "," };
                    write!(out, "{separator} {} = {}", row.key(), (row.value)(frames))?;
                }
                out.write_str(" }")
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

fn list(out: &mut fmt::Formatter<'_>, all: impl Iterator<Item = Value>) -> fmt::Result {
    for (at, value) in all.enumerate() {
        let separator = if at == 0 { "[" } else { ", " };
        write!(out, "{separator}{value}")?;
    }
    out.write_str("]")
}

fn pace_part(out: &mut fmt::Formatter<'_>, part: &PacePart) -> fmt::Result {
    write!(out, "{{ from = {:?}, to = {:?}, ", part.from, part.to)?;
    match &part.of {
        PaceSource::Speeds {
            speeds,
            before,
            after,
        } => {
            write!(out, "speed_curve = {speeds:?}")?;
            if let Some(before) = before {
                write!(out, ", facing_before = {before:?}")?;
            }
            if let Some(after) = after {
                write!(out, ", facing_after = {after:?}")?;
            }
        }
        PaceSource::Ease(ease) => write!(out, "ease = {}", Value::Ease(*ease))?,
        PaceSource::Distance(keys) => write!(out, "distance = {keys:?}")?,
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
                control if control.is_control() => {
                    write!(out, "\\u{:04X}", u32::from(control))?;
                }
                other => out.write_char(other)?,
            }
        }
        out.write_str(if lines { "\"\"\"" } else { "\"" })
    }
}
