//! Which camera is shown is chosen in the heading of its picture.

use egui::{Key, Modifiers, accesskit::Role};
use egui_kittest::kittest::{NodeT, Queryable};
use vides_document::{Document, Edit, StepName};
use vides_engine::path::{CameraPath, Pose};
use vides_engine::scene::{
    Channel, Extrapolation, FollowPath, Interpolation, Kind, Node, Part, Scene, Track,
};
use vides_formats::Options as Written;

use crate::screenshots::screenshot;
use crate::setup::{CameraPlace, Theme};
use crate::state::{Options, Reason};
use crate::tests::*;
use crate::texts::Language;

/// One camera on a path, one by keys between two frames, one on a path that begins later; the scene
/// begins at a fraction of a frame and is longer than a block.
fn cameras() -> Document {
    let mut scene = Scene::new();
    for (name, start) in [("first", 1.0), ("by keys", 0.0), ("third", 21.0)] {
        let at = scene
            .add(Node::new(name, Kind::Camera(Default::default())))
            .unwrap();
        if start > 0.0 {
            let path = CameraPath::default();
            let path = FollowPath::new(path, start, Extrapolation::Hold).unwrap();
            scene.set_path(at, Some(path)).unwrap();
            continue;
        }
        let track = Track::new(
            Channel::Position,
            Interpolation::Linear,
            vec![0.7, 900.3],
            vec![0.0, 0.3, -1.0, 1.0, 0.2, -0.7],
            Vec::new(),
        );
        scene.set_track(at, track.unwrap()).unwrap();
    }
    let mut document = Document::new();
    document.apply(Edit::ReplaceScene(Box::new(scene))).unwrap();
    document.as_opened()
}

fn window_in(language: Language, size: [f32; 2], theme: Theme) -> Window {
    let options = Options {
        document: cameras(),
        ..options(language)
    };
    window_of(options, size, 1.0, theme)
}

fn shown(window: &Window) -> usize {
    let scene = window.state().document().edited_scene().unwrap().scene();
    scene.shown_camera().unwrap()
}

fn choose(window: &mut Window, name: &str) {
    let heading = window.state().texts().scene.shown_camera;
    window
        .get_by_role_and_label(Role::ComboBox, heading)
        .click();
    window.run();
    window.get_by_role_and_label(Role::Button, name).click();
    window.run();
}

fn bits(poses: &[Pose]) -> Vec<u64> {
    let all = poses.iter().flat_map(|pose| {
        let places = pose.vrp.iter().chain(&pose.vpn).chain(&pose.vup);
        places.chain([&pose.zoom]).copied().collect::<Vec<_>>()
    });
    all.map(f64::to_bits).collect()
}

/// One step that stands in the file; `on_view` is told, and the path that is edited stays.
#[test]
fn the_heading_chooses_the_camera() {
    for language in BOTH {
        let mut window = window_in(language, LARGE, Theme::Dark);
        let before = window.state().document().scene().unwrap();
        window.state_mut().set_frame(30.0).unwrap();
        window.run();
        assert_eq!(shown(&window), 0);
        let standing = window.state().standing();
        choose(&mut window, "by keys");
        assert_eq!(shown(&window), 1);
        assert_eq!(window.state().frame().unwrap(), 30.0);
        let edited = window.state().document().edited_scene().unwrap();
        assert_eq!(edited.node(), Some(0), "what is edited stays");
        let name = window.state().document().step_names()[0];
        assert_eq!(name, Some(StepName::ShownCamera));
        assert_eq!(
            window.state().standing().reason(&standing),
            Reason::Selected
        );
        let scene = window.state().document().scene().unwrap();
        let (pose, _) = window.state().view().unwrap();
        let mut states = vec![Default::default(); 3];
        let warnings = &mut Default::default();
        scene.evaluate(30.0, &mut states, warnings).unwrap();
        assert_eq!(bits(&[pose]), bits(&[states[1].pose]));
        let text = window.state().document().to_toml().unwrap();
        assert!(text.contains("camera = \"by keys\""), "{text}");
        let heading = window.state().texts().scene.shown_camera;
        let heading = window.get_by_role_and_label(Role::ComboBox, heading);
        let words = heading.accesskit_node().value().unwrap();
        assert!(words.starts_with("by keys"), "{words}");
        // Undo tells the host the same.
        let standing = window.state().standing();
        press(&mut window, Modifiers::CTRL, Key::Z);
        assert_eq!(window.state().document().scene().unwrap(), before);
        assert_eq!(
            window.state().standing().reason(&standing),
            Reason::Selected
        );
        assert!(!window.state().document().is_modified());
        // Another change of the same scene is no other camera.
        let standing = window.state().standing();
        window.state_mut().add_here();
        assert_eq!(window.state().standing().reason(&standing), Reason::Edited);
    }
}

