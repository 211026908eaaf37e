//! The interactive tools, each with a table of its parameters, from which window and texts are
//! built, and the edit it makes; the mathematics is in [`vides_engine::tools`].

mod arguments;
mod moved;
pub mod options;
mod table;

use std::fmt;
use std::sync::Arc;

use glam::{DQuat, DVec3};
use vides_engine::deform::{Bounds, Deformation, identity_lattice};
use vides_engine::planner::{
    AvoidRequest, AvoidedPart, Request, Rest, SteadyRequest, Tour, TourRequest, What, avoid_object,
    retime, steady, tour,
};
use vides_engine::scene::Mesh;
use vides_engine::tools::blend::blend;
use vides_engine::tools::block::{self, Fit};
use vides_engine::tools::check::{FindingKind, OFF};
use vides_engine::tools::clearance::Clearance;
use vides_engine::tools::fit::{
    Fitted, Options, PoseDeviation, Progress, Report, Tolerance, fit, fit_points,
};
use vides_engine::tools::moves::{MOVES, Move};
use vides_engine::tools::{Parameter, transform};

use super::apply::no_longer_ahead;
use super::draw::drawn;
use super::edit::Edit;
use super::editing::Document;
use crate::cage;
pub use crate::cage::Cage;
use crate::error::{EngineError, Error, Invalid, OutOfRange, Result};
use arguments::{ToolArguments, chosen};
pub use moved::moved;
use table::{ABOUT, AXIS, FIRST, LAST, OF_DEFORM, OF_FIT, OF_TOUR, PUT, SEEN, TOOLS};
use vides_engine::path::fit_frames::frames_of;
use vides_engine::path::{CameraPath, Pose, Space, Target, Up};

/// A tool: its name, description and parameters.
#[derive(Debug, Clone, Copy)]
pub struct Tool {
    /// In lower case, words joined by `-`.
    pub name: &'static str,
    /// What it does, in a few words.
    pub does: &'static str,
    kind: Kind,
    /// Its own parameters, and shared ones.
    tables: [&'static [Parameter]; 2],
}

impl PartialEq for Tool {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}

/// A tool's input besides its numbers.
#[derive(Debug, Clone, Default)]
pub enum ToolInput {
    /// Nothing.
    #[default]
    None,
    /// A path to insert.
    Block(Box<CameraPath>),
    /// Recorded poses, with their times in seconds, if any, and their up axis.
    Poses(Vec<Pose>, Option<Vec<f64>>, Up),
    /// The positions of a line drawn by hand.
    Stroke(Vec<DVec3>),
    /// The object of the document, prepared.
    Object(Arc<Clearance>),
    /// An object to show in place of the document's own, and where the flight begins.
    Tour(Option<Box<Mesh>>, Option<DVec3>),
}

impl ToolInput {
    /// The object, prepared, else the document's own.
    fn object_or_own(&self, document: &Document) -> Result<Arc<Clearance>> {
        match self {
            Self::Object(object) => Ok(object.clone()),
            _ => Ok(Arc::new(document.solid(None)?)),
        }
    }
}

/// What a tool makes of a document.
#[derive(Debug)]
pub struct Made {
    /// None: it changes nothing.
    pub edit: Option<Edit>,
    /// How well a path follows the recorded poses to which it was fitted.
    pub fit: Option<FitResult>,
    /// What was done, in numbers by their names.
    pub numbers: Vec<(&'static str, f64)>,
    /// The same in sentences.
    pub lines: Vec<Line>,
}

/// What a tool did, as a sentence.
#[derive(Debug)]
pub enum Line {
    /// A part that leads another way.
    Avoided(AvoidedPart),
    /// Where the pace rests.
    Rest(Rest),
    /// How far a position moved, and by how many degrees a view turned, at most.
    Steadied(f64, f64),
    /// What a flight shows of an object.
    Tour(Box<Tour>),
}

impl fmt::Display for Line {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Avoided(part) => part.fmt(f),
            Self::Rest(rest) => rest.fmt(f),
            Self::Tour(tour) => tour.fmt(f),
            Self::Steadied(furthest, turned) => write!(
                f,
                "places went {furthest:.6} at most, views turned {turned:.3} degrees"
            ),
        }
    }
}

