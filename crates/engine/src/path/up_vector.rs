//! Up vectors of whole paths, and paths that become up paths.

use std::sync::Arc;

use super::camera_path::{CameraPath, SupportPoint};
use super::cube::Space;
use super::curve;
use super::own_parts::Tangents;
pub use super::up::UpVector;
pub use super::up_path::{UpPath, UpPathPoint};
use crate::error::{Invalid, Result, TooMany, vec_with_room};
use crate::limits;

impl UpPath {
    /// The curve of a path.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub fn of(path: &CameraPath) -> Result<Arc<Self>> {
        let count = path.points.len() + usize::from(path.closed);
        if count > limits::MAX_UP_PATH_POINTS {
            return Err(TooMany::UpPathPoints.into());
        }
        let mut points = vec_with_room(count)?;
        for at in 0..count {
            let at = at % path.points.len();
            let tangents = curve::tangents(path, at);
            points.push(UpPathPoint {
                position: path.points[at].position,
                before: tangents.before,
                after: tangents.after,
            });
        }
        Self::new(points)
    }

    /// A path of which [`Self::of`] makes this curve.
    ///
    /// # Errors
    /// [`crate::Error::Memory`].
    pub fn as_path(&self, space: Space) -> Result<CameraPath> {
        let mut points = vec_with_room(self.points().len())?;
        for point in self.points() {
            points.push(SupportPoint {
                tangents: Some(Tangents {
                    before: point.before,
                    after: point.after,
                }),
                ..SupportPoint::try_new(point.position)?
            });
        }
        Ok(CameraPath {
            points: points.into(),
            space,
            ..CameraPath::try_new()?
        })
    }
}

/// Checks that a path's ups are defined (the principal normal needs continuous curvature), and that
/// there are not too many up paths.
///
/// # Errors
/// [`crate::Error::Argument`] or [`crate::Error::Limit`].
pub fn check_ups(path: &CameraPath) -> Result<()> {
    let mut paths: [Option<&Arc<UpPath>>; limits::MAX_UP_PATHS] = [None; limits::MAX_UP_PATHS];
    let mut frenet = false;
    for orientation in path.points.iter().flat_map(|point| &point.orientations) {
        if orientation.own.is_empty() {
            continue;
        }
        match &orientation.own.up {
            UpVector::Frenet => frenet = true,
            UpVector::Path(new) => {
                let known =
                    |old: &&Arc<UpPath>| Arc::ptr_eq(old, new) || old.points() == new.points();
                if paths.iter().flatten().any(known) {
                    continue;
                }
                match paths.iter_mut().find(|place| place.is_none()) {
                    Some(place) => *place = Some(new),
                    None => return Err(TooMany::UpPaths.into()),
                }
            }
            _ => {}
        }
    }
    let smooth =
        || path.curve.is_spline() && path.points.iter().all(|point| point.tangents.is_none());
    if frenet && !smooth() {
        return Err(Invalid::NoNormal.into());
    }
    Ok(())
}
