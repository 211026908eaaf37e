//! Comments of a file stay at what they are about while its scene is edited.

use std::collections::BTreeSet;

use vides_document::{Document, Edit, SceneDocument};
use vides_engine::scene::{Channel, KeyList, Kind, Light, Node, Part};

use crate::part;

const COMMENTED: &str = r##"# head
version = 1
# a marker
[[marker]]
name = "begin"
frame = 5.0 # here

# the car
[[node]]
name = "car"
kind = "group" # a group

# its way
[[node.track]]
channel = "position" # where
interpolation = "linear"
# when
frames = [1.0, 10.0]
values = [
  [0.0, 0.0, 0.0],
  [1.0, 0.0, 0.0],
]

[[node.track]]
channel = "value:load"
interpolation = "linear"
# of the load
frames = [1.0]
values = [1.0]

# the eye
[[node]]
name = "eye"
kind = "camera"

[node.path] # its flight
start_frame = 1.0

[node.path.base_speeds]
move_frames = 100.0 # slow

[[node.path.point]]
# first
position = [0.0, 0.0, 0.0]

[[node.path.point.orientation]]
target = [1.0, 0.0, 0.0]

[[node.path.point]]
# second
position = [0.5, 0.5, 0.0]

[[node.path.point.orientation]]
target = [1.0, 0.0, 0.0]
# end
"##;

/// What is written without being asked.
const OURS: [&str; 3] = ["Frames at", "a zoom", "A cube"];

/// The comments of a text with what stands on the next line, or before them on theirs.
fn comments(text: &str) -> BTreeSet<String> {
    let lines: Vec<&str> = text.lines().collect();
    let mut all = BTreeSet::new();
    for (at, line) in lines.iter().enumerate() {
        if let Some((before, comment)) = line.split_once('#')
            && !OURS.iter().any(|ours| comment.trim().starts_with(ours))
        {
            let key = match before.trim() {
                "" => lines.get(at + 1).copied().unwrap_or("").trim(),
                before => before,
            };
            let key = key.split('=').next().unwrap_or("").trim();
            all.insert(format!("{} {key}", comment.trim()));
        }
    }
    all
}

/// Comments stay at what they are about, whatever is edited around it.
#[test]
fn comments_of_a_scene_stay_where_they_are() {
    let (mut document, _) = Document::scene_from_toml(COMMENTED, "".as_ref()).unwrap();
    let all = comments(COMMENTED);
    assert_eq!(all.len(), 15);
    let first = document.to_toml().unwrap();
    assert_eq!(comments(&first), all);
    let keys = |node, frames: &[f64], values: &[f64]| {
        part(Part::Keys {
            node,
            channel: Channel::Position,
            remove: vec![0],
            put: KeyList {
                frames: frames.to_vec(),
                values: values.to_vec(),
                shape: Vec::new(),
            },
        })
    };
    document.apply(keys(0, &[4.0], &[3.0, 2.0, 1.0])).unwrap();
    let name = "wagon".to_owned();
    document.apply(part(Part::Name { node: 0, name })).unwrap();
    document
        .apply(Edit::AddNodes(vec![Node::new("more", Kind::Group)]))
        .unwrap();
    assert_eq!(comments(&document.to_toml().unwrap()), all);
    // The track that came before another one goes, and its comments to the node's.
    document
        .apply(part(Part::track(0, Channel::Position, None).unwrap()))
        .unwrap();
    let text = document.to_toml().unwrap();
    assert!(comments(&text).contains("of the load frames"), "{text}");
    assert_eq!(comments(&text).len(), all.len(), "{text}");
    // What belongs to a node goes with it, and what belongs to a point with that.
    document.apply(Edit::RemovePoint { at: 0 }).unwrap_err();
    document
        .apply(Edit::InsertPoint {
            at: 0,
            position: glam::DVec3::Y,
        })
        .unwrap();
    document.apply(part(Part::Remove(vec![0]))).unwrap();
    let text = document.to_toml().unwrap();
    assert_eq!(comments(&text).len(), 9, "{text}");
    assert!(
        comments(&text).contains("second position") && comments(&text).contains("slow move_frames")
    );
    assert!(
        text.find("# first").unwrap() > text.find("0.0, 1.0, 0.0").unwrap(),
        "{text}"
    );
    let (last, _) = Document::scene_from_toml(&text, "".as_ref()).unwrap();
    assert_eq!(last.to_toml().unwrap(), text);
    while document.undo() {}
    assert_eq!(document.to_toml().unwrap(), first);
    while document.redo() {}
    assert_eq!(document.to_toml().unwrap(), text);
}

