use proptest::prelude::*;

use super::*;

fn point() -> impl Strategy<Value = DVec3> {
    prop::array::uniform3(-4.0..4.0f64).prop_map(DVec3::from)
}

fn bounds() -> impl Strategy<Value = Bounds> {
    (point(), prop::array::uniform3(0.1..3.0f64), 0..4usize).prop_map(|(min, size, flat)| {
        let mut max = min + DVec3::from(size);
        if flat < 3 {
            max[flat] = min[flat];
        }
        Bounds::new(min, max).unwrap()
    })
}

#[test]
fn what_is_no_deformation_is_refused() {
    for (kind, parameters) in [
        ("shear", &[0.0, 1.0][..]),
        ("taper", &[0.0]),
        ("taper", &[3.0, 1.0]),
        ("taper", &[0.5, 1.0]),
        ("twist", &[0.0, f64::NAN]),
        ("twist", &[0.0, 1e7]),
        ("twist", &[f64::NAN, 1.0]),
        ("bend", &[0.0, 0.0, 0.0, 0.0, 0.0, 0.0]),
        ("free-form", &[0.0; 191]),
    ] {
        assert!(Deformation::new(kind, parameters).is_err(), "{kind}");
    }
    let refused = Deformation::new("shear", &[]).unwrap_err().to_string();
    assert!(
        FORMULAS
            .iter()
            .all(|formula| refused.contains(formula.kind()))
    );
    assert!(Bounds::new(DVec3::ONE, DVec3::ZERO).is_err());
    assert!(Bounds::new(DVec3::NAN, DVec3::ZERO).is_err());
}

#[test]
fn parameters_have_names() {
    let mut bend = Deformation::new("bend", &[0.0, 1.0, 2.0, 3.0, 4.0, 5.0]).unwrap();
    assert_eq!(bend.channel("phi_max"), Some(&[5.0][..]));
    bend.channel_mut("u0").unwrap()[0] = 7.0;
    assert_eq!(bend.parameters()[2], 7.0);
    assert_eq!(bend.channel("angle"), None);
    let names: Vec<_> = bend.channels().map(|channel| channel.0).collect();
    assert_eq!(names, ["u0", "v0", "phi_min", "phi_max"]);
}

#[test]
fn the_lectures_taper_is_twice_as_wide_in_the_middle() {
    let bounds = Bounds::new(DVec3::splat(-1.0), DVec3::ONE).unwrap();
    let taper = Deformation::new("taper", &[0.0, 2.0]).unwrap();
    let mut points = [
        DVec3::new(0.0, 0.5, -0.5),
        DVec3::new(0.5, 0.5, 1.0),
        DVec3::ONE,
    ];
    taper.apply(&bounds, &mut points);
    assert_eq!(points[0], DVec3::new(0.0, 1.0, -1.0));
    assert!((points[1] - DVec3::new(0.5, 0.875, 1.75)).length() < 1e-15);
    assert_eq!(points[2], DVec3::ONE);
}

