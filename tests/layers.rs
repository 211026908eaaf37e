//! The arrows of ARCHITECTURE.md, held against the source: a module may use
//! what lies below it, and nothing else of the crate.
//!
//! The source is read as tokens, without comments and texts, so that a
//! mention in the documentation is no arrow. Paths count that begin with
//! `crate::` or climb to the root by `super::`. And where `unsafe` code may
//! be, as SECURITY.md lists it.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// Each layer with the layers that it stands on directly. What those stand on
/// is below it too.
const ARROWS: &[(&str, &[&str])] = &[
    ("ffi", &["instance", "document"]),
    ("window", &["instance"]),
    ("instance", &["editor", "x11", "raster"]),
    ("editor", &["document", "raster"]),
    ("x11", &["raster"]),
    ("raster", &[]),
    ("document", &["scene"]),
    ("scene", &["path", "deform"]),
    ("deform", &["path"]),
    ("path", &["math"]),
    ("math", &[]),
];

/// What every layer may use. They use each other only.
const GROUND: &[&str] = &["error", "limits", "inject"];

/// The crates of the layers that are not in the main one.
const CRATES: &[&str] = &["vides_engine", "vides_raster"];

/// Items that a crate shows at its root: by `lib.rs`, or a macro.
const RE_EXPORTED: &[&str] = &["Error", "Result", "message"];

fn below(layer: &str) -> BTreeSet<&'static str> {
    let direct = ARROWS
        .iter()
        .find(|(name, _)| *name == layer)
        .map_or(&[][..], |(_, to)| to);
    direct
        .iter()
        .flat_map(|&to| below(to).into_iter().chain([to]))
        .collect()
}

fn allowed(from: &str, to: &str) -> bool {
    from == to || GROUND.contains(&to) || RE_EXPORTED.contains(&to) || below(from).contains(to)
}

/// Words, `::` and single signs of a Rust source. Comments, texts, characters
/// and lifetimes leave nothing behind.
fn tokens(source: &str) -> Vec<String> {
    let text: Vec<char> = source.chars().collect();
    let at = |i: usize| text.get(i).copied().unwrap_or('\0');
    let mut found = Vec::new();
    let mut i = 0;
    while i < text.len() {
        match at(i) {
            '/' if at(i + 1) == '/' => {
                while i < text.len() && at(i) != '\n' {
                    i += 1;
                }
            }
            '/' if at(i + 1) == '*' => {
                let mut depth = 0;
                loop {
                    match (at(i), at(i + 1)) {
                        ('/', '*') => (depth, i) = (depth + 1, i + 2),
                        ('*', '/') => (depth, i) = (depth - 1, i + 2),
                        _ => i += 1,
                    }
                    if depth == 0 || i >= text.len() {
                        break;
                    }
                }
            }
            '"' => {
                i += 1;
                while i < text.len() && at(i) != '"' {
                    i += if at(i) == '\\' { 2 } else { 1 };
                }
                i += 1;
            }
            'r' if raw_text(&text[i + 1..]).is_some() => {
                i += 1 + raw_text(&text[i + 1..]).unwrap_or(0);
            }
            '\'' if at(i + 1) == '\\' => {
                i += 3;
                while i < text.len() && at(i) != '\'' {
                    i += 1;
                }
                i += 1;
            }
            '\'' if at(i + 2) == '\'' => i += 3,
            '\'' => {
                i += 1;
                while at(i).is_alphanumeric() || at(i) == '_' {
                    i += 1;
                }
            }
            ':' if at(i + 1) == ':' => {
                found.push("::".to_owned());
                i += 2;
            }
            c if c.is_alphanumeric() || c == '_' => {
                let start = i;
                while at(i).is_alphanumeric() || at(i) == '_' {
                    i += 1;
                }
                found.push(text[start..i].iter().collect());
                // A prefix of a text (`b"…"`, `c"…"`, `br"…"`) ends here as a
                // word of its own, which no path is made of.
            }
            c => {
                if !c.is_whitespace() {
                    found.push(c.to_string());
                }
                i += 1;
            }
        }
    }
    found
}

/// The length of the raw text that follows an `r`, if one does.
fn raw_text(after_r: &[char]) -> Option<usize> {
    let hashes = after_r.iter().take_while(|&&c| c == '#').count();
    if after_r.get(hashes) != Some(&'"') {
        return None;
    }
    let end: Vec<char> = std::iter::once('"')
        .chain(std::iter::repeat_n('#', hashes))
        .collect();
    let body = &after_r[hashes + 1..];
    let length = body.windows(end.len()).position(|window| window == end)?;
    Some(hashes + 1 + length + end.len())
}

