//! Servers that reply wrongly while a window opens: with an error, with a part, with a length that
//! is a lie. Each time there is a result within [`LIMIT`].

use std::io::{Read, Write};
use std::os::unix::net::{UnixListener, UnixStream};
use std::sync::mpsc;
use std::thread;
use std::time::{Duration, Instant};

use super::testing::Server;
use super::{Options, Window};

const LIMIT: Duration = Duration::from_secs(4);

/// What happens to one of the server's packets on its way.
#[derive(Clone, Copy, Debug)]
enum Fault {
    /// None; all packets are counted.
    None,
    /// An error comes in its place.
    Error,
    /// Nothing comes after so many bytes, not even the end.
    Silence(usize),
    /// The connection ends after so many bytes.
    End(usize),
    /// It announces so many units of four bytes.
    Length(u32),
    /// Each 32-bit number after its head that is not 0 is the largest.
    Counts,
}

/// A way to a real server, by which one packet changes.
struct Way {
    display: String,
    listener: UnixListener,
    server: String,
    _folder: tempfile::TempDir,
}

impl Way {
    fn to(server: &Server) -> Self {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("way");
        let number = server.display().trim_start_matches(':');
        Self {
            display: format!("unix:{}", path.display()),
            listener: UnixListener::bind(&path).unwrap(),
            server: format!("/tmp/.X11-unix/X{number}"),
            _folder: folder,
        }
    }

    /// Opens a window; the lengths of the packets that came, and the result.
    fn open(&self, at: usize, fault: Fault) -> (Vec<usize>, Result<(), String>) {
        let (tell, told) = mpsc::channel();
        let display = self.display.clone();
        thread::spawn(move || {
            let start = Instant::now();
            let options = Options {
                display: Some(display),
                title: "VIDES".to_owned(),
                application: "a host".to_owned(),
                size: [64.0, 48.0],
                smallest: [10.0, 8.0],
                ..Options::default()
            };
            let opened = Window::open(&options);
            tell.send((
                opened.as_ref().map(drop).map_err(ToString::to_string),
                start.elapsed(),
            ))
            .ok();
        });
        let (ours, _) = self.listener.accept().unwrap();
        let server = UnixStream::connect(&self.server).unwrap();
        let (mut from, mut to) = (ours.try_clone().unwrap(), server.try_clone().unwrap());
        thread::spawn(move || {
            std::io::copy(&mut from, &mut to).ok();
            to.shutdown(std::net::Shutdown::Both).ok();
        });
        let packets = thread::spawn(move || carry(&server, &ours, at, fault));
        let (opened, took) = told
            .recv_timeout(LIMIT + Duration::from_secs(6))
            .unwrap_or_else(|_| panic!("packet {at}, {fault:?}: no result"));
        assert!(took < LIMIT, "packet {at}, {fault:?}: {took:?}");
        // The window is closed, so the connection ends.
        let packets = packets.join().unwrap();
        (packets, opened)
    }
}

/// Carries the server's packets to the client, and this one with its fault.
fn carry(mut server: &UnixStream, mut client: &UnixStream, at: usize, fault: Fault) -> Vec<usize> {
    let mut lengths = Vec::new();
    loop {
        let mut packet = vec![0; if lengths.is_empty() { 8 } else { 32 }];
        if server.read_exact(&mut packet).is_err() {
            return lengths;
        }
        let number = |at: usize, packet: &[u8]| {
            u32::from_ne_bytes(packet[at..at + 4].try_into().unwrap()) as usize
        };
        let more = match packet[0] {
            _ if lengths.is_empty() => usize::from(u16::from_ne_bytes([packet[6], packet[7]])),
            1 => number(4, &packet),
            _ => 0,
        };
        let head = packet.len();
        packet.resize(head + 4 * more, 0);
        if server.read_exact(&mut packet[head..]).is_err() {
            return lengths;
        }
        let is_reply = packet[0] == 1 && !lengths.is_empty();
        let (mut silent, mut ended) = (false, false);
        if lengths.len() == at {
            match fault {
                Fault::Error if is_reply => {
                    packet.truncate(32);
                    packet[..2].copy_from_slice(&[0, 11]); // a request that cannot be served
                    packet[4..].fill(0);
                }
                Fault::Length(length) if is_reply => {
                    packet[4..8].copy_from_slice(&length.to_ne_bytes());
                }
                Fault::Counts => {
                    for word in packet.chunks_exact_mut(4).skip(2) {
                        if word != [0; 4] {
                            word.fill(0xff);
                        }
                    }
                }
                Fault::Silence(bytes) => {
                    packet.truncate(bytes);
                    silent = true;
                }
                Fault::End(bytes) => {
                    packet.truncate(bytes);
                    ended = true;
                }
                _ => {}
            }
        }
        lengths.push(packet.len());
        if client.write_all(&packet).is_err() || ended {
            client.shutdown(std::net::Shutdown::Both).ok();
            return lengths;
        }
        if silent {
            // Until the client gives up.
            while server.read(&mut [0; 4096]).is_ok_and(|count| count > 0) {}
            return lengths;
        }
    }
}

/// The lengths of the packets of a window that opens as usual.
fn usual(way: &Way) -> Vec<usize> {
    let (packets, opened) = way.open(0, Fault::None);
    opened.unwrap();
    assert!(packets.len() > 60, "{} packets", packets.len());
    packets
}

#[test]
fn each_reply_may_be_an_error() {
    let server = Server::start();
    let way = Way::to(&server);
    let mut opened = 0;
    let packets = usual(&way);
    for at in 1..packets.len() {
        match way.open(at, Fault::Error).1 {
            Ok(_) => opened += 1,
            Err(error) => assert!(error.contains("the X server answers"), "{at}: {error}"),
        }
    }
    // Without an extension, a setting or a name of a key there is a window all the same.
    assert!(opened > 10, "{opened} of {}", packets.len());
}

#[test]
fn each_packet_may_end_at_any_byte() {
    let server = Server::start();
    let way = Way::to(&server);
    for (at, length) in usual(&way).into_iter().enumerate() {
        // Of the long ones, which are lists, a part.
        for bytes in (0..length).filter(|at| *at < 48 || at % 211 == 0) {
            // Some come unasked for, after all that is needed.
            if let Err(error) = way.open(at, Fault::End(bytes)).1 {
                assert!(error.starts_with("display "), "{error}");
            }
        }
    }
}

#[test]
fn silence_within_any_packet_is_an_error_in_time() {
    let server = Server::start();
    thread::scope(|scope| {
        for part in 0..8 {
            let server = &server;
            scope.spawn(move || {
                let way = Way::to(server);
                for (at, length) in usual(&way)
                    .into_iter()
                    .enumerate()
                    .skip(part * 9)
                    .step_by(72)
                {
                    way.open(at, Fault::Silence(length / 2)).1.ok();
                }
            });
        }
    });
}

#[test]
fn each_length_and_count_may_be_a_lie() {
    let server = Server::start();
    let way = Way::to(&server);
    for at in 0..usual(&way).len() {
        for units in [u32::MAX, 1 << 30, 1 << 28, (1 << 18) + 1] {
            way.open(at, Fault::Length(units)).1.ok();
        }
        way.open(at, Fault::Counts).1.ok();
    }
}
