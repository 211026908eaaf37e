//! `vides plot`: a path as a picture in a file.

mod png;

use std::io::{self, IsTerminal};
use std::path::{Path, PathBuf};

use clap::Args;
use vides::plot;

use super::failure::{Failure, complain, one_line};
use super::input::{self, ObjectOption};
use super::output::{is_file, write};
use super::progress::progress;

#[derive(Args)]
pub(super) struct Arguments {
    /// The path, or a scene, for its shown camera; - is standard input
    #[arg(value_name = "FILE.vid")]
    file: PathBuf,
    /// The output file, .svg or .png; - is standard output, as SVG, which is also where it
    /// goes without this option, but not onto a terminal
    #[arg(short, long, value_name = "OUT")]
    output: Option<PathBuf>,
    #[command(flatten)]
    object: ObjectOption,
    /// Uses a dark background
    #[arg(long)]
    dark: bool,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    if arguments.output.is_none() && io::stdout().is_terminal() {
        return Err(Failure::Usage(
            "name a file, .svg or .png, with --output, or - for SVG on the terminal".to_owned(),
        ));
    }
    let out = arguments.output.as_deref().unwrap_or(Path::new("-"));
    let to_file = is_file(out);
    let ending = out.extension();
    let ends = |wanted: &str| ending.is_some_and(|ending| ending.eq_ignore_ascii_case(wanted));
    if to_file && !ends("svg") && !ends("png") {
        return Err(Failure::Usage(format!(
            "{}: a plot is written as .svg or .png",
            out.display()
        )));
    }
    let document = input::load_shown(&arguments.file)?;
    let object = arguments.object.load()?;
    let picture = plot::picture(
        &document,
        object.as_ref(),
        arguments.dark,
        &mut progress("frames"),
    )
    .map_err(|error| Failure::from(error.at(input::name(&arguments.file))))?;
    for note in picture.notes() {
        complain(&one_line(&note.to_string()));
    }
    if to_file && ends("png") {
        let png = png::of(picture.drawn()).map_err(Failure::Usage)?;
        return write(out, &png);
    }
    write(out, picture.into_svg().as_bytes())
}
