//! The meaning of the server's keys: from XKB (read by kbvm), or from the core protocol without it.

use std::panic::{AssertUnwindSafe, catch_unwind};

use egui::Key;
use kbvm::lookup::LookupTable;
use kbvm::xkb::x11::KbvmX11Ext as _;
use kbvm::{GroupIndex, Keycode, Keysym, ModifierMask, syms};
use x11rb::connection::{Connection as _, RequestConnection};
use x11rb::protocol::xproto::ConnectionExt as _;

use super::connection::Connection;
use super::core_keymap::{CONTROL, CoreKeymap, MOD1};
use super::keys;
use crate::error::Result;

/// XkbUseCoreKbd: whichever device is the core keyboard.
pub(super) const KEYBOARD: u16 = 0x100;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Meaning {
    /// Depends on the modifiers held.
    pub(super) keysym: Keysym,
    /// egui's logical key, if it has one.
    pub(super) key: Option<Key>,
    /// egui's key at this position, if the keycodes are known.
    pub(super) physical: Option<Key>,
    /// A modifier makes it a command instead of text.
    pub(super) command: bool,
}

pub(super) struct Keymap {
    /// From XKB; without it `core` serves all keys.
    table: Option<LookupTable>,
    core: CoreKeymap,
    alt: u16,
    logo: u16,
    /// Keycodes are Linux's, so positions are known.
    places: bool,
}

impl Keymap {
    /// Loads the keymap from the server, with `extension` from XKB, which must be enabled. `None`
    /// if the server does not answer sensibly.
    pub(super) fn load(connection: &Connection, extension: bool) -> Result<Option<Self>> {
        let setup = connection.setup();
        let first = setup.min_keycode;
        let count = setup.max_keycode.saturating_sub(first).saturating_add(1);
        let keys = connection.get_keyboard_mapping(first, count);
        let modifiers = connection.get_modifier_mapping();
        let xkb = extension.then(|| read(&**connection)).flatten();
        let keys = connection.answer(keys)?;
        let modifiers = connection.answer(modifiers)?;
        let (Some(keys), Some(modifiers)) = (keys, modifiers) else {
            return Ok(None);
        };
        let core = CoreKeymap::new(first, keys, &modifiers);
        Ok(Some(Self::new(xkb, core)))
    }

    fn new(xkb: Option<Xkb>, core: CoreKeymap) -> Self {
        let (table, alt, logo) = match xkb {
            Some(xkb) => (Some(xkb.table), xkb.alt, xkb.logo),
            None => (None, core.alt, core.logo),
        };
        let mut map = Self {
            table,
            core,
            alt: if alt == 0 { MOD1 } else { alt },
            logo,
            places: false,
        };
        // Two keys that no layout moves: Escape and Return.
        map.places = map.keysym(9, 0).0 == syms::Escape && map.keysym(36, 0).0 == syms::Return;
        map
    }

    pub(super) fn alt(&self) -> u16 {
        self.alt
    }

    pub(super) fn sets(&self, keycode: u8) -> u16 {
        self.core.sets(keycode)
    }

    pub(super) fn meaning(&self, keycode: u8, state: u16) -> Meaning {
        let (keysym, left) = self.keysym(keycode, state);
        let physical = keys::physical(keycode).filter(|_| self.places);
        Meaning {
            keysym,
            key: keys::logical(keysym)
                .or_else(|| self.latin(keycode, state))
                .or(physical),
            physical,
            command: left & (CONTROL | self.alt | self.logo) != 0,
        }
    }

    /// The keysym, and the modifiers not consumed in finding it.
    fn keysym(&self, keycode: u8, state: u16) -> (Keysym, u16) {
        match self.table.as_ref() {
            Some(table) => {
                let found = look(table, keycode, state, group(state));
                match found {
                    (syms::NoSymbol, _) => self.core.lookup(keycode, state),
                    found => found,
                }
            }
            None => self.core.lookup(keycode, state),
        }
    }

    /// The key in another group with Latin letters, for shortcuts on Cyrillic or Greek layouts.
    fn latin(&self, keycode: u8, state: u16) -> Option<Key> {
        let table = self.table.as_ref()?;
        let (own, _) = look(table, keycode, state, group(state));
        if own
            .char()
            .is_none_or(|sign| !sign.is_alphabetic() || sign < LAST_LATIN)
        {
            return None;
        }
        (0..GROUPS)
            .map(|group| look(table, keycode, state, group).0)
            .find_map(keys::logical)
    }
}

/// The most groups XKB allows.
const GROUPS: u32 = 4;

/// The end of Latin Extended-B; other alphabets follow.
const LAST_LATIN: char = '\u{250}';

fn group(state: u16) -> u32 {
    u32::from(state >> 13) & 3
}

fn look(table: &LookupTable, keycode: u8, state: u16, group: u32) -> (Keysym, u16) {
    let modifiers = u32::from(state & 0xFF);
    let found = table
        .lookup(
            GroupIndex(group),
            ModifierMask(modifiers),
            Keycode::from_x11(keycode.into()),
        )
        .with_ctrl_fallback(false)
        .with_ctrl_transform(false);
    let left = u16::try_from(found.remaining_mods().0 & 0xFF).unwrap_or(0);
    let keysym = found.into_iter().next().map(|found| found.keysym());
    (keysym.unwrap_or(syms::NoSymbol), left)
}

struct Xkb {
    table: LookupTable,
    alt: u16,
    logo: u16,
}

/// Reads the XKB keymap. Invalid data from a server may make kbvm panic, which counts as no answer.
fn read(connection: &impl RequestConnection) -> Option<Xkb> {
    let read = AssertUnwindSafe(|| {
        let keymap = connection.get_xkb_keymap(KEYBOARD).ok()?;
        let mask = |names: &[&str]| {
            let bits = keymap
                .virtual_modifiers()
                .filter(|modifier| names.contains(&modifier.name()))
                .fold(0, |bits, modifier| bits | modifier.mask().0);
            u16::try_from(bits & 0xFF).unwrap_or(0)
        };
        Some(Xkb {
            alt: mask(&["Alt", "Meta"]),
            logo: mask(&["Super", "Hyper"]),
            table: keymap.to_builder().build_lookup_table(),
        })
    });
    catch_unwind(read).ok().flatten()
}
