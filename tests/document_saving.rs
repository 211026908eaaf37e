//! Saving: wholly the old or wholly the new, links followed, permissions kept,
//! nothing left behind.

use std::fs;
use std::io::Write;
use std::os::unix::fs::{MetadataExt, PermissionsExt, symlink};
use std::path::{Path, PathBuf};

use vides::document::{Document, save};
use vides::error::EngineError;
use vides::{Error, Result};

/// The names in a folder.
fn names(folder: &Path) -> Vec<String> {
    let mut names: Vec<_> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}

fn mode(file: &Path) -> u32 {
    fs::metadata(file).unwrap().permissions().mode() & 0o7777
}

fn folder() -> tempfile::TempDir {
    tempfile::tempdir().unwrap()
}

#[test]
fn a_new_file_has_the_permissions_of_new_files() {
    let folder = folder();
    let file = folder.path().join("new.vid");
    Document::new().save(&file).unwrap();
    let other = folder.path().join("other");
    fs::write(&other, "").unwrap();
    assert_eq!(mode(&file), mode(&other));
    assert_eq!(names(folder.path()), ["new.vid", "other"]);
    let loaded = Document::load(&file).unwrap();
    assert_eq!(
        format!("{:?}", loaded.path()),
        format!("{:?}", Document::new().path())
    );
}

#[test]
fn permissions_stay() {
    let folder = folder();
    let file = folder.path().join("kept.vid");
    for permissions in [0o600, 0o640, 0o664, 0o755] {
        fs::write(&file, "old").unwrap();
        fs::set_permissions(&file, fs::Permissions::from_mode(permissions)).unwrap();
        let old = fs::metadata(&file).unwrap();
        save::save(&file, b"new").unwrap();
        assert_eq!(mode(&file), permissions);
        assert_eq!(fs::read(&file).unwrap(), b"new");
        let new = fs::metadata(&file).unwrap();
        // It is another file: the old one was never written to.
        assert_ne!(old.ino(), new.ino());
        assert_eq!((old.uid(), old.gid()), (new.uid(), new.gid()));
    }
}

/// Whatever is in the folder meanwhile: nobody else may read it.
#[test]
fn a_private_file_is_private_while_it_is_saved() {
    let folder = folder();
    let file = folder.path().join("private.vid");
    fs::write(&file, "old").unwrap();
    fs::set_permissions(&file, fs::Permissions::from_mode(0o600)).unwrap();
    let mut looked = 0;
    save::save_with(&file, &mut |out| {
        out.write_all(&vec![b'x'; 1 << 20]).unwrap();
        for name in names(folder.path()) {
            assert_eq!(mode(&folder.path().join(&name)) & 0o077, 0, "{name}");
            looked += 1;
        }
        Ok(())
    })
    .unwrap();
    assert!(looked > 0);
    assert_eq!(mode(&file), 0o600);
}

#[test]
fn another_hard_link_keeps_the_old_file() {
    let folder = folder();
    let [file, other] = ["file", "other"].map(|name| folder.path().join(name));
    fs::write(&file, "old").unwrap();
    fs::hard_link(&file, &other).unwrap();
    save::save(&file, b"new").unwrap();
    assert_eq!(fs::read(&file).unwrap(), b"new");
    assert_eq!(fs::read(&other).unwrap(), b"old");
}

/// What somebody else has put into a folder like `/tmp` is neither followed nor replaced. Root alone
/// can try it.
#[test]
fn traps_in_shared_folders_are_refused() {
    const OTHER: Option<u32> = Some(65534);
    let folder = folder();
    let at = |name: &str| folder.path().join(name);
    fs::create_dir(at("shared")).unwrap();
    fs::write(at("precious"), "kept").unwrap();
    symlink("../precious", at("shared/theirs")).unwrap();
    symlink("../none", at("shared/dangling")).unwrap();
    symlink("../precious", at("shared/ours")).unwrap();
    fs::write(at("shared/waiting"), "").unwrap();
    let planted = ["theirs", "dangling", "waiting"].map(|name| at("shared").join(name));
    for planted in &planted {
        if std::os::unix::fs::lchown(planted, OTHER, None).is_err() {
            return;
        }
    }
    // Nobody else can write here: the links are the folder's owner's business.
    save::save(&planted[0], b"followed").unwrap();
    assert_eq!(fs::read(at("precious")).unwrap(), b"followed");
    fs::write(at("precious"), "kept").unwrap();
    fs::set_permissions(at("shared"), fs::Permissions::from_mode(0o1777)).unwrap();
    for planted in &planted {
        let error = save::save(planted, b"new").unwrap_err().to_string();
        assert_eq!(error, format!("{}: Permission denied", planted.display()));
    }
    assert_eq!(fs::read(at("precious")).unwrap(), b"kept");
    assert!(!at("none").exists());
    save::save(&at("shared/ours"), b"new").unwrap();
    assert_eq!(fs::read(at("precious")).unwrap(), b"new");
}

