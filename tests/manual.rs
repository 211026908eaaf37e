//! The table in `docs/project/anhang_a.md` says which tests show what the thesis's
//! Anhang A promises. Here it is held against the sources: no test that it
//! names is missing, no section is left out.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

/// The sections with claims about the program. A.6 itself is a heading only.
const SECTIONS: [&str; 11] = [
    "A.2", "A.3", "A.3.1", "A.4", "A.4.1", "A.4.2", "A.4.3", "A.4.4", "A.5", "A.6.1", "A.6.2",
];

fn read(path: &str) -> Result<String, String> {
    let whole = Path::new(env!("CARGO_MANIFEST_DIR")).join(path);
    fs::read_to_string(whole).map_err(|error| format!("{path}: {error}"))
}

/// Whether a source has a function of this name with the mark of a test
/// directly above it.
fn has_test(source: &str, path: &str, name: &str) -> bool {
    let python = Path::new(path).extension().is_some_and(|end| end == "py");
    let (mark, begin) = if python {
        ("@test(", format!("def {name}("))
    } else {
        ("#[test]", format!("fn {name}("))
    };
    let lines: Vec<&str> = source.lines().map(str::trim).collect();
    let found = lines.iter().position(|line| line.starts_with(&begin));
    found.is_some_and(|at| {
        // Documentation, attributes and what a decorator goes on with.
        lines[..at]
            .iter()
            .rev()
            .take_while(|line| !line.is_empty() && *line != &"}")
            .any(|line| line.starts_with(mark))
    })
}

/// What is wrong with a table; and how many rows each section has.
fn check(table: &str) -> (Vec<String>, BTreeMap<String, usize>) {
    let mut wrong = Vec::new();
    let mut rows = BTreeMap::new();
    for line in table.lines().filter(|line| line.starts_with("| A.")) {
        let cells: Vec<&str> = line.split('|').map(str::trim).collect();
        let &["", section, claim, tests, ""] = cells.as_slice() else {
            wrong.push(format!("not three columns: {line}"));
            continue;
        };
        if !SECTIONS.contains(&section) {
            wrong.push(format!("no such section: {section}"));
        }
        if claim.is_empty() {
            wrong.push(format!("no claim: {line}"));
        }
        *rows.entry(section.to_owned()).or_default() += 1;
        for test in tests.split("<br>") {
            let named = test.trim().trim_matches('`').split_once("::");
            let Some((path, name)) = named else {
                wrong.push(format!("{claim}: names no test"));
                continue;
            };
            match read(path) {
                Ok(source) if has_test(&source, path, name) => {}
                Ok(_) => wrong.push(format!("{path} has no test {name}")),
                Err(error) => wrong.push(error),
            }
        }
    }
    for section in SECTIONS {
        if !rows.contains_key(section) {
            wrong.push(format!("{section} has no row"));
        }
    }
    (wrong, rows)
}

#[test]
fn every_claim_of_the_manual_names_tests_that_exist() {
    let (wrong, rows) = check(&read("docs/project/anhang_a.md").expect("the table"));
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(rows.values().sum::<usize>() >= 80, "{rows:?}");
}

#[test]
fn what_is_wrong_in_a_table_is_found() {
    let good = "| A.2 | It opens. | `tests/manual.rs::what_is_wrong_in_a_table_is_found` |";
    let others: String = SECTIONS[1..]
        .iter()
        .map(|section| format!("\n{}", good.replace("A.2", section)))
        .collect();
    let whole = format!("{good}{others}");
    assert_eq!(check(&whole).0, Vec::<String>::new());
    for (bad, why) in [
        (good.replace("what_is", "nothing_is"), "no test"),
        (
            good.replace("what_is_wrong_in_a_table_is_found", "check"),
            "no test",
        ),
        (good.replace("manual.rs", "missing.rs"), "missing.rs"),
        (good.replace("A.2", "A.9"), "no such section"),
        (
            good.replace("`tests/manual.rs::what_is_wrong_in_a_table_is_found`", ""),
            "names no test",
        ),
        (good.replace("It opens.", ""), "no claim"),
    ] {
        let (wrong, _) = check(&format!("{whole}\n{bad}"));
        assert!(wrong.len() == 1 && wrong[0].contains(why), "{wrong:?}");
    }
    assert_eq!(check(&others).0, ["A.2 has no row"]);
}
