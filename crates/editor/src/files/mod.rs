//! What is loaded, saved and written, and the question before work is lost.

mod autosave;
mod chooser;
mod exchange;
mod file_action;
pub(crate) mod folders;
mod listing;
mod naming;
mod node_meshes;
mod picture;
mod question;
pub(crate) mod recent;
pub(crate) mod recovery;
mod recovery_window;

#[cfg(test)]
mod exchange_tests;
#[cfg(test)]
mod object_tests;
#[cfg(test)]
mod opened_tests;
#[cfg(test)]
mod recent_tests;
#[cfg(test)]
mod recovery_window_tests;
#[cfg(test)]
mod tests;
#[cfg(test)]
mod unsaved_tests;

use std::ffi::OsStr;
use std::path::{Path, PathBuf};

use vides_document::error::{EngineError, Error, Result, TooMany};
use vides_document::mesh::Format;
use vides_document::tool::ToolInput;
use vides_document::{At, Document, Edit, Fingerprint, load_mesh, load_object, save};
use vides_engine::limits;
use vides_engine::path::Space;
use vides_engine::scene::{Geometry, MeshSource};

use crate::host::warning::Warnings;
use crate::state::files::{AfterSave, FileWindow, Purpose, Question};
use crate::state::{Editor, Request};
use crate::texts::fill;
use crate::texts::refusals::reason_of;
pub(crate) use exchange::is_object;
pub use folders::Folders;

impl Editor {
    pub(crate) fn choose_file(&mut self, purpose: Purpose) {
        self.windows.files = Some(FileWindow::open(self, purpose));
    }

    /// Asks about unsaved work, if there is any, and goes on.
    pub(crate) fn ask_before(&mut self, then: AfterSave) {
        if self.is_unsaved() {
            self.windows.files = None;
            self.windows.question = Some(Question::unsaved(then));
        } else {
            self.go_on(then);
        }
    }

    /// Does what waited: nothing is lost any more, or it is given up.
    pub(crate) fn go_on(&mut self, then: AfterSave) {
        match then {
            AfterSave::Close => self.requests.push(Request::Close),
            AfterSave::New => self.begin_anew(),
            AfterSave::Load => self.choose_file(Purpose::LoadPath),
            AfterSave::Example => self.show_example(),
            AfterSave::Recent(number) => {
                if let Some(file) = self.recent.get(number).cloned()
                    && let Err(text) = self.load_path(&file)
                {
                    self.complain(text);
                }
            }
            AfterSave::Dropped => self.load_dropped(),
            AfterSave::Restore(number) => self.restore_found(number),
        }
    }

    /// Saves under the known name, or asks for one; then goes on. Asks if the file was changed.
    pub(crate) fn save(&mut self, then: Option<AfterSave>) {
        let Some(file) = self.file.clone() else {
            self.choose_file(Purpose::SavePath(then));
            return;
        };
        match self.write(&file, false) {
            Ok(true) => {
                if let Some(then) = then {
                    self.go_on(then);
                }
            }
            Ok(false) => self.windows.changed = Some(Question::changed(then)),
            Err(error) => {
                self.complain(self.refusal(self.texts().errors.cannot_save, &file, &error));
            }
        }
    }

    /// Offers to read the file again if another program has written it; called when the window gets
    /// the keyboard. Its contents are looked at only if its time or length is another.
    pub(crate) fn look_after_file(&mut self) {
        let (Some(file), Some(_)) = (&self.file, self.known) else {
            return;
        };
        let Ok(state) = std::fs::metadata(file) else {
            return;
        };
        let written = state.modified().ok().map(|time| (time, state.len()));
        if self.windows.has_modal() || written == self.written {
            return;
        }
        self.written = written;
        // What cannot be read is reported when it is saved.
        if let Ok(Some(now)) = Fingerprint::now(file)
            && Some(now) != self.known
        {
            self.windows.changed = Some(Question::newer());
        }
    }

    /// Loads the open file again.
    pub(crate) fn reload(&mut self) {
        if let Some(file) = self.file.clone()
            && let Err(text) = self.load_path(&file)
        {
            self.complain(text);
        }
    }

