//! A path made in one expression.

use glam::DVec3;

use super::camera_path::{CameraPath, CurveKind, SupportPoint, Target};
use super::fit_frames::fit_frames;
use super::sampling::Sampler;
use super::space::{Space, Up};
use super::timeline::Timeline;
use crate::error::Result;

/// A path in the making: [`CameraPath::through`] begins it, [`Builder::build`] checks and gives it.
#[derive(Debug, Clone)]
#[must_use = "a path comes of build()"]
pub struct Builder {
    points: Vec<DVec3>,
    target: Option<DVec3>,
    space: Option<Space>,
    up: Up,
    zoom: Option<f64>,
    closed: bool,
    curve: CurveKind,
    frames: Option<usize>,
}

impl Builder {
    /// Every camera looks at this place; without it along −z, or −x if z is up.
    pub const fn looking_at(mut self, target: DVec3) -> Self {
        self.target = Some(target);
        self
    }

    /// Where the path lies; without it the smallest cube round its points and its target, with a
    /// tenth to spare. It has its own up axis: [`Builder::up`] is then ignored.
    pub const fn in_space(mut self, space: Space) -> Self {
        self.space = Some(space);
        self
    }

    /// Which axis is up; without it y.
    pub const fn up(mut self, up: Up) -> Self {
        self.up = up;
        self
    }

    /// The zoom of all cameras in mm, 1…2000; without it 24.
    pub const fn zoom(mut self, zoom: f64) -> Self {
        self.zoom = Some(zoom);
        self
    }

    /// Leads from the last point back to the first.
    pub const fn closed(mut self) -> Self {
        self.closed = true;
        self
    }

    /// How the curve leads through the points.
    pub const fn curve(mut self, curve: CurveKind) -> Self {
        self.curve = curve;
        self
    }

    /// How many poses there are from the first point to the last one (or round to the first again),
    /// at least one for each point; without it what the base speeds give.
    pub const fn frames(mut self, frames: usize) -> Self {
        self.frames = Some(frames);
        self
    }

    /// The path.
    ///
    /// # Errors
    /// What is wrong with it, as [`CameraPath::check`]; [`crate::Error::Argument`] if all points are
    /// one place and no space is given; [`crate::Error::Range`] for too few frames.
    pub fn build(self) -> Result<CameraPath> {
        let space = match self.space {
            Some(space) => space,
            None => Space::around(self.points.iter().copied().chain(self.target), self.up)?,
        };
        let mut path = CameraPath::of_points(Vec::new());
        (path.space, path.closed, path.curve) = (space, self.closed, self.curve);
        path.points.try_reserve(self.points.len())?;
        for position in self.points {
            let mut point = SupportPoint::try_new_in(position, space)?;
            let camera = &mut point.orientations[0];
            camera.target = self.target.map_or(camera.target, Target::Absolute);
            camera.zoom = self.zoom.unwrap_or(camera.zoom);
            path.points.push(point);
        }
        path.check()?;
        if let Some(frames) = self.frames {
            let last = path.points.len() - 1;
            for fixed in fit_frames(&path, &Timeline::new(&path)?, 0, last, frames)? {
                fixed.apply(&mut path)?;
            }
        }
        Ok(path)
    }
}

impl CameraPath {
    /// Begins a path through these places.
    ///
    /// ```
    /// use glam::DVec3;
    /// use vides_engine::path::CameraPath;
    ///
    /// # fn main() -> vides_engine::Result<()> {
    /// let corners = [[5.0, 2.0, 0.0], [0.0, 3.0, 5.0], [-5.0, 2.0, 0.0]].map(DVec3::from);
    /// let path = CameraPath::through(corners).looking_at(DVec3::ZERO).frames(100).build()?;
    /// let poses = path.sampler()?.iter().collect::<Result<Vec<_>, _>>()?;
    /// assert_eq!(poses.len(), 100);
    /// assert_eq!(poses[99].vrp, [-5.0, 2.0, 0.0]);
    /// # Ok(())
    /// # }
    /// ```
    pub fn through(points: impl IntoIterator<Item = DVec3>) -> Builder {
        Builder {
            points: points.into_iter().collect(),
            target: None,
            space: None,
            up: Up::Y,
            zoom: None,
            closed: false,
            curve: CurveKind::default(),
            frames: None,
        }
    }

    /// The path prepared for sampling.
    ///
    /// # Errors
    /// [`crate::Error::Memory`]; [`crate::Error::Limit`] for too many frames.
    pub fn sampler(&self) -> Result<Sampler> {
        Sampler::new(self, &Timeline::new(self)?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::error::Error;
    use crate::path::Pose;

    #[test]
    fn a_path_is_made_as_it_was_told() {
        let places = [DVec3::X, DVec3::Z, DVec3::NEG_X];
        let path = CameraPath::through(places)
            .looking_at(DVec3::ZERO)
            .up(Up::Z)
            .zoom(50.0)
            .closed()
            .curve(CurveKind::Cubic)
            .frames(60)
            .build()
            .unwrap();
        assert_eq!(path.space.up, Up::Z);
        assert_eq!(path.space.half_size, 1.1);
        let sampler = path.sampler().unwrap();
        let poses: Vec<_> = sampler.iter().map(Result::unwrap).collect();
        assert_eq!(
            (poses.len(), sampler.iter().len(), path.segment_count()),
            (60, 60, 3)
        );
        let mut all = vec![Pose::default(); 60];
        sampler.sample(1, &mut all).unwrap();
        assert_eq!(poses, all);
        for pose in poses {
            let towards = -DVec3::from(pose.vrp).normalize();
            assert!(towards.dot(pose.view()) > 0.999, "{pose:?}");
            assert_eq!(pose.zoom, 50.0);
        }
    }

    #[test]
    fn what_cannot_be_is_refused() {
        let places = [DVec3::ZERO, DVec3::X];
        let at_a_point = CameraPath::through(places).looking_at(DVec3::X).build();
        assert!(matches!(
            at_a_point,
            Err(Error::At(..) | Error::Argument(_))
        ));
        assert!(CameraPath::through([DVec3::ZERO; 2]).build().is_err());
        assert!(
            CameraPath::through([DVec3::X])
                .in_space(Space::default())
                .build()
                .is_err()
        );
        assert!(CameraPath::through([DVec3::NAN, DVec3::X]).build().is_err());
        assert!(CameraPath::through(places).frames(1).build().is_err());
        assert!(CameraPath::through(places).zoom(0.5).build().is_err());
    }
}
