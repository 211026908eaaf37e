//! What people do with scenes, by mouse and keyboard.

use vides_engine::scene::{NodeState, Scene, Warnings};

use super::hands::Hands;
use super::*;

fn states(scene: &Scene, frame: f64) -> Vec<NodeState> {
    let mut states = vec![NodeState::default(); scene.nodes().len()];
    let warnings = &mut Warnings::default();
    scene.evaluate(frame, &mut states, warnings).unwrap();
    states
}

/// A lamp moves along a path of its own while the camera flies as before.
#[test]
fn a_lamp_flies_beside_the_camera() {
    let mut hands = Hands::new(Options {
        document: some_points(),
        ..options(Language::English)
    });
    let flown = poses(hands.window.state());
    let texts = Language::English.texts();
    hands.add(texts.menu.add_light);
    hands.rename("lamp");
    hands.click(texts.node.by_path);
    hands.click(texts.node.points_tab);
    hands.number(&fill(texts.position.coordinate, &[&"y"]), "0.9");
    assert_eq!(hands.actions, 10);
    let scene = hands.scene();
    let [camera, lamp] = ["camera", "lamp"].map(|name| scene.find(name).unwrap());
    let mut way = 0.0;
    let mut before = None;
    for (at, pose) in flown.iter().enumerate() {
        let now = states(&scene, at as f64 + 1.0);
        assert_eq!(now[camera].pose, *pose, "frame {}", at + 1);
        let place = now[lamp].pose.position();
        way += before.map_or(0.0, |before: DVec3| place.distance(before));
        before = Some(place);
    }
    // From where it stood, 0.15 lower, half as far as a new path goes.
    assert!((way - 0.6_f64.hypot(0.15)).abs() < 1e-9, "{way}");
}

/// A tower is twisted more and more: by so many degrees from its foot to its top.
#[test]
fn a_tower_is_twisted_over_time() {
    let folder = tempfile::tempdir().unwrap();
    let corners = "v 1 0 0\nv 0 0 1\nv -1 0 0\nv 0 0 -1\nv 1 2 0\nv 0 2 1\nv -1 2 0\nv 0 2 -1\n";
    let sides = "f 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
    std::fs::write(folder.path().join("tower.obj"), format!("{corners}{sides}")).unwrap();
    let mut hands = Hands::new(options(Language::English));
    let texts = &Language::English.texts().node;
    hands.object(folder.path(), "tower.obj");
    hands.click(texts.add_deformation);
    hands.click(Language::English.tool("twist"));
    hands.number(texts.angle, "0");
    hands.diamond(texts.angle);
    hands.frame(101);
    hands.number(texts.angle, "90");
    let scene = hands.scene();
    let tower = scene.find("tower").unwrap();
    for (frame, expected) in [(1.0, 0.0), (51.0, 45.0), (101.0, 90.0), (120.0, 90.0)] {
        let warnings = &mut Warnings::default();
        let mut points = [DVec3::ZERO; 8];
        scene.vertices(tower, frame, &mut points, warnings).unwrap();
        let turned = |at: usize| points[at].x.atan2(points[at].z).to_degrees();
        for corner in 0..4 {
            let by = (turned(corner + 4) - turned(corner)).rem_euclid(360.0);
            let off = (by - expected).abs();
            assert!(off < 1e-9, "{by} at frame {frame}, not {expected}");
        }
    }
    assert_eq!(hands.actions, 10);
}

/// Another camera is shown, and what it sees at every frame is written.
#[test]
fn another_cameras_poses_are_written() {
    let folder = tempfile::tempdir().unwrap();
    let mut hands = Hands::new(options(Language::English));
    let texts = Language::English.texts();
    hands.add(texts.menu.add_camera);
    hands.rename("above");
    hands.place(["0", "1.5", "0"]);
    hands.choose(texts.node.aim_name, "camera");
    hands.choose(texts.scene.shown_camera, "above");
    hands.entry(2, texts.menu.export);
    hands.file(&folder.path().join("above.txt"));
    hands.click(texts.files.write);
    let written = std::fs::read_to_string(folder.path().join("above.txt")).unwrap();
    let scene = hands.scene();
    let above = scene.find("above").unwrap();
    assert_eq!(written.lines().count(), 121);
    for (at, line) in written.lines().enumerate() {
        let numbers: Vec<f64> = line.split(' ').map(|word| word.parse().unwrap()).collect();
        let pose = states(&scene, at as f64 + 1.0)[above].pose;
        let expected = [pose.vrp, pose.vpn, pose.vup].concat();
        for (written, expected) in numbers.iter().zip(expected) {
            assert!((written - expected).abs() < 6e-5, "{line}");
        }
        assert_eq!(numbers[..3], [0.0, 1.5, 0.0]);
    }
    assert_eq!(hands.actions, 19);
}
