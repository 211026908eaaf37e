//! The view against plain geometry: rays through eye and window, and lengths
//! along the normal. Nothing here multiplies matrices but the checks of
//! single formulas, each named.

use glam::dcamera::rh::proj::opengl;
use glam::{DMat3, DMat4, DVec3};
use proptest::prelude::*;

use super::*;
use crate::math::transform::{axis_to_z, rotation_z};

fn vector(range: f64) -> impl Strategy<Value = DVec3> {
    prop::array::uniform3(-range..range).prop_map(DVec3::from_array)
}

/// Directions with two zero components too: the axes are what breaks first.
fn direction() -> impl Strategy<Value = DVec3> {
    prop_oneof![
        4 => vector(2.0),
        1 => (0..6usize, 0.1..3.0f64).prop_map(|(k, s)| {
            let mut v = [0.0; 3];
            v[k / 2] = if k % 2 == 0 { s } else { -s };
            DVec3::from_array(v)
        }),
    ]
}

fn view() -> impl Strategy<Value = View> {
    (
        (vector(10.0), direction(), direction()),
        (vector(3.0), -3.0..3.0f64, -3.0..3.0f64),
        (0.2..4.0f64, 0.2..4.0f64),
        (0.2..5.0f64, 0.2..5.0f64, 0.2..5.0f64),
        any::<bool>(),
    )
        .prop_map(|(frame, window, half, depth, perspective)| View {
            vrp: frame.0,
            normal: frame.1,
            up: frame.2,
            prp: window.0,
            window: [
                window.1 - half.0,
                window.1 + half.0,
                window.2 - half.1,
                window.2 + half.1,
            ],
            front: window.0.z - depth.0,
            back: window.0.z - depth.0 - depth.1,
            distance: window.0.z - depth.2,
            perspective,
        })
        .prop_filter("up along the normal", |view| {
            view.normal.length() > 0.1
                && view.up.length() > 0.1
                && view.normal.normalize().cross(view.up.normalize()).length() > 0.05
        })
}

/// The axes u, v, n by Gram–Schmidt on the up vector.
fn axes(view: &View) -> (DVec3, DVec3, DVec3) {
    let n = view.normal / view.normal.length();
    let v = view.up - n * view.up.dot(n);
    let v = v / v.length();
    (v.cross(n), v, n)
}

/// Where the line from `from` along `direction` meets n = `distance`.
fn on_plane(view: &View, from: DVec3, direction: DVec3) -> DVec3 {
    let (_, _, n) = axes(view);
    from + direction * ((view.distance - (from - view.vrp).dot(n)) / direction.dot(n))
}

/// What the canonical volume must give for the world point `p`.
fn expected(view: &View, p: DVec3) -> DVec3 {
    let (u, v, n) = axes(view);
    let world = |w: DVec3| view.vrp + u * w.x + v * w.y + n * w.z;
    let [u_min, u_max, v_min, v_max] = view.window;
    let eye = world(view.prp);
    let centre = world(DVec3::new(
        (u_min + u_max) / 2.0,
        (v_min + v_max) / 2.0,
        view.distance,
    ));
    let ray = if view.perspective {
        p - eye
    } else {
        centre - eye
    };
    let hit = on_plane(view, p, ray) - centre;
    let x = hit.dot(u) / ((u_max - u_min) / 2.0);
    let y = hit.dot(v) / ((v_max - v_min) / 2.0);
    let depth = (p - view.vrp).dot(n);
    if view.perspective {
        let z = (view.prp.z - depth) / (view.prp.z - view.back);
        DVec3::new(x * z, y * z, z)
    } else {
        DVec3::new(x, y, (depth - view.front) / (view.front - view.back))
    }
}

