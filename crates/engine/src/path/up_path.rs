//! A second path, to whose places a camera's up points.

use std::sync::Arc;

use glam::DVec3;

use super::chain::Chain;
use super::cube::Space;
use super::dispatch;
use super::hermite::Cubic;
use crate::error::{OutOfRange, Result, TooMany, try_arc, vec_with_room};
use crate::limits;
use crate::property::same_bits::SameBits;

/// A point of an up path, and the curve's derivatives there, per segment parameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct UpPathPoint {
    /// Where it is.
    pub position: DVec3,
    /// With which the curve reaches it.
    pub before: DVec3,
    /// With which the curve leaves it.
    pub after: DVec3,
}

impl SameBits for UpPathPoint {
    fn same_bits(&self, other: &Self) -> bool {
        let vectors = |point: &Self| [point.position, point.before, point.after];
        vectors(self)[..].same_bits(&vectors(other)[..])
    }
}

/// A second path of which only the curve counts. A closed one ends where it begins.
#[derive(Debug, Clone, PartialEq)]
pub struct UpPath {
    points: Vec<UpPathPoint>,
    chain: Chain,
}

impl UpPath {
    /// The curve through these points.
    ///
    /// # Errors
    /// [`crate::Error::Range`] for fewer than two, [`crate::Error::Limit`] for more than
    /// [`limits::MAX_UP_PATH_POINTS`]; [`crate::Error::Memory`].
    pub fn new(points: Vec<UpPathPoint>) -> Result<Arc<Self>> {
        if points.len() < limits::MIN_POINTS {
            return Err(OutOfRange::TooFewSupportPoints.into());
        }
        if points.len() > limits::MAX_UP_PATH_POINTS {
            return Err(TooMany::UpPathPoints.into());
        }
        let chain = Chain::new(points.windows(2).map(|pair| {
            let (a, b) = (&pair[0], &pair[1]);
            let curve = Cubic::hermite(a.position, b.position, a.after, b.before);
            (curve, dispatch::length(&curve))
        }))?;
        try_arc(Self { points, chain })
    }

    /// Its points.
    #[must_use]
    pub fn points(&self) -> &[UpPathPoint] {
        &self.points
    }

    /// The other way round.
    ///
    /// # Errors
    /// [`crate::Error::Memory`].
    pub fn reversed(&self) -> Result<Arc<Self>> {
        let mut points = vec_with_room(self.points.len())?;
        points.extend(self.points.iter().rev().map(|point| UpPathPoint {
            position: point.position,
            before: -point.after,
            after: -point.before,
        }));
        Self::new(points)
    }

    pub(super) fn check(&self, space: Space) -> Result<()> {
        for point in &self.points {
            space.check_place(point.position)?;
            space.check_offset(point.before)?;
            space.check_offset(point.after)?;
        }
        Ok(())
    }

    /// The place at a share of its length, 0 to 1.
    pub(super) fn place(&self, share: f64) -> DVec3 {
        let place = self.chain.place(share * self.chain.length());
        place.unwrap_or(self.points[0].position)
    }
}
