//! Where the editor keeps what is no work of the user's: the setup that is read at start, and the
//! state (work not yet saved, recent files).
//!
//! By the XDG Base Directory Specification. A window without folders, as in tests, keeps nothing.

use std::ffi::OsString;
use std::fs::{self, DirBuilder, Metadata};
use std::io;
use std::os::unix::fs::{DirBuilderExt, MetadataExt};
use std::path::{Path, PathBuf};

use rustix::io::Errno;
use rustix::process::geteuid;

/// The folders of one window.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Folders {
    /// Holds `setup.toml`: `$XDG_CONFIG_HOME/vides`.
    pub setup: Option<PathBuf>,
    /// Holds unsaved work and the list of recent files: `$XDG_STATE_HOME/vides`.
    pub state: Option<PathBuf>,
    /// The library of blocks: `$XDG_DATA_HOME/vides/blocks`.
    pub blocks: Option<PathBuf>,
}

impl Folders {
    /// Those of the environment; none of them is created.
    pub fn of_environment() -> Self {
        Self::by(|name| std::env::var_os(name))
    }

    fn by(variable: impl Fn(&str) -> Option<OsString>) -> Self {
        let home = variable("HOME").map(PathBuf::from);
        let home = home.filter(|home| home.is_absolute());
        let folder = |name: &str, below_home: &str| {
            // The specification: relative paths are to be ignored.
            let base = variable(name)
                .map(PathBuf::from)
                .filter(|base| base.is_absolute())
                .or_else(|| home.as_ref().map(|home| home.join(below_home)))?;
            Some(base.join("vides"))
        };
        Self {
            setup: folder("XDG_CONFIG_HOME", ".config"),
            state: folder("XDG_STATE_HOME", ".local/state"),
            blocks: folder("XDG_DATA_HOME", ".local/share").map(|data| data.join("blocks")),
        }
    }

    pub(crate) fn setup_file(&self) -> Option<PathBuf> {
        self.setup.as_deref().map(|folder| folder.join(SETUP_NAME))
    }
}

/// The home directory by `HOME`: a static program cannot ask the system's list of users.
pub(crate) fn home() -> Option<PathBuf> {
    let home = PathBuf::from(std::env::var_os("HOME")?);
    (!home.as_os_str().is_empty()).then_some(home)
}

/// The usual name of a setup file.
pub(crate) const SETUP_NAME: &str = "setup.toml";

/// Makes a folder and those above it, private as the specification asks, unless it exists.
pub(crate) fn make(folder: &Path) -> io::Result<()> {
    DirBuilder::new().recursive(true).mode(0o700).create(folder)
}

/// As [`make`]; fails if the folder is not [`ours`].
pub(crate) fn make_ours(folder: &Path) -> io::Result<()> {
    make(folder)?;
    match ours(folder) {
        true => Ok(()),
        false => Err(Errno::PERM.into()),
    }
}

/// Whether a folder is ours alone to write to: what lies in another one may be somebody's trap.
pub(crate) fn ours(folder: &Path) -> bool {
    let ours = |there: Metadata| there.uid() == geteuid().as_raw() && there.mode() & 0o002 == 0;
    fs::metadata(folder).is_ok_and(ours)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(variables: &[(&str, &str)]) -> Folders {
        Folders::by(|name| {
            let found = variables.iter().find(|(known, _)| *known == name);
            found.map(|(_, value)| value.into())
        })
    }

    #[test]
    fn the_variables_come_first_and_home_after_them() {
        let folders = of(&[("HOME", "/h"), ("XDG_CONFIG_HOME", "/c")]);
        assert_eq!(folders.setup, Some("/c/vides".into()));
        assert_eq!(folders.state, Some("/h/.local/state/vides".into()));
        assert_eq!(folders.blocks, Some("/h/.local/share/vides/blocks".into()));
        assert_eq!(folders.setup_file(), Some("/c/vides/setup.toml".into()));
    }

    #[test]
    fn what_is_not_absolute_is_ignored() {
        let folders = of(&[
            ("HOME", "/h"),
            ("XDG_STATE_HOME", "s"),
            ("XDG_CONFIG_HOME", ""),
        ]);
        assert_eq!(folders.setup, Some("/h/.config/vides".into()));
        assert_eq!(folders.state, Some("/h/.local/state/vides".into()));
        assert_eq!(of(&[("HOME", "h")]), Folders::default());
        assert_eq!(of(&[]), Folders::default());
    }
}
