//! The one descriptor that a host watches for all windows of a thread: an epoll of their
//! connections and one timer.
//!
//! The timer also announces work that no connection announces: a new window, events that were read
//! along with a reply, a round that was cut short. The host needs no timers, and an idle
//! window never wakes it.

#![allow(unsafe_code)] // system calls

use std::io;
use std::os::fd::{AsRawFd, BorrowedFd, FromRawFd, OwnedFd, RawFd};
use std::time::{Duration, Instant};

use vides_engine::descriptor::off_standard;

use crate::clock;
use crate::error::{Error, Result};

pub(super) struct Descriptors {
    epoll: OwnedFd,
    timer: OwnedFd,
    armed: Armed,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Armed {
    No,
    /// Readable until the timer is set again.
    Now,
    At(Instant),
}

impl Descriptors {
    /// Both are close-on-exec.
    pub(super) fn new() -> Result<Self> {
        // SAFETY: a system call without pointers.
        let epoll = unsafe { owned(libc::epoll_create1(libc::EPOLL_CLOEXEC)) }?;
        let flags = libc::TFD_CLOEXEC | libc::TFD_NONBLOCK;
        // SAFETY: as above.
        let timer = unsafe { owned(libc::timerfd_create(libc::CLOCK_MONOTONIC, flags)) }?;
        let made = Self {
            epoll,
            timer,
            armed: Armed::No,
        };
        made.control(libc::EPOLL_CTL_ADD, made.timer.as_raw_fd())?;
        Ok(made)
    }

    /// The descriptor that the host watches.
    pub(super) fn raw(&self) -> RawFd {
        self.epoll.as_raw_fd()
    }

    pub(super) fn watch(&self, connection: BorrowedFd<'_>) -> Result<()> {
        self.control(libc::EPOLL_CTL_ADD, connection.as_raw_fd())
    }

    /// Stops watching a connection. It is no error if it was not watched.
    pub(super) fn leave(&self, connection: BorrowedFd<'_>) {
        let _ = self.control(libc::EPOLL_CTL_DEL, connection.as_raw_fd());
    }

    fn control(&self, operation: i32, descriptor: RawFd) -> Result<()> {
        let mut event = libc::epoll_event {
            events: libc::EPOLLIN as u32,
            u64: 0,
        };
        // SAFETY: `event` is alive during the call, which copies it.
        let done =
            unsafe { libc::epoll_ctl(self.epoll.as_raw_fd(), operation, descriptor, &mut event) };
        if done == 0 { Ok(()) } else { Err(refused()) }
    }

    /// Makes the descriptor readable at this time, at once if it has passed; never for `None`.
    pub(super) fn wake_at(&mut self, due: Option<Instant>, now: Instant) {
        let wanted = match due {
            None => Armed::No,
            Some(due) if due <= now => Armed::Now,
            Some(due) => Armed::At(due),
        };
        // An expired timer remains readable until it is set again.
        let rang = matches!(self.armed, Armed::At(due) if due <= now);
        if wanted == self.armed && !rang {
            return;
        }
        let wait = match wanted {
            Armed::No => Duration::ZERO,
            Armed::Now => Duration::from_nanos(1),
            Armed::At(due) => due.saturating_duration_since(now),
        };
        let setting = libc::itimerspec {
            it_interval: timespec(Duration::ZERO),
            it_value: timespec(wait),
        };
        // SAFETY: `setting` is alive during the call; the old setting is not requested.
        let done = unsafe {
            libc::timerfd_settime(
                self.timer.as_raw_fd(),
                0,
                &raw const setting,
                std::ptr::null_mut(),
            )
        };
        debug_assert_eq!(done, 0, "a timer that is one");
        self.armed = wanted;
    }

    /// Makes the descriptor readable at once.
    pub(super) fn ring(&mut self) {
        let now = clock::now();
        self.wake_at(Some(now), now);
    }

    /// How long until the timer makes the descriptor readable.
    pub(super) fn wait(&self, now: Instant) -> Option<Duration> {
        match self.armed {
            Armed::No => None,
            Armed::Now => Some(Duration::ZERO),
            Armed::At(due) => Some(due.saturating_duration_since(now)),
        }
    }

