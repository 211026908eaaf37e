//! The ASCII output (thesis B.2.3): one line per pose, ten numbers as C's `%3.4f`, separated by
//! single spaces. Unlike C, the decimal sign is always a point, and zero never has a minus sign.

use std::io::Write;
use std::path::Path;

use vides_engine::path::{Pose, Sampler};

use super::blocks;
use super::content::Content;
use super::error::Result;
use super::flight::Flight;
use super::format::{Format, Holds};
use super::loss::Report;
use super::rows;

pub(super) static ASCII: Format = Format {
    name: "ascii",
    title: "ASCII",
    endings: &["txt"],
    holds: Holds::Frames,
    recognises: |source| rows::is_poses(source.beginning(), false),
    read: Some(|source, _, _| rows::poses_of_text(source.text()?).map(Content::Poses)),
    write: Some(write),
    ..Format::PLAIN
};

/// Of what has no poses the matrices to world coordinates, column by column as in OpenGL.
fn write(flight: &mut Flight<'_>, out: &mut dyn Write, _: &mut Report) -> Result<()> {
    let decimals = flight.options().digits.unwrap_or(DECIMALS);
    if flight.looks() {
        return flight.write_poses(Vec::new(), out, |_, text, _, pose| {
            push_line(text, pose, decimals);
        });
    }
    flight.write_states(Vec::new(), out, |flight, text, _, state| {
        for (at, number) in flight.matrix(state).iter().enumerate() {
            text.extend_from_slice(if at == 0 { b"" } else { b" " });
            push_number(text, *number, decimals);
        }
        text.push(b'\n');
    })
}

/// Writes all poses, one per line, as VRP, VPN and VUP (x y z each) and zoom.
///
/// # Errors
/// [`super::error::Error::Document`] if `out` fails or memory runs out.
pub fn write_ascii(sampler: &Sampler, out: &mut dyn Write) -> Result<()> {
    blocks::write(
        Vec::new(),
        sampler.frame_count(),
        out,
        &mut |_, _| {},
        |done, poses| Ok(sampler.sample(done + 1, poses)?),
        |text, _, pose| push_line(text, pose, DECIMALS),
    )
}

/// As [`write_ascii`], into a file that is replaced only when all is written ([`vides_document::save`]).
///
/// # Errors
/// As [`write_ascii`], naming the file.
pub fn write_ascii_file(sampler: &Sampler, file: &Path) -> Result<()> {
    super::saving::save_with(file, &mut |out| write_ascii(sampler, out))
}

pub(super) fn push_line(text: &mut Vec<u8>, pose: &Pose, decimals: usize) {
    for number in [pose.vrp, pose.vpn, pose.vup].as_flattened() {
        push_number(text, *number, decimals);
        text.push(b' ');
    }
    push_number(text, pose.zoom, decimals);
    text.push(b'\n');
}

/// Those of the thesis.
pub(super) const DECIMALS: usize = 4;

const SCALE: f64 = 1e4;

/// Below this a ten-thousandth is more than the rounding of 10⁴·x: 10⁴·10¹¹ < 2⁵².
const FAST: f64 = 1e11;

/// Appends `x`, finite, as `%.*f` does: the exact value rounded to that number of decimals, ties to
/// even.
///
/// Of four decimals `p`, the rounded product 10⁴·x, decides alone unless it is exactly half-way:
/// half-way numbers are multiples of `p`'s last place here, so the product's rounding cannot step
/// over one. Half-way, the sign of the rounding error decides.
pub(super) fn push_number(text: &mut Vec<u8>, x: f64, decimals: usize) {
    let magnitude = x.abs();
    if magnitude >= FAST || decimals != DECIMALS {
        let start = text.len();
        let _ = write!(text, "{x:.decimals$}");
        if !text[start..]
            .iter()
            .any(|digit| (b'1'..=b'9').contains(digit))
            && x.is_sign_negative()
        {
            text.remove(start);
        }
        return;
    }
    let product = magnitude * SCALE;
    let mut count = product as u64;
    let rest = product - count as f64;
    let up = if rest == 0.5 {
        let lost = magnitude.mul_add(SCALE, -product);
        lost > 0.0 || (lost == 0.0 && count % 2 == 1)
    } else {
        rest > 0.5
    };
    count += u64::from(up);
    if x < 0.0 && count > 0 {
        text.push(b'-');
    }
    push_count(text, count);
}

