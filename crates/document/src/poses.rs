//! Recorded poses as text, as [`super::export`] writes them: with or without frame numbers before
//! and seconds behind.

use std::io::Read;
use std::path::Path;

use super::vid;
use crate::error::{Error, Key, Malformed, Result, Value};
use crate::path::Pose;

/// Poses, and their frame numbers and seconds if each has some.
pub type Recorded = (Vec<Pose>, Option<Vec<f64>>, Option<Vec<f64>>);

const POSE: usize = 10;

/// The poses in a file.
///
/// # Errors
/// [`Error::Io`]; those of [`poses_of_text`] with the file.
pub fn load_poses(file: &Path) -> Result<Recorded> {
    vid::load(file, poses_of_text)
}

/// As [`load_poses`], from `reader`, which messages call `name`.
///
/// # Errors
/// As [`load_poses`].
pub fn load_poses_from(reader: &mut dyn Read, name: &str) -> Result<Recorded> {
    vid::load_from(reader, name, poses_of_text)
}

/// The poses in a text, numbers separated by commas or blanks; a heading on line 1 is skipped.
///
/// # Errors
/// [`Error::Format`] with the line; `ErrorKind::Memory`.
pub fn poses_of_text(text: &str) -> Result<Recorded> {
    let (mut poses, mut frames): (Vec<Pose>, Vec<f64>) = (Vec::new(), Vec::new());
    let mut seconds: Vec<f64> = Vec::new();
    for (line, words) in text.lines().enumerate() {
        let wrong = |cause| Error::Format {
            line: line + 1,
            key: Key(None),
            cause,
        };
        let words = words.split(|c: char| c == ',' || c.is_whitespace());
        let words = words.filter(|word| !word.is_empty());
        let (mut numbers, mut found, mut read) = ([0.0; POSE + 2], 0, true);
        for word in words {
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
            (false, _) => {
                return Err(wrong(Malformed::Expected {
                    wanted: Value::Number,
                    found: Value::Text,
                }));
            }
            (true, POSE) => {}
            (true, found) if found == POSE + 1 || found == POSE + 2 => {
                frames.try_reserve(1)?;
                frames.push(numbers[0]);
                if found == POSE + 2 {
                    seconds.try_reserve(1)?;
                    seconds.push(numbers[POSE + 1]);
                }
                numbers.rotate_left(1);
            }
            (true, found) => {
                return Err(wrong(Malformed::NumberCount {
                    wanted: POSE,
                    found,
                }));
            }
        }
        let vector = |at: usize| [numbers[at], numbers[at + 1], numbers[at + 2]];
        poses.try_reserve(1)?;
        poses.push(Pose {
            vrp: vector(0),
            vpn: vector(3),
            vup: vector(6),
            zoom: numbers[9],
        });
    }
    let all = [&frames, &seconds].map(|column| column.len() == poses.len());
    Ok((poses, all[0].then_some(frames), all[1].then_some(seconds)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_with_and_without_frames_are_poses() {
        let text = "frame,x\n1,0,0,0,0,0,-1,0,1,0,24\n\n3 1 2 3 0 0 -1 0 1 0 35\n";
        let (poses, frames, seconds) = poses_of_text(text).unwrap();
        assert_eq!((frames, seconds), (Some(vec![1.0, 3.0]), None));
        assert_eq!(poses[1].vrp, [1.0, 2.0, 3.0]);
        assert_eq!(poses[1].zoom, 35.0);
        let text = "frame,zoom,seconds\n1,1,2,3,0,0,-1,0,1,0,35,0.0\n2,0,0,0,0,0,-1,0,1,0,24,0.04";
        let (poses, frames, seconds) = poses_of_text(text).unwrap();
        assert_eq!(
            (frames, seconds),
            (Some(vec![1.0, 2.0]), Some(vec![0.0, 0.04]))
        );
        assert_eq!((poses[0].vrp, poses[0].zoom), ([1.0, 2.0, 3.0], 35.0));
        let (poses, frames, _) = poses_of_text("0 0 0 0 0 -1 0 1 0 24").unwrap();
        assert_eq!((poses.len(), frames), (1, None));
        for (text, said) in [
            ("1 2 3", "line 1: expected 10 numbers, found 3"),
            (
                "1 2 3 4 5 6 7 8 9 10 11 12 13",
                "line 1: expected 10 numbers, found 13",
            ),
            (
                "0 0 0 0 0 -1 0 1 0 24\n0 a 0 0 0 -1 0 1 0 24",
                "line 2: expected a number, found a text",
            ),
        ] {
            assert_eq!(poses_of_text(text).unwrap_err().to_string(), said);
        }
    }
}
