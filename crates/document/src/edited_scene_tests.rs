use vides_engine::scene::{Camera, Extrapolation, Kind, Marker, Node};

use super::*;
use crate::error::ErrorKind;
use crate::{At, Document, Edit};
use glam::DVec3;
use vides_engine::path::{Pose, Space};

/// A car on a path, a camera on another one from frame 11 on, and a lamp on the car.
fn scene() -> Scene {
    let mut scene = Scene::new();
    let follow =
        |start| FollowPath::new(CameraPath::default(), start, Extrapolation::Hold).unwrap();
    let mut car = Node::new("car", Kind::Group);
    car.set_path(Some(follow(1.0))).unwrap();
    scene.add(car).unwrap();
    let mut camera = Node::new("eye", Kind::Camera(Camera::default()));
    camera.set_path(Some(follow(11.0))).unwrap();
    scene.add(camera).unwrap();
    let mut lamp = Node::new("lamp", Kind::Light(vides_engine::scene::Light::Spot));
    lamp.parent = Some(0);
    scene.add(lamp).unwrap();
    scene.set_marker("there", 5.0).unwrap();
    scene
}

fn document(scene: &Scene) -> Document {
    let mut document = Document::new();
    let edit = Edit::ReplaceScene(Box::new(scene.clone()));
    document.apply(edit).unwrap();
    document.as_opened()
}

fn move_first(document: &mut Document) {
    let position = document.path().points[0].position + DVec3::new(0.0, 0.125, 0.0);
    let edit = Edit::set(At::Point(0), "position", position);
    document.apply(edit).unwrap();
}

#[test]
fn what_is_edited_goes_back_into_the_scene_and_nothing_else_changes() {
    let before = scene();
    let mut document = document(&before);
    assert_eq!(document.edited_scene().unwrap().node(), Some(1));
    assert_eq!(document.scene().unwrap(), before);
    move_first(&mut document);
    let after = document.scene().unwrap();
    assert_eq!(after.nodes()[0], before.nodes()[0]);
    assert_eq!(after.nodes()[2], before.nodes()[2]);
    assert_eq!(after.markers(), before.markers());
    let follow = after.nodes()[1].path().unwrap();
    assert_eq!(follow.path(), document.path());
    assert_eq!(follow.start_frame(), 11.0);
    assert_ne!(after, before);
}

#[test]
fn a_file_of_a_scene_has_all_of_it_again() {
    let mut edited = document(&scene());
    move_first(&mut edited);
    let text = edited.to_toml().unwrap();
    let (again, warnings) = Document::scene_from_toml(&text, "".as_ref()).unwrap();
    assert!(warnings.is_empty());
    assert_eq!(again.scene().unwrap(), edited.scene().unwrap());
    assert_eq!(again.to_toml().unwrap(), text);
    // A path alone is the document of that path.
    let text = Document::new().to_toml().unwrap();
    let (alone, _) = Document::scene_from_toml(&text, "".as_ref()).unwrap();
    assert!(alone.edited_scene().is_none());
}

#[test]
fn another_node_is_edited_and_that_is_no_change_of_the_file() {
    let before = scene();
    let mut document = document(&before);
    document.apply(Edit::EditNode(Some(0))).unwrap();
    assert!(!document.is_modified());
    assert_eq!(document.edited_scene().unwrap().node(), Some(0));
    assert_eq!(document.frame_of_scene(3.0), 3.0);
    move_first(&mut document);
    document.apply(Edit::EditNode(Some(1))).unwrap();
    assert_eq!(document.frame_of_scene(3.0), 13.0);
    move_first(&mut document);
    let both = document.scene().unwrap();
    assert_ne!(both.nodes()[0], before.nodes()[0]);
    assert_ne!(both.nodes()[1], before.nodes()[1]);
    while document.undo() {}
    assert_eq!(document.scene().unwrap(), before);
    assert!(!document.is_modified());
    while document.redo() {}
    assert_eq!(document.scene().unwrap(), both);
}