fn push_count(text: &mut Vec<u8>, count: u64) {
    // At most 10¹⁵ ten-thousandths: 12 digits, the point, 4 digits.
    let mut digits = [0_u8; 17];
    let mut at = digits.len();
    let mut rest = count;
    let mut digit = || {
        let last = (rest % 10) as u8;
        rest /= 10;
        (b'0' + last, rest > 0)
    };
    for _ in 0..4 {
        at -= 1;
        digits[at] = digit().0;
    }
    at -= 1;
    digits[at] = b'.';
    loop {
        let (character, more) = digit();
        at -= 1;
        digits[at] = character;
        if !more {
            break;
        }
    }
    text.extend_from_slice(&digits[at..]);
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ours(x: f64) -> String {
        with(x, DECIMALS)
    }

    fn with(x: f64, decimals: usize) -> String {
        let mut text = Vec::new();
        push_number(&mut text, x, decimals);
        String::from_utf8(text).unwrap()
    }

    /// Any bits but those of infinities and NaN.
    fn finite(bits: u64) -> f64 {
        let x = f64::from_bits(bits);
        if x.is_finite() { x } else { 0.0 }
    }

    /// Rust's own formatting is exact, and what it prints for all these
    /// numbers is compared with C's in `tests/ascii.rs`.
    fn check(x: f64) {
        let expected = format!("{x:.4}");
        let expected = if expected == "-0.0000" {
            "0.0000"
        } else {
            &expected
        };
        assert_eq!(ours(x), expected, "{x:?}");
    }

    #[test]
    fn numbers_are_rounded_like_exact_decimals() {
        let mut state = 1_u64;
        let mut random = || {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            state ^ (state >> 29)
        };
        for _ in 0..200_000 {
            check(finite(random()));
            check((random() as i64) as f64 / 2_f64.powi(63));
            check((random() as i64) as f64 / 2_f64.powi(40));
            // Half-way or next to it: odd multiples of 1/20000, and ties that
            // are exact in binary, odd multiples of 1/32.
            let near = (random() % 2_000_001) as f64 / 20_000.0;
            for x in [near, near.next_up(), near.next_down()] {
                check(x);
                check(-x);
            }
            let tie = (random() % 65_536) as f64 / 32.0;
            check(tie);
            check(-tie);
        }
    }

    #[test]
    fn zero_has_no_minus() {
        for x in [0.0, -0.0, -0.000_01, -5e-324, -0.000_05, 0.000_05] {
            let text = ours(x);
            assert!(text == "0.0000" || text == "0.0001" || text == "-0.0001");
            assert_ne!(text, "-0.0000");
        }
        assert_eq!(ours(-0.000_01), "0.0000");
        assert_eq!(ours(-0.0), "0.0000");
        // 0.00005 lies a little above the half-way, in binary.
        assert_eq!(ours(0.000_05), "0.0001");
        // Exact ties go to the even digit: 0.03125, 0.09375.
        assert_eq!(ours(0.031_25), "0.0312");
        assert_eq!(ours(0.093_75), "0.0938");
    }

    /// By hand: 2⁻⁵ = 0.03125, 2⁻²⁰ = 0.00000095367431640625.
    #[test]
    fn other_decimals_are_exact_too() {
        let x = -1.031_25;
        for (decimals, text) in [
            (0, "-1"),
            (1, "-1.0"),
            (4, "-1.0312"),
            (5, "-1.03125"),
            (7, "-1.0312500"),
        ] {
            assert_eq!(with(x, decimals), text);
        }
        assert_eq!(with(2_f64.powi(-20), 20), "0.00000095367431640625");
        for (zero, decimals, text) in [(-0.4, 0, "0"), (-0.0, 2, "0.00"), (-0.004, 2, "0.00")] {
            assert_eq!(with(zero, decimals), text);
        }
        assert_eq!(with(-2e11, 0), "-200000000000");
    }

    #[test]
    fn large_worlds_keep_every_digit() {
        check(1e11);
        check(99_999_999_999.999_95);
        check(-123_456_789_012_345.68);
        check(f64::MAX);
    }
}
