//! The list of points as a user works in it.

use egui::{Event, Key, Modifiers, PointerButton, Pos2, Vec2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT, Queryable, by};
use glam::DVec3;
use vides_engine::path::{CameraPath, SupportPoint};

use super::*;
use crate::screenshots::screenshot;
use crate::setup::Theme;
use crate::space::tests::{editor, motion, press, pyramid, release, tap, window};
use crate::texts::Language;

type Window<'a> = Harness<'a, Editor>;

const LEFT: PointerButton = PointerButton::Primary;

fn of_size<'a>(document: Document, language: Language, size: Vec2) -> Window<'a> {
    window(editor(document, language), size, 1.0)
}

fn pyramid_list<'a>() -> Window<'a> {
    of_size(pyramid(), Language::English, vec2(1200.0, 800.0))
}

/// The rows as they are read, from top to bottom.
fn rows(harness: &Window<'_>) -> Vec<String> {
    let rows = harness.query_all(by().role(Role::ListItem));
    let mut rows: Vec<(f32, String)> = rows
        .map(|row| (row.rect().top(), row.accesskit_node().label().unwrap()))
        .collect();
    rows.sort_by(|a, b| a.0.total_cmp(&b.0));
    rows.into_iter().map(|(_, label)| label).collect()
}

fn row(harness: &Window<'_>, label: &str) -> Pos2 {
    harness
        .get_by_role_and_label(Role::ListItem, label)
        .rect()
        .center()
}

fn click(harness: &mut Window<'_>, label: &str, held: Modifiers) {
    let at = row(harness, label);
    harness.event(Event::ModifiersChanged(held));
    press(harness, at, LEFT);
    release(harness, at, LEFT);
    harness.event(Event::ModifiersChanged(Modifiers::NONE));
    harness.step();
}

fn names(harness: &Window<'_>) -> Vec<String> {
    let points = &harness.state().document.path().points;
    points
        .iter()
        .map(|point| point.name.clone().unwrap_or_default())
        .collect()
}

const START: &str = "Point 1: start";
const LEFT_SIDE: &str = "Point 2: left side";
const RIGHT_SIDE: &str = "Point 5: right side";

#[test]
fn it_has_a_row_for_each_point_and_for_each_further_orientation() {
    let harness = pyramid_list();
    assert_eq!(
        rows(&harness),
        [
            START,
            LEFT_SIDE,
            "Point 3: left corner",
            "Point 4: right corner",
            "Point 4, view 2",
            "Point 4, view 3",
            "Point 4, view 4",
            RIGHT_SIDE,
            "Point 6: end",
        ]
    );
}

#[test]
fn clicks_select_one_or_several() {
    let mut harness = pyramid_list();
    let state = |harness: &Window<'_>| {
        let editor = harness.state();
        (editor.document.selection(), editor.all_selected())
    };
    click(&mut harness, RIGHT_SIDE, Modifiers::NONE);
    assert_eq!(state(&harness), (Selection::at(4, 0), vec![4]));
    click(&mut harness, LEFT_SIDE, Modifiers::SHIFT);
    assert_eq!(state(&harness), (Selection::at(4, 0), vec![1, 2, 3, 4]));
    click(&mut harness, START, Modifiers::CTRL);
    assert_eq!(state(&harness), (Selection::at(0, 0), vec![0, 1, 2, 3, 4]));
    click(&mut harness, LEFT_SIDE, Modifiers::CTRL);
    assert_eq!(state(&harness), (Selection::at(0, 0), vec![0, 2, 3, 4]));
    click(&mut harness, "Point 4, view 3", Modifiers::NONE);
    assert_eq!(state(&harness), (Selection::at(3, 2), vec![3]));
    // Here the arrow keys go through the list.
    tap(&mut harness, Key::ArrowUp, Modifiers::NONE);
    assert_eq!(state(&harness), (Selection::at(2, 0), vec![2]));
    click(&mut harness, RIGHT_SIDE, Modifiers::SHIFT);
    tap(&mut harness, Key::Escape, Modifiers::NONE);
    assert_eq!(state(&harness), (Selection::at(2, 0), vec![2]));
    assert!(!harness.state().document.is_modified());
}

