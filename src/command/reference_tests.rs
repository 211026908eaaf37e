//! What clap's declarations make is current: completions/, the commands of man/vides.1, and
//! docs/reference/command.md.
//!
//! `make completions` (or `UPDATE_COMPLETIONS=1 cargo test --all-features --bin vides completions`)
//! writes them anew.

use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use clap::builder::PossibleValuesParser;
use clap::{Arg, Command};
use clap_complete::Shell;
use vides::formats::{Format, formats};

use super::groups::{self, GROUPS};

/// The file of each shell, by the name under which the shell looks for it.
const FILES: [(Shell, &str); 3] = [
    (Shell::Bash, "vides"),
    (Shell::Zsh, "_vides"),
    (Shell::Fish, "vides.fish"),
];

const BEGIN: &str = ".\\\" Made from the arguments by `make completions`.\n";
const END: &str = ".\\\" End of what is made.\n";

/// The arguments as a shell may know them: here the formats are a list to choose from. (The
/// command itself refuses others with a sentence of its own.)
fn arguments() -> Command {
    let names = |fits: fn(&Format) -> bool| {
        let all = formats().iter().filter(|format| fits(format));
        PossibleValuesParser::new(all.map(|format| format.name))
    };
    groups::command().mut_subcommand("convert", |convert| {
        convert
            .mut_arg("from", |from| from.value_parser(names(Format::reads)))
            .mut_arg("to", |to| to.value_parser(names(Format::writes)))
    })
}

/// Writes a file, or compares it.
fn keep(name: &str, made: &[u8]) {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(name);
    if std::env::var_os("UPDATE_COMPLETIONS").is_some() {
        fs::create_dir_all(file.parent().expect("a folder")).expect("the folder");
        fs::write(&file, made).expect("written");
    }
    assert!(
        fs::read(&file).unwrap_or_default() == made,
        "{name} does not have the arguments of today: run `make completions`"
    );
}

/// What an option or argument is called, what it takes, and what it means.
fn described(arg: &Arg) -> (String, String, String) {
    let values = arg.get_value_names().unwrap_or_default();
    let mut value = values.iter().map(ToString::to_string).collect::<Vec<_>>();
    if arg.get_num_args().is_none_or(|range| !range.takes_values()) {
        value.clear();
    }
    let optional = arg.is_require_equals_set();
    let name = match (arg.get_short(), arg.get_long()) {
        (Some(short), Some(long)) => format!("-{short}, --{long}"),
        (None, Some(long)) => format!("--{long}"),
        _ => String::new(),
    };
    let mut text = arg.get_help().map(ToString::to_string).unwrap_or_default();
    let list = |all: Vec<String>| all.join(", ");
    let choices: Vec<_> = match value.is_empty() || arg.is_hide_possible_values_set() {
        true => Vec::new(),
        false => arg.get_possible_values(),
    };
    let choices = choices.iter().map(|choice| match choice.get_help() {
        Some(help) => format!("{} ({help})", choice.get_name()),
        None => choice.get_name().to_owned(),
    });
    let choices = list(choices.collect());
    if !choices.is_empty() {
        // Before the default.
        let at = text.find(" [default").unwrap_or(text.len());
        text.insert_str(at, &format!(": {choices}"));
    }
    let default = arg.get_default_values().iter();
    let default = list(default.map(|text| text.to_string_lossy().into()).collect());
    if !default.is_empty() && !value.is_empty() {
        let _ = write!(text, " [default: {default}]");
    }
    match optional {
        true => (format!("{name}[={}]", value.join(" ")), String::new(), text),
        false => (name, value.join(" "), text),
    }
}

/// Its arguments, without those of every command.
fn shown(command: &Command) -> Vec<(String, String, String)> {
    let own = |arg: &&Arg| !arg.is_global_set() && arg.get_id() != "help";
    let all = command.get_positionals().chain(command.get_opts());
    let flags = command
        .get_arguments()
        .filter(|arg| arg.get_long().is_some() && !arg.get_action().takes_values());
    all.chain(flags).filter(own).map(described).collect()
}

/// Each subcommand by its group, with its example.
fn commands(whole: &Command) -> impl Iterator<Item = (&str, Vec<(&Command, &str)>)> {
    GROUPS.into_iter().map(|(heading, rows)| {
        let rows = rows.iter().map(|&(name, example)| {
            let command = whole.find_subcommand(name);
            (command.expect("a subcommand"), example)
        });
        (heading, rows.collect())
    })
}

/// What stands below the options besides the example.
fn notes(command: &Command) -> String {
    let all = command.get_after_help().map(ToString::to_string);
    let all = all.unwrap_or_default();
    all.split("Example: ").next().unwrap_or_default().to_owned()
}

fn usage(command: &Command) -> String {
    let places = command.get_positionals().map(|arg| {
        let name = arg.get_value_names().unwrap_or_default().join(" ");
        let more = if arg.get_num_args().is_some_and(|n| n.max_values() > 1) {
            "..."
        } else {
            ""
        };
        match arg.is_required_set() {
            true => format!(" {name}{more}"),
            false => format!(" [{name}]{more}"),
        }
    });
    format!(
        "vides {}{} [OPTIONS]",
        command.get_name(),
        places.collect::<String>()
    )
}

