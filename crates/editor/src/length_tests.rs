use egui::Event;
use vides_document::Selection;
use vides_engine::path::fit_frames::frames_between;
use vides_engine::path::{Change, Timeline};

use crate::action::Action;
use crate::entry::Entry;
use crate::state::selected::SelectionChange;
use crate::state::with;
use crate::tests::*;

fn frames(window: &Window) -> usize {
    let document = &window.state().document;
    document.timeline(Timeline::frame_count).unwrap().unwrap()
}

fn seconds(window: &Window) -> f64 {
    frames(window) as f64 / window.state().document.info().fps
}

fn hold(window: &Window, frames: u32) -> Edit {
    let editor = window.state();
    let at = editor.document.selection();
    with(at, editor.orientation().unwrap(), |key| key.hold = frames)
}

fn act(window: &mut Window, action: Action) {
    let context = window.ctx.clone();
    window.state_mut().act(action, &context);
    window.run();
}

fn window_of_300_frames(language: Language) -> Window {
    let mut document = some_points();
    let last = document.path().points.len() - 1;
    let fit = Edit::FitFrames {
        first: 0,
        last,
        frames: 300,
    };
    document.apply(fit).unwrap();
    let options = Options {
        document: document.as_opened(),
        ..options(language)
    };
    window_of(options, LARGE, 1.0, Theme::Dark)
}

/// 300 frames at 25 a second are 12 s; a hold of 30 makes them 13.2 s.
#[test]
fn a_change_of_the_length_says_so_and_is_undone_from_there() {
    for (language, text, typed) in [
        (
            Language::English,
            "The film is now 13.20 s long (was 12.00 s): Ctrl+Z undoes it",
            "The film is now 14.00 s long (was 13.20 s): Ctrl+Z undoes it",
        ),
        (
            Language::German,
            "Der Film dauert jetzt 13,20 s (vorher 12,00 s): Strg+Z macht es rückgängig",
            "Der Film dauert jetzt 14,00 s (vorher 13,20 s): Strg+Z macht es rückgängig",
        ),
    ] {
        let mut window = window_of_300_frames(language);
        let edit = hold(&window, 30);
        act(&mut window, Action::Edit(edit));
        assert_eq!(said(&window).as_deref(), Some(text));
        click_button(&mut window, |texts| texts.menu.undo);
        assert_eq!((frames(&window), said(&window)), (300, None));
        assert!(!window.state().document.can_undo());
        // A drag says it once at its end, and where nothing changes nothing is said.
        let context = window.ctx.clone();
        let drags = [10, 40, 30].map(|frames| Entry::Drag(hold(&window, frames)));
        let editor = window.state_mut();
        for entry in std::iter::once(Entry::Begin).chain(drags) {
            editor.act(Action::Enter(entry), &context);
            assert_eq!(editor.message, None);
        }
        act(&mut window, Action::Enter(Entry::End));
        assert_eq!(said(&window).as_deref(), Some(text));
        let name = Edit::set(At::Point(0), "name", "A".to_owned());
        act(&mut window, Action::Edit(name));
        assert_eq!(said(&window), None);
        // So it does where the length is typed.
        enter(&mut window, language.texts().space.duration, "14");
        assert_eq!(
            (frames(&window), said(&window).as_deref()),
            (350, Some(typed))
        );
        press(&mut window, Modifiers::CTRL, Key::Z);
        assert_eq!(frames(&window), 330);
    }
}

/// By name, when the points are reached, in seconds.
fn reached(window: &Window) -> Vec<(String, f64)> {
    let document = &window.state().document;
    let named = document.path().points.iter().zip(0..);
    let named = named.filter_map(|(point, at)| Some((point.name.clone()?, at)));
    let times = named.map(|(name, at)| {
        let frames = |timeline: &Timeline| frames_between(document.path(), timeline, 0, at);
        let frames = document.timeline(frames).unwrap();
        (name, frames as f64 / document.info().fps)
    });
    times.collect()
}

/// A window in which every point has a name, and of which the third one has three views.
fn named(language: Language, fixed_speeds: bool) -> Window {
    let mut document = some_points();
    for (at, name) in (0..6).zip(["a", "b", "c", "d", "e", "f"]) {
        let name = Edit::set(At::Point(at), "name", name.to_owned());
        document.apply(name).unwrap();
    }
    let options = Options {
        document: document.as_opened(),
        fixed_speeds,
        ..options(language)
    };
    window_of(options, LARGE, 1.0, Theme::Dark)
}

