//! The files that were open last, for the File menu: in the state folder, one a line, newest first.

use std::path::{Path, PathBuf};

use egui::{Rect, Ui, Vec2, vec2};
use vides_document::save;
use vides_document::vid::read_text;
use vides_engine::tools::fit::Progress;

use super::recovery::{escaped, unescaped};
use super::{folders, short};
use crate::state::Editor;
use crate::state::files::Picture;

/// How many are kept.
const MOST: usize = 8;

/// Bytes of the list: each path may be as long as paths can be.
const MAX_BYTES: u64 = 1 << 20;

/// The list's name in the state folder.
const NAME: &str = "recent";

/// Those that still exist. A list that cannot be read is empty.
fn load(folder: &Path) -> Vec<PathBuf> {
    let text = match list(folder) {
        Some(list) => read_text(&list, MAX_BYTES).unwrap_or_default(),
        None => String::new(),
    };
    let files = text.lines().filter_map(unescaped);
    files.filter(|file| file.is_file()).take(MOST).collect()
}

/// The list, unless the folder is not ours or a link stands there.
fn list(folder: &Path) -> Option<PathBuf> {
    let list = folder.join(NAME);
    (folders::ours(folder) && !list.is_symlink()).then_some(list)
}

fn note(folder: &Path, file: &Path) -> vides_document::Result<()> {
    // Read again: other windows write it, too.
    let mut files = load(folder);
    files.retain(|known| known != file);
    files.insert(0, file.to_owned());
    files.truncate(MOST);
    let lines: Vec<String> = files.iter().map(|file| escaped(file) + "\n").collect();
    folders::make_ours(folder).map_err(|source| vides_document::Error::Io {
        place: folder.display().to_string(),
        source,
    })?;
    list(folder).map_or(Ok(()), |list| save::save(&list, lines.concat().as_bytes()))
}

/// Size of a recent file's picture.
pub(crate) const PICTURE: Vec2 = vec2(112.0, 64.0);

/// Pictures of these files.
fn pictures(of: Vec<PathBuf>, go_on: Progress<'_>) -> Vec<Option<Picture>> {
    let pictures = of.iter().enumerate().map(|(done, file)| {
        let goes_on = go_on(done, of.len());
        goes_on.then(|| Picture::of_file(file, PICTURE)).flatten()
    });
    pictures.collect()
}

impl Editor {
    /// Paints the picture of a recent file, if it has one by now.
    pub(crate) fn paint_recent(&self, ui: &Ui, at: usize, rect: Rect) {
        let show = |picture: &Picture| picture.paint(self, ui, rect, None);
        let known = &self.recent_pictures;
        known.show((self, ui.ctx()), &self.recent, pictures, (at, show));
    }

    /// A file was loaded or saved: it is the newest now.
    pub(crate) fn note_file(&mut self, file: &Path) {
        let Some(folder) = &self.folders.state else {
            return;
        };
        let file = std::path::absolute(file).unwrap_or_else(|_| file.to_owned());
        // If the list cannot be written, only a convenience is lost.
        let _ = note(folder, &file);
        self.read_recent();
    }

    pub(crate) fn read_recent(&mut self) {
        self.recent = self.folders.state.as_deref().map(load).unwrap_or_default();
    }

    /// The recent files as the menu shows them: names, with the folder where two are the same.
    pub(crate) fn recent_names(&self) -> Vec<String> {
        let names: Vec<String> = self.recent.iter().map(|file| short(file)).collect();
        let several = |name: &String| names.iter().filter(|other| *other == name).count() > 1;
        let shown = self.recent.iter().zip(&names).map(|(file, name)| {
            let folder = file.parent().filter(|_| several(name)).map(short);
            folder.map_or_else(|| name.clone(), |folder| format!("{name} ({folder})"))
        });
        shown.collect()
    }
}
