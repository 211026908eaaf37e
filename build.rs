//! Nothing is made at build time: the C header is checked in (`make header`)
//! and the C libraries are made by the Makefile, which needs more than cargo
//! offers. What stands here keeps cargo from asking again at every change.
fn main() {
    println!("cargo::rerun-if-changed=build.rs");
}
