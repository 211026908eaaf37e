//! Text of a row of numbers a line, separated by commas or blanks.

use std::io::Write;

use glam::{DMat3, DMat4, DQuat};
use vides_engine::path::Pose;

use super::content::Recording;
use super::convention;
use super::error::{Cause, Place, Result, Wanted};

/// The words of a line.
pub(super) fn words(line: &str) -> impl Iterator<Item = &str> + Clone {
    let words = line.split(|c: char| c == ',' || c.is_whitespace());
    words.filter(|word| !word.is_empty())
}

/// The rows of a text that have words, with their lines; what begins with `#` is a comment.
pub(super) fn rows(text: &str) -> impl Iterator<Item = (Place, &str)> + Clone {
    let lines = text.lines().enumerate();
    let lines = lines.map(|(line, text)| (Place::Line(line + 1), text.trim()));
    lines.filter(|(_, text)| !text.is_empty() && !text.starts_with('#'))
}

/// A row of exactly this many finite numbers.
///
/// # Errors
/// [`Wanted::Number`], [`Cause::NumberCount`], [`Cause::NotFinite`], with the place.
pub(super) fn numbers<const N: usize>(place: &Place, row: &str) -> Result<[f64; N]> {
    let (mut numbers, mut found) = ([0.0; N], 0);
    for word in words(row) {
        let number: f64 = word
            .parse()
            .map_err(|_| place.clone().expected(Wanted::Number))?;
        if !number.is_finite() {
            return Err(place.clone().wrong(Cause::NotFinite));
        }
        if let Some(place) = numbers.get_mut(found) {
            *place = number;
        }
        found += 1;
    }
    if found != N {
        return Err(place.clone().wrong(Cause::NumberCount { wanted: N, found }));
    }
    Ok(numbers)
}

/// The first row of numbers; a heading may come before it.
fn first_row(beginning: &str) -> Option<&str> {
    let is_row = |row: &&str| words(row).all(|word| word.parse::<f64>().is_ok());
    // The last row may be cut off.
    let mut rows = rows(beginning).map(|(_, row)| row).take(2);
    rows.find(is_row)
}

/// Whether the first row has commas.
pub(super) fn with_commas(beginning: &str) -> bool {
    first_row(beginning).is_some_and(|row| row.contains(','))
}

/// The numbers of the first row, if there are so many; a heading may come before it.
pub(super) fn first<const N: usize>(beginning: &str) -> Option<[f64; N]> {
    numbers(&Place::Whole, first_row(beginning)?).ok()
}

/// Whether the last four numbers of a row are nearly a quaternion of length 1.
pub(super) fn turns_last(row: [f64; 8]) -> bool {
    let [.., x, y, z, w] = row;
    (DQuat::from_xyzw(x, y, z, w).length() - 1.0).abs() < 0.1
}

/// Appends numbers with as many digits as give the same bits, with a sign between them.
pub(super) fn push(text: &mut Vec<u8>, numbers: impl IntoIterator<Item = f64>, between: &str) {
    for (at, number) in numbers.into_iter().enumerate() {
        let between = if at == 0 { "" } else { between };
        // Writing into a vector cannot fail.
        let _ = write!(text, "{between}{number:?}");
    }
}

/// Appends `[[a, b], [c, d]]`, the numbers as [`push`] does.
pub(super) fn push_matrix<const N: usize>(
    text: &mut Vec<u8>,
    rows: impl IntoIterator<Item = [f64; N]>,
) {
    for (at, row) in rows.into_iter().enumerate() {
        text.extend_from_slice(if at == 0 { b"[[" } else { b", [" });
        push(text, row, ", ");
        text.push(b']');
    }
    text.push(b']');
}

const POSE: usize = 10;

/// Whether this begins like poses, with commas or without.
pub(super) fn is_poses(beginning: &str, commas: bool) -> bool {
    let row = first_row(beginning);
    let wide = row.is_some_and(|row| matches!(words(row).count(), POSE..=12));
    // Twelve numbers without commas may be a matrix.
    wide && beginning.contains(',') == commas && (commas || !is_matrix(beginning))
}

