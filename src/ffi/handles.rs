//! Handles: tokens that name an object without being its address.
//!
//! A token holds a slot's index and generation, which increases with each object in the slot. So a
//! handle that is stale, freed twice, of another kind or made up is recognized by a table lookup
//! and never dereferenced. The lowest bit is set and, on 64 bits, the highest too: no allocator
//! returns such an address, and dereferencing it faults.

use std::marker::PhantomData;
use std::sync::{PoisonError, RwLock};

use super::counted::TryArc;
use super::status::{Answer, Failure, V_ERR_LIMIT};
use crate::error::Error;

#[cfg(target_pointer_width = "64")]
mod layout {
    pub(super) const KIND_BITS: u32 = 7;
    pub(super) const SLOT_BITS: u32 = 24;
    pub(super) const GENERATION_BITS: u32 = 31;
    pub(super) const MARK: usize = 1 | 1 << 63;
}
#[cfg(target_pointer_width = "32")]
mod layout {
    pub(super) const KIND_BITS: u32 = 3;
    pub(super) const SLOT_BITS: u32 = 16;
    pub(super) const GENERATION_BITS: u32 = 12;
    pub(super) const MARK: usize = 1;
}
use layout::{GENERATION_BITS, KIND_BITS, MARK, SLOT_BITS};

const SLOT_SHIFT: u32 = 1 + KIND_BITS;
const GENERATION_SHIFT: u32 = SLOT_SHIFT + SLOT_BITS;
const MAX_SLOTS: usize = 1 << SLOT_BITS;
const LAST_GENERATION: usize = (1 << GENERATION_BITS) - 1;

/// The name of a parameter with a handle of this kind, unless its function gives
/// another.
const NAMES: [&str; 4] = ["", "path", "editor", "scene"];

/// The kind of `V_PATH *`.
pub(super) const KIND_PATH: usize = 1;
/// The kind of `V_EDITOR *`.
pub(super) const KIND_EDITOR: usize = 2;
/// The kind of `V_SCENE *`.
pub(super) const KIND_SCENE: usize = 3;

/// All objects of one kind that C holds. `C` is the opaque type in the header.
pub(super) struct Handles<T, C> {
    kind: usize,
    table: RwLock<Table<T>>,
    named: PhantomData<fn() -> C>,
}

struct Table<T> {
    slots: Vec<Slot<T>>,
    /// The first empty slot; the rest are chained through `next_empty`, so that freeing
    /// a handle needs no memory.
    empty: Option<usize>,
}

struct Slot<T> {
    generation: usize,
    object: Option<TryArc<T>>,
    next_empty: Option<usize>,
}

impl<T, C> Handles<T, C> {
    pub(super) const fn new(kind: usize) -> Self {
        Self {
            kind,
            table: RwLock::new(Table {
                slots: Vec::new(),
                empty: None,
            }),
            named: PhantomData,
        }
    }

    /// Creates a handle for an object.
    pub(super) fn insert(&self, object: T) -> Answer<*mut C> {
        let object = TryArc::try_new(object)?;
        let mut table = self.table.write().unwrap_or_else(PoisonError::into_inner);
        let number = match table.empty {
            Some(number) => number,
            None => table.grow()?,
        };
        let slot = &mut table.slots[number];
        slot.object = Some(object);
        let generation = slot.generation;
        table.empty = slot.next_empty.take();
        Ok(self.token(number, generation))
    }

    /// The object of a handle. Stays alive while the result is held, even if another thread frees
    /// the handle.
    pub(super) fn get(&self, handle: *const C) -> Answer<TryArc<T>> {
        if handle.is_null() {
            return Err(Failure::Null(NAMES[self.kind].into()));
        }
        let table = self.table.read().unwrap_or_else(PoisonError::into_inner);
        let number = self.slot_of(handle, &table)?;
        let object = table.slots[number].object.clone();
        object.ok_or_else(|| self.invalid())
    }

