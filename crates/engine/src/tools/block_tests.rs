use super::*;
use crate::path::own::{check_distance, distance_backwards};
use crate::path::test_support::Random;
use crate::path::{
    CurveKind, CurveParameters, Ease, Orientation, OrientationOverrides, Overrides, Pace, Pose,
    Sampler, Target, Tcb, Timeline, UpPath, UpVector, curve,
};

fn vector(random: &mut Random) -> DVec3 {
    DVec3::from_array(std::array::from_fn(|_| 2.0 * random.unit() - 1.0))
}

fn random_path(random: &mut Random) -> CameraPath {
    let count = 2 + (random.unit() * 6.0) as usize;
    let tcb = |random: &mut Random| {
        Tcb::new(
            random.unit() - 0.5,
            random.unit() - 0.5,
            random.unit() - 0.5,
        )
    };
    let points = (0..count).map(|_| {
        let mut point = SupportPoint::new(vector(random));
        point.curve = CurveParameters::Own(tcb(random));
        if random.unit() < 0.2 {
            let tangent = vector(random);
            point.tangents = Some(Tangents {
                before: tangent,
                after: 2.0 * tangent,
            });
        }
        let views = 1 + (random.unit() * 1.5) as usize;
        point.orientations = (0..views)
            .map(|_| Orientation {
                target: Target::Relative(vector(random)),
                roll: 100.0 * random.unit(),
                zoom: 1.0 + 99.0 * random.unit(),
                turning: tcb(random),
                speeds: std::array::from_fn(|_| 20.0 + 60.0 * random.unit()),
                hold: (3.0 * random.unit()) as u32,
                ..Orientation::default()
            })
            .collect();
        point
    });
    CameraPath {
        points: points.collect(),
        closed: random.unit() < 0.4,
        curve: if random.unit() < 0.5 {
            CurveKind::Cubic
        } else {
            CurveKind::Tcb
        },
        ..CameraPath::default()
    }
}

fn poses(path: &CameraPath) -> Vec<Pose> {
    let timeline = Timeline::new(path).unwrap();
    let sampler = Sampler::new(path, &timeline).unwrap();
    let mut poses = vec![Pose::default(); sampler.frame_count()];
    sampler.sample(1, &mut poses).unwrap();
    poses
}

fn far(a: &Pose, b: &Pose) -> f64 {
    let vectors = [(a.vrp, b.vrp), (a.vpn, b.vpn), (a.vup, b.vup)];
    let far = vectors.map(|(a, b)| (DVec3::from(a) - DVec3::from(b)).length());
    far.into_iter().fold((a.zoom - b.zoom).abs(), f64::max)
}

/// The largest distance between segments of two paths, the second ones counted
/// from `offset`.
fn curves_differ(a: &CameraPath, from: usize, b: &CameraPath, offset: usize, count: usize) -> f64 {
    let mut most = 0.0_f64;
    for k in 0..count {
        let one = curve::segment(a, (from + k) % a.segment_count());
        let two = curve::segment(b, (offset + k) % b.segment_count());
        for t in [0.0, 0.13, 0.5, 0.77, 1.0] {
            most = most.max((one.point(t) - two.point(t)).length());
        }
    }
    most
}

#[test]
fn a_block_has_the_curve_that_it_had() {
    let mut random = Random(3);
    for _ in 0..500 {
        let path = random_path(&mut random);
        let count = path.points.len();
        let first = (random.unit() * count as f64) as usize;
        let last = (random.unit() * count as f64) as usize;
        let Ok(block) = extract(&path, first, last) else {
            assert!(first == last || first > last && !path.closed);
            continue;
        };
        let segments = block.segment_count();
        assert!(curves_differ(&path, first, &block, 0, segments) < 1e-12);
    }
}

/// Other modes, views at one target, paces, and a last view twice, with another rest.
fn vary(path: &mut CameraPath, random: &mut Random) {
    use crate::path::{EaseKind, OrientationMode, ZoomMode};
    let modes = [
        OrientationMode::BarryGoldman,
        OrientationMode::Slerp,
        OrientationMode::Tcb,
    ];
    path.orientation_mode = modes[(3.0 * random.unit()) as usize];
    if random.unit() < 0.5 {
        path.zoom_mode = ZoomMode::Linear;
    }
    let target = Target::Absolute(DVec3::new(0.2, -6.0, 0.1));
    for point in &mut path.points {
        for view in &mut point.orientations {
            let kind = random.unit();
            if kind < 0.3 {
                view.target = target;
            }
            let ease = Ease {
                kind: EaseKind::Sine,
                rise: 0.2,
                fall: 0.4,
                cruise: 60.0,
            };
            let own = |own: &mut OrientationOverrides| {
                own.frames = (20.0 * random.unit()) as u32;
                if kind > 0.7 {
                    own.pace = Pace::Ease(ease);
                }
            };
            view.own = view.own.with(own).unwrap();
        }
        if random.unit() < 0.3 {
            let mut again = point.orientations[point.orientations.len() - 1].clone();
            again.hold += 3;
            again.turning = Tcb::new(0.3, 0.2, -0.4);
            point.orientations.push(again);
        }
    }
}

