//! What is written: a document, the node and the frames of it, in the axes of the file.

use std::cell::OnceCell;
use std::io::Write;

use glam::{DAffine3, DMat4, DQuat, DVec3};
use vides_document::error::{Place as ScenePlace, TooMany, vec_with_room};
use vides_document::{Info, SceneDocument};
use vides_engine::limits::MAX_FRAMES;
use vides_engine::path::{Pose, Space, Up};
use vides_engine::scene::{
    Camera, Channel, FollowPath, Kind, Node, NodeState, Scene, Track, Warnings,
};

use super::blocks::{self, Progress};
use super::convention::{self, focal_pixels};
use super::error::{Error, Result};
use super::format::{Format, Holds};
use super::loss::{Loss, Report};
use super::options::{DEFAULT_SIZE, Options, Times};
use super::space;

/// A share of a frame that is rounding.
const HAIR: f64 = 1e-6;

/// So many half sizes from the origin, 32 bits are too coarse.
const FAR: f64 = 16.0;

/// A document and the frames that are written of it.
pub struct Flight<'a> {
    document: &'a SceneDocument,
    options: &'a Options,
    node: usize,
    /// Scene frame of the first pose, and frames from one to the next.
    first: f64,
    step: f64,
    count: usize,
    fps: f64,
    /// The scene frames of the poses where they are not evenly spaced.
    own: Option<Vec<f64>>,
    up: Up,
    /// The cube around everything, once it was asked for.
    bounds: OnceCell<Space>,
    progress: Option<Progress<'a>>,
}

impl<'a> Flight<'a> {
    /// The node and frames that the options choose, in the axes of a format.
    ///
    /// # Errors
    /// [`Error::NoNode`], [`Error::NoFrames`], [`Error::OtherUp`]; [`Error::Document`] without a
    /// camera, for too many frames and if a path cannot be prepared.
    pub fn new(
        document: &'a SceneDocument,
        options: &'a Options,
        format: &Format,
        progress: Progress<'a>,
    ) -> Result<Self> {
        let scene = &document.scene;
        let node = match &options.node {
            Some(name) => scene.find(name),
            // Nothing of a whole scene is seen through it.
            None => {
                let any = format.holds == Holds::Scene && !scene.nodes().is_empty();
                scene.shown_camera().or(any.then_some(0))
            }
        };
        let node = node.ok_or_else(|| match &options.node {
            Some(name) => Error::NoNode(name.as_str().into()),
            None => Error::Document(vides_document::error::Refused::NoCamera.into()),
        })?;
        let (first, last) = scene.frame_range();
        let to_scene = 1.0 - f64::from(document.info.first_frame);
        let (from, to) = match options.frames {
            Some((a, b)) => (a + to_scene, b + to_scene),
            None => (first, last),
        };
        if from < first - HAIR || to > last + HAIR {
            return Err(Error::NoFrames {
                first: first - to_scene,
                last: last - to_scene,
            });
        }
        let fps = options.fps.unwrap_or(document.info.fps);
        // Finite, so that the first pose of the slowest rate is at a frame.
        let step = (document.info.fps / fps).min(f64::MAX);
        // As many as last as long as the frames do, each of which is shown until the next.
        let frames = ((to - from) / step + 1.0).max((to - from + 1.0) / step);
        let frames = (frames + HAIR).floor();
        if frames > MAX_FRAMES as f64 {
            return Err(Error::Document(TooMany::SceneFrames(MAX_FRAMES).into()));
        }
        let up = options.up.or(format.up).unwrap_or(scene.space().up);
        if let Some(fixed) = format.up.filter(|fixed| *fixed != up) {
            return Err(Error::OtherUp {
                format: format.name,
                up: fixed.name(),
            });
        }
        let own = match options.times {
            Some(Times::Own) if !format.own_times || options.fps.is_some() => {
                return Err(Error::OwnTimes);
            }
            Some(Times::Own) => keys(&scene.nodes()[node], from, to),
            _ => None,
        };
        // Report what cannot be sampled before any file is touched.
        scene.prepare(from)?;
        Ok(Self {
            document,
            options,
            node,
            first: from,
            step,
            count: own.as_ref().map_or(frames as usize, Vec::len),
            own,
            fps,
            up,
            bounds: OnceCell::new(),
            progress: Some(progress),
        })
    }

