use vides_engine::scene::{Camera, Extrapolation, FollowPath, Node, Object as Shown, Scene};
use vides_engine::tools::check::FindingKind;

use super::*;
use crate::{Edit, Info, Note};
use vides_engine::path::CameraPath;

/// The first finding of a kind.
fn found(document: &Document, kind: &str) -> Option<Finding> {
    let all = document.check(None).unwrap();
    all.into_iter().find(|finding| finding.kind.name() == kind)
}

/// A camera on the default path and a triangle across it, which a group has moved there.
fn crossed_scene(across: bool) -> Scene {
    let mut scene = Scene::new();
    let mut camera = Node::new("eye", Kind::Camera(Camera::default()));
    let follow = FollowPath::new(CameraPath::default(), 1.0, Extrapolation::Hold).unwrap();
    camera.set_path(Some(follow)).unwrap();
    scene.add(camera).unwrap();
    let path = CameraPath::default();
    let middle = 0.5 * (path.points[0].position + path.points[1].position);
    let mut group = Node::new("group", Kind::Group);
    // Across the way, or behind its end.
    let way = path.points[1].position - path.points[0].position;
    group.rest.position = middle + if across { DVec3::ZERO } else { 3.0 * way };
    scene.add(group).unwrap();
    let mut object = Shown::default();
    let far = 5.0 * way.normalize().any_orthonormal_vector();
    let other = far.cross(way.normalize());
    object
        .set_mesh(Mesh {
            points: vec![2.0 * far, other - far, -other - far],
            triangles: vec![[0, 1, 2]],
            ..Mesh::default()
        })
        .unwrap();
    let mut wall = Node::new("wall", Kind::Object(object));
    wall.parent = Some(1);
    scene.add(wall).unwrap();
    scene
}

#[test]
fn the_objects_of_a_scene_are_in_the_way_where_they_stand() {
    for across in [true, false] {
        let mut document = Document::new();
        let scene = Edit::ReplaceScene(Box::new(crossed_scene(across)));
        document.apply(scene).unwrap();
        assert_eq!(document.shows_path(), Some(true));
        assert_eq!(found(&document, "through").is_some(), across);
        let mesh = document.obstacles().unwrap().unwrap();
        assert_eq!((mesh.points.len(), mesh.triangles.len()), (3, 1));
    }
    assert!(Document::new().obstacles().unwrap().is_none());
}

/// A box around the space's middle, as a mesh of quads in two.
fn box_of(half: f64) -> Mesh {
    let corner = |k: usize| {
        DVec3::from_array([0, 1, 2].map(|bit| half * ((k >> bit & 1) as f64 * 2.0 - 1.0)))
    };
    let sides: [[u32; 4]; 6] = [
        [0, 1, 3, 2],
        [4, 5, 7, 6],
        [0, 1, 5, 4],
        [2, 3, 7, 6],
        [0, 2, 6, 4],
        [1, 3, 7, 5],
    ];
    let halves = sides
        .iter()
        .flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]);
    Mesh {
        points: (0..8).map(corner).collect(),
        triangles: halves.collect(),
        ..Mesh::default()
    }
}

/// A path from one side of the origin to the other with this object.
fn through(object: Object, reach: f64) -> Document {
    let mut path = CameraPath::default();
    path.points[0].position = DVec3::new(-reach, 0.01, 0.02);
    path.points[1].position = DVec3::new(reach, 0.01, 0.02);
    let info = Info {
        object,
        ..Info::default()
    };
    Document::from_parts(path, info).unwrap()
}

/// As a box that is handed over, whether it was set or comes from a file, and back from a file.
#[test]
fn the_faces_of_the_own_object_are_looked_at() {
    let folder = tempfile::tempdir().unwrap();
    let mesh = box_of(0.25);
    let corners = mesh
        .points
        .iter()
        .map(|p| format!("v {} {} {}\n", p.x, p.y, p.z));
    let faces = mesh
        .triangles
        .iter()
        .map(|[a, b, c]| format!("f {} {} {}\n", a + 1, b + 1, c + 1));
    let file = folder.path().join("box.obj");
    std::fs::write(&file, corners.chain(faces).collect::<String>()).unwrap();
    let wanted = through(Object::default(), 0.8).check(Some(&mesh)).unwrap();
    let kinds: Vec<_> = wanted.iter().map(|f| f.kind.name()).collect();
    assert_eq!(kinds.iter().filter(|kind| **kind == "through").count(), 2);
    let near = wanted.iter().find(|f| f.kind == FindingKind::Clearance);
    assert_eq!(near.unwrap().value, 0.0);
    for object in [
        Object::of_mesh(mesh).unwrap(),
        crate::load_object(&file).unwrap(),
    ] {
        let document = through(object, 0.8);
        assert_eq!(document.check(None).unwrap(), wanted);
        let path = folder.path().join("flight.vid");
        document.save(&path).unwrap();
        let loaded = Document::load(&path).unwrap();
        assert_eq!(loaded.info(), document.info());
        assert_eq!(loaded.check(None).unwrap(), wanted);
        let text = document.to_toml().unwrap();
        assert_eq!(Document::from_toml(&text).unwrap().to_toml().unwrap(), text);
    }
}

