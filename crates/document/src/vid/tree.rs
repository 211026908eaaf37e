//! What stands in a piece of a file: keys and values, and where.
//!
//! The parser lists all tokens, then all events, then builds a tree of strings; that was two thirds
//! of the time that a file took. What is written as we write it ourselves (bare keys, numbers in
//! base ten, strings without escapes) is therefore read here in one go, numbers as numbers. Whatever
//! else there is, errors above all, is left to the parser, so that only it says what is wrong.

use std::borrow::Cow;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// A value and where it is reported: the byte offset of its key, or of an element itself.
pub(super) type Placed<'a> = (usize, Value<'a>);

/// Keys in their order, each with its value.
#[derive(Debug, Default)]
pub struct Table<'a> {
    pub(super) entries: Vec<(Cow<'a, str>, Placed<'a>)>,
    /// Made by headers, which may add to it.
    open: bool,
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

impl<'a> From<DeTable<'a>> for Table<'a> {
    fn from(table: DeTable<'a>) -> Self {
        let entries = table.into_iter().map(|(key, value)| {
            // The key's line says more than that of the bracket of an array over several lines.
            let offset = key.span().start;
            (key.into_inner(), (offset, value.into_inner().into()))
        });
        Self {
            entries: entries.collect(),
            open: false,
        }
    }
}

impl<'a> From<DeValue<'a>> for Value<'a> {
    fn from(value: DeValue<'a>) -> Self {
        match value {
            DeValue::String(text) => Self::Text(text),
            DeValue::Float(float) => Self::Float(float.as_str().parse().unwrap_or(f64::NAN)),
            DeValue::Integer(integer) => {
                let whole = i64::from_str_radix(integer.as_str(), integer.radix()).ok();
                let number = match integer.radix() {
                    10 => integer.as_str().parse().unwrap_or(f64::NAN),
                    _ => whole.map_or(f64::NAN, |whole| whole as f64),
                };
                Self::Integer(number, whole)
            }
            DeValue::Boolean(boolean) => Self::Boolean(boolean),
            DeValue::Datetime(_) => Self::Date,
            DeValue::Array(array) => {
                let elements = array.into_iter();
                let placed = |element: Spanned<DeValue<'a>>| {
                    (element.span().start, element.into_inner().into())
                };
                Self::Array(elements.map(placed).collect())
            }
            DeValue::Table(table) => Self::Table(table.into()),
        }
    }
}

/// Adds one more; None without memory.
fn push<T>(to: &mut Vec<T>, one: T) -> Option<()> {
    to.try_reserve(1).ok()?;
    to.push(one);
    Some(())
}

/// Byte offset and name.
type Key<'a> = (usize, &'a str);

impl<'a> Table<'a> {
    fn find(&self, (_, key): Key<'a>) -> Result<usize, usize> {
        self.entries
            .binary_search_by(|(other, _)| (**other).cmp(key))
    }

    /// None if it has the key, or very many others: each insertion moves what is behind it.
    fn insert(&mut self, key: Key<'a>, value: Value<'a>) -> Option<()> {
        let at = self.find(key).err().filter(|_| self.entries.len() < KEYS)?;
        self.entries.try_reserve(1).ok()?;
        let entry = (Cow::Borrowed(key.1), (key.0, value));
        self.entries.insert(at, entry);
        Some(())
    }

    /// Puts what follows a header where its name says; None if something else is there. A table that
    /// may come again is the element of an array, reported where its header begins.
    fn attach(&mut self, name: Key<'a>, repeated: Option<usize>, table: Table<'a>) -> Option<()> {
        let (first, rest) = match name.1.split_once('.') {
            Some((first, rest)) => (first, Some((name.0 + first.len() + 1, rest))),
            None => (name.1, None),
        };
        let key = (name.0, first);
        let found = self.find(key);
        if found.is_err() {
            let new = match (rest, repeated) {
                (None, None) => return self.insert(key, Value::Table(table)),
                (None, Some(_)) => Value::Array(Vec::new()),
                (Some(_), _) => Value::Table(Table {
                    open: true,
                    ..Table::default()
                }),
            };
            self.insert(key, new)?;
        }
        let at = found.unwrap_or_else(|at| at);
        match (&mut self.entries[at].1.1, rest, repeated) {
            (Value::Table(below), Some(rest), _) => below.opened()?.attach(rest, repeated, table),
            (Value::Array(elements), Some(rest), _) => match &mut elements.last_mut()?.1 {
                Value::Table(below) => below.opened()?.attach(rest, repeated, table),
                _ => None,
            },
            (Value::Array(elements), None, Some(offset)) => {
                // An array that stands behind a key is not added to.
                let open = matches!(elements.last(), Some((_, Value::Table(last))) if last.open);
                (found.is_err() || open).then_some(())?;
                push(elements, (offset, Value::Table(table)))
            }
            _ => None,
        }
    }

    fn opened(&mut self) -> Option<&mut Self> {
        self.open.then_some(self)
    }
}

/// Arrays within arrays and tables within tables, at the most.
const DEPTH: usize = 8;

/// Keys of a table, at the most: more than there are.
const KEYS: usize = 64;

