//! From the text of a file to its tree and its comments, in one pass.
//!
//! Tokens, keys, strings and numbers are read by `toml_parser`. The trees of `toml` have no comments,
//! and take some twenty times the memory of a text; so it is asked only about a statement that is no
//! TOML, which it puts into words. The memory that our trees take is counted while they are built.
//!
//! A file is read in pieces, each with its own tree, which so stays in the cache. A piece ends before
//! a point or a node, and what follows does not depend on it, except for keys given twice, which the
//! reader checks.

use std::borrow::Cow;
use std::mem::{replace, size_of, take};
use std::ops::Range;

use toml::de::DeTable;
use toml_parser::lexer::TokenKind;
use toml_parser::{ParseError, Span};

use super::field::Source;
use super::scalar;
use super::statements::{self, Statement, Within, slot};
use super::tokens::{Stop, Tokens};
use super::tree::{Key, Made, Placed, Table, Value};
use crate::error::{EngineError, Error, Malformed, Result, can_allocate};
use vides_engine::limits::{MAX_FILE_BYTES, MAX_TREE_BYTES};

/// Minimum bytes of a piece; small for the fuzzer, so that its files are cut too.
const PIECE: usize = if cfg!(fuzzing) { 256 } else { 128 << 10 };

const CUTS: [&str; 2] = ["[[point]]", "[[node]]"];

/// Arrays within arrays, tables within tables and names of a key, at the most.
const DEPTH: usize = 80;

/// Bytes that an allocation takes besides what it holds.
const ALLOCATION: usize = 16;

/// Bytes for an element while its list grows: lists double.
const ELEMENT: usize = 2 * size_of::<Placed<'static>>();

/// Bytes for a key and its value; the nodes of a table's tree are half full at least.
const ENTRY: usize = 3 * size_of::<(Cow<'static, str>, Placed<'static>)>();

/// Bytes for the first node of a table's tree, which has room for eleven.
const NODE: usize = 12 * size_of::<(Cow<'static, str>, Placed<'static>)>() + 5 * ALLOCATION;

/// No byte of a text takes more than this.
const MOST: usize = NODE + ENTRY;

/// Bytes that are known to be there before they are taken, since tables cannot be refused them.
const GRANT: usize = 64 << 10;

/// Which statements are kept, besides the tree.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Keep {
    Nothing,
    Commented,
    All,
}

fn no_memory<E>(_: E) -> Stop {
    Some(EngineError::Memory.into())
}

pub(super) struct Parser<'a> {
    tokens: Tokens<'a>,
    /// Where the piece, the text before the statement and the statement itself begin.
    piece: usize,
    begin: usize,
    start: usize,
    /// Bytes that a piece may still take, and those of them that are known to be there.
    left: usize,
    granted: usize,
    most: usize,
    root: Table<'a>,
    /// Where in it the table is that is being read.
    header: Vec<Key<'a>>,
    place: Within<'a>,
    keep: Keep,
    statements: Vec<Statement<'a>>,
    /// The first one of the table.
    of_table: usize,
    within: String,
}

/// The tree of a text of one piece, if that takes no more than `most` bytes of memory.
///
/// # Errors
/// `ErrorKind::Format` with line and reason, `Limit`, `Memory`.
pub fn table(text: &str, most: usize) -> Result<Table<'_>> {
    let mut parser = Parser::new(text);
    parser.most = most;
    parser.piece()
}

/// Every statement of a text.
pub(super) fn statements(text: &str) -> Result<Vec<Statement<'_>>> {
    let mut parser = Parser::new(text);
    parser.keep = Keep::All;
    while !parser.is_done() {
        parser.piece()?;
    }
    Ok(parser.statements)
}

/// A text that we have written, if it can be read again.
///
/// # Errors
/// [`Error::FileTooLarge`], [`Error::PieceTooLarge`].
pub(super) fn readable(text: String) -> Result<String> {
    if text.len() as u64 > MAX_FILE_BYTES {
        return Err(Error::FileTooLarge(MAX_FILE_BYTES >> 20));
    }
    each_fits(&text, MAX_TREE_BYTES).map(|()| text)
}