fn assert_near(got: DVec3, want: DVec3, size: f64) {
    let error = (got - want).abs().max_element();
    assert!(
        error <= 1e-12 * size.max(1.0),
        "got {got}, want {want}, error {error}"
    );
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    /// A point anywhere, followed along its own ray into the window.
    #[test]
    fn the_ray_through_a_point_meets_the_window_where_the_matrix_says(
        view in view(), offset in vector(8.0),
    ) {
        let p = view.vrp + offset;
        let (_, _, n) = axes(&view);
        // On the eye's own level a ray never meets the window.
        prop_assume!(((p - view.vrp).dot(n) - view.prp.z).abs() > 0.05);
        let matrix = view.matrix().unwrap();
        prop_assert_eq!(matrix.row(3), glam::DVec4::W);
        let want = expected(&view, p);
        assert_near(matrix.transform_point3(p), want, want.abs().max_element());
    }

    /// A place in the window and a depth, placed in the world along the ray.
    #[test]
    fn the_corners_of_the_visible_volume_are_those_of_the_canonical_one(view in view()) {
        let (u, v, n) = axes(&view);
        let world = |w: DVec3| view.vrp + u * w.x + v * w.y + n * w.z;
        let matrix = view.matrix().unwrap();
        let [u_min, u_max, v_min, v_max] = view.window;
        let centre = DVec3::new((u_min + u_max) / 2.0, (v_min + v_max) / 2.0, view.distance);
        for (depth, is_back) in [(view.front, false), (view.back, true)] {
            for (cu, x) in [(u_min, -1.0), (u_max, 1.0)] {
                for (cv, y) in [(v_min, -1.0), (v_max, 1.0)] {
                    let corner = DVec3::new(cu, cv, view.distance);
                    let ray = if view.perspective { corner - view.prp } else { centre - view.prp };
                    let place = corner + ray * ((depth - corner.z) / ray.z);
                    let got = matrix.transform_point3(world(place));
                    let want = if view.perspective {
                        let z = if is_back {
                            1.0
                        } else {
                            (view.prp.z - view.front) / (view.prp.z - view.back)
                        };
                        DVec3::new(x * z, y * z, z)
                    } else {
                        DVec3::new(x, y, if is_back { -1.0 } else { 0.0 })
                    };
                    // A steep ray leads far away, where a world coordinate has
                    // fewer digits after the point than the window needs.
                    let far = (place.length() + view.vrp.length())
                        / (u_max - u_min).min(v_max - v_min);
                    assert_near(got, want, far);
                }
            }
        }
    }

    /// R_z·R_y·R_x of 2.5.1 with the angles of 2.15, 2.17 and 2.26.
    #[test]
    fn the_orientation_is_the_product_of_the_three_rotations(view in view()) {
        let to_z = axis_to_z(view.normal).unwrap();
        let up = to_z.transform_vector3(view.up);
        let chain = rotation_z(up.x.atan2(up.y)) * to_z;
        let got = DMat3::from_mat4(view.orientation());
        prop_assert!(got.abs_diff_eq(DMat3::from_mat4(chain), 1e-13));
    }

    /// The whole way of 2.5: canonical volume, M_per, division by w.
    #[test]
    fn the_plain_projection_finishes_the_picture(view in view(), offset in vector(8.0)) {
        let (_, _, n) = axes(&view);
        // Brought before the eye, where it is not.
        let ahead = view.prp.z - offset.dot(n);
        let p = view.vrp + offset + n * (ahead - ahead.abs() - 0.05);
        let want = expected(&view, p);
        let matrix = view.matrix().unwrap();
        if view.perspective {
            let d = (view.distance - view.prp.z) / (view.back - view.prp.z);
            let got = (perspective_projection(d) * matrix).project_point3(p);
            let want = DVec3::new(want.x / want.z * d, want.y / want.z * d, d);
            assert_near(got, want, want.abs().max_element());
        } else {
            let got = (parallel_projection() * matrix).project_point3(p);
            assert_near(got, DVec3::new(want.x, want.y, 0.0), want.abs().max_element());
        }
    }

    /// A camera's picture is the one that OpenGL makes of it.
    #[test]
    fn a_pose_sees_what_opengl_sees(
        position in vector(10.0), look in direction(), up in direction(), ahead in vector(1.0),
        zoom in 1.0..100.0f64, aspect in 0.3..4.0f64, front in 0.01..1.0f64,
    ) {
        prop_assume!(look.length() > 0.1 && up.length() > 0.1);
        prop_assume!(look.normalize().cross(up.normalize()).length() > 0.05);
        let back = front * 50.0;
        let p = position + look.normalize() * (front * 7.0) + ahead * front;
        let view = View::from_pose(position, look, up, zoom, aspect, front, back).unwrap();
        let got = view.matrix().unwrap().transform_point3(p);
        let clip = opengl::perspective(2.0 * (12.0 / zoom).atan(), aspect, front, back)
            * gl_matrix(position, look, up).unwrap();
        let ndc = clip.project_point3(p);
        let size = ndc.abs().max_element() * position.length() / front;
        assert_near(DVec3::new(got.x / got.z, got.y / got.z, 0.0), ndc.with_z(0.0), size);
    }

    #[test]
    fn the_gl_matrix_puts_the_camera_at_rest(
        position in vector(100.0), look in direction(), up in direction(),
    ) {
        prop_assume!(look.length() > 0.1 && up.length() > 0.1);
        prop_assume!(look.normalize().cross(up.normalize()).length() > 0.05);
        let matrix = gl_matrix(position, look, up).unwrap();
        let size = position.length();
        assert_near(matrix.transform_point3(position), DVec3::ZERO, size);
        let look = look.normalize();
        assert_near(matrix.transform_point3(position + look), -DVec3::Z, size);
        let right = look.cross(up).normalize();
        assert_near(matrix.transform_point3(position + right), DVec3::X, size);
        assert_near(matrix.transform_vector3(right.cross(look)), DVec3::Y, 1.0);
    }
}

#[test]
fn right_of_the_camera_is_right_in_the_picture() {
    // Unturned camera: along +z, y up; its right hand points to −x.
    let view = View::from_pose(DVec3::ZERO, DVec3::Z, DVec3::Y, 24.0, 1.5, 0.1, 10.0).unwrap();
    let matrix = view.matrix().unwrap();
    let seen = |x, y| {
        let p = matrix.transform_point3(DVec3::new(x, y, 4.0));
        assert!((p.z - 0.4).abs() < 1e-15);
        (p.x / p.z, p.y / p.z)
    };
    // Half the film's height over the focal length: 12/24 of the distance.
    let (x, y) = seen(-3.0, 2.0);
    assert!((x - 1.0).abs() < 1e-14 && (y - 1.0).abs() < 1e-14);
    let (x, y) = seen(0.75, -0.5);
    assert!((x + 0.25).abs() < 1e-14 && (y + 0.25).abs() < 1e-14);
}

