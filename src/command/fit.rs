//! `vides fit`: recorded poses become a path of few points.

use std::path::PathBuf;

use clap::{Args, Command};
use vides::document::{Document, Info};
use vides::formats::{self, Recording, Report};
use vides::path::{Space, Up};
use vides::tools::fit::{self, Tolerance, fit, fit_points};

use super::call::Call;
use super::failure::{Failure, complain, one_line};
use super::given::exactly;
use super::input;
use super::moves::up;
use super::progress::progress;

/// What it reads.
pub(super) const INPUT: &str = "The poses, as `vides sample` writes them: ten numbers per line, \
     optionally with the frame number before and the seconds after (the frame gives the time, at \
     --fps); - is standard input";

#[derive(Args)]
struct Options {
    /// Frames per second [default: the file's, else its poses per second, else 25]
    #[arg(long, value_name = "NUMBER")]
    fps: Option<f64>,
    /// The object to show with the path: a mesh (.obj, .ply, .stl, .gltf, .glb),
    /// or the object of a .vid file
    #[arg(long, value_name = "FILE")]
    object: Option<PathBuf>,
    /// The up axis
    #[arg(long, value_name = "AXIS", value_parser = up(), default_value = "y")]
    up: Up,
    /// The space of the path: its centre and half its size [default: fits the positions,
    /// with a margin of a tenth]
    #[arg(long, value_name = "X,Y,Z,HALF", value_parser = exactly::<4>, allow_hyphen_values = true)]
    space: Option<[f64; 4]>,
}

pub(super) fn declare(command: Command) -> Command {
    Options::augment_args(command).mut_arg("tolerance", |arg| {
        arg.help(
            "Maximum distance of a position from its pose; greater than 0 [default: 1/1000 of the \
             diagonal of the bounds of the positions]",
        )
    })
}

/// Warns where the seconds of poses differ from their frames, whose times are used.
fn compare(name: &str, frames: &[f64], seconds: &[f64], fps: f64) {
    let (Some(frame), Some(second)) = (frames.first(), seconds.first()) else {
        return;
    };
    let off = frames.iter().zip(seconds).position(|(at, when)| {
        let off = (when - second) * fps - (at - frame);
        !(off.abs() <= 0.5)
    });
    if let Some(off) = off {
        complain(&format!(
            "{name}: the times are those of the frames at {fps} frames a second; by the column of \
             seconds pose {} would be at {} s, by its frame it is at {} s",
            off + 1,
            seconds[off] - second,
            (frames[off] - frame) / fps
        ));
    }
}

/// Which poses are left out, by the numbers of their frames or counted from 1.
fn told(left_out: &[usize], all: usize, frames: Option<&[f64]>) -> String {
    let count = left_out.len();
    let are = if count == 1 { "is" } else { "are" };
    let mut text = format!("{count} of {all} poses {are} left out");
    let kind = if frames.is_some() { "frame" } else { "pose" };
    let numbers = left_out.iter().take(LISTED).map(|k| match frames {
        Some(frames) => frames[*k].to_string(),
        None => (k + 1).to_string(),
    });
    let numbers: Vec<String> = numbers.collect();
    if count > 0 {
        let several = if count == 1 { "" } else { "s" };
        text += &format!(": {kind}{several} {}", numbers.join(", "));
    }
    if count > LISTED {
        text += &format!(" and {} more", count - LISTED);
    }
    text
}

/// The maximum number of ignored poses that a message lists.
const LISTED: usize = 50;

pub(super) fn run(call: &Call) -> Result<(), Failure> {
    let arguments: Options = call.more()?;
    let name = input::name(call.file());
    let object = arguments.object.as_deref().map(input::object).transpose()?;
    let mut report = Report::default();
    let source = input::source(call.file())?;
    let recording = formats::recording(&source, None, &formats::Options::default(), &mut report)?;
    for loss in report.losses() {
        complain(&one_line(&format!("{name}: {loss}")));
    }
    let fps = arguments.fps.or(recording.rate()).unwrap_or(25.0);
    let Recording {
        poses,
        frames,
        seconds,
        ..
    } = recording;
    let by_frames = |frames: &Vec<f64>| frames.iter().map(|frame| frame / fps).collect();
    let times: Option<Vec<f64>> = frames.as_ref().map(by_frames).or_else(|| seconds.clone());
    let usual = Tolerance::usual(&poses);
    let robust = call.number("robust") != 0.0;
    let options = fit::Options {
        tolerance: Tolerance {
            position: call.given.number("tolerance").unwrap_or(usual.position),
            angle: call.given.number("angle").unwrap_or(usual.angle),
        },
        space: arguments.space.map(|[x, y, z, half_size]| Space {
            centre: [x, y, z].into(),
            half_size,
            up: arguments.up,
        }),
        up: arguments.up,
        robust,
    };
    let times = times.as_deref();
    let go_on = &mut progress("poses");
    // Whole and not negative, by the table.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    let fitted = match call.number("points") as usize {
        0 => fit(&poses, times, fps, &options, go_on),
        points => fit_points(&poses, times, fps, &options, points, go_on).map(|made| made.0),
    };
    let fitted = fitted.map_err(|error| vides::Error::from(error).at(name.clone()))?;
    if let (Some(frames), Some(seconds)) = (&frames, &seconds) {
        compare(&name, frames, seconds, fps);
    }
    let first = frames.as_ref().and_then(|frames| frames.first());
    let info = Info {
        fps,
        first_frame: first.map_or(1, |first| first.round() as i32),
        object: object.unwrap_or_default(),
        ..Info::default()
    };
    for line in fitted.report.to_string().lines() {
        complain(&format!("{name}: {line}"));
    }
    if robust {
        complain(&told(&fitted.left_out, poses.len(), frames.as_deref()));
    }
    let document = Document::from_parts(fitted.path, info)?;
    call.output.write(&document)
}
