//! Files of other programs in the window.

use std::path::Path;

use vides_engine::path::Up;
use vides_formats::{Loss, Options, Report};

use super::tests::{modified, name, window_in};
use crate::screenshots::screenshot;
use crate::state::files::Purpose;
use crate::tests::*;
use crate::texts::formats::losses_of;

const BOTH: [Language; 2] = [Language::English, Language::German];

fn example(name: &str) -> std::path::PathBuf {
    let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    examples.join(name)
}

/// What would be lost is told before anything is written, and writing waits for the answer.
#[test]
fn losses_are_told_before_a_file_is_written() {
    for language in BOTH {
        let texts = language.texts();
        let folder = tempfile::tempdir().expect("a folder");
        let mut window = window_in(language, folder.path());
        let file = folder.path().join("a.tum");
        let ask = |window: &mut Window| {
            open_menu(window, 2);
            click(window, window.state().texts().menu.export);
            name(window, "a.tum");
            window.run();
        };
        ask(&mut window);
        assert!(!file.exists());
        let asked = window.query_by_label_contains(match language {
            Language::English => "the field of view is left out",
            Language::German => "der Bildwinkel bleibt weg",
        });
        assert!(asked.is_some());
        click(&mut window, texts.questions.cancel);
        assert!(!file.exists());
        ask(&mut window);
        click(&mut window, texts.files.write);
        let written = std::fs::read_to_string(&file).expect("a file");
        let frames = poses(window.state()).len();
        let rows = written.lines().filter(|line| !line.starts_with('#'));
        assert_eq!(rows.count(), frames);
        let said = said(&window).expect("a sentence");
        assert_eq!(said, fill(texts.output.written, &[&frames, &"a.tum"]));
        // Lines of ten numbers lose nothing that anyone expects there.
        open_menu(&mut window, 2);
        let export = window.state().texts().menu.export;
        click(&mut window, export);
        name(&mut window, "a.txt");
        assert!(folder.path().join("a.txt").exists());
    }
}

/// A scene takes the document's place in one step.
#[test]
fn a_scene_of_another_program_is_taken_over_and_given_back() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("car.glb");
    let mut window = window_in(Language::English, folder.path());
    window
        .state_mut()
        .load_path(&example("car.vid"))
        .expect("loaded");
    let frames = window
        .state()
        .document
        .poses()
        .expect("poses")
        .frame_count();
    window.state_mut().write_as(&file, "glb").expect("written");
    let mut window = window_in(Language::English, folder.path());
    let before = window.state().document.path().clone();
    assert!(!modified(&window));
    window.state_mut().file_chosen(Purpose::Import, &file);
    window.run();
    let scene = window.state().document.scene().expect("a scene");
    assert!(scene.find("body").or(scene.find("car")).is_some());
    let count = window
        .state()
        .document
        .poses()
        .expect("poses")
        .frame_count();
    assert_eq!(count, frames);
    assert!(modified(&window));
    assert!(window.state_mut().document.undo());
    assert_eq!(window.state().document.path(), &before);
    assert!(!modified(&window) && window.state().document.edited_scene().is_none());
}

/// Poses go to the tool that fits them; what is no file of a known format changes nothing.
#[test]
fn poses_are_fitted_and_the_unknown_is_refused() {
    for language in BOTH {
        let folder = tempfile::tempdir().expect("a folder");
        let file = folder.path().join("camera_path.json");
        let mut window = window_in(language, folder.path());
        window
            .state_mut()
            .write_as(&file, "nerfstudio")
            .expect("written");
        window.state_mut().file_chosen(Purpose::Import, &file);
        window.run();
        click_button(&mut window, |texts| texts.tools.ok);
        let [back, _] = window.state().document.step_names();
        assert!(back.is_some() && modified(&window));
        let unknown = folder.path().join("a.bin");
        std::fs::write(&unknown, "nothing known").expect("written");
        let before = window.state().document.path().clone();
        window.state_mut().file_chosen(Purpose::Import, &unknown);
        window.run();
        let said = said(&window).expect("a sentence");
        let why = match language {
            Language::English => "this is no file of a format that is read",
            Language::German => "das ist keine Datei eines Formats, das gelesen wird",
        };
        assert!(said.contains(why), "{said}");
        assert_eq!(window.state().document.path(), &before);
    }
}

