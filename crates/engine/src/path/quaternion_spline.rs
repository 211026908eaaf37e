//! Smooth curves through unit quaternions at given times: Barry and Goldman's (*A Recursive
//! Evaluation Algorithm for a Class of Catmull–Rom Splines*, 1988; with unit knots it is Schlag's
//! form, thesis 4.4.4), and cubic spherical Bézier curves whose angular velocities at the keys
//! follow Kochanek and Bartels, weighted for unequal times. The signs of the keys are fixed once,
//! so that neighbours are less than half a turn apart; the arcs inside are taken as they come,
//! which keeps the curve smooth.

use glam::{DQuat, DVec3};

use super::camera_path::Tcb;
use crate::error::{Error, Invalid, OutOfRange, Result, TooMany, vec_with_room};
use crate::limits::MAX_KEYS;
use crate::math::quaternion::{continue_signs, exp, log, slerp};

/// The point at `x` in [0, 1] of a cubic spherical Bézier curve: de Casteljau with great arcs.
#[must_use]
pub fn bezier(control: &[DQuat; 4], x: f64) -> DQuat {
    let [a, b, c, d] = *control;
    let (ab, bc, cd) = (slerp(a, b, x), slerp(b, c, x), slerp(c, d, x));
    slerp(slerp(ab, bc, x), slerp(bc, cd, x), x)
}

/// Control quaternions between two keys `step` apart in time, from the angular velocities with
/// which the first is left and the second is reached.
#[must_use]
pub fn bezier_control(from: DQuat, to: DQuat, leave: DVec3, reach: DVec3, step: f64) -> [DQuat; 4] {
    let third = step / 3.0;
    [
        from,
        exp(leave * third) * from,
        exp(reach * -third) * to,
        to,
    ]
}

/// The point at time `t` of Barry and Goldman's curve between the inner two of four keys.
#[must_use]
pub fn barry_goldman_between(keys: &[DQuat; 4], knots: &[f64; 4], t: f64) -> DQuat {
    let [q0, q1, q2, q3] = *keys;
    let [t0, t1, t2, t3] = *knots;
    let part = |from: f64, to: f64| (t - from) / (to - from);
    let a = slerp(q0, q1, part(t0, t1));
    let b = slerp(q1, q2, part(t1, t2));
    let c = slerp(q2, q3, part(t2, t3));
    slerp(
        slerp(a, b, part(t0, t2)),
        slerp(b, c, part(t1, t3)),
        part(t1, t2),
    )
}

/// Mean angular velocity on S³ from one key to the next, in the world.
#[must_use]
pub fn mean_velocity(from: DQuat, to: DQuat, step: f64) -> DVec3 {
    log(to * from.conjugate()) / step
}

/// Angular velocities with which the curve reaches and leaves a key, from the mean velocities and
/// the durations of the sections before and after.
#[must_use]
pub fn key_velocities(
    tcb: Tcb,
    before: DVec3,
    after: DVec3,
    step_before: f64,
    step_after: f64,
) -> (DVec3, DVec3) {
    let Tcb {
        tension,
        continuity: c,
        bias: b,
    } = tcb;
    let scale = (1.0 - tension) / (step_before + step_after);
    let (before, after) = (before * (scale * step_after), after * (scale * step_before));
    (
        before * ((1.0 - c) * (1.0 + b)) + after * ((1.0 + c) * (1.0 - b)),
        before * ((1.0 + c) * (1.0 + b)) + after * ((1.0 - c) * (1.0 - b)),
    )
}

/// Angular velocity at an end of the curve: that of a parabola, loosened by the tension. `mean` is
/// that of the end section, `inner` that at its other key without tension, continuity and bias.
#[must_use]
pub fn end_velocity(tension: f64, mean: DVec3, inner: DVec3) -> DVec3 {
    (1.0 - tension) * (2.0 * mean - inner)
}

/// Checks what a caller handed over: the keys, normalised and continuing each other's signs, and the
/// section that holds `when`.
fn prepare(keys: &[DQuat], times: &[f64], when: f64) -> Result<(Vec<DQuat>, usize)> {
    if keys.len() < 2 || times.len() != keys.len() {
        return Err(OutOfRange::QuaternionKeys.into());
    }
    if keys.len() > MAX_KEYS {
        return Err(TooMany::QuaternionKeys.into());
    }
    if !times.iter().all(|time| time.is_finite()) || times.windows(2).any(|pair| pair[0] >= pair[1])
    {
        return Err(Invalid::TimeOrder.into());
    }
    if !(times[0]..=times[times.len() - 1]).contains(&when) {
        return Err(OutOfRange::Time.into());
    }
    let mut fixed = vec_with_room(keys.len())?;
    for &key in keys {
        fixed.push(normalized(key)?);
    }
    continue_signs(&mut fixed);
    let after = times.partition_point(|&time| time <= when);
    Ok((fixed, after.clamp(1, times.len() - 1) - 1))
}