#[test]
fn an_object_without_faces_is_written_as_it_was() {
    let lines = Mesh {
        lines: vec![[0, 1], [1, 3]],
        triangles: Vec::new(),
        ..box_of(0.25)
    };
    let object = Object::of_mesh(lines).unwrap();
    assert!(object.mesh().is_none());
    let text = through(object, 0.8).to_toml().unwrap();
    assert!(
        text.contains("polylines = [\n  [[-0.25, -0.25, -0.25], [0.25, "),
        "{text}"
    );
    for broken in [
        "[object]\npolylines = [[[0, 0, 0], [1, 0, 0]]]\npoints = [[0, 0, 0]]",
        "[object]\npoints = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]\ntriangles = [[0, 1, 3]]",
    ] {
        let broken = text.replace(
            &text[text.find("[object]").unwrap()..text.find("]],\n]").unwrap() + 6],
            broken,
        );
        let error = Document::from_toml(&broken).unwrap_err().to_string();
        assert!(error.contains("line"), "{error}");
    }
}

/// More edges than a wireframe may have: those that show its shape are drawn, all faces are there.
#[test]
fn a_large_mesh_keeps_its_faces() {
    let side = 600_u32;
    let points = (0..side * side).map(|k| {
        DVec3::new(
            f64::from(k % side) / 600.0,
            f64::from(k / side) / 600.0,
            0.0,
        )
    });
    let squares = (0..(side - 1) * (side - 1)).map(|k| k / (side - 1) * side + k % (side - 1));
    let triangles = squares.flat_map(|k| [[k, k + 1, k + side], [k + 1, k + side + 1, k + side]]);
    let mesh = Mesh {
        points: points.collect(),
        triangles: triangles.collect(),
        ..Mesh::default()
    };
    let count = mesh.triangles.len();
    let object = Object::of_mesh(mesh).unwrap();
    assert!(object.len() < 10_000, "{}", object.len());
    let document = through(object, 0.8);
    assert_eq!(
        document.obstacles().unwrap().unwrap().triangles.len(),
        count
    );
}

#[test]
fn what_is_no_fault_is_noted() {
    let notes = |document: &Document, object: Option<&Mesh>| {
        let tree = document.clearance(object).unwrap();
        document.notes(tree.as_ref(), object.is_none()).unwrap()
    };
    // Inside, through a wall, with a wall that is missing.
    assert_eq!(
        notes(&through(Object::default(), 0.2), Some(&box_of(0.25))),
        [Note::Inside]
    );
    assert_eq!(
        notes(&through(Object::default(), 0.3), Some(&box_of(0.25))),
        []
    );
    let mut open = box_of(0.25);
    open.triangles.pop();
    assert_eq!(notes(&through(Object::default(), 0.2), Some(&open)), []);
    let mut scene = crossed_scene(false);
    let mut document = Document::new();
    document
        .apply(Edit::ReplaceScene(Box::new(scene.clone())))
        .unwrap();
    assert_eq!(notes(&document, None), []);
    // The group that the wall is in follows a path.
    let follow = FollowPath::new(CameraPath::default(), 1.0, Extrapolation::Hold).unwrap();
    scene.set_path(1, Some(follow)).unwrap();
    document.apply(Edit::ReplaceScene(Box::new(scene))).unwrap();
    let moving = Note::Moving {
        name: "wall".into(),
        others: 0,
    };
    assert!(moving.to_string().starts_with("The object \"wall\" moves"));
    assert_eq!(notes(&document, None), [moving]);
    assert_eq!(notes(&document, Some(&box_of(0.01))), []);
}

#[test]
fn a_kind_that_is_off_stays_so_in_the_file() {
    let mut document = through(Object::default(), 5.0);
    let space = |document: &Document| found(document, "space").is_some();
    assert!(space(&document));
    let mut info = document.info().clone();
    let off = vides_engine::tools::check::OFF;
    info.limits.set(FindingKind::Space, off).unwrap();
    info.limits.set(FindingKind::Jerk, 90.0).unwrap();
    document.apply(Edit::SetInfo(Box::new(info))).unwrap();
    assert!(!space(&document));
    let text = document.to_toml().unwrap();
    assert!(
        text.contains("[check]\nspace = \"off\"\njerk = 90.0\n"),
        "{text}"
    );
    assert_eq!(Document::from_toml(&text).unwrap().info(), document.info());
    assert!(Document::from_toml(&text.replace("\"off\"", "\"of\"")).is_err());
}
