use egui_kittest::kittest::NodeT;
use vides_document::{At, Selection};

use crate::screenshots::screenshot;
use crate::tests::*;

/// A path that turns too fast and leaves the space.
fn wild() -> Document {
    let mut document = some_points();
    let position = DVec3::new(0.6, 0.3, -1.2);
    document
        .apply(Edit::set(At::Point(3), "position", position))
        .unwrap();
    let few = Edit::FitFrames {
        first: 0,
        last: 5,
        frames: 60,
    };
    document.apply(few).unwrap();
    document
}

fn checked(language: Language, size: [f32; 2], theme: Theme) -> Window {
    let options = crate::Options {
        document: wild(),
        ..options(language)
    };
    let mut window = window_of(options, size, 1.0, theme);
    open_menu(&mut window, 3);
    click(&mut window, language.texts().check.menu);
    window
}

/// What the button of the first finding with this word says.
fn button(window: &Window, word: &str) -> String {
    let mut all = window.query_all_by_role(Role::Button);
    let labels = all.find_map(|node| {
        let label = node.accesskit_node().label()?;
        label.contains(word).then_some(label)
    });
    labels.expect("a finding")
}

#[test]
fn a_click_on_a_finding_leads_to_its_frame_and_key() {
    for language in BOTH {
        let mut window = checked(language, LARGE, Theme::Dark);
        let found = window.state().document.check(None).unwrap();
        let texts = &language.texts().check;
        let count = fill(texts.many, &[&found.len()]);
        assert!(window.query_by_label(&count).is_some(), "{count}");
        let word = match language {
            Language::English => "outside the space",
            Language::German => "außerhalb des Raums",
        };
        let label = button(&window, word);
        // It may have to be scrolled to.
        window.get_by_label(&label).click_accesskit();
        window.run();
        let finding = found
            .iter()
            .find(|finding| finding.kind.name() == "space")
            .unwrap();
        let editor = window.state();
        assert_eq!(editor.playing.frame(), Some(finding.first_frame));
        let selection = Selection::at(finding.point, finding.orientation);
        assert_eq!(editor.document.selection(), selection);
    }
}

#[test]
fn it_follows_each_change_but_not_while_something_is_dragged() {
    let mut window = checked(Language::English, LARGE, Theme::Dark);
    let shown = |window: &Window| {
        let found = window.state().windows.check.as_ref().expect("open");
        found
            .found
            .iter()
            .filter(|finding| finding.kind.name() == "space")
            .count()
    };
    assert!(shown(&window) > 0);
    let position = DVec3::new(0.6, 0.3, -0.9);
    window
        .state_mut()
        .edit(Edit::set(At::Point(3), "position", position));
    window.run();
    let of = |window: &Window| window.state().document.check(None).unwrap();
    assert_eq!(
        window.state().windows.check.as_ref().unwrap().found,
        of(&window)
    );
    let before = of(&window);
    // While something is dragged nothing is checked; the button is down where nothing is.
    let nowhere = egui::pos2(700.0, 12.0);
    window.hover_at(nowhere);
    window.run();
    window.drag_at(nowhere);
    window.run();
    let moved = Edit::set(At::Point(3), "position", position + DVec3::X);
    window.state_mut().document.begin_step();
    window.state_mut().edit(moved);
    window.run();
    assert_ne!(of(&window), before);
    assert_eq!(window.state().windows.check.as_ref().unwrap().found, before);
    window.state_mut().document.end_step();
    window.drop_at(nowhere);
    window.run();
    assert_eq!(
        window.state().windows.check.as_ref().unwrap().found,
        of(&window)
    );
}

#[test]
fn what_helps_is_one_step() {
    for language in BOTH {
        let mut window = checked(language, LARGE, Theme::Light);
        let before = window.state().document.path().clone();
        let mend = language.texts().check.mend;
        let first = window.get_all_by_label(mend).next().expect("a button");
        first.click();
        window.run();
        assert_ne!(*window.state().document.path(), before);
        let step = window.state().document.step_names()[0];
        assert_eq!(step, Some(vides_document::StepName::Mend));
        press(&mut window, Modifiers::CTRL, Key::Z);
        assert_eq!(*window.state().document.path(), before);
    }
}

