//! `vides get` and `vides set`: properties of a path or a scene by the names of their keys.

use std::fmt::Write as _;
use std::path::PathBuf;

use clap::{Args, ValueEnum};
use vides::limits::MAX_FPS;

use vides::document::may_replace;

use super::failure::{Failure, print};
use super::{input, output::Output};

/// What `vides get` is asked.
#[derive(Args)]
pub(super) struct Get {
    /// The path or scene; - is standard input
    #[arg(value_name = "FILE.vid")]
    file: PathBuf,
    /// A name, as in point.2.zoom, point.2.view.3.zoom, node.lamp.intensity or fps
    /// [default: all that the file sets]
    #[arg(value_name = "NAME")]
    names: Vec<String>,
}

/// The arguments of `vides set`.
#[derive(Args)]
pub(super) struct Set {
    /// The path or scene; - is standard input
    #[arg(value_name = "FILE.vid")]
    file: PathBuf,
    /// Name and value, as in point.2.zoom=30, node.lamp.intensity=2 or fps=25; an empty value
    /// restores the default
    #[arg(value_name = "NAME=VALUE", required = true)]
    values: Vec<String>,
    /// What stays when the frame rate (fps) changes: the seconds at which things happen, or the
    /// frames, so that the film gets faster or slower
    #[arg(long, value_name = "WHAT", default_value = "seconds")]
    keep: Keep,
    /// The output file; - is standard output [default: FILE.vid]
    #[arg(short, long, value_name = "OUT.vid")]
    output: Option<PathBuf>,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
enum Keep {
    Seconds,
    Frames,
}

pub(super) fn get(arguments: &Get) -> Result<(), Failure> {
    let Get { file, names } = arguments;
    let document = input::load_whole(file)?;
    let mut text = String::new();
    if names.is_empty() {
        for (name, value) in document.properties()? {
            let _ = writeln!(text, "{name} = {value}");
        }
    }
    for name in names {
        let value = document.property(name);
        let value = value.map_err(|error| error.at(input::name(file)))?;
        let _ = writeln!(text, "{value}");
    }
    print(&text)
}

pub(super) fn set(arguments: &Set) -> Result<(), Failure> {
    let Set {
        file,
        values,
        keep,
        output,
    } = arguments;
    let mut document = input::load_whole(file)?.without_history();
    for value in values {
        let Some((name, value)) = value.split_once('=') else {
            return Err(Failure::Usage(format!("\"{value}\" is not NAME=VALUE")));
        };
        let rate = value
            .trim()
            .parse()
            .ok()
            .filter(|fps| (0.0..=MAX_FPS).contains(fps));
        let set = match rate.filter(|_| name.trim() == "fps" && *keep == Keep::Seconds) {
            Some(fps) if fps > 0.0 => document
                .rate_edits(fps)
                .and_then(|edits| document.apply_all(edits)),
            _ => document.set_property(name.trim(), value),
        };
        set.map_err(|error| error.at(input::name(file)))?;
    }
    may_replace(file);
    Output::to(output.as_ref().unwrap_or(file).clone()).write(&document)
}
