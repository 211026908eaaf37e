//! What is typed into a field for a number: numbers with comma or point, other units of the
//! same quantity (`48fr` in a field of seconds), sums and products (`2*3`), and changes of the
//! value that was there (`+10%`, `*2`).

use std::iter::Peekable;
use std::str::Chars;

use crate::texts::Language;

/// What the numbers of a document count, for the units that may be typed.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct Measures {
    /// Frames per second.
    pub(super) fps: f64,
    /// The name of the unit of lengths; may be empty.
    pub(super) length: String,
}

/// The quantity of a field.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) enum Quantity {
    /// One that has no other units.
    #[default]
    Plain,
    Frames,
    Seconds,
    Length,
    Degrees,
}

/// Why a text is no value.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Miss {
    /// It cannot be read, or its value is not finite.
    Number,
    /// This unit does not fit the field.
    Unit(String),
}

/// A field as a typed text sees it.
pub(super) struct Field<'a> {
    pub(super) quantity: Quantity,
    /// The unit that is shown behind the value.
    pub(super) unit: &'a str,
    pub(super) before: f64,
    pub(super) measures: &'a Measures,
}

/// Units of length in metres.
const LENGTHS: [(&str, f64); 10] = [
    ("nm", 1e-9),
    ("µm", 1e-6),
    ("um", 1e-6),
    ("mm", 1e-3),
    ("cm", 1e-2),
    ("m", 1.0),
    ("km", 1e3),
    ("in", 0.0254),
    ("ft", 0.3048),
    ("mi", 1609.344),
];

/// Units of time in seconds.
const TIMES: [(&str, f64); 4] = [("ms", 1e-3), ("s", 1.0), ("min", 60.0), ("h", 3600.0)];

/// The finite value that a text stands for in a field.
pub(super) fn value(text: &str, field: &Field) -> Result<f64, Miss> {
    let plain: String = text.trim().chars().map(plain).collect();
    // Not the `s` of `ms`.
    let whole = |rest: &&str| !rest.ends_with(char::is_alphabetic);
    let rest = plain.strip_suffix(field.unit.trim()).filter(whole);
    let rest = rest.unwrap_or(&plain);
    let mut typed = Typed {
        rest: rest.trim().chars().peekable(),
        field,
    };
    let value = typed.whole()?;
    match typed.peek() {
        None if value.is_finite() => Ok(value),
        _ => Err(Miss::Number),
    }
}

/// A letter as programs write it.
fn plain(letter: char) -> char {
    match letter {
        '−' | '–' => '-',
        ',' => '.',
        '×' | '·' => '*',
        '÷' => '/',
        '\u{a0}' => ' ',
        other => other,
    }
}

struct Typed<'a> {
    rest: Peekable<Chars<'a>>,
    field: &'a Field<'a>,
}

