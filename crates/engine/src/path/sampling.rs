//! From a whole path to poses (thesis 5.2, 5.3, A.6.2; `docs/theory/path.md`, speed and frames).

use std::sync::OnceLock;
use std::sync::atomic::AtomicBool;

use super::ahead;
use super::arc_length;
use super::camera_path::{CameraPath, ZoomMode};
use super::fill::{Frames, Scratch, fill_widest};
use super::motion::{Motion, motions_widest};
use super::orientation_curve::{self, Key, turnings};
use super::pose::Pose;
use super::runs::{Run, each_run, in_order};
use super::section_sampler::{ArcLengthCurve, SectionSampler};
use super::timeline::{Change, Timeline};
use super::turning::Turning;
use super::ups::rolled;
use crate::error::{OutOfRange, Result, try_box, vec_with_room};
use crate::limits::{MAX_ZOOM, MIN_ZOOM};
use crate::math::{monotone_cubic, orientation};

/// Everything prepared to give any pose of a path; independent of the path it was made from.
#[derive(Debug)]
pub struct Sampler {
    sections: Vec<SectionSampler>,
    /// Poses of the keys: the one in which section k begins, and the last one.
    keys: Vec<Pose>,
    /// Number of the first own pose of each section.
    first_frames: Vec<usize>,
    /// Number of the last pose of each section in which something changes: by it they are found, in
    /// fewer cache lines than themselves.
    ends: Vec<usize>,
    frames: usize,
}

/// What is known of a path before its turning and its zoom.
pub(super) struct Layout<'a> {
    pub sections: Vec<SectionSampler>,
    /// The key in which section k begins; of an open path also the last one.
    pub keys: Vec<Key>,
    /// Their poses; of a closed path the first one again at the end.
    pub poses: Vec<Pose>,
    pub spans: Vec<orientation_curve::Span<'a>>,
    pub guides: orientation_curve::Guides<'a>,
    first_frames: Vec<usize>,
}

impl<'a> Layout<'a> {
    /// The timeline must be that path's.
    #[allow(clippy::cast_precision_loss)]
    pub(super) fn new(path: &CameraPath, timeline: &'a Timeline) -> Result<Self> {
        let count = timeline.section_count();
        let moving = timeline.moving().count();
        let mut first_frames = vec_with_room(count)?;
        let mut keys: Vec<Key> = vec_with_room(moving + 1)?;
        let mut poses: Vec<Pose> = vec_with_room(moving + 1)?;
        let mut spans: Vec<orientation_curve::Span<'_>> = vec_with_room(moving)?;
        let mut sections: Vec<SectionSampler> = vec_with_room(moving)?;

        let mut number = 1;
        for index in 0..count {
            let section = timeline.section(index);
            let point = &path.points[section.point];
            let orientation = &point.orientations[section.orientation];
            if section.change == Change::Nothing {
                first_frames.push(number);
                continue;
            }
            number += orientation.hold as usize;
            first_frames.push(number + 1);
            let (key, pose) = key(path, timeline, section.point, section.orientation);
            keys.push(key);
            poses.push(pose);
            let moves = section.orientation + 1 == point.orientations.len();
            let length = if moves {
                timeline.segment_length(section.point)
            } else {
                0.0
            };
            let curve = timeline.curve(section.point.min(timeline.segment_count() - 1));
            // A way too short to measure counts as none.
            let curve = (length > 100.0 * arc_length::TINY).then_some(curve);
            spans.push(orientation_curve::Span {
                duration: section.duration(),
                way: curve.map(|curve| (curve, length)),
                segment: section.point.min(timeline.segment_count() - 1),
                section: index,
            });
            sections.push(SectionSampler {
                section: index,
                start: number,
                frames: section.frames,
                speed: if section.constant_speed {
                    None
                } else {
                    Some(try_box(timeline.timing(path, index)?)?)
                },
                way: curve.map(|&curve| ArcLengthCurve { curve, length }),
                position: point.position,
                turning: Turning::Kept(glam::DVec3::Z, glam::DVec3::Y),
                space: path.space,
                zoom: [pose.zoom, 0.0, 0.0, 0.0],
                tables: OnceLock::new(),
                filled: AtomicBool::new(false),
            });
            number += section.frames;
        }
        // The last key: where an open path ends, where a closed one begins.
        if path.closed {
            let first = poses.first().copied();
            poses.push(match first {
                Some(first) => first,
                None => key(path, timeline, 0, 0).1,
            });
        } else {
            let last = path.points.len() - 1;
            let (key, pose) = key(
                path,
                timeline,
                last,
                path.points[last].orientations.len() - 1,
            );
            keys.push(key);
            poses.push(pose);
        }
        Ok(Self {
            sections,
            keys,
            poses,
            spans,
            guides: timeline.guides(),
            first_frames,
        })
    }
}

