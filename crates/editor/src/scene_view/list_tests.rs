//! The list of nodes, and *Edit ▸ Add*, as a user works with them.

use std::path::Path;

use egui::{Event, PointerButton, Pos2};
use egui_kittest::kittest::{NodeT, by};
use glam::{DAffine3, DQuat};
use vides_document::StepName;
use vides_engine::path::CameraPath;
use vides_engine::scene::{
    Channel, Extrapolation, FollowPath, Interpolation, Kind, Light, Node, NodeState, Object, Scene,
    Track, Values, Warnings,
};

use super::*;
use crate::screenshots::screenshot;
use crate::space::cameras::Camera;
use crate::space::tests::{self as space, motion, press as press_at, release};
use crate::state::files::Purpose;
use crate::state::scene_view::{NewNode, NodeCommand};
use crate::tests::*;

pub(super) const LEFT: PointerButton = PointerButton::Primary;
pub(super) const NONE: Modifiers = Modifiers::NONE;

/// A camera on a path; a car with a wheel with a hub; a lamp that moves by keys; a box.
pub(in crate::scene_view) fn parts() -> Document {
    let mut camera = Node::new("camera", Kind::Camera(Default::default()));
    let follow = FollowPath::new(CameraPath::default(), 1.0, Extrapolation::Hold);
    camera.set_path(Some(follow.unwrap())).unwrap();
    let mut car = Node::new("car", Kind::Group);
    car.rest.position = DVec3::new(1.0, 2.0, 3.0);
    car.rest.rotation = DQuat::from_rotation_y(0.5);
    let inside = |name: &str, parent: usize| {
        let mut node = Node::new(name, Kind::Object(Object::default()));
        node.parent = Some(parent);
        node.rest.position = DVec3::new(0.1, 0.2, 0.3);
        node
    };
    let mut lamp = Node::new("lamp", Kind::Light(Light::Point));
    lamp.set_track(track(
        Channel::Position,
        &[1.0, 11.0],
        &[0.0, 0.0, 0.0, 1.0, 0.0, 0.0],
    ))
    .unwrap();
    let nodes = vec![
        camera,
        car,
        inside("wheel", 1),
        inside("hub", 2),
        lamp,
        Node::new("box", Kind::Object(Object::default())),
    ];
    let mut document = Document::new();
    let scene = Scene::from_nodes(nodes).unwrap();
    let edit = Edit::ReplaceScene(Box::new(scene));
    document.apply(edit).unwrap();
    document.as_opened()
}

pub(super) fn track(channel: Channel, frames: &[f64], values: &[f64]) -> Track {
    let by = match channel {
        Channel::Visible => Interpolation::Step,
        _ => Interpolation::Linear,
    };
    Track::new(channel, by, frames.into(), values.into(), Vec::new()).unwrap()
}

pub(in crate::scene_view) fn window_of_parts(language: Language) -> Window {
    let options = Options {
        document: parts(),
        ..options(language)
    };
    window_of(options, LARGE, 1.0, Theme::Dark)
}

pub(in crate::scene_view) fn scene_of(window: &Window) -> Scene {
    window.state().document().scene().unwrap()
}

pub(in crate::scene_view) fn names(window: &Window) -> Vec<String> {
    let scene = scene_of(window);
    scene.nodes().iter().map(|node| node.name.clone()).collect()
}

/// The rows as they are read, from top to bottom, without those of points.
pub(super) fn rows(window: &Window) -> Vec<String> {
    let rows = window.query_all(by().role(Role::ListItem));
    let rows = rows.map(|row| (row.rect().top(), row.accesskit_node().label().unwrap()));
    let points = window.state().texts().points_list.point;
    let point = points.split('{').next().unwrap();
    let mut rows: Vec<_> = rows
        .filter(|(_, label)| !label.starts_with(point))
        .collect();
    rows.sort_by(|a, b| a.0.total_cmp(&b.0));
    rows.into_iter().map(|(_, label)| label).collect()
}

/// A node's row.
pub(in crate::scene_view) fn row(window: &Window, name: &str) -> Pos2 {
    let node = scene_of(window).find(name).unwrap();
    let label = format!(
        "{name} {}",
        kind(window.state(), &scene_of(window).nodes()[node])
    );
    let row = window.get_by_role_and_label(Role::ListItem, &label);
    row.rect().center()
}

