//! One section that has frames, ready to be sampled. What is here is the plain
//! way to a pose: Newton's method on the arc length, arcs by sines. The fast
//! way in [`super::fill`] is measured against it.

use std::sync::OnceLock;

use glam::DVec3;

use super::arc_length::ArcLength;
use super::hermite::Cubic;
use super::orientation_curve::Turning;
use super::pose::Pose;
use super::speed_curve::SpeedCurve;
use super::tables::Tables;
use crate::error::Result;

/// The curve of a section and its length.
#[derive(Debug, Clone, Copy)]
pub(super) struct Way {
    pub curve: Cubic,
    pub length: f64,
}

/// One section that has frames.
#[derive(Debug)]
pub(super) struct Leg {
    /// Number of the last pose before its own: the key in which it begins.
    pub start: usize,
    /// Its frames, ≥ 1; the last one is the key in which it ends.
    pub frames: usize,
    /// None where the speed is constant.
    pub speed: Option<Box<[SpeedCurve]>>,
    /// Where the camera moves; None where it stays at `position`.
    pub way: Option<Way>,
    pub position: DVec3,
    pub turning: Turning,
    /// Zoom in powers of φ.
    pub zoom: [f64; 4],
    /// What fast sampling prepares once, if the section has many frames.
    pub tables: OnceLock<Tables>,
}

impl Leg {
    /// φ at `u` = frame / frames: share of the way and of the curve time.
    pub(super) fn phi(&self, u: f64) -> f64 {
        self.speed.as_ref().map_or(u, |speed| speed[0].fraction(u))
    }

    /// The pose at φ.
    pub(super) fn pose(&self, phi: f64) -> Result<Pose> {
        let arc = match &self.way {
            Some(way) => Some(ArcLength::new(&way.curve)?),
            None => None,
        };
        let place = |phi: f64| match (&self.way, &arc) {
            (Some(way), Some(arc)) => way.curve.point(arc.parameter_at(phi * arc.length())),
            _ => self.position,
        };
        let (view, up) = self.turning.view_at(phi, &place);
        let c = &self.zoom;
        Ok(Pose {
            vrp: place(phi).to_array(),
            vpn: view.to_array(),
            vup: up.to_array(),
            zoom: ((c[3] * phi + c[2]) * phi + c[1]) * phi + c[0],
        })
    }
}
