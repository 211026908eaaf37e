//! The frames of one section, many at a time: the only vector code.
//!
//! It is ordinary code over short arrays, compiled once for every processor
//! and once for those with wide vectors and fused multiplication; the two agree
//! to rounding. Runs of frames that lie on the same polynomial are computed in
//! strides of [`STRIDE`] and may overshoot their end: what they spoil there is
//! written again by the next run, and arrays are longer than a block for the
//! last one. Everything is forced inline, since a function that is called
//! would be compiled for the plainest processor.

use glam::DVec3;

use super::arc_length;
use super::leg::{Leg, Way};
use super::orientation_curve::{AT_TARGET, Turning};
use super::pose::Pose;
use super::speed_curve::{INTERVALS, SpeedCurve};
use super::tables::{Tables, quaternions};
use crate::error::Result;
use crate::math::chebyshev::NODES;
use crate::math::fused::{Fused, MultiplyAdd, Separate, horner};
use crate::math::orientation::POLE;

/// Frames of a block: all its numbers stay in the first-level cache.
const BLOCK: usize = 256;

/// Frames computed side by side.
const STRIDE: usize = 8;

/// A row of one number for each frame of a block, with room to overshoot.
type Row = [f64; BLOCK + STRIDE];

/// The frames of a block, number by number.
struct Block {
    phi: Row,
    t: Row,
    q: [Row; 4],
    /// VRP, VPN, VUP, zoom.
    pose: [Row; 10],
}

/// Frames at φ values of the section, `first` being the number of the first
/// frame within the section (from 1): fills `poses`. `scratch` holds the
/// section's tables where the section has not kept its own.
///
/// # Errors
/// [`crate::Error::Memory`].
pub(super) fn fill(
    leg: &Leg,
    scratch: &mut Tables,
    first: usize,
    poses: &mut [Pose],
) -> Result<()> {
    #[cfg(all(target_arch = "x86_64", not(vides_no_simd)))]
    if std::arch::is_x86_feature_detected!("avx2") && std::arch::is_x86_feature_detected!("fma") {
        // SAFETY: the processor has just been asked for both features.
        #[allow(unsafe_code)]
        return unsafe { fill_avx2(leg, scratch, first, poses) };
    }
    if cfg!(target_feature = "fma") || cfg!(target_arch = "aarch64") {
        return fill_with::<Fused>(leg, scratch, first, poses);
    }
    fill_with::<Separate>(leg, scratch, first, poses)
}

#[cfg(all(target_arch = "x86_64", not(vides_no_simd)))]
#[target_feature(enable = "avx2,fma")]
fn fill_avx2(leg: &Leg, scratch: &mut Tables, first: usize, poses: &mut [Pose]) -> Result<()> {
    fill_with::<Fused>(leg, scratch, first, poses)
}

/// Sections with fewer frames than this do not keep their tables: they are
/// made again faster than they come back from memory.
const KEEP: usize = 1024;

#[inline(always)]
fn fill_with<M: MultiplyAdd>(
    leg: &Leg,
    scratch: &mut Tables,
    first: usize,
    poses: &mut [Pose],
) -> Result<()> {
    let tables = match leg.tables.get() {
        Some(tables) => tables,
        None if leg.frames >= KEEP => {
            let mut tables = Tables::default();
            tables.build::<M>(leg)?;
            leg.tables.get_or_init(|| tables)
        }
        None => {
            scratch.build::<M>(leg)?;
            &*scratch
        }
    };
    let mut block = Block {
        phi: [0.0; BLOCK + STRIDE],
        t: [0.0; BLOCK + STRIDE],
        q: [[0.0; BLOCK + STRIDE]; 4],
        pose: [[0.0; BLOCK + STRIDE]; 10],
    };
    let mut number = first;
    for poses in poses.chunks_mut(BLOCK) {
        let count = poses.len();
        shares::<M>(leg, number, count, &mut block.phi);
        places::<M>(leg, tables, count, &mut block);
        views::<M>(leg, tables, count, &mut block);
        for k in (0..count).step_by(STRIDE) {
            for i in k..k + STRIDE {
                block.pose[9][i] = horner::<M, 4>(&leg.zoom, block.phi[i]);
            }
        }
        if let Turning::Tracked(target, _) = leg.turning {
            mend(leg, target, count, &mut block)?;
        }
        store(&block.pose, poses);
        number += count;
    }
    Ok(())
}

