//! The panels (thesis A.4.1, A.4.4), sentence by sentence; those of views are beside theirs.

use egui_kittest::kittest::NodeT as _;
use vides_document::{At, Edit, Selection};
use vides_engine::path::{CurveParameters, SupportPoint, Target, Tcb};

use crate::tests::*;

pub(super) fn selection(window: &Window) -> Selection {
    window.state().document.selection()
}

fn points(window: &Window) -> usize {
    window.state().document.path().points.len()
}

pub(super) fn orientations(window: &Window) -> usize {
    let point = selection(window).point;
    window.state().document.path().points[point]
        .orientations
        .len()
}

pub(super) fn large(language: Language) -> Window {
    window_with_points(language, LARGE, 1.0, Theme::Dark)
}

#[test]
fn the_panels_name_all_that_the_thesis_has_there() {
    let window = large(Language::German);
    for name in [
        "+ Punkt",
        "− Punkt",
        "Position: 3 von 6",
        "Bias (b1)",
        "Continuity (c1)",
        "Tension (t1)",
        "Bias (b2)",
        "Continuity (c2)",
        "Tension (t2)",
        "Form der Kurve",
        "+ Blick",
        "− Blick",
        "Blick: 1 von 3 · blickt auf einen Ort",
        "Ziel",
        "Richtung",
        "Zoom",
    ] {
        assert!(window.query_by_label(name).is_some(), "{name}");
    }
    let window = large(Language::English);
    for name in ["Position: 3 of 6", "View: 1 of 3 · looks at a place"] {
        assert!(window.query_by_label(name).is_some(), "{name}");
    }
}

#[test]
fn a_point_is_inserted_half_way_and_the_flight_stays_as_it_is() {
    for (key, points) in [
        ((Modifiers::NONE, Key::Insert), 1),
        ((Modifiers::CTRL, Key::I), 7),
    ] {
        let mut window = window(Language::German);
        enter(&mut window, "Zoomwert", "35");
        window.state_mut().set_orientation(|orientation| {
            orientation.roll = 20.0;
            orientation.speeds[0] = 3.0;
        });
        window.run();
        let before = poses(window.state());
        press(&mut window, key.0, key.1);
        if points > 1 {
            press(&mut window, Modifiers::NONE, Key::Num7);
        }
        assert_eq!(
            (self::points(&window), selection(&window).point),
            (2 + points, 1)
        );
        let after = poses(window.state());
        assert_eq!(after.len(), before.len());
        for (frame, (a, b)) in before.iter().zip(&after).enumerate() {
            let moved = DVec3::from(a.vrp).distance(b.vrp.into());
            let turned = DVec3::from(a.vpn).angle_between(b.vpn.into());
            assert!(
                moved < 1e-9 && turned < 1e-6,
                "{points}, frame {frame}: {moved}, {turned}"
            );
            assert!((a.zoom - b.zoom).abs() < 1e-6);
        }
        // Within half of the fastest frame's way of where they would be.
        let path = window.state().document.path();
        let frame = before
            .windows(2)
            .map(|pair| DVec3::from(pair[0].vrp).distance(pair[1].vrp.into()));
        let fastest = frame.fold(0.0, f64::max);
        for (a, b) in path.points.iter().zip(path.points.range(1..)) {
            let way = b.position.distance(a.position);
            assert!((way - 1.2 / (points + 1) as f64).abs() < fastest, "{way}");
        }
        press(&mut window, Modifiers::CTRL, Key::Z);
        assert_eq!(self::points(&window), 2);
    }
}

#[test]
fn with_shift_a_new_point_has_all_of_its_predecessor() {
    let mut window = window(Language::German);
    enter(&mut window, "Zoomwert", "35");
    window
        .get_by_label("+ Punkt")
        .click_modifiers(Modifiers::SHIFT);
    window.run();
    assert_eq!((points(&window), selection(&window).point), (3, 1));
    let path = window.state().document.path();
    let middle = path.points[1].position;
    assert!((middle - DVec3::new(0.0, 0.2, 0.8)).length() < 1e-9);
    assert_eq!(path.points[1].orientations, path.points[0].orientations);
    assert_eq!(path.points[1].orientations[0].zoom, 35.0);
    assert_eq!(said(&window).as_deref(), Some("Neuer Punkt"));
}

