//! What is read: a scene, or a list of poses that becomes one.

use glam::DVec3;
use vides_document::error::{TooMany, vec_with_room};
use vides_document::{Info, ObjectPoint, SceneDocument};
use vides_engine::error::{Invalid, Place as EnginePlace};
use vides_engine::limits::{
    MAX_COMMENT_BYTES, MAX_FPS, MAX_FRAMES, MAX_NAME_BYTES, MAX_OBJECT_POINTS,
};
use vides_engine::math::quaternion::{angle, continue_sign};
use vides_engine::path::{CameraPath, Plan, Pose, Space, Up};
use vides_engine::scene::{Camera, Channel, Interpolation, Kind, Node, Scene, Track};
use vides_engine::tools::fit::{self, TimeUnit, Tolerance};

use super::convention::Continued;
use super::error::{Cause, Place, Result};
use super::keyframes::Keyframes;
use super::loss::{Loss, Report};
use super::options::{As, Options};

/// The zoom of poses without a field of view: that of a new path.
pub(super) const DEFAULT_ZOOM: f64 = 24.0;

/// Frames per second where neither file nor user says.
pub(super) const DEFAULT_FPS: f64 = 25.0;

/// Fewer poses in a second are not taken as frames.
pub(super) const SEEN_AS_MOTION: f64 = 12.0;

/// What a file holds. There is one at a time: boxing the larger kind gains nothing.
#[derive(Debug)]
#[allow(clippy::large_enum_variant)]
pub enum Content {
    /// Nodes that keep their keys.
    Scene(Box<SceneDocument>),
    /// A camera's poses, one after the other.
    Poses(Recording),
}

/// Poses of one camera, and what belongs to them.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Recording {
    /// In order.
    pub poses: Vec<Pose>,
    /// Their frames, if each has one.
    pub frames: Option<Vec<f64>>,
    /// Their times in seconds, if each has one; frames count before them.
    pub seconds: Option<Vec<f64>>,
    /// By how many seconds times may be off, since the file rounds them.
    pub rounding: f32,
    /// Frames per second, if the file says.
    pub fps: Option<f64>,
    /// The number of the first frame, if the file says.
    pub first_frame: Option<f64>,
    /// Which axis is up, if the file says.
    pub up: Option<Up>,
    /// A title, may be empty.
    pub title: String,
    /// Any lines, may be empty.
    pub comment: String,
    /// The name of the world's unit, may be empty.
    pub unit: String,
    /// The keys that the poses come of, if the file says: a document is made of them.
    pub keyframes: Option<Box<Keyframes>>,
    /// Places that belong to it beside the positions, to be shown as points.
    pub points: Vec<DVec3>,
}

impl Recording {
    /// Appends a pose.
    ///
    /// # Errors
    /// [`super::error::Error::Document`] for too many or if memory runs out.
    pub fn push(&mut self, pose: Pose) -> Result<()> {
        if self.poses.len() >= MAX_FRAMES {
            return Err(super::error::Error::Document(
                TooMany::SceneFrames(MAX_FRAMES).into(),
            ));
        }
        self.poses.try_reserve(1)?;
        self.poses.push(pose);
        Ok(())
    }

    /// The times of the poses in seconds from the first, at a frame rate; none if there
    /// is a pose a frame.
    #[must_use]
    pub fn seconds_at(&self, fps: f64) -> Option<Vec<f64>> {
        let times = self.times(fps)?;
        Some(times.iter().map(|time| time / fps).collect())
    }

    /// Frames per second: what the file says, else as many poses as it has in a second where they
    /// are enough to be seen as motion.
    #[must_use]
    pub fn rate(&self) -> Option<f64> {
        if self.fps.is_some() {
            return self.fps;
        }
        let seconds = self.seconds.as_ref()?;
        let mut steps: Vec<f64> = seconds.windows(2).map(|pair| pair[1] - pair[0]).collect();
        let middle = steps.len().checked_sub(1)? / 2;
        let step = match &self.frames {
            Some(frames) => (seconds.last()? - seconds[0]) / (frames.last()? - frames[0]),
            // The mean of those that no gap is in.
            None => {
                let (_, step, _) = steps.select_nth_unstable_by(middle, f64::total_cmp);
                let most = 1.5 * *step;
                let even = || steps.iter().filter(|step| **step <= most);
                even().sum::<f64>() / even().count() as f64
            }
        };
        let rate = usual(step.recip());
        (SEEN_AS_MOTION..=MAX_FPS).contains(&rate).then_some(rate)
    }

