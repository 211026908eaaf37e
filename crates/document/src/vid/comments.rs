//! The user's comments in a `.vid` file, kept when the path is saved.
//!
//! Each comment is kept with the place it is attached to (a key, a table, the end of the file) and
//! put back into the written text there, so that reader and writer need not know of comments.
//!
//! A comment moves, goes and returns with its point. A removed one stays in the list, parked under
//! the number of the removal, so that undo needs no memory.

use std::collections::HashMap;
use std::ops::Range;
use std::sync::Arc;

use crate::error::{Result, can_allocate};
use crate::limits::MAX_FILE_BYTES;
use crate::path::CameraPath;
use vides_engine::property::find;

/// The comments we write ourselves; `#` otherwise only occurs within strings.
pub(super) const OURS: [&str; 3] = [
    "# Frames at speed 50 for a way of half the space's size, a turn of 180 degrees,",
    "# a zoom from 1 to 100, a roll of 90 degrees.",
    "# A cube in the world; which axis stands upright.",
];

/// What a comment is attached to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
struct Place<'a> {
    /// The node of a scene whose table it is.
    node: Option<usize>,
    table: Table,
    /// For tables other than a point's.
    name: &'a str,
    /// What such a table is called, where there may be several: a channel or a name.
    item: &'a str,
    /// Empty for the table's header.
    key: &'a str,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
enum Table {
    /// Before all tables.
    Root,
    Named,
    /// One of several that have no name.
    Item(usize),
    /// A point or, with a second number, one of its orientations.
    Point(usize, Option<usize>),
    /// The end of the file.
    End,
}

#[derive(Debug, Clone)]
struct Comment {
    node: Option<usize>,
    /// The removal that took its node away, as `parked`. It then has the number from before.
    node_parked: u64,
    table: Table,
    name: Arc<str>,
    item: Arc<str>,
    key: Arc<str>,
    /// Whole lines before the place, with the empty lines between them.
    before: Arc<str>,
    /// At the end of the place's line.
    behind: Arc<str>,
    /// The removal that took its place away, counted from 1; 0: it is there.
    parked: u64,
}

impl Comment {
    fn place(&self) -> Place<'_> {
        Place {
            node: self.node,
            table: self.table,
            name: &self.name,
            item: &self.item,
            key: &self.key,
        }
    }

    const fn there(&self) -> bool {
        self.parked == 0 && self.node_parked == 0
    }
}

/// Shifts what is attached to a point for inserted ones, or restores what `removal`, unless 0,
/// parked.
pub(crate) const fn insert_points(
    point: &mut usize,
    parked: &mut u64,
    at: usize,
    count: usize,
    removal: u64,
) {
    if *parked == 0 && *point >= at {
        *point += count;
    } else if *parked == removal && removal != 0 {
        *parked = 0;
        *point += at;
    }
}

/// Shifts what is attached to a point for removed ones, or parks it.
pub(crate) const fn remove_points(
    point: &mut usize,
    parked: &mut u64,
    at: usize,
    count: usize,
    removal: u64,
) {
    if *parked != 0 || *point < at {
    } else if *point >= at + count {
        *point -= count;
    } else {
        *parked = removal;
        *point -= at;
    }
}

/// A file's comments, in the order of their places.
#[derive(Debug, Default)]
pub(crate) struct Comments {
    all: Vec<Comment>,
    removals: u64,
}

