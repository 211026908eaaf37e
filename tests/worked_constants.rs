//! The thesis's own numbers: presets, the pyramid of its host program, what an
//! orientation is as a quaternion, what a zoom is as a field of view.

mod common;

use std::f64::consts::{FRAC_1_SQRT_2, PI};

use common::{all_poses, prepared};
use glam::{DQuat, DVec3, DVec4};
use vides::document::{Document, Edit};
use vides::math::orientation::{
    level_axes, quaternion_from_view, roll_from_up, up_from_roll, view_from_quaternion,
    wrap_degrees,
};
use vides::math::view::View;
use vides::path::{CameraPath, CurveParameters, Orientation, Overrides, Target, Tcb};

/// Thesis A.6.1.
#[test]
fn the_ten_presets() {
    let want = [
        [0.0, 0.0, 0.0],
        [0.3, 0.0, 0.0],
        [0.6, 0.0, 0.0],
        [-0.3, 0.0, 0.0],
        [-0.6, 0.0, 0.0],
        [0.0, -0.5, 0.0],
        [0.0, 0.5, 0.0],
        [0.0, 0.0, 0.5],
        [0.0, 0.0, -0.5],
        [0.0, 0.0, 0.0],
    ]
    .map(|[t, c, b]| Tcb::new(t, c, b));
    assert_eq!(CameraPath::default().presets, want);
    assert_eq!(Document::new().path().presets, want);
}

#[test]
fn the_path_of_a_new_window() {
    let path = CameraPath::default();
    assert_eq!(Document::new().path(), &path);
    assert_eq!(path.points.len(), 2);
    for (point, x) in path.points.iter().zip([-0.6, 0.6]) {
        assert_eq!(point.position, DVec3::new(x, 0.2, 0.8));
        assert_eq!(point.curve, CurveParameters::Preset(0));
        let all = Orientation {
            target: Target::Relative(DVec3::new(0.0, 0.0, -0.4)),
            roll: 0.0,
            zoom: 24.0,
            turning: Tcb::new(0.0, 0.0, 0.0),
            speeds: [50.0; 10],
            hold: 0,
            own: Overrides::default(),
        };
        assert_eq!(point.orientations, [all]);
    }
    assert!(!path.closed);
    // With the speed of Anhang C, 100: 1.2 · 100 frames to the right, looking
    // along −z all the way.
    let poses = all_poses(&prepared(&path).1);
    assert_eq!(poses.len(), 121);
    for (n, pose) in poses.iter().enumerate() {
        let x = -0.6 + 0.01 * n as f64;
        assert!((DVec3::from(pose.vrp) - DVec3::new(x, 0.2, 0.8)).length() < 1e-15);
        assert_eq!((pose.vpn, pose.vup), ([0.0, 0.0, -1.0], [0.0, 1.0, 0.0]));
        assert_eq!(pose.zoom, 24.0);
    }
}

/// The ten lines of Anhang C's host program: a square foot and four edges.
#[test]
fn the_flight_goes_around_the_pyramid_of_the_thesis() {
    let want: [([f64; 3], bool); 10] = [
        ([0.3, 0.0, 0.3], false),
        ([0.3, 0.0, -0.3], true),
        ([-0.3, 0.0, -0.3], true),
        ([-0.3, 0.0, 0.3], true),
        ([0.3, 0.0, 0.3], true),
        ([0.0, 0.5, 0.0], true),
        ([0.3, 0.0, -0.3], true),
        ([-0.3, 0.0, -0.3], false),
        ([0.0, 0.5, 0.0], true),
        ([-0.3, 0.0, 0.3], true),
    ];
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/pyramid.vid");
    let document = Document::load(file.as_ref()).unwrap();
    let object: Vec<_> = document
        .info()
        .object
        .iter()
        .map(|point| (point.position.to_array(), point.draw))
        .collect();
    assert_eq!(object, want);
    // Eight edges, each drawn once.
    let mut edges: Vec<_> = object
        .windows(2)
        .filter(|pair| pair[1].1)
        .map(|pair| {
            let mut ends = [format!("{:?}", pair[0].0), format!("{:?}", pair[1].0)];
            ends.sort();
            ends
        })
        .collect();
    edges.sort();
    edges.dedup();
    assert_eq!(edges.len(), 8);
    // The corner of 7.5: several orientations, continuity −0.5.
    let path = document.path();
    let corner = (0..path.points.len()).find(|&i| path.points[i].orientations.len() > 1);
    assert_eq!(path.tcb(corner.unwrap()), Tcb::new(0.0, -0.5, 0.0));
}