    /// The times of the poses in frames from the first, or none if there is one a frame.
    fn times(&self, fps: f64) -> Option<Vec<f64>> {
        let from_first = |times: &Vec<f64>, unit: f64| {
            let first = times.first().copied().unwrap_or(0.0);
            let frame = |time: &f64| {
                let frame = (time - first) * unit;
                // Seconds of today have seven decimals: what their rounding hides is a whole frame.
                let slack =
                    4.0 * f64::EPSILON * (time.abs() + first.abs()) + f64::from(self.rounding);
                let slack = slack * unit;
                let whole = frame.round();
                if (frame - whole).abs() <= slack {
                    whole
                } else {
                    frame
                }
            };
            times.iter().map(frame).collect()
        };
        let by_seconds = || Some(from_first(self.seconds.as_ref()?, fps));
        let by_frames = self.frames.as_ref().map(|frames| from_first(frames, 1.0));
        by_frames.or_else(by_seconds)
    }

    /// A scene of one camera, on a path or by keys, as the options say.
    ///
    /// # Errors
    /// [`Cause::Empty`], [`Cause::Order`]; those of the fit and of scenes.
    pub fn into_scene(mut self, options: &Options, report: &mut Report) -> Result<SceneDocument> {
        let otherwise = self.rate().unwrap_or(DEFAULT_FPS);
        let fps = rate(&[self.fps], options, otherwise, report);
        let up = options.up.or(self.up).unwrap_or_default();
        if options.as_ != Some(As::Keys)
            && let Some(path) = self.path(None, up, fps)?
        {
            return self.document(Scene::of_path(path)?, fps);
        }
        let as_keys = options.as_ != Some(As::Path);
        if let Some(keyframes) = self.keyframes.take().filter(|_| as_keys) {
            return self.of_keyframes(&keyframes, fps, options);
        }
        if self.poses.is_empty() {
            return Err(Place::Whole.wrong(Cause::Empty));
        }
        let times = self.times(fps);
        if let Some(times) = &times
            && !times.is_sorted_by(|a, b| a < b)
        {
            return Err(Place::Whole.wrong(Cause::Order));
        }
        self.compare(fps, report);
        // Fewer than three are no path.
        let usual = if self.poses.len() < 3 {
            As::Keys
        } else {
            As::Path
        };
        let scene = match options.as_.unwrap_or(usual) {
            As::Path => self.fitted(times.as_deref(), fps, up, options, report)?,
            As::Keys => self.keyed(times, up, &Interpolation::Linear)?,
        };
        self.document(scene, fps)
    }

    /// The path through the keyframes of the file, in the space `within` if that holds it; none
    /// without keyframes, or if they all are the same. A document takes it in place of a fit.
    ///
    /// # Errors
    /// Those of [`CameraPath::check`].
    pub fn path(&self, within: Option<Space>, up: Up, fps: f64) -> Result<Option<CameraPath>> {
        let Some(keyframes) = self.keyframes.as_ref().filter(|keys| keys.moves()) else {
            return Ok(None);
        };
        let far = |pose: &Pose, from: DVec3| (pose.position() - from).abs().max_element();
        let holds = |space: &Space| {
            let mut poses = keyframes.poses.iter();
            space.up == up && poses.all(|pose| far(pose, space.centre) <= space.half_size)
        };
        let space = match within.filter(holds) {
            Some(space) => space,
            None => space_around(&keyframes.poses, &self.points, up)?,
        };
        keyframes.path(space, fps).map(Some)
    }

    /// Reports the keyframes if the poses are read in their place.
    pub fn tell_keyframes(&self, report: &mut Report) {
        let count = self.keyframes.as_ref().map_or(0, |keys| keys.poses.len());
        report.count(count, Loss::Keyframes);
    }

    /// A scene of keys that a spline joins: the points of a path, or keys.
    fn of_keyframes(
        mut self,
        keyframes: &Keyframes,
        fps: f64,
        options: &Options,
    ) -> Result<SceneDocument> {
        (self.poses, self.seconds) = {
            let (poses, seconds) = keyframes.as_list()?;
            (poses, Some(seconds))
        };
        let up = options.up.or(self.up).unwrap_or_default();
        let scene = self.keyed(self.times(fps), up, &Interpolation::CatmullRom)?;
        self.document(scene, fps)
    }

