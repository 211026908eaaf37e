//! Edits of scenes: each can be undone and done again to the last bit, whatever came before, and a
//! file holds every state. Each refuses what must not be with a sentence and changes nothing.

mod comments;
mod maker;
mod refused;

use std::collections::BTreeSet;

use maker::{Maker, kinds, nodes, whole};
use vides_document::{Document, Edit};
use vides_engine::path::CameraPath;
use vides_engine::scene::{
    Channel, Extrapolation, FollowPath, Interpolation, KeyList, Kind, Light, Mesh, Node, NodeState,
    Object, Part, Scene, Shape, Track, Warnings,
};

fn part(part: Part) -> Edit {
    Edit::Part(Box::new(part))
}

/// The text of its file, and every value as it is read from there.
fn assert_saved(document: &Document) {
    let text = document.to_toml().unwrap();
    let (loaded, warnings) = Document::scene_from_toml(&text, "".as_ref())
        .unwrap_or_else(|error| panic!("{error} in\n{text}"));
    assert!(warnings.is_empty(), "{warnings:?}");
    assert_eq!(loaded.to_toml().unwrap(), text);
    let both = [document, &loaded].map(|document| nodes(&document.scene().unwrap()));
    assert!(both[0] == both[1], "a bit differs in\n{text}");
}

/// The scene, and whether it is more than a path.
fn before_travel(document: &Document) -> (Scene, bool) {
    (document.scene().unwrap(), document.edited_scene().is_some())
}

/// What undo or redo of an edit has changed is told: all nodes that differ from those of the same
/// name that were there, and keys that were not there.
fn assert_touched(document: &Document, (before, known): &(Scene, bool), edit: &Edit) {
    let touched = document.touched();
    let now = document.scene().unwrap();
    let nodes = touched.nodes();
    assert!(nodes.is_sorted_by(|a, b| a < b), "{nodes:?}");
    if document.edited_scene().is_none() || !known {
        return;
    }
    // Nodes are found under their new numbers.
    let renamed = matches!(edit, Edit::Part(part) if matches!(**part, Part::Name { .. }));
    for (old, &id) in before.nodes().iter().zip(before.ids()) {
        let new = now.number_of(id);
        let there = now.find(&old.name);
        assert!(there == new || renamed, "{} after {edit:?}", old.name);
    }
    for (at, node) in now.nodes().iter().enumerate() {
        let parent = |scene: &Scene, node: &Node| {
            let parent = node.parent;
            parent.map(|parent| scene.nodes()[parent].name.clone())
        };
        let what = |scene: &Scene, node: &Node| {
            let mut alone = node.clone();
            (alone.parent, alone.aim) = (None, None);
            (parent(scene, node), alone)
        };
        let old = before.find(&node.name).map(|old| &before.nodes()[old]);
        let of_parent = parent(&now, node).is_some_and(|name| before.find(&name).is_none());
        let same = old.is_some_and(|old| what(before, old) == what(&now, node));
        // A marker moves what is pinned to it.
        let of_marker = matches!(edit, Edit::Part(part) if matches!(**part, Part::Marker { .. }));
        assert!(
            same || of_parent || of_marker || nodes.contains(&at),
            "{} after {edit:?}: {nodes:?}",
            node.name
        );
        for track in node.keys().tracks() {
            let old = old.and_then(|old| old.keys().track(track.channel()));
            let told = touched
                .keys()
                .find(|of| (of.0, of.1) == (at, track.channel()));
            let told = told.map_or(&[][..], |of| of.2);
            assert!(told.iter().all(|&key| key < track.frames().len()));
            let new = track.frames().iter().enumerate();
            let new = new.filter(|(_, frame)| old.is_some_and(|old| !old.frames().contains(frame)));
            let of_keys = matches!(edit, Edit::Part(part) if matches!(**part, Part::Keys { .. }));
            assert!(!of_keys || new.clone().all(|(key, _)| told.contains(&key)));
        }
    }
}

