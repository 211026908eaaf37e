//! What can be asked for of files.

use std::path::PathBuf;

use vides_engine::path::Up;

use crate::state::files::{AfterSave, Purpose};

/// What opens and saves.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum FileAction {
    /// Begin an empty path.
    New,
    /// Ask for a file and load a path from it.
    Load,
    /// Begin with the example.
    Example,
    /// Save under the known name, else ask for one.
    Save,
    SaveAs,
    Quit,
    /// Open what was dropped on the window.
    Dropped(Vec<PathBuf>),
    LoadObject,
    Export,
    /// Write into this file, in the format of this name, whatever is lost.
    WriteAs(PathBuf, &'static str),
    Import,
    /// Take over poses from this file, in which this axis is up.
    ImportUpright(PathBuf, Up),
    LoadSetup,
    Recent(usize),
    /// Open unsaved work that was found, by its number in the window.
    Restore(usize),
    SaveSetup,
    FileChosen(Purpose, PathBuf),
    /// Discard unsaved work that was found, by its number in the window.
    Discard(usize),
    SaveBefore(AfterSave),
    /// Go on, whatever is lost.
    GoOn(AfterSave),
    Reload,
    /// Open the file again, with what it names outside its folder.
    ReadOutside,
    /// Save under another name, and then go on.
    SaveAsBefore(Option<AfterSave>),
    /// Overwrite the file that has changed, and then go on.
    Overwrite(Option<AfterSave>),
}

impl FileAction {
    /// Whether a menu, a key or a button names it.
    pub(super) const fn is_command(&self) -> bool {
        !matches!(
            self,
            Self::FileChosen(..)
                | Self::ImportUpright(..)
                | Self::Discard(_)
                | Self::SaveBefore(_)
                | Self::GoOn(_)
                | Self::Reload
                | Self::ReadOutside
                | Self::SaveAsBefore(_)
                | Self::Overwrite(_)
        )
    }

    /// Whether a shown tool stays as it is: all but what changes the document. Files do not get what
    /// the tool shows.
    pub(super) const fn leaves_tool(&self) -> bool {
        !matches!(
            self,
            Self::FileChosen(
                Purpose::LoadObject(_)
                    | Purpose::AddObject
                    | Purpose::LoadMesh(_)
                    | Purpose::LoadShape(_),
                _
            )
        )
    }
}
