//! Mapping to egui's keys, by keysym and by keycode.

use egui::Key;
use kbvm::{Keysym, syms};

/// The key for a keysym; `None` if egui has none for it.
pub(super) fn logical(keysym: Keysym) -> Option<Key> {
    if let Some(key) = named(keysym) {
        return Some(key);
    }
    let sign = keysym.char().filter(|sign| sign.is_ascii_graphic())?;
    Key::from_name(sign.encode_utf8(&mut [0; 4]))
}

/// Keys with a name instead of a character.
fn named(keysym: Keysym) -> Option<Key> {
    Some(match keysym {
        syms::Down | syms::KP_Down => Key::ArrowDown,
        syms::Left | syms::KP_Left => Key::ArrowLeft,
        syms::Right | syms::KP_Right => Key::ArrowRight,
        syms::Up | syms::KP_Up => Key::ArrowUp,
        syms::Escape => Key::Escape,
        syms::Tab | syms::KP_Tab | syms::ISO_Left_Tab => Key::Tab,
        syms::BackSpace => Key::Backspace,
        syms::Return | syms::KP_Enter | syms::ISO_Enter => Key::Enter,
        syms::space | syms::KP_Space => Key::Space,
        syms::Insert | syms::KP_Insert => Key::Insert,
        syms::Delete | syms::KP_Delete => Key::Delete,
        syms::Home | syms::KP_Home => Key::Home,
        syms::End | syms::KP_End => Key::End,
        syms::Page_Up | syms::KP_Page_Up => Key::PageUp,
        syms::Page_Down | syms::KP_Page_Down => Key::PageDown,
        syms::XF86Copy => Key::Copy,
        syms::XF86Cut => Key::Cut,
        syms::XF86Paste => Key::Paste,
        syms::F1 | syms::KP_F1 => Key::F1,
        syms::F2 | syms::KP_F2 => Key::F2,
        syms::F3 | syms::KP_F3 => Key::F3,
        syms::F4 | syms::KP_F4 => Key::F4,
        Keysym(code) if (syms::F5.0..=syms::F35.0).contains(&code) => {
            let place = usize::try_from(code - syms::F5.0).ok()?;
            return LATER_FUNCTION_KEYS.get(place).copied();
        }
        syms::XF86Back => Key::BrowserBack,
        syms::XF86Forward => Key::BrowserForward,
        syms::XF86Refresh | syms::XF86Reload => Key::BrowserRefresh,
        syms::XF86Search => Key::BrowserSearch,
        syms::XF86HomePage => Key::BrowserHome,
        syms::XF86Favorites => Key::BrowserFavorites,
        syms::XF86Stop => Key::BrowserStop,
        syms::XF86AudioPlay | syms::XF86AudioPause => Key::MediaPlayPause,
        syms::XF86AudioNext => Key::MediaTrackNext,
        syms::XF86AudioPrev => Key::MediaTrackPrevious,
        syms::XF86AudioStop => Key::MediaStop,
        syms::XF86AudioMute => Key::AudioVolumeMute,
        syms::XF86AudioLowerVolume => Key::AudioVolumeDown,
        syms::XF86AudioRaiseVolume => Key::AudioVolumeUp,
        syms::XF86Mail => Key::LaunchMail,
        syms::XF86MyComputer | syms::XF86Explorer => Key::LaunchApp1,
        syms::XF86Calculator => Key::LaunchApp2,
        syms::Shift_L => Key::ShiftLeft,
        syms::Shift_R => Key::ShiftRight,
        syms::Control_L => Key::ControlLeft,
        syms::Control_R => Key::ControlRight,
        syms::Alt_L | syms::Meta_L => Key::AltLeft,
        syms::Alt_R | syms::Meta_R | syms::ISO_Level3_Shift | syms::Mode_switch => Key::AltRight,
        syms::Super_L => Key::SuperLeft,
        syms::Super_R => Key::SuperRight,
        syms::Caps_Lock => Key::CapsLock,
        syms::Num_Lock => Key::NumLock,
        syms::Scroll_Lock => Key::ScrollLock,
        syms::Print | syms::Sys_Req => Key::PrintScreen,
        syms::Pause | syms::Break => Key::Pause,
        syms::Menu => Key::Menu,
        syms::XF86Fn => Key::Fn,
        syms::XF86Eject => Key::Eject,
        syms::Help => Key::Help,
        syms::XF86PowerOff | syms::XF86PowerDown => Key::Power,
        syms::XF86Sleep => Key::Sleep,
        syms::Clear => Key::Clear,
        _ => return None,
    })
}