/// 10,000 edits that were done, in scenes that grow to 200 nodes.
#[test]
fn any_edits_of_scenes_can_be_undone_and_done_again() {
    let mut seen = BTreeSet::new();
    let mut done = 0;
    for seed in 0..40 {
        let mut make = Maker::new(seed);
        let mut document = Document::new();
        let mut states = vec![whole(&document)];
        let mut saved = vec![document.to_toml().unwrap()];
        while states.len() <= 250 {
            let edit = make.edit(&document);
            let name = kinds(&edit);
            let (before, now) = (document.revision(), whole(&document));
            match document.apply(edit.clone()) {
                Err(error) => {
                    assert!(!error.to_string().is_empty());
                    assert_eq!(document.revision(), before);
                    if make.now_and_then(8) {
                        assert_eq!(whole(&document), now, "{edit:?}: {error}");
                    }
                }
                Ok(()) if document.revision() == before => {}
                // To choose a node is no step; it goes back with the next one.
                Ok(()) if name == "edit-node" => {
                    seen.insert(name);
                }
                Ok(()) => {
                    seen.insert(name);
                    done += 1;
                    let (after, scene) = (whole(&document), before_travel(&document));
                    assert!(document.undo());
                    assert_eq!(&whole(&document), states.last().unwrap(), "{edit:?}");
                    assert_touched(&document, &scene, &edit);
                    let scene = before_travel(&document);
                    // Looking at other nodes is no step, and does no harm to those that are.
                    for node in [None, Some(0), Some(2), Some(5)] {
                        if make.now_and_then(4) {
                            let _ = document.apply(Edit::EditNode(node));
                        }
                    }
                    assert!(document.redo());
                    assert_eq!(whole(&document), after, "{edit:?}");
                    assert_touched(&document, &scene, &edit);
                    states.push(after);
                    saved.push(document.to_toml().unwrap());
                    if make.now_and_then(16) {
                        assert_saved(&document);
                    }
                }
            }
        }
        assert!(
            document
                .edited_scene()
                .is_none_or(|scene| scene.scene().nodes().len() <= 200)
        );
        assert_saved(&document);
        for (state, text) in states.iter().zip(&saved).rev().skip(1) {
            assert!(document.undo());
            assert_eq!(&whole(&document), state);
            assert_eq!(&document.to_toml().unwrap(), text);
        }
        assert!(!document.undo() && !document.is_modified());
        assert!(document.edited_scene().is_none());
        for (state, text) in states.iter().zip(&saved).skip(1) {
            assert!(document.redo());
            assert_eq!(&whole(&document), state);
            assert_eq!(&document.to_toml().unwrap(), text);
        }
        assert!(!document.redo());
    }
    assert!(done >= 10_000, "{done}");
    let all: BTreeSet<&str> = maker::KINDS.into_iter().collect();
    assert_eq!(seen, all);
}

/// A camera on a path, a lamp with keys, a box with two shapes.
fn furnished() -> Document {
    let mut document = Document::new();
    let mut lamp = Node::new("lamp", Kind::Light(Light::Point));
    lamp.set_track(linear(
        Channel::Intensity,
        &[1.0, 5.0, 9.0],
        &[1.0, 2.0, 3.0],
    ))
    .unwrap();
    lamp.set_track(linear(
        Channel::Position,
        &[1.0, 5.0],
        &[0.0, 0.0, 0.0, 1.0, 2.0, 3.0],
    ))
    .unwrap();
    let mut object = Object::default();
    object
        .set_mesh(Mesh {
            points: vec![glam::DVec3::ZERO, glam::DVec3::ONE],
            ..Mesh::default()
        })
        .unwrap();
    let mut still = Node::new("box", Kind::Object(object));
    still.rest.scale = glam::DVec3::new(1.0, 2.0, 3.0);
    let mut turned = Node::new("turned", Kind::Group);
    turned.rest.rotation = glam::DQuat::from_rotation_z(0.5);
    turned.parent = Some(2);
    document
        .apply(Edit::AddNodes(vec![lamp, still, turned]))
        .unwrap();
    for name in ["a", "b"] {
        let shape = shape(name, 2);
        document
            .apply(part(Part::insert_shape(2, 0, shape).unwrap()))
            .unwrap();
    }
    document
}

