//! The principal normal of a curve with continuous curvature, without the jumps of Frenet's frame:
//! its sign goes on through inflections, and straight pieces carry it on (Kolb, Computergraphik II,
//! 9.2.2, with the signed angle).
//!
//! On a cubic P′ × P″ is a quadratic B₀ + B₁t + B₂t²; its zeros are the inflections.

use glam::DVec3;

use super::hermite::{Cubic, end_direction};
use crate::error::{Result, vec_with_room};
use crate::math::rotation_minimising::{perpendicular, shortest, signed_angle, turned};

/// |P′ × P″| below this share of the squared size counts as zero: there the normal is exact to 1e-7.
const STRAIGHT: f64 = 1e-9;

/// How far beside an inflection, in t, its two sides are compared.
const BESIDE: f64 = 1e-5;

/// Nearer to an inflection, in t, the limit takes the place of the formula.
const LIMIT: f64 = 1e-8;

#[derive(Debug, Clone, PartialEq)]
enum Kind {
    /// Coefficients of P′ × P″, its zeros, and the sign of the normal at the start.
    Bent([DVec3; 3], [Option<f64>; 2], f64),
    /// The normal at the start, and how far it has turned at both ends.
    Straight(DVec3, [f64; 2]),
}

#[derive(Debug, Clone, PartialEq)]
struct Segment {
    curve: Cubic,
    length: f64,
    kind: Kind,
}

/// The normals of a whole curve.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Normals {
    segments: Vec<Segment>,
    /// The segment where a half turn begins to be spread, if a closed curve turns the normal over.
    turns_over: Option<usize>,
}

impl Segment {
    fn new(curve: &Cubic, length: f64) -> Self {
        let b = [
            2.0 * curve.c.cross(curve.b),
            6.0 * curve.c.cross(curve.a),
            -6.0 * curve.a.cross(curve.b),
        ];
        let size = (curve.a.length() + curve.b.length() + curve.c.length()).powi(2);
        let at = |t: f64| b[0] + t * (b[1] + t * b[2]);
        let most = [0.0, 0.5, 1.0].map(|t| at(t).length());
        if most.iter().all(|most| *most <= STRAIGHT * size) {
            return Self {
                curve: *curve,
                length,
                kind: Kind::Straight(DVec3::ZERO, [0.0; 2]),
            };
        }
        // Zeros of the largest component; `vanishes` drops those where another is left.
        let largest = b
            .into_iter()
            .max_by(|a, b| a.length().total_cmp(&b.length()));
        let axis = largest.unwrap_or(DVec3::X);
        let roots = roots(b.map(|b| b.dot(axis)));
        let vanishes =
            |t: &f64| (-BESIDE..=1.0 + BESIDE).contains(t) && at(*t).length() <= STRAIGHT * size;
        Self {
            curve: *curve,
            length,
            kind: Kind::Bent(b, roots.map(|t| t.filter(vanishes)), 1.0),
        }
    }

    fn tangent(&self, t: f64) -> Option<DVec3> {
        if t <= 0.0 || t >= 1.0 {
            return end_direction(&self.curve, t >= 1.0);
        }
        self.curve.derivative(t).try_normalize()
    }

    /// The normal of a bent segment by the formula, at inflections by its limit.
    fn raw(&self, b: &[DVec3; 3], zeros: &[Option<f64>; 2], t: f64) -> Option<DVec3> {
        let mut along = b[0] + t * (b[1] + t * b[2]);
        let slope = |t: f64| b[1] + 2.0 * t * b[2];
        let near = |zero: &&f64| (t - **zero).abs() < LIMIT;
        if let Some(&zero) = zeros.iter().flatten().find(near) {
            let ends = zero > 1.0 - BESIDE || (zero >= BESIDE && t < zero);
            let side = if ends { -1.0 } else { 1.0 };
            let first = slope(zero);
            along = if first.length() > 1e-6 * b[2].length() {
                side * first
            } else {
                b[2]
            };
        }
        perpendicular(along.cross(self.tangent(t)?), self.tangent(t)?)
    }

    fn sign(&self, b: &[DVec3; 3], zeros: &[Option<f64>; 2], first: f64, t: f64) -> f64 {
        let mut sign = first;
        for &zero in zeros.iter().flatten() {
            let inside = zero > BESIDE && zero < 1.0 - BESIDE;
            if inside && t >= zero {
                let beside = [-BESIDE, BESIDE].map(|h| self.raw(b, zeros, zero + h));
                if let [Some(before), Some(after)] = beside
                    && before.dot(after) < 0.0
                {
                    sign = -sign;
                }
            }
        }
        sign
    }

    fn normal(&self, t: f64, share: f64) -> Option<DVec3> {
        match &self.kind {
            Kind::Bent(b, zeros, first) => {
                Some(self.sign(b, zeros, *first, t) * self.raw(b, zeros, t)?)
            }
            Kind::Straight(normal, [from, to]) => {
                let along = self.tangent(t).or_else(|| self.tangent(0.0))?;
                Some(turned(*normal, along, from + (to - from) * share))
            }
        }
    }
}

