//! The list of poses in its form of 1994 (thesis B.2.2, B.2.3).
//!
//! The first element is the host's, the others are made one by one with the
//! host's `malloc`. A list is built whole before anything of an old one is
//! touched; nothing here asks for memory in a way that cannot be refused.
//!
//! An old list is freed only if this library made it. A pointer cannot tell
//! that, and a host may have freed, relinked or never initialised what it
//! hands over; so the library remembers of each list its head, its second and
//! last element and its count ([`MADE`]), and follows pointers only where they
//! agree with that.

use std::ffi::c_int;
use std::mem::ManuallyDrop;
use std::ptr;
use std::sync::{Mutex, MutexGuard, PoisonError};

use super::types::{V_KAMERAPAR, V_POS};
use crate::error::{EngineError, OutOfRange};
use crate::limits::MAX_FRAMES;
use crate::path::Pose;
use vides_engine::Result;

/// Poses taken from the engine at a time: 20 KB, which stay in the
/// processor's first cache between being computed and being spread.
const BLOCK: usize = 256;

/// What is remembered of a list. Addresses are compared, never followed from
/// here.
#[derive(Clone, Copy, PartialEq)]
struct Made {
    head: usize,
    second: usize,
    last: usize,
    count: c_int,
}

/// The lists that this library made and has not freed, in the order of their
/// heads' addresses.
struct Registry(Vec<Made>);

static MADE: Mutex<Registry> = Mutex::new(Registry(Vec::new()));

fn made() -> MutexGuard<'static, Registry> {
    MADE.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Registry {
    /// Where the list of a head is, or would be.
    fn place(&self, head: usize) -> std::result::Result<usize, usize> {
        self.0.binary_search_by_key(&head, |list| list.head)
    }

    fn get(&self, head: usize) -> Option<&Made> {
        self.place(head).ok().map(|place| &self.0[place])
    }

    /// Remembers a list in place of what its head had before. There must be
    /// room for one more.
    fn insert(&mut self, list: Made) {
        match self.place(list.head) {
            Ok(place) => self.0[place] = list,
            Err(place) => self.0.insert(place, list),
        }
    }

    /// Forgets a list; with the last one the memory is given back, too.
    fn remove(&mut self, head: usize) {
        if let Ok(place) = self.place(head) {
            self.0.remove(place);
        }
        if self.0.is_empty() {
            self.0 = Vec::new();
        }
    }
}

/// Elements of a list while it is built, from the second on: linked among
/// themselves, not yet to the head. Dropped before [`publish`] took it over, it
/// frees them.
struct Chain {
    second: *mut V_KAMERAPAR,
    last: *mut V_KAMERAPAR,
    /// Elements, and one for the head.
    count: c_int,
}

impl Chain {
    const fn new() -> Self {
        Self {
            second: ptr::null_mut(),
            last: ptr::null_mut(),
            count: 1,
        }
    }

    /// Appends one element.
    #[inline]
    fn push(&mut self, pose: &Pose) -> Result<()> {
        // SAFETY: malloc takes any size.
        let element = unsafe { libc::malloc(size_of::<V_KAMERAPAR>()) }.cast::<V_KAMERAPAR>();
        if element.is_null() {
            return Err(EngineError::Memory);
        }
        self.count += 1;
        let mut value = converted(pose);
        value.prev = self.last;
        value.number = self.count;
        // SAFETY: malloc gave room for one element, aligned for any type.
        unsafe { element.write(value) };
        if self.last.is_null() {
            self.second = element;
        } else {
            // SAFETY: `last` is the element that was written before this one.
            unsafe { (*self.last).next = element };
        }
        self.last = element;
        Ok(())
    }
}

impl Default for Chain {
    fn default() -> Self {
        Self::new()
    }
}

impl Drop for Chain {
    fn drop(&mut self) {
        let mut element = self.second;
        for _ in 1..self.count {
            // SAFETY: `count` - 1 elements of malloc's hang together by `next`;
            // nobody else has seen them.
            unsafe {
                let next = (*element).next;
                libc::free(element.cast());
                element = next;
            }
        }
    }
}

/// A pose in the form of 1994, without links and number.
#[inline]
fn converted(pose: &Pose) -> V_KAMERAPAR {
    V_KAMERAPAR {
        VRP: narrowed(pose.vrp),
        VPN: narrowed(pose.vpn),
        VUP: narrowed(pose.vup),
        zoom: rounded(pose.zoom),
        prev: ptr::null_mut(),
        next: ptr::null_mut(),
        number: 0,
    }
}

#[inline]
fn narrowed([x, y, z]: [f64; 3]) -> V_POS {
    V_POS {
        x: x as f32,
        y: y as f32,
        z: z as f32,
    }
}

/// Rounds half away from zero. A zoom lies between 1 and 100, where to add a
/// half and to cut off is exact and takes no call of the mathematics library.
#[inline]
fn rounded(zoom: f64) -> c_int {
    (zoom + 0.5) as c_int
}

/// Builds a list of `frames` poses on the host's element `first`. A list that was
/// there, if this library made it, gives its elements to the new one as far as that
/// goes, and the others are freed. `fill(n, poses)` computes
/// the poses number n, n + 1, … (counted from 1).
///
/// # Errors
/// Those of `fill`, `ErrorKind::Memory`; the old list is then as it was.
///
/// # Safety
/// `first` points to an element of the host's. If its number is not negative,
/// then a list that this library made there either still exists as it was
/// made, or its first element's links have changed.
pub(super) unsafe fn build(
    frames: usize,
    first: *mut V_KAMERAPAR,
    mut fill: impl FnMut(usize, &mut [Pose]) -> Result<()>,
) -> Result<()> {
    // `count` below numbers them all.
    const { assert!(MAX_FRAMES <= c_int::MAX as usize) };
    let mut scratch = [Pose::default(); BLOCK];
    let mut chain = Chain::new();
    let mut head = None;
    let mut done = 0;
    while done < frames {
        let block = &mut scratch[..BLOCK.min(frames - done)];
        fill(done + 1, block)?;
        done += block.len();
        let mut poses = block.iter();
        if head.is_none() {
            head = poses.next().map(converted);
        }
        for pose in poses {
            chain.push(pose)?;
        }
    }
    let Some(head) = head else {
        return Err(OutOfRange::NoPose.into());
    };
    // SAFETY: the caller's word.
    unsafe { publish(chain, head, first) }
}