const LATER_FUNCTION_KEYS: [Key; 31] = [
    Key::F5,
    Key::F6,
    Key::F7,
    Key::F8,
    Key::F9,
    Key::F10,
    Key::F11,
    Key::F12,
    Key::F13,
    Key::F14,
    Key::F15,
    Key::F16,
    Key::F17,
    Key::F18,
    Key::F19,
    Key::F20,
    Key::F21,
    Key::F22,
    Key::F23,
    Key::F24,
    Key::F25,
    Key::F26,
    Key::F27,
    Key::F28,
    Key::F29,
    Key::F30,
    Key::F31,
    Key::F32,
    Key::F33,
    Key::F34,
    Key::F35,
];

/// The US key at the position of a Linux keycode (the kernel's input event code plus 8).
pub(super) fn physical(keycode: u8) -> Option<Key> {
    if let Some(place) = keycode.checked_sub(FIRST_PLACE)
        && let Some(&key) = PLACES.get(usize::from(place))
    {
        return key;
    }
    Some(match keycode {
        94 => Key::IntlBackslash,
        95 => Key::F11,
        96 => Key::F12,
        104 => Key::Enter,
        105 => Key::ControlRight,
        106 => Key::Slash,
        107 => Key::PrintScreen,
        108 => Key::AltRight,
        110 => Key::Home,
        111 => Key::ArrowUp,
        112 => Key::PageUp,
        113 => Key::ArrowLeft,
        114 => Key::ArrowRight,
        115 => Key::End,
        116 => Key::ArrowDown,
        117 => Key::PageDown,
        118 => Key::Insert,
        119 => Key::Delete,
        125 => Key::Equals,
        127 => Key::Pause,
        133 => Key::SuperLeft,
        134 => Key::SuperRight,
        135 => Key::Menu,
        _ => return None,
    })
}

const FIRST_PLACE: u8 = 9;

/// Keycodes from Escape to the keypad's decimal point, without a gap.
const PLACES: [Option<Key>; 83] = [
    Some(Key::Escape),
    Some(Key::Num1),
    Some(Key::Num2),
    Some(Key::Num3),
    Some(Key::Num4),
    Some(Key::Num5),
    Some(Key::Num6),
    Some(Key::Num7),
    Some(Key::Num8),
    Some(Key::Num9),
    Some(Key::Num0),
    Some(Key::Minus),
    Some(Key::Equals),
    Some(Key::Backspace),
    Some(Key::Tab),
    Some(Key::Q),
    Some(Key::W),
    Some(Key::E),
    Some(Key::R),
    Some(Key::T),
    Some(Key::Y),
    Some(Key::U),
    Some(Key::I),
    Some(Key::O),
    Some(Key::P),
    Some(Key::OpenBracket),
    Some(Key::CloseBracket),
    Some(Key::Enter),
    Some(Key::ControlLeft),
    Some(Key::A),
    Some(Key::S),
    Some(Key::D),
    Some(Key::F),
    Some(Key::G),
    Some(Key::H),
    Some(Key::J),
    Some(Key::K),
    Some(Key::L),
    Some(Key::Semicolon),
    Some(Key::Quote),
    Some(Key::Backtick),
    Some(Key::ShiftLeft),
    Some(Key::Backslash),
    Some(Key::Z),
    Some(Key::X),
    Some(Key::C),
    Some(Key::V),
    Some(Key::B),
    Some(Key::N),
    Some(Key::M),
    Some(Key::Comma),
    Some(Key::Period),
    Some(Key::Slash),
    Some(Key::ShiftRight),
    None, // the keypad's times
    Some(Key::AltLeft),
    Some(Key::Space),
    Some(Key::CapsLock),
    Some(Key::F1),
    Some(Key::F2),
    Some(Key::F3),
    Some(Key::F4),
    Some(Key::F5),
    Some(Key::F6),
    Some(Key::F7),
    Some(Key::F8),
    Some(Key::F9),
    Some(Key::F10),
    Some(Key::NumLock),
    Some(Key::ScrollLock),
    Some(Key::Num7),
    Some(Key::Num8),
    Some(Key::Num9),
    Some(Key::Minus),
    Some(Key::Num4),
    Some(Key::Num5),
    Some(Key::Num6),
    Some(Key::Plus),
    Some(Key::Num1),
    Some(Key::Num2),
    Some(Key::Num3),
    Some(Key::Num0),
    Some(Key::Period),
];

