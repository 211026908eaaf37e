//! What can be said of the window's looks without looking: every letter has a
//! picture, numbers stand in columns, nothing is cut off.

use egui_kittest::kittest::{NodeT, by};

use super::*;
use crate::editor::texts::Texts;
use crate::editor::theme;

#[test]
fn every_letter_of_every_text_can_be_drawn() {
    let window = window(Language::German);
    for (name, english, german) in Texts::ALL.iter().copied().flatten() {
        for text in [english, german] {
            let drawn = window
                .ctx
                .fonts_mut(|fonts| fonts.has_glyphs(&theme::text(), text));
            assert!(drawn, "{name}: {text}");
        }
    }
}

#[test]
fn digits_are_of_equal_width() {
    let window = window(Language::German);
    let widths: Vec<f32> = ('0'..='9')
        .map(|digit| {
            window
                .ctx
                .fonts_mut(|fonts| fonts.glyph_width(&theme::text(), digit))
        })
        .collect();
    assert!(widths[0] > 4.0);
    assert!(widths.iter().all(|&width| width == widths[0]), "{widths:?}");
}

/// Whatever has a name lies within the window, to a border's width.
fn check_nothing_is_cut_off(window: &Window, when: &str) {
    let whole = window.ctx.content_rect();
    let mut count = 0;
    for node in window.query_all(by().predicate(|node| node.label().is_some())) {
        let rect = node.rect();
        assert!(
            whole.expand(1.0).contains_rect(rect),
            "{when}: {:?} {rect:?}",
            node.accesskit_node().label()
        );
        count += 1;
    }
    assert!(count > 20, "{when}: {count}");
}

#[test]
fn nothing_is_cut_off_in_the_smallest_window() {
    for language in BOTH {
        let texts = language.texts();
        let options = Options {
            document: some_points(),
            ..options(language)
        };
        let mut window = window_of(options, [800.0, 600.0], 1.0, Theme::Dark);
        check_nothing_is_cut_off(&window, "at first");
        for action in ["far", "roll"] {
            let (name, text) = match action {
                "far" => (fill(texts.position.coordinate, &[&"x"]), "-0.999"),
                _ => (texts.orientation.roll.to_owned(), "-179.9"),
            };
            enter(&mut window, &name, text);
            check_nothing_is_cut_off(&window, action);
        }
        for (key, menu) in [(Key::D, "file"), (Key::A, "output"), (Key::E, "settings")] {
            press(&mut window, Modifiers::ALT, key);
            check_nothing_is_cut_off(&window, menu);
            press(&mut window, Modifiers::NONE, Key::Escape);
        }
        click(&mut window, texts.menu.edit);
        check_nothing_is_cut_off(&window, "edit");
        press(&mut window, Modifiers::NONE, Key::Escape);
        click(&mut window, texts.position.add_many);
        check_nothing_is_cut_off(&window, "points");
        press(&mut window, Modifiers::NONE, Key::Escape);
        window.state_mut().ask_to_close();
        window.run();
        check_nothing_is_cut_off(&window, "question");
    }
}

#[test]
fn columns_do_not_jump() {
    let mut window = window(Language::German);
    let places = |window: &Window| -> Vec<f32> {
        // Where each text of the bar ends.
        let shapes = &window.output().shapes;
        let mut ends = Vec::new();
        for shape in shapes {
            if let egui::Shape::Text(text) = &shape.shape
                && text.pos.y < 32.0
                && text
                    .galley
                    .text()
                    .ends_with(|letter: char| letter.is_ascii_digit() || letter == '°')
            {
                ends.push(text.pos.x + text.galley.size().x);
            }
        }
        ends
    };
    let before = places(&window);
    assert_eq!(before.len(), 9, "{before:?}");
    for (name, text) in [
        ("Position x", "0,777"),
        ("Winkel", "-123,4"),
        ("Zoomwert", "8"),
    ] {
        enter(&mut window, name, text);
        let after = places(&window);
        assert_eq!(after.len(), before.len());
        for (before, after) in before.iter().zip(&after) {
            assert!((before - after).abs() < 0.51, "{name}: {before} {after}");
        }
    }
}
