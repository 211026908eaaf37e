//! The table of all formats.

use std::path::Path;

use super::error::{Error, NAMES, Result};
use super::format::Format;
use super::{
    ascii, cameras, chan, colmap, csv, euroc, gltf, html, json, kitti, matrices, nerfstudio, ngp,
    open3d, osg, polycam, record3d, script, supersplat, transforms, tum, usd, vid,
};

/// All formats, in the order in which they are offered.
#[must_use]
pub fn formats() -> &'static [&'static Format] {
    static ALL: [&Format; NAMES.len()] = [
        &vid::VID,
        &ascii::ASCII,
        &csv::CSV,
        &json::JSON,
        &gltf::GLTF,
        &gltf::GLB,
        &usd::USDA,
        &script::BLENDER,
        &script::PARAVIEW,
        &script::VTK,
        &html::HTML,
        &nerfstudio::NERFSTUDIO,
        &transforms::TRANSFORMS,
        &ngp::NGP,
        &cameras::CAMERAS,
        &supersplat::SUPERSPLAT,
        &tum::TUM,
        &euroc::EUROC,
        &kitti::KITTI,
        &matrices::MATRICES,
        &open3d::OPEN3D,
        &record3d::RECORD3D,
        &polycam::POLYCAM,
        &colmap::COLMAP,
        &osg::OSG,
        &chan::CHAN,
    ];
    &ALL
}

/// The format of this name.
///
/// # Errors
/// [`Error::UnknownFormat`], naming all.
pub fn by_name(name: &str) -> Result<&'static Format> {
    let found = formats().iter().find(|format| format.name == name);
    found
        .copied()
        .ok_or_else(|| Error::UnknownFormat(name.into()))
}

/// The format that a file to be written has by its name: by the whole name, else by the ending.
///
/// # Errors
/// [`Error::UnknownEnding`] with those that are known; [`Error::SharedEnding`].
pub fn by_target(file: &Path) -> Result<&'static Format> {
    let written = || {
        let all = formats().iter().copied();
        all.filter(|format| format.writes())
    };
    if let Some(named) = written().find(|format| format.has_name(file)) {
        return Ok(named);
    }
    let fitting: Vec<_> = written().filter(|format| format.has_ending(file)).collect();
    match *fitting {
        [] => {}
        [one] => return Ok(one),
        _ => {
            return Err(Error::SharedEnding {
                file: file.display().to_string().as_str().into(),
                formats: fitting.iter().map(|format| format.name).collect(),
            });
        }
    }
    written()
        .find(|format| file.is_dir() && format.is_folder())
        .ok_or_else(|| Error::UnknownEnding(file.display().to_string().as_str().into()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_name_the_formats_that_there_are() {
        let names = formats().iter().map(|format| format.name);
        assert!(names.eq(NAMES));
    }
}
