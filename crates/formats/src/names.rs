//! Names of what is read, each given once.

use std::collections::{HashMap, HashSet};

use vides_engine::limits::MAX_NAME_BYTES;

use super::content::one_line;
use super::error::Result;

/// Room for a number behind a name.
const NUMBER: usize = 16;

/// Names that are taken, and the next number of each.
#[derive(Default)]
pub(super) struct Names {
    taken: HashSet<String>,
    next: HashMap<String, usize>,
}

impl Names {
    /// The name, or one like it that is free.
    ///
    /// # Errors
    /// For memory.
    pub(super) fn unique(&mut self, wanted: &str) -> Result<String> {
        let mut name = one_line(wanted);
        if name.is_empty() {
            name = "node".to_owned();
        }
        self.taken.try_reserve(1)?;
        self.next.try_reserve(1)?;
        if self.taken.insert(name.clone()) {
            return Ok(name);
        }
        let mut base = name;
        while base.len() > MAX_NAME_BYTES - NUMBER {
            base.pop();
        }
        // Many of one name are numbered from where the last one ended.
        let next = self.next.entry(base.clone()).or_insert(2);
        loop {
            let numbered = format!("{base} {next}");
            *next += 1;
            if self.taken.insert(numbered.clone()) {
                return Ok(numbered);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_given_once() {
        let mut names = Names::default();
        let long = "ä".repeat(MAX_NAME_BYTES / 2);
        for (wanted, given) in [
            ("a", "a"),
            ("a 2", "a 2"),
            ("a", "a 3"),
            ("a\nb", "a 4"),
            ("", "node"),
            (&long, &long),
            (&long, &format!("{} 2", "ä".repeat(MAX_NAME_BYTES / 2 - 8))),
        ] {
            assert_eq!(names.unique(wanted).unwrap(), given);
        }
    }
}