impl Typed<'_> {
    /// The next sign that is no space.
    fn peek(&mut self) -> Option<char> {
        while self.rest.next_if_eq(&' ').is_some() {}
        self.rest.peek().copied()
    }

    fn take(&mut self, sign: char) -> bool {
        self.peek() == Some(sign) && self.rest.next().is_some()
    }

    /// A sum, or a change of the value before: `*2`, `/2`, `+10%`, `150%`.
    fn whole(&mut self) -> Result<f64, Miss> {
        let before = self.field.before;
        if self.take('*') {
            return Ok(before * self.sum()?);
        }
        if self.take('/') {
            return Ok(before / self.sum()?);
        }
        let signed = matches!(self.peek(), Some('+' | '-'));
        let value = self.sum()?;
        match (self.take('%'), signed) {
            (true, true) => Ok(before * (1.0 + value / 100.0)),
            (true, false) => Ok(before * value / 100.0),
            (false, _) => Ok(value),
        }
    }

    fn sum(&mut self) -> Result<f64, Miss> {
        let mut value = self.product()?;
        loop {
            if self.take('+') {
                value += self.product()?;
            } else if self.take('-') {
                value -= self.product()?;
            } else {
                return Ok(value);
            }
        }
    }

    fn product(&mut self) -> Result<f64, Miss> {
        let mut value = self.factor()?;
        loop {
            if self.take('*') {
                value *= self.factor()?;
            } else if self.take('/') {
                value /= self.factor()?;
            } else {
                return Ok(value);
            }
        }
    }

    /// A number with or without a unit, behind any signs.
    fn factor(&mut self) -> Result<f64, Miss> {
        let mut sign = 1.0;
        loop {
            if self.take('-') {
                sign = -sign;
            } else if !self.take('+') {
                break;
            }
        }
        let number = self.number()?;
        let one = self.unit()?;
        let value = sign * number * one;
        // Of seconds as many frames as come nearest.
        let counts = self.field.quantity == Quantity::Frames && one != 1.0;
        Ok(if counts { value.round() } else { value })
    }

    fn number(&mut self) -> Result<f64, Miss> {
        self.peek();
        let mut text = String::new();
        while let Some(&letter) = self.rest.peek() {
            let exponent = letter.eq_ignore_ascii_case(&'e') && self.is_exponent();
            if !(letter.is_ascii_digit() || letter == '.' || exponent) {
                break;
            }
            text.push(letter);
            self.rest.next();
            if exponent {
                text.extend(self.rest.next_if(|sign| matches!(sign, '+' | '-')));
            }
        }
        text.parse().map_err(|_| Miss::Number)
    }

    /// Whether an exponent stands here, such as `e-3`.
    fn is_exponent(&self) -> bool {
        let mut ahead = self.rest.clone().skip(1);
        let first = ahead.next();
        let digit = match first {
            Some('+' | '-') => ahead.next(),
            other => other,
        };
        digit.is_some_and(|digit| digit.is_ascii_digit())
    }

    /// What one of the unit that stands here is in the field's own; 1 if none does.
    fn unit(&mut self) -> Result<f64, Miss> {
        self.peek();
        let mut name = String::new();
        let of_unit = |letter: &char| letter.is_alphabetic() || *letter == '°';
        while let Some(letter) = self.rest.next_if(of_unit) {
            name.push(letter);
        }
        if name.is_empty() || name == self.field.unit.trim() {
            return Ok(1.0);
        }
        self.field.one(&name).ok_or(Miss::Unit(name))
    }
}

impl Field<'_> {
    /// One of a unit in that of the field.
    fn one(&self, name: &str) -> Option<f64> {
        let of = |units: &[(&str, f64)], name: &str| {
            let found = units.iter().find(|(unit, _)| *unit == name);
            found.map(|(_, one)| *one)
        };
        let frames = matches!(
            name,
            "f" | "fr" | "frames" | "frame" | "B" | "Bilder" | "Bild"
        );
        let Measures { fps, length } = self.measures;
        match self.quantity {
            Quantity::Plain => None,
            Quantity::Frames if frames => Some(1.0),
            Quantity::Frames => of(&TIMES, name).map(|seconds| seconds * fps),
            Quantity::Seconds if frames => Some(1.0 / fps),
            Quantity::Seconds => of(&TIMES, name),
            Quantity::Length if name == length => Some(1.0),
            Quantity::Length => Some(of(&LENGTHS, name)? / of(&LENGTHS, length)?),
            Quantity::Degrees => match name {
                "°" | "deg" => Some(1.0),
                "rad" => Some(1f64.to_degrees()),
                _ => None,
            },
        }
    }
}