pub(in crate::scene_view) fn click_on(window: &mut Window, name: &str, held: Modifiers) {
    let at = row(window, name);
    window.event(Event::ModifiersChanged(held));
    press_at(window, at, LEFT);
    release(window, at, LEFT);
    window.event(Event::ModifiersChanged(NONE));
    // Two of them are no double click.
    window.run();
    for _ in 0..40 {
        window.step();
    }
}

pub(in crate::scene_view) fn drag(window: &mut Window, from: &str, to: Pos2) {
    let from = row(window, from);
    press_at(window, from, LEFT);
    motion(window, from + vec2(0.0, 8.0));
    motion(window, to);
    release(window, to, LEFT);
    window.run();
}

pub(in crate::scene_view) fn selected(window: &Window) -> Vec<String> {
    let scene = scene_of(window);
    let name = |&at: &usize| scene.nodes()[at].name.clone();
    window.state().selected_nodes().iter().map(name).collect()
}

pub(in crate::scene_view) fn world(scene: &Scene, name: &str) -> DAffine3 {
    let mut states = vec![NodeState::default(); scene.nodes().len()];
    let first = scene.frame_range().0;
    scene
        .evaluate(first, &mut states, &mut Warnings::default())
        .unwrap();
    states[scene.find(name).unwrap()].world()
}

pub(in crate::scene_view) fn pick(window: &mut Window, entry: &str) {
    open_menu(window, 1);
    click(window, entry);
}

/// One step makes a scene of a path, and one undo makes it the path again.
#[test]
fn what_is_added_first_makes_a_scene_of_a_path() {
    for language in BOTH {
        let (menu, texts) = (&language.texts().menu, &language.texts().scene);
        let mut window = window(language);
        let before = window.state().document().path().clone();
        let (seen, _) = window.state().view().unwrap();
        for (entry, stem) in [
            (menu.add_light, texts.light),
            (menu.add_camera, texts.camera),
            (menu.add_group, texts.group),
        ] {
            pick(&mut window, entry);
            let scene = scene_of(&window);
            let name = match scene.nodes()[0].name == stem {
                true => format!("{stem} 2"),
                false => stem.to_owned(),
            };
            assert_eq!(names(&window), ["camera", name.as_str()]);
            assert_eq!(selected(&window), [name.as_str()]);
            assert_eq!(scene.nodes()[0].path().unwrap().path(), &before);
            assert!(scene.nodes()[1].parent.is_none());
            let step = window.state().document().step_names()[0];
            assert_eq!(step, Some(StepName::AddNodes));
            // The picture is that of before, since its camera is the first on a path.
            assert_eq!(window.state().view().unwrap().0, seen);
            pick(&mut window, entry);
            assert!(names(&window)[2].starts_with(&format!("{stem} ")));
            press(&mut window, Modifiers::CTRL, Key::Z);
            press(&mut window, Modifiers::CTRL, Key::Z);
            assert!(window.state().document().edited_scene().is_none());
            assert_eq!(window.state().document().path(), &before);
            assert!(!window.state().document().can_undo());
            assert!(window.query_by_label(texts.below).is_none());
        }
    }
}

