//! An object kept whole in the picture all along a path: by the zoom, by the distance, or by turning
//! the view (`docs/reference/planning.md`, picture).

mod below;
mod film;
mod keyed;
mod outline;
mod zoom;

use crate::error::{Invalid, OutOfRange, Result};
use crate::limits::{MAX_ZOOM, MIN_ZOOM};
use crate::path::{CameraPath, Orientation, Target, UpVector};
use crate::property::choices;
use crate::scene::Mesh;
use crate::tools::check::Limits;
use crate::tools::clearance::Clearance;
use crate::tools::fit::Progress;
use crate::tools::watch::Watch;
use film::{Film, Spot};
use outline::{Camera, FILM, Outline};

/// What is left free at each side of a picture where nothing else is asked for.
pub const DEFAULT_MARGIN: f64 = 0.1;

choices! {
    /// By what an object is kept in the picture.
    pub enum What {
        /// By the zoom.
        #[default]
        Zoom = "zoom",
        /// By moving the camera along its view.
        Distance = "distance",
        /// By turning the camera.
        View = "view",
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

/// The margin that is left for what lies between samples.
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
    keep_all_in_picture(path, &Clearance::new(object)?, request, &mut |_, _| true)
}

/// As [`keep_in_picture`], with a tree that is there; `progress` gets places along the path that were
/// looked at and all, starting over in each round, and ends it with `false`.
///
/// # Errors
/// As [`keep_in_picture`]; [`crate::Error::Argument`] where `progress` ends it.
pub fn keep_all_in_picture(
    path: &CameraPath,
    object: &Clearance,
    request: &PictureRequest,
    progress: Progress<'_>,
) -> Result<Framed> {
    request.check()?;
    path.check()?;
    let film = Film::new(path, request.fps)?;
    let watch = Watch::new(progress);
    let framed = Work::new(object, request, &watch)?.framed(path, &film);
    watch.check()?;
    framed
}

/// One orientation that looks at the middle of an object and shows it whole, as large as the margin
/// allows.
///
/// # Errors
/// [`crate::Error::Argument`] where no zoom shows it, [`crate::Error::Range`] for no such
/// orientation or a margin out of range; [`crate::Error::Memory`].
pub fn orientation_towards(
    path: &CameraPath,
    (point, orientation): (usize, usize),
    object: &Clearance,
    margin: f64,
) -> Result<Orientation> {
    let request = PictureRequest {
        margin,
        what: What::Zoom,
        limits: Limits::default(),
        fps: 25.0,
    };
    request.check()?;
    let support = path.points.get(point).ok_or_else(|| path.no_point(point))?;
    let known = support.orientations.get(orientation);
    let mut one = known.ok_or(OutOfRange::Orientations)?.clone();
    let go_on = &mut |_, _| true;
    let watch = Watch::new(go_on);
    let mut work = Work::new(object, &request, &watch)?;
    let middle = work.outline.middle();
    let far = middle - support.position;
    let view = far.try_normalize().ok_or(Invalid::TargetOnCamera)?;
    let level = one.own.up.level(path.space.up);
    let axis = level.unwrap_or(path.space.up);
    let camera = Camera {
        eye: support.position,
        view,
        up: axis.up_from_roll(view, one.roll.to_radians()),
    };
    let behind = Invalid::PictureHere { zoom: 0.0 };
    let most = work.zoom_for(&camera).ok_or(behind)?;
    if most < MIN_ZOOM {
        return Err(Invalid::PictureHere { zoom: most }.into());
    }
    one.target = Target::Absolute(middle);
    one.zoom = ((1.0 - SPARE) * most).clamp(MIN_ZOOM, MAX_ZOOM);
    one.own = one.own.with(|own| {
        own.ahead = None;
        own.velocities = None;
        own.turning = None;
        own.zoom_slope = None;
        if level.is_none() {
            own.up = UpVector::Axis;
        }
    })?;
    Ok(one)
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
    outline: Outline,
    watch: &'a Watch<'a>,
}

impl<'a> Work<'a> {
    fn new(object: &Clearance, request: &'a PictureRequest, watch: &'a Watch<'a>) -> Result<Self> {
        Ok(Self {
            request,
            room: FILM.map(|film| film * (1.0 - 2.0 * request.margin)),
            outline: Outline::new(object)?,
            watch,
        })
    }

    fn framed(&mut self, path: &CameraPath, film: &Film) -> Result<Framed> {
        let (tightest, loosest) = self.shares(film);
        let fits = tightest <= 1.0;
        if fits && (tightest >= TIGHT || self.request.what == What::View) {
            return Ok(Framed {
                path: path.try_clone()?,
                added: 0,
                tightest,
                loosest,
            });
        }
        match self.request.what {
            What::Zoom => self.by_zoom(path, film),
            What::Distance => {
                let [min, max] = self.outline.bounds();
                if min == max {
                    return Err(Invalid::PicturePlace.into());
                }
                self.by_keys(path, film)
            }
            What::View => self.by_keys(path, film),
        }
    }

    /// The greatest zoom with which all of the object is in the room; none where not all is before
    /// the camera, and when the work does not go on. Infinite for a single place in the middle.
    fn zoom_for(&mut self, camera: &Camera) -> Option<f64> {
        if !self.watch.goes_on() {
            return None;
        }
        let reach = self.outline.reach(camera)?;
        let sides = reach.iter().zip(self.room);
        // A reach of -0.0 would make it -inf.
        let least = sides.map(|(reach, room)| room / reach.max(0.0).abs());
        Some(least.fold(f64::INFINITY, f64::min))
    }

    /// The share of the room that the object takes at a sample.
    fn share(&mut self, spot: &Spot) -> f64 {
        let most = self.zoom_for(&spot.camera);
        most.map_or(f64::INFINITY, |most| spot.zoom / most)
    }

    /// The greatest share, and its frame.
    fn worst(&mut self, film: &Film) -> (f64, f64) {
        let mut worst = (0.0, 1.0);
        for spot in &film.spots {
            let share = self.share(spot);
            if share > worst.0 {
                worst = (share, spot.frame);
            }
        }
        worst
    }

    /// The greatest and the least share of the room that the object takes; infinite where not all of
    /// it is before the camera.
    fn shares(&mut self, film: &Film) -> (f64, f64) {
        let mut shares = (0.0_f64, f64::INFINITY);
        for spot in &film.spots {
            let share = self.share(spot);
            shares = (shares.0.max(share), shares.1.min(share));
        }
        shares
    }
}

#[cfg(test)]
#[path = "picture_tests.rs"]
mod tests;
