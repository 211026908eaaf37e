//! A window with a scene: what is shown of it, whose path is edited, and that nothing of
//! the rest is lost.

use std::path::{Path, PathBuf};

use egui_kittest::kittest::Queryable;
use vides_document::{At, Document, Edit};
use vides_engine::path::CameraPath;
use vides_engine::scene::{Extrapolation, FollowPath, Kind, Mesh, Node, Object, Scene, Track};
use vides_raster::Lines;

use crate::screenshots::screenshot;
use crate::setup::Theme;
use crate::state::{Editor, Options};
use crate::tests::*;
use crate::texts::Language;

/// A window with the scene of a file.
fn window_of_file(file: &Path, language: Language, theme: Theme) -> Window {
    let (document, warnings) = Document::load_scene(file).unwrap();
    assert!(warnings.is_empty());
    let options = Options {
        document,
        file: Some(file.to_owned()),
        ..options(language)
    };
    window_of(options, LARGE, 1.0, theme)
}

fn car() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/car.vid")
}

/// A drone on a path that carries a crate, and a camera on a path from frame 21 on.
fn flights() -> Document {
    let mut scene = Scene::new();
    let mut drone = Node::new("drone", Kind::Group);
    let path = CameraPath::default();
    drone
        .set_path(Some(
            FollowPath::new(path, 1.0, Extrapolation::Hold).unwrap(),
        ))
        .unwrap();
    scene.add(drone).unwrap();
    let mut load = Node::new("crate", Kind::Object(Object::default()));
    load.parent = Some(0);
    scene.add(load).unwrap();
    let corner = |x, y| glam::DVec3::new(x, y, 0.0);
    let mesh = Mesh {
        points: vec![corner(-0.1, 0.0), corner(0.1, 0.0), corner(0.0, 0.1)],
        triangles: vec![[0, 1, 2]],
        ..Mesh::default()
    };
    scene.set_mesh(1, mesh).unwrap();
    let mut camera = Node::new("camera", Kind::Camera(Default::default()));
    let path = CameraPath::default();
    camera
        .set_path(Some(
            FollowPath::new(path, 21.0, Extrapolation::Hold).unwrap(),
        ))
        .unwrap();
    scene.add(camera).unwrap();
    let mut document = Document::new();
    document.apply(Edit::ReplaceScene(Box::new(scene))).unwrap();
    document.as_opened()
}

fn window_of_flights(language: Language) -> Window {
    let options = Options {
        document: flights(),
        ..options(language)
    };
    window_of(options, LARGE, 1.0, Theme::Dark)
}

/// The lines of the scene in the movement window.
fn wires(editor: &Editor) -> Vec<[glam::DVec3; 2]> {
    let mut all = Vec::new();
    editor
        .with_scene(|now| super::wires(editor, now, |wire| all.push(wire.ends)))
        .unwrap();
    all
}

#[test]
fn pictures_of_the_car() {
    for (language, theme, name) in [
        (Language::German, Theme::Dark, "de-dark"),
        (Language::English, Theme::Light, "en-light"),
    ] {
        let mut window = window_of_file(&car(), language, theme);
        for frame in [1.0, 26.0, 51.0, 76.0] {
            window.state_mut().set_frame(frame).unwrap();
            window.run();
            screenshot(&mut window, &format!("scene-{name}-{frame}.png"));
        }
    }
    let mut window = window_of_flights(Language::English);
    screenshot(&mut window, "scene-flights.png");
    click(&mut window, "drone group");
    window.state_mut().set_frame(30.0).unwrap();
    window.run();
    screenshot(&mut window, "scene-flights-drone.png");
}

