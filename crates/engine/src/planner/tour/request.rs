//! What is asked of a tour, and what it tells.

use std::fmt;

use glam::DVec3;

use crate::error::{Invalid, OutOfRange, Result};
use crate::path::{CameraPath, Space, Up};
use crate::tools::check::Limits;

/// What is asked for.
#[derive(Debug, Clone, Copy)]
pub struct TourRequest {
    /// Seconds of the flight, > 0.
    pub seconds: f64,
    /// Share, by area, of the surface that can be seen: greater than 0, at most 1.
    pub coverage: f64,
    /// How far the camera is from the object where it shows it; 0: found, so that the whole of it
    /// is in the picture, or by how much room there is inside.
    pub distance: f64,
    /// In the object's free space, not around it.
    pub inside: bool,
    /// Where the flight begins; none: it is a closed round.
    pub start: Option<DVec3>,
    /// The up axis.
    pub up: Up,
    /// The space of the path, if that holds the flight; none: the smallest round flight and object.
    pub space: Option<Space>,
    /// One frame for each view, not a flight.
    pub stills: bool,
    /// Limits of the pace, those of a check.
    pub limits: Limits,
    /// Frames a second.
    pub fps: f64,
}

impl Default for TourRequest {
    /// A minute that shows 0.95 from outside.
    fn default() -> Self {
        Self {
            seconds: 60.0,
            coverage: 0.95,
            distance: 0.0,
            inside: false,
            start: None,
            up: Up::Y,
            space: None,
            stills: false,
            limits: Limits::default(),
            fps: 25.0,
        }
    }
}

/// A flight, and what it shows. Shares are of areas.
#[derive(Debug)]
pub struct Tour {
    /// The path.
    pub path: CameraPath,
    /// The share that its places show of what can be seen from anywhere outside or, inside, from
    /// anywhere that is reached.
    pub coverage: f64,
    /// The share that they show of the whole surface.
    pub surface: f64,
    /// How many places show it.
    pub places: usize,
    /// The distance from the object that was found or given.
    pub distance: f64,
    /// The length of the way.
    pub length: f64,
    /// Seconds, a whole number of frames.
    pub seconds: f64,
    /// Of the whole surface what is seen from places that were tried but not taken,
    pub left_out: f64,
    /// what might be seen, but from none of the places that were tried,
    pub narrow: f64,
    /// and what cannot be seen.
    pub hidden: f64,
}

/// English sentences, a line each.
impl fmt::Display for Tour {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let percent = |share: f64| format!("{:.1} %", 100.0 * share);
        let places = if self.places == 1 {
            "place shows"
        } else {
            "places show"
        };
        writeln!(
            f,
            "{} {places} {} of the surface that can be seen, from a distance of {:.4}; {:.4} long, {:.3} s",
            self.places,
            percent(self.coverage),
            self.distance,
            self.length,
            self.seconds
        )?;
        write!(
            f,
            "of the whole surface {} is shown, {} is seen from places that were not needed, {} only \
             from nearer, through gaps or at a grazing angle, {} from nowhere",
            percent(self.surface),
            percent(self.left_out),
            percent(self.narrow),
            percent(self.hidden)
        )
    }
}

impl TourRequest {
    pub(super) fn check(&self) -> Result<()> {
        if !(self.seconds > 0.0 && self.seconds.is_finite()) {
            return Err(Invalid::PaceTime.into());
        }
        if !(self.coverage > 0.0 && self.coverage <= 1.0) {
            return Err(OutOfRange::Coverage.into());
        }
        if !(self.distance >= 0.0 && self.distance.is_finite()) {
            return Err(OutOfRange::TourDistance.into());
        }
        if let Some(start) = self.start
            && !start.is_finite()
        {
            return Err(Invalid::TourStart.into());
        }
        Ok(())
    }
}
