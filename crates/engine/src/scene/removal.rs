//! Many nodes removed one by one. Each removal moves the numbers of all nodes behind; done at
//! once, that is the whole scene for every node. Here a removal only marks, in logarithmic time,
//! and the scene is put right once for all of them.

use std::sync::Arc;

use super::membership::renumber;
use super::scene::Scene;
use crate::error::{OutOfRange, Result, vec_with_room};

const NONE: u32 = u32::MAX;

/// Nodes that are gone from a scene that still holds them. Its *places* are the scene's numbers;
/// *numbers* are those that nodes have without the ones that are gone.
#[derive(Debug)]
pub struct Removal {
    gone: Vec<bool>,
    count: usize,
    /// How many are left, in a tree (Fenwick 1994): entry i of i & −i places up to i, from 1.
    left: Vec<u32>,
    /// The nodes in each one: the first, and the next in the same one.
    first: Vec<u32>,
    next: Vec<u32>,
    /// Room for what is to be removed, and for the new numbers.
    open: Vec<u32>,
}

fn filled(count: usize, value: u32) -> Result<Vec<u32>> {
    let mut all = vec_with_room(count)?;
    all.resize(count, value);
    Ok(all)
}

impl Removal {
    /// Of no node yet.
    ///
    /// # Errors
    /// [`crate::Error::Memory`].
    #[allow(clippy::cast_possible_truncation)] // MAX_NODES
    pub fn new(scene: &Scene) -> Result<Self> {
        let nodes = scene.nodes();
        let count = nodes.len();
        let mut gone = vec_with_room(count)?;
        gone.resize(count, false);
        let (mut first, mut next) = (filled(count, NONE)?, filled(count, NONE)?);
        for (at, node) in nodes.iter().enumerate() {
            if let Some(parent) = node.parent {
                next[at] = std::mem::replace(&mut first[parent], at as u32);
            }
        }
        let mut left = vec_with_room(count + 1)?;
        left.extend((0..=count as u32).map(|at| at & at.wrapping_neg()));
        let open = vec_with_room(count)?;
        Ok(Self {
            gone,
            count,
            left,
            first,
            next,
            open,
        })
    }

    /// How many nodes are left.
    #[must_use]
    pub const fn count(&self) -> usize {
        self.count
    }

    /// The number of the node at a place; none if it is gone.
    #[must_use]
    pub fn number(&self, place: usize) -> Option<usize> {
        if *self.gone.get(place)? {
            return None;
        }
        let (mut at, mut before) = (place, 0);
        while at > 0 {
            before += self.left[at] as usize;
            at &= at - 1;
        }
        Some(before)
    }

    /// The place of the node with a number.
    ///
    /// # Errors
    /// [`crate::Error::Range`] if it does not exist.
    pub fn place(&self, number: usize) -> Result<usize> {
        let count = self.count;
        if number >= count {
            return Err(OutOfRange::NoNode {
                node: number,
                count,
            }
            .into());
        }
        let (mut place, mut before) = (0, 0);
        let mut step = self.gone.len().next_power_of_two();
        while step > 0 {
            let left = self.left.get(place + step);
            if let Some(&left) = left.filter(|&&left| before + left as usize <= number) {
                (place, before) = (place + step, before + left as usize);
            }
            step /= 2;
        }
        Ok(place)
    }

    /// Removes the node with a number and all that is in it.
    ///
    /// # Errors
    /// [`crate::Error::Range`] if it does not exist.
    pub fn remove(&mut self, number: usize) -> Result<()> {
        let place = self.place(number)?;
        self.remove_place(place);
        Ok(())
    }

    /// Removes the node at a place, if it is still there, and all that is in it.
    #[allow(clippy::cast_possible_truncation)] // MAX_NODES
    pub(super) fn remove_place(&mut self, place: usize) {
        self.open.push(place as u32);
        while let Some(node) = self.open.pop().map(|node| node as usize) {
            if std::mem::replace(&mut self.gone[node], true) {
                continue;
            }
            self.count -= 1;
            let mut at = node + 1;
            while let Some(left) = self.left.get_mut(at) {
                *left -= 1;
                at += at & at.wrapping_neg();
            }
            let mut child = self.first[node];
            while child != NONE {
                self.open.push(child);
                child = self.next[child as usize];
            }
        }
    }

    /// The new number of each place, [`NONE`] for those that are gone.
    #[allow(clippy::cast_possible_truncation)] // MAX_NODES
    pub(super) fn into_numbers(self) -> Vec<u32> {
        let (mut numbers, mut next) = (self.next, 0);
        for (number, gone) in numbers.iter_mut().zip(self.gone) {
            *number = if gone { NONE } else { next };
            next += u32::from(!gone);
        }
        numbers
    }
}

impl Scene {
    /// Removes a node with all that is in it. Later ones move up; aims at what is removed end.
    ///
    /// # Errors
    /// [`crate::Error::Range`] if it does not exist, [`crate::Error::Memory`].
    pub fn remove(&mut self, at: usize) -> Result<()> {
        let mut removal = Removal::new(self)?;
        removal.remove(at)?;
        self.remove_all(removal);
        Ok(())
    }

    /// Removes what is gone. Later nodes move up; aims at what is removed end.
    pub fn remove_all(&mut self, removal: Removal) {
        let numbers = removal.into_numbers();
        let new = |at: usize| match numbers[at] {
            NONE => None,
            number => Some(number as usize),
        };
        let mut place = 0;
        self.nodes.retain(|_| {
            place += 1;
            // What is in one that is gone is gone, too.
            numbers[place - 1] != NONE
        });
        renumber(&mut self.nodes, new);
        let mut place = 0;
        Arc::make_mut(&mut self.ids).retain(|_| {
            place += 1;
            numbers[place - 1] != NONE
        });
        for list in [&mut *self.order, Arc::make_mut(&mut self.names)] {
            list.retain_mut(|node| {
                let number = new(*node);
                *node = number.unwrap_or(0);
                number.is_some()
            });
        }
        self.pins.retain_mut(|pin| {
            let number = new(pin.node);
            pin.node = number.unwrap_or(0);
            number.is_some()
        });
        self.camera = self.camera.and_then(new);
        self.numbers = self.nodes.iter().map(|node| node.keys.numbers()).sum();
    }
}

#[cfg(test)]
#[path = "removal_tests.rs"]
mod tests;
