//! Finds where packets from the X server begin and end, below x11rb.
//!
//! x11rb allocates what a packet's head announces, up to 16 GB, before it has arrived; a failed
//! allocation would abort the host.

/// The longest packet, in bytes: four times the longest reply to any request in use.
const MAX_PACKET: usize = 1 << 20;

/// The bytes of a packet that give its length.
const HEAD: usize = 8;

/// The shortest packet after the setup, in bytes.
const SHORTEST: usize = 32;

/// The bit in an event's type that marks it as sent by another client.
pub(super) const SENT: u8 = 0x80;

const REPLY: u8 = 1;
const GENERIC_EVENT: u8 = 35;

#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Packets {
    head: [u8; HEAD],
    /// Bytes of the head that have arrived.
    got: usize,
    /// Bytes of the packet after its head that have not arrived.
    left: usize,
    /// The setup, which has a different form, has begun.
    opened: bool,
    senseless: bool,
}

impl Packets {
    /// Follows the received bytes. False once a packet announces more than the longest.
    pub(super) fn follow(&mut self, mut bytes: &[u8]) -> bool {
        while !bytes.is_empty() && !self.senseless {
            let wanted = if self.left > 0 {
                self.left
            } else {
                HEAD - self.got
            };
            let (now, later) = bytes.split_at(wanted.min(bytes.len()));
            bytes = later;
            if self.left > 0 {
                self.left -= now.len();
                continue;
            }
            self.head[self.got..][..now.len()].copy_from_slice(now);
            self.got += now.len();
            if self.got == HEAD {
                self.got = 0;
                self.left = self.announced();
                self.senseless = self.left > MAX_PACKET;
            }
        }
        !self.senseless
    }

    /// The number of bytes after this head.
    fn announced(&mut self) -> usize {
        let [kind, _, _, _, a, b, c, d] = self.head;
        if !std::mem::replace(&mut self.opened, true) {
            return 4 * usize::from(u16::from_ne_bytes([c, d]));
        }
        let more = match kind {
            REPLY => u32::from_ne_bytes([a, b, c, d]),
            _ if kind & !SENT == GENERIC_EVENT => u32::from_ne_bytes([a, b, c, d]),
            _ => 0,
        };
        (SHORTEST - HEAD).saturating_add(
            usize::try_from(more)
                .unwrap_or(usize::MAX)
                .saturating_mul(4),
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn packet(kind: u8, units: u32, bytes: usize) -> Vec<u8> {
        let mut packet = vec![kind, 0, 0, 0];
        packet.extend(units.to_ne_bytes());
        packet.resize(bytes, 7);
        packet
    }

    fn setup() -> Vec<u8> {
        let mut setup = vec![1, 0, 11, 0, 0, 0];
        setup.extend(3_u16.to_ne_bytes());
        setup.resize(8 + 12, 7);
        setup
    }

    #[test]
    fn packets_are_followed_however_they_are_cut() {
        let mut all = setup();
        for (kind, units, bytes) in [
            (1, 0, 32),
            (1, 500, 32 + 2000),
            (0, u32::MAX, 32),
            (12, u32::MAX, 32),
            (GENERIC_EVENT, 3, 44),
            (GENERIC_EVENT | 0x80, 1, 36),
            (1, 2, 40),
        ] {
            all.extend(packet(kind, units, bytes));
        }
        let end = packet(1, u32::MAX, 32);
        for size in [1, 2, 7, 8, 31, 32, 33, 4096] {
            let mut packets = Packets::default();
            for part in all.chunks(size) {
                assert!(packets.follow(part), "in parts of {size} bytes");
            }
            assert!(!packets.follow(&end) && !packets.follow(&all));
        }
    }

    #[test]
    fn the_longest_packet_is_one_mebibyte() {
        for kind in [REPLY, GENERIC_EVENT, GENERIC_EVENT | 0x80] {
            for (units, fits) in [(1 << 16, true), (1 << 18, false), (1 << 30, false)] {
                let mut packets = Packets::default();
                packets.follow(&setup());
                assert_eq!(packets.follow(&packet(kind, units, 8)), fits, "{units}");
            }
        }
    }
}
