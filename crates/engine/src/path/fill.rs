//! The poses of one section at whole frames or between them, many at a time.
//!
//! Runs of frames on the same polynomial are computed vector by vector and may overshoot: the next
//! run writes over what they spoil, and arrays are longer than a block for the last one. No frame
//! depends on which others are asked for with it. All is forced inline: see [`super::dispatch`].

use std::sync::atomic::Ordering;

use glam::DVec3;

use super::ahead::AT_TARGET;
use super::arc_length;
use super::dispatch::widest;
use super::pose::Pose;
use super::section_sampler::{ArcLengthCurve, SectionSampler};
use super::space::Up;
use super::speed_curve::{INTERVALS, SpeedCurve};
use super::tables::{Fit, Tables, quaternions};
use super::timing::Timing;
use super::turning::Turning;
use crate::error::Result;
use crate::math::orientation::POLE;
use crate::math::vector::{self, Vector, each, horner};

/// Frames of a block, whose numbers all stay in the first-level cache.
pub(super) const BLOCK: usize = 64;

/// Frames by which a run may overshoot.
const STRIDE: usize = 16;

/// Vectors of frames that a polynomial is evaluated for at once.
const AT_ONCE: usize = 4;

/// A row of one number for each frame of a block, with room to overshoot.
pub(super) type Row = [f64; BLOCK + STRIDE];

#[repr(align(64))]
pub(super) struct Block {
    pub phi: Row,
    /// Length from the start, where the parameter is searched directly.
    s: Row,
    /// The curve's parameter.
    pub t: Row,
    /// The quaternion; for tracked frames the sine and cosine of the roll.
    q: [Row; 4],
}

/// The poses of a block, where they are put together before they are written.
#[repr(align(64))]
struct Records([f64; 10 * STRIDE]);

/// Working memory that one call hands from section to section.
pub(super) struct Scratch {
    /// The tables of a section that does not keep any yet.
    pub(super) tables: Tables,
    /// The poses are wanted once: only long sections keep tables.
    pub(super) once: bool,
    pub(super) block: Block,
    records: Records,
}

impl Scratch {
    /// Written where it stays: for one pose alone copying it would count.
    #[inline(always)]
    pub(super) fn new() -> Self {
        const ROW: Row = [0.0; BLOCK + STRIDE];
        Self {
            tables: Tables::default(),
            once: false,
            block: Block {
                phi: ROW,
                s: ROW,
                t: ROW,
                q: [ROW, ROW, ROW, ROW],
            },
            records: Records([0.0; 10 * STRIDE]),
        }
    }
}

/// Shorter sections keep their tables only when they are filled again: that costs more memory
/// and time, for nothing if every pose is wanted once.
const KEEP: usize = 1024;

/// Which frames of a section are wanted, counted from its start.
#[derive(Clone, Copy)]
pub(super) enum Frames<'a> {
    /// Whole ones in order; the number of the first, at least 1.
    From(usize),
    /// Any, none before its predecessor; numbers of the path, as many as there are poses.
    At(&'a [f64]),
}

