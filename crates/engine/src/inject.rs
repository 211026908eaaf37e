//! Faults on demand for tests (feature `inject`, see `tests/calls`): places where the library can
//! be told to panic, or to report that they are passed. Otherwise [`point`] does nothing.

/// Where a panic can be injected.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(not(feature = "inject"), allow(dead_code))]
pub enum Place {
    /// In an export, before its body.
    Call,
    /// In an export, while it holds a path.
    Path,
    /// Before any window is served.
    Dispatch,
    /// With an event of the X server.
    Event,
    /// In a window's turn, when the events have been taken.
    Turn,
    /// While the editor lays itself out.
    Layout,
    /// Before pixels are painted.
    Paint,
    /// Before poses are made ready for the host.
    HandOver,
    /// When the poses are ready, or could not be made.
    Prepared,
    /// Before host code is called.
    Callback,
}

/// Passes a place.
#[inline(always)]
pub fn point(place: Place) {
    #[cfg(feature = "inject")]
    on_demand::pass(place);
    #[cfg(not(feature = "inject"))]
    let _ = place;
}

#[cfg(feature = "inject")]
#[allow(unsafe_code)] // names for C
mod on_demand {
    use std::cell::Cell;
    use std::ffi::c_int;

    use super::Place;

    thread_local! {
        /// The watched place, its passes left before a panic (negative: never), and its passes so
        /// far.
        static WATCHED: Cell<(c_int, c_int, c_int)> = const { Cell::new((-1, -1, 0)) };
        /// Called at every place that is passed.
        static TOLD: Cell<Option<extern "C" fn(c_int)>> = const { Cell::new(None) };
    }

    pub(super) fn pass(place: Place) {
        if let Some(tell) = TOLD.get() {
            tell(place as c_int);
        }
        let (watched, left, passed) = WATCHED.get();
        if watched != place as c_int {
            return;
        }
        WATCHED.set((watched, (left - 1).max(-1), passed + 1));
        assert!(left != 0, "wanted by a test");
    }

    /// Watches a place: it panics once, after it was passed `after` times; never if negative.
    #[unsafe(no_mangle)]
    pub(super) extern "C" fn v_test_panic(place: c_int, after: c_int) {
        WATCHED.set((place, after.max(-1), 0));
    }

    /// Sets the function that is called at every place that is passed; NULL: none.
    #[unsafe(no_mangle)]
    pub(super) extern "C" fn v_test_tell(tell: Option<extern "C" fn(c_int)>) {
        TOLD.set(tell);
    }

    #[unsafe(no_mangle)]
    pub(super) extern "C" fn v_test_passed() -> c_int {
        WATCHED.get().2
    }
}
