use std::path::{Path, PathBuf};
use std::sync::Arc;

use egui::Event;
use glam::DVec3;
use vides_document::{Document, Selection};
use vides_engine::path::fit_frames::frames_between;
use vides_engine::path::{Change, SupportPoint};
use vides_engine::shared_list::SharedList;

use crate::state::selected::SelectionChange;
use crate::tests::*;

/// What a window has put into the clipboard in its last pass.
fn clipboard(window: &Window) -> Option<String> {
    let commands = window.output().platform_output.commands.iter();
    let mut texts = commands.filter_map(|command| match command {
        egui::OutputCommand::CopyText(text) => Some(text.clone()),
        _ => None,
    });
    texts.next_back()
}

/// Copies or cuts by the event that the keyboard's keys make.
fn taken(window: &mut Window, event: Event) -> Option<String> {
    window.event(event);
    window.step();
    let text = clipboard(window);
    window.run();
    text
}

fn paste(window: &mut Window, text: &str) {
    window.event(Event::Paste(text.to_owned()));
    window.run();
}

fn fresh() -> Window {
    window_with_points(Language::English, LARGE, 1.0, Theme::Dark)
}

fn choose(window: &mut Window, points: &[usize]) {
    window
        .state_mut()
        .choose(SelectionChange::These(points.to_vec()));
    window.run();
}

fn points(window: &Window) -> SharedList<SupportPoint> {
    window.state().document.path().points.clone()
}

fn places(window: &Window) -> Vec<DVec3> {
    points(window).iter().map(|point| point.position).collect()
}

#[test]
fn points_go_from_window_to_window_as_the_text_of_a_file() {
    let (mut one, mut other) = (fresh(), fresh());
    choose(&mut one, &[1, 2, 3]);
    let text = taken(&mut one, Event::Copy).expect("a text");
    // Whoever pastes it into a text file has a path.
    let of_file = Document::from_toml(&text).expect("a file");
    assert_eq!(of_file.path().points.len(), 3);
    let (before, known) = (places(&other), places(&one));
    other.state_mut().select_key(4, 0).unwrap();
    other.run();
    paste(&mut other, &text);
    let now = places(&other);
    assert_eq!(now[..=4], before[..=4]);
    assert_eq!(now[5..8], known[1..4]);
    assert_eq!(now[8..], before[5..]);
    // What was pasted is selected, so that it can be moved at once; one step.
    assert_eq!(other.state().several(), Some(&[5, 6, 7][..]));
    assert_eq!(other.state().document.selection(), Selection::at(5, 0));
    let output = &Language::English.texts().output;
    let pasted = fill(output.points_pasted, &[&3]);
    assert_eq!(said(&other), Some(pasted));
    let undo = |window: &Window| {
        let editor = window.state();
        let step = editor.document.step_names()[0];
        editor.language().travel(false, step)
    };
    assert_eq!(undo(&other), "Undo pasted points");
    press(&mut other, Modifiers::CTRL, Key::Z);
    assert_eq!(places(&other), before);
    // Their own window is none other.
    paste(&mut one, &text);
    assert_eq!(places(&one).len(), known.len() + 3);
}

#[test]
fn points_that_are_apart_are_copied_without_those_between_and_cut_in_one_step() {
    let mut window = fresh();
    let before = points(&window);
    choose(&mut window, &[0, 2, 5]);
    let document = &window.state().document;
    let times = [(0, 2), (2, 5)].map(|(from, to)| frames(document, from, to));
    let left = (frames(document, 1, 4) + 1) as f64 / 25.0;
    let text = taken(&mut window, Event::Cut).expect("a text");
    let cut = Document::from_toml(&text).expect("a file");
    let at = |number: usize| before[number].position;
    let positions = cut.path().points.iter().map(|point| point.position);
    assert_eq!(positions.collect::<Vec<_>>(), [at(0), at(2), at(5)]);
    let [views, known] = [&cut.path().points[1], &before[2]].map(|point| {
        let views = point.orientations.iter();
        views
            .map(|view| (view.target, view.speeds))
            .collect::<Vec<_>>()
    });
    assert_eq!(views, known);
    // They take as long as they did with those between.
    assert_eq!([0, 1].map(|at| frames(&cut, at, at + 1)), times);
    assert_eq!(points(&window).len(), before.len() - 3);
    let output = &Language::English.texts().output;
    let copied = fill(output.points_copied, &[&3]);
    assert_eq!(
        said(&window),
        Some(format!(
            "{copied} · The film is now {left:.2} s long (was 17.96 s): Ctrl+Z undoes it"
        ))
    );
    press(&mut window, Modifiers::CTRL, Key::Z);
    assert_eq!(points(&window), before);
    // Two remain: what cannot be removed is not copied either.
    choose(&mut window, &(0..before.len()).collect::<Vec<_>>());
    assert_eq!(taken(&mut window, Event::Cut), None);
    assert_eq!(points(&window), before);
    choose(&mut window, &[1]);
    assert_eq!(taken(&mut window, Event::Cut), None);
    assert_eq!(said(&window).as_deref(), Some(output.nothing_to_cut));
}