/// A.4.1 and 7.3: half-way, with all properties of the current point but its name.
#[test]
fn in_a_window_of_a_host_of_1994_a_new_point_is_a_copy() {
    for language in BOTH {
        let texts = language.texts();
        let mut window = window_of(
            Options {
                fixed_speeds: true,
                ..options(language)
            },
            LARGE,
            1.0,
            Theme::Dark,
        );
        enter(&mut window, texts.zoom.value, "35");
        window.state_mut().set_orientation(|orientation| {
            orientation.target = Target::Absolute(DVec3::new(0.0, 0.5, 0.0));
            orientation.speeds[0] = 3.0;
        });
        window.run();
        let copied = |window: &Window, at: usize| {
            let path = window.state().document.path();
            let points = &path.points;
            assert_eq!(points[at].tangents, None);
            assert_eq!(points[at].orientations, points[0].orientations);
        };
        press(&mut window, Modifiers::NONE, Key::Insert);
        assert_eq!((points(&window), selection(&window).point), (3, 1));
        copied(&window, 1);
        press(&mut window, Modifiers::CTRL, Key::I);
        click(&mut window, "4");
        assert_eq!((points(&window), selection(&window).point), (7, 2));
        (2..6).for_each(|at| copied(&window, at));
        // Its button says so, and the menu has the other way by name.
        let [hint, _] = window.state().add_hints();
        assert_eq!(hint, texts.position.copy_hint);
        let before = poses(window.state());
        open_menu(&mut window, 1);
        click(&mut window, texts.menu.add_keeping);
        assert_eq!((points(&window), selection(&window).point), (8, 3));
        assert_eq!(poses(window.state()).len(), before.len());
        assert!(window.state().document.path().points[3].keeps_motion);
        press(&mut window, Modifiers::CTRL, Key::Z);
        window
            .get_by_label(texts.position.add)
            .click_modifiers(Modifiers::SHIFT);
        window.run();
        assert!(window.state().document.path().points[3].keeps_motion);
    }
}

/// The panel says that tangents came of an insertion, and they are over when a point beside moves.
#[test]
fn tangents_that_keep_the_motion_lapse_and_the_panel_says_so() {
    for language in BOTH {
        let texts = &language.texts().position;
        let mut window = window(language);
        let kept = |window: &Window| -> Vec<bool> {
            let path = window.state().document.path();
            let own = |point: &SupportPoint| (point.keeps_motion, point.tangents.is_some());
            path.points
                .iter()
                .map(|point| {
                    let (keeps, owns) = own(point);
                    assert_eq!(keeps, owns);
                    keeps
                })
                .collect()
        };
        let named = |window: &Window| window.query_by_label(texts.keeps_motion).is_some();
        // Not straight, where a new point needs no tangents.
        let position = DVec3::new(0.1, 0.9, -0.2);
        let document = &mut window.state_mut().document;
        document
            .apply(Edit::InsertPoint { at: 2, position })
            .unwrap();
        document.select(0, 0).unwrap();
        window.run();
        assert!(!named(&window));
        for _ in 0..3 {
            press(&mut window, Modifiers::NONE, Key::Insert);
        }
        assert!(named(&window));
        assert_eq!(kept(&window), [true; 6]);
        // The new point is moved: its tangents and those beside it are over.
        let name = fill(texts.coordinate, &[&"y"]);
        enter(&mut window, &name, "0.5");
        assert_eq!(kept(&window), [true, true, false, false, false, true]);
        assert!(!named(&window));
        press(&mut window, Modifiers::CTRL, Key::Z);
        assert_eq!(kept(&window), [true; 6]);
        // A click takes them away at once.
        click(&mut window, texts.keeps_motion);
        assert_eq!(kept(&window), [true, true, true, false, true, true]);
        press(&mut window, Modifiers::CTRL, Key::Z);
        // All points moved together keep the motion.
        press(&mut window, Modifiers::CTRL, Key::A);
        enter(&mut window, &name, "0.25");
        assert_eq!(kept(&window), [true; 6]);
    }
}

