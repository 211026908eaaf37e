//! The panels of a node, driven as a user drives them.

use vides_document::StepName;
use vides_engine::path::CameraPath;
use vides_engine::scene::{Extrapolation, FollowPath, Kind, Light, Mesh, Node, Object, Scene};

use super::*;
use crate::screenshots::screenshot;
use crate::state::files::Purpose;
use crate::state::scene_view::NodeCommand;
use crate::tests::*;

const CAMERA: usize = 0;
const BOX: usize = 1;
const LAMP: usize = 2;
const DRONE: usize = 3;

/// A camera, a box in a drone on a path, and a lamp.
fn scene() -> Scene {
    let mut scene = Scene::new();
    scene.set_range(Some((1.0, 101.0))).unwrap();
    let camera = Node::new("camera", Kind::Camera(Default::default()));
    scene.add(camera).unwrap();
    scene
        .add(Node::new("box", Kind::Object(Object::default())))
        .unwrap();
    let corner = |x, y| DVec3::new(x, y, 0.0);
    let mesh = Mesh {
        points: vec![corner(-0.1, 0.0), corner(0.1, 0.0), corner(0.0, 0.1)],
        triangles: vec![[0, 1, 2]],
        ..Mesh::default()
    };
    scene.set_mesh(BOX, mesh).unwrap();
    let lamp = Node::new("lamp", Kind::Light(Light::Directional));
    scene.add(lamp).unwrap();
    let mut drone = Node::new("drone", Kind::Group);
    let path = FollowPath::new(CameraPath::default(), 11.0, Extrapolation::Hold);
    drone.set_path(Some(path.unwrap())).unwrap();
    scene.add(drone).unwrap();
    scene
}

fn window_at(language: Language, node: usize, size: [f32; 2], theme: Theme) -> Window {
    let mut document = Document::new();
    let replace = Edit::ReplaceScene(Box::new(scene()));
    document.apply(replace).unwrap();
    let options = crate::Options {
        document: document.as_opened(),
        ..options(language)
    };
    let mut window = window_of(options, size, 1.0, theme);
    window.state_mut().select_nodes(vec![node]);
    window.run();
    window
}

/// So high that nothing has to be scrolled.
fn at(language: Language, node: usize) -> Window {
    window_at(language, node, [1200.0, 1200.0], Theme::Dark)
}

fn node(window: &Window, at: usize) -> Node {
    window.state().document.scene().unwrap().nodes()[at].clone()
}

fn diamond_of(window: &mut Window, name: &str) {
    let label = fill(window.state().texts().node.key_of, &[&name]);
    window.get_by_role_and_label(Role::CheckBox, &label).click();
    window.run();
}

fn choose(window: &mut Window, name: &str, entry: &str) {
    window.get_by_role_and_label(Role::ComboBox, name).click();
    window.run();
    let all = window.get_all_by_role_and_label(Role::Button, entry);
    all.last().unwrap().click();
    window.run();
}

#[test]
fn pictures_of_the_panels() {
    for (language, theme, name) in [
        (Language::German, Theme::Dark, "de-dark"),
        (Language::English, Theme::Light, "en-light"),
    ] {
        for (size, large) in [(LARGE, "large"), (SMALL, "small")] {
            for (node, of) in [
                (CAMERA, "camera"),
                (BOX, "box"),
                (LAMP, "lamp"),
                (DRONE, "drone"),
            ] {
                let mut window = window_at(language, node, size, theme);
                let editor = window.state_mut();
                editor.scene_view.shows_node = true;
                if node == BOX {
                    editor.switch_key(node, &Channel::Position);
                    editor.switch_key(node, &Channel::Rotation);
                    let twist = vides_engine::deform::Deformation::new("twist", &[1.0, 30.0]);
                    let part = Part::InsertDeformation {
                        node,
                        at: 0,
                        deformation: twist.unwrap(),
                        bounds: None,
                    };
                    assert!(editor.edit(Edit::Part(Box::new(part))));
                    editor.set_frame(30.0).unwrap();
                    editor.switch_key(node, &Channel::Rotation);
                }
                window.run();
                screenshot(&mut window, &format!("node-{of}-{large}-{name}.png"));
            }
        }
    }
}

