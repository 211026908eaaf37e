//! The command's arguments and what becomes of them. It stands on the library's public Rust
//! interface, as any other program would.
//!
//! Exit statuses: 0 done, or the reader of our output closed it; 1 bad input, or a file cannot be
//! read or written; 2 bad usage; 3 a check found something.

mod avoid;
mod check;
#[cfg(test)]
mod completions_tests;
mod convert;
mod edit;
mod failure;
mod fit;
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
mod retime;
mod sample;
mod scene;
mod steady;
mod table;
mod tools;
mod tour;

use std::io::{self, Write};
use std::path::PathBuf;
use std::process::ExitCode;

use clap::{Parser, Subcommand};

use self::failure::{Failure, complain, one_line, print};

/// Plans camera paths: a few support points with views become every camera pose between them.
#[derive(Parser)]
#[command(
    name = "vides",
    version,
    arg_required_else_help = true,
    disable_help_subcommand = true,
    max_term_width = 80,
    after_help = "Exit status: 0 done, 1 bad input, 2 bad usage, 3 findings of a check."
)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Opens the editor in a window
    Edit {
        /// The path; one that does not exist yet is a new one of that name
        #[arg(value_name = "FILE.vid")]
        file: Option<PathBuf>,

        /// A mesh or a point cloud (.obj, .ply, .stl, .gltf, .glb) to be shown as the object;
        /// a new path lies in a space around it
        #[arg(long, value_name = "MESH")]
        object: Option<PathBuf>,
    },
    /// Writes every camera pose of a path
    Sample(sample::Arguments),
    /// Writes a path or scene in the format of another program, and back
    Convert(convert::Arguments),
    /// Shows points, sections, lengths, frames and seconds of a path; of a
    /// scene its nodes and what moves them
    Info {
        /// The path; - is standard input
        #[arg(value_name = "FILE.vid")]
        file: PathBuf,
        /// Writes one object, with all digits
        #[arg(long)]
        json: bool,
    },
    /// Writes properties of a path by their names
    Get(properties::Get),
    /// Sets properties of a path by their names
    Set(properties::Set),
    /// Makes a path of few points of recorded poses
    Fit(fit::Arguments),
    /// Tells what will look wrong in a film
    Check(check::Arguments),
    /// Draws a path, its views and what changes over its frames
    Plot(plot::Arguments),
    /// Computes the pace of a path anew, within limits
    Retime(retime::Arguments),
    /// Takes the shaking of a hand out of a recorded flight
    Steady(steady::Arguments),
    /// Leads the way of a path clear of an object
    Avoid(avoid::Arguments),
    /// Keeps an object whole in the picture, as large as a margin allows
    Picture(picture::Arguments),
    /// Makes a flight that shows an object
    Tour(tour::Arguments),
    /// Makes a path by a ready-made move
    Move(moves::Arguments),
    #[command(flatten)]
    Tool(tools::Tool),
}

pub(crate) fn run() -> ExitCode {
    let cli = match Cli::try_parse() {
        Ok(cli) => cli,
        Err(error) if error.use_stderr() => return complain_of_usage(&error),
        // --help and --version
        Err(error) => return conclude(print(&error.render().to_string())),
    };
    progress::watch_meshes();
    conclude(match cli.command {
        Command::Edit { file, object } => edit::run(file.as_deref(), object.as_deref()),
        Command::Sample(arguments) => sample::run(&arguments),
        Command::Convert(arguments) => convert::run(&arguments),
        Command::Info { file, json } => info::run(&file, json),
        Command::Get(arguments) => properties::get(&arguments),
        Command::Set(arguments) => properties::set(&arguments),
        Command::Fit(arguments) => fit::run(&arguments),
        Command::Check(arguments) => check::run(&arguments),
        Command::Plot(arguments) => plot::run(&arguments),
        Command::Retime(arguments) => retime::run(&arguments),
        Command::Steady(arguments) => steady::run(&arguments),
        Command::Avoid(arguments) => avoid::run(&arguments),
        Command::Picture(arguments) => picture::run(&arguments),
        Command::Tour(arguments) => tour::run(&arguments),
        Command::Move(arguments) => moves::run(&arguments),
        Command::Tool(tool) => tools::run(&tool),
    })
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
    use clap::CommandFactory;

    use super::*;

    #[test]
    fn the_arguments_are_declared_soundly() {
        Cli::command().debug_assert();
    }
}