/// The poses in a text, with or without frame numbers before and seconds behind, all alike; a
/// heading on line 1 is skipped.
///
/// # Errors
/// [`Wanted::Number`], [`Cause::NumberCount`], [`Cause::NotFinite`] with the line.
pub(super) fn poses_of_text(text: &str) -> Result<Recording> {
    let mut recording = Recording::default();
    let (mut frames, mut seconds): (Vec<f64>, Vec<f64>) = (Vec::new(), Vec::new());
    let mut width = None;
    for (line, row) in text.lines().enumerate() {
        let place = Place::Line(line + 1);
        let (mut numbers, mut found, mut read) = ([0.0_f64; POSE + 2], 0, true);
        for word in words(row) {
            let number = word.parse();
            read &= number.is_ok();
            if let (Ok(number), Some(place)) = (number, numbers.get_mut(found)) {
                *place = number;
            }
            found += 1;
        }
        match (read, found) {
            (_, 0) => continue,
            (false, _) if line == 0 => continue,
            (false, _) => return Err(place.expected(Wanted::Number)),
            (true, _) => {}
        }
        let first = if (POSE..=POSE + 2).contains(&found) {
            found
        } else {
            POSE
        };
        let wanted = *width.get_or_insert(first);
        if found != wanted {
            return Err(place.wrong(Cause::NumberCount { wanted, found }));
        }
        if !numbers.iter().all(|number| number.is_finite()) {
            return Err(place.wrong(Cause::NotFinite));
        }
        if found > POSE {
            frames.try_reserve(1)?;
            frames.push(numbers[0]);
            if found == POSE + 2 {
                seconds.try_reserve(1)?;
                seconds.push(numbers[POSE + 1]);
            }
            numbers.rotate_left(1);
        }
        let vector = |at: usize| [numbers[at], numbers[at + 1], numbers[at + 2]];
        recording.push(Pose {
            vrp: vector(0),
            vpn: vector(3),
            vup: vector(6),
            zoom: numbers[9],
        })?;
    }
    recording.frames = (width > Some(POSE)).then_some(frames);
    recording.seconds = (width > Some(POSE + 1)).then_some(seconds);
    Ok(recording)
}

/// Whether this begins with a matrix that turns.
pub(super) fn is_matrix(beginning: &str) -> bool {
    first(beginning)
        .is_some_and(|row| convention::rotation_of(DMat3::from_mat4(matrix(row))).is_ok())
}

/// A matrix of three rows as one of four.
pub(super) fn matrix(row: [f64; 12]) -> DMat4 {
    let mut rows = [0.0; 16];
    rows[..12].copy_from_slice(&row);
    rows[15] = 1.0;
    DMat4::from_cols_array(&rows).transpose()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_with_and_without_frames_are_poses() {
        let text = "frame,x\n1,0,0,0,0,0,-1,0,1,0,24\n\n3 1 2 3 0 0 -1 0 1 0 35\n";
        let Recording {
            poses,
            frames,
            seconds,
            ..
        } = poses_of_text(text).unwrap();
        assert_eq!((frames, seconds), (Some(vec![1.0, 3.0]), None));
        assert_eq!(poses[1].vrp, [1.0, 2.0, 3.0]);
        assert_eq!(poses[1].zoom, 35.0);
        let text = "frame,zoom,seconds\n1,1,2,3,0,0,-1,0,1,0,35,0.0\n2,0,0,0,0,0,-1,0,1,0,24,0.04";
        let Recording {
            poses,
            frames,
            seconds,
            ..
        } = poses_of_text(text).unwrap();
        assert_eq!(
            (frames, seconds),
            (Some(vec![1.0, 2.0]), Some(vec![0.0, 0.04]))
        );
        assert_eq!((poses[0].vrp, poses[0].zoom), ([1.0, 2.0, 3.0], 35.0));
        let Recording { poses, frames, .. } = poses_of_text("0 0 0 0 0 -1 0 1 0 24").unwrap();
        assert_eq!((poses.len(), frames), (1, None));
        for (text, said) in [
            ("1 2 3", "line 1: expected 10 numbers, found 3"),
            (
                "1 2 3 4 5 6 7 8 9 10 11 12 13",
                "line 1: expected 10 numbers, found 13",
            ),
            (
                "0 0 0 0 0 -1 0 1 0 24\n0 a 0 0 0 -1 0 1 0 24",
                "line 2: expected a number",
            ),
        ] {
            assert_eq!(poses_of_text(text).unwrap_err().to_string(), said);
        }
    }
}
