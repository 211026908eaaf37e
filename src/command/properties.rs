//! `vides get` and `vides set`: properties of a path or a scene by the names of their keys.

use std::fmt::Write as _;
use std::path::PathBuf;

use clap::Args;

use super::failure::{Failure, print};
use super::{input, output::Output};

/// What `vides get` is asked.
#[derive(Args)]
pub(super) struct Get {
    /// The path or scene; - is standard input
    #[arg(value_name = "FILE.vid")]
    file: PathBuf,
    /// As point.2.zoom, point.2.view.3.zoom, node.lamp.intensity or fps; without one, all that
    /// the file says
    #[arg(value_name = "NAME")]
    names: Vec<String>,
}

/// What `vides set` is told.
#[derive(Args)]
pub(super) struct Set {
    /// The path or scene; - is standard input
    #[arg(value_name = "FILE.vid")]
    file: PathBuf,
    /// As point.2.zoom=30, node.lamp.intensity=2 or fps=25, by the keys of the file; nothing
    /// behind the = gives back what a new one has
    #[arg(value_name = "NAME=VALUE", required = true)]
    values: Vec<String>,
    /// Where it goes; - is standard output [default: FILE.vid]
    #[arg(short, long, value_name = "OUT.vid")]
    output: Option<PathBuf>,
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
        output,
    } = arguments;
    let mut document = input::load_whole(file)?.without_history();
    for value in values {
        let Some((name, value)) = value.split_once('=') else {
            return Err(Failure::Usage(format!("\"{value}\" is not NAME=VALUE")));
        };
        let set = document.set_property(name.trim(), value);
        set.map_err(|error| error.at(input::name(file)))?;
    }
    Output::to(output.as_ref().unwrap_or(file).clone()).write(&document)
}
