//! A subcommand for each tool of the table, and those that only edit a path.

use std::path::PathBuf;

use clap::error::ErrorKind;
use clap::{Arg, ArgMatches, Args, Command, FromArgMatches, Subcommand};
use vides::deform::Bounds;
use vides::document::Edit;
use vides::document::tool::{Needs, Tool, ToolInput, tools};
use vides::glam::{DMat4, DVec3};
use vides::limits::MAX_FRAMES;

use super::call::Call;
use super::failure::Failure;
use super::given::{Given, Numbers, exactly, option, sentence};
use super::output::Output;
use super::progress::progress;
use super::{avoid, fit, input, moves, picture, retime, steady, tour};

/// All tools but the line drawn by hand.
fn known() -> impl Iterator<Item = Tool> {
    tools().filter(|tool| tool.needs() != Needs::Stroke)
}

fn file(id: &'static str, name: &'static str, help: &'static str) -> Arg {
    Arg::new(id)
        .value_name(name)
        .help(help)
        .required(true)
        .value_parser(clap::value_parser!(PathBuf))
}

fn declare(tool: &Tool) -> Command {
    let path = file("file", "FILE.vid", "The path; - is standard input");
    let command = Command::new(tool.name);
    let command = match tool.name {
        _ if tool.is_move() => command,
        "tour" => command.arg(file(
            "file",
            "OBJECT",
            "The object: a mesh (.obj, .ply, .stl, .gltf, .glb), or the object of a .vid file",
        )),
        "fit" => command.arg(file("file", "POSES", fit::INPUT)),
        _ => command.arg(path),
    };
    let command = match tool.needs() {
        Needs::Block => command.arg(file("other", "OTHER.vid", "The other path")),
        _ => command,
    };
    let command = command.args(tool.alone().parameters().map(option));
    let command = match tool.name {
        _ if tool.is_move() => moves::Options::augment_args(command),
        "avoid" => avoid::Options::augment_args(command).mut_arg("clearance", |arg| {
            arg.help("Least distance from the object; greater than 0 [default: as in the check]")
        }),
        "fit" => fit::declare(command),
        "picture" => picture::Options::augment_args(command),
        "retime" => retime::Options::augment_args(command),
        "tour" => tour::Options::augment_args(command),
        _ => with_extras(command, tool),
    };
    // What groups of options say of themselves is not what the tool does.
    Output::augment_args(command).about(match tool.is_move() && tool.name != "pan" {
        true => format!("Flies {}", tool.does),
        false => sentence(tool.does),
    })
}

const DEFORMATIONS: [&str; 5] = ["taper", "bulge", "twist", "bend", "free-form"];

/// Adds what the table does not say of the tools that only edit a path.
fn with_extras(command: Command, tool: &Tool) -> Command {
    let number = |name: &'static str| Arg::new(name).long(name).allow_negative_numbers(true);
    let at = |default| {
        let help = format!("The current point; 1 or more [default: {default}]");
        let parser = clap::value_parser!(usize);
        number("at")
            .value_name("POINT")
            .help(help)
            .value_parser(parser)
    };
    match tool.name {
        "insert" => command.arg(at("the last")),
        "frames" => command
            .mut_arg("frames", |arg| {
                let frames = "The frames, including the first and the last";
                arg.help(format!("{frames}; 1 to {MAX_FRAMES}"))
                    .required_unless_present("seconds")
            })
            .arg(
                number("seconds")
                    .value_name("SECONDS")
                    .help("The duration instead of --frames; greater than 0")
                    .value_parser(clap::value_parser!(f64))
                    .conflicts_with("frames"),
            ),
        name if DEFORMATIONS.contains(&name) => command.arg(
            number("box")
                .value_name("X,Y,Z,X,Y,Z")
                .help("The box: two opposite corners [default: the bounds of the points]")
                .allow_hyphen_values(true)
                .value_parser(exactly::<6>),
        ),
        _ if tool.place_of("about").is_some() => command.arg(at("the first")),
        _ => command,
    }
}

impl Subcommand for Call {
    fn augment_subcommands(command: Command) -> Command {
        command.subcommands(known().map(|tool| declare(&tool)))
    }

    fn augment_subcommands_for_update(command: Command) -> Command {
        Self::augment_subcommands(command)
    }