    /// Saves under the known name, whatever is there; then goes on.
    pub(crate) fn overwrite(&mut self, then: Option<AfterSave>) {
        let Some(file) = self.file.clone() else {
            return;
        };
        match (self.save_path(&file), then) {
            (Ok(()), Some(then)) => self.go_on(then),
            (Ok(()), None) => {}
            (Err(text), _) => self.complain(text),
        }
    }

    /// A file was chosen: the window that asked closes, or shows why it was refused.
    pub(crate) fn file_chosen(&mut self, purpose: Purpose, file: &Path) {
        let window = self.windows.files.take();
        if let Some(window) = &window {
            self.file_order = window.order;
        }
        let done = match purpose {
            Purpose::LoadPath => self.load_path(file),
            Purpose::SavePath(then) => self.save_path(file).map(|()| {
                if let Some(then) = then {
                    self.go_on(then);
                }
            }),
            Purpose::LoadObject(waits) => self.load_object(file).map(|()| {
                if let Some(tool) = waits {
                    self.open_tool(tool);
                }
            }),
            Purpose::AddObject => self.add_object(file),
            Purpose::Export => {
                let chosen = window.as_ref().and_then(FileWindow::format);
                self.export(file, chosen)
            }
            Purpose::LoadSetup => self.load_setup(file),
            Purpose::SaveSetup => self.save_setup(file),
            Purpose::LoadBlock => self.load_block(file),
            Purpose::Import => self.import(file, None),
            Purpose::SaveBlock => self.save_block(file),
            Purpose::LoadMesh(node) => self.load_mesh_of(node, file),
            Purpose::LoadShape(node) => self.load_shape(node, file),
        };
        match done {
            Ok(()) => {
                let folder = file.parent().map(Path::to_owned);
                match purpose {
                    Purpose::LoadBlock | Purpose::SaveBlock => self.block_folder = folder,
                    _ => self.last_folder = folder,
                }
            }
            Err(text) => {
                self.complain(text.clone());
                self.windows.files = window.map(|window| window.refused(text));
            }
        }
    }

    /// Loads a path in place of the open one. Where the host's base speeds are fixed they are kept,
    /// and its object if it gave one. The error is a sentence; what is open then stays.
    pub(crate) fn load_path(&mut self, file: &Path) -> Result<(), String> {
        let texts = self.texts();
        let loaded = self.loaded(file);
        let (document, warnings) =
            loaded.map_err(|error| self.refusal(texts.errors.cannot_load, file, &error))?;
        // What is begun around an object has no file yet.
        let is_path = Format::of(file).is_none();
        let known = document.fingerprint();
        self.take_up(document, is_path.then_some(file), known);
        self.note_file(file);
        self.space.opened = !self.fixed_speeds;
        self.say(fill(texts.output.loaded, &[&short(file)]));
        let mut meshes = Warnings::default();
        meshes.add_meshes(warnings);
        self.warn(&meshes);
        Ok(())
    }

    /// Edits another document from now on, and with it its file, which had these contents. It is
    /// shown as in a new window.
    fn take_up(&mut self, document: Document, file: Option<&Path>, known: Option<Fingerprint>) {
        self.document = document;
        self.file = file.map(Path::to_owned);
        self.known = known;
        self.handed_state = None;
        self.show_anew();
    }

    /// An empty path in place of the open one, with what is the host's.
    fn begin_anew(&mut self) {
        match self.of_host(Document::new()) {
            Ok(document) => self.take_up(document, None, None),
            Err(error) => self.complain_of(&error),
        }
    }

    /// The example in place of the open path; without a file, so that nothing overwrites it.
    fn show_example(&mut self) {
        let example = Document::from_toml(include_str!("../../texts/example.vid"));
        match example.and_then(|document| self.of_host(document)) {
            Ok(document) => self.take_up(document, None, None),
            Err(error) => self.complain_of(&error),
        }
    }

    fn loaded(&self, file: &Path) -> Result<(Document, Vec<Error>)> {
        let (loaded, warnings) = match Format::of(file) {
            Some(_) => (Document::around(load_object(file)?)?, Vec::new()),
            None => Document::load_scene(file)?,
        };
        Ok((self.of_host(loaded)?, warnings))
    }