fn roots([c, b, a]: [f64; 3]) -> [Option<f64>; 2] {
    let discriminant = b * b - 4.0 * a * c;
    if discriminant < 0.0 {
        return [None; 2];
    }
    let q = -0.5 * (b + discriminant.sqrt().copysign(b));
    let finite = |t: f64| t.is_finite().then_some(t);
    [finite(q / a), finite(c / q)]
}

impl Normals {
    /// For segments that join with continuous curvature; `None` if all are straight.
    pub(super) fn new(curves: &[Cubic], starts: &[f64], closed: bool) -> Result<Option<Self>> {
        let count = curves.len();
        let mut segments = vec_with_room(count)?;
        for (k, curve) in curves.iter().enumerate() {
            segments.push(Segment::new(curve, starts[k + 1] - starts[k]));
        }
        let bent = |segment: &Segment| matches!(segment.kind, Kind::Bent(..));
        let Some(first) = segments.iter().position(bent) else {
            return Ok(None);
        };
        let mut normals = Self {
            segments,
            turns_over: None,
        };
        let begin = normals.segments[first].normal(0.0, 0.0);
        let Some(mut normal) = begin else {
            return Ok(None);
        };
        // What lies before the first bend has its normal; on a closed curve that is the last run.
        if !closed {
            for k in (0..first).rev() {
                let (here, behind) = (&normals.segments[k], &normals.segments[k + 1]);
                if let (Some(to), Some(from)) = (here.tangent(1.0), behind.tangent(0.0)) {
                    normal = shortest(normal, from, to);
                }
                if let (Some(to), Some(from)) = (here.tangent(0.0), here.tangent(1.0)) {
                    normal = shortest(normal, from, to);
                }
                normals.segments[k].kind = Kind::Straight(normal, [0.0; 2]);
            }
        }
        let end = if closed { first + count } else { count };
        let mut carried: Option<(DVec3, DVec3)> = None;
        let mut run = first;
        for k in first..=end {
            if k == end && !closed {
                break;
            }
            let at = k % count;
            let here = normals.segments[at].tangent(0.0);
            let arrived = match (carried, here) {
                (Some((normal, from)), Some(to)) => Some(shortest(normal, from, to)),
                (carried, _) => carried.map(|(normal, _)| normal),
            };
            let wanted = match normals.segments[at].kind {
                Kind::Bent(..) => normals.segments[at].normal(0.0, 0.0),
                Kind::Straight(..) => None,
            };
            if let (Some(arrived), Some(wanted), Some(along)) = (arrived, wanted, here) {
                let flips = arrived.dot(wanted) < 0.0;
                let wanted = if flips { -wanted } else { wanted };
                normals.turn_run(run, k, signed_angle(arrived, wanted, along));
                if k == end {
                    normals.turns_over = flips.then_some(first);
                } else if flips && let Kind::Bent(_, _, sign) = &mut normals.segments[at].kind {
                    *sign = -*sign;
                }
            }
            if k == end {
                break;
            }
            if let (Kind::Straight(normal, _), Some(arrived)) =
                (&mut normals.segments[at].kind, arrived)
            {
                *normal = arrived;
            }
            if wanted.is_some() {
                run = k + 1;
            }
            let segment = &normals.segments[at];
            carried = match (segment.normal(1.0, 1.0), segment.tangent(1.0)) {
                (Some(normal), Some(along)) => Some((normal, along)),
                _ => carried,
            };
        }
        Ok(Some(normals))
    }

    /// Spreads an angle over the straight segments from `run` to before `end`.
    fn turn_run(&mut self, run: usize, end: usize, angle: f64) {
        let count = self.segments.len();
        let whole: f64 = (run..end).map(|k| self.segments[k % count].length).sum();
        let mut gone = 0.0;
        for k in run..end {
            let segment = &mut self.segments[k % count];
            let from = gone;
            gone += segment.length;
            if let Kind::Straight(_, angles) = &mut segment.kind
                && whole > 0.0
            {
                *angles = [angle * from / whole, angle * gone / whole];
            }
        }
    }

    /// [`Self::at`], under the shortest rotation from the tangent to a view there.
    pub(super) fn up(&self, segment: usize, (t, share): (f64, f64), view: DVec3) -> Option<DVec3> {
        let normal = self.at(segment, t, share)?;
        Some(shortest(normal, self.segments[segment].tangent(t)?, view))
    }

    /// The normal at the parameter `t` of a segment, `share` of its length from its start.
    pub(super) fn at(&self, segment: usize, t: f64, share: f64) -> Option<DVec3> {
        let here = &self.segments[segment];
        let normal = here.normal(t, share)?;
        let Some(first) = self.turns_over else {
            return Some(normal);
        };
        let length = |k: usize| self.segments[k % self.segments.len()].length;
        let count = self.segments.len();
        let steps = (segment + count - first) % count;
        let before: f64 = (first..first + steps).map(length).sum();
        let whole: f64 = (0..count).map(length).sum();
        let turn = std::f64::consts::PI * (before + share * here.length) / whole;
        Some(turned(normal, here.tangent(t)?, turn))
    }
}