impl Sampler {
    /// Prepares a path; the timeline must be that path's.
    ///
    /// # Errors
    /// [`crate::Error::Memory`]; [`crate::Error::Limit`] if the path has too many frames.
    pub fn new(path: &CameraPath, timeline: &Timeline) -> Result<Self> {
        let frames = timeline.frame_count()?;
        let Layout {
            mut sections,
            mut keys,
            poses,
            spans,
            guides,
            first_frames,
        } = Layout::new(path, timeline)?;
        let (mode, space) = (path.orientation_mode, path.space);
        turnings(&mut keys, &spans, mode, guides, space, |k, turning| {
            sections[k].turning = turning;
        })?;
        let slopes = zoom_slopes(path, &keys, &spans, &poses)?;
        for (k, section) in sections.iter_mut().enumerate() {
            if let Turning::Tracked(..) = section.turning {
                section.space.up = keys[k].level(space.up);
            }
            let (zoom, rise) = (poses[k].zoom, poses[k + 1].zoom - poses[k].zoom);
            section.zoom = match path.zoom_mode {
                ZoomMode::Linear => [zoom, rise, 0.0, 0.0],
                ZoomMode::Smooth => {
                    let (step, from, to) = (spans[k].duration, slopes[k], slopes[k + 1]);
                    monotone_cubic::cubic(zoom, rise, step, from, to)
                }
            };
        }
        let mut ends = vec_with_room(sections.len())?;
        ends.extend(sections.iter().map(|s| s.start + s.frames));
        Ok(Self {
            sections,
            keys: poses,
            first_frames,
            ends,
            frames,
        })
    }

