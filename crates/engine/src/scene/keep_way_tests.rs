use super::*;
use crate::error::Error as EngineError;
use crate::path::CameraPath;
use crate::scene::{Extrapolation, Keep, Kind, Light, Node};

/// A source of numbers.
struct Numbers(u64);

impl Numbers {
    fn below(&mut self, count: usize) -> usize {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % count
    }

    fn number(&mut self) -> f64 {
        self.below(2001) as f64 / 1000.0 - 1.0
    }

    fn vector(&mut self) -> DVec3 {
        DVec3::new(self.number(), self.number(), self.number())
    }

    fn track(&mut self, channel: Channel) -> Track {
        use Interpolation::{CatmullRom, Cubic, EulerLinear, Hermite, Linear, Step, Tcb};
        let turns = channel == Channel::Rotation;
        let by = match turns {
            true => [Linear, CatmullRom, Hermite, Tcb, EulerLinear][self.below(5)].clone(),
            false => [Linear, CatmullRom, Hermite, Tcb, Cubic, Step][self.below(6)].clone(),
        };
        let width = match (turns, by == EulerLinear) {
            (true, false) => 4,
            _ => 3,
        };
        let count = 1 + self.below(4);
        let frames = (0..count).map(|key| 1.0 + 9.0 * key as f64).collect();
        let values: Vec<f64> = match channel {
            // Even ones, so that what is in it needs no shear.
            Channel::Scale => (0..count)
                .flat_map(|_| [1.2 + 0.5 * self.number(); 3])
                .collect(),
            _ => (0..width * count).map(|_| 0.1 + self.number()).collect(),
        };
        let shape = match by {
            Hermite if channel == Channel::Scale => vec![0.0; 2 * width * count],
            Hermite => (0..2 * width * count)
                .map(|_| 0.1 * self.number())
                .collect(),
            Tcb => (0..3 * count).map(|_| self.number()).collect(),
            _ => Vec::new(),
        };
        Track::new(channel, by, frames, values, shape).unwrap()
    }

    /// Nodes each in one before it; a third moves.
    fn scene(&mut self) -> Scene {
        let mut scene = Scene::new();
        scene.set_range(Some((1.0, 31.0))).unwrap();
        for at in 0..3 + self.below(8) {
            let mut node = match self.below(3) {
                0 => Node::new(&at.to_string(), Kind::Light(Light::Spot)),
                _ => Node {
                    pivot: self.vector(),
                    ..Node::new(&at.to_string(), Kind::Group)
                },
            };
            node.parent = Some(self.below(at + 1)).filter(|&parent| parent < at);
            node.rest.position = self.vector();
            node.rest.rotation = DQuat::from_scaled_axis(self.vector());
            node.rest.scale = DVec3::splat(1.2 + self.number());
            if self.below(6) == 0 {
                node.rest.scale = self.vector();
            }
            if self.below(3) == 0 {
                for channel in [Channel::Position, Channel::Rotation, Channel::Scale] {
                    if self.below(2) == 0 {
                        node.set_track(self.track(channel)).unwrap();
                    }
                }
            } else if self.below(4) == 0 {
                let path = CameraPath::default();
                let path = FollowPath::new(path, 2.0, Extrapolation::Hold).unwrap();
                node.set_path(Some(path)).unwrap();
            }
            scene.add(node).unwrap();
        }
        scene
    }
}

/// World matrices of all nodes at every frame.
fn worlds(scene: &Scene) -> Vec<Vec<DAffine3>> {
    let mut states = vec![NodeState::default(); scene.nodes().len()];
    let at = |frame: i32| {
        let mut warnings = Warnings::default();
        scene
            .evaluate(f64::from(frame), &mut states, &mut warnings)
            .unwrap();
        states.iter().map(NodeState::world).collect()
    };
    (1..=31).map(at).collect()
}

/// The world matrices before are the oracle: a node that gets another parent, and all that is in it,
/// are where they were at every frame, or it is refused by name and nothing has changed.
#[test]
fn world_matrices_are_the_same_at_every_frame() {
    let mut numbers = Numbers(3);
    let [mut kept, mut mapped, mut sheared, mut within, mut paths] = [0; 5];
    for _ in 0..1500 {
        let mut scene = numbers.scene();
        let count = scene.nodes().len();
        let at = numbers.below(count);
        let parent = Some(numbers.below(count + 1)).filter(|&parent| parent < count);
        let (before, old) = (worlds(&scene), scene.clone());
        let keys = |scene: &Scene| {
            let tracks = scene.nodes()[at].keys().tracks().iter();
            tracks.map(|track| track.frames().len()).max()
        };
        match scene.set_parent(at, parent, Keep::Way) {
            Ok(()) => {
                kept += 1;
                assert_eq!(scene.nodes()[at].parent, parent);
                mapped += usize::from(old.nodes()[at].moves() && keys(&scene) == keys(&old));
                paths += usize::from(old.nodes()[at].path().is_some());
                for (before, after) in before.iter().flatten().zip(worlds(&scene).iter().flatten())
                {
                    let size = before
                        .to_cols_array()
                        .into_iter()
                        .fold(1.0, |a: f64, b| a.max(b.abs()));
                    // Those of what is in it are products with these.
                    assert!(
                        before.abs_diff_eq(*after, 1e-8 * size),
                        "{before:?} {after:?}"
                    );
                }
                let own =
                    |worlds: &[Vec<DAffine3>]| worlds.iter().map(|all| all[at]).collect::<Vec<_>>();
                for (before, after) in own(&before).iter().zip(&own(&worlds(&scene))) {
                    let size = before
                        .to_cols_array()
                        .into_iter()
                        .fold(1.0, |a: f64, b| a.max(b.abs()));
                    assert!(before.abs_diff_eq(*after, 1e-9 * size));
                }
            }
            Err(error) => {
                assert_eq!(scene, old);
                let said = error.to_string();
                assert!(said.contains(&format!("\"{at}\"")), "{said}");
                match error {
                    EngineError::Argument(Invalid::NeedsShear(_)) => sheared += 1,
                    EngineError::Argument(Invalid::ParentMovesWithIt { .. })
                    | EngineError::At(..) => within += 1,
                    EngineError::Argument(
                        Invalid::WayOfPath(_) | Invalid::PathFliesOtherwise(_),
                    ) => {
                        assert!(old.nodes()[at].path().is_some());
                    }
                    other => panic!("{other}"),
                }
            }
        }
    }
    // Each was met often.
    let met = [kept, mapped, sheared, within, paths];
    assert!(met.into_iter().all(|count| count > 30), "{met:?}");
}