#[test]
fn where_no_path_is_edited_the_whole_scene_passes_and_edits_are_refused() {
    let mut document = document(&scene());
    document.apply(Edit::EditNode(None)).unwrap();
    let (first, last) = document.scene().unwrap().frame_range();
    let frames = document.sampler().unwrap().frame_count();
    assert_eq!(first, document.frame_of_scene(1.0));
    #[allow(clippy::cast_precision_loss)]
    let end = document.frame_of_scene(frames as f64);
    assert_eq!(end, last);
    let error = document
        .apply(Edit::set(At::Path, "closed", true))
        .unwrap_err();
    assert_eq!(error.kind(), ErrorKind::Argument);
    let error = document.apply(Edit::EditNode(Some(2))).unwrap_err();
    assert_eq!(error.to_string(), "node \"lamp\" follows no path");
    let error = document.apply(Edit::EditNode(Some(3))).unwrap_err();
    assert_eq!(error.kind(), ErrorKind::Range);
    let alone = Document::new().apply(Edit::EditNode(None)).unwrap_err();
    assert_eq!(alone.kind(), ErrorKind::Argument);
}

#[test]
fn a_scene_takes_the_place_of_a_path_and_the_other_way_round() {
    let mut document = Document::new();
    let old = document.path().clone();
    let edit = Edit::ReplaceScene(Box::new(scene()));
    document.apply(edit).unwrap();
    assert!(document.is_modified() && document.edited_scene().is_some());
    let alone = Scene::of_path(CameraPath::default()).unwrap();
    document.apply(Edit::ReplaceScene(Box::new(alone))).unwrap();
    assert!(document.edited_scene().is_none());
    document.undo();
    assert_eq!(document.scene().unwrap(), scene());
    document.undo();
    assert!(document.edited_scene().is_none() && *document.path() == old);
}

#[test]
fn poses_are_those_of_the_camera_that_is_shown() {
    let mut document = document(&scene());
    let (mut own, mut others) = ([Pose::default(); 20], [Pose::default(); 20]);
    document.sampler().unwrap().sample(1, &mut own).unwrap();
    // The camera goes from frame 11 on, the car from frame 1.
    document.poses().unwrap().sample(11, &mut others).unwrap();
    assert_eq!(own, others);
    // Whichever path is edited.
    document.apply(Edit::EditNode(Some(0))).unwrap();
    move_first(&mut document);
    document.poses().unwrap().sample(11, &mut others).unwrap();
    assert_eq!(own, others);
    assert_eq!(
        document.shown_path().unwrap().path(),
        &CameraPath::default()
    );
}

#[test]
fn poses_of_a_camera_that_moves_by_keys_are_those_of_the_scene() {
    let text = "version = 1\n[[node]]\nname = \"eye\"\nkind = \"camera\"\n[[node.track]]\n\
        channel = \"position\"\ninterpolation = \"linear\"\nframes = [3, 9]\n\
        values = [[0, 0, 0], [0.6, 0, 0]]\n";
    let (document, _) = Document::scene_from_toml(text, "".as_ref()).unwrap();
    assert!(!document.edits_path());
    let poses = document.poses().unwrap();
    assert_eq!(poses.frame_count(), 7);
    let mut all = [Pose::default(); 7];
    poses.sample(1, &mut all).unwrap();
    for (at, pose) in all.iter().enumerate() {
        #[allow(clippy::cast_precision_loss)]
        let x = 0.1 * at as f64;
        assert!((pose.vrp[0] - x).abs() < 1e-15);
    }
    let mut last = [Pose::default(); 2];
    poses.sample(6, &mut last).unwrap();
    assert_eq!(last, all[5..]);
    for (first, count, frame) in [
        (0, 1, "0"),
        (7, 2, "8"),
        (8, 1, "8"),
        (usize::MAX, 1, "1.8446744073709552e19"),
    ] {
        let error = poses.sample(first, &mut all[..count]).unwrap_err();
        assert_eq!(
            error.to_string(),
            format!("there is no frame {frame}: they go from 1 to 7")
        );
    }
    assert_eq!(
        document.shown_path().unwrap_err().kind(),
        ErrorKind::Argument
    );
}

#[test]
fn a_scene_without_anything_is_one_too() {
    let (document, _) = Document::scene_from_toml("version = 1\nnode = []\n", "".as_ref()).unwrap();
    assert!(!document.edits_path());
    assert!(document.poses().is_err() && document.sampler().is_ok());
    assert_eq!(document.scene().unwrap(), Scene::new());
    let far = Space {
        centre: DVec3::splat(1e6),
        half_size: 1e-3,
        ..Space::default()
    };
    let mut scene = Scene::new();
    scene.set_space(far).unwrap();
    scene.set_marker("here", 1.0).unwrap();
    assert_eq!(
        scene.markers(),
        [Marker {
            name: "here".to_owned(),
            frame: 1.0
        }]
    );
    let document = self::document(&scene);
    assert_eq!(document.path().space, far);
    assert_eq!(document.scene().unwrap(), scene);
}

