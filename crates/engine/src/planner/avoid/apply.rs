//! Bent stretches become points: the new ones by insertion on the curve, at the frames at which the
//! pace of the section comes there; then all are moved.

use super::bend::Bend;
use super::{Avoided, AvoidedPart, Work};
use crate::error::{Result, vec_with_room};
use crate::path::arc_length::ArcLength;
use crate::path::{Change, Tangents, curve, insertion};
use crate::tools::keep::keep_tangents;
use glam::DVec3;

/// A stretch that is clear, between places in `Work::points`.
pub(super) struct Bent<'a, 'w> {
    pub bend: Bend<'a, 'w>,
    pub range: [usize; 2],
}

/// A new point: its segment and its frame.
struct New {
    segment: usize,
    frame: f64,
}

impl Work<'_> {
    pub(super) fn applied(&self, bent: &[Bent<'_, '_>]) -> Result<Avoided> {
        let mut made = self.path.try_clone()?;
        self.fix_frames(&mut made, bent)?;
        let mut new = Vec::new();
        for stretch in bent {
            self.new_points(stretch, &mut new)?;
        }
        // From behind, so that frames and numbers of points before stay.
        new.sort_by(|a, b| b.frame.total_cmp(&a.frame));
        for point in &new {
            made = insertion::on_curve(&made, point.frame)?.path;
        }
        let before = |point: usize| new.iter().filter(|new| new.segment < point).count();
        let at = |point: usize| point + before(point);
        let mut wanted: Vec<Option<Tangents>> = vec_with_room(made.points.len())?;
        wanted.resize(made.points.len(), None);
        for point in 0..self.path.points.len() {
            wanted[at(point)] = Some(curve::tangents(self.path, point));
        }
        let mut parts = vec_with_room(bent.len())?;
        for Bent { bend, range } in bent {
            let mut part = AvoidedPart {
                from: at(self.points[range[0]].0),
                to: at(self.points[range[1]].0),
                moved: 0,
                inserted: 0,
                furthest: 0.0,
            };
            let (mut segment, mut rank) = (0, 0);
            for (k, knot) in bend.knots.iter().enumerate() {
                let leave = (k + 1 < bend.knots.len()).then(|| bend.piece(k).c);
                let reach = (k > 0).then(|| bend.piece(k - 1).derivative(1.0));
                part.furthest = part.furthest.max(knot.delta.length());
                if knot.new {
                    rank += 1;
                    let index = at(segment) + rank;
                    made.points[index].position = bend.piece(k).d;
                    wanted[index] = leave
                        .zip(reach)
                        .map(|(after, before)| Tangents { before, after });
                    part.inserted += 1;
                    if bend.linear {
                        (made.points[index].tangents, wanted[index]) = (None, None);
                    }
                    continue;
                }
                let here = (range[0]..=range[1]).filter(|at| self.points[*at].1 == knot.u);
                let (first, last) = (here.clone().min(), here.clone().max());
                // A closed way ends where it began.
                for place in here {
                    let point = self.points[place].0;
                    let index = at(point);
                    if knot.delta != DVec3::ZERO {
                        made.points[index].position = self.path.points[point].position + knot.delta;
                        part.moved += 1;
                    }
                    if bend.linear {
                        (made.points[index].tangents, wanted[index]) = (None, None);
                    } else if let Some(own) = &mut wanted[index] {
                        if let Some(reach) = reach.filter(|_| Some(place) == first) {
                            own.before = reach;
                        }
                        if let Some(leave) = leave.filter(|_| Some(place) == last) {
                            own.after = leave;
                        }
                    }
                    (segment, rank) = (point, 0);
                }
            }
            parts.push(part);
        }
        keep_tangents(&mut made, &wanted)?;
        Ok(Avoided { path: made, parts })
    }

    /// Sections that change own the frames that they have.
    fn fix_frames(&self, made: &mut crate::path::CameraPath, bent: &[Bent<'_, '_>]) -> Result<()> {
        for Bent { bend, range } in bent {
            for place in range[0]..=range[1] {
                let (point, u) = self.points[place];
                let here = |knot: &&super::Knot| knot.u == u && !knot.new;
                let knot = bend.knots.iter().find(here);
                let moves = knot.is_some_and(|knot| knot.delta != DVec3::ZERO);
                let count = made.points[point].orientations.len();
                for number in 0..count {
                    let leaves = number + 1 == count;
                    if if leaves { place == range[1] } else { !moves } {
                        continue;
                    }
                    let Some(section) = self.timeline.section_from(point, number) else {
                        continue;
                    };
                    let section = self.timeline.section(section);
                    if section.change == Change::Nothing {
                        continue;
                    }
                    // A path has at most u32::MAX frames.
                    let frames = section.frames as u32;
                    let orientation = &mut made.points[point].orientations[number];
                    orientation.own = orientation.own.with(|own| own.frames = frames)?;
                }
            }
        }
        Ok(())
    }

    /// Where the new points of a stretch lie in time: where the pace of the section, over the new
    /// way, comes past them.
    fn new_points(&self, stretch: &Bent<'_, '_>, all: &mut Vec<New>) -> Result<()> {
        let knots = &stretch.bend.knots;
        let mut first = 0;
        while first + 1 < knots.len() {
            let mut end = first + 1;
            while knots[end].new {
                end += 1;
            }
            let count = end - first - 1;
            if count > 0 {
                let leg =
                    ((0.5 * (knots[first].u + knots[end].u)) as usize).min(self.legs.len() - 1);
                let section = self.section(leg);
                let timing = self.timeline.timing(self.path, section)?;
                let start = self.sampler.first_frame(section) - 1;
                let frames = self.frames[leg];
                let mut lengths = vec_with_room(count + 1)?;
                for piece in first..end {
                    lengths.push(ArcLength::new(&stretch.bend.piece(piece))?.length());
                }
                let whole: f64 = lengths.iter().sum();
                let (mut way, mut least) = (0.0, 1);
                for (rank, length) in lengths[..count].iter().enumerate() {
                    way += length;
                    let (mut low, mut high) = (0.0, 1.0);
                    for _ in 0..50 {
                        let middle = 0.5 * (low + high);
                        if timing.fraction(middle) < way / whole {
                            low = middle;
                        } else {
                            high = middle;
                        }
                    }
                    let most = (frames + rank).saturating_sub(count).max(least);
                    let frame = ((low * frames as f64).round() as usize).clamp(least, most);
                    least = frame + 1;
                    all.try_reserve(1)?;
                    all.push(New {
                        segment: self.segments[leg],
                        frame: (start + frame) as f64,
                    });
                }
            }
            first = end;
        }
        Ok(())
    }
}