fn shape(name: &str, points: usize) -> Shape {
    Shape {
        name: name.to_owned(),
        points: vec![glam::DVec3::X; points],
        colours: Vec::new(),
    }
}

fn linear(channel: Channel, frames: &[f64], values: &[f64]) -> Track {
    let (frames, values) = (frames.to_vec(), values.to_vec());
    Track::new(channel, Interpolation::Linear, frames, values, Vec::new()).unwrap()
}

fn keys(channel: Channel, remove: &[usize], frames: &[f64], values: &[f64]) -> Edit {
    part(Part::Keys {
        node: 1,
        channel,
        remove: remove.to_vec(),
        put: KeyList {
            frames: frames.to_vec(),
            values: values.to_vec(),
            shape: Vec::new(),
        },
    })
}

/// Where a pin cannot be met, the last that could stays.
#[test]
fn a_pin_that_cannot_be_met_is_refused() {
    let mut document = furnished();
    let marker = |name: &str, frame: f64| {
        let (name, frame) = (name.to_owned(), Some(frame));
        part(Part::Marker { name, frame })
    };
    let pin = |node: usize, point: usize, marker: &str| {
        let marker = Some(marker.to_owned());
        part(Part::Pin {
            node,
            point,
            marker,
        })
    };
    let follow = FollowPath::new(CameraPath::default(), 1.0, Extrapolation::Hold).unwrap();
    document
        .apply(part(Part::path(3, Some(follow)).unwrap()))
        .unwrap();
    for edit in [marker("begin", 10.0), marker("end", 60.0)] {
        document.apply(edit).unwrap();
    }
    for node in [0, 3] {
        document.apply(pin(node, 0, "begin")).unwrap();
        document.apply(pin(node, 1, "end")).unwrap();
    }
    let scene = document.scene().unwrap();
    for node in [0, 3] {
        assert_eq!(
            scene.nodes()[node].path().unwrap().first_and_last(),
            (10.0, 60.0)
        );
    }
    let before = whole(&document);
    for edit in [
        marker("end", 5.0),
        marker("end", 10.0),
        marker("begin", 1e8),
    ] {
        let error = document.apply(edit).unwrap_err().to_string();
        assert!(
            error.starts_with("point ") || error.starts_with("node \"turned\": point "),
            "{error}"
        );
        assert_eq!(whole(&document), before);
    }
    document.apply(marker("end", 80.0)).unwrap();
    let scene = document.scene().unwrap();
    for node in [0, 3] {
        assert_eq!(
            scene.nodes()[node].path().unwrap().first_and_last(),
            (10.0, 80.0)
        );
    }
    assert!(document.undo());
    assert_eq!(whole(&document), before);
    // A marker goes with its pins and comes back with them.
    document
        .apply(Edit::RenameMarker {
            from: "end".into(),
            to: "stop".into(),
        })
        .unwrap();
    assert_eq!(document.scene().unwrap().pins().len(), 4);
    document
        .apply(part(Part::Marker {
            name: "stop".into(),
            frame: None,
        }))
        .unwrap();
    assert_eq!(document.scene().unwrap().pins().len(), 2);
    assert!(document.undo() && document.undo());
    assert_eq!(whole(&document), before);
}

/// A key let go on another takes its place; undo brings that back. The last one's value stays.
#[test]
fn a_key_dropped_on_a_key_replaces_it() {
    let mut document = furnished();
    let track = |document: &Document| {
        let scene = document.scene().unwrap();
        let track = scene.nodes()[1].keys().track(&Channel::Intensity);
        track.map(|track| (track.frames().to_vec(), track.values().to_vec()))
    };
    let before = whole(&document);
    document
        .apply(keys(Channel::Intensity, &[0], &[5.0], &[1.0]))
        .unwrap();
    assert_eq!(track(&document), Some((vec![5.0, 9.0], vec![1.0, 3.0])));
    assert!(document.undo());
    assert_eq!(whole(&document), before);
    document
        .apply(keys(Channel::Intensity, &[0, 1, 2], &[], &[]))
        .unwrap();
    assert_eq!(track(&document), None);
    assert_eq!(document.scene().unwrap().nodes()[1].rest.intensity, 3.0);
    assert!(document.undo());
    assert_eq!(whole(&document), before);
}