impl Comments {
    /// The comments of a text that parses without an error.
    pub(crate) fn of(text: &str) -> Result<Self> {
        let mut comments = Self::default();
        // If every `#` is in a comment of ours there is nothing to keep.
        let marks = text.bytes().filter(|&byte| byte == b'#').count();
        let ours = OURS.iter().filter(|line| text.contains(**line)).count();
        if marks <= ours {
            return Ok(comments);
        }
        // An upper bound: so many comments, together no longer than the text.
        can_allocate(marks.saturating_mul(2 * size_of::<Comment>() + 128) + 2 * text.len())?;
        statements(text, |statement| {
            let before = kept(statement.before) + &kept(&statement.within);
            let behind = statement.behind;
            if !before.is_empty() || !behind.is_empty() {
                let place = statement.place;
                comments.all.push(Comment {
                    node: place.node,
                    node_parked: 0,
                    table: place.table,
                    name: place.name.into(),
                    item: place.item.into(),
                    key: place.key.into(),
                    before: before.into(),
                    behind: behind.into(),
                    parked: 0,
                });
            }
        });
        Ok(comments)
    }

    pub(crate) fn try_clone(&self) -> Result<Self> {
        let mut copy = Self::default();
        copy.all.try_reserve_exact(self.all.len())?;
        let there = self.all.iter().filter(|comment| comment.there());
        copy.all.extend(there.cloned());
        Ok(copy)
    }

    /// Those of a node's path, or of the path alone.
    fn of_path(&mut self, node: Option<usize>) -> impl Iterator<Item = &mut Comment> {
        let all = self.all.iter_mut();
        all.filter(move |comment| comment.node == node && comment.node_parked == 0)
    }

    /// Shifts comments for inserted points and restores those of `removal`, unless 0.
    pub(crate) fn insert_points(
        &mut self,
        node: Option<usize>,
        at: usize,
        count: usize,
        removal: u64,
    ) {
        for comment in self.of_path(node) {
            if let Table::Point(point, _) = &mut comment.table {
                insert_points(point, &mut comment.parked, at, count, removal);
            }
        }
    }

    /// Parks the comments of removed points; returns the number of the removal.
    pub(crate) fn remove_points(&mut self, node: Option<usize>, at: usize, count: usize) -> u64 {
        self.removals += 1;
        let removal = self.removals;
        for comment in self.of_path(node) {
            if let Table::Point(point, _) = &mut comment.table {
                remove_points(point, &mut comment.parked, at, count, removal);
            }
        }
        removal
    }

    /// Shifts comments for inserted nodes, which get these numbers, and restores those of `removal`,
    /// unless 0.
    pub(crate) fn insert_nodes(&mut self, places: &[usize], removal: u64) {
        for comment in &mut self.all {
            let Some(node) = &mut comment.node else {
                continue;
            };
            if comment.node_parked == 0 {
                for &place in places {
                    *node += usize::from(place <= *node);
                }
            } else if comment.node_parked == removal {
                comment.node_parked = 0;
            }
        }
    }

    /// Parks the comments of removed nodes; returns the number of the removal.
    pub(crate) fn remove_nodes(&mut self, places: &[usize]) -> u64 {
        self.removals += 1;
        for comment in self
            .all
            .iter_mut()
            .filter(|comment| comment.node_parked == 0)
        {
            let Some(node) = &mut comment.node else {
                continue;
            };
            match places.binary_search(node) {
                Ok(_) => comment.node_parked = self.removals,
                Err(before) => *node -= before,
            }
        }
        self.removals
    }

    /// Those of a path in a scene of one camera on it.
    pub(crate) fn in_scene(&self) -> Result<Self> {
        let mut comments = self.try_clone()?;
        let of_path = |key: &str| find(CameraPath::PROPERTIES, key).is_some();
        for comment in comments
            .all
            .iter_mut()
            .filter(|comment| comment.node.is_none())
        {
            let name = match (comment.table, &*comment.name) {
                (Table::Point(..), _) => "",
                (Table::Root, _) if of_path(&comment.key) => {
                    comment.table = Table::Named;
                    "node.path"
                }
                (_, "base_speeds") => "node.path.base_speeds",
                (_, "presets") => "node.path.presets",
                _ => continue,
            };
            (comment.node, comment.name) = (Some(0), name.into());
        }
        Ok(comments)
    }

