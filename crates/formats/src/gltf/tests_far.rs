//! Content far from the origin: 32 bits count from a node beside it.

use std::collections::HashMap;

use glam::{DAffine3, DQuat, DVec3};
use serde_json::Value;
use vides_document::SceneDocument;
use vides_document::mesh::gltf::Container;
use vides_engine::scene::Kind;

use super::tests::{read, states, written};
use super::*;
use crate::loss::Loss;

/// A path, keys of a root and below one, meshes in a scaled and in a turned node.
const FAR: &str = r#"
version = 1
[[node]]
name = "path"
kind = "camera"
[node.path]
[[node.path.point]]
position = [4.9e6, 5.1e6, 300.0]
[[node.path.point.orientation]]
offset = [0.0, 0.0, -1.0]
roll_degrees = 0.0
zoom_mm = 24.0
[[node.path.point]]
position = [4900100.7, 5100000.3, 310.1]
[[node.path.point.orientation]]
offset = [0.3, 0.0, -1.0]
roll_degrees = 0.0
zoom_mm = 24.0
[[node]]
name = "keyed"
kind = "camera"
[[node.track]]
channel = "position"
interpolation = "linear"
frames = [1.0, 20.0]
values = [[4900000.123, 5100000.3, 300.7], [4900050.77, 5100001.9, 303.1]]
[[node]]
name = "group"
kind = "group"
[[node]]
name = "below"
kind = "camera"
parent = "group"
[[node.track]]
channel = "position"
interpolation = "hermite"
frames = [1.0, 20.0]
values = [[4900000.123, 5100000.3, 300.7], [4900050.77, 5100001.9, 303.1]]
shape = [[0.0, 0.0, 0.0, 1.0, 2.0, 3.0], [0.0, 0.0, 0.0, 0.0, 0.0, 0.0]]
[[node]]
name = "lamp"
kind = "light"
position = [4900010.123, 5100000.3, 300.7]
[[node]]
name = "object"
kind = "object"
pivot = [4900010.123, 5100000.3, 300.7]
[node.mesh]
points = [[4900000.123, 5100000.3, 300.7], [4900050.77, 5100001.9, 303.1], [4900020.2, 5100040.4, 320.6]]
triangles = [[0, 1, 2]]
[[node.shape]]
name = "s"
points = [[4900000.123, 5100000.3, 300.7], [4900051.77, 5100001.9, 303.1], [4900020.2, 5100040.4, 320.6]]
[[node]]
name = "hundredths"
kind = "object"
scale = [0.01, 0.01, 0.01]
[node.mesh]
points = [[490000012.3, 510000030.0, 30070.0], [490005077.0, 510000190.0, 30310.0], [490002020.0, 510004040.0, 32060.0]]
triangles = [[0, 1, 2]]
"#;

pub(super) fn far(up: &str) -> SceneDocument {
    let space =
        format!("[space]\ncentre = [4.9e6, 5.1e6, 300.0]\nhalf_size = 50.0\nup = \"{up}\"\n");
    SceneDocument::from_toml(&FAR.replacen("version = 1\n", &format!("version = 1\n{space}"), 1))
        .unwrap()
}

/// Each node's place in the world and its vertices there, at a frame, by the document.
fn by_document(document: &SceneDocument, frame: f64) -> HashMap<String, (DVec3, Vec<DVec3>)> {
    let nodes = document.scene.nodes().iter();
    let each = nodes.zip(states(document, frame)).map(|(node, state)| {
        let world = state.world();
        let points = match &node.kind {
            Kind::Object(object) => object.mesh().points.clone(),
            _ => Vec::new(),
        };
        let points = points.iter().map(|point| world.transform_point3(*point));
        (node.name.clone(), (world.translation, points.collect()))
    });
    each.collect()
}

/// The same by another program, which knows nodes, accessors and the keys at the end of a clip.
fn by_the_file(file: &[u8]) -> HashMap<String, (DVec3, Vec<DVec3>)> {
    let container = Container::open(file.into(), &mut |_| None).unwrap();
    let json = container.json();
    let numbers = |at: &Value, from: usize| {
        let found = container.accessor(at, 1000).unwrap();
        DVec3::from_array(std::array::from_fn(|part| found.number(from, part)))
    };
    let list = |at: &Value| at.as_array().cloned().unwrap_or_default();
    let mut ends: HashMap<u64, DVec3> = HashMap::new();
    let animation = &json["animations"][0];
    for channel in list(&animation["channels"]) {
        if channel["target"]["path"] == "translation" {
            let sampler = &animation["samplers"][channel["sampler"].as_u64().unwrap() as usize];
            let count = container
                .accessor(&sampler["output"], 1000)
                .unwrap()
                .count();
            let back = if sampler["interpolation"] == "CUBICSPLINE" {
                2
            } else {
                1
            };
            let end = numbers(&sampler["output"], count - back);
            ends.insert(channel["target"]["node"].as_u64().unwrap(), end);
        }
    }
    let mut all = HashMap::new();
    let mut open = vec![(
        DAffine3::IDENTITY,
        String::new(),
        json["scenes"][0]["nodes"].clone(),
    )];
    while let Some((above, name, children)) = open.pop() {
        for number in list(&children) {
            let node = &json["nodes"][number.as_u64().unwrap() as usize];
            let triple = |key: &str, rest: f64| match list(&node[key]) {
                list if list.is_empty() => DVec3::splat(rest),
                list => DVec3::from_array(std::array::from_fn(|at| list[at].as_f64().unwrap())),
            };
            let turn = match list(&node["rotation"]) {
                list if list.is_empty() => DQuat::IDENTITY,
                list => DQuat::from_array(std::array::from_fn(|at| list[at].as_f64().unwrap())),
            };
            let end = ends.get(&number.as_u64().unwrap()).copied();
            let place = end.unwrap_or_else(|| triple("translation", 0.0));
            let local =
                DAffine3::from_scale_rotation_translation(triple("scale", 1.0), turn, place);
            let world = above * local;
            let part = !node["extras"]["vides"]["part"].is_null();
            let own = if part {
                name.clone()
            } else {
                node["name"].as_str().unwrap().to_owned()
            };
            let entry = all
                .entry(own.clone())
                .or_insert((world.translation, Vec::new()));
            if let Some(mesh) = node["mesh"].as_u64() {
                let points =
                    &json["meshes"][mesh as usize]["primitives"][0]["attributes"]["POSITION"];
                let count = container.accessor(points, 1000).unwrap().count();
                let points = (0..count).map(|at| world.transform_point3(numbers(points, at)));
                entry.1 = points.collect();
            }
            open.push((world, own, node["children"].clone()));
        }
    }
    all
}