impl Made {
    /// Another path in the place of the old one, and what was done.
    fn path(path: CameraPath, numbers: &[(&'static str, f64)], lines: Vec<Line>) -> Self {
        Self {
            numbers: numbers.to_vec(),
            lines,
            ..Some(Edit::ReplacePath(Box::new(path))).into()
        }
    }
}

impl From<Option<Edit>> for Made {
    fn from(edit: Option<Edit>) -> Self {
        Self {
            edit,
            fit: None,
            numbers: Vec::new(),
            lines: Vec::new(),
        }
    }
}

/// How well a path follows recorded poses.
#[derive(Debug)]
pub struct FitResult {
    /// The tolerance that it keeps: the given one, or the least that leads to the number of points.
    pub tolerance: Tolerance,
    /// In words and numbers.
    pub report: Report,
    /// How far it is from each pose that counts, in the order of their times.
    pub deviations: Vec<PoseDeviation>,
    /// Indices of the poses that do not count.
    pub left_out: Vec<usize>,
}

/// What a tool needs before it can begin, or does at its end.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Needs {
    /// Nothing but its numbers.
    Nothing,
    /// A file with a path.
    Block,
    /// A file with poses.
    Poses,
    /// A line drawn in the space.
    Stroke,
    /// A file to write; it changes nothing.
    Output,
}

#[derive(Debug, Clone, Copy)]
enum Kind {
    Move(&'static Move),
    Shift,
    Turn,
    Scale,
    Mirror,
    Deform(&'static str),
    Insert,
    Blend,
    Extract,
    Reverse,
    Repeat,
    Frames,
    Fit,
    Draw,
    Retime,
    Steady,
    Avoid,
    Picture,
    Tour,
}

/// More poses than this are not fitted in the thread of the window.
const POSES: usize = 2_000;

/// How often a fit to a number of points fits them.
const ROUNDS: usize = 10;

const FITS: [Fit; 4] = [Fit::None, Fit::Move, Fit::Turn, Fit::Scale];

/// All tools, the moves first.
pub fn tools() -> impl Iterator<Item = Tool> {
    let moves = MOVES.iter().map(|known| Tool {
        name: known.name,
        does: known.does,
        kind: Kind::Move(known),
        tables: [known.parameters, PUT],
    });
    moves.chain(TOOLS.iter().copied())
}

impl Tool {
    /// Its parameters, the shared ones last.
    pub fn parameters(&self) -> impl Iterator<Item = &'static Parameter> + use<> {
        self.tables.into_iter().flatten()
    }

    /// The tool without the parameters that put its path into another.
    #[must_use]
    pub fn alone(mut self) -> Self {
        if self.can_add() {
            self.tables[1] = &[];
        }
        self
    }

    /// What it takes in text options besides its parameters; none has a default.
    #[must_use]
    pub const fn more(&self) -> &'static [Parameter] {
        match self.kind {
            Kind::Fit => OF_FIT,
            Kind::Tour => OF_TOUR,
            Kind::Deform(_) => OF_DEFORM,
            _ => &[],
        }
    }

    /// Index of a parameter's first number among all its numbers.
    #[must_use]
    pub fn place_of(&self, name: &str) -> Option<usize> {
        let mut start = 0;
        for parameter in self.parameters() {
            if parameter.name == name {
                return Some(start);
            }
            start += parameter.width;
        }
        None
    }

    /// Whether it is a ready-made move.
    #[must_use]
    pub const fn is_move(&self) -> bool {
        matches!(self.kind, Kind::Move(_))
    }

