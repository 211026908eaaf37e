//! `vides plot`: a path as a picture in a file.

mod png;

use std::path::PathBuf;

use clap::Args;
use vides::document::save;
use vides::plot;

use super::failure::{Failure, complain, one_line, print};
use super::input;

#[derive(Args)]
pub(super) struct Arguments {
    /// The path, or a scene: the path of the camera that is shown; - is standard input
    #[arg(value_name = "FILE.vid")]
    file: PathBuf,
    /// Where the picture goes, as .svg or .png; - is standard output, as SVG
    #[arg(short, long, value_name = "OUT", default_value = "-")]
    output: PathBuf,
    /// The object in place of the path's: a mesh (.obj, .ply, .stl, .gltf, .glb),
    /// or the object of a .vid file
    #[arg(long, value_name = "FILE")]
    object: Option<PathBuf>,
    /// On a dark ground
    #[arg(long)]
    dark: bool,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let to_file = !input::is_standard_stream(&arguments.output);
    let ending = arguments.output.extension();
    let ends = |wanted: &str| ending.is_some_and(|ending| ending.eq_ignore_ascii_case(wanted));
    if to_file && !ends("svg") && !ends("png") {
        return Err(Failure::Usage(format!(
            "{}: a plot is written as .svg or .png",
            arguments.output.display()
        )));
    }
    let document = input::load_shown(&arguments.file)?;
    let object = arguments.object.as_deref().map(input::object).transpose()?;
    let picture = plot::picture(&document, object.as_ref(), arguments.dark)
        .map_err(|error| Failure::from(error.at(input::name(&arguments.file))))?;
    for note in picture.notes() {
        complain(&one_line(&note.to_string()));
    }
    if to_file && ends("png") {
        let png = png::of(picture.drawn()).map_err(Failure::Usage)?;
        return Ok(save::save(&arguments.output, &png)?);
    }
    let text = picture.into_svg();
    if to_file {
        Ok(save::save(&arguments.output, text.as_bytes())?)
    } else {
        print(&text)
    }
}
