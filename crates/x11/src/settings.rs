//! The desktop's settings, by freedesktop.org's XSETTINGS: whether it is dark, by the name in
//! `Net/ThemeName`, for example "Adwaita-dark" or "Mint-Y-Dark-Aqua", and whether it asks for no
//! animations, by `Gtk/EnableAnimations`.
//!
//! Any client may own the selection and write anything there, so the data is parsed defensively and
//! ignored if it is not valid.

use x11rb::protocol::xproto::{
    ChangeWindowAttributesAux, ClientMessageEvent, ConnectionExt as _, EventMask,
    PropertyNotifyEvent,
};

use super::connection::Connection;
use super::scale;
use crate::error::Result;

/// The most settings read, in 32-bit words; real ones take a few hundred.
const MOST_WORDS: u32 = 16 << 10;

const THEME: &[u8] = b"Net/ThemeName";
const MOVES: &[u8] = b"Gtk/EnableAnimations";

/// The desktop's settings, as far as they are given.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Asked {
    pub(super) dark: Option<bool>,
    /// No animations.
    pub(super) still: bool,
}

#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Settings {
    /// The manager's window, or 0.
    manager: u32,
    /// The manager's property has changed.
    stale: bool,
    /// A new manager was announced.
    replaced: bool,
    asked: Asked,
}

impl Settings {
    /// Reads the settings of the first screen's manager, if there is one, and selects its changes.
    pub(super) fn ask(connection: &Connection) -> Result<Self> {
        let mut settings = Self::default();
        settings.find(connection)?;
        Ok(settings)
    }

    /// Finds the current manager. If a new one has not written anything yet, the value is
    /// unchanged; its first write will be an event.
    fn find(&mut self, connection: &Connection) -> Result<()> {
        let selection = connection.atoms()._XSETTINGS_S0;
        let owner = connection.answer(connection.get_selection_owner(selection))?;
        let owner = owner.map_or(0, |answer| answer.owner);
        if owner == 0 {
            return Ok(());
        }
        self.manager = owner;
        let wanted = ChangeWindowAttributesAux::new().event_mask(EventMask::PROPERTY_CHANGE);
        connection.done(connection.change_window_attributes(owner, &wanted))?;
        let before = self.asked;
        if !self.read(connection)? {
            self.asked = before;
        }
        Ok(())
    }

    pub(super) fn asked(&self) -> Asked {
        self.asked
    }

    /// Notes a property change; true if it was the manager's.
    pub(super) fn note(&mut self, connection: &Connection, event: &PropertyNotifyEvent) -> bool {
        let ours =
            event.window == self.manager && event.atom == connection.atoms()._XSETTINGS_SETTINGS;
        self.stale |= ours;
        ours
    }

    /// Handles a MANAGER message on the root window, which announces a new manager.
    pub(super) fn announced(&mut self, connection: &Connection, event: &ClientMessageEvent) {
        let atoms = connection.atoms();
        self.replaced |= event.window == scale::root(connection)
            && event.type_ == atoms.MANAGER
            && event.format == 32
            && event.data.as_data32()[1] == atoms._XSETTINGS_S0;
    }

    /// Reads the settings once for all changes so far, so that a flood of them costs little. True
    /// if the value changed.
    pub(super) fn renew(&mut self, connection: &Connection) -> Result<bool> {
        let before = self.asked;
        let stale = std::mem::take(&mut self.stale);
        if std::mem::take(&mut self.replaced) {
            self.find(connection)?;
        } else if stale {
            self.read(connection)?;
        }
        Ok(self.asked != before)
    }

    /// Returns whether the property exists.
    fn read(&mut self, connection: &Connection) -> Result<bool> {
        let property = connection.atoms()._XSETTINGS_SETTINGS;
        let answer = connection.answer(connection.get_property(
            false,
            self.manager,
            property,
            property,
            0,
            MOST_WORDS,
        ))?;
        // Without a reply the value is unchanged.
        let Some(answer) = answer else {
            return Ok(false);
        };
        let there = answer.type_ != 0;
        self.asked = Asked::default();
        if answer.format == 8 {
            // Anything after a truncation is ignored.
            let _ = self.asked.read(&answer.value);
        }
        Ok(there)
    }
}

fn is_dark(theme: &[u8]) -> Option<bool> {
    let name = theme.to_ascii_lowercase();
    let words = name.split(|byte| !byte.is_ascii_alphanumeric());
    let is_dark = |word: &[u8]| word.ends_with(b"dark") || word.ends_with(b"inverse");
    (!name.is_empty()).then(|| words.into_iter().any(is_dark))
}

impl Asked {
    /// Reads settings, up to the first that is not valid.
    fn read(&mut self, settings: &[u8]) -> Option<()> {
        let mut rest = Reader {
            bytes: settings,
            big_endian: match settings.first()? {
                0 => false,
                1 => true,
                _ => return None,
            },
        };
        rest.take(8)?; // byte order, padding, serial
        let count = rest.long()?;
        for _ in 0..count {
            let kind = rest.take(2)?[0];
            let length = rest.short()?;
            let name = rest.padded(length.into())?;
            rest.take(4)?; // serial
            match kind {
                0 => {
                    let number = rest.long()?;
                    self.still |= name == MOVES && number == 0;
                }
                1 => {
                    let length = rest.long()?;
                    let text = rest.padded(usize::try_from(length).ok()?)?;
                    if name == THEME {
                        self.dark = is_dark(text);
                    }
                }
                2 => drop(rest.take(8)?),
                _ => return None,
            }
        }
        Some(())
    }
}