/// A value as offered for typing: without trailing zeros beyond the decimals shown, at most six
/// decimals or three more than shown.
pub(super) fn written(language: Language, value: f64, decimals: usize) -> String {
    let most = (decimals + 3).max(6);
    let mut text = format!("{value:.most$}");
    let least = text.len() - most + decimals;
    while text.len() > least && text.ends_with('0') {
        text.pop();
    }
    if text.ends_with('.') {
        text.pop();
    }
    let shown = text.trim_start_matches('-');
    if shown.bytes().all(|byte| matches!(byte, b'0' | b'.')) {
        text = shown.to_owned();
    }
    match language {
        Language::English => text,
        Language::German => text.replace('.', ","),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str, quantity: Quantity, unit: &str, length: &str) -> Result<f64, Miss> {
        let measures = Measures {
            fps: 24.0,
            length: length.to_owned(),
        };
        let field = Field {
            quantity,
            unit,
            before: 8.0,
            measures: &measures,
        };
        value(text, &field)
    }

    #[test]
    fn both_decimal_signs_are_read() {
        for (text, value) in [
            ("1,5", 1.5),
            (" 1.5 ", 1.5),
            ("−0,25", -0.25),
            ("-0.25", -0.25),
            ("+3", 3.0),
            ("1e-3", 0.001),
            ("2E3", 2000.0),
            (",5", 0.5),
            ("12 °", 12.0),
            ("12°", 12.0),
        ] {
            assert_eq!(read(text, Quantity::Degrees, "°", ""), Ok(value), "{text}");
        }
        for text in [
            "", "1,5,2", "1.000,5", "1e999", "1 2", "°", "2*", "1/0", "2+*3", "3e", "%", "5%%",
        ] {
            let read = read(text, Quantity::Plain, "", "");
            assert!(read.is_err(), "{text}: {read:?}");
        }
        for text in ["abc", "inf", "nan"] {
            assert_eq!(read(text, Quantity::Plain, "", ""), Err(Miss::Number));
        }
    }

    #[test]
    fn sums_and_changes_are_computed() {
        for (text, value) in [
            ("2*3", 6.0),
            ("1 + 2*3 - 4/2", 5.0),
            ("10−3", 7.0),
            ("2×−3", -6.0),
            ("*2", 16.0),
            ("/4", 2.0),
            ("+10%", 8.8),
            ("-25 %", 6.0),
            ("150%", 12.0),
        ] {
            let read = read(text, Quantity::Plain, "", "").unwrap();
            assert!((read - value).abs() < 1e-12, "{text}: {read}");
        }
        // In a field of percents they are the unit.
        assert_eq!(read("30 %", Quantity::Plain, "\u{a0}%", ""), Ok(30.0));
    }

    #[test]
    fn units_are_those_of_the_quantity() {
        use Quantity::{Degrees, Frames, Length, Plain, Seconds};
        for (text, quantity, unit, length, value) in [
            ("2s", Frames, " frames", "", 48.0),
            ("1s + 12fr", Frames, "", "", 36.0),
            ("0.1s", Frames, "", "", 2.0),
            ("12 Bilder", Seconds, " s", "", 0.5),
            ("48fr", Seconds, " s", "", 2.0),
            ("500 ms", Seconds, " s", "", 0.5),
            ("1,5min", Seconds, " s", "", 90.0),
            ("0.5m", Length, "", "mm", 500.0),
            ("2 ft", Length, "", "m", 0.6096),
            ("3 parsec", Length, "", "parsec", 3.0),
            ("0.5 rad", Degrees, "°", "", 0.5f64.to_degrees()),
            ("35mm", Plain, " mm", "", 35.0),
        ] {
            let read = read(text, quantity, unit, length).unwrap();
            assert!((read - value).abs() < 1e-12, "{text}: {read}");
        }
        for (text, quantity, length, unit) in [
            ("2s", Length, "m", "s"),
            ("2 m", Length, "", "m"),
            ("2 m", Length, "parsec", "m"),
            ("3 rad", Plain, "", "rad"),
        ] {
            assert_eq!(
                read(text, quantity, "", length),
                Err(Miss::Unit(unit.to_owned())),
                "{text}"
            );
        }
    }

    #[test]
    fn what_is_offered_reads_back() {
        let read = |text: &str| read(text, Quantity::Plain, "", "");
        for value in [0.0, -0.0, 0.1, -2.5, 1e-6, 123_456.75, -1e9, 0.333_333] {
            for decimals in 0..4 {
                for language in [Language::English, Language::German] {
                    let text = written(language, value, decimals);
                    assert_eq!(read(&text), Ok(value), "{text}");
                }
            }
        }
        for value in [0.000_000_25, -0.000_001_000_5] {
            let text = written(Language::German, value, 9);
            assert_eq!(read(&text), Ok(value), "{text}");
        }
        assert_eq!(written(Language::German, 0.5, 2), "0,50");
        assert_eq!(written(Language::English, 100.0, 0), "100");
        assert_eq!(written(Language::English, 0.25, 0), "0.25");
    }
}
