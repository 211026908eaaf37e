//! `vides edit`: the editor in a window, until it is closed.

use std::path::Path;

use super::failure::Failure;
use super::input;

/// The path, and the object that is shown with it. A mesh in a path's place is the object of a new
/// path.
fn opened<'a>(file: Option<&'a Path>, object: Option<&'a Path>) -> [Option<&'a Path>; 2] {
    match file.filter(|file| !input::is_path(file)) {
        Some(mesh) if object.is_none() => [None, Some(mesh)],
        _ => [file, object],
    }
}

pub(super) fn run(file: Option<&Path>, object: Option<&Path>) -> Result<(), Failure> {
    if file.is_some_and(input::is_standard_stream) {
        return Err(Failure::Usage(
            "the editor needs a file that it can save to, and not -".to_owned(),
        ));
    }
    let [file, object] = opened(file, object);
    vides::window::edit(file, object).map_err(|error| match (&error, file) {
        (vides::window::Error::Document(_), Some(file)) => input::refused(file, &error),
        _ => error.into(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mesh_is_the_object_of_a_new_path() {
        let [path, mesh] = ["flight.vid", "house.glb"].map(Path::new);
        assert_eq!(opened(Some(mesh), None), [None, Some(mesh)]);
        assert_eq!(opened(Some(path), None), [Some(path), None]);
        assert_eq!(opened(Some(path), Some(mesh)), [Some(path), Some(mesh)]);
        assert_eq!(opened(None, Some(mesh)), [None, Some(mesh)]);
    }
}