#[test]
fn everything_stands_where_the_scene_has_it_at_the_playhead() {
    let mut window = window_of_file(&car(), Language::English, Theme::Dark);
    let (document, _) = Document::load_scene(&car()).unwrap();
    let scene = document.scene().unwrap();
    let body = scene.find("body").unwrap();
    for frame in [1.0, 20.0, 40.5] {
        window.state_mut().set_frame(frame).unwrap();
        window.run();
        assert_eq!(window.state().frame().unwrap(), frame);
        let mut states = vec![Default::default(); scene.nodes().len()];
        let troubles = &mut vides_engine::scene::Warnings::default();
        scene.evaluate(frame, &mut states, troubles).unwrap();
        let Kind::Object(object) = &scene.nodes()[body].kind else {
            panic!("a body");
        };
        let corner = states[body]
            .world()
            .transform_point3(object.mesh().points[0]);
        let drawn = wires(window.state());
        assert!(drawn.iter().flatten().any(|end| *end == corner), "{frame}");
        // What the host is told is the camera's own state.
        let shown = scene.shown_camera().unwrap();
        let (pose, at) = window.state().view().unwrap();
        assert_eq!((pose, at), (states[shown].pose, frame));
    }
    // The whole of it plays, and no frame beyond.
    let (first, last) = scene.frame_range();
    assert_eq!(window.state().document().frame_of_scene(1.0), first);
    assert!(window.state_mut().set_frame(last).is_ok());
    assert!(window.state_mut().set_frame(last + 1.0).is_err());
}

#[test]
fn one_chooses_whose_path_is_edited() {
    for language in BOTH {
        let mut window = window_of_flights(language);
        let texts = &language.texts().scene;
        let edited = |window: &Window| window.state().document().edited_scene().unwrap().node();
        assert_eq!(edited(&window), Some(2));
        assert_eq!(window.state().frame().unwrap(), 21.0);
        let before = window.state().document().scene().unwrap();
        click(&mut window, &format!("drone {}", texts.group));
        assert_eq!(edited(&window), Some(0));
        // The moment stays.
        assert_eq!(window.state().frame().unwrap(), 21.0);
        assert!(!window.state().is_unsaved());
        click(&mut window, language.texts().position.add);
        let after = window.state().document().scene().unwrap();
        assert_eq!(after.nodes()[2], before.nodes()[2]);
        assert_ne!(after.nodes()[0], before.nodes()[0]);
        click(&mut window, texts.below);
        assert_eq!(edited(&window), None);
        assert!(window.query_by_label(texts.no_path).is_some());
        click(&mut window, &format!("camera {}", texts.camera));
        assert_eq!(edited(&window), Some(2));
        assert!(window.query_by_label(texts.no_path).is_none());
        // With what follows no path none is edited.
        click(&mut window, &format!("crate {}", texts.object));
        assert_eq!(edited(&window), None);
        assert_eq!(window.state().current_node(), Some(1));
    }
}

#[test]
fn what_is_in_a_node_is_drawn_around_its_path() {
    let mut window = window_of_flights(Language::English);
    let scene = window.state().document().scene().unwrap();
    let drawn = wires(window.state());
    assert_eq!(drawn.len(), 3);
    // The load hangs where the drone is at the camera's frame.
    let follow = scene.nodes()[0].path().unwrap();
    let pose = follow.pose(window.state().frame().unwrap()).unwrap();
    let centre: glam::DVec3 = drawn.iter().flatten().sum::<glam::DVec3>() / 6.0;
    let away = centre.distance(pose.vrp.into());
    assert!(away < 0.1, "{away}");
    // A drag of the path takes it along in the same pass.
    click(&mut window, "drone group");
    let at = window.state().document().path().points[0].position;
    let position = at + glam::DVec3::new(0.0, 0.25, 0.0);
    let before = wires(window.state());
    let edit = Edit::set(At::Point(0), "position", position);
    window.state_mut().document_mut().apply(edit).unwrap();
    let after = wires(window.state());
    for (before, after) in before.iter().flatten().zip(after.iter().flatten()) {
        assert!((*after - *before - glam::DVec3::new(0.0, 0.25, 0.0)).length() < 0.2);
        assert_ne!(after, before);
    }
}

