//! What the history of moved keys weighs against the scene, and what moving one costs.

#[path = "../../../tests/common/counting.rs"]
mod counting;

use std::hint::black_box;
use std::time::{Duration, Instant};

use vides_document::{Document, Edit};
use vides_engine::path::CameraPath;
use vides_engine::scene::{
    Channel, Extrapolation, FollowPath, Interpolation, KeyList, Kind, Node, NodeState, Part, Rest,
    Scene, Track, Warnings,
};

const NODES: usize = 10_000;
const KEYS: usize = 100;

fn scene() -> Scene {
    let mut scene = Scene::new();
    for at in 0..NODES {
        let mut node = Node::new(&format!("node {at}"), Kind::Group);
        let frames = (0..KEYS).map(|key| 10.0 * key as f64).collect();
        let values = (0..3 * KEYS).map(|number| (number + at) as f64).collect();
        let track = Track::new(
            Channel::Position,
            Interpolation::Linear,
            frames,
            values,
            Vec::new(),
        );
        node.set_track(track.unwrap()).unwrap();
        scene.add(node).unwrap();
    }
    scene
}

fn document() -> Document {
    let mut document = Document::new();
    document
        .apply(Edit::ReplaceScene(Box::new(scene())))
        .unwrap();
    document.as_opened()
}

fn moved(node: usize, key: usize, frame: f64) -> Edit {
    Edit::Part(Box::new(Part::Keys {
        node,
        channel: Channel::Position,
        remove: vec![key],
        put: KeyList {
            frames: vec![10.0 * key as f64 + frame],
            values: vec![1.0, 2.0, frame],
            shape: Vec::new(),
        },
    }))
}

/// A step has of its own the list of the nodes, and the one that it changed.
#[test]
fn the_history_of_a_moved_key_is_a_list_of_nodes_and_one_node() {
    let mut document = document();
    let history = counting::cost(|| {
        for at in 0..1000 {
            document.apply(moved(7 * at, at % KEYS, 0.5)).unwrap();
        }
    });
    let history = history.left;
    println!("{} bytes of history for a moved key", history / 1000);
    let step = size_of::<usize>() * NODES + 16_384;
    assert!(history <= 1000 * step as isize, "{history}");
    let undone = counting::cost(|| while document.undo() {});
    assert!(undone.left <= 4096, "{}", undone.left);
}

/// A frame evaluated, and a frame evaluated after a key has moved.
#[test]
fn timed_a_moved_key_costs_no_more_than_half_of_a_frame() {
    let mut document = document();
    let mut copy = document.scene().unwrap();
    let mut states = vec![NodeState::default(); NODES];
    let mut evaluate = |scene: &Scene, frame: f64| {
        let warnings = &mut Warnings::default();
        scene.evaluate(frame, &mut states, warnings).unwrap();
        black_box(&states);
    };
    // What a scrubbed scene prepares is there.
    (0..100).for_each(|at| evaluate(&copy, f64::from(at)));
    let (mut scrub, mut drag) = (Duration::MAX, Duration::MAX);
    for round in 0..40 {
        let frame = 3.25 * f64::from(round) + 0.5;
        let begin = Instant::now();
        evaluate(&copy, frame);
        scrub = scrub.min(begin.elapsed());
        let begin = Instant::now();
        document.begin_step();
        document
            .apply(moved(4321, 50, f64::from(round) / 9.0))
            .unwrap();
        let scene = document.edited_scene().unwrap();
        scene.update(&mut copy, document.path()).unwrap();
        evaluate(&copy, frame);
        drag = drag.min(begin.elapsed());
        let track = |scene: &Scene| scene.nodes()[4321].keys().tracks()[0].clone();
        assert_eq!(
            track(&copy),
            track(document.edited_scene().unwrap().scene())
        );
        document.cancel_step();
    }
    println!("scrub {scrub:?}, drag {drag:?}");
    assert!(
        drag.as_secs_f64() <= 1.5 * scrub.as_secs_f64(),
        "{drag:?} of {scrub:?}"
    );
}

/// A value that is dragged is kept once, with the paths that follow a marker.
#[test]
fn a_drag_keeps_one_value() {
    let mut document = document();
    let marker = |frame: f64| {
        let (name, frame) = ("m".to_owned(), Some(frame));
        Edit::Part(Box::new(Part::Marker { name, frame }))
    };
    let follow = |start| {
        let follow = FollowPath::new(CameraPath::default(), start, Extrapolation::Hold);
        Edit::Part(Box::new(Part::path(1, Some(follow.unwrap())).unwrap()))
    };
    let track = Part::track(1, Channel::Position, None).unwrap();
    document.apply(Edit::Part(Box::new(track))).unwrap();
    document.apply(follow(1.0)).unwrap();
    document.apply(marker(0.0)).unwrap();
    let pin = Part::Pin {
        node: 1,
        point: 0,
        marker: Some("m".to_owned()),
    };
    document.apply(Edit::Part(Box::new(pin))).unwrap();
    let start = |document: &Document| {
        let scene = document.edited_scene().unwrap().scene();
        scene.nodes()[1].path().unwrap().start_frame()
    };
    assert_eq!(start(&document), 0.0);
    let cost = counting::cost(|| {
        document.begin_step();
        for at in 0..1000 {
            document.apply(marker(f64::from(at) + 1.0)).unwrap();
            let rest = Rest::of(&document.edited_scene().unwrap().scene().nodes()[2]);
            let mut rest = Box::new(rest);
            rest.values.position.x = f64::from(at) + 1.0;
            document
                .apply(Edit::Part(Box::new(Part::Rest { node: 2, rest })))
                .unwrap();
        }
        document.end_step();
    });
    // What was there before: its list of nodes.
    let list = (size_of::<usize>() * NODES) as isize;
    assert!(cost.left < list + 16_384, "{}", cost.left);
    assert_eq!(start(&document), 1000.0);
    document.apply(moved(7, 50, 1.0)).unwrap();
    assert!(document.undo() && document.undo());
    assert_eq!(start(&document), 0.0);
    assert_eq!(
        document.edited_scene().unwrap().scene().nodes()[2]
            .rest
            .position
            .x,
        0.0
    );
}