    fn document(self, scene: Scene, fps: f64) -> Result<SceneDocument> {
        let first = self
            .frames
            .as_ref()
            .and_then(|frames| frames.first().copied());
        let first = first.or(self.first_frame).unwrap_or(1.0);
        let points = self.points.iter().take(MAX_OBJECT_POINTS);
        let mut object = vec_with_room(points.len())?;
        object.extend(points.map(|&position| ObjectPoint {
            position,
            draw: false,
        }));
        let info = Info {
            title: one_line(&self.title),
            comment: shortened(&self.comment),
            unit: one_line(&self.unit),
            fps,
            first_frame: first.round() as i32,
            object: object.into(),
            ..Info::default()
        };
        Ok(SceneDocument::new(scene, info)?)
    }

    /// Makes times seconds that are too great to be such.
    pub(super) fn count_seconds(&mut self, report: &mut Report) -> Result<()> {
        let Some(times) = &mut self.seconds else {
            return Ok(());
        };
        if let Some(unit) = TimeUnit::of(times)? {
            for time in times {
                *time *= unit.seconds();
            }
            report.add(Loss::TimeUnit(unit.name()));
        }
        Ok(())
    }

    /// Tells when the times begin, if not at once.
    pub(super) fn tell_epoch(&self, report: &mut Report) {
        let first = self.seconds.as_ref().and_then(|seconds| seconds.first());
        if let (Some(&first), None) = (first.filter(|first| **first != 0.0), &self.frames) {
            report.add(Loss::Epoch(first));
        }
    }

    /// Tells where the seconds of poses are not those of their frames, which count.
    fn compare(&self, fps: f64, report: &mut Report) {
        let (Some(frames), Some(seconds)) = (&self.frames, &self.seconds) else {
            return;
        };
        let times = frames.iter().zip(seconds).map(|(frame, second)| {
            let by_frame = (frame - frames[0]) / fps;
            (second - seconds[0], by_frame)
        });
        for (pose, (seconds, by_frame)) in times.enumerate() {
            if !(((seconds - by_frame) * fps).abs() <= 0.5) {
                report.add(Loss::Seconds {
                    pose,
                    seconds,
                    by_frame,
                });
                return;
            }
        }
    }

    fn keyed(&self, times: Option<Vec<f64>>, up: Up, by: &Interpolation) -> Result<Scene> {
        let count = self.poses.len();
        let numbers = |width: usize| vec_with_room::<f64>(width * count);
        let (mut positions, mut rotations, mut zooms) = (numbers(3)?, numbers(4)?, numbers(1)?);
        let mut continued = Continued::default();
        for (at, pose) in self.poses.iter().enumerate() {
            check(pose).map_err(|error| error.at(EnginePlace::Pose(at)))?;
            let turn = continued.next(pose.rotation());
            positions.extend(pose.vrp);
            rotations.extend([turn.w, turn.x, turn.y, turn.z]);
            zooms.push(pose.zoom);
        }
        let frames = match times {
            Some(times) => times.iter().map(|time| time + 1.0).collect(),
            None => (1..=count).map(|frame| frame as f64).collect::<Vec<_>>(),
        };
        let mut camera = Node::new("camera", Kind::Camera(Camera::default()));
        for (channel, values) in [
            (Channel::Position, positions),
            (Channel::Rotation, rotations),
            (Channel::Zoom, zooms),
        ] {
            let track = Track::new(channel, by.clone(), frames.clone(), values, Vec::new());
            camera.set_track(track?)?;
        }
        let mut scene = Scene::new();
        scene.set_space(space_around(&self.poses, &self.points, up)?)?;
        scene.add(camera)?;
        Ok(scene)
    }

