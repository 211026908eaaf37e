use super::*;
use crate::path::CameraPath;
use crate::scene::{Camera, Channel, Extrapolation, FollowPath, Interpolation, Node, Track};

fn camera(name: &str) -> Node {
    Node::new(name, Kind::Camera(Camera::default()))
}

fn follow(start: f64) -> Option<FollowPath> {
    Some(FollowPath::new(CameraPath::default(), start, Extrapolation::Hold).unwrap())
}

fn keys(frames: &[f64]) -> Track {
    let values = vec![1.0; frames.len()];
    Track::new(
        Channel::parse("roll").unwrap(),
        Interpolation::Linear,
        frames.to_vec(),
        values,
        Vec::new(),
    )
    .unwrap()
}

/// A group, two cameras of which the second follows a path, and one more.
fn scene() -> Scene {
    let mut scene = Scene::new();
    scene.add(Node::new("group", Kind::Group)).unwrap();
    for name in ["still", "moving", "other"] {
        scene.add(camera(name)).unwrap();
    }
    scene.set_path(2, follow(5.0)).unwrap();
    scene
}

#[test]
fn the_camera_shown_is_the_chosen_one_else_the_first_on_a_path_else_the_first() {
    let mut scene = scene();
    assert_eq!((scene.camera(), scene.shown_camera()), (None, Some(2)));
    scene.set_path(2, None).unwrap();
    assert_eq!(scene.shown_camera(), Some(1));
    scene.set_camera(Some(3)).unwrap();
    scene.set_path(2, follow(5.0)).unwrap();
    assert_eq!((scene.camera(), scene.shown_camera()), (Some(3), Some(3)));
    let said = |result: Result<()>| result.unwrap_err().to_string();
    assert_eq!(said(scene.set_camera(Some(0))), "\"group\" is no camera");
    assert!(said(scene.set_camera(Some(4))).contains("no node 4"));
    assert_eq!(scene.camera(), Some(3));
    scene.set_camera(None).unwrap();
    assert_eq!(scene.shown_camera(), Some(2));
    assert_eq!(Scene::new().shown_camera(), None);
}

#[test]
fn a_choice_stays_with_its_node() {
    let mut scene = scene();
    scene.set_camera(Some(3)).unwrap();
    scene.set_range(Some((-2.0, 7.5))).unwrap();
    scene.set_name(3, "renamed").unwrap();
    scene
        .set_parent(3, Some(2), crate::scene::Keep::Numbers)
        .unwrap();
    scene
        .set_parent(3, Some(0), crate::scene::Keep::Place)
        .unwrap();
    let copy = scene.clone();
    assert_eq!(copy, scene);
    scene.remove(1).unwrap();
    assert_eq!(
        (scene.camera(), scene.range()),
        (Some(2), Some((-2.0, 7.5)))
    );
    // It goes with what it is in.
    scene.remove(0).unwrap();
    assert_eq!((scene.camera(), scene.shown_camera()), (None, Some(0)));
    assert_eq!(scene.frame_range(), (-2.0, 7.5));
    assert_eq!((copy.camera(), copy.nodes().len()), (Some(3), 4));
}

#[test]
fn the_range_is_the_chosen_one_else_that_of_paths_and_keys() {
    let mut scene = scene();
    let last = 4.0 + scene.nodes()[2].path().unwrap().count() as f64;
    assert_eq!(scene.frame_range(), (5.0, last));
    scene.set_track(3, keys(&[-1.5, 2.0])).unwrap();
    assert_eq!((scene.range(), scene.frame_range()), (None, (-1.5, last)));
    assert_eq!(scene.frame_count().unwrap(), (last + 1.5) as usize + 1);
    scene.set_range(Some((2.0, 2.0))).unwrap();
    assert_eq!(
        (scene.frame_range(), scene.frame_count().unwrap()),
        ((2.0, 2.0), 1)
    );
    scene.set_range(Some((0.5, 3.25))).unwrap();
    assert_eq!(
        (scene.frame_range(), scene.frame_count().unwrap()),
        ((0.5, 3.25), 3)
    );
    let said = |result: Result<()>| result.unwrap_err().to_string();
    for (wrong, sentence) in [
        ((3.0, 2.0), "the last frame must not lie before the first"),
        ((f64::NAN, 2.0), "a frame must be a finite number"),
        ((0.0, f64::INFINITY), "a frame must be a finite number"),
        ((-2e9, 2.0), "a frame must not exceed 1e9"),
        ((0.0, 1e8), "the scene has more than 100000000 frames"),
    ] {
        assert_eq!(said(scene.set_range(Some(wrong))), sentence);
        assert_eq!(scene.range(), Some((0.5, 3.25)));
    }
    scene.set_range(Some((0.0, 1e8 - 1.0))).unwrap();
    scene.set_range(None).unwrap();
    assert_eq!(scene.frame_range(), (-1.5, last));
    assert_eq!(Scene::new().frame_range(), (1.0, 1.0));
}

#[test]
fn scenes_that_show_something_else_differ() {
    let plain = scene();
    let mut other = scene();
    other.set_camera(Some(1)).unwrap();
    assert_ne!(plain, other);
    other.set_camera(None).unwrap();
    assert_eq!(plain, other);
    other.set_range(Some(plain.frame_range())).unwrap();
    assert_ne!(plain, other);
}