proptest! {
    /// Untouched lattice, taper by 1, twist and bend by 0.
    #[test]
    fn identities_are_identities(bounds in bounds(), p in point()) {
        let lattice = identity_lattice();
        let mut all: Vec<(&str, Vec<f64>)> = vec![("free-form", lattice.to_vec())];
        for axis in [0.0, 1.0, 2.0] {
            all.push(("taper", vec![axis, 1.0]));
            all.push(("taper", vec![axis, 1.0, 1.0]));
            all.push(("twist", vec![axis, 0.0]));
            all.push(("bend", vec![axis, 0.0]));
        }
        for (kind, parameters) in all {
            let mut points = [p];
            Deformation::new(kind, &parameters).unwrap().apply(&bounds, &mut points);
            // A point far outside a thin box loses what its coordinate is large by.
            let far = [0, 1, 2].map(|k| bounds.coordinate(p, k).abs()).into_iter().fold(1.0, f64::max);
            let size = bounds.min().abs().max_element().max(bounds.max().abs().max_element());
            let near = 1e-12 * far * size.max(1.0);
            prop_assert!((points[0] - p).length() <= near, "{} {:?}", kind, points[0] - p);
        }
    }

    #[test]
    fn flat_sides_stay(p in point(), axis in 0..3usize, flat in 0..3usize) {
        let mut max = DVec3::splat(2.0);
        max[flat] = -1.0;
        let bounds = Bounds::new(DVec3::splat(-1.0), max).unwrap();
        for (kind, second) in [("taper", 2.0), ("twist", 70.0), ("bend", 70.0)] {
            let mut points = [p];
            let deformation = Deformation::new(kind, &[axis as f64, second]).unwrap();
            deformation.apply(&bounds, &mut points);
            prop_assert_eq!(points[0][flat].to_bits(), p[flat].to_bits());
        }
    }

    /// Lengths along the middle line stay; the middle too.
    #[test]
    fn a_bend_keeps_the_middle_line(angle in -350.0..350.0f64, axis in 0..3usize) {
        let bounds = Bounds::new(DVec3::splat(-1.0), DVec3::ONE).unwrap();
        let bend = Deformation::new("bend", &[axis as f64, angle]).unwrap();
        let a = (axis + 1) % 3;
        let mut line: Vec<DVec3> = (0..=2000)
            .map(|k| {
                let mut p = DVec3::ZERO;
                p[a] = f64::from(k) / 1000.0 - 1.0;
                p
            })
            .collect();
        bend.apply(&bounds, &mut line);
        prop_assert!(line[1000].length() < 1e-15);
        let length: f64 = line.windows(2).map(|p| (p[1] - p[0]).length()).sum();
        prop_assert!((length - 2.0).abs() < 1e-5);
        // Both ends turned by half the angle, against each other.
        let ends = [line[1] - line[0], line[2000] - line[1999]];
        let turned = ends[0].normalize().dot(ends[1].normalize());
        prop_assert!((turned - angle.to_radians().cos()).abs() < 1e-2);
    }
}

/// A side too short to divide by is flat: its coordinate stays, and nothing is infinite.
#[test]
fn a_side_of_subnormal_length_is_flat() {
    let points = [
        DVec3::ZERO,
        DVec3::new(1.0, -2.0, 3.0),
        DVec3::splat(5e-324),
    ];
    for size in [5e-324, 1e-310, f64::MIN_POSITIVE, 1e-200] {
        for sides in [
            [1.0, 1.0, 1.0],
            [1.0, 0.0, 0.0],
            [0.0, 1.0, 0.0],
            [0.0, 0.0, 1.0],
        ] {
            let side = |at: usize| if sides[at] > 0.0 { size } else { 1.0 };
            let bounds = |flat: f64| {
                let side = |at: usize| if sides[at] > 0.0 { flat } else { side(at) };
                Bounds::new(DVec3::ZERO, DVec3::new(side(0), side(1), side(2))).unwrap()
            };
            let lattice = identity_lattice().map(|number| 2.0 * number);
            for (kind, numbers) in [
                ("taper", &[0.0, 3.0][..]),
                ("taper", &[1.0, 3.0, 2.0]),
                ("twist", &[2.0, 90.0]),
                ("bend", &[1.0, 90.0]),
                ("bend", &[0.0, 1.0, 0.5, 0.5, 10.0, 80.0]),
                ("free-form", &lattice),
            ] {
                let deformation = Deformation::new(kind, numbers).unwrap();
                let (mut short, mut flat) = (points, points);
                deformation.apply(&bounds(size), &mut short);
                deformation.apply(&bounds(0.0), &mut flat);
                assert!(
                    short.iter().all(|point| point.is_finite()),
                    "{kind}, {size}: {short:?}"
                );
                for (short, flat) in short.iter().zip(flat) {
                    assert!(
                        short.distance(flat) < 1e-15,
                        "{kind}, {size}: {short} {flat}"
                    );
                }
            }
        }
    }
}
