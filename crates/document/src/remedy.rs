//! Edits that cure what a check finds, where the choice is not the user's.

pub(crate) mod planned;

use glam::DVec3;
use vides_engine::error::Invalid;
use vides_engine::path::joint::Neighbour;
use vides_engine::path::{Ease, EaseKind, Section, timing};
use vides_engine::tools::check::{Finding, FindingKind};
use vides_engine::tools::clearance::Clearance;
use vides_engine::tools::fit::Progress;
use vides_engine::tools::redundant::without;

use planned::is_planned;

use super::edit::{At, Edit};
use super::editing::Document;
use crate::error::{ErrorKind, Result};
use vides_engine::limits::{MAX_SECTION_FRAMES, MAX_SPEED, MIN_POINTS, MIN_SPEED, SPEEDS};
use vides_engine::path::{
    CameraPath, Change, CurveKind, Orientation, OrientationOverrides, Pace, Tangents, curve,
};

/// A section's frames grow by at most this factor.
const MOST: f64 = 8.0;

/// Factor by which a cure goes below the limit, since whole frames and changes nearby would leave it
/// at the limit.
const MARGIN: f64 = 1.05;

/// How far ahead a view that jumped looks, in units of `half_size`.
const AHEAD: f64 = 0.1;

/// Share of a section's time in which it comes to rest.
const REST: f64 = 0.3;

/// A cure at one place is tried so often.
const TIMES: usize = 8;

impl Document {
    /// The edits, to be one step, that fix a finding; none where the choice is the user's. A turn
    /// or zoom gets more frames (not over eight times as many: then the view should change), a
    /// corner or cusp smooth tangents, a speed that jumps goes over into the next one, or to rest
    /// where the camera rests, a view that jumps gets a place ahead to look at, a way that goes back
    /// makes the curve centripetal; a redundant key is removed. Where nothing of `object` is in the picture the views are
    /// turned so that all of it is; where it is too large for that, to its middle. Where the way is
    /// too near `object` or goes through it, the whole way is led clear of it
    /// ([`vides_engine::planner::avoid()`]), with the limit of the clearance. Where the camera is too
    /// fast, accelerates or jerks too much, the pace is replanned
    /// ([`vides_engine::planner::retime()`]).
    ///
    /// # Errors
    /// [`vides_engine::Error::Argument`] where there is no way round or no such pace; [`vides_engine::Error::Limit`],
    /// [`vides_engine::Error::Memory`].
    pub fn remedy(
        &self,
        finding: &Finding,
        object: Option<&Clearance>,
        progress: Progress<'_>,
    ) -> Result<Vec<Edit>> {
        let path = self.path();
        let (point, at) = (finding.point, finding.orientation);
        let known = path.points.get(point);
        let Some(key) = known.and_then(|here| here.orientations.get(at)) else {
            return Ok(Vec::new());
        };
        match finding.kind {
            FindingKind::Turning | FindingKind::Zoom if finding.value <= MOST * finding.limit => {
                self.slower(finding)
            }
            FindingKind::ViewJump => {
                let ahead = AHEAD * path.space.half_size;
                let keys = [(point, at), ((point + 1) % path.points.len(), 0)];
                let keys = keys.into_iter().filter(|(point, at)| {
                    path.points[*point].orientations[*at].own.ahead == Some(0.0)
                });
                keys.map(|key| owned(path, key, &|own| own.ahead = Some(ahead)))
                    .collect()
            }
            FindingKind::SpeedJump => match self.joined(finding)? {
                joined if joined.is_empty() => self.planned(finding, object, progress),
                joined => Ok(joined),
            },
            kind if is_planned(kind) => self.planned(finding, object, progress),
            FindingKind::Corner => {
                let old = curve::tangents(path, point);
                let middle = 0.5 * (old.before + old.after);
                let smooth = middle.length() > 1e-6 * path.space.half_size;
                Ok(smooth
                    .then(|| set_tangent(point, middle))
                    .into_iter()
                    .collect())
            }
            FindingKind::Cusp => match key.own.pace {
                Pace::Distance(_) | Pace::Part(_) => {
                    let plain = owned(path, (point, at), &|own| own.pace = Pace::Speeds)?;
                    Ok(vec![plain])
                }
                _ => {
                    let ends = [point, (point + 1) % path.points.len()];
                    let ends = ends
                        .into_iter()
                        .filter_map(|end| Some((end, smooth(path, end)?)));
                    Ok(ends
                        .map(|(end, tangent)| set_tangent(end, tangent))
                        .collect())
                }
            },
            // What owns its tangents keeps them.
            FindingKind::Backwards if path.curve.has_shape() => {
                let kind = CurveKind::Centripetal;
                Ok(vec![Edit::set(At::Path, "curve", kind)])
            }
            FindingKind::Redundant => {
                if let Some(found) = without(path, point, finding.limit)? {
                    let last = path.points[point - 1].orientations.len() - 1;
                    let frames = |own: &mut OrientationOverrides| own.frames = found.frames;
                    let begin = owned(path, (point - 1, last), &frames)?;
                    let begin = (found.frames > 0).then_some(begin);
                    let remove = Edit::RemovePoint { at: point };
                    return Ok(begin.into_iter().chain([remove]).collect());
                }
                let edit = if path.points[point].orientations.len() > 1 {
                    Some(Edit::RemoveOrientation { point, at })
                } else {
                    let alone = path.points.len() > MIN_POINTS && key.hold == 0;
                    alone.then_some(Edit::RemovePoint { at: point })
                };
                Ok(edit.into_iter().collect())
            }
            _ => Ok(Vec::new()),
        }
    }

