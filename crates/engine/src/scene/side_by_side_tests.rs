use super::super::motion::Motion;
use super::super::{Channel, Extrapolation, hierarchy};
use super::super::{Interpolation, Kind, Node, NodeState, Scene, Track, Warnings};
use super::*;
use crate::path::test_support::Random;

/// 200 nodes: with the same keys, with keys of their own, curved ones, some that stay, a light.
fn scene(random: &mut Random, apart: f64) -> Scene {
    let mut nodes = Vec::new();
    for n in 0..200 {
        let kind = if n == 70 {
            Kind::Light(Default::default())
        } else {
            Kind::Group
        };
        let mut node = Node::new(&format!("n{n}"), kind);
        let mut some = || 4.0 * random.unit() - 2.0;
        node.parent = (n > 0).then_some(n / 4);
        node.rest.position = DVec3::new(some(), some(), some());
        if n != 70 {
            node.pivot = DVec3::new(some(), some(), some());
        }
        for (at, width) in [3, 3, 4].into_iter().enumerate() {
            if some() > 1.2 {
                continue;
            }
            let way = match (some() + 2.0) * apart {
                way if way > 3.0 => Interpolation::CatmullRom,
                way if way > 2.0 => Interpolation::Sine,
                _ => Interpolation::Linear,
            };
            let moved = apart * (some() + 2.0) / 9.0;
            let frames = (0..8).map(|k| f64::from(k * k) + if k == 3 { moved } else { 0.0 });
            let values = (0..8 * width).map(|_| some()).collect();
            let track = Track::new(
                MOTIONS[at].clone(),
                way,
                frames.collect(),
                values,
                Vec::new(),
            );
            let beyond = [Extrapolation::Repeat, Extrapolation::Offset];
            let track = track.unwrap().with_extrapolation(beyond[0], beyond[1]);
            node.set_track(track.unwrap()).unwrap();
        }
        nodes.push(node);
    }
    Scene::from_nodes(nodes).unwrap()
}

fn states(scene: &Scene, frame: f64) -> Vec<NodeState> {
    let mut states = vec![NodeState::default(); scene.nodes().len()];
    scene
        .evaluate(frame, &mut states, &mut Warnings::default())
        .unwrap();
    states
}

/// Packed as gathered, bit for bit; both as computed one by one.
#[test]
fn side_by_side_as_one_by_one() {
    let mut random = Random(11);
    for apart in [0.0, 0.0, 1.0] {
        let packed = scene(&mut random, apart);
        while packed.nodes.packs.get().is_none() {
            states(&packed, 1.0);
        }
        let packs = packed.nodes.packs.get().unwrap().iter().flatten().count();
        assert!(packs >= if apart > 0.0 { 0 } else { 11 }, "{packs}");
        for frame in [0.0, 1.0, 5.3, 9.0, 30.0, 48.999, 49.0, 49.5, -3.0, 120.7] {
            let found = states(&packed, frame);
            assert!(found == states(&packed.clone(), frame), "at {frame}");
            for (at, node) in packed.nodes().iter().enumerate() {
                let mut values = node.rest;
                node.keys()
                    .at(frame, &mut values, &mut Warnings::default())
                    .unwrap();
                let parent = node
                    .parent
                    .map_or(glam::DAffine3::IDENTITY, |at| found[at].world());
                let plain = parent * hierarchy::local(node, &values);
                let size = plain
                    .to_cols_array()
                    .map(f64::abs)
                    .into_iter()
                    .fold(1.0, f64::max);
                let near = found[at].world().abs_diff_eq(plain, 1e-14 * size);
                assert!(near, "node {at} at {frame}");
            }
        }
    }
}

#[test]
fn what_is_packed_follows_changes() {
    let mut scene = scene(&mut Random(12), 0.0);
    for _ in 0..100 {
        states(&scene, 3.0);
    }
    let before = states(&scene, 3.0);
    scene.remove_track(100, &Channel::Position).unwrap();
    let mut values = scene.nodes()[100].clone();
    values.rest.position = DVec3::new(5.0, 6.0, 7.0);
    scene.set_node(100, &values).unwrap();
    let after = states(&scene, 3.0);
    assert_ne!(before[100], after[100]);
    assert_eq!(after, states(&scene.clone(), 3.0));
}

#[test]
fn many_frames_of_one_node_as_each_by_itself() {
    for (apart, packs) in [(0.0, 1), (1.0, 0)] {
        let scene = scene(&mut Random(13), apart);
        let chain = scene.chain(199).unwrap();
        let packed = Pack::all(scene.nodes(), &chain, 300).unwrap();
        assert!(chain.len() > 3 && packed.iter().flatten().count() == packs);
        let mut many = vec![NodeState::default(); 300];
        let none = &mut Warnings::default();
        scene.sample(199, -20.0, 0.5, &mut many, none).unwrap();
        for (k, state) in many.iter().enumerate() {
            let frame = -20.0 + 0.5 * k as f64;
            assert!(*state == states(&scene, frame)[199], "at {frame}");
        }
    }
}