widest! {
    pub(super) fn fill_widest = self::fill;
    (section: &SectionSampler, scratch: &mut Scratch, frames: Frames<'_>, poses: &mut [Pose]) -> Result<()>
}

/// Fills `poses` with the poses of a section at `frames`.
#[inline(always)]
pub(super) fn fill<V: Vector>(
    section: &SectionSampler,
    scratch: &mut Scratch,
    frames: Frames<'_>,
    poses: &mut [Pose],
) -> Result<()> {
    let Scratch {
        tables,
        once,
        block,
        records,
    } = scratch;
    let tables = tables_of::<V>(section, tables, *once)?;
    for (at, poses) in (0..).step_by(BLOCK).zip(poses.chunks_mut(BLOCK)) {
        let count = poses.len();
        shares::<V>(section, frames, at, count, &mut block.phi);
        if let Turning::Follow(_) = section.turning {
            for (pose, &phi) in poses.iter_mut().zip(&block.phi) {
                *pose = section.pose(tables, phi);
            }
            continue;
        }
        if let Some(way) = &section.way {
            parameters::<V>(way, tables, count, block);
        }
        match &section.turning {
            Turning::Kept(..) | Turning::Follow(_) => {}
            Turning::Tracked(_, roll) => {
                let [sin, cos, ..] = &mut block.q;
                for k in 0..count {
                    (sin[k], cos[k]) = horner::<f64, 4>(roll, block.phi[k]).sin_cos();
                }
            }
            turning => turned::<V>(turning, tables, count, block),
        }
        write::<V>(section, block, records, poses);
        if let Turning::Tracked(target, _) = section.turning {
            resolve_singularities(section, tables, target, &block.phi, poses);
        }
    }
    Ok(())
}

/// The tables of a section: its own, or where it does not keep any, those made in `room`.
#[inline(always)]
pub(super) fn tables_of<'a, V: Vector>(
    section: &'a SectionSampler,
    room: &'a mut Tables,
    once: bool,
) -> Result<&'a Tables> {
    if let Some(tables) = section.tables.get() {
        return Ok(&tables[0]);
    }
    room.build::<V>(section)?;
    let again = !once && section.filled.swap(true, Ordering::Relaxed);
    if section.frames >= KEEP || again {
        section.keep(room)
    } else {
        Ok(room)
    }
}

/// φ of `count` frames from the one `at` this place on.
#[inline(always)]
#[allow(clippy::cast_precision_loss)]
pub(super) fn shares<V: Vector>(
    section: &SectionSampler,
    frames: Frames<'_>,
    at: usize,
    count: usize,
    phi: &mut Row,
) {
    const COUNTING: [f64; 8] = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0];
    let scale = 1.0 / section.frames as f64;
    match frames {
        Frames::From(first) => {
            let counting = V::load(&COUNTING);
            for k in (0..count).step_by(V::LANES) {
                let frame = V::splat((first + at + k) as f64).add(counting);
                let share = frame.mul(V::splat(scale));
                share.min(V::splat(1.0)).store(&mut phi[k..]);
            }
        }
        Frames::At(frames) => {
            for (phi, frame) in phi.iter_mut().zip(&frames[at..at + count]) {
                *phi = ((frame - section.start as f64) * scale).min(1.0);
            }
        }
    }
    if let Some([timing]) = section.speed.as_deref() {
        match timing.plain_curve() {
            Some(speed) => paced_shares::<V>(speed, count, phi),
            None => plain_shares(timing, &mut phi[..count]),
        }
    }
}

/// From u to φ one by one; not inlined, to keep out of the way of the fast code.
#[inline(never)]
fn plain_shares(timing: &Timing, phi: &mut [f64]) {
    for phi in phi {
        *phi = timing.fraction(*phi);
    }
}

/// From u to φ by the integral of the speed curve.
#[inline(always)]
#[allow(clippy::cast_precision_loss)]
fn paced_shares<V: Vector>(speed: &SpeedCurve, count: usize, phi: &mut Row) {
    let u = *phi;
    let mut from = 0;
    for (i, coefficients) in speed.fraction_coefficients().iter().enumerate() {
        let mut to = count;
        if i + 1 < INTERVALS {
            let end = (i + 1) as f64 / INTERVALS as f64;
            to = from + u[from..count].partition_point(|&u| u < end);
        }
        for k in (from..to).step_by(V::LANES) {
            let x = V::load(&u[k..]).mul_add(V::splat(INTERVALS as f64), V::splat(-(i as f64)));
            let share = horner::<V, 5>(coefficients, x);
            share
                .max(V::splat(0.0))
                .min(V::splat(1.0))
                .store(&mut phi[k..]);
        }
        from = to;
    }
}

/// The end of the run of frames that begins at `from` and lies on one piece.
#[inline(always)]
pub(super) fn run<const C: usize>(
    fits: &[Fit<C>],
    piece: usize,
    phi: &Row,
    from: usize,
    count: usize,
) -> usize {
    if piece + 1 >= fits.len() {
        return count;
    }
    let end = fits[piece].end;
    if phi[count - 1] < end {
        return count;
    }
    from + phi[from..count].partition_point(|&phi| phi < end)
}

#[inline(always)]
fn arguments<V: Vector, const C: usize>(fit: &Fit<C>, phi: &[f64]) -> [V; AT_ONCE] {
    each!(u in [0, 1, 2, 3] => fit.x(V::load(&phi[u * V::LANES..])))
}

