//! Sections and their frames (thesis 5.2, 5.3, B.2.2; `docs/theory/path.md`, sections). When the values at
//! one point change, only what lies around it is computed again.

use std::sync::Arc;

use glam::DVec3;

use super::ahead::{self, Rail};
use super::camera_path::{CameraPath, Orientation};
use super::curve;
use super::dispatch;
use super::hermite::Cubic;
use super::joint::Neighbour;
use super::orientation_curve::Guides;
use super::section::unrounded;
pub use super::section::{Change, Section};
use super::speed_curve::{CurveEnd, SpeedCurve};
use super::timing::{Timing, facing};
use super::ups::{self, Alignment, rolled};
use crate::error::{Result, TooMany, vec_with_room};
use crate::limits::{BASE_SPEED, MAX_FRAMES, ZOOM_UNIT};
use crate::math::rotation_minimising::signed_angle;
use crate::math::{orientation, quaternion};

/// Less than this is no change: units of `half_size`, radians, degrees, zoom.
const NO_CHANGE: f64 = 1e-9;

/// Share by which a number of frames may fall short of a half and still be rounded up.
const TIE: f64 = 1e-12;

#[derive(Debug, Clone)]
struct Segment {
    curve: Cubic,
    length: f64,
}

#[derive(Debug, Clone, Copy)]
struct State {
    change: Change,
    amount: f64,
    mean_speed: f64,
    frames: usize,
    /// The hold of the key in which the section begins, if it has frames.
    hold: usize,
    constant_speed: bool,
    curve_time: Option<f64>,
}

impl State {
    fn moves(&self) -> bool {
        self.change != Change::Nothing
    }
}

/// Whether an orientation's view or up depends on more than itself.
fn follows(orientation: &Orientation) -> bool {
    let own = &orientation.own;
    !own.is_empty() && (own.ahead.is_some() || !own.up.is_level())
}

/// Lengths of all segments, frames of all sections. Orientations are counted through the whole
/// path: a *slot* is the number of one, and section k leads from slot k to the next.
#[derive(Debug, Clone)]
pub struct Timeline {
    closed: bool,
    /// First slot of each point, and one past the last.
    first_slot: Vec<usize>,
    segments: Vec<Segment>,
    sections: Vec<State>,
    /// Hold of the last orientation of an open path.
    last_hold: usize,
    frames: usize,
    /// The whole curve, where a view looks along it or has another up than the axis.
    rail: Option<Arc<Rail>>,
    /// Where a view has another up than the axis.
    alignment: Option<Alignment>,
}

impl Timeline {
    /// Computes everything for a path that [`CameraPath::check`] accepts.
    ///
    /// # Errors
    /// [`crate::Error::Memory`].
    pub fn new(path: &CameraPath) -> Result<Self> {
        let points = path.points.len();
        let mut first_slot = vec_with_room(points + 1)?;
        let mut slots = 0;
        first_slot.push(0);
        for point in &path.points {
            slots += point.orientations.len();
            first_slot.push(slots);
        }
        let mut segments = vec_with_room(path.segment_count())?;
        for index in 0..path.segment_count() {
            let curve = curve::segment(path, index);
            let length = dispatch::length(&curve);
            segments.push(Segment { curve, length });
        }
        let count = if path.closed { slots } else { slots - 1 };
        let sections = vec_with_room(count)?;
        let mut timeline = Self {
            closed: path.closed,
            first_slot,
            segments,
            sections,
            last_hold: last_hold(path),
            frames: 1,
            rail: None,
            alignment: None,
        };
        timeline.align(path)?;
        for (index, point) in path.points.iter().enumerate() {
            for number in 0..point.orientations.len() {
                if timeline.sections.len() == count {
                    break;
                }
                let (change, amount) = timeline.compare(path, index, number);
                timeline.sections.push(State {
                    change,
                    amount,
                    mean_speed: BASE_SPEED,
                    frames: 0,
                    hold: 0,
                    constant_speed: true,
                    curve_time: None,
                });
            }
        }
        timeline.pace_all(path)?;
        Ok(timeline)
    }