/// A fix says what it did; playhead and selected point stay.
#[test]
fn a_fix_says_what_it_did_and_stays_there() {
    for language in BOTH {
        let mut kinds = Vec::new();
        let window = checked(language, LARGE, Theme::Dark);
        let check = window.state().windows.check.as_ref().unwrap();
        for (finding, edits) in check.found.iter().zip(check.mends.clone()) {
            let known = kinds.contains(&finding.kind);
            let Some(edits) = edits.filter(|edits| !known && !edits.is_empty()) else {
                continue;
            };
            kinds.push(finding.kind);
            let mut window = checked(language, LARGE, Theme::Dark);
            window.state_mut().document.select(4, 0).unwrap();
            window.state_mut().scrub(45.0);
            window.run();
            let stand = |window: &Window| {
                let editor = window.state();
                (editor.playing.frame(), editor.document.selection())
            };
            let before = stand(&window);
            window.state_mut().mend(finding, edits);
            window.run();
            let number = window.state().document.number_of_frame(finding.first_frame);
            let told = [finding.point as f64 + 1.0, number.round()];
            let told = fill(language.mended(finding.kind), &[&told[0], &told[1]]);
            assert_eq!(said_besides_length(&window), Some(told));
            assert_eq!(stand(&window), before, "{finding:?}");
        }
        assert!(kinds.len() > 1, "{kinds:?}");
    }
}

/// What goes through the object, or near it, stands first.
#[test]
fn collisions_stand_first() {
    use vides_engine::tools::check::FindingKind;
    let mut document = wild();
    let mut info = document.info().clone();
    let corner = |x: f64, y: f64| DVec3::new(x, y, 0.0);
    let wall = vides_engine::scene::Mesh {
        points: vec![
            corner(-1.0, -1.0),
            corner(1.0, -1.0),
            corner(1.0, 1.0),
            corner(-1.0, 1.0),
        ],
        triangles: vec![[0, 1, 2], [0, 2, 3]],
        ..Default::default()
    };
    info.object = vides_document::Object::of_mesh(wall).unwrap();
    document.apply(Edit::SetInfo(Box::new(info))).unwrap();
    let first = document.check(None).unwrap()[0].kind;
    let options = crate::Options {
        document,
        ..options(Language::English)
    };
    let mut window = window_of(options, LARGE, 1.0, Theme::Dark);
    press(&mut window, Modifiers::NONE, Key::F8);
    screenshot(&mut window, "check-collisions.png");
    let kinds: Vec<_> = window
        .state()
        .windows
        .check
        .as_ref()
        .unwrap()
        .found
        .iter()
        .map(|finding| finding.kind)
        .collect();
    let collides =
        |kind: &FindingKind| matches!(kind, FindingKind::Through | FindingKind::Clearance);
    assert!(
        !collides(&first) && kinds[0] == FindingKind::Through,
        "{kinds:?}"
    );
    let count = kinds.iter().filter(|kind| collides(kind)).count();
    assert!(kinds[..count].iter().all(collides), "{kinds:?}");
    // The key that opens it closes it.
    press(&mut window, Modifiers::NONE, Key::F8);
    assert!(window.state().windows.check.is_none());
}

