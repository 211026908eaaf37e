//! Recovery files: a document below comments that tell where it comes from.
#![no_main]

use std::path::PathBuf;
use std::sync::LazyLock;

use libfuzzer_sys::{fuzz_mutator, fuzz_target};
use vides_fuzz::Words;

static FOLDER: LazyLock<PathBuf> = LazyLock::new(vides_fuzz::folder);

const WORDS: Words = Words {
    lines: &[
        "# Work in VIDES that was not saved.",
        "# process = 1",
        "# written = 18446744073709551615",
        "# file = /home/a/b.vid",
        "# file = relative.vid",
        "# file = %",
        "# file = %2",
        "# file = %+A",
        "# file = %00",
        "# file = %FF%fe%C3%A4 b",
        "# file = ",
        "# file = ../..",
        "version = 1",
        "closed = true",
        "[[point]]",
        "position = [-0.6, 0.2, 0.8]",
        "position = [0.6, 0.2, 0.8]",
        "[[point.orientation]]",
        "target = [0.0, 0.5, 0.0]",
        "hold_frames = 3",
    ],
    values: &["/a/b", "%2F%25", "true", "[1, 2, 3]", "\"a\""],
};

fuzz_target!(|bytes: &[u8]| {
    vides_fuzz::bounded(bytes, |bytes| vides::hostile::recovery(&FOLDER, bytes));
});

fuzz_mutator!(|data: &mut [u8], size: usize, most: usize, seed: u32| {
    vides_fuzz::mutate(data, size, most, seed, &WORDS)
});
