//! The clock for timers and durations.

use std::time::Instant;

/// The current time. Tests advance it themselves, so they do not depend on the speed of the
/// machine.
pub(super) fn now() -> Instant {
    #[cfg(not(test))]
    return Instant::now();
    #[cfg(test)]
    fake::NOW.get()
}

#[cfg(test)]
pub(super) use fake::pass;

#[cfg(test)]
mod fake {
    use std::cell::Cell;
    use std::time::{Duration, Instant};

    thread_local! {
        pub(super) static NOW: Cell<Instant> = Cell::new(Instant::now());
    }

    pub(crate) fn pass(time: Duration) {
        NOW.set(NOW.get() + time);
    }
}
