use egui_kittest::kittest::NodeT;
use glam::DVec3;
use vides_document::tool::{Needs, tools};
use vides_document::{At, Edit, Object, ObjectPoint};
use vides_engine::path::fit_frames::frames_between;
use vides_engine::path::{CameraPath, Plan, Timeline};

use crate::screenshots::screenshot;
use crate::state::files::Purpose;
use crate::tests::*;

/// A path of points, with nothing done to it.
fn fresh(language: Language) -> Window {
    window_with_points(language, LARGE, 1.0, Theme::Dark)
}

/// The window of a tool that was picked in the menu.
fn picked(language: Language, name: &'static str) -> Window {
    let mut window = fresh(language);
    pick(&mut window, name);
    window
}

fn pick(window: &mut Window, name: &'static str) {
    let language = window.state().language();
    open_menu(window, 3);
    let tool = tools().find(|tool| tool.name == name).expect("a tool");
    let more = if tool.has_numbers() || tool.needs() != Needs::Nothing {
        " …"
    } else {
        ""
    };
    click(window, &format!("{}{more}", language.tool(name)));
}

fn path(window: &Window) -> CameraPath {
    window.state().document.path().clone()
}

fn undo_name(window: &Window) -> Option<&'static str> {
    match window.state().document.step_names()[0] {
        Some(vides_document::StepName::Tool(tool)) => Some(tool),
        _ => None,
    }
}

/// The sentence below the fields, if the numbers will not do.
fn refused(window: &Window) -> bool {
    let ok = window.state().texts().tools.ok;
    let ok = window.get_all_by_label(ok).last().expect("a button");
    ok.accesskit_node().is_disabled()
}

#[test]
fn by_keys_alone_a_move_is_shown_and_kept_as_one_step_with_its_name() {
    for language in BOTH {
        let mut window = fresh(language);
        let before = path(&window);
        let state = window.state().document.state_number();
        open_menu(&mut window, 3);
        press(&mut window, Modifiers::NONE, Key::Enter);
        // Twelve points a turn, and the last one is where the first is; the film before them stays.
        assert_eq!(path(&window).points.len(), 6 + 13);
        assert_ne!(path(&window), before);
        press(&mut window, Modifiers::NONE, Key::Escape);
        assert_eq!(path(&window), before);
        assert_eq!(window.state().document.state_number(), state);
        assert!(!window.state().document.is_modified());
        assert_eq!(undo_name(&window), None);
        assert!(window.state().windows.tool.is_none());
        open_menu(&mut window, 3);
        press(&mut window, Modifiers::NONE, Key::Enter);
        press(&mut window, Modifiers::NONE, Key::Enter);
        assert!(window.state().windows.tool.is_none());
        assert_eq!(undo_name(&window), Some("orbit"));
        open_menu(&mut window, 1);
        let [undo, redo] = match language {
            Language::English => ["Undo orbit", "Redo orbit"],
            Language::German => ["Umkreisen rückgängig", "Umkreisen wiederholen"],
        };
        window.get_by_role_and_label(Role::MenuItem, undo).click();
        window.run();
        assert_eq!(path(&window), before);
        open_menu(&mut window, 1);
        assert!(window.query_by_label(redo).is_some());
    }
}

/// When the points are reached, in frames.
fn reached(path: &CameraPath) -> Vec<usize> {
    let times = |timeline: &Timeline| {
        let points = 0..path.points.len();
        points
            .map(|at| frames_between(path, timeline, 0, at))
            .collect()
    };
    Plan::new().timeline(path, times).unwrap()
}

fn places(path: &CameraPath) -> Vec<DVec3> {
    path.points.iter().map(|point| point.position).collect()
}

