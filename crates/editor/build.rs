//! Packs the window's fonts, which are half as large then.
//!
//! Nothing else is made at build time: the C header is checked in (`make
//! header`) and the C libraries are made by the Makefile, which needs more than
//! cargo offers.

use std::path::PathBuf;
use std::{env, fs};

/// As hard as it tries.
const LEVEL: u8 = 10;

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    let folder = PathBuf::from(env::var_os("OUT_DIR").expect("cargo names a folder"));
    for (name, font) in [
        ("text", epaint_default_fonts::UBUNTU_LIGHT),
        ("signs", epaint_default_fonts::EGUI_ICONS),
    ] {
        let packed = miniz_oxide::deflate::compress_to_vec(font, LEVEL);
        fs::write(folder.join(name), packed).expect("a file in cargo's folder");
    }
}
