//! The keyboard's shortcuts, and who has the keyboard.
//!
//! The shortcuts are the same in both languages (thesis A.5, and habits of today). While a text is
//! typed, editing keys belong to it; any other shortcut first applies the text.

use egui::{Context, Event, Id, Key, Modifiers};

use crate::action::{Action, FileAction, PathAction, TimeAction};
use crate::state::scene_view::NodeAction;
use crate::state::selected::SelectionChange;
use crate::texts::Language;

const NONE: Modifiers = Modifiers::NONE;
const ALT: Modifiers = Modifiers::ALT;
const CTRL: Modifiers = Modifiers::CTRL;
const CTRL_SHIFT: Modifiers = Modifiers::CTRL.plus(Modifiers::SHIFT);

/// Every shortcut; the menu shows the first of several for one action.
pub(super) const SHORTCUTS: &[(Modifiers, Key, Action)] = &[
    (CTRL, Key::O, Action::File(FileAction::Load)),
    (ALT, Key::L, Action::File(FileAction::Load)),
    (CTRL, Key::N, Action::File(FileAction::New)),
    (CTRL, Key::S, Action::File(FileAction::Save)),
    (CTRL_SHIFT, Key::S, Action::File(FileAction::SaveAs)),
    (ALT, Key::S, Action::File(FileAction::SaveAs)),
    (ALT, Key::F4, Action::File(FileAction::Quit)),
    (CTRL, Key::Q, Action::File(FileAction::Quit)),
    (CTRL, Key::Z, Action::Undo),
    (CTRL_SHIFT, Key::Z, Action::Redo),
    (CTRL, Key::Y, Action::Redo),
    (CTRL, Key::E, Action::File(FileAction::Export)),
    (NONE, Key::Insert, Action::Path(PathAction::AddPoint)),
    (CTRL, Key::K, Action::Path(PathAction::AddHere)),
    (NONE, Key::K, Action::Node(NodeAction::SetKeys)),
    (CTRL, Key::I, Action::Path(PathAction::AskPoints)),
    (NONE, Key::Delete, Action::Path(PathAction::RemovePoint)),
    (CTRL, Key::L, Action::Path(PathAction::SwitchClosed)),
    (CTRL, Key::A, Action::Choose(SelectionChange::All)),
    (CTRL, Key::PageDown, Action::Path(PathAction::NextPoint)),
    (CTRL, Key::PageUp, Action::Path(PathAction::PreviousPoint)),
    (ALT, Key::Insert, Action::Path(PathAction::AddOrientation)),
    (
        ALT,
        Key::Delete,
        Action::Path(PathAction::RemoveOrientation),
    ),
    (
        CTRL_SHIFT,
        Key::PageDown,
        Action::Path(PathAction::NextOrientation),
    ),
    (
        CTRL_SHIFT,
        Key::PageUp,
        Action::Path(PathAction::PreviousOrientation),
    ),
    (CTRL, Key::C, Action::Copy),
    (CTRL, Key::X, Action::Cut),
    (CTRL, Key::V, Action::Paste),
    (ALT, Key::U, Action::HandOver),
    (
        CTRL,
        Key::Enter,
        Action::Path(PathAction::TakeOver { replace: false }),
    ),
    (
        CTRL_SHIFT,
        Key::Enter,
        Action::Path(PathAction::TakeOver { replace: true }),
    ),
    (ALT, Key::F, Action::Colours),
    (ALT, Key::C, Action::Colours),
    (ALT, Key::Z, Action::Display),
    (ALT, Key::T, Action::File(FileAction::LoadSetup)),
    (ALT, Key::P, Action::File(FileAction::SaveSetup)),
    (NONE, Key::F1, Action::Keys),
    (NONE, Key::F2, Action::Curve),
    (NONE, Key::F3, Action::SpeedCurve),
    (NONE, Key::F4, Action::SwitchCameraView),
    (NONE, Key::F5, Action::Time(TimeAction::PlayOrPause)),
    (NONE, Key::F6, Action::Path(PathAction::SwitchAbsolute)),
    (NONE, Key::F7, Action::Path(PathAction::AimAll)),
    (NONE, Key::F8, Action::Check),
];

/// What repeats while the key is held.
const REPEATED: &[Action] = &[
    Action::Undo,
    Action::Redo,
    Action::Path(PathAction::NextPoint),
    Action::Path(PathAction::PreviousPoint),
    Action::Path(PathAction::NextOrientation),
    Action::Path(PathAction::PreviousOrientation),
];

/// What a text being typed needs itself.
const OF_TEXTS: &[Action] = &[
    Action::Undo,
    Action::Redo,
    Action::Path(PathAction::RemovePoint),
    Action::Path(PathAction::RemoveOrientation),
    Action::Copy,
    Action::Cut,
    Action::Paste,
    Action::Choose(SelectionChange::All),
    Action::Node(NodeAction::SetKeys),
];

/// Takes the actions whose keys were pressed out of the input, in their order. Without a `scene`
/// its keys mean nothing; in an open menu they are its letters. Those that open a `menu` are the
/// menu's.
pub(super) fn pressed(context: &Context, scene: bool, menus: &[Key]) -> Vec<Action> {
    let typing = context.text_edit_focused();
    let scene = scene && !egui::Popup::is_any_open(context);
    context.input_mut(|input| {
        let mut found = Vec::new();
        input.events.retain(|event| {
            let action = match event {
                Event::Key {
                    key,
                    pressed: true,
                    repeat,
                    modifiers,
                    ..
                } if !(modifiers.matches_exact(ALT) && menus.contains(key)) => {
                    action_of(*modifiers, *key)
                        .filter(|action| !repeat || REPEATED.contains(action))
                }
                Event::Copy => Some(Action::Copy),
                Event::Cut => Some(Action::Cut),
                Event::Paste(text) if !typing => Some(Action::Pasted(text.clone())),
                _ => None,
            };
            let action = action
                .filter(|action| !(typing && OF_TEXTS.contains(action)))
                .filter(|action| scene || !matches!(action, Action::Node(_)));
            let other = action.is_none();
            found.extend(action);
            other
        });
        found
    })
}