#[test]
fn a_long_name_and_a_menu_of_nodes_fit() {
    for size in [LARGE, SMALL] {
        let mut window = window_at(Language::German, LAMP, size, Theme::Dark);
        let name = "a lamp with a very long name, longer than any panel".to_owned();
        let part = Part::Name { node: LAMP, name };
        window.state_mut().edit(Edit::Part(Box::new(part)));
        let links = Part::Links {
            node: BOX,
            parent: Some(LAMP),
            aim: None,
        };
        window.state_mut().edit(Edit::Part(Box::new(links)));
        window.run();
        screenshot(&mut window, &format!("node-long-{}.png", size[0]));
        let heading = window.get_by_label_contains("…: Licht");
        assert!(heading.rect().right() <= size[0]);
        window.state_mut().select_nodes(vec![BOX]);
        window.run();
        let texts = &Language::German.texts().node;
        let menu = window.get_by_role_and_label(Role::ComboBox, texts.parent_name);
        let right = menu.rect().right();
        menu.click();
        window.run();
        screenshot(&mut window, &format!("node-menu-{}.png", size[0]));
        // None, and all but itself; nothing lies beyond the window.
        for name in [texts.no_parent, "camera", "drone"] {
            let all = window.get_all_by_role_and_label(Role::Button, name);
            let entry = all.last().unwrap().rect();
            assert!(entry.right() <= size[0] && right <= size[0], "{entry:?}");
        }
    }
}

#[test]
fn values_are_typed_and_keys_are_clicked() {
    for language in BOTH {
        let texts = &language.texts().node;
        let mut window = at(language, BOX);
        window.state_mut().set_frame(20.0).unwrap();
        window.run();
        let x = format!("{} x", texts.position);
        enter(&mut window, &x, "0.25");
        assert_eq!(node(&window, BOX).rest.position.x, 0.25);
        diamond_of(&mut window, texts.position);
        window.state_mut().set_frame(40.0).unwrap();
        window.run();
        enter(&mut window, &x, "0.75");
        let track = node(&window, BOX).keys().track(&Channel::Position).cloned();
        let track = track.unwrap();
        assert_eq!(track.frames(), [20.0, 40.0]);
        assert_eq!((track.values()[0], track.values()[3]), (0.25, 0.75));
        window.state_mut().set_frame(30.0).unwrap();
        window.run();
        let half = language.number(0.5, 3);
        assert_eq!(value(&window, &x), half);
        let yaw = texts.yaw.to_owned();
        enter(&mut window, &yaw, "90");
        let turned = node(&window, BOX).rest.rotation;
        let quarter = glam::DQuat::from_rotation_y(std::f64::consts::FRAC_PI_2);
        assert!(turned.dot(quarter).abs() > 1.0 - 1e-15);
        let pivot = format!("{} y", texts.pivot);
        enter(&mut window, &pivot, "0.1");
        assert_eq!(node(&window, BOX).pivot.y, 0.1);
        click(&mut window, texts.visible);
        assert!(!node(&window, BOX).rest.visible);
        // Each was one step.
        let mut steps = 0;
        while window.state_mut().document.undo() {
            steps += 1;
        }
        assert_eq!(steps, 6);
        let scene = window.state().document.scene().unwrap();
        assert_eq!(scene.nodes(), self::scene().nodes());
    }
}

/// A turn beyond the pole would have other angles, which would jump while it is dragged.
#[test]
fn a_pitch_is_dragged_up_to_the_pole() {
    let mut window = at(Language::English, BOX);
    let texts = &Language::English.texts().node;
    let name = texts.pitch.to_owned();
    drag(&mut window, &name, 40, 8.0);
    let angles = crate::scene_view::values::angles_of(node(&window, BOX).rest.rotation);
    assert!((angles[1] - 90.0).abs() < 1e-6, "{angles:?}");
    drag(&mut window, &name, 4, -5.0);
    let angles = crate::scene_view::values::angles_of(node(&window, BOX).rest.rotation);
    assert!((75.0..85.0).contains(&angles[1]), "{angles:?}");
    assert!(angles[0].abs() + angles[2].abs() < 1e-6, "{angles:?}");
    enter(&mut window, &name, "120");
    assert!(said(&window).unwrap().contains("90"));
}

/// Drags a number to the right by so many steps.
fn drag(window: &mut Window, name: &str, steps: u8, step: f32) {
    let from = number(window, name).rect().center();
    window.hover_at(from);
    window.run();
    window.drag_at(from);
    window.run();
    for at in 1..=steps {
        window.hover_at(from + vec2(step * f32::from(at), 0.0));
        window.run();
    }
    window.drop_at(from + vec2(step * f32::from(steps), 0.0));
    window.run();
}

