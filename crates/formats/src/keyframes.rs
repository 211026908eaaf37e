//! Keys that a spline joins, as the viewer of nerfstudio has them: points of a path, or keys.

use vides_document::error::vec_with_room;
use vides_engine::limits::MAX_POINTS;
use vides_engine::path::arc_length::ArcLength;
use vides_engine::path::curve::{segment as segment_of, tangents};
use vides_engine::path::own::{Tangents, check_distance, distance};
use vides_engine::path::{
    CameraPath, CurveParameters, Orientation, Pace, Pose, Space, SupportPoint, Target, Tcb,
};

use super::error::Result;

/// Keys of the pace of a section.
const PACE_KEYS: usize = 17;

/// One for all sections: the viewer's curves have their knots at whole numbers.
const CURVE_TIME: f64 = 50.0;

/// Keys a second between two steps (Fritsch and Butland, as scipy's PCHIP has it).
fn inner_slope(before: f64, after: f64) -> f64 {
    let weights = [2.0 * after + before, after + 2.0 * before];
    (weights[0] + weights[1]) / (weights[0] * before + weights[1] * after)
}

/// The same at an end, beside the step `near`.
fn end_slope(near: f64, far: f64) -> f64 {
    (((2.0 * near + far) / near - near / far) / (near + far)).max(0.0)
}

/// Gives the ends of an open path the tangents of the viewer's: no curvature there, where ours are
/// parabolas.
fn end_naturally(path: &mut CameraPath) -> Result<()> {
    let last = path.points.len() - 1;
    if path.closed {
        return Ok(());
    }
    for (end, next) in [(0, 1), (last, last - 1)] {
        let sign = if end == 0 { 1.0 } else { -1.0 };
        let chord = sign * (path.points[next].position - path.points[end].position);
        let inner = match end {
            // Two points are joined by a straight line.
            _ if last == 1 => chord,
            0 => tangents(path, next).before,
            _ => tangents(path, next).after,
        };
        let own = 1.5 * chord - 0.5 * inner;
        path.points[end].tangents = Some(Tangents {
            before: own,
            after: own,
        });
    }
    Ok(path.check()?)
}

/// Poses that a spline of Kochanek and Bartels leads through.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Keyframes {
    /// The keys, in order.
    pub poses: Vec<Pose>,
    /// When each is reached, in seconds, increasing.
    pub seconds: Vec<f64>,
    /// How many seconds it takes from the last to the first again, if the spline is closed.
    pub closing: Option<f64>,
    /// The tension at all keys.
    pub tension: f64,
}

impl Keyframes {
    /// Poses and times; the first comes again at the end of a closed spline.
    pub(super) fn as_list(&self) -> Result<(Vec<Pose>, Vec<f64>)> {
        let room = self.poses.len() + 1;
        let (mut poses, mut seconds) = (vec_with_room(room)?, vec_with_room(room)?);
        poses.extend_from_slice(&self.poses);
        seconds.extend_from_slice(&self.seconds);
        if let (Some(closing), [first, .., _], Some(last)) =
            (self.closing, &self.poses[..], self.seconds.last())
        {
            poses.push(*first);
            seconds.push(last + closing);
        }
        Ok((poses, seconds))
    }

    /// The path through the keys, which are reached at the frames nearest to their times.
    ///
    /// # Errors
    /// Those of [`CameraPath::check`].
    pub(super) fn path(&self, space: Space, fps: f64) -> Result<CameraPath> {
        let shape = Tcb::new(self.tension, 0.0, 0.0);
        let (_, seconds) = self.as_list()?;
        let frame = |at: usize| ((seconds[at] - seconds[0]) * fps).round();
        // One too many is refused by the path.
        let count = self.poses.len().min(MAX_POINTS + 1);
        let mut points = vec_with_room(count)?;
        // The key from which each point is left.
        let mut leaves = vec_with_room(count)?;
        for (at, pose) in self.poses[..count].iter().enumerate() {
            super::content::check(pose)?;
            let frames = match seconds.len() > at + 1 {
                true => (frame(at + 1) - frame(at)).clamp(1.0, f64::from(u32::MAX)) as u32,
                false => 0,
            };
            let before: Option<&mut SupportPoint> = points.last_mut();
            if let Some(before) = before.filter(|_| self.poses[at - 1] == *pose) {
                // Between equal keys the camera rests.
                let view = &mut before.orientations[0];
                view.hold = view.hold.saturating_add(view.own.frames);
                view.own = view.own.with(|own| own.frames = frames)?;
                leaves.pop();
                leaves.push(at);
                continue;
            }
            let mut point = SupportPoint::try_new(pose.position())?;
            point.curve = CurveParameters::Own(shape);
            let view = &mut point.orientations[0];
            *view = Orientation {
                target: Target::Relative(0.4 * space.half_size * pose.view().normalize()),
                roll: space.up.roll_from_up(pose.view(), pose.up()).to_degrees(),
                zoom: pose.zoom,
                turning: shape,
                ..Orientation::default()
            };
            view.own = view.own.with(|own| own.frames = frames)?;
            points.push(point);
            leaves.push(at);
        }
        let mut path = CameraPath {
            closed: self.closing.is_some(),
            space,
            points: points.into(),
            ..CameraPath::try_new()?
        };
        path.check()?;
        end_naturally(&mut path)?;
        for segment in 0..path.segment_count() {
            let pace = self.pace(&path, segment, leaves[segment], &seconds)?;
            let view = &mut path.points[segment].orientations[0];
            view.own = view.own.with(|own| {
                own.pace = pace;
                own.curve_time = Some(CURVE_TIME);
            })?;
        }
        Ok(path)
    }

    /// How the viewer goes through the segment that leaves a key: by the parameter of the curve,
    /// which is a monotone cubic of the time.
    fn pace(&self, path: &CameraPath, segment: usize, key: usize, seconds: &[f64]) -> Result<Pace> {
        let step = |at: usize| seconds[at + 1] - seconds[at];
        let last = seconds.len() - 2;
        let around = self.closing.is_some();
        let slope = |at: usize| match at {
            0 if around => inner_slope(step(last), step(0)),
            0 if last == 0 => step(0).recip(),
            0 => end_slope(step(0), step(1)),
            at if at <= last => inner_slope(step(at - 1), step(at)),
            _ if around => inner_slope(step(last), step(0)),
            _ if last == 0 => step(0).recip(),
            _ => end_slope(step(last), step(last - 1)),
        };
        let [leave, reach] = [key, key + 1].map(|at| slope(at) * step(key));
        let curve = segment_of(path, segment);
        let arc = ArcLength::new(&curve)?;
        let mut keys = [[0.0, 0.0]; PACE_KEYS];
        for (at, key) in keys.iter_mut().enumerate() {
            let t = at as f64 / (PACE_KEYS - 1) as f64;
            let u = (((leave + reach - 2.0) * t + 3.0 - 2.0 * leave - reach) * t + leave) * t;
            let way = arc.length_at(u.clamp(0.0, 1.0)) / arc.length();
            *key = [t, if arc.length() > 0.0 { way } else { u }];
        }
        keys[PACE_KEYS - 1] = [1.0, 1.0];
        // A curve that turns back on itself may rest for longer than a pace can say.
        Ok(match check_distance(&keys) {
            Ok(()) => distance(&keys)?,
            Err(_) => Pace::default(),
        })
    }

    /// Whether the camera moves at all.
    pub(super) fn moves(&self) -> bool {
        self.poses.windows(2).any(|pair| pair[0] != pair[1])
    }
}
