//! Tools on paths: `transform`, `deform`, `blend` and others.

use std::path::PathBuf;

use clap::{Args, Subcommand, ValueEnum};
use vides::deform::{Bounds, Deformation};
use vides::document::{Document, Edit};
use vides::glam::{DQuat, DVec3};
use vides::limits::MAX_FRAMES;
use vides::path::CameraPath;
use vides::tools::block::{self, Fit};
use vides::tools::{blend, transform};

use super::failure::Failure;
use super::output::Output;
use super::{input, moves};

#[derive(Subcommand)]
pub(super) enum Tool {
    /// Moves, turns, scales or mirrors points of a path
    Transform(Transform),
    /// Tapers, twists, bends or free-form deforms points of a path
    Deform(Deform),
    /// Extracts a range of points as a new path
    Extract(Extract),
    /// Inserts a path into another
    Insert(Insert),
    /// Reverses a path
    Reverse {
        /// The path; - is standard input
        #[arg(value_name = "FILE.vid")]
        file: PathBuf,
        #[command(flatten)]
        output: Output,
    },
    /// Repeats a path
    Repeat {
        /// The path; - is standard input
        #[arg(value_name = "FILE.vid")]
        file: PathBuf,
        /// The number of times
        #[arg(value_name = "TIMES")]
        times: usize,
        #[command(flatten)]
        output: Output,
    },
    /// Sets the number of frames of a path, or of part of it
    Frames {
        /// The path; - is standard input
        #[arg(value_name = "FILE.vid")]
        file: PathBuf,
        /// The number of frames, including the first and last; or seconds: 10s
        #[arg(value_name = "COUNT", value_parser = length)]
        count: Length,
        /// The points, as in 2-5 [default: all]
        #[arg(long, value_name = "POINTS", value_parser = range)]
        points: Option<Range>,
        #[command(flatten)]
        output: Output,
    },
    /// Blends paths by weights that sum to 1
    Blend {
        /// The paths
        #[arg(value_name = "FILE.vid", required = true, num_args = 2..)]
        files: Vec<PathBuf>,
        /// A weight for each path [default: equal weights]
        #[arg(long, value_name = "NUMBERS", value_parser = list, allow_hyphen_values = true)]
        weights: Option<Numbers>,
        #[command(flatten)]
        output: Output,
    },
}

#[derive(Clone)]
pub(super) struct Numbers(pub(super) Vec<f64>);

pub(super) fn list(text: &str) -> Result<Numbers, String> {
    moves::numbers(text).map(Numbers)
}

fn vector(text: &str) -> Result<DVec3, String> {
    match moves::numbers(text)?[..] {
        [x, y, z] => Ok(DVec3::new(x, y, z)),
        _ => Err("three numbers with commas between are needed".to_owned()),
    }
}

/// The wanted duration of a path.
#[derive(Clone, Copy)]
pub(super) enum Length {
    Frames(usize),
    Seconds(f64),
}

fn length(text: &str) -> Result<Length, String> {
    let wrong = || "a number of frames is needed, or seconds as 10s".to_owned();
    let Some(seconds) = text.strip_suffix('s') else {
        return text.parse().map(Length::Frames).map_err(|_| wrong());
    };
    match seconds.trim_end().parse::<f64>() {
        Ok(seconds) if seconds > 0.0 && seconds.is_finite() => Ok(Length::Seconds(seconds)),
        _ => Err(wrong()),
    }
}

/// The frames of a duration, at most those that a film may have.
fn whole_frames(seconds: f64, fps: f64) -> Result<usize, Failure> {
    let frames = (seconds * fps).round();
    if frames > MAX_FRAMES as f64 {
        return Err(Failure::Input(format!(
            "{seconds:e} seconds are too many: a film has at most {MAX_FRAMES} frames, {:.0} seconds \
             at {fps} frames a second",
            MAX_FRAMES as f64 / fps
        )));
    }
    Ok(frames as usize)
}

#[derive(Clone, Copy)]
pub(super) struct Range {
    first: usize,
    last: usize,
}

fn range(text: &str) -> Result<Range, String> {
    let (first, last) = text.split_once('-').unwrap_or((text, text));
    match (first.trim().parse(), last.trim().parse()) {
        (Ok(first), Ok(last)) if first > 0 && last > 0 => Ok(Range { first, last }),
        _ => Err("points are given as 3 or 2-5, counted from 1".to_owned()),
    }
}