    fn has_subcommand(name: &str) -> bool {
        known().any(|tool| tool.name == name)
    }
}

impl FromArgMatches for Call {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, clap::Error> {
        let found = matches.subcommand().and_then(|(name, matches)| {
            let tool = known().find(|tool| tool.name == name)?;
            Some((tool, matches))
        });
        let (tool, matches) = found.ok_or(clap::Error::new(ErrorKind::MissingSubcommand))?;
        Ok(Self {
            tool,
            given: Given::of(tool.alone().parameters(), matches),
            output: Output::from_arg_matches(matches)?,
            matches: matches.clone(),
        })
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}

pub(super) fn run(call: &Call) -> Result<(), Failure> {
    match call.tool.name {
        _ if call.tool.is_move() => moves::run(call),
        "avoid" => avoid::run(call),
        "fit" => fit::run(call),
        "picture" => picture::run(call),
        "retime" => retime::run(call),
        "steady" => steady::run(call),
        "tour" => tour::run(call),
        _ => edit(call),
    }
}

/// The frames of a duration, at most those that a film may have.
fn whole_frames(seconds: f64, fps: f64) -> Result<f64, Failure> {
    let frames = (seconds * fps).round();
    if !(seconds > 0.0) {
        return Err(Failure::Usage(
            "--seconds must be greater than 0".to_owned(),
        ));
    }
    if frames > MAX_FRAMES as f64 {
        return Err(Failure::Input(format!(
            "{seconds:e} seconds are too many: a film has at most {MAX_FRAMES} frames, {:.0} seconds \
             at {fps} frames a second",
            MAX_FRAMES as f64 / fps
        )));
    }
    Ok(frames)
}

fn edit(call: &Call) -> Result<(), Failure> {
    let Call { tool, given, .. } = call;
    let mut document = input::load(call.file())?;
    let extra = |name| call.matches.try_get_one::<f64>(name).ok().flatten();
    let at = call.matches.try_get_one::<usize>("at").ok().flatten();
    let count = document.path().points.len();
    let at = at.copied().unwrap_or(match tool.name {
        "insert" => count,
        _ => 1,
    });
    if at == 0 || at > count {
        return Err(Failure::Input(format!(
            "there is no point {at}: the path has points 1 to {count}"
        )));
    }
    document.select(at - 1, 0)?;
    let mut numbers = Numbers::new(tool, given, &document)?;
    if let Some(seconds) = extra("seconds") {
        numbers.all[0] = whole_frames(*seconds, document.info().fps)?;
    }
    let fixed = given.get("about").filter(|place| place.len() == 3);
    if let Some(about) = tool.place_of("about").filter(|_| fixed.is_some()) {
        numbers.all[about] = ORIGIN;
    }
    if tool.needs() == Needs::Output {
        let taken = tool.extracted(&document, &numbers.all);
        let taken = taken.map_err(|error| call.at_file(error))?;
        return call.output.write(&taken);
    }
    let other = call.matches.try_get_one::<PathBuf>("other").ok().flatten();
    let material = match other {
        Some(file) => ToolInput::Block(Box::new(input::load(file)?.into_parts().0)),
        None => ToolInput::None,
    };
    let edit = tool.edit(&document, &material, &numbers.all, &mut progress("points"));
    let Some(mut edit) = edit.map_err(|error| call.at_file(error))?.edit else {
        return call.output.write(&document);
    };
    match &mut edit {
        Edit::TransformPoints { matrix, .. } => {
            let place = fixed.map_or(DVec3::ZERO, DVec3::from_slice);
            let [there, back] = [place, -place].map(DMat4::from_translation);
            *matrix = there * *matrix * back;
        }
        Edit::DeformPoints { bounds, .. } => {
            if let Some([a, b, c, d, e, f]) = call.matches.get_one::<[f64; 6]>("box") {
                let corners = [[a, b, c], [d, e, f]].map(|corner| DVec3::from(corner.map(|x| *x)));
                *bounds = Some(Bounds::new(corners[0], corners[1])?);
            }
        }
        _ => {}
    }
    call.output.applied(document, call.file(), edit)
}

/// The choice of `about` that is the origin.
const ORIGIN: f64 = 1.0;
