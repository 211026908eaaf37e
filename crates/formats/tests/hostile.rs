//! Files that the fuzzer begins with, or that it found to do harm, below `tests/corpus/formats`, a
//! folder for each format: any reader refuses any of them with a sentence, or takes it whole.

use std::fs;
use std::path::{Path, PathBuf};

use vides_formats::{Format, by_name, formats};

#[path = "../../../tests/hostile/formats.rs"]
mod hostile;

fn corpus() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/corpus/formats")
}

/// The files of each format, in the order of their names.
fn files() -> Vec<(&'static Format, Vec<PathBuf>)> {
    let folders = fs::read_dir(corpus())
        .unwrap()
        .map(|entry| entry.unwrap().path());
    let files = folders.map(|folder| {
        let name = folder.file_name().unwrap().to_str().unwrap();
        let entries = fs::read_dir(&folder).unwrap();
        let mut files: Vec<_> = entries.map(|entry| entry.unwrap().path()).collect();
        files.sort();
        (by_name(name).unwrap(), files)
    });
    files.collect()
}

fn readers() -> impl Iterator<Item = &'static Format> {
    formats().iter().copied().filter(|format| format.reads())
}

/// Those of `vid` are the document's, in `tests/corpus`.
#[test]
fn every_reader_has_files_of_its_own() {
    for format in readers().filter(|format| format.name != "vid") {
        let name = format.name;
        let has_files = |(of, files): &(&Format, Vec<_>)| of.name == name && files.len() > 1;
        assert!(files().iter().any(has_files), "{name}");
    }
}

/// The page of formats, the manual page, and what a host can give `v_scene_export`.
#[test]
fn every_format_is_told_of() {
    for (place, text) in [
        (
            "docs/reference/formats.md",
            include_str!("../../../docs/reference/formats.md"),
        ),
        ("man/vides.1", include_str!("../../../man/vides.1")),
        (
            "src/ffi/exchange.rs",
            include_str!("../../../src/ffi/exchange.rs"),
        ),
    ] {
        let of_a_name = |c: char| c.is_ascii_alphanumeric() || "_-".contains(c);
        // The manual page escapes hyphens.
        let text = text.replace('\\', "");
        let words: Vec<_> = text.split(|c: char| !of_a_name(c)).collect();
        for format in formats() {
            let name = format.name;
            assert!(words.contains(&name), "{place}: {name}");
        }
    }
}

#[test]
fn files_of_the_corpus_are_refused_or_in_order_in_every_reader() {
    let folder = tempfile::tempdir().unwrap();
    let mut count = 0;
    for file in files().iter().flat_map(|(_, files)| files) {
        let bytes = fs::read(file).unwrap();
        for format in readers() {
            println!("{} as {}", file.display(), format.name);
            hostile::check(format, &bytes, folder.path());
            count += 1;
        }
    }
    assert!(count > 300, "{count} readings");
}

/// Every file cut off, and with a byte or a number exchanged: what costs nothing to try each time.
#[test]
fn broken_files_are_refused_or_in_order() {
    let folder = tempfile::tempdir().unwrap();
    let mut random = 0x2545_F491_4F6C_DD1D_u64;
    let mut below = |most: usize| {
        random ^= random >> 12;
        random ^= random << 25;
        random ^= random >> 27;
        (random >> 33) as usize % most.max(1)
    };
    const WORDS: [&[u8]; 9] = [
        b"-1",
        b"1e308",
        b"1e-320",
        b"nan",
        b"9223372036854775808",
        b"0",
        b"null",
        b"\"\"",
        b"\xff",
    ];
    for (format, files) in files() {
        for file in files {
            let bytes = fs::read(&file).unwrap();
            for turn in 0..40 {
                let at = below(bytes.len());
                let changed = match turn % 4 {
                    0 => bytes[..at].to_vec(),
                    1 => {
                        let mut changed = bytes.clone();
                        if let Some(byte) = changed.get_mut(at) {
                            *byte = below(256) as u8;
                        }
                        changed
                    }
                    2 => [&bytes[..at], WORDS[below(WORDS.len())], &bytes[at..]].concat(),
                    _ => {
                        let end = (at + below(20)).min(bytes.len());
                        [&bytes[..at], WORDS[below(WORDS.len())], &bytes[end..]].concat()
                    }
                };
                hostile::check(format, &changed, folder.path());
            }
        }
    }
}
