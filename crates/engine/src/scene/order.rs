//! The nodes in an order in which each comes after what it needs, and what hangs in them: so a node
//! that is given another parent costs what is moved and not the whole scene (D. J. Pearce and
//! P. H. J. Kelly, *A dynamic topological sort algorithm for directed acyclic graphs*, 2006).

use std::ops::{Deref, DerefMut};
use std::sync::Arc;

use super::node::Node;
use crate::error::{Result, vec_with_room};
use crate::limits::MAX_LEVELS;
use crate::shared_list::SharedList;

const NONE: u32 = u32::MAX;

/// The order, and what is known of the tree until somebody changes it otherwise.
#[derive(Debug, Default)]
pub(super) struct Order {
    nodes: Arc<Vec<usize>>,
    tree: Option<Tree>,
}

/// What is known of each node.
#[derive(Debug)]
struct Tree {
    all: Vec<Known>,
    /// How many nodes aim at another.
    aims: usize,
}

#[derive(Debug, Clone, Copy)]
struct Known {
    /// Where it stands in the order.
    place: u32,
    first_child: u32,
    next: u32,
    before: u32,
    /// Not less than the levels of it and what is in it.
    height: u16,
    /// Whether another aims at it.
    aimed_at: bool,
}

impl Order {
    /// Adds a node after the others, to which no node refers yet.
    pub(super) fn add(&mut self, node: &Node) {
        let at = self.nodes.len();
        Arc::make_mut(&mut self.nodes).push(at);
        let Some(tree) = &mut self.tree else { return };
        tree.all.push(Known::new(at));
        tree.attach(at, node.parent);
        tree.aim(node.aim);
    }

    /// Whether another order is the very same list.
    pub(super) fn is_shared_with(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.nodes, &other.nodes)
    }

    /// Takes note of a node's new parent and aim, where these lead to no circle, to no more levels
    /// than there may be, and to another order only if no node aims; if not, nothing has changed.
    pub(super) fn moved(
        &mut self,
        nodes: &SharedList<Node>,
        at: usize,
        (parent, aim): (Option<usize>, Option<usize>),
    ) -> Result<bool> {
        if self.tree.is_none() {
            self.tree = Some(Tree::new(nodes, &self.nodes)?);
        }
        let Some(tree) = &mut self.tree else {
            return Ok(false);
        };
        let (old, node) = (&nodes[at], tree.all[at]);
        let moves = parent != old.parent;
        let above = || std::iter::successors(parent, |&up| nodes[up].parent);
        let stays = |needed: usize| tree.all[needed].place < node.place;
        if moves {
            let levels = above().count() + usize::from(node.height);
            if levels > MAX_LEVELS || above().any(|up| up == at) {
                return Ok(false);
            }
            // Who aims at it needs its parent.
            if parent.is_some() && node.aimed_at {
                return Ok(false);
            }
        }
        let target = aim.and_then(|aim| nodes.get(aim)?.parent);
        if aim.is_some_and(|aim| aim >= nodes.len()) || !target.is_none_or(stays) {
            return Ok(false);
        }
        if !parent.is_none_or(stays) {
            if tree.aims > 0 || aim.is_some() {
                return Ok(false);
            }
            let order: &mut Vec<usize> = Arc::make_mut(&mut self.nodes);
            tree.reorder(order, at, above())?;
        }
        if aim != old.aim {
            tree.aims -= usize::from(old.aim.is_some());
            tree.aim(aim);
        }
        if moves {
            tree.detach(at, old.parent);
            tree.attach(at, parent);
            let mut height = node.height;
            for up in above() {
                height += 1;
                let known = &mut tree.all[up];
                known.height = known.height.max(height);
            }
        }
        Ok(true)
    }
}

impl Known {
    #[allow(clippy::cast_possible_truncation)] // a scene has at most MAX_NODES nodes
    fn new(place: usize) -> Self {
        Self {
            place: place as u32,
            first_child: NONE,
            next: NONE,
            before: NONE,
            height: 1,
            aimed_at: false,
        }
    }
}