    /// A document with the base speeds and the object of a host that fixes them.
    fn of_host(&self, mut loaded: Document) -> Result<Document> {
        if !self.fixed_speeds {
            return Ok(loaded);
        }
        if loaded.edits_path() {
            loaded.apply(Edit::set(
                At::Path,
                "base_speeds",
                self.document.path().base_frames,
            ))?;
        }
        if !self.document.info().object.is_empty() {
            let mut info = loaded.info().clone();
            info.object = self.document.info().object.clone();
            loaded.apply(Edit::SetInfo(Box::new(info)))?;
        }
        // A copy has no history: putting the host's values back cannot be undone.
        let mut copy = loaded.try_clone()?;
        copy.mark_saved();
        Ok(copy)
    }

    /// Saves the path as this file, whatever is there, and edits it from now on.
    pub(crate) fn save_path(&mut self, file: &Path) -> Result<(), String> {
        let done = self.write(file, true).map(drop);
        done.map_err(|error| self.refusal(self.texts().errors.cannot_save, file, &error))
    }

    /// The same; false, without writing, if the file was changed and is not to be `replaced`.
    pub(crate) fn write(&mut self, file: &Path, replaced: bool) -> Result<bool> {
        let text = self.document().to_toml_for(file)?;
        let bytes = text.as_bytes();
        if replaced {
            save::save(file, bytes)?;
        } else if !save::save_unless_changed(file, bytes, self.known)? {
            return Ok(false);
        }
        match self
            .windows
            .tool
            .as_mut()
            .and_then(|tool| tool.unapplied.as_mut())
        {
            Some(unapplied) => {
                unapplied.mark_saved();
                self.document.mark_saved_before_step();
            }
            None => self.document.mark_saved(),
        }
        self.file = Some(file.to_owned());
        self.known = Some(Fingerprint::of(bytes));
        self.note_file(file);
        self.say(fill(self.texts().output.saved, &[&short(file)]));
        Ok(true)
    }

    /// Shows the mesh of a file as the object, in an undoable step. A path in which nothing is done
    /// yet gets a space around it, unless its own is somebody's choice.
    fn load_object(&mut self, file: &Path) -> Result<(), String> {
        let texts = self.texts();
        let file = &self.beside_document(file, self.document.info().object.source());
        let object = load_object(file);
        let object =
            object.map_err(|error| self.refusal(texts.errors.cannot_load, file, &error))?;
        self.take_tool();
        let space = self.document.path().space;
        let unchosen = Space {
            up: space.up,
            ..Space::default()
        };
        let around = self.document.space_around_object();
        let fits = self.begins() && (space == unchosen || around.is_ok_and(|own| own == space));
        self.document.begin_step();
        let done = self.set_object(object);
        let whole = self.document.space_around_object();
        if let (true, Ok(_), Ok(space)) = (fits, &done, &whole) {
            let fit = Edit::SetSpace {
                space: *space,
                fit: true,
            };
            // Else it is told that the space is too small.
            let _ = self.document.apply(fit);
        }
        self.document.end_step();
        done.map_err(|error| self.refusal(texts.errors.cannot_load, file, &error))?;
        let space = self.document.path().space;
        let text = match whole {
            Ok(whole) if whole.half_size > 1.2 * space.half_size => texts.output.too_large,
            _ => texts.output.loaded,
        };
        self.say(fill(text, &[&short(file)]));
        Ok(())
    }

    /// Adds the mesh of a file to the scene, as an object called after the file.
    fn add_object(&mut self, file: &Path) -> Result<(), String> {
        let name = file.file_stem().unwrap_or_default().to_string_lossy();
        let read = load_mesh(file).and_then(|(source, mesh)| {
            let file = std::path::absolute(file).unwrap_or_else(|_| file.to_owned());
            let file = file.display().to_string();
            let mesh = Geometry::new(mesh, Some(MeshSource { file, ..source }))?;
            self.add_mesh(&name, mesh)
        });
        read.map_err(|error| self.refusal(self.texts().errors.cannot_load, file, &error))?;
        self.say(fill(self.texts().output.loaded, &[&short(file)]));
        Ok(())
    }