    /// As [`Document::remedy`] where that takes no noticeable time; none where the planner is
    /// needed. For a person, who sees what comes of it: a turn or zoom of any speed gets up to eight
    /// times as many frames.
    ///
    /// # Errors
    /// As [`Document::remedy`].
    pub fn quick_remedy(&self, finding: &Finding) -> Result<Option<Vec<Edit>>> {
        match finding.kind {
            kind if is_planned(kind) => Ok(None),
            FindingKind::SpeedJump => Ok(Some(self.joined(finding)?).filter(|all| !all.is_empty())),
            FindingKind::Turning | FindingKind::Zoom => self.slower(finding).map(Some),
            _ => self.remedy(finding, None, &mut |_, _| true).map(Some),
        }
    }

    /// The sections of a finding's frames, in which something changes.
    fn sections_of(&self, finding: &Finding) -> Result<Vec<Section>> {
        let sampler = self.sampler()?;
        self.timeline(|timeline| {
            let all = 0..timeline.section_count();
            let all = all.map(|k| (sampler.first_frame(k) as f64, timeline.section(k)));
            let found = all.filter(|(first, section)| {
                section.change != Change::Nothing
                    && *first <= finding.last_frame
                    && first + section.frames as f64 > finding.first_frame
            });
            found.map(|(_, section)| section).collect()
        })
    }

    /// More frames for the sections of a finding, in proportion.
    fn slower(&self, finding: &Finding) -> Result<Vec<Edit>> {
        let more = MARGIN * (finding.value / finding.limit).min(MOST);
        let slowed = self.sections_of(finding)?.into_iter().map(|section| {
            let frames = (section.frames as f64 * more)
                .ceil()
                .min(MAX_SECTION_FRAMES as f64);
            #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
            let frames = frames as u32;
            let key = (section.point, section.orientation);
            owned(self.path(), key, &|own| own.frames = frames)
        });
        slowed.collect()
    }

