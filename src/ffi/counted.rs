//! An `Arc` whose allocation can fail: `Arc::new` aborts when memory runs out, but the header
//! promises a status. Has only what handles need.

use std::alloc::{Layout, alloc};
use std::marker::PhantomData;
use std::ops::Deref;
use std::process::abort;
use std::ptr::NonNull;
use std::sync::atomic::{AtomicUsize, Ordering};

use crate::error::{EngineError, Result};

/// An owner of a shared value on the heap.
#[derive(Debug)]
pub(super) struct TryArc<T> {
    block: NonNull<Block<T>>,
    owns: PhantomData<Block<T>>,
}

#[derive(Debug)]
struct Block<T> {
    owners: AtomicUsize,
    value: T,
}

// SAFETY: owners on several threads share the value (hence `Sync`), and the last one drops it on
// whatever thread it is (hence `Send`); the count is atomic.
unsafe impl<T: Send + Sync> Send for TryArc<T> {}
// SAFETY: as above; a shared owner can be cloned into one of another thread.
unsafe impl<T: Send + Sync> Sync for TryArc<T> {}

impl<T> TryArc<T> {
    /// Allocates the value with its first owner. Fails with `ErrorKind::Memory`.
    pub(super) fn try_new(value: T) -> Result<Self> {
        // SAFETY: a block is never of size zero: it holds the count.
        let room = unsafe { alloc(Layout::new::<Block<T>>()) }.cast::<Block<T>>();
        let block = NonNull::new(room).ok_or(EngineError::Memory)?;
        let owners = AtomicUsize::new(1);
        // SAFETY: freshly allocated with the block's size and alignment, and unshared.
        unsafe { block.write(Block { owners, value }) };
        Ok(Self {
            block,
            owns: PhantomData,
        })
    }

    fn block(&self) -> &Block<T> {
        // SAFETY: an owner keeps the block alive, and until the last one drops it only shared
        // references exist.
        unsafe { self.block.as_ref() }
    }
}

impl<T> Clone for TryArc<T> {
    fn clone(&self) -> Self {
        // An existing owner has already synchronized with the value.
        let before = self.block().owners.fetch_add(1, Ordering::Relaxed);
        // As in `Arc`: owners leaked by the billion could overflow the count.
        if before > usize::MAX / 2 {
            abort();
        }
        Self {
            block: self.block,
            owns: PhantomData,
        }
    }
}

impl<T> Deref for TryArc<T> {
    type Target = T;

    fn deref(&self) -> &T {
        &self.block().value
    }
}

impl<T> Drop for TryArc<T> {
    fn drop(&mut self) {
        // Other owners' accesses happen before the drop.
        if self.block().owners.fetch_sub(1, Ordering::Release) != 1 {
            return;
        }
        // A load instead of a fence, which ThreadSanitizer does not support.
        self.block().owners.load(Ordering::Acquire);
        // SAFETY: allocated by the global allocator with a block's layout, like a box; this was the
        // last owner.
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
        let first = TryArc::try_new(Dropped(&drops)).expect("room");
        let second = first.clone();
        drop(first);
        assert_eq!(second.0.load(Ordering::Relaxed), 0);
        drop(second);
        assert_eq!(drops.load(Ordering::Relaxed), 1);
    }

    #[test]
    fn owners_come_and_go_on_several_threads() {
        let drops = AtomicUsize::new(0);
        let first = TryArc::try_new((7, Dropped(&drops))).expect("room");
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
        let wide = TryArc::try_new(Wide(3)).expect("room");
        assert!((&raw const *wide).addr().is_multiple_of(256) && wide.0 == 3);
    }
}
