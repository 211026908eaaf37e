//! Why something could not be done, in the window's language.
//!
//! The library's own sentences speak to programs too and count from 0. Of what a
//! hand can bring about in the window each has one here; the others are said in
//! the window's language as they are.

use std::io;

use super::state::Editor;
use super::texts::{Language, fill};
use crate::document::{Document, Edit, NotAFile};
use crate::error::{Error, reason};
use crate::limits;

/// The kinds of edits that fail for different reasons.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Insert,
    Divide,
    Extend,
    RemovePoint,
    Move,
    InsertOrientation,
    RemoveOrientation,
    Orientation,
    Other,
}

impl Kind {
    pub(super) fn of(edit: &Edit) -> Self {
        match edit {
            Edit::InsertPoint { .. } => Self::Insert,
            Edit::DivideSegment { .. } => Self::Divide,
            Edit::AppendAfterLast | Edit::PrependBeforeFirst => Self::Extend,
            Edit::RemovePoint { .. } => Self::RemovePoint,
            Edit::SetPosition { .. } => Self::Move,
            Edit::InsertOrientation { .. } => Self::InsertOrientation,
            Edit::RemoveOrientation { .. } => Self::RemoveOrientation,
            Edit::SetOrientation { .. } | Edit::SetAbsolute { .. } => Self::Orientation,
            _ => Self::Other,
        }
    }
}

/// Why the document refused an edit.
pub(super) fn of_edit(
    language: Language,
    document: &Document,
    kind: Kind,
    error: &Error,
) -> String {
    let texts = language.texts();
    let (position, orientation) = (&texts.position, &texts.orientation);
    let bound = |value: f64| language.number(value, 0);
    match (kind, error) {
        (Kind::Insert | Kind::Divide | Kind::Extend, Error::Limit(_)) => {
            let room = limits::MAX_POINTS - document.path().points.len().min(limits::MAX_POINTS);
            if room < limits::MAX_DIVISION {
                fill(position.too_many, &[&limits::MAX_POINTS])
            } else {
                fill(
                    position.too_many_orientations,
                    &[&limits::MAX_ALL_ORIENTATIONS],
                )
            }
        }
        (Kind::Divide, Error::Range(_)) => position.last_point.to_owned(),
        (Kind::Extend, Error::Argument(_)) if document.path().closed => {
            position.closed_has_no_ends.to_owned()
        }
        (Kind::Extend, Error::Argument(_)) => position.no_direction.to_owned(),
        (Kind::Extend, Error::Range(_)) => position.no_room.to_owned(),
        (Kind::RemovePoint, Error::Range(_)) => position.two_remain.to_owned(),
        (Kind::Move, Error::Argument(_)) => position.on_target.to_owned(),
        (Kind::InsertOrientation, Error::Limit(_)) => {
            let point = document.path().points.get(document.selection().point);
            if point.is_some_and(|point| point.orientations.len() < limits::MAX_ORIENTATIONS) {
                fill(
                    position.too_many_orientations,
                    &[&limits::MAX_ALL_ORIENTATIONS],
                )
            } else {
                fill(orientation.at_most, &[&limits::MAX_ORIENTATIONS])
            }
        }
        (Kind::RemoveOrientation, Error::Range(_)) => orientation.one_remains.to_owned(),
        (Kind::Orientation | Kind::InsertOrientation, Error::Argument(_)) => {
            orientation.on_position.to_owned()
        }
        (Kind::Move | Kind::Insert | Kind::Orientation, Error::Range(_)) => {
            let space = document.path().space;
            let centre = space.centre.abs().max_element();
            let far = space.farthest();
            fill(
                position.too_far,
                &[&bound(-far - centre), &bound(far + centre)],
            )
        }
        (_, Error::Memory) => texts.errors.memory.to_owned(),
        (_, other) => fill(texts.errors.refused, &[&reason_of(language, other)]),
    }
}

/// Why something with a file or with poses failed, without the file's name.
pub(super) fn reason_of(language: Language, error: &Error) -> String {
    let texts = &language.texts().errors;
    match error {
        Error::Io { source, .. } => of_system(language, source),
        Error::Memory => texts.memory.to_owned(),
        Error::Argument(message)
        | Error::Range(message)
        | Error::Limit(message)
        | Error::Format(message)
        | Error::Display(message) => language.reason(message),
    }
}

/// What the operating system said.
pub(super) fn of_system(language: Language, error: &io::Error) -> String {
    let texts = &language.texts().errors;
    let known = match error.kind() {
        io::ErrorKind::NotFound => texts.not_found,
        io::ErrorKind::PermissionDenied => texts.permission,
        io::ErrorKind::IsADirectory => texts.is_directory,
        io::ErrorKind::NotADirectory => texts.not_directory,
        io::ErrorKind::StorageFull | io::ErrorKind::QuotaExceeded => texts.full,
        io::ErrorKind::ReadOnlyFilesystem => texts.read_only,
        io::ErrorKind::InvalidFilename => texts.long_name,
        io::ErrorKind::FileTooLarge => texts.too_large,
        io::ErrorKind::Interrupted => texts.interrupted,
        io::ErrorKind::OutOfMemory => texts.memory,
        _ => match NotAFile::of(error) {
            Some(NotAFile::Directory) => texts.is_directory,
            Some(NotAFile::Special) => texts.not_regular,
            None => return fill(texts.system, &[&reason(error)]),
        },
    };
    known.to_owned()
}

impl Editor {
    /// Says what went wrong without a hand at work.
    pub(super) fn complain_of(&mut self, error: &Error) {
        self.complain(reason_of(self.language(), error));
    }

    /// Says how a hand-over failed.
    pub(super) fn complain_of_hand_over(&mut self, error: &Error) {
        let texts = &self.texts().errors;
        let why = match error {
            Error::Limit(_) => fill(texts.frames, &[&limits::MAX_FRAMES]),
            other => reason_of(self.language(), other),
        };
        self.complain(fill(texts.cannot_hand_over, &[&why]));
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;
    use crate::document::{save::save, vid::read_text};

    #[test]
    fn what_is_no_file_is_called_what_it_is() {
        for language in [Language::German, Language::English] {
            let texts = &language.texts().errors;
            for (place, what) in [("/", texts.is_directory), ("/dev/null", texts.not_regular)] {
                let place = Path::new(place);
                for refused in [read_text(place, 1).map(drop), save(place, b"")] {
                    let error = refused.expect_err("no file");
                    assert_eq!(reason_of(language, &error), what);
                }
            }
            // The same words from elsewhere are somebody else's.
            let other = io::Error::other("this is not a regular file");
            let said = of_system(language, &other);
            assert_eq!(said, fill(texts.system, &[&other]));
        }
    }
}
