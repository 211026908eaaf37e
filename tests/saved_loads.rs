//! What is saved loads: at every limit of what a scene may hold.
//!
//! An eighth of each limit, and all of it where `VIDES_LIMITS` is set (`make soak`), which takes
//! some gigabytes.

use glam::DVec3;
use vides::document::{Info, SceneDocument};
use vides::limits;
use vides::scene::{Channel, Interpolation, Kind, Mesh, Node, Object, Scene, Shape, Track};

fn share(limit: usize) -> usize {
    match std::env::var_os("VIDES_LIMITS") {
        Some(_) => limit,
        None => limit / 8,
    }
}

fn points(count: usize) -> Vec<DVec3> {
    let place = |k: usize| DVec3::new((k % 97) as f64, (k % 89) as f64 / 4.0, -1.5);
    (0..count).map(place).collect()
}

/// So many lists of corners, among three points.
fn corners<const N: usize>(count: usize) -> Vec<[u32; N]> {
    let corners = |k: usize| std::array::from_fn(|corner| ((k + corner) % 3) as u32);
    (0..count).map(corners).collect()
}

/// A scene with an object, whose name wants escapes, which no parser's help is wanted for.
fn scene(mesh: Mesh) -> SceneDocument {
    let mut scene = Scene::new();
    let node = Node::new("the \"body\" \\ 1", Kind::Object(Object::default()));
    let node = scene.add(node).unwrap();
    scene.set_mesh(node, mesh).unwrap();
    let info = Info {
        comment: "two lines\nof a \"comment\"".to_owned(),
        ..Info::default()
    };
    SceneDocument::new(scene, info).unwrap()
}

/// Saved and loaded it is the same, to the last bit.
fn comes_back(document: &SceneDocument, what: &str) {
    let text = document.to_toml().expect(what);
    let loaded = SceneDocument::from_toml(&text).expect(what);
    assert!(loaded == *document, "{what}: it is another one");
}

#[test]
fn meshes_of_every_size_come_back() {
    let all = [
        Mesh {
            points: points(share(limits::MAX_MESH_POINTS)),
            ..Mesh::default()
        },
        Mesh {
            points: points(share(limits::MAX_MESH_POINTS)),
            colours: vec![[1, 20, 255]; share(limits::MAX_MESH_POINTS)],
            triangles: corners(share(limits::MAX_MESH_CORNERS / 3)),
            ..Mesh::default()
        },
        Mesh {
            points: points(3),
            lines: corners(share(limits::MAX_MESH_CORNERS / 2)),
            ..Mesh::default()
        },
    ];
    for (number, mesh) in all.into_iter().enumerate() {
        comes_back(&scene(mesh), &format!("mesh {number}"));
    }
}

#[test]
fn shapes_and_tracks_of_every_size_come_back() {
    let count = share(500_000);
    let mut document = scene(Mesh {
        points: points(count),
        ..Mesh::default()
    });
    for number in 0..4 {
        let shape = Shape {
            name: format!("shape {number}"),
            points: points(count),
            colours: Vec::new(),
        };
        document.scene.add_shape(0, shape).unwrap();
    }
    // Frame and number of each key count.
    let keys = share(limits::MAX_SCENE_NUMBERS) / 2;
    let frames = (0..keys).map(|k| k as f64).collect();
    let values = (0..keys).map(|k| (k % 101) as f64).collect();
    let (channel, by) = (Channel::parse("value:a").unwrap(), Interpolation::Linear);
    let track = Track::new(channel, by, frames, values, Vec::new()).unwrap();
    document.scene.set_track(0, track).unwrap();
    comes_back(&document, "shapes and keys");
}
