//! `vides check`: what will look wrong in a film.

use std::fmt::Write;
use std::path::PathBuf;

use clap::Args;
use vides::document::{Document, Edit, Note, limit_scale, may_replace};
use vides::path::Space;
use vides::tools::check::{Finding, FindingKind, Limits, OFF};

use super::failure::{Failure, complain, json as json_text, lines, print};
use super::input::{self, ObjectOption};
use super::output::{is_standard_output, write_document};
use super::progress::progress;
use super::table::{Align, Table};

#[derive(Args)]
pub(super) struct Arguments {
    /// The path, or a scene, for its shown camera; - is standard input
    #[arg(value_name = "FILE.vid")]
    file: PathBuf,
    #[command(flatten)]
    object: ObjectOption,
    #[command(flatten)]
    limits: LimitOption,
    /// Applies fixes while they help, writes the path to --output, and reports what
    /// was fixed and what remains
    #[arg(long, requires = "output")]
    fix: bool,
    /// The file that --fix writes
    #[arg(short, long, value_name = "OUT.vid", requires = "fix")]
    output: Option<PathBuf>,
    /// Prints the findings and notes as a JSON array
    #[arg(long)]
    json: bool,
}

/// Limits instead of those of the file.
#[derive(Args)]
pub(super) struct LimitOption {
    /// Overrides a limit of the file, as in turning=90, lengths in those of the path;
    /// turning=off removes it
    #[arg(long, value_name = "KIND=LIMIT", value_parser = limit)]
    limit: Vec<(FindingKind, f64)>,
}

impl LimitOption {
    /// The limits of a document, with these instead of its own.
    pub(super) fn over(&self, document: &Document) -> Result<Limits, Failure> {
        let mut limits = document.info().limits;
        for (kind, limit) in &self.limit {
            limits.set(*kind, limit / limit_scale(*kind, document.path().space))?;
        }
        Ok(limits)
    }
}

/// A kind and its limit, as `turning=90`.
fn limit(text: &str) -> Result<(FindingKind, f64), String> {
    let (kind, limit) = text
        .split_once('=')
        .ok_or("a limit is given as KIND=LIMIT")?;
    let kind = FindingKind::parse(kind).map_err(|error| error.to_string())?;
    let limit = match limit {
        "off" => OFF,
        number => number
            .parse()
            .map_err(|_| format!("\"{number}\" is not a number"))?,
    };
    let mut limits = Limits::default();
    limits.set(kind, limit).map_err(|error| error.to_string())?;
    Ok((kind, limit))
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let mut document = input::load_shown(&arguments.file)?.without_history();
    let object = arguments.object.mesh()?;
    let mut info = document.info().clone();
    info.limits = arguments.limits.over(&document)?;
    document.apply(Edit::SetInfo(Box::new(info)))?;
    let at_file = |error: vides::Error| Failure::from(error.at(input::name(&arguments.file)));
    let clearance = document.clearance(object.as_ref()).map_err(at_file)?;
    let mut fixed = Vec::new();
    let found = match &arguments.output {
        Some(output) if is_standard_output(output) => {
            return Err(Failure::Usage(
                "--fix needs a file for --output, and not -".to_owned(),
            ));
        }
        Some(_) => document.fix(
            clearance.as_ref(),
            &mut |finding| fixed.push(*finding),
            &mut progress("findings"),
        ),
        None => document.check_against(clearance.as_ref(), &mut progress("frames")),
    };
    let in_lengths = |finding| in_lengths(finding, document.path().space);
    let found: Vec<_> = found
        .map_err(at_file)?
        .into_iter()
        .map(in_lengths)
        .collect();
    let fixed: Vec<_> = fixed.into_iter().map(in_lengths).collect();
    let notes = document
        .notes(clearance.as_ref(), object.is_none())
        .map_err(at_file)?;
    if let Some(output) = &arguments.output {
        may_replace(&arguments.file);
        write_document(output, &document)?;
        if fixed.is_empty() && !found.is_empty() {
            complain("nothing was fixed: for what is found there is no cure that lessens it");
        }
    }
    print(&if arguments.json {
        json_text(&json(&document, &fixed, &found, &notes))
    } else {
        let told = fixed.iter().map(|finding| {
            let frames = frames(&document, finding);
            format!(
                "Fixed {}, frames {frames}: {}\n",
                finding.kind.name(),
                said(finding)
            )
        });
        lines(&(told.collect::<String>() + &text(&document, &found, &notes)))
    })?;
    if found.is_empty() {
        Ok(())
    } else {
        Err(Failure::Findings)
    }
}

