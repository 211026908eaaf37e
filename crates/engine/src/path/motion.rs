//! How a camera moves: lengths and turning by derivatives of what [`super::fill`] evaluates.

use glam::DVec3;

use super::ahead::AT_TARGET;
use super::dispatch::widest;
use super::fill::{BLOCK, Block, Frames, Row, Scratch, parameters, run, shares, tables_of};
use super::section_sampler::{ArcLengthCurve, SectionSampler};
use super::tables::Tables;
use super::turning::Turning;
use crate::error::Result;
use crate::math::monotone_cubic::slope;
use crate::math::orientation::{POLE, quaternion_from_view};
use crate::math::quaternion::{continue_sign, log};
use crate::math::vector::{self, Dual, Vector, each, horner};

/// How a camera moves at a frame ([`super::Sampler::motion`]).
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Motion {
    /// Length of the way since the first frame.
    pub distance: f64,
    /// Length of the way per frame.
    pub speed: f64,
    /// Angle in radians per frame by which the camera turns as a whole.
    pub turning: f64,
    /// Of the way, one by the radius of its circle; 0 where the camera rests or turns on the spot,
    /// and where the curve has no direction.
    pub curvature: f64,
}

/// Step in φ of the differences that give the turning, of the fourth order, where it has no
/// derivative in closed form.
const STEP: f64 = 1.0 / 4096.0;

widest! {
    pub(super) fn motions_widest = self::motions;
    (section: &SectionSampler, before: f64, scratch: &mut Scratch, frames: &[f64], motions: &mut [Motion]) -> Result<()>
}

/// Fills `motions` with those of a section at ascending `frames`; `before` is the way before it.
#[inline(always)]
fn motions<V: Vector>(
    section: &SectionSampler,
    before: f64,
    scratch: &mut Scratch,
    frames: &[f64],
    motions: &mut [Motion],
) -> Result<()> {
    let Scratch {
        tables,
        once,
        block,
        ..
    } = scratch;
    let tables = tables_of::<V>(section, tables, *once)?;
    let mut rates = Rates::default();
    let length = section.way.as_ref().map_or(0.0, |way| way.length);
    for (at, motions) in (0..).step_by(BLOCK).zip(motions.chunks_mut(BLOCK)) {
        let count = motions.len();
        shares::<V>(section, Frames::At(frames), at, count, &mut block.phi);
        if let Some(way) = &section.way {
            parameters::<V>(way, tables, count, block);
            curvatures::<V>(way, count, &block.t, &mut rates.curvature);
        }
        turnings::<V>(section, tables, count, block, &mut rates.turning);
        for (k, motion) in motions.iter_mut().enumerate() {
            let pace = section.pace(frames[at + k]);
            *motion = Motion {
                distance: before + block.phi[k] * length,
                speed: pace * length,
                turning: rates.turning[k] * pace,
                curvature: rates.curvature[k],
            };
        }
    }
    Ok(())
}

/// Of a block of frames, by the way.
#[repr(align(64))]
struct Rates {
    /// Angle in radians by φ.
    turning: Row,
    curvature: Row,
}

impl Default for Rates {
    fn default() -> Self {
        let row = [0.0; size_of::<Row>() / size_of::<f64>()];
        Self {
            turning: row,
            curvature: row,
        }
    }
}

impl SectionSampler {
    /// Derivative of φ at a frame of the path.
    #[allow(clippy::cast_precision_loss)]
    fn pace(&self, frame: f64) -> f64 {
        let frames = self.frames as f64;
        let slope = self.speed.as_ref().map_or(1.0, |speed| {
            speed[0].slope(((frame - self.start as f64) / frames).min(1.0))
        });
        slope / frames
    }

    /// Angle in radians by φ at φ, by differences.
    fn turning_rate(&self, tables: &Tables, phi: f64) -> f64 {
        let place = |phi: f64| self.place(&tables.arc, phi);
        let step = if phi > 0.5 { -STEP } else { STEP };
        let q = |k: f64| {
            let (view, up) = self.turning.view_at(phi + k * step, &place, self.space);
            quaternion_from_view(view, up)
        };
        let here = q(0.0);
        let turned = |k: f64| log(continue_sign(here, q(k)).0 * here.conjugate());
        let turn = 48.0 * turned(1.0) - 36.0 * turned(2.0) + 16.0 * turned(3.0) - 3.0 * turned(4.0);
        // Angles on S³ are half of those in space.
        2.0 * (turn / (12.0 * step)).length()
    }
}

#[inline(always)]
fn curvatures<V: Vector>(way: &ArcLengthCurve, count: usize, t: &Row, curvature: &mut Row) {
    let curve = &way.curve;
    let (a, b, c) = (3.0 * curve.a, 2.0 * curve.b, curve.c);
    for k in (0..count).step_by(V::LANES) {
        let t = V::load(&t[k..]);
        let first = each!(i in [0, 1, 2] => horner(&[c[i], b[i], a[i]], t));
        let second = each!(i in [0, 1, 2] => horner(&[b[i], 2.0 * a[i]], t));
        let across = each!(i in [(1, 2), (2, 0), (0, 1)] =>
            first[i.0].mul(second[i.1]).sub(first[i.1].mul(second[i.0])));
        let square = dot(first, first);
        let cube = square.mul(square.sqrt());
        dot(across, across)
            .sqrt()
            .div(cube)
            .store(&mut curvature[k..]);
    }
    for curvature in &mut curvature[..count] {
        // Where the curve stops it has no direction.
        if !curvature.is_finite() {
            *curvature = 0.0;
        }
    }
}