/// φ of each frame.
#[inline(always)]
#[allow(clippy::cast_precision_loss)]
fn shares<M: MultiplyAdd>(leg: &Leg, number: usize, count: usize, phi: &mut Row) {
    let scale = 1.0 / leg.frames as f64;
    let start = number as f64;
    for k in 0..BLOCK + STRIDE {
        phi[k] = (start + k as f64) * scale;
    }
    if let Some(speed) = &leg.speed {
        paced_shares::<M>(&speed[0], count, phi);
    }
    // What overshoots must stay harmless.
    for phi in &mut phi[count..] {
        *phi = 1.0;
    }
}

/// From u to φ by the integral of the speed curve.
#[inline(always)]
fn paced_shares<M: MultiplyAdd>(speed: &SpeedCurve, count: usize, phi: &mut Row) {
    let u = *phi;
    let coefficients = speed.fraction_coefficients();
    let mut from = 0;
    for i in 0..INTERVALS {
        #[allow(clippy::cast_precision_loss)]
        let (left, right) = (i as f64, (i + 1) as f64);
        let to = if i + 1 == INTERVALS {
            count
        } else {
            from + u[from..count].partition_point(|&u| u * (INTERVALS as f64) < right)
        };
        let mut k = from;
        while k < to {
            for j in k..k + STRIDE {
                let x = M::mul_add(u[j], INTERVALS as f64, -left);
                phi[j] = horner::<M, 5>(&coefficients[i], x).clamp(0.0, 1.0);
            }
            k += STRIDE;
        }
        from = to;
    }
}

/// VRP of each frame.
#[inline(always)]
fn places<M: MultiplyAdd>(leg: &Leg, tables: &Tables, count: usize, block: &mut Block) {
    let Some(way) = &leg.way else {
        for axis in 0..3 {
            block.pose[axis] = [leg.position[axis]; BLOCK + STRIDE];
        }
        return;
    };
    parameters::<M>(way, tables, count, block);
    let curve = &way.curve;
    for axis in 0..3 {
        let powers = [curve.d[axis], curve.c[axis], curve.b[axis], curve.a[axis]];
        for k in (0..count).step_by(STRIDE) {
            for i in k..k + STRIDE {
                block.pose[axis][i] = horner::<M, 4>(&powers, block.t[i]);
            }
        }
    }
}

/// The curve's parameter of each frame.
#[inline(always)]
fn parameters<M: MultiplyAdd>(way: &Way, tables: &Tables, count: usize, block: &mut Block) {
    let Block { phi, t, .. } = block;
    let mut from = 0;
    let mut piece = tables.place.partition_point(|fit| fit.end <= phi[0]);
    while from < count {
        let last = piece + 1 >= tables.place.len();
        let fit = &tables.place[piece.min(tables.place.len() - 1)];
        let to = if last {
            count
        } else {
            from + phi[from..count].partition_point(|&phi| phi < fit.end)
        };
        if let Some([powers]) = &fit.powers {
            let mut k = from;
            while k < to {
                for j in k..k + STRIDE {
                    t[j] = horner::<M, NODES>(powers, fit.x(phi[j]));
                }
                k += STRIDE;
            }
        } else {
            let mut s = [0.0; BLOCK];
            for k in from..to {
                s[k] = phi[k] * way.length;
            }
            arc_length::invert::<M>(&tables.arc, &s[from..to], &mut t[from..to]);
        }
        from = to;
        piece += 1;
    }
}

/// VPN and VUP of each frame.
#[inline(always)]
fn views<M: MultiplyAdd>(leg: &Leg, tables: &Tables, count: usize, block: &mut Block) {
    match &leg.turning {
        Turning::Kept(view, up) => {
            for axis in 0..3 {
                block.pose[3 + axis] = [view[axis]; BLOCK + STRIDE];
                block.pose[6 + axis] = [up[axis]; BLOCK + STRIDE];
            }
        }
        Turning::Tracked(target, roll) => tracked::<M>(*target, roll, count, block),
        turning => {
            turned::<M>(turning, tables, count, block);
            views_from_quaternions::<M>(count, block);
        }
    }
}

/// The quaternion of each frame.
#[inline(always)]
fn turned<M: MultiplyAdd>(turning: &Turning, tables: &Tables, count: usize, block: &mut Block) {
    let Block { phi, q, .. } = block;
    let mut from = 0;
    let mut piece = tables.turn.partition_point(|fit| fit.end <= phi[0]);
    while from < count {
        let last = piece + 1 >= tables.turn.len();
        let fit = &tables.turn[piece.min(tables.turn.len() - 1)];
        let to = if last {
            count
        } else {
            from + phi[from..count].partition_point(|&phi| phi < fit.end)
        };
        let mut k = from;
        if let Some(powers) = &fit.powers {
            while k < to {
                for j in k..k + STRIDE {
                    let x = fit.x(phi[j]);
                    q[0][j] = horner::<M, NODES>(&powers[0], x);
                    q[1][j] = horner::<M, NODES>(&powers[1], x);
                    q[2][j] = horner::<M, NODES>(&powers[2], x);
                    q[3][j] = horner::<M, NODES>(&powers[3], x);
                }
                k += STRIDE;
            }
        } else {
            while k < to {
                let mut some = [0.0; STRIDE];
                some.copy_from_slice(&phi[k..k + STRIDE]);
                let mut values = [[0.0; STRIDE]; 4];
                quaternions::<M, STRIDE>(turning, tables.bezier.as_ref(), &some, &mut values);
                for component in 0..4 {
                    q[component][k..k + STRIDE].copy_from_slice(&values[component]);
                }
                k += STRIDE;
            }
        }
        from = to;
        piece += 1;
    }
}

