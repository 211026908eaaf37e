//! The byte stream to and from the X server, below x11rb's connection.
//!
//! x11rb's own stream cannot be used: writing to a server that is gone must not raise SIGPIPE in
//! the host, and a server that does not answer must not block it. Writes never wait: what the
//! socket does not take is queued, and [`Stream::watch`] becomes readable when it can be sent. Only
//! reads of replies wait, for at most [`REPLY_TIMEOUT`].

use std::cell::{Cell, RefCell};
use std::collections::VecDeque;
use std::io::{Error, ErrorKind, IoSlice, Result};
use std::mem::MaybeUninit;
use std::os::fd::{AsFd, BorrowedFd, OwnedFd};
use std::time::{Duration, Instant};

use rustix::event::epoll::{self, EventData, EventFlags};
use rustix::event::{PollFd, PollFlags, Timespec};
use rustix::io::{Errno, retry_on_intr};
use rustix::net::{RecvFlags, SendAncillaryBuffer, SendAncillaryMessage, SendFlags, recv, sendmsg};
use vides_engine::descriptor::off_standard;
use x11rb::rust_connection::PollMode;
use x11rb::utils::RawFdContainer;

use super::packets::Packets;

/// How long to wait for a reply once the window is open, whatever else arrives. After a timeout
/// there is no waiting until the server speaks again.
pub(super) const REPLY_TIMEOUT: Duration = Duration::from_secs(1);

/// How long not to wait after a server has sent events but no reply, perhaps because another client
/// has grabbed it. So the host is blocked for at most one second in six.
const BACKOFF: Duration = Duration::from_secs(5);

/// The maximum number of bytes read while waiting for replies before events must be handled: about
/// 130,000 events, six times the bytes once in x11rb's queue. Replies are far smaller.
const MOST_BEFORE_ANSWER: usize = 4 << 20;

/// The limit for unsent output, in bytes. Images are sent in pieces, each after the one before has
/// arrived, so reaching the limit means that something is wrong.
const MOST_WAITING: usize = 16 << 20;

/// The maximum number of bytes read before events are handled. A faster sender waits, and takes no
/// memory here.
const MOST_AT_ONCE: usize = 64 << 10;

const MOST_DESCRIPTORS: usize = 4;

#[derive(Debug)]
pub(super) struct Stream {
    socket: OwnedFd,
    /// An epoll descriptor that watches the socket.
    watch: OwnedFd,
    waiting: RefCell<Waiting>,
    /// The deadline for all replies; `None` allows [`REPLY_TIMEOUT`] for each.
    deadline: Cell<Option<Instant>>,
    awaited: Cell<Option<Awaited>>,
    /// A reply timed out, and nothing was received since.
    silent: Cell<bool>,
    /// No waiting until then, because input arrived but no reply.
    backoff_until: Cell<Option<Instant>>,
    /// Bytes read since x11rb last got `WouldBlock`.
    taken: Cell<usize>,
    /// Bytes read but not yet handled.
    ahead: Cell<usize>,
    packets: Cell<Packets>,
}

/// The wait for a reply, from the first poll for it until the next request.
#[derive(Clone, Copy, Debug)]
struct Awaited {
    end: Instant,
    taken: usize,
}

/// Output the socket did not take yet.
#[derive(Debug, Default)]
struct Waiting {
    bytes: VecDeque<u8>,
    descriptors: Vec<OwnedFd>,
    /// The epoll descriptor also watches for room to send.
    watched: bool,
}

impl Stream {
    /// `deadline` holds for all replies together, until [`Stream::settle`].
    pub(super) fn new(socket: OwnedFd, deadline: Instant) -> Result<Self> {
        let watch = off_standard(epoll::create(epoll::CreateFlags::CLOEXEC)?)?;
        epoll::add(&watch, &socket, EventData::new_u64(0), EventFlags::IN)?;
        Ok(Self {
            socket,
            watch,
            waiting: RefCell::default(),
            deadline: Cell::new(Some(deadline)),
            awaited: Cell::new(None),
            silent: Cell::new(false),
            backoff_until: Cell::new(None),
            taken: Cell::new(0),
            ahead: Cell::new(0),
            packets: Cell::default(),
        })
    }

    pub(super) fn settle(&self) {
        self.deadline.set(None);
    }