#[test]
fn a_light_stands_high_in_the_space_and_a_camera_sees_what_is_seen() {
    for language in BOTH {
        let menu = &language.texts().menu;
        let mut window = window_with_points(language, LARGE, 1.0, Theme::Dark);
        let space = vides_engine::path::Space {
            centre: DVec3::new(10.0, -3.0, 2.0),
            half_size: 4.0,
            up: vides_engine::path::Up::Z,
        };
        window.state_mut().edit(Edit::SetSpace { space, fit: true });
        window.state_mut().set_frame(17.5).unwrap();
        window.run();
        let (seen, _) = window.state().view().unwrap();
        pick(&mut window, menu.add_light);
        let light = scene_of(&window).nodes()[1].clone();
        assert_eq!(light.kind, Kind::Light(Light::Point));
        assert_eq!(light.rest.position, DVec3::new(10.0, -3.0, 5.0));
        assert_eq!(window.state().frame().unwrap(), 17.5);
        // What is new is named by F2 at once, which has no curve to change here.
        press(&mut window, NONE, Key::F2);
        assert!(window.state().windows.curve.is_none());
        window.event(Event::Text("sun".to_owned()));
        window.run();
        press(&mut window, NONE, Key::Enter);
        assert_eq!(scene_of(&window).nodes()[1].name, "sun");
        pick(&mut window, menu.add_camera);
        let scene = scene_of(&window);
        let mut states = vec![NodeState::default(); 3];
        scene
            .evaluate(17.5, &mut states, &mut Warnings::default())
            .unwrap();
        let pose = states[2].pose;
        let pairs = pose.vrp.iter().chain(&pose.vpn).chain(&pose.vup);
        let wanted = seen.vrp.iter().chain(&seen.vpn).chain(&seen.vup);
        for (got, wanted) in pairs.zip(wanted) {
            assert!((got - wanted).abs() < 1e-12, "{pose:?} {seen:?}");
        }
        assert_eq!(pose.zoom, seen.zoom);
        // One that has flown counts.
        let flown = Camera {
            position: DVec3::new(1.0, 2.0, 3.0),
            view: DVec3::NEG_X,
            up: DVec3::Z,
            zoom: 50.0,
        };
        window.state_mut().fly(Some(flown));
        pick(&mut window, menu.add_camera);
        let rest = scene_of(&window).nodes()[3].rest;
        assert_eq!((rest.position, rest.zoom), (flown.position, 50.0));
        assert!((rest.rotation * DVec3::Z - flown.view).length() < 1e-12);
        assert!((rest.rotation * DVec3::Y - flown.up).length() < 1e-12);
    }
}

#[test]
fn an_object_comes_from_a_file() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("crate.obj");
    std::fs::write(&file, "v 7 0 0\nv 8 0 0\nv 7 1 0\nf 1 2 3\n").unwrap();
    let broken = folder.path().join("broken.obj");
    std::fs::write(&broken, "v 7 0\n").unwrap();
    for language in BOTH {
        let texts = language.texts();
        let mut window = window(language);
        pick(&mut window, texts.menu.add_object);
        assert!(window.query_by_label(texts.files.add_object).is_some());
        screenshot(&mut window, &format!("add-object-{language:?}.png"));
        let revision = window.state().document().revision();
        let choose = |window: &mut Window, file: &Path| {
            window.state_mut().file_chosen(Purpose::AddObject, file);
            window.run();
        };
        choose(&mut window, &broken);
        assert!(window.state().message.as_ref().unwrap().error);
        assert!(window.state().windows.files.is_some());
        assert_eq!(window.state().document().revision(), revision);
        choose(&mut window, &file);
        assert!(window.state().windows.files.is_none());
        choose(&mut window, &file);
        assert_eq!(names(&window), ["camera", "crate", "crate 2"]);
        assert_eq!(selected(&window), ["crate 2"]);
        let scene = scene_of(&window);
        let object = scene.object(1).unwrap();
        assert_eq!(object.mesh().points[0], DVec3::new(7.0, 0.0, 0.0));
        assert_eq!(object.source().unwrap().file, file.display().to_string());
        assert_eq!(scene.nodes()[1].rest, Values::default());
        let text = window
            .state()
            .document()
            .to_toml_for(&folder.path().join("a.vid"));
        assert!(text.unwrap().contains("file = \"crate.obj\""));
        for _ in 0..2 {
            press(&mut window, Modifiers::CTRL, Key::Z);
        }
        assert!(window.state().document().edited_scene().is_none());
    }
}

#[test]
fn the_list_is_a_tree_that_folds() {
    for language in BOTH {
        let texts = &language.texts().scene;
        let mut window = window_of_parts(language);
        let (group, object) = (texts.group, texts.object);
        let all = [
            format!("camera {}", texts.camera),
            format!("car {group}"),
            format!("wheel {object}"),
            format!("hub {object}"),
            format!("lamp {}", texts.light),
            format!("box {object}"),
        ];
        assert_eq!(rows(&window), all);
        click(&mut window, &fill(texts.fold, &[&"car"]));
        let folded = [&all[..2], &all[4..]].concat();
        assert_eq!(rows(&window), folded);
        // A node in it that becomes current elsewhere is seen.
        window.state_mut().select_nodes(vec![3]);
        window.run();
        assert_eq!(rows(&window), all);
        assert!(!window.state().document().is_modified());
    }
}

