//! What stands in a piece of a file: keys and values, and where.
//!
//! The parser lists all tokens, then all events, then builds a tree of strings; that was two thirds
//! of the time that a file took. What is written as we write it ourselves (bare keys, numbers in
//! base ten, strings with the escapes that we write) is therefore read here in one go, numbers as numbers. Whatever
//! else there is, errors above all, is left to the parser, so that only it says what is wrong.

use std::borrow::Cow;
use std::mem::size_of;

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

/// Bytes that an allocation takes besides what it holds.
const ALLOCATION: usize = 16;

/// Bytes for an element while its list grows: lists double.
const ELEMENT: usize = 2 * size_of::<Placed<'static>>();

/// Bytes for a key and its value, in a list of four at least.
const ENTRY: usize = 2 * size_of::<(Cow<'static, str>, Placed<'static>)>();

/// No byte of a text takes more than this: an array is two at least, a key and its value four.
pub(super) const MOST: usize = 5 * ELEMENT;

/// What comes of reading a text here.
#[derive(Debug)]
pub(super) enum Reading<'a> {
    Plain(Table<'a>),
    /// It is not written plainly.
    Other,
    /// It would take more than it may.
    Dear,
    NoMemory,
}

/// The tree of a text that is written plainly, within a limit of bytes.
pub(super) fn read(text: &str, most: usize) -> Reading<'_> {
    let mut plain = Plain::new(text, most);
    match plain.whole() {
        Some(table) => Reading::Plain(table),
        None if plain.dear => Reading::Dear,
        None if plain.no_memory => Reading::NoMemory,
        None => Reading::Other,
    }
}

/// Whether a text that we have written can be read again within a limit of bytes; nothing is kept
/// of it meanwhile.
pub(super) fn fits(text: &str, most: usize) -> bool {
    let mut plain = Plain::new(text, most);
    plain.only_counts = true;
    plain.whole().is_some() || !plain.dear
}

fn bare(byte: u8) -> bool {
    byte.is_ascii_alphanumeric() || matches!(byte, b'_' | b'-')
}

struct Plain<'a> {
    text: &'a str,
    at: usize,
    /// Bytes that may still be taken.
    left: usize,
    /// They did not suffice.
    dear: bool,
    no_memory: bool,
    /// Elements of arrays are not kept.
    only_counts: bool,
}

impl<'a> Plain<'a> {
    fn new(text: &'a str, most: usize) -> Self {
        Self {
            text,
            at: 0,
            left: most,
            dear: false,
            no_memory: false,
            only_counts: false,
        }
    }

    fn whole(&mut self) -> Option<Table<'a>> {
        let plain = self;
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
            plain.take_memory(ENTRY + ELEMENT)?;
            root.attach(name, repeated, table)?;
        }
        Some(root)
    }

    /// Counts memory that will be taken.
    fn take_memory(&mut self, bytes: usize) -> Option<()> {
        self.left = self.left.checked_sub(bytes).or_else(|| {
            self.dear = true;
            None
        })?;
        Some(())
    }

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

    /// The text before the next header.
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
        let first = if into.entries.is_empty() { 4 } else { 0 };
        self.take_memory(ENTRY * (1 + first) + ALLOCATION)?;
        into.insert(key, self.value(depth)?)
    }

    fn value(&mut self, depth: usize) -> Option<Value<'a>> {
        match self.peek()? {
            b'"' => self.quoted().map(Value::Text),
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
        let mut count = 0;
        // A list begins with room for four.
        self.take_memory(4 * ELEMENT + ALLOCATION)?;
        loop {
            self.blank()?;
            if self.take(b']') {
                elements.shrink_to_fit();
                // What was counted and is not needed.
                self.left += 4 * ELEMENT + count * (ELEMENT - size_of::<Placed<'_>>());
                return Some(Value::Array(elements));
            }
            self.take_memory(ELEMENT)?;
            count += 1;
            let element = (self.at, self.value(depth)?);
            if !self.only_counts && push(&mut elements, element).is_none() {
                self.no_memory = true;
                return None;
            }
            self.blank()?;
            (self.take(b',') || self.peek() == Some(b']')).then_some(())?;
        }
    }

    /// A string in double quotes, on one line or, in three of them, on several.
    fn quoted(&mut self) -> Option<Cow<'a, str>> {
        self.at += 1;
        let long = self.rest().starts_with("\"\"");
        if long {
            self.at += 2;
            // The line break after the opening quotes is not part of the string.
            self.take(b'\n');
        }
        let (mut start, mut before) = (self.at, None);
        let inside = |byte: u8| {
            byte == b'\t'
                || long && byte == b'\n'
                || byte >= b' ' && !matches!(byte, b'"' | b'\\' | 0x7f)
        };
        loop {
            self.while_in(inside);
            match self.peek()? {
                b'\\' => {
                    let text: &mut String = before.get_or_insert_default();
                    self.take_memory(2 * (self.at - start + 4) + ALLOCATION)?;
                    text.try_reserve(self.at - start + 4).ok()?;
                    text.push_str(self.text.get(start..self.at)?);
                    text.push(self.escaped()?);
                    start = self.at;
                }
                b'"' if long && !self.rest().starts_with("\"\"") => self.at += 1,
                b'"' => break,
                _ => return None,
            }
        }
        let rest = self.text.get(start..self.at)?;
        let closed = self.take(b'"') && (!long || self.take(b'"') && self.take(b'"'));
        if !closed || self.peek() == Some(b'"') {
            return None;
        }
        Some(match before {
            None => Cow::Borrowed(rest),
            Some(mut text) => {
                self.take_memory(2 * rest.len())?;
                text.try_reserve(rest.len()).ok()?;
                text.push_str(rest);
                Cow::Owned(text)
            }
        })
    }

    fn rest(&self) -> &'a str {
        self.text.get(self.at..).unwrap_or("")
    }

    /// What stands for a character, as we write it.
    fn escaped(&mut self) -> Option<char> {
        self.at += 1;
        let kind = self.peek()?;
        self.at += 1;
        match kind {
            b'"' | b'\\' => Some(kind.into()),
            b'n' => Some('\n'),
            b't' => Some('\t'),
            b'r' => Some('\r'),
            b'u' => {
                let digits = self.text.get(self.at..self.at + 4)?;
                self.at += 4;
                let hexadecimal = digits.bytes().all(|byte| byte.is_ascii_hexdigit());
                let code = u32::from_str_radix(digits, 16).ok().filter(|_| hexadecimal);
                code.and_then(char::from_u32)
            }
            _ => None,
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

    /// A number by TOML's rules, which are stricter than Rust's; most of a file is numbers.
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