    /// Whether it asks how the path lies to the object: a prepared one as [`ToolInput::Object`] spares
    /// time.
    #[must_use]
    pub const fn asks_object(&self) -> bool {
        matches!(self.kind, Kind::Picture | Kind::Avoid)
    }

    /// Whether it has parameters.
    #[must_use]
    pub const fn has_numbers(&self) -> bool {
        !self.tables[0].is_empty() || !self.tables[1].is_empty()
    }

    /// Whether it takes a noticeable time with these numbers.
    #[must_use]
    pub fn takes_long(&self, document: &Document, material: &ToolInput, numbers: &[f64]) -> bool {
        let rounds = match ToolArguments::new(self, document, numbers).points_of_fit() {
            Some(_) => ROUNDS,
            None => 1,
        };
        let poses = match (self.kind, material) {
            (Kind::Avoid | Kind::Picture | Kind::Tour, _) => return true,
            (Kind::Retime | Kind::Steady, _) => document
                .sampler()
                .map_or(0, |sampler| sampler.frame_count()),
            (_, ToolInput::Poses(poses, ..)) => rounds * poses.len(),
            _ => 0,
        };
        poses > POSES
    }

    /// Whether a preview follows a drag even if it takes long, as far as the machine can.
    #[must_use]
    pub const fn follows_drags(&self) -> bool {
        matches!(self.kind, Kind::Fit)
    }

    /// Whether it makes a new flight, to be shown from its beginning.
    #[must_use]
    pub const fn makes_flight(&self) -> bool {
        matches!(self.kind, Kind::Tour)
    }

    /// What it needs besides its numbers.
    #[must_use]
    pub const fn needs(&self) -> Needs {
        match self.kind {
            Kind::Insert | Kind::Blend => Needs::Block,
            Kind::Fit => Needs::Poses,
            Kind::Draw => Needs::Stroke,
            Kind::Extract => Needs::Output,
            _ => Needs::Nothing,
        }
    }

    /// The number that brings the usual tolerance for these poses, where the tool fits a path.
    #[must_use]
    pub fn usual_tolerance(&self, poses: &[Pose]) -> Option<f64> {
        matches!(self.kind, Kind::Fit).then(|| Tolerance::usual(poses).position)
    }

    /// Whether it can make its path a part of the present one: number `put`, which is 0 where it
    /// replaces it, 1 after the current point, 2 after the last one.
    #[must_use]
    pub fn can_add(&self) -> bool {
        self.place_of("put").is_some()
    }

    /// Its default numbers, fitted to the object, the path's points and the frame count.
    ///
    /// # Errors
    /// `ErrorKind::Memory`.
    pub fn defaults(&self, document: &Document) -> Result<Vec<f64>> {
        let (path, info) = (document.path(), document.info());
        let mut numbers = match self.kind {
            Kind::Move(known) => {
                let places: Vec<_> = info.object.iter().map(|point| point.position).collect();
                let bounds = (!places.is_empty()).then(|| Bounds::of(&places));
                known.defaults(bounds.as_ref(), path.space)?
            }
            _ => Parameter::numbers(self.tables[0], &[], path.space.half_size)?,
        };
        match self.kind {
            Kind::Frames => numbers[0] = document.sampler()?.frame_count() as f64,
            Kind::Avoid => numbers[0] = least_clearance(document),
            Kind::Deform("free-form") => numbers = identity_lattice().to_vec(),
            _ => {}
        }
        let own = numbers.len();
        numbers.extend(Parameter::numbers(
            self.tables[1],
            &[],
            path.space.half_size,
        )?);
        if let Some((at, _)) = Parameter::find(self.tables[1], LAST.name) {
            numbers[own + at] = path.points.len() as f64;
        }
        Ok(numbers)
    }

