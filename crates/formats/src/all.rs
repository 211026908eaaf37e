//! The table of all formats.

use std::path::Path;

use super::error::{Error, Result};
use super::format::Format;
use super::row::NAMES;
use super::{
    ascii, cameras, chan, colmap, csv, gltf, html, json, kitti, nerfstudio, osg, script,
    transforms, tum, usd, vid,
};

/// All formats, in the order in which they are offered.
#[must_use]
pub fn formats() -> &'static [&'static dyn Format] {
    const ALL: [&dyn Format; NAMES.len()] = [
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
    ];
    &ALL
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_name_the_formats_that_there_are() {
        let names = formats().iter().map(|format| format.row().name);
        assert!(names.eq(NAMES));
    }
}
