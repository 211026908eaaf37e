//! `vides sample`: writes every pose of a path.

use std::io::{self, BufWriter, IsTerminal, Write};
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use vides::document::{At, Document, Edit, SceneDocument};
use vides::formats::{self, Flight, MAX_DECIMALS, Options, Report, export, export_to};

use super::failure::{Failure, output_failed};
use super::output::{self, Sink};
use super::progress::Bar;
use super::{input, scene};

#[derive(Args)]
pub(super) struct Arguments {
    /// The path; - is standard input
    #[arg(value_name = "FILE.vid")]
    file: PathBuf,

    /// The output file; - is standard output. An existing file is replaced only when
    /// everything is written
    #[arg(short, long, value_name = "OUT", default_value = "-")]
    output: PathBuf,

    /// The output format
    #[arg(long, value_enum, default_value_t)]
    format: Format,

    /// Decimals of the format ascii, at most 30 [default: 4]
    #[arg(long, value_name = "NUMBER", value_parser = decimals, allow_negative_numbers = true)]
    digits: Option<usize>,

    /// A node of a scene, at every frame: cameras and lights as poses, others as
    /// matrices (16 numbers, column by column)
    #[arg(long, value_name = "NAME")]
    node: Option<String>,

    /// A function of the type V_INTERPOLATE for the interpolation "host:NAME" of a scene's tracks
    #[arg(long, value_name = "NAME=FILE.so:SYMBOL")]
    interpolation: Vec<String>,

    #[command(flatten)]
    speeds: Speeds,
}

#[derive(Clone, Copy, Default, ValueEnum)]
enum Format {
    /// Ten numbers per line, four decimals: VRP, VPN, VUP (x y z each) and zoom
    #[default]
    Ascii,
    /// A header, then frame number, ten numbers and seconds, all digits
    Csv,
    /// Title, frames per second and the poses, all digits
    Json,
}

fn decimals(text: &str) -> Result<usize, String> {
    match text.parse() {
        Ok(digits) if digits <= MAX_DECIMALS => Ok(digits),
        _ => Err(format!("a whole number from 0 to {MAX_DECIMALS} is needed")),
    }
}

impl Arguments {
    fn format(&self) -> Result<&'static formats::Format, Failure> {
        let name = match self.format {
            Format::Ascii => "ascii",
            Format::Csv => "csv",
            Format::Json => "json",
        };
        if self.digits.is_some() && name != "ascii" {
            return Err(Failure::Usage(
                "--digits goes with the format ascii; csv and json have all digits".to_owned(),
            ));
        }
        Ok(formats::by_name(name)?)
    }
}

/// Base speeds: greater than 0, each instead of the file's own.
#[derive(Args)]
#[command(next_help_heading = "Base speeds, instead of the file's; each > 0")]
struct Speeds {
    /// Frames for moving by half the edge of the space, at speed 50
    #[arg(long, value_name = "FRAMES", value_parser = base_speed, allow_negative_numbers = true)]
    move_frames: Option<f64>,

    /// Frames for a turn of 180 degrees at speed 50
    #[arg(long, value_name = "FRAMES", value_parser = base_speed, allow_negative_numbers = true)]
    turn_frames: Option<f64>,

    /// Frames for a zoom from 1 to 100 mm at speed 50
    #[arg(long, value_name = "FRAMES", value_parser = base_speed, allow_negative_numbers = true)]
    zoom_frames: Option<f64>,

    /// Frames for a roll of 90 degrees at speed 50
    #[arg(long, value_name = "FRAMES", value_parser = base_speed, allow_negative_numbers = true)]
    roll_frames: Option<f64>,
}

fn base_speed(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(speed) if speed > 0.0 && speed.is_finite() => Ok(speed),
        Ok(_) => Err("a base speed must be finite and greater than 0".to_owned()),
        Err(_) => Err("this is not a number".to_owned()),
    }
}

impl Speeds {
    fn are_given(&self) -> bool {
        let all = [
            self.move_frames,
            self.turn_frames,
            self.zoom_frames,
            self.roll_frames,
        ];
        all.iter().any(Option::is_some)
    }

    fn apply(&self, document: &mut Document) -> vides::Result<()> {
        let mut speeds = document.path().base_frames;
        for (given, speed) in [
            (self.move_frames, &mut speeds.movement),
            (self.turn_frames, &mut speeds.turning),
            (self.zoom_frames, &mut speeds.zoom),
            (self.roll_frames, &mut speeds.rolling),
        ] {
            if let Some(given) = given {
                *speed = given;
            }
        }
        document.apply(Edit::set(At::Path, "base_speeds", speeds))
    }
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let (file, out) = (&arguments.file, &arguments.output);
    let format = arguments.format()?;
    for interpolation in &arguments.interpolation {
        scene::register(interpolation)?;
    }
    let mut document = input::load_whole(file)?.without_history();
    if arguments.speeds.are_given() {
        if arguments.node.is_some() || document.edited_scene().is_some() {
            let reason = "base speeds are those of a path, not of a node of a scene";
            return Err(Failure::Usage(reason.to_owned()));
        }
        arguments
            .speeds
            .apply(&mut document)
            .map_err(|error| error.at(input::name(file)))?;
    }
    let options = Options {
        node: arguments.node.clone(),
        digits: arguments.digits,
        ..Options::default()
    };
    let name = input::name(file);
    let scene = document.scene_document().map_err(|error| error.at(&name))?;
    write_out(&scene, &name, out, format, &options).map(drop)
}

/// Writes to standard output, a pipe or a file, with a progress bar on a terminal. What is wrong
/// with the document is reported before any file is touched, with its `name`.
pub(super) fn write_out(
    document: &SceneDocument,
    name: &str,
    out: &Path,
    format: &formats::Format,
    options: &Options,
) -> Result<Report, Failure> {
    let named = |error: formats::Error| Failure::from(error.at(name));
    Flight::new(document, options, format, &mut |_, _| {}).map_err(named)?;
    let sink = Sink::of(out)?;
    let to_standard_output = matches!(sink, Sink::Standard);
    // Poses printed on a terminal are progress enough.
    let shown = io::stderr().is_terminal() && !(to_standard_output && io::stdout().is_terminal());
    let mut bar = shown.then(|| Bar::new(io::stderr(), Some("frames")));
    let mut progress = |done, all| {
        if let Some(bar) = &mut bar {
            bar.update(done, all);
        }
    };
    let mut stream: Box<dyn Write> = match sink {
        // Locked once, and without the line buffering of standard output.
        Sink::Standard => Box::new(BufWriter::with_capacity(BUFFER, io::stdout().lock())),
        Sink::Stream(stream) => Box::new(BufWriter::with_capacity(BUFFER, stream)),
        Sink::File => return export(document, out, format, options, &mut progress).map_err(named),
    };
    let failed = |source| match to_standard_output {
        true => output_failed(&source),
        false => output::failed(out, source),
    };
    let report = export_to(document, &mut stream, format, options, &mut progress);
    let report = report.map_err(|error| match error {
        formats::Error::Document(vides::Error::Io { source, .. }) => failed(source),
        other => named(other),
    })?;
    stream.flush().map_err(failed)?;
    Ok(report)
}

const BUFFER: usize = 1 << 16;
