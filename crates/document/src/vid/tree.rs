//! What stands in a piece of a file: keys and values, and where.
//!
//! Which key may add to which table is TOML's rule; None: it may not.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

/// A value and where it is reported: the byte offset of its key, or of an element itself.
pub(super) type Placed<'a> = (usize, Value<'a>);

/// A key and its byte offset.
pub(super) type Key<'a> = (usize, Cow<'a, str>);

/// Values by their keys.
#[derive(Debug, Default)]
pub struct Table<'a> {
    pub(super) entries: BTreeMap<Cow<'a, str>, Placed<'a>>,
    pub(super) made: Made,
}

/// What has made a table, which decides what may add to it.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) enum Made {
    /// Its own header, or the beginning of the file.
    #[default]
    Header,
    /// The header of a table below it.
    Below,
    /// A key with dots.
    Dotted,
    /// Braces.
    Inline,
    /// A key with dots within braces.
    InlineDotted,
}

#[derive(Debug)]
#[cfg_attr(test, derive(PartialEq))]
pub(super) enum Value<'a> {
    Text(Cow<'a, str>),
    Float(f64),
    /// The same as a number with a decimal point; None where it is too large for an integer.
    Integer(f64, Option<i64>),
    Boolean(bool),
    Date,
    Array(Vec<Placed<'a>>),
    Table(Table<'a>),
}

impl<'a> Table<'a> {
    pub(super) fn new(made: Made) -> Self {
        Self {
            made,
            ..Self::default()
        }
    }

    /// Whether it stands there only because of what is below it.
    const fn is_implied(&self) -> bool {
        matches!(self.made, Made::Below | Made::Dotted | Made::InlineDotted)
    }

    const fn is_inline(&self) -> bool {
        matches!(self.made, Made::Inline | Made::InlineDotted)
    }

    /// The table at the end of a path of keys; `new` is what makes those that are missing.
    pub(super) fn descend(&mut self, path: &[Key<'a>], new: Made) -> Option<&mut Self> {
        let mut table = self;
        for (offset, key) in path {
            let value = table.entries.entry(key.clone());
            let value = value.or_insert_with(|| (*offset, Value::Table(Table::new(new))));
            table = match &mut value.1 {
                Value::Array(elements) if new != Made::InlineDotted => last_table(elements)?,
                Value::Table(below) => {
                    let closed = below.is_inline() && new != Made::InlineDotted;
                    if closed || new != Made::Below && !below.is_implied() {
                        return None;
                    }
                    if new == Made::Dotted {
                        below.made = new;
                    }
                    below
                }
                _ => return None,
            };
        }
        Some(table)
    }

    /// Puts a value behind its key; `new`: what makes the tables on the way.
    pub(super) fn put(
        &mut self,
        path: &[Key<'a>],
        (offset, key): Key<'a>,
        value: Value<'a>,
        new: Made,
    ) -> Option<()> {
        let table = self.descend(path, new)?;
        if !path.is_empty() && !table.is_implied() {
            return None;
        }
        let Entry::Vacant(place) = table.entries.entry(key) else {
            return None;
        };
        place.insert((offset, value));
        Some(())
    }

    /// Begins the table of a header, at the end of a path of keys; `element`: of one of several, where
    /// it begins.
    pub(super) fn begin(
        &mut self,
        path: &[Key<'a>],
        (offset, key): Key<'a>,
        element: Option<usize>,
    ) -> Option<()> {
        let table = Value::Table(Table::default());
        let new = match element {
            Some(_) => Value::Array(Vec::new()),
            None => Value::Table(Table::new(Made::Below)),
        };
        let all = &mut self.descend(path, Made::Below)?.entries;
        let known = all.contains_key(&key);
        match (all.entry(key).or_insert((offset, new)), element) {
            ((_, Value::Array(all)), Some(element)) => {
                // An array that stands behind a key is not added to.
                if known {
                    last_table(all)?;
                }
                all.push((element, table));
            }
            ((place, Value::Table(below)), None) if below.made == Made::Below => {
                (*place, below.made) = (offset, Made::Header);
            }
            _ => return None,
        }
        Some(())
    }
}

/// The last of the tables that headers have made of a list.
fn last_table<'t, 'a>(elements: &'t mut [Placed<'a>]) -> Option<&'t mut Table<'a>> {
    match elements.last_mut() {
        Some((_, Value::Table(last))) if !last.is_inline() => Some(last),
        _ => None,
    }
}