    /// Removes the object and invalidates its handle.
    pub(super) fn remove(&self, handle: *const C) -> Answer<TryArc<T>> {
        let mut table = self.table.write().unwrap_or_else(PoisonError::into_inner);
        let number = self.slot_of(handle, &table)?;
        let empty = table.empty;
        let slot = &mut table.slots[number];
        let object = slot.object.take().ok_or_else(|| self.invalid())?;
        // A slot that has used up its generations stays empty.
        if slot.generation < LAST_GENERATION {
            slot.generation += 1;
            slot.next_empty = empty;
            table.empty = Some(number);
        }
        Ok(object)
    }

    fn token(&self, slot: usize, generation: usize) -> *mut C {
        let bits = MARK | self.kind << 1 | slot << SLOT_SHIFT | generation << GENERATION_SHIFT;
        std::ptr::without_provenance_mut(bits)
    }

    /// The slot of a handle, checked against its generation.
    fn slot_of(&self, handle: *const C, table: &Table<T>) -> Answer<usize> {
        let number = (handle.addr() >> SLOT_SHIFT) & (MAX_SLOTS - 1);
        match table.slots.get(number) {
            Some(slot) if self.token(number, slot.generation).addr() == handle.addr() => Ok(number),
            _ => Err(self.invalid()),
        }
    }

    fn invalid(&self) -> Failure {
        Failure::Handle(NAMES[self.kind].into())
    }
}

impl<T> Table<T> {
    /// Adds an empty slot, which is not yet in the chain.
    fn grow(&mut self) -> Answer<usize> {
        let number = self.slots.len();
        if number == MAX_SLOTS {
            return Err(Failure::Border(V_ERR_LIMIT, "too many handles"));
        }
        self.slots.try_reserve(1).map_err(Error::from)?;
        self.slots.push(Slot {
            generation: 0,
            object: None,
            next_empty: None,
        });
        Ok(number)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    enum Opaque {}

    #[test]
    fn a_handle_is_good_until_it_is_removed() {
        let handles = Handles::<_, Opaque>::new(KIND_PATH);
        let a = handles.insert("a").expect("room");
        let b = handles.insert("b").expect("room");
        assert_eq!(*handles.get(a).expect("valid"), "a");
        assert_eq!(*handles.remove(a).expect("valid"), "a");
        assert!(handles.get(a).is_err() && handles.remove(a).is_err());
        let c = handles.insert("c").expect("room");
        assert_ne!(a, c);
        assert!(handles.get(a).is_err());
        assert_eq!(*handles.get(b).expect("valid"), "b");
        assert_eq!(*handles.get(c).expect("valid"), "c");
    }

    #[test]
    fn nothing_but_the_token_itself_is_valid() {
        let handles = Handles::<_, Opaque>::new(KIND_PATH);
        let others = Handles::<_, Opaque>::new(KIND_PATH + 1);
        let handle = handles.insert(0).expect("room");
        assert!(others.insert(0).is_ok() && others.get(handle).is_err());
        for bit in 0..usize::BITS {
            let changed = handle.map_addr(|bits| bits ^ (1 << bit));
            assert!(handles.get(changed).is_err(), "bit {bit}");
        }
        assert!(handles.get(std::ptr::null()).is_err());
        assert!(!handle.addr().is_multiple_of(2));
    }

    #[test]
    fn a_slot_without_further_generations_is_given_up() {
        let handles = Handles::<_, Opaque>::new(KIND_PATH);
        let first = handles.insert(1).expect("room");
        handles.remove(first).expect("valid");
        handles.table.write().expect("lock").slots[0].generation = LAST_GENERATION;
        let last = handles.insert(2).expect("room");
        handles.remove(last).expect("valid");
        let next = handles.insert(3).expect("room");
        assert!(handles.get(last).is_err());
        assert_eq!(handles.table.read().expect("lock").slots.len(), 2);
        assert_eq!(*handles.get(next).expect("valid"), 3);
    }

    #[test]
    fn a_freed_slot_is_used_again() {
        let handles = Handles::<_, Opaque>::new(KIND_PATH);
        for round in 0..if cfg!(miri) { 10 } else { 1000 } {
            let tokens = [0, 1, 2].map(|i| handles.insert(round + i).expect("room"));
            for token in tokens {
                handles.remove(token).expect("valid");
            }
        }
        assert_eq!(handles.table.read().expect("lock").slots.len(), 3);
    }
}
