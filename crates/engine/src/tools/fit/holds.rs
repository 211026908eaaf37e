//! Rests of any length.

use glam::DVec3;

use super::piece::{rest, whole};
use super::{Data, Joint, Piece, Sample};
use crate::error::{Result, vec_with_room};
use crate::limits::{MAX_HOLD, MIN_ZOOM};
use crate::path::{CameraPath, SupportPoint, own};

/// By how much the zoom changes between two rests as long as one may be.
const CREEP: f64 = 1e-6;

impl Piece {
    /// A frame in which the zoom changes by what no eye sees, since without any change there is none.
    pub(super) fn creep(from: Sample) -> Result<Self> {
        let change = if from.zoom > 2.0 * MIN_ZOOM {
            -CREEP
        } else {
            CREEP
        };
        let joint = Joint {
            sample: from,
            zoom_slope: None,
            bend: DVec3::ZERO,
        };
        Ok(Self {
            end: Sample {
                zoom: from.zoom + change,
                ..from
            },
            pace: own::distance(&[[0.0, 0.0], [1.0, 1.0]])?,
            zoom_slopes: [change; 2],
            holds: false,
            ..rest(1.0, joint)
        })
    }
}

impl Data {
    /// Two equal points, as a path has at least two, or as many as the length of the rest needs.
    pub(super) fn standing(&self, frames: f64) -> Result<CameraPath> {
        let start = self.calm[0];
        let mut points = vec_with_room(2)?;
        points.push(self.point(&start, 0, [None; 2])?);
        self.rest(&mut points, start, whole(frames), [None; 2])?;
        let mut path = CameraPath::try_new()?;
        path.points = points.into();
        path.space = self.space;
        path.check()?;
        Ok(path)
    }

    /// Adds a point that rests for those frames between two pieces: several, with nearly nothing
    /// between them, where one may not rest as long.
    pub(super) fn rest(
        &self,
        points: &mut Vec<SupportPoint>,
        mut at: Sample,
        mut frames: u32,
        [before, after]: [Option<&Piece>; 2],
    ) -> Result<()> {
        let mut crept: Option<Piece> = None;
        while frames > MAX_HOLD {
            let creep = Piece::creep(at)?;
            let pieces = [crept.as_ref().or(before), Some(&creep)];
            points.try_reserve(1)?;
            points.push(self.point(&at, MAX_HOLD, pieces)?);
            frames -= MAX_HOLD + creep.frames;
            at = creep.end;
            crept = Some(creep);
        }
        points.try_reserve(1)?;
        points.push(self.point(&at, frames, [crept.as_ref().or(before), after])?);
        Ok(())
    }
}