#[test]
fn clicks_and_arrows_select_without_a_step() {
    let mut window = window_of_parts(Language::English);
    click_on(&mut window, "box", NONE);
    assert_eq!(selected(&window), ["box"]);
    click_on(&mut window, "wheel", Modifiers::SHIFT);
    assert_eq!(selected(&window), ["box", "wheel", "hub", "lamp"]);
    click_on(&mut window, "hub", Modifiers::CTRL);
    assert_eq!(selected(&window), ["box", "wheel", "lamp"]);
    click_on(&mut window, "car", Modifiers::CTRL);
    assert_eq!(selected(&window), ["car", "box", "wheel", "lamp"]);
    press(&mut window, NONE, Key::ArrowDown);
    assert_eq!(selected(&window), ["wheel"]);
    press(&mut window, NONE, Key::ArrowLeft);
    assert_eq!(rows(&window).len(), 5);
    press(&mut window, NONE, Key::ArrowLeft);
    assert_eq!(selected(&window), ["car"]);
    press(&mut window, NONE, Key::ArrowRight);
    press(&mut window, NONE, Key::ArrowRight);
    assert_eq!(selected(&window), ["wheel"]);
    press(&mut window, NONE, Key::ArrowUp);
    assert_eq!(selected(&window), ["car"]);
    press(&mut window, Modifiers::CTRL, Key::A);
    assert_eq!(window.state().selected_nodes().len(), 6);
    assert_eq!(selected(&window)[0], "car");
    assert!(!window.state().document().is_modified());
    // A node on a path brings its panels.
    click_on(&mut window, "camera", NONE);
    assert!(window.state().document().edits_path());
    click(&mut window, Language::English.texts().scene.below);
    assert!(!window.state().document().edits_path());
    assert_eq!(selected(&window), [""; 0]);
}

#[test]
fn a_name_is_typed_in_its_row() {
    for language in BOTH {
        // Passes are short enough for a double click.
        let editor = space::editor(parts(), language);
        let mut window = space::window(editor, LARGE.into(), 1.0);
        let before = names(&window);
        click(&mut window, &fill(language.texts().scene.fold, &[&"wheel"]));
        click_on(&mut window, "wheel", NONE);
        press(&mut window, NONE, Key::F2);
        assert!(window.state().windows.curve.is_none(), "F2 is the list's");
        screenshot(&mut window, &format!("scene-name-{language:?}.png"));
        window.event(Event::Text("tyre".to_owned()));
        window.run();
        press(&mut window, NONE, Key::Enter);
        assert_eq!(names(&window)[2], "tyre");
        assert_eq!(rows(&window).len(), 5, "it stays folded");
        // The list has the keyboard again; what another node is called is refused.
        press(&mut window, NONE, Key::F2);
        window.event(Event::Text("box".to_owned()));
        window.run();
        press(&mut window, NONE, Key::Enter);
        assert_eq!(names(&window)[2], "tyre");
        let told = said(&window).unwrap();
        assert!(told.contains("box"), "{told}");
        press(&mut window, Modifiers::CTRL, Key::Z);
        assert_eq!(names(&window), before);
        assert!(!window.state().document().is_modified());
        // By a double click; Escape leaves the name.
        let at = row(&window, "box");
        for _ in 0..2 {
            press_at(&mut window, at, LEFT);
            release(&mut window, at, LEFT);
        }
        window.run();
        let field = language.texts().scene.name;
        assert!(window.query_by_label(field).is_some());
        window.event(Event::Text("x".to_owned()));
        window.run();
        press(&mut window, NONE, Key::Escape);
        assert!(window.query_by_label(field).is_none());
        // None at all is refused, too.
        press(&mut window, NONE, Key::F2);
        press(&mut window, NONE, Key::Delete);
        press(&mut window, NONE, Key::Enter);
        let told = fill(language.texts().scene.needs_name, &[&"box"]);
        assert_eq!(said(&window), Some(told));
        assert_eq!(names(&window), before);
        assert!(!window.state().document().is_modified());
    }
}

