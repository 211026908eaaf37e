//! An object kept whole in the picture all along a path: by the zoom, by the distance, or by turning
//! the view (`docs/planning.md`, picture).

mod below;
mod film;
mod outline;
mod zoom;

use crate::error::{Invalid, OutOfRange, Result};
use crate::path::CameraPath;
use crate::property::choices;
use crate::scene::Mesh;
use crate::tools::check::Limits;
use crate::tools::clearance::Clearance;
use film::Film;
use outline::{Camera, FILM, Outline};

choices! {
    /// By what an object is kept in the picture.
    pub enum What {
        /// By the zoom.
        #[default]
        Zoom = "zoom",
    }
}

/// What is asked for.
#[derive(Debug, Clone, Copy)]
pub struct PictureRequest {
    /// The share of the picture's width, and of its height, that stays free at each side: 0 ≤ margin
    /// < 0.5.
    pub margin: f64,
    /// What may change.
    pub what: What,
    /// Limits, those of a check.
    pub limits: Limits,
    /// Frames a second, positive.
    pub fps: f64,
}

/// A path with an object in its picture.
#[derive(Debug)]
pub struct Framed {
    /// The path.
    pub path: CameraPath,
    /// Points that were added to the curve.
    pub added: usize,
    /// The greatest share of the room within the margins that the object takes at any time: at most
    /// 1.
    pub tightest: f64,
    /// The least share.
    pub loosest: f64,
}

/// A path already as tight as this is left as it is.
const TIGHT: f64 = 0.99;

/// So much less than all of the room is aimed at, for what lies between samples.
const SPARE: f64 = 1e-5;

/// Keeps an object whole in the picture less margin, at every frame and between.
///
/// # Errors
/// [`crate::Error::Argument`] where it cannot be, with the frame; [`crate::Error::Range`] for a
/// margin or frames a second out of range; as [`Clearance::new`]; [`crate::Error::Limit`],
/// [`crate::Error::Memory`].
pub fn keep_in_picture(
    path: &CameraPath,
    object: &Mesh,
    request: &PictureRequest,
) -> Result<Framed> {
    request.check()?;
    keep_all_in_picture(path, &Clearance::new(object)?, request)
}

/// As [`keep_in_picture`], with a tree that is there.
///
/// # Errors
/// As [`keep_in_picture`].
pub fn keep_all_in_picture(
    path: &CameraPath,
    object: &Clearance,
    request: &PictureRequest,
) -> Result<Framed> {
    request.check()?;
    path.check()?;
    let mut work = Work {
        request,
        room: FILM.map(|film| film * (1.0 - 2.0 * request.margin)),
        outline: Outline::new(object),
    };
    let film = Film::new(path, request.fps)?;
    let (tightest, loosest) = work.shares(&film);
    if (TIGHT..=1.0).contains(&tightest) {
        return Ok(Framed {
            path: path.try_clone()?,
            added: 0,
            tightest,
            loosest,
        });
    }
    match request.what {
        What::Zoom => work.by_zoom(path, &film),
    }
}

impl PictureRequest {
    fn check(&self) -> Result<()> {
        if !(0.0..0.5).contains(&self.margin) {
            return Err(Invalid::PictureMargin.into());
        }
        if !(self.fps > 0.0 && self.fps <= crate::limits::MAX_FPS) {
            return Err(OutOfRange::Fps.into());
        }
        Ok(())
    }
}

struct Work<'a> {
    request: &'a PictureRequest,
    /// Half of the picture less margin to each side, in mm.
    room: [f64; 4],
    outline: Outline<'a>,
}

impl Work<'_> {
    /// The greatest zoom with which all of the object is in the room; none where not all is before
    /// the camera. Infinite for a single place in the middle.
    fn zoom_for(&mut self, camera: &Camera) -> Option<f64> {
        let reach = self.outline.reach(camera)?;
        let sides = reach.iter().zip(self.room);
        let least = sides.map(|(reach, room)| room / reach.max(0.0));
        Some(least.fold(f64::INFINITY, f64::min))
    }

    /// The greatest and the least share of the room that the object takes; infinite where not all of
    /// it is before the camera.
    fn shares(&mut self, film: &Film) -> (f64, f64) {
        let mut shares = (0.0_f64, f64::INFINITY);
        for spot in &film.spots {
            let share = self
                .zoom_for(&spot.camera)
                .map_or(f64::INFINITY, |most| spot.zoom / most);
            shares = (shares.0.max(share), shares.1.min(share));
        }
        shares
    }
}

#[cfg(test)]
#[path = "picture_tests.rs"]
mod tests;
