//! The list of poses in its form of 1994 (thesis B.2.2, B.2.3).
//!
//! The first element is the host's; each further one is allocated with the host's `malloc`. A
//! list is built whole before an old one is touched, and no allocation may abort.
//!
//! An old list is freed only if this library made it. A host may have freed, relinked or never
//! initialised what it passes; so the library records each list's head, second and last element and
//! count ([`MADE`]), and follows pointers only where they agree.

use std::ffi::c_int;
use std::mem::ManuallyDrop;
use std::ptr;
use std::sync::{Mutex, MutexGuard, PoisonError};

use super::types::{V_KAMERAPAR, V_POS};
use crate::error::{EngineError, OutOfRange};
use crate::limits::{MAX_FRAMES, MAX_LIST_ZOOM};
use crate::path::Pose;
use vides_engine::Result;

/// Poses taken from the engine at a time: 20 KB, which stay in the L1 cache.
const BLOCK: usize = 256;

/// What is recorded of a list. The addresses are only compared.
#[derive(Clone, Copy, PartialEq)]
struct Made {
    head: usize,
    second: usize,
    last: usize,
    count: c_int,
}

/// The lists this library made and has not freed, sorted by head.
struct Registry(Vec<Made>);

static MADE: Mutex<Registry> = Mutex::new(Registry(Vec::new()));

fn made() -> MutexGuard<'static, Registry> {
    MADE.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Registry {
    /// The index of a head's list, or where to insert it.
    fn place(&self, head: usize) -> std::result::Result<usize, usize> {
        self.0.binary_search_by_key(&head, |list| list.head)
    }

    fn get(&self, head: usize) -> Option<&Made> {
        self.place(head).ok().map(|place| &self.0[place])
    }

    /// Records a list in place of its head's previous one. The capacity must suffice.
    fn insert(&mut self, list: Made) {
        match self.place(list.head) {
            Ok(place) => self.0[place] = list,
            Err(place) => self.0.insert(place, list),
        }
    }

    /// Forgets a list; with the last one, frees the memory.
    fn remove(&mut self, head: usize) {
        if let Ok(place) = self.place(head) {
            self.0.remove(place);
        }
        if self.0.is_empty() {
            self.0 = Vec::new();
        }
    }
}

/// A list under construction, from the second element on, not yet linked to the head. Frees its
/// elements when dropped before [`publish`] takes them over.
struct Chain {
    second: *mut V_KAMERAPAR,
    last: *mut V_KAMERAPAR,
    /// The number of elements, plus one for the head.
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
            // SAFETY: `last` is the element written before this one.
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
            // SAFETY: `count` - 1 elements from malloc are linked by `next`, and unshared.
            unsafe {
                let next = (*element).next;
                libc::free(element.cast());
                element = next;
            }
        }
    }
}

/// Converts a pose to the form of 1994, without links and number.
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

/// Rounds half up, without a call of libm, exact for a zoom. Lists of 1994 have none
/// above 100.
#[inline]
fn rounded(zoom: f64) -> c_int {
    (zoom.min(MAX_LIST_ZOOM) + 0.5) as c_int
}

/// Builds a list of `frames` poses on the host's element `first`; `fill(n, poses)` computes the
/// poses from number n on (counted from 1). The elements of an old list made by this library are
/// reused as far as needed, and the others freed. On failure (of `fill`, or `ErrorKind::Memory`)
/// the old list is unchanged.
/// # Safety
/// `first` points to an element of the host's. If its number is not negative, a list made there by
/// this library is either unchanged, or its first element's links have changed.
pub(super) unsafe fn build(
    frames: usize,
    first: *mut V_KAMERAPAR,
    mut fill: impl FnMut(usize, &mut [Pose]) -> Result<()>,
) -> Result<()> {
    // Elements are numbered by a `c_int`.
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
    // SAFETY: as required of the caller.
    unsafe { publish(chain, head, first) }
}

/// Replaces whatever the head held by a complete list.
///
/// # Safety
/// As for [`build`].
unsafe fn publish(chain: Chain, head: V_KAMERAPAR, first: *mut V_KAMERAPAR) -> Result<()> {
    let mut made = made();
    // The last step that can fail; the chain is then freed by its drop.
    made.0.try_reserve(1)?;
    // SAFETY: as required of the caller.
    let old = unsafe { known(&made, first) };
    let (chain, spare) = match old {
        // SAFETY: `known` found it whole.
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
    // SAFETY: `first` is the host's element; `second` and `last` are elements of the chain or
    // `first` itself.
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

/// Elements left over from a reuse, to be freed.
type Spare = [Chain; 2];

/// Copies poses into the elements of an old list as far as both go, so that pointers a host kept
/// stay valid; beyond, the new elements are linked.
///
/// # Safety
/// The old list was found whole by [`known`].
unsafe fn reuse(chain: Chain, old: Known) -> (Chain, Spare) {
    let chain = ManuallyDrop::new(chain);
    let both = chain.count.min(old.count);
    let (mut from, mut into) = (chain.second, old.second);
    let mut last = ptr::null_mut();
    for _ in 1..both {
        // SAFETY: both lists have that many elements.
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

/// Frees all elements but the first of a list made by this library, and sets the first one's number
/// to −1. Does nothing if that is negative already; `false`, and nothing changed, for any other
/// list.
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
    // SAFETY: as required of the caller.
    let Some(old) = (unsafe { known(&made, first) }) else {
        return false;
    };
    made.remove(first.addr());
    drop(made);
    // SAFETY: found whole, and no longer recorded.
    unsafe {
        (*first).number = -1;
        release(old);
    }
    true
}

/// Elements that may be freed: the second one and the list's count.
struct Known {
    second: *mut V_KAMERAPAR,
    count: c_int,
}

/// The list at a head, if this library made it and every link and number is unchanged; anything the
/// host has changed belongs to the host.
///
/// # Safety
/// As for [`build`].
unsafe fn known(made: &Registry, first: *mut V_KAMERAPAR) -> Option<Known> {
    let entry = made.get(first.addr())?;
    // SAFETY: as required of the caller.
    let head = unsafe { first.read() };
    let named = Made {
        second: head.next.addr(),
        last: head.prev.addr(),
        ..*entry
    };
    if head.number < 0 || named != *entry {
        return None;
    }
    // Follow the links, each of which must be as made.
    let (mut before, mut element) = (first, head.next);
    for number in 2..=entry.count {
        // SAFETY: `element` is the recorded second element, or the successor of an element found
        // unchanged.
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