    /// The speeds of the two sections that meet at a key, joined.
    fn joined(&self, finding: &Finding) -> Result<Vec<Edit>> {
        let path = self.path();
        let found = self.timeline(|timeline| {
            let number = timeline.section_from(finding.point, finding.orientation)?;
            let mut all = (0..number).rev().map(|k| (k, timeline.section(k)));
            let (k, before) = all.find(|(_, section)| section.frames > 0)?;
            let work = [k, number].map(|at| timeline.neighbour(path, at).work);
            let [first, _] = timeline.neighbours(path, k);
            let [_, last] = timeline.neighbours(path, number);
            Some(([before, timeline.section(number)], work, [first, last]))
        })?;
        let Some((sections, work, outer)) = found else {
            return Ok(Vec::new());
        };
        let mut ends = sections.map(|s| path.points[s.point].orientations[s.orientation].clone());
        let moves = sections.map(|section| section.change == Change::Position);
        let rises = |end: &Orientation, side: usize| match end.own.pace {
            Pace::Ease(ease) => [ease.fall, ease.rise][side] > 0.0,
            _ => false,
        };
        let rests = finding.last_frame > finding.first_frame
            || moves != [true; 2]
            || (0..2).any(|side| rises(&ends[side], side));
        if rests {
            for side in 0..2 {
                if moves[side] && !rises(&ends[side], side) {
                    come_to_rest(&mut ends[side], side)?;
                }
            }
        } else {
            join(&mut ends, &sections, work, outer)?;
        }
        let mut edits = Vec::new();
        for (orientation, section) in ends.into_iter().zip(sections) {
            let (point, at) = (section.point, section.orientation);
            if orientation != path.points[point].orientations[at] {
                edits.push(Edit::SetOrientation {
                    point,
                    at,
                    orientation,
                });
            }
        }
        Ok(edits)
    }

    /// Cures what a check against `object` finds, as long as something gets better by it; `tell`
    /// gets each finding that was cured. What is left is the answer.
    ///
    /// # Errors
    /// [`vides_engine::Error::Limit`], [`vides_engine::Error::Memory`]; [`vides_engine::Error::Argument`]
    /// where `progress` ends it.
    pub fn fix(
        &mut self,
        object: Option<&Clearance>,
        tell: &mut dyn FnMut(&Finding),
        progress: Progress<'_>,
    ) -> Result<Vec<Finding>> {
        let mut found = self.check_against(object, progress)?;
        let mut tried: Vec<(FindingKind, usize, usize)> = Vec::new();
        'again: loop {
            for finding in &found {
                let place = (finding.kind, finding.point, finding.orientation);
                if tried.iter().filter(|known| **known == place).count() >= TIMES {
                    continue;
                }
                if !progress(tried.len(), TIMES * found.len()) {
                    return Err(vides_engine::Error::from(Invalid::Cancelled).into());
                }
                let edits = match self.remedy(finding, object, progress) {
                    // No way round.
                    Err(error) if error.kind() == ErrorKind::Argument => Vec::new(),
                    edits => edits?,
                };
                if edits.is_empty() {
                    continue;
                }
                tried.push(place);
                let mut other = self.try_clone()?.without_history();
                if edits
                    .into_iter()
                    .try_for_each(|edit| other.apply(edit))
                    .is_err()
                {
                    continue;
                }
                let left = other.check_against(object, progress)?;
                if is_better(finding.kind, &found, &left) {
                    tell(finding);
                    *self = other;
                    found = left;
                    continue 'again;
                }
                // Here it does not help.
                tried.extend([place; TIMES]);
            }
            return Ok(found);
        }
    }
}

/// Whether less is found; or of one kind less or smaller excesses, and of the others not more. That
/// a key has become redundant is no fault.
fn is_better(kind: FindingKind, before: &[Finding], after: &[Finding]) -> bool {
    let of_kind = |found: &[Finding]| {
        let found = found.iter().filter(|finding| finding.kind == kind);
        found.fold((0, 0.0), |(count, sum), finding| {
            (count + 1, sum + (finding.value - finding.limit).abs())
        })
    };
    let all = |found: &[Finding]| {
        let counts = |of: FindingKind| of == kind || of != FindingKind::Redundant;
        found.iter().filter(|finding| counts(finding.kind)).count()
    };
    let ((many, much), (left, rest)) = (of_kind(before), of_kind(after));
    let [before, after] = [before, after].map(all);
    after < before || after - left <= before - many && (left < many || rest < much)
}

/// An orientation with a custom value changed.
fn owned(
    path: &CameraPath,
    key: (usize, usize),
    change: &dyn Fn(&mut OrientationOverrides),
) -> Result<Edit> {
    let (point, at) = key;
    let key = &path.points[point].orientations[at];
    let orientation = Orientation {
        own: key.own.with(|own| change(own))?,
        ..key.clone()
    };
    Ok(Edit::SetOrientation {
        point,
        at,
        orientation,
    })
}