/// The first node beside a path makes a scene of it, and the last one that goes a path again.
#[test]
fn a_path_becomes_a_scene_with_every_comment() {
    let text = r##"# head
version = 1
first_frame = 100 # as in the film
closed = true # round and round

[base_speeds]
move_frames = 40.0 # slow

[presets] # shapes
1 = { tension = 0.5, continuity = 0.0, bias = 0.0 } # tight

[[point]] # begin
position = [0.0, 0.0, 0.0]
[[point.orientation]]
target = [1.0, 0.0, 0.0]
# of the second
[[point]]
position = [0.5, 0.5, 0.0]
[[point.orientation]]
target = [1.0, 0.0, 0.0]
roll_degrees = 10.0 # level
[[point]]
position = [-0.5, 0.5, 0.0]
[[point.orientation]]
target = [1.0, 0.0, 0.0]
# end
"##;
    let mut document = Document::from_toml(text).unwrap();
    let first = document.to_toml().unwrap();
    let all = comments(&first);
    assert_eq!(all.len(), 10);
    let poses = |document: &Document| {
        let poses = document.poses().unwrap();
        let mut all = vec![vides_engine::path::Pose::default(); poses.frame_count()];
        poses.sample(1, &mut all).unwrap();
        format!("{all:?}")
    };
    let before = poses(&document);
    let path = document.path().clone();
    document
        .apply(Edit::AddNodes(vec![Node::new(
            "lamp",
            Kind::Light(Light::Point),
        )]))
        .unwrap();
    assert_eq!(*document.path(), path);
    assert_eq!(poses(&document), before);
    assert_eq!(document.info().first_frame, 100);
    let scene = document.to_toml().unwrap();
    let keys = |text: &str| {
        let all = comments(text).into_iter();
        all.map(|comment| comment.replace("node.path.", ""))
            .collect::<BTreeSet<_>>()
    };
    assert_eq!(keys(&scene), keys(&first), "{scene}");
    let (loaded, _) = Document::scene_from_toml(&scene, "".as_ref()).unwrap();
    assert_eq!(loaded.to_toml().unwrap(), scene);
    document.apply(Edit::AppendAfterLast).unwrap_err();
    document.apply(part(Part::Remove(vec![1]))).unwrap();
    assert!(document.edited_scene().is_none());
    assert_eq!(document.to_toml().unwrap(), first);
    assert!(document.undo());
    assert_eq!(document.to_toml().unwrap(), scene);
    assert!(document.undo());
    assert_eq!(document.to_toml().unwrap(), first);
    assert!(document.edited_scene().is_none() && !document.is_modified());
}

/// A program that changes a scene and saves it loses no comment but those of what it removes.
#[test]
fn comments_of_a_scene_that_a_program_changes_stay() {
    let mut document = SceneDocument::from_toml(COMMENTED).unwrap();
    let all = comments(COMMENTED);
    assert_eq!(comments(&document.to_toml().unwrap()), all);
    document.scene.add(Node::new("more", Kind::Group)).unwrap();
    assert_eq!(comments(&document.to_toml().unwrap()), all);
    document.scene.remove(0).unwrap();
    let text = document.to_toml().unwrap();
    let car = [
        "the car",
        "a group",
        "its way",
        "where",
        "when",
        "of the load",
    ];
    let gone = |comment: &&String| !car.iter().any(|of| comment.starts_with(of));
    assert_eq!(comments(&text), all.iter().filter(gone).cloned().collect());
    let copy = document.try_clone().unwrap();
    assert_eq!(copy.to_toml().unwrap(), text);
    // One camera is left: it is written as a path.
    document.scene.remove(1).unwrap();
    document.scene.remove_marker("begin");
    document.scene.set_name(0, "camera").unwrap();
    let text = document.to_toml().unwrap();
    assert!(
        text.contains("[[point]]") && text.contains("# second\nposition"),
        "{text}"
    );
}