fn select(window: &mut Window, point: usize) {
    act(window, Action::Select(Selection::at(point, 0)));
}

fn move_away(window: &mut Window) {
    select(window, 3);
    let coordinate = window.state().texts().position.coordinate;
    enter(window, &fill(coordinate, &[&"x"]), "0.9");
}

fn remove(window: &mut Window) {
    select(window, 3);
    press(window, Modifiers::NONE, Key::Delete);
}

fn remove_two(window: &mut Window) {
    let choice = SelectionChange::These(vec![1, 3]);
    act(window, Action::Choose(choice));
    press(window, Modifiers::NONE, Key::Delete);
}

fn insert(window: &mut Window) {
    select(window, 3);
    press(window, Modifiers::NONE, Key::Insert);
}

fn insert_copies(window: &mut Window) {
    select(window, 3);
    let copies = crate::action::PathAction::AddPointOtherwise;
    act(window, Action::Path(copies));
}

fn paste(window: &mut Window) {
    let copied = some_points().points_as_text(&[2, 3, 4]).unwrap();
    select(window, 3);
    window.event(Event::Paste(copied));
    window.run();
}

fn add_view_and_turn_it(window: &mut Window) {
    select(window, 3);
    press(window, Modifiers::ALT, Key::Insert);
    let turned = window.state().texts().orientation.roll;
    enter(window, turned, "40");
    enter(window, turned, "70");
}

fn other_rate(window: &mut Window) {
    let rate = window.state().texts().space.rate;
    enter(window, rate, "50");
}

fn other_rate_by_f3(window: &mut Window) {
    press(window, Modifiers::NONE, Key::F3);
    let rate = window.state().texts().speed_window.fps;
    enter(window, rate, "50");
}

fn scale_by_tool(window: &mut Window) {
    let tool = vides_document::tool::tools().find(|tool| tool.name == "scale");
    let tool = crate::action::ToolAction::Open(tool.unwrap());
    act(window, Action::Tool(tool));
    let factor = window.state().language().parameter("factor");
    enter(window, factor, "0.7");
    click_button(window, |texts| texts.tools.ok);
}