    /// All poses in order; [`crate::Error::Memory`] in place of the first that cannot be had ends it.
    #[must_use]
    pub fn iter(&self) -> Poses<'_> {
        Poses {
            sampler: self,
            block: [Pose::default(); BLOCK],
            next: 0,
        }
    }

    /// The sections in which something changes, for planning their pace.
    pub(crate) fn courses(&self) -> impl Iterator<Item = &SectionSampler> {
        self.sections.iter()
    }

    pub(super) fn sections(&self) -> &[SectionSampler] {
        &self.sections
    }

    /// All frames, at least 1.
    #[must_use]
    pub const fn frame_count(&self) -> usize {
        self.frames
    }

    /// Number (from 1) of a section's first pose after its key has rested. Its last one is this
    /// plus its frames less 1. For a section without frames it is the number of the key.
    ///
    /// # Panics
    /// If there is no such section.
    #[must_use]
    pub fn first_frame(&self, section: usize) -> usize {
        self.first_frames[section]
    }

    /// A number for each section in which something changes, in order: equal where all poses
    /// between its keys are, in this path or another; others are equal by a chance of about 2⁻⁶⁴.
    pub fn fingerprints(&self) -> impl Iterator<Item = u64> {
        self.sections.iter().map(SectionSampler::fingerprint)
    }

    /// Fills `poses` with the frames `first`, `first + 1`, … (numbered from 1).
    ///
    /// # Errors
    /// [`crate::Error::Range`] if not all of them are frames of the path, [`crate::Error::Memory`];
    /// what `poses` holds is then unspecified.
    pub fn sample(&self, first: usize, poses: &mut [Pose]) -> Result<()> {
        self.fill(&mut Scratch::new(), first, poses)
    }

    /// As [`Sampler::sample`], of poses that are handed on and not asked for again: short sections
    /// keep nothing for the next time.
    ///
    /// # Errors
    /// As [`Sampler::sample`].
    pub fn sample_once(&self, first: usize, poses: &mut [Pose]) -> Result<()> {
        let mut scratch = Scratch::new();
        scratch.once = true;
        self.fill(&mut scratch, first, poses)
    }

    fn fill(&self, scratch: &mut Scratch, first: usize, poses: &mut [Pose]) -> Result<()> {
        let inside = first >= 1 && first <= self.frames + 1;
        if !inside || poses.len() > self.frames + 1 - first {
            let last = first.saturating_add(poses.len().saturating_sub(1));
            return Err(self.no_frame(if inside { last } else { first } as f64));
        }
        let mut rest = poses;
        let mut number = first;
        // The section whose own poses end at or after the first one wanted.
        let mut index = self.ends.partition_point(|&end| end < number);
        while !rest.is_empty() {
            let Some(section) = self.sections.get(index) else {
                rest.fill(self.keys[self.sections.len()]);
                break;
            };
            // The key in which the section begins, as long as it rests.
            let resting = (section.start + 1).saturating_sub(number).min(rest.len());
            let (held, after) = rest.split_at_mut(resting);
            held.fill(self.keys[index]);
            number += resting;
            // Poses between the two keys, then the second key itself.
            let between = (section.start + section.frames - number).min(after.len());
            let (moved, after) = after.split_at_mut(between);
            if between > 0 {
                SectionSampler::fetch_next(&self.sections[index + 1..]);
                fill_widest(
                    section,
                    scratch,
                    Frames::From(number - section.start),
                    moved,
                )?;
            }
            number += between;
            rest = after;
            if let Some(end) = rest.first_mut() {
                *end = self.keys[index + 1];
                rest = &mut rest[1..];
                number += 1;
            }
            index += 1;
        }
        Ok(())
    }

    /// The error where there is no such frame.
    #[allow(clippy::cast_precision_loss)]
    pub(super) fn no_frame(&self, frame: f64) -> crate::Error {
        OutOfRange::NoFrame {
            frame,
            first: 1.0,
            last: self.frames as f64,
        }
        .into()
    }

    /// The last frame, if all these are frames of the path.
    ///
    /// # Panics
    /// If there are not as many frames as results.
    #[allow(clippy::cast_precision_loss)]
    fn last_of(&self, frames: &[f64], results: usize) -> Result<f64> {
        assert_eq!(frames.len(), results);
        let last = self.frames as f64;
        match frames.iter().find(|&&f| !(f >= 1.0 && f <= last)) {
            Some(&frame) => Err(self.no_frame(frame)),
            None => Ok(last),
        }
    }

    /// The pose at any frame between 1 and the last, also between two frames; at a whole one bit for
    /// bit that of [`Sampler::sample`].
    ///
    /// # Errors
    /// [`crate::Error::Range`] outside them, [`crate::Error::Memory`].
    pub fn pose(&self, frame: f64) -> Result<Pose> {
        let mut pose = [Pose::default()];
        self.poses_at(&[frame], &mut pose)?;
        Ok(pose[0])
    }

    /// The poses at any frames in any order, each as [`Sampler::pose`] gives it; fastest in
    /// ascending order. As many frames as poses.
    ///
    /// # Errors
    /// [`crate::Error::Range`] for the first frame outside them, before any pose is written;
    /// [`crate::Error::Memory`], and what `poses` holds is then unspecified.
    ///
    /// # Panics
    /// If there are not as many frames as poses.
    pub fn poses_at(&self, frames: &[f64], poses: &mut [Pose]) -> Result<()> {
        let last = self.last_of(frames, poses.len())?;
        let mut scratch = Scratch::new();
        in_order(frames, poses, |frames, poses| {
            let fill = |run: Run<'_, Pose>| match run {
                Run::Held(index, pose) => {
                    *pose = self.keys[index];
                    Ok(())
                }
                Run::Moved(index, frames, poses) => {
                    let frames = Frames::At(frames);
                    fill_widest(&self.sections[index], &mut scratch, frames, poses)
                }
            };
            each_run(&self.sections, &self.ends, last, frames, poses, false, fill)
        })
    }

    /// How the camera moves at any frame between 1 and the last, also between two frames. At a key
    /// it is how the camera goes on; at the last frame how it came there.
    ///
    /// Lengths are exact to rounding, the turning to about 10⁻¹² of a section's whole turn where it
    /// is a curve of quaternions or looks at a target, elsewhere (along the way, at the target, at
    /// the poles) to 10⁻¹⁰, by differences.
    ///
    /// # Errors
    /// As [`Sampler::pose`].
    pub fn motion(&self, frame: f64) -> Result<Motion> {
        let mut motion = [Motion::default()];
        self.motions_at(&[frame], &mut motion)?;
        Ok(motion[0])
    }

    /// The motions at any frames in any order, each as [`Sampler::motion`] gives it; as many frames
    /// as motions.
    ///
    /// # Errors
    /// As [`Sampler::poses_at`].
    ///
    /// # Panics
    /// If there are not as many frames as motions.
    pub fn motions_at(&self, frames: &[f64], motions: &mut [Motion]) -> Result<()> {
        let last = self.last_of(frames, motions.len())?;
        let mut before = vec_with_room(self.sections.len() + 1)?;
        let mut sum = 0.0;
        before.push(sum);
        for section in &self.sections {
            sum += section.way.as_ref().map_or(0.0, |way| way.length);
            before.push(sum);
        }
        let mut scratch = Scratch::new();
        in_order(frames, motions, |frames, motions| {
            let fill = |run: Run<'_, Motion>| match run {
                Run::Held(index, motion) => {
                    *motion = Motion {
                        distance: before[index],
                        ..Motion::default()
                    };
                    Ok(())
                }
                Run::Moved(index, frames, motions) => {
                    let (section, before) = (&self.sections[index], before[index]);
                    motions_widest(section, before, &mut scratch, frames, motions)
                }
            };
            each_run(
                &self.sections,
                &self.ends,
                last,
                frames,
                motions,
                true,
                fill,
            )
        })
    }
}

