//! What is computed of a document's path: lengths and frames, ups, spaces around it.

use glam::DVec3;

use super::editing::Document;
use super::set::orientation;
use crate::error::Result;
use vides_engine::path::{Sampler, Space, Timeline, UpVector, ahead, alignment};

impl Document {
    /// Calls `f` with the current lengths and frame counts.
    ///
    /// # Errors
    /// `ErrorKind::Memory`.
    pub fn timeline<R>(&self, f: impl FnOnce(&Timeline) -> R) -> Result<R> {
        Ok(self.plan.timeline(&self.content.path, f)?)
    }

    /// The camera's up at an orientation, roll included: a unit vector in world coordinates,
    /// perpendicular to the view.
    ///
    /// # Errors
    /// `ErrorKind::Range` if there is no such orientation; `ErrorKind::Memory`.
    pub fn up(&self, point: usize, orientation: usize) -> Result<DVec3> {
        let path = self.path();
        let here = self::orientation(path, point, orientation)?;
        if here.own.up == UpVector::Axis {
            let view = ahead::view(path, point, orientation);
            return Ok(path.space.up.up_from_roll(view, here.roll.to_radians()));
        }
        self.timeline(|timeline| alignment::up(path, timeline, point, orientation))
    }

    /// The path prepared for sampling.
    ///
    /// # Errors
    /// `ErrorKind::Memory`; `ErrorKind::Limit` for more than
    /// [`vides_engine::limits::MAX_FRAMES`] frames.
    pub fn sampler(&self) -> Result<&Sampler> {
        Ok(self.plan.sampler(&self.content.path)?)
    }

    /// The smallest space that holds the object, with a tenth to spare.
    ///
    /// # Errors
    /// As [`Space::around`].
    pub fn space_around_object(&self) -> Result<Space> {
        let object = self.content.info.object.iter();
        Ok(Space::around(
            object.map(|point| point.position),
            self.path().space.up,
        )?)
    }

    /// The smallest space that holds the path's curve, with a tenth to spare.
    ///
    /// # Errors
    /// As [`Space::around`]; [`vides_engine::Error::Memory`].
    pub fn space_around_path(&self) -> Result<Space> {
        self.space_around(std::iter::empty())
    }

    /// The smallest space that holds the path's curve and the object, with a tenth to spare.
    ///
    /// # Errors
    /// As [`Document::space_around_path`].
    pub fn space_around_all(&self) -> Result<Space> {
        let object = self.content.info.object.iter();
        self.space_around(object.map(|point| point.position))
    }

    /// How many of the path's points lie outside its space.
    #[must_use]
    pub fn points_outside(&self) -> usize {
        let (path, space) = (self.path(), self.path().space);
        let (low, high) = (space.low(), space.high());
        let places = path.points.iter().map(|point| point.position);
        let outside = |place: &DVec3| place.cmplt(low).any() || place.cmpgt(high).any();
        places.filter(outside).count()
    }

    fn space_around(&self, others: impl Iterator<Item = DVec3>) -> Result<Space> {
        self.timeline(|timeline| {
            // Dense enough that the spare tenth covers the curve between samples.
            let along = (0..timeline.segment_count()).flat_map(|segment| {
                (0..=16).map(move |k| timeline.curve(segment).point(f64::from(k) / 16.0))
            });
            Ok(Space::around(along.chain(others), self.path().space.up)?)
        })?
    }
}
