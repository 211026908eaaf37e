use std::time::Instant;

use crate::limits::MAX_LEVELS;
use crate::path::test_support::Random;
use crate::scene::{Camera, Channel, Interpolation, Keep, Kind, Node, Scene, Track};

fn scene(count: usize) -> Scene {
    let node = |at: usize| Node::new(&at.to_string(), Kind::Camera(Camera::default()));
    Scene::from_nodes((0..count).map(node).collect())
        .map_err(|(_, error)| error)
        .unwrap()
}

/// Whether each node stands once, and behind its parent and that of what it aims at.
fn is_right(scene: &Scene) -> bool {
    let mut places = vec![usize::MAX; scene.nodes().len()];
    for (place, &at) in scene.order.iter().enumerate() {
        places[at] = place;
    }
    let behind = |at: usize| {
        let node = &scene.nodes()[at];
        let target = node.aim.and_then(|aim| scene.nodes()[aim].parent);
        [node.parent, target]
            .into_iter()
            .flatten()
            .all(|needed| places[needed] < places[at])
    };
    !places.contains(&usize::MAX) && (0..places.len()).all(behind)
}

/// The same links are taken and refused as by a scene whose order is rebuilt for each.
#[test]
fn the_order_after_any_links_is_one_of_the_scene() {
    let mut random = Random(3);
    for round in 0..60 {
        let count = 3 + round;
        let (mut scene, mut anew) = (scene(count), scene(count));
        let mut below = |most: usize| (random.unit() * most as f64) as usize % most;
        for _ in 0..6 * count {
            let at = below(count);
            let other = Some(below(count + 1)).filter(|other| *other < count);
            let done = if round % 3 == 0 || below(4) > 0 {
                anew.order.len(); // as it is
                drop(std::mem::take(&mut *anew.order));
                let all = super::super::hierarchy::order(&anew.nodes).map_err(|(_, error)| error);
                *anew.order = all.unwrap();
                let same = anew.set_parent(at, other, Keep::Numbers);
                (scene.set_parent(at, other, Keep::Numbers), same)
            } else {
                let aimed = |scene: &mut Scene| {
                    let values = Node {
                        aim: other,
                        ..scene.nodes()[at].clone()
                    };
                    scene.set_node(at, &values)
                };
                (aimed(&mut scene), aimed(&mut anew))
            };
            assert_eq!(
                done.0.is_ok(),
                done.1.is_ok(),
                "{at} {other:?}: {:?} {:?}",
                done.0,
                done.1
            );
            assert!(scene == anew && is_right(&scene), "{round}: {at} {other:?}");
        }
    }
}

#[test]
fn levels_are_counted_whatever_way_they_come_about() {
    for down in [true, false] {
        let mut scene = scene(MAX_LEVELS + 1);
        let link = |scene: &mut Scene, k: usize| scene.set_parent(k, Some(k - 1), Keep::Numbers);
        let (mut all, last): (Vec<usize>, usize) = match down {
            true => ((1..MAX_LEVELS).collect(), MAX_LEVELS),
            false => ((2..=MAX_LEVELS).rev().collect(), 1),
        };
        for k in all.drain(..) {
            link(&mut scene, k).unwrap();
        }
        assert!(
            link(&mut scene, last)
                .unwrap_err()
                .to_string()
                .contains("256")
        );
        // One less, and it fits.
        scene.set_parent(MAX_LEVELS, None, Keep::Numbers).unwrap();
        link(&mut scene, last.min(MAX_LEVELS - 1)).unwrap();
        assert!(is_right(&scene));
    }
}

/// Each would take as long as the whole scene: minutes in all.
#[test]
fn a_node_of_many_is_given_another_parent_in_no_time() {
    let count = 30_000;
    let start = Instant::now();
    let key = Track::new(
        Channel::Zoom,
        Interpolation::Step,
        vec![7.0],
        vec![50.0],
        vec![],
    );
    for backwards in [false, true] {
        let mut scene = scene(count);
        // One that moves, so that the scene has frames.
        scene.set_track(5, key.clone().unwrap()).unwrap();
        for k in 0..count - 1 {
            let (at, parent) = match backwards {
                false => (k + 1, k / 10),
                true => (k, count - 1 - (count - 1 - k) / 10),
            };
            if at != parent {
                scene.set_parent(at, Some(parent), Keep::Place).unwrap();
            }
        }
        assert!(is_right(&scene));
    }
    assert!(
        start.elapsed().as_secs_f64() < 15.0,
        "{:?}",
        start.elapsed()
    );
}