    pub(super) fn watch(&self) -> BorrowedFd<'_> {
        self.watch.as_fd()
    }

    pub(super) fn looked_at(&self, bytes: usize) {
        self.ahead.set(self.ahead.get().saturating_sub(bytes));
    }

    /// Sends as much queued output as the socket takes.
    pub(super) fn push(&self) -> Result<()> {
        let mut waiting = self.waiting.borrow_mut();
        let Waiting {
            bytes, descriptors, ..
        } = &mut *waiting;
        while !bytes.is_empty() {
            let (front, back) = bytes.as_slices();
            let slices = [IoSlice::new(front), IoSlice::new(back)];
            match send(self.socket.as_fd(), &slices, descriptors) {
                Ok(sent) => drop(bytes.drain(..sent)),
                Err(error) if error.kind() == ErrorKind::WouldBlock => break,
                Err(error) => return Err(error),
            }
        }
        if bytes.is_empty() {
            bytes.shrink_to(64 << 10);
        }
        self.look_for_room(&mut waiting)
    }

    pub(super) fn waiting(&self) -> usize {
        self.waiting.borrow().bytes.len()
    }

    fn look_for_room(&self, waiting: &mut Waiting) -> Result<()> {
        let wanted = !waiting.bytes.is_empty();
        if wanted != waiting.watched {
            let mut events = EventFlags::IN;
            events.set(EventFlags::OUT, wanted);
            epoll::modify(&self.watch, &self.socket, EventData::new_u64(0), events)?;
            waiting.watched = wanted;
        }
        Ok(())
    }

    /// Sends `slices`, and queues what the socket does not take.
    fn take(&self, slices: &[IoSlice<'_>], fds: &mut Vec<RawFdContainer>) -> Result<usize> {
        let length = slices.iter().map(|slice| slice.len()).sum::<usize>();
        self.awaited.set(None);
        self.push()?;
        let mut waiting = self.waiting.borrow_mut();
        waiting.descriptors.append(fds);
        let mut sent = 0;
        if waiting.bytes.is_empty() {
            match send(self.socket.as_fd(), slices, &mut waiting.descriptors) {
                Ok(count) => sent = count,
                Err(error) if error.kind() == ErrorKind::WouldBlock => {}
                Err(error) => return Err(error),
            }
        }
        if sent == length && waiting.descriptors.is_empty() {
            return Ok(length);
        }
        if waiting.bytes.len() + (length - sent) > MOST_WAITING {
            return Err(ErrorKind::TimedOut.into());
        }
        (waiting.bytes.try_reserve(length - sent)).map_err(|_| ErrorKind::OutOfMemory)?;
        for slice in slices {
            let skipped = sent.min(slice.len());
            sent -= skipped;
            waiting.bytes.extend(&slice[skipped..]);
        }
        self.look_for_room(&mut waiting)?;
        Ok(length)
    }

    fn reply_timeout(&self) -> Duration {
        match self.deadline.get() {
            Some(deadline) => deadline.saturating_duration_since(Instant::now()),
            None if self.silent.get() || self.backs_off() => Duration::ZERO,
            None => REPLY_TIMEOUT,
        }
    }

    fn backs_off(&self) -> bool {
        (self.backoff_until.get()).is_some_and(|end| Instant::now() < end)
    }

    fn give_up(&self, awaited: Awaited) -> Error {
        self.awaited.set(None);
        if self.backs_off() {
            // It did not wait, so this shows nothing about the server.
        } else if awaited.taken == 0 {
            self.silent.set(true);
        } else {
            self.backoff_until.set(Some(Instant::now() + BACKOFF));
        }
        ErrorKind::TimedOut.into()
    }
}

