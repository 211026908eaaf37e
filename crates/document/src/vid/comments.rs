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

use super::statements::{Place, Table, statements};
use crate::error::{Result, can_allocate};
use vides_engine::limits::MAX_FILE_BYTES;
use vides_engine::path::CameraPath;
use vides_engine::property::find;

/// The comments we write ourselves; `#` otherwise only occurs within strings.
pub(super) const OURS: [&str; 3] = [
    "# Frames at speed 50 for a way of half the space's size, a turn of 180 degrees,",
    "# a zoom from 1 to 100, a roll of 90 degrees.",
    "# A cube in the world; which axis stands upright.",
];

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

    /// Those that are of no point of this node's path, for another path.
    pub(crate) fn without_points(&self, node: Option<usize>) -> Result<Self> {
        let mut comments = self.try_clone()?;
        comments
            .all
            .retain(|comment| comment.node != node || !matches!(comment.table, Table::Point(..)));
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

#[cfg(test)]
#[path = "comments_tests.rs"]
mod tests;