    /// The inverse of [`Comments::in_scene`]; those of the node itself go to the file's head.
    pub(crate) fn of_path_alone(&self) -> Result<Self> {
        let mut comments = self.try_clone()?;
        for comment in comments
            .all
            .iter_mut()
            .filter(|comment| comment.node.is_some())
        {
            comment.node = None;
            let name = match (comment.table, &*comment.name) {
                (Table::Named, "node.path") if !comment.key.is_empty() => {
                    comment.table = Table::Root;
                    ""
                }
                (Table::Named, "node.path.base_speeds") => "base_speeds",
                (Table::Named, "node.path.presets") => "presets",
                (Table::Point(..), _) => "",
                _ => {
                    (comment.table, comment.key) = (Table::Root, "".into());
                    ""
                }
            };
            comment.name = name.into();
        }
        Ok(comments)
    }

    /// Those that are of no node and no point, for another scene.
    pub(crate) fn of_file(&self) -> Result<Self> {
        let mut comments = self.try_clone()?;
        comments
            .all
            .retain(|comment| comment.node.is_none() && !matches!(comment.table, Table::Point(..)));
        Ok(comments)
    }

    pub(crate) fn insert_orientation(
        &mut self,
        node: Option<usize>,
        of: usize,
        at: usize,
        removal: u64,
    ) {
        for comment in self.of_path(node) {
            if let Table::Point(point, Some(number)) = &mut comment.table {
                if comment.parked == 0 && *point == of && *number >= at {
                    *number += 1;
                } else if comment.parked == removal && removal != 0 {
                    comment.parked = 0;
                    (*point, *number) = (of, at);
                }
            }
        }
    }

    pub(crate) fn remove_orientation(&mut self, node: Option<usize>, of: usize, at: usize) -> u64 {
        self.removals += 1;
        let removal = self.removals;
        for comment in self.of_path(node).filter(|comment| comment.parked == 0) {
            if let Table::Point(point, Some(number)) = &mut comment.table
                && *point == of
            {
                match (*number).cmp(&at) {
                    std::cmp::Ordering::Less => {}
                    std::cmp::Ordering::Equal => comment.parked = removal,
                    std::cmp::Ordering::Greater => *number -= 1,
                }
            }
        }
        removal
    }

    pub(super) fn put_into(&self, text: String) -> Result<String> {
        let there = || self.all.iter().filter(|comment| comment.there());
        let sizes = there().map(|comment| comment.before.len() + comment.behind.len() + 2);
        let size = sizes.sum::<usize>() + text.len();
        // Better to lose the comments than to write a file too long to be read.
        if there().next().is_none() || size as u64 > MAX_FILE_BYTES {
            return Ok(text);
        }
        // A statement has at least ten bytes.
        can_allocate(
            (text.len() / 10 + self.all.len()) * 2 * size_of::<(Place<'_>, Range<usize>)>(),
        )?;
        let mut ranges = Vec::new();
        let mut places = HashMap::new();
        statements(&text, |statement| {
            places.insert(statement.place, ranges.len());
            ranges.push(statement.text);
        });
        // If its key is not written a comment goes to its table's header, or its node's, else to the
        // end.
        let home = |comment: &Comment| {
            let key = match comment.table {
                Table::Root => "version",
                _ => "",
            };
            let place = comment.place();
            let own = places.get(&place).map(|&at| (at, true));
            let header = Place { key, ..place };
            let node = Place {
                node: place.node,
                table: Table::Named,
                name: "node",
                item: "",
                key: "",
            };
            let of = |place| places.get(&place).map(|&at| (at, false));
            let home = own.or_else(|| of(header)).or_else(|| of(node));
            home.unwrap_or((ranges.len() - 1, false))
        };
        let mut homes: Vec<_> = there().map(|comment| (home(comment), comment)).collect();
        homes.sort_by_key(|((at, _), _)| *at);
        let mut out = String::new();
        out.try_reserve_exact(size)?;
        let mut copied = 0;
        for here in homes.chunk_by(|((a, _), _), ((b, _), _)| a == b) {
            let Some(range) = here.first().and_then(|((at, _), _)| ranges.get(*at)) else {
                continue;
            };
            out.push_str(&text[copied..range.start]);
            for ((_, own), comment) in here {
                out.push_str(&comment.before);
                if !own {
                    push_line(&mut out, &comment.behind);
                }
            }
            out.push_str(&text[range.clone()]);
            copied = range.end;
            for ((_, own), comment) in here {
                if *own && !comment.behind.is_empty() {
                    out.push(' ');
                    out.push_str(&comment.behind);
                }
            }
        }
        out.push_str(&text[copied..]);
        Ok(out)
    }
}

fn push_line(out: &mut String, line: &str) {
    if !line.is_empty() {
        out.push_str(line);
        out.push('\n');
    }
}

/// The user's comment lines; empty lines only after comments, one at a time.
fn kept(lines: &str) -> String {
    let mut kept = String::new();
    for line in lines.lines().map(str::trim) {
        let again = line.is_empty() && (kept.is_empty() || kept.ends_with("\n\n"));
        if !again && !OURS.contains(&line) {
            kept.push_str(line);
            kept.push('\n');
        }
    }
    kept
}

/// A key with its value, a header, or the end of the text.
struct Statement<'a> {
    place: Place<'a>,
    /// Empty at the end of the text.
    text: Range<usize>,
    before: &'a str,
    /// Comments within its value, one per line.
    within: String,
    /// The comment after it on its line.
    behind: &'a str,
}