#[cfg(test)]
mod tests {
    use super::*;

    /// Keysyms have the names of X.Org's table, through kbvm.
    fn of(name: &str) -> Option<Key> {
        logical(Keysym::from_str(name).unwrap_or_else(|| panic!("no keysym {name}")))
    }

    #[test]
    fn every_key_of_a_pc_keyboard_has_its_meaning() {
        for (name, key) in [
            ("a", Key::A),
            ("Z", Key::Z),
            ("5", Key::Num5),
            ("KP_5", Key::Num5),
            ("KP_Begin", Key::A),
            ("KP_Decimal", Key::Period),
            ("KP_Separator", Key::Comma),
            ("KP_Add", Key::Plus),
            ("KP_Enter", Key::Enter),
            ("KP_Home", Key::Home),
            ("ISO_Left_Tab", Key::Tab),
            ("F1", Key::F1),
            ("F5", Key::F5),
            ("F12", Key::F12),
            ("F35", Key::F35),
            ("Prior", Key::PageUp),
            ("minus", Key::Minus),
            ("bracketleft", Key::OpenBracket),
            ("apostrophe", Key::Quote),
            ("grave", Key::Backtick),
            ("colon", Key::Colon),
            ("bar", Key::Pipe),
            ("exclam", Key::Exclamationmark),
        ] {
            if name == "KP_Begin" {
                assert_eq!(of(name), None, "{name}");
            } else {
                assert_eq!(of(name), Some(key), "{name}");
            }
        }
        for none in ["adiaeresis", "dead_acute", "Cyrillic_es", "at", "EuroSign"] {
            assert_eq!(of(none), None, "{none}");
        }
    }

    /// Compares with the kernel's numbers in `linux/input-event-codes.h`.
    #[test]
    fn places_are_those_of_the_kernel() {
        for (code, key) in [
            (1, Key::Escape),
            (2, Key::Num1),
            (11, Key::Num0),
            (14, Key::Backspace),
            (16, Key::Q),
            (28, Key::Enter),
            (30, Key::A),
            (44, Key::Z),
            (53, Key::Slash),
            (57, Key::Space),
            (59, Key::F1),
            (68, Key::F10),
            (69, Key::NumLock),
            (71, Key::Num7),
            (83, Key::Period),
            (86, Key::IntlBackslash),
            (88, Key::F12),
            (100, Key::AltRight),
            (102, Key::Home),
            (103, Key::ArrowUp),
            (108, Key::ArrowDown),
            (111, Key::Delete),
            (125, Key::SuperLeft),
        ] {
            assert_eq!(physical(code + 8), Some(key), "{code}");
        }
        assert_eq!(physical(0), None);
        assert_eq!(physical(255), None);
    }
}
