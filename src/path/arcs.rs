//! Great arcs without branches: the form of slerp that fills whole vectors.
//!
//! For arcs up to [`MAX_ANGLE`] the square of the angle is a polynomial in the
//! square of the chord, and sin θ/θ and θ/sin θ are polynomials in the square
//! of the angle, so that no case near zero is needed and nothing but
//! multiplications and additions is left. The polynomials are Chebyshev fits.

use glam::DQuat;

use crate::math::fused::{MultiplyAdd, horner};
use crate::math::quaternion::angle;

/// The longest arc on S³ that these functions take, in radians.
pub(super) const MAX_ANGLE: f64 = 1.25;

/// (2·asin(√d/2))²/d in powers of d ≤ 4·sin²(MAX_ANGLE/2); error 6e-18.
const ANGLE: [f64; 16] = [
    1.0,
    0.08333333333333477,
    0.01111111111102245,
    0.0017857142878773332,
    0.00031746028982872616,
    6.01252728568418e-05,
    1.1891798185464899e-05,
    2.4318342881009316e-06,
    4.987388760461932e-07,
    1.2440163397153961e-07,
    2.6108184644395516e-09,
    2.4536342156161428e-08,
    -1.167084879771306e-08,
    5.994979867942336e-09,
    -1.539705412965105e-09,
    2.3266098162808516e-10,
];

/// θ/sin θ in powers of θ² ≤ MAX_ANGLE²; error 8e-18.
const INVERSE: [f64; 13] = [
    1.0,
    0.16666666666666516,
    0.01944444444449856,
    0.002050264549505919,
    0.00020998677799885726,
    2.1336021876980967e-05,
    2.1634129627351625e-06,
    2.1911227473723363e-07,
    2.2364386764429803e-08,
    2.1231271670956865e-09,
    2.998264660280375e-10,
    -2.008291341222051e-12,
    7.006163655563099e-12,
];

/// sin θ/θ in powers of θ² ≤ MAX_ANGLE²; error 3e-18.
const SINC: [f64; 8] = [
    1.0,
    -0.1666666666666664,
    0.008333333333330037,
    -0.00019841269839581692,
    2.7557318799284958e-06,
    -2.5052050342647083e-08,
    1.6054646090937375e-10,
    -7.473341292114921e-13,
];

/// A quaternion as plain numbers, so that many of them fill vectors.
type Q = [f64; 4];

/// One arc with what depends on its ends alone.
#[derive(Debug, Clone, Copy)]
struct Arc {
    from: Q,
    to: Q,
    square: f64,
    inverse: f64,
}

/// Weights of the ends of an arc at `x`, apart from the factor θ/sin θ.
#[inline(always)]
fn weights<M: MultiplyAdd>(square: f64, x: f64) -> (f64, f64) {
    let y = 1.0 - x;
    (
        y * horner::<M, 8>(&SINC, y * y * square),
        x * horner::<M, 8>(&SINC, x * x * square),
    )
}

#[inline(always)]
fn blend<M: MultiplyAdd>(a: &Q, b: &Q, wa: f64, wb: f64) -> Q {
    let mut q = [0.0; 4];
    for k in 0..4 {
        q[k] = M::mul_add(a[k], wa, b[k] * wb);
    }
    q
}

#[inline(always)]
fn square_angle<M: MultiplyAdd>(a: &Q, b: &Q) -> f64 {
    let mut chord = 0.0;
    for k in 0..4 {
        let d = a[k] - b[k];
        chord = M::mul_add(d, d, chord);
    }
    chord * horner::<M, 16>(&ANGLE, chord)
}

impl Arc {
    #[inline(always)]
    fn new<M: MultiplyAdd>(from: Q, to: Q) -> Self {
        let square = square_angle::<M>(&from, &to);
        Self {
            from,
            to,
            square,
            inverse: horner::<M, 13>(&INVERSE, square),
        }
    }

    #[inline(always)]
    fn at<M: MultiplyAdd>(&self, x: f64) -> Q {
        let (a, b) = weights::<M>(self.square, x);
        blend::<M>(&self.from, &self.to, a * self.inverse, b * self.inverse)
    }
}

/// A cubic spherical Bézier curve all of whose arcs are short enough.
#[derive(Debug, Clone, Copy)]
pub(super) struct ShortBezier([Arc; 3]);

impl ShortBezier {
    /// None where an arc of the control polygon is too long; the arcs of the
    /// later rounds of de Casteljau's algorithm are never longer than those.
    #[inline(always)]
    pub(super) fn new<M: MultiplyAdd>(control: &[DQuat; 4]) -> Option<Self> {
        let [a, b, c, d] = *control;
        if angle(a, b).max(angle(b, c)).max(angle(c, d)) > MAX_ANGLE {
            return None;
        }
        let plain = |q: DQuat| [q.x, q.y, q.z, q.w];
        let (a, b, c, d) = (plain(a), plain(b), plain(c), plain(d));
        Some(Self([
            Arc::new::<M>(a, b),
            Arc::new::<M>(b, c),
            Arc::new::<M>(c, d),
        ]))
    }

    /// The quaternion (x, y, z, w) at φ, of length near 1: the factor of the
    /// last arc is left out, since views are divided by the length anyway.
    #[inline(always)]
    pub(super) fn at<M: MultiplyAdd>(&self, phi: f64) -> [f64; 4] {
        let [first, second, third] = &self.0;
        let (ab, bc, cd) = (first.at::<M>(phi), second.at::<M>(phi), third.at::<M>(phi));
        let abc = Arc::new::<M>(ab, bc).at::<M>(phi);
        let bcd = Arc::new::<M>(bc, cd).at::<M>(phi);
        let square = square_angle::<M>(&abc, &bcd);
        let (a, b) = weights::<M>(square, phi);
        blend::<M>(&abc, &bcd, a, b)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::fused::Separate;
    use crate::math::quaternion::{exp, slerp};
    use crate::path::quaternion_spline::bezier;
    use glam::DVec3;

    #[test]
    fn arcs_agree_with_slerp_by_sines() {
        let start = exp(DVec3::new(0.3, -0.7, 0.2));
        for k in 0..=1000 {
            let theta = MAX_ANGLE * f64::from(k) / 1000.0;
            let end = exp(DVec3::new(0.6, 0.8, 0.0) * theta) * start;
            let arc = Arc::new::<Separate>(start.into(), end.into());
            for j in 0..=20 {
                let x = f64::from(j) / 20.0;
                let q = DQuat::from_array(arc.at::<Separate>(x));
                assert!((q - slerp(start, end, x)).length() < 2e-15, "{theta} {x}");
            }
        }
    }

    #[test]
    fn bezier_agrees_with_de_casteljau_by_sines() {
        let q = |x, y, z| exp(DVec3::new(x, y, z));
        let control = [
            q(0.1, 0.2, 0.3),
            q(0.5, -0.2, 0.4),
            q(0.2, 0.7, 0.1),
            q(1.0, 0.9, 0.5),
        ];
        let short = ShortBezier::new::<Separate>(&control).unwrap();
        for k in 0..=1000 {
            let phi = f64::from(k) / 1000.0;
            let q = DQuat::from_array(short.at::<Separate>(phi));
            assert!((q.length() - 1.0).abs() < 0.2);
            assert!((q.normalize() - bezier(&control, phi)).length() < 3e-15);
        }
        let far = [control[0], -control[1], control[2], control[3]];
        assert!(ShortBezier::new::<Separate>(&far).is_none());
    }
}