#[inline(always)]
fn store_each<V: Vector>(values: [V; AT_ONCE], to: &mut [f64]) {
    for u in 0..AT_ONCE {
        values[u].store(&mut to[u * V::LANES..]);
    }
}

#[inline(always)]
pub(super) fn parameters<V: Vector>(
    way: &ArcLengthCurve,
    tables: &Tables,
    count: usize,
    block: &mut Block,
) {
    let Block { phi, s, t, .. } = block;
    let mut from = 0;
    let mut piece = tables.place.partition_point(|fit| fit.end <= phi[0]);
    while from < count {
        piece = piece.min(tables.place.len() - 1);
        let fit = &tables.place[piece];
        let to = run(&tables.place, piece, phi, from, count);
        if let Some([powers]) = &fit.powers {
            for k in (from..to).step_by(AT_ONCE * V::LANES) {
                let x = arguments::<V, 1>(fit, &phi[k..]);
                let mut found = fit.at(powers, &x);
                if let Some(piece) = fit.polish {
                    let mut lengths = x;
                    for u in 0..AT_ONCE {
                        let phi = V::load(&phi[k + u * V::LANES..]);
                        lengths[u] = phi.mul(V::splat(way.length));
                    }
                    arc_length::polish(&tables.arc[piece], &lengths, &mut found);
                }
                store_each(found, &mut t[k..]);
            }
        } else {
            for k in (from..to).step_by(V::LANES) {
                V::load(&phi[k..])
                    .mul(V::splat(way.length))
                    .store(&mut s[k..]);
            }
            arc_length::invert::<V>(&tables.arc, &s[from..to], &mut t[from..to]);
        }
        from = to;
        piece += 1;
    }
}

/// The quaternion of each frame.
#[inline(always)]
fn turned<V: Vector>(turning: &Turning, tables: &Tables, count: usize, block: &mut Block) {
    let Block { phi, q, .. } = block;
    let mut from = 0;
    let mut piece = tables.turn.partition_point(|fit| fit.end <= phi[0]);
    while from < count {
        piece = piece.min(tables.turn.len() - 1);
        let fit = &tables.turn[piece];
        let to = run(&tables.turn, piece, phi, from, count);
        if let Some(powers) = &fit.powers {
            for k in (from..to).step_by(AT_ONCE * V::LANES) {
                let x = arguments::<V, 4>(fit, &phi[k..]);
                for component in 0..4 {
                    store_each(fit.at(&powers[component], &x), &mut q[component][k..]);
                }
            }
        } else {
            for k in (from..to).step_by(STRIDE) {
                let mut some = [0.0; STRIDE];
                some.copy_from_slice(&phi[k..k + STRIDE]);
                let mut values = [[0.0; STRIDE]; 4];
                quaternions::<V, STRIDE>(turning, tables.bezier.as_ref(), &some, &mut values);
                for component in 0..4 {
                    q[component][k..k + STRIDE].copy_from_slice(&values[component]);
                }
            }
        }
        from = to;
        piece += 1;
    }
}

/// View direction and up: third and second column of the rotation of a quaternion of any length.
#[inline(always)]
fn view_from_quaternion<V: Vector>(q: [V; 4]) -> [V; 6] {
    let [x, y, z, w] = q;
    let (xx, yy, zz, ww) = (x.mul(x), y.mul(y), z.mul(z), w.mul(w));
    let scale = V::splat(1.0).div(xx.add(yy).add(zz.add(ww)));
    let twice = scale.add(scale);
    let (wx, wy, wz, yz) = (w.mul(x), w.mul(y), w.mul(z), y.mul(z));
    [
        twice.mul(x.mul_add(z, wy)),
        twice.mul(yz.sub(wx)),
        scale.mul(ww.sub(xx).add(zz.sub(yy))),
        twice.mul(x.mul(y).sub(wz)),
        scale.mul(ww.sub(xx).add(yy.sub(zz))),
        twice.mul(yz.add(wx)),
    ]
}