    /// To be called after values (not the number) of anything at one point of the path have
    /// changed, and only there. After an error the timeline must not be used any more.
    ///
    /// # Errors
    /// [`crate::Error::Memory`].
    pub fn update_point(&mut self, path: &CameraPath, point: usize) -> Result<()> {
        let ahead = self.rail.is_some() || path.points[point].orientations.iter().any(follows);
        if path.curve.is_spline() || ahead {
            // Of a spline many segments feel a point, and along the way all views may.
            *self = Self::new(path)?;
            return Ok(());
        }
        let points = path.points.len();
        let mut touched: Vec<usize> = vec_with_room(64)?;
        // A point shapes two segments on either side, some of them twice on a short closed path.
        for offset in 0..4 {
            let Some(near) = self.step(point, offset, points) else {
                continue;
            };
            if near < self.segments.len() {
                let curve = curve::segment(path, near);
                let segment = &mut self.segments[near];
                if segment.curve != curve {
                    segment.length = dispatch::length(&curve);
                    segment.curve = curve;
                }
            }
            let last = self.first_slot[near + 1] - 1;
            if near != point && last < self.sections.len() && !touched.contains(&last) {
                touched.push(last);
            }
        }
        touched.extend(self.first_slot[point]..self.first_slot[point + 1].min(self.sections.len()));
        for &section in &touched {
            let (start, orientation) = self.start_of(section);
            let (change, amount) = self.compare(path, start, orientation);
            let state = &mut self.sections[section];
            (state.change, state.amount) = (change, amount);
        }
        // Their neighbours see other facing speeds.
        for i in 0..touched.len() {
            let around = [
                self.moving_before(touched[i]),
                self.moving_after(touched[i]),
            ];
            for neighbour in around.into_iter().flatten() {
                if !touched.contains(&neighbour) {
                    touched.try_reserve(1)?;
                    touched.push(neighbour);
                }
            }
        }
        for section in touched {
            self.pace(path, section)?;
        }
        let hold = last_hold(path);
        self.frames = self.frames - self.last_hold + hold;
        self.last_hold = hold;
        Ok(())
    }

    /// Prepares what views along the way and other ups than the axis go by.
    fn align(&mut self, path: &CameraPath) -> Result<()> {
        let mut all = path.points.iter().flat_map(|point| &point.orientations);
        if all.any(follows) {
            let segments = self.segments.iter();
            let segments = segments.map(|segment| (segment.curve, segment.length));
            let rail = self.rail.insert(Rail::new(path, segments)?);
            if ups::any(path) {
                self.alignment = Some(Alignment::new(path, rail)?);
            }
        }
        Ok(())
    }