#[test]
fn what_was_copied_last_is_pasted() {
    let mut window = fresh();
    window.state_mut().set_orientation(|view| view.roll = 45.0);
    let view = taken(&mut window, Event::Copy).expect("a text");
    assert!(view.starts_with("[[point.orientation]]"), "{view}");
    choose(&mut window, &[0, 1]);
    let text = taken(&mut window, Event::Copy).expect("a text");
    let before = points(&window).len();
    window.state_mut().select_key(1, 0).unwrap();
    paste(&mut window, &text);
    assert_eq!(points(&window).len(), before + 2);
    // The view is still there: for its entry in the menu, and when nobody has a text.
    window.state_mut().select_key(4, 0).unwrap();
    paste(&mut window, "");
    assert_eq!(window.state().orientation().unwrap().roll, 45.0);
    // In another window its text is none of points.
    let mut other = fresh();
    paste(&mut other, &view);
    let no_points = Language::English.texts().output.no_points;
    assert_eq!(said(&other).as_deref(), Some(no_points));
}

#[test]
fn a_text_that_will_not_do_is_told_in_a_sentence() {
    for language in BOTH {
        let mut window = window_with_points(language, LARGE, 1.0, Theme::Dark);
        let before = window.state().document.state_number();
        let output = &language.texts().output;
        for text in [
            "milk, eggs",
            "[[points]]\n",
            "\0\u{7f}",
            &"x".repeat(1 << 20),
        ] {
            paste(&mut window, text);
            assert_eq!(said(&window).as_deref(), Some(output.no_points));
        }
        let far =
            "version = 1\n[[point]]\nposition = [1e300, 0, 0]\n[[point]]\nposition = [0, 0, 0]\n";
        let bad = "version = 1\n[[point]]\nposition = [0, 0]\n[[point]]\n";
        let one = "version = 1\n[[point]]\nposition = [0, 0, 0]\n";
        for text in ["[[point]]", far, bad, one] {
            paste(&mut window, text);
            let begin = fill(output.not_pasted, &[&""]);
            let said = said(&window).expect("a sentence");
            assert!(said.starts_with(begin.trim_end()), "{said}");
            assert!(said.len() < 300 && !said.contains('\n'), "{said}");
        }
        assert_eq!(window.state().document.state_number(), before);
        assert!(!window.state().document.in_step());
    }
}

#[derive(Debug)]
struct Dropped(PathBuf);

impl egui::DroppedFile for Dropped {
    fn path(&self) -> &Path {
        &self.0
    }

    fn bytes(&self) -> Result<Vec<u8>, String> {
        Err("only its name is of interest".to_owned())
    }
}

/// Drops files on a window.
fn drop_on(window: &mut Window, files: &[PathBuf]) {
    for file in files {
        let files = &mut window.input_mut().dropped_files;
        files.push(Arc::new(Dropped(file.clone())));
    }
    window.run();
}

#[test]
fn files_that_are_dropped_are_opened() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a flight.VID");
    let mut flight = Document::new();
    flight.apply(Edit::AppendAfterLast).unwrap();
    std::fs::write(&path, flight.to_toml().unwrap()).unwrap();
    let mesh = folder.path().join("box.obj");
    std::fs::write(&mesh, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").unwrap();
    let other = folder.path().join("notes.txt");
    std::fs::write(&other, "milk").unwrap();
    let texts = Language::English.texts();

    let mut window = window(Language::English);
    drop_on(&mut window, std::slice::from_ref(&mesh));
    assert!(!window.state().document.info().object.is_empty());
    // That is unsaved: a path asks first, and may be kept.
    drop_on(&mut window, std::slice::from_ref(&path));
    assert!(window.state().windows.question.is_some());
    assert_eq!(points(&window).len(), 2);
    press(&mut window, Modifiers::NONE, Key::Escape);
    assert!(window.state().windows.question.is_none());
    assert_eq!(points(&window).len(), 2);
    press(&mut window, Modifiers::CTRL, Key::Z);
    drop_on(&mut window, std::slice::from_ref(&path));
    assert_eq!(points(&window).len(), 3);
    assert_eq!(window.state().file.as_ref(), Some(&path));

    let state = window.state().document.state_number();
    drop_on(&mut window, std::slice::from_ref(&other));
    let refused = said(&window).unwrap_or_default();
    assert!(refused.contains("notes.txt"), "{refused}");
    drop_on(&mut window, &[path, mesh.clone()]);
    assert_eq!(said(&window).as_deref(), Some(texts.files.one_file));
    drop_on(&mut window, &[folder.path().join("gone.vid")]);
    assert!(said(&window).is_some_and(|said| said.contains("gone.vid")));
    drop_on(&mut window, &["http://example.org/a.vid".into()]);
    assert!(said(&window).is_some_and(|said| said.contains("example.org")));
    assert_eq!(window.state().document.state_number(), state);
}

