//! From a display's name to a connected socket and its cookie, all under one deadline.
#![allow(unsafe_code)] // the mask of signals

use std::io::{Error, ErrorKind, Result};
use std::mem::MaybeUninit;
use std::net::{IpAddr, Ipv4Addr, Ipv6Addr, SocketAddr, TcpStream, ToSocketAddrs};
use std::os::fd::{AsFd, OwnedFd};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

use rustix::event::{EventfdFlags, PollFlags, eventfd};
use rustix::io::Errno;
use rustix::net::{AddressFamily, SocketAddrUnix, SocketFlags, SocketType};
use vides_engine::descriptor::off_standard;
use x11rb::reexports::x11rb_protocol::parse_display::{self, ConnectAddress, ParsedDisplay};
use x11rb::reexports::x11rb_protocol::xauth::Family;

use super::stream::wait;

/// A connected socket, and the peer's name in an authority file.
pub(super) struct Peer {
    pub(super) socket: OwnedFd,
    pub(super) local: bool,
    family: Family,
    address: Vec<u8>,
}

/// The highest display whose port exists: ports start at 6000.
const LAST_DISPLAY: u16 = u16::MAX - 6000;

pub(super) fn parse(name: &str) -> Option<ParsedDisplay> {
    let parse = |name: &str| parse_display::parse_display(Some(name)).ok();
    // x11rb takes what follows `unix:` for a path; in Xlib it is a display of this machine.
    let number = name.strip_prefix("unix:").filter(|number| {
        let mut letters = number.bytes();
        letters.all(|letter| letter.is_ascii_digit() || letter == b'.')
    });
    let parsed = match number.and_then(|number| parse(&format!(":{number}"))) {
        Some(parsed) => ParsedDisplay {
            host: "unix".to_owned(),
            ..parsed
        },
        None => parse(name)?,
    };
    (parsed.display <= LAST_DISPLAY).then_some(parsed)
}

/// Connects to the first address that answers. If none does, the error is that of the first
/// address.
pub(super) fn connect(display: &ParsedDisplay, deadline: Instant) -> Result<Peer> {
    let mut first = None;
    let path = (display.host.starts_with('/') && display.protocol.as_deref() == Some("unix"))
        .then(|| ConnectAddress::Socket(display.host.clone()));
    for address in path.into_iter().chain(display.connect_instruction()) {
        let result = match address {
            ConnectAddress::Socket(path) => local(&path, deadline),
            ConnectAddress::Hostname(host, port) => tcp(host, port, deadline),
            _ => Err(ErrorKind::Unsupported.into()),
        };
        match result {
            Ok(peer) => return Ok(peer),
            Err(error) => first = first.or(Some(error)),
        }
    }
    Err(first.unwrap_or_else(|| ErrorKind::Unsupported.into()))
}

impl Peer {
    /// Its name in an authority file.
    pub(super) fn name(&self) -> (Family, &[u8]) {
        (self.family, &self.address)
    }
}

/// Connects to a socket of this machine. Like Xlib, it tries the abstract socket of that name
/// first, which exists whatever folders the process sees, then the one in the file system, whose
/// error is returned.
fn local(path: &str, deadline: Instant) -> Result<Peer> {
    if let Ok(hidden) = SocketAddrUnix::new_abstract_name(path.as_bytes())
        && let Ok(peer) = unix(&hidden, deadline)
    {
        return Ok(peer);
    }
    let address = SocketAddrUnix::new(path).map_err(|_| ErrorKind::InvalidInput)?;
    unix(&address, deadline)
}

fn unix(address: &SocketAddrUnix, deadline: Instant) -> Result<Peer> {
    let flags = SocketFlags::CLOEXEC | SocketFlags::NONBLOCK;
    let (family, kind) = (AddressFamily::UNIX, SocketType::STREAM);
    let socket = off_standard(rustix::net::socket_with(family, kind, flags, None)?)?;
    // A local connection succeeds at once unless the backlog is full, which cannot be polled for.
    loop {
        match rustix::net::connect(&socket, address) {
            Ok(()) => break,
            Err(Errno::INTR) => {}
            Err(Errno::AGAIN) if Instant::now() < deadline => {
                wait(
                    socket.as_fd(),
                    PollFlags::empty(),
                    Duration::from_millis(20),
                )
                .ok();
            }
            Err(Errno::AGAIN) => return Err(ErrorKind::TimedOut.into()),
            Err(error) => return Err(error.into()),
        }
    }
    Ok(Peer {
        socket,
        local: true,
        family: Family::LOCAL,
        address: host_name(),
    })
}

