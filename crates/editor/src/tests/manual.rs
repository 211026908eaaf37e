//! What the thesis's Anhang A says of the window and no other test shows.

use egui::{Rect, Role};

use super::*;
use crate::setup::View;

/// The window of a host of 1994, with the sliders that others choose.
fn window_of_1994(language: Language) -> Window {
    let options = Options {
        fixed_speeds: true,
        ..options(language)
    };
    window_of(options, LARGE, 1.0, Theme::Dark)
}

/// The main window as Abb. A.1 shows it.
#[test]
fn the_parts_lie_around_the_movement_window() {
    for language in BOTH {
        let texts = language.texts();
        let window = window_of_1994(language);
        let of = |label: &str| window.get_by_label(label).rect();
        let slider = |label: &str| window.get_by_role_and_label(Role::Slider, label).rect();
        let space = of(texts.space.name);
        let (width, height) = (1200.0, 800.0);
        assert!(space.width() > 0.6 * width && space.height() > 0.6 * height);
        let menus = [texts.menu.file, texts.menu.output, texts.menu.settings].map(of);
        for menu in menus {
            assert!(menu.bottom() < space.top(), "menus above");
        }
        let setting = window
            .query_all_by_label_contains("Position −")
            .map(|node| node.rect())
            .next()
            .expect("the output field");
        let beside = |rect: Rect| {
            rect.right() < setting.left() && rect.y_range().intersects(setting.y_range())
        };
        assert!(
            menus.into_iter().all(beside),
            "the output field beside the menus"
        );
        // The panels beside it, in this order.
        let panels = [
            number(&window, &fill(texts.position.coordinate, &[&"x"])).rect(),
            number(&window, &format!("{} (t1)", texts.curve.tension)).rect(),
            of(texts.orientation.relative),
            slider(texts.zoom.slider),
            number(&window, texts.timing.hold).rect(),
        ];
        for pair in panels.windows(2) {
            assert!(pair[0].bottom() < pair[1].top());
        }
        assert!(panels.iter().all(|panel| panel.left() > space.right()));
        // The sliders above, below and at the right.
        assert!(slider(texts.space.size).bottom() <= space.top());
        assert!(slider(texts.space.rotate).top() >= space.bottom());
        assert!(slider(texts.space.tilt).left() >= space.right());
    }
}

#[test]
fn the_three_sliders_change_size_rotation_and_tilt() {
    for language in BOTH {
        let texts = &language.texts().space;
        let mut window = window_of_1994(language);
        let slide = |window: &mut Window, name: &str, to: [f32; 2]| {
            let rect = window.get_by_role_and_label(Role::Slider, name).rect();
            let from = rect.center();
            let to = rect.lerp_inside(egui::Vec2::from(to));
            window.hover_at(from);
            window.run();
            window.drag_at(from);
            window.run();
            window.hover_at(to);
            window.run();
            window.drop_at(to);
            window.run();
            window.state().setup.view
        };
        let first = View::default();
        let larger = slide(&mut window, texts.size, [0.9, 0.5]);
        assert!(larger.size > 1.5 * first.size);
        assert_eq!((larger.rotation, larger.tilt), (first.rotation, first.tilt));
        let rotated = slide(&mut window, texts.rotate, [0.1, 0.5]);
        assert!(rotated.rotation < -90.0);
        assert_eq!((rotated.size, rotated.tilt), (larger.size, first.tilt));
        let tilted = slide(&mut window, texts.tilt, [0.5, 0.1]);
        assert!((tilted.tilt - first.tilt).abs() > 20.0);
        assert_eq!(
            (tilted.size, tilted.rotation),
            (rotated.size, rotated.rotation)
        );
        assert!(!window.state().document.is_modified());
    }
}

/// The speeds of the sections before and after are shown, and stay.
#[test]
fn neighbouring_speeds_cannot_be_dragged() {
    for language in BOTH {
        let texts = language.texts();
        let mut window = window_with_points(language, LARGE, 1.0, Theme::Dark);
        press(
            &mut window,
            Modifiers::CTRL | Modifiers::SHIFT,
            Key::PageDown,
        );
        press(&mut window, Modifiers::NONE, Key::F3);
        let square = |window: &Window, at: usize| {
            let name = fill(texts.speed_window.speed, &[&at]);
            let square = window.get_by_role_and_label(Role::Slider, &name);
            square.rect().center()
        };
        let step = square(&window, 2).x - square(&window, 1).x;
        let speed =
            |window: &Window, at: usize| window.state().orientation().expect("there").speeds[at];
        // A square's height tells its speed; the same scale for those beside.
        assert_eq!(speed(&window, 0), 50.0);
        for end in [1, 10] {
            let beside = if end == 1 { -step } else { step };
            let from = egui::pos2(square(&window, end).x + beside, square(&window, 1).y);
            let to = from - vec2(0.0, 40.0);
            // Not until it rests: a button held down on a window keeps it awake.
            window.hover_at(from);
            window.step();
            window.drag_at(from);
            window.step();
            window.hover_at(to);
            window.step();
            window.drop_at(to);
            window.run();
        }
        assert!(!window.state().document.is_modified());
        let squares = (1..=12).filter(|at| {
            let name = fill(texts.speed_window.speed, &[at]);
            window
                .query_by_role_and_label(Role::Slider, &name)
                .is_some()
        });
        assert_eq!(squares.count(), 10);
    }
}

/// Whoever reads the window aloud hears its language, at the cross as well.
#[test]
fn the_closing_cross_has_a_name_in_the_windows_language() {
    for language in BOTH {
        let texts = language.texts();
        let mut window = window(language);
        press(&mut window, Modifiers::NONE, Key::F2);
        click(&mut window, texts.menu.close_window);
        assert!(window.query_by_label(texts.curve.title).is_none());
    }
}

/// Whether the pointer is told this that rests on what has this label.
pub(crate) fn tip(window: &mut Window, label: &str, hint: &str) -> bool {
    let node = window.get_all_by_label(label).last().expect("a label");
    let at = node.rect().center();
    assert!(window.query_by_label(hint).is_none(), "{hint}");
    window.hover_at(at);
    for _ in 0..80 {
        window.step();
    }
    let shown = window.query_by_label(hint).is_some();
    window.hover_at(egui::pos2(1.0, 799.0));
    window.run();
    shown
}

#[test]
fn buttons_of_questions_and_files_and_menu_entries_tell_what_they_do() {
    for language in BOTH {
        let texts = language.texts();
        let mut window = window(language);
        press(&mut window, Modifiers::ALT, Key::L);
        let files = &texts.files;
        for (label, hint) in [
            (files.name, files.name_hint),
            (files.hidden, files.hidden_hint),
            (files.cancel, files.cancel_hint),
            (files.load, files.take_hint),
        ] {
            assert!(tip(&mut window, label, hint), "{label}");
        }
        press(&mut window, Modifiers::NONE, Key::Escape);
        click_button(&mut window, |texts| texts.position.add);
        window.state_mut().ask_to_close();
        window.run();
        let texts = &texts.questions;
        for (label, hint) in [
            (texts.save, texts.save_hint),
            (texts.discard, texts.discard_hint),
            (texts.cancel, texts.cancel_hint),
        ] {
            assert!(tip(&mut window, label, hint), "{label}");
        }
    }
}
