//! Out and in.

use super::*;
use crate::document::SceneDocument;
use std::path::PathBuf;
use vides_engine::scene::{Kind, NodeState, Warnings};

fn write_files(name: &str, document: &SceneDocument, options: &Options) {
    let folder = std::env::var_os("GLTF_OUT").map(PathBuf::from).unwrap();
    for ending in ["glb", "gltf"] {
        let file = folder.join(format!("{name}.{ending}"));
        let format = crate::by_name(ending).unwrap();
        let report = crate::export(document, &file, format, options, &mut |_, _| {}).unwrap();
        println!("{name}.{ending}: {:?}", report.losses());
    }
    let mut ignored = |_, _| {};
    let flight = Flight::new(document, options, &GLB, &mut ignored).unwrap();
    let scene = flight.scene();
    let mut frames = Vec::new();
    for at in 0..flight.count() {
        let mut states = vec![NodeState::default(); scene.nodes().len()];
        scene
            .evaluate(flight.frame(at), &mut states, &mut Warnings::default())
            .unwrap();
        let nodes: serde_json::Map<_, _> = scene.nodes().iter().zip(&states).map(|(node, state)| {
            let m = glam::DMat4::from(flight.to_file() * state.world()).to_cols_array();
            let p = state.pose;
            let pose = match node.kind.looks() {
                true => serde_json::json!({"position": flight.place(p.vrp.into()).to_array(),
                    "view": flight.direction(p.vpn.into()).to_array(), "up": flight.direction(p.vup.into()).to_array(),
                    "fov": crate::convention::field_of_view(p.zoom).to_degrees(),
                    "camera": matches!(node.kind, Kind::Camera(_))}),
                false => serde_json::Value::Null,
            };
            (node.name.clone(), serde_json::json!({"matrix": m.to_vec(), "pivot": node.pivot.to_array(), "pose": pose}))
        }).collect();
        frames.push(serde_json::json!({"time": flight.seconds(at), "nodes": nodes}));
    }
    std::fs::write(
        folder.join(format!("{name}.json")),
        serde_json::to_vec(&serde_json::json!({"scale": options.scale, "frames": frames})).unwrap(),
    )
    .unwrap();
}

#[test]
#[ignore]
fn write_all() {
    let tricky = SceneDocument::from_toml(include_str!("tricky.vid")).unwrap();
    let scaled = Options {
        scale: 2.5,
        ..Options::default()
    };
    write_files("tricky", &tricky, &Options::default());
    write_files("tricky-scaled", &tricky, &scaled);
    for name in ["pyramid", "car"] {
        let file = PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples"));
        let document = SceneDocument::load(&file.join(format!("{name}.vid"))).unwrap();
        write_files(name, &document, &Options::default());
        let compact = Options {
            compact: Some(0.001),
            ..Options::default()
        };
        write_files(&format!("{name}-compact"), &document, &compact);
    }
}