#[test]
fn a_row_dragged_onto_another_is_put_into_it() {
    for language in BOTH {
        let texts = &language.texts().scene;
        let mut window = window_of_parts(language);
        let before = scene_of(&window);
        let parent = |window: &Window, name: &str| {
            let scene = scene_of(window);
            let at = scene.nodes()[scene.find(name).unwrap()].parent;
            at.map(|at| scene.nodes()[at].name.clone())
        };
        // What rests keeps its place in the world.
        let to = row(&window, "car");
        drag(&mut window, "box", to);
        assert_eq!(parent(&window, "box").as_deref(), Some("car"));
        let (was, is) = (world(&before, "box"), world(&scene_of(&window), "box"));
        assert!((was.translation - is.translation).length() < 1e-12);
        assert!(
            (was.matrix3 - is.matrix3)
                .to_cols_array()
                .iter()
                .all(|x| x.abs() < 1e-12)
        );
        let there = scene_of(&window).nodes()[5].rest.position;
        assert!(there.length() > 1.0, "its numbers are others");
        // Of what moves it is asked: it keeps its way, or its numbers, which is told.
        let to = row(&window, "car");
        drag(&mut window, "lamp", to);
        assert_eq!(parent(&window, "lamp"), None);
        screenshot(&mut window, &format!("another-parent-{language:?}.png"));
        click(&mut window, texts.keep_way);
        assert_eq!(parent(&window, "lamp").as_deref(), Some("car"));
        assert_eq!(said(&window), Some(fill(texts.keeps_way, &[&"lamp"])));
        let (was, is) = (world(&before, "lamp"), world(&scene_of(&window), "lamp"));
        assert!(was.abs_diff_eq(is, 1e-12));
        press(&mut window, Modifiers::CTRL, Key::Z);
        assert_eq!(parent(&window, "lamp"), None);
        let to = row(&window, "car");
        drag(&mut window, "lamp", to);
        click(&mut window, texts.go_along);
        assert_eq!(parent(&window, "lamp").as_deref(), Some("car"));
        assert_eq!(said(&window), Some(fill(texts.goes_along, &[&"lamp"])));
        let now = scene_of(&window);
        let (was, is) = (&before.nodes()[4], &now.nodes()[4]);
        assert_eq!((was.rest, was.keys()), (is.rest, is.keys()));
        // Into none.
        let whole = window.get_by_label(texts.below).rect().center();
        drag(&mut window, "wheel", whole);
        assert_eq!(parent(&window, "wheel"), None);
        assert_eq!(parent(&window, "hub").as_deref(), Some("wheel"));
        // A drag that ends beside the list does nothing.
        let now = scene_of(&window);
        let beside = egui::pos2(600.0, row(&window, "lamp").y);
        drag(&mut window, "wheel", beside);
        assert_eq!(scene_of(&window), now);
        // Nothing comes into what is in it.
        let to = row(&window, "lamp");
        drag(&mut window, "car", to);
        let told = said(&window).unwrap();
        assert!(told.contains("car") && told.contains("lamp"), "{told}");
        assert_eq!(scene_of(&window), now);
        for _ in 0..3 {
            press(&mut window, Modifiers::CTRL, Key::Z);
        }
        assert_eq!(scene_of(&window), before);
    }
}

