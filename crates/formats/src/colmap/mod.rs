//! Models of COLMAP (Schönberger and Frahm 2016): a folder with `cameras`, `images` and `points3D`,
//! as text or as `.bin`. World to camera, x right, y down, z forward; no times: images are in the
//! order of their names, numbers in them as numbers.

mod binary;
mod model;
mod search;
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
    recognises,
    read: Some(read),
    parts: &[
        ("cameras.txt", write::cameras),
        ("images.txt", write::images),
        ("points3D.txt", write::points),
    ],
    empty: &["points3D.txt"],
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

fn recognises(source: &Source) -> bool {
    let folder = source.folder.as_deref().filter(|_| source.is_folder);
    folder.map_or_else(
        || ending(source).is_some(),
        |folder| search::model(folder).is_some(),
    )
}

fn read(source: &Source, _: &Options, report: &mut Report) -> Result<Content> {
    let folder = source.folder.as_deref().filter(|_| source.is_folder);
    if let Some((folder, others)) = folder.and_then(search::model) {
        if let Some(others) = others {
            report.add(others);
        }
        return read_model(&Source::open(&folder)?, report);
    }
    read_model(source, report)
}

fn read_model(source: &Source, report: &mut Report) -> Result<Content> {
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

/// Whether the model of a folder, or the one of which a file is a part, is binary or text.
fn ending(source: &Source) -> Option<&'static str> {
    let folder = source.folder.as_deref()?;
    if source.is_folder {
        return search::ending(folder);
    }
    let (stem, ending) = Path::new(&source.name)
        .file_name()?
        .to_str()?
        .rsplit_once('.')?;
    let is_part = ["cameras", "images", "points3D"].contains(&stem);
    let has = |found: &&str| is_part && *found == ending;
    search::endings(folder).find(has)
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
