//! The files that were open last, for the File menu: in the state folder, one a line, newest first.

use std::cell::RefCell;
use std::path::{Path, PathBuf};

use egui::{Rect, Ui, Vec2, vec2};

use super::folders;
use super::picture::Picture;
use super::recovery::{escaped, unescaped};
use super::short;
use crate::background::Background;
use crate::document::save;
use crate::document::vid::read_text;
use crate::state::Editor;

/// How many are kept.
const MOST: usize = 8;

/// Bytes of the list: each path may be as long as paths can be.
const MAX_BYTES: u64 = 1 << 20;

/// The list's name in the state folder.
const NAME: &str = "recent";

/// Those that still exist. A list that cannot be read is empty.
fn load(folder: &Path) -> Vec<PathBuf> {
    let text = read_text(&folder.join(NAME), MAX_BYTES).unwrap_or_default();
    let files = text.lines().filter_map(unescaped);
    files.filter(|file| file.is_file()).take(MOST).collect()
}

fn note(folder: &Path, file: &Path) -> crate::Result<()> {
    // Read again: other windows write it, too.
    let mut files = load(folder);
    files.retain(|known| known != file);
    files.insert(0, file.to_owned());
    files.truncate(MOST);
    let lines: Vec<String> = files.iter().map(|file| escaped(file) + "\n").collect();
    folders::make(folder).map_err(|source| crate::Error::Io {
        place: folder.display().to_string(),
        source,
    })?;
    save::save(&folder.join(NAME), lines.concat().as_bytes())
}

/// Size of a recent file's picture.
pub(crate) const PICTURE: Vec2 = vec2(112.0, 64.0);

/// Pictures of the files that were open last, made beside the window when they are first shown.
#[derive(Debug, Default)]
pub(crate) struct Pictures(RefCell<Option<Made>>);

#[derive(Debug)]
struct Made {
    of: Vec<PathBuf>,
    work: Background<Vec<Option<Picture>>>,
    pictures: Vec<Option<Picture>>,
}

impl Editor {
    /// Paints the picture of a recent file, if it has one by now.
    pub(crate) fn paint_recent(&self, ui: &Ui, at: usize, rect: Rect) {
        let mut known = self.recent_pictures.0.borrow_mut();
        let made = match &mut *known {
            Some(made) if made.of == self.recent => made,
            known => {
                let of = self.recent.clone();
                let work = Background::begin(self.start, move |go_on| {
                    let pictures = of.iter().enumerate().map(|(done, file)| {
                        let goes_on = go_on(done, of.len());
                        goes_on.then(|| Picture::of_file(file, PICTURE)).flatten()
                    });
                    Ok(pictures.collect())
                });
                known.insert(Made {
                    of: self.recent.clone(),
                    work,
                    pictures: Vec::new(),
                })
            }
        };
        if made.pictures.is_empty() && made.work.is_done(ui.ctx()) {
            // Without them there are the names.
            made.pictures = made.work.made().and_then(Result::ok).unwrap_or_default();
        }
        if let Some(Some(picture)) = made.pictures.get(at) {
            picture.paint(self, ui, rect);
        }
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