/// Four points, the middle section locked.
fn with_a_lock() -> CameraPath {
    let mut random = Random(8);
    let mut path = CameraPath::default();
    path.points = std::array::from_fn::<_, 4, _>(|_| path.points[0].clone()).into();
    for point in &mut path.points {
        point.position = vector(&mut random);
    }
    let own = &mut path.points[1].orientations[0].own;
    let lock = |own: &mut OrientationOverrides| (own.frames, own.locked) = (20, true);
    *own = own.with(lock).unwrap();
    path
}

fn locks(path: &CameraPath) -> Vec<bool> {
    let own = |point: &SupportPoint| point.orientations.iter().any(|view| view.own.locked);
    path.points.iter().map(own).collect()
}

#[test]
fn a_lock_goes_with_its_section() {
    let path = with_a_lock();
    assert_eq!(locks(&path), [false, true, false, false]);
    assert_eq!(locks(&reverse(&path).unwrap()), [false, true, false, false]);
    let mut other = path.clone();
    other.points.remove(0);
    assert_eq!(locks(&reverse(&other).unwrap()), [false, true, false]);
    // The way that began at the joint goes on behind the block, as its pace does.
    let done = insert(&path, 1, &CameraPath::default(), Fit::Move, true).unwrap();
    let whole = [false, false, true, false, false];
    assert_eq!(locks(&done.path), whole);
    let done = insert(&path, 0, &other, Fit::Move, true).unwrap();
    assert_eq!(locks(&done.path), [true, false, false, true, false, false]);
}

#[test]
fn a_film_of_the_reversed_path_runs_backwards() {
    let mut random = Random(4);
    for number in 0..300 {
        let mut path = random_path(&mut random);
        if number % 3 == 2 {
            vary(&mut path, &mut random);
        }
        let back = reverse(&path).unwrap();
        let (one, two) = (poses(&path), poses(&back));
        assert_eq!(one.len(), two.len(), "{number}");
        if path.closed {
            // Its last pose is the first again.
            let count = one.len() - 1;
            let same = |shift: usize| {
                let backwards = (0..count).map(|k| &two[(shift + count - k) % count]);
                one.iter().zip(backwards).all(|(a, b)| far(a, b) < 1e-8)
            };
            let first = path.points[0].orientations.len() == 1;
            let hold = path.points[0].orientations[0].hold as usize;
            let found = (0..count).find(|shift| same(*shift));
            assert!(found.is_some(), "{number}");
            // From the same key; the rest in it comes first both ways.
            assert!(!first || same(hold), "{number}");
            continue;
        }
        for (a, b) in one.iter().zip(two.iter().rev()) {
            assert!(far(a, b) < 1e-8, "{number}: {}", far(a, b));
        }
        let again = reverse(&back).unwrap();
        for (a, b) in one.iter().zip(&poses(&again)) {
            assert!(far(a, b) < 1e-10, "{number}");
        }
    }
}

#[test]
fn keys_of_a_given_distance_go_backwards_however_near_they_lie() {
    let tiny = [[0.0, 0.0], [0.3, 1e-300], [0.3 + 1e-9, 1e-18], [1.0, 1.0]];
    let late = [[0.0, 0.0], [1e-9, 1e-17], [0.5, 0.25], [1.0, 1.0]];
    for keys in [&tiny[..], &late[..], &[[0.0, 0.0], [0.5, 0.25], [1.0, 1.0]]] {
        check_distance(keys).unwrap();
        let back = distance_backwards(keys);
        check_distance(&back).unwrap();
        let again = distance_backwards(&back);
        check_distance(&again).unwrap();
        assert!(again.iter().all(|key| {
            keys.iter()
                .any(|old| (old[0] - key[0]).abs() + (old[1] - key[1]).abs() < 1e-15)
        }));
    }
}