/// A drag at a track makes one key, and is one step, whatever it passes.
#[test]
fn a_drag_is_one_step() {
    let mut window = at(Language::English, BOX);
    let texts = &Language::English.texts().node;
    window.state_mut().switch_key(BOX, &Channel::Scale);
    window.state_mut().set_frame(40.0).unwrap();
    window.run();
    let name = format!("{} x", texts.scale);
    drag(&mut window, &name, 8, 5.0);
    let track = node(&window, BOX).keys().track(&Channel::Scale).cloned();
    let track = track.unwrap();
    assert_eq!(track.frames().len(), 2);
    assert!(track.values()[3] > 1.05, "{:?}", track.values());
    assert!(window.state_mut().document.undo());
    let track = node(&window, BOX).keys().track(&Channel::Scale).cloned();
    assert_eq!(track.unwrap().frames().len(), 1);
}

#[test]
fn parents_and_aims_are_chosen_and_refused_in_words() {
    for language in BOTH {
        let texts = &language.texts().node;
        let mut window = at(language, BOX);
        choose(&mut window, texts.parent_name, "lamp");
        assert_eq!(node(&window, BOX).parent, Some(LAMP));
        window.state_mut().select_nodes(vec![LAMP]);
        window.run();
        // What is in it is not offered, and refused.
        click(&mut window, texts.parent_name);
        assert!(window.query_by_label("drone").is_some());
        assert!(window.query_by_label("box").is_none());
        press(&mut window, Modifiers::NONE, Key::Escape);
        let put = NodeCommand::PutInto(vec![LAMP], Some(BOX));
        window.state_mut().do_to_nodes(put);
        window.run();
        assert_eq!(node(&window, LAMP).parent, None);
        let said = said(&window).unwrap();
        assert!(said.contains("lamp") && said.contains("box"), "{said}");
        choose(&mut window, texts.aim_name, "drone");
        assert_eq!(node(&window, LAMP).aim, Some(DRONE));
        assert!(
            window
                .query_by_role_and_label(Role::SpinButton, texts.aim_weight)
                .is_some()
        );
        choose(&mut window, texts.aim_name, texts.no_aim);
        assert_eq!(node(&window, LAMP).aim, None);
        // Of one that moves it is asked.
        window.state_mut().select_nodes(vec![DRONE]);
        window.run();
        click(&mut window, texts.node_tab);
        choose(&mut window, texts.parent_name, "camera");
        assert_eq!(node(&window, DRONE).parent, None);
        click(&mut window, language.texts().scene.go_along);
        assert_eq!(node(&window, DRONE).parent, Some(CAMERA));
        let goes_along = language.texts().scene.goes_along;
        assert_eq!(
            crate::tests::said(&window),
            Some(fill(goes_along, &[&"drone"]))
        );
    }
}

#[test]
fn each_kind_has_its_own() {
    let texts = &Language::English.texts().node;
    let mut window = at(Language::English, CAMERA);
    enter(&mut window, texts.zoom, "50");
    enter(&mut window, texts.near, "0.5");
    assert_eq!(node(&window, CAMERA).rest.zoom, 50.0);
    let Kind::Camera(planes) = node(&window, CAMERA).kind else {
        panic!("a camera")
    };
    assert_eq!((planes.near, planes.far), (0.5, 1000.0));
    // Nearer than nearest is refused.
    enter(&mut window, texts.far, "0.1");
    assert!(said(&window).is_some());
    window.state_mut().select_nodes(vec![LAMP]);
    window.run();
    let inner = format!("{} {}", texts.cone, texts.inner);
    let cone = |window: &Window| {
        let found = window.query_by_role_and_label(Role::SpinButton, &inner);
        found.is_some()
    };
    assert!(!cone(&window));
    click(&mut window, texts.spot);
    assert_eq!(node(&window, LAMP).kind, Kind::Light(Light::Spot));
    assert!(cone(&window));
    enter(&mut window, &inner, "12");
    assert_eq!(node(&window, LAMP).rest.cone, [12.0, 30.0]);
    enter(&mut window, texts.intensity, "3");
    enter(&mut window, &format!("{} R", texts.colour), "0.5");
    let rest = node(&window, LAMP).rest;
    assert_eq!((rest.intensity, rest.colour), (3.0, [0.5, 1.0, 1.0]));
}