impl x11rb::rust_connection::Stream for Stream {
    /// Always writable. For reading, waits until the reply's deadline, whatever else arrives.
    fn poll(&self, mode: PollMode) -> Result<()> {
        if mode.writable() {
            return Ok(());
        }
        let awaited = self.awaited.get().unwrap_or_else(|| Awaited {
            end: Instant::now() + self.reply_timeout(),
            taken: 0,
        });
        self.awaited.set(Some(awaited));
        let late = || Instant::now() >= awaited.end;
        let much = self.ahead.get() >= MOST_BEFORE_ANSWER;
        // Input that is already there is read once, even after the deadline.
        if awaited.taken > 0 && (much || late()) {
            return Err(self.give_up(awaited));
        }
        if much {
            return Err(ErrorKind::TimedOut.into());
        }
        loop {
            self.push()?;
            let mut events = PollFlags::IN;
            events.set(PollFlags::OUT, self.waiting() > 0);
            let left = awaited.end.saturating_duration_since(Instant::now());
            let ready = wait(self.socket.as_fd(), events, left)?;
            if !(ready - PollFlags::OUT).is_empty() {
                return Ok(()); // what it was is told by reading
            }
            if ready.is_empty() && late() {
                return Err(self.give_up(awaited));
            }
        }
    }

    /// x11rb reads until `WouldBlock`, so this returns it now and then even if there is more.
    fn read(&self, buf: &mut [u8], _: &mut Vec<RawFdContainer>) -> Result<usize> {
        let taken = self.taken.take();
        if taken >= MOST_AT_ONCE {
            return Err(ErrorKind::WouldBlock.into());
        }
        // Descriptors are never requested; the kernel closes any that arrive.
        let (count, _) = retry_on_intr(|| recv(&self.socket, &mut *buf, RecvFlags::DONTWAIT))?;
        let mut packets = self.packets.get();
        let sensible = packets.follow(buf.get(..count).unwrap_or_default());
        self.packets.set(packets);
        if !sensible {
            return Err(ErrorKind::InvalidData.into());
        }
        // A silent server has spoken: waiting begins afresh.
        let spoken = self.silent.replace(false);
        let awaited = self.awaited.get().filter(|_| !spoken);
        self.awaited.set(awaited.map(|awaited| Awaited {
            taken: awaited.taken + count,
            ..awaited
        }));
        self.taken.set(taken + count);
        self.ahead.set(self.ahead.get() + count);
        Ok(count)
    }

    fn write(&self, buf: &[u8], fds: &mut Vec<RawFdContainer>) -> Result<usize> {
        self.take(&[IoSlice::new(buf)], fds)
    }

