//! What a tool shows is in no file, and no program has it, until `OK`.

use std::path::Path;

use vides_document::tool::{Needs, tools};
use vides_engine::path::Timeline;

use crate::state::Request;
use crate::tests::*;

/// A window of a file with 6 points.
fn opened(file: &Path, folders: Folders) -> Window {
    let document = some_points();
    document.save(file).expect("a file");
    let options = Options {
        document: Document::load(file).expect("a path"),
        file: Some(file.to_owned()),
        folders,
        ..options(Language::English)
    };
    window_of(options, LARGE, 1.0, Theme::Dark)
}

fn pick(window: &mut Window, name: &'static str) {
    let language = window.state().language();
    open_menu(window, 3);
    let tool = tools().find(|tool| tool.name == name).expect("a tool");
    let more = match tool.has_numbers() || tool.needs() != Needs::Nothing {
        true => " …",
        false => "",
    };
    click(window, &format!("{}{more}", language.tool(name)));
}

fn points(document: &Document) -> usize {
    document.path().points.len()
}

fn points_in(file: &Path) -> usize {
    points(&Document::load(file).expect("a path"))
}

fn frames(document: &Document) -> usize {
    document.timeline(Timeline::frame_count).unwrap().unwrap()
}

/// The points of the film, and those of an orbit after its end.
const WITH_ORBIT: usize = 6 + 13;

fn shows_orbit(window: &Window) -> bool {
    window.state().windows.tool.is_some() && points(&window.state().document) == WITH_ORBIT
}

#[test]
fn saving_leaves_a_preview_out_and_open() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("film.vid");
    let mut window = opened(&file, Folders::default());
    press(&mut window, Modifiers::ALT, Key::Insert);
    let count = points(&window.state().document);
    pick(&mut window, "orbit");
    press(&mut window, Modifiers::CTRL, Key::S);
    assert_eq!(points_in(&file), count);
    assert!(shows_orbit(&window));
    assert!(!window.state().is_unsaved());
    assert!(!window.state().window_title().contains('*'));
    // Cancelled, the document is what the file has; undone, it is not.
    press(&mut window, Modifiers::NONE, Key::Escape);
    assert_eq!(points(&window.state().document), count);
    assert!(!window.state().is_unsaved());
    press(&mut window, Modifiers::CTRL, Key::Z);
    assert!(window.state().is_unsaved());
    // Kept, it is unsaved.
    press(&mut window, Modifiers::CTRL, Key::S);
    pick(&mut window, "orbit");
    press(&mut window, Modifiers::CTRL, Key::S);
    press(&mut window, Modifiers::NONE, Key::Enter);
    assert!(window.state().is_unsaved());
    press(&mut window, Modifiers::CTRL, Key::Z);
    assert!(!window.state().is_unsaved());
    press(&mut window, Modifiers::CTRL, Key::Y);
    press(&mut window, Modifiers::CTRL, Key::S);
    assert_eq!(points_in(&file), WITH_ORBIT);
}

#[test]
fn quitting_with_save_leaves_a_preview_out() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("film.vid");
    let mut window = opened(&file, Folders::default());
    pick(&mut window, "orbit");
    // A preview is no unsaved work.
    press(&mut window, Modifiers::CTRL, Key::Q);
    assert_eq!(window.state_mut().next_request(), Some(Request::Close));
    press(&mut window, Modifiers::NONE, Key::Escape);
    press(&mut window, Modifiers::ALT, Key::Insert);
    let count = points(&window.state().document);
    pick(&mut window, "orbit");
    press(&mut window, Modifiers::CTRL, Key::Q);
    click_button(&mut window, |texts| texts.questions.save);
    assert_eq!(window.state_mut().next_request(), Some(Request::Close));
    assert_eq!(points_in(&file), count);
}

#[test]
fn other_programs_get_no_preview() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut window = opened(&folder.path().join("film.vid"), Folders::default());
    let count = poses(window.state()).len();
    let editor = window.state();
    let before = (
        editor.document().revision(),
        editor.step_number(),
        editor.standing(),
        editor.view().unwrap(),
    );
    pick(&mut window, "orbit");
    assert_ne!(frames(&window.state().document), count);
    let told = |window: &Window| {
        let editor = window.state();
        (
            editor.document().revision(),
            editor.step_number(),
            editor.standing(),
            editor.view().unwrap(),
        )
    };
    assert!(told(&window) == before);
    assert!(!window.state().is_under_way());
    assert_eq!(
        window.state().document().poses().unwrap().frame_count(),
        count
    );
    // Behind the end of the path the camera stands at its end.
    let end = frames(&window.state().document).max(count + 50) as f64;
    window.state_mut().playing.frame = Some(end);
    let (pose, frame) = window.state().view().unwrap();
    assert_eq!(frame, count as f64);
    assert_eq!(
        pose,
        window
            .state()
            .document()
            .sampler()
            .unwrap()
            .pose(frame)
            .unwrap()
    );
    let file = folder.path().join("poses.csv");
    window.state_mut().export(&file, None).expect("written");
    let lines = std::fs::read_to_string(&file).unwrap();
    let poses = lines.lines().filter(|line| !line.starts_with('#'));
    assert_eq!(poses.count(), 1 + count);
    press(&mut window, Modifiers::CTRL, Key::H);
    assert!(shows_orbit(&window));
    // `OK` gives it to all of them.
    click_button(&mut window, |texts| texts.tools.ok);
    let after = told(&window);
    assert!(after.0 != before.0 && after.1 != before.1);
    assert_eq!(points(window.state().document()), WITH_ORBIT);
}

