//! Lengths against adaptive quadrature and closed forms.

use super::*;
use crate::path::test_support::Random;
use glam::DVec3;

fn vector(random: &mut Random) -> DVec3 {
    DVec3::new(random.unit(), random.unit(), random.unit()) * 2.0 - 1.0
}

fn cubic(random: &mut Random) -> Cubic {
    let (start, end) = (vector(random), vector(random));
    Cubic::hermite(start, end, 3.0 * vector(random), 3.0 * vector(random))
}

/// Gauss–Legendre with 20 nodes, split where the speed is least and then
/// halved: another method than the one under test.
fn quadrature(curve: &Cubic, from: f64, to: f64) -> f64 {
    // Positive nodes and weights of the 20-point rule.
    const RULE: [(f64, f64); 10] = [
        (0.076_526_521_133_497_33, 0.152_753_387_130_725_85),
        (0.227_785_851_141_645_08, 0.149_172_986_472_603_75),
        (0.373_706_088_715_419_56, 0.142_096_109_318_382_05),
        (0.510_867_001_950_827_1, 0.131_688_638_449_176_63),
        (0.636_053_680_726_515_0, 0.118_194_531_961_518_42),
        (0.746_331_906_460_150_8, 0.101_930_119_817_240_44),
        (0.839_116_971_822_218_8, 0.083_276_741_576_704_75),
        (0.912_234_428_251_325_9, 0.062_672_048_334_109_06),
        (0.963_971_927_277_913_8, 0.040_601_429_800_386_94),
        (0.993_128_599_185_094_9, 0.017_614_007_139_152_12),
    ];
    fn rule(curve: &Cubic, from: f64, to: f64) -> f64 {
        let (m, h) = (0.5 * (from + to), 0.5 * (to - from));
        let speed = |t| curve.derivative(t).length();
        RULE.iter()
            .map(|(x, w)| w * h * (speed(m - h * x) + speed(m + h * x)))
            .sum()
    }
    fn halve(curve: &Cubic, from: f64, to: f64, whole: f64, enough: f64) -> f64 {
        let m = 0.5 * (from + to);
        let (a, b) = (rule(curve, from, m), rule(curve, m, to));
        if (a + b - whole).abs() <= enough {
            return a + b;
        }
        halve(curve, from, m, a, enough) + halve(curve, m, to, b, enough)
    }
    // Where |P′|² has an extremum, P′·P″ changes its sign.
    let slope = |t| curve.derivative(t).dot(curve.second_derivative(t));
    let mut splits = vec![from];
    for k in 0..500 {
        let at = |k: f64| from + (to - from) * k / 500.0;
        let (mut low, mut high) = (at(f64::from(k)), at(f64::from(k + 1)));
        if slope(low) * slope(high) > 0.0 {
            continue;
        }
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if slope(low) * slope(middle) > 0.0 {
                low = middle
            } else {
                high = middle
            }
        }
        splits.push(low);
    }
    splits.push(to);
    let enough = 1e-15 * rule(curve, 0.0, 1.0);
    splits
        .windows(2)
        .map(|w| halve(curve, w[0], w[1], rule(curve, w[0], w[1]), enough))
        .sum()
}

fn check(curve: &Cubic, scale: f64) {
    let arc = ArcLength::new(curve).unwrap();
    let exact = quadrature(curve, 0.0, 1.0);
    assert!(
        (arc.length() - exact).abs() <= 1e-12 * exact,
        "{} {exact}",
        arc.length()
    );
    assert!((length::<f64>(curve) - exact).abs() <= 1e-12 * exact);
    let mut last = 0.0;
    for k in 0..=20 {
        let s = f64::from(k) / 20.0 * arc.length();
        let t = arc.parameter_at(s);
        assert!(t >= last);
        last = t;
        let back = quadrature(curve, 0.0, t);
        assert!(
            (back - s).abs() <= 1e-12 * exact + 1e-15 * scale,
            "{s} {back} {exact}"
        );
        assert!((arc.length_at(t) - s).abs() <= 1e-13 * exact + 1e-15 * scale);
    }
}

#[test]
fn random_curves_agree_with_quadrature() {
    let mut random = Random(1);
    for _ in 0..300 {
        check(&cubic(&mut random), 1.0);
    }
}

#[test]
fn hard_curves_agree_with_quadrature() {
    let (o, x, y) = (DVec3::ZERO, DVec3::X, DVec3::Y);
    // Tension 1 at one end, at both; there and back; past the end and back.
    check(&Cubic::hermite(o, x, o, x + y), 1.0);
    check(&Cubic::hermite(o, x, o, o), 1.0);
    check(&Cubic::hermite(o, x, -5.0 * x, -5.0 * x), 1.0);
    check(&Cubic::hermite(o, x, 9.0 * x, 9.0 * x), 1.0);
    // Coincident ends with a loop between them, and with a spike.
    check(&Cubic::hermite(o, o, x, y), 1.0);
    check(&Cubic::hermite(o, o, x, -x), 1.0);
    // A cusp inside: P′(1/2) = 0, at an odd parameter, and nearly one.
    let cusp = |t0: f64, off: f64| Cubic {
        a: DVec3::new(1.0, 0.0, 0.0),
        b: DVec3::new(-3.0 * t0, 1.0, 0.0),
        c: DVec3::new(3.0 * t0 * t0, -2.0 * t0, off),
        d: o,
        end: DVec3::new(1.0 - 3.0 * t0 + 3.0 * t0 * t0, 1.0 - 2.0 * t0, off),
    };
    for t0 in [0.5, 1.0 / 3.0, 0.123_456] {
        for off in [0.0, 1e-12, 1e-8, 1e-4, 1e-2] {
            check(&cusp(t0, off), 1.0);
        }
    }
    // Very short and very long.
    check(&Cubic::hermite(o, 1e-6 * x, 1e-6 * y, 1e-6 * x), 1e-6);
    check(&Cubic::hermite(o, 1e6 * x, 1e6 * y, -1e6 * x), 1e6);
}