fn tcp(host: &str, port: u16, deadline: Instant) -> Result<Peer> {
    let mut last = Error::from(ErrorKind::NotFound);
    for address in addresses(host, port, deadline)? {
        let left = deadline.saturating_duration_since(Instant::now());
        if left.is_zero() {
            return Err(ErrorKind::TimedOut.into());
        }
        match TcpStream::connect_timeout(&address, left) {
            Ok(stream) => {
                stream.set_nodelay(true)?;
                let (family, address) = peer_name(address.ip());
                return Ok(Peer {
                    socket: off_standard(stream.into())?,
                    local: false,
                    family,
                    address,
                });
            }
            Err(error) => last = error,
        }
    }
    Err(last)
}

fn addresses(host: &str, port: u16, deadline: Instant) -> Result<Vec<SocketAddr>> {
    if host == "localhost" {
        let local = [Ipv4Addr::LOCALHOST.into(), Ipv6Addr::LOCALHOST.into()];
        return Ok(local.map(|ip| SocketAddr::new(ip, port)).to_vec());
    }
    let bare = host
        .strip_prefix('[')
        .and_then(|host| host.strip_suffix(']'));
    if let Ok(ip) = bare.unwrap_or(host).parse::<IpAddr>() {
        return Ok(vec![SocketAddr::new(ip, port)]);
    }
    let host = host.to_owned();
    in_time(deadline, move || {
        let found = (host.as_str(), port).to_socket_addrs();
        found.map(Vec::from_iter)
    })
}

/// Runs work that may take long and cannot be cancelled on a separate thread, which is abandoned at
/// the deadline.
pub(super) fn in_time<T: Send + 'static>(
    deadline: Instant,
    work: impl FnOnce() -> Result<T> + Send + 'static,
) -> Result<T> {
    // Not a channel: waiting at one allocates something that is freed only when the thread ends,
    // and the host's thread may never end.
    let done = off_standard(eventfd(0, EventfdFlags::CLOEXEC)?)?;
    let shared = Arc::new((done, Mutex::new(None)));
    let made = Arc::clone(&shared);
    let work = move || {
        let result = work();
        *made.1.lock().unwrap_or_else(PoisonError::into_inner) = Some(result);
        let _ = rustix::io::write(&made.0, &1u64.to_ne_bytes());
    };
    without_signals(|| std::thread::Builder::new().spawn(work))?;
    loop {
        let left = deadline.saturating_duration_since(Instant::now());
        let ready = wait(shared.0.as_fd(), PollFlags::IN, left)?;
        let made = (shared.1.lock().unwrap_or_else(PoisonError::into_inner)).take();
        match made {
            Some(result) => return result,
            None if ready.is_empty() && left.is_zero() => return Err(ErrorKind::TimedOut.into()),
            None => {}
        }
    }
}

/// Runs `start` with all signals blocked, so that a thread it starts inherits that mask and takes
/// no signal meant for the host.
pub fn without_signals<T>(start: impl FnOnce() -> T) -> T {
    let (mut all, mut before) = (MaybeUninit::uninit(), MaybeUninit::uninit());
    // SAFETY: `sigfillset` fills `all`, and only then it is read; `before` is
    // filled by the first `pthread_sigmask` if that succeeded, and read only then.
    unsafe {
        libc::sigfillset(all.as_mut_ptr());
        let changed = libc::pthread_sigmask(libc::SIG_SETMASK, all.as_ptr(), before.as_mut_ptr());
        let result = start();
        if changed == 0 {
            libc::pthread_sigmask(libc::SIG_SETMASK, before.as_ptr(), std::ptr::null_mut());
        }
        result
    }
}

/// The peer's name in an authority file: for a loopback connection the machine's own name.
fn peer_name(ip: IpAddr) -> (Family, Vec<u8>) {
    match ip.to_canonical() {
        ip if ip.is_loopback() => (Family::LOCAL, host_name()),
        IpAddr::V4(ip) => (Family::INTERNET, ip.octets().to_vec()),
        IpAddr::V6(ip) => (Family::INTERNET6, ip.octets().to_vec()),
    }
}

pub(super) fn host_name() -> Vec<u8> {
    rustix::system::uname().nodename().to_bytes().to_vec()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::os::linux::net::SocketAddrExt as _;
    use std::os::unix::net::{SocketAddr, UnixListener};

    /// For example in a sandbox with its own folders.
    #[test]
    fn a_display_with_an_abstract_socket_alone_is_reached() {
        let number = 40_000 + std::process::id() % 10_000;
        let name = format!("/tmp/.X11-unix/X{number}");
        let address = SocketAddr::from_abstract_name(&name).unwrap();
        let server = UnixListener::bind_addr(&address).unwrap();
        server.set_nonblocking(true).unwrap();
        for host in ["", "unix", "unix/"] {
            let display = parse(&format!("{host}:{number}.0")).unwrap();
            let deadline = Instant::now() + Duration::from_secs(2);
            let peer = connect(&display, deadline).unwrap();
            assert!(peer.local, "{host}");
            server.accept().unwrap();
        }
    }
}