#[test]
fn a_name_is_typed_in_its_place() {
    let mut harness = pyramid_list();
    let before = names(&harness);
    click(&mut harness, LEFT_SIDE, Modifiers::NONE);
    let below = row(&harness, RIGHT_SIDE);
    tap(&mut harness, Key::F2, Modifiers::NONE);
    assert!(harness.state().windows.curve.is_none(), "F2 is the list's");
    harness.step();
    assert_eq!(row(&harness, RIGHT_SIDE), below, "the rows below stay");
    screenshot(&mut harness, "list-name.png");
    harness.event(Event::Text("bank".to_owned()));
    harness.step();
    tap(&mut harness, Key::Enter, Modifiers::NONE);
    assert_eq!(names(&harness)[1], "bank");
    assert!(harness.state_mut().document.undo());
    assert_eq!(names(&harness), before);
    // By a double click; Escape leaves the name.
    harness.run();
    let at = row(&harness, START);
    for _ in 0..2 {
        press(&mut harness, at, LEFT);
        release(&mut harness, at, LEFT);
    }
    harness.step();
    harness.event(Event::Text("x".to_owned()));
    harness.step();
    tap(&mut harness, Key::Escape, Modifiers::NONE);
    assert_eq!(names(&harness), before);
    assert!(!harness.state().document.is_modified());
    assert_eq!(rows(&harness)[0], START);
    // Elsewhere F2 is what it was.
    harness
        .get_by_label(harness.state().texts().space.name)
        .click();
    harness.run();
    tap(&mut harness, Key::F2, Modifiers::NONE);
    assert!(harness.state().windows.curve.is_some());
}

#[test]
fn dragging_brings_points_into_another_order() {
    let mut harness = pyramid_list();
    let before = harness.state().document.to_toml().unwrap();
    let points = harness.state().document.path().points.clone();
    let drag = |harness: &mut Window<'_>, from: &str, to: &str, beside: f32| {
        let from = row(harness, from);
        let to = row(harness, to) + vec2(0.0, beside);
        press(harness, from, LEFT);
        motion(harness, from + vec2(0.0, 8.0));
        motion(harness, to);
        release(harness, to, LEFT);
    };
    // Behind the last orientation of point 4, between it and point 5.
    drag(&mut harness, LEFT_SIDE, "Point 4, view 2", 0.0);
    let now = |harness: &Window<'_>| -> Vec<usize> {
        let path = harness.state().document.path();
        let number = |point| points.iter().position(|other| other == point).unwrap();
        path.points.iter().map(number).collect()
    };
    assert_eq!(now(&harness), [0, 2, 3, 1, 4, 5]);
    assert_eq!(harness.state().document.selection(), Selection::at(3, 0));
    // Several as they stand, to the front.
    harness.run();
    click(&mut harness, "Point 2: left corner", Modifiers::NONE);
    click(&mut harness, "Point 6: end", Modifiers::CTRL);
    drag(&mut harness, "Point 2: left corner", START, -10.0);
    assert_eq!(now(&harness), [2, 5, 0, 3, 1, 4]);
    assert_eq!(harness.state().all_selected(), [0, 1]);
    assert_eq!(harness.state().document.selection().point, 1);
    let document = &mut harness.state_mut().document;
    assert!(document.undo() && document.undo() && !document.can_undo());
    assert_eq!(document.to_toml().unwrap(), before);
}

#[test]
fn it_folds_in_a_narrow_window_and_by_a_click() {
    for language in [Language::German, Language::English] {
        let texts = &language.texts().points_list;
        let mut narrow = of_size(pyramid(), language, vec2(800.0, 600.0));
        assert_eq!(rows(&narrow), [""; 0]);
        narrow.get_by_label(texts.unfold).click();
        narrow.run();
        assert_eq!(rows(&narrow).len(), 9);
        narrow.get_by_label(texts.fold).click();
        narrow.run();
        assert_eq!(rows(&narrow), [""; 0]);
    }
}

/// A point that becomes current elsewhere comes to be seen.
#[test]
fn it_scrolls_to_what_is_current() {
    let mut harness = of_size(many(), Language::English, vec2(1200.0, 800.0));
    assert!(rows(&harness).len() < 40);
    for at in [299, 0, 150] {
        harness.state_mut().document.select(at, 0).unwrap();
        harness.run();
        let label = format!("Point {}", at + 1);
        assert!(
            rows(&harness).contains(&label),
            "{label} {:?}",
            rows(&harness)
        );
        let place = row(&harness, &label);
        assert!(place.y > 60.0 && place.y < 750.0, "{label} at {place}");
    }
}