#[test]
fn links_are_followed_and_stay() {
    let folder = folder();
    let at = |name: &str| folder.path().join(name);
    fs::create_dir(at("far")).unwrap();
    fs::write(at("far/real.vid"), "old").unwrap();
    symlink("far/real.vid", at("relative")).unwrap();
    symlink(at("relative"), at("absolute")).unwrap();
    symlink("../far/none.vid", at("far/dangling")).unwrap();
    save::save(&at("absolute"), b"new").unwrap();
    assert_eq!(fs::read(at("far/real.vid")).unwrap(), b"new");
    for link in ["relative", "absolute"] {
        assert!(fs::symlink_metadata(at(link)).unwrap().is_symlink());
    }
    save::save(&at("far/dangling"), b"made").unwrap();
    assert_eq!(fs::read(at("far/none.vid")).unwrap(), b"made");
    assert_eq!(names(folder.path()), ["absolute", "far", "relative"]);
    assert_eq!(names(&at("far")), ["dangling", "none.vid", "real.vid"]);

    symlink("two", at("one")).unwrap();
    symlink("one", at("two")).unwrap();
    let error = save::save(&at("one"), b"").unwrap_err().to_string();
    assert!(error.contains("symbolic links"), "{error}");
}

#[test]
fn a_writer_that_fails_leaves_the_old_file() {
    let folder = folder();
    let file = folder.path().join("kept.vid");
    fs::write(&file, "old").unwrap();
    let mut fail = |out: &mut dyn Write| -> Result<()> {
        // More than any buffer holds: some of it has reached the disk.
        out.write_all(&vec![b'x'; 1 << 20]).unwrap();
        Err(EngineError::Memory.into())
    };
    assert!(matches!(
        save::save_with(&file, &mut fail),
        Err(Error::Engine(EngineError::Memory))
    ));
    let missing = folder.path().join("missing.vid");
    assert!(save::save_with(&missing, &mut fail).is_err());
    let mut panic = |_: &mut dyn Write| -> Result<()> { panic!("the writer's own fault") };
    let caught = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| {
        let _ = save::save_with(&file, &mut panic);
    }));
    assert!(caught.is_err());
    assert_eq!(fs::read(&file).unwrap(), b"old");
    assert_eq!(names(folder.path()), ["kept.vid"]);
}

#[test]
fn a_writers_error_names_the_file() {
    let folder = folder();
    let file = folder.path().join("full.vid");
    let error = save::save_with(&file, &mut |_| {
        Err(Error::Io {
            place: "the output".to_owned(),
            source: std::io::Error::from_raw_os_error(28),
        })
    })
    .unwrap_err();
    assert_eq!(
        error.to_string(),
        format!("{}: No space left on device", file.display())
    );
}

#[test]
fn what_cannot_be_replaced_is_refused() {
    let folder = folder();
    let path = folder.path();
    let error = |file: &Path| save::save(file, b"x").unwrap_err().to_string();
    assert_eq!(
        error(path),
        format!("{}: this is a directory, not a file", path.display())
    );
    let missing = path.join("no/such/folder.vid");
    assert_eq!(
        error(&missing),
        format!("{}: No such file or directory", missing.display())
    );
    let under = path.join("file");
    fs::write(&under, "").unwrap();
    let under = under.join("below.vid");
    assert_eq!(
        error(&under),
        format!("{}: Not a directory", under.display())
    );
    assert_eq!(
        error(Path::new("/dev/null")),
        "/dev/null: this is not a regular file"
    );
    assert_eq!(error(Path::new("")), ": No such file or directory");
    assert_eq!(names(path), ["file"]);
}

#[test]
fn the_longest_names_can_be_saved() {
    let folder = folder();
    let file = folder.path().join("n".repeat(255));
    save::save(&file, b"new").unwrap();
    assert_eq!(names(folder.path()), ["n".repeat(255)]);
    let file = folder.path().join("n".repeat(256));
    assert!(save::save(&file, b"new").is_err());
}

/// Many writers and readers of one file: a reader never sees anything but a
/// whole one.
#[test]
fn readers_see_whole_files_only() {
    let folder = folder();
    let file: PathBuf = folder.path().join("busy.vid");
    let contents: Vec<Vec<u8>> = (0..4_u8).map(|byte| vec![byte; 300_000]).collect();
    save::save(&file, &contents[0]).unwrap();
    std::thread::scope(|scope| {
        for content in &contents {
            scope.spawn(|| {
                for _ in 0..10 {
                    save::save(&file, content).unwrap();
                }
            });
        }
        scope.spawn(|| {
            for _ in 0..200 {
                assert!(contents.contains(&fs::read(&file).unwrap()));
            }
        });
    });
    assert_eq!(names(folder.path()), ["busy.vid"]);
}
