//! The menu bar and the output field (thesis A.2, A.5).

use egui_kittest::kittest::by;
use vides_document::At;

use crate::action::Action;
use crate::state::selected::SelectionChange;
use crate::tests::*;

#[test]
fn the_output_field_shows_position_and_orientation() {
    let window = window(Language::German);
    let words = "Punkt 1 · Position −0,600 0,200 0,800 · Blick 0,000 0,000 −1,000 · Rollen 0,0° · Zoom 24,0";
    assert!(window.query_by_label(words).is_some());
    let window = crate::tests::window(Language::English);
    let words =
        "Point 1 · Position −0.600 0.200 0.800 · View 0.000 0.000 −1.000 · Roll 0.0° · Zoom 24.0";
    assert!(window.query_by_label(words).is_some());
}

#[test]
fn the_output_field_follows_at_once() {
    let mut window = window(Language::English);
    enter(&mut window, "Roll", "12.5");
    press(&mut window, Modifiers::CTRL, Key::PageDown);
    press(&mut window, Modifiers::CTRL, Key::PageUp);
    let words =
        "Point 1 · Position −0.600 0.200 0.800 · View 0.000 0.000 −1.000 · Roll 12.5° · Zoom 24.0";
    assert!(window.query_by_label(words).is_some());
}

#[test]
fn all_cameras_are_aimed_at_one_target_in_one_step() {
    for language in BOTH {
        let texts = language.texts();
        let mut window = window_with_points(language, LARGE, 1.0, Theme::Dark);
        let before = window.state().document.path().clone();
        // The third point looks to the summit from one place, and elsewhere.
        let place = DVec3::new(0.1, 0.5, -0.1);
        window.state_mut().edit(Edit::SetAbsolute {
            point: 2,
            at: 0,
            absolute: false,
        });
        window.state_mut().set_orientation(|current| {
            current.target = Target::Relative(place - before.points[2].position);
            current.zoom = 35.0;
        });
        window.run();
        press(&mut window, Modifiers::NONE, Key::F7);
        let told = said_besides_length(&window);
        let views: usize = before.points.iter().map(|at| at.orientations.len()).sum();
        let aimed = fill(texts.orientation.all_aimed, &[&views]);
        assert_eq!(told, Some(aimed));
        // The button beside it takes it back, and nothing else.
        let steps = window.state().document.path().clone();
        click(&mut window, texts.menu.undo);
        assert_ne!(*window.state().document.path(), steps);
        press(&mut window, Modifiers::CTRL, Key::Y);
        assert_eq!(*window.state().document.path(), steps);
        for (point, was) in window
            .state()
            .document
            .path()
            .points
            .iter()
            .zip(&before.points)
        {
            assert_eq!(point.orientations.len(), was.orientations.len());
            for (orientation, was) in point.orientations.iter().zip(&was.orientations) {
                let Target::Absolute(found) = orientation.target else {
                    panic!("{:?}", orientation.target);
                };
                assert!((found - place).length() < 1e-15, "{found}");
                assert_eq!(orientation.speeds, was.speeds);
            }
        }
        assert_eq!(window.state().orientation().expect("there").zoom, 35.0);
        // Of a point that lies there nothing is changed.
        press(&mut window, Modifiers::CTRL, Key::Z);
        let aimed = |window: &Window| {
            let path = window.state().document.path();
            let all = path.points.iter().flat_map(|point| &point.orientations);
            all.filter(|one| one.target == Target::Absolute(before.points[4].position))
                .count()
        };
        window.state_mut().set_orientation(|current| {
            current.target = Target::Absolute(before.points[4].position);
        });
        window.run();
        press(&mut window, Modifiers::NONE, Key::F7);
        assert_eq!(
            said(&window).as_deref(),
            Some(texts.orientation.on_position)
        );
        assert_eq!(aimed(&window), 1);
    }
}

#[test]
fn handing_over_is_grey_where_nobody_takes_it() {
    for language in BOTH {
        let texts = &language.texts().menu;
        let options = Options {
            host_takes_poses: false,
            ..options(language)
        };
        let mut window = window_of(options, LARGE, 1.0, Theme::Dark);
        open_menu(&mut window, 2);
        click(&mut window, texts.hand_over);
        assert_eq!(window.state_mut().next_request(), None);
        press(&mut window, Modifiers::NONE, Key::Escape);
        press(&mut window, Modifiers::ALT, Key::U);
        assert_eq!(window.state_mut().next_request(), None);
        assert_eq!(said(&window).as_deref(), Some(texts.nobody_takes));
    }
}

/// Rests the pointer on an entry; what the tooltip says then is there to be read.
fn has_tooltip(window: &mut Window, entry: &str, hint: &str) {
    assert!(window.query_by_label(hint).is_none(), "{entry}: {hint}");
    let at = window.get_by_label(entry).rect().center();
    window.hover_at(at);
    for _ in 0..4 {
        window.step();
    }
    assert!(window.query_by_label(hint).is_some(), "{entry}: {hint}");
}

