//! Which files a file may name: those in its own folder and below. A person or a program may name
//! any file, and may agree to all that a file names: [`trusting`].

use std::cell::Cell;
use std::path::{Component, Path, PathBuf, absolute};

use crate::error::{Refused, Result};

thread_local! {
    static TRUSTED: Cell<bool> = const { Cell::new(false) };
}

/// Files that are read meanwhile on this thread may name files anywhere.
pub fn trusting<T>(read: impl FnOnce() -> T) -> T {
    struct Before(bool);
    impl Drop for Before {
        fn drop(&mut self) {
            TRUSTED.set(self.0);
        }
    }
    let _before = Before(TRUSTED.replace(true));
    read()
}

/// Requires a file that another file in `folder` names to lie in that folder or below it, by its
/// name and after all links are followed.
///
/// # Errors
/// [`Refused::Outside`].
pub fn inside(folder: &Path, name: &str) -> Result<()> {
    if TRUSTED.get() {
        return Ok(());
    }
    let folder = match folder.as_os_str().is_empty() {
        true => Path::new("."),
        false => folder,
    };
    let file = folder.join(name);
    // The name first: nothing is looked for outside.
    let named = starts_with(plain(&file), plain(folder));
    // What is not there is reported when it is read.
    let linked = || file.canonicalize().is_err() || starts_with(real(&file), real(folder));
    match named && linked() {
        true => Ok(()),
        false => Err(Refused::Outside(name.into()).into()),
    }
}

fn starts_with(file: Option<PathBuf>, folder: Option<PathBuf>) -> bool {
    file.zip(folder)
        .is_some_and(|(file, folder)| file.starts_with(folder))
}

/// The path without `.` and `..`, as it is written.
fn plain(path: &Path) -> Option<PathBuf> {
    let mut plain = PathBuf::new();
    for part in absolute(path).ok()?.components() {
        match part {
            Component::ParentDir => {
                plain.pop();
            }
            Component::CurDir => {}
            other => plain.push(other),
        }
    }
    Some(plain)
}

fn real(path: &Path) -> Option<PathBuf> {
    path.canonicalize().ok()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;
    use std::os::unix::fs::symlink;

    #[test]
    fn a_file_names_only_what_lies_in_its_folder() {
        let above = tempfile::tempdir().unwrap();
        let folder = above.path().join("in");
        let at = |name: &str| folder.join(name);
        fs::create_dir_all(at("below")).unwrap();
        for name in ["a.obj", "below/b.obj", "../out.obj"] {
            fs::write(at(name), "v 0 0 0\n").unwrap();
        }
        symlink("../out.obj", at("link.obj")).unwrap();
        symlink("a.obj", at("own.obj")).unwrap();
        symlink(above.path(), at("up")).unwrap();
        let absolute = |name: &str| at(name).display().to_string();
        let allowed = [
            "a.obj",
            "./a.obj",
            "below/b.obj",
            "below/../a.obj",
            "own.obj",
            "missing.obj",
            &absolute("a.obj"),
        ];
        for name in allowed {
            assert!(inside(&folder, name).is_ok(), "{name}");
        }
        let refused = [
            "../out.obj",
            "below/../../out.obj",
            "link.obj",
            "up/out.obj",
            "/etc/passwd",
            "/nowhere",
            &absolute("../out.obj"),
        ];
        for name in refused {
            let error = inside(&folder, name).unwrap_err();
            assert_eq!(
                error.outside().map(ToString::to_string).as_deref(),
                Some(name)
            );
            assert!(trusting(|| inside(&folder, name)).is_ok(), "{name}");
        }
        assert!(inside(&folder, "../out.obj").is_err());
        assert!(inside(Path::new(""), "../out.obj").is_err());
        assert!(inside(Path::new(""), "src/lib.rs").is_ok());
    }
}