    /// [`Tool::defaults`] for points from `first` to `last`, counted from 0, which keep their
    /// duration. If a pace within limits takes longer, it is the shortest within them.
    ///
    /// # Errors
    /// `ErrorKind::Range` for points that do not exist; `ErrorKind::Limit`, `ErrorKind::Memory`.
    pub fn defaults_between(
        &self,
        document: &Document,
        first: usize,
        last: usize,
    ) -> Result<Vec<f64>> {
        let mut numbers = self.defaults(document)?;
        for (parameter, at) in [(FIRST, first + 1), (LAST, last + 1)] {
            if let Some(place) = self.place_of(parameter.name) {
                numbers[place] = at as f64;
            }
        }
        if !matches!(self.kind, Kind::Frames | Kind::Retime) {
            return Ok(numbers);
        }
        let path = document.path();
        let frames = document.timeline(|timeline| frames_of(path, timeline, first, last))??;
        numbers[0] = frames as f64;
        if matches!(self.kind, Kind::Retime) {
            // The last pose is a frame of the range only where the path ends.
            let ends = match path.closed {
                true => first == 0 && last + 1 == path.points.len(),
                false => last + 1 == path.points.len(),
            };
            let frames = frames - usize::from(!ends);
            numbers[0] = frames as f64 / document.info().fps;
            let made = ToolArguments::new(self, document, &numbers).retimed(&mut |_, _| true);
            if let Err(Error::Engine(EngineError::Argument(Invalid::PaceSeconds {
                least, ..
            }))) = made
            {
                numbers[0] = least;
            }
        }
        Ok(numbers)
    }

    /// The edit it makes of these numbers and its material, and how well a fit follows its poses.
    ///
    /// # Errors
    /// Those of the tool; the document may still refuse the edit.
    pub fn edit(
        &self,
        document: &Document,
        material: &ToolInput,
        numbers: &[f64],
        progress: Progress<'_>,
    ) -> Result<Made> {
        let own = Parameter::count(self.tables[0]).min(numbers.len());
        let (first, second) = numbers.split_at(own);
        let half_size = document.path().space.half_size;
        Parameter::numbers(self.tables[0], first, half_size)?;
        Parameter::numbers(self.tables[1], second, half_size)?;
        let given = ToolArguments::new(self, document, numbers);
        let path = document.path();
        let block = |at: usize, block: CameraPath, with_targets| Edit::InsertPath {
            at,
            block: Box::new(block),
            fit: FITS[chosen(given.number("fit")).min(FITS.len() - 1)],
            with_targets,
        };
        let here = document.selection().point;
        let put = |made: CameraPath| match chosen(given.number("put")) {
            0 => Edit::ReplacePath(Box::new(made)),
            1 => block(here, made, true),
            _ => block(path.points.len() - 1, made, true),
        };
        let edit = match (self.kind, material) {
            (Kind::Move(known), _) => {
                let fps = document.info().fps;
                put(known.path_with_base_frames(first, path.space, fps, path.base_frames)?)
            }
            (Kind::Draw, ToolInput::Stroke(places)) => {
                put(drawn(document, places, given.number("tolerance"))?)
            }
            (Kind::Shift, _) => given.placed(DVec3::ONE, 0.0, given.place("by"))?,
            (Kind::Turn, _) => {
                given.placed(DVec3::ONE, given.number("angle").to_radians(), DVec3::ZERO)?
            }
            (Kind::Scale, _) => {
                given.placed(DVec3::splat(given.number("factor")), 0.0, DVec3::ZERO)?
            }
            (Kind::Mirror, _) => given.placed(1.0 - 2.0 * given.axis(), 0.0, DVec3::ZERO)?,
            (Kind::Deform(kind), _) => Edit::DeformPoints {
                points: given.points()?,
                deformation: Deformation::new(kind, first)?,
                bounds: Some(cage::bounds(kind, &given.places()?)),
                with_targets: given.number(SEEN.name) != 0.0,
            },
            (Kind::Insert, ToolInput::Block(of_file)) => {
                let with_targets = given.number(SEEN.name) != 0.0;
                block(here, of_file.try_clone()?, with_targets)
            }
            (Kind::Blend, ToolInput::Block(other)) => {
                let weight = given.number("weight");
                let made = blend(&[path, other], &[1.0 - weight, weight])?;
                Edit::ReplacePath(Box::new(made))
            }
            (Kind::Extract, _) => {
                given.extracted()?;
                return Ok(None.into());
            }
            (Kind::Reverse, _) => Edit::Reverse,
            (Kind::Repeat, _) => Edit::Repeat(chosen(given.number("times"))),
            (Kind::Frames, _) => {
                let [first, last] = given.ends();
                let frames = chosen(given.number("frames"));
                Edit::FitFrames {
                    first,
                    last,
                    frames,
                }
            }
            (Kind::Retime, _) => return given.retimed(progress),
            (Kind::Steady, _) => return given.steadied(progress),
            (Kind::Avoid, _) => return given.avoiding(material, progress),
            (Kind::Picture, _) => {
                let what = What::ALL[chosen(given.number("what")).min(What::ALL.len() - 1)];
                let object = material.object_or_own(document)?;
                let how = (given.number("margin"), what);
                let made = document.framed(&object, how, document.info().limits, progress)?;
                let numbers = [
                    ("added", made.added as f64),
                    ("tightest", made.tightest),
                    ("loosest", made.loosest),
                ];
                return Ok(Made::path(made.path, &numbers, Vec::new()));
            }
            (Kind::Tour, _) => {
                let (path, made) = given.tour(material, progress)?;
                return Ok(Made {
                    edit: Some(put(path)),
                    ..made
                });
            }
            (Kind::Fit, ToolInput::Poses(poses, seconds, up)) => {
                let recorded = (&poses[..], seconds.as_deref(), *up);
                let (path, result) = given.fitted(recorded, progress)?;
                return Ok(Made {
                    fit: Some(result),
                    ..Some(put(path)).into()
                });
            }
            (Kind::Insert | Kind::Blend | Kind::Fit | Kind::Draw, _) => return Ok(None.into()),
        };
        Ok(Some(edit).into())
    }