    /// The document.
    #[must_use]
    pub const fn document(&self) -> &'a SceneDocument {
        self.document
    }

    /// Everything that moves.
    #[must_use]
    pub const fn scene(&self) -> &'a Scene {
        &self.document.scene
    }

    /// Title, comment, object.
    #[must_use]
    pub const fn info(&self) -> &'a Info {
        &self.document.info
    }

    /// What was chosen.
    #[must_use]
    pub const fn options(&self) -> &'a Options {
        self.options
    }

    /// The number of the node that is written; 0 for a whole scene without a camera.
    #[must_use]
    pub const fn node(&self) -> usize {
        self.node
    }

    /// How many frames there are; at least one.
    #[must_use]
    pub const fn count(&self) -> usize {
        self.count
    }

    /// Frames per second of what is written.
    #[must_use]
    pub const fn fps(&self) -> f64 {
        self.fps
    }

    /// The scene frame of a pose, counted from 0.
    #[must_use]
    pub fn frame(&self, index: usize) -> f64 {
        match &self.own {
            Some(frames) => frames[index],
            None => self.first + self.step * index as f64,
        }
    }

    /// The scene frame of the first pose, and how many frames lie between two.
    #[must_use]
    pub const fn first_and_step(&self) -> (f64, f64) {
        (self.first, self.step)
    }

    /// The frame of a pose in the numbers that people see.
    #[must_use]
    pub fn number(&self, index: usize) -> f64 {
        self.frame(index) + f64::from(self.info().first_frame) - 1.0
    }

    /// The time of a pose in seconds, the first at 0.
    #[must_use]
    pub fn seconds(&self, index: usize) -> f64 {
        match &self.own {
            Some(frames) => (frames[index] - frames[0]) / self.fps,
            None => convention::seconds(index, self.fps),
        }
    }

    /// The time of a pose in seconds as the file counts them.
    pub(crate) fn time(&self, index: usize) -> f64 {
        self.options.start.unwrap_or(0.0) + self.seconds(index)
    }

    /// Width and height of a picture in pixels.
    #[must_use]
    pub fn pixels(&self) -> [u32; 2] {
        self.options.size.unwrap_or(DEFAULT_SIZE)
    }

    /// The same as numbers to calculate with.
    #[must_use]
    pub fn size(&self) -> [f64; 2] {
        self.pixels().map(f64::from)
    }

    /// The focal length of a zoom in pixels.
    #[must_use]
    pub fn focal_pixels(&self, zoom: f64) -> f64 {
        focal_pixels(zoom, self.size()[1])
    }

    /// Which axis is up in the file.
    #[must_use]
    pub const fn up(&self) -> Up {
        self.up
    }

    /// Which axis is up in the document.
    #[must_use]
    pub fn document_up(&self) -> Up {
        self.scene().space().up
    }

    /// From the document's coordinates to the file's: rotated to its up axis, then scaled.
    #[must_use]
    pub fn to_file(&self) -> DAffine3 {
        DAffine3::from_quat(convention::turn(self.document_up(), self.up))
            * DAffine3::from_scale(DVec3::splat(self.options.scale))
    }

    /// The near and far plane of a camera in the file's unit: its own, or those that show
    /// everything if nobody set them.
    pub(crate) fn planes(&self, camera: Camera) -> Result<[f64; 2]> {
        let Camera { near, far } = match camera == Camera::default() {
            true => Camera::for_size(self.bounds()?.half_size),
            false => camera,
        };
        // As files of 32 bits hold them.
        let scaled = |plane: f64| (plane * self.options.scale).clamp(1e-30, 1e30);
        Ok([near, far].map(scaled))
    }

    /// The smallest cube around everything, in the document's coordinates.
    pub(crate) fn bounds(&self) -> Result<Space> {
        if let Some(bounds) = self.bounds.get() {
            return Ok(*bounds);
        }
        let object = self.info().object.iter().map(|point| point.position);
        let bounds = space::around(self.scene(), object, self.document_up())?;
        Ok(*self.bounds.get_or_init(|| bounds))
    }

    /// What places near this one count from in a file of 32 bits; zero unless it is far from the
    /// origin for the size of everything. `scale` is the length in the world of one unit there.
    ///
    /// A whole number of steps, so that 32 bits hold it exactly.
    pub(crate) fn origin(&self, place: DVec3, scale: f64) -> Result<DVec3> {
        let half_size = self.bounds()?.half_size * self.options.scale / scale;
        if !(place.length() > FAR * half_size) {
            return Ok(DVec3::ZERO);
        }
        let step = half_size.log2().floor().exp2();
        let origin = (place / step).round() * step;
        Ok(if origin.is_finite() {
            origin
        } else {
            DVec3::ZERO
        })
    }

    /// A place of the document in the file's coordinates.
    #[must_use]
    pub fn place(&self, place: DVec3) -> DVec3 {
        self.direction(place) * self.options.scale
    }

    /// A direction of the document in the file's coordinates.
    #[must_use]
    pub fn direction(&self, direction: DVec3) -> DVec3 {
        convention::turned(direction, self.document_up(), self.up)
    }

    /// A rotation of the document in the file's coordinates.
    #[must_use]
    pub fn rotation(&self, rotation: DQuat) -> DQuat {
        convention::turn(self.document_up(), self.up) * rotation
    }

    /// The matrix of a node to the file's world: rotated to its up axis and moved as poses are.
    /// Lengths in it are the file's, too.
    #[must_use]
    pub fn matrix(&self, state: &NodeState) -> [f64; 16] {
        let mut matrix = DMat4::from_cols_array(&state.matrix);
        for axis in 0..3 {
            *matrix.col_mut(axis) = self.direction(matrix.col(axis).truncate()).extend(0.0);
        }
        matrix.w_axis = self.place(matrix.w_axis.truncate()).extend(1.0);
        matrix.to_cols_array()
    }

    /// A pose of the document in the file's coordinates.
    #[must_use]
    pub fn pose(&self, pose: Pose) -> Pose {
        if self.up == self.document_up() && self.options.scale == 1.0 {
            return pose;
        }
        Pose {
            vrp: self.place(pose.vrp.into()).to_array(),
            vpn: self.direction(pose.vpn.into()).to_array(),
            vup: self.direction(pose.vup.into()).to_array(),
            zoom: pose.zoom,
        }
    }

    /// The path, if the document is nothing but one camera on it.
    #[must_use]
    pub fn path_alone(&self) -> Option<&'a FollowPath> {
        self.document.path_alone()?;
        self.scene().nodes()[0].path()
    }

    /// Calls for progress while the flight itself is read; [`Flight::give_progress`] puts it back.
    pub(super) fn take_progress(&mut self) -> Option<Progress<'a>> {
        self.progress.take()
    }

    /// Gives back what [`Flight::take_progress`] took.
    pub(super) fn give_progress(&mut self, progress: Option<Progress<'a>>) {
        self.progress = progress;
    }

    /// Whether the node has poses: cameras and lights do.
    #[must_use]
    pub fn looks(&self) -> bool {
        self.scene().nodes()[self.node].kind.looks()
    }

    /// Reports what a format cannot hold.
    ///
    /// # Errors
    /// [`Error::NoCamera`] if it is for cameras and the node is not a camera.
    pub(super) fn tell_left_out(&self, holds: Holds, report: &mut Report) -> Result<()> {
        match holds {
            Holds::Scene => {}
            Holds::Frames => self.tell_others(report),
            Holds::View => self.needs_camera()?,
            Holds::Objects => {
                self.needs_camera()?;
                self.tell_motion(report);
            }
            Holds::Motion => {
                self.needs_camera()?;
                self.tell_others(report);
                self.tell_motion(report);
            }
            Holds::Poses => {
                self.needs_camera()?;
                self.tell_others(report);
                self.tell_motion(report);
                if !self.info().object.is_empty() {
                    report.add(Loss::Object);
                }
            }
        }
        Ok(())
    }

    fn needs_camera(&self) -> Result<()> {
        let node = &self.scene().nodes()[self.node];
        match node.kind {
            Kind::Camera(_) => Ok(()),
            _ => Err(Error::NoCamera(node.name.as_str().into())),
        }
    }

    /// Reports of what becomes a pose a frame.
    fn tell_motion(&self, report: &mut Report) {
        let node = &self.scene().nodes()[self.node];
        if node.aim.is_some() {
            report.add(Loss::Aims(1));
        }
        if node.path().is_some() {
            report.add(Loss::Path);
        }
    }

    fn tell_others(&self, report: &mut Report) {
        let nodes = self.scene().nodes().iter().enumerate();
        let mut others = [0, 0];
        for (at, node) in nodes {
            if at != self.node {
                others[usize::from(matches!(node.kind, Kind::Camera(_)))] += 1;
            }
        }
        report.count(others[0], Loss::OtherNodes);
        report.count(others[1], Loss::OtherCameras);
    }

    /// The poses from an index on, in the file's coordinates.
    ///
    /// # Errors
    /// Those of sampling; a host interpolation that is missing or fails.
    pub fn poses(&self, from: usize, poses: &mut [Pose]) -> Result<()> {
        if let Some(follow) = self.path_alone() {
            let sampler = follow.sampler()?;
            if self.step == 1.0 && self.first.fract() == 0.0 {
                sampler.sample(self.frame(from) as usize, poses)?;
            } else {
                let last = sampler.frame_count() as f64;
                for (at, pose) in poses.iter_mut().enumerate() {
                    *pose = sampler.pose(self.frame(from + at).clamp(1.0, last))?;
                }
            }
        } else {
            let states = self.states(self.node, from, poses.len())?;
            for (pose, state) in poses.iter_mut().zip(&states) {
                *pose = state.pose;
            }
        }
        for pose in poses {
            *pose = self.pose(*pose);
        }
        Ok(())
    }

    /// All poses, in the file's coordinates.
    ///
    /// # Errors
    /// As [`Flight::poses`].
    pub fn all_poses(&self) -> Result<Vec<Pose>> {
        let mut poses = vec_with_room(self.count)?;
        poses.resize(self.count, Pose::default());
        self.poses(0, &mut poses)?;
        Ok(poses)
    }

    /// The states of a node from an index on, in the document's coordinates.
    ///
    /// # Errors
    /// As [`Flight::poses`].
    pub fn states(&self, node: usize, from: usize, count: usize) -> Result<Vec<NodeState>> {
        let mut states = vec_with_room(count)?;
        states.resize(count, NodeState::default());
        self.fill_states(node, from, &mut states)?;
        Ok(states)
    }

    /// As [`Flight::states`], into room that is there.
    ///
    /// # Errors
    /// As [`Flight::poses`].
    pub fn fill_states(&self, node: usize, from: usize, states: &mut [NodeState]) -> Result<()> {
        let scene = self.scene();
        let mut warnings = Warnings::default();
        if self.own.is_none() {
            scene.sample(node, self.frame(from), self.step, states, &mut warnings)?;
        } else {
            for (at, state) in states.iter_mut().enumerate() {
                let state = std::slice::from_mut(state);
                scene.sample(node, self.frame(from + at), 1.0, state, &mut warnings)?;
            }
        }
        // It may be one that this depends on.
        let failed = warnings.first().map_or(node, |(failed, _)| failed);
        succeeded(warnings, &scene.nodes()[failed])
    }

    /// Writes `head`, then each pose as `push` appends it, in blocks.
    ///
    /// # Errors
    /// As [`Flight::poses`]; [`Error::Document`] if `out` fails.
    pub fn write_poses(
        &mut self,
        head: Vec<u8>,
        out: &mut dyn Write,
        push: impl Fn(&Self, &mut Vec<u8>, usize, &Pose),
    ) -> Result<()> {
        self.write_blocks(head, out, Self::poses, push)
    }

    /// As [`Flight::write_poses`], of the node's states in the document's coordinates.
    ///
    /// # Errors
    /// As [`Flight::write_poses`].
    pub fn write_states(
        &mut self,
        head: Vec<u8>,
        out: &mut dyn Write,
        push: impl Fn(&Self, &mut Vec<u8>, usize, &NodeState),
    ) -> Result<()> {
        let states = |flight: &Self, from, states: &mut [NodeState]| {
            flight.fill_states(flight.node, from, states)
        };
        self.write_blocks(head, out, states, push)
    }

    /// As [`Flight::write_poses`], of what `sample` gives of the frames from an index on.
    ///
    /// # Errors
    /// Those of `sample`; [`Error::Document`] if `out` fails.
    pub(super) fn write_blocks<T: Clone + Default>(
        &mut self,
        head: Vec<u8>,
        out: &mut dyn Write,
        sample: impl Fn(&Self, usize, &mut [T]) -> Result<()>,
        push: impl Fn(&Self, &mut Vec<u8>, usize, &T),
    ) -> Result<()> {
        // Taken out, so that the rest can be read meanwhile.
        let mut progress = self.progress.take();
        let flight = &*self;
        let done = blocks::write(
            head,
            flight.count,
            out,
            &mut |done, all| {
                if let Some(progress) = &mut progress {
                    progress(done, all);
                }
            },
            |done, block| sample(flight, done, block),
            |text, index, one| push(flight, text, index, one),
        );
        self.progress = progress;
        done
    }
}

/// The frames of a node's keys of position and rotation, between two; none if it has no keys there.
fn keys(node: &Node, from: f64, to: f64) -> Option<Vec<f64>> {
    let tracks = [Channel::Position, Channel::Rotation].map(|channel| node.keys().track(&channel));
    let frames = tracks.into_iter().flatten().flat_map(Track::frames);
    let mut frames: Vec<f64> = frames
        .copied()
        .filter(|at| (from..=to).contains(at))
        .collect();
    frames.sort_unstable_by(f64::total_cmp);
    frames.dedup();
    (!frames.is_empty()).then_some(frames)
}

/// Fails with the node's name if something went wrong while the rest went on.
///
/// # Errors
/// The first of what went wrong.
pub(super) fn succeeded(warnings: Warnings, node: &Node) -> Result<()> {
    match warnings.into_error() {
        Some(error) => Err(error.at(ScenePlace::Node(node.name.as_str().into())).into()),
        None => Ok(()),
    }
}
