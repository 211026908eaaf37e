//! What is to be planned: a path, an object and what is asked for, of bytes.
#![no_main]

use libfuzzer_sys::fuzz_target;

#[path = "../../tests/hostile/planner.rs"]
mod planner;

fuzz_target!(|bytes: &[u8]| {
    planner::check(bytes);
});