/// Puts a complete list in the place of whatever the head held.
///
/// # Safety
/// As for [`build`].
unsafe fn publish(chain: Chain, head: V_KAMERAPAR, first: *mut V_KAMERAPAR) -> Result<()> {
    let mut made = made();
    // The last thing that can fail. Dropping the chain frees it.
    made.0.try_reserve(1)?;
    // SAFETY: the caller's word.
    let old = unsafe { known(&made, first) };
    let (chain, spare) = match old {
        // SAFETY: found whole.
        Some(old) => unsafe { reuse(chain, old) },
        None => (chain, Spare::default()),
    };
    let chain = ManuallyDrop::new(chain);
    let single = chain.last.is_null();
    let second = if single { first } else { chain.second };
    let last = if single { first } else { chain.last };
    made.insert(Made {
        head: first.addr(),
        second: second.addr(),
        last: last.addr(),
        count: chain.count,
    });
    drop(made);
    // SAFETY: `first` is the host's element, `second` and `last` are complete
    // elements of the chain, or `first` itself.
    unsafe {
        first.write(V_KAMERAPAR { number: 1, ..head });
        (*first).next = second;
        (*first).prev = last;
        (*second).prev = first;
        (*last).next = first;
    }
    drop(spare);
    Ok(())
}

/// Elements of which a new list has no need.
type Spare = [Chain; 2];

/// Puts poses into the elements of an old list as far as both go, so that a host that
/// kept one of them has it still; behind them the list goes on with its own elements.
///
/// # Safety
/// The old list was found whole by [`known`].
unsafe fn reuse(chain: Chain, old: Known) -> (Chain, Spare) {
    let chain = ManuallyDrop::new(chain);
    let both = chain.count.min(old.count);
    let (mut from, mut into) = (chain.second, old.second);
    let mut last = ptr::null_mut();
    for _ in 1..both {
        // SAFETY: both have so many elements.
        unsafe {
            let pose = from.read();
            into.write(V_KAMERAPAR {
                prev: (*into).prev,
                next: (*into).next,
                ..pose
            });
            last = into;
            (from, into) = (pose.next, (*into).next);
        }
    }
    if chain.count > both && !last.is_null() {
        // SAFETY: elements of either list.
        unsafe {
            (*last).next = from;
            (*from).prev = last;
        }
        last = chain.last;
    }
    let piece = |second, last, count| Chain {
        second,
        last,
        count,
    };
    if both == 1 {
        let all = piece(chain.second, chain.last, chain.count);
        return (all, [Chain::new(), piece(into, into, old.count)]);
    }
    let used = piece(chain.second, chain.second, both);
    let rest = piece(into, into, old.count - both + 1);
    (piece(old.second, last, chain.count), [used, rest])
}

/// Frees all elements but the first of a list that this library made, and sets
/// the first one's number to −1. Nothing happens to a list that is none
/// (number < 0), nor to any other; `false` for that.
///
/// # Safety
/// As for [`build`].
pub(super) unsafe fn free(first: *mut V_KAMERAPAR) -> bool {
    let mut made = made();
    // SAFETY: the host's element.
    let number = unsafe { &mut (*first).number };
    if *number < 0 {
        made.remove(first.addr());
        return true;
    }
    // SAFETY: the caller's word.
    let Some(old) = (unsafe { known(&made, first) }) else {
        return false;
    };
    made.remove(first.addr());
    drop(made);
    // SAFETY: found whole, and nobody can find it any more.
    unsafe {
        (*first).number = -1;
        release(old);
    }
    true
}

/// Elements that may be freed: the second one and the count of the list.
struct Known {
    second: *mut V_KAMERAPAR,
    count: c_int,
}

/// The list at a head, if it is one that this library made, whole and as it
/// was made. What the host has changed is the host's.
///
/// # Safety
/// As for [`build`].
unsafe fn known(made: &Registry, first: *mut V_KAMERAPAR) -> Option<Known> {
    let entry = made.get(first.addr())?;
    // SAFETY: the caller's word.
    let head = unsafe { first.read() };
    let named = Made {
        second: head.next.addr(),
        last: head.prev.addr(),
        ..*entry
    };
    if head.number < 0 || named != *entry {
        return None;
    }
    // The host says that there are data, and the links are those that were
    // made. Every element must hang where it was hung.
    let (mut before, mut element) = (first, head.next);
    for number in 2..=entry.count {
        // SAFETY: `element` is the second element as it was made, or what the
        // element before it, found in order, points to.
        let found = unsafe { element.read() };
        if found.number != number || found.prev != before {
            return None;
        }
        (before, element) = (element, found.next);
    }
    (before == head.prev && element == first).then_some(Known {
        second: head.next,
        count: entry.count,
    })
}

/// Frees a list's elements from the second on.
///
/// # Safety
/// The list was found whole by [`known`].
unsafe fn release(known: Known) {
    drop(Chain {
        second: known.second,
        last: ptr::null_mut(),
        count: known.count,
    });
}
