//! The statements of a `.vid` file's text, with the places to which comments are attached.

use std::borrow::Cow;
use std::ops::Range;

/// What a comment is attached to.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub(super) struct Place<'a> {
    /// The node of a scene whose table it is.
    pub(super) node: Option<usize>,
    pub(super) table: Table,
    /// For tables other than a point's.
    pub(super) name: &'a str,
    /// What such a table is called, where there may be several: a channel or a name.
    pub(super) item: Cow<'a, str>,
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
    /// The whole lines before it, with their comments.
    pub(super) before: &'a str,
    /// Comments within its value, one per line.
    pub(super) within: String,
    /// The comment after it on its line.
    pub(super) behind: &'a str,
}

/// Maps mutually exclusive keys of a table to one place.
pub(super) fn slot(key: &str) -> &str {
    match key.trim_matches(['"', '\'']) {
        "own" => "preset",
        "offset" => "target",
        other => other,
    }
}

/// The table in which a statement stands; see [`Place`].
#[derive(Clone, Copy)]
pub(super) struct Within<'a> {
    node: Option<usize>,
    pub(super) table: Table,
    pub(super) name: &'a str,
    /// The last node so far.
    last: Option<usize>,
}

impl<'a> Within<'a> {
    /// Before all tables, or behind them.
    pub(super) const fn outside(table: Table) -> Self {
        Self {
            node: None,
            table,
            name: "",
            last: None,
        }
    }

    pub(super) const fn place(self, key: &'a str) -> Place<'a> {
        Place {
            node: self.node,
            table: self.table,
            name: self.name,
            item: Cow::Borrowed(""),
            key,
        }
    }

    /// The key that tells such tables apart.
    pub(super) fn item_key(self) -> Option<&'static str> {
        match self.name {
            "node.track" => Some("channel"),
            "node.shape" | "marker" => Some("name"),
            _ => None,
        }
    }

    /// The table that a header of this name begins.
    pub(super) fn next(self, name: &'a str) -> Self {
        let last = match name {
            "node" => Some(self.last.map_or(0, |node| node + 1)),
            _ => self.last,
        };
        let node = last.filter(|_| name == "node" || name.starts_with("node."));
        let before = Some(self.table).filter(|_| self.node == node);
        let (table, name) = match (name, before) {
            ("point" | "node.path.point", Some(Table::Point(point, _))) => {
                (Table::Point(point + 1, None), "")
            }
            ("point" | "node.path.point", _) => (Table::Point(0, None), ""),
            (
                "point.orientation" | "node.path.point.orientation",
                Some(Table::Point(point, number)),
            ) => {
                let number = number.map_or(0, |number| number + 1);
                (Table::Point(point, Some(number)), "")
            }
            ("node.deformation", Some(Table::Item(number))) => (Table::Item(number + 1), name),
            ("node.deformation", _) => (Table::Item(0), name),
            _ => (Table::Named, name),
        };
        Self {
            node,
            table,
            name,
            last,
        }
    }
}