fn set_tangent(at: usize, tangent: DVec3) -> Edit {
    let tangents = Some(Tangents {
        before: tangent,
        after: tangent,
    });
    Edit::set(At::Point(at), "tangents", tangents)
}

/// A tangent along the points beside one, as long as the shorter chord: it makes no loop.
fn smooth(path: &CameraPath, point: usize) -> Option<DVec3> {
    let count = path.points.len();
    let place = |at: usize| path.points[at % count].position;
    let before = (point > 0 || path.closed).then(|| place(point) - place(point + count - 1));
    let after = (point + 1 < count || path.closed).then(|| place(point + 1) - place(point));
    let (before, after) = (before.or(after)?, after.or(before)?);
    let length = before.length().min(after.length());
    Some(length * (before + after).try_normalize()?)
}

/// Lets a section end (side 0) or begin (1) at rest.
fn come_to_rest(orientation: &mut Orientation, side: usize) -> Result<()> {
    let mut ease = match orientation.own.pace {
        Pace::Ease(ease) => ease,
        Pace::Speeds => Ease {
            kind: EaseKind::Sine,
            rise: 0.0,
            fall: 0.0,
            cruise: [orientation.speeds[0], orientation.speeds[SPEEDS - 1]][side],
        },
        _ => return Ok(()),
    };
    if side == 0 {
        ease.fall = REST.min(1.0 - ease.rise);
    } else {
        ease.rise = REST.min(1.0 - ease.fall);
    }
    orientation.own = orientation.own.with(|own| own.pace = Pace::Ease(ease))?;
    Ok(())
}

/// Brings the speeds with which one section ends and the next begins to one between them; of
/// speeds that are not ten to choose, to those. `outer` are what lies beyond the other ends.
fn join(
    ends: &mut [Orientation; 2],
    sections: &[Section; 2],
    work: [f64; 2],
    [first, last]: [Option<Neighbour<'_>>; 2],
) -> Result<()> {
    let free = [0, 1].map(|side| matches!(ends[side].own.pace, Pace::Speeds));
    let begun = ends.clone();
    // Of a section with fixed frames the mean changes with its speeds: a few rounds settle it.
    for _ in 0..ROUNDS {
        let met = [timing::facing(&ends[0])[1], timing::facing(&ends[1])[0]];
        let mut scale = [0.0; 2];
        let [one, other] = [0, 1].map(|side| Neighbour {
            orientation: &ends[side],
            work: work[side],
        });
        for side in 0..2 {
            let timing = match side {
                0 => one.timing(first, Some(other)),
                _ => other.timing(Some(one), last),
            };
            let mean = timing?.mean();
            let section = &sections[side];
            let fixed = ends[side].own.frames > 0;
            // The way in one frame at speed 1.
            let mean = if fixed { mean } else { section.mean_speed };
            scale[side] = section.amount / (section.frames as f64 * mean);
        }
        let real = [0, 1].map(|side| scale[side] * met[side]);
        let common = match free {
            [true, false] => real[1],
            [false, true] => real[0],
            _ => 0.5 * (real[0] + real[1]),
        };
        for side in (0..2).filter(|side| free[*side]) {
            let wanted = (common / scale[side]).clamp(MIN_SPEED, MAX_SPEED);
            let old = [begun[0].speeds[SPEEDS - 1], begun[1].speeds[0]][side];
            for k in 0..SPEEDS / 2 {
                let at = if side == 0 { SPEEDS - 1 - k } else { k };
                // Over half of the section, smooth at both ends.
                let share = 1.0 - k as f64 / (SPEEDS / 2) as f64;
                let share = share * share * (3.0 - 2.0 * share);
                let speed = begun[side].speeds[at] + share * (wanted - old);
                ends[side].speeds[at] = speed.clamp(MIN_SPEED, MAX_SPEED);
            }
        }
    }
    Ok(())
}

const ROUNDS: usize = 20;

#[cfg(test)]
#[path = "remedy_tests.rs"]
mod tests;