/// The keyframes of a file are the points, as when it is converted; a tool that waits for poses
/// gets the frames, and tells it.
#[test]
fn keyframes_become_points() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../formats/tests/nerfstudio/open.json");
    let source = vides_formats::Source::open(&file).expect("a file");
    let converted = vides_formats::import(&source, None, &Options::default()).expect("a scene");
    let converted = converted.document.scene.nodes()[0].path().expect("a path");
    for language in BOTH {
        let folder = tempfile::tempdir().expect("a folder");
        let mut window = window_in(language, folder.path());
        let mut info = window.state().document.info().clone();
        info.fps = 10.0;
        let edit = Edit::SetInfo(Box::new(info));
        window.state_mut().document.apply(edit).expect("applied");
        let before = window.state().document.path().clone();
        window.state_mut().file_chosen(Purpose::Import, &file);
        window.run();
        assert!(window.state().windows.tool.is_none());
        let path = window.state().document.path();
        assert_eq!(path.points, converted.path().points);
        assert!(window.state_mut().document.undo());
        assert_eq!(window.state().document.path(), &before);
        let mut tools = vides_document::tool::tools();
        let fit = tools.find(|tool| tool.needs() == vides_document::tool::Needs::Poses);
        window.state_mut().open_tool(fit.expect("the fit"));
        window.state_mut().file_chosen(Purpose::Import, &file);
        window.run();
        let said = said(&window).expect("a sentence");
        let told = match language {
            Language::English => "5 keyframes left out",
            Language::German => "Schlüssel bleiben weg, angenähert werden die Bilder: 5",
        };
        assert!(said.contains(told), "{said}");
        click_button(&mut window, |texts| texts.tools.ok);
        assert!(window.state().document.path().points != converted.path().points);
    }
}

/// Poses whose file does not say which axis stands upright wait for the answer; the path takes that
/// axis, and one that the file says without a question. No camera is turned on its side.
#[test]
fn the_upright_axis_of_poses_is_asked_for_where_the_file_does_not_say() {
    for language in BOTH {
        let texts = &language.texts().questions;
        let folder = tempfile::tempdir().expect("a folder");
        let window = window_in(language, folder.path());
        let recorded = poses(window.state());
        for (format, name, asks) in [
            ("tum", "a.tum", true),
            ("nerfstudio", "camera_path.json", false),
        ] {
            let file = folder.path().join(name);
            let state = window.state();
            let document = state.document.scene_document().expect("a scene");
            let options = Options {
                up: Some(Up::Z),
                ..Options::default()
            };
            let by = vides_formats::by_name(format).expect("a format");
            vides_formats::export(&document, &file, by, &options, &mut |_, _| {}).expect("written");
            let mut window = window_in(language, folder.path());
            window.state_mut().file_chosen(Purpose::Import, &file);
            window.run();
            assert_eq!(
                window.query_by_label(texts.z_up).is_some(),
                asks,
                "{format}"
            );
            if asks {
                assert!(window.state().windows.tool.is_none());
                click(&mut window, texts.cancel);
                assert!(!modified(&window) && window.state().windows.tool.is_none());
                window.state_mut().file_chosen(Purpose::Import, &file);
                window.run();
                screenshot(&mut window, &format!("import-upright-{language:?}.png"));
                click(&mut window, texts.z_up);
            }
            click_button(&mut window, |texts| texts.tools.ok);
            let state = window.state();
            assert_eq!(state.document.path().space.up, Up::Z, "{format}");
            for (now, then) in poses(state).iter().zip(&recorded) {
                // What was upright is upright in the axes of the file.
                assert!((now.vup[2] - then.vup[1]).abs() < 0.01, "{now:?} {then:?}");
            }
        }
    }
}

/// Seconds since 1970 are read digit by digit.
#[test]
fn times_of_recordings_are_written_out() {
    let mut report = Report::default();
    report.add(Loss::Epoch(1_305_031_102.5));
    assert_eq!(
        losses_of(Language::German, &report),
        ["die Zeiten beginnen bei 1305031102,5 s: hier zählen sie ab 0"]
    );
}

/// A scene that is taken over does not go into the file that was open; its rate is told.
#[test]
fn an_imported_scene_is_a_document_without_a_file() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("scene.gltf");
    for own in [true, false] {
        let mut options = options(Language::English);
        options.program.offers_all = own;
        options.document = some_points();
        options.file = Some(folder.path().join("flight.vid"));
        let mut window = window_of(options, LARGE, 1.0, Theme::Dark);
        let editor = window.state_mut();
        editor.write_as(&file, "gltf").expect("written");
        editor.import(&file, None).expect("read");
        assert_eq!(editor.file.is_none(), own);
        window.run();
        let said = said(&window).expect("a sentence");
        assert!(said.contains("25 frames a second"), "{said}");
    }
}