#[test]
fn the_rest_of_a_scene_is_in_the_file_that_is_saved() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("again.vid");
    let mut window = window_of_file(&car(), Language::German, Theme::Dark);
    window.state_mut().save_as(Some(&file)).unwrap();
    let before = vides_document::SceneDocument::load(&car()).unwrap();
    let after = vides_document::SceneDocument::load(&file).unwrap();
    assert_eq!(before, after);
    // And so it is where a path of it has changed.
    let mut window = window_of_flights(Language::German);
    click(&mut window, "drone Gruppe");
    click(&mut window, Language::German.texts().position.add);
    window.state_mut().save_as(Some(&file)).unwrap();
    let after = vides_document::SceneDocument::load(&file).unwrap();
    assert_eq!(after.scene, window.state().document().scene().unwrap());
    let points = |at: usize| after.scene.nodes()[at].path().unwrap().path().points.len();
    assert_eq!(points(0), points(2) + 1);
}

#[test]
fn a_mesh_beside_the_file_is_read_and_named_as_before() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(
        folder.path().join("a.obj"),
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
    )
    .unwrap();
    let mut scene = Scene::new();
    let object = Node::new("thing", Kind::Object(Object::default()));
    scene.add(object).unwrap();
    let (source, mesh) = vides_document::load_mesh(&folder.path().join("a.obj")).unwrap();
    scene.set_mesh_of(0, source, mesh).unwrap();
    let mut document = Document::new();
    document.apply(Edit::ReplaceScene(Box::new(scene))).unwrap();
    let file = folder.path().join("a.vid");
    document.save(&file).unwrap();
    let mut window = window_of_file(&file, Language::English, Theme::Dark);
    assert_eq!(wires(window.state()).len(), 3);
    window.state_mut().save_as(None).unwrap();
    let text = std::fs::read_to_string(&file).unwrap();
    assert!(text.contains("file = \"a.obj\""), "{text}");
    // What is broken is told, and the rest is there.
    std::fs::write(folder.path().join("a.obj"), "v 0 0\n").unwrap();
    let (document, warnings) = Document::load_scene(&file).unwrap();
    assert_eq!(warnings.len(), 1);
    assert_eq!(document.scene().unwrap().nodes().len(), 1);
    let loaded = window.state_mut().load_path(&file);
    assert!(loaded.is_ok());
    let message = window.state().message.clone().unwrap();
    assert!(
        message.error && message.text.contains("a.obj"),
        "{}",
        message.text
    );
}

#[test]
fn a_path_alone_has_no_list_and_no_scene() {
    let window = window(Language::English);
    assert!(
        window
            .query_by_label(Language::English.texts().scene.below)
            .is_none()
    );
    assert!(window.state().document().edited_scene().is_none());
    assert!(window.state().with_scene(|_| ()).unwrap().is_none());
}

#[test]
fn a_pass_over_a_still_scene_makes_no_lines_anew() {
    let mut window = window_of_file(&car(), Language::English, Theme::Dark);
    let lines = |window: &Window| -> *const Lines {
        let editor = window.state();
        editor.space.lines_of_nodes()
    };
    let first = lines(&window);
    window.run();
    assert_eq!(lines(&window), first);
    window.state_mut().set_frame(10.0).unwrap();
    window.run();
    assert_ne!(lines(&window), first);
}

#[test]
fn unsaved_work_at_a_scene_is_the_whole_scene_again() {
    let mut window = window_of_flights(Language::English);
    click(&mut window, Language::English.texts().position.add);
    let document = window.state().document();
    let text = document.to_toml().unwrap();
    let (again, _) = Document::scene_from_toml(&text, Path::new("")).unwrap();
    assert_eq!(again.scene().unwrap(), document.scene().unwrap());
}

#[test]
fn a_track_beside_a_path_keeps_moving() {
    // The path of a node is edited; its own scale track stays and acts.
    let mut scene = flights().scene().unwrap();
    let track = Track::new(
        vides_engine::scene::Channel::Scale,
        vides_engine::scene::Interpolation::Linear,
        vec![1.0, 11.0],
        vec![1.0, 1.0, 1.0, 3.0, 3.0, 3.0],
        Vec::new(),
    );
    scene.set_track(0, track.unwrap()).unwrap();
    let mut document = Document::new();
    document.apply(Edit::ReplaceScene(Box::new(scene))).unwrap();
    document.apply(Edit::EditNode(Some(0))).unwrap();
    let options = Options {
        document,
        ..options(Language::English)
    };
    let mut window = window_of(options, LARGE, 1.0, Theme::Dark);
    let width = |window: &Window| {
        let drawn = wires(window.state());
        drawn[0][0].distance(drawn[0][1])
    };
    let narrow = width(&window);
    window.state_mut().set_frame(11.0).unwrap();
    assert!((width(&window) / narrow - 3.0).abs() < 1e-12);
}

