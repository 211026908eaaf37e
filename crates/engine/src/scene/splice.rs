//! Keys that come into a track and go out of it, and the ways between them that become others.

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

    /// The track without the keys `remove` and with those of `put`.
    pub(super) fn with_keys(&self, remove: &[usize], put: &KeyList) -> Result<Self> {
        self.check_which(remove)?;
        let numbers @ [width, shape] = self.key_numbers();
        let come = put.len();
        if put.values.len() != width * come || put.shape.len() != shape * come {
            return Err(OutOfRange::KeyNumbers {
                keys: come,
                numbers: put.values.len() + put.shape.len(),
            }
            .into());
        }
        let count = self.frames().len() - remove.len() + come;
        let mut new = KeyList::with_room(count, numbers)?;
        let mut places = vec_with_room(come)?;
        let (mut next, mut going) = (0, remove.iter().peekable());
        for key in 0..self.frames().len() {
            if going.next_if_eq(&&key).is_some() {
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
        let mut track = self.with_list(new);
        track.check_count()?;
        for key in places {
            for key in [key, key + 1].into_iter().filter(|&key| key < count) {
                track
                    .check_key(key)
                    .map_err(|error| error.at(Place::Key(key)))?;
            }
        }
        track.prepare()?;
        Ok(track)
    }

    /// The track as it goes from key to key in another manner.
    pub(super) fn with_manner(&self, manner: Manner) -> Result<Self> {
        let mut track = self.with_list(KeyList {
            shape: manner.shape,
            ..self.list.clone()
        });
        track.set_manner(manner.interpolation, (manner.before, manner.after));
        track.check()?;
        track.prepare()?;
        Ok(track)
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

    /// Puts a zero into each row of as many as the key has, `at` each.
    pub(super) fn insert_column(&mut self, at: usize) -> Result<()> {
        self.change_columns(self.width() + 1, |row, into| {
            into.extend_from_slice(&row[..at]);
            into.push(0.0);
            into.extend_from_slice(&row[at..]);
        })
    }

    /// Takes the number `at` out of each row, of at least two each.
    pub(super) fn remove_column(&mut self, at: usize) -> Result<()> {
        self.change_columns(self.width() - 1, |row, into| {
            into.extend_from_slice(&row[..at]);
            into.extend_from_slice(&row[at + 1..]);
        })
    }

    fn change_columns(
        &mut self,
        width: usize,
        change: impl Fn(&[f64], &mut Vec<f64>),
    ) -> Result<()> {
        let changed = |list: &[f64]| {
            let rows = list.chunks_exact(self.width());
            let mut all = vec_with_room(rows.len() * width)?;
            rows.for_each(|row| change(row, &mut all));
            Ok::<_, crate::Error>(all)
        };
        let shape = match self.interpolation() {
            Interpolation::Hermite => changed(self.shape())?,
            _ => self.shape().to_vec(),
        };
        let mut track = self.with_list(KeyList {
            frames: self.frames().to_vec(),
            values: changed(self.values())?,
            shape,
        });
        track.width = width;
        track.check()?;
        track.prepare()?;
        *self = track;
        Ok(())
    }
}