/// A drag that is held at the end of what is seen goes on.
#[test]
fn a_drag_scrolls() {
    let mut harness = of_size(many(), Language::English, vec2(1200.0, 800.0));
    let from = row(&harness, "Point 3");
    let last = harness.query_all(by().role(Role::ListItem));
    let below = last.map(|row| row.rect().bottom()).fold(0.0, f32::max);
    press(&mut harness, from, LEFT);
    motion(&mut harness, from + vec2(0.0, 9.0));
    let to = egui::pos2(from.x, below.min(700.0) - 2.0);
    motion(&mut harness, to);
    for _ in 0..20 {
        harness.step();
    }
    let rows = rows(&harness);
    assert!(!rows.contains(&"Point 3".to_owned()), "{rows:?}");
    let place = harness.state().document.path().points[2].position;
    release(&mut harness, to, LEFT);
    let points = &harness.state().document.path().points;
    let at = points.iter().position(|point| point.position == place);
    assert!(at.is_some_and(|at| (30..60).contains(&at)), "{at:?}");
    assert_eq!(harness.state().document.selection().point, at.unwrap());
}

/// Three hundred points on a spiral.
fn many() -> Document {
    let points = (0..300_u32).map(|k| {
        let turn = f64::from(k) * 0.2;
        let out = 0.2 + f64::from(k) * 0.0025;
        SupportPoint::new(DVec3::new(
            out * turn.cos(),
            f64::from(k) / 200.0 - 0.75,
            out * turn.sin(),
        ))
    });
    let path = CameraPath {
        points: points.collect(),
        ..CameraPath::default()
    };
    Document::from_parts(path, vides_document::Info::default()).unwrap()
}

#[test]
fn pictures_of_the_list() {
    for (name, theme, language, size) in [
        (
            "list-dark-de.png",
            Theme::Dark,
            Language::German,
            [1200.0, 800.0],
        ),
        (
            "list-light-en.png",
            Theme::Light,
            Language::English,
            [1440.0, 900.0],
        ),
        (
            "list-small-de.png",
            Theme::Light,
            Language::German,
            [800.0, 600.0],
        ),
    ] {
        let mut document = pyramid();
        document.select(3, 1).unwrap();
        let mut editor = editor(document, language);
        editor.setup.theme = Some(theme);
        let mut harness = window(editor, size.into(), 1.0);
        screenshot(&mut harness, name);
    }
    let mut harness = of_size(many(), Language::English, vec2(1200.0, 800.0));
    tap(&mut harness, Key::A, Modifiers::CTRL);
    screenshot(&mut harness, "list-300.png");
    let mut harness = of_size(many(), Language::German, vec2(800.0, 600.0));
    harness
        .get_by_label(Language::German.texts().points_list.unfold)
        .click();
    harness.run();
    screenshot(&mut harness, "list-300-small.png");
}

/// A letter means what the pointer is over, though the list has the keyboard; while a name
/// is typed it is a letter.
#[test]
fn over_the_space_the_letters_of_its_tools_are_its_own() {
    let mut harness = pyramid_list();
    let name = harness.state().texts().space.name;
    let space = harness.get_by_label(name).rect();
    let over = space.left_bottom() + vec2(150.0, -60.0);
    let before = harness.state().document.path().clone();
    let choose = |harness: &mut Window<'_>| {
        click(harness, LEFT_SIDE, Modifiers::NONE);
        click(harness, RIGHT_SIDE, Modifiers::CTRL);
    };
    for (letter, axis) in [(Key::M, Key::X), (Key::R, Key::Y), (Key::S, Key::X)] {
        choose(&mut harness);
        tap(&mut harness, letter, Modifiers::NONE);
        assert!(!harness.state().document.in_step(), "the pointer is here");
        motion(&mut harness, over);
        tap(&mut harness, letter, Modifiers::NONE);
        assert!(harness.state().document.in_step(), "{letter:?}");
        tap(&mut harness, axis, Modifiers::NONE);
        harness.event(Event::Text("0.5".to_owned()));
        harness.step();
        if letter == Key::S {
            screenshot(&mut harness, "list-then-tool.png");
        }
        tap(&mut harness, Key::Enter, Modifiers::NONE);
        assert_ne!(*harness.state().document.path(), before, "{letter:?}");
        tap(&mut harness, Key::Z, Modifiers::CTRL);
        assert_eq!(*harness.state().document.path(), before);
        // Escape gives up the tool and nothing else.
        choose(&mut harness);
        motion(&mut harness, over);
        tap(&mut harness, letter, Modifiers::NONE);
        tap(&mut harness, Key::Escape, Modifiers::NONE);
        assert!(!harness.state().document.in_step());
        assert_eq!(harness.state().all_selected(), [1, 4]);
    }
    click(&mut harness, START, Modifiers::NONE);
    tap(&mut harness, Key::F2, Modifiers::NONE);
    harness.step();
    motion(&mut harness, over);
    tap(&mut harness, Key::M, Modifiers::NONE);
    harness.event(Event::Text("m".to_owned()));
    harness.step();
    tap(&mut harness, Key::Enter, Modifiers::NONE);
    harness.step();
    assert_eq!(names(&harness)[0], "m");
}