fn action_of(modifiers: Modifiers, key: Key) -> Option<Action> {
    let known = |shortcut: &&(Modifiers, Key, Action)| {
        shortcut.1 == key && modifiers.matches_exact(shortcut.0)
    };
    SHORTCUTS
        .iter()
        .find(known)
        .map(|shortcut| shortcut.2.clone())
}

pub(super) fn words(language: Language, action: &Action) -> Option<String> {
    // Alt+F opens a menu of this language.
    let is_free = |of: &&(Modifiers, Key, Action)| {
        language == Language::German || (of.0, of.1) != (ALT, Key::F)
    };
    let mut known = SHORTCUTS.iter().filter(is_free);
    let &(modifiers, key, _) = known.find(|shortcut| shortcut.2 == *action)?;
    Some(combination(language, modifiers, key))
}

/// The names of keys.
pub(super) fn combination(language: Language, modifiers: Modifiers, key: Key) -> String {
    let texts = &language.texts().menu;
    let mut words = String::new();
    for (held, name) in [
        (modifiers.ctrl, texts.control),
        (modifiers.alt, "Alt"),
        (modifiers.shift, texts.shift),
    ] {
        if held {
            words.push_str(name);
            words.push('+');
        }
    }
    words.push_str(match key {
        Key::Insert => texts.insert,
        Key::Delete => texts.delete,
        Key::PageUp => texts.page_up,
        Key::PageDown => texts.page_down,
        other => other.name(),
    });
    words
}

/// Removes the keyboard focus, which applies a typed text.
pub(super) fn release(context: &Context) {
    context.memory_mut(|memory| {
        if let Some(id) = memory.focused() {
            memory.surrender_focus(id);
        }
    });
}

/// Remembers, at the end of each pass, whether a text is typed and whether a menu is open.
///
/// egui takes the keyboard from a text on Escape, and closes a menu, before anybody sees the key;
/// without this Escape would do that and close a window at once.
pub(super) fn remember_typing(context: &Context) -> bool {
    let typing = context.text_edit_focused();
    let menu = egui::Popup::is_any_open(context);
    context.data_mut(|data| data.insert_temp(typing_id(), (typing, menu)));
    typing
}

/// Whether a text was typed, and a menu open, at the end of the last pass.
fn remembered(context: &Context) -> (bool, bool) {
    context
        .data(|data| data.get_temp(typing_id()))
        .unwrap_or_default()
}

/// Whether a text was being typed when this pass began.
pub(super) fn was_typing(context: &Context) -> bool {
    remembered(context).0 || context.text_edit_focused()
}

/// Takes Escape out of the input if it was pressed and only a window has use for it.
pub(super) fn take_escape(context: &Context) -> bool {
    !was_typing(context)
        && !remembered(context).1
        && !egui::Popup::is_any_open(context)
        // egui ends a drag on Escape before anybody sees the key.
        && !context.input(|input| input.pointer.any_down())
        && consume_escape(context)
}

/// The same, even where a widget has a use for it.
pub(super) fn consume_escape(context: &Context) -> bool {
    context.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Escape))
}

fn typing_id() -> Id {
    Id::unique("typing")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_two_actions_share_their_keys() {
        for (index, one) in SHORTCUTS.iter().enumerate() {
            for other in &SHORTCUTS[index + 1..] {
                assert!((one.0, one.1) != (other.0, other.1), "{one:?} {other:?}");
            }
        }
    }

    #[test]
    fn keys_are_named_in_the_windows_language() {
        let german = |action: Action| words(Language::German, &action);
        assert_eq!(
            german(Action::File(FileAction::Save)).as_deref(),
            Some("Strg+S")
        );
        assert_eq!(german(Action::Redo).as_deref(), Some("Strg+Umschalt+Z"));
        assert_eq!(
            german(Action::Path(PathAction::RemovePoint)).as_deref(),
            Some("Entf")
        );
        let english = |action: Action| words(Language::English, &action);
        assert_eq!(
            english(Action::File(FileAction::Quit)).as_deref(),
            Some("Alt+F4")
        );
        assert_eq!(english(Action::Path(PathAction::AppendPoint)), None);
    }

    /// What is done often needs no menu.
    #[test]
    fn a_key_exports_closes_the_path_and_checks_it() {
        use crate::tests::{BOTH, LARGE, Theme, press, window_with_points};
        use egui_kittest::kittest::Queryable as _;
        for language in BOTH {
            let mut window = window_with_points(language, LARGE, 1.0, Theme::Dark);
            let before = window.state().document.path().closed;
            for closed in [!before, before] {
                press(&mut window, CTRL, Key::L);
                assert_eq!(window.state().document.path().closed, closed);
            }
            press(&mut window, NONE, Key::F8);
            assert!(window.state().windows.check.is_some());
            press(&mut window, CTRL, Key::E);
            let title = language.texts().files.export;
            assert!(window.query_by_label(title).is_some());
        }
    }
}
