//! Dead keys and compose sequences.
//!
//! The Compose file of the locale is read once per process, when the first character is typed: it
//! costs milliseconds and some hundred kilobytes.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::{Arc, OnceLock};

use kbvm::xkb::Context;
use kbvm::xkb::compose::{ComposeTable, FeedResult, State};
use kbvm::xkb::diagnostic::Diagnostic;
use kbvm::{Keysym, syms};

#[derive(Debug, PartialEq, Eq)]
pub(super) enum Fed {
    /// Not part of a sequence: handle it as usual.
    Plain,
    /// Part of a sequence that is unfinished or has just been cancelled.
    Taken,
    /// Completes a sequence with this text.
    Text(String),
}

#[derive(Default)]
pub(super) struct Compose {
    table: Option<Arc<ComposeTable>>,
    state: Option<State>,
}

impl Compose {
    pub(super) fn feed(&mut self, keysym: Keysym) -> Fed {
        if self.table.is_none() {
            self.table = shared();
        }
        let Some(table) = self.table.as_deref() else {
            return Fed::Plain;
        };
        let mut state = self.state.take().unwrap_or_else(|| table.create_state());
        let underway = state != table.create_state();
        let mut result = table.feed(&mut state, keysym);
        if result == Some(FeedResult::Aborted) {
            if matches!(keysym, syms::BackSpace | syms::Escape) {
                return Fed::Taken;
            }
            // A key that does not fit ends the sequence and counts on its own.
            result = table.feed(&mut state, keysym);
        }
        match result {
            Some(FeedResult::Pending) => {
                self.state = Some(state);
                Fed::Taken
            }
            Some(FeedResult::Composed { string, keysym }) => match text(string, keysym) {
                Some(text) => Fed::Text(text),
                None => Fed::Taken,
            },
            Some(FeedResult::Aborted) => Fed::Plain,
            None => {
                // A modifier does not disturb a sequence.
                self.state = underway.then_some(state).filter(|_| keysym.is_modifier());
                Fed::Plain
            }
        }
    }

    pub(super) fn reset(&mut self) {
        self.state = None;
    }
}

/// The text of a sequence: the file's string, or the keysym's text if the string is not valid
/// UTF-8.
fn text(string: Option<&str>, keysym: Option<Keysym>) -> Option<String> {
    let sound = |text: &&str| !text.is_empty() && !text.contains('\u{FFFD}');
    string
        .filter(sound)
        .map(str::to_owned)
        .or_else(|| keysym?.char().map(String::from))
        .or_else(|| string.map(str::to_owned))
}

fn shared() -> Option<Arc<ComposeTable>> {
    static TABLE: OnceLock<Option<Arc<ComposeTable>>> = OnceLock::new();
    TABLE.get_or_init(|| load(&Context::default())).clone()
}

/// Reads the table of the environment's locale, or the English one without it. Errors in the files
/// are skipped, and a panic of the parser counts as no table.
fn load(context: &Context) -> Option<Arc<ComposeTable>> {
    let read = |locale: Option<&str>| {
        let build = AssertUnwindSafe(|| {
            let mut builder = context.compose_table_builder();
            if let Some(locale) = locale {
                builder.locale(locale);
            }
            // Rejects all diagnostics before they are built.
            builder.build((Vec::<Diagnostic>::new(), |_, _| false))
        });
        catch_unwind(build).ok().flatten()
    };
    read(None)
        .or_else(|| read(Some("en_US.UTF-8")))
        .map(Arc::new)
}

#[cfg(test)]
mod tests {
    use super::*;

    const FILE: &str = r#"
<dead_acute> <e> : "é" eacute
<dead_acute> <space> : "'" apostrophe
<Multi_key> <less> <equal> : "≤"
<Multi_key> <o> <o> : degree
<Multi_key> <dead_acute> : "´"
"#;

    fn compose(file: &str) -> Compose {
        let context = Context::default();
        let mut builder = context.compose_table_builder();
        builder.buffer(file);
        let table = builder.build(Vec::<Diagnostic>::new()).unwrap();
        Compose {
            table: Some(Arc::new(table)),
            state: None,
        }
    }

    fn text(text: &str) -> Fed {
        Fed::Text(text.to_owned())
    }

    #[test]
    fn sequences_make_their_text() {
        let mut compose = compose(FILE);
        assert_eq!(compose.feed(syms::e), Fed::Plain);
        assert_eq!(compose.feed(syms::dead_acute), Fed::Taken);
        assert_eq!(compose.feed(syms::Shift_L), Fed::Plain);
        assert_eq!(compose.feed(syms::e), text("é"));
        assert_eq!(compose.feed(syms::e), Fed::Plain);
        assert_eq!(compose.feed(syms::Multi_key), Fed::Taken);
        assert_eq!(compose.feed(syms::less), Fed::Taken);
        assert_eq!(compose.feed(syms::equal), text("≤"));
        for key in [syms::Multi_key, syms::o] {
            assert_eq!(compose.feed(key), Fed::Taken);
        }
        assert_eq!(compose.feed(syms::o), text("°"));
    }

    #[test]
    fn a_sequence_that_cannot_go_on_is_given_up() {
        let mut compose = compose(FILE);
        for stop in [syms::BackSpace, syms::Escape] {
            assert_eq!(compose.feed(syms::dead_acute), Fed::Taken);
            assert_eq!(compose.feed(stop), Fed::Taken);
            assert_eq!(compose.feed(stop), Fed::Plain);
        }
        assert_eq!(compose.feed(syms::dead_acute), Fed::Taken);
        assert_eq!(compose.feed(syms::x), Fed::Plain);
        assert_eq!(compose.feed(syms::e), Fed::Plain);
        // A key that does not fit may begin another sequence.
        assert_eq!(compose.feed(syms::dead_acute), Fed::Taken);
        assert_eq!(compose.feed(syms::Multi_key), Fed::Taken);
        assert_eq!(compose.feed(syms::dead_acute), text("´"));
        assert_eq!(compose.feed(syms::dead_acute), Fed::Taken);
        compose.reset();
        assert_eq!(compose.feed(syms::e), Fed::Plain);
    }

    /// "\351" is é in Latin-1, but not valid UTF-8.
    #[test]
    fn text_in_another_encoding_gives_way_to_the_keysym() {
        let mut compose = compose("<dead_acute> <e> : \"\\351\" eacute\n");
        assert_eq!(compose.feed(syms::dead_acute), Fed::Taken);
        assert_eq!(compose.feed(syms::e), text("é"));
    }

    #[test]
    fn a_missing_or_broken_file_does_no_harm() {
        let mut builder = Context::builder();
        builder
            .environment_accessor(|name| (name == "XLOCALEDIR").then(|| "/nonexistent".to_owned()));
        assert!(load(&builder.build()).is_none());
        let mut compose = compose("<dead_acute <e> : \"\u{1}\n<\n\0\n");
        assert_eq!(compose.feed(syms::dead_acute), Fed::Plain);
    }
}