    fn fitted(
        &self,
        times: Option<&[f64]>,
        fps: f64,
        up: Up,
        options: &Options,
        report: &mut Report,
    ) -> Result<Scene> {
        let space = space_around(&self.poses, &self.points, up)?;
        let usual = Tolerance::usual(&self.poses);
        let tolerance = Tolerance {
            position: options.tolerance.unwrap_or(usual.position),
            angle: options.angle,
        };
        let choice = fit::Options {
            space: (!self.points.is_empty()).then_some(space),
            up,
            ..tolerance.into()
        };
        let seconds: Option<Vec<f64>> =
            times.map(|times| times.iter().map(|time| time / fps).collect());
        let made = fit::fit(
            &self.poses,
            seconds.as_deref(),
            fps,
            &choice,
            &mut |_, _| true,
        )?;
        let (off, turned) = missed(&made.path, &self.poses, times)?;
        report.add(Loss::Fitted {
            points: made.path.points.len(),
            off,
            turned,
        });
        Ok(Scene::of_path(made.path)?)
    }
}

/// The smallest space around poses and points.
pub(super) fn space_around(poses: &[Pose], points: &[DVec3], up: Up) -> Result<Space> {
    let places = || {
        let positions = poses.iter().map(Pose::position);
        positions.chain(points.iter().copied())
    };
    let first = places().next().unwrap_or_default();
    if places().all(|place| place == first) {
        // A camera on one spot: a space about it of the size of its distance, else 1.
        let half_size = first.abs().max_element();
        let half_size = if half_size > 0.0 { half_size } else { 1.0 };
        return Ok(Space {
            centre: first,
            half_size,
            up,
        });
    }
    Ok(Space::around(places(), up)?)
}

pub(super) fn check(pose: &Pose) -> Result<(), vides_engine::Error> {
    vides_engine::path::camera_path::check_zoom(pose.zoom)?;
    let finite = [pose.position(), pose.view(), pose.up()];
    if !finite.iter().all(|vector| vector.is_finite())
        || !(pose.view().cross(pose.up()).length() > 1e-9)
    {
        return Err(Invalid::RotationZero.into());
    }
    Ok(())
}

/// The rate that a measured one is likely to be: a whole one, one of television's, else to a
/// thousandth.
fn usual(rate: f64) -> f64 {
    let of_television = rate.round() * 1000.0 / 1001.0;
    let near = |usual: &f64| (rate / usual - 1.0).abs() <= 2e-4;
    let likely = [rate.round(), of_television];
    likely
        .into_iter()
        .find(near)
        .unwrap_or((rate * 1e3).round() / 1e3)
}

/// Frames per second: what the file says first, then the user, else `otherwise`. A rate beyond the
/// range is reported.
pub(super) fn rate(
    said: &[Option<f64>],
    options: &Options,
    otherwise: f64,
    report: &mut Report,
) -> f64 {
    let sane = |fps: &f64| *fps > 0.0 && *fps <= MAX_FPS;
    let said = said.iter().copied().flatten();
    report.count(said.clone().filter(|fps| !sane(fps)).count(), Loss::Rates);
    let mut known = said.chain(options.fps).filter(sane);
    known.next().unwrap_or(otherwise)
}

/// A text of a file as the title of a document: its first line, as far as it may be long.
pub(super) fn one_line(text: &str) -> String {
    let line = text.lines().next().unwrap_or("");
    let plain = |c: &char| !c.is_control();
    let mut title = String::new();
    for c in line.trim().chars().filter(plain) {
        if title.len() + c.len_utf8() > MAX_NAME_BYTES {
            break;
        }
        title.push(c);
    }
    title
}

/// A text of a file as the comment of a document: as much of it as that may have.
pub(super) fn shortened(text: &str) -> String {
    let mut end = text.len().min(MAX_COMMENT_BYTES);
    while !text.is_char_boundary(end) {
        end -= 1;
    }
    text[..end].to_owned()
}

/// How far a path is at most from poses at their times in frames from the first, or a pose a frame:
/// a length, and an angle in degrees.
///
/// # Errors
/// Those of sampling.
fn missed(path: &CameraPath, poses: &[Pose], times: Option<&[f64]>) -> Result<(f64, f64)> {
    let plan = Plan::new();
    let sampler = plan.sampler(path)?;
    let last = sampler.frame_count() as f64;
    let (mut off, mut turned): (f64, f64) = (0.0, 0.0);
    for (at, pose) in poses.iter().enumerate() {
        let time = times.map_or(at as f64, |times| times[at]);
        let made = sampler.pose((time + 1.0).min(last))?;
        off = off.max(made.position().distance(pose.position()));
        let (a, b) = (pose.rotation(), made.rotation());
        turned = turned.max(2.0 * angle(a, continue_sign(a, b).0).to_degrees());
    }
    Ok((off, turned))
}
