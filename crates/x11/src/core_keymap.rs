//! The keyboard by the core protocol, for connections without XKB (untrusted clients, `ssh -X`).
//!
//! Follows chapter 5 of the X protocol, except that the fifth and sixth keysym, if given, are
//! levels three and four of the first group, as servers with XKB fill them.

use kbvm::{Keysym, syms};
use x11rb::protocol::xproto::{GetKeyboardMappingReply, GetModifierMappingReply};

/// Modifier bits of an event's state.
pub(super) const SHIFT: u16 = 1;
pub(super) const LOCK: u16 = 1 << 1;
pub(super) const CONTROL: u16 = 1 << 2;
/// The first modifier without a fixed meaning.
pub(super) const MOD1: u16 = 1 << 3;

#[derive(Debug)]
pub(super) struct CoreKeymap {
    first: u8,
    width: usize,
    keysyms: Vec<u32>,
    sets: Box<[u8; 256]>,
    pub(super) alt: u16,
    pub(super) logo: u16,
    num_lock: u16,
    second_group: u16,
    third_level: u16,
    shift_lock: bool,
}

impl CoreKeymap {
    /// Reads the server's replies, which are not trusted; `first` is the first keycode in `keys`.
    pub(super) fn new(
        first: u8,
        keys: GetKeyboardMappingReply,
        modifiers: &GetModifierMappingReply,
    ) -> Self {
        let mut map = Self {
            first,
            width: usize::from(keys.keysyms_per_keycode),
            keysyms: keys.keysyms,
            sets: Box::new([0; 256]),
            alt: 0,
            logo: 0,
            num_lock: 0,
            second_group: 0,
            third_level: 0,
            shift_lock: false,
        };
        let each = (modifiers.keycodes.len() / 8).max(1);
        for (modifier, keycodes) in modifiers.keycodes.chunks_exact(each).take(8).enumerate() {
            for &keycode in keycodes.iter().filter(|&&keycode| keycode != 0) {
                map.modifier(1 << modifier, keycode);
            }
        }
        map
    }

    /// Records that a key sets this modifier, and what follows for the meaning of the modifier.
    fn modifier(&mut self, bit: u8, keycode: u8) {
        if let Some(sets) = self.sets.get_mut(usize::from(keycode)) {
            *sets |= bit;
        }
        let bit = u16::from(bit);
        let list = self.list(keycode);
        let has = |keysyms: &[Keysym]| list.iter().any(|&keysym| keysyms.contains(&Keysym(keysym)));
        let alt = has(&[syms::Alt_L, syms::Alt_R, syms::Meta_L, syms::Meta_R]);
        let logo = has(&[syms::Super_L, syms::Super_R, syms::Hyper_L, syms::Hyper_R]);
        let num_lock = has(&[syms::Num_Lock]);
        let second_group = has(&[syms::Mode_switch]);
        let third_level = has(&[syms::ISO_Level3_Shift]);
        let shift_lock = has(&[syms::Shift_Lock]);
        if bit == LOCK {
            self.shift_lock |= shift_lock;
        }
        // Shift, Lock and Control keep their meaning whatever keys set them.
        if bit >= MOD1 {
            self.alt |= if alt { bit } else { 0 };
            self.logo |= if logo { bit } else { 0 };
            self.num_lock |= if num_lock { bit } else { 0 };
            self.second_group |= if second_group { bit } else { 0 };
            self.third_level |= if third_level { bit } else { 0 };
        }
    }

    fn list(&self, keycode: u8) -> &[u32] {
        let place = keycode.checked_sub(self.first).map(usize::from);
        let start = place.and_then(|place| place.checked_mul(self.width));
        let end = start.and_then(|start| start.checked_add(self.width));
        match (start, end) {
            (Some(start), Some(end)) => self.keysyms.get(start..end).unwrap_or_default(),
            _ => &[],
        }
    }

    pub(super) fn sets(&self, keycode: u8) -> u16 {
        self.sets
            .get(usize::from(keycode))
            .map_or(0, |&sets| sets.into())
    }

    /// The keysym under these modifiers, and the modifiers not consumed.
    pub(super) fn lookup(&self, keycode: u8, state: u16) -> (Keysym, u16) {
        let list = self.list(keycode);
        let at = |place: usize| Keysym(list.get(place).copied().unwrap_or(0));
        let used_up = state & (self.second_group | self.third_level);
        let left = state & !used_up;
        if state & self.third_level != 0 {
            let third = Self::choose(at(4), at(5), self.shift(state, at(5)));
            if third != syms::NoSymbol {
                return (third, left);
            }
        }
        let second = state & self.second_group != 0 && (at(2), at(3)) != NOTHING;
        let (plain, shifted) = if second {
            (at(2), at(3))
        } else {
            (at(0), at(1))
        };
        // A letter given alone implies its capital.
        let shifted = match shifted {
            syms::NoSymbol => plain.to_uppercase(),
            shifted => shifted,
        };
        let keysym = Self::choose(plain, shifted, self.shift(state, shifted));
        let caps = state & LOCK != 0 && !self.shift_lock;
        (if caps { keysym.to_uppercase() } else { keysym }, left)
    }

