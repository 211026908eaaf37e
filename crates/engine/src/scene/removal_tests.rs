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
    if random(state, 4) > 0 {
        scene.set_camera(Some(random(state, count))).unwrap();
    }
    scene.set_range(Some((3.0, 40.0))).unwrap();
    scene
}

#[test]
fn nodes_removed_one_by_one_are_those_removed_at_once() {
    let mut state = 7;
    for _ in 0..300 {
        let mut scene = a_scene(&mut state);
        let (places, mut model) = (kept(&scene), kept(&scene));
        let chosen = scene.camera().map(|at| places[at].0.clone());
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
        // The camera that was chosen is, as long as it is there.
        let left = chosen.and_then(|name| model.iter().position(|node| node.0 == name));
        assert_eq!(scene.camera(), left);
        assert_eq!(scene.shown_camera(), left.or(model.first().map(|_| 0)));
        assert_eq!(scene.frame_range(), (3.0, 40.0));
        for (number, node) in model.iter().enumerate() {
            assert_eq!(scene.find(&node.0), Some(number));
        }
        // Evaluated in an order in which all are, each behind what it needs.
        let mut order = scene.order.to_vec();
        order.sort_unstable();
        assert!(order.into_iter().eq(0..model.len()));
    }
}

#[test]
fn a_shape_goes_and_the_others_keep_their_weights() {
    use crate::scene::{Channel, Extrapolation, Interpolation, Object, Shape, Track};
    let rows = |numbers: &[[f64; 3]], gone: &[usize]| -> Vec<f64> {
        let left = |row: &[f64; 3]| {
            let kept = (0..3).filter(|at| !gone.contains(at));
            kept.map(|at| row[at]).collect::<Vec<_>>()
        };
        numbers.iter().flat_map(left).collect()
    };
    let values = [[0.1, 0.2, 0.3], [1.0, 2.0, 3.0]];
    let tangents = [
        [4.0, 5.0, 6.0],
        [7.0, 8.0, 9.0],
        [1.5, 2.5, 3.5],
        [0.5, -0.0, 1e-9],
    ];
    let ways = [("hermite", &tangents[..]), ("linear", &[])];
    for (order, (by, tangents)) in [[1, 1, 0], [2, 0, 0], [0, 1, 0]]
        .into_iter()
        .flat_map(|order| ways.map(|way| (order, way)))
    {
        let mut scene = Scene::new();
        let object = Node::new("sheet", Kind::Object(Object::default()));
        scene.add(object).unwrap();
        for name in ["a", "b", "c"] {
            let shape = Shape {
                name: name.to_owned(),
                points: Vec::new(),
                colours: Vec::new(),
            };
            scene.add_shape(0, shape).unwrap();
        }
        scene.set_weights(0, &[10.0, 20.0, 30.0]).unwrap();
        let track = Track::new(
            Channel::Weights,
            Interpolation::parse(by).unwrap(),
            vec![1.0, 2.5],
            rows(&values, &[]),
            rows(tangents, &[]),
        )
        .and_then(|track| track.with_extrapolation(Extrapolation::PingPong, Extrapolation::Repeat));
        scene.set_track(0, track.unwrap()).unwrap();
        let (untouched, wrong) = (scene.clone(), scene.remove_shape(0, 3).unwrap_err());
        assert_eq!(
            wrong.to_string(),
            "there is no shape 3 among 3, counted from 0"
        );
        assert_eq!(scene, untouched);
        let mut gone = Vec::new();
        for which in order {
            let left: Vec<usize> = (0..3).filter(|at| !gone.contains(at)).collect();
            gone.push(left[which]);
            let names: String = (0..3)
                .filter(|at| !gone.contains(at))
                .map(|at| ["a", "b", "c"][at])
                .collect();
            scene.remove_shape(0, which).unwrap();
            let node = &scene.nodes()[0];
            let Kind::Object(object) = &node.kind else {
                panic!("an object stays one")
            };
            let left: String = object.shapes().iter().map(|s| &*s.name).collect();
            assert_eq!(left, names);
            let weights = rows(&[[10.0, 20.0, 30.0]], &gone);
            assert_eq!(object.weights(), weights);
            let track = node.keys().track(&Channel::Weights);
            assert_eq!(track.is_none(), gone.len() == 3);
            if let Some(track) = track {
                assert_eq!(track.values(), rows(&values, &gone));
                assert_eq!(track.shape(), rows(tangents, &gone));
                assert_eq!(
                    track.extrapolation(),
                    (Extrapolation::PingPong, Extrapolation::Repeat)
                );
            }
            assert_eq!(scene.numbers, node.keys().numbers());
        }
        assert!(scene.remove_shape(0, 0).is_err());
    }
}
