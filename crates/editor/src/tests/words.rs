//! What can be said of the window's words without reading them: every letter has a picture, none is in the other language.

use super::*;
use crate::texts::Texts;
use crate::theme;
use egui_kittest::kittest::{NodeT, by};

#[test]
fn every_letter_of_every_text_can_be_drawn() {
    let window = window(Language::German);
    for (name, english, german) in Texts::all() {
        for text in [english, german] {
            let drawn = window
                .ctx
                .fonts_mut(|fonts| fonts.has_glyphs(&theme::text(), text));
            assert!(drawn, "{name}: {text}");
        }
    }
}

/// The window shows arrows; what the thesis calls them stands where they are switched off.
#[test]
fn texts_need_no_thesis() {
    let all = Texts::all();
    for (name, english, german) in all.filter(|(name, ..)| !name.starts_with("display")) {
        for text in [english, german] {
            assert!(
                !text.contains("VPN") && !text.contains("VUP"),
                "{name}: {text}"
            );
        }
    }
}

/// All texts that are painted.
pub(super) fn painted(shapes: &[egui::epaint::ClippedShape]) -> Vec<String> {
    fn add(shape: &egui::Shape, found: &mut Vec<String>) {
        match shape {
            egui::Shape::Text(text) => found.push(text.galley.text().to_owned()),
            egui::Shape::Vec(shapes) => shapes.iter().for_each(|shape| add(shape, found)),
            _ => {}
        }
    }
    let mut found = Vec::new();
    shapes
        .iter()
        .for_each(|clipped| add(&clipped.shape, &mut found));
    found
}

/// Whether a text is this one with values in its places, of which there are some.
fn is_filled(text: &str, template: &str) -> bool {
    let mut parts = template.split('{');
    let first = parts.next().unwrap_or_default();
    let Some(mut rest) = text.strip_prefix(first) else {
        return false;
    };
    let mut places = 0;
    for part in parts {
        let literal = part.split_once('}').map_or(part, |(_, literal)| literal);
        let Some(at) = rest.find(literal) else {
            return false;
        };
        rest = if literal.is_empty() {
            ""
        } else {
            &rest[at + literal.len()..]
        };
        places += 1;
    }
    places > 0 && rest.is_empty()
}

/// Whatever is open, a window of one language shows no text of the other, and
/// egui adds none of its own.
#[test]
fn no_text_is_in_the_other_language() {
    for language in BOTH {
        let texts = language.texts();
        let foreign: Vec<&str> = Texts::all()
            .filter(|(_, english, german)| english != german)
            .map(|(_, english, german)| match language {
                Language::English => german,
                Language::German => english,
            })
            // Some words are those of another text in this language.
            .filter(|foreign| {
                Texts::all().all(|(_, e, g)| {
                    *foreign
                        != match language {
                            Language::English => e,
                            Language::German => g,
                        }
                })
            })
            .collect();
        // Those with places for values, and words that tell them.
        let filled_in = |language: Language, text: &str| {
            let all = Texts::all();
            let mut all = all.filter(|(_, english, german)| english != german);
            all.any(|(_, english, german)| {
                let template = match language {
                    Language::English => english,
                    Language::German => german,
                };
                let letters = template.chars().filter(|letter| letter.is_alphabetic());
                letters.count() > 3 && is_filled(text, template)
            })
        };
        let [own, other] = match language {
            Language::English => [Language::English, Language::German],
            Language::German => [Language::German, Language::English],
        };
        let check = |window: &Window, when: &str| {
            let labels = window
                .query_all(by().predicate(|node| node.label().is_some()))
                .filter_map(|node| node.accesskit_node().label());
            let mut count = 0;
            for text in painted(&window.output().shapes).into_iter().chain(labels) {
                assert!(!foreign.contains(&text.trim()), "{when}: {text}");
                let filled = filled_in(other, &text) && !filled_in(own, &text);
                assert!(!filled, "{when}: {text}");
                count += 1;
            }
            assert!(count > 30, "{when}: {count}");
        };
        let mut window = window_with_points(language, LARGE, 1.0, Theme::Dark);
        check(&window, "at first");
        for menu in [
            texts.menu.file,
            texts.menu.edit,
            texts.menu.output,
            texts.menu.settings,
            texts.menu.help,
        ] {
            click(&mut window, menu);
            check(&window, menu);
            press(&mut window, Modifiers::NONE, Key::Escape);
        }
        for (modifiers, key) in [
            (Modifiers::NONE, Key::F2),
            (Modifiers::NONE, Key::F3),
            (Modifiers::ALT, Key::C),
            (Modifiers::ALT, Key::Z),
            (Modifiers::NONE, Key::F1),
            (Modifiers::ALT, Key::L),
            (Modifiers::ALT, Key::P),
        ] {
            press(&mut window, modifiers, key);
            check(&window, key.name());
            press(&mut window, Modifiers::NONE, Key::Escape);
        }
        press(&mut window, Modifiers::CTRL, Key::I);
        check(&window, "how many");
        press(&mut window, Modifiers::NONE, Key::Escape);
        press(&mut window, Modifiers::NONE, Key::Delete);
        window.state_mut().ask_to_close();
        window.run();
        check(&window, "question");
    }
}
