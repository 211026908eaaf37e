//! Great arcs without branches: slerp for whole vectors.
//!
//! For arcs up to `MAX_ANGLE` the squared angle is a polynomial in the squared chord, and sin θ/θ
//! and θ/sin θ are polynomials in the squared angle, so that no case near zero is needed, only
//! multiplications and additions. The polynomials are Chebyshev fits.

use glam::DQuat;

use crate::math::vector::{Number, Vector, each, horner};

/// The longest arc on S³ that these functions take, in radians.
#[cfg(test)]
pub(super) const MAX_ANGLE: f64 = 1.25;

/// Its cosine.
const LEAST_COSINE: f64 = 0.3153223623952687;

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

/// One arc with what depends on its ends alone.
#[derive(Debug, Clone, Copy)]
struct Arc<V> {
    from: [V; 4],
    to: [V; 4],
    square: V,
    inverse: V,
}

/// Weights of the ends of an arc at `x`, apart from the factor θ/sin θ.
#[inline(always)]
fn weights<V: Number>(square: V, x: V) -> (V, V) {
    let y = V::splat(1.0).sub(x);
    (
        y.mul(horner(&SINC, y.mul(y).mul(square))),
        x.mul(horner(&SINC, x.mul(x).mul(square))),
    )
}

#[inline(always)]
fn blend<V: Number>(a: &[V; 4], b: &[V; 4], wa: V, wb: V) -> [V; 4] {
    let mut q = *a;
    for k in 0..4 {
        q[k] = a[k].mul_add(wa, b[k].mul(wb));
    }
    q
}

/// Square of the angle between two unit quaternions.
#[inline(always)]
fn square_angle<V: Number>(a: &[V; 4], b: &[V; 4]) -> V {
    let mut chord = V::splat(0.0);
    for k in 0..4 {
        let d = a[k].sub(b[k]);
        chord = d.mul_add(d, chord);
    }
    chord.mul(horner(&ANGLE, chord))
}

impl<V: Number> Arc<V> {
    #[inline(always)]
    fn new(from: [V; 4], to: [V; 4]) -> Self {
        let square = square_angle(&from, &to);
        Self {
            from,
            to,
            square,
            inverse: horner(&INVERSE, square),
        }
    }

    #[inline(always)]
    fn at(&self, x: V) -> [V; 4] {
        let (a, b) = weights(self.square, x);
        let (a, b) = (a.mul(self.inverse), b.mul(self.inverse));
        blend(&self.from, &self.to, a, b)
    }
}

/// A cubic spherical Bézier curve all of whose arcs are short enough.
#[derive(Debug, Clone, Copy)]
pub(super) struct ShortBezier {
    control: [[f64; 4]; 4],
    /// Of the arcs of the control polygon, the last without meaning.
    squares: [f64; 4],
    inverses: [f64; 4],
}

impl ShortBezier {
    /// `None` where an arc of the control polygon is too long; later rounds have none longer.
    #[inline(always)]
    pub(super) fn new<V: Vector>(control: &[DQuat; 4]) -> Option<Self> {
        let [a, b, c, d] = *control;
        let cosine = a.dot(b).min(b.dot(c)).min(c.dot(d));
        if !(cosine > LEAST_COSINE) {
            return None;
        }
        let control = [a, b, c, d].map(|q| q.to_array());
        // Number by number, so that the three arcs are computed beside each other.
        let mut rows = [[0.0; 5]; 4];
        for k in 0..16 {
            rows[k % 4][k / 4] = control[k / 4][k % 4];
        }
        let (mut squares, mut inverses) = ([0.0; 4], [0.0; 4]);
        for k in (0..4).step_by(V::LANES) {
            let from = each!(i in [0, 1, 2, 3] => V::load(&rows[i][k..]));
            let to = each!(i in [0, 1, 2, 3] => V::load(&rows[i][k + 1..]));
            let arcs = Arc::new(from, to);
            arcs.square.store(&mut squares[k..]);
            arcs.inverse.store(&mut inverses[k..]);
        }
        Some(Self {
            control,
            squares,
            inverses,
        })
    }

    /// The quaternion (x, y, z, w) at φ, of length near 1: the factor of the last arc is left out,
    /// since views are divided by the length anyway.
    #[inline(always)]
    pub(super) fn at<V: Number>(&self, phi: V) -> [V; 4] {
        let [a, b, c, d] =
            each!(k in [0, 1, 2, 3] => each!(i in [0, 1, 2, 3] => V::splat(self.control[k][i])));
        let [ab, bc, cd] = each!(k in [(0, a, b), (1, b, c), (2, c, d)] => Arc {
            from: k.1,
            to: k.2,
            square: V::splat(self.squares[k.0]),
            inverse: V::splat(self.inverses[k.0]),
        }
        .at(phi));
        let abc = Arc::new(ab, bc).at(phi);
        let bcd = Arc::new(bc, cd).at(phi);
        let square = square_angle(&abc, &bcd);
        let (a, b) = weights(square, phi);
        blend(&abc, &bcd, a, b)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::quaternion::{exp, slerp};
    use crate::path::quaternion_spline::bezier;
    use glam::DVec3;

    #[test]
    fn arcs_agree_with_slerp_by_sines() {
        let start = exp(DVec3::new(0.3, -0.7, 0.2));
        for k in 0..=1000 {
            let theta = MAX_ANGLE * f64::from(k) / 1000.0;
            let end = exp(DVec3::new(0.6, 0.8, 0.0) * theta) * start;
            let arc = Arc::<f64>::new(start.to_array(), end.to_array());
            for j in 0..=20 {
                let x = f64::from(j) / 20.0;
                let q = DQuat::from_array(arc.at(x));
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
        let short = ShortBezier::new::<f64>(&control).unwrap();
        for k in 0..=1000 {
            let phi = f64::from(k) / 1000.0;
            let q = DQuat::from_array(short.at::<f64>(phi));
            assert!((q.length() - 1.0).abs() < 0.2);
            assert!((q.normalize() - bezier(&control, phi)).length() < 3e-15);
        }
        let far = [control[0], -control[1], control[2], control[3]];
        assert!(ShortBezier::new::<f64>(&far).is_none());
    }
}