    /// Begins with the tool that inserts the path of a file.
    fn load_block(&mut self, file: &Path) -> Result<(), String> {
        let read = Document::load(file);
        let read =
            read.map_err(|error| self.refusal(self.texts().errors.cannot_load, file, &error))?;
        let (path, _) = read.into_parts();
        self.begin_tool_with(ToolInput::Block(Box::new(path)));
        Ok(())
    }

    /// Writes the points named in the tool's window.
    fn save_block(&mut self, file: &Path) -> Result<(), String> {
        let Some(window) = &self.windows.tool else {
            return Ok(());
        };
        let saved = window.write(&self.document, file);
        let [first, last] =
            saved.map_err(|error| self.refusal(self.texts().errors.cannot_save, file, &error))?;
        self.windows.tool = None;
        let text = self.texts().tools.block_written;
        self.say(fill(text, &[&first, &last, &short(file)]));
        Ok(())
    }

    /// What could not be done with a file, and why.
    fn refusal(&self, text: &str, file: &Path, error: &Error) -> String {
        fill(text, &[&short(file), &self.without_name(error)])
    }

    /// Why it failed, without the file's name.
    pub(crate) fn without_name(&self, error: &Error) -> String {
        match error {
            Error::In(_, cause) => self.without_name(cause),
            Error::Engine(EngineError::Limit(TooMany::Frames)) => {
                fill(self.texts().errors.frames, &[&limits::MAX_FRAMES])
            }
            _ => reason_of(self.language(), error),
        }
    }

    /// The name to propose for a file with this ending: its own, its title, that of its object.
    pub(crate) fn proposal(&self, stem: &str, ending: &str) -> String {
        let object = self.document.info().object.source();
        let object = object.map(|source| Path::new(&source.file));
        let known = self.file.as_deref().and_then(Path::file_stem);
        let title = self.document.info().title.trim();
        let plain = |letter: char| !letter.is_control() && !matches!(letter, '/' | '\\');
        let stem = match known {
            Some(known) => known.to_string_lossy().into_owned(),
            None if !title.is_empty() => title.chars().filter(|&letter| plain(letter)).collect(),
            None => match object.and_then(Path::file_stem) {
                Some(object) => object.to_string_lossy().into_owned(),
                None => stem.to_owned(),
            },
        };
        format!("{stem}.{ending}")
    }

    pub(crate) fn folder_for(&self, purpose: Purpose) -> PathBuf {
        let ours = match purpose {
            Purpose::LoadSetup | Purpose::SaveSetup => self.folders.setup.clone(),
            Purpose::LoadBlock | Purpose::SaveBlock => {
                let library = self.folders.blocks.clone();
                self.block_folder.clone().or(library)
            }
            _ => None,
        };
        if let Some(folder) = &ours
            && purpose == Purpose::SaveBlock
        {
            // Without it the window begins elsewhere.
            let _ = folders::make(folder);
        }
        let ours = ours.filter(|folder| folder.is_dir());
        ours.unwrap_or_else(|| self.folder())
    }

    /// Where the last file was chosen, else beside the open file, else the current directory.
    fn folder(&self) -> PathBuf {
        let beside = |file: &Path| {
            let folder = file.parent()?;
            let here = folder.as_os_str().is_empty();
            Some(if here {
                PathBuf::from(".")
            } else {
                folder.to_owned()
            })
        };
        let folder = self.last_folder.clone();
        let folder = folder.or_else(|| self.file.as_deref().and_then(beside));
        let folder = folder.unwrap_or_else(|| PathBuf::from("."));
        std::path::absolute(&folder).unwrap_or(folder)
    }
}

/// A file's name without its folder.
pub(crate) fn short(file: &Path) -> String {
    readable(file.file_name().unwrap_or(file.as_os_str()))
}

/// A name as it is shown: `?` for control characters and invalid bytes.
pub(crate) fn readable(name: &OsStr) -> String {
    let letters = name.to_string_lossy();
    let plain = letters.chars().map(|letter| match letter {
        char::REPLACEMENT_CHARACTER => '?',
        control if control.is_control() => '?',
        other => other,
    });
    plain.collect()
}
