//! A catalogue holds the texts of one language, one a line, for translators who need no Rust.
//!
//! ```text
//! [space]
//! whole_meaning = See all of it as at first
//! turned = {0} turned by {1}°
//! ```

use std::collections::BTreeMap;

/// The texts of a language by part and name. They stay until the process ends; a hash map has no
/// pointer to the beginning of its memory, which checkers of memory take for lost.
pub(super) struct Catalogue(BTreeMap<(&'static str, &'static str), &'static str>);

impl Catalogue {
    pub(super) fn new(file: &'static str) -> Self {
        let mut part = "";
        let mut texts = BTreeMap::new();
        for line in file.lines().filter(|line| !line.starts_with('#')) {
            if let Some((name, text)) = line.split_once(" = ") {
                let quoted = text
                    .strip_prefix('"')
                    .and_then(|text| text.strip_suffix('"'));
                texts.insert((part, name), quoted.unwrap_or(text));
            } else if let Some(name) = line
                .strip_prefix('[')
                .and_then(|line| line.strip_suffix(']'))
            {
                part = name;
            }
        }
        Self(texts)
    }

    /// The text of this name, if there is one.
    pub(super) fn find(&self, part: &str, name: &str) -> Option<&'static str> {
        self.0.get(&(part, name)).copied()
    }

    /// The texts of these names. A test sees that none is missing; one that were would show its name.
    pub(super) fn texts<const N: usize>(
        &self,
        part: &str,
        names: [&'static str; N],
    ) -> [&'static str; N] {
        names.map(|name| self.find(part, name).unwrap_or(name))
    }

    /// Part and name of each text.
    #[cfg(test)]
    pub(super) fn names(&self) -> impl Iterator<Item = (&'static str, &'static str)> {
        self.0.keys().copied()
    }
}
