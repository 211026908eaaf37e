//! Strings, identifiers and numbers as they are written.

use std::collections::HashMap;
use std::fmt;

use glam::{DQuat, DVec3};

/// A text between quotation marks: data, whatever it holds.
pub(super) struct Quoted<'a>(pub &'a str);

impl fmt::Display for Quoted<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("\"")?;
        for sign in self.0.chars() {
            match sign {
                '"' => f.write_str("\\\"")?,
                '\\' => f.write_str("\\\\")?,
                '\n' => f.write_str("\\n")?,
                '\r' => f.write_str("\\r")?,
                '\t' => f.write_str("\\t")?,
                '\0'..='\u{1f}' | '\u{7f}' => write!(f, "\\x{:02x}", u32::from(sign))?,
                other => fmt::Write::write_char(f, other)?,
            }
        }
        f.write_str("\"")
    }
}

/// Identifiers that are given once.
#[derive(Default)]
pub(super) struct Names(HashMap<String, usize>);

impl Names {
    /// A valid identifier, like the name, that nothing else has.
    pub(super) fn give(&mut self, name: &str) -> String {
        let valid = |sign: char| {
            if sign.is_ascii_alphanumeric() {
                sign
            } else {
                '_'
            }
        };
        let mut plain: String = name.chars().map(valid).collect();
        if !plain.starts_with(|first: char| first.is_ascii_alphabetic() || first == '_') {
            plain.insert(0, '_');
        }
        // Many names that become one are numbered from where the last one ended.
        let mut number = self.0.get(&plain).copied().unwrap_or(1);
        let mut given = plain.clone();
        while self.0.contains_key(&given) {
            number += 1;
            given = format!("{plain}_{number}");
        }
        self.0.insert(plain, number);
        self.0.entry(given.clone()).or_insert(1);
        given
    }
}

/// A number of 32 bits, finite.
pub(super) fn single(number: f64) -> f32 {
    (number as f32).clamp(f32::MIN, f32::MAX)
}

/// `(x, y, z)` of 64 bits.
pub(super) struct Double3(pub DVec3);

impl fmt::Display for Double3 {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let DVec3 { x, y, z } = self.0;
        write!(f, "({x:?}, {y:?}, {z:?})")
    }
}

/// `(x, y, z)` of 32 bits.
pub(super) struct Float3(pub DVec3);

impl fmt::Display for Float3 {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [x, y, z] = self.0.to_array().map(single);
        write!(f, "({x:?}, {y:?}, {z:?})")
    }
}

/// `(w, x, y, z)` of 64 bits.
pub(super) struct Quat(pub DQuat);

impl fmt::Display for Quat {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let DQuat { x, y, z, w } = self.0;
        write!(f, "({w:?}, {x:?}, {y:?}, {z:?})")
    }
}

/// Red, green and blue of a channel, as they are.
pub(super) fn colour(v: &[f64]) -> String {
    Float3(glam::DVec3::new(v[0], v[1], v[2])).to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_stay_data() {
        let text = "a\"\"\" \\ \n\u{1}é</script>";
        assert_eq!(Quoted(text).to_string(), r#""a\"\"\" \\ \n\x01é</script>""#);
    }

    #[test]
    fn names_are_identifiers_and_differ() {
        let mut names = Names::default();
        for (name, given) in [
            ("wheel front left", "wheel_front_left"),
            ("wheel-front left", "wheel_front_left_2"),
            ("1. Kamera", "_1__Kamera"),
            ("é", "_"),
            ("ü", "__2"),
            ("__2", "__2_2"),
        ] {
            assert_eq!(names.give(name), given);
        }
    }
}