/// A move comes after the end of the film; two more choices put it after the current point and in
/// place of the film. In a new document it is all there is.
#[test]
fn a_move_leaves_the_film_as_it_is_unless_it_is_to_replace_it() {
    let moves = || tools().filter(|tool| tool.is_move());
    assert!(moves().count() > 8);
    for language in BOTH {
        for tool in moves() {
            let mut window = window(language);
            pick(&mut window, tool.name);
            let made = places(&path(&window));
            let mut window = fresh(language);
            window.state_mut().document.select(2, 0).unwrap();
            window.run();
            let film = path(&window);
            let old = places(&film);
            pick(&mut window, tool.name);
            assert_eq!(
                places(&path(&window)),
                [&old[..], &made].concat(),
                "{}",
                tool.name
            );
            assert_eq!(
                reached(&path(&window))[..6],
                reached(&film),
                "{}",
                tool.name
            );
            click(&mut window, language.choice("insert"));
            let inserted = [&old[..3], &made, &old[3..]].concat();
            assert_eq!(places(&path(&window)), inserted, "{}", tool.name);
            click(&mut window, language.choice("replace"));
            assert_eq!(places(&path(&window)), made, "{}", tool.name);
            assert!(window.query_by_label(language.choice("none")).is_none());
            click(&mut window, language.choice("append"));
            // Placed where the film ends, it begins with the last point.
            click(&mut window, language.choice("move"));
            assert_eq!(path(&window).points.len(), 5 + made.len());
            click(&mut window, language.choice("none"));
            click_button(&mut window, |texts| texts.tools.ok);
            assert_eq!(places(&path(&window)), [&old[..], &made].concat());
            press(&mut window, Modifiers::CTRL, Key::Z);
            assert_eq!(path(&window), film, "{}", tool.name);
            assert!(!window.state().document.is_modified());
        }
    }
}

#[test]
fn numbers_change_the_path_at_once_and_bad_ones_change_nothing() {
    for language in BOTH {
        let mut window = picked(language, "orbit");
        let radius = |window: &Window| {
            let points = path(window).points;
            let [x, _, z] = points[points.len() - 1].position.to_array();
            x.hypot(z)
        };
        let label = language.parameter("radius");
        enter(&mut window, label, "0.5");
        assert!((radius(&window) - 0.5).abs() < 1e-12);
        assert!(!refused(&window));
        let shown = window.state().windows.tool.is_some();
        assert!(shown);
        enter(&mut window, label, "-2");
        assert!(refused(&window));
        let sentence = match language {
            Language::English => "Radius must lie between 0.000001 and 1000000000",
            Language::German => "Radius muss zwischen 0,000001 und 1000000000 liegen",
        };
        assert!(window.query_by_label(sentence).is_some());
        assert_eq!(path(&window), some_points().path().clone());
        assert!(!window.state().document.is_modified());
        enter(&mut window, label, "0.25");
        assert!((radius(&window) - 0.25).abs() < 1e-12);
        assert!(window.query_by_label(sentence).is_none());
        // What the engine refuses is its own sentence.
        enter(&mut window, language.parameter("turns"), "0");
        assert!(refused(&window));
        assert_eq!(path(&window), some_points().path().clone());
    }
}

#[test]
fn a_number_that_is_dragged_shows_each_path_and_escape_brings_it_back() {
    let mut window = picked(Language::English, "orbit");
    let at = number(&window, "Radius").rect().center();
    let before = path(&window);
    window.hover_at(at);
    window.run();
    window.drag_at(at);
    window.run();
    // The first motion only begins the drag.
    window.hover_at(at + vec2(4.0, 0.0));
    window.run();
    let mut last = before.clone();
    for step in 1..4_u8 {
        window.hover_at(at + vec2(10.0 * f32::from(step), 0.0));
        window.run();
        assert_ne!(path(&window), last);
        last = path(&window);
    }
    press(&mut window, Modifiers::NONE, Key::Escape);
    assert_eq!(path(&window), before);
    window.drop_at(at);
    window.run();
    assert!(window.state().windows.tool.is_some());
    click(&mut window, "Cancel");
    assert_eq!(path(&window), some_points().path().clone());
    assert_eq!(undo_name(&window), None);
}

