use super::*;
use crate::scene::{Camera, Kind, Node};

/// A node as the test keeps it: parent and aim by name.
type Kept = (String, Option<String>, Option<String>);

fn kept(scene: &Scene) -> Vec<Kept> {
    let name = |at: Option<usize>| at.map(|at| scene.nodes()[at].name.clone());
    let of = |node: &Node| (node.name.clone(), name(node.parent), name(node.aim));
    scene.nodes().iter().map(of).collect()
}

/// The same without a node, what is in it and the aims at them, as one would do it by hand.
fn without(nodes: &[Kept], number: usize) -> Vec<Kept> {
    let mut gone = vec![nodes[number].0.clone()];
    loop {
        let inside = |node: &&Kept| {
            !gone.contains(&node.0) && node.1.as_ref().is_some_and(|parent| gone.contains(parent))
        };
        match nodes.iter().find(inside) {
            Some(node) => gone.push(node.0.clone()),
            None => break,
        }
    }
    let left = nodes.iter().filter(|node| !gone.contains(&node.0)).cloned();
    let aims = |aim: Option<String>| aim.filter(|aim| !gone.contains(aim));
    left.map(|(name, parent, aim)| (name, parent, aims(aim)))
        .collect()
}

/// Random numbers (Steele and Vigna 2021).
fn random(state: &mut u64, below: usize) -> usize {
    *state = state.wrapping_mul(0xd134_2543_de82_ef95).wrapping_add(1);
    (*state >> 33) as usize % below
}

/// Scenes whose nodes are in others and aim at others, before and behind them.
fn a_scene(state: &mut u64) -> Scene {
    let count = 1 + random(state, 40);
    let mut scene = Scene::new();
    for at in 0..count {
        let kind = Kind::Camera(Camera::default());
        let mut node = Node::new(
            &format!("{:02}", random(state, 97) * 41 % 97 + 100 * at),
            kind,
        );
        if at > 0 && random(state, 2) == 0 {
            node.parent = Some(random(state, at));
        } else if at > 0 && random(state, 2) == 0 {
            node.aim = Some(random(state, at));
        }
        scene.add(node).unwrap();
    }
    for at in 0..count / 2 {
        let mut aims = scene.nodes()[at].clone();
        aims.aim = Some(at + 1 + random(state, count - at - 1));
        // Where it would aim at what it carries, it does not.
        let _ = scene.set_node(at, &aims);
    }
    scene
}

#[test]
fn nodes_removed_one_by_one_are_those_removed_at_once() {
    let mut state = 7;
    for _ in 0..300 {
        let mut scene = a_scene(&mut state);
        let (places, mut model) = (kept(&scene), kept(&scene));
        let (mut each, mut removal) = (scene.clone(), Removal::new(&scene).unwrap());
        for _ in 0..random(&mut state, places.len() + 1) {
            if model.is_empty() {
                break;
            }
            let number = random(&mut state, model.len());
            model = without(&model, number);
            each.remove(number).unwrap();
            removal.remove(number).unwrap();
            assert_eq!(removal.count(), model.len());
            for (number, node) in model.iter().enumerate() {
                assert_eq!(places[removal.place(number).unwrap()].0, node.0);
            }
            for (place, node) in places.iter().enumerate() {
                let number = model.iter().position(|(name, ..)| *name == node.0);
                assert_eq!(removal.number(place), number);
            }
            assert!(removal.remove(model.len()).is_err() && removal.number(999).is_none());
        }
        scene.remove_all(removal);
        assert_eq!(scene, each);
        assert_eq!(kept(&scene), model);
        for (number, node) in model.iter().enumerate() {
            assert_eq!(scene.find(&node.0), Some(number));
        }
        // Evaluated in an order in which all are, each behind what it needs.
        let mut order = scene.order.clone();
        order.sort_unstable();
        assert!(order.into_iter().eq(0..model.len()));
    }
}
