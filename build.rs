//! Refuses to build a library whose header names another version.
//!
//! Nothing is generated: the header is checked in (`make header`), and the C
//! libraries are made by the Makefile, which needs more than cargo offers.

use std::fs;

const HEADER: &str = "include/libvides.h";

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-changed={HEADER}");
    let header = fs::read_to_string(HEADER).expect("the C header");
    for (part, number) in [
        ("MAJOR", env!("CARGO_PKG_VERSION_MAJOR")),
        ("MINOR", env!("CARGO_PKG_VERSION_MINOR")),
        ("PATCH", env!("CARGO_PKG_VERSION_PATCH")),
    ] {
        let line = format!("#define V_VERSION_{part} {number}");
        assert!(
            header.lines().any(|l| l == line),
            "{HEADER} does not say `{line}`: run `make header`"
        );
    }
}