    /// Keeps the descriptors open for good, because an Xt context still watches them.
    pub(super) fn leak(self) {
        std::mem::forget(self);
    }
}

/// Sleeps until the epoll with this descriptor, which must be open, is readable or a signal
/// arrives.
pub(super) fn sleep_on(epoll: RawFd) {
    let mut event = libc::epoll_event { events: 0, u64: 0 };
    // SAFETY: room for the one event that is requested.
    let _ = unsafe { libc::epoll_wait(epoll, &mut event, 1, -1) };
}

/// Which of these poll(2) events a descriptor has now, or whether it is at its end.
pub(super) fn events_of(descriptor: RawFd, events: libc::c_short) -> libc::c_short {
    let mut poll = libc::pollfd {
        fd: descriptor,
        events,
        revents: 0,
    };
    // SAFETY: one element, alive during the call.
    let found = unsafe { libc::poll(&mut poll, 1, 0) };
    if found == 1 { poll.revents } else { 0 }
}

fn timespec(duration: Duration) -> libc::timespec {
    libc::timespec {
        tv_sec: libc::time_t::try_from(duration.as_secs()).unwrap_or(libc::time_t::MAX),
        // Less than 1e9, so it fits any long.
        tv_nsec: duration.subsec_nanos() as libc::c_long,
    }
}

fn refused() -> Error {
    Error::NoDescriptor(io::Error::last_os_error())
}

/// # Safety
/// No one else owns the descriptor, or it is -1.
unsafe fn owned(descriptor: RawFd) -> Result<OwnedFd> {
    if descriptor < 0 {
        return Err(refused());
    }
    // SAFETY: as the caller promises.
    off_standard(unsafe { OwnedFd::from_raw_fd(descriptor) }).map_err(|_| refused())
}

#[cfg(test)]
mod tests {
    use std::io::{Read as _, Write as _};
    use std::os::fd::AsFd as _;
    use std::os::unix::net::UnixStream;

    use super::*;

    fn readable(descriptors: &Descriptors, wait: i32) -> bool {
        let mut poll = libc::pollfd {
            fd: descriptors.raw(),
            events: libc::POLLIN,
            revents: 0,
        };
        // SAFETY: one element, alive during the call.
        unsafe { libc::poll(&mut poll, 1, wait) == 1 }
    }

    #[test]
    fn connections_and_the_timer_make_it_readable() {
        let mut descriptors = Descriptors::new().expect("descriptors");
        let (mut ours, mut theirs) = UnixStream::pair().expect("a pair");
        assert!(!readable(&descriptors, 0));
        descriptors.watch(ours.as_fd()).expect("watched");
        theirs.write_all(b"x").expect("written");
        assert!(readable(&descriptors, 1000));
        descriptors.leave(ours.as_fd());
        descriptors.leave(ours.as_fd());
        assert!(!readable(&descriptors, 0));
        descriptors.watch(ours.as_fd()).expect("watched");
        assert!(readable(&descriptors, 0));
        ours.read_exact(&mut [0]).expect("read");
        assert!(!readable(&descriptors, 0));

        descriptors.ring();
        assert_eq!(descriptors.wait(Instant::now()), Some(Duration::ZERO));
        assert!(readable(&descriptors, 1000));
        descriptors.wake_at(None, Instant::now());
        assert!(!readable(&descriptors, 0));
        assert_eq!(descriptors.wait(Instant::now()), None);
    }

    #[test]
    fn a_time_that_came_rings_until_it_is_set_anew() {
        let mut descriptors = Descriptors::new().expect("descriptors");
        let due = Instant::now() + Duration::from_millis(20);
        descriptors.wake_at(Some(due), Instant::now());
        assert!(!readable(&descriptors, 0));
        assert!(readable(&descriptors, 5000));
        assert!(readable(&descriptors, 0));
        descriptors.wake_at(None, Instant::now());
        assert!(!readable(&descriptors, 0));
    }

    #[test]
    fn programs_that_are_started_inherit_nothing() {
        let descriptors = Descriptors::new().expect("descriptors");
        for descriptor in [descriptors.raw(), descriptors.timer.as_raw_fd()] {
            // SAFETY: no pointers.
            let flags = unsafe { libc::fcntl(descriptor, libc::F_GETFD) };
            assert!(flags >= 0 && flags & libc::FD_CLOEXEC != 0);
        }
    }
}