/// Yaw, pitch and roll in degrees, the view and the up vector: by hand.
#[test]
fn euler_angles_of_4_4_5() {
    let s = FRAC_1_SQRT_2;
    let table = [
        ([0.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 1.0, 0.0]),
        ([90.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]),
        ([180.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]),
        ([-90.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 1.0, 0.0]),
        // Positive pitch looks down.
        ([0.0, 45.0, 0.0], [0.0, -s, s], [0.0, s, s]),
        ([0.0, -45.0, 0.0], [0.0, s, s], [0.0, s, -s]),
        ([90.0, 45.0, 0.0], [s, -s, 0.0], [s, s, 0.0]),
        // Roll turns x towards y: the up vector goes to −x.
        ([0.0, 0.0, 90.0], [0.0, 0.0, 1.0], [-1.0, 0.0, 0.0]),
        ([0.0, 0.0, -90.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]),
        ([0.0, 0.0, 180.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]),
        ([90.0, 0.0, 90.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]),
        // Yaw first, then pitch about the turned x axis, then roll.
        ([90.0, 45.0, 90.0], [s, -s, 0.0], [0.0, 0.0, 1.0]),
        // Straight down and up: the yaw is 0.
        ([0.0, 90.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0]),
        ([0.0, -90.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, -1.0]),
    ];
    for (angles, view, up) in table {
        let [yaw, pitch, roll] = angles.map(f64::to_radians);
        let (view, up) = (DVec3::from(view), DVec3::from(up));
        // The three quaternions of 4.4.5, multiplied by hand.
        let about = |axis: DVec3, angle: f64| {
            let v = axis * (angle / 2.0).sin();
            DQuat::from_xyzw(v.x, v.y, v.z, (angle / 2.0).cos())
        };
        let q = about(DVec3::Y, yaw) * about(DVec3::X, pitch) * about(DVec3::Z, roll);
        let (n, v) = view_from_quaternion(q);
        assert!((n - view).length() < 1e-15, "{angles:?}: {n}");
        assert!((v - up).length() < 1e-15, "{angles:?}: {v}");
        // Vectors and roll give the same orientation back.
        assert!(
            (up_from_roll(view, roll) - up).length() < 1e-15,
            "{angles:?}"
        );
        let back = wrap_degrees(roll_from_up(view, up).to_degrees() - angles[2]);
        assert!(back.abs() < 1e-13, "{angles:?}");
        let again = quaternion_from_view(view, up);
        let same = DVec4::from(again).dot(DVec4::from(q)).abs();
        assert!((same - 1.0).abs() < 1e-15, "{angles:?}");
    }
    // A quaternion is given as w, x, y, z: yaw 90° is (√½, 0, √½, 0).
    let q = quaternion_from_view(DVec3::X, DVec3::Y);
    let q = if q.w < 0.0 { -q } else { q };
    for (component, want) in [q.w, q.x, q.y, q.z].into_iter().zip([s, 0.0, s, 0.0]) {
        assert!((component - want).abs() < 1e-15);
    }
}

/// Nearer than 1e-12 to a pole the yaw is 0, farther away it is what it is.
#[test]
fn the_pole_begins_at_1e_12() {
    for sign in [1.0, -1.0] {
        let beside = |x: f64| DVec3::new(x, sign, 0.0);
        // Yaw 0: the turned x axis is x itself.
        assert_eq!(level_axes(beside(0.9e-12)).0, DVec3::X);
        // Yaw 90°: it is −z.
        assert_eq!(level_axes(beside(1.1e-12)).0, -DVec3::Z);
        assert_eq!(level_axes(beside(-1.1e-12)).0, DVec3::Z);
    }
}

#[test]
fn roll_is_kept_between_minus_180_and_180() {
    let table = [
        (180.0, 180.0),
        (-180.0, 180.0),
        (190.0, -170.0),
        (-190.0, 170.0),
        (540.0, 180.0),
        (360.0, 0.0),
        (-179.9, -179.9),
        (725.0, 5.0),
    ];
    for (degrees, want) in table {
        assert_eq!(wrap_degrees(degrees), want);
        let mut document = Document::new();
        document
            .apply(Edit::SetOrientation {
                point: 0,
                at: 0,
                orientation: Orientation {
                    roll: degrees,
                    ..Orientation::default()
                },
            })
            .unwrap();
        assert_eq!(document.path().points[0].orientations[0].roll, want);
    }
}

/// Zoom is the focal length of a 36×24 mm camera: what lies half the vertical
/// field of view, atan(12/zoom), above the axis is at the picture's upper edge, y = z in the unit pyramid.
#[test]
fn zoom_is_a_focal_length_in_millimetres() {
    // 12 mm see 90°, 12·√3 mm see 60°, 12·(1+√2) mm see 45°.
    let table = [
        (12.0, PI / 2.0),
        (12.0 * 3f64.sqrt(), PI / 3.0),
        (12.0 * (1.0 + 2f64.sqrt()), PI / 4.0),
        (24.0, 2.0 * 0.5f64.atan()),
    ];
    for (zoom, field) in table {
        let aspect = 1.5;
        let view = View::from_pose(
            DVec3::new(1.0, 2.0, 3.0),
            DVec3::X,
            DVec3::Y,
            zoom,
            aspect,
            0.1,
            100.0,
        )
        .unwrap();
        let matrix = view.matrix().unwrap();
        let (sin, cos) = (field / 2.0).sin_cos();
        for distance in [1.0, 7.0] {
            let edge = DVec3::new(1.0, 2.0, 3.0) + distance * DVec3::new(cos, sin, 0.0);
            let seen = matrix * edge.extend(1.0);
            assert!((seen.y / seen.z - 1.0).abs() < 1e-14, "{zoom}: {seen}");
            // 36 : 24, to the right of the view direction.
            let side = DVec3::new(cos, 0.0, aspect * sin);
            let edge = DVec3::new(1.0, 2.0, 3.0) + distance * side;
            let seen = matrix * edge.extend(1.0);
            assert!((seen.x / seen.z - 1.0).abs() < 1e-14, "{zoom}: {seen}");
        }
    }
}
