//! `vides move`: a path by a ready-made move. Its options are the engine's table.

use std::path::PathBuf;

use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::error::ErrorKind;
use clap::{Arg, ArgMatches, Args, Command, FromArgMatches};
use vides::deform::Bounds;
use vides::document::{Document, Info};
use vides::path::{Space, Up};
use vides::tools::moves::{MOVES, Move};
use vides::tools::{Parameter, Unit};

use super::failure::Failure;
use super::input;
use super::output::Output;

pub(super) struct Arguments {
    chosen: &'static Move,
    /// The numbers given, by parameter index.
    given: Vec<(usize, Vec<f64>)>,
    fps: f64,
    up: Option<Up>,
    object: Option<PathBuf>,
    output: PathBuf,
}

/// Numbers separated by commas.
pub(super) fn numbers(text: &str) -> Result<Vec<f64>, String> {
    text.split(',')
        .map(|number| match number.trim().parse::<f64>() {
            Ok(number) if number.is_finite() => Ok(number),
            _ => Err(format!("\"{number}\" is not a number")),
        })
        .collect()
}

/// An up axis.
pub(super) fn up() -> impl TypedValueParser<Value = Up> {
    PossibleValuesParser::new([Up::Y.name(), Up::Z.name()])
        .map(|name| if name == Up::Z.name() { Up::Z } else { Up::Y })
}

fn option(parameter: &'static Parameter) -> Arg {
    let value = match parameter.unit {
        _ if parameter.width == 3 => "X,Y,Z",
        Unit::One | Unit::Length | Unit::Count | Unit::Choice(_) | Unit::Switch | Unit::Lattice => {
            "NUMBER"
        }
        Unit::Degrees => "DEGREES",
        Unit::Zoom => "MM",
        Unit::Seconds => "SECONDS",
    };
    let default = [parameter.default.to_string()];
    let default = default.iter().cycle().take(parameter.width);
    let default = default.cloned().collect::<Vec<_>>().join(",");
    let mut does = parameter.does.to_owned();
    does[..1].make_ascii_uppercase();
    Arg::new(parameter.name)
        .long(parameter.name)
        .value_name(value)
        .value_parser(numbers)
        .allow_negative_numbers(true)
        .allow_hyphen_values(true)
        .help(format!("{does} [default: {default}]"))
}

impl Args for Arguments {
    fn augment_args(command: Command) -> Command {
        let moves = MOVES.iter().map(|known| {
            let mut does = known.does.to_owned();
            does[..1].make_ascii_uppercase();
            Command::new(known.name)
                .about(does)
                .args(known.parameters.iter().map(option))
                .arg(
                    Arg::new("fps")
                        .long("fps")
                        .value_name("NUMBER")
                        .value_parser(clap::value_parser!(f64))
                        .help("Frames in a second [default: 25]"),
                )
                .arg(
                    Arg::new("up")
                        .long("up")
                        .value_name("AXIS")
                        .value_parser(up())
                        .help("Which axis is up [default: that of --object, else y]"),
                )
                .arg(
                    Arg::new("object")
                        .long("object")
                        .value_name("FILE")
                        .value_parser(clap::value_parser!(PathBuf))
                        .help(
                            "Goes round this object: a mesh (.obj, .ply, .stl, .gltf, .glb) with \
                             a space around it, or that of a .vid file in its space",
                        ),
                )
                .arg(
                    Arg::new("output")
                        .short('o')
                        .long("output")
                        .value_name("OUT.vid")
                        .value_parser(clap::value_parser!(PathBuf))
                        .help("Where the path goes; - is standard output [default: -]"),
                )
        });
        command
            .subcommand_required(true)
            .arg_required_else_help(true)
            .disable_help_subcommand(true)
            .subcommands(moves)
    }

    fn augment_args_for_update(command: Command) -> Command {
        Self::augment_args(command)
    }
}

impl FromArgMatches for Arguments {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, clap::Error> {
        let found = matches.subcommand().and_then(|(name, matches)| {
            let chosen = MOVES.iter().find(|known| known.name == name)?;
            Some((chosen, matches))
        });
        let Some((chosen, matches)) = found else {
            return Err(clap::Error::new(ErrorKind::MissingSubcommand));
        };
        let mut given = Vec::new();
        for (at, parameter) in chosen.parameters.iter().enumerate() {
            let Some(numbers) = matches.get_one::<Vec<f64>>(parameter.name) else {
                continue;
            };
            if numbers.len() != parameter.width {
                return Err(clap::Error::raw(
                    ErrorKind::ValueValidation,
                    format!(
                        "--{} takes {} numbers with commas between\n",
                        parameter.name, parameter.width
                    ),
                ));
            }
            given.push((at, numbers.clone()));
        }
        let path = |name: &str| matches.get_one::<PathBuf>(name).cloned();
        Ok(Self {
            chosen,
            given,
            fps: matches.get_one("fps").copied().unwrap_or(25.0),
            up: matches.get_one("up").copied(),
            object: path("object"),
            output: path("output").unwrap_or_else(|| PathBuf::from("-")),
        })
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let mut space = Space::default();
    let mut info = Info {
        fps: arguments.fps,
        ..Info::default()
    };
    let mut bounds = None;
    if let Some(file) = &arguments.object {
        let (path, of_file) = input::around(file)?.into_parts();
        space = path.space;
        (info.unit, info.object) = (of_file.unit, of_file.object);
        let places: Vec<_> = info.object.iter().map(|point| point.position).collect();
        bounds = (!places.is_empty()).then(|| Bounds::of(&places));
    }
    space.up = arguments.up.unwrap_or(space.up);
    // Moves use the frame rate: check it first.
    info.check(space)?;
    let mut numbers = arguments.chosen.defaults(bounds.as_ref(), space)?;
    let parameters = arguments.chosen.parameters;
    for (at, given) in &arguments.given {
        let start = Parameter::count(&parameters[..*at]);
        numbers[start..start + given.len()].copy_from_slice(given);
    }
    let make = |space| {
        let path = arguments.chosen.path(&numbers, space, arguments.fps)?;
        Ok::<_, Failure>(Document::from_parts(path, info.clone())?)
    };
    let mut document = make(space)?;
    // Only the space of a file was chosen by somebody.
    let of_file = arguments.object.as_deref().is_some_and(input::is_path);
    if !of_file && document.points_outside() > 0 {
        document = make(document.space_around_all()?)?;
    }
    Output::to(arguments.output.clone()).write(&document)
}
