//! Setup files.
#![no_main]

use std::path::PathBuf;
use std::sync::LazyLock;

use libfuzzer_sys::{fuzz_mutator, fuzz_target};
use vides_fuzz::Words;

static FOLDER: LazyLock<PathBuf> = LazyLock::new(vides_fuzz::folder);

const WORDS: Words = Words {
    lines: &[
        "version = 1",
        "theme = \"dark\"",
        "theme = \"light\"",
        "camera_view = false",
        "[view]",
        "rotation_degrees = 270",
        "rotation_degrees = -1e300",
        "tilt_degrees = -90.0",
        "size = 50.0",
        "size = 0.1",
        "shift = [4.0, -4.0]",
        "[shown]",
        "cube = false",
        "current_segment = true",
        "vup_circle = false",
        "background = false",
        "[dark]",
        "[light]",
        "background = \"#000000\"",
        "curve = \"#FFfFff\"",
        "player = \"#a0b1c2\"",
        "dark.curve = \"#010203\"",
        "view = { size = 2, shift = [0, 0] }",
    ],
    values: &[
        "true",
        "false",
        "\"dark\"",
        "\"#12345g\"",
        "\"#äöü\"",
        "\"#\\u0000\"",
        "[1, 2]",
        "{}",
        "[]",
        "1979-05-27",
    ],
};

fuzz_target!(|bytes: &[u8]| {
    vides_fuzz::bounded(bytes, |bytes| vides::hostile::setup(&FOLDER, bytes));
});

fuzz_mutator!(|data: &mut [u8], size: usize, most: usize, seed: u32| {
    vides_fuzz::mutate(data, size, most, seed, &WORDS)
});
