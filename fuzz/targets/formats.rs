//! Readers of the formats of other programs, one a run: `VIDES_FORMAT` names it. Without a name the
//! names of all are told, a line each.
#![no_main]

use std::path::PathBuf;
use std::sync::LazyLock;

use libfuzzer_sys::{fuzz_mutator, fuzz_target};
use vides_formats::{Format, by_name, formats};
use vides_fuzz::Words;

#[path = "../../tests/hostile/formats.rs"]
mod hostile;

static FOLDER: LazyLock<PathBuf> = LazyLock::new(vides_fuzz::folder);

static FORMAT: LazyLock<&'static Format> = LazyLock::new(|| {
    let Ok(name) = std::env::var("VIDES_FORMAT") else {
        for format in formats().iter().filter(|format| format.reads()) {
            println!("{}", format.name);
        }
        std::process::exit(0);
    };
    by_name(&name).unwrap_or_else(|error| panic!("{error}"))
});

const WORDS: Words = Words {
    lines: &[
        "# a comment",
        "0 0 0 0 0 0 0 1",
        "1 0 0 0 0 1 0 0 0 0 1 0",
        "1 PINHOLE 1920 1080 540 540 960 540",
        "1 1 0 0 0 0 0 0 1 a.png",
        "--- points3D.txt",
        "--- sparse/0/cameras.txt",
        "--- sparse/0/images.txt",
        "--- dense/sparse/cameras.bin",
        "--- frame-000001.pose.txt",
        "--- 20000000.json",
        "{",
        "},",
        "[",
        "],",
        "\"frames\": [",
        "null,",
    ],
    values: &["0", "\"a\"", "[]", "{}", "null", "true"],
};

fuzz_target!(init: { LazyLock::force(&FORMAT); }, |bytes: &[u8]| {
    vides_fuzz::bounded(bytes, |bytes| hostile::check(*FORMAT, bytes, &FOLDER));
});

fuzz_mutator!(|data: &mut [u8], size: usize, most: usize, seed: u32| {
    vides_fuzz::mutate(data, size, most, seed, &WORDS)
});
