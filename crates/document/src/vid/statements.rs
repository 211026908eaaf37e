//! The statements of a `.vid` file's text, with the places to which comments are attached.

use std::ops::Range;

/// What a comment is attached to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) struct Place<'a> {
    /// The node of a scene whose table it is.
    pub(super) node: Option<usize>,
    pub(super) table: Table,
    /// For tables other than a point's.
    pub(super) name: &'a str,
    /// What such a table is called, where there may be several: a channel or a name.
    pub(super) item: &'a str,
    /// Empty for the table's header.
    pub(super) key: &'a str,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) enum Table {
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

/// A key with its value, a header, or the end of the text.
pub(super) struct Statement<'a> {
    pub(super) place: Place<'a>,
    /// Empty at the end of the text.
    pub(super) text: Range<usize>,
    pub(super) before: &'a str,
    /// Comments within its value, one per line.
    pub(super) within: String,
    /// The comment after it on its line.
    pub(super) behind: &'a str,
}

/// Every statement of a text.
pub(super) fn statements<'a>(text: &'a str, mut each: impl FnMut(Statement<'a>)) {
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

/// What follows a key in a table, without quotes; empty if it is missing.
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