#[test]
fn several_go_together_and_a_shear_is_refused() {
    let mut window = window_of_parts(Language::English);
    click_on(&mut window, "wheel", NONE);
    click_on(&mut window, "hub", Modifiers::CTRL);
    click_on(&mut window, "box", Modifiers::CTRL);
    let to = row(&window, "lamp");
    drag(&mut window, "box", to);
    let scene = scene_of(&window);
    let parents = scene.nodes().iter().map(|node| node.parent);
    assert_eq!(
        parents.collect::<Vec<_>>(),
        [None, None, Some(4), Some(2), None, Some(4)]
    );
    assert_eq!(
        window.state().document().step_names()[0],
        Some(StepName::NodeLinks)
    );
    press(&mut window, Modifiers::CTRL, Key::Z);
    assert!(!window.state().document().is_modified());
    // A turned one would be sheared by a scale that is not the same along all axes.
    let mut rest = vides_engine::scene::Rest::of(&scene_of(&window).nodes()[1]);
    rest.values.scale = DVec3::new(1.0, 3.0, 1.0);
    let mut turned = vides_engine::scene::Rest::of(&scene_of(&window).nodes()[5]);
    turned.values.rotation = DQuat::from_rotation_x(0.7);
    for (node, rest) in [(1, rest), (5, turned)] {
        let rest = Box::new(rest);
        let part = vides_engine::scene::Part::Rest { node, rest };
        window.state_mut().edit(Edit::Part(Box::new(part)));
    }
    window.run();
    let before = scene_of(&window);
    let to = row(&window, "car");
    click_on(&mut window, "hub", NONE);
    click_on(&mut window, "box", Modifiers::CTRL);
    drag(&mut window, "box", to);
    let told = said(&window).unwrap();
    assert!(told.contains("box"), "{told}");
    assert_eq!(scene_of(&window), before);
}

/// Delete, Ctrl-D and the clipboard's keys mean nodes here, and points elsewhere.
#[test]
fn keys_mean_nodes_where_the_list_has_the_keyboard() {
    for language in BOTH {
        let texts = &language.texts().scene;
        let mut window = window_of_parts(language);
        let before = scene_of(&window);
        click_on(&mut window, "car", NONE);
        press(&mut window, Modifiers::CTRL, Key::D);
        let all = names(&window);
        assert_eq!(all[6..], ["car 2", "wheel 2", "hub 2"]);
        assert_eq!(selected(&window), ["car 2"]);
        assert_eq!(scene_of(&window).nodes()[7].parent, Some(6));
        press(&mut window, Modifiers::CTRL, Key::Z);
        assert_eq!(scene_of(&window), before);
        click_on(&mut window, "wheel", NONE);
        press(&mut window, NONE, Key::Delete);
        assert_eq!(names(&window), ["camera", "car", "lamp", "box"]);
        assert_eq!(selected(&window), [""; 0]);
        press(&mut window, Modifiers::CTRL, Key::Z);
        assert_eq!(scene_of(&window), before);
        window.event(Event::Paste("no nodes".to_owned()));
        window.run();
        assert_eq!(said(&window).as_deref(), Some(texts.no_nodes));
        assert_eq!(scene_of(&window), before);
        // A copy of what is on a path is edited.
        click_on(&mut window, "camera", NONE);
        press(&mut window, Modifiers::CTRL, Key::D);
        let edited = window.state().document().edited_scene().unwrap().node();
        assert_eq!(
            (edited, selected(&window)),
            (Some(6), vec!["camera 2".to_owned()])
        );
        press(&mut window, Modifiers::CTRL, Key::Z);
        assert_eq!(scene_of(&window), before);
        // Several are, in the order in which they were.
        click_on(&mut window, "car", NONE);
        click_on(&mut window, "box", Modifiers::CTRL);
        press(&mut window, Modifiers::CTRL, Key::D);
        assert_eq!(selected(&window), ["box 2", "car 2"]);
        // Elsewhere Delete is the points'.
        let mut window = window_of_parts(language);
        click(&mut window, language.texts().position.add);
        let points = |window: &Window| window.state().document().path().points.len();
        let count = points(&window);
        press(&mut window, NONE, Key::Delete);
        assert_eq!(points(&window), count - 1);
        assert_eq!(names(&window).len(), 6);
    }
}

/// When nothing but one camera on a path is left, it is a path again.
#[test]
fn what_is_left_alone_is_a_path_again() {
    let mut window = window(Language::English);
    let before = window.state().document().path().clone();
    window
        .state_mut()
        .do_to_nodes(NodeCommand::Add(NewNode::Group));
    window.run();
    click_on(&mut window, "group", NONE);
    press(&mut window, NONE, Key::Delete);
    assert!(window.state().document().edited_scene().is_none());
    assert_eq!(window.state().document().path(), &before);
    assert!(window.state().document().edits_path());
}