/// A ball of so many rings of so many triangles, with edges where it is cut.
fn ball(rings: u32, around: u32) -> Mesh {
    let at = |ring: u32, turn: u32| {
        let tilt = std::f64::consts::PI * f64::from(ring) / f64::from(rings);
        let turn = std::f64::consts::TAU * f64::from(turn) / f64::from(around);
        glam::DVec3::new(tilt.sin() * turn.cos(), tilt.cos(), tilt.sin() * turn.sin()) * 0.5
    };
    let point = |ring: u32, turn: u32| ring * around + turn % around;
    let all = |of: u32| (0..of).flat_map(move |ring| (0..around).map(move |turn| (ring, turn)));
    Mesh {
        points: all(rings + 1).map(|(ring, turn)| at(ring, turn)).collect(),
        triangles: all(rings)
            .flat_map(|(ring, turn)| {
                let corners = [
                    point(ring, turn),
                    point(ring, turn + 1),
                    point(ring + 1, turn),
                    point(ring + 1, turn + 1),
                ];
                [
                    [corners[0], corners[1], corners[2]],
                    [corners[1], corners[3], corners[2]],
                ]
            })
            .collect(),
        ..Mesh::default()
    }
}

#[test]
fn timed_scrubbing_a_large_scene_stays_fluent() {
    let mut scene = flights().scene().unwrap();
    for k in 0..196_u32 {
        let mut node = Node::new(&format!("part {k}"), Kind::Object(Object::default()));
        node.parent = Some(if k % 4 == 0 { 0 } else { 2 + k as usize });
        node.rest.position = glam::DVec3::new(0.01 * f64::from(k % 7), 0.01, -0.01);
        let at = scene.add(node).unwrap();
        scene.set_mesh(at, ball(2, 4)).unwrap();
        let frames: Vec<f64> = (0..11).map(|key| 1.0 + 12.0 * f64::from(key)).collect();
        let turns = frames
            .iter()
            .flat_map(|frame| [0.0, 5.0 * frame, 0.0])
            .collect();
        let track = Track::new(
            vides_engine::scene::Channel::Rotation,
            vides_engine::scene::Interpolation::EulerLinear,
            frames,
            turns,
            Vec::new(),
        );
        scene.set_track(at, track.unwrap()).unwrap();
    }
    let large = scene
        .add(Node::new("ball", Kind::Object(Object::default())))
        .unwrap();
    scene.set_mesh(large, ball(250, 200)).unwrap();
    let twist = vides_engine::deform::Deformation::new("twist", &[1.0, 90.0]).unwrap();
    scene.add_deformation(large, twist, None).unwrap();
    let mut document = Document::new();
    document.apply(Edit::ReplaceScene(Box::new(scene))).unwrap();
    assert_eq!(document.scene().unwrap().nodes().len(), 200);
    let options = Options {
        document,
        ..options(Language::English)
    };
    let mut window = window_of(options, LARGE, 1.0, Theme::Dark);
    screenshot(&mut window, "scene-large.png");
    let passes = 40;
    let before = spent();
    for step in 0..passes {
        let frame = 21.0 + f64::from(step);
        window.state_mut().set_frame(frame).unwrap();
        window.step();
    }
    let pass = (spent() - before) / f64::from(passes);
    println!("a pass: {pass:.1} ms");
    assert!(pass < 60.0, "{pass} ms");
}

