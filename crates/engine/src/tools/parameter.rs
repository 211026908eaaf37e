//! What a tool asks for: one table for the window's fields, the command's options and the header.

/// What a number counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Unit {
    /// Nothing: a ratio or a count.
    One,
    /// Units of the positions.
    Length,
    /// Degrees.
    Degrees,
    /// Millimetres of focal length.
    Zoom,
    /// Seconds.
    Seconds,
    /// Things: whole numbers.
    Count,
    /// One of these, counted from 0.
    Choice(&'static [&'static str]),
    /// 0: no, 1: yes.
    Switch,
    /// The control points of a free form, in coordinates of its box.
    Lattice,
}

impl Unit {
    /// The unit after a number; empty for lengths and ratios.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::One
            | Self::Length
            | Self::Count
            | Self::Choice(_)
            | Self::Switch
            | Self::Lattice => "",
            Self::Degrees => "degrees",
            Self::Zoom => "mm",
            Self::Seconds => "seconds",
        }
    }
}

/// One parameter of a tool: a number, or several.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parameter {
    /// In small letters, words joined by `-`.
    pub name: &'static str,
    /// What it does, in a few words.
    pub does: &'static str,
    /// What its numbers count.
    pub unit: Unit,
    /// 1; 3 for x, y and z; 192 for a lattice.
    pub width: usize,
    /// The least that it may be; of a length, in units of `half_size`.
    pub least: f64,
    /// The most that it may be; of a length, in units of `half_size`.
    pub most: f64,
    /// The default of each of its numbers; of a length, in units of `half_size`.
    pub default: f64,
}

impl Parameter {
    /// One of several, by default the one of this number.
    #[must_use]
    pub const fn choice(
        name: &'static str,
        does: &'static str,
        names: &'static [&'static str],
        default: usize,
    ) -> Self {
        Self {
            name,
            does,
            unit: Unit::Choice(names),
            width: 1,
            least: 0.0,
            most: names.len() as f64 - 1.0,
            default: default as f64,
        }
    }

    /// Where this parameter begins among the numbers of `all`, and what it is.
    #[must_use]
    pub fn find(all: &'static [Self], name: &str) -> Option<(usize, &'static Self)> {
        let mut start = 0;
        for parameter in all {
            if parameter.name == name {
                return Some((start, parameter));
            }
            start += parameter.width;
        }
        None
    }

    /// How many numbers they are together.
    #[must_use]
    pub fn count(all: &[Self]) -> usize {
        all.iter().map(|parameter| parameter.width).sum()
    }

    /// What its bounds and its default are in, in a space of this `half_size`.
    #[must_use]
    pub fn scale(&self, half_size: f64) -> f64 {
        if self.unit == Unit::Length {
            half_size
        } else {
            1.0
        }
    }
}