/// The first names after the crate's root that a source mentions. `depth` is
/// how many modules lie between the root and the file (`path/pose.rs`: 2).
fn mentioned(source: &str, depth: usize) -> BTreeSet<String> {
    let words = tokens(source);
    let word = |i: usize| words.get(i).map_or("", String::as_str);
    let mut names = BTreeSet::new();
    let mut inline_modules = Vec::new();
    let mut braces = 0;
    for i in 0..words.len() {
        match word(i) {
            "{" => {
                braces += 1;
                if i >= 2 && word(i - 2) == "mod" {
                    inline_modules.push(braces);
                }
            }
            "}" => {
                if inline_modules.last() == Some(&braces) {
                    inline_modules.pop();
                }
                braces -= 1;
            }
            "crate" if word(i + 1) == "::" => names_from(&words, i + 2, 0, &mut names),
            "super" if i == 0 || word(i - 1) != "::" || word(i.wrapping_sub(2)) == "self" => {
                let mut climbed = 0;
                let mut k = i;
                while word(k) == "super" && word(k + 1) == "::" {
                    climbed += 1;
                    k += 2;
                }
                let to_root = depth + inline_modules.len();
                names_from(&words, k, to_root.saturating_sub(climbed), &mut names);
            }
            _ => {}
        }
    }
    names
}

/// Collects the names at the root: `path` in `path::Pose`, and all of
/// `{path, math::{self}}`. Further `super::` within braces climb on.
fn names_from(words: &[String], i: usize, above: usize, names: &mut BTreeSet<String>) {
    let word = |i: usize| words.get(i).map_or("", String::as_str);
    match word(i) {
        "{" => {
            let mut depth = 0;
            let mut k = i;
            while k < words.len() {
                match word(k) {
                    "{" => depth += 1,
                    "}" => depth -= 1,
                    _ => {}
                }
                if depth == 0 {
                    break;
                }
                if depth == 1 && (word(k) == "{" || word(k) == ",") && word(k + 1) != "}" {
                    names_from(words, k + 1, above, names);
                }
                k += 1;
            }
        }
        "super" if word(i + 1) == "::" => names_from(words, i + 2, above.saturating_sub(1), names),
        "self" if word(i + 1) == "::" => names_from(words, i + 2, above, names),
        name if above == 0 => {
            names.insert(name.to_owned());
        }
        _ => {}
    }
}

fn rust_files(folder: &Path, into: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("a folder of the source") {
        let path = entry.expect("an entry of the source").path();
        if path.is_dir() {
            rust_files(&path, into);
        } else if path.extension().is_some_and(|ending| ending == "rs") {
            into.push(path);
        }
    }
}

/// The layer of a file and the number of modules above its items, in its crate.
fn place(relative: &Path) -> (String, usize) {
    let relative = relative.strip_prefix("engine").unwrap_or(relative);
    let mut parts: Vec<String> = relative
        .with_extension("")
        .iter()
        .map(|part| part.to_string_lossy().into_owned())
        .collect();
    if parts.last().is_some_and(|last| last == "mod") {
        parts.pop();
    }
    (parts[0].clone(), parts.len())
}

#[test]
fn arrows_run_one_way() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut files = Vec::new();
    rust_files(&source, &mut files);
    let mut wrong = Vec::new();
    for file in &files {
        let relative = file.strip_prefix(&source).expect("a file below src");
        let text = fs::read_to_string(file).expect("a source in UTF-8");
        let (layer, depth) = place(relative);
        let shown = relative.display();
        let words = tokens(&text);
        match layer.as_str() {
            "lib" => {}
            // By `lib.rs`, which has the crates under the names of their layers.
            _ if words.iter().any(|word| CRATES.contains(&word.as_str())) => {
                wrong.push(format!("{shown}: another crate but by the root's names"));
            }
            // A crate of its own, whose manifest says what it may use.
            "raster" => {}
            // The command is a crate of its own and sees what every user sees.
            "main" | "command" => {
                if words
                    .windows(3)
                    .any(|w| w[0] == "vides" && w[1] == "::" && w[2] == "ffi")
                {
                    wrong.push(format!("{shown}: the command reaches for ffi"));
                }
            }
            layer if GROUND.contains(&layer) => wrong.extend(
                mentioned(&text, depth)
                    .iter()
                    .filter(|to| {
                        !GROUND.contains(&to.as_str()) && !RE_EXPORTED.contains(&to.as_str())
                    })
                    .map(|to| format!("{shown}: {layer} → {to}")),
            ),
            layer if ARROWS.iter().any(|(name, _)| *name == layer) => wrong.extend(
                mentioned(&text, depth)
                    .iter()
                    .filter(|to| !allowed(layer, to))
                    .map(|to| format!("{shown}: {layer} → {to}")),
            ),
            _ => wrong.push(format!("{shown}: no layer of ARCHITECTURE.md")),
        }
    }
    assert!(
        files.len() > 10,
        "the source was not found in {}",
        source.display()
    );
    assert!(
        wrong.is_empty(),
        "arrows against ARCHITECTURE.md:\n{}",
        wrong.join("\n")
    );
}