/// Indices of the points in `range`, by default all.
fn picked(range: Option<Range>, path: &CameraPath) -> Result<Vec<usize>, Failure> {
    let count = path.points.len();
    let Range { first, last } = range.unwrap_or(Range {
        first: 1,
        last: count,
    });
    if first > last || last > count {
        return Err(Failure::Input(format!(
            "there are no points {first} to {last}: the path has points 1 to {count}"
        )));
    }
    Ok((first - 1..last).collect())
}

#[derive(Clone, Copy, Default, ValueEnum)]
enum Axis {
    X,
    #[default]
    Y,
    Z,
}

impl Axis {
    fn unit(self) -> DVec3 {
        match self {
            Self::X => DVec3::X,
            Self::Y => DVec3::Y,
            Self::Z => DVec3::Z,
        }
    }
}

#[derive(Args)]
pub(super) struct Transform {
    /// The path; - is standard input
    #[arg(value_name = "FILE.vid")]
    file: PathBuf,
    /// The points, as in 3 or 2-5 [default: all]
    #[arg(long, value_name = "POINTS", value_parser = range)]
    points: Option<Range>,
    /// Moves by this vector, last
    #[arg(long = "move", value_name = "X,Y,Z", value_parser = vector, allow_hyphen_values = true)]
    by: Option<DVec3>,
    /// Turns by this many degrees about --axis
    #[arg(long, value_name = "DEGREES", allow_hyphen_values = true)]
    turn: Option<f64>,
    /// The axis of --turn
    #[arg(long, value_enum, default_value_t)]
    axis: Axis,
    /// Scales by this factor
    #[arg(long, value_name = "FACTOR", allow_hyphen_values = true)]
    scale: Option<f64>,
    /// Mirrors along this axis
    #[arg(long, value_enum)]
    mirror: Option<Axis>,
    /// The fixed point [default: the middle of the points]
    #[arg(long, value_name = "X,Y,Z", value_parser = vector, allow_hyphen_values = true)]
    about: Option<DVec3>,
    /// Transforms the targets too
    #[arg(long)]
    with_targets: bool,
    #[command(flatten)]
    output: Output,
}

#[derive(Args)]
pub(super) struct Deform {
    /// The path; - is standard input
    #[arg(value_name = "FILE.vid")]
    file: PathBuf,
    /// taper, twist, bend or free-form
    #[arg(value_name = "KIND")]
    kind: String,
    /// Its numbers: an axis (0, 1, 2), then those listed in vides(1)
    #[arg(value_name = "NUMBER", allow_negative_numbers = true)]
    numbers: Vec<f64>,
    /// The points, as in 3 or 2-5 [default: all]
    #[arg(long, value_name = "POINTS", value_parser = range)]
    points: Option<Range>,
    /// The box: least x,y,z, then greatest x,y,z [default: the bounds of the points]
    #[arg(long = "box", value_name = "NUMBERS", value_parser = list, allow_hyphen_values = true)]
    bounds: Option<Numbers>,
    /// Deforms the targets too
    #[arg(long)]
    with_targets: bool,
    #[command(flatten)]
    output: Output,
}

#[derive(Args)]
pub(super) struct Extract {
    /// The path; - is standard input
    #[arg(value_name = "FILE.vid")]
    file: PathBuf,
    /// The points, as in 2-5; on a closed path also 5-2
    #[arg(long, value_name = "POINTS", value_parser = range)]
    points: Range,
    #[command(flatten)]
    output: Output,
}

#[derive(Args)]
pub(super) struct Insert {
    /// The path; - is standard input
    #[arg(value_name = "FILE.vid")]
    file: PathBuf,
    /// The path to insert
    #[arg(value_name = "BLOCK.vid")]
    block: PathBuf,
    /// The point to insert it after [default: the last]
    #[arg(long, value_name = "POINT")]
    at: Option<usize>,
    /// How it is placed
    #[arg(long, value_enum, default_value_t)]
    fit: FitName,
    /// Keeps its absolute targets in place
    #[arg(long)]
    keep_targets: bool,
    #[command(flatten)]
    output: Output,
}

#[derive(Clone, Copy, Default, ValueEnum)]
enum FitName {
    /// Unchanged
    None,
    /// Moved to begin at the point
    #[default]
    Move,
    /// Also turned into the direction of travel
    Turn,
    /// Moved, turned and scaled to end at the next point
    Scale,
}

/// Checks a point counted from 1.
fn check_point(at: usize, count: usize) -> Result<(), Failure> {
    if at == 0 || at > count {
        return Err(Failure::Input(format!(
            "there is no point {at}: the path has points 1 to {count}"
        )));
    }
    Ok(())
}

