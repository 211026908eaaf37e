//! What undo and redo have changed of a scene, so that it can be selected.

use vides_engine::scene::{Channel, Part};

use super::change::Change;
use super::edited_scene::{came, went};

/// Nodes and keys of a scene that the last undo or redo has changed and that are there.
#[derive(Debug, Default)]
pub struct Touched {
    nodes: Vec<usize>,
    keys: Vec<(usize, Channel, Vec<usize>)>,
}

impl Touched {
    /// The nodes, each once, in rising order.
    #[must_use]
    pub fn nodes(&self) -> &[usize] {
        &self.nodes
    }

    /// The keys that have come, by node and channel.
    pub fn keys(&self) -> impl Iterator<Item = (usize, &Channel, &[usize])> {
        let keys = self.keys.iter();
        keys.map(|(node, channel, keys)| (*node, channel, keys.as_slice()))
    }

    pub(super) fn clear(&mut self) {
        self.nodes.clear();
        self.keys.clear();
    }

    /// Takes down what a change has just exchanged; `edited`: the node whose path is edited. Without
    /// memory for it less is known.
    pub(super) fn note(&mut self, change: &Change, edited: Option<usize>) {
        match change {
            Change::Several(changes) => {
                // That another path is edited is no change of either.
                let other = |one: &Change| matches!(one, Change::Edited(..));
                let edited = edited.filter(|_| !changes.iter().any(other));
                changes.iter().for_each(|one| self.note(one, edited));
            }
            Change::Part(part, _) => self.note_part(part),
            Change::Whole(whole) if whole.scene.is_some() => self.clear(),
            Change::Whole(whole) if whole.info.is_some() => {}
            Change::Edited(..) => {}
            // Of the path that is edited.
            _ => edited.into_iter().for_each(|node| self.add(node)),
        }
    }

    fn note_part(&mut self, part: &Part) {
        match part {
            // What is to be removed has come.
            Part::Remove(places) => {
                self.renumber(|node| Some(came(places, node)));
                places.iter().for_each(|&node| self.add(node));
            }
            Part::Insert(list) => self.renumber(|node| went(list.places(), node)),
            Part::Keys {
                node,
                channel,
                remove,
                ..
            } => {
                self.add(*node);
                self.keys.retain(|of| (of.0, &of.1) != (*node, channel));
                let mut keys = Vec::new();
                if self.keys.try_reserve(1).is_ok() && keys.try_reserve(remove.len()).is_ok() {
                    keys.extend_from_slice(remove);
                    self.keys.push((*node, channel.clone(), keys));
                }
            }
            Part::Name { node, .. } | Part::Links { node, .. } | Part::Pin { node, .. } => {
                self.add(*node);
            }
            other => other.node().into_iter().for_each(|node| self.add(node)),
        }
    }

    fn add(&mut self, node: usize) {
        if let Err(at) = self.nodes.binary_search(&node)
            && self.nodes.try_reserve(1).is_ok()
        {
            self.nodes.insert(at, node);
        }
    }

    /// Gives all nodes other numbers, in the same order; those without one are gone.
    fn renumber(&mut self, new: impl Fn(usize) -> Option<usize>) {
        self.nodes.retain_mut(|node| match new(*node) {
            Some(number) => {
                *node = number;
                true
            }
            None => false,
        });
        self.keys.retain_mut(|of| match new(of.0) {
            Some(number) => {
                of.0 = number;
                true
            }
            None => false,
        });
    }
}
