//! Keys that come into a track and go out of it, and the ways between them that become others.

use std::mem::{replace, swap, take};

use super::interpolation::Interpolation;
use super::key_list::{KeyList, Manner};
use super::track::Track;
use crate::error::{Invalid, OutOfRange, Place, Result, vec_with_room};

impl Track {
    /// How many numbers of value and of shape a key has.
    #[must_use]
    pub fn key_numbers(&self) -> [usize; 2] {
        let shape = match self.interpolation() {
            Interpolation::Hermite => 2 * self.width(),
            Interpolation::Tcb => 3,
            _ => 0,
        };
        [self.width(), shape]
    }

    /// Keys by their numbers, in rising order.
    ///
    /// # Errors
    /// [`crate::Error::Range`] if there is no such key, [`crate::Error::Argument`] for the order,
    /// [`crate::Error::Memory`].
    pub fn keys(&self, which: &[usize]) -> Result<KeyList> {
        self.check_which(which)?;
        let numbers = self.key_numbers();
        let mut list = KeyList::with_room(which.len(), numbers)?;
        which
            .iter()
            .for_each(|&key| list.push(&self.list, key, numbers));
        Ok(list)
    }

    fn check_which(&self, which: &[usize]) -> Result<()> {
        let count = self.frames().len();
        if let Some(&key) = which.iter().find(|&&key| key >= count) {
            return Err(OutOfRange::NoKeyThere { key, count }.into());
        }
        match which.is_sorted_by(|a, b| a < b) {
            true => Ok(()),
            false => Err(Invalid::KeysOutOfOrder.into()),
        }
    }

    /// The keys `remove` go and those of `put` come; afterwards both say how to take that back.
    pub(super) fn splice(&mut self, remove: &mut Vec<usize>, put: &mut KeyList) -> Result<()> {
        self.check_which(remove)?;
        let numbers @ [width, shape] = self.key_numbers();
        let (gone, come) = (remove.len(), put.len());
        if put.values.len() != width * come || put.shape.len() != shape * come {
            return Err(OutOfRange::KeyNumbers {
                keys: come,
                numbers: put.values.len() + put.shape.len(),
            }
            .into());
        }
        let count = self.frames().len() - gone + come;
        let mut new = KeyList::with_room(count, numbers)?;
        let mut out = KeyList::with_room(gone, numbers)?;
        let mut places = vec_with_room(come)?;
        let (mut next, mut going) = (0, remove.iter().peekable());
        for key in 0..self.frames().len() {
            if going.next_if_eq(&&key).is_some() {
                out.push(&self.list, key, numbers);
                continue;
            }
            while next < come && put.frames[next] < self.frames()[key] {
                places.push(new.len());
                new.push(put, next, numbers);
                next += 1;
            }
            new.push(&self.list, key, numbers);
        }
        for key in next..come {
            places.push(new.len());
            new.push(put, key, numbers);
        }
        swap(&mut self.list, &mut new);
        let old = replace(&mut self.prepared, super::track::Prepared::Nothing);
        let checked = self.check_count().and_then(|()| {
            for &key in &places {
                for key in [key, key + 1].into_iter().filter(|&key| key < count) {
                    self.check_key(key)
                        .map_err(|error| error.at(Place::Key(key)))?;
                }
            }
            self.prepare()
        });
        if let Err(error) = checked {
            (self.list, self.prepared) = (new, old);
            return Err(error);
        }
        (*remove, *put) = (places, out);
        Ok(())
    }

    pub(super) fn exchange_manner(&mut self, manner: &mut Manner) -> Result<()> {
        self.swap_manner(manner);
        let old = replace(&mut self.prepared, super::track::Prepared::Nothing);
        let checked = self.check().and_then(|()| self.prepare());
        if checked.is_err() {
            self.swap_manner(manner);
            self.prepared = old;
        }
        checked
    }

    /// How it goes from key to key, and beyond.
    #[must_use]
    pub fn manner(&self) -> Manner {
        let (before, after) = self.extrapolation();
        Manner {
            interpolation: self.interpolation().clone(),
            shape: self.shape().to_vec(),
            before,
            after,
        }
    }

    /// Puts a number into each row of as many as the key has, `at` each; empty: zeros.
    pub(super) fn insert_column(&mut self, at: usize, numbers: &[f64]) -> Result<()> {
        let width = self.width();
        let hermite = *self.interpolation() == Interpolation::Hermite;
        let rows = self.frames().len() * if hermite { 3 } else { 1 };
        if !numbers.is_empty() && numbers.len() != rows {
            return Err(OutOfRange::KeyNumbers {
                keys: self.frames().len(),
                numbers: numbers.len(),
            }
            .into());
        }
        let mut numbers = numbers.iter().copied();
        let mut wider = |list: &[f64]| {
            let mut all = vec_with_room(list.len() / width * (width + 1))?;
            for row in list.chunks_exact(width) {
                all.extend_from_slice(&row[..at]);
                all.push(numbers.next().unwrap_or(0.0));
                all.extend_from_slice(&row[at..]);
            }
            Ok::<_, crate::Error>(all)
        };
        let values = wider(self.values())?;
        let shape = if hermite {
            wider(self.shape())?
        } else {
            self.list.shape.clone()
        };
        self.with_width(width + 1, values, shape)
    }

    /// Takes the number `at` out of each row, of at least two each; gives them.
    pub(super) fn remove_column(&mut self, at: usize) -> Result<Vec<f64>> {
        let width = self.width();
        let hermite = *self.interpolation() == Interpolation::Hermite;
        let mut column = vec_with_room(self.frames().len() * if hermite { 3 } else { 1 })?;
        let mut narrower = |list: &[f64]| {
            let mut all = vec_with_room(list.len() / width * (width - 1))?;
            for row in list.chunks_exact(width) {
                all.extend_from_slice(&row[..at]);
                column.push(row[at]);
                all.extend_from_slice(&row[at + 1..]);
            }
            Ok::<_, crate::Error>(all)
        };
        let values = narrower(self.values())?;
        let shape = if hermite {
            narrower(self.shape())?
        } else {
            self.list.shape.clone()
        };
        self.with_width(width - 1, values, shape)?;
        Ok(column)
    }

    fn with_width(&mut self, width: usize, values: Vec<f64>, shape: Vec<f64>) -> Result<()> {
        let old = (
            self.width,
            replace(&mut self.list.values, values),
            replace(&mut self.list.shape, shape),
            take(&mut self.prepared),
        );
        self.width = width;
        let done = self.check().and_then(|()| self.prepare());
        if done.is_err() {
            (self.width, self.list.values, self.list.shape, self.prepared) = old;
        }
        done
    }
}
