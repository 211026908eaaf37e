//! The undo history. A step keeps "the other side": the selection and state number from before it
//! or, once undone, from after it; undo and redo exchange the sides.

use std::collections::VecDeque;

use super::change::{Change, exchange_all};
use super::edit::Selection;
use super::step_name::StepName;
use crate::error::{Result, vec_with_room};
use vides_engine::limits;

/// What a single undo takes back.
#[derive(Debug)]
pub(super) struct Step {
    /// The records that lead to the other side, in the order of application.
    changes: Vec<Change>,
    /// The selection on the other side.
    pub(super) selection: Selection,
    /// Number of the state on the other side.
    pub(super) number: u64,
    pub(super) name: Option<StepName>,
}

impl Step {
    pub(super) fn new(selection: Selection, number: u64) -> Self {
        Self {
            changes: Vec::new(),
            selection,
            number,
            name: None,
        }
    }

    pub(super) fn reserve(&mut self) -> Result<()> {
        if self.changes.is_empty() {
            self.changes.try_reserve_exact(1)?;
        } else {
            self.changes.try_reserve(1)?;
        }
        Ok(())
    }

    pub(super) fn reserve_more(&mut self, records: usize) -> Result<()> {
        Ok(self.changes.try_reserve(records)?)
    }

    /// Adds the record that undoes the newest change, unless an older one already does. The newest
    /// is last until [`Step::close`] reverses the order.
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

    pub(super) fn reserve_for(&mut self, inner: &Self) -> Result<()> {
        self.reserve_more(inner.changes.len())
    }

    /// Appends the records of an inner step; the memory was reserved by [`Step::reserve_for`].
    pub(super) fn append(&mut self, inner: Self) {
        self.name = self.name.or(inner.name);
        for record in inner.changes {
            self.push(record);
        }
    }

    /// Puts the records into their order of application.
    pub(super) fn close(&mut self) {
        self.changes.reverse();
    }

    pub(super) fn is_empty(&self) -> bool {
        self.changes.is_empty()
    }

    /// Applies each record, which then undoes itself; none if one cannot be.
    pub(super) fn exchange(&mut self, apply: impl FnMut(&mut Change) -> Result<()>) -> Result<()> {
        exchange_all(&mut self.changes, apply)
    }

    /// Puts the records back into the order in which they came, so that more can follow.
    pub(super) fn reopen(&mut self) {
        self.changes.reverse();
    }

    /// Puts closed steps together, given in the order in which they were done.
    fn join(
        steps: impl DoubleEndedIterator<Item = Self>,
        mut changes: Vec<Change>,
    ) -> Option<Self> {
        let mut joined: Option<Self> = None;
        // What was done last is taken back first; the other side is that of the first.
        for mut step in steps.rev() {
            changes.append(&mut step.changes);
            let name = joined.and_then(|later| later.name);
            joined = Some(Self {
                name: step.name.or(name),
                ..step
            });
        }
        joined.map(|first| Self { changes, ..first })
    }

    fn weight(&self) -> usize {
        size_of::<Self>() + self.changes.iter().map(Change::weight).sum::<usize>()
    }
}

/// How many records to search for one at the same place: a drag changes one or two repeatedly.
const FAR_BACK: usize = 64;

#[derive(Debug)]
pub(super) struct History {
    steps: VecDeque<(Step, usize)>,
    /// Number of steps done; those after them have been undone.
    done: usize,
    weight: usize,
    /// Steps kept; 0 keeps none.
    limit: usize,
    /// How many steps were done where joining begins; fewer if they have been undone since.
    mark: Option<usize>,
}

impl History {
    pub(super) const fn new(limit: usize) -> Self {
        Self {
            steps: VecDeque::new(),
            done: 0,
            weight: 0,
            limit,
            mark: None,
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

    pub(super) fn names(&self) -> [Option<StepName>; 2] {
        let name = |at: usize| self.steps.get(at).and_then(|(step, _)| step.name);
        [self.done.checked_sub(1).and_then(name), name(self.done)]
    }

    pub(super) fn reserve(&mut self) -> Result<()> {
        Ok(self.steps.try_reserve(1)?)
    }

    /// Adds a step; steps undone before are dropped.
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
            self.mark = self.mark.map(|mark| mark.saturating_sub(1));
        }
    }

    pub(super) const fn mark(&mut self) {
        self.mark = Some(self.done);
    }

    /// Makes one step of all that were done since the mark, which goes.
    pub(super) fn join(&mut self) -> Result<()> {
        let Some(mark) = self.mark.take().filter(|mark| mark + 1 < self.done) else {
            return Ok(());
        };
        let records = |(step, _): &(Step, usize)| step.changes.len();
        let count = self.steps.range(mark..self.done).map(records).sum();
        let changes = vec_with_room(count)?;
        let steps = self.steps.drain(mark..self.done).map(|(step, _)| step);
        let joined = Step::join(steps, changes);
        self.done = mark;
        if let Some(joined) = joined {
            let weight = joined.weight();
            self.steps.insert(mark, (joined, weight));
            self.done += 1;
        }
        self.weight = self.steps.iter().map(|(_, weight)| weight).sum();
        Ok(())
    }

    fn lower_mark(&mut self) {
        let done = self.done;
        self.mark = self.mark.map(|mark| mark.min(done));
    }

    /// Takes the newest step out, if nothing was undone after it.
    pub(super) fn pop(&mut self) -> Option<Step> {
        if self.can_redo() {
            return None;
        }
        let (step, weight) = self.steps.pop_back()?;
        self.weight -= weight;
        self.done -= 1;
        self.lower_mark();
        Some(step)
    }

    /// Undoes the newest step by `exchange`, or redoes the one undone last. False if there is none.
    pub(super) fn exchange(
        &mut self,
        redo: bool,
        exchange: impl FnOnce(&mut Step) -> Result<()>,
    ) -> bool {
        let index = if redo {
            Some(self.done)
        } else {
            self.done.checked_sub(1)
        };
        let Some((step, weight)) = index.and_then(|index| self.steps.get_mut(index)) else {
            return false;
        };
        if exchange(step).is_err() {
            return false;
        }
        self.done = if redo { self.done + 1 } else { self.done - 1 };
        // It now holds the other side's values.
        self.weight -= *weight;
        *weight = step.weight();
        self.weight += *weight;
        self.lower_mark();
        true
    }
}
