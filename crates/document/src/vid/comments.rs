//! The user's comments in a `.vid` file, kept when the path is saved.
//!
//! Each comment is kept with the place it is attached to (a key, a table, the end of the file) and
//! put back into the written text there, so that reader and writer need not know of comments.
//!
//! A comment hangs on its node, whatever number that has, and follows its point.

use std::collections::HashMap;
use std::ops::Range;
use std::sync::Arc;

use super::statements::{Place, Table, statements};
use crate::error::{Result, can_allocate};
use vides_engine::limits::MAX_FILE_BYTES;
use vides_engine::path::CameraPath;
use vides_engine::property::find;
use vides_engine::scene::{NodeId, Scene};

/// The comments we write ourselves; `#` otherwise only occurs within strings.
pub(super) const OURS: [&str; 3] = [
    "# Frames at speed 50 for a way of half the space's size, a turn of 180 degrees,",
    "# a zoom from 1 to 100, a roll of 90 degrees.",
    "# A cube in the world; which axis stands upright.",
];

#[derive(Debug, Clone)]
struct Comment {
    node: Option<NodeId>,
    table: Table,
    name: Arc<str>,
    item: Arc<str>,
    key: Arc<str>,
    /// Whole lines before the place, with the empty lines between them.
    before: Arc<str>,
    /// At the end of the place's line.
    behind: Arc<str>,
}

/// A file's comments, in the order of their places.
#[derive(Debug, Clone, Default)]
pub(crate) struct Comments {
    all: Vec<Comment>,
}

impl Comments {
    /// The comments of a text that parses without an error; `nodes`: those of its scene.
    pub(crate) fn of(text: &str, nodes: &[NodeId]) -> Result<Self> {
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
                    node: place.node.and_then(|node| nodes.get(node).copied()),
                    table: place.table,
                    name: place.name.into(),
                    item: place.item.into(),
                    key: place.key.into(),
                    before: before.into(),
                    behind: behind.into(),
                });
            }
        });
        Ok(comments)
    }

    /// The comments of a text that holds this scene.
    pub(crate) fn of_scene(text: &str, scene: &Scene) -> Result<Self> {
        let comments = Self::of(text, scene.ids())?;
        Ok(match scene.ids() {
            // A path in its short form.
            [NodeId::OF_PATH] => comments.in_scene(),
            _ => comments,
        })
    }

    /// Those of a node's path, or of the path alone.
    fn of_path(&self, node: Option<NodeId>) -> impl Iterator<Item = &Comment> {
        self.all.iter().filter(move |comment| comment.node == node)
    }

    /// Whether there are any of points of a node's path.
    pub(crate) fn has_points(&self, node: Option<NodeId>) -> bool {
        let mut of_path = self.of_path(node);
        of_path.any(|comment| matches!(comment.table, Table::Point(..)))
    }

    /// Lets comments follow points that have other numbers now, or none.
    pub(crate) fn renumber_points(
        &mut self,
        node: Option<NodeId>,
        number: impl Fn(usize) -> Option<usize>,
    ) {
        self.all.retain_mut(|comment| match &mut comment.table {
            Table::Point(point, _) if comment.node == node => follow(point, &number),
            _ => true,
        });
    }

    /// The same for orientations of a point.
    pub(crate) fn renumber_views(
        &mut self,
        node: Option<NodeId>,
        of: usize,
        number: impl Fn(usize) -> Option<usize>,
    ) {
        self.all.retain_mut(|comment| match &mut comment.table {
            Table::Point(point, Some(view)) if *point == of && comment.node == node => {
                follow(view, &number)
            }
            _ => true,
        });
    }

    /// Those of a path in a scene of one camera on it.
    pub(crate) fn in_scene(&self) -> Self {
        let mut comments = self.clone();
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
            (comment.node, comment.name) = (Some(NodeId::OF_PATH), name.into());
        }
        comments
    }

    /// The inverse of [`Comments::in_scene`], of the scene's only node; those of the node itself go
    /// to the file's head.
    pub(crate) fn of_path_alone(&self, node: NodeId) -> Self {
        let mut comments = self.clone();
        let stays = |comment: &Comment| comment.node.is_none_or(|id| id == node);
        comments.all.retain(stays);
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
        comments
    }

    /// Those that are of no node and no point, for another scene.
    pub(crate) fn of_file(&self) -> Self {
        let mut comments = self.clone();
        comments
            .all
            .retain(|comment| comment.node.is_none() && !matches!(comment.table, Table::Point(..)));
        comments
    }

    pub(crate) fn heap_size(&self) -> usize {
        let texts = self.all.iter();
        let texts = texts.map(|comment| comment.before.len() + comment.behind.len());
        size_of_val(&self.all[..]) + texts.sum::<usize>()
    }

    /// A text with these comments; `nodes`: those of its scene, by their numbers.
    pub(super) fn put_into(&self, text: String, nodes: &[NodeId]) -> Result<String> {
        let number = |id: NodeId| nodes.binary_search(&id).ok();
        let there = || {
            let all = self.all.iter();
            all.filter(|comment| comment.node.is_none_or(|id| number(id).is_some()))
        };
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
            let place = Place {
                node: comment.node.and_then(number),
                table: comment.table,
                name: &comment.name,
                item: &comment.item,
                key: &comment.key,
            };
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

/// Gives something its new number; false: it has none.
fn follow(number: &mut usize, new: impl Fn(usize) -> Option<usize>) -> bool {
    let new = new(*number);
    *number = new.unwrap_or(*number);
    new.is_some()
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
