//! `.vid` files.
#![no_main]

use libfuzzer_sys::{fuzz_mutator, fuzz_target};
use vides_fuzz::Words;

#[path = "../../tests/hostile/vid.rs"]
mod vid;

const WORDS: Words = Words {
    lines: &[
        "version = 1",
        "title = \"a\"",
        "comment = \"\"\"\na\n[[point]]\n\"\"\"",
        "fps = 25.0",
        "first_frame = -3",
        "closed = true",
        "orientation_mode = \"tcb\"",
        "orientation_mode = \"barry-goldman\"",
        "orientation_mode = \"slerp\"",
        "zoom_mode = \"smooth\"",
        "zoom_mode = \"linear\"",
        "[base_speeds]",
        "move_frames = 100.0",
        "turn_frames = 0.5",
        "zoom_frames = 1e-300",
        "roll_frames = 1e300",
        "[presets]",
        "3 = { tension = 1.0, continuity = -1.0, bias = 1.0 }",
        "[space]",
        "half_size = 2.0",
        "up = \"z\"",
        "centre = [1.0, -1e9, 0.0]",
        "unit = \"m\"",
        "[object]",
        "polylines = [[[0, 0, 0], [1, 1, 1]], [], [[0.5, 0.5, 0.5]]]",
        "[[point]]",
        "position = [-0.6, 0.2, 0.8]",
        "position = [0.6, 0.2, 0.8]",
        "position = [0, 0, 0]",
        "name = \"start\"",
        "preset = 5",
        "own = { tension = 1.0, continuity = -1.0, bias = 0.0 }",
        "own = { tension = -1.0, continuity = 1.0, bias = 1.0 }",
        "[[point.orientation]]",
        "target = [0.0, 0.5, 0.0]",
        "offset = [0.0, 0.0, -0.4]",
        "offset = [0, 1, 0]",
        "offset = [0, -1e-300, 0]",
        "roll_degrees = 180.0",
        "zoom_mm = 100.0",
        "zoom_mm = 1",
        "turning = { tension = -1.0, continuity = 1.0, bias = -1.0 }",
        "speed_curve = [1, 100, 1, 100, 1, 100, 1, 100, 1, 100]",
        "speed_curve = [1, 1, 1, 1, 1, 1, 1, 1, 1, 1]",
        "hold_frames = 1000000",
        "hold_frames = 3",
        "point.orientation = [{ target = [0, 0, 0] }]",
        "point = [{ position = [1, 2, 3] }, { position = [1, 2, 3] }]",
        "# [[point]]",
    ],
    values: &[
        "true",
        "\"a\"",
        "'''\n[[point]]\n'''",
        "\"\\u0085\\\"\\\\\"",
        "[1, 2, 3]",
        "[]",
        "{}",
        "[[1, 2, 3]]",
        "{ tension = 1 }",
        "1979-05-27T07:32:00Z",
        "[1e9, -1e9, 1e-300]",
        "[0.0, 0.0, 0.0]",
    ],
};

fuzz_target!(|bytes: &[u8]| vides_fuzz::bounded(bytes, vid::check));

fuzz_mutator!(|data: &mut [u8], size: usize, most: usize, seed: u32| {
    vides_fuzz::mutate(data, size, most, seed, &WORDS)
});