/// Whether each piece can be read within a limit of bytes.
fn each_fits(text: &str, most: usize) -> Result<()> {
    let parts = text.split("\n[[node]]");
    let mut parts = parts.flat_map(|part| part.split("\n[[point]]"));
    // What is short cannot take so much.
    if parts.all(|part| part.len() + PIECE <= most / MOST) {
        return Ok(());
    }
    let mut parser = Parser::new(text);
    (parser.keep, parser.most) = (Keep::Nothing, most);
    while !parser.is_done() {
        parser.piece()?;
    }
    Ok(())
}

impl<'a> Parser<'a> {
    pub(super) fn new(text: &'a str) -> Self {
        let tokens = Tokens::of(text);
        Self {
            begin: tokens.at,
            start: tokens.at,
            tokens,
            piece: 0,
            left: 0,
            granted: 0,
            most: MAX_TREE_BYTES,
            root: Table::default(),
            header: Vec::new(),
            place: Within::outside(statements::Table::Root),
            keep: Keep::Commented,
            statements: Vec::new(),
            of_table: 0,
            within: String::new(),
        }
    }

    /// Whether the whole text has been read.
    pub(super) fn is_done(&self) -> bool {
        self.place.table == statements::Table::End
    }

    /// The statements that have comments.
    pub(super) fn into_statements(self) -> Vec<Statement<'a>> {
        self.statements
    }

    /// The tree of the next piece.
    pub(super) fn piece(&mut self) -> Result<Table<'a>> {
        self.piece = self.begin;
        (self.left, self.granted) = (self.most, 0);
        loop {
            match self.statement() {
                Ok(true) => {}
                Ok(false) => return Ok(take(&mut self.root)),
                Err(Some(error)) => return Err(error),
                Err(None) => return Err(self.in_words()),
            }
        }
    }

    /// What the crate `toml` says of the text so far, or of the statement if that is long.
    fn in_words(&mut self) -> Error {
        let (text, end) = (self.tokens.text, self.tokens.end_of_next());
        // What follows on the line may say it better.
        let end = text[end..]
            .find('\n')
            .map_or(text.len(), |line| end + line + 1);
        let bytes = |from: usize| (end - from).saturating_mul(MOST).saturating_add(GRANT);
        let long = |from: usize| bytes(from) > MAX_TREE_BYTES;
        let from = if long(self.piece) {
            self.start
        } else {
            self.piece
        };
        // That crate cannot be refused memory.
        let faults = match can_allocate(bytes(from).min(MAX_TREE_BYTES)) {
            Err(error) => return error.into(),
            Ok(()) if long(from) => Vec::new(),
            Ok(()) => DeTable::parse_recoverable(&text[from..end]).1,
        };
        // The text is cut behind that, so that brackets may be open there.
        let cut = |fault: &toml::de::Error| {
            let words = fault.message();
            words.starts_with("unclosed array,") || words.starts_with("unclosed inline")
        };
        let first = faults.iter().find(|fault| !cut(fault)).or(faults.first());
        let (at, words) = first.map_or((end, "unexpected content"), |fault| {
            let offset = fault.span().map_or(0, |span| span.start);
            (from + offset, fault.message())
        });
        Source { text }.complain(at, Malformed::Toml(words.into()))
    }

    fn dear(&self) -> Error {
        let source = Source {
            text: self.tokens.text,
        };
        Error::PieceTooLarge(source.line(self.piece))
    }

    /// Counts memory that will be taken.
    fn pay(&mut self, bytes: usize) -> Result<()> {
        let left = self.left.checked_sub(bytes);
        self.left = left.ok_or_else(|| self.dear())?;
        if self.granted < bytes {
            can_allocate(bytes + GRANT)?;
            self.granted = bytes + GRANT;
        }
        self.granted -= bytes;
        Ok(())
    }

    /// Passes blanks, ends of lines and comments.
    fn blank(&mut self) -> Result<(), Stop> {
        loop {
            match self.tokens.kind() {
                TokenKind::Whitespace => {
                    self.tokens.next();
                }
                TokenKind::Newline => self.tokens.newline()?,
                TokenKind::Comment => {
                    let comment = self.tokens.comment()?;
                    if self.keep != Keep::Nothing {
                        self.within
                            .try_reserve(comment.len() + 1)
                            .map_err(no_memory)?;
                        self.within.push_str(comment);
                        self.within.push('\n');
                    }
                }
                _ => return Ok(()),
            }
        }
    }

    /// Passes the end of a statement's line; the comment there.
    fn end_of_line(&mut self) -> Result<&'a str, Stop> {
        self.tokens.takes(TokenKind::Whitespace);
        let comment = match self.tokens.kind() {
            TokenKind::Comment => self.tokens.comment()?,
            _ => "",
        };
        match self.tokens.kind() {
            TokenKind::Newline => self.tokens.newline()?,
            TokenKind::Eof => {}
            _ => return Err(None),
        }
        Ok(comment.trim_end())
    }

    /// Reads a statement; false at the end of the piece.
    fn statement(&mut self) -> Result<bool, Stop> {
        self.blank()?;
        let (start, before) = (self.tokens.offset(), self.begin..self.tokens.line);
        self.start = start;
        self.within.clear();
        if self.tokens.kind() == TokenKind::Eof {
            self.end_of_table();
            self.place = Within::outside(statements::Table::End);
            let end = self.tokens.text.len();
            self.keep_statement("", end..end, self.begin..end, "")?;
            return Ok(false);
        }
        let here = &self.tokens.text[start..];
        if start - self.piece >= PIECE && CUTS.iter().any(|cut| here.starts_with(cut)) {
            self.end_of_table();
            return Ok(false);
        }
        let key = match self.tokens.kind() {
            TokenKind::LeftSquareBracket => self.header(start)?,
            _ => {
                let (path, key, name) = self.keys(0)?;
                self.tokens.takes(TokenKind::Whitespace);
                self.tokens.wants(TokenKind::Equals)?;
                self.tokens.takes(TokenKind::Whitespace);
                let value = self.value(0)?;
                self.pay_for(&path)?;
                let table = self.root.descend(&self.header, Made::Below);
                let table = table.ok_or(None)?;
                table.put(&path, key, value, Made::Dotted).ok_or(None)?;
                slot(name)
            }
        };
        let text = start..self.tokens.at;
        let behind = self.end_of_line()?;
        self.keep_statement(key, text, before, behind)?;
        (self.begin, self.start) = (self.tokens.at, self.tokens.at);
        Ok(true)
    }

    fn keep_statement(
        &mut self,
        key: &'a str,
        text: Range<usize>,
        before: Range<usize>,
        behind: &'a str,
    ) -> Result<(), Stop> {
        let before = self.tokens.text.get(before).unwrap_or("");
        let commented = !behind.is_empty() || !self.within.is_empty() || before.contains('#');
        if self.keep == Keep::All || self.keep == Keep::Commented && commented {
            self.pay(2 * size_of::<Statement<'_>>() + 2 * self.within.len())?;
            self.statements.try_reserve(1).map_err(no_memory)?;
            self.statements.push(Statement {
                place: self.place.place(key),
                text,
                before,
                within: take(&mut self.within),
                behind,
            });
        }
        Ok(())
    }

    fn header(&mut self, start: usize) -> Result<&'a str, Stop> {
        self.tokens.next();
        let repeated = self.tokens.takes(TokenKind::LeftSquareBracket);
        self.tokens.takes(TokenKind::Whitespace);
        let (path, key, name) = self.keys(0)?;
        self.tokens.takes(TokenKind::Whitespace);
        self.tokens.wants(TokenKind::RightSquareBracket)?;
        if repeated {
            self.tokens.wants(TokenKind::RightSquareBracket)?;
        }
        self.end_of_table();
        self.pay(NODE + ELEMENT)?;
        self.pay_for(&path)?;
        let element = repeated.then_some(start);
        self.root.begin(&path, key.clone(), element).ok_or(None)?;
        self.header = path;
        self.header.push(key);
        self.place = self.place.next(name);
        Ok("")
    }

    /// Names the comments of the table that has been read by what tells it apart.
    fn end_of_table(&mut self) {
        let from = replace(&mut self.of_table, self.statements.len());
        let statements = &mut self.statements[from..];
        let Some(key) = self.place.item_key().filter(|_| !statements.is_empty()) else {
            return;
        };
        let table = self.root.descend(&self.header, Made::Below);
        let item = table.and_then(|table| table.entries.get(key));
        if let Some((_, Value::Text(item))) = item {
            for statement in statements {
                statement.place.item = item.clone();
            }
        }
    }

    /// For a key and the tables on its way.
    fn pay_for(&mut self, path: &[Key<'a>]) -> Result<()> {
        self.pay(ENTRY + path.len() * MOST)
    }

    /// The names of a key with dots, the last apart, and all as it is written.
    fn keys(&mut self, depth: usize) -> Result<(Vec<Key<'a>>, Key<'a>, &'a str), Stop> {
        let (mut path, mut last) = (Vec::new(), self.key()?);
        let start = last.0;
        loop {
            let name = &self.tokens.text[start..self.tokens.at];
            self.tokens.takes(TokenKind::Whitespace);
            if !self.tokens.takes(TokenKind::Dot) {
                return Ok((path, last, name));
            }
            self.tokens.takes(TokenKind::Whitespace);
            let next = self.key()?;
            path.push(replace(&mut last, next));
            if path.len() + depth >= DEPTH {
                return Err(None);
            }
        }
    }

    fn key(&mut self) -> Result<Key<'a>, Stop> {
        let kind = self.tokens.kind();
        let start = self.tokens.offset();
        if kind != TokenKind::Atom && kind.encoding().is_none() {
            return Err(None);
        }
        let span = self.tokens.next();
        let (mut key, mut wrong) = (Cow::Borrowed(""), None::<ParseError>);
        self.pay_for_text(span, kind)?;
        self.tokens.raw(span, kind).decode_key(&mut key, &mut wrong);
        match wrong {
            None => Ok((start, key)),
            Some(_) => Err(None),
        }
    }

    /// What is not a part of the file's text is a copy, and one message describes it.
    fn pay_for_text(&mut self, span: Span, kind: TokenKind) -> Result<()> {
        let copied = kind.encoding().is_some() || span.len() > 40;
        self.pay(if copied {
            4 * span.len() + ALLOCATION
        } else {
            0
        })
    }

    fn value(&mut self, depth: usize) -> Result<Value<'a>, Stop> {
        match self.tokens.kind() {
            TokenKind::LeftSquareBracket if depth < DEPTH => self.array(depth + 1),
            TokenKind::LeftCurlyBracket if depth < DEPTH => self.inline(depth + 1),
            TokenKind::Atom | TokenKind::Dot => self.scalar(),
            kind if kind.encoding().is_some() => self.scalar(),
            _ => Err(None),
        }
    }

    fn array(&mut self, depth: usize) -> Result<Value<'a>, Stop> {
        self.tokens.next();
        let mut elements = Vec::new();
        let mut count = 0;
        // A list begins with room for four.
        self.pay(4 * ELEMENT + ALLOCATION)?;
        loop {
            self.blank()?;
            if self.tokens.takes(TokenKind::RightSquareBracket) {
                elements.shrink_to_fit();
                // What was counted and is not needed.
                self.left += 4 * ELEMENT + count * (ELEMENT - size_of::<Placed<'_>>());
                return Ok(Value::Array(elements));
            }
            self.pay(ELEMENT)?;
            count += 1;
            let element = (self.tokens.offset(), self.value(depth)?);
            if self.keep == Keep::Commented {
                elements.try_reserve(1).map_err(no_memory)?;
                elements.push(element);
            }
            self.blank()?;
            if !self.tokens.takes(TokenKind::Comma)
                && self.tokens.kind() != TokenKind::RightSquareBracket
            {
                return Err(None);
            }
        }
    }

    fn inline(&mut self, depth: usize) -> Result<Value<'a>, Stop> {
        self.tokens.next();
        let mut table = Table::new(Made::Inline);
        self.pay(NODE)?;
        loop {
            self.blank()?;
            if self.tokens.takes(TokenKind::RightCurlyBracket) {
                return Ok(Value::Table(table));
            }
            let (path, key, _) = self.keys(depth)?;
            self.blank()?;
            self.tokens.wants(TokenKind::Equals)?;
            self.blank()?;
            let value = self.value(depth)?;
            self.pay_for(&path)?;
            table
                .put(&path, key, value, Made::InlineDotted)
                .ok_or(None)?;
            self.blank()?;
            if !self.tokens.takes(TokenKind::Comma)
                && self.tokens.kind() != TokenKind::RightCurlyBracket
            {
                return Err(None);
            }
        }
    }

    /// A text, a number, a switch or a date.
    fn scalar(&mut self) -> Result<Value<'a>, Stop> {
        let (kind, span) = self.tokens.scalar();
        self.pay_for_text(span, kind)?;
        scalar::value(self.tokens.raw(span, kind)).ok_or(None)
    }
}

#[cfg(test)]
#[path = "parse_tests.rs"]
mod tests;