/// The tree of a text that is written plainly; None if it is not, or there is no memory.
pub(super) fn read(text: &str) -> Option<Table<'_>> {
    let mut plain = Plain { text, at: 0 };
    let mut root = plain.pairs()?;
    while plain.peek().is_some() {
        let offset = plain.at;
        plain.at += 1;
        let repeated = plain.take(b'[').then_some(offset);
        let name = (plain.at, plain.while_in(|byte| bare(byte) || byte == b'.'));
        let whole = name.1.split('.').count() <= DEPTH && !name.1.split('.').any(str::is_empty);
        if !whole || !plain.take(b']') || (repeated.is_some() && !plain.take(b']')) {
            return None;
        }
        plain.end_of_line()?;
        let mut table = plain.pairs()?;
        table.open = true;
        root.attach(name, repeated, table)?;
    }
    Some(root)
}

fn bare(byte: u8) -> bool {
    byte.is_ascii_alphanumeric() || matches!(byte, b'_' | b'-')
}

struct Plain<'a> {
    text: &'a str,
    at: usize,
}

impl<'a> Plain<'a> {
    fn peek(&self) -> Option<u8> {
        self.text.as_bytes().get(self.at).copied()
    }

    /// Whether this byte comes next, which is passed then.
    fn take(&mut self, byte: u8) -> bool {
        let there = self.peek() == Some(byte);
        self.at += usize::from(there);
        there
    }

    fn while_in(&mut self, belongs: impl Fn(u8) -> bool) -> &'a str {
        let start = self.at;
        while self.peek().is_some_and(&belongs) {
            self.at += 1;
        }
        // Only ASCII belongs, or all but ASCII.
        self.text.get(start..self.at).unwrap_or("")
    }

    fn spaces(&mut self) {
        self.while_in(|byte| matches!(byte, b' ' | b'\t'));
    }

    /// What follows a value on its line: at most a comment.
    fn end_of_line(&mut self) -> Option<()> {
        self.spaces();
        if self.take(b'#') {
            self.while_in(|byte| byte == b'\t' || (byte >= b' ' && byte != 0x7f));
        }
        (self.take(b'\n') || self.at == self.text.len()).then_some(())
    }

    /// Passes blanks, ends of lines and comments.
    fn blank(&mut self) -> Option<()> {
        loop {
            self.spaces();
            if !matches!(self.peek(), Some(b'\n' | b'#')) {
                return Some(());
            }
            self.end_of_line()?;
        }
    }

    fn key(&mut self) -> Option<Key<'a>> {
        let key = (self.at, self.while_in(bare));
        (!key.1.is_empty()).then_some(key)
    }

    /// What stands before the next header.
    fn pairs(&mut self) -> Option<Table<'a>> {
        let mut table = Table::default();
        loop {
            self.blank()?;
            if matches!(self.peek(), None | Some(b'[')) {
                return Some(table);
            }
            self.pair(&mut table, DEPTH)?;
            self.end_of_line()?;
        }
    }

    fn pair(&mut self, into: &mut Table<'a>, depth: usize) -> Option<()> {
        self.spaces();
        let key = self.key()?;
        self.spaces();
        self.take(b'=').then_some(())?;
        self.spaces();
        into.insert(key, self.value(depth)?)
    }

    fn value(&mut self, depth: usize) -> Option<Value<'a>> {
        match self.peek()? {
            b'"' => {
                self.at += 1;
                let inside = |byte: u8| byte >= b' ' && !matches!(byte, b'"' | b'\\' | 0x7f);
                let text = self.while_in(inside);
                let closed = self.take(b'"') && self.peek() != Some(b'"');
                closed.then_some(Value::Text(Cow::Borrowed(text)))
            }
            b'[' => self.array(depth.checked_sub(1)?),
            b'{' => self.inline(depth.checked_sub(1)?),
            b't' | b'f' => match self.key()?.1 {
                "true" => Some(Value::Boolean(true)),
                "false" => Some(Value::Boolean(false)),
                _ => None,
            },
            _ => self.number(),
        }
    }

    fn array(&mut self, depth: usize) -> Option<Value<'a>> {
        self.at += 1;
        let mut elements = Vec::new();
        loop {
            self.blank()?;
            if self.take(b']') {
                return Some(Value::Array(elements));
            }
            push(&mut elements, (self.at, self.value(depth)?))?;
            self.blank()?;
            (self.take(b',') || self.peek() == Some(b']')).then_some(())?;
        }
    }

    fn inline(&mut self, depth: usize) -> Option<Value<'a>> {
        let mut table = Table::default();
        let mut before = b'{';
        loop {
            self.take(before).then_some(())?;
            self.pair(&mut table, depth)?;
            self.spaces();
            if self.take(b'}') {
                return Some(Value::Table(table));
            }
            before = b',';
        }
    }

    fn digits(&mut self) -> Option<usize> {
        let count = self.while_in(|byte| byte.is_ascii_digit()).len();
        (count > 0).then_some(count)
    }

    /// As TOML has it, which asks for more than Rust does; most of a file is this.
    fn number(&mut self) -> Option<Value<'a>> {
        let start = self.at;
        self.take(b'-');
        let zero = self.peek() == Some(b'0');
        (self.digits()? == 1 || !zero).then_some(())?;
        let end = self.at;
        if self.take(b'.') {
            self.digits()?;
        }
        if self.take(b'e') || self.take(b'E') {
            let _ = self.take(b'-') || self.take(b'+');
            self.digits()?;
        }
        let text = &self.text[start..self.at];
        let number = text.parse().ok()?;
        Some(match self.at == end {
            true => Value::Integer(number, text.parse().ok()),
            false => Value::Float(number),
        })
    }
}

#[cfg(test)]
#[path = "tree_tests.rs"]
mod tests;
