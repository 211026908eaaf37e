//! `completions/` is what clap makes of the arguments today.
//!
//! `make completions` (or `UPDATE_COMPLETIONS=1 cargo test --all-features --bin vides completions`)
//! writes them anew.

use std::fs;
use std::path::Path;

use clap::builder::PossibleValuesParser;
use clap::{Command, CommandFactory};
use clap_complete::Shell;
use vides::formats::{Format, formats};

use super::Cli;

/// The file of each shell, by the name under which the shell looks for it.
const FILES: [(Shell, &str); 3] = [
    (Shell::Bash, "vides"),
    (Shell::Zsh, "_vides"),
    (Shell::Fish, "vides.fish"),
];

/// The arguments as a shell may know them: here the formats are a list to choose from. (The
/// command itself refuses others with a sentence of its own.)
fn arguments() -> Command {
    let names = |fits: fn(&Format) -> bool| {
        let all = formats().iter().filter(|format| fits(format));
        PossibleValuesParser::new(all.map(|format| format.name))
    };
    Cli::command().mut_subcommand("convert", |convert| {
        convert
            .mut_arg("from", |from| from.value_parser(names(Format::reads)))
            .mut_arg("to", |to| to.value_parser(names(Format::writes)))
    })
}

#[test]
fn the_completions_are_current() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("completions");
    for (shell, name) in FILES {
        let mut made = Vec::new();
        clap_complete::generate(shell, &mut arguments(), "vides", &mut made);
        let file = folder.join(name);
        if std::env::var_os("UPDATE_COMPLETIONS").is_some() {
            fs::create_dir_all(&folder).expect("the folder completions");
            fs::write(&file, made).expect("the completions written");
            continue;
        }
        assert!(
            fs::read(&file).unwrap_or_default() == made,
            "completions/{name} does not have the arguments of today: run `make completions`"
        );
    }
}
