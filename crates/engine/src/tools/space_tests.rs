//! In a space of any size a tool does what it does in [−1, 1]³; powers of two lose no bit.

use glam::{DMat4, DVec3};

use super::block::{self, Fit};
use super::check::{CheckContext, Limits, check};
use super::moves::{MOVES, Move};
use super::{blend, fit, transform};
use crate::deform::{Bounds, Deformation};
use crate::path::resample::resample;
use crate::path::space::Move as Carry;
use crate::path::test_support::Random;
use crate::path::{
    CameraPath, CurveKind, Pose, Sampler, Space, SupportPoint, Tangents, Target, Timeline,
};

const SMALL: f64 = 1.0 / (1u64 << 30) as f64;
const HALF_SIZES: [f64; 4] = [
    SMALL * SMALL * SMALL,
    SMALL,
    1.0 / SMALL,
    1.0 / (SMALL * SMALL),
];

fn vector(random: &mut Random) -> DVec3 {
    DVec3::from_array(std::array::from_fn(|_| 2.0 * random.unit() - 1.0))
}

fn path(random: &mut Random, count: usize) -> CameraPath {
    let curve = [CurveKind::Tcb, CurveKind::Cubic][usize::from(random.unit() < 0.5)];
    let points = (0..count).map(|_| SupportPoint::new(vector(random)));
    let mut path = CameraPath {
        points: points.collect(),
        curve,
        ..CameraPath::default()
    };
    for point in &mut path.points {
        let [before, after] = [(); 2].map(|()| vector(random));
        point.tangents = (random.unit() < 0.3).then_some(Tangents { before, after });
        point.orientations[0].target = if random.unit() < 0.5 {
            Target::Absolute(3.0 * DVec3::ONE + vector(random))
        } else {
            Target::Relative(vector(random))
        };
    }
    path
}

fn carried(path: &CameraPath, half_size: f64) -> CameraPath {
    let space = Space {
        half_size,
        ..path.space
    };
    let carry = Carry::new(path.space, space);
    let points = path.points.iter().map(|point| carry.point(point).unwrap());
    CameraPath {
        points: points.collect(),
        space,
        ..*path
    }
}

/// Holds what a tool makes of paths in other spaces against what it makes of them here.
fn alike(tool: impl Fn(&CameraPath, &CameraPath, f64) -> CameraPath) {
    let mut random = Random(41);
    for _ in 0..20 {
        let (one, other) = (path(&mut random, 4), path(&mut random, 5));
        let wanted = tool(&one, &other, 1.0);
        for size in HALF_SIZES {
            let got = tool(&carried(&one, size), &carried(&other, size), size);
            assert_eq!(got, carried(&wanted, size), "{size:e}");
        }
    }
}

#[test]
fn blocks() {
    alike(|path, _, _| block::extract(path, 1, 3).unwrap());
    alike(|path, _, _| block::reverse(path).unwrap());
    alike(|path, _, _| block::repeat(path, 3).unwrap());
    for fit in [Fit::None, Fit::Move, Fit::Turn, Fit::Scale] {
        alike(|path, block, _| block::insert(path, 2, block, fit, true).unwrap().path);
    }
}

/// A block of a large space in a small one is scaled by far less than 1e-12.
#[test]
fn a_block_of_another_space() {
    let mut random = Random(42);
    let (path, block) = (path(&mut random, 4), path(&mut random, 3));
    let path = carried(&path, HALF_SIZES[0]);
    let sizes = [HALF_SIZES[0], 1.0 / SMALL];
    let [wanted, got] = sizes.map(|size| {
        let block = carried(&block, size);
        block::insert(&path, 1, &block, Fit::Scale, true)
            .unwrap()
            .path
    });
    assert_eq!(got, wanted);
}

#[test]
fn points_that_change() {
    let put = |path: &CameraPath, changed: transform::Changed| {
        let mut new = path.clone();
        for (number, point) in changed {
            new.points[number] = point;
        }
        new
    };
    alike(|path, _, size| {
        let matrix = DMat4::from_translation(DVec3::X * size) * DMat4::from_rotation_y(0.5);
        put(
            path,
            transform::transform(path, &[1, 2], &matrix, true).unwrap(),
        )
    });
    for bounds in [
        None,
        Some(Bounds::new(DVec3::splat(-1.0), DVec3::new(1.0, 1.0, -1.0)).unwrap()),
    ] {
        alike(|path, _, size| {
            let twist = Deformation::new("twist", &[1.0, 50.0]).unwrap();
            let bounds = bounds.map(|b| Bounds::of(&[b.min() * size, b.max() * size]));
            put(
                path,
                transform::deform(path, &[0, 1, 2], &twist, bounds, true).unwrap(),
            )
        });
    }
}

#[test]
fn new_paths() {
    alike(|path, other, _| blend::blend(&[path, other], &[0.25, 0.75]).unwrap());
    alike(|path, _, _| resample(path, 7).unwrap());
}

#[test]
fn moves() {
    let made = |known: &Move, half_size: f64| {
        let space = Space {
            half_size,
            ..Space::default()
        };
        let numbers = known.defaults(None, space).unwrap();
        known.path(&numbers, space, 25.0).unwrap()
    };
    for known in MOVES {
        let wanted = made(known, 1.0);
        for size in HALF_SIZES {
            assert_eq!(
                made(known, size),
                carried(&wanted, size),
                "{} {size:e}",
                known.name
            );
        }
    }
}

fn poses(path: &CameraPath) -> Vec<Pose> {
    let sampler = Sampler::new(path, &Timeline::new(path).unwrap()).unwrap();
    let mut poses = vec![Pose::default(); sampler.frame_count()];
    sampler.sample(1, &mut poses).unwrap();
    poses
}

#[test]
fn fits() {
    let poses = poses(&path(&mut Random(43), 5));
    let fitted = |size: f64| {
        let mut poses = poses.clone();
        for pose in &mut poses {
            pose.vrp = (size * DVec3::from_array(pose.vrp)).to_array();
        }
        let tolerance = fit::Tolerance {
            position: 0.01 * size,
            angle: 0.5,
        };
        fit::fit(&poses, None, 25.0, &tolerance.into(), &mut |_, _| true)
            .unwrap()
            .path
    };
    let wanted = fitted(1.0);
    for size in [SMALL, 0.25 / SMALL] {
        let got = fitted(size);
        assert_eq!(
            got.space.half_size,
            size * wanted.space.half_size,
            "{size:e}"
        );
        for (got, wanted) in got.points.iter().zip(&mut wanted.points.clone()) {
            assert_eq!(got.position, size * wanted.position, "{size:e}");
            if let Target::Relative(offset) = &mut wanted.orientations[0].target {
                *offset *= size;
            }
            assert_eq!(got.orientations, wanted.orientations, "{size:e}");
        }
    }
}

#[test]
fn checks() {
    let mut random = Random(44);
    for _ in 0..10 {
        let path = path(&mut random, 5);
        let found = |size: f64| {
            let against = CheckContext {
                fps: 25.0,
                space: Some(
                    Space {
                        half_size: 0.5 * size,
                        ..Space::default()
                    }
                    .into(),
                ),
                object: None,
                limits: Limits::default(),
            };
            check(&carried(&path, size), &against).unwrap()
        };
        let wanted = found(1.0);
        assert!(!wanted.is_empty());
        for size in HALF_SIZES {
            assert_eq!(found(size), wanted, "{size:e}");
        }
    }
}
