use vides_engine::scene::{Camera, Extrapolation, FollowPath, Node, Object as Shown, Scene};
use vides_engine::tools::check::FindingKind;

use super::*;
use crate::path::CameraPath;
use crate::{Edit, Info, Note};

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
