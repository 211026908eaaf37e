//! Cures that the planner makes: another pace, a way round, other views.

use vides_engine::planner::{self, AvoidRequest, Request, What, avoid_object, retime};
use vides_engine::tools::check::{Finding, FindingKind};
use vides_engine::tools::clearance::Clearance;
use vides_engine::tools::fit::Progress;

use crate::edit::Edit;
use crate::editing::Document;
use crate::error::{EngineError, Error, Result};
use crate::tool::least_clearance;
use vides_engine::path::{Orientation, Target};

impl Document {
    /// The edits that cure what [`is_planned`]; none if an object is needed and missing.
    pub(super) fn planned(
        &self,
        finding: &Finding,
        object: Option<&Clearance>,
        progress: Progress<'_>,
    ) -> Result<Vec<Edit>> {
        match (finding.kind, object) {
            (FindingKind::NothingToSee, Some(object)) => self.seen(finding, object, progress),
            (FindingKind::Clearance | FindingKind::Through, Some(object)) => {
                self.led_clear(object, progress)
            }
            // Of sections with a pace of their own the ten speeds cannot be joined.
            (FindingKind::SpeedJump, _) => self.paced(finding, progress),
            (kind, _) if is_of_pace(kind) => self.paced(finding, progress),
            _ => Ok(Vec::new()),
        }
    }

    /// A pace within the limits between the points around a finding, or if it is still found then,
    /// on the whole way: in the same time with the lowest peaks, or in the shortest where that is
    /// not enough.
    fn paced(&self, finding: &Finding, progress: Progress<'_>) -> Result<Vec<Edit>> {
        let (path, info) = (self.path(), self.info());
        let last = path.points.len() - 1;
        let sampler = self.sampler()?;
        let found = self.sections_of(finding)?;
        let behind = found.iter().map(|section| section.point + 1).max();
        let to = behind.unwrap_or(finding.point).min(last);
        let frames = self.timeline(|timeline| {
            let first = |point: usize, at: usize| match timeline.section_from(point, at) {
                Some(section) => sampler.first_frame(section),
                None => sampler.frame_count(),
            };
            let end = first(to, path.points[to].orientations.len() - 1);
            // Where the path ends the last pose counts, too.
            let ends = usize::from(to == last && !path.closed);
            end.saturating_sub(first(finding.point, 0)) + ends
        })?;
        let (mut made, mut refused) = (None, None);
        for (points, frames) in [
            ([finding.point, to], frames),
            ([0, last], sampler.frame_count()),
        ] {
            if points[0] >= points[1] {
                continue;
            }
            let mut request = Request {
                limits: info.limits,
                fps: info.fps,
                points: Some(points),
                seconds: frames as f64 / info.fps,
            };
            let same = retime(path, &request, progress);
            request.seconds = 0.0;
            let found = match same.or_else(|_| retime(path, &request, progress)) {
                Ok(found) => found.path,
                Err(error) => {
                    refused = Some(error);
                    continue;
                }
            };
            let mut other = self.try_clone()?.without_history();
            other.apply(Edit::ReplacePath(Box::new(found.try_clone()?)))?;
            let left = other.check_against(None, progress)?;
            made = Some(found);
            if !left.iter().any(|left| left.kind == finding.kind) {
                break;
            }
        }
        match (made, refused) {
            (Some(path), _) => Ok(vec![Edit::ReplacePath(Box::new(path))]),
            (None, Some(error)) => Err(error.into()),
            (None, None) => Ok(Vec::new()),
        }
    }

    /// The way led clear of an object.
    fn led_clear(&self, object: &Clearance, progress: Progress<'_>) -> Result<Vec<Edit>> {
        let request = AvoidRequest {
            clearance: least_clearance(self),
            radius: 0.0,
        };
        let made = avoid_object(self.path(), object, &request, progress)?;
        let edit = Edit::ReplacePath(Box::new(made.path));
        Ok((!made.parts.is_empty())
            .then_some(edit)
            .into_iter()
            .collect())
    }

    /// Views turned so that all of an object, of which nothing is in the picture, is; towards its
    /// middle where it is too large for that.
    fn seen(
        &self,
        finding: &Finding,
        object: &Clearance,
        progress: Progress<'_>,
    ) -> Result<Vec<Edit>> {
        let how = (planner::DEFAULT_MARGIN, What::View);
        match self.framed(object, how, self.info().limits, progress) {
            Ok(made) => return Ok(vec![Edit::ReplacePath(Box::new(made.path))]),
            Err(Error::Engine(EngineError::Argument(_))) => {}
            Err(error) => return Err(error),
        }
        let [min, max] = object.bounds();
        let target = Target::Absolute(min.midpoint(max));
        let points = &self.path().points;
        // All views between which it is, and the one behind.
        let mut keys = vec![(finding.point, finding.orientation)];
        for section in self.sections_of(finding)? {
            let (point, at) = (section.point, section.orientation);
            let next = if at + 1 < points[point].orientations.len() {
                (point, at + 1)
            } else {
                ((point + 1) % points.len(), 0)
            };
            keys.extend([(point, at), next]);
        }
        keys.sort_unstable();
        keys.dedup();
        let turned = keys.into_iter().map(|(point, at)| {
            let one = &points[point].orientations[at];
            let own = one.own.with(|own| {
                own.ahead = None;
                own.velocities = None;
                own.turning = None;
            })?;
            let orientation = Orientation {
                target,
                own,
                ..one.clone()
            };
            Ok(Edit::SetOrientation {
                point,
                at,
                orientation,
            })
        });
        turned.collect()
    }
}

/// Whether a finding is cured by the planner, which may take long.
#[must_use]
pub const fn is_planned(kind: FindingKind) -> bool {
    matches!(
        kind,
        FindingKind::Clearance | FindingKind::Through | FindingKind::NothingToSee
    ) || is_of_pace(kind)
}

/// Whether a finding is cured by another pace. A turn or a zoom that is too fast is not: more
/// frames for its section do.
const fn is_of_pace(kind: FindingKind) -> bool {
    matches!(
        kind,
        FindingKind::Speed
            | FindingKind::Acceleration
            | FindingKind::Jerk
            | FindingKind::TurningAcceleration
            | FindingKind::Crossing
    )
}