#[test]
fn every_entry_has_a_tooltip() {
    for language in BOTH {
        let texts = language.texts();
        let (menu, hints, position) = (&texts.menu, &texts.menu_hints, &texts.position);
        let mut window = window(language);
        for (title, entries) in [
            (
                menu.file,
                vec![
                    (menu.new, hints.new),
                    (menu.load, hints.load),
                    (menu.load_object, hints.load_object),
                    (menu.save, hints.save),
                    (menu.save_as, hints.save_as),
                    (menu.import, hints.import),
                    (menu.export, hints.export),
                    (menu.quit, hints.quit),
                ],
            ),
            (
                menu.edit,
                vec![
                    // Those that are not possible say why.
                    (menu.undo, texts.output.nothing_to_undo),
                    (menu.redo, texts.output.nothing_to_redo),
                    (menu.add_point, position.add_hint),
                    (menu.add_copy, position.only_copy_hint),
                    (menu.add_points, position.add_many_hint),
                    (menu.remove_point, position.two_remain),
                    (menu.append, hints.append),
                    (menu.prepend, hints.prepend),
                    (menu.close, hints.close),
                    (texts.space.all_points, hints.select_all),
                    (menu.add_orientation, texts.orientation.add_hint),
                    (menu.remove_orientation, texts.orientation.one_remains),
                    (menu.copy_orientation, hints.copy_orientation),
                    (menu.cut, texts.output.nothing_to_cut),
                    (menu.paste, hints.paste),
                    (menu.paste_orientation, texts.output.nothing_copied),
                    (menu.aim_all, hints.aim_all),
                    (menu.speeds, hints.speeds),
                    (menu.space, hints.space),
                    (menu.add_object, hints.add_object),
                    (menu.add_light, hints.add_light),
                    (menu.add_camera, hints.add_camera),
                    (menu.add_group, hints.add_group),
                ],
            ),
            (
                menu.output,
                vec![
                    (menu.export, hints.export),
                    (menu.hand_over, hints.hand_over),
                    (menu.hands_over, hints.hands_over),
                ],
            ),
            (
                menu.settings,
                vec![
                    (menu.colours, hints.colours),
                    (menu.display, hints.display),
                    (texts.space.sliders, texts.space.sliders_tip),
                    (texts.space.wireframe, texts.space.wireframe_tip),
                    (menu.as_system, hints.as_system),
                    (menu.dark, hints.dark),
                    (menu.light, hints.light),
                    (texts.display.automatic, texts.display.language_hint),
                    (texts.display.german, texts.display.german_hint),
                    (texts.display.english, texts.display.english_hint),
                    (menu.load_setup, hints.load_setup),
                    (menu.save_setup, hints.save_setup),
                ],
            ),
            (menu.help, vec![(menu.keys, hints.keys)]),
        ] {
            click(&mut window, title);
            let shown = window
                .query_all(by().predicate(|node| {
                    let role = node.role();
                    matches!(role, Role::MenuItem | Role::MenuItemCheckBox)
                }))
                .count();
            assert_eq!(shown, entries.len(), "{title}");
            for (entry, hint) in entries {
                has_tooltip(&mut window, entry, hint);
            }
            press(&mut window, Modifiers::NONE, Key::Escape);
        }
    }
}

#[test]
fn a_hand_over_is_told() {
    use vides_document::error::EngineError;
    for language in BOTH {
        let texts = language.texts();
        let mut window = window(language);
        window.state_mut().handed_over(Ok(121), true);
        window.run();
        assert_eq!(said(&window), Some(fill(texts.output.handed_over, &[&121])));
        window
            .state_mut()
            .handed_over(Err(EngineError::Memory.into()), true);
        window.run();
        assert_eq!(
            said(&window),
            Some(fill(texts.errors.cannot_hand_over, &[&texts.errors.memory]))
        );
    }
}

#[test]
fn light_and_dark_are_chosen_in_the_settings() {
    let mut window = window(Language::German);
    open_menu(&mut window, 4);
    click(&mut window, "Hell");
    assert!(!window.ctx.global_style().visuals.dark_mode);
    open_menu(&mut window, 4);
    click(&mut window, "Dunkel");
    assert!(window.ctx.global_style().visuals.dark_mode);
}

#[test]
fn the_ends_of_the_path_are_led_on() {
    for language in BOTH {
        let texts = language.texts();
        let mut window = window(language);
        let count = |window: &Window| window.state().document.path().points.len();
        let pick = |window: &mut Window, entry: &str| {
            click(window, texts.menu.edit);
            click(window, entry);
        };
        pick(&mut window, texts.menu.append);
        assert_eq!(count(&window), 3);
        assert_eq!(window.state().document.selection().point, 2);
        pick(&mut window, texts.menu.append);
        assert_eq!(said(&window).as_deref(), Some(texts.position.no_room));
        pick(&mut window, texts.menu.prepend);
        assert_eq!(
            (count(&window), window.state().document.selection().point),
            (4, 0)
        );
        pick(&mut window, texts.menu.close);
        assert!(window.state().document.path().closed);
        window.state_mut().edit(Edit::AppendAfterLast);
        window.run();
        assert_eq!(
            said(&window).as_deref(),
            Some(texts.position.closed_has_no_ends)
        );
        pick(&mut window, texts.menu.close);
        assert!(!window.state().document.path().closed);
    }
}

