//! Meshes in OBJ, PLY and STL.
#![no_main]

use libfuzzer_sys::fuzz_target;

#[path = "../../tests/hostile/mesh.rs"]
mod mesh;

fuzz_target!(|bytes: &[u8]| vides_fuzz::bounded(bytes, mesh::check));
