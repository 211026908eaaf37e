use vides_engine::scene::{
    Channel, Extrapolation, FollowPath, Interpolation, Kind, Node, Part, Scene, Track,
};

use crate::{At, Document, Edit};
use vides_engine::path::CameraPath;

fn on_path(name: &str, start: f64, beyond: Extrapolation) -> Node {
    let mut node = Node::new(name, Kind::Group);
    let path = FollowPath::new(CameraPath::default(), start, beyond).unwrap();
    node.set_path(Some(path)).unwrap();
    node
}

fn document() -> Document {
    let mut scene = Scene::new();
    let first = on_path("first", 11.0, Extrapolation::PingPong);
    let first = scene.add(first).unwrap();
    let keys = Track::new(
        Channel::Scale,
        Interpolation::Linear,
        vec![-2.5, 4.0],
        vec![1.0; 6],
        Vec::new(),
    );
    scene.set_track(first, keys.unwrap()).unwrap();
    let second = on_path("second", 30.0, Extrapolation::Repeat);
    scene.add(second).unwrap();
    let mut document = Document::new();
    document.apply(Edit::ReplaceScene(Box::new(scene))).unwrap();
    document
}

/// It is that of the scene as it is now, whichever path is edited and however it has changed.
#[test]
fn the_range_is_that_of_the_present_scene() {
    let mut document = document();
    for node in [None, Some(0), Some(1)] {
        document.apply(Edit::EditNode(node)).unwrap();
        let same = |document: &Document| {
            let range = document.frame_range().unwrap();
            assert_eq!(range, document.scene().unwrap().frame_range(), "{node:?}");
            range
        };
        let before = same(&document);
        assert_eq!(before.0, -2.5);
        if node.is_none() {
            continue;
        }
        // A longer path, a later one, and one that a marker holds.
        let position = glam::DVec3::new(0.9, -0.9, -0.9);
        let longer = Edit::set(At::Point(1), "position", position);
        document.apply(longer).unwrap();
        same(&document);
        let start = Part::Start {
            node: node.unwrap(),
            start_frame: 77.5,
            beyond: Extrapolation::Hold,
        };
        document.apply(Edit::Part(Box::new(start))).unwrap();
        let later = same(&document);
        assert!(later.1 > before.1 && later.1.fract() == 0.5, "{later:?}");
        let range = Part::Range(Some((5.0, 9.25)));
        document.apply(Edit::Part(Box::new(range))).unwrap();
        assert_eq!(same(&document), (5.0, 9.25));
        while document.can_undo() && document.edited_scene().unwrap().node() == node {
            document.undo();
        }
    }
    let path = Document::new();
    let range = path.frame_range().unwrap();
    assert_eq!(range, path.scene().unwrap().frame_range());
}

/// Beyond its ends it is the frame whose pose the scene has there.
#[test]
fn the_frame_that_is_seen_is_that_of_the_motion() {
    let mut document = document();
    for node in [0, 1] {
        document.apply(Edit::EditNode(Some(node))).unwrap();
        let scene = document.scene().unwrap();
        let follow = scene.nodes()[node].path().unwrap();
        let (first, last) = follow.first_and_last();
        for frame in [
            first - 7.25,
            first - 1.0,
            first,
            first + 3.5,
            last,
            last + 12.0,
        ] {
            let seen = document.seen_frame_of_path(frame).unwrap();
            let pose = document.sampler().unwrap().pose(seen).unwrap();
            assert_eq!(pose, follow.pose(frame).unwrap(), "{frame}");
        }
    }
    // A path alone has nothing beyond.
    assert_eq!(Document::new().seen_frame_of_path(3.5).unwrap(), 3.5);
}
