//! What was done and can be taken back: steps of one or more records.
//!
//! Every step keeps "the other side": what the selection and the state's
//! number were before it, or, once it has been taken back, after it. Undo and
//! redo exchange the two sides.

use std::collections::VecDeque;

use super::change::Change;
use super::editing::Selection;
use crate::error::Result;
use crate::limits;

/// One step: what a single undo takes back.
#[derive(Debug)]
pub(super) struct Step {
    /// The records that lead to the other side, to be applied in this order.
    changes: Vec<Change>,
    /// The selection on the other side.
    pub(super) selection: Selection,
    /// Number of the state on the other side.
    pub(super) state: u64,
    /// What it is called, if it has a name.
    pub(super) name: Option<&'static str>,
}

impl Step {
    pub(super) fn new(selection: Selection, state: u64) -> Self {
        Self {
            changes: Vec::new(),
            selection,
            state,
            name: None,
        }
    }

    /// Takes the memory for one more record.
    pub(super) fn reserve(&mut self) -> Result<()> {
        if self.changes.is_empty() {
            // Most steps are one record: no room for others.
            self.changes.try_reserve_exact(1)?;
        } else {
            self.changes.try_reserve(1)?;
        }
        Ok(())
    }

    /// The same for several.
    pub(super) fn reserve_more(&mut self, records: usize) -> Result<()> {
        Ok(self.changes.try_reserve(records)?)
    }

    /// Adds the record that takes the newest change back, unless an older one
    /// does. (Kept newest last; [`Step::close`] turns the order round.)
    pub(super) fn push(&mut self, inverse: Change) {
        let known = self
            .changes
            .iter()
            .rev()
            .take_while(|older| !older.renumbers())
            .take(FAR_BACK)
            .any(|older| older.is_at_place_of(&inverse));
        if !known {
            self.changes.push(inverse);
        }
    }

    /// Takes the memory for the records of a step that was done within this one.
    pub(super) fn reserve_for(&mut self, inner: &Self) -> Result<()> {
        self.reserve_more(inner.changes.len())
    }

    /// Adds its records, to which none were added since that.
    pub(super) fn append(&mut self, inner: Self) {
        for record in inner.changes {
            self.push(record);
        }
    }

    /// The step is complete: its records in the order they are to be applied.
    pub(super) fn close(&mut self) {
        self.changes.reverse();
    }

    pub(super) fn is_empty(&self) -> bool {
        self.changes.is_empty()
    }

    /// Applies its records, each by `apply`, and keeps what takes them back.
    pub(super) fn exchange(&mut self, mut apply: impl FnMut(Change) -> Change) {
        for change in &mut self.changes {
            let taken = std::mem::replace(change, Change::Closed(false));
            *change = apply(taken);
        }
        self.changes.reverse();
    }

    fn weight(&self) -> usize {
        size_of::<Self>() + self.changes.iter().map(Change::weight).sum::<usize>()
    }
}

/// Records looked through for one at the same place: a drag changes one or
/// two places over and over.
const FAR_BACK: usize = 64;

/// The steps done and those taken back.
#[derive(Debug)]
pub(super) struct History {
    steps: VecDeque<(Step, usize)>,
    /// Steps that are done; those behind them have been taken back.
    done: usize,
    /// Weight of all steps together.
    weight: usize,
    /// Steps kept; 0 keeps none.
    limit: usize,
}

impl History {
    pub(super) const fn new(limit: usize) -> Self {
        Self {
            steps: VecDeque::new(),
            done: 0,
            weight: 0,
            limit,
        }
    }

    pub(super) fn keeps_any(&self) -> bool {
        self.limit > 0
    }

    pub(super) fn can_undo(&self) -> bool {
        self.done > 0
    }

    pub(super) fn can_redo(&self) -> bool {
        self.done < self.steps.len()
    }

    /// The names of the steps to be taken back and done again next.
    pub(super) fn names(&self) -> [Option<&'static str>; 2] {
        let name = |at: usize| self.steps.get(at).and_then(|(step, _)| step.name);
        [self.done.checked_sub(1).and_then(name), name(self.done)]
    }

    /// Takes the memory for one more step.
    pub(super) fn reserve(&mut self) -> Result<()> {
        Ok(self.steps.try_reserve(1)?)
    }

    /// A step has been done; those taken back before are gone.
    pub(super) fn push(&mut self, step: Step) {
        if !self.keeps_any() || step.changes.is_empty() {
            return;
        }
        while self.can_redo() {
            self.weight -= self.steps.pop_back().map_or(0, |(_, weight)| weight);
        }
        let weight = step.weight();
        self.weight += weight;
        self.steps.push_back((step, weight));
        self.done += 1;
        while self.steps.len() > self.limit
            || (self.weight > limits::MAX_HISTORY_BYTES && self.steps.len() > 1)
        {
            self.weight -= self.steps.pop_front().map_or(0, |(_, weight)| weight);
            self.done -= 1;
        }
    }

    /// Lets `exchange` take the newest step back. False if there is none.
    pub(super) fn back(&mut self, exchange: impl FnOnce(&mut Step)) -> bool {
        let Some(index) = self.done.checked_sub(1) else {
            return false;
        };
        self.done = index;
        self.exchange(index, exchange)
    }

    /// Lets `exchange` do the step again that was taken back last. False if
    /// there is none.
    pub(super) fn forth(&mut self, exchange: impl FnOnce(&mut Step)) -> bool {
        let index = self.done;
        if index == self.steps.len() {
            return false;
        }
        self.done += 1;
        self.exchange(index, exchange)
    }

    fn exchange(&mut self, index: usize, exchange: impl FnOnce(&mut Step)) -> bool {
        let Some((step, weight)) = self.steps.get_mut(index) else {
            return false;
        };
        exchange(step);
        // What it holds now are the other side's values.
        self.weight -= *weight;
        *weight = step.weight();
        self.weight += *weight;
        true
    }
}
