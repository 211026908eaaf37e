//! Pictures of the window, to be looked at (`VIDES_SCREENSHOTS` names the
//! folder), and what can be said of its looks without looking.

use super::*;
use crate::screenshots::screenshot;

#[test]
fn the_main_window() {
    for (language, name) in [(Language::German, "de"), (Language::English, "en")] {
        for (theme, look) in [(Theme::Dark, "dark"), (Theme::Light, "light")] {
            for size in [LARGE, SMALL] {
                for scale in [1.0, 1.5, 2.0] {
                    let mut window = window_with_points(language, size, scale, theme);
                    let name = format!("frame-{name}-{look}-{}-{scale}.png", size[0]);
                    screenshot(&mut window, &name);
                }
            }
        }
    }
}

#[test]
fn menus_and_windows() {
    for (language, theme, name) in [
        (Language::German, Theme::Dark, "de"),
        (Language::English, Theme::Light, "en"),
    ] {
        let mut window = window_with_points(language, SMALL, 1.0, theme);
        for (key, menu) in [(Key::D, "file"), (Key::A, "output"), (Key::E, "settings")] {
            press(&mut window, Modifiers::ALT, key);
            screenshot(&mut window, &format!("menu-{name}-{menu}.png"));
            press(&mut window, Modifiers::NONE, Key::Escape);
        }
        let texts = language.texts();
        click(&mut window, texts.menu.edit);
        screenshot(&mut window, &format!("menu-{name}-edit.png"));
        press(&mut window, Modifiers::NONE, Key::Escape);
        press(&mut window, Modifiers::NONE, Key::F1);
        screenshot(&mut window, &format!("help-{name}.png"));
        press(&mut window, Modifiers::NONE, Key::Escape);
        press(&mut window, Modifiers::CTRL, Key::I);
        screenshot(&mut window, &format!("points-{name}.png"));
        press(&mut window, Modifiers::NONE, Key::Escape);
        press(&mut window, Modifiers::ALT, Key::S);
        screenshot(&mut window, &format!("files-{name}.png"));
        press(&mut window, Modifiers::NONE, Key::Escape);
        press(&mut window, Modifiers::NONE, Key::Delete);
        window.state_mut().ask_to_close();
        window.run();
        screenshot(&mut window, &format!("question-{name}.png"));
        press(&mut window, Modifiers::NONE, Key::Escape);
        for _ in 0..4 {
            press(&mut window, Modifiers::NONE, Key::Delete);
        }
        press(&mut window, Modifiers::NONE, Key::Delete);
        screenshot(&mut window, &format!("error-{name}.png"));
    }
}
