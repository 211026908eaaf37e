//! The clock by which windows know what is due, and what took how long.

use std::time::Instant;

/// The time. In tests it stands still until they let it pass: no machine is too slow for them.
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
