//! What a tool makes of its numbers.

use super::*;
use vides_engine::path::change_up::change_up;

/// A tool's numbers by parameter name.
pub(super) struct ToolArguments<'a> {
    tool: &'a Tool,
    numbers: &'a [f64],
    document: &'a Document,
}

/// A number already checked to be a small whole one.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
pub(super) fn chosen(number: f64) -> usize {
    number as usize
}

impl<'a> ToolArguments<'a> {
    pub(super) const fn new(tool: &'a Tool, document: &'a Document, numbers: &'a [f64]) -> Self {
        Self {
            tool,
            numbers,
            document,
        }
    }

    pub(super) fn of(&self, name: &str) -> &[f64] {
        let start = self.tool.place_of(name);
        start.map_or(&[], |start| self.numbers.get(start..).unwrap_or_default())
    }

    pub(super) fn number(&self, name: &str) -> f64 {
        self.of(name).first().copied().unwrap_or_default()
    }

    pub(super) fn place(&self, name: &str) -> DVec3 {
        match *self.of(name) {
            [x, y, z, ..] => DVec3::new(x, y, z),
            _ => DVec3::ZERO,
        }
    }

    pub(super) fn axis(&self) -> DVec3 {
        let mut axis = DVec3::ZERO;
        axis[chosen(self.number(AXIS.name)).min(2)] = 1.0;
        axis
    }

    pub(super) fn points(&self) -> Result<Vec<usize>> {
        let [first, last] = [FIRST, LAST].map(|end| chosen(self.number(end.name)));
        if first > last {
            return Err(OutOfRange::PointOrder {
                first: first - 1,
                last: last - 1,
            }
            .into());
        }
        let count = self.document.path().points.len();
        if last > count {
            return Err(OutOfRange::NumberBetween(LAST.name, 1.0, count as f64).into());
        }
        Ok((first - 1..last).collect())
    }

    /// The first and the last point, from 0; on a closed path also over its seam.
    pub(super) fn ends(&self) -> [usize; 2] {
        [FIRST, LAST].map(|end| chosen(self.number(end.name)).saturating_sub(1))
    }

    pub(super) fn retimed(&self, progress: Progress<'_>) -> Result<Made> {
        let info = self.document.info();
        let request = Request {
            limits: info.limits,
            fps: info.fps,
            points: Some(self.ends()),
            seconds: self.number("seconds"),
        };
        let made = retime(self.document.path(), &request, progress)?;
        let lines = made.rests.iter().copied().map(Line::Rest).collect();
        Ok(Made::path(made.path, &[("seconds", made.seconds)], lines))
    }

    pub(super) fn steadied(&self, progress: Progress<'_>) -> Result<Made> {
        let request = SteadyRequest {
            period: self.number("period"),
            within: self.number("within"),
            fps: self.document.info().fps,
        };
        let made = steady(self.document.path(), &request, progress)?;
        let line = Line::Steadied(made.furthest, made.turned);
        let numbers = [("furthest", made.furthest), ("turned", made.turned)];
        Ok(Made::path(made.path, &numbers, vec![line]))
    }

    pub(super) fn avoiding(&self, material: &ToolInput, progress: Progress<'_>) -> Result<Made> {
        let request = AvoidRequest {
            clearance: self.number("clearance"),
            radius: self.number("radius"),
        };
        let object = material.object_or_own(self.document)?;
        let made = avoid_object(self.document.path(), &object, &request, progress)?;
        let sum = |of: fn(&AvoidedPart) -> usize| made.parts.iter().map(of).sum::<usize>() as f64;
        let furthest = made.parts.iter().map(|part| part.furthest);
        let numbers = [
            ("parts", made.parts.len() as f64),
            ("moved", sum(|part| part.moved)),
            ("inserted", sum(|part| part.inserted)),
            ("furthest", furthest.fold(0.0, f64::max)),
        ];
        let lines = made.parts.iter().copied().map(Line::Avoided).collect();
        Ok(Made::path(made.path, &numbers, lines))
    }

    /// The points that a fit may have; none: those that its tolerance needs.
    pub(super) fn points_of_fit(&self) -> Option<usize> {
        let points = chosen(self.number("points"));
        (matches!(self.tool.kind, Kind::Fit) && points > 0).then_some(points)
    }

