//! What is known of a format before any file: its names, and what it can do.

use std::path::Path;

use vides_engine::path::Up;

/// The names of all formats, in the order in which they are offered, which errors tell.
pub(super) const NAMES: [&str; 19] = [
    "vid",
    "ascii",
    "csv",
    "json",
    "gltf",
    "glb",
    "usda",
    "blender",
    "paraview",
    "vtk",
    "html",
    "nerfstudio",
    "transforms",
    "cameras",
    "tum",
    "kitti",
    "colmap",
    "osg",
    "chan",
];

/// The names of a format and what it can do.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Row {
    /// As `--from` and `--to` take it.
    pub name: &'static str,
    /// As people call it.
    pub title: &'static str,
    /// File name extensions, without the dot; the first is proposed.
    pub endings: &'static [&'static str],
    /// Whole file names that are always of this format.
    pub file_names: &'static [&'static str],
    /// Which axis stands upright in every file, if the format says so.
    pub up: Option<Up>,
    /// The files of a format that is a folder.
    pub parts: &'static [&'static str],
    /// Whether all of a scene is written, with or without a camera.
    pub whole: bool,
    /// Whether it can be read.
    pub reads: bool,
    /// Whether it can be written.
    pub writes: bool,
}

impl Row {
    /// A format of one file, of which nothing is known yet.
    pub const PLAIN: Self = Self {
        name: "",
        title: "",
        endings: &[],
        file_names: &[],
        up: None,
        parts: &[],
        whole: false,
        reads: true,
        writes: true,
    };

    /// Whether a file of this name is of the format: by the whole name, or by the ending.
    #[must_use]
    pub fn is_named(&self, file: &Path) -> bool {
        self.has_name(file) || self.has_ending(file)
    }

    pub(super) fn has_name(&self, file: &Path) -> bool {
        let name = file.file_name().unwrap_or_default();
        let known = self.file_names.iter().chain(self.parts);
        known
            .into_iter()
            .any(|known| name.eq_ignore_ascii_case(known))
    }

    pub(super) fn has_ending(&self, file: &Path) -> bool {
        let ending = file.extension().unwrap_or_default();
        let known = self.endings.iter();
        known
            .into_iter()
            .any(|known| ending.eq_ignore_ascii_case(known))
    }
}