fn statements<'a>(text: &'a str, mut each: impl FnMut(Statement<'a>)) {
    let bytes = text.as_bytes();
    let line_end = |from: usize| {
        let rest = bytes.get(from..).unwrap_or_default();
        from + rest
            .iter()
            .position(|&byte| byte == b'\n')
            .unwrap_or(rest.len())
    };
    let mut here = Header {
        node: None,
        table: Table::Root,
        name: "",
        item: "",
    };
    let mut last_node = None;
    let mut at = 0;
    loop {
        let begin = at;
        loop {
            let rest = &text[at..];
            let line = rest.trim_start_matches([' ', '\t', '\r']);
            match line.as_bytes().first() {
                Some(b'#' | b'\n') => at = (line_end(at) + 1).min(text.len()),
                // A byte order mark.
                _ if at == 0 && rest.starts_with('\u{feff}') => at = '\u{feff}'.len_utf8(),
                _ => break,
            }
        }
        let before = &text[begin..at];
        let (end, within) = end_of_statement(text, at);
        let words = text[at..end].trim();
        let key = if words.is_empty() {
            here = Header {
                node: None,
                table: Table::End,
                name: "",
                item: "",
            };
            ""
        } else if let Some(header) = words.strip_prefix('[') {
            here = here.next(header, &text[end..], &mut last_node);
            ""
        } else {
            let key = words.split('=').next().unwrap_or_default();
            slot(key.trim().trim_matches(['"', '\'']))
        };
        let next = line_end(end);
        each(Statement {
            place: here.place(key),
            text: at..end,
            before,
            within,
            behind: text[end..next].trim(),
        });
        if here.table == Table::End {
            return;
        }
        at = (next + 1).min(text.len());
    }
}

/// Maps mutually exclusive keys of a table to one place.
fn slot(key: &str) -> &str {
    match key {
        "own" => "preset",
        "offset" => "target",
        other => other,
    }
}

/// The table in which a statement stands; see [`Place`].
#[derive(Clone, Copy)]
struct Header<'a> {
    node: Option<usize>,
    table: Table,
    name: &'a str,
    item: &'a str,
}