pub(super) fn run(tool: &Tool) -> Result<(), Failure> {
    match tool {
        Tool::Transform(arguments) => transform(arguments),
        Tool::Deform(arguments) => deform(arguments),
        Tool::Extract(arguments) => {
            let (path, info) = input::load(&arguments.file)?.into_parts();
            let Range { first, last } = arguments.points;
            check_point(first.max(last), path.points.len())?;
            let block = block::extract(&path, first - 1, last - 1)
                .map_err(|error| vides::Error::from(error).at(input::name(&arguments.file)))?;
            arguments.output.write(&Document::from_parts(block, info)?)
        }
        Tool::Insert(arguments) => {
            let document = input::load(&arguments.file)?;
            let count = document.path().points.len();
            let at = arguments.at.unwrap_or(count);
            check_point(at, count)?;
            let (block, _) = input::load(&arguments.block)?.into_parts();
            let insert = Edit::InsertPath {
                at: at - 1,
                block: Box::new(block),
                fit: match arguments.fit {
                    FitName::None => Fit::None,
                    FitName::Move => Fit::Move,
                    FitName::Turn => Fit::Turn,
                    FitName::Scale => Fit::Scale,
                },
                with_targets: !arguments.keep_targets,
            };
            arguments.output.applied(document, &arguments.file, insert)
        }
        Tool::Reverse { file, output } => output.edited(file, Edit::Reverse),
        Tool::Repeat {
            file,
            times,
            output,
        } => output.edited(file, Edit::Repeat(*times)),
        Tool::Frames {
            file,
            count,
            points,
            output,
        } => {
            let document = input::load(file)?;
            let points = picked(*points, document.path())?;
            let edit = Edit::FitFrames {
                first: points[0],
                last: points[points.len() - 1],
                frames: match *count {
                    Length::Frames(frames) => frames,
                    Length::Seconds(seconds) => whole_frames(seconds, document.info().fps)?,
                },
            };
            output.applied(document, file, edit)
        }
        Tool::Blend {
            files,
            weights,
            output,
        } => {
            let mut paths = Vec::new();
            let mut info = None;
            for file in files {
                let (path, of_file) = input::load(file)?.into_parts();
                info.get_or_insert(of_file);
                paths.push(path);
            }
            let same = || vec![1.0 / paths.len() as f64; paths.len()];
            let weights = weights.as_ref().map_or_else(same, |given| given.0.clone());
            let blend = blend::blend(&paths.iter().collect::<Vec<_>>(), &weights)?;
            output.write(&Document::from_parts(blend, info.unwrap_or_default())?)
        }
    }
}

fn transform(arguments: &Transform) -> Result<(), Failure> {
    let document = input::load(&arguments.file)?;
    let points = picked(arguments.points, document.path())?;
    let places = points.iter().map(|&at| document.path().points[at].position);
    let middle = places.sum::<DVec3>() / points.len() as f64;
    let about = arguments.about.unwrap_or(middle);
    let mut scale = DVec3::splat(arguments.scale.unwrap_or(1.0));
    if let Some(axis) = arguments.mirror {
        scale *= 1.0 - 2.0 * axis.unit();
    }
    let angle = arguments.turn.unwrap_or(0.0).to_radians();
    let turn = DQuat::from_axis_angle(arguments.axis.unit(), angle);
    let by = arguments.by.unwrap_or(DVec3::ZERO);
    let matrix = transform::matrix(about, scale, turn, by);
    let edit = Edit::TransformPoints {
        points,
        matrix,
        with_targets: arguments.with_targets,
    };
    arguments.output.applied(document, &arguments.file, edit)
}

fn deform(arguments: &Deform) -> Result<(), Failure> {
    let document = input::load(&arguments.file)?;
    let bounds = match arguments.bounds.as_ref().map(|given| &given.0[..]) {
        None => None,
        Some(&[a, b, c, d, e, f]) => Some(Bounds::new(DVec3::new(a, b, c), DVec3::new(d, e, f))?),
        Some(_) => return Err(Failure::Usage("--box takes six numbers".to_owned())),
    };
    let edit = Edit::DeformPoints {
        points: picked(arguments.points, document.path())?,
        deformation: Deformation::new(&arguments.kind, &arguments.numbers)?,
        bounds,
        with_targets: arguments.with_targets,
    };
    arguments.output.applied(document, &arguments.file, edit)
}
