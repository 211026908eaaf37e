//! The curves against reference values from `scipy` and `splines`, kept in
//! `oracles/curves.toml`; `oracles/curves.py` beside it makes them.

use glam::DVec3;
use serde::Deserialize;
use vides::path::bezier::Bezier;
use vides::path::catmull_rom::{EndRule, closed_curve, open_curve};
use vides::path::cubic_spline::{CubicSpline, SplineEnds};
use vides::path::hermite::Cubic;
use vides::path::{CameraPath, CurveParameters, SupportPoint, Tcb, kochanek_bartels};

const TOLERANCE: f64 = 1e-12;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Oracles {
    catmull_rom: Vec<CatmullRom>,
    kochanek_bartels: Vec<KochanekBartels>,
    cubic_spline: Vec<Spline>,
    bezier: Vec<BezierCurve>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct CatmullRom {
    ends: String,
    points: Vec<[f64; 3]>,
    slopes: Vec<[f64; 3]>,
    t: Vec<f64>,
    point: Vec<[f64; 3]>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct KochanekBartels {
    closed: bool,
    points: Vec<[f64; 3]>,
    tcb: Vec<[f64; 3]>,
    t: Vec<f64>,
    point: Vec<[f64; 3]>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Spline {
    ends: String,
    points: Vec<[f64; 3]>,
    knots: Vec<f64>,
    slopes: Vec<[f64; 3]>,
    x: Vec<f64>,
    point: Vec<[f64; 3]>,
    first: Vec<[f64; 3]>,
    second: Vec<[f64; 3]>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct BezierCurve {
    points: Vec<[f64; 3]>,
    t: Vec<f64>,
    point: Vec<[f64; 3]>,
    derivative: Vec<[f64; 3]>,
}

fn oracles() -> Oracles {
    toml::from_str(include_str!("oracles/curves.toml")).expect("the reference values")
}

fn vectors(list: &[[f64; 3]]) -> Vec<DVec3> {
    list.iter().copied().map(DVec3::from_array).collect()
}

/// Every value within the tolerance of its own curve's size, of which the
/// largest value tells unless `least` is larger.
#[track_caller]
fn assert_near(what: &str, at: &[f64], want: &[[f64; 3]], least: f64, got: impl Fn(f64) -> DVec3) {
    assert_eq!(at.len(), want.len());
    let want = vectors(want);
    let sizes = want.iter().map(|v| v.abs().max_element());
    let size = sizes.fold(least, f64::max);
    for (&t, want) in at.iter().zip(want) {
        let got = got(t);
        let error = (got - want).abs().max_element();
        assert!(
            error <= TOLERANCE * size,
            "{what} at {t}: got {got}, want {want}, error {error:e}"
        );
    }
}

#[track_caller]
fn assert_equal(what: &str, at: &[f64], want: &[[f64; 3]], got: impl Fn(f64) -> DVec3) {
    assert_near(what, at, want, f64::MIN_POSITIVE, got);
}

/// The point of a chain of uniform segments at its common parameter.
fn on_chain(chain: &[Cubic], t: f64) -> DVec3 {
    let i = (t as usize).min(chain.len() - 1);
    chain[i].point(t - i as f64)
}

#[test]
fn catmull_rom_curves() {
    for case in oracles().catmull_rom {
        let points = vectors(&case.points);
        let chain = match case.ends.as_str() {
            "natural" => open_curve(&points, EndRule::Natural),
            "quadratic" => open_curve(&points, EndRule::Quadratic),
            "tangents" => {
                let slopes = vectors(&case.slopes);
                open_curve(&points, EndRule::Tangents(slopes[0], slopes[1]))
            }
            "closed" => closed_curve(&points),
            other => panic!("unknown ends {other}"),
        }
        .unwrap();
        let what = format!("{} through {}", case.ends, points.len());
        assert_equal(&what, &case.t, &case.point, |t| on_chain(&chain, t));
    }
}

#[test]
fn kochanek_bartels_curves() {
    for case in oracles().kochanek_bartels {
        let point = |(position, tcb): (&[f64; 3], &[f64; 3])| SupportPoint {
            curve: CurveParameters::Own(Tcb::new(tcb[0], tcb[1], tcb[2])),
            ..SupportPoint::new(DVec3::from_array(*position))
        };
        let path = CameraPath {
            points: case.points.iter().zip(&case.tcb).map(point).collect(),
            closed: case.closed,
            ..CameraPath::default()
        };
        let segments = case.points.len() - usize::from(!case.closed);
        let chain: Vec<_> = (0..segments)
            .map(|i| kochanek_bartels::segment(&path, i))
            .collect();
        let what = format!("closed {} through {}", case.closed, case.points.len());
        assert_equal(&what, &case.t, &case.point, |t| on_chain(&chain, t));
    }
}

#[test]
fn cubic_splines() {
    for case in oracles().cubic_spline {
        let slopes = vectors(&case.slopes);
        let ends = match case.ends.as_str() {
            "natural" => SplineEnds::Natural,
            "clamped" => SplineEnds::Clamped(slopes[0], slopes[1]),
            "periodic" => SplineEnds::Periodic,
            other => panic!("unknown ends {other}"),
        };
        let spline = CubicSpline::new(&vectors(&case.points), &case.knots, ends).unwrap();
        let what = format!("{} through {}", case.ends, case.points.len());
        assert_equal(&what, &case.x, &case.point, |x| spline.point(x));
        assert_equal(&what, &case.x, &case.first, |x| spline.derivative(x));
        // On a straight line the second derivative is 0 but for the rounding
        // of differences of slopes, which this is the size of.
        let points = vectors(&case.points);
        let bend = |i: usize| {
            (points[i + 1] - points[i]).length() / (case.knots[i + 1] - case.knots[i]).powi(2)
        };
        let least = (0..points.len() - 1).map(bend).fold(0.0, f64::max);
        assert_near(&what, &case.x, &case.second, least, |x| {
            spline.second_derivative(x)
        });
    }
}

#[test]
fn bezier_curves() {
    for case in oracles().bezier {
        let curve = Bezier::new(&vectors(&case.points)).unwrap();
        let what = format!("degree {}", curve.degree());
        assert_equal(&what, &case.t, &case.point, |t| curve.point(t));
        assert_equal(&what, &case.t, &case.derivative, |t| curve.derivative(t));
        if let Ok(control) = <[DVec3; 4]>::try_from(vectors(&case.points)) {
            let cubic = Cubic::bezier(control);
            assert_equal(&what, &case.t, &case.point, |t| cubic.point(t));
            assert_equal(&what, &case.t, &case.derivative, |t| cubic.derivative(t));
        }
    }
}
