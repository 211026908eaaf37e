//! `vides check`: what will look wrong in a film.

use std::fmt::Write;
use std::path::PathBuf;

use clap::Args;
use vides::tools::check::{Finding, FindingKind};

use super::table::{Align, Table};
use super::{Failure, input, print};

#[derive(Args)]
pub(super) struct Arguments {
    /// The path, or a scene: the path of the camera that is shown; - is standard input
    #[arg(value_name = "FILE.vid")]
    file: PathBuf,
    /// Writes the findings as an array of objects
    #[arg(long)]
    json: bool,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let document = input::load_shown(&arguments.file)?;
    let found = document
        .check(None)
        .map_err(|error| error.at(input::name(&arguments.file)))?;
    print(&if arguments.json {
        json(&found)
    } else {
        text(&found)
    })?;
    if found.is_empty() {
        Ok(())
    } else {
        Err(Failure::Findings)
    }
}

fn text(found: &[Finding]) -> String {
    let mut text = String::new();
    if found.is_empty() {
        return text;
    }
    let mut table = Table::new(&[
        ("Frames", Align::Right),
        ("From", Align::Right),
        ("Kind", Align::Left),
        ("Value", Align::Right),
        ("Limit", Align::Right),
    ]);
    for finding in found {
        let frames = if finding.first_frame == finding.last_frame {
            format!("{:.0}", finding.first_frame)
        } else {
            format!("{:.0}-{:.0}", finding.first_frame, finding.last_frame)
        };
        table.row(vec![
            frames,
            format!("{}.{}", finding.point + 1, finding.orientation + 1),
            finding.kind.name().to_owned(),
            format!("{:.4}", finding.value),
            finding.limit.to_string(),
        ]);
    }
    // Writing into a string cannot fail.
    let _ = writeln!(text, "{}", table.to_string().trim_end());
    for kind in FindingKind::all() {
        if found.iter().any(|finding| finding.kind == kind) {
            let _ = write!(text, "\n{}: {}", kind.name(), kind.limit().does);
            let _ = writeln!(text, "; {}", kind.remedy());
        }
    }
    text
}

fn json(found: &[Finding]) -> String {
    let objects = found.iter().map(|finding| {
        // Names and finite numbers need no quoting.
        format!(
            "  {{\"kind\": \"{}\", \"first_frame\": {:?}, \"last_frame\": {:?}, \"point\": {}, \
             \"orientation\": {}, \"value\": {:?}, \"limit\": {:?}}}",
            finding.kind.name(),
            finding.first_frame,
            finding.last_frame,
            finding.point + 1,
            finding.orientation + 1,
            finding.value,
            finding.limit
        )
    });
    let objects: Vec<String> = objects.collect();
    if objects.is_empty() {
        return "[]\n".to_owned();
    }
    format!("[\n{}\n]\n", objects.join(",\n"))
}
