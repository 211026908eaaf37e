//! Whether a path with a new pace holds the limits, frame by frame and where sections meet.

use super::super::course::{Course, turned};
use super::super::track::Miss;
use super::Work;
use crate::error::Result;
use crate::path::{CameraPath, Pose, Sampler, Timeline};
use crate::tools::check::{CheckContext, FindingKind, OFF, check};

/// Frames beside a joint that give way.
const BESIDE: f64 = 2.0;

/// Places in each of the two frames around a joint at which it is looked at.
const PHASES: i32 = 10;

impl Work<'_> {
    /// Whether the frames themselves hold the limits; where not, margins grow.
    pub(super) fn holds_in(&mut self, made: &CameraPath) -> Result<bool> {
        let mut limits = self.request.limits;
        for kind in FindingKind::all() {
            let planned = matches!(
                kind,
                FindingKind::Speed
                    | FindingKind::Acceleration
                    | FindingKind::Jerk
                    | FindingKind::Turning
                    | FindingKind::TurningAcceleration
                    | FindingKind::Zoom
                    | FindingKind::Crossing
            );
            if !planned {
                limits.set(kind, OFF)?;
            }
        }
        let against = CheckContext {
            fps: self.request.fps,
            space: None,
            object: None,
            limits,
        };
        let found = check(made, &against)?;
        let mut hold = self.joints_hold(made)?;
        for finding in found {
            let at = (finding.point, finding.orientation);
            let same = |course: &Course| (course.point, course.orientation) == at;
            let Some(k) = self.courses.iter().position(same) else {
                continue;
            };
            let worst = if finding.kind == FindingKind::Crossing {
                finding.limit / finding.value
            } else {
                finding.value / finding.limit
            };
            hold = false;
            self.both_give_way(k, worst, finding.kind, None);
        }
        Ok(hold)
    }

    /// What is missed near the beginning of a section is the one's before, too; there in so many
    /// seconds, else everywhere.
    fn both_give_way(
        &mut self,
        section: usize,
        worst: f64,
        kind: FindingKind,
        beside: Option<f64>,
    ) {
        let count = self.courses.len();
        self.missed = (section, kind);
        let miss = Miss {
            from: 0.0,
            to: 1.0,
            worst,
            kind,
        };
        let to = beside.map_or(1.0, |time| self.tracks[section].share(time));
        self.give_way(section, Miss { to, ..miss });
        if section > 0 || self.ring {
            let before = (section + count - 1) % count;
            let from = beside.map_or(0.0, |time| self.tracks[before].share(-time));
            self.give_way(before, Miss { from, ..miss });
        }
    }

    /// Whether the differences over a frame hold the limits where sections meet, between frames too.
    fn joints_hold(&mut self, made: &CameraPath) -> Result<bool> {
        let timeline = Timeline::new(made)?;
        let sampler = Sampler::new(made, &timeline)?;
        let last = sampler.frame_count() as f64;
        let fps = self.request.fps;
        let half = made.space.half_size;
        let mut hold = true;
        for k in 0..self.courses.len() {
            if self.joints[k].most == 0.0 {
                continue;
            }
            let at = sampler.first_frame(self.courses[k].section) as f64 - 1.0;
            let mut worst = (1.0, FindingKind::Acceleration);
            for phase in -PHASES..=PHASES {
                let middle = at + f64::from(phase) / f64::from(PHASES);
                if middle < 2.0 || middle > last - 1.0 {
                    continue;
                }
                let mut poses = [Pose::default(); 3];
                for (pose, frame) in poses.iter_mut().zip([-1.0, 0.0, 1.0]) {
                    *pose = sampler.pose(middle + frame)?;
                }
                let [a, b, c] = poses.map(|pose| pose.position());
                let bend = (c - 2.0 * b + a).length() / half * fps * fps;
                let [p, q, r] = poses.map(|pose| pose.rotation());
                let change = (turned(q, r) - turned(p, q)).length() * fps * fps;
                for (share, kind) in [
                    (bend / self.bounds.acceleration, FindingKind::Acceleration),
                    (
                        change / self.bounds.turning_acceleration,
                        FindingKind::TurningAcceleration,
                    ),
                ] {
                    if share > worst.0 {
                        worst = (share, kind);
                    }
                }
            }
            if worst.0 > 1.0 {
                hold = false;
                self.both_give_way(k, worst.0, worst.1, Some(BESIDE / fps));
            }
        }
        Ok(hold)
    }
}