#[test]
fn a_gl_matrix_by_hand() {
    // Column-major, as gluLookAt(1,2,3, 1,2,2, 0,1,0) leaves it.
    let matrix = gl_matrix(DVec3::new(1.0, 2.0, 3.0), -DVec3::Z, DVec3::Y * 4.0).unwrap();
    assert_eq!(
        matrix,
        DMat4::from_translation(DVec3::new(-1.0, -2.0, -3.0))
    );
    let matrix = gl_matrix(DVec3::new(1.0, 2.0, 3.0), DVec3::X, DVec3::Y).unwrap();
    assert_eq!(
        matrix.to_cols_array(),
        [
            0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, -3.0, -2.0, 1.0, 1.0
        ]
    );
}

#[test]
fn plain_projections_by_hand() {
    let p = DVec3::new(3.0, -2.0, 4.0);
    assert_eq!(
        perspective_projection(0.5).project_point3(p),
        DVec3::new(0.375, -0.25, 0.5)
    );
    assert_eq!(
        parallel_projection().project_point3(p),
        DVec3::new(3.0, -2.0, 0.0)
    );
}

fn good() -> View {
    View {
        vrp: DVec3::new(1.0, 2.0, 3.0),
        normal: DVec3::new(0.0, 3.0, 4.0),
        up: DVec3::Y,
        prp: DVec3::new(0.1, 0.2, 6.0),
        window: [-1.0, 2.0, -3.0, 4.0],
        front: 1.0,
        back: -5.0,
        distance: 0.5,
        perspective: true,
    }
}

#[test]
fn bad_views_are_refused_each_by_its_reason() {
    type Change = fn(&mut View);
    let cases: &[(Change, &str)] = &[
        (|v| v.vrp.x = f64::NAN, "finite"),
        (|v| v.normal.y = f64::INFINITY, "finite"),
        (|v| v.up.z = f64::NAN, "finite"),
        (|v| v.prp.x = f64::NEG_INFINITY, "finite"),
        (|v| v.window[3] = f64::INFINITY, "finite"),
        (|v| v.front = f64::NAN, "finite"),
        (|v| v.back = f64::NEG_INFINITY, "finite"),
        (|v| v.distance = f64::NAN, "finite"),
        (|v| v.normal = DVec3::ZERO, "normal must not be zero"),
        (|v| v.up = DVec3::ZERO, "up vector must not be zero"),
        (|v| v.up = v.normal * -1e9, "parallel"),
        (|v| v.up = v.normal * 1e-200, "parallel"),
        (|v| v.window[0] = v.window[1], "window"),
        (|v| v.window[2] = 5.0, "window"),
        (|v| v.back = v.front, "back plane"),
        (|v| v.back = 2.0, "back plane"),
        (|v| v.prp.z = v.front, "before the front plane"),
        (|v| v.prp.z = -9.0, "before the front plane"),
        (|v| v.distance = v.prp.z, "in the view plane"),
        (|v| v.window = [0.0, 1e-310, -1.0, 1.0], "so large"),
    ];
    for perspective in [true, false] {
        let view = View {
            perspective,
            ..good()
        };
        assert!(view.matrix().is_ok());
        for (change, reason) in cases {
            let mut bad = view;
            change(&mut bad);
            let message = bad.matrix().unwrap_err().to_string();
            assert!(message.contains(reason), "{message} for {reason}");
        }
    }
}

#[test]
fn bad_poses_are_refused() {
    let at = |zoom, aspect, front, back| {
        View::from_pose(DVec3::ZERO, DVec3::Z, DVec3::Y, zoom, aspect, front, back).is_ok()
    };
    assert!(at(24.0, 1.0, 1.0, 2.0));
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(!at(bad, 1.0, 1.0, 2.0));
        assert!(!at(24.0, bad, 1.0, 2.0));
        assert!(!at(24.0, 1.0, bad, 2.0));
        assert!(!at(24.0, 1.0, 1.0, bad));
    }
    assert!(!at(24.0, 1.0, 2.0, 2.0));
    let along = |view, up| View::from_pose(DVec3::ZERO, view, up, 24.0, 1.0, 1.0, 2.0).is_ok();
    assert!(!along(DVec3::Z, DVec3::Z));
    assert!(!along(DVec3::ZERO, DVec3::Z));
    for (view, up) in [
        (DVec3::Z, -DVec3::Z),
        (DVec3::ZERO, DVec3::Y),
        (DVec3::Z, DVec3::ZERO),
        (DVec3::NAN, DVec3::Y),
    ] {
        assert!(gl_matrix(DVec3::ZERO, view, up).is_err());
    }
    assert!(gl_matrix(DVec3::INFINITY, DVec3::Z, DVec3::Y).is_err());
}