struct Reader<'a> {
    bytes: &'a [u8],
    big_endian: bool,
}

impl<'a> Reader<'a> {
    fn take(&mut self, count: usize) -> Option<&'a [u8]> {
        let (taken, rest) = self.bytes.split_at_checked(count)?;
        self.bytes = rest;
        Some(taken)
    }

    /// Takes `count` bytes and their padding to a multiple of four.
    fn padded(&mut self, count: usize) -> Option<&'a [u8]> {
        let taken = self.take(count)?;
        self.take(count.wrapping_neg() % 4)?;
        Some(taken)
    }

    fn short(&mut self) -> Option<u16> {
        let bytes = self.take(2)?.try_into().ok()?;
        Some(if self.big_endian {
            u16::from_be_bytes(bytes)
        } else {
            u16::from_le_bytes(bytes)
        })
    }

    fn long(&mut self) -> Option<u32> {
        let bytes = self.take(4)?.try_into().ok()?;
        Some(if self.big_endian {
            u32::from_be_bytes(bytes)
        } else {
            u32::from_le_bytes(bytes)
        })
    }
}

#[cfg(test)]
pub(super) mod tests {
    use proptest::prelude::*;

    use super::*;

    fn is_dark(settings: &[u8]) -> Option<bool> {
        asked(settings).dark
    }

    fn asked(settings: &[u8]) -> Asked {
        let mut asked = Asked::default();
        let _ = asked.read(settings);
        asked
    }

    /// Settings as a manager writes them, with this theme among others; a name that begins with
    /// `still` asks for no animations.
    pub(crate) fn settings(big_endian: bool, theme: &str) -> Vec<u8> {
        let moves = !theme.starts_with("still");
        let short = |value: u16| match big_endian {
            true => value.to_be_bytes(),
            false => value.to_le_bytes(),
        };
        let long = |value: usize| match big_endian {
            true => (value as u32).to_be_bytes(),
            false => (value as u32).to_le_bytes(),
        };
        let mut out = vec![u8::from(big_endian), 0, 0, 0];
        out.extend(long(7));
        out.extend(long(5));
        let fill = |out: &mut Vec<u8>| out.resize(out.len().next_multiple_of(4), 0);
        let mut setting = |kind: u8, name: &str, value: &[u8]| {
            out.extend([kind, 0]);
            out.extend(short(name.len() as u16));
            out.extend(name.bytes());
            fill(&mut out);
            out.extend(long(3));
            if kind == 1 {
                out.extend(long(value.len()));
            }
            out.extend(value);
            fill(&mut out);
        };
        setting(0, "Xft/DPI", &[1, 2, 3, 4]);
        setting(0, "Gtk/EnableAnimations", &long(usize::from(moves)));
        setting(2, "Some/Colour", &[9; 8]);
        setting(1, "Net/IconThemeName", b"Papirus-Dark");
        setting(1, "Net/ThemeName", theme.as_bytes());
        out
    }

    #[test]
    fn themes_tell_by_their_names() {
        for (theme, dark) in [
            ("Adwaita", Some(false)),
            ("Adwaita-dark", Some(true)),
            ("Breeze-Dark", Some(true)),
            ("Mint-Y-Dark-Aqua", Some(true)),
            ("Adwaita:dark", Some(true)),
            ("HighContrastInverse", Some(true)),
            ("Darkness-light", Some(false)),
            ("Clearlooks", Some(false)),
            ("", None),
        ] {
            for big_endian in [false, true] {
                assert_eq!(is_dark(&settings(big_endian, theme)), dark, "{theme}");
            }
        }
    }

    #[test]
    fn desktops_ask_for_stillness() {
        for big_endian in [false, true] {
            let still = |theme| asked(&settings(big_endian, theme)).still;
            assert!(!still("Adwaita") && still("still"));
        }
    }

    #[test]
    fn what_is_cut_off_says_nothing() {
        let whole = settings(false, "Adwaita-dark");
        for length in 0..whole.len() {
            assert_eq!(is_dark(&whole[..length]), None, "{length}");
        }
        let mut endless = settings(false, "Adwaita-dark");
        endless[8..12].fill(0xff);
        assert_eq!(is_dark(&endless), Some(true));
        let at = endless.windows(4).position(|four| four == b"Net/").unwrap();
        endless[at - 2..at].fill(0xff);
        assert_eq!(is_dark(&endless), None);
        assert_eq!(is_dark(&[2; 64]), None);
    }

    #[test]
    fn what_means_something_else_says_nothing() {
        let good = settings(false, "Adwaita-dark");
        let with = |at: usize, byte: u8| {
            let mut changed = good.clone();
            changed[at] = byte;
            is_dark(&changed)
        };
        assert_eq!(with(0, 0), Some(true));
        assert_eq!(with(0, 2), None, "an order of bytes that is none");
        assert_eq!(with(8, 3), None, "behind the last of them");
        // After a kind that does not exist, even without a value.
        let colour = good.windows(4).position(|four| four == b"Some").unwrap();
        let mut other = good.clone();
        other[colour - 4] = 3;
        assert_eq!(is_dark(&other), None);
        other.drain(colour + 16..colour + 24);
        assert_eq!(is_dark(&other), None);
    }

    proptest! {
        #[test]
        fn no_bytes_do_harm(
            bytes in prop::collection::vec(any::<u8>(), 0..200),
            place in 0usize..120,
            byte in any::<u8>(),
        ) {
            is_dark(&bytes);
            let mut nearly = settings(byte % 2 == 1, "Adwaita-dark");
            let length = nearly.len();
            nearly[place % length] = byte;
            is_dark(&nearly);
        }
    }
}
