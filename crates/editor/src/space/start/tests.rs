use super::*;
use crate::screenshots::screenshot;
use crate::tests::*;
use vides_engine::path::CameraPath;

fn begins(window: &Window) -> usize {
    let editor = window.state();
    let space = window.get_by_label(editor.texts().space.name).rect();
    offered(editor, space).places().count()
}

/// One click, and Enter keeps it; with undo the beginning is there again.
#[test]
fn an_empty_document_offers_beginnings_until_something_is_done() {
    for language in BOTH {
        let texts = language.texts();
        let mut window = window(language);
        let all = begins(&window);
        let tools = TOOLS
            .iter()
            .filter(|name| tool::tools().any(|tool| tool.name == **name));
        assert_eq!(all, tools.count() + 1);
        screenshot(&mut window, &format!("begin-{language:?}.png"));
        let before = window.state().document.path().clone();
        let orbit = fill(texts.space.begin_with, &[&language.tool("orbit")]);
        click(&mut window, &orbit);
        assert!(window.state().windows.tool.is_some());
        assert_eq!(begins(&window), 0);
        press(&mut window, egui::Modifiers::NONE, Key::Enter);
        assert!(window.state().windows.tool.is_none());
        assert_ne!(*window.state().document.path(), before);
        assert_eq!(begins(&window), 0);
    }
    // Where there is a path there is nothing to begin.
    let window = window_with_points(Language::English, LARGE, 1.0, Theme::Dark);
    assert_eq!(begins(&window), 0);
}

/// A window of our own, in which nothing has been done.
fn first(language: Language, size: [f32; 2], theme: Theme) -> Window {
    let mut options = options(language);
    options.program.offers_all = true;
    window_of(options, size, 1.0, theme)
}

/// Nothing that the user has not made is shown, and no key changes what is not seen.
#[test]
fn the_first_screen_shows_ways_to_begin_and_no_path() {
    for language in BOTH {
        for (size, theme) in [
            (LARGE, Theme::Dark),
            (LARGE, Theme::Light),
            (SMALL, Theme::Dark),
            (SMALL, Theme::Light),
            ([640.0, 440.0], Theme::Light),
        ] {
            let texts = language.texts();
            let mut window = first(language, size, theme);
            let space = window.get_by_label(texts.space.name).rect();
            assert_eq!([space.width(), space.bottom()], size);
            let all: Vec<Rect> = offered(window.state(), space).places().collect();
            assert_eq!(all.len(), FILES.len() + TOOLS.len());
            for (at, place) in all.iter().enumerate() {
                assert!(space.contains_rect(*place), "{size:?}: {place:?}");
                let apart = |other: &Rect| !other.intersects(*place);
                assert!(all[at + 1..].iter().all(apart), "{size:?}");
            }
            for name in [texts.position.heading, texts.timing.heading] {
                assert!(window.query_by_label(name).is_none(), "{name}");
            }
            window.get_by_label(texts.space.drop_here);
            screenshot(
                &mut window,
                &format!("first-{language:?}-{theme:?}-{}.png", size[0]),
            );
            for key in [Key::Insert, Key::Delete, Key::F3, Key::F7, Key::ArrowLeft] {
                press(&mut window, egui::Modifiers::NONE, key);
            }
            let editor = window.state();
            assert!(editor.is_first_screen() && !editor.document.can_undo());
        }
    }
}

/// The first click sets the first point, the second one the path, which undo takes back.
#[test]
fn a_path_begins_with_the_first_point_that_is_set() {
    let mut window = first(Language::English, LARGE, Theme::Dark);
    let viewport = window
        .get_by_label(Language::English.texts().space.name)
        .rect();
    let places = [egui::pos2(400.0, 520.0), egui::pos2(800.0, 520.0)];
    let expected = places.map(|at| {
        let projection = super::super::surface::projection_of(window.state(), viewport);
        projection.point_facing(DVec3::ZERO, super::super::projection::from_pos(at))
    });
    let set = |window: &mut Window, at: egui::Pos2| {
        window.hover_at(at);
        window.run();
        for pressed in [true, false] {
            window.event(egui::Event::PointerButton {
                pos: at,
                button: egui::PointerButton::Primary,
                pressed,
                modifiers: egui::Modifiers::NONE,
            });
            window.run();
        }
    };
    let before = window.state().document.path().clone();
    // Escape begins again.
    set(&mut window, egui::pos2(240.0, 500.0));
    press(&mut window, egui::Modifiers::NONE, Key::Escape);
    set(&mut window, places[0]);
    window.hover_at(places[1]);
    window.run();
    screenshot(&mut window, "first-point.png");
    assert!(window.state().is_first_screen());
    assert_eq!(*window.state().document.path(), before);
    set(&mut window, places[1]);
    let path = window.state().document.path();
    for (point, expected) in path.points.iter().zip(expected) {
        assert!(
            point.position.abs_diff_eq(expected, 1e-9),
            "{}",
            point.position
        );
        assert!(point.orientations[0].own.ahead.is_some());
    }
    assert!(!window.state().is_first_screen());
    screenshot(&mut window, "first-path.png");
    press(&mut window, egui::Modifiers::CTRL, Key::Z);
    assert_eq!(*window.state().document.path(), before);
    assert!(window.state().is_first_screen());
}