/// The files and folders of the source that a list names, `src/…` in backticks.
fn listed(list: &str) -> BTreeSet<&str> {
    let quoted = list.split('`').skip(1).step_by(2);
    quoted.filter(|name| name.starts_with("src/")).collect()
}

#[test]
fn unsafe_code_is_where_security_md_says() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let text = fs::read_to_string(root.join("SECURITY.md")).expect("SECURITY.md");
    let (_, list) = (text.split_once("`unsafe` code is confined to")).expect("the list");
    let (list, _) = list.split_once("Every block").expect("the list's end");
    let mut unseen = listed(list);
    let mut files = Vec::new();
    rust_files(&root.join("src"), &mut files);
    let mut wrong = Vec::new();
    for file in &files {
        let source = fs::read_to_string(file).expect("a source in UTF-8");
        if !tokens(&source).iter().any(|word| word == "unsafe") {
            continue;
        }
        let shown = file.strip_prefix(root).expect("a file of the source");
        let named = listed(list)
            .into_iter()
            .find(|name| shown.starts_with(name));
        match named {
            Some(name) => drop(unseen.remove(name)),
            None if shown.to_string_lossy().ends_with("tests.rs") => {}
            None => wrong.push(format!("{}: not in SECURITY.md", shown.display())),
        }
    }
    wrong.extend(unseen.iter().map(|name| format!("{name}: no unsafe code")));
    assert!(wrong.is_empty(), "unsafe code:\n{}", wrong.join("\n"));
}

#[test]
fn every_way_to_write_an_arrow_is_seen() {
    let seen = |source: &str, depth| {
        mentioned(source, depth)
            .into_iter()
            .collect::<Vec<_>>()
            .join(" ")
    };
    assert_eq!(seen("use crate::path::Pose;", 1), "path");
    assert_eq!(
        seen(
            "use crate::{error::{Error, Result}, ffi, math::{self, x}};",
            1
        ),
        "error ffi math"
    );
    assert_eq!(
        seen(
            "fn f() -> crate::document::Document { g(crate::limits::A) }",
            2
        ),
        "document limits"
    );
    assert_eq!(
        seen("macro_rules! m { () => { $crate::ffi::g() } }", 1),
        "ffi"
    );
    assert_eq!(
        seen("pub(crate) use super::{super::ffi::f, sibling};", 2),
        "ffi"
    );
    assert_eq!(seen("use super::super::ffi;", 2), "ffi");
    assert_eq!(seen("use self::super::ffi;", 1), "ffi");
    assert_eq!(seen("use super::sibling::Thing;", 2), "");
    assert_eq!(seen("mod tests { use super::super::sibling; }", 2), "");
    assert_eq!(
        seen(
            "mod tests { use super::super::super::ffi; } use super::super::x11;",
            2
        ),
        "ffi x11"
    );
    assert_eq!(
        seen(
            "// crate::ffi\n/* crate::a /* */ crate::b */ \"crate::c\" r#\"crate::d\"#",
            1
        ),
        ""
    );
    assert_eq!(
        seen(
            "fn f<'a>(c: char) { c == '\"' || c == '\\'' ; crate::x11::g() }",
            1
        ),
        "x11"
    );
}

#[test]
fn layers_see_what_is_below_and_no_more() {
    assert!(allowed("ffi", "math") && allowed("editor", "path") && allowed("instance", "x11"));
    for (from, to) in [
        ("math", "path"),
        ("path", "document"),
        ("document", "ffi"),
        ("document", "editor"),
        ("editor", "x11"),
        ("raster", "x11"),
        ("raster", "editor"),
        ("x11", "editor"),
        ("instance", "ffi"),
    ] {
        assert!(!allowed(from, to), "{from} → {to}");
    }
}