/// `q` with length 1, even where its square would over- or underflow.
///
/// # Errors
/// [`Error::Argument`] if it is not finite or zero.
pub fn normalized(q: DQuat) -> Result<DQuat> {
    let largest = q.x.abs().max(q.y.abs()).max(q.z.abs()).max(q.w.abs());
    if !q.is_finite() || largest == 0.0 {
        return Err(Invalid::QuaternionZero.into());
    }
    Ok((q / largest).normalize())
}

/// A point of a curve, of length 1; an error where the times are too unequal (1e-300 beside 1e300).
fn finished(q: DQuat) -> Result<DQuat> {
    normalized(q).map_err(|_| Error::Argument(Invalid::TimesUnequal))
}

/// Barry and Goldman's curve through `keys` (none zero) with knots at `times` (strictly
/// increasing), at the time `when`. Beyond either end stands the neighbouring key, reflected.
///
/// # Errors
/// [`Error::Range`], [`Error::Argument`] or [`Error::Limit`] with the reason.
pub fn barry_goldman(keys: &[DQuat], times: &[f64], when: f64) -> Result<DQuat> {
    let (keys, i) = prepare(keys, times, when)?;
    let last = keys.len() - 1;
    let (before, time_before) = if i > 0 {
        (keys[i - 1], times[i - 1])
    } else {
        (reflect(keys[1], keys[0]), 2.0 * times[0] - times[1])
    };
    let (after, time_after) = if i + 2 <= last {
        (keys[i + 2], times[i + 2])
    } else {
        (
            reflect(keys[last - 1], keys[last]),
            2.0 * times[last] - times[last - 1],
        )
    };
    finished(barry_goldman_between(
        &[before, keys[i], keys[i + 1], after],
        &[time_before, times[i], times[i + 1], time_after],
        when,
    ))
}

/// The quaternion as far beyond `about` as `q` is before it.
#[must_use]
pub fn reflect(q: DQuat, about: DQuat) -> DQuat {
    about * q.conjugate() * about
}

/// Control quaternions of a section of the tcb curve through at least two unit keys, each of the
/// sign that continues the one before; where there are but two it is the great arc.
#[must_use]
pub fn tcb_section(
    keys: &[DQuat],
    times: &[f64],
    tcb: impl Fn(usize) -> Tcb,
    section: usize,
) -> [DQuat; 4] {
    let (i, last) = (section, keys.len() - 1);
    let step = |i: usize| times[i + 1] - times[i];
    let mean = |i: usize| mean_velocity(keys[i], keys[i + 1], step(i));
    let at = |k: usize, tcb| key_velocities(tcb, mean(k - 1), mean(k), step(k - 1), step(k));
    let end = |k: usize, inner: usize| {
        if last == 1 {
            mean(0)
        } else {
            end_velocity(tcb(k).tension, mean(i), at(inner, Tcb::default()).0)
        }
    };
    let leave = if i == 0 { end(0, 1) } else { at(i, tcb(i)).1 };
    let reach = if i + 1 == last {
        end(last, i)
    } else {
        at(i + 1, tcb(i + 1)).0
    };
    bezier_control(keys[i], keys[i + 1], leave, reach, step(i))
}

/// The tcb curve through `keys` at the time `when`, as a camera path turns by default but without
/// the limit on the velocities. `tcb` has one set for each key; without it all are zero.
///
/// # Errors
/// [`Error::Range`], [`Error::Argument`] or [`Error::Limit`] with the reason.
pub fn tcb(keys: &[DQuat], times: &[f64], tcb: Option<&[Tcb]>, when: f64) -> Result<DQuat> {
    if let Some(tcb) = tcb {
        if tcb.len() != keys.len() {
            return Err(OutOfRange::KeyShapes.into());
        }
        tcb.iter().try_for_each(|tcb| tcb.check())?;
    }
    let (keys, i) = prepare(keys, times, when)?;
    let own = |k: usize| tcb.map_or(Tcb::default(), |tcb| tcb[k]);
    let control = tcb_section(&keys, times, own, i);
    let step = times[i + 1] - times[i];
    finished(bezier(&control, (when - times[i]) / step))
}