#[test]
fn several_points_are_asked_for_in_a_small_window() {
    for language in BOTH {
        let texts = &language.texts().position;
        let mut window = window(language);
        press(&mut window, Modifiers::CTRL, Key::I);
        assert!(window.query_by_label(texts.how_many).is_some());
        click(&mut window, "10");
        assert_eq!((points(&window), selection(&window).point), (12, 1));
        assert!(window.query_by_label(texts.how_many).is_none());
        let path = window.state().document.path();
        for (a, b) in path.points.iter().zip(path.points.range(1..)) {
            let way = b.position - a.position;
            // As near as whole frames come to it.
            assert!((way.length() - 1.2 / 11.0).abs() <= 0.01 + 1e-9);
        }
        press(&mut window, Modifiers::CTRL, Key::Z);
        assert_eq!(points(&window), 2);
        // By the keyboard alone: a digit.
        press(&mut window, Modifiers::CTRL, Key::I);
        press(&mut window, Modifiers::NONE, Key::Num3);
        assert_eq!(points(&window), 5);
        press(&mut window, Modifiers::CTRL, Key::I);
        press(&mut window, Modifiers::NONE, Key::Escape);
        assert_eq!(points(&window), 5);
        assert!(window.query_by_label(texts.how_many).is_none());
    }
}

#[test]
fn behind_the_last_point_there_is_a_message() {
    for language in BOTH {
        let texts = &language.texts().position;
        for key in [(Modifiers::NONE, Key::Insert), (Modifiers::CTRL, Key::I)] {
            let mut window = window(language);
            press(&mut window, Modifiers::CTRL, Key::PageDown);
            press(&mut window, key.0, key.1);
            assert_eq!(said(&window).as_deref(), Some(texts.last_point));
            assert!(
                window
                    .state()
                    .message
                    .as_ref()
                    .is_some_and(|message| message.error)
            );
            assert_eq!(points(&window), 2);
            // It stays until the next action.
            window.run();
            assert_eq!(said(&window).as_deref(), Some(texts.last_point));
            press(&mut window, Modifiers::CTRL, Key::PageUp);
            assert_eq!(said(&window), None);
        }
        // A closed path has a segment there.
        let mut window = window(language);
        press(&mut window, Modifiers::CTRL, Key::PageDown);
        click(&mut window, language.texts().menu.edit);
        click(&mut window, language.texts().menu.close);
        click(&mut window, texts.add);
        assert_eq!((points(&window), selection(&window).point), (3, 2));
    }
}

#[test]
fn the_predecessor_of_a_removed_point_becomes_current_and_two_remain() {
    for language in BOTH {
        let texts = &language.texts().position;
        let mut window = large(language);
        click(&mut window, texts.remove);
        assert_eq!(
            (points(&window), selection(&window)),
            (5, Selection::at(1, 0))
        );
        click(&mut window, texts.remove);
        click(&mut window, texts.remove);
        assert_eq!((points(&window), selection(&window).point), (3, 0));
        press(&mut window, Modifiers::NONE, Key::Delete);
        assert_eq!(points(&window), 2);
        click(&mut window, texts.remove);
        assert_eq!(points(&window), 2);
        assert_eq!(said(&window).as_deref(), Some(texts.two_remain));
        // Undo brings back what was current.
        for _ in 0..4 {
            press(&mut window, Modifiers::CTRL, Key::Z);
        }
        assert_eq!(
            (points(&window), selection(&window)),
            (6, Selection::at(2, 0))
        );
        assert!(!window.state().document.is_modified());
    }
}

#[test]
fn the_choice_of_a_point_goes_round() {
    let mut window = large(Language::German);
    let mut seen = Vec::new();
    for _ in 0..6 {
        press(&mut window, Modifiers::CTRL, Key::PageDown);
        seen.push(selection(&window).point);
    }
    assert_eq!(seen, [3, 4, 5, 0, 1, 2]);
    press(
        &mut window,
        Modifiers::CTRL | Modifiers::SHIFT,
        Key::PageDown,
    );
    press(&mut window, Modifiers::CTRL, Key::PageUp);
    // Another point begins with its first orientation.
    assert_eq!(selection(&window), Selection::at(1, 0));
    press(&mut window, Modifiers::CTRL, Key::PageUp);
    press(&mut window, Modifiers::CTRL, Key::PageUp);
    assert_eq!(selection(&window).point, 5);
    assert!(window.query_by_label("Position: 6 von 6").is_some());
}

