//! From a display's name to a connected socket and its cookie, all under one deadline.
#![allow(unsafe_code)] // the mask of signals

use std::io::{Error, ErrorKind, Result};
use std::mem::MaybeUninit;
use std::net::{IpAddr, Ipv4Addr, Ipv6Addr, SocketAddr, TcpStream, ToSocketAddrs};
use std::os::fd::{AsFd, OwnedFd};
use std::sync::mpsc;
use std::time::{Duration, Instant};

use rustix::event::PollFlags;
use rustix::io::Errno;
use rustix::net::{AddressFamily, SocketAddrUnix, SocketFlags, SocketType};
use x11rb::reexports::x11rb_protocol::parse_display::{self, ConnectAddress, ParsedDisplay};
use x11rb::reexports::x11rb_protocol::xauth::{Family, get_auth};

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
    let parsed = parse_display::parse_display(Some(name)).ok()?;
    (parsed.display <= LAST_DISPLAY).then_some(parsed)
}

/// Connects to the first address that answers; an error is that of the first, which is meant.
pub(super) fn connect(display: &ParsedDisplay, deadline: Instant) -> Result<Peer> {
    let mut first = None;
    let path = (display.host.starts_with('/') && display.protocol.as_deref() == Some("unix"))
        .then(|| ConnectAddress::Socket(display.host.clone()));
    for address in path.into_iter().chain(display.connect_instruction()) {
        let result = match address {
            ConnectAddress::Socket(path) => unix(&path, deadline),
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

/// The authorization name and data for this display; empty if the authority file has none.
pub(super) fn authority(peer: &Peer, display: u16) -> (Vec<u8>, Vec<u8>) {
    let found = get_auth(peer.family, &peer.address, display);
    found.ok().flatten().unwrap_or_default()
}

fn unix(path: &str, deadline: Instant) -> Result<Peer> {
    let address = SocketAddrUnix::new(path).map_err(|_| ErrorKind::InvalidInput)?;
    let flags = SocketFlags::CLOEXEC | SocketFlags::NONBLOCK;
    let (family, kind) = (AddressFamily::UNIX, SocketType::STREAM);
    let socket = rustix::net::socket_with(family, kind, flags, None)?;
    // A local connection succeeds at once unless the backlog is full, which cannot be polled for.
    loop {
        match rustix::net::connect(&socket, &address) {
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
                    socket: stream.into(),
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

/// The addresses of a host. Name resolution can take long and cannot be cancelled, so it runs on a
/// thread of its own, which is abandoned at the deadline.
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
    let (answer, answers) = mpsc::channel();
    let host = host.to_owned();
    without_signals(|| {
        std::thread::Builder::new().spawn(move || {
            let found = (host.as_str(), port).to_socket_addrs();
            answer.send(found.map(Vec::from_iter)).ok();
        })
    })?;
    let left = deadline.saturating_duration_since(Instant::now());
    answers
        .recv_timeout(left)
        .map_err(|_| ErrorKind::TimedOut)?
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
