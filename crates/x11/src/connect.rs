//! From a display's name to a connected socket and its cookie.
//!
//! Every step has the same deadline. Whatever goes wrong becomes one sentence
//! that names the display and the reason.
#![allow(unsafe_code)] // system calls

use std::io::{Error, ErrorKind, Result};
use std::mem::MaybeUninit;
use std::net::{IpAddr, Ipv4Addr, Ipv6Addr, SocketAddr, TcpStream, ToSocketAddrs};
use std::os::fd::{AsFd, AsRawFd, OwnedFd};
use std::sync::mpsc;
use std::time::{Duration, Instant};

use x11rb::reexports::x11rb_protocol::parse_display::{self, ConnectAddress, ParsedDisplay};
use x11rb::reexports::x11rb_protocol::xauth::{Family, get_auth};

use super::stream::{descriptor, wait};

/// A socket, and how its peer is called in an authority file.
pub(super) struct Peer {
    pub(super) socket: OwnedFd,
    pub(super) local: bool,
    family: Family,
    address: Vec<u8>,
}

/// The highest display whose port exists: ports are counted from 6000.
const LAST_DISPLAY: u16 = u16::MAX - 6000;

/// Takes a display's name apart; `None` if it is none.
pub(super) fn parse(name: &str) -> Option<ParsedDisplay> {
    let parsed = parse_display::parse_display(Some(name)).ok()?;
    (parsed.display <= LAST_DISPLAY).then_some(parsed)
}

/// Connects to the first address that answers.
///
/// # Errors
/// Of the first address: it is the one that is meant, the others are a try.
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

/// The name and the data by which the server lets us in; empty if the
/// authority file has none for this display.
pub(super) fn authority(peer: &Peer, display: u16) -> (Vec<u8>, Vec<u8>) {
    let found = get_auth(peer.family, &peer.address, display);
    found.ok().flatten().unwrap_or_default()
}

fn unix(path: &str, deadline: Instant) -> Result<Peer> {
    // SAFETY: all zero is a valid address structure.
    let mut address = unsafe { MaybeUninit::<libc::sockaddr_un>::zeroed().assume_init() };
    address.sun_family = libc::AF_UNIX as libc::sa_family_t;
    if path.len() >= address.sun_path.len() || path.bytes().any(|byte| byte == 0) {
        return Err(ErrorKind::InvalidInput.into());
    }
    for (place, byte) in address.sun_path.iter_mut().zip(path.bytes()) {
        *place = byte as libc::c_char;
    }
    let kind = libc::SOCK_STREAM | libc::SOCK_CLOEXEC | libc::SOCK_NONBLOCK;
    // SAFETY: no pointer is involved.
    let socket = descriptor(unsafe { libc::socket(libc::AF_UNIX, kind, 0) })?;
    let length = size_of_val(&address) as libc::socklen_t;
    // A local connection is made at once, or there are too many waiting already:
    // for that there is nothing to poll.
    loop {
        // SAFETY: the address is whole and outlives the call.
        let result =
            unsafe { libc::connect(socket.as_raw_fd(), (&raw const address).cast(), length) };
        if result == 0 {
            break;
        }
        let error = Error::last_os_error();
        match error.kind() {
            ErrorKind::Interrupted => {}
            ErrorKind::WouldBlock if Instant::now() < deadline => {
                wait(socket.as_fd(), 0, Duration::from_millis(20)).ok();
            }
            ErrorKind::WouldBlock => return Err(ErrorKind::TimedOut.into()),
            _ => return Err(error),
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

/// The addresses of a host. Asking a name server can take much longer than any
/// host program wants to stand still, and cannot be broken off; so a thread
/// of its own asks, and is left to itself when the time is over.
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

/// Runs `start` with all signals blocked, so that a thread that it starts takes
/// none that the host waits for.
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

/// What an authority file calls a peer. For one on this machine it is the
/// machine's name, whatever way the connection took.
fn peer_name(ip: IpAddr) -> (Family, Vec<u8>) {
    match ip.to_canonical() {
        ip if ip.is_loopback() => (Family::LOCAL, host_name()),
        IpAddr::V4(ip) => (Family::INTERNET, ip.octets().to_vec()),
        IpAddr::V6(ip) => (Family::INTERNET6, ip.octets().to_vec()),
    }
}

/// This machine's name, as the window manager and the authority file know it.
pub(super) fn host_name() -> Vec<u8> {
    let mut name = vec![0_u8; 256];
    // SAFETY: the pointer and the length are those of one vector; the last byte
    // stays out, so that the name ends with a zero.
    let result = unsafe { libc::gethostname(name.as_mut_ptr().cast(), name.len() - 1) };
    let end = name.iter().position(|&byte| byte == 0).unwrap_or(0);
    name.truncate(if result == 0 { end } else { 0 });
    name
}