/// What a host does to the path is done to the path, not to what a tool shows.
#[test]
fn a_host_changes_the_path_without_the_preview() {
    for by in [0, 1, 2] {
        let folder = tempfile::tempdir().expect("a folder");
        let file = folder.path().join("film.vid");
        let mut window = opened(&file, Folders::default());
        pick(&mut window, "orbit");
        let editor = window.state_mut();
        let insert = Edit::DivideSegment {
            segment: 0,
            points: 1,
        };
        match by {
            0 => editor.change(|document| document.apply(insert)).unwrap(),
            1 => editor.document_mut().apply(insert).unwrap(),
            _ => {
                editor
                    .set_object(vides_document::Object::default())
                    .unwrap();
                assert_eq!(points(&editor.document), 6);
                continue;
            }
        }
        window.run();
        assert_eq!(points(&window.state().document), 7);
        assert!(window.state().windows.tool.is_none());
        window.state_mut().save_as(None).unwrap();
        assert_eq!(points_in(&file), 7);
        press(&mut window, Modifiers::CTRL, Key::Z);
        assert_eq!(points(&window.state().document), 6);
    }
}

#[test]
fn what_is_kept_for_recovery_has_no_preview() {
    let folder = tempfile::tempdir().expect("a folder");
    let state = folder.path().join("state");
    std::fs::create_dir(&state).unwrap();
    let folders = || Folders {
        state: Some(state.clone()),
        ..Folders::default()
    };
    let file = folder.path().join("film.vid");
    let mut window = opened(&file, folders());
    press(&mut window, Modifiers::ALT, Key::Insert);
    let count = points(&window.state().document);
    pick(&mut window, "orbit");
    for _ in 0..400 {
        window.step();
    }
    drop(window);
    let found = crate::files::recovery::find(&state, None);
    let [found] = &found[..] else {
        panic!("one file");
    };
    assert_eq!(points(&found.document().unwrap()), count);
}

/// What a tool shows is what `OK` makes of it, whether times are fixed or not.
#[test]
fn a_preview_keeps_fixed_times() {
    for fixed in [true, false] {
        let mut window = window_with_points(Language::English, LARGE, 1.0, Theme::Dark);
        let before = frames(&window.state().document);
        if !fixed {
            click_button(&mut window, |texts| texts.space.times);
        }
        pick(&mut window, "scale");
        enter(&mut window, "Factor", "0.7");
        let shown = window.state().document.path().clone();
        assert_eq!(frames(&window.state().document) == before, fixed);
        click_button(&mut window, |texts| texts.tools.ok);
        assert_eq!(window.state().document.path(), &shown);
        press(&mut window, Modifiers::CTRL, Key::Z);
        assert_eq!(frames(&window.state().document), before);
    }
}

/// *Pace within limits* changes the pace, and the duration when it is asked to.
#[test]
fn a_pace_begins_with_the_present_duration() {
    let mut window = window_with_points(Language::English, LARGE, 1.0, Theme::Dark);
    let last = window.state().document.path().points.len() - 1;
    let slow = Edit::FitFrames {
        first: 0,
        last,
        frames: 1500,
    };
    window.state_mut().document.apply(slow).unwrap();
    window.run();
    pick(&mut window, "retime");
    assert_eq!(value(&window, "Duration"), "60.00 s");
    assert_eq!(frames(&window.state().document), 1500);
    press(&mut window, Modifiers::NONE, Key::Escape);
    // Of selected points it is theirs.
    let frame = |window: &Window, point| {
        let document = &window.state().document;
        let section = document.timeline(|timeline| timeline.section_from(point, 0));
        document
            .sampler()
            .unwrap()
            .first_frame(section.unwrap().unwrap())
    };
    let [from, to] = [1, 4].map(|point| frame(&window, point));
    let choice = crate::state::selected::SelectionChange::These(vec![1, 2, 3, 4]);
    window.state_mut().choose(choice);
    pick(&mut window, "frames");
    assert_eq!(value(&window, "Frames"), (to - from + 1).to_string());
    assert_eq!(frames(&window.state().document), 1500);
    // Where the limits allow no such pace it is the shortest that they allow.
    press(&mut window, Modifiers::NONE, Key::Escape);
    let fast = Edit::FitFrames {
        first: 0,
        last,
        frames: 20,
    };
    window.state_mut().document.apply(fast).unwrap();
    window.run();
    pick(&mut window, "retime");
    assert!(frames(&window.state().document) > 20);
    let shown = value(&window, "Duration");
    let seconds = shown.trim_end_matches(" s").parse::<f64>().unwrap();
    assert_eq!(
        frames(&window.state().document),
        (25.0 * seconds).round() as usize
    );
}