/// What is handed over, what is written to a file, and what the scene has frame by frame are the
/// same to the last bit, whichever camera is shown and whatever is edited.
#[test]
fn the_poses_are_the_shown_cameras_wherever_they_go() {
    let folder = tempfile::tempdir().unwrap();
    let mut window = window_in(Language::English, LARGE, Theme::Dark);
    for (camera, name) in ["first", "by keys", "third"].into_iter().enumerate() {
        if camera > 0 {
            choose(&mut window, name);
        }
        for node in 0..3 {
            window.state_mut().select_nodes(vec![node]);
            let document = window.state().document();
            let all = document.poses().unwrap();
            let scene = document.scene().unwrap();
            let (first, last) = scene.frame_range();
            assert_eq!((first, last), (0.7, 900.3));
            assert_eq!(all.frame_count(), 900);
            let mut poses = vec![Pose::default(); 900];
            all.sample(1, &mut poses).unwrap();
            for (at, pose) in poses.iter().enumerate() {
                let mut states = vec![Default::default(); 3];
                let warnings = &mut Default::default();
                let frame = first + at as f64;
                scene.evaluate(frame, &mut states, warnings).unwrap();
                let of_frame = [states[camera].pose];
                assert_eq!(bits(&[*pose]), bits(&of_frame), "{name} {frame}");
            }
            let file = folder.path().join("poses.csv");
            window.state_mut().write_as(&file, "csv").unwrap();
            let text = std::fs::read_to_string(&file).unwrap();
            let rows = text.lines().skip(1).map(|line| {
                let numbers = line.split(',').map(|number| number.parse().unwrap());
                numbers.collect::<Vec<f64>>()
            });
            let rows: Vec<Vec<f64>> = rows.collect();
            assert_eq!(rows.len(), 900);
            let written = rows.iter().flat_map(|row| row[1..11].to_vec());
            let written: Vec<u64> = written.map(f64::to_bits).collect();
            assert_eq!(written, bits(&poses), "{name}");
            // By people's numbers.
            assert_eq!(rows[0][0], 0.7);
            let document = window.state().document().scene_document().unwrap();
            let mut out = Vec::new();
            let format = vides_formats::by_name("csv").unwrap();
            let none = &mut |_, _| {};
            vides_formats::export_to(&document, &mut out, format, &Written::default(), none)
                .unwrap();
            assert_eq!(String::from_utf8(out).unwrap(), text);
        }
    }
}

/// A range whose ends are whole frames apart but for rounding has its last pose everywhere.
#[test]
fn rounding_takes_no_pose_away() {
    let mut window = window_in(Language::English, LARGE, Theme::Dark);
    let part = Part::Range(Some((1.1, 4.1)));
    assert!(window.state_mut().edit(Edit::Part(Box::new(part))));
    let count = window.state().document().poses().unwrap().frame_count();
    assert_eq!(count, 4);
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("poses.csv");
    window.state_mut().write_as(&file, "csv").unwrap();
    let text = std::fs::read_to_string(&file).unwrap();
    assert_eq!(text.lines().count(), 1 + count);
}

/// Its path is what hosts get, and none where it moves by keys.
#[test]
fn the_path_of_the_shown_camera_is_the_hosts() {
    let mut window = window_in(Language::English, LARGE, Theme::Dark);
    window.state_mut().select_nodes(vec![2]);
    click(&mut window, Language::English.texts().position.add);
    window.state_mut().select_nodes(vec![0]);
    window.run();
    let points = |window: &Window| {
        let path = window.state().document().shown_path().ok()?;
        Some(path.path().points.len())
    };
    let few = points(&window).unwrap();
    choose(&mut window, "third");
    assert_eq!(points(&window), Some(few + 1));
    choose(&mut window, "by keys");
    assert_eq!(points(&window), None);
}

#[test]
fn one_camera_has_no_list() {
    for language in BOTH {
        let window = window(language);
        let name = window.state().texts().scene.shown_camera;
        assert!(window.query_by_label(name).is_none());
    }
}

#[test]
fn pictures_of_the_heading() {
    for (language, theme) in [
        (Language::English, Theme::Light),
        (Language::German, Theme::Dark),
    ] {
        for size in [SMALL, LARGE] {
            for place in [CameraPlace::Corner, CameraPlace::Beside] {
                let mut window = window_in(language, size, theme);
                window.state_mut().setup.camera_place = place;
                window.state_mut().set_frame(30.0).unwrap();
                window.run();
                let heading = window.state().texts().scene.shown_camera;
                window
                    .get_by_role_and_label(Role::ComboBox, heading)
                    .click();
                window.run();
                let [width, _] = size;
                let name = format!("shown-camera-{language:?}-{width}-{place:?}.png");
                screenshot(&mut window, &name);
            }
        }
    }
}
