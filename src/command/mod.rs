//! The command's arguments and what becomes of them. It stands on the library's public Rust
//! interface, as any other program would.
//!
//! Exit statuses: 0 done, or the reader of our output closed it; 1 bad input, or a file cannot be
//! read or written; 2 bad usage; 3 a check found something.

mod avoid;
mod call;
mod check;
mod convert;
mod edit;
mod failure;
mod fit;
mod given;
mod groups;
mod info;
mod info_json;
mod info_parts;
mod input;
mod moves;
mod output;
mod picture;
mod plot;
mod progress;
mod properties;
#[cfg(test)]
mod reference_tests;
mod retime;
mod sample;
mod scene;
mod signals;
mod steady;
mod table;
mod tools;
mod tour;

use std::ffi::OsString;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::{FromArgMatches, Parser, Subcommand};
use vides::document::{protect_inputs, trusting};

use self::failure::{Failure, complain, one_line, print};

/// Plans camera paths: computes every camera pose between a few points.
#[derive(Parser)]
#[command(
    name = "vides",
    version,
    arg_required_else_help = true,
    override_usage = "vides [OPTIONS] COMMAND\n       vides FILE",
    disable_help_subcommand = true,
    max_term_width = 80,
    after_help = "Exit status: 0 done, 1 bad input, 2 bad usage, 3 findings of a check."
)]
struct Cli {
    /// Also reads meshes and buffers that an input file names outside its folder
    #[arg(long, global = true, display_order = 900)]
    trust: bool,
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Opens the editor window
    Edit {
        /// The path, or a mesh or point cloud (.obj, .ply, .stl, .gltf, .glb) for a new path around
        /// it; a path that does not exist is created on saving
        #[arg(value_name = "FILE")]
        file: Option<PathBuf>,

        /// A mesh or point cloud to show as the object of a path; a new path gets a space around it
        #[arg(long, value_name = "MESH")]
        object: Option<PathBuf>,
    },
    /// Writes every camera pose of a path
    Sample(sample::Arguments),
    /// Converts to or from the format of another program
    Convert(convert::Arguments),
    /// Shows the sections and frames of a path, or the nodes of a scene
    Info {
        /// The path; - is standard input
        #[arg(value_name = "FILE.vid")]
        file: PathBuf,
        /// Prints one JSON object, with all digits
        #[arg(long)]
        json: bool,
    },
    /// Prints properties of a path by name
    Get(properties::Get),
    /// Sets properties of a path by name
    Set(properties::Set),
    /// Finds what will look wrong: jerks, flips, collisions
    Check(check::Arguments),
    /// Draws a path, its views, and charts over its frames
    Plot(plot::Arguments),
    #[command(flatten)]
    Tool(call::Call),
}

/// The arguments; a file alone is one to edit.
fn arguments() -> Vec<OsString> {
    let mut arguments: Vec<_> = std::env::args_os().collect();
    if let [_, file] = &arguments[..]
        && (Path::new(file).is_file() || has_known_ending(Path::new(file)))
    {
        arguments.insert(1, "edit".into());
    }
    arguments
}

/// Whether a name is that of a path or a mesh, there or not.
fn has_known_ending(file: &Path) -> bool {
    !input::is_path(file) || file.extension().is_some_and(|ending| ending == "vid")
}

pub(crate) fn run() -> ExitCode {
    let matches = groups::command().try_get_matches_from(arguments());
    let cli = match matches.and_then(|matches| Cli::from_arg_matches(&matches)) {
        Ok(cli) => cli,
        Err(error) if error.use_stderr() => return complain_of_usage(&error),
        // --help and --version
        Err(error) => return conclude(print(error.render().to_string())),
    };
    signals::survive_size_limit();
    progress::watch_meshes();
    // The editor saves over what it has opened.
    if !matches!(cli.command, Command::Edit { .. }) {
        protect_inputs();
    }
    conclude(match cli.trust {
        true => trusting(|| cli.command.run()),
        false => cli.command.run(),
    })
}

impl Command {
    fn run(self) -> Result<(), Failure> {
        match self {
            Self::Edit { file, object } => edit::run(file.as_deref(), object.as_deref()),
            Self::Sample(arguments) => sample::run(&arguments),
            Self::Convert(arguments) => convert::run(&arguments),
            Self::Info { file, json } => info::run(&file, json),
            Self::Get(arguments) => properties::get(&arguments),
            Self::Set(arguments) => properties::set(&arguments),
            Self::Check(arguments) => check::run(&arguments),
            Self::Plot(arguments) => plot::run(&arguments),
            Self::Tool(call) => tools::run(&call),
        }
    }
}

fn conclude(result: Result<(), Failure>) -> ExitCode {
    let (message, status) = match result {
        Ok(()) | Err(Failure::ReaderGone) => return ExitCode::SUCCESS,
        Err(Failure::Findings) => return ExitCode::from(3),
        Err(Failure::Input(message)) => (message, 1),
        Err(Failure::Usage(message)) => (message, 2),
    };
    complain(&one_line(&message));
    ExitCode::from(status)
}

/// Prints clap's message behind our name.
fn complain_of_usage(error: &clap::Error) -> ExitCode {
    let text = error.render().to_string();
    if error.kind() == clap::error::ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand {
        let _ = io::stderr().write_all(text.as_bytes());
    } else {
        complain(text.strip_prefix("error: ").unwrap_or(&text).trim_end());
    }
    ExitCode::from(2)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_arguments_are_declared_soundly() {
        groups::command().debug_assert();
    }
}
