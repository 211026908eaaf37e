//! What the targets share: changes that know the shape of the files, so that
//! most of what is tried gets past TOML's surface; a count of the memory in
//! use; a folder in memory for what is read from files.

use std::alloc::{GlobalAlloc, Layout, System};
use std::path::PathBuf;
use std::sync::atomic::{AtomicUsize, Ordering};

mod mutate;

pub use mutate::{Words, mutate};

/// Hands everything on and counts what is in use.
struct Counting;

static LIVE: AtomicUsize = AtomicUsize::new(0);
static PEAK: AtomicUsize = AtomicUsize::new(0);

// SAFETY: everything is handed on to the system's allocator (or to the
// sanitizer's, which stands in its place).
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        let live = LIVE.fetch_add(layout.size(), Ordering::Relaxed) + layout.size();
        PEAK.fetch_max(live, Ordering::Relaxed);
        // SAFETY: the caller's promises are those that the system's needs.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        LIVE.fetch_sub(layout.size(), Ordering::Relaxed);
        // SAFETY: as above; the memory came from the system's allocator.
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// Bytes in use that need no file to be large: presets, sentences, poses that
/// are looked at, a piece's tree.
const BASE: usize = 4 << 20;

/// Bytes in use for each byte of a file: its tree, the path, what is prepared
/// for sampling, and two texts of it that are compared.
const PER_BYTE: usize = 600;

/// Runs a check of a file's bytes and holds its memory against their number.
pub fn bounded(bytes: &[u8], check: impl FnOnce(&[u8])) {
    let before = LIVE.load(Ordering::Relaxed);
    PEAK.store(before, Ordering::Relaxed);
    check(bytes);
    let peak = PEAK.load(Ordering::Relaxed) - before;
    let most = BASE + PER_BYTE * bytes.len();
    assert!(
        peak <= most,
        "{peak} bytes in use for a file of {}, more than {most}",
        bytes.len()
    );
}

/// A folder of this process alone, in memory where the system has such a place.
pub fn folder() -> PathBuf {
    let memory = PathBuf::from("/dev/shm");
    let base = if memory.is_dir() {
        memory
    } else {
        std::env::temp_dir()
    };
    let folder = base.join(format!("vides-fuzz-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder for the files");
    folder
}