/// The squares of their speeds are not full numbers, or none at all.
#[test]
fn tiny_curves_are_measured_like_large_ones() {
    let mut random = Random(5);
    for power in (-1000..-300).step_by(7) {
        let small = cubic(&mut random);
        let factor = 2f64.powi(power);
        let scaled = Cubic {
            a: small.a * factor,
            b: small.b * factor,
            c: small.c * factor,
            d: small.d * factor,
            end: small.end * factor,
        };
        let (known, arc) = (
            ArcLength::new(&small).unwrap(),
            ArcLength::new(&scaled).unwrap(),
        );
        // Below about 2⁻⁹⁷⁰ the coefficients themselves lose digits.
        let close = if power > -960 { 1e-13 } else { 1e-5 };
        let exact = known.length() * factor;
        assert!((arc.length() - exact).abs() <= close * exact, "{power}");
        assert!((length::<f64>(&scaled) - exact).abs() <= close * exact);
        for k in 0..=8 {
            let share = f64::from(k) / 8.0;
            let t = known.parameter_at(share * known.length());
            let back = arc.length_at(t);
            assert!((back - share * exact).abs() <= close * exact);
            let there = arc.parameter_at(share * arc.length());
            let way = known.length_at(there) - share * known.length();
            assert!(way.abs() <= close * known.length());
        }
    }
}

#[test]
fn closed_forms() {
    // A straight line, and the parabola y = x² over [0, 1].
    let line = Cubic::hermite(
        DVec3::ZERO,
        DVec3::new(3.0, 4.0, 0.0),
        DVec3::new(3.0, 4.0, 0.0),
        DVec3::new(3.0, 4.0, 0.0),
    );
    assert!((length::<f64>(&line) - 5.0).abs() < 1e-15 * 5.0);
    let parabola = Cubic::hermite(
        DVec3::ZERO,
        DVec3::new(1.0, 1.0, 0.0),
        DVec3::X,
        DVec3::new(1.0, 2.0, 0.0),
    );
    let exact = 5f64.sqrt() / 2.0 + 2f64.asinh() / 4.0;
    assert!((length::<f64>(&parabola) - exact).abs() < 1e-15);
    // x(t) = 3t² − 2t³: s(t) is x(t) itself.
    let ease = Cubic::hermite(DVec3::ZERO, DVec3::X, DVec3::ZERO, DVec3::ZERO);
    let arc = ArcLength::new(&ease).unwrap();
    for k in 0..=100 {
        let t = f64::from(k) / 100.0;
        let s = (3.0 - 2.0 * t) * t * t;
        assert!((arc.length_at(t) - s).abs() < 1e-15);
        assert!((ease.point(arc.parameter_at(s)).x - s).abs() < 1e-15);
    }
    let still = Cubic::hermite(DVec3::X, DVec3::X, DVec3::ZERO, DVec3::ZERO);
    let arc = ArcLength::new(&still).unwrap();
    assert_eq!(
        (arc.length(), arc.parameter_at(0.0), arc.length_at(0.5)),
        (0.0, 0.0, 0.0)
    );
}

/// A straight way that runs back at t = r: the length is |v|·(r² + (1 − r)²)/2.
#[test]
fn a_reversal_is_seen_wherever_it_lies() {
    let v = DVec3::new(1.0, -2.0, 0.5);
    let mut random = Random(29);
    for round in 0..20_000 {
        // Near the ends of pieces no node sees it.
        let reversal = match round % 4 {
            0 => random.unit(),
            1 => 0.004 * random.unit(),
            2 => 1.0 - 0.004 * random.unit(),
            _ => 0.25 * f64::from(1 + round % 3) + 0.004 * (random.unit() - 0.5),
        };
        let curve = Cubic {
            a: DVec3::ZERO,
            b: 0.5 * v,
            c: -reversal * v,
            d: DVec3::ZERO,
            end: (0.5 - reversal) * v,
        };
        let rest = 1.0 - reversal;
        let exact = 0.5 * v.length() * (reversal * reversal + rest * rest);
        let measured = length::<f64>(&curve);
        assert!((measured - exact).abs() <= 1e-12 * exact, "{reversal}");
        let arc = ArcLength::new(&curve).expect("memory");
        assert!((arc.length() - exact).abs() <= 1e-12 * exact, "{reversal}");
        let half = arc.length_at(reversal);
        let way = 0.5 * v.length() * reversal * reversal;
        assert!((half - way).abs() <= 1e-12 * exact, "{reversal}: {half}");
    }
}

#[test]
fn lengths_add_up_and_the_inverse_comes_back() {
    let mut random = Random(2);
    for _ in 0..20_000 {
        let curve = cubic(&mut random);
        let arc = ArcLength::new(&curve).unwrap();
        let (t, s) = (random.unit(), random.unit() * arc.length());
        let back = arc.length_at(arc.parameter_at(s));
        assert!((back - s).abs() < 1e-14 * arc.length());
        assert!(
            (arc.parameter_at(arc.length_at(t)) - t).abs() * curve.derivative(t).length()
                < 1e-13 * arc.length()
        );
    }
}