type Operation = (&'static str, fn(&mut Window), bool);

/// What a person does, and whether the other points keep their times if these follow the speed.
const OPERATIONS: [Operation; 10] = [
    ("moved", move_away, false),
    ("removed", remove, false),
    ("two removed", remove_two, false),
    ("inserted", insert, true),
    ("copies inserted", insert_copies, false),
    ("pasted", paste, false),
    ("view turned", add_view_and_turn_it, false),
    ("another rate", other_rate, true),
    ("another rate by F3", other_rate_by_f3, false),
    ("scaled", scale_by_tool, false),
];

#[test]
fn fixed_times_stay_whatever_is_done_to_other_points() {
    for language in BOTH {
        let texts = &language.texts().space;
        for (what, operate, follows) in OPERATIONS {
            for fixed in [true, false] {
                let mut window = named(language, false);
                if !fixed {
                    click(&mut window, texts.times);
                }
                let (before, path) = (reached(&window), window.state().document.path().clone());
                let length = seconds(&window);
                operate(&mut window);
                assert!(window.state().document.is_modified(), "{what}");
                let after = reached(&window);
                let mut both = after.iter().filter_map(|(name, now)| {
                    let (_, then) = before.iter().find(|(of, _)| of == name)?;
                    Some((now - then).abs())
                });
                // A frame at 50 a second.
                let stay = both.all(|by| by < 0.020_001);
                assert_eq!(
                    stay,
                    fixed || follows,
                    "{what}, {fixed}: {before:?} {after:?}"
                );
                let same = seconds(&window) == length;
                assert!(same || !fixed, "{what}");
                let said = said(&window).unwrap_or_default();
                let tells = said != said_besides_length(&window).unwrap_or_default();
                assert_eq!(tells, !same, "{what}, {fixed}: {said}");
                while window.state().document.can_undo() {
                    press(&mut window, Modifiers::CTRL, Key::Z);
                }
                assert_eq!(window.state().document.path(), &path, "{what}");
            }
        }
    }
}

/// What is done on purpose to times and speeds has its effect, fixed or not, and says it.
#[test]
fn times_that_are_typed_change_in_either_state() {
    let texts = Language::English.texts();
    let base = format!(
        "{}: {}",
        texts.speed_window.base, texts.speed_window.base_move
    );
    for (name, text) in [
        (texts.speed_window.hold, "40"),
        (texts.speed_window.frames, "200"),
        (&base, "400"),
        (texts.space.duration, "30"),
    ] {
        for fixed in [true, false] {
            let mut window = named(Language::English, false);
            if !fixed {
                click(&mut window, texts.space.times);
            }
            let before = frames(&window);
            press(&mut window, Modifiers::NONE, Key::F3);
            enter(&mut window, name, text);
            assert_ne!(frames(&window), before, "{name}");
            let said = said(&window).unwrap();
            assert!(said.contains("Ctrl+Z undoes it"), "{name}: {said}");
        }
    }
}

/// Two words, as the window begins, and what was chosen begins the next window too. Files have no
/// part in it.
#[test]
fn the_choice_is_the_setups_and_not_the_files() {
    let folder = tempfile::tempdir().unwrap();
    let options = |fixed_speeds| Options {
        document: some_points(),
        fixed_speeds,
        folders: Folders {
            setup: Some(folder.path().to_owned()),
            ..Folders::default()
        },
        ..options(Language::English)
    };
    let word = |window: &Window| {
        let button = window.get_by_label("Times of the keys");
        button.value().unwrap_or_default()
    };
    let open = |fixed_speeds| window_of(options(fixed_speeds), LARGE, 1.0, Theme::Dark);
    // As the manual of 1994 has it where a host gives the speeds.
    assert_eq!(word(&open(true)), "follows speed");
    let mut window = open(false);
    assert_eq!(word(&window), "fixed");
    let text = window.state().document.to_toml().unwrap();
    click(&mut window, "Times of the keys");
    assert_eq!(word(&window), "follows speed");
    // It is no change of the document, and another one that is opened does not change it.
    assert_eq!(window.state().document.to_toml().unwrap(), text);
    assert!(!window.state().document.is_modified());
    let file = folder.path().join("film.vid");
    some_points().save(&file).unwrap();
    window.state_mut().load_path(&file).unwrap();
    window.run();
    assert_eq!(word(&window), "follows speed");
    assert_eq!(frames(&window), {
        let document = Document::load(&file).unwrap();
        document.timeline(Timeline::frame_count).unwrap().unwrap()
    });
    assert_eq!(word(&open(false)), "follows speed");
    click(&mut window, "Times of the keys");
    assert_eq!([word(&open(false)), word(&open(true))], ["fixed"; 2]);
}

/// After a point moved, the duration that is typed keeps the places of keys in time, or shares the
/// frames by the length of the sections, here of those of one speed.
#[test]
fn a_typed_duration_does_what_the_word_says() {
    let mut window = window_of_300_frames(Language::English);
    let each = |window: &Window| {
        let ways = |timeline: &Timeline| {
            let all = (0..timeline.section_count()).map(|at| timeline.section(at));
            let moves = all.filter(|of| of.change == Change::Position && of.point != 2);
            let numbers = moves.map(|of| (timeline.segment_length(of.point), of.frames as f64));
            numbers.collect::<Vec<_>>()
        };
        window.state().document.timeline(ways).unwrap()
    };
    // The most that a section has above its share by length.
    let uneven = |window: &Window| {
        let all = each(window);
        let [way, frames] = all
            .iter()
            .fold([0.0; 2], |sum, of| [sum[0] + of.0, sum[1] + of.1]);
        let above = all.iter().map(|of| (of.1 - of.0 * frames / way).abs());
        above.fold(0.0, f64::max)
    };
    assert!(uneven(&window) <= 1.0);
    move_away(&mut window);
    let before = each(&window);
    enter(&mut window, "Duration", "24");
    assert_eq!(frames(&window), 600);
    for (old, new) in before.iter().zip(each(&window)) {
        assert!((new.1 / old.1 - 2.0).abs() <= 0.1, "{old:?} {new:?}");
    }
    assert!(uneven(&window) > 2.0);
    click(&mut window, "Times of the keys");
    enter(&mut window, "Duration", "40");
    assert_eq!(frames(&window), 1000);
    assert!(uneven(&window) <= 1.0);
}