#[inline(always)]
fn dot<V: Vector>(a: [V; 3], b: [V; 3]) -> V {
    a[0].mul_add(b[0], a[1].mul_add(b[1], a[2].mul(b[2])))
}

/// Angles in radians by φ.
#[inline(always)]
fn turnings<V: Vector>(
    section: &SectionSampler,
    tables: &Tables,
    count: usize,
    block: &Block,
    rates: &mut Row,
) {
    let phi = &block.phi;
    match &section.turning {
        Turning::Kept(..) => rates[..count].fill(0.0),
        Turning::Tracked(target, roll) => {
            tracked::<V>(section, tables, (*target, roll), count, block, rates);
        }
        Turning::Follow(_) => by_differences(section, tables, &phi[..count], rates),
        _ => {
            let mut from = 0;
            let mut piece = tables.turn.partition_point(|fit| fit.end <= phi[0]);
            while from < count {
                piece = piece.min(tables.turn.len() - 1);
                let fit = &tables.turn[piece];
                let to = run(&tables.turn, piece, phi, from, count);
                if let Some(powers) = &fit.powers {
                    for k in (from..to).step_by(V::LANES) {
                        let x = [fit.x(by_phi(V::load(&phi[k..])))];
                        let q = each!(i in [0, 1, 2, 3] => fit.at(&powers[i], &x)[0]);
                        rate(q).store(&mut rates[k..]);
                    }
                } else if let Some(bezier) = &tables.bezier {
                    for k in (from..to).step_by(V::LANES) {
                        rate(bezier.at(by_phi(V::load(&phi[k..])))).store(&mut rates[k..]);
                    }
                } else {
                    by_differences(section, tables, &phi[from..to], &mut rates[from..]);
                }
                from = to;
                piece += 1;
            }
        }
    }
}

/// φ, by which the derivatives are.
#[inline(always)]
fn by_phi<V: Vector>(phi: V) -> Dual<V> {
    Dual {
        value: phi,
        slope: V::splat(1.0),
    }
}

/// Not inlined, to keep out of the way of the fast code.
#[inline(never)]
fn by_differences(section: &SectionSampler, tables: &Tables, phi: &[f64], rates: &mut [f64]) {
    for (rate, &phi) in rates.iter_mut().zip(phi) {
        *rate = section.turning_rate(tables, phi);
    }
}

/// Angular velocity of a quaternion of any length: 2·|Im(q′·q̄)|/|q|².
#[inline(always)]
fn rate<V: Vector>(q: [Dual<V>; 4]) -> V {
    let [x, y, z, w] = each!(k in [0, 1, 2, 3] => q[k].value);
    let [dx, dy, dz, dw] = each!(k in [0, 1, 2, 3] => q[k].slope);
    let v = [x, y, z];
    let dv = [dx, dy, dz];
    let turn = each!(i in [(0, 1, 2), (1, 2, 0), (2, 0, 1)] => {
        let across = v[i.1].mul(dv[i.2]).sub(v[i.2].mul(dv[i.1]));
        w.mul_add(dv[i.0], across.sub(dw.mul(v[i.0])))
    });
    let square = dot(v, v).add(w.mul(w));
    let twice = dot(turn, turn).sqrt();
    twice.add(twice).div(square)
}

/// The turning of a camera that looks at a target: yaw, pitch and roll of its view.
#[inline(always)]
fn tracked<V: Vector>(
    section: &SectionSampler,
    tables: &Tables,
    (target, roll): (DVec3, &[f64; 4]),
    count: usize,
    block: &Block,
    rates: &mut Row,
) {
    let Some(ArcLengthCurve { curve, length }) = &section.way else {
        for (rate, &phi) in rates.iter_mut().zip(&block.phi[..count]) {
            *rate = slope(roll, phi).abs();
        }
        return;
    };
    let up = section.space.up;
    let upright = |v: DVec3| up.upright(v);
    let [a, b, c] = [curve.a, curve.b, curve.c].map(upright);
    let offset = upright(target - curve.d);
    let near = 2.0 * AT_TARGET * section.space.half_size;
    for (k, rate) in rates[..count].iter_mut().enumerate() {
        let (t, phi) = (block.t[k], block.phi[k]);
        let to = offset - ((a * t + b) * t + c) * t;
        let first = (3.0 * a * t + 2.0 * b) * t + c;
        let (distance, speed) = (to.length(), first.length());
        let across = (to.x * to.x + to.z * to.z).sqrt();
        let regular = distance > near && across > 2.0 * POLE * distance && speed > 1e-9 * length;
        if !regular {
            *rate = section.turning_rate(tables, phi);
            continue;
        }
        let moved = first * (-length / speed);
        let inward = (to.x * moved.x + to.z * moved.z) / across;
        let yaw = (to.z * moved.x - to.x * moved.z) / (across * across);
        let pitch = (across * moved.y - to.y * inward) / (distance * distance);
        let roll = slope(roll, phi);
        // The axis of the yaw and that of the roll are not perpendicular.
        let level = yaw * across / distance;
        let about_view = roll + yaw * to.y / distance;
        *rate = DVec3::new(level, pitch, about_view).length();
    }
}