/// The frames of the scene in which the pinned points of a path are reached.
fn reached(document: &Document) -> Vec<f64> {
    let scene = document.scene().unwrap();
    let pins = scene.pins().iter().filter(|pin| pin.node == 0);
    let follow = scene.nodes()[0].path().unwrap();
    let place = |at: usize| follow.path().points[at].position;
    let frames = |at: usize| {
        let (first, last) = follow.first_and_last();
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        let mut all = (0..=(last - first) as usize).map(|n| first + n as f64);
        all.find(|&frame| DVec3::from_array(follow.pose(frame).unwrap().vrp) == place(at))
    };
    pins.map(|pin| frames(pin.point).unwrap()).collect()
}

#[test]
#[allow(clippy::cast_precision_loss)]
fn pins_hold_whatever_is_done_to_the_path() {
    let mut scene = scene();
    scene.set_marker("here", 3.0).unwrap();
    scene.set_marker("yonder", 53.0).unwrap();
    scene.pin(0, 0, Some("here")).unwrap();
    scene.pin(0, 1, Some("yonder")).unwrap();
    let mut document = document(&scene);
    document.apply(Edit::EditNode(Some(0))).unwrap();
    assert_eq!(reached(&document), [3.0, 53.0]);
    assert_eq!(document.frame_of_scene(1.0), 3.0);
    let before = document.scene().unwrap();
    move_first(&mut document);
    document
        .apply(Edit::DivideSegment {
            segment: 0,
            points: 3,
        })
        .unwrap();
    document.apply(Edit::PrependBeforeFirst).unwrap();
    assert_eq!(reached(&document), [3.0, 53.0]);
    let scene = document.scene().unwrap();
    let points: Vec<usize> = scene.pins().iter().map(|pin| pin.point).collect();
    assert_eq!(points, [1, 5]);
    // The path begins earlier, so that the first pin still holds.
    assert!(document.frame_of_scene(1.0) < 3.0);
    assert_eq!(document.scene().unwrap(), scene);
    // A pinned point that goes takes its pin along, and brings it back.
    document.apply(Edit::RemovePoint { at: 5 }).unwrap();
    assert_eq!(reached(&document), [3.0]);
    document.undo();
    assert_eq!(reached(&document), [3.0, 53.0]);
    // What would need more frames than there are is refused, and nothing has changed.
    let there = document.scene().unwrap();
    let mut waits = document.path().points[2].orientations[0].clone();
    waits.hold = 60;
    let edit = Edit::SetOrientation {
        point: 2,
        at: 0,
        orientation: waits,
    };
    let said = document.apply(edit).unwrap_err().to_string();
    assert!(said.contains("at least 64"), "{said}");
    assert_eq!(document.scene().unwrap(), there);
    while document.undo() {}
    document.apply(Edit::EditNode(Some(0))).unwrap();
    assert_eq!(document.scene().unwrap(), before);
}

/// The points of the first node that are pinned.
fn pinned(document: &Document) -> Vec<usize> {
    let scene = document.scene().unwrap();
    let pins = scene.pins().iter().filter(|pin| pin.node == 0);
    pins.map(|pin| pin.point).collect()
}

/// The scene of [`scene`] with its car edited, which has four points and meets "there" at one.
fn pinned_at(point: usize) -> Document {
    let mut document = document(&scene());
    document.apply(Edit::EditNode(Some(0))).unwrap();
    document
        .apply(Edit::DivideSegment {
            segment: 0,
            points: 2,
        })
        .unwrap();
    let mut scene = document.scene().unwrap();
    scene.pin(0, point, Some("there")).unwrap();
    document.apply(Edit::ReplaceScene(Box::new(scene))).unwrap();
    document.apply(Edit::EditNode(Some(0))).unwrap();
    document
}