#[test]
fn another_edit_first_takes_what_the_tool_shows() {
    let mut window = picked(Language::English, "reverse");
    let reversed = path(&window);
    assert_ne!(reversed, some_points().path().clone());
    press(&mut window, Modifiers::NONE, Key::Insert);
    assert!(window.state().windows.tool.is_none());
    assert_eq!(path(&window).points.len(), 7);
    press(&mut window, Modifiers::CTRL, Key::Z);
    assert_eq!(path(&window), reversed);
    assert_eq!(undo_name(&window), Some("reverse"));
    press(&mut window, Modifiers::CTRL, Key::Z);
    assert_eq!(path(&window), some_points().path().clone());
    // Undo, another tool and another document take it back.
    pick(&mut window, "reverse");
    press(&mut window, Modifiers::CTRL, Key::Z);
    assert!(window.state().windows.tool.is_none());
    assert_eq!(path(&window), some_points().path().clone());
    pick(&mut window, "orbit");
    pick(&mut window, "repeat");
    assert_eq!(path(&window).points.len(), 11);
    click_button(&mut window, |texts| texts.tools.ok);
    press(&mut window, Modifiers::CTRL, Key::Z);
    assert_eq!(path(&window), some_points().path().clone());
    assert_eq!(undo_name(&window), None);
}

#[test]
fn looking_round_and_choosing_a_point_leave_a_tool_alone() {
    let mut window = picked(Language::English, "mirror");
    let mirrored = path(&window);
    press(&mut window, Modifiers::CTRL, Key::PageDown);
    press(&mut window, Modifiers::NONE, Key::F4);
    let name = Language::English.texts().space.name;
    let middle = window.get_by_label(name).rect().left_bottom() + vec2(90.0, -90.0);
    window.hover_at(middle);
    window.run();
    window.drag_at(middle);
    window.run();
    window.hover_at(middle + vec2(40.0, 10.0));
    window.run();
    press(&mut window, Modifiers::NONE, Key::Escape);
    window.drop_at(middle);
    window.run();
    assert!(window.state().windows.tool.is_some());
    assert_eq!(path(&window), mirrored);
    // The host gets the path without the tool, which ends.
    let outside = window.state_mut().document_mut().path().clone();
    assert_eq!(outside, some_points().path().clone());
    assert_eq!(undo_name(&window), None);
    assert!(!window.state().document.in_step());
}

#[test]
fn the_playhead_stands_where_it_stood() {
    let mut window = fresh(Language::English);
    window.state_mut().scrub(40.0);
    window.run();
    let selection = window.state().document.selection();
    pick(&mut window, "frames");
    enter(&mut window, "Frames", "12");
    assert_eq!(poses(window.state()).len(), 12);
    press(&mut window, Modifiers::NONE, Key::Escape);
    assert_eq!(window.state().playing.frame(), Some(40.0));
    assert_eq!(window.state().document.selection(), selection);
}

#[test]
fn a_block_is_written_and_put_in_by_files() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("block.vid");
    for language in BOTH {
        let mut window = picked(language, "extract");
        let texts = &language.texts().tools;
        enter(&mut window, language.parameter("first"), "9");
        assert!(window.query_by_label(texts.result).is_none());
        let write = window
            .get_all_by_label(texts.write)
            .last()
            .expect("a button");
        assert!(write.accesskit_node().is_disabled());
        enter(&mut window, language.parameter("first"), "2");
        enter(&mut window, language.parameter("last"), "4");
        click(&mut window, texts.write);
        window.state_mut().file_chosen(Purpose::SaveBlock, &file);
        window.run();
        let told = fill(texts.block_written, &[&2, &4, &"block.vid"]);
        assert_eq!(said(&window), Some(told));
        assert_eq!(path(&window), some_points().path().clone());
        assert_eq!(undo_name(&window), None);
        let block = Document::load(&file).expect("a path");
        assert_eq!(block.path().points.len(), 3);
        assert_eq!(
            block.path().points[0].position,
            path(&window).points[1].position
        );

        // Nothing is left of a file that is not chosen.
        pick(&mut window, "insert");
        press(&mut window, Modifiers::NONE, Key::Escape);
        assert!(window.state().windows.tool.is_none());
        pick(&mut window, "insert");
        window.state_mut().file_chosen(Purpose::LoadBlock, &file);
        window.run();
        // Its first point is the current one.
        assert_eq!(path(&window).points.len(), 8);
        click(&mut window, language.choice("none"));
        assert_eq!(path(&window).points.len(), 9);
        click_button(&mut window, |texts| texts.tools.ok);
        assert_eq!(undo_name(&window), Some("insert"));
    }
}