/// The example has no file that could be overwritten.
#[test]
fn the_example_is_one_click_away() {
    let mut window = first(Language::English, LARGE, Theme::Light);
    let texts = &Language::English.texts().space;
    click(
        &mut window,
        &fill(texts.begin_with, &[&texts.begin_example]),
    );
    let editor = window.state();
    assert!(editor.document.path().points.len() > 2 && editor.file.is_none());
    assert!(!editor.is_unsaved() && !editor.is_first_screen());
}

/// The files that were open last are offered too, and one click opens one of them.
#[test]
fn recent_files_are_offered() {
    for language in BOTH {
        let folder = tempfile::tempdir().unwrap();
        let start = |size| {
            let folders = crate::Folders {
                state: Some(folder.path().to_owned()),
                ..crate::Folders::default()
            };
            let options = Options {
                folders,
                ..options(language)
            };
            window_of(options, size, 1.0, Theme::Light)
        };
        let tools = begins(&start(LARGE));
        let path = some_points();
        let names = [
            "first.vid",
            "a rather long name of a flight past a house.vid",
        ];
        for name in names {
            let file = folder.path().join(name);
            path.save(&file).unwrap();
            start(LARGE).state_mut().note_file(&file);
        }
        for size in [LARGE, SMALL, [700.0, 450.0]] {
            let mut window = start(size);
            let space = window.get_by_label(language.texts().space.name).rect();
            let all: Vec<Rect> = offered(window.state(), space).places().collect();
            assert!(size != LARGE || all.len() == tools + 2);
            for (at, place) in all.iter().enumerate() {
                assert!(space.contains_rect(*place), "{size:?}: {place:?}");
                let apart = |other: &Rect| !other.intersects(*place);
                assert!(all[at + 1..].iter().all(apart), "{size:?}");
            }
            screenshot(&mut window, &format!("recent-{language:?}-{}.png", size[0]));
        }
        let mut window = start(LARGE);
        let first = fill(language.texts().space.begin_with, &[&names[0]]);
        click(&mut window, &first);
        let editor = window.state();
        assert_eq!(editor.file, Some(folder.path().join(names[0])));
        assert_eq!(editor.document.path(), path.path());
        assert_eq!(begins(&window), 0);
    }
}

/// They lie within the space, apart from one another, whatever its size.
#[test]
fn beginnings_have_room_or_are_left_out() {
    for size in [
        [640.0, 440.0],
        [700.0, 450.0],
        [800.0, 600.0],
        [1200.0, 800.0],
        [3840.0, 2160.0],
    ] {
        for language in BOTH {
            let mut window = window_of(options(language), size, 1.0, Theme::Light);
            let space = window.get_by_label(language.texts().space.name).rect();
            let all: Vec<Rect> = offered(window.state(), space).places().collect();
            assert!(!all.is_empty(), "{size:?}");
            for (at, place) in all.iter().enumerate() {
                assert!(space.contains_rect(*place), "{size:?}: {place:?}");
                let apart = |other: &Rect| !other.intersects(*place);
                assert!(all[at + 1..].iter().all(apart), "{size:?}");
            }
            screenshot(&mut window, &format!("begin-{language:?}-{}.png", size[0]));
        }
    }
}

