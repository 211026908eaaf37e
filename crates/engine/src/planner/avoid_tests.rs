use super::*;
use crate::path::test_support::Random;
use crate::path::{CurveKind, SupportPoint, Target};
use crate::tools::check::{CheckContext, FindingKind, Limits, OFF, check};

fn vector(random: &mut Random) -> DVec3 {
    DVec3::from_array(std::array::from_fn(|_| 2.0 * random.unit() - 1.0))
}

/// A torus around the z axis, and its distance in closed form (but for its facets).
fn torus(ring: f64, tube: f64, count: [u32; 2]) -> Mesh {
    let [m, n] = count;
    let tau = std::f64::consts::TAU;
    let mut mesh = Mesh::default();
    for i in 0..m {
        for j in 0..n {
            let (a, b) = (
                tau * f64::from(i) / f64::from(m),
                tau * f64::from(j) / f64::from(n),
            );
            let far = ring + tube * b.cos();
            let point = DVec3::new(far * a.cos(), far * a.sin(), tube * b.sin());
            mesh.points.push(point);
            let at = |i: u32, j: u32| (i % m) * n + j % n;
            let [p, q, r, s] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            mesh.triangles.extend([[p, q, r], [p, r, s]]);
        }
    }
    mesh
}

/// A box of walls; `open` leaves out the one towards +x.
fn walls(half: DVec3, open: bool) -> Mesh {
    let corner = |k: u32| {
        let side = |bit: u32| f64::from(k >> bit & 1) * 2.0 - 1.0;
        half * DVec3::new(side(0), side(1), side(2))
    };
    let mut triangles = vec![
        [0, 2, 6],
        [0, 6, 4],
        [0, 1, 5],
        [0, 5, 4],
        [2, 3, 7],
        [2, 7, 6],
        [0, 1, 3],
        [0, 3, 2],
        [4, 5, 7],
        [4, 7, 6],
    ];
    if !open {
        triangles.extend([[1, 3, 7], [1, 7, 5]]);
    }
    Mesh {
        points: (0..8).map(corner).collect(),
        triangles,
        ..Mesh::default()
    }
}

fn through(places: &[DVec3]) -> CameraPath {
    let points = places.iter().map(|place| SupportPoint::new(*place));
    CameraPath {
        points: points.collect(),
        ..CameraPath::default()
    }
}

fn request(clearance: f64) -> AvoidRequest {
    AvoidRequest {
        clearance,
        radius: 0.0,
    }
}

/// No triangle is nearer at seven places a frame, counted without the tree.
fn nearest(path: &CameraPath, mesh: &Mesh) -> f64 {
    let sampler = Sampler::new(path, &Timeline::new(path).unwrap()).unwrap();
    let pieces: Vec<Clearance> = mesh
        .triangles
        .iter()
        .map(|corners| {
            let points = corners.map(|k| mesh.points[k as usize]).to_vec();
            let alone = Mesh {
                points,
                triangles: vec![[0, 1, 2]],
                ..Mesh::default()
            };
            Clearance::new(&alone).unwrap()
        })
        .collect();
    let count = 7 * (sampler.frame_count() - 1);
    (0..=count)
        .map(|k| sampler.pose(1.0 + k as f64 / 7.0).unwrap().position())
        .map(|place| {
            let far = |piece: &Clearance| piece.distance(place, 1e9).unwrap();
            pieces.iter().map(far).fold(f64::INFINITY, f64::min)
        })
        .fold(f64::INFINITY, f64::min)
}

fn findings(path: &CameraPath, mesh: &Mesh, clearance: f64) -> usize {
    let mut limits = Limits::default();
    for kind in FindingKind::all() {
        if kind != FindingKind::Through {
            limits.set(kind, OFF).unwrap();
        }
    }
    limits
        .set(FindingKind::Clearance, clearance / path.space.half_size)
        .unwrap();
    let against = CheckContext {
        fps: 25.0,
        space: None,
        object: Some(&Clearance::new(mesh).unwrap()),
        limits,
    };
    check(path, &against).unwrap().len()
}

#[test]
fn random_ways_keep_clear_of_a_ring() {
    let mesh = torus(0.5, 0.15, [24, 12]);
    let object = Clearance::new(&mesh).unwrap();
    let mut random = Random(77);
    let (mut changed, mut put_in) = (0, 0);
    for round in 0..60 {
        let count = 2 + round % 5;
        let clearance = 0.02 + 0.08 * random.unit();
        let mut places: Vec<DVec3> = Vec::new();
        while places.len() < count {
            let place = vector(&mut random);
            let end = places.is_empty() || places.len() + 1 == count;
            let ring = DVec3::new(place.x, place.y, 0.0).normalize() * 0.5;
            let free = ring.distance(place) > 0.15 && object.distance(place, clearance).is_none();
            if !end || free {
                places.push(place);
            }
        }
        let mut path = through(&places);
        path.curve = CurveKind::ALL[round % CurveKind::ALL.len()];
        path.closed = round % 4 == 3 && count > 2;
        for point in &mut path.points {
            point.orientations[0].target = Target::Absolute(DVec3::new(0.0, 0.0, 0.01));
        }
        let made = avoid(&path, &mesh, &request(clearance)).unwrap();
        let frames = |path: &CameraPath| Timeline::new(path).unwrap().frame_count().unwrap();
        assert_eq!(frames(&made.path), frames(&path), "{round}");
        let near = nearest(&made.path, &mesh);
        assert!(
            near >= clearance * (1.0 - 1e-9),
            "{round}: {near} {clearance}"
        );
        assert_eq!(findings(&made.path, &mesh, clearance), 0, "{round}");
        for point in &path.points {
            let same = |other: &SupportPoint| other.position == point.position;
            let ring = DVec3::new(point.position.x, point.position.y, 0.0).normalize() * 0.5;
            let free = ring.distance(point.position) > 0.15
                && object.distance(point.position, clearance).is_none();
            assert!(made.path.points.iter().any(same) || !free, "{round}");
        }
        changed += made.parts.len();
        put_in += made.parts.iter().map(|part| part.inserted).sum::<usize>();
    }
    assert!(changed > 30 && put_in < 4 * changed);
}