/// Third and second column of each quaternion's rotation; dividing by |q|²
/// makes them unit whatever the length of q.
#[inline(always)]
fn views_from_quaternions<M: MultiplyAdd>(count: usize, block: &mut Block) {
    let Block { q, pose, .. } = block;
    for k in (0..count).step_by(STRIDE) {
        for i in k..k + STRIDE {
            let (x, y, z, w) = (q[0][i], q[1][i], q[2][i], q[3][i]);
            let (xx, yy, zz, ww) = (x * x, y * y, z * z, w * w);
            let scale = 1.0 / ((xx + yy) + (zz + ww));
            let twice = scale + scale;
            pose[3][i] = twice * M::mul_add(x, z, w * y);
            pose[4][i] = twice * M::mul_add(y, z, -(w * x));
            pose[5][i] = scale * ((ww - xx) + (zz - yy));
            pose[6][i] = twice * M::mul_add(x, y, -(w * z));
            pose[7][i] = scale * ((ww - xx) + (yy - zz));
            pose[8][i] = twice * M::mul_add(y, z, w * x);
        }
    }
}

/// Views that look at a target; those that have no direction or no yaw of
/// their own come out as they may and are mended afterwards.
#[inline(always)]
fn tracked<M: MultiplyAdd>(target: DVec3, roll: &[f64; 4], count: usize, block: &mut Block) {
    let Block { phi, pose, q, .. } = block;
    let (sin, rest) = q.split_at_mut(1);
    let (sin, cos) = (&mut sin[0], &mut rest[0]);
    for k in 0..count {
        (sin[k], cos[k]) = horner::<M, 4>(roll, phi[k]).sin_cos();
    }
    for k in (0..count).step_by(STRIDE) {
        for i in k..k + STRIDE {
            let x = target.x - pose[0][i];
            let y = target.y - pose[1][i];
            let z = target.z - pose[2][i];
            let scale = 1.0 / (x * x + y * y + z * z).sqrt();
            let (x, y, z) = (x * scale, y * scale, z * scale);
            let h = (x * x + z * z).sqrt();
            let (sin_yaw, cos_yaw) = (x / h, z / h);
            pose[3][i] = x;
            pose[4][i] = y;
            pose[5][i] = z;
            pose[6][i] = -y * sin_yaw * cos[i] - cos_yaw * sin[i];
            pose[7][i] = h * cos[i];
            pose[8][i] = -y * cos_yaw * cos[i] + sin_yaw * sin[i];
        }
    }
}

/// Computes those tracked frames the plain way that lie at the target, or
/// straight above or below it.
fn mend(leg: &Leg, target: DVec3, count: usize, block: &mut Block) -> Result<()> {
    for i in 0..count {
        let pose = &block.pose;
        let offset = target - DVec3::new(pose[0][i], pose[1][i], pose[2][i]);
        // Twice the bounds, since the plain way measures with other rounding.
        let far = offset.abs().max_element() > 2.0 * AT_TARGET;
        let level = pose[3][i].abs().max(pose[5][i].abs()) > 2.0 * POLE;
        let far_enough_to_square = offset.abs().max_element() > 1e-100;
        if far && level && far_enough_to_square {
            continue;
        }
        let plain = leg.pose(block.phi[i])?;
        for axis in 0..3 {
            block.pose[3 + axis][i] = plain.vpn[axis];
            block.pose[6 + axis][i] = plain.vup[axis];
        }
    }
    Ok(())
}

/// From rows to poses.
#[inline(always)]
fn store(rows: &[Row; 10], poses: &mut [Pose]) {
    for (i, pose) in poses.iter_mut().enumerate() {
        *pose = Pose {
            vrp: [rows[0][i], rows[1][i], rows[2][i]],
            vpn: [rows[3][i], rows[4][i], rows[5][i]],
            vup: [rows[6][i], rows[7][i], rows[8][i]],
            zoom: rows[9][i],
        };
    }
}
