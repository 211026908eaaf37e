//! The letters of menus and their entries. Each language has its own, the German ones those of the
//! thesis where it has any. None takes a shortcut of the thesis from it, and the German ones hold in
//! English too where they are free.

use egui::text::{LayoutJob, TextFormat};
use egui::{Color32, Context, Key, Modifiers, Stroke};

use super::entry::{Entry, Menu};
use crate::action::Action;
use crate::texts::Language;
use crate::theme;

/// The letters that open the menus in German.
pub(super) const GERMAN: [Key; 6] = [Key::D, Key::B, Key::A, Key::W, Key::E, Key::H];

/// The letters that open the menus with Alt, and the titles. In windows of hosts of 1994, Alt+F is
/// not free: it opens the colours, as their manual says.
pub(crate) fn letters(language: Language, of_1994: bool) -> [(Key, &'static str); 6] {
    let (menu, tools) = (&language.texts().menu, &language.texts().tools);
    let letters = match language {
        Language::German => GERMAN,
        Language::English => {
            let file = if of_1994 { Key::I } else { Key::F };
            [file, Key::E, Key::X, Key::O, Key::G, Key::H]
        }
    };
    let titles = [
        menu.file,
        menu.edit,
        menu.output,
        tools.menu,
        menu.settings,
        menu.help,
    ];
    std::array::from_fn(|at| (letters[at], titles[at]))
}

/// Whether a letter can be a key of words: it is in them, an umlaut being its vowel.
pub(super) fn is_in(letter: Key, words: &str) -> bool {
    words.chars().any(|sign| key_of(sign) == Some(letter))
}

/// The key of a sign, if it is a letter.
pub(super) fn key_of(sign: char) -> Option<Key> {
    let sign = match sign.to_lowercase().next()? {
        'ä' => 'A',
        'ö' => 'O',
        'ü' => 'U',
        sign if sign.is_ascii_alphabetic() => sign.to_ascii_uppercase(),
        _ => return None,
    };
    Key::from_name(sign.encode_utf8(&mut [0; 4]))
}

/// Each entry with a letter of its words that no other of the menu has: its own if that is one of
/// them, else one that begins a word, else any.
pub(super) fn lettered(mut entries: Vec<Entry>) -> Vec<Entry> {
    let mut taken = Vec::new();
    for entry in &mut entries {
        let text = &entry.text;
        entry.other_letter = entry.letter;
        entry.letter = entry
            .letter
            .filter(|&own| is_in(own, text) && !taken.contains(&own));
        taken.extend(entry.letter);
    }
    for entry in &mut entries {
        let first = entry.text.split(' ').filter_map(|word| word.chars().next());
        let all = first.chain(entry.text.chars());
        let free = all.filter_map(key_of).find(|key| !taken.contains(key));
        entry.letter = entry.letter.or(free);
        taken.extend(entry.letter);
    }
    entries
}

/// A text whose first such letter is underlined.
pub(super) fn underlined(text: &str, letter: Option<Key>, color: Color32) -> LayoutJob {
    let mut job = LayoutJob::default();
    let plain = TextFormat::simple(theme::text(), color);
    let at = text
        .char_indices()
        .find(|&(_, sign)| letter.is_some() && key_of(sign) == letter);
    let (from, to) = at.map_or((0, 0), |(at, sign)| (at, at + sign.len_utf8()));
    let mut line = plain.clone();
    line.underline = Stroke::new(1.0, color);
    for (range, format) in [
        (0..from, &plain),
        (from..to, &line),
        (to..text.len(), &plain),
    ] {
        job.append(&text[range], 0.0, format.clone());
    }
    job
}

/// An entry's letter, with Alt or without, in the open menu.
pub(super) fn pick_by_letter(context: &Context, menu: &Menu) -> Option<Action> {
    let pressed = |letter: Option<Key>| {
        letter.is_some_and(|letter| {
            context.input_mut(|input| {
                input.consume_key(Modifiers::NONE, letter)
                    || input.consume_key(Modifiers::ALT, letter)
            })
        })
    };
    let has = |letter| menu.entries.iter().any(|entry| entry.letter == letter);
    let mut entries = menu.entries.iter().filter(|entry| entry.enabled);
    let own = entries.clone().find(|entry| pressed(entry.letter));
    let entry = own
        .or_else(|| entries.find(|entry| !has(entry.other_letter) && pressed(entry.other_letter)));
    Some(entry?.action.clone())
}