#[test]
fn a_pin_stays_at_its_point_where_the_way_is_turned_round() {
    let mut document = pinned_at(1);
    assert_eq!(pinned(&document), [1]);
    let place = document.path().points[1].position;
    document.apply(Edit::Reverse).unwrap();
    assert_eq!(pinned(&document), [2]);
    assert_eq!(document.path().points[2].position, place);
    assert_eq!(reached(&document), [5.0]);
    document.undo();
    assert_eq!(
        (pinned(&document), reached(&document)),
        (vec![1], vec![5.0])
    );
    document.redo();
    assert_eq!(pinned(&document), [2]);
    // A closed path still begins at its first point.
    document.apply(Edit::set(At::Path, "closed", true)).unwrap();
    document.apply(Edit::MovePoint { from: 2, to: 1 }).unwrap();
    document.apply(Edit::Reverse).unwrap();
    assert_eq!(pinned(&document), [3]);
    // Two would be met in the wrong order: refused, as wherever a marker comes too early.
    let mut scene = document.scene().unwrap();
    scene.set_marker("yonder", 1.0).unwrap();
    scene.pin(0, 1, Some("yonder")).unwrap();
    document
        .apply(Edit::ReplaceScene(Box::new(scene.clone())))
        .unwrap();
    document.apply(Edit::EditNode(Some(0))).unwrap();
    assert!(document.apply(Edit::Reverse).is_err());
    assert_eq!(document.scene().unwrap(), scene);
}

#[test]
fn pins_of_points_that_another_path_lacks_go_the_others_hold() {
    let mut document = pinned_at(3);
    let (long, short) = (document.path().clone(), CameraPath::default());
    let replace = |path: &CameraPath| Edit::ReplacePath(Box::new(path.clone()));
    document.apply(replace(&short)).unwrap();
    assert_eq!(pinned(&document), [0; 0]);
    document.apply(replace(&long)).unwrap();
    assert_eq!(pinned(&document), [0; 0]);
    while pinned(&document).is_empty() {
        assert!(document.undo());
    }
    // The choice of the node has gone back, too.
    document.apply(Edit::EditNode(Some(0))).unwrap();
    assert_eq!((pinned(&document), document.path()), (vec![3], &long));
    document.apply(Edit::Repeat(2)).unwrap();
    assert_eq!(
        (pinned(&document), reached(&document)),
        (vec![3], vec![5.0])
    );
}

#[test]
fn meshes_that_are_gone_broken_or_huge_leave_their_objects_empty_and_the_rest_as_it_is() {
    let folder = tempfile::tempdir().unwrap();
    let mut text = scene_text();
    let huge = std::fs::File::create(folder.path().join("huge.ply")).unwrap();
    // No more than a name for a length: a file with holes.
    huge.set_len(vides_engine::limits::MAX_FILE_BYTES + 1)
        .unwrap();
    std::fs::write(folder.path().join("broken.stl"), b"solid a\nfacet\n").unwrap();
    for (at, file) in ["gone.obj", "huge.ply", "broken.stl", "."]
        .iter()
        .enumerate()
    {
        text += &format!(
            "[[node]]\nname = \"mesh {at}\"\nkind = \"object\"\n[node.mesh]\nfile = \"{file}\"\n\
             bytes = 3\nchecksum = \"1\"\n"
        );
    }
    let (document, warnings) = Document::scene_from_toml(&text, folder.path()).unwrap();
    let said: Vec<String> = warnings.iter().map(ToString::to_string).collect();
    assert_eq!(said.len(), 4, "{said:?}");
    for (at, words) in ["gone.obj: No such file", "larger than", "broken.stl", ""]
        .iter()
        .enumerate()
    {
        let node = format!("node \"mesh {at}\"");
        assert!(
            said[at].contains(&node) && said[at].contains(words),
            "{said:?}"
        );
        assert!(!said[at].chars().any(char::is_control));
    }
    let scene = document.scene().unwrap();
    assert_eq!(scene.nodes().len(), 3 + 4);
    // They are still named in the file, and the camera's poses are what they were.
    let again = document.to_toml_for(&folder.path().join("a.vid")).unwrap();
    assert!(again.contains("file = \"huge.ply\"") && again.contains("file = \"gone.obj\""));
    let poses = document.poses().unwrap();
    assert_eq!(
        poses.frame_count(),
        self::document(&self::scene())
            .poses()
            .unwrap()
            .frame_count()
    );
}

fn scene_text() -> String {
    document(&scene()).to_toml().unwrap()
}