/// It is the range of the scene, and a step.
#[test]
fn the_end_of_a_scene_is_typed() {
    let mut window = window_of_file(&car(), Language::English, Theme::Dark);
    let scene = |window: &Window| window.state().document().scene().unwrap();
    let before = scene(&window);
    let texts = &Language::English.texts().space;
    for (name, text, last) in [(texts.last_frame, "20", 20.0), (texts.duration, "4", 100.0)] {
        enter(&mut window, name, text);
        assert_eq!(scene(&window).range(), Some((1.0, last)));
    }
    for _ in 0..2 {
        press(&mut window, Modifiers::CTRL, Key::Z);
    }
    assert_eq!(scene(&window), before);
}

/// The rest goes on.
#[test]
fn a_function_that_no_program_has_registered_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("car.vid");
    let text = std::fs::read_to_string(car()).unwrap();
    let (before, after) = text.split_once("interpolation = \"").unwrap();
    let (_, after) = after.split_once('"').unwrap();
    let text = format!("{before}interpolation = \"host:wobble\"{after}");
    std::fs::write(&file, text).unwrap();
    for language in BOTH {
        let window = window_of_file(&file, language, Theme::Dark);
        assert!(window.query_by_label_contains("host:wobble").is_some());
        let well = window_of_file(&car(), language, Theme::Dark);
        assert!(well.query_by_label_contains("host:").is_none());
    }
}

/// A camera that moves by keys is told, and one click makes it a path; that is one step.
#[test]
fn a_camera_by_keys_is_offered_a_path() {
    for language in BOTH {
        let texts = &language.texts().scene;
        let mut window = window_of_file(&car(), language, Theme::Dark);
        let camera = {
            let edited = window.state().document.edited_scene().unwrap();
            let scene = edited.scene();
            scene.nodes()[scene.shown_camera().unwrap()].name.clone()
        };
        let told = fill(texts.runs_by_keys, &[&camera]);
        assert!(window.query_by_label(&told).is_some());
        screenshot(&mut window, &format!("by-keys-{language:?}.png"));
        press(&mut window, Modifiers::CTRL, Key::I);
        let position = &language.texts().position;
        assert!(window.query_by_label(position.how_many).is_none());
        let only_path = language.texts().tools.only_path.to_owned();
        assert_eq!(said(&window), Some(only_path));
        click(&mut window, texts.keys_to_path);
        assert!(window.state().document.edits_path());
        let name = window.state().document.step_names()[0];
        assert_eq!(name, Some(vides_document::StepName::KeysToPath));
        let told_off = said(&window).unwrap();
        let points = window.state().document.path().points.len();
        assert!(told_off.contains(&points.to_string()), "{told_off}");
        screenshot(&mut window, &format!("became-path-{language:?}.png"));
        press(&mut window, Modifiers::CTRL, Key::Z);
        assert!(!window.state().document.edits_path());
        assert!(!window.state().document.can_undo());
    }
}

/// The scene's markers stand below the ruler, and a press near one goes there.
#[test]
fn markers_stand_at_the_scale_of_frames() {
    let mut window = window_of_file(&car(), Language::English, Theme::Dark);
    let name = Language::English.texts().space.timeline;
    let bar = window.get_by_role_and_label(Role::Slider, name).rect();
    let shapes = window.output().shapes.iter();
    let mut marker = shapes.filter_map(|clipped| match &clipped.shape {
        egui::Shape::Text(text) if text.galley.text() == "at the arm" => {
            Some(egui::Rect::from_min_size(text.pos, text.galley.size()))
        }
        _ => None,
    });
    let place = marker.next().expect("a marker");
    let below = place.top() - bar.bottom();
    assert!(below.abs() < 3.0, "{bar:?} {place:?}");
    // Frame 51 of 1 to 76.
    let middle = bar.left() + 8.0 + (bar.width() - 16.0) * 50.0 / 75.0;
    // Its name begins behind its sign.
    assert!((place.left() - middle - 6.0).abs() < 1.0);
    let at = egui::pos2(middle + 3.0, bar.center().y);
    window.hover_at(at);
    window.run();
    window.drag_at(at);
    window.step();
    assert_eq!(window.state().frame().unwrap(), 51.0);
}
