use glam::DVec3;

use super::*;
use crate::path::insertion::tests::random_path;
use crate::path::test_support::Random;
use crate::path::{Sampler, Target, Timeline};
use crate::tools::check::{CheckContext, FindingKind, OFF, check};

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
    for number in 0..60 {
        let path = path(&mut random, number);
        if path.check().is_err() {
            continue;
        }
        let object = object(&mut random, 0.4);
        let made = match keep_in_picture(&path, &object, &request(What::Zoom)) {
            Ok(made) => made,
            Err(error) => {
                println!("{number}: {error}");
                continue;
            }
        };
        tried += 1;
        let share = seen(&made.path, &object, 0.1);
        println!(
            "{number}: {share} loosest {} added {} of {}",
            made.loosest,
            made.added,
            path.points.len()
        );
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
    assert!(tried > 40, "{tried}");
}