fn markdown(whole: &Command) -> String {
    let mut page = "# The command `vides`\n\n*For everybody who works in a shell. This page is made \
                    from the command's own help.*\n\n`vides FILE` opens a path or a mesh in the \
                    editor. `vides COMMAND --help` prints what follows. All commands take `--trust`: \
                    they then also read meshes and buffers that an input file names outside its \
                    folder. Lengths are in the path's unit, points count from 1.\n"
        .to_owned();
    for (heading, rows) in commands(whole) {
        let _ = write!(page, "\n## {heading}\n");
        for (command, example) in rows {
            let about = command.get_about().map(ToString::to_string);
            let about = about.unwrap_or_default();
            let _ = write!(page, "\n### {}\n\n{about}.\n\n", command.get_name());
            let _ = write!(page, "```\n{}\n```\n\n", usage(command));
            for (name, value, text) in shown(command) {
                let tag = format!("{name} {value}");
                let _ = writeln!(page, "- `{}`: {text}", tag.trim());
            }
            for line in notes(command).lines().filter(|line| !line.is_empty()) {
                let _ = write!(page, "\n{line}\n");
            }
            let _ = write!(page, "\n    {example}\n");
        }
    }
    page
}

/// Text as roff has it.
fn roff(text: &str) -> String {
    let text = text.replace('\\', "\\e").replace('-', "\\-");
    text.replace('×', "\\(mu")
}

fn manual(whole: &Command) -> String {
    let mut page = String::new();
    for (heading, rows) in commands(whole) {
        let _ = writeln!(page, ".SS {heading}");
        for (command, example) in rows {
            let about = command.get_about().map(ToString::to_string);
            let about = roff(&about.unwrap_or_default());
            let _ = write!(page, ".PP\n.B {}\n.br\n{about}.\n", roff(&usage(command)));
            for (name, value, text) in shown(command) {
                let tag = format!(".BI \"{} \" \"{}\"", roff(&name), roff(&value));
                let _ = write!(page, ".TP\n{tag}\n\\&{}\n", roff(&text));
            }
            for line in notes(command).lines().filter(|line| !line.is_empty()) {
                let _ = write!(page, ".PP\n{}\n", roff(line));
            }
            let _ = write!(page, ".IP\n.EX\n{}\n.EE\n", roff(example));
        }
    }
    page
}

#[test]
fn the_completions_are_current() {
    for (shell, name) in FILES {
        let mut made = Vec::new();
        clap_complete::generate(shell, &mut arguments(), "vides", &mut made);
        keep(&format!("completions/{name}"), &made);
    }
}

#[test]
fn the_pages_of_the_completions_are_current() {
    let mut whole = groups::command();
    whole.build();
    keep("docs/reference/command.md", markdown(&whole).as_bytes());
    let page = include_str!("../../man/vides.1");
    let (before, rest) = page.split_once(BEGIN).expect("where the commands begin");
    let (_, after) = rest.split_once(END).expect("where they end");
    let made = format!("{before}{BEGIN}{}{END}{after}", manual(&whole));
    keep("man/vides.1", made.as_bytes());
}

/// Every subcommand is in one group, and the command understands its example.
#[test]
fn each_subcommand_has_a_group_and_an_example() {
    let rows: Vec<_> = GROUPS.iter().flat_map(|(_, rows)| *rows).collect();
    let named: BTreeSet<_> = rows.iter().map(|(name, _)| *name).collect();
    let whole = groups::command();
    let all: BTreeSet<_> = whole.get_subcommands().map(Command::get_name).collect();
    assert_eq!((named, rows.len()), (all, whole.get_subcommands().count()));
    for (name, example) in rows {
        let words: Vec<_> = example.split(' ').collect();
        assert_eq!(words[1], *name);
        let matches = groups::command().try_get_matches_from(words);
        matches.unwrap_or_else(|error| panic!("{example}: {error}"));
    }
}

/// The help says of each option what it means, and a default unless it is a file or a limit.
#[test]
fn each_line_of_help_fits_and_each_number_has_a_default() {
    let mut whole = groups::command();
    whole.build();
    for command in whole
        .get_subcommands()
        .filter(|one| one.get_name() != "help")
    {
        let about = command.get_about().map(ToString::to_string);
        let about = about.unwrap_or_default();
        assert!(about.chars().count() <= 64, "{about}");
        for arg in command.get_opts() {
            let (name, value, text) = described(arg);
            assert!(!text.is_empty(), "{} {name}", command.get_name());
            let free = ["FILE", "MESH", "OUT", "KIND=LIMIT", "NAME", "OUT.vid"];
            let optional = free.iter().any(|free| value.starts_with(free));
            let tool = !["sample", "convert"].contains(&command.get_name());
            let said = ["default", "instead", "At most"]
                .iter()
                .any(|word| text.contains(word));
            let required = arg.is_required_set() || name == "--frames";
            assert!(
                optional || !tool || said || required || name.ends_with("[=yes|no]"),
                "{} {name} {value}: {text}",
                command.get_name()
            );
        }
    }
}
