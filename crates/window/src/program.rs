//! The program whose windows these are, by its name.

use std::path::Path;

/// What the program was called by, without folders; empty where it was called by
/// nothing. By this name a desktop puts our windows beside the program's own.
pub(super) fn name() -> String {
    let called = std::env::args_os().next().unwrap_or_default();
    let name = Path::new(&called).file_name().unwrap_or_default();
    name.to_string_lossy().into_owned()
}