fn text(document: &Document, found: &[Finding], notes: &[Note]) -> String {
    let mut text = String::new();
    if !found.is_empty() {
        let columns = [
            ("Frames", Align::Right),
            ("Kind", Align::Left),
            ("Finding", Align::Left),
        ];
        let mut table = Table::new(&columns);
        for finding in worst(found) {
            table.row(vec![
                frames(document, finding),
                finding.kind.name().to_owned(),
                said(finding),
            ]);
        }
        // Writing into a string cannot fail.
        let _ = writeln!(text, "{}\n", table.to_string().trim_end());
    }
    for kind in FindingKind::all() {
        let count = found.iter().filter(|finding| finding.kind == kind).count();
        if count > LISTED {
            let name = kind.name();
            let _ = writeln!(
                text,
                "{name}: the worst {LISTED} of {count} (--json lists all)"
            );
        }
        if count > 0 {
            let _ = writeln!(text, "{}: {}", kind.name(), kind.remedy());
        }
    }
    for note in notes {
        let _ = writeln!(text, "Note: {note}");
    }
    text
}

/// Findings of one kind that are listed.
const LISTED: usize = 20;

/// Of each kind the findings farthest beyond their limit, in their order.
fn worst(found: &[Finding]) -> Vec<&Finding> {
    // A ratio of 0 or without a number is as far as can be.
    let beyond = |finding: &Finding| (finding.value / finding.limit).ln().abs();
    let mut ranked: Vec<usize> = (0..found.len()).collect();
    ranked.sort_by(|a, b| beyond(&found[*b]).total_cmp(&beyond(&found[*a])));
    let mut listed: Vec<usize> = Vec::new();
    for kind in FindingKind::all() {
        let of_kind = ranked.iter().filter(|at| found[**at].kind == kind);
        listed.extend(of_kind.take(LISTED));
    }
    listed.sort_unstable();
    listed.into_iter().map(|at| &found[at]).collect()
}

/// A finding with its lengths in those of the path.
fn in_lengths(finding: Finding, space: Space) -> Finding {
    let scale = limit_scale(finding.kind, space);
    Finding {
        value: finding.value * scale,
        limit: finding.limit * scale,
        ..finding
    }
}

/// Its sentence.
fn said(finding: &Finding) -> String {
    let sentence = finding.kind.sentence().replace(" half sizes/", " lengths/");
    let number = |value: f64, decimals: usize| format!("{value:.decimals$}");
    finding.say(&sentence.replace(" half sizes", ""), number)
}

/// The frames of a finding as people count them.
fn numbers(document: &Document, finding: &Finding) -> [f64; 2] {
    [finding.first_frame, finding.last_frame].map(|frame| document.number_of_frame(frame))
}

fn frames(document: &Document, finding: &Finding) -> String {
    let [first, last] = numbers(document, finding);
    if first == last {
        format!("{first:.0}")
    } else {
        format!("{first:.0}-{last:.0}")
    }
}

fn json(document: &Document, fixed: &[Finding], found: &[Finding], notes: &[Note]) -> String {
    let fixed = fixed.iter().map(|finding| (finding, ", \"fixed\": true"));
    let findings = fixed.chain(found.iter().map(|finding| (finding, "")));
    let findings = findings.map(|(finding, fixed)| {
        let [first, last] = numbers(document, finding);
        // Names, sentences and finite numbers need no quoting.
        format!(
            "  {{\"kind\": \"{}\", \"first_frame\": {first:?}, \"last_frame\": {last:?}, \"point\": {}, \
             \"orientation\": {}, \"value\": {:?}, \"limit\": {:?}, \"text\": \"{}\"{fixed}}}",
            finding.kind.name(),
            finding.point + 1,
            finding.orientation + 1,
            finding.value,
            finding.limit,
            said(finding)
        )
    });
    let notes = notes.iter().map(|note| {
        // Names of nodes have no control characters.
        let text = note.to_string().replace('\\', "\\\\").replace('"', "\\\"");
        format!("  {{\"kind\": \"note\", \"text\": \"{text}\"}}")
    });
    let objects: Vec<String> = findings.chain(notes).collect();
    if objects.is_empty() {
        return "[]\n".to_owned();
    }
    format!("[\n{}\n]\n", objects.join(",\n"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_worst_of_each_kind_are_listed_in_their_order() {
        let finding = |kind, at: usize, value| Finding {
            kind,
            first_frame: at as f64,
            last_frame: at as f64,
            point: at,
            orientation: 0,
            value,
            limit: 10.0,
        };
        let of_kind = |name, values: &[f64]| -> Vec<Finding> {
            let kind = FindingKind::parse(name).unwrap();
            let all = values.iter().enumerate();
            all.map(|(at, value)| finding(kind, at, *value)).collect()
        };
        let fast: Vec<f64> = (0..30).map(|at| f64::from(11 + (at * 7) % 30)).collect();
        let mut found = of_kind("turning", &fast);
        // Below its limit, and the farther the worse; 0 is the worst.
        found.extend(of_kind("clearance", &[9.0, 0.0]));
        let listed = worst(&found);
        let turning: Vec<f64> = listed.iter().map(|finding| finding.value).collect();
        let wanted: Vec<f64> = fast.iter().copied().filter(|value| *value > 20.0).collect();
        assert_eq!(turning[..20], wanted);
        assert_eq!(turning[20..], [9.0, 0.0]);
    }
}