    pub(super) fn fitted(
        &self,
        (poses, seconds, up): (&[Pose], Option<&[f64]>, Up),
        progress: Progress<'_>,
    ) -> Result<(CameraPath, FitResult)> {
        let tolerance = Tolerance {
            position: self.number("tolerance"),
            angle: self.number("angle"),
        };
        let options = Options {
            robust: self.number("robust") != 0.0,
            ..tolerance.into()
        };
        let CameraPath {
            space, base_frames, ..
        } = *self.document.path();
        let options = in_space(options, poses, Space { up, ..space });
        let fps = self.document.info().fps;
        let (made, tolerance) = match self.points_of_fit() {
            Some(points) => fit_points(poses, seconds, fps, &options, points, progress)?,
            None => (fit(poses, seconds, fps, &options, progress)?, tolerance),
        };
        let Fitted {
            mut path,
            left_out,
            report,
            deviations,
        } = made;
        path.base_frames = base_frames;
        // A part of a film has its up axis.
        if chosen(self.number("put")) > 0 {
            path = change_up(&path, space.up)?;
        }
        let result = FitResult {
            tolerance,
            report,
            deviations,
            left_out,
        };
        Ok((path, result))
    }

    /// A flight round the object, and what it is besides the edit.
    pub(super) fn tour(
        &self,
        material: &ToolInput,
        progress: Progress<'_>,
    ) -> Result<(CameraPath, Made)> {
        let (space, info) = (self.document.path().space, self.document.info());
        let (mesh, start) = match material {
            ToolInput::Tour(mesh, start) => (mesh.as_deref(), *start),
            _ => (None, None),
        };
        let request = TourRequest {
            seconds: self.number("seconds"),
            coverage: self.number("coverage"),
            distance: self.number("distance"),
            inside: self.number("inside") != 0.0,
            start,
            up: space.up,
            space: Some(space),
            stills: false,
            limits: info.limits,
            fps: info.fps,
        };
        let mut made = match mesh {
            Some(mesh) => tour(mesh, &request, progress)?,
            None => {
                let own = self.document.obstacles()?.unwrap_or_default();
                tour(&own, &request, progress)?
            }
        };
        let path = std::mem::take(&mut made.path);
        let numbers = [
            ("coverage", made.coverage),
            ("places", made.places as f64),
            ("distance", made.distance),
            ("length", made.length),
            ("seconds", made.seconds),
        ];
        let made = Made {
            numbers: numbers.to_vec(),
            lines: vec![Line::Tour(Box::new(made))],
            ..Made::from(None)
        };
        Ok((path, made))
    }

    pub(super) fn places(&self) -> Result<Vec<DVec3>> {
        let all = &self.document.path().points;
        let points = self.points()?;
        Ok(points.iter().map(|&at| all[at].position).collect())
    }

    /// On a closed path also over its seam.
    pub(super) fn extracted(&self) -> Result<CameraPath> {
        let [first, last] = self.ends();
        Ok(block::extract(self.document.path(), first, last)?)
    }

    /// The point that stays fixed.
    pub(super) fn about(&self, points: &[usize]) -> DVec3 {
        let path = self.document.path();
        let here = self.document.selection();
        let current = path.points[here.point].position;
        match chosen(self.number(ABOUT.name)) {
            1 => DVec3::ZERO,
            2 => current,
            3 => no_longer_ahead(path, here.point, here.orientation).map_or(current, |seen| {
                match seen.target {
                    Target::Absolute(place) => place,
                    Target::Relative(offset) => current + offset,
                }
            }),
            _ => {
                let places = points.iter().map(|&at| path.points[at].position);
                places.sum::<DVec3>() / points.len() as f64
            }
        }
    }

    pub(super) fn placed(&self, scale: DVec3, angle: f64, by: DVec3) -> Result<Edit> {
        let points = self.points()?;
        let turn = DQuat::from_axis_angle(self.axis(), angle);
        Ok(Edit::TransformPoints {
            matrix: transform::matrix(self.about(&points), scale, turn, by),
            points,
            with_targets: self.number(SEEN.name) != 0.0,
        })
    }
}
