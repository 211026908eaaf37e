//! Scenes against reference values from `numpy`, `scipy` and `splines`, kept in
//! `oracles/scene.toml`; `oracles/scene.py` beside it makes them.

use glam::{DQuat, DVec3, DVec4};
use toml::de::{DeTable, DeValue};
use vides::deform::{Bounds, Deformation};
use vides::scene::{
    Channel, Extrapolation, Interpolation, Kind, Mesh, Node, NodeState, Object, Scene, Shape,
    Track, Warnings,
};

const TOLERANCE: f64 = 1e-12;

struct Case<'a>(&'a DeTable<'a>);

impl Case<'_> {
    fn text(&self, key: &str) -> Option<&str> {
        self.0.get(key)?.get_ref().as_str()
    }

    /// All numbers below a key, in their order.
    fn numbers(&self, key: &str) -> Vec<f64> {
        let mut all = Vec::new();
        collect(self.0[key].get_ref(), &mut all);
        all
    }

    fn vectors(&self, key: &str) -> Vec<DVec3> {
        let numbers = self.numbers(key);
        numbers.chunks_exact(3).map(DVec3::from_slice).collect()
    }

    fn track(&self, channel: Channel) -> Track {
        let interpolation = Interpolation::parse(self.text("interpolation").unwrap()).unwrap();
        let track = Track::new(
            channel,
            interpolation,
            self.numbers("frames"),
            self.numbers("values"),
            self.numbers("shape"),
        );
        let beyond = self.text("beyond").map_or(Extrapolation::Hold, |name| {
            Extrapolation::named(name).expect("a way to go on")
        });
        track.unwrap().with_extrapolation(beyond, beyond).unwrap()
    }
}

fn collect(value: &DeValue<'_>, all: &mut Vec<f64>) {
    match value {
        DeValue::Array(array) => array.iter().for_each(|value| collect(value.get_ref(), all)),
        DeValue::Float(number) => all.push(number.as_str().parse().unwrap()),
        DeValue::Integer(number) => all.push(number.as_str().parse().unwrap()),
        other => panic!("no number: {other:?}"),
    }
}

fn file() -> toml::Spanned<DeTable<'static>> {
    DeTable::parse(include_str!("oracles/scene.toml")).expect("TOML")
}