#[test]
fn deformations_come_move_and_go() {
    for language in BOTH {
        let texts = &language.texts().node;
        let mut window = at(language, BOX);
        let kinds = |window: &Window| {
            let Kind::Object(object) = node(window, BOX).kind else {
                panic!("an object")
            };
            let all = object.deformations().iter();
            all.map(|(of, _)| (of.kind(), of.parameters()[0]))
                .collect::<Vec<_>>()
        };
        for kind in ["twist", "bend"] {
            click(&mut window, texts.add_deformation);
            click(&mut window, language.tool(kind));
        }
        // It is longest along x: the one twists along that, the other bends it about z.
        assert_eq!(kinds(&window), [("twist", 0.0), ("bend", 2.0)]);
        let second = format!("2. {}", language.tool("bend"));
        click(&mut window, &fill(texts.earlier, &[&second]));
        assert_eq!(kinds(&window), [("bend", 2.0), ("twist", 0.0)]);
        let first = format!("1. {}", language.tool("bend"));
        click(&mut window, &fill(texts.axis, &[&first]));
        assert_eq!(kinds(&window), [("bend", 0.0), ("twist", 0.0)]);
        click(&mut window, &fill(texts.remove_deformation, &[&first]));
        assert_eq!(kinds(&window), [("twist", 0.0)]);
        enter(&mut window, texts.angle, "45");
        diamond_of(&mut window, texts.angle);
        let angle = Channel::Deformation {
            at: 0,
            parameter: "angle".to_owned(),
        };
        let track = node(&window, BOX).keys().track(&angle).cloned();
        assert_eq!(track.unwrap().values(), [45.0]);
    }
}

#[test]
fn what_moves_a_node_is_chosen() {
    for language in BOTH {
        let texts = &language.texts().node;
        let mut window = at(language, DRONE);
        let mut info = window.state().document.info().clone();
        info.first_frame = 101;
        window.state_mut().edit(Edit::SetInfo(Box::new(info)));
        window.run();
        // At first the path's points, as ever.
        assert!(window.query_by_label(texts.path_to_keys).is_none());
        click(&mut window, texts.node_tab);
        // As people count.
        assert_eq!(value(&window, texts.start), "111");
        enter(&mut window, texts.start, "121");
        let start = |window: &Window| node(window, DRONE).path().map(FollowPath::start_frame);
        assert_eq!(start(&window), Some(21.0));
        choose(&mut window, texts.beyond_name, texts.pingpong);
        let beyond = node(&window, DRONE).path().map(FollowPath::extrapolation);
        assert_eq!(beyond, Some(Extrapolation::PingPong));
        let before = window.state().document.scene().unwrap();
        click(&mut window, texts.path_to_keys);
        assert_eq!(said(&window).as_deref(), Some(texts.became_keys));
        let after = window.state().document.scene().unwrap();
        assert!(after.nodes()[DRONE].path().is_none());
        assert_eq!(window.state().current_node(), Some(DRONE));
        for frame in [21.0, 30.0, 60.0] {
            let place = |scene: &Scene| {
                let warnings = &mut vides_engine::scene::Warnings::default();
                scene
                    .value(DRONE, &Channel::Position, frame, warnings)
                    .unwrap()
            };
            let (a, b) = (place(&before), place(&after));
            for (a, b) in a.into_iter().zip(b) {
                assert!((a - b).abs() < 1e-12);
            }
        }
        // And back, as near as asked, which is told; then few keys.
        enter(&mut window, texts.nearness, "0.01");
        enter(&mut window, texts.nearness_angle, "2");
        click(&mut window, texts.keys_to_path);
        let points = node(&window, DRONE).path().unwrap().path().points.len();
        let told = said(&window).unwrap();
        assert!(told.contains(&points.to_string()), "{told}");
        window.state_mut().select_nodes(vec![DRONE]);
        click(&mut window, texts.few_keys);
        let tracks = node(&window, DRONE).keys().tracks().clone();
        let keys: usize = tracks.iter().map(|track| track.frames().len()).sum();
        assert!(said(&window).unwrap().starts_with(&keys.to_string()));
        assert!(keys < 40, "{keys}");
        click(&mut window, texts.none);
        assert!(node(&window, DRONE).keys().tracks().is_empty());
        click(&mut window, texts.by_path);
        assert!(node(&window, DRONE).path().is_some());
        assert_eq!(
            window.state().document.edited_scene().unwrap().node(),
            Some(DRONE)
        );
        assert_eq!(
            window.state().document.step_names()[0],
            Some(StepName::Motion)
        );
    }
}

