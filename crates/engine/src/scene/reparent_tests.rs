use glam::DVec3;
use proptest::prelude::*;

use super::*;
use crate::scene::{Kind, NodeState, Warnings};

fn worlds(scene: &Scene) -> Vec<DAffine3> {
    let mut states = vec![NodeState::default(); scene.nodes().len()];
    let mut warnings = Warnings::default();
    scene.evaluate(1.0, &mut states, &mut warnings).unwrap();
    states.iter().map(NodeState::world).collect()
}

fn group(name: String, parent: Option<usize>, numbers: [f64; 7]) -> Node {
    let [x, y, z, a, b, c, scale] = numbers;
    let mut node = Node {
        parent,
        pivot: DVec3::new(z, x, y),
        ..Node::new(&name, Kind::Group)
    };
    node.rest.position = DVec3::new(x, y, z);
    node.rest.rotation = DQuat::from_scaled_axis(DVec3::new(a, b, c));
    node.rest.scale = DVec3::splat(1.0 + scale);
    node
}

proptest! {
    /// Each node is in one before it; then one of them is given to another.
    #[test]
    fn it_stays_in_place_or_goes_along(
        all in proptest::collection::vec((any::<proptest::sample::Index>(), proptest::array::uniform7(-0.5_f64..0.5)), 2..12),
        which in any::<proptest::sample::Index>(),
        to in any::<proptest::sample::Index>(),
    ) {
        let mut scene = Scene::new();
        for (at, (parent, numbers)) in all.iter().enumerate() {
            let parent = (at > 0).then(|| parent.index(at + 1)).filter(|&parent| parent < at);
            scene.add(group(at.to_string(), parent, *numbers)).unwrap();
        }
        let at = which.index(all.len());
        let to = Some(to.index(all.len() + 1)).filter(|&to| to < all.len());
        let (before, old) = (worlds(&scene), scene.clone());
        let mut above = std::iter::successors(to, |&up| scene.nodes()[up].parent);
        let round = above.any(|up| up == at);
        for keep in [Keep::Place, Keep::Numbers] {
            let mut scene = old.clone();
            let done = scene.set_parent(at, to, keep);
            prop_assert_eq!(done.is_err(), round);
            if round {
                prop_assert_eq!(&scene, &old);
                continue;
            }
            let after = worlds(&scene);
            prop_assert_eq!(scene.nodes()[at].parent, to);
            if keep == Keep::Place {
                for (before, after) in before.iter().zip(&after) {
                    prop_assert!(before.abs_diff_eq(*after, 1e-9), "{:?} {:?}", before, after);
                }
            } else {
                let (new, old) = (&scene.nodes()[at], &old.nodes()[at]);
                prop_assert_eq!((new.rest, new.pivot, new.keys()), (old.rest, old.pivot, old.keys()));
                let parent = to.map_or(DAffine3::IDENTITY, |to| after[to]);
                prop_assert!(after[at].abs_diff_eq(parent * local(new, &new.rest), 1e-12));
            }
        }
    }
}

#[test]
fn one_that_moves_goes_along_with_its_numbers_only() {
    let mut scene = Scene::of_path(crate::path::CameraPath::default()).unwrap();
    let numbers = [1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    let to = Some(scene.add(group("car".to_owned(), None, numbers)).unwrap());
    let before = worlds(&scene);
    let said = |result: Result<()>| result.unwrap_err().to_string();
    assert!(said(scene.set_parent(0, to, Keep::Place)).contains("moves in its parent's"));
    assert_eq!(scene.nodes()[0].parent, None);
    scene.set_parent(0, to, Keep::Numbers).unwrap();
    let shift = DAffine3::from_translation(DVec3::X) * before[0];
    assert!(worlds(&scene)[0].abs_diff_eq(shift, 1e-12));
    assert!(said(scene.set_parent(1, Some(1), Keep::Numbers)).contains("cannot be in itself"));
    assert!(said(scene.set_parent(1, Some(0), Keep::Numbers)).contains("cannot be in \"camera\""));
    assert!(
        said(scene.set_parent(1, Some(2), Keep::Numbers)).contains("parent: there is no node 2")
    );
    assert!(said(scene.set_parent(2, None, Keep::Numbers)).contains("there is no node 2"));
    scene.set_parent(0, None, Keep::Numbers).unwrap();
    assert_eq!(worlds(&scene), before);
}
