use glam::DVec3;

use super::*;
use crate::error::Error;
use crate::path::insertion::tests::random_path;
use crate::path::test_support::Random;
use crate::path::{Sampler, Target, Timeline};
use crate::tools::check::{CheckContext, FindingKind, OFF, check};

/// Paths of each kind that are tried here; `make check-planning` tries more.
const COUNT: usize = 6;

fn object(random: &mut Random, size: f64) -> Mesh {
    let mut corner =
        || DVec3::from_array(std::array::from_fn(|_| size * (2.0 * random.unit() - 1.0)));
    Mesh {
        points: (0..60).map(|_| corner()).collect(),
        triangles: (0..20).map(|k| [3 * k, 3 * k + 1, 3 * k + 2]).collect(),
        ..Mesh::default()
    }
}

fn request(what: What) -> PictureRequest {
    PictureRequest {
        margin: 0.1,
        what,
        limits: Limits::default(),
        fps: 25.0,
    }
}

/// The greatest share of the room that any corner takes at 20 places a frame, anew for each corner.
fn seen(path: &CameraPath, object: &Mesh, margin: f64) -> f64 {
    let sampler = Sampler::new(path, &Timeline::new(path).unwrap()).unwrap();
    let mut most = 0.0_f64;
    for k in 0..=20 * (sampler.frame_count() - 1) {
        let pose = sampler.pose(1.0 + k as f64 / 20.0).unwrap();
        for point in &object.points {
            let way = *point - pose.position();
            let right = pose.view().cross(pose.up());
            let depth = way.dot(pose.view());
            if depth <= 0.0 {
                return f64::INFINITY;
            }
            let [x, y] = [way.dot(right) / 18.0, way.dot(pose.up()) / 12.0];
            most = most.max(x.abs().max(y.abs()) * pose.zoom / depth / (1.0 - 2.0 * margin));
        }
    }
    most
}

/// Paths of all kinds, from afar, with a common target in the middle.
fn path(random: &mut Random, number: usize) -> CameraPath {
    let mut path = random_path(random, number);
    for point in &mut path.points {
        let way = point.position.try_normalize().unwrap_or(DVec3::X);
        point.position = way * (2.0 + random.unit());
        point.tangents = None;
        for orientation in &mut point.orientations {
            orientation.target = Target::Absolute(DVec3::splat(0.05));
            orientation.own = orientation.own.with(|own| own.ahead = None).unwrap();
        }
    }
    path
}

#[test]
fn the_zoom_shows_all_of_it() {
    let mut random = Random(5);
    let mut tried = 0;
    for number in 0..COUNT {
        let path = path(&mut random, number);
        if path.check().is_err() {
            continue;
        }
        let object = object(&mut random, 0.4);
        let made = match keep_in_picture(&path, &object, &request(What::Zoom)) {
            Ok(made) => made,
            // A zoom below 1 mm.
            Err(Error::Argument(_)) => continue,
            Err(error) => panic!("{number}: {error}"),
        };
        tried += 1;
        let share = seen(&made.path, &object, 0.1);
        let mut limits = Limits::default();
        limits.set(FindingKind::HalfTurn, OFF).unwrap();
        let against = CheckContext {
            fps: 25.0,
            space: None,
            object: None,
            limits,
        };
        let found = check(&made.path, &against).unwrap();
        assert!(
            !found
                .iter()
                .any(|finding| finding.kind == FindingKind::Zoom),
            "{number}"
        );
        let places = |path: &CameraPath| {
            let sampler = Sampler::new(path, &Timeline::new(path).unwrap()).unwrap();
            sampler.iter().collect::<Result<Vec<_>>>().unwrap()
        };
        for (a, b) in places(&path).iter().zip(places(&made.path)) {
            assert!((a.position() - b.position()).length() < 1e-8, "{number}");
            assert!(
                (a.view() - b.view()).length() < 1e-6 && (a.up() - b.up()).length() < 1e-6,
                "{number}"
            );
        }
        assert!((0.99..=1.0).contains(&share), "{number}: {share}");
        assert!((made.tightest - share).abs() < 1e-4);
        let frames = |path: &CameraPath| Timeline::new(path).unwrap().frame_count().unwrap();
        assert_eq!(frames(&path), frames(&made.path));
        let again = keep_in_picture(&made.path, &object, &request(What::Zoom)).unwrap();
        assert_eq!(again.path, made.path);
    }
    assert!(2 * tried > COUNT, "{tried}");
}

#[test]
fn distance_and_view_show_all_of_it() {
    let mut random = Random(11);
    for what in [What::Distance, What::View] {
        let mut tried = 0;
        for number in 0..COUNT {
            let mut path = path(&mut random, number);
            if path.check().is_err() {
                continue;
            }
            for orientation in path
                .points
                .iter_mut()
                .flat_map(|point| &mut point.orientations)
            {
                orientation.zoom = 14.0 + 6.0 * random.unit();
                if what == What::View {
                    let aside =
                        DVec3::from_array(std::array::from_fn(|_| 1.4 * random.unit() - 0.7));
                    orientation.target = Target::Absolute(aside);
                    orientation.zoom = 10.0;
                }
            }
            let object = object(&mut random, 0.4);
            let was = seen(&path, &object, 0.1);
            let made = match keep_in_picture(&path, &object, &request(what)) {
                Ok(made) => made,
                // Too large wherever it turns, or in the way.
                Err(Error::Argument(_)) => continue,
                Err(error) => panic!("{number}: {error}"),
            };
            tried += 1;
            let share = seen(&made.path, &object, 0.1);
            assert!(share <= 1.0, "{what:?} {number}: {share}");
            if was <= 1.0 && what == What::View {
                assert_eq!(made.path, path);
            } else {
                assert!(share >= 0.99, "{what:?} {number}: {share}");
            }
            let frames = |path: &CameraPath| Timeline::new(path).unwrap().frame_count().unwrap();
            assert_eq!(frames(&path), frames(&made.path));
        }
        assert!(2 * tried > COUNT, "{tried}");
    }
}

