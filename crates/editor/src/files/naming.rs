//! How files are called: by format, by purpose.

use std::path::{Path, PathBuf};

use vides_formats::{Format, formats};

use super::exchange::DEFAULT;
use crate::state::files::Purpose;
use crate::texts::Language;
use crate::texts::formats::title_of;

/// A format by what people call it and how its files end.
pub(super) fn described(language: Language, format: &Format) -> String {
    let title = title_of(language, format);
    let names = format.file_names.iter().map(|name| (*name).to_owned());
    let endings = format.all_endings().map(|ending| format!("*.{ending}"));
    let files: Vec<_> = names.chain(endings).collect();
    match files.as_slice() {
        [] => format!("{title} ({})", language.texts().files.folder),
        files => format!("{title} ({})", files.join(", ")),
    }
}

/// Whether poses or scenes are written in it; saving is another thing.
pub(super) fn is_export(format: &Format) -> bool {
    format.writes() && format.name != "vid"
}

/// All endings of files of some formats.
pub(super) fn filter_of(which: impl Fn(&Format) -> bool) -> String {
    let which = formats().iter().filter(|format| which(format));
    let endings = which.flat_map(|format| format.all_endings());
    let mut endings: Vec<_> = endings.map(|ending| format!("*.{ending}")).collect();
    endings.sort_unstable();
    endings.dedup();
    endings.join(" ")
}

/// Without `.` and, where that surely means the same, without `..`.
pub(super) fn tidy(path: &Path) -> PathBuf {
    let path = std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
    if path
        .components()
        .any(|part| part == std::path::Component::ParentDir)
    {
        // After a link, `..` is not the directory before it.
        let folder = path.parent().and_then(|parent| parent.canonicalize().ok());
        return match (path.canonicalize(), folder, path.file_name()) {
            (Ok(whole), _, _) => whole,
            (_, Some(folder), Some(name)) => folder.join(name),
            _ => path,
        };
    }
    path
}

/// Adds the usual ending to a name without one; a format that is a folder of files has none.
pub(super) fn with_ending(path: PathBuf, purpose: Purpose, format: Option<&str>) -> PathBuf {
    let ending = match purpose {
        Purpose::Export => {
            let format = vides_formats::by_name(format.unwrap_or(DEFAULT));
            let endings = format.map_or(&["txt"][..], |format| format.endings);
            match endings.first() {
                Some(ending) => *ending,
                None => return path,
            }
        }
        Purpose::LoadSetup | Purpose::SaveSetup => "toml",
        Purpose::LoadObject(_)
        | Purpose::AddObject
        | Purpose::LoadMesh(_)
        | Purpose::LoadShape(_) => "obj",
        Purpose::Import => "csv",
        Purpose::LoadPath | Purpose::SavePath(_) | Purpose::LoadBlock | Purpose::SaveBlock => "vid",
    };
    if path.extension().is_some() {
        path
    } else {
        path.with_extension(ending)
    }
}