#[test]
fn points_outside_are_told_at_the_space_and_a_click_mends_it() {
    for language in BOTH {
        let texts = &language.texts().space;
        let mut window = window_with_points(language, LARGE, 1.0, Theme::Dark);
        assert_eq!(outside(window.state()), 0);
        let far = DVec3::new(3.0, 0.2, 0.1);
        let edits = [0, 1].map(|at| Edit::set(At::Point(at), "position", far * (1.0 + at as f64)));
        for edit in edits {
            assert!(window.state_mut().document.apply(edit).is_ok());
        }
        window.run();
        let path = window.state().document.path().clone();
        let count = poses(window.state()).len();
        let text = fill(texts.some_outside, &[&2]);
        screenshot(&mut window, &format!("outside-{language:?}.png"));
        click(&mut window, &text);
        assert_eq!(outside(window.state()), 0);
        assert!(window.query_by_label(&text).is_none());
        // The space alone has changed, in one step, and no time.
        let places = |path: &CameraPath| {
            let places = path.points.iter().map(|point| point.position);
            places.collect::<Vec<_>>()
        };
        assert_eq!(places(window.state().document.path()), places(&path));
        assert_eq!(poses(window.state()).len(), count);
        press(&mut window, egui::Modifiers::CTRL, Key::Z);
        assert_eq!(*window.state().document.path(), path);
    }
}

/// With an object each tool shows on it what it would make by itself, and a camera flies along it
/// under the pointer, unless the desktop asks for stillness.
#[test]
fn beginnings_are_drawn_on_the_object() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("roof.obj");
    let corners = "v -4 0 -4\nv 4 0 -4\nv 4 0 4\nv -4 0 4\nv 0 5 0\n";
    let faces = "f 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n";
    std::fs::write(&file, [corners, faces].concat()).unwrap();
    for (size, large) in [
        (LARGE, true),
        (SMALL, true),
        ([700.0, 450.0], false),
        ([3840.0, 2160.0], true),
    ] {
        let mut window = window_of(options(Language::English), size, 1.0, Theme::Dark);
        let object = vides_document::load_object(&file).unwrap();
        let around = vides_document::Document::around(object).unwrap();
        window.state_mut().document = around;
        window.run();
        let around = Around::of(window.state()).unwrap();
        let all = sign::pictures(around, &mut |_, _| true);
        for (name, made) in TOOLS.iter().zip(&all) {
            let made = made.as_ref().expect(name);
            assert_eq!(made.has_path(), *name != "draw", "{name}");
        }
        let space = window
            .get_by_label(window.state().texts().space.name)
            .rect();
        let (_, place) = offered(window.state(), space).begins[0];
        assert!((place.height() > BUTTON.y) == large && space.contains_rect(place));
        screenshot(&mut window, &format!("begin-object-{}.png", size[0]));
        // Under the pointer it moves, and nothing moves where the desktop asks for that.
        for still in [false, true] {
            window.state_mut().keep_still(still);
            window.hover_at(place.center());
            window.step();
            window.step();
            let seen = [0, 1].map(|_| {
                window.step();
                window.render().unwrap()
            });
            assert_eq!(seen[0] == seen[1], still, "{size:?}");
        }
    }
}

/// A flight around an object that is larger than its space has the room that it needs, in one step.
#[test]
fn what_is_begun_lies_in_its_space() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("plate.obj");
    std::fs::write(&file, "v 0 0 0\nv 9 0 0\nv 0 0 9\nf 1 2 3\n").unwrap();
    let object = vides_document::load_object(&file).unwrap();
    let mut window = window(Language::English);
    window.state_mut().document = vides_document::Document::around(object).unwrap();
    window.state_mut().recent = vec![file.clone(), folder.path().join("other.vid")];
    window.run();
    let texts = Language::English.texts();
    // The file that is open is not offered again.
    for (name, there) in [("plate.obj", false), ("other.vid", true)] {
        let offer = fill(texts.space.begin_with, &[&name]);
        assert_eq!(window.query_by_label(&offer).is_some(), there, "{name}");
    }
    let before = window.state().document.path().clone();
    let orbit = Language::English.tool("orbit");
    click(&mut window, &fill(texts.space.begin_with, &[&orbit]));
    press(&mut window, egui::Modifiers::NONE, Key::Enter);
    let document = &window.state().document;
    assert!(document.points_outside() == 0 && document.path().points.len() > 2);
    assert_ne!(document.path().space, before.space);
    assert!(said(&window).is_some_and(|said| said.starts_with(orbit)));
    press(&mut window, egui::Modifiers::CTRL, Key::Z);
    assert_eq!(*window.state().document.path(), before);
}
