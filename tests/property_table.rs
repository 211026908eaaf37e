//! The tables of keys in `docs/reference/files.md` are what the rows of properties say.
//!
//! `UPDATE_DOCS=1 cargo test --test property_table` writes them anew.

use std::fmt::Write as _;

use vides::limits;
use vides::property::{Listed, Owner};

const FILE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/reference/files.md");
const END: &str = "<!-- end -->";

/// Kind, unit and range of a value, as "number (mm), 1 to 2000".
fn value(row: &Listed) -> String {
    let mut out = row.kind.to_string();
    if !row.unit.name().is_empty() {
        write!(out, " ({})", row.unit.name()).unwrap();
    }
    let range = row.range.filter(|(low, _)| *low > f64::from(i32::MIN));
    if let Some((low, high)) = range {
        write!(out, ", {low} to {high}").unwrap();
    }
    out
}

fn table(rows: &[Listed]) -> String {
    // No node changes a path, and copies of nodes have everything.
    let of_path = rows.iter().all(|row| row.owner != Owner::Node);
    let (head, line) = match of_path {
        true => ("affects | ", "---|"),
        false => ("", ""),
    };
    let mut out = format!("| key | value | new | {head}what it is |\n|---|---|---|{line}---|\n");
    for row in rows {
        let new = match row.new.as_str() {
            "" => String::new(),
            new => format!("`{new}`"),
        };
        let affects = match (of_path, row.copied) {
            (true, true) => format!("{} | ", row.affects.name()),
            (true, false) => format!("{}, not copied | ", row.affects.name()),
            (false, _) => String::new(),
        };
        let (key, value, does) = (row.key, value(row), row.does.replace('|', "\\|"));
        writeln!(out, "| `{key}` | {value} | {new} | {affects}{does} |").unwrap();
    }
    out
}

#[test]
fn the_manual_names_every_key() {
    let manual = include_str!("../man/vides.1");
    let of_a_key = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let words: Vec<_> = manual.split(|c| !of_a_key(c)).collect();
    for row in vides::properties() {
        assert!(words.contains(&row.key), "{}", row.key);
    }
}

/// What stands in the tables is read by people: no links of rustdoc, and the numbers of the limits.
#[test]
fn a_property_says_what_it_is_in_plain_words() {
    let all = vides::properties();
    for row in &all {
        let code = ["[`", "`]", "::"]
            .iter()
            .any(|mark| row.does.contains(mark));
        assert!(!code, "{}: {}", row.key, row.does);
    }
    for (key, limit) in [
        ("title", limits::MAX_NAME_BYTES as f64),
        ("comment", limits::MAX_COMMENT_BYTES as f64),
        ("fps", limits::MAX_FPS),
    ] {
        let row = all.iter().find(|row| row.key == key).unwrap();
        assert!(row.does.contains(&format!(" {limit}")), "{}", row.does);
    }
}

#[test]
fn the_documents_tables_are_current() {
    let mut text = std::fs::read_to_string(FILE).unwrap();
    let all = vides::properties();
    for owner in [Owner::Path, Owner::Point, Owner::View, Owner::Node] {
        let begin = format!("<!-- begin: properties of a {} -->\n", owner.name());
        let rows: Vec<_> = all
            .iter()
            .filter(|row| row.owner == owner)
            .cloned()
            .collect();
        let (before, rest) = text.split_once(&begin).expect("the table's begin");
        let (_, after) = rest.split_once(END).expect("the table's end");
        text = format!("{before}{begin}{}{END}{after}", table(&rows));
    }
    if std::env::var_os("UPDATE_DOCS").is_some() {
        std::fs::write(FILE, text).unwrap();
        return;
    }
    let found = std::fs::read_to_string(FILE).unwrap();
    assert!(
        found == text,
        "run UPDATE_DOCS=1 cargo test --test property_table"
    );
}