fn key(path: &CameraPath, timeline: &Timeline, point: usize, orientation: usize) -> (Key, Pose) {
    let axes = path.space.up;
    let view = ahead::view(path, point, orientation);
    let reference = timeline.reference(path, (point, orientation), view);
    let point = &path.points[point];
    let orientation = &point.orientations[orientation];
    let roll = orientation.roll.to_radians();
    let upright = axes.upright(view);
    let up = rolled(upright, reference, roll);
    let key = Key {
        position: point.position,
        target: orientation.target,
        view: upright,
        roll,
        reference,
        turning: orientation.turning,
        own: orientation.own.clone(),
        q: orientation::quaternion_from_view(upright, up),
    };
    let pose = Pose {
        vrp: point.position.to_array(),
        vpn: view.to_array(),
        vup: axes.world(up).to_array(),
        zoom: orientation.zoom,
    };
    (key, pose)
}

/// The slope of the zoom at each key, the first again at a closed end; empty if the zoom is linear.
pub(super) fn zoom_slopes(
    path: &CameraPath,
    keys: &[Key],
    spans: &[orientation_curve::Span<'_>],
    poses: &[Pose],
) -> Result<Vec<f64>> {
    if spans.is_empty() || path.zoom_mode == ZoomMode::Linear {
        return Ok(Vec::new());
    }
    let mut steps: Vec<f64> = vec_with_room(spans.len())?;
    let mut rises: Vec<f64> = vec_with_room(spans.len())?;
    let mut slopes: Vec<f64> = vec_with_room(spans.len() + 1)?;
    steps.extend(spans.iter().map(|way| way.duration));
    rises.extend(poses.windows(2).map(|pair| pair[1].zoom - pair[0].zoom));
    slopes.resize(spans.len() + 1, 0.0);
    monotone_cubic::slopes(&steps, &rises, path.closed, &mut slopes);
    for (k, slope) in slopes.iter_mut().enumerate() {
        let key = &keys[k % keys.len()];
        if let Some(own) = key.own.zoom_slope {
            let before = match k {
                0 => path.closed.then(|| spans.len() - 1),
                k => Some(k - 1),
            };
            let after = if k < spans.len() {
                Some(k)
            } else {
                path.closed.then_some(0)
            };
            *slope = limited_slope(
                own,
                poses[k].zoom,
                [before, after].map(|k| k.map(|k| steps[k])),
            );
        }
    }
    Ok(slopes)
}

/// Clips an own slope of the zoom so that the adjacent inner Bézier points, and by their hull
/// every value, are valid zooms. `steps` are the curve times of the sections before and after.
fn limited_slope(own: f64, zoom: f64, steps: [Option<f64>; 2]) -> f64 {
    let [before, after] = steps.map(|step| step.map_or(0.0, |step| step / 3.0));
    let (up, down) = (MAX_ZOOM - zoom, zoom - MIN_ZOOM);
    let most = (up / after).min(down / before);
    let least = (down / after).min(up / before);
    own.clamp(-least, most)
}

/// The poses of a path, one after the other ([`Sampler::iter`]).
#[derive(Debug, Clone)]
pub struct Poses<'a> {
    sampler: &'a Sampler,
    /// Those of the frames that are filled with the next one.
    block: [Pose; BLOCK],
    next: usize,
}

/// Poses filled at once: enough to be fast, few enough for the stack.
const BLOCK: usize = 32;

impl Iterator for Poses<'_> {
    type Item = Result<Pose>;

    fn next(&mut self) -> Option<Result<Pose>> {
        let (at, left) = (self.next % BLOCK, self.len());
        if left == 0 {
            return None;
        }
        if at == 0
            && let Err(error) = self
                .sampler
                .sample(self.next + 1, &mut self.block[..left.min(BLOCK)])
        {
            self.next = self.sampler.frames;
            return Some(Err(error));
        }
        self.next += 1;
        Some(Ok(self.block[at]))
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        let left = self.sampler.frames - self.next;
        (left, Some(left))
    }
}

impl ExactSizeIterator for Poses<'_> {}

impl std::iter::FusedIterator for Poses<'_> {}

impl<'a> IntoIterator for &'a Sampler {
    type Item = Result<Pose>;
    type IntoIter = Poses<'a>;

    fn into_iter(self) -> Poses<'a> {
        self.iter()
    }
}

#[cfg(test)]
#[path = "sampling_tests.rs"]
mod tests;
