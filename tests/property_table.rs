//! The table of a view's keys in `docs/files.md` is what the engine's rows say.
//!
//! `UPDATE_DOCS=1 cargo test --test property_table` writes it anew.

use std::fmt::Write as _;

use vides::path::{Orientation, OrientationOverrides};
use vides::property::Property;

const FILE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/files.md");
const BEGIN: &str = "<!-- begin: properties of a view -->\n";
const END: &str = "<!-- end -->";

fn rows<T>(table: &[Property<T>], new: &T, out: &mut String) {
    for row in table.iter().filter(|row| !row.keys.is_empty()) {
        let keys = row.keys.join("`, `");
        let range = match row.range {
            Some((low, high)) => format!("{low} to {high}"),
            None => String::new(),
        };
        let value = (row.value)(new).map_or(String::new(), |value| format!("`{value}`"));
        let does = row.does.trim().replace('|', "\\|");
        let (kind, unit) = (row.kind, row.unit.name());
        writeln!(
            out,
            "| `{keys}` | {kind} | {unit} | {range} | {value} | {does} |"
        )
        .unwrap();
    }
}

#[test]
fn the_manual_names_every_key() {
    let manual = include_str!("../man/vides.1");
    let views = Orientation::PROPERTIES.iter().flat_map(|row| row.keys);
    let own = OrientationOverrides::PROPERTIES
        .iter()
        .flat_map(|row| row.keys);
    for key in views.chain(own) {
        assert!(manual.contains(key), "{key}");
    }
}

#[test]
fn the_documents_table_is_current() {
    let mut table = String::from(
        "| key | kind | unit | range | new | what it is |\n|---|---|---|---|---|---|\n",
    );
    let new = Orientation::default();
    rows(Orientation::PROPERTIES, &new, &mut table);
    rows(OrientationOverrides::PROPERTIES, &new.own, &mut table);
    let text = std::fs::read_to_string(FILE).unwrap();
    let (before, rest) = text.split_once(BEGIN).expect("the table's begin");
    let (found, after) = rest.split_once(END).expect("the table's end");
    if std::env::var_os("UPDATE_DOCS").is_some() {
        std::fs::write(FILE, format!("{before}{BEGIN}{table}{END}{after}")).unwrap();
    } else {
        assert_eq!(
            found, table,
            "run UPDATE_DOCS=1 cargo test --test property_table"
        );
    }
}