#[test]
fn blocks_lie_in_a_library_and_are_seen_before_they_are_chosen() {
    let folder = tempfile::tempdir().expect("a folder");
    let library = folder.path().join("vides").join("blocks");
    for language in BOTH {
        let options = Options {
            document: some_points(),
            folders: Folders {
                blocks: Some(library.clone()),
                ..Folders::default()
            },
            ..options(language)
        };
        let mut window = window_of(options, LARGE, 1.0, Theme::Dark);
        let texts = &language.texts();
        pick(&mut window, "extract");
        click(&mut window, texts.tools.write);
        // The file window stands in the library, which is made for the first block.
        assert!(library.is_dir());
        let name = format!("{}.vid", texts.files.block);
        click(&mut window, texts.files.save);
        assert!(library.join(&name).is_file());
        pick(&mut window, "insert");
        let picture = texts.recovery.picture;
        assert!(window.query_by_label(picture).is_none());
        click(&mut window, &name);
        assert!(window.query_by_label(picture).is_some());
        screenshot(&mut window, "files-block.png");
        click(&mut window, texts.files.load);
        assert!(window.state().windows.tool.is_some());
        click_button(&mut window, |texts| texts.tools.ok);
        assert_eq!(undo_name(&window), Some("insert"));
        // Another file is chosen where paths are.
        let elsewhere = window.state().folder_for(Purpose::LoadPath);
        assert_ne!(elsewhere, library);
    }
}

#[test]
fn a_path_is_blended_with_one_from_a_file() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("other.vid");
    let mut other = some_points();
    let moved = DVec3::new(0.1, -0.05, 0.02);
    for at in 0..other.path().points.len() {
        let position = other.path().points[at].position + moved;
        other
            .apply(Edit::set(At::Point(at), "position", position))
            .expect("moved");
    }
    other.save(&file).expect("written");
    for language in BOTH {
        let mut window = fresh(language);
        let before = path(&window);
        pick(&mut window, "blend");
        window.state_mut().file_chosen(Purpose::LoadBlock, &file);
        window.run();
        for (weight, share) in [(None, 0.5), (Some("0"), 0.0), (Some("1"), 1.0)] {
            if let Some(weight) = weight {
                enter(&mut window, language.parameter("weight"), weight);
            }
            for (new, old) in path(&window).points.iter().zip(&before.points) {
                assert!(new.position.distance(old.position + share * moved) < 1e-12);
            }
        }
        click_button(&mut window, |texts| texts.tools.ok);
        assert_eq!(undo_name(&window), Some("blend"));
    }
}

#[test]
fn recorded_poses_become_a_path() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("poses.csv");
    let mut window = fresh(Language::German);
    window.state_mut().export(&file, None).expect("written");
    let recorded = poses(window.state());
    pick(&mut window, "fit");
    window.state_mut().file_chosen(Purpose::Import, &file);
    window.run();
    click(&mut window, Language::German.texts().questions.y_up);
    click(&mut window, Language::German.choice("replace"));
    let fitted = poses(window.state());
    assert_eq!(fitted.len(), recorded.len());
    for (a, b) in fitted.iter().zip(&recorded) {
        let [a, b] = [a, b].map(|pose| DVec3::from_array(pose.vrp));
        assert!((a - b).length() <= 0.01);
    }
    click_button(&mut window, |texts| texts.tools.ok);
    assert_eq!(undo_name(&window), Some("fit"));
    std::fs::write(&file, "1 2 3").expect("written");
    pick(&mut window, "fit");
    window.state_mut().file_chosen(Purpose::Import, &file);
    window.run();
    let told = said(&window).expect("a sentence");
    assert!(told.contains("10 Zahlen erwartet"), "{told}");
}

