//! The report of a fit: the path held against the poses at their own times.

use glam::DVec3;

use super::report::{Deviation, Measured, PoseDeviation, Report};
use super::{Data, view_angle};
use crate::error::{Result, vec_with_room};
use crate::math::quaternion::{angle, continue_sign};
use crate::path::{CameraPath, Sampler, Timeline};
use crate::tools::smooth::noise;

impl Data {
    /// At the poses' own times.
    pub(super) fn measured(&self, path: &CameraPath) -> Result<Measured> {
        let sampler = Sampler::new(path, &Timeline::new(path)?)?;
        let last = sampler.frame_count() as f64;
        let mut sums = [Deviation::default(); 3];
        let mut each = vec_with_room(self.poses())?;
        let all = self.raw.iter().zip(&self.times).take(self.poses());
        for (k, (sample, time)) in all.enumerate() {
            if self.left_out[k] || self.in_a_cut(k) {
                continue;
            }
            let frame = (1.0 + time).clamp(1.0, last);
            let pose = sampler.pose(frame)?;
            let turn = self.turn(pose.vpn.into(), pose.vup.into());
            let turned = 2.0 * angle(sample.turn, continue_sign(sample.turn, turn).0);
            let position = DVec3::from_array(pose.vrp).distance(sample.position);
            let lens = (view_angle(sample.zoom) - view_angle(pose.zoom)).abs();
            let [turned, lens] = [turned, lens].map(f64::to_degrees);
            for (sum, off) in sums.iter_mut().zip([position, turned, lens]) {
                sum.add(off);
            }
            each.push(PoseDeviation {
                frame,
                position,
                angle: turned.max(lens),
            });
        }
        let [position, view, lens] = sums.map(|sum| sum.mean(each.len()));
        let turned = view.greatest.max(lens.greatest).to_radians();
        Ok(Measured {
            worst: (position.greatest / self.tolerance).max(turned / self.angle),
            position,
            view,
            lens,
            each,
        })
    }

    /// Of the positions, and of the views in radians.
    pub(super) fn noises(&self) -> Result<[f64; 2]> {
        let count = self.poses();
        let (mut places, mut turns) = (vec_with_room(count)?, vec_with_room(count)?);
        let all = || self.raw.iter().take(count);
        places.extend(all().map(|sample| sample.position.to_array()));
        turns.extend(all().map(|sample| sample.turn.to_array()));
        let times = &self.times[..count];
        // On S³ an angle counts half.
        Ok([noise(times, &places)?, 2.0 * noise(times, &turns)?])
    }

    pub(super) fn report(
        &self,
        path: &CameraPath,
        measured: &Measured,
        poses: usize,
    ) -> Result<Report> {
        let holds = path
            .points
            .iter()
            .filter(|point| point.orientations[0].hold > 0);
        let [noise, turning] = self.noises()?;
        Ok(Report {
            points: path.points.len(),
            poses,
            position: measured.position,
            view: measured.view,
            lens: measured.lens,
            fps: self.fps,
            holds: holds.count(),
            gaps: self.gaps,
            cuts: self.cuts.len(),
            outliers: self.outliers().count(),
            dropped: poses - self.poses(),
            unit: self.unit,
            noise,
            turning_noise: turning.to_degrees(),
            better: None,
            robust: None,
        })
    }
}