    pub(super) fn guides(&self) -> Guides<'_> {
        Guides {
            rail: self.rail.as_ref(),
            alignment: self.alignment.as_ref(),
        }
    }

    /// Whether ups by the normal are the up axis.
    pub(super) fn has_no_normals(&self) -> bool {
        self.alignment
            .as_ref()
            .is_some_and(Alignment::has_no_normals)
    }

    /// Up before the roll of an orientation with this view, in y-up axes; `None` where it is the
    /// up axis.
    pub(super) fn reference(
        &self,
        path: &CameraPath,
        (point, orientation): (usize, usize),
        view: DVec3,
    ) -> Option<DVec3> {
        let upright = path.space.up;
        match path.points[point].orientations[orientation]
            .own
            .up
            .level(upright)
        {
            Some(axis) if axis == upright => None,
            Some(axis) => Some(upright.upright(axis.level_axes(view).1)),
            None => self
                .alignment
                .as_ref()?
                .up(self.first_slot[point] + orientation),
        }
    }

    /// All frames of the path, at least 1.
    ///
    /// # Errors
    /// [`crate::Error::Limit`] if there are more than [`MAX_FRAMES`].
    pub fn frame_count(&self) -> Result<usize> {
        if self.frames > MAX_FRAMES {
            return Err(TooMany::Frames.into());
        }
        Ok(self.frames)
    }

    /// Length of the whole curve.
    #[must_use]
    pub fn length(&self) -> f64 {
        self.segments.iter().map(|segment| segment.length).sum()
    }

    /// Number of segments.
    #[must_use]
    pub fn segment_count(&self) -> usize {
        self.segments.len()
    }

    /// Length of one segment.
    ///
    /// # Panics
    /// If there is no such segment.
    #[must_use]
    pub fn segment_length(&self, segment: usize) -> f64 {
        self.segments[segment].length
    }

    /// Curve of one segment.
    ///
    /// # Panics
    /// If there is no such segment.
    #[must_use]
    pub fn curve(&self, segment: usize) -> &Cubic {
        &self.segments[segment].curve
    }

    /// Sections: one fewer than orientations, as many if the path is closed.
    #[must_use]
    pub fn section_count(&self) -> usize {
        self.sections.len()
    }

    /// One section.
    ///
    /// # Panics
    /// If there is no such section.
    #[must_use]
    pub fn section(&self, section: usize) -> Section {
        let (point, orientation) = self.start_of(section);
        let state = self.sections[section];
        Section {
            point,
            orientation,
            change: state.change,
            amount: state.amount,
            mean_speed: state.mean_speed,
            frames: state.frames,
            constant_speed: state.constant_speed,
            curve_time: state.curve_time,
        }
    }

    /// The sections in which something changes.
    pub(crate) fn moving(&self) -> impl Iterator<Item = usize> {
        (0..self.sections.len()).filter(|&section| self.sections[section].moves())
    }

    /// Frames of a section by its length, fixed or not, before rounding; 0 if nothing changes.
    ///
    /// # Panics
    /// If there is no such section.
    #[must_use]
    pub fn unrounded_frames(&self, path: &CameraPath, section: usize) -> f64 {
        let state = &self.sections[section];
        unrounded(path, state.change, state.amount, state.mean_speed)
    }

    /// The section that begins with an orientation; the last one of an open path begins none.
    #[must_use]
    pub fn section_from(&self, point: usize, orientation: usize) -> Option<usize> {
        let slot = self.first_slot.get(point)? + orientation;
        (slot < self.sections.len()).then_some(slot)
    }

    /// The speed curve of a section, shaped by its neighbours'; without frames, as if it had some.
    ///
    /// # Errors
    /// [`crate::Error::Memory`].
    ///
    /// # Panics
    /// If there is no such section.
    pub fn speed_curve(&self, path: &CameraPath, section: usize) -> Result<SpeedCurve> {
        let ends = self.curve_ends(path, section)?;
        Ok(SpeedCurve::new(
            &self.orientation_at(path, section).speeds,
            ends,
        ))
    }

    /// What shapes the curve of a section's ten speeds.
    ///
    /// # Errors
    /// [`crate::Error::Memory`].
    ///
    /// # Panics
    /// If there is no such section.
    pub fn curve_ends(&self, path: &CameraPath, section: usize) -> Result<[CurveEnd; 2]> {
        let [before, after] = self.neighbours(path, section);
        self.neighbour(path, section).curve_ends(before, after)
    }

    /// A section as its neighbours see it.
    ///
    /// # Panics
    /// If there is no such section.
    #[must_use]
    pub fn neighbour<'a>(&self, path: &'a CameraPath, section: usize) -> Neighbour<'a> {
        let State { change, amount, .. } = self.sections[section];
        Neighbour {
            orientation: self.orientation_at(path, section),
            work: unrounded(path, change, amount, 1.0),
        }
    }

    /// The moving sections before and after one; `None` at the ends.
    ///
    /// # Panics
    /// If there is no such section.
    #[must_use]
    pub fn neighbours<'a>(
        &self,
        path: &'a CameraPath,
        section: usize,
    ) -> [Option<Neighbour<'a>>; 2] {
        let around = [self.moving_before(section), self.moving_after(section)];
        around.map(|at| at.map(|at| self.neighbour(path, at)))
    }

    /// The pace of a section, shaped by its neighbours' where it goes by its ten speeds.
    ///
    /// # Errors
    /// [`crate::Error::Memory`].
    ///
    /// # Panics
    /// If there is no such section.
    pub fn timing(&self, path: &CameraPath, section: usize) -> Result<Timing> {
        let [before, after] = self.neighbours(path, section);
        self.neighbour(path, section).timing(before, after)
    }

    /// Last speed of the moving section before this one and first of that after it; `None` at the
    /// ends. The number of sections stands for the orientation after the last of them.
    ///
    /// # Panics
    /// If there is no such section.
    #[must_use]
    pub fn facing_speeds(&self, path: &CameraPath, section: usize) -> (Option<f64>, Option<f64>) {
        let before = self
            .moving_before(section)
            .map(|before| facing(self.orientation_at(path, before))[1]);
        let after = if section < self.sections.len() {
            self.moving_after(section)
        } else {
            None
        };
        let after = after.map(|after| facing(self.orientation_at(path, after))[0]);
        (before, after)
    }

    /// Point and orientation with which a section begins.
    pub(super) fn start_of(&self, section: usize) -> (usize, usize) {
        let point = self.first_slot.partition_point(|&first| first <= section) - 1;
        (point, section - self.first_slot[point])
    }

    fn orientation_at<'a>(&self, path: &'a CameraPath, slot: usize) -> &'a Orientation {
        let (point, orientation) = self.start_of(slot);
        &path.points[point].orientations[orientation]
    }

    /// `point` − 2 + `offset`, around the ends of a closed path.
    fn step(&self, point: usize, offset: usize, points: usize) -> Option<usize> {
        let near = (point + offset).checked_sub(2);
        if self.closed {
            Some((point + offset + 2 * points - 2) % points)
        } else {
            near.filter(|&near| near < points)
        }
    }

    /// What changes first in the section that begins with this orientation.
    fn compare(&self, path: &CameraPath, point: usize, orientation: usize) -> (Change, f64) {
        let here = &path.points[point];
        let from = &here.orientations[orientation];
        let to = if orientation + 1 < here.orientations.len() {
            &here.orientations[orientation + 1]
        } else {
            let length = self.segments[point].length / path.space.half_size;
            if length > NO_CHANGE {
                return (Change::Position, length);
            }
            &path.points[(point + 1) % path.points.len()].orientations[0]
        };
        let next = next(path, (point, orientation));
        let [a, b] = [(point, orientation), next].map(|(p, o)| ahead::view(path, p, o));
        let references = [
            self.reference(path, (point, orientation), a),
            self.reference(path, next, b),
        ];
        if (a - b).length() > NO_CHANGE {
            let key = |view, reference, roll: f64| {
                let view = path.space.up.upright(view);
                orientation::quaternion_from_view(view, rolled(view, reference, roll.to_radians()))
            };
            let a = key(a, references[0], from.roll);
            let b = key(b, references[1], to.roll);
            let angle = quaternion::angle(a, if a.dot(b) < 0.0 { -b } else { b });
            return (Change::View, angle / std::f64::consts::FRAC_PI_2);
        }
        let view = path.space.up.upright(a);
        let level = |up: Option<DVec3>| rolled(view, up, 0.0);
        let between = match references {
            _ if from.own.up.is_level() && from.own.up.same(&to.own.up, path.space.up) => 0.0,
            [a, b] => signed_angle(level(a), level(b), view).to_degrees(),
        };
        let roll = orientation::wrap_degrees(to.roll - from.roll + between).abs();
        if roll > NO_CHANGE {
            return (Change::Roll, roll / 90.0);
        }
        let zoom = (to.zoom - from.zoom).abs();
        if zoom > NO_CHANGE {
            return (Change::Zoom, zoom / ZOOM_UNIT);
        }
        (Change::Nothing, 0.0)
    }

    /// The nearest section before this one that has frames.
    fn moving_before(&self, section: usize) -> Option<usize> {
        let found = self.sections[..section].iter().rposition(State::moves);
        if found.is_some() || !self.closed {
            return found;
        }
        let wrapped = self.sections[section..].iter().rposition(State::moves);
        wrapped.map(|found| section + found)
    }

    fn moving_after(&self, section: usize) -> Option<usize> {
        let found = self.sections[section + 1..].iter().position(State::moves);
        if found.is_some() || !self.closed {
            return found.map(|found| section + 1 + found);
        }
        self.sections[..=section].iter().position(State::moves)
    }

    /// Mean speed and frames of one section from what changes in it.
    fn pace(&mut self, path: &CameraPath, section: usize) -> Result<()> {
        let state = self.sections[section];
        let mut new = State {
            frames: 0,
            hold: 0,
            mean_speed: BASE_SPEED,
            constant_speed: true,
            curve_time: None,
            ..state
        };
        if state.moves() {
            let around = self.neighbours(path, section);
            new = paced(path, state, self.neighbour(path, section), around)?;
        }
        self.frames = self.frames - state.frames - state.hold + new.frames + new.hold;
        self.sections[section] = new;
        Ok(())
    }

    /// [`Self::pace`] for all sections in one pass over the path.
    fn pace_all(&mut self, path: &CameraPath) -> Result<()> {
        let mut before = if self.closed && !self.sections.is_empty() {
            self.moving_before(0).map(|slot| self.neighbour(path, slot))
        } else {
            None
        };
        let first = self.sections.iter().position(State::moves);
        let wrap = first.filter(|_| self.closed);
        let wrap = wrap.map(|slot| self.neighbour(path, slot));
        let mut pending: Option<(usize, Neighbour<'_>)> = None;
        self.frames = 1 + self.last_hold;
        let mut finish = |state: &mut State, this, around| -> Result<()> {
            *state = paced(path, *state, this, around)?;
            self.frames += state.frames + state.hold;
            Ok(())
        };
        let orientations = path.points.iter().flat_map(|point| &point.orientations);
        for (slot, orientation) in orientations.enumerate().take(self.sections.len()) {
            let State { change, amount, .. } = self.sections[slot];
            if change == Change::Nothing {
                continue;
            }
            let work = unrounded(path, change, amount, 1.0);
            let this = Neighbour { orientation, work };
            if let Some((slot, done)) = pending {
                finish(&mut self.sections[slot], done, [before, Some(this)])?;
                before = Some(done);
            }
            pending = Some((slot, this));
        }
        if let Some((slot, done)) = pending {
            finish(&mut self.sections[slot], done, [before, wrap])?;
        }
        Ok(())
    }
}