#[test]
fn the_title_begins_with_the_name_and_marks_unsaved_work() {
    let mut editor = Editor::new(options(Language::German)).expect("an editor");
    assert_eq!(editor.window_title(), "VIDES");
    editor.edit(Edit::set(At::Path, "closed", true));
    assert_eq!(editor.window_title(), "VIDES*");
    editor.file = Some("/tmp/a b.vid".into());
    assert_eq!(editor.window_title(), "VIDES – *a b.vid");
    editor.title = Some("Flug".into());
    assert_eq!(editor.window_title(), "VIDES – *Flug");
}

/// What is new is as in a window without a file, after a question about what is not saved.
#[test]
fn a_new_path_is_begun() {
    let mut window = window_with_points(Language::English, LARGE, 1.0, Theme::Dark);
    window.state_mut().file = Some("/tmp/a.vid".into());
    press(&mut window, Modifiers::CTRL, Key::N);
    let editor = window.state();
    assert_eq!(editor.document.path(), Document::new().path());
    assert!(editor.file.is_none() && !editor.is_unsaved());
    window.state_mut().edit(Edit::AppendAfterLast);
    window.run();
    press(&mut window, Modifiers::CTRL, Key::N);
    click(&mut window, Language::English.texts().questions.discard);
    assert_eq!(window.state().document.path(), Document::new().path());
}

/// Menu and tooltip name what would be taken back, whatever the edit was.
#[test]
fn undo_and_redo_say_what() {
    use crate::state::with;
    use vides_document::{Info, Selection};
    use vides_engine::path::Tcb;
    for (language, undo, redo) in [
        (Language::English, "Undo {}", "Redo {}"),
        (Language::German, "{} rückgängig", "{} wiederholen"),
    ] {
        let steps = &language.texts().steps;
        let mut window = window_with_points(language, LARGE, 1.0, Theme::Dark);
        let key = window.state().document.path().points[1].orientations[0].clone();
        let at = Selection::at(1, 0);
        let info = Info {
            fps: 30.0,
            ..window.state().document.info().clone()
        };
        let edits = [
            (Edit::AppendAfterLast, steps.insert_point),
            (Edit::RemovePoint { at: 0 }, steps.remove_point),
            (
                Edit::set(At::Point(0), "position", DVec3::new(0.1, 0.2, 0.3)),
                steps.set_position,
            ),
            (with(at, &key, |key| key.zoom = 55.0), steps.zoom),
            (with(at, &key, |key| key.hold = 5), steps.hold),
            (with(at, &key, |key| key.speeds[3] = 7.0), steps.pace),
            (with(at, &key, |key| key.roll = 7.0), steps.roll),
            (
                with(at, &key, |key| (key.roll, key.zoom) = (3.0, 3.0)),
                steps.orientation,
            ),
            (
                Edit::set(At::Point(0), "own", Tcb::new(0.5, 0.0, 0.0)),
                steps.curve,
            ),
            (Edit::set(At::Path, "closed", true), steps.closed),
            (Edit::SetInfo(Box::new(info)), steps.fps),
            (Edit::Reverse, steps.reverse),
        ];
        for (edit, name) in edits {
            window.state_mut().document.apply(edit).unwrap();
            window.run();
            for (pattern, next) in [(undo, Key::Z), (redo, Key::Y)] {
                let wanted = pattern.replace("{}", name);
                open_menu(&mut window, 1);
                assert!(window.query_by_label(&wanted).is_some(), "{wanted}");
                press(&mut window, Modifiers::NONE, Key::Escape);
                press(&mut window, Modifiers::CTRL, next);
            }
            press(&mut window, Modifiers::CTRL, Key::Z);
        }
    }
}

/// Where no path is edited, all that needs one is grey.
#[test]
fn without_a_path_what_needs_one_is_grey() {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/car.vid");
    let (document, _) = vides_document::Document::load_scene(file.as_ref()).unwrap();
    assert!(!document.edits_path());
    let options = crate::Options {
        document,
        ..options(Language::English)
    };
    let window = window_of(options, LARGE, 1.0, Theme::Dark);
    let editor = window.state();
    let texts = editor.texts();
    let mut seen = 0;
    for menu in super::menus(editor) {
        if ![texts.menu.edit, texts.tools.menu].contains(&menu.title) {
            continue;
        }
        for entry in menu.entries {
            // There is nothing to undo or redo yet, either, and no node is selected. Nodes can be
            // added to any scene, pasted and selected.
            let of_nodes = matches!(
                entry.action,
                Action::Nodes(_) | Action::Choose(SelectionChange::All) | Action::Paste
            );
            assert_eq!(entry.enabled, of_nodes, "{}", entry.text);
            seen += 1;
        }
    }
    assert!(seen > 30, "{seen}");
}