fn square(z: f64, half: f64) -> Mesh {
    Mesh {
        points: [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]
            .map(|[x, y]| DVec3::new(half * x, half * y, z))
            .to_vec(),
        triangles: vec![[0, 1, 2], [0, 2, 3]],
        ..Mesh::default()
    }
}

/// Straight ahead to a square: the zoom in closed form, 12·(1 − 2·margin)·depth/half.
#[test]
fn a_square_ahead_has_the_zoom_of_its_height() {
    let mut path = CameraPath::default();
    for (point, x) in path.points.iter_mut().zip([-0.5, 0.5]) {
        point.position = DVec3::new(0.0, 0.0, x);
    }
    let mut wanted = request(What::Zoom);
    wanted.margin = 0.05;
    let made = keep_in_picture(&path, &square(-2.0, 0.4), &wanted).unwrap();
    let sampler = Sampler::new(&made.path, &Timeline::new(&made.path).unwrap()).unwrap();
    let first = 12.0 * 0.9 * 1.5 / 0.4;
    assert!((sampler.pose(1.0).unwrap().zoom / first - 1.0).abs() < 0.01);
    for k in 1..=sampler.frame_count() {
        let pose = sampler.pose(k as f64).unwrap();
        let most = 12.0 * 0.9 * (pose.vrp[2] + 2.0) / 0.4;
        assert!(pose.zoom <= most && pose.zoom > 0.93 * most, "{k}");
    }
    // By the distance: as far as the zoom of 24 mm asks, everywhere the same.
    wanted.what = What::Distance;
    let made = keep_in_picture(&path, &square(-2.0, 0.4), &wanted).unwrap();
    let frames = |path: &CameraPath| Timeline::new(path).unwrap().frame_count().unwrap();
    assert_eq!(frames(&made.path), frames(&path));
    for point in &made.path.points {
        let depth = 24.0 * 0.4 / (12.0 * 0.9);
        assert!(
            (point.position.z + 2.0 - depth).abs() < 0.01 * depth,
            "{point:?}"
        );
    }
}

/// A half turn about the middle, one view with all of the object at the margin's edge.
#[test]
fn one_orientation_shows_all_of_it() {
    let path = CameraPath::default();
    let mesh = square(-2.0, 0.4);
    let tree = Clearance::new(&mesh).unwrap();
    let mut made = path.try_clone().unwrap();
    for point in 0..2 {
        made.points[point].orientations[0] =
            orientation_towards(&path, (point, 0), &tree, 0.1).unwrap();
    }
    let sampler = Sampler::new(&made, &Timeline::new(&made).unwrap()).unwrap();
    let pose = sampler.pose(1.0).unwrap();
    let mut outline = Outline::new(&tree).unwrap();
    let reach = outline.reach(&Camera::from(&pose)).unwrap();
    let share = (reach[0].max(reach[1]) / 18.0).max(reach[2].max(reach[3]) / 12.0);
    assert!((share * pose.zoom - 0.8).abs() < 1e-4);
    assert!(orientation_towards(&path, (0, 9), &tree, 0.1).is_err());
    assert!(orientation_towards(&path, (9, 0), &tree, 0.1).is_err());
}

#[test]
fn what_cannot_be_is_refused_and_says_where() {
    let path = CameraPath::default();
    let mesh = square(-2.0, 0.4);
    for margin in [-0.1, 0.5, f64::NAN, f64::INFINITY] {
        let wanted = PictureRequest {
            margin,
            ..request(What::Zoom)
        };
        assert!(keep_in_picture(&path, &mesh, &wanted).is_err());
    }
    for fps in [0.0, f64::NAN, f64::INFINITY] {
        let wanted = PictureRequest {
            fps,
            ..request(What::Zoom)
        };
        assert!(keep_in_picture(&path, &mesh, &wanted).is_err());
    }
    let said = |mesh: &Mesh, what| {
        keep_in_picture(&path, mesh, &request(what))
            .unwrap_err()
            .to_string()
    };
    // Around the camera; beyond any zoom; a place; nothing; not a number.
    assert!(said(&square(0.9, 0.4), What::Zoom).contains("not all of the object is before"));
    assert!(said(&square(-2.0, 900.0), What::Zoom).contains("below the least"));
    assert!(said(&square(-2.0, 90.0), What::View).contains("too large"));
    assert!(said(&square(-2.0, 0.0), What::Distance).contains("single place"));
    assert!(said(&Mesh::default(), What::View).contains("geometry"));
    for bad in [f64::NAN, 1e300] {
        for what in What::ALL {
            said(&square(bad, 0.4), what);
        }
    }
    // Two points at one place, and an object around both.
    let mut still = path.try_clone().unwrap();
    still.points[1] = still.points[0].try_clone().unwrap();
    for what in What::ALL {
        let made = keep_in_picture(&still, &square(-2.0, 0.4), &request(what)).unwrap();
        assert!(seen(&made.path, &square(-2.0, 0.4), 0.1) <= 1.0);
    }
}