/// The orientation in which the section ends that begins with this one.
pub(super) fn next(path: &CameraPath, (point, orientation): (usize, usize)) -> (usize, usize) {
    if orientation + 1 < path.points[point].orientations.len() {
        (point, orientation + 1)
    } else {
        ((point + 1) % path.points.len(), 0)
    }
}

/// Hold of the last orientation; a closed path ends in its first key, which has rested already.
fn last_hold(path: &CameraPath) -> usize {
    if path.closed {
        return 0;
    }
    let last = path
        .points
        .last()
        .and_then(|point| point.orientations.last());
    last.map_or(0, |orientation| orientation.hold as usize)
}

/// The state of a section that moves, between two others.
fn paced(
    path: &CameraPath,
    state: State,
    this: Neighbour<'_>,
    [before, after]: [Option<Neighbour<'_>>; 2],
) -> Result<State> {
    let ends = this.curve_ends(before, after)?;
    let this = this.orientation;
    let (mean_speed, constant_speed) = Timing::outline(this, ends)?;
    let frames = match this.own.frames {
        0 => {
            let frames = unrounded(path, state.change, state.amount, mean_speed);
            // Half a frame rounds up whatever its last bits, which depend on the processor.
            (frames + TIE * frames).round()
        }
        fixed => f64::from(fixed),
    };
    // Beyond the limit the exact number does not matter, only that it is beyond.
    #[allow(
        clippy::cast_precision_loss,
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss
    )]
    let frames = frames.clamp(1.0, (MAX_FRAMES + 1) as f64) as usize;
    Ok(State {
        mean_speed,
        frames,
        hold: this.hold as usize,
        constant_speed,
        curve_time: this.own.curve_time,
        ..state
    })
}
