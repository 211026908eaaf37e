//! An allocator that counts, and refuses, for tests of what something costs.
#![allow(dead_code, missing_docs, unreachable_pub)]
// Counting needs an allocator of its own, and an allocator is unsafe.
#![allow(unsafe_code)]

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

struct Counting;

thread_local! {
    static BYTES: Cell<usize> = const { Cell::new(0) };
    static LIVE: Cell<isize> = const { Cell::new(0) };
    static PEAK: Cell<isize> = const { Cell::new(0) };
    static MOST: Cell<usize> = const { Cell::new(usize::MAX) };
}

// SAFETY: everything is handed on to the system's allocator; the counters are
// plain cells without destructors, which may be used at any time of a thread.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        if layout.size() > MOST.get() {
            return std::ptr::null_mut();
        }
        BYTES.set(BYTES.get() + layout.size());
        LIVE.set(LIVE.get() + layout.size() as isize);
        PEAK.set(PEAK.get().max(LIVE.get()));
        // SAFETY: the caller's promises are those that the system's needs.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        LIVE.set(LIVE.get() - layout.size() as isize);
        // SAFETY: as above; the memory came from the system's allocator.
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// What something cost this thread.
pub struct Cost {
    /// Bytes allocated, whether or not they were freed again.
    pub bytes: usize,
    /// By how much it left more bytes in use.
    pub left: isize,
    /// How many more bytes than before were in use at once.
    pub peak: usize,
}

/// Runs `f` while this thread gets no more than `most` bytes at once.
pub fn with_at_most<T>(most: usize, f: impl FnOnce() -> T) -> T {
    MOST.set(most);
    let result = f();
    MOST.set(usize::MAX);
    result
}

pub fn cost(f: impl FnOnce()) -> Cost {
    let (bytes, live) = (BYTES.get(), LIVE.get());
    PEAK.set(live);
    f();
    Cost {
        bytes: BYTES.get() - bytes,
        left: LIVE.get() - live,
        peak: (PEAK.get() - live) as usize,
    }
}