/// Round an object that is larger than the space of the path whose place the tour takes.
#[test]
fn a_check_finds_nothing_in_a_tour() {
    let corner = |k: usize| [0, 1, 2].map(|bit| if k >> bit & 1 == 1 { 2.0 } else { -1.0 });
    let sides = [
        [0, 1, 3, 2],
        [4, 6, 7, 5],
        [0, 4, 5, 1],
        [2, 3, 7, 6],
        [0, 2, 6, 4],
        [1, 5, 7, 3],
    ];
    let mesh = vides_engine::scene::Mesh {
        points: (0..8).map(|k| DVec3::from_array(corner(k))).collect(),
        triangles: sides
            .iter()
            .flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]])
            .collect(),
        ..Default::default()
    };
    for language in BOTH {
        let mut window = fresh(language);
        let mut info = window.state().document.info().clone();
        info.object = Object::features_of(mesh.clone()).unwrap();
        window.state_mut().edit(Edit::SetInfo(Box::new(info)));
        pick(&mut window, "tour");
        click(&mut window, language.choice("replace"));
        click_button(&mut window, |texts| texts.tools.ok);
        assert_eq!(undo_name(&window), Some("tour"));
        assert_eq!(window.state().document.check(None).unwrap(), []);
    }
}

/// Each of them in each look, with all its controls within the window.
#[test]
fn every_tool_fits_into_the_window() {
    for (language, theme, size) in [
        (Language::German, Theme::Dark, SMALL),
        (Language::English, Theme::Light, LARGE),
    ] {
        let mut window = window_with_points(language, size, 1.0, theme);
        open_menu(&mut window, 3);
        let name = if language == Language::German {
            "de"
        } else {
            "en"
        };
        screenshot(&mut window, &format!("tools-menu-{name}.png"));
        press(&mut window, Modifiers::NONE, Key::Escape);
        let whole = egui::Rect::from_min_size(egui::Pos2::ZERO, size.into());
        for tool in tools().filter(|tool| matches!(tool.needs(), Needs::Nothing | Needs::Output)) {
            if tool.makes_flight() {
                let object = Object::from(vec![ObjectPoint {
                    position: DVec3::ZERO,
                    draw: false,
                }]);
                window.state_mut().set_object(object).unwrap();
            }
            pick(&mut window, tool.name);
            let texts = &language.texts().tools;
            screenshot(&mut window, &format!("tool-{}-{name}.png", tool.name));
            for label in [texts.cancel, language.tool_hint(&tool)] {
                let rect = window.get_all_by_label(label).last().expect("shown").rect();
                assert!(whole.contains_rect(rect), "{} {label}", tool.name);
            }
            // No row is wider than name and fields: nothing stands over anything.
            let [hint, cancel] = [language.tool_hint(&tool), texts.cancel]
                .map(|label| window.get_all_by_label(label).last().expect("shown").rect());
            assert!(cancel.right() - hint.left() < 320.0, "{}", tool.name);
            press(&mut window, Modifiers::NONE, Key::Escape);
            assert!(window.state().windows.tool.is_none());
            assert_eq!(path(&window), some_points().path().clone(), "{}", tool.name);
        }
    }
}

#[test]
fn points_and_frames_of_a_block_are_those_that_are_written() {
    for language in BOTH {
        let mut window = picked(language, "extract");
        let tool = tools().find(|tool| tool.name == "extract").expect("a tool");
        for [first, last] in [[2, 4], [1, 6], [5, 6]] {
            enter(&mut window, language.parameter("first"), &first.to_string());
            enter(&mut window, language.parameter("last"), &last.to_string());
            let numbers = [first, last].map(f64::from);
            let block = tool
                .extracted(&window.state().document, &numbers)
                .expect("a block");
            let frames = block.sampler().expect("poses").frame_count();
            let text = language.texts().tools.result;
            let told = fill(text, &[&(last - first + 1), &frames]);
            assert!(window.query_by_label(&told).is_some(), "{told}");
            screenshot(&mut window, &format!("tool-extract-{first}-{last}.png"));
            // So that the first is never behind the last.
            enter(&mut window, language.parameter("first"), "1");
        }
    }
}