impl<'a> Header<'a> {
    const fn place(self, key: &'a str) -> Place<'a> {
        Place {
            node: self.node,
            table: self.table,
            name: self.name,
            item: self.item,
            key,
        }
    }

    /// The table that a header, without its first bracket, begins before `rest`.
    fn next(self, header: &'a str, rest: &'a str, nodes: &mut Option<usize>) -> Self {
        let name = header.trim_matches(['[', ']', ' ', '\t']);
        if name == "node" {
            *nodes = Some(nodes.map_or(0, |node| node + 1));
        }
        let node = nodes.filter(|_| name == "node" || name.starts_with("node."));
        let last = Some(self.table).filter(|_| self.node == node);
        let (table, name, item) = match (name, last) {
            ("point" | "node.path.point", Some(Table::Point(point, _))) => {
                (Table::Point(point + 1, None), "", "")
            }
            ("point" | "node.path.point", _) => (Table::Point(0, None), "", ""),
            (
                "point.orientation" | "node.path.point.orientation",
                Some(Table::Point(point, number)),
            ) => {
                let number = number.map_or(0, |number| number + 1);
                (Table::Point(point, Some(number)), "", "")
            }
            ("node.deformation", Some(Table::Item(number))) => (Table::Item(number + 1), name, ""),
            ("node.deformation", _) => (Table::Item(0), name, ""),
            ("node.track", _) => (Table::Named, name, value_of_key(rest, "channel")),
            ("node.shape" | "marker", _) => (Table::Named, name, value_of_key(rest, "name")),
            _ => (Table::Named, name, ""),
        };
        Self {
            node,
            table,
            name,
            item,
        }
    }
}

/// What follows a key in a table, without quotes; empty if it is not there.
fn value_of_key<'a>(table: &'a str, key: &str) -> &'a str {
    for line in table.lines().map(str::trim_start) {
        if line.starts_with("[[") || line.starts_with("[node") {
            break;
        }
        let value = line.strip_prefix(key).map(str::trim_start);
        if let Some(value) = value.and_then(|value| value.strip_prefix('=')) {
            let value = value.trim_start();
            let end = match value.as_bytes().first() {
                Some(b'"' | b'\'') => end_of_text(value.as_bytes(), 0),
                _ => value.find('#').unwrap_or(value.len()),
            };
            return value[..end].trim().trim_matches(['"', '\'']);
        }
    }
    ""
}

/// The end of the statement at `at`, without trailing blanks and comments, and those within it.
fn end_of_statement(text: &str, mut at: usize) -> (usize, String) {
    let bytes = text.as_bytes();
    let (mut end, mut depth, mut within) = (at, 0, String::new());
    while let Some(&byte) = bytes.get(at) {
        match byte {
            b'\n' if depth == 0 => break,
            b'#' => {
                let rest = &text[at..];
                let line = rest.lines().next().unwrap_or(rest);
                if depth == 0 {
                    break;
                }
                within.push_str(line);
                within.push('\n');
                at += line.len();
                continue;
            }
            b'"' | b'\'' => at = end_of_text(bytes, at) - 1,
            b'[' | b'{' => depth += 1,
            b']' | b'}' => depth -= 1,
            _ => {}
        }
        at += 1;
        if !byte.is_ascii_whitespace() {
            end = at;
        }
    }
    (end, within)
}

/// The end of the string literal that begins at `at`.
fn end_of_text(bytes: &[u8], at: usize) -> usize {
    let quote = bytes[at];
    let rest = &bytes[at..];
    let long = rest.starts_with(&[quote; 3]);
    let mut place = if long { 3 } else { 1 };
    while let Some(&byte) = rest.get(place) {
        if byte == b'\\' && quote == b'"' {
            place += 2;
            continue;
        }
        let over = if long {
            rest[place..].starts_with(&[quote; 3])
        } else {
            byte == quote
        };
        if over {
            place += if long { 3 } else { 1 };
            // Up to two quotes before the closing three belong to the string.
            while long && rest.get(place) == Some(&quote) {
                place += 1;
            }
            break;
        }
        place += 1;
    }
    at + place.min(rest.len())
}

#[cfg(test)]
#[path = "comments_tests.rs"]
mod tests;
