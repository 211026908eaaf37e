//! The undo history: a list of what was there before each step. A step holds *the other side*: what
//! was there before it or, once undone, after it; undo and redo exchange the sides.

use std::collections::VecDeque;
use std::mem::swap;

use super::content::Content;
use super::step_name::StepName;
use vides_engine::limits;

/// What a single undo takes back.
#[derive(Debug)]
pub(super) struct Step {
    pub(super) name: Option<StepName>,
    /// What is on the other side.
    pub(super) other: Content,
}

/// A step, and about how many bytes its other side takes besides what this side has.
type Weighed = (Step, usize);

#[derive(Debug)]
pub(super) struct History {
    steps: VecDeque<Weighed>,
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

    pub(super) const fn keeps_any(&self) -> bool {
        self.limit > 0
    }

    pub(super) const fn can_undo(&self) -> bool {
        self.done > 0
    }

    pub(super) fn can_redo(&self) -> bool {
        self.done < self.steps.len()
    }

    pub(super) fn names(&self) -> [Option<StepName>; 2] {
        let name = |at: usize| self.steps.get(at).and_then(|(step, _)| step.name);
        [self.done.checked_sub(1).and_then(name), name(self.done)]
    }

    /// Adds a step that has led to `now`; steps undone before are dropped.
    pub(super) fn push(&mut self, step: Step, now: &Content) {
        if !self.keeps_any() {
            return;
        }
        while self.can_redo() {
            self.weight -= self.steps.pop_back().map_or(0, |(_, weight)| weight);
        }
        let weight = step.other.heap_size_without(now);
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

    /// Makes one step, which leads to `now`, of all that were done since the mark, which goes.
    pub(super) fn join(&mut self, now: &Content) {
        let Some(mark) = self.mark.take().filter(|mark| mark + 1 < self.done) else {
            return;
        };
        let name = self.steps.range(mark..self.done);
        let name = name.filter_map(|(step, _)| step.name).next();
        self.steps.drain(mark + 1..self.done);
        self.done = mark + 1;
        let (first, weight) = &mut self.steps[mark];
        first.name = name;
        *weight = first.other.heap_size_without(now);
        self.weight = self.steps.iter().map(|(_, weight)| weight).sum();
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

    /// Undoes the newest step, or redoes the one undone last: exchanges `now` with its other side.
    pub(super) fn travel(&mut self, redo: bool, now: &mut Content) {
        let index = match redo {
            true => Some(self.done),
            false => self.done.checked_sub(1),
        };
        let Some((step, weight)) = index.and_then(|index| self.steps.get_mut(index)) else {
            return;
        };
        swap(&mut step.other, now);
        self.weight -= *weight;
        *weight = step.other.heap_size_without(now);
        self.weight += *weight;
        self.done = if redo { self.done + 1 } else { self.done - 1 };
        self.lower_mark();
    }
}
