//! `vides convert`: from one program's file to another's.

use std::path::PathBuf;

use clap::{Arg, ArgMatches, Args, Command, FromArgMatches};
use vides::formats::{self, As, Format, Holds, OPTIONS, Options, Report};

use super::failure::{Failure, complain, one_line};
use super::output::is_standard_output;
use super::sample::write_out;
use super::{input, scene};

#[derive(Args)]
#[command(after_help = after_help())]
pub(super) struct Arguments {
    /// The input file or folder; - is standard input
    #[arg(value_name = "IN")]
    from_file: PathBuf,
    /// The output file or folder; - is standard output
    #[arg(value_name = "OUT")]
    to_file: PathBuf,
    /// The format of IN [default: detected from its content]
    #[arg(long, value_name = "FORMAT")]
    from: Option<String>,
    /// The format of OUT [default: from its name]
    #[arg(long, value_name = "FORMAT")]
    to: Option<String>,
    /// A function of the type V_INTERPOLATE for the interpolation "host:NAME" of a scene's tracks
    #[arg(long, value_name = "NAME=FILE.so:SYMBOL")]
    interpolation: Vec<String>,
    #[command(flatten)]
    choices: Choices,
}

/// The options of all formats, from their table.
struct Choices(Options);

impl FromArgMatches for Choices {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, clap::Error> {
        let mut options = Options::default();
        for row in OPTIONS {
            if let Some(value) = matches.get_one::<String>(row.name) {
                // It has passed the same check before.
                let _ = options.set(row.name, value);
            }
        }
        Ok(Self(options))
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}

impl Args for Choices {
    fn augment_args(command: Command) -> Command {
        command.args(OPTIONS.iter().map(|row| {
            Arg::new(row.name)
                .long(row.name)
                .value_name(row.value)
                .help(row.help)
                .value_parser(|text: &str| row.check(text).map(|()| text.to_owned()))
                .allow_negative_numbers(true)
        }))
    }

    fn augment_args_for_update(command: Command) -> Command {
        Self::augment_args(command)
    }
}

/// The names of all formats, by what they can do.
fn after_help() -> String {
    let list = |what: &str, fits: fn(&Format) -> bool| {
        let all = formats::formats().iter().filter(|format| fits(format));
        let names: Vec<_> = all.map(|format| format.name).collect();
        if names.is_empty() {
            return String::new();
        }
        format!("{what}: {}.\n", names.join(", "))
    };
    list("Read and written", |format| {
        format.reads() && format.writes()
    }) + &list("Written only", |format| !format.reads())
        + &list("Read only", |format| !format.writes())
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let (file, out) = (&arguments.from_file, &arguments.to_file);
    let to_standard_output = is_standard_output(out);
    let named = |name: &Option<String>| -> Result<_, Failure> {
        let format = name.as_deref().map(formats::by_name).transpose();
        format.map_err(|error| Failure::Usage(error.to_string()))
    };
    let (from, to) = (named(&arguments.from)?, named(&arguments.to)?);
    let to = match to {
        Some(to) => to,
        None if to_standard_output => {
            let reason = "standard output has no name that tells a format: give --to";
            return Err(Failure::Usage(reason.to_owned()));
        }
        None => formats::by_target(out).map_err(|error| Failure::Usage(error.to_string()))?,
    };
    for interpolation in &arguments.interpolation {
        scene::register(interpolation)?;
    }
    let mut options = arguments.choices.0.clone();
    // What is not kept as a path need not become one on the way.
    if to.holds != Holds::Scene {
        options.as_ = options.as_.or(Some(As::Keys));
    }
    let source = input::source(file)?;
    let mut imported = formats::import(&source, from, &options)?;
    let name = &source.name;
    input::warn(name, imported.document.warnings());
    imported.keep_times(to, &mut options);
    tell(name, &imported.report);
    let report = write_out(&imported.document, name, out, to, &options)?;
    let out = if to_standard_output {
        "standard output".to_owned()
    } else {
        out.display().to_string()
    };
    tell(&out, &report);
    Ok(())
}

/// Says what is lost.
fn tell(name: &str, report: &Report) {
    for loss in report.losses() {
        complain(&one_line(&format!("{name}: {loss}")));
    }
}
