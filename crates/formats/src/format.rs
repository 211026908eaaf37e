//! What a format is, and the table of all.

use std::io::Write;
use std::path::Path;

use super::content::Content;
use super::error::{Error, Result};
use super::flight::Flight;
use super::loss::Report;
use super::options::Options;
use super::source::Source;
use super::{
    ascii, cameras, chan, colmap, csv, gltf, html, json, kitti, nerfstudio, osg, script,
    transforms, tum, usd, vid,
};
use crate::path::Up;

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

/// A file format.
pub trait Format: Sync {
    /// Its names and what it can do.
    fn row(&self) -> &'static Row;

    /// Whether the content looks like this format; of files that several recognise the user must
    /// name the format.
    fn recognises(&self, _source: &Source) -> bool {
        false
    }

    /// Reads all of a file.
    ///
    /// # Errors
    /// One sentence with the place in the file and the reason.
    fn read(&self, _source: &Source, _options: &Options, _report: &mut Report) -> Result<Content> {
        Err(Error::NotRead(self.row().name))
    }

    /// Fails if nothing may be written into a folder.
    ///
    /// # Errors
    /// What stands in the way there.
    fn check_folder(&self, _folder: &Path) -> Result<()> {
        Ok(())
    }

    /// Writes a flight; of a format of several files the one with this index in [`Row::parts`].
    ///
    /// # Errors
    /// Those of sampling; [`Error::Document`] if `out` fails.
    fn write(
        &self,
        _flight: &mut Flight<'_>,
        _part: usize,
        _out: &mut dyn Write,
        _report: &mut Report,
    ) -> Result<()> {
        Err(Error::NotWritten(self.row().name))
    }
}

/// All formats, in the order in which they are offered.
#[must_use]
pub fn formats() -> &'static [&'static dyn Format] {
    &[
        &vid::Vid,
        &ascii::Ascii,
        &csv::Csv,
        &json::Json,
        &gltf::Gltf,
        &gltf::Glb,
        &usd::Usda,
        &script::Blender,
        &script::ParaView,
        &script::Vtk,
        &html::Html,
        &nerfstudio::Nerfstudio,
        &transforms::Transforms,
        &cameras::Cameras,
        &tum::Tum,
        &kitti::Kitti,
        &colmap::Colmap,
        &osg::Osg,
        &chan::Chan,
    ]
}

/// The format of this name.
///
/// # Errors
/// [`Error::UnknownFormat`], naming all.
pub fn by_name(name: &str) -> Result<&'static dyn Format> {
    let found = formats().iter().find(|format| format.row().name == name);
    found
        .copied()
        .ok_or_else(|| Error::UnknownFormat(name.into()))
}

/// The format that a file to be written has by its name: by the whole name, else by the ending.
///
/// # Errors
/// [`Error::UnknownEnding`] with those that are known; [`Error::SharedEnding`].
pub fn by_target(file: &Path) -> Result<&'static dyn Format> {
    let written = || {
        let all = formats().iter().copied();
        all.filter(|format| format.row().writes)
    };
    if let Some(named) = written().find(|format| format.row().has_name(file)) {
        return Ok(named);
    }
    let fitting: Vec<_> = written()
        .filter(|format| format.row().has_ending(file))
        .collect();
    match *fitting {
        [] => {}
        [one] => return Ok(one),
        _ => {
            return Err(Error::SharedEnding {
                file: file.display().to_string().as_str().into(),
                formats: fitting.iter().map(|format| format.row().name).collect(),
            });
        }
    }
    written()
        .find(|format| file.is_dir() && !format.row().parts.is_empty())
        .ok_or_else(|| Error::UnknownEnding(file.display().to_string().as_str().into()))
}