    /// The box around the points, deformed; none if the tool deforms none or its numbers are
    /// invalid.
    #[must_use]
    pub fn cage(&self, document: &Document, numbers: &[f64]) -> Option<Cage> {
        let Kind::Deform(kind) = self.kind else {
            return None;
        };
        let given = ToolArguments::new(self, document, numbers);
        let own = numbers.get(..Parameter::count(self.tables[0]))?;
        let deformation = Deformation::new(kind, own).ok()?;
        let bounds = cage::bounds(kind, &given.places().ok()?);
        Some(Cage::new(bounds, &deformation))
    }

    /// The points as a separate path, with this document's info.
    ///
    /// # Errors
    /// `ErrorKind::Range` if there are no such points; `ErrorKind::Memory`.
    pub fn extracted(&self, document: &Document, numbers: &[f64]) -> Result<Document> {
        let given = ToolArguments::new(self, document, numbers);
        Document::from_parts(given.extracted()?, document.info().try_clone()?)
    }
}

/// The distance from the object that the document's check asks for, else the usual one.
pub(super) fn least_clearance(document: &Document) -> f64 {
    let limit = document.info().limits.get(FindingKind::Clearance);
    let known = limit > 0.0 && limit < OFF;
    let limit = if known {
        limit
    } else {
        FindingKind::Clearance.limit().default
    };
    limit * document.path().space.half_size
}

/// The options with a space, if that holds the poses.
pub(super) fn in_space(options: Options, poses: &[Pose], space: Space) -> Options {
    let far = |pose: &Pose| (DVec3::from(pose.vrp) - space.centre).abs().max_element();
    let holds = poses.iter().all(|pose| far(pose) <= space.half_size);
    Options {
        space: holds.then_some(space),
        up: space.up,
        ..options
    }
}

#[cfg(test)]
#[path = "tool_tests.rs"]
mod tests;