    fn shift(&self, state: u16, shifted: Keysym) -> bool {
        let shift = state & SHIFT != 0 || (state & LOCK != 0 && self.shift_lock);
        // Num Lock inverts Shift on the keypad.
        let turned = state & self.num_lock != 0 && is_keypad(shifted);
        shift != turned
    }

    fn choose(plain: Keysym, shifted: Keysym, second: bool) -> Keysym {
        if second { shifted } else { plain }
    }
}

const NOTHING: (Keysym, Keysym) = (syms::NoSymbol, syms::NoSymbol);

/// The keysyms Num Lock affects: the keypad's and a vendor range.
fn is_keypad(keysym: Keysym) -> bool {
    keysym.is_keypad() || (0x1100_0000..=0x1100_FFFF).contains(&keysym.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    const NUM_LOCK: u16 = 1 << 4;
    const LEVEL_3: u16 = 1 << 7;

    /// Four keys from keycode 10 on, six keysyms each.
    fn map() -> CoreKeymap {
        let name = |name: &str| match name {
            "" => 0,
            name => Keysym::from_str(name).unwrap().0,
        };
        let keys = [
            ["q", "Q", "q", "Q", "at", "Greek_OMEGA"],
            ["odiaeresis", "", "", "", "", ""],
            ["KP_Home", "KP_7", "KP_Home", "KP_7", "", ""],
            ["Num_Lock", "", "", "", "", ""],
            ["ISO_Level3_Shift", "", "", "", "", ""],
            ["Alt_L", "Meta_L", "", "", "", ""],
            ["7", "slash", "", "", "", ""],
        ];
        let mut modifiers = vec![0; 16];
        modifiers[2 * 3] = 15;
        modifiers[2 * 4 + 1] = 13;
        modifiers[2 * 7] = 14;
        CoreKeymap::new(
            10,
            GetKeyboardMappingReply {
                keysyms_per_keycode: 6,
                keysyms: keys.iter().flatten().map(|key| name(key)).collect(),
                ..Default::default()
            },
            &GetModifierMappingReply {
                keycodes: modifiers,
                ..Default::default()
            },
        )
    }

    #[test]
    fn levels_follow_the_protocol() {
        let map = map();
        for (keycode, state, name) in [
            (10, 0, "q"),
            (10, SHIFT, "Q"),
            (10, LOCK, "Q"),
            (10, SHIFT | LOCK, "Q"),
            (10, LEVEL_3, "at"),
            (10, LEVEL_3 | SHIFT, "Greek_OMEGA"),
            (11, 0, "odiaeresis"),
            (11, SHIFT, "Odiaeresis"),
            (11, LOCK, "Odiaeresis"),
            (11, LEVEL_3, "odiaeresis"),
            (12, 0, "KP_Home"),
            (12, NUM_LOCK, "KP_7"),
            (12, NUM_LOCK | SHIFT, "KP_Home"),
            (12, SHIFT, "KP_7"),
            (16, LOCK, "7"),
            (16, SHIFT | NUM_LOCK, "slash"),
        ] {
            let (keysym, _) = map.lookup(keycode, state);
            assert_eq!(keysym.name(), Some(name), "{keycode} {state:#x}");
        }
        assert_eq!(map.lookup(10, LEVEL_3 | CONTROL).1, CONTROL);
        assert_eq!((map.alt, map.logo), (MOD1, 0));
        assert_eq!(
            (map.sets(15), map.sets(10), map.sets(14)),
            (MOD1, 0, LEVEL_3)
        );
    }

    #[test]
    fn senseless_answers_do_no_harm() {
        for (width, keysyms, modifiers) in [
            (0, vec![], vec![]),
            (255, vec![0xFFFF_FFFF; 3], vec![1, 2, 3]),
            (3, vec![0x61; 7], vec![255; 2040]),
            (0, vec![0x61; 700], vec![10; 9]),
        ] {
            let map = CoreKeymap::new(
                200,
                GetKeyboardMappingReply {
                    keysyms_per_keycode: width,
                    keysyms,
                    ..Default::default()
                },
                &GetModifierMappingReply {
                    keycodes: modifiers,
                    ..Default::default()
                },
            );
            for keycode in 0..=255 {
                for state in [0, SHIFT, LOCK, 0xFF, 0xFFFF] {
                    let _ = map.lookup(keycode, state);
                }
            }
        }
    }
}