#[test]
fn ups_are_kept_backwards_and_in_parts() {
    let mut random = Random(14);
    for number in 0..60 {
        let mut path = random_path(&mut random);
        path.closed &= number % 2 == 0;
        let second = UpPath::of(&random_path(&mut random)).unwrap();
        let up = match number % 3 {
            0 => UpVector::Minimal,
            1 => UpVector::Point(DVec3::new(0.3, 5.0, -0.4)),
            _ => UpVector::Path(second),
        };
        let target = Target::Absolute(DVec3::new(0.2, -6.0, 0.1));
        for orientation in path.points.iter_mut().flat_map(|p| &mut p.orientations) {
            orientation.target = target;
            orientation.hold = 0;
            orientation.own = Overrides::default()
                .with(|own| own.up = up.clone())
                .unwrap();
        }
        let back = reverse(&path).unwrap();
        if !path.closed {
            for (a, b) in poses(&path).iter().zip(poses(&back).iter().rev()) {
                assert!(far(a, b) < 1e-6, "{number}: {}", far(a, b));
            }
        }
        let count = path.points.len();
        let part = extract(&path, 1, count - 1).unwrap_or_else(|_| path.clone());
        if part.points.len() == count - 1 {
            let (all, some) = (
                alignment::ups(&path).unwrap(),
                alignment::ups(&part).unwrap(),
            );
            let skipped = path.points[0].orientations.len();
            for (a, b) in all[skipped..].iter().zip(&some) {
                assert!((*a - *b).length() < 1e-9, "{number}");
            }
        }
    }
}

#[test]
fn joins_are_smooth_and_all_else_stays() {
    let mut random = Random(5);
    let mut joined = 0;
    for number in 0..600 {
        let (path, block) = (random_path(&mut random), random_path(&mut random));
        let at = (random.unit() * path.points.len() as f64) as usize;
        let fit = [Fit::None, Fit::Move, Fit::Turn, Fit::Scale][number % 4];
        let Ok(done) = insert(&path, at, &block, fit, true) else {
            assert!(fit == Fit::Scale && (at + 1 == path.points.len() || block.closed));
            continue;
        };
        joined += 1;
        let new = &done.path;
        assert_eq!(new.points.len(), path.points.len() + done.count);
        let old = (0..path.points.len()).map(|k| if k > at { k + done.count } else { k });
        for (k, moved) in old.enumerate() {
            assert_eq!(new.points[moved].position, path.points[k].position);
            assert_eq!(
                new.points[moved].orientations.len(),
                path.points[k].orientations.len()
            );
            if path.points[k] != new.points[moved] {
                assert!(done.changed.contains(&moved));
            }
        }
        if fit != Fit::None {
            let own = curve::tangents(new, at);
            // Where there is a direction at all.
            let (a, b) = (
                own.before.normalize_or_zero(),
                own.after.normalize_or_zero(),
            );
            let none = a == DVec3::ZERO || b == DVec3::ZERO;
            assert!(
                none || (a - b).length() < 1e-12,
                "{number} {fit:?}: {a} {b}"
            );
        }
        // Behind the block the old way goes on as it was.
        if at + 2 < path.points.len() {
            let rest = path.points.len() - at - 2;
            let first = usize::from(fit == Fit::Scale);
            let behind = at + 1 + done.count;
            if rest > first {
                let off = curves_differ(&path, at + 1 + first, new, behind + first, rest - first);
                assert!(off < 1e-11, "{number} {fit:?}: {off}");
            }
        }
        if let (Fit::Turn, false) = (fit, block.closed) {
            let before = travel(&path, at).unwrap();
            let after = curve::tangents(new, at).after.normalize();
            assert!((before - after).length() < 1e-12);
        }
    }
    assert!(joined > 300);
}

#[test]
fn a_block_keeps_its_shape_where_it_is_put() {
    let mut random = Random(6);
    for _ in 0..100 {
        let (path, block) = (random_path(&mut random), random_path(&mut random));
        let done = insert(&path, path.points.len() - 1, &block, Fit::None, true).unwrap();
        let segments = block.segment_count();
        assert!(curves_differ(&block, 0, &done.path, done.at, segments) < 1e-12);
    }
}

#[test]
fn repeated_paths_go_on_where_they_end() {
    let mut random = Random(7);
    for times in [1, 2, 3, 7] {
        let mut path = random_path(&mut random);
        path.closed = false;
        path.points[0].name = Some("start".to_owned());
        let all = repeat(&path, times).unwrap();
        let count = path.points.len() - 1;
        assert_eq!(all.points.len(), times * count + 1);
        let step = path.points[count].position - path.points[0].position;
        for (k, point) in all.points.iter().enumerate().skip(1) {
            let (round, at) = ((k - 1) / count, (k - 1) % count + 1);
            let want = path.points[at].position + round as f64 * step;
            assert!((point.position - want).length() < 1e-12);
        }
        path.closed = true;
        let all = repeat(&path, times).unwrap();
        assert_eq!(all.points.len(), times * (count + 1));
        let mut names: Vec<_> = all.points.iter().filter_map(|p| p.name.clone()).collect();
        names.dedup();
        assert_eq!(names.len(), times);
    }
    assert!(repeat(&CameraPath::default(), 0).is_err());
    assert!(repeat(&CameraPath::default(), 60_000).is_err());
}
