//! Tests of [`super::zoom`]: long lenses, and those of other sensors.

use crate::files::folders::Folders;
use crate::setup::Setup;
use crate::setup::file::load;
use crate::state::{Editor, Options};
use crate::tests::*;

fn zoom(window: &Window) -> f64 {
    window.state().orientation().expect("there").zoom
}

#[test]
fn a_long_lens_is_typed_and_the_slider_leaves_it() {
    let mut window = window(Language::English);
    for (text, typed) in [
        ("135", 135.0),
        ("2000", 2000.0),
        ("0.5", 2000.0),
        ("2000.5", 2000.0),
    ] {
        enter(&mut window, "Zoom value", text);
        assert_eq!(zoom(&window), typed);
    }
    enter(&mut window, "Zoom value", "135");
    // The slider stands at its end, hovered and focused too.
    let steps = window.state().document.state_number();
    let rect = window.get_by_label("Zoom").rect();
    window.hover_at(rect.right_center());
    window.run();
    window.get_by_label("Zoom").focus();
    window.run();
    assert_eq!(
        (zoom(&window), window.state().document.state_number()),
        (135.0, steps)
    );
    assert_eq!(value(&window, "Zoom value"), "135.0");
    // Dragged, it reaches 100 and no more.
    window.drag_at(rect.center());
    window.run();
    window.hover_at(rect.right_center() + egui::vec2(400.0, 0.0));
    window.run();
    window.drop_at(rect.right_center() + egui::vec2(400.0, 0.0));
    window.run();
    assert_eq!(zoom(&window), 100.0);
}

/// 35 mm before 18.66 mm see what 35·24/18.66 mm see before 24 mm, 2·atan(18.66/70).
#[test]
fn another_sensor_has_another_lens_for_the_same_view() {
    for language in BOTH {
        let texts = &language.texts().zoom;
        let folder = tempfile::tempdir().expect("a folder");
        let folders = Folders {
            setup: Some(folder.path().to_owned()),
            ..Folders::default()
        };
        let options = Options {
            folders: folders.clone(),
            ..options(language)
        };
        let mut window = window_of_editor(Editor::new(options).unwrap(), LARGE, 1.0);
        window.run();
        window
            .get_by_role_and_label(Role::ComboBox, texts.sensor)
            .click();
        window.run();
        enter(&mut window, texts.sensor, "18.66");
        assert_eq!(zoom(&window), 24.0);
        enter(&mut window, texts.lens, "35");
        assert!((zoom(&window) - 35.0 * 24.0 / 18.66).abs() < 1e-12);
        let angle = 2.0 * (18.66_f64 / 70.0).atan().to_degrees();
        let (angle, lens) = (language.number(angle, 1), language.number(35.0, 1));
        let heading = format!("{}: {angle}° · {lens} mm", texts.heading);
        assert!(window.query_by_label(&heading).is_some(), "{heading}");
        // At once, for the next start, too.
        let kept = load(&folders.setup_file().expect("a file")).expect("a setup");
        assert_eq!(
            kept,
            Setup {
                sensor_height: 18.66,
                ..Setup::default()
            }
        );
    }
}
