//! `vides fit`: recorded poses become a path of few points.

use std::fs;
use std::io::{self, IsTerminal, Read};
use std::path::PathBuf;

use clap::Args;
use vides::document::{Document, Info};
use vides::error::reason;
use vides::path::Pose;
use vides::tools::fit::{Tolerance, fit};

use super::output::Output;
use super::progress::Bar;
use super::{Failure, input};

#[derive(Args)]
pub(super) struct Arguments {
    /// The poses, as `vides sample` writes them: ten numbers a line, or the
    /// frame's number before them; - is standard input
    #[arg(value_name = "POSES")]
    file: PathBuf,
    /// How far a position may be from its pose
    #[arg(long, value_name = "LENGTH", default_value_t = 0.01)]
    tolerance: f64,
    /// How far view, up and field of view may be from theirs
    #[arg(long, value_name = "DEGREES", default_value_t = 0.5)]
    angle: f64,
    /// Frames in a second
    #[arg(long, value_name = "NUMBER", default_value_t = 25.0)]
    fps: f64,
    #[command(flatten)]
    output: Output,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let name = input::name(&arguments.file);
    let text = if input::is_standard_stream(&arguments.file) {
        let mut text = String::new();
        io::stdin().lock().read_to_string(&mut text).map(|_| text)
    } else {
        fs::read_to_string(&arguments.file)
    };
    let text = text.map_err(|error| Failure::Input(format!("{name}: {}", reason(&error))))?;
    let (poses, frames) = poses(&text).map_err(|said| Failure::Input(format!("{name}: {said}")))?;
    let seconds: Vec<f64> = frames.iter().map(|frame| frame / arguments.fps).collect();
    let times = (seconds.len() == poses.len()).then_some(&seconds[..]);
    let tolerance = Tolerance {
        position: arguments.tolerance,
        angle: arguments.angle,
    };
    let mut bar = io::stderr().is_terminal().then(|| Bar::new(io::stderr()));
    let path = fit(&poses, times, arguments.fps, tolerance, &mut |done, all| {
        if let Some(bar) = &mut bar {
            bar.update(done, all);
        }
        true
    })
    .map_err(|error| vides::Error::from(error).at(name))?;
    let info = Info {
        fps: arguments.fps,
        ..Info::default()
    };
    arguments.output.write(&Document::from_parts(path, info)?)
}

/// Poses, and their frames where there are such; a first line of headings is passed.
fn poses(text: &str) -> Result<(Vec<Pose>, Vec<f64>), String> {
    let (mut poses, mut frames) = (Vec::new(), Vec::new());
    for (line, words) in text.lines().enumerate() {
        let words = words.split(|c: char| c == ',' || c.is_whitespace());
        let words: Vec<&str> = words.filter(|word| !word.is_empty()).collect();
        let numbers: Option<Vec<f64>> = words.iter().map(|word| word.parse().ok()).collect();
        let Some(numbers) = numbers else {
            if line == 0 {
                continue;
            }
            return Err(format!(
                "line {}: there is a word that is no number",
                line + 1
            ));
        };
        let numbers = match numbers.len() {
            0 => continue,
            10 => &numbers[..],
            11 => {
                frames.push(numbers[0]);
                &numbers[1..]
            }
            count => return Err(format!("line {}: {count} numbers are no pose", line + 1)),
        };
        let vector = |at: usize| [numbers[at], numbers[at + 1], numbers[at + 2]];
        poses.push(Pose {
            vrp: vector(0),
            vpn: vector(3),
            vup: vector(6),
            zoom: numbers[9],
        });
    }
    Ok((poses, frames))
}