/// View direction and up of a camera that looks at a target at `offset`. Where there is no
/// direction or no yaw, [`resolve_singularities`] replaces the result.
#[inline(always)]
fn view_at_target<V: Vector>(offset: [V; 3], sin: V, cos: V) -> [V; 6] {
    let [x, y, z] = offset;
    let scale = V::splat(1.0).div(x.mul_add(x, y.mul_add(y, z.mul(z))).sqrt());
    let (x, y, z) = (x.mul(scale), y.mul(scale), z.mul(scale));
    let h = x.mul_add(x, z.mul(z)).sqrt();
    let (sin_yaw, cos_yaw) = (x.div(h), z.div(h));
    let tilted = V::splat(0.0).sub(y).mul(cos);
    [
        x,
        y,
        z,
        tilted.mul(sin_yaw).sub(cos_yaw.mul(sin)),
        h.mul(cos),
        tilted.mul_add(cos_yaw, sin_yaw.mul(sin)),
    ]
}

/// Turns a block into poses.
#[inline(always)]
fn write<V: Vector>(
    section: &SectionSampler,
    block: &Block,
    records: &mut Records,
    poses: &mut [Pose],
) {
    let count = poses.len();
    let numbers = Pose::as_numbers(poses);
    for k in (0..count).step_by(V::LANES) {
        let row = write_vector::<V>(section, block, k);
        if k + V::LANES > count {
            V::store_records(row, &mut records.0);
            let left = &mut numbers[10 * k..];
            left.copy_from_slice(&records.0[..left.len()]);
        } else {
            V::store_records(row, &mut numbers[10 * k..]);
        }
    }
}

/// [`Up::upright`] of several vectors.
#[inline(always)]
fn upright<V: Vector>(up: Up, [x, y, z]: [V; 3]) -> [V; 3] {
    match up {
        Up::Y => [x, y, z],
        Up::Z => [y, z, x],
    }
}

/// One vector of poses, number by number.
#[inline(always)]
fn write_vector<V: Vector>(section: &SectionSampler, block: &Block, k: usize) -> [V; 10] {
    let place = if let Some(ArcLengthCurve { curve, .. }) = &section.way {
        let t = V::load(&block.t[k..]);
        let (a, b, c, d) = (curve.a, curve.b, curve.c, curve.d);
        each!(i in [0, 1, 2] => horner(&[d[i], c[i], b[i], a[i]], t))
    } else {
        each!(i in [0, 1, 2] => V::splat(section.position[i]))
    };
    let view = match &section.turning {
        Turning::Kept(view, up) => {
            each!(v in [view.x, view.y, view.z, up.x, up.y, up.z] => V::splat(v))
        }
        Turning::Tracked(target, _) => view_at_target(
            upright(
                section.space.up,
                each!(i in [0, 1, 2] => V::splat(target[i]).sub(place[i])),
            ),
            V::load(&block.q[0][k..]),
            V::load(&block.q[1][k..]),
        ),
        _ => view_from_quaternion(each!(i in [0, 1, 2, 3] => V::load(&block.q[i][k..]))),
    };
    let zoom = horner(&section.zoom, V::load(&block.phi[k..]));
    let [x, y, z] = place;
    let [a, b, c, d, e, f] = match section.space.up {
        Up::Y => view,
        Up::Z => each!(i in [2, 0, 1, 5, 3, 4] => view[i]),
    };
    [x, y, z, a, b, c, d, e, f, zoom]
}

/// Computes tracked frames at the target, or straight above or below it, the plain way.
fn resolve_singularities(
    section: &SectionSampler,
    tables: &Tables,
    target: DVec3,
    phi: &Row,
    poses: &mut [Pose],
) {
    let near = 2.0 * AT_TARGET * section.space.half_size;
    for (pose, &phi) in poses.iter_mut().zip(phi) {
        let offset = (target - DVec3::from(pose.vrp)).abs().max_element();
        // Twice the bounds, since the plain way measures with other rounding.
        let far = offset > near;
        let view = section.space.up.upright(DVec3::from(pose.vpn));
        let level = view.x.abs().max(view.z.abs()) > 2.0 * POLE;
        if far && level {
            continue;
        }
        let plain = section.pose(tables, phi);
        (pose.vpn, pose.vup) = (plain.vpn, plain.vup);
    }
}
