//! Checks of what any bytes do as a setup or a recovery file, for tests and the fuzzer in `fuzz/`.
//!
//! The readers stay private: the fuzzer gets these checks, in a separate build (`cfg(fuzzing)`).

use std::fs;
use std::path::Path;

use vides_document::error::ErrorKind;

use crate::files::recovery::{self, Autosave, Origin};
use crate::setup::file as setup_file;

/// Loads bytes as a setup: they are refused with one sentence that names file and line, or saved
/// and loaded again without a bit changing. `folder` is for this alone.
///
/// # Panics
/// If that does not hold.
pub fn setup(folder: &Path, bytes: &[u8]) {
    let file = folder.join("setup.toml");
    fs::write(&file, bytes).expect("a file to read");
    let setup = match setup_file::load(&file) {
        Ok(setup) => setup,
        Err(error) => {
            let sentence = error.to_string();
            assert!(!sentence.chars().any(char::is_control), "{sentence:?}");
            assert!(sentence.contains("setup.toml: line "), "{sentence}");
            return;
        }
    };
    assert_eq!(setup.view, setup.view.in_range());
    setup_file::write(&file, &setup).expect("a setup to be saved");
    let text = fs::read(&file).expect("what was saved");
    let again = setup_file::load(&file).expect("what was saved loads");
    assert_eq!(format!("{again:?}"), format!("{setup:?}"));
    setup_file::write(&file, &again).expect("a setup to be saved");
    assert_eq!(fs::read(&file).expect("what was saved"), text);
}

/// Finds bytes as work that was left behind: offered or left alone; its document and its file's
/// name are kept again without a bit changing. `folder` is for this alone, and empty afterwards.
///
/// # Panics
/// If that does not hold.
pub fn recovery(folder: &Path, bytes: &[u8]) {
    fs::write(folder.join("unsaved-1-2-3.vid"), bytes).expect("a file to find");
    for found in recovery::find(folder, None) {
        let document = match found.document() {
            Ok(document) => document,
            Err(error) if matches!(error.kind(), ErrorKind::Format | ErrorKind::Limit) => {
                let said = error.to_string();
                assert!(!said.chars().any(char::is_control), "{said:?}");
                found.discard();
                continue;
            }
            Err(error) => panic!("neither a document nor broken: {error}"),
        };
        assert!(document.is_modified());
        let (original, program) = (found.original.clone(), found.program.clone());
        let known = found.known;
        found.discard();
        let mut autosave = Autosave::new(folder, &document);
        autosave
            .write(
                &document,
                &Origin {
                    program: program.as_deref().unwrap_or_default(),
                    file: original.as_deref(),
                    known,
                },
            )
            .expect("work to be kept");
        drop(autosave);
        let mut again = recovery::find(folder, None);
        let kept = again.pop().expect("what was kept is found");
        assert!(again.is_empty());
        // A name without a folder is kept as an absolute one.
        let whole = original.map(|file| std::path::absolute(&file).unwrap_or(file));
        // What the file contained is kept only with its name.
        assert_eq!(kept.known, known.filter(|_| whole.is_some()));
        assert_eq!(kept.original, whole);
        assert_eq!(kept.program, program.filter(|name| !name.is_empty()));
        let came_back = kept.document().expect("what was kept loads");
        assert_eq!(
            came_back.to_toml().expect("a text"),
            document.to_toml().expect("a text")
        );
        kept.discard();
    }
    // The window leaves alone what is no text; here it goes.
    for entry in fs::read_dir(folder).expect("the folder").flatten() {
        fs::remove_file(entry.path()).expect("a file to remove");
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every file of a folder of the corpus.
    fn replay(name: &str, check: fn(&Path, &[u8])) {
        let corpus = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/corpus");
        let folder = tempfile::tempdir().unwrap();
        let mut count = 0;
        for entry in fs::read_dir(corpus.join(name)).unwrap() {
            let file = entry.unwrap().path();
            println!("{}", file.display());
            check(folder.path(), &fs::read(&file).unwrap());
            count += 1;
        }
        assert!(count > 0, "no files");
    }

    #[test]
    fn setup_files_of_the_corpus_are_refused_or_kept() {
        replay("setup", setup);
    }

    #[test]
    fn recovery_files_of_the_corpus_are_refused_or_kept() {
        replay("recovery", recovery);
    }
}
