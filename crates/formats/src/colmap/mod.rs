//! Models of COLMAP (Schönberger and Frahm 2016): a folder with `cameras`, `images` and `points3D`,
//! as text or as `.bin`. World to camera, x right, y down, z forward; no times: images are in the
//! order of their names, numbers in them as numbers.

mod binary;
mod model;
mod text;
mod write;

use std::path::Path;

use vides_engine::limits::MAX_FILE_BYTES;

use self::model::Model;
use super::content::Content;
use super::error::{Error, Result};
use super::format::Format;
use super::loss::Report;
use super::options::Options;
use super::source::Source;

pub(super) static COLMAP: Format = Format {
    name: "colmap",
    title: "COLMAP",
    recognises: |source| ending(source).is_some(),
    read: Some(read),
    parts: &[
        ("cameras.txt", write::cameras),
        ("images.txt", write::images),
        ("points3D.txt", write::points),
    ],
    // What COLMAP reads before the three texts, or together with them.
    barred: &[
        "cameras.bin",
        "images.bin",
        "points3D.bin",
        "rigs.bin",
        "frames.bin",
        "rigs.txt",
        "frames.txt",
    ],
    ..Format::PLAIN
};

fn read(source: &Source, _: &Options, report: &mut Report) -> Result<Content> {
    let ending = ending(source).unwrap_or("txt");
    let is_text = ending == "txt";
    let mut model = Model::default();
    let read_cameras = if is_text {
        text::cameras
    } else {
        binary::cameras
    };
    let read_images = if is_text {
        text::images
    } else {
        binary::images
    };
    let read_points = if is_text {
        text::points
    } else {
        binary::points
    };
    part(
        source,
        &format!("cameras.{ending}"),
        &mut model,
        read_cameras,
    )?;
    part(source, &format!("images.{ending}"), &mut model, read_images)?;
    let points = format!("points3D.{ending}");
    if source.place_beside(&points)?.is_file() {
        part(source, &points, &mut model, read_points)?;
    }
    model.recording(report).map(Content::Poses)
}

/// Whether a model is binary or text; COLMAP takes `.bin` before text.
fn ending(source: &Source) -> Option<&'static str> {
    let folder = source.folder.as_deref()?;
    let there = |ending: &&str| {
        let parts = ["cameras", "images"];
        let mut files = parts
            .iter()
            .map(|part| folder.join(format!("{part}.{ending}")));
        files.all(|file| file.is_file())
    };
    let mut endings = ["bin", "txt"].into_iter().filter(there);
    if source.is_folder {
        return endings.next();
    }
    let name = Path::new(&source.name).file_name()?.to_str()?;
    endings.find(|ending| {
        let stem = name.strip_suffix(ending).unwrap_or("");
        ["cameras.", "images.", "points3D."].contains(&stem)
    })
}

/// Reads one of the files; errors name it.
fn part(
    source: &Source,
    name: &str,
    model: &mut Model,
    read: fn(&[u8], &mut Model) -> Result<()>,
) -> Result<()> {
    let bytes = source.beside(name, MAX_FILE_BYTES)?;
    let place = source.place_beside(name)?.display().to_string();
    read(&bytes, model).map_err(|error: Error| error.at(&place))
}

#[cfg(test)]
mod tests;
