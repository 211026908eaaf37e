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

/// Whether there is memory for one more.
fn room<T>(entries: &mut Vec<T>) -> Option<()> {
    entries.try_reserve(1).ok()
}

impl<'a> Table<'a> {
    fn find(&self, (_, key): Key<'a>) -> Result<usize, usize> {
        self.entries
            .binary_search_by(|(other, _)| (**other).cmp(key))
    }

    /// None if it has the key, or very many others.
    fn insert(&mut self, key: Key<'a>, value: Value<'a>) -> Option<()> {
        let at = self.find(key).err()?;
        // Each insertion moves what is behind it.
        if self.entries.len() == KEYS {
            return None;
        }
        room(&mut self.entries)?;
        let entry = (Cow::Borrowed(key.1), (key.0, value));
        self.entries.insert(at, entry);
        Some(())
    }

    fn get(&mut self, key: Key<'a>) -> Option<&mut Value<'a>> {
        let at = self.find(key).ok()?;
        Some(&mut self.entries[at].1.1)
    }

    /// Puts what follows a header where it says; None if something else is there.
    fn attach(&mut self, header: &Header<'a>, mut table: Table<'a>) -> Option<()> {
        let last = header.name.rfind('.').map_or(0, |dot| dot + 1);
        let (before, name) = header.name.split_at(last);
        let last = (header.at + last, name);
        let (mut parent, mut at) = (self, header.at);
        for name in before.split_terminator('.') {
            let key = (at, name);
            at += name.len() + 1;
            if parent.get(key).is_none() {
                let open = true;
                let entries = Vec::new();
                parent.insert(key, Value::Table(Table { entries, open }))?;
            }
            parent = match parent.get(key)? {
                Value::Table(table) => table,
                Value::Array(elements) => match &mut elements.last_mut()?.1 {
                    Value::Table(table) => table,
                    _ => return None,
                },
                _ => return None,
            };
            if !parent.open {
                return None;
            }
        }
        table.open = true;
        if !header.repeated {
            return parent.insert(last, Value::Table(table));
        }
        let element = (header.offset, Value::Table(table));
        let new = parent.find(last).is_err();
        if new {
            parent.insert(last, Value::Array(Vec::new()))?;
        }
        let Value::Array(elements) = parent.get(last)? else {
            return None;
        };
        // An array that stands behind a key is not added to.
        let open = matches!(elements.last(), Some((_, Value::Table(table))) if table.open);
        if !new && !open {
            return None;
        }
        room(elements)?;
        elements.push(element);
        Some(())
    }
}

/// Byte offset and name.
type Key<'a> = (usize, &'a str);

/// `[a.b]` or `[[a.b]]`.
struct Header<'a> {
    offset: usize,
    /// Byte offset of the name.
    at: usize,
    name: &'a str,
    repeated: bool,
}

/// Arrays within arrays and tables within tables, at the most.
const DEPTH: usize = 8;

/// Keys of a table, at the most: more than there are.
const KEYS: usize = 64;

/// The tree of a text that is written plainly; None if it is not, or there is no memory.
pub(super) fn read(text: &str) -> Option<Table<'_>> {
    let mut plain = Plain { text, at: 0 };
    let mut root = Table::default();
    let mut table = Table::default();
    let mut header = None;
    loop {
        plain.blank()?;
        let next = plain.peek();
        if !matches!(next, None | Some(b'[')) {
            let (key, value) = plain.pair(DEPTH)?;
            table.insert(key, value)?;
            plain.end_of_line()?;
            continue;
        }
        let done = std::mem::take(&mut table);
        match &header {
            None => root = done,
            Some(header) => root.attach(header, done)?,
        }
        if next.is_none() {
            return Some(root);
        }
        header = Some(plain.header()?);
        plain.end_of_line()?;
    }
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
        let offset = self.at;
        let key = self.while_in(bare);
        (!key.is_empty()).then_some((offset, key))
    }

    fn header(&mut self) -> Option<Header<'a>> {
        let offset = self.at;
        self.at += 1;
        let repeated = self.take(b'[');
        let at = self.at;
        let name = self.while_in(|byte| bare(byte) || byte == b'.');
        let depth = name.split('.').count();
        let plain = depth <= DEPTH && !name.split('.').any(str::is_empty);
        let closed = self.take(b']') && (!repeated || self.take(b']'));
        (plain && closed).then_some(Header {
            offset,
            at,
            name,
            repeated,
        })
    }

    fn pair(&mut self, depth: usize) -> Option<(Key<'a>, Value<'a>)> {
        let key = self.key()?;
        self.spaces();
        if !self.take(b'=') {
            return None;
        }
        self.spaces();
        Some((key, self.value(depth)?))
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
            let offset = self.at;
            let value = self.value(depth)?;
            room(&mut elements)?;
            elements.push((offset, value));
            self.blank()?;
            if !self.take(b',') && self.peek() != Some(b']') {
                return None;
            }
        }
    }

    fn inline(&mut self, depth: usize) -> Option<Value<'a>> {
        self.at += 1;
        let mut table = Table::default();
        loop {
            self.spaces();
            let (key, value) = self.pair(depth)?;
            table.insert(key, value)?;
            self.spaces();
            if self.take(b'}') {
                return Some(Value::Table(table));
            }
            if !self.take(b',') {
                return None;
            }
        }
    }

    /// As TOML has it, which asks for more than Rust does; most of a file is this.
    fn number(&mut self) -> Option<Value<'a>> {
        let start = self.at;
        self.take(b'-');
        let first = self.peek();
        let digits = self.while_in(|byte| byte.is_ascii_digit()).len();
        if digits == 0 || (digits > 1 && first == Some(b'0')) {
            return None;
        }
        let mut whole = true;
        if self.take(b'.') {
            whole = false;
            if self.while_in(|byte| byte.is_ascii_digit()).is_empty() {
                return None;
            }
        }
        if self.take(b'e') || self.take(b'E') {
            whole = false;
            let _ = self.take(b'-') || self.take(b'+');
            if self.while_in(|byte| byte.is_ascii_digit()).is_empty() {
                return None;
            }
        }
        let text = &self.text[start..self.at];
        let number = text.parse().ok()?;
        Some(if whole {
            Value::Integer(number, text.parse().ok())
        } else {
            Value::Float(number)
        })
    }
}

#[cfg(test)]
#[path = "tree_tests.rs"]
mod tests;