#[test]
fn far_content_keeps_its_precision() {
    for (up, scale) in [("y", 1.0), ("z", 1.0), ("z", 1e-3)] {
        let document = far(up);
        let options = Options {
            scale,
            ..Options::default()
        };
        let (file, report) = written(&document, "glb", &options);
        let told = |loss: &Loss| matches!(loss, Loss::Origin(_));
        assert!(report.losses().iter().any(told));
        let mut ignored = |_, _| {};
        let flight = Flight::new(&document, &options, &GLB, &mut ignored).unwrap();
        let half_size = 50.0 * scale;
        let again = read(file.clone()).unwrap().document;
        let nodes = again.scene.nodes();
        assert_eq!(nodes.len(), document.scene.nodes().len(), "{nodes:?}");
        let near = |was: DVec3, is: DVec3, what: &str| {
            let off = flight.place(was).distance(is) / half_size;
            assert!(off < 1e-6, "{what}, {up} up, scale {scale}: {off}");
        };
        let last = document.scene.frame_range().1;
        for frame in [1.0, 2.0, last] {
            let (was, is) = (by_document(&document, frame), by_document(&again, frame));
            let file = (frame == last).then(|| by_the_file(&file));
            for (name, (place, points)) in &was {
                for (which, all) in [("read", Some(&is)), ("file", file.as_ref())] {
                    let Some((found, vertices)) = all.map(|all| &all[name]) else {
                        continue;
                    };
                    let pivoted = name == "object" && which == "file";
                    let pivot = document.scene.nodes()[document.scene.find(name).unwrap()].pivot;
                    let place = if pivoted { *place + pivot } else { *place };
                    near(place, *found, &format!("{name} at {frame}, {which}"));
                    assert_eq!(points.len(), vertices.len());
                    for (was, is) in points.iter().zip(vertices) {
                        near(*was, *is, &format!("a vertex of {name}, {which}"));
                    }
                }
            }
        }
    }
}

/// The points that a path is shown with, drawn or not.
#[test]
fn a_far_object_of_a_path_keeps_its_precision() {
    for up in ["y", "z"] {
        let mut document = far(up);
        let places: Vec<DVec3> = by_document(&document, 1.0)["object"].1.clone();
        let points = places.iter().enumerate();
        let points = points.map(|(at, &position)| vides_document::ObjectPoint {
            position,
            draw: at > 0,
        });
        document.info.object = points.collect::<Vec<_>>().into();
        let (file, _) = written(&document, "glb", &Options::default());
        let again = read(file.clone()).unwrap().document;
        let mut ignored = |_, _| {};
        let options = Options::default();
        let flight = Flight::new(&document, &options, &GLB, &mut ignored).unwrap();
        assert_eq!(again.scene.nodes().len(), document.scene.nodes().len() + 1);
        let name = &again.scene.nodes().last().unwrap().name;
        let read = &by_document(&again, 1.0)[name].1;
        // It has the name of another node in the file.
        let mut file = by_the_file(&file);
        let file = file.remove("object").unwrap().1;
        for found in [read, &file] {
            assert_eq!(found.len(), places.len());
            for (was, is) in places.iter().zip(found) {
                assert!(flight.place(*was).distance(*is) < 1e-4, "{was} {is}");
            }
        }
    }
}

/// A node that is named as ours but not marked is a node; files near the origin have none.
#[test]
fn only_far_content_has_an_origin() {
    let (file, _) = written(&far("y"), "gltf", &Options::default());
    let text = String::from_utf8(file).unwrap();
    assert!(text.contains("\"part\":\"origin\"") && text.contains("\"part\":\"vertices\""));
    let foreign = text.replace("\"part\"", "\"other\"");
    let read = read(foreign.into_bytes()).unwrap().document;
    let last = far("y").scene.frame_range().1;
    let (was, is) = (by_document(&far("y"), last), by_document(&read, last));
    assert_eq!(is["origin"].0 % 32.0, DVec3::ZERO);
    for name in ["path", "keyed", "lamp"] {
        assert!(was[name].0.distance(is[name].0) < 1e-4, "{name}");
    }
    let (near, _) = written(&super::tests::everything(), "gltf", &Options::default());
    let near = String::from_utf8(near).unwrap();
    assert!(!near.contains("\"part\":\"origin\"") && !near.contains("\"part\":\"vertices\""));
}