#[allow(clippy::cast_possible_truncation)] // a scene has at most MAX_NODES nodes and MAX_LEVELS levels
impl Tree {
    fn new(nodes: &SharedList<Node>, order: &[usize]) -> Result<Self> {
        let mut all = vec_with_room(nodes.len())?;
        all.resize(nodes.len(), Known::new(0));
        let mut tree = Self { all, aims: 0 };
        for (place, &at) in order.iter().enumerate() {
            tree.all[at].place = place as u32;
            tree.attach(at, nodes[at].parent);
            tree.aim(nodes[at].aim);
        }
        for &at in order.iter().rev() {
            let height = tree.all[at].height + 1;
            if let Some(parent) = nodes[at].parent {
                let known = &mut tree.all[parent];
                known.height = known.height.max(height);
            }
        }
        Ok(tree)
    }

    fn aim(&mut self, aim: Option<usize>) {
        if let Some(aim) = aim {
            self.aims += 1;
            self.all[aim].aimed_at = true;
        }
    }

    fn attach(&mut self, at: usize, parent: Option<usize>) {
        let Some(parent) = parent else { return };
        let next = std::mem::replace(&mut self.all[parent].first_child, at as u32);
        (self.all[at].next, self.all[at].before) = (next, NONE);
        if next != NONE {
            self.all[next as usize].before = at as u32;
        }
        let height = self.all[at].height + 1;
        let known = &mut self.all[parent];
        known.height = known.height.max(height);
    }

    fn detach(&mut self, at: usize, parent: Option<usize>) {
        let Some(parent) = parent else { return };
        let Known { next, before, .. } = self.all[at];
        match before {
            NONE => self.all[parent].first_child = next,
            before => self.all[before as usize].next = next,
        }
        if next != NONE {
            self.all[next as usize].before = before;
        }
        (self.all[at].next, self.all[at].before) = (NONE, NONE);
    }

    /// Brings a node, and what is in it, behind those above it, within the places that all these have.
    fn reorder(
        &mut self,
        order: &mut [usize],
        at: usize,
        above: impl Iterator<Item = usize>,
    ) -> Result<()> {
        let from = self.all[at].place;
        let mut before: Vec<usize> = Vec::new();
        for up in above.take_while(|up| self.all[*up].place > from) {
            before.try_reserve(1)?;
            before.push(up);
        }
        before.reverse();
        let to = before.last().map_or(from, |parent| self.all[*parent].place);
        let mut behind: Vec<usize> = vec_with_room(1)?;
        behind.push(at);
        let mut done = 0;
        while let Some(&node) = behind.get(done) {
            done += 1;
            let mut child = self.all[node].first_child;
            while child != NONE {
                let known = &self.all[child as usize];
                if known.place < to {
                    behind.try_reserve(1)?;
                    behind.push(child as usize);
                }
                child = known.next;
            }
        }
        behind.sort_unstable_by_key(|node| self.all[*node].place);
        let mut places = vec_with_room(before.len() + behind.len())?;
        let all = || before.iter().chain(&behind);
        places.extend(all().map(|node| self.all[*node].place));
        places.sort_unstable();
        for (&node, place) in all().zip(places) {
            self.all[node].place = place;
            order[place as usize] = node;
        }
        Ok(())
    }
}

impl From<Vec<usize>> for Order {
    fn from(nodes: Vec<usize>) -> Self {
        Self {
            nodes: Arc::new(nodes),
            tree: None,
        }
    }
}

impl Clone for Order {
    fn clone(&self) -> Self {
        Self {
            nodes: Arc::clone(&self.nodes),
            tree: None,
        }
    }
}

impl Deref for Order {
    type Target = Vec<usize>;
    fn deref(&self) -> &Vec<usize> {
        &self.nodes
    }
}

/// Any other change of the order must recompute what is known.
impl DerefMut for Order {
    fn deref_mut(&mut self) -> &mut Vec<usize> {
        self.tree = None;
        Arc::make_mut(&mut self.nodes)
    }
}

#[cfg(test)]
#[path = "order_tests.rs"]
mod tests;
