//! `include/libvides.h` is what cbindgen makes of `src/ffi` today.
//!
//! `make header` (or `UPDATE_HEADER=1 cargo test --test header`) writes it anew.

use std::fs;
use std::path::Path;

/// The files with exports, in the order in which the header shows them.
const SOURCES: [&str; 36] = [
    "status",
    "types",
    "path",
    "path_object",
    "points",
    "orientations",
    "space",
    "properties",
    "curve",
    "shape",
    "poses",
    "times",
    "toolbox",
    "tools",
    "fit",
    "checks",
    "progress",
    "scene_types",
    "scene",
    "scene_properties",
    "scene_shown",
    "scene_tracks",
    "scene_contents",
    "scene_states",
    "exchange",
    "editor",
    "live",
    "editor_scene",
    "editor_steps",
    "host_loop",
    "legacy",
    "quaternions",
    "splines",
    "pace",
    "view",
    "camera",
];

/// The last touches: what C89 does not take, and what cbindgen has no setting
/// for.
fn polished(made: &str) -> String {
    // Not C89.
    let made = made
        .replace("  // __cplusplus", "")
        .replace(" // __cplusplus", "")
        .replace("  // extern \"C\"", "")
        // Said by the typedef that follows.
        .replace("struct v_path;\n\n", "")
        .replace("struct v_editor;\n\n", "")
        .replace("struct v_scene;\n\n", "")
        // The thesis names the type without "struct", as C++ allows it.
        .replace(
            "typedef struct interpolparameter V_KAMERAPAR;",
            "typedef struct interpolparameter interpolparameter;\ntypedef interpolparameter V_KAMERAPAR;",
        )
        // Constants that share a comment stand together.
        .replace("\n\n#define V_", "\n#define V_")
        .replace("\n\n\n", "\n\n");
    // What cbindgen puts at the end belongs within the guard.
    let end = "#endif  /* LIBVIDES_H */\n";
    let made = match made.split_once(end) {
        Some((before, trailer)) => format!("{before}{}\n{end}", trailer.trim_start()),
        None => made,
    };
    let lines: Vec<&str> = made.lines().collect();
    let mut header = String::new();
    let mut at = 0;
    while at < lines.len() {
        let rest = &lines[at..];
        let (text, taken) = heading(rest)
            .or_else(|| short_comment(rest))
            .or_else(|| declaration(rest))
            .unwrap_or_else(|| (rest[0].to_owned(), 1));
        header += &text;
        header += "\n";
        at += taken;
    }
    header
}

/// A comment that begins with `==== Heading: sentence ====` begins a part of the header; both
/// get lines of their own before the comment.
fn heading(lines: &[&str]) -> Option<(String, usize)> {
    let ["/**", heading, " *", ..] = lines else {
        return None;
    };
    let heading = heading.strip_prefix(" * ==== ")?.strip_suffix(" ====")?;
    let (title, sentence) = heading.split_once(": ").unwrap_or((heading, ""));
    let rule = "-".repeat(72 - title.len());
    let sentence = match sentence {
        "" => String::new(),
        sentence => format!(
            "/* {}{}. */\n",
            sentence[..1].to_uppercase(),
            &sentence[1..]
        ),
    };
    Some((format!("\n/* ---- {title} {rule} */\n{sentence}\n/**"), 3))
}

/// A comment of one line stands on one line.
fn short_comment(lines: &[&str]) -> Option<(String, usize)> {
    let [begin, text, end, ..] = lines else {
        return None;
    };
    let (indent, text) = text.split_once("* ")?;
    (begin.trim() == "/**" && end.trim() == "*/" && text.len() < 68)
        .then(|| (format!("{}/** {text} */", &indent[1..]), 3))
}

/// A declaration takes as few lines as its parameters fit in.
fn declaration(lines: &[&str]) -> Option<(String, usize)> {
    let is_function = lines[0].starts_with(|c: char| c.is_ascii_lowercase())
        && !lines[0].starts_with("typedef")
        && (lines[0].contains(" v_") || lines[0].contains(" *v_"));
    if !is_function || lines[0].ends_with(';') {
        return None;
    }
    let taken = 1 + lines.iter().position(|line| line.ends_with(");"))?;
    let (head, _) = lines[0].split_once('(')?;
    let mut text = format!("{head}(");
    let indent = text.len();
    let mut column = indent;
    let all = lines[..taken]
        .iter()
        .map(|line| line.trim())
        .collect::<Vec<_>>();
    let all = all.join(" ");
    for (at, parameter) in parameters(&all[indent..]).into_iter().enumerate() {
        if at > 0 && column + 1 + parameter.len() > 84 {
            text += &format!("\n{:indent$}", "");
            column = indent;
        } else if at > 0 {
            text += " ";
            column += 1;
        }
        text += parameter;
        column += parameter.len();
    }
    Some((text, taken))
}

/// Parameters with the comma or bracket that ends each; one may be a function with its own.
fn parameters(text: &str) -> Vec<&str> {
    let (mut depth, mut from, mut all) = (0, 0, Vec::new());
    for (at, c) in text.char_indices() {
        match c {
            '(' => depth += 1,
            ')' => depth -= 1,
            ',' if depth == 0 => {
                all.push(text[from..=at].trim());
                from = at + 1;
            }
            _ => {}
        }
    }
    all.push(text[from..].trim());
    all
}

fn made() -> String {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let config = cbindgen::Config::from_file(root.join("cbindgen.toml")).expect("cbindgen.toml");
    let mut builder = cbindgen::Builder::new().with_config(config);
    for source in SOURCES {
        builder = builder.with_src(root.join(format!("src/ffi/{source}.rs")));
    }
    let mut text = Vec::new();
    builder
        .generate()
        .expect("sources that can be read")
        .write(&mut text);
    polished(&String::from_utf8(text).expect("UTF-8"))
}

#[test]
fn the_header_is_current() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("include/libvides.h");
    let made = made();
    if std::env::var_os("UPDATE_HEADER").is_some() {
        fs::create_dir_all(file.parent().expect("a folder")).expect("the folder include");
        fs::write(&file, made).expect("the header written");
        return;
    }
    let there = fs::read_to_string(&file).unwrap_or_default();
    assert!(
        there == made,
        "include/libvides.h is not what src/ffi says: run `make header`"
    );
}

/// Every export stands in a file that the header is made of.
#[test]
fn no_export_is_missing() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/ffi");
    let header = made();
    let mut exports = 0;
    for entry in fs::read_dir(folder).expect("src/ffi") {
        let source = fs::read_to_string(entry.expect("an entry").path()).expect("a source");
        for declaration in source.split("extern \"C\" fn v_").skip(1) {
            let name = declaration.split('(').next().expect("a name");
            let declared = [" ", "*"].map(|before| format!("{before}v_{name}("));
            assert!(
                declared.iter().any(|text| header.contains(text)),
                "v_{name}"
            );
            exports += 1;
        }
    }
    assert!(exports > 40, "{exports} exports");
}
