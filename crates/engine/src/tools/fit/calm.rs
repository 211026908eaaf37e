//! What the splines take for the poses: those that between two cuts are one within the tolerance are
//! their mean, since what is left of them is noise, in which no piece could be long.

use glam::{DQuat, DVec3};

use super::{Data, Sample, view_angle};
use crate::error::Result;

/// How far from the mean they may be, in tolerances.
const WITHIN: f64 = 0.95;

impl Data {
    /// Sets `calm`; `exact`: to the poses themselves.
    pub(super) fn calm_down(&mut self, exact: bool) -> Result<()> {
        self.calm.clear();
        self.calm.try_reserve_exact(self.raw.len())?;
        self.calm.extend_from_slice(&self.raw);
        if exact {
            return Ok(());
        }
        let mut begin = 0;
        for cut in 0..=self.cuts.len() {
            let end = self.cuts.get(cut).map_or(self.raw.len(), |cut| cut + 1);
            self.calm_side(begin, end);
            begin = end;
        }
        Ok(())
    }

    /// The poses between two cuts.
    fn calm_side(&mut self, begin: usize, end: usize) {
        let raw = &self.raw[begin..end];
        let counts = |k: &usize| !self.left_out[begin + k];
        let all = || (0..raw.len()).filter(counts).map(|k| &raw[k]);
        let count = all().count() as f64;
        if count == 0.0 {
            return;
        }
        let position = all().map(|sample| sample.position).sum::<DVec3>() / count;
        let sum = all().fold(DQuat::from_array([0.0; 4]), |sum, sample| sum + sample.turn);
        let (turn, zoom) = (
            sum.normalize(),
            all().map(|sample| sample.zoom).sum::<f64>() / count,
        );
        let calm = &mut self.calm[begin..end];
        let most = WITHIN * self.tolerance;
        if all().all(|sample| sample.position.distance(position) <= most) {
            calm.iter_mut()
                .for_each(|sample| sample.position = position);
        }
        let most = WITHIN * self.angle;
        if turn.is_finite() && all().all(|sample| sample.off(turn, sample.zoom) <= most) {
            calm.iter_mut().for_each(|sample| sample.turn = turn);
        }
        let off = |sample: &Sample| (view_angle(sample.zoom) - view_angle(zoom)).abs();
        if all().all(|sample| off(sample) <= most) {
            calm.iter_mut().for_each(|sample| sample.zoom = zoom);
        }
    }
}