    fn write_vectored(&self, bufs: &[IoSlice<'_>], fds: &mut Vec<RawFdContainer>) -> Result<usize> {
        self.take(bufs, fds)
    }
}

/// Waits for `events` on `socket`. Returns none if the time is over.
pub(super) fn wait(socket: BorrowedFd<'_>, events: PollFlags, time: Duration) -> Result<PollFlags> {
    let mut entry = [PollFd::from_borrowed_fd(socket, events)];
    let time = Timespec::try_from(time).ok();
    match rustix::event::poll(&mut entry, time.as_ref()) {
        Err(Errno::INTR) => Ok(PollFlags::empty()),
        result => Ok(result.map(|_| entry[0].revents())?),
    }
}

/// Sends what the socket takes now, with the first few `descriptors`, which are then closed.
fn send(
    socket: BorrowedFd<'_>,
    slices: &[IoSlice<'_>],
    descriptors: &mut Vec<OwnedFd>,
) -> Result<usize> {
    let mut space = [MaybeUninit::uninit(); rustix::cmsg_space!(ScmRights(MOST_DESCRIPTORS))];
    let mut control = SendAncillaryBuffer::new(&mut space);
    let count = descriptors.len().min(MOST_DESCRIPTORS);
    let first: Vec<_> = descriptors[..count].iter().map(OwnedFd::as_fd).collect();
    if count > 0 {
        control.push(SendAncillaryMessage::ScmRights(&first));
    }
    let flags = SendFlags::NOSIGNAL | SendFlags::DONTWAIT;
    let sent = retry_on_intr(|| sendmsg(socket, slices, &mut control, flags))?;
    descriptors.drain(..count);
    Ok(sent)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::{Read, Write};
    use std::os::unix::net::UnixStream;
    use std::sync::atomic::{AtomicBool, Ordering};
    use std::thread;
    use x11rb::rust_connection::Stream as _;

    const SOON: Duration = Duration::from_millis(200);

    fn pair() -> (Stream, UnixStream) {
        let (ours, theirs) = UnixStream::pair().unwrap();
        let stream = Stream::new(ours.into(), Instant::now() + SOON).unwrap();
        (stream, theirs)
    }

    fn ready(stream: &Stream) -> bool {
        wait(stream.watch(), PollFlags::IN, Duration::ZERO).unwrap() == PollFlags::IN
    }

    #[test]
    fn what_is_not_taken_is_kept_in_order_and_sent_later() {
        let (stream, mut theirs) = pair();
        let all: Vec<u8> = (0..3_000_000_u32).map(|i| (i % 251) as u8).collect();
        for part in all.chunks(70_001) {
            let (front, back) = part.split_at(part.len() / 3);
            let slices = [IoSlice::new(front), IoSlice::new(&[]), IoSlice::new(back)];
            let taken = stream.write_vectored(&slices, &mut Vec::new()).unwrap();
            assert_eq!(taken, part.len());
        }
        assert!(stream.waiting() > 0 && !ready(&stream), "there is no room");
        let mut got: Vec<u8> = Vec::new();
        let mut buffer = vec![0; 1 << 16];
        theirs.set_nonblocking(true).unwrap();
        while got.len() < all.len() {
            // Room is reported when most of the socket's buffer is free again.
            while let Ok(count) = theirs.read(&mut buffer) {
                got.extend(&buffer[..count]);
            }
            assert!(
                stream.waiting() == 0
                    || wait(stream.watch(), PollFlags::IN, SOON).unwrap() == PollFlags::IN
            );
            stream.push().unwrap();
        }
        assert!(got == all);
        assert!(!ready(&stream), "nothing waits any more");
        theirs.write_all(b"x").unwrap();
        assert!(ready(&stream));
    }

    #[test]
    fn an_answer_is_waited_for_once_and_not_again_until_something_comes() {
        let (stream, mut theirs) = pair();
        let late = |stream: &Stream| stream.poll(PollMode::Readable).unwrap_err().kind();
        assert_eq!(late(&stream), ErrorKind::TimedOut);
        stream.settle();
        assert_eq!(
            stream.reply_timeout(),
            Duration::ZERO,
            "it was silent while it opened"
        );
        theirs.write_all(b"x").unwrap();
        stream.poll(PollMode::Readable).unwrap();
        assert_eq!(stream.read(&mut [0; 8], &mut Vec::new()).unwrap(), 1);
        assert_eq!(stream.reply_timeout(), REPLY_TIMEOUT);
        assert_eq!(late(&stream), ErrorKind::TimedOut);
        assert_eq!(stream.reply_timeout(), Duration::ZERO);
    }

    /// Requests and waits as x11rb does, until `enough` bytes have arrived; returns how many did.
    fn ask(stream: &Stream, enough: usize) -> Result<usize> {
        let mut buffer = [0; 4096];
        let mut got = 0;
        stream.write(b"?", &mut Vec::new())?;
        while got < enough {
            stream.poll(PollMode::Readable)?;
            loop {
                match stream.read(&mut buffer, &mut Vec::new()) {
                    Ok(count) => got += count,
                    Err(error) if error.kind() == ErrorKind::WouldBlock => break,
                    Err(error) => return Err(error),
                }
            }
        }
        Ok(got)
    }

    /// Runs `check` while another thread sends these bytes after each pause, for ever.
    fn while_sent(bytes: &[u8], rest: Duration, check: impl FnOnce(&Stream)) {
        let (stream, theirs) = pair();
        stream.settle();
        thread::scope(|scope| {
            scope.spawn(|| {
                while (&theirs).write_all(bytes).is_ok() {
                    thread::sleep(rest);
                }
            });
            check(&stream);
            drop(stream);
        });
    }

    #[test]
    fn who_speaks_but_does_not_answer_is_waited_for_once_and_after_a_rest() {
        while_sent(&[7; 32], Duration::from_millis(10), |stream| {
            let waited = |enough| {
                let start = Instant::now();
                let result = ask(stream, enough).map_err(|error| error.kind());
                (result, start.elapsed())
            };
            for _ in 0..2 {
                let (result, time) = waited(usize::MAX);
                assert_eq!(result, Err(ErrorKind::TimedOut));
                assert!(
                    time >= REPLY_TIMEOUT && time < 2 * REPLY_TIMEOUT,
                    "{time:?}"
                );
                // Whatever arrives, and however often a reply is requested.
                let start = Instant::now();
                for _ in 0..100 {
                    thread::sleep(Duration::from_millis(2));
                    assert_eq!(waited(usize::MAX).0, Err(ErrorKind::TimedOut));
                }
                assert!(start.elapsed() < REPLY_TIMEOUT, "{:?}", start.elapsed());
                let end = stream.backoff_until.get().unwrap();
                assert!(end <= start + BACKOFF, "a rest grows");
                stream.backoff_until.set(Some(Instant::now())); // as if it were over
            }
            // A reply that arrives in time again is waited for.
            for _ in 0..3 {
                assert!(waited(320).0.is_ok());
            }
        });
    }

    #[test]
    fn an_answer_behind_many_events_is_reached_but_not_behind_any_number() {
        while_sent(&[7; 1 << 16], Duration::ZERO, |stream| {
            for _ in 0..3 {
                assert!(ask(stream, 1 << 20).is_ok());
            }
            let before = stream.awaited.get().unwrap();
            assert!(before.taken >= 1 << 20);
            let error = ask(stream, 10 * MOST_BEFORE_ANSWER).unwrap_err();
            assert_eq!(error.kind(), ErrorKind::TimedOut);
        });
        // However much time is left.
        let (stream, _theirs) = pair();
        stream.settle();
        stream.ahead.set(MOST_BEFORE_ANSWER);
        let start = Instant::now();
        assert!(stream.poll(PollMode::Readable).is_err());
        assert!(start.elapsed() < REPLY_TIMEOUT / 2);
    }

    /// What is read while waiting for replies, and not yet handled, takes memory.
    #[test]
    fn however_often_is_asked_not_more_is_read_until_all_was_looked_at() {
        while_sent(&[7; 1 << 16], Duration::ZERO, |stream| {
            let mut buffer = [0; 4096];
            let mut read = || {
                let mut got = 0;
                while let Ok(count) = stream.read(&mut buffer, &mut Vec::new()) {
                    got += count;
                }
                got
            };
            for _ in 0..3 {
                let mut got = 0;
                for _ in 0..1000 {
                    stream.write(b"?", &mut Vec::new()).unwrap();
                    while stream.poll(PollMode::Readable).is_ok() {
                        got += read();
                    }
                    stream.backoff_until.set(None); // as if it were over
                }
                let most = MOST_BEFORE_ANSWER..MOST_BEFORE_ANSWER + 2 * MOST_AT_ONCE;
                assert!(most.contains(&got), "{got} bytes");
                stream.looked_at(got);
            }
        });
    }

    #[test]
    fn what_has_no_end_is_read_in_parts() {
        let (stream, theirs) = pair();
        let ended = AtomicBool::new(false);
        thread::scope(|scope| {
            scope.spawn(|| {
                let mut sent = Ok(());
                while sent.is_ok() && !ended.load(Ordering::Relaxed) {
                    sent = (&theirs).write_all(&[7; 4096]);
                }
            });
            let mut buffer = [0; 4096];
            for _ in 0..20 {
                // Like x11rb, until nothing is left.
                let mut got = 0;
                stream.poll(PollMode::Readable).unwrap();
                let end = loop {
                    match stream.read(&mut buffer, &mut Vec::new()) {
                        Ok(count) => got += count,
                        Err(error) => break error.kind(),
                    }
                };
                assert_eq!(end, ErrorKind::WouldBlock);
                assert!(got > 0 && got < MOST_AT_ONCE + buffer.len());
            }
            ended.store(true, Ordering::Relaxed);
            drop(stream);
        });
    }

    #[test]
    fn too_much_is_refused_and_a_closed_end_is_an_error() {
        let (stream, theirs) = pair();
        let much = vec![0; 1 << 20];
        let refused = (0..40).find_map(|_| stream.write(&much, &mut Vec::new()).err());
        assert_eq!(refused.map(|error| error.kind()), Some(ErrorKind::TimedOut));
        drop(theirs);
        assert!(stream.push().is_err());
        let (stream, theirs) = pair();
        drop(theirs);
        assert!(ready(&stream));
        assert_eq!(stream.read(&mut [0; 8], &mut Vec::new()).unwrap(), 0);
        let error = stream.write(b"x", &mut Vec::new()).unwrap_err();
        assert_eq!(error.kind(), ErrorKind::BrokenPipe);
    }
}