#[test]
fn bias_continuity_and_tension_of_this_point_and_the_next_are_shown() {
    let mut window = large(Language::German);
    assert_eq!(value(&window, "Continuity (c1)"), "0,00");
    assert_eq!(value(&window, "Continuity (c2)"), "−0,50");
    press(&mut window, Modifiers::CTRL, Key::PageDown);
    assert_eq!(value(&window, "Continuity (c1)"), "−0,50");
    assert!(window.query_by_label("Kurve: 5 Ecke").is_some());
    press(&mut window, Modifiers::CTRL, Key::PageDown);
    press(&mut window, Modifiers::CTRL, Key::PageDown);
    // Behind the last point there is none.
    for name in ["Bias (b2)", "Continuity (c2)", "Tension (t2)"] {
        assert_eq!(value(&window, name), "–");
    }
    window.state_mut().edit(Edit::set(At::Path, "closed", true));
    window.run();
    assert_eq!(value(&window, "Bias (b2)"), "0,00");
}

#[test]
fn each_orientation_has_a_zoom_of_its_own() {
    for language in BOTH {
        let texts = &language.texts().zoom;
        let mut window = large(language);
        enter(&mut window, texts.value, "50");
        let heading = format!("{}: {}°", texts.heading, language.number(26.991_466, 1));
        assert!(window.query_by_label(&heading).is_some(), "{heading}");
        let path = window.state().document.path();
        let zooms: Vec<f64> = path.points[2].orientations.iter().map(|o| o.zoom).collect();
        assert_eq!(zooms, [50.0, 24.0, 24.0]);
        enter(&mut window, texts.value, "2001");
        let errors = &language.texts().errors;
        let message = fill(errors.out_of_range, &[&texts.value, &1, &2000]);
        assert_eq!(said(&window), Some(message));
        assert_eq!(window.state().orientation().expect("there").zoom, 50.0);
    }
}

#[test]
fn the_zoom_slider_is_dragged_in_one_step() {
    let mut window = window(Language::German);
    let rect = window.get_by_label("Zoom").rect();
    let y = rect.center().y;
    window.drag_at(egui::pos2(rect.left() + 60.0, y));
    window.run();
    for x in 61..140 {
        window.hover_at(egui::pos2(rect.left() + x as f32, y));
        window.run();
    }
    window.drop_at(egui::pos2(rect.left() + 140.0, y));
    window.run();
    let zoom = window.state().orientation().expect("there").zoom;
    assert!((70.0..90.0).contains(&zoom), "{zoom}");
    press(&mut window, Modifiers::CTRL, Key::Z);
    assert_eq!(window.state().orientation().expect("there").zoom, 24.0);
    assert!(!window.state().document.can_undo());
}

#[test]
fn the_section_is_shown_with_its_frames_and_seconds() {
    let mut window = window(Language::German);
    assert!(
        window
            .query_by_label("Zeiten: 120 Bilder · 4,80 s")
            .is_some()
    );
    press(&mut window, Modifiers::CTRL, Key::PageDown);
    assert!(window.query_by_label("Zeiten: Ende der Bahn").is_some());
    open_menu(&mut window, 1);
    click(&mut window, "Zeitkurve …");
    assert!(window.state().windows.speed.is_some());
    click(&mut window, "Form der Kurve");
    click(&mut window, "Ändern … F2");
    assert!(window.state().windows.curve.is_some());
}

#[test]
fn holding_takes_whole_frames() {
    let mut window = window(Language::English);
    enter(&mut window, "Hold", "12");
    assert_eq!(window.state().orientation().expect("there").hold, 12);
    enter(&mut window, "Hold", "2.5");
    assert_eq!(
        said(&window).as_deref(),
        Some("Hold must be a whole number")
    );
    enter(&mut window, "Hold", "-1");
    assert_eq!(window.state().orientation().expect("there").hold, 12);
}

#[test]
fn a_preset_is_chosen_in_the_panel() {
    for language in BOTH {
        let texts = &language.texts().position;
        let mut window = large(language);
        let curve = |window: &Window| window.state().point().expect("there").curve;
        let before = curve(&window);
        click(&mut window, texts.choice);
        let word = language.texts().curve.corner_outwards;
        let value = language.number(0.5, 2);
        let entry = format!("{} {word}  c {value}", fill(texts.preset, &[&6]));
        click(&mut window, &entry);
        assert_eq!(curve(&window), CurveParameters::Preset(6));
        let heading = format!("{}: 6 {word}", texts.curve);
        assert!(window.query_by_label(&heading).is_some());
        assert!(window.query_by_label(&entry).is_none());
        press(&mut window, Modifiers::CTRL, Key::Z);
        assert_eq!(curve(&window), before);
        // By the keyboard, too.
        window.get_by_label(texts.choice).focus();
        window.run();
        press(&mut window, Modifiers::NONE, Key::Enter);
        press(&mut window, Modifiers::NONE, Key::ArrowDown);
        press(&mut window, Modifiers::NONE, Key::ArrowDown);
        press(&mut window, Modifiers::NONE, Key::Enter);
        assert_eq!(curve(&window), CurveParameters::Preset(1));
    }
}