/// Whatever is imported may be dropped: a scene, a list of poses, the folder of a project; a glTF
/// file without a camera is the object.
#[test]
fn what_is_imported_may_be_dropped() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let scene = fresh().state().document.scene_document().unwrap();
    let write = |name: &str, format: &str| {
        let file = folder.join(name);
        let by = vides_formats::by_name(format).unwrap();
        let options = vides_formats::Options::default();
        std::fs::create_dir_all(file.parent().unwrap()).unwrap();
        vides_formats::export(&scene, &file, by, &options, &mut |_, _| {}).unwrap();
        file
    };
    let project = write("project/sparse/0", "colmap");
    let project = project.ancestors().nth(2).unwrap().to_owned();
    for file in [
        write("camera.glb", "glb"),
        write("poses.euroc.csv", "euroc"),
        write("poses.npy", "matrices"),
        write("camera_path.json", "nerfstudio"),
        project,
    ] {
        let mut window = fresh();
        let before = window.state().document.state_number();
        drop_on(&mut window, std::slice::from_ref(&file));
        let texts = window.state().texts();
        if window.query_by_label(texts.questions.y_up).is_some() {
            click(&mut window, texts.questions.y_up);
        }
        if window.state().windows.tool.is_some() {
            click_button(&mut window, |texts| texts.tools.ok);
        }
        let after = window.state().document.state_number();
        assert_ne!(after, before, "{}: {:?}", file.display(), said(&window));
        assert!(window.state().document.info().object.is_empty());
        assert!(window.state().document.frame_range().unwrap().1 > 10.0);
    }
    let mesh = folder.join("mesh.gltf");
    let buffer = "data:application/octet-stream;base64,\
                  AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA";
    let text = format!(
        r#"{{"asset": {{"version": "2.0"}}, "nodes": [{{"mesh": 0}}], "scenes": [{{"nodes": [0]}}],
        "meshes": [{{"primitives": [{{"attributes": {{"POSITION": 0}}}}]}}],
        "accessors": [{{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
            "min": [0, 0, 0], "max": [1, 1, 0]}}],
        "bufferViews": [{{"buffer": 0, "byteLength": 36}}],
        "buffers": [{{"byteLength": 36, "uri": "{buffer}"}}]}}"#
    );
    std::fs::write(&mesh, text).unwrap();
    let mut window = fresh();
    let path = window.state().document.path().clone();
    drop_on(&mut window, &[mesh]);
    let state = window.state();
    assert!(
        !state.document.info().object.is_empty(),
        "{:?}",
        said(&window)
    );
    assert_eq!(state.document.path(), &path);
}

fn frames(document: &Document, from: usize, to: usize) -> usize {
    let path = document.path();
    let frames = document.timeline(|timeline| frames_between(path, timeline, from, to));
    frames.unwrap()
}

fn seconds_between(window: &Window, from: usize, to: usize) -> f64 {
    let document = &window.state().document;
    frames(document, from, to) as f64 / document.info().fps
}

