//! What any bytes at all may do as a file of a format. Used by the tests and, by path, by the
//! fuzzer in `fuzz/`, so that both ask the same.

use std::path::Path;

use vides_formats::{As, Content, Format, Loss, Options, Report, Source, formats, import, losses};

/// Frames of what is written out again, poses of which a path is fitted, at most.
const LOOKED_AT: f64 = 64.0;

/// What stands before the content of each file of a folder in one sequence of bytes, with its name
/// and a line feed behind it.
const FILE: &[u8] = b"--- ";

/// Reads bytes as a file: it is refused with one sentence, or gives a scene that is in order, can be
/// saved, and goes out in the same format. A format of several files has them in `folder`, which is
/// emptied.
///
/// # Panics
/// If that does not hold.
pub(crate) fn check(format: &Format, bytes: &[u8], folder: &Path) {
    let source = source(format, bytes, folder);
    for other in formats() {
        let _ = (other.recognises)(&source);
    }
    let mut options = Options {
        as_: Some(As::Keys),
        ..Options::default()
    };
    let read = match import(&source, Some(format), &options) {
        Ok(read) => read,
        Err(error) => return check_sentence(&error.to_string()),
    };
    read.report.losses().iter().for_each(check_loss);
    let text = read.document.to_toml().expect("a text");
    let again = vides_document::SceneDocument::from_toml(&text)
        .unwrap_or_else(|error| panic!("read, saved and then refused: {error}\n{text}"));
    assert_eq!(again.to_toml().expect("a text"), text);
    let (first, last) = read.document.scene.frame_range();
    if last - first > LOOKED_AT {
        return;
    }
    if format.writes() {
        match losses(&read.document, format, &options) {
            Ok(report) => report.losses().iter().for_each(check_loss),
            Err(error) => check_sentence(&error.to_string()),
        }
    }
    let content = vides_formats::read(&source, Some(format), &options, &mut Report::default());
    if let Ok((_, Content::Poses(_))) = content {
        options.as_ = Some(As::Path);
        options.angle = 10.0;
        match import(&source, Some(format), &options) {
            Ok(read) => read.report.losses().iter().for_each(check_loss),
            Err(error) => check_sentence(&error.to_string()),
        }
    }
}

fn check_loss(loss: &Loss) {
    check_sentence(&loss.to_string());
}

fn check_sentence(sentence: &str) {
    assert!(!sentence.is_empty());
    assert!(!sentence.chars().any(char::is_control), "{sentence:?}");
}

fn source(format: &Format, bytes: &[u8], folder: &Path) -> Source {
    if !(format.is_folder() || format.reads_folder && bytes.starts_with(FILE)) {
        return Source::of_bytes("a file", bytes.to_vec());
    }
    for entry in std::fs::read_dir(folder).expect("a folder") {
        let place = entry.expect("an entry").path();
        match place.is_dir() {
            true => std::fs::remove_dir_all(place).expect("a folder less"),
            false => std::fs::remove_file(place).expect("a file less"),
        }
    }
    let starts = (0..bytes.len())
        .filter(|&at| bytes[at..].starts_with(FILE) && (at == 0 || bytes[at - 1] == b'\n'));
    let starts: Vec<_> = starts.collect();
    for (at, &start) in starts.iter().enumerate() {
        let end = starts.get(at + 1).map_or(bytes.len(), |next| next - 1);
        let piece = &bytes[start + FILE.len()..end.max(start + FILE.len())];
        let line = piece.iter().position(|&byte| byte == b'\n');
        let (name, content) = piece.split_at(line.unwrap_or(piece.len()));
        let name = String::from_utf8_lossy(name);
        let plain = |byte: u8| byte.is_ascii_alphanumeric() || b".-".contains(&byte);
        let mut parts = name.split('/');
        let inside = |part: &str| {
            part.starts_with(|c: char| c.is_ascii_alphanumeric()) && part.bytes().all(plain)
        };
        if name.len() < 48 && parts.all(inside) {
            let place = folder.join(&*name);
            // A file may have the name of a folder.
            if std::fs::create_dir_all(place.parent().unwrap_or(folder)).is_ok() {
                let _ = std::fs::write(place, content.get(1..).unwrap_or(b""));
            }
        }
    }
    Source {
        name: "a folder".to_owned(),
        folder: Some(folder.to_owned()),
        is_folder: true,
        ..Source::default()
    }
}