/// Beside each preset stands what it makes of the curve, as it is at the moment.
#[test]
fn a_presets_shape_is_told_in_words() {
    for (language, words) in [
        (
            Language::German,
            [
                "straffer  t 0,30",
                "Ecke  c −0,50",
                "biegt später  b 0,50",
                "glatt",
            ],
        ),
        (
            Language::English,
            [
                "tighter  t 0.30",
                "corner  c −0.50",
                "turns late  b 0.50",
                "smooth",
            ],
        ),
    ] {
        let mut window = large(language);
        let texts = language.texts();
        let mut presets = window.state().document.path().presets;
        presets[2] = Tcb::new(-0.25, 0.0, -1.0);
        let edit = Edit::set(At::Path, "presets", presets);
        window.state_mut().edit(edit);
        click(&mut window, texts.position.choice);
        for (preset, words) in [1, 5, 7, 9].into_iter().zip(words) {
            let entry = format!("{} {words}", fill(texts.position.preset, &[&preset]));
            assert!(window.query_by_label(&entry).is_some(), "{entry}");
        }
        let changed = match language {
            Language::German => "Standard 2 runder  t −0,25, biegt früher  b −1,00",
            Language::English => "Preset 2 rounder  t −0.25, turns early  b −1.00",
        };
        assert!(window.query_by_label(changed).is_some(), "{changed}");
    }
}

/// A click or Enter on a heading folds its panel and no other; the next window has it so, too.
#[test]
fn panels_are_folded_and_stay_so() {
    for language in BOTH {
        let texts = language.texts();
        let folder = tempfile::tempdir().unwrap();
        let start = || {
            let folders = Folders {
                setup: Some(folder.path().to_owned()),
                ..Folders::default()
            };
            let options = Options {
                folders,
                ..options(language)
            };
            window_of(options, LARGE, 1.0, Theme::Dark)
        };
        let tension = format!("{} (t1)", texts.curve.tension);
        let position = fill(texts.position.coordinate, &[&"x"]);
        let direction = fill(texts.orientation.direction, &[&"x"]);
        let inside = [
            position.as_str(),
            &tension,
            &direction,
            texts.zoom.value,
            texts.timing.hold,
        ];
        let headings = [
            texts.position.heading,
            texts.position.curve,
            texts.orientation.heading,
            texts.zoom.heading,
            texts.timing.heading,
        ];
        let open = |window: &Window| {
            inside.map(|name| {
                let mut all = window.query_all_by_role_and_label(Role::SpinButton, name);
                all.next().is_some()
            })
        };
        let heading = |window: &mut Window, at: usize, by_key: bool| {
            let label = format!("{}: ", headings[at]);
            let mut all = window.query_all_by_role(Role::DisclosureTriangle);
            let begins = |node: &egui_kittest::Node<'_>| {
                let name = node.accesskit_node().label();
                name.is_some_and(|name| name.starts_with(&label))
            };
            let node = all.find(begins).expect("a heading");
            match by_key {
                true => node.focus(),
                false => node.click(),
            }
            drop(all);
            window.run();
            if by_key {
                press(window, Modifiers::NONE, Key::Enter);
            }
        };
        let mut window = start();
        assert_eq!(open(&window), [true; 5]);
        let mut wanted = [true; 5];
        for at in [1, 4, 0, 3, 2] {
            heading(&mut window, at, at % 2 == 0);
            wanted[at] = false;
            assert_eq!(open(&window), wanted, "{at}");
            assert_eq!(open(&start()), wanted, "{at}");
        }
        heading(&mut window, 2, false);
        wanted[2] = true;
        assert_eq!(open(&window), wanted);
        assert_eq!(open(&start()), wanted);
        // It is no step, and the headings still tell what they told.
        assert!(!window.state().document.can_undo());
        let zoom = format!("{}: ", texts.zoom.heading);
        assert!(window.query_by_label_contains(&zoom).is_some());
    }
}
