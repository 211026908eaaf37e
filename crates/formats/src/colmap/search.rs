//! Where the model lies in the folder of a project.

use std::fs::{self, File};
use std::io::Read;
use std::path::{Path, PathBuf};

use vides_document::{inside, read_bytes};
use vides_engine::limits::MAX_FILE_BYTES;

use crate::loss::Loss;
use crate::natural;

/// Where programs write models, the first place that has one counts; COLMAP numbers them below it.
const PLACES: [&str; 3] = ["sparse", "colmap/sparse", "dense/sparse"];

/// More folders in a folder are not searched.
const MAX_FOLDERS: usize = 10_000;

/// The model in a folder, or in a place below it where models lie; of several that with the most
/// images, and what is lost with the others.
pub(super) fn model(folder: &Path) -> Option<(PathBuf, Option<Loss>)> {
    if ending(folder).is_some() {
        return Some((folder.to_owned(), None));
    }
    let mut places = PLACES.iter().chain(&[""]).map(|place| {
        let is_model = !place.is_empty() && is_model(folder, Path::new(place));
        if is_model {
            vec![PathBuf::from(place)]
        } else {
            models_below(folder, Path::new(place))
        }
    });
    let models = places.find(|models| !models.is_empty())?;
    if let [only] = &*models {
        return Some((folder.join(only), None));
    }
    let counted = models.iter().map(|name| (images(&folder.join(name)), name));
    // Of equal ones the first.
    let (images, most) = counted.rev().max_by_key(|(images, _)| *images)?;
    let others = Loss::OtherModels {
        read: most.display().to_string().as_str().into(),
        images,
        others: models.len() - 1,
    };
    Some((folder.join(most), Some(others)))
}

/// Whether a model is binary or text; COLMAP takes `.bin` before text.
pub(super) fn ending(folder: &Path) -> Option<&'static str> {
    endings(folder).next()
}

/// The endings of the models in one folder.
pub(super) fn endings(folder: &Path) -> impl Iterator<Item = &'static str> {
    ["bin", "txt"].into_iter().filter(|ending| {
        let file = |part| folder.join(format!("{part}.{ending}"));
        file("cameras").is_file() && file("images").is_file()
    })
}

/// The folders with models in a place of a folder, in the order of their names.
fn models_below(folder: &Path, place: &Path) -> Vec<PathBuf> {
    let Ok(entries) = fs::read_dir(folder.join(place)) else {
        return Vec::new();
    };
    let entries = entries.take(MAX_FOLDERS).filter_map(Result::ok);
    let names = entries.map(|entry| place.join(entry.file_name()));
    let mut models: Vec<_> = names.filter(|name| is_model(folder, name)).collect();
    models.sort_by(|a, b| natural::compare(&a.to_string_lossy(), &b.to_string_lossy()));
    models
}

/// Whether there is a model in a place of a folder, and not outside of it.
fn is_model(folder: &Path, place: &Path) -> bool {
    let is_inside = place
        .to_str()
        .is_some_and(|name| inside(folder, name).is_ok());
    is_inside && ending(&folder.join(place)).is_some()
}

/// As many images as a model says it has; 0 if that cannot be read.
fn images(folder: &Path) -> u64 {
    if ending(folder) == Some("bin") {
        let mut count = [0; 8];
        let file = File::open(folder.join("images.bin"));
        let read = file.and_then(|mut file| file.read_exact(&mut count));
        return read.map_or(0, |()| u64::from_le_bytes(count));
    }
    let text = read_bytes(&folder.join("images.txt"), MAX_FILE_BYTES).unwrap_or_default();
    let lines = text.split(|&byte| byte == b'\n');
    // Two lines each, the second may be empty; the last one ends the text.
    let lines = lines.filter(|line| !line.starts_with(b"#")).count() as u64;
    lines / 2
}
