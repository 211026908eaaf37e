//! A counted pointer whose making can be refused.
//!
//! `Arc::new` ends the process when memory has run out, and the header
//! promises a status. This is the little of `Arc` that handles need: made,
//! copied, looked through, and dropped with the last copy.

use std::alloc::{Layout, alloc};
use std::marker::PhantomData;
use std::ops::Deref;
use std::process::abort;
use std::ptr::NonNull;
use std::sync::atomic::{AtomicUsize, Ordering};

use crate::error::{EngineError, Result};

/// One of the owners of a value on the heap.
#[derive(Debug)]
pub(super) struct Counted<T> {
    block: NonNull<Block<T>>,
    owns: PhantomData<Block<T>>,
}

#[derive(Debug)]
struct Block<T> {
    owners: AtomicUsize,
    value: T,
}

// SAFETY: owners on several threads share the value (so `Sync`), and the last
// one drops it wherever it is (so `Send`); the count is atomic.
unsafe impl<T: Send + Sync> Send for Counted<T> {}
// SAFETY: as above; a shared owner can be cloned into one of another thread.
unsafe impl<T: Send + Sync> Sync for Counted<T> {}

impl<T> Counted<T> {
    /// The first owner of a value.
    ///
    /// # Errors
    /// `ErrorKind::Memory`.
    pub(super) fn try_new(value: T) -> Result<Self> {
        // SAFETY: a block is never of size zero: it holds the count.
        let room = unsafe { alloc(Layout::new::<Block<T>>()) }.cast::<Block<T>>();
        let block = NonNull::new(room).ok_or(EngineError::Memory)?;
        let owners = AtomicUsize::new(1);
        // SAFETY: room for one block, aligned for it, and nobody else's.
        unsafe { block.write(Block { owners, value }) };
        Ok(Self {
            block,
            owns: PhantomData,
        })
    }

    fn block(&self) -> &Block<T> {
        // SAFETY: an owner keeps the block alive, and only shared references
        // to it are given out until the last owner drops it.
        unsafe { self.block.as_ref() }
    }
}

impl<T> Clone for Counted<T> {
    fn clone(&self) -> Self {
        // Whoever has an owner has seen the value: nothing to wait for.
        let before = self.block().owners.fetch_add(1, Ordering::Relaxed);
        // Owners that were leaked by the billion: no count is right any more.
        if before > usize::MAX / 2 {
            abort();
        }
        Self {
            block: self.block,
            owns: PhantomData,
        }
    }
}

impl<T> Deref for Counted<T> {
    type Target = T;

    fn deref(&self) -> &T {
        &self.block().value
    }
}

impl<T> Drop for Counted<T> {
    fn drop(&mut self) {
        // What other owners did with the value comes before it is dropped.
        if self.block().owners.fetch_sub(1, Ordering::Release) != 1 {
            return;
        }
        // A load and no fence, since ThreadSanitizer does not know fences.
        self.block().owners.load(Ordering::Acquire);
        // SAFETY: made by the global allocator with the layout of a block, as
        // a box is; this was the last owner.
        drop(unsafe { Box::from_raw(self.block.as_ptr()) });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Counts how often it is dropped.
    struct Dropped<'a>(&'a AtomicUsize);

    impl Drop for Dropped<'_> {
        fn drop(&mut self) {
            self.0.fetch_add(1, Ordering::Relaxed);
        }
    }

    #[test]
    fn the_value_goes_with_its_last_owner() {
        let drops = AtomicUsize::new(0);
        let first = Counted::try_new(Dropped(&drops)).expect("room");
        let second = first.clone();
        drop(first);
        assert_eq!(second.0.load(Ordering::Relaxed), 0);
        drop(second);
        assert_eq!(drops.load(Ordering::Relaxed), 1);
    }

    #[test]
    fn owners_come_and_go_on_several_threads() {
        let drops = AtomicUsize::new(0);
        let first = Counted::try_new((7, Dropped(&drops))).expect("room");
        std::thread::scope(|scope| {
            for _ in 0..4 {
                let mut mine = first.clone();
                scope.spawn(move || {
                    for _ in 0..if cfg!(miri) { 100 } else { 10_000 } {
                        let next = mine.clone();
                        assert_eq!(next.0, 7);
                        mine = next;
                    }
                });
            }
            drop(first);
        });
        assert_eq!(drops.load(Ordering::Relaxed), 1);
    }

    #[test]
    fn a_value_that_needs_much_alignment_has_it() {
        #[repr(align(256))]
        struct Wide(u8);
        let wide = Counted::try_new(Wide(3)).expect("room");
        assert!((&raw const *wide).addr().is_multiple_of(256) && wide.0 == 3);
    }
}
