//! The curves against reference values from `scipy` and `splines`, kept in
//! `oracles/curves.toml`; `oracles/curves.py` beside it makes them.

use glam::DVec3;
use toml::de::{DeTable, DeValue};
use vides::path::bezier::Bezier;
use vides::path::catmull_rom::{EndRule, closed_curve, open_curve};
use vides::path::cubic_spline::{CubicSpline, SplineEnds};
use vides::path::hermite::Cubic;
use vides::path::{CameraPath, CurveParameters, SupportPoint, Tcb, curve};

const TOLERANCE: f64 = 1e-12;

/// One reference curve: a table of the file.
struct Case<'a>(&'a DeTable<'a>);

impl<'a> Case<'a> {
    fn value(&self, key: &str) -> &'a DeValue<'a> {
        self.0[key].get_ref()
    }

    fn ends(&self) -> &'a str {
        self.value("ends").as_str().expect("a word")
    }

    fn closed(&self) -> bool {
        self.value("closed").as_bool().expect("true or false")
    }

    fn numbers(&self, key: &str) -> Vec<f64> {
        numbers(self.value(key))
    }

    fn vectors(&self, key: &str) -> Vec<DVec3> {
        let rows = self.value(key).as_array().expect("an array").iter();
        rows.map(|row| DVec3::from_slice(&numbers(row.get_ref())))
            .collect()
    }
}

fn numbers(value: &DeValue<'_>) -> Vec<f64> {
    let elements = value.as_array().expect("an array").iter();
    elements
        .map(|x| x.get_ref().as_float().expect("a number").as_str())
        .map(|digits| digits.parse().expect("a number"))
        .collect()
}

/// Runs a check over all curves of one kind.
fn for_each(kind: &str, check: impl Fn(Case<'_>)) {
    let file = DeTable::parse(include_str!("oracles/curves.toml")).expect("TOML");
    let cases = file.get_ref()[kind].get_ref().as_array().expect("tables");
    assert!(cases.len() > 5);
    for case in cases.iter() {
        check(Case(case.get_ref().as_table().expect("a table")));
    }
}

/// Every value within the tolerance of its own curve's size, of which the
/// largest value tells unless `least` is larger.
#[track_caller]
fn assert_near(what: &str, at: &[f64], want: &[DVec3], least: f64, got: impl Fn(f64) -> DVec3) {
    assert_eq!(at.len(), want.len());
    let sizes = want.iter().map(|v| v.abs().max_element());
    let size = sizes.fold(least, f64::max);
    for (&t, &want) in at.iter().zip(want) {
        let got = got(t);
        let error = (got - want).abs().max_element();
        assert!(
            error <= TOLERANCE * size,
            "{what} at {t}: got {got}, want {want}, error {error:e}"
        );
    }
}

#[track_caller]
fn assert_equal(what: &str, at: &[f64], want: &[DVec3], got: impl Fn(f64) -> DVec3) {
    assert_near(what, at, want, f64::MIN_POSITIVE, got);
}

/// The point of a chain of uniform segments at its common parameter.
fn on_chain(chain: &[Cubic], t: f64) -> DVec3 {
    let i = (t as usize).min(chain.len() - 1);
    chain[i].point(t - i as f64)
}

#[test]
fn catmull_rom_curves() {
    for_each("catmull_rom", |case| {
        let points = case.vectors("points");
        let chain = match case.ends() {
            "natural" => open_curve(&points, EndRule::Natural),
            "quadratic" => open_curve(&points, EndRule::Quadratic),
            "tangents" => {
                let slopes = case.vectors("slopes");
                open_curve(&points, EndRule::Tangents(slopes[0], slopes[1]))
            }
            "closed" => closed_curve(&points),
            other => panic!("unknown ends {other}"),
        };
        let chain = chain.unwrap();
        let what = format!("{} through {}", case.ends(), points.len());
        let (t, want) = (case.numbers("t"), case.vectors("point"));
        assert_equal(&what, &t, &want, |t| on_chain(&chain, t));
    });
}

#[test]
fn kochanek_bartels_curves() {
    for_each("kochanek_bartels", |case| {
        let point = |(position, tcb): (DVec3, DVec3)| SupportPoint {
            curve: CurveParameters::Own(Tcb::new(tcb.x, tcb.y, tcb.z)),
            ..SupportPoint::new(position)
        };
        let keys = case.vectors("points").into_iter().zip(case.vectors("tcb"));
        let path = CameraPath {
            points: keys.map(point).collect(),
            closed: case.closed(),
            ..CameraPath::default()
        };
        let segments = path.points.len() - usize::from(!path.closed);
        let chain: Vec<_> = (0..segments).map(|i| curve::segment(&path, i)).collect();
        let what = format!("closed {} through {}", path.closed, path.points.len());
        let (t, want) = (case.numbers("t"), case.vectors("point"));
        assert_equal(&what, &t, &want, |t| on_chain(&chain, t));
    });
}

#[test]
fn cubic_splines() {
    for_each("cubic_spline", |case| {
        let slopes = case.vectors("slopes");
        let ends = match case.ends() {
            "natural" => SplineEnds::Natural,
            "clamped" => SplineEnds::Clamped(slopes[0], slopes[1]),
            "periodic" => SplineEnds::Periodic,
            other => panic!("unknown ends {other}"),
        };
        let (points, knots) = (case.vectors("points"), case.numbers("knots"));
        let spline = CubicSpline::new(&points, &knots, ends).unwrap();
        let what = format!("{} through {}", case.ends(), points.len());
        let x = case.numbers("x");
        assert_equal(&what, &x, &case.vectors("point"), |x| spline.point(x));
        assert_equal(&what, &x, &case.vectors("first"), |x| spline.derivative(x));
        // On a straight line the second derivative is 0 but for the rounding
        // of differences of slopes, which this is the size of.
        let bend =
            |i: usize| (points[i + 1] - points[i]).length() / (knots[i + 1] - knots[i]).powi(2);
        let least = (0..points.len() - 1).map(bend).fold(0.0, f64::max);
        assert_near(&what, &x, &case.vectors("second"), least, |x| {
            spline.second_derivative(x)
        });
    });
}

#[test]
fn bezier_curves() {
    for_each("bezier", |case| {
        let points = case.vectors("points");
        let curve = Bezier::new(&points).unwrap();
        let what = format!("degree {}", curve.degree());
        let t = case.numbers("t");
        let (point, derivative) = (case.vectors("point"), case.vectors("derivative"));
        assert_equal(&what, &t, &point, |t| curve.point(t));
        assert_equal(&what, &t, &derivative, |t| curve.derivative(t));
        if let Ok(control) = <[DVec3; 4]>::try_from(points) {
            let cubic = Cubic::bezier(control);
            assert_equal(&what, &t, &point, |t| cubic.point(t));
            assert_equal(&what, &t, &derivative, |t| cubic.derivative(t));
        }
    });
}
