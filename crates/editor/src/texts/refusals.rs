//! Why something could not be done, in the window's language.
//!
//! Sentences for errors that the user can cause in the window; all others are only translated.

use std::io;

use vides_document::NotAFile;
use vides_document::error::{
    EngineError, Error, ErrorKind, Invalid, OutOfRange, Quantity, Refused, TooMany, reason,
};
use vides_engine::limits;

use super::{Language, fill};
use crate::texts::german::German;

/// Why the document refused an edit.
pub(crate) fn of_edit(language: Language, error: &Error) -> String {
    let texts = language.texts();
    let (position, orientation) = (&texts.position, &texts.orientation);
    let said = match error {
        Error::Engine(error) => match error {
            EngineError::Limit(TooMany::SupportPoints) => {
                return fill(position.too_many, &[&limits::MAX_POINTS]);
            }
            EngineError::Limit(TooMany::Orientations) => {
                return fill(orientation.at_most, &[&limits::MAX_ORIENTATIONS]);
            }
            EngineError::Limit(TooMany::AllOrientations) => {
                let most = limits::MAX_ALL_ORIENTATIONS;
                return fill(position.too_many_orientations, &[&most]);
            }
            EngineError::Range(OutOfRange::Exceeds(Quantity::Coordinate, most)) => {
                let bound = |value| language.number(value, 0);
                return fill(position.too_far, &[&bound(-most), &bound(*most)]);
            }
            EngineError::Argument(Invalid::TargetOnCamera) => orientation.on_position,
            EngineError::Memory => texts.errors.memory,
            _ => "",
        },
        Error::Refused(refused) => match refused {
            Refused::NoSegmentAtEnd => position.last_point,
            Refused::NoEnds => position.closed_has_no_ends,
            Refused::NoDirection(_) => position.no_direction,
            Refused::NoRoom(_) => position.no_room,
            Refused::TwoPointsRemain => position.two_remain,
            Refused::OnTarget { .. } => position.on_target,
            Refused::OneOrientationRemains => orientation.one_remains,
            _ => "",
        },
        _ => "",
    };
    match said {
        "" => fill(texts.errors.refused, &[&reason_of(language, error)]),
        said => said.to_owned(),
    }
}

/// Why something with a file or with poses failed.
pub(crate) fn reason_of(language: Language, error: &Error) -> String {
    match error {
        Error::Io { source, .. } => of_system(language, source),
        _ if error.kind() == ErrorKind::Memory => language.texts().errors.memory.to_owned(),
        _ if language == Language::German => German(error).to_string(),
        _ => error.to_string(),
    }
}

/// What the operating system said.
pub(crate) fn of_system(language: Language, error: &io::Error) -> String {
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

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;
    use vides_document::save::save;
    use vides_document::vid::read_text;

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