/// A film of a room is put into one of a town, a thousand times as large.
#[test]
fn pasted_points_keep_their_seconds_and_join_at_the_mean_speed() {
    let mut one = fresh();
    choose(&mut one, &[1, 2, 3, 4]);
    let text = taken(&mut one, Event::Copy).expect("a text");
    let known = seconds_between(&one, 1, 4);
    for fps in [25.0, 30.0, 50.0] {
        let mut town = some_points();
        let mut space = town.path().space;
        space.half_size = 1000.0;
        town.apply(Edit::SetSpace { space, fit: true }).unwrap();
        let mut info = town.info().clone();
        info.fps = fps;
        town.apply(Edit::SetInfo(Box::new(info))).unwrap();
        let options = Options {
            document: town,
            ..options(Language::English)
        };
        let mut other = window_of(options, LARGE, 1.0, Theme::Dark);
        // Where times are fixed the others keep theirs instead.
        click_button(&mut other, |texts| texts.space.times);
        let before = [0, 1].map(|at| seconds_between(&other, 3 * at, 3 * at + 2));
        other.state_mut().select_key(2, 0).unwrap();
        paste(&mut other, &text);
        assert_eq!(places(&other).len(), 10);
        let pasted = seconds_between(&other, 3, 6);
        assert!((pasted - known).abs() <= 1.0 / fps, "{pasted} {known}");
        assert_eq!(seconds_between(&other, 0, 2), before[0]);
        assert_eq!(seconds_between(&other, 7, 9), before[1]);
        // Both joins at the speed of all others together.
        let document = &other.state().document;
        let timing = |of: &dyn Fn(usize) -> bool| {
            let all = document.timeline(|timeline| {
                let all = (0..timeline.section_count()).map(|at| timeline.section(at));
                let moving = all.filter(|at| at.change == Change::Position && of(at.point));
                let moving = moving.map(|at| (timeline.segment_length(at.point), at.frames as f64));
                moving.fold((0.0, 0.0), |sum, at| (sum.0 + at.0, sum.1 + at.1))
            });
            all.map(|(length, frames)| length / frames).unwrap()
        };
        let mean = timing(&|point| point != 2 && point != 6);
        for join in [2, 6] {
            let speed = timing(&|point| point == join);
            assert!((speed / mean - 1.0).abs() < 0.05, "{speed} {mean}");
        }
        let seconds = said(&other).unwrap();
        assert!(seconds.starts_with("4 points"), "{seconds}");
        press(&mut other, Modifiers::CTRL, Key::Z);
        assert_eq!(places(&other).len(), 6);
    }
}

#[test]
fn points_pasted_into_a_new_document_replace_its_two() {
    let mut one = fresh();
    let all: Vec<usize> = (0..points(&one).len()).collect();
    choose(&mut one, &all);
    let text = taken(&mut one, Event::Copy).expect("a text");
    let mut other = window(Language::English);
    paste(&mut other, &text);
    let paths = [&one, &other].map(|window| window.state().document.path().clone());
    assert_eq!(paths[1].points, paths[0].points);
    assert_eq!(paths[1].space, paths[0].space);
    assert_eq!(poses(other.state()), poses(one.state()));
    assert_eq!(other.state().several(), Some(&all[..]));
    press(&mut other, Modifiers::CTRL, Key::Z);
    assert!(other.state().document.path().is_new());
    // Where a host fixes the base speeds the seconds stay.
    let mut info = Document::new();
    let mut speeds = info.path().base_frames;
    speeds.movement *= 3.0;
    speeds.turning *= 0.5;
    info.apply(Edit::set(At::Path, "base_speeds", speeds))
        .unwrap();
    let options = Options {
        document: info.as_opened(),
        fixed_speeds: true,
        ..options(Language::English)
    };
    let mut host = window_of(options, LARGE, 1.0, Theme::Dark);
    paste(&mut host, &text);
    assert_eq!(host.state().document.path().base_frames, speeds);
    assert_eq!(seconds_between(&host, 0, 5), seconds_between(&one, 0, 5));
    // What is not new any more keeps its points.
    press(&mut other, Modifiers::NONE, Key::Insert);
    paste(&mut other, &text);
    assert_eq!(points(&other).len(), 3 + all.len());
}

#[test]
fn keys_beside_removed_points_keep_their_times() {
    for closed in [false, true] {
        for removed in [
            vec![1],
            vec![2],
            vec![1, 2, 3],
            vec![2, 4],
            vec![0],
            vec![0, 5],
            vec![5],
        ] {
            let mut window = fresh();
            let hold = |key: &mut vides_engine::path::Orientation| key.hold = 9;
            for at in [1, 2] {
                window.state_mut().select(at, 0);
                window.state_mut().set_orientation(hold);
            }
            if closed {
                window.state_mut().edit(Edit::set(At::Path, "closed", true));
            }
            let before = points(&window);
            let time = |window: &Window, at| frames(&window.state().document, 0, at);
            let times: Vec<usize> = (0..6).map(|at| time(&window, at)).collect();
            let total = poses(window.state()).len();
            choose(&mut window, &removed);
            press(&mut window, Modifiers::NONE, Key::Delete);
            let left: Vec<usize> = (0..6).filter(|at| !removed.contains(at)).collect();
            assert_eq!(points(&window).len(), left.len());
            for (now, &at) in left.iter().enumerate() {
                let since = times[at] - times[left[0]];
                assert_eq!(time(&window, now), since, "{closed} {removed:?} {at}");
            }
            if closed || !(removed.contains(&0) || removed.contains(&5)) {
                assert_eq!(poses(window.state()).len(), total, "{closed} {removed:?}");
            }
            press(&mut window, Modifiers::CTRL, Key::Z);
            assert_eq!(points(&window), before);
        }
    }
}