#[test]
fn a_closed_box_is_refused_and_an_open_one_gone_round() {
    let ways = [DVec3::new(-3.0, 0.1, 0.2), DVec3::new(0.1, 0.0, 0.1)];
    let mut path = through(&ways);
    path.space.half_size = 4.0;
    let closed = walls(DVec3::splat(1.0), false);
    let error = avoid(&path, &closed, &request(0.1)).unwrap_err();
    assert!(error.to_string().contains("at frame"));
    let open = walls(DVec3::splat(1.0), true);
    let made = avoid(&path, &open, &request(0.1)).unwrap();
    assert!(nearest(&made.path, &open) >= 0.1);
    assert_eq!(findings(&made.path, &open, 0.1), 0);
    // The other way: from within.
    path.points = path.points.shared().rev().cloned().collect();
    assert!(avoid(&path, &closed, &request(0.1)).is_err());
    assert!(nearest(&avoid(&path, &open, &request(0.1)).unwrap().path, &open) >= 0.1);
    // Through all of it.
    path.points[0].position = DVec3::new(3.0, 0.0, 0.3);
    let made = avoid(&path, &closed, &request(0.1)).unwrap();
    assert!(nearest(&made.path, &closed) >= 0.1);
    // A way within it, too near to a wall.
    let within = through(&[DVec3::new(-0.8, -0.97, 0.0), DVec3::new(0.8, -0.95, 0.1)]);
    let made = avoid(&within, &closed, &request(0.1)).unwrap();
    assert!(nearest(&made.path, &closed) >= 0.1);
    // No room at all.
    assert!(avoid(&within, &walls(DVec3::splat(1.0), false), &request(1.5)).is_err());
}

#[test]
fn lines_points_and_bad_requests() {
    let path = through(&[DVec3::new(-1.0, 0.0, 0.0), DVec3::new(1.0, 0.0, 0.0)]);
    let line = Mesh {
        points: vec![DVec3::new(0.0, -1.0, 0.0), DVec3::new(0.0, 1.0, 0.0)],
        lines: vec![[0, 1]],
        ..Mesh::default()
    };
    let cloud = Mesh {
        points: (0..50)
            .map(|k| DVec3::new(0.0, 0.0, f64::from(k) * 0.01))
            .collect(),
        ..Mesh::default()
    };
    for mesh in [&line, &cloud] {
        let made = avoid(&path, mesh, &request(0.1)).unwrap();
        assert_eq!(made.path.points.len(), 3);
        assert_eq!(findings(&made.path, mesh, 0.1), 0);
        // What is clear stays.
        let again = avoid(&made.path, mesh, &request(0.1)).unwrap();
        assert!(again.parts.is_empty() && again.path == made.path);
    }
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e300] {
        assert!(avoid(&path, &line, &request(bad)).is_err(), "{bad}");
        let request = AvoidRequest {
            clearance: 0.1,
            radius: bad,
        };
        assert_eq!(avoid(&path, &line, &request).is_err(), bad != 0.0, "{bad}");
    }
    assert!(avoid(&path, &Mesh::default(), &request(0.1)).is_err());
    // Far away, flat, a single place, and in one frame.
    let mut far = line.clone();
    far.points[0] = DVec3::splat(1e300);
    let _ = avoid(&path, &far, &request(0.1));
    far.points[0] = DVec3::splat(1e9);
    let _ = avoid(&path, &far, &request(0.1));
    let flat = Mesh {
        points: vec![DVec3::ZERO; 3],
        triangles: vec![[0, 1, 2]],
        ..Mesh::default()
    };
    assert_eq!(
        findings(
            &avoid(&path, &flat, &request(0.1)).unwrap().path,
            &flat,
            0.1
        ),
        0
    );
    let mut quick = path.clone();
    let own = &mut quick.points[0].orientations[0].own;
    *own = own.with(|own| own.frames = 1).unwrap();
    let error = avoid(&quick, &line, &request(0.1)).unwrap_err();
    assert!(error.to_string().contains("fewer frames"), "{error}");
    // Two equal points, on the object.
    let resting = through(&[DVec3::ZERO; 2]);
    let made = avoid(&resting, &line, &request(0.1)).unwrap();
    assert_eq!(findings(&made.path, &line, 0.1), 0);
    let stopped = avoid_object(
        &path,
        &Clearance::new(&line).unwrap(),
        &request(0.1),
        &mut |_, _| false,
    );
    assert!(stopped.is_err());
}
