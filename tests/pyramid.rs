//! `examples/pyramid.vid`: the flight of thesis 7.5 around the pyramid of its
//! Anhang C.

use std::path::Path;

use vides::document::Document;
use vides::path::Pose;

fn pyramid() -> Document {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/pyramid.vid");
    Document::load(Path::new(file)).unwrap()
}

/// The object of the thesis's Anhang C: ten points, a line to each but the
/// first and the eighth.
#[test]
fn the_pyramid_is_that_of_the_thesis() {
    let document = pyramid();
    let (a, b, c, d) = (
        [0.3, 0.0, 0.3],
        [0.3, 0.0, -0.3],
        [-0.3, 0.0, -0.3],
        [-0.3, 0.0, 0.3],
    );
    let top = [0.0, 0.5, 0.0];
    let object = document.info().object.iter();
    let found: Vec<_> = object.map(|p| (p.position.to_array(), p.draw)).collect();
    let points = [a, b, c, d, a, top, b, c, top, d];
    let expected: Vec<_> = points
        .into_iter()
        .enumerate()
        .map(|(index, point)| (point, index != 0 && index != 7))
        .collect();
    assert_eq!(found, expected);
}

/// The camera stays in the movement space and clear of the pyramid, and sees
/// its top in the middle of the picture wherever it is on the way.
#[test]
fn the_flight_leads_around_the_pyramid() {
    let document = pyramid();
    let sampler = document.sampler().unwrap();
    let mut poses = vec![Pose::default(); sampler.frame_count()];
    sampler.sample(1, &mut poses).unwrap();
    let mut around = 0.0;
    for (pose, next) in poses.iter().zip(&poses[1..]) {
        let [x, y, z] = pose.vrp;
        assert!(x.abs().max(y.abs()).max(z.abs()) < 1.0, "{pose:?}");
        // Half the pyramid's width at this height.
        let half = (0.3 * (1.0 - y / 0.5)).max(0.0);
        assert!(x.abs().max(z.abs()) > half + 0.3, "{pose:?}");
        let step = next.vrp[0].atan2(next.vrp[2]) - x.atan2(z);
        around += step - std::f64::consts::TAU * (step / std::f64::consts::TAU).round();
        if next.vrp != pose.vrp {
            let to_top = [-x, 0.5 - y, -z];
            let length = to_top.iter().map(|x| x * x).sum::<f64>().sqrt();
            let miss = (0..3).map(|i| (to_top[i] / length - pose.vpn[i]).abs());
            assert!(miss.fold(0.0, f64::max) < 1e-12, "{pose:?}");
        }
    }
    // From the left in front of it, behind it, to the right in front of it.
    assert!((-300.0..-250.0).contains(&around.to_degrees()), "{around}");
}