fn for_each(kind: &str, least: usize, mut check: impl FnMut(Case<'_>)) {
    let file = file();
    let cases = file.get_ref()[kind].get_ref().as_array().expect("tables");
    assert!(cases.len() >= least);
    for case in cases.iter() {
        check(Case(case.get_ref().as_table().expect("a table")));
    }
}

#[test]
fn tracks_of_numbers() {
    let mut largest = 0.0_f64;
    for_each("track", 40, |case| {
        let track = case.track(Channel::Position);
        let want = case.vectors("want");
        let size = want
            .iter()
            .map(|v| v.abs().max_element())
            .fold(1.0, f64::max);
        for (&frame, &want) in case.numbers("at").iter().zip(&want) {
            let mut got = [0.0; 3];
            let mut warnings = Warnings::default();
            track.numbers(frame, &mut got, &mut warnings);
            assert!(warnings.first().is_none());
            let error = (DVec3::from_array(got) - want).abs().max_element() / size;
            largest = largest.max(error);
            let what = case.text("interpolation").unwrap();
            assert!(
                error <= TOLERANCE,
                "{what} at {frame}: {got:?}, want {want}, {error:e}"
            );
        }
    });
    println!("largest difference of numbers: {largest:e}");
}

#[test]
fn tracks_of_rotations() {
    let mut largest = 0.0_f64;
    for_each("rotation", 20, |case| {
        let track = case.track(Channel::Rotation);
        let want = case.numbers("want");
        for (&frame, want) in case.numbers("at").iter().zip(want.chunks_exact(4)) {
            let q = track.rotation(frame, &mut Warnings::default());
            assert!((q.length() - 1.0).abs() <= 1e-12);
            let got = DVec4::new(q.w, q.x, q.y, q.z);
            let want = DVec4::from_slice(want);
            let error = (got - want).length().min((got + want).length());
            largest = largest.max(error);
            let what = case.text("interpolation").unwrap();
            assert!(
                error <= TOLERANCE,
                "{what} at {frame}: {got}, want {want}, {error:e}"
            );
        }
    });
    println!("largest difference of rotations: {largest:e}");
}

#[test]
fn deformations() {
    let mut largest = 0.0_f64;
    for_each("deformation", 30, |case| {
        let kind = case.text("deformation").unwrap();
        let deformation = Deformation::new(kind, &case.numbers("parameters")).unwrap();
        let corner = |key| case.vectors(key)[0];
        let bounds = Bounds::new(corner("low"), corner("high")).unwrap();
        let mut points = case.vectors("points");
        let want = case.vectors("want");
        deformation.apply(&bounds, &mut points);
        let size = want
            .iter()
            .map(|v| v.abs().max_element())
            .fold(1.0, f64::max);
        for (got, want) in points.iter().zip(&want) {
            let error = (*got - *want).abs().max_element() / size;
            largest = largest.max(error);
            assert!(error <= TOLERANCE, "{kind}: {got}, want {want}, {error:e}");
        }
    });
    println!("largest difference of deformed points: {largest:e}");
}

#[test]
fn morphs() {
    for_each("morph", 3, |case| {
        let base = case.vectors("base");
        let count = base.len();
        let mut scene = Scene::new();
        let node = scene.add(Node::new("face", Kind::Object(Object::default())));
        let node = node.unwrap();
        let points = base;
        let mesh = Mesh {
            points,
            ..Mesh::default()
        };
        scene.set_mesh(node, mesh).unwrap();
        for (at, points) in case.vectors("shapes").chunks_exact(count).enumerate() {
            let shape = Shape {
                name: format!("shape {at}"),
                points: points.to_vec(),
                colours: Vec::new(),
            };
            scene.add_shape(node, shape).unwrap();
        }
        let weights = case.numbers("weights");
        scene.set_weights(node, &weights).unwrap();
        let mut got = vec![DVec3::ZERO; count];
        scene
            .vertices(node, 1.0, &mut got, &mut Warnings::default())
            .unwrap();
        for (got, want) in got.iter().zip(case.vectors("want")) {
            assert!(
                (*got - want).abs().max_element() <= TOLERANCE,
                "{got}, want {want}"
            );
        }
    });
}

/// splitmix64, as in `scene.py`.
struct Numbers(u64);

impl Numbers {
    fn whole(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    fn real(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * ((self.whole() >> 11) as f64 / (1_u64 << 53) as f64)
    }

    fn vector(&mut self, low: f64, high: f64) -> DVec3 {
        DVec3::from_array([0; 3].map(|_| self.real(low, high)))
    }
}

#[test]
fn thousand_trees() {
    let file = file();
    let mut images = Vec::new();
    let trees = file.get_ref()["trees"].get_ref().as_table().unwrap();
    collect(trees["images"].get_ref(), &mut images);
    assert_eq!(images.len(), 3000);
    let (mut largest, mut deepest) = (0.0_f64, 0);
    for (seed, want) in images.chunks_exact(3).enumerate() {
        let mut random = Numbers(seed as u64);
        let count = 1 + (random.whole() % 64) as usize;
        let mut nodes = Vec::new();
        // What the chain stretches rounding by, at most.
        let mut sizes: Vec<(usize, f64)> = Vec::new();
        for at in 0..count {
            let back = if at > 1 { random.whole() % 2 } else { 0 };
            let mut node = Node::new(&format!("node {at}"), Kind::Group);
            node.parent = (at > 0).then(|| at - 1 - back as usize);
            node.rest.position = random.vector(-2.0, 2.0);
            node.pivot = random.vector(-1.0, 1.0);
            let w = random.real(-1.0, 1.0);
            let v = random.vector(-1.0, 1.0);
            node.rest.rotation = DQuat::from_xyzw(v.x, v.y, v.z, w);
            node.rest.scale = random.vector(0.6, 1.5);
            for k in 0..3 {
                if random.whole().is_multiple_of(4) {
                    node.rest.scale[k] = -node.rest.scale[k];
                }
            }
            let (level, size) = node.parent.map_or((0, 1.0), |parent| sizes[parent]);
            let own = node.rest.scale.abs().max_element();
            sizes.push((
                level + 1,
                size * own.max(1.0) * 2.0_f64.min(1.0 + 5.0 / size),
            ));
            nodes.push(node);
        }
        let (level, _) = sizes[count - 1];
        deepest = deepest.max(level);
        let scene = Scene::from_nodes(nodes).unwrap();
        let mut states = vec![NodeState::default(); count];
        scene
            .evaluate(1.0, &mut states, &mut Warnings::default())
            .unwrap();
        let m = states[count - 1].matrix;
        let got = [0, 1, 2].map(|k| m[k] + 2.0 * m[4 + k] + 3.0 * m[8 + k] + m[12 + k]);
        let got = DVec3::from_array(got);
        let want = DVec3::from_slice(want);
        // Relative to the sizes of the matrices on the way.
        let size = states
            .iter()
            .flat_map(|state| state.matrix)
            .map(f64::abs)
            .fold(1.0, f64::max);
        let error = (got - want).abs().max_element() / size;
        largest = largest.max(error);
        assert!(
            error <= TOLERANCE,
            "tree {seed}: {got}, want {want}, {error:e}"
        );
    }
    println!("largest difference of trees: {largest:e}, deepest {deepest}");
    assert!(deepest > 30);
}
