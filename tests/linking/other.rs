//! Another Rust library in the same program, just as rustc leaves it: with
//! its own standard library and its own unwinding.
use std::ffi::c_int;

/// The length of a text that is made while a panic passes.
#[unsafe(no_mangle)]
pub extern "C" fn other_rust(number: c_int) -> c_int {
    std::panic::catch_unwind(|| {
        let text = std::hint::black_box(format!("{number}"));
        assert!(text.is_empty(), "this panic is part of the test too");
        0
    })
    .unwrap_or(7)
}
