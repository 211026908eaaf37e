//! What all that writes a file writes with. Of numbers and lists of them `{:?}` writes TOML, with the
//! fewest digits that parse to the same bits.

use std::fmt::{self, Debug, Write};

use vides_engine::property::Property;
pub(super) use vides_engine::property::Quoted;

/// A text in quotes.
pub(crate) fn quoted(text: &str) -> String {
    Quoted(text).to_string()
}

/// A string that reports running out of memory.
pub(super) struct Text(pub(super) String);

impl Write for Text {
    fn write_str(&mut self, more: &str) -> fmt::Result {
        self.0.try_reserve(more.len()).map_err(|_| fmt::Error)?;
        self.0.push_str(more);
        Ok(())
    }
}

/// A property, if it is not as in a new one or always stands there.
pub(super) fn plain<T>(out: &mut impl Write, row: &Property<T>, of: &T, new: &T) -> fmt::Result {
    if row.keys.is_empty() || !row.always && (row.same)(of, new) {
        return Ok(());
    }
    let value = (row.value)(of);
    match row.key_of(&value) {
        Some(key) => writeln!(out, "{key} = {value}"),
        None => Ok(()),
    }
}

pub(super) fn rows<T: Debug>(
    out: &mut Text,
    key: &str,
    rows: impl IntoIterator<Item = T>,
) -> fmt::Result {
    let mut rows = rows.into_iter().peekable();
    if rows.peek().is_none() {
        return Ok(());
    }
    writeln!(out, "{key} = [")?;
    for row in rows {
        writeln!(out, "  {row:?},")?;
    }
    writeln!(out, "]")
}
