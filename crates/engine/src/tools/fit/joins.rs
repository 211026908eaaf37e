//! Turning that goes on from piece to piece with its acceleration: as in a cubic spline the spins at
//! the joins are those with which it does.

use std::f64::consts::PI;

use glam::{DQuat, DVec3};

use super::pace::timing;
use super::piece::hermite;
use super::{Data, Piece};
use crate::error::{Result, vec_with_room};
use crate::math::quaternion::{angle, exp, log};
use crate::path::quaternion_spline::bezier;

/// Step of the differences that give the change of the turning along the curve: long enough that rounding
/// is nothing beside what a few frames turn, and exact where the spin is a parabola of the way.
const STEP: f64 = 1e-2;

/// Sweeps over all joins, there and back; each leaves a quarter of what is to do.
const SWEEPS: usize = 12;

/// Where the pace changes by more than this share in a frame, a cubic of the way cannot turn evenly:
/// such joins are skipped, so that their neighbours do not follow them.
const STEEP: f64 = 0.5;

/// Ways at which a piece that turns otherwise is held against what it was.
const NEAR_AT: [f64; 3] = [0.25, 0.5, 0.75];

/// Rounds in which joins are left as they were, since poses were missed.
const ROUNDS: usize = 6;

impl Piece {
    /// The acceleration of the position at an end.
    pub(super) fn bend(&self, side: usize) -> DVec3 {
        let Some(curve) = self.curve else {
            return DVec3::ZERO;
        };
        let end = [0.0, 1.0][side];
        let [speed, faster] = self.speeds[side].map(|part| part * self.length);
        let (d, dd) = (curve.derivative(end), curve.second_derivative(end));
        let along = d.normalize_or_zero();
        let bend = (dd - along * along.dot(dd)) / d.length_squared();
        along * faster + bend * (speed * speed)
    }

    /// Its control quaternions.
    pub(super) fn control(&self) -> [DQuat; 4] {
        Self::between([self.start.turn, self.end.turn], self.velocities)
    }

    fn between([a, b]: [DQuat; 2], velocities: [DVec3; 2]) -> [DQuat; 4] {
        let [leave, reach] = velocities.map(|velocity| velocity / 3.0);
        [a, exp(leave) * a, exp(-reach) * b, b]
    }

    /// The acceleration of the turning at an end, on S³.
    pub(super) fn twist(&self, side: usize) -> DVec3 {
        let control = self.control();
        let [speed, faster] = self.speeds[side];
        let end = [0.0, 1.0][side];
        let q = [0.0, 1.0, 2.0, 3.0].map(|k| bezier(&control, (end - k * STEP).abs()));
        let turned = |k: usize| log(q[k + 1] * q[k].conjugate());
        let bend = (3.0 * turned(1) - 2.0 * turned(0) - turned(2)) / (STEP * STEP);
        self.velocities[side] * faster + bend * (speed * speed)
    }

    /// Turns with another spin at an end; false if a key may not own such a one.
    fn spin(&mut self, side: usize, spin: DVec3) -> bool {
        let velocity = spin / self.speeds[side][0];
        let most = 3.0 * 0.45 * (PI - angle(self.start.turn, self.end.turn));
        let may = velocity.length() <= most;
        if may {
            self.velocities[side] = velocity;
        }
        may
    }
}

/// Evens out the jump of the turning's acceleration between two pieces, by a step of Newton.
fn even(before: &mut Piece, after: &mut Piece) {
    let ([reach, gains], [leave, grows]) = (before.speeds[1], after.speeds[0]);
    if !(reach > 0.0 && leave > 0.0) {
        return;
    }
    let jump = after.twist(0) - before.twist(1);
    let slope = 4.0 * (reach + leave) + gains / reach - grows / leave;
    let spin = before.velocities[1] * reach;
    let steep = (gains / reach).abs().max((grows / leave).abs()) > STEEP;
    if steep || !(slope > reach + leave) {
        return;
    }
    let better = spin + jump / slope;
    let was = before.velocities[1];
    if !(before.spin(1, better) && after.spin(0, better)) {
        before.velocities[1] = was;
    }
}

impl Data {
    /// Evens out the jumps of the turning's acceleration at the joins of pieces, but where a pose
    /// would be missed by it.
    pub(super) fn even_out(&self, pieces: &mut [Piece]) -> Result<()> {
        let mut before: Vec<[DVec3; 2]> = vec_with_room(pieces.len())?;
        before.extend(pieces.iter().map(|piece| piece.velocities));
        let mut stays = vec_with_room(pieces.len())?;
        stays.resize(pieces.len() + 1, false);
        for round in 0..=ROUNDS {
            if round == ROUNDS {
                stays.fill(true);
            }
            for (k, piece) in pieces.iter_mut().enumerate() {
                for side in 0..2 {
                    if stays[k + side] {
                        piece.velocities[side] = before[k][side];
                    }
                }
            }
            for sweep in 0..SWEEPS {
                for k in 1..pieces.len() {
                    let k = if sweep % 2 == 0 { k } else { pieces.len() - k };
                    let (before, after) = pieces.split_at_mut(k);
                    let (before, after) = (&mut before[k - 1], &mut after[0]);
                    if !(stays[k] || before.holds || after.holds || after.corner) {
                        even(before, after);
                    }
                }
            }
            let (mut from, mut met) = (0.0, true);
            for (k, piece) in pieces.iter().enumerate() {
                if !piece.holds && !self.meets(piece, before[k], from)? {
                    (stays[k], stays[k + 1]) = (true, true);
                    met = false;
                }
                from += f64::from(piece.frames);
            }
            if met {
                break;
            }
        }
        Ok(())
    }

    /// Whether the views of a piece that begins at a time are those of the poses, and as near as they
    /// must be to those with the velocities that it had.
    fn meets(&self, piece: &Piece, had: [DVec3; 2], from: f64) -> Result<bool> {
        let (timing, control) = (timing(&piece.pace)?, piece.control());
        let was = Piece::between([piece.start.turn, piece.end.turn], had);
        let far =
            |way: f64| 2.0 * log(bezier(&control, way) * bezier(&was, way).conjugate()).length();
        if NEAR_AT.iter().any(|way| far(*way) > self.near[1]) {
            return Ok(false);
        }
        let to = from + f64::from(piece.frames);
        let range = [from, to].map(|end| self.times.partition_point(|time| *time < end));
        Ok((range[0]..range[1])
            .filter(|k| !self.left_out[*k])
            .all(|k| {
                let way = timing.fraction((self.times[k] - from) / (to - from));
                let zoom = hermite(way, [piece.start.zoom, piece.end.zoom], piece.zoom_slopes);
                self.raw[k].off(bezier(&control, way), zoom) <= self.angle
            }))
    }
}
