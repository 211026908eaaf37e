//! What any bytes at all may do as a mesh; the first says in which format. Used by the
//! tests and, by path, by the fuzzer in `fuzz/`, so that both ask the same.

use vides::document::mesh::{self, Format};

/// Reads bytes as a mesh: it is refused with one sentence, or it is in order.
///
/// # Panics
/// If that does not hold.
pub(crate) fn check(bytes: &[u8]) {
    let Some((&first, rest)) = bytes.split_first() else {
        return;
    };
    let format = [Format::Obj, Format::Ply, Format::Stl, Format::Gltf][usize::from(first) % 4];
    match mesh::read(format, rest, &mut |_| true) {
        Ok(mesh) => mesh.check().expect("a mesh in order"),
        Err(error) => {
            let sentence = error.to_string();
            assert!(!sentence.chars().any(char::is_control), "{sentence:?}");
        }
    }
}