/// What is removed while its path is edited comes back with it, and so does the path alone.
#[test]
fn the_edited_node_goes_and_comes_back() {
    let mut document = furnished();
    document.apply(Edit::AppendAfterLast).unwrap();
    let before = whole(&document);
    document.apply(part(Part::Remove(vec![0]))).unwrap();
    assert_eq!(document.edited_scene().unwrap().node(), None);
    assert_eq!(document.scene().unwrap().nodes().len(), 3);
    assert!(document.undo());
    assert_eq!(whole(&document), before);
    assert_eq!(document.path().points.len(), 3);
    document.apply(part(Part::Remove(vec![1, 2]))).unwrap();
    assert!(document.edited_scene().is_none());
    assert_eq!(document.path().points.len(), 3);
    assert!(document.undo());
    assert_eq!(whole(&document), before);
}

/// A path alone and one of a scene, with a start of its own: keys move both as the path did.
#[test]
fn a_path_becomes_keys_that_are_where_it_was() {
    let states = |document: &Document, node: usize, first: f64| {
        let scene = document.scene().unwrap();
        let mut states = vec![NodeState::default(); 60];
        let warnings = &mut Warnings::default();
        scene
            .sample(node, first, 1.0, &mut states, warnings)
            .unwrap();
        states
    };
    let mut alone = Document::new();
    alone.apply(Edit::AppendAfterLast).unwrap();
    let mut car = furnished();
    car.apply(Edit::AppendAfterLast).unwrap();
    let mut path = CameraPath::default();
    path.points[1].position.y = 0.5;
    let follow = FollowPath::new(path, -7.5, Extrapolation::PingPong).unwrap();
    car.apply(part(Part::path(3, Some(follow)).unwrap()))
        .unwrap();
    for (mut document, node, first) in [(alone, 0, 1.0), (furnished(), 0, 1.0), (car, 3, -7.5)] {
        let (before, old) = (whole(&document), states(&document, node, first));
        let edits = document.path_to_keys(node).unwrap();
        document.apply_all(edits).unwrap();
        let scene = document.scene().unwrap();
        assert!(scene.nodes()[node].path().is_none());
        for (a, b) in old.iter().zip(&states(&document, node, first)) {
            let off = a.matrix.iter().zip(b.matrix).map(|(a, b)| (a - b).abs());
            assert!(off.fold(0.0, f64::max) <= 1e-12, "{a:?} {b:?}");
            assert!((a.pose.zoom - b.pose.zoom).abs() <= 1e-12);
        }
        document.path_to_keys(node).unwrap_err();
        assert!(document.undo());
        assert_eq!(whole(&document), before);
    }
    Document::new().path_to_keys(1).unwrap_err();
    furnished().path_to_keys(1).unwrap_err();
}

/// Edits in one step, of which values are kept once, are taken back and done again together.
#[test]
fn a_step_of_many_edits_is_one() {
    for seed in 0..80 {
        let mut make = Maker::new(1000 + seed);
        let mut document = Document::new();
        for _ in 0..60 {
            let _ = document.apply(make.edit(&document));
        }
        // A node that was chosen goes into a step.
        let title = "settled".to_owned();
        let info = vides_document::Info {
            title,
            ..Default::default()
        };
        document.apply(Edit::SetInfo(Box::new(info))).unwrap();
        for _ in 0..4 {
            let before = whole(&document);
            document.begin_step();
            for _ in 0..30 {
                let _ = document.apply(make.edit(&document));
            }
            let after = whole(&document);
            if make.now_and_then(4) {
                document.cancel_step();
                assert_eq!(whole(&document), before, "{seed}");
                continue;
            }
            document.end_step();
            if after != before {
                assert!(document.undo());
                assert_eq!(whole(&document), before, "{seed}");
                assert!(document.redo());
                assert_eq!(whole(&document), after, "{seed}");
            }
        }
    }
}