/// Switched off, set and switched on again, each a step that is found again in the path.
#[test]
fn limits_are_steps_that_can_be_undone() {
    use vides_engine::tools::check::{FindingKind, OFF};
    for language in BOTH {
        let mut window = checked(language, LARGE, Theme::Dark);
        let limit = |window: &Window, kind| window.state().document.info().limits.get(kind);
        let count = |window: &Window| window.state().windows.check.as_ref().unwrap().found.len();
        let before = count(&window);
        click(&mut window, language.texts().check.limits);
        let [name, _] = language.limit(FindingKind::Space);
        let tick = |window: &mut Window| {
            window.get_by_role_and_label(Role::CheckBox, name).click();
            window.run();
        };
        tick(&mut window);
        assert_eq!(limit(&window, FindingKind::Space), OFF);
        assert!(count(&window) < before);
        press(&mut window, Modifiers::CTRL, Key::Z);
        assert_eq!(
            (limit(&window, FindingKind::Space), count(&window)),
            (0.0, before)
        );
        screenshot(&mut window, &format!("check-limits-{language:?}.png"));
    }
}

#[test]
fn a_camera_in_a_room_is_noted() {
    let corner = |k: usize| [0, 1, 2].map(|bit| if k >> bit & 1 == 1 { 9.0 } else { -9.0 });
    let sides = [
        [0, 1, 3],
        [0, 3, 2],
        [4, 5, 7],
        [4, 7, 6],
        [0, 1, 5],
        [0, 5, 4],
        [2, 3, 7],
        [2, 7, 6],
        [0, 2, 6],
        [0, 6, 4],
        [1, 3, 7],
        [1, 7, 5],
    ];
    let room = vides_engine::scene::Mesh {
        points: (0..8).map(|k| DVec3::from_array(corner(k))).collect(),
        triangles: sides.to_vec(),
        ..Default::default()
    };
    for language in BOTH {
        let mut window = checked(language, LARGE, Theme::Dark);
        let mut info = window.state().document.info().clone();
        info.object = vides_document::Object::of_mesh(room.clone()).unwrap();
        window.state_mut().edit(Edit::SetInfo(Box::new(info)));
        window.run();
        assert!(
            window
                .query_by_label(language.texts().check.inside)
                .is_some()
        );
    }
}

#[test]
fn a_long_film_is_checked_when_asked() {
    let mut window = checked(Language::English, LARGE, Theme::Dark);
    let long = Edit::FitFrames {
        first: 0,
        last: 5,
        frames: 30_000,
    };
    window.state_mut().edit(long);
    window.run();
    assert!(
        window
            .query_by_label("The path has changed since")
            .is_some()
    );
    click(&mut window, "Check now");
    assert!(window.query_by_label("Check now").is_none());
    let found = &window.state().windows.check.as_ref().unwrap().found;
    assert_eq!(*found, window.state().document.check(None).unwrap());
}

#[test]
fn it_fits_into_the_window() {
    for (language, theme, size, name) in [
        (Language::German, Theme::Dark, SMALL, "de-small"),
        (Language::English, Theme::Light, LARGE, "en-light"),
    ] {
        let mut window = checked(language, size, theme);
        screenshot(&mut window, &format!("check-{name}.png"));
        let whole = egui::Rect::from_min_size(egui::Pos2::ZERO, size.into());
        let count = window.state().windows.check.as_ref().unwrap().found.len();
        let label = fill(language.texts().check.many, &[&count]);
        assert!(whole.contains_rect(window.get_by_label(&label).rect()));
    }
}

/// What is open above it is closed first; after a fix it is told how many there were before.
#[test]
fn escape_closes_a_menu_before_the_check() {
    for language in BOTH {
        let mut window = checked(language, LARGE, Theme::Dark);
        let before = window.state().windows.check.as_ref().unwrap().found.len();
        click(&mut window, language.texts().menu.edit);
        press(&mut window, Modifiers::NONE, Key::Escape);
        assert!(window.state().windows.check.is_some());
        let mend = language.texts().check.mend;
        let first = window.get_all_by_label(mend).next().expect("a button");
        first.click();
        window.run();
        let told = fill(language.texts().check.before, &[&before]);
        assert!(window.query_by_label(&told).is_some());
        screenshot(&mut window, &format!("check-fixed-{language:?}.png"));
        press(&mut window, Modifiers::NONE, Key::Escape);
        assert!(window.state().windows.check.is_none());
    }
}