#[test]
fn k_sets_keys_unless_a_text_is_typed() {
    let mut window = at(Language::English, BOX);
    press(&mut window, Modifiers::NONE, Key::K);
    assert_eq!(node(&window, BOX).keys().tracks().len(), 3);
    let texts = &Language::English.texts().node;
    type_into(&mut window, &format!("{} x", texts.position), "0.5");
    window.state_mut().set_frame(50.0).unwrap();
    press(&mut window, Modifiers::NONE, Key::K);
    let track = node(&window, BOX).keys().track(&Channel::Scale).cloned();
    assert_eq!(track.unwrap().frames().len(), 1);
    // What a path moves has no keys, which is told.
    window.state_mut().select_nodes(vec![DRONE]);
    let before = window.state().document.revision();
    press(&mut window, Modifiers::NONE, Key::K);
    assert!(said(&window).unwrap().contains("drone"));
    assert_eq!(window.state().document.revision(), before);
    // A path is no scene: nothing happens.
    let mut window = crate::tests::window(Language::English);
    let before = window.state().document.revision();
    press(&mut window, Modifiers::NONE, Key::K);
    assert_eq!(window.state().document.revision(), before);
    assert_eq!(said(&window), None);
    assert!(window.query_by_label(texts.node_tab).is_none());
}

#[test]
fn meshes_and_shapes_come_from_files() {
    for language in BOTH {
        let texts = &language.texts().node;
        let folder = tempfile::tempdir().unwrap();
        let file = |name: &str, text: &str| {
            let file = folder.path().join(name);
            std::fs::write(&file, text).unwrap();
            file
        };
        let first = file("first.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        let other = file("other.obj", "v 0 0 0\nv 2 0 0\nv 0 1 0\nf 1 2 3\n");
        let larger = file(
            "larger.obj",
            "v 0 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 1\nf 1 2 3\n",
        );
        let mut window = at(language, BOX);
        let object = |window: &Window| match node(window, BOX).kind {
            Kind::Object(object) => object,
            _ => panic!("an object"),
        };
        click(&mut window, texts.load);
        assert!(window.query_by_label(texts.mesh_title).is_some());
        window
            .state_mut()
            .file_chosen(Purpose::LoadMesh(BOX), &first);
        window.run();
        assert_eq!(object(&window).mesh().points[1].x, 1.0);
        let name = object(&window).source().unwrap().file.clone();
        assert_eq!(std::path::Path::new(&name), first);
        // Another program writes it.
        file("first.obj", "v 0 0 0\nv 3 0 0\nv 0 1 0\nf 1 2 3\n");
        click(&mut window, texts.reload);
        assert_eq!(object(&window).mesh().points[1].x, 3.0);
        // Again: it is read when the window gets the keyboard.
        let look = |window: &mut Window| {
            window.event(egui::Event::WindowFocused(true));
            window.run();
        };
        look(&mut window);
        for (text, x) in [("4.25", 4.25), ("3", 3.0)] {
            let text = format!("v 0 0 0\nv {text} 0 0\nv 0 1 0\nf 1 2 3\n");
            file("first.obj", &text);
            look(&mut window);
            assert_eq!(object(&window).mesh().points[1].x, x);
        }
        let choose = |window: &mut Window, file| {
            window
                .state_mut()
                .file_chosen(Purpose::LoadShape(BOX), file);
            window.run();
        };
        choose(&mut window, &other);
        assert_eq!(object(&window).shapes()[0].name, "other");
        assert_eq!(object(&window).weights(), [0.0]);
        // One of another number of points is refused in words.
        choose(&mut window, &larger);
        assert_eq!(object(&window).shapes().len(), 1);
        assert!(said(&window).unwrap().contains("larger.obj"));
        enter(&mut window, &fill(texts.weight, &[&"other"]), "0.5");
        assert_eq!(object(&window).weights(), [0.5]);
        // A mesh that is gone is told, and the one that was there stays.
        std::fs::remove_file(&first).unwrap();
        look(&mut window);
        assert_eq!(said(&window), Some(fill(texts.mesh_gone, &[&"first.obj"])));
        assert_eq!(object(&window).mesh().points[1].x, 3.0);
        click(&mut window, texts.reload);
        assert!(said(&window).unwrap().contains("first.obj"));
        assert_eq!(object(&window).mesh().points[1].x, 3.0);
        click(&mut window, &fill(texts.remove_shape, &[&"other"]));
        assert!(object(&window).shapes().is_empty());
    }
}
