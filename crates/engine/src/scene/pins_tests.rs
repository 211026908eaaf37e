use super::*;
use crate::path::insertion::tests::random_path;
use crate::path::test_support::Random;
use crate::scene::{Camera, Extrapolation, Kind, Node};
use glam::DVec3;

/// The scene's frame in which a point of a path is reached: where its pose is first that of
/// the point.
fn reached(scene: &Scene, node: usize, point: usize) -> f64 {
    let follow = scene.nodes()[node].path().unwrap();
    let (first, last) = follow.first_and_last();
    let place = follow.path().points[point].position;
    let mut frame = first;
    while frame <= last {
        if DVec3::from_array(follow.pose(frame).unwrap().vrp) == place {
            return frame;
        }
        frame += 1.0;
    }
    panic!("point {point} is never reached");
}

fn scene_of(paths: Vec<CameraPath>) -> Scene {
    let mut scene = Scene::new();
    for (at, path) in paths.into_iter().enumerate() {
        let mut node = Node::new(&at.to_string(), Kind::Camera(Camera::default()));
        let follow = FollowPath::new(path, 1.0, Extrapolation::Hold).unwrap();
        node.set_path(Some(follow)).unwrap();
        scene.add(node).unwrap();
    }
    scene
}

/// A path along x of so many points, equally far from each other but for the last.
fn line(points: usize) -> CameraPath {
    let mut path = CameraPath::default();
    let like = path.points[0].clone();
    #[allow(clippy::cast_precision_loss)]
    let place = |at: usize| 0.1 * at as f64 + if at + 1 == points { 0.3 } else { 0.0 };
    path.points = (0..points)
        .map(|at| crate::path::SupportPoint {
            position: DVec3::new(place(at) - 0.9, 0.1, 0.2),
            ..like.clone()
        })
        .collect();
    path
}

#[test]
fn flights_meet_at_their_markers() {
    let mut scene = scene_of(vec![line(4), line(6)]);
    scene.set_marker("start", 11.0).unwrap();
    scene.set_marker("meet", 61.0).unwrap();
    scene.set_marker("end", 200.5).unwrap();
    for (node, points) in [(0, [0, 2, 3]), (1, [1, 3, 5])] {
        for (point, marker) in points.into_iter().zip(["start", "meet", "end"]) {
            scene.pin(node, point, Some(marker)).unwrap();
        }
        assert_eq!(reached(&scene, node, points[0]), 11.0);
        assert_eq!(reached(&scene, node, points[1]), 61.0);
        // The nearest frame.
        assert_eq!(reached(&scene, node, points[2]), 201.0);
    }
    // Equal ways share their frames equally.
    let frames = |at: usize| {
        let path = scene.nodes()[0].path().unwrap().path();
        path.points[at].orientations[0].own.frames
    };
    assert_eq!([frames(0), frames(1)], [25, 25]);
    // Another marker takes all along that is pinned to it.
    scene.set_marker("meet", 101.0).unwrap();
    assert_eq!([reached(&scene, 0, 2), reached(&scene, 1, 3)], [101.0; 2]);
    assert_eq!([reached(&scene, 0, 0), reached(&scene, 1, 1)], [11.0; 2]);
    // Another path holds the pins of the old one.
    let follow = FollowPath::new(line(5), 1.0, Extrapolation::Hold).unwrap();
    scene.set_path(0, Some(follow)).unwrap();
    assert_eq!(
        [reached(&scene, 0, 0), reached(&scene, 0, 2)],
        [11.0, 101.0]
    );
}

#[test]
fn what_cannot_be_held_is_refused_and_changes_nothing() {
    let mut scene = scene_of(vec![line(6), line(3)]);
    scene.set_marker("a", 10.0).unwrap();
    scene.set_marker("b", 13.0).unwrap();
    scene.pin(0, 1, Some("a")).unwrap();
    scene.pin(1, 0, Some("a")).unwrap();
    let before = scene.clone();
    let said = scene.pin(0, 5, Some("b")).unwrap_err().to_string();
    assert!(said.contains("at least 4"), "{said}");
    assert_eq!(scene, before);
    scene.pin(0, 4, Some("b")).unwrap();
    scene.pin(1, 1, Some("b")).unwrap();
    let before = scene.clone();
    for frame in [12.0, 10.0, 3.0] {
        let said = scene.set_marker("b", frame).unwrap_err().to_string();
        assert!(said.contains("node \"0\""), "{said}");
        assert_eq!(scene, before);
    }
    let mut long = line(3);
    long.points[1].orientations[0].hold = 2;
    let error = FollowPath::new(long, 1.0, Extrapolation::Hold).unwrap();
    scene.pin(1, 2, Some("b")).unwrap_err();
    assert!(scene.set_path(1, Some(error)).is_ok());
}

#[test]
fn a_scene_that_holds_its_pins_stays_as_it_is_to_the_last_bit() {
    let mut random = Random(77);
    let mut held = 0;
    for round in 0..2_000 {
        let mut path = random_path(&mut random, round);
        path.closed = false;
        let points = path.points.len();
        let mut scene = scene_of(vec![path]);
        let mut frame = 100.0 * random.unit() - 50.0;
        for point in (0..points).filter(|point| point % 2 == round % 2) {
            let name = format!("at {point}");
            scene.set_marker(&name, frame).unwrap();
            frame += 30.0 + (200.0 * random.unit()).floor();
            if scene.pin(0, point, Some(&name)).is_ok() {
                held += 1;
            }
        }
        let before = scene.clone();
        let follow = scene.nodes()[0].path().unwrap().clone();
        scene.set_path(0, Some(follow)).unwrap();
        assert_eq!(scene, before, "round {round}");
        let pins = before.pins_of(0, points).unwrap();
        let follow = before.nodes()[0].path().unwrap();
        let path = follow.path();
        for (point, frame) in pins {
            let after = follow.timeline(|timeline| frames_between(path, timeline, 0, point));
            #[allow(clippy::cast_precision_loss)]
            let reached = follow.start_frame() + after.unwrap() as f64;
            assert!((reached - frame).abs() <= 0.5 + 1e-9, "{reached} {frame}");
        }
    }
    assert!(held > 2_000, "{held}");
}
