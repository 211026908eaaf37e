//! A path: load, sample, edit, save.

use std::path::PathBuf;
use std::sync::{PoisonError, RwLock};

use numpy::{PyArray2, PyArrayMethods, PyReadonlyArray1, PyReadonlyArray2, PyReadwriteArray2};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use vides::document::{self, Edit, Info};
use vides::glam::DVec3;
use vides::path::{CameraPath, Change, CurveKind, Motion, Pose, Space, Up};
use vides::tools::check::Finding;
use vides::tools::fit::Progress;

use crate::arrays::{self, WIDTH, rows_mut, table};
use crate::error::{Failure, Result};
use crate::interrupt::interruptible;
use crate::scene::Scene;
use crate::{edits, planning, values};

/// Motions at once: few enough for the second-level cache.
const MOTIONS: usize = 1 << 14;

/// A path with its info and its undo history.
#[pyclass(frozen, module = "vides._vides")]
pub(crate) struct Document(RwLock<document::Document>);

/// Kind, first and last frame, point, orientation, value, limit, sentence, remedy.
type Found = (
    String,
    f64,
    f64,
    usize,
    usize,
    f64,
    f64,
    String,
    &'static str,
);

/// Point, orientation, what changes, amount, frames, first frame, length.
type SectionRow = (usize, usize, &'static str, f64, usize, usize, f64);

impl From<document::Document> for Document {
    fn from(document: document::Document) -> Self {
        Self(RwLock::new(document))
    }
}

impl Document {
    /// Reads the document without holding the interpreter.
    pub(crate) fn read<R: Send, E: Into<Failure>>(
        &self,
        py: Python<'_>,
        look: impl FnOnce(&document::Document) -> Result<R, E> + Send,
    ) -> Result<R> {
        py.detach(|| {
            let document = self.0.read().unwrap_or_else(PoisonError::into_inner);
            look(&document).map_err(Into::into)
        })
    }

    /// Changes the document without holding the interpreter.
    pub(crate) fn write<R: Send, E: Into<Failure>>(
        &self,
        py: Python<'_>,
        change: impl FnOnce(&mut document::Document) -> Result<R, E> + Send,
    ) -> Result<R> {
        py.detach(|| {
            let mut document = self.0.write().unwrap_or_else(PoisonError::into_inner);
            change(&mut document).map_err(Into::into)
        })
    }

    /// Plans an edit on a copy, so that signal handlers may read the path meanwhile, and applies
    /// it. Ctrl-C stops it.
    pub(crate) fn planned<R: Send>(
        &self,
        py: Python<'_>,
        plan: impl FnOnce(&mut document::Document, Progress<'_>) -> Result<(Edit, R)> + Send,
    ) -> PyResult<R> {
        let mut copy = self.read(py, document::Document::try_clone)?;
        let (copy, edit, told) = interruptible(py, |go_on| {
            let before = copy.path().try_clone()?;
            let (edit, told) = plan(&mut copy, go_on)?;
            Ok((before, edit, told))
        })?;
        self.write(py, |document| {
            if *document.path() != copy {
                return Err(Failure::argument(
                    "the path was changed while it was planned",
                ));
            }
            // An edit that changes nothing is no undo step.
            if !matches!(&edit, Edit::ReplacePath(path) if **path == copy) {
                document.apply(edit)?;
            }
            Ok(told)
        })
        .map_err(Into::into)
    }

    fn apply(&self, py: Python<'_>, edit: Edit) -> Result<()> {
        self.write(py, |document| document.apply(edit))
    }

    /// Takes the path shown in a window, as one undo step.
    pub(crate) fn follow(&self, py: Python<'_>, path: CameraPath, info: Info) -> Result<()> {
        self.write(py, |document| {
            document.apply_all([
                Edit::ReplacePath(Box::new(path)),
                Edit::SetInfo(Box::new(info)),
            ])
        })
    }
}

fn collected(places: impl Iterator<Item = DVec3>) -> Vec<[f64; 3]> {
    places.map(DVec3::into).collect()
}

/// A curve by its name in files.
fn curve(name: &str) -> Result<CurveKind> {
    CurveKind::named(name).ok_or_else(|| {
        let known = CurveKind::NAMES.join(", ");
        Failure::argument(format!("the curve is one of {known}, not {name:?}"))
    })
}

pub(crate) fn upright(name: &str) -> Result<Up> {
    Up::named(name).ok_or_else(|| {
        Failure::argument(format!("the up axis must be \"y\" or \"z\", not {name:?}"))
    })
}

/// A finding in a space of this `half_size`: lengths in the path's unit, points from 0.
fn told(finding: &Finding, half_size: f64) -> Found {
    let kind = finding.kind;
    let scale = planning::scale(kind, half_size);
    let finding = Finding {
        value: finding.value * scale,
        limit: finding.limit * scale,
        ..*finding
    };
    let sentence = kind.sentence().replace("{2}", &finding.point.to_string());
    let sentence = sentence.replace("{3}", &finding.orientation.to_string());
    let sentence = sentence.replace(" half sizes/", " lengths/");
    let sentence = sentence.replace(" half sizes", "");
    let number = |value: f64, decimals: usize| format!("{value:.decimals$}");
    (
        planning::keyword(kind),
        finding.first_frame,
        finding.last_frame,
        finding.point,
        finding.orientation,
        finding.value,
        finding.limit,
        finding.say(&sentence, number),
        kind.remedy(),
    )
}

#[pymethods]
impl Document {
    #[new]
    fn new() -> Result<Self> {
        Ok(document::Document::try_new()?.into())
    }

    #[staticmethod]
    fn load(py: Python<'_>, file: PathBuf) -> Result<Self> {
        Ok(py.detach(|| document::Document::load(&file))?.into())
    }

    #[staticmethod]
    fn from_text(py: Python<'_>, text: &str) -> Result<Self> {
        Ok(py.detach(|| document::Document::from_toml(text))?.into())
    }

    #[staticmethod]
    #[pyo3(signature = (positions, look_at, up, closed, frames, zoom, curve, fps))]
    #[expect(clippy::too_many_arguments)]
    fn through(
        py: Python<'_>,
        positions: PyReadonlyArray2<'_, f64>,
        look_at: Option<[f64; 3]>,
        up: &str,
        closed: bool,
        frames: Option<usize>,
        zoom: f64,
        curve: &str,
        fps: f64,
    ) -> Result<Self> {
        let kind = self::curve(curve)?;
        let builder = CameraPath::through(arrays::places(&positions)?);
        let mut builder = builder.up(upright(up)?).zoom(zoom).curve(kind);
        if closed {
            builder = builder.closed();
        }
        if let Some(place) = look_at {
            builder = builder.looking_at(place.into());
        }
        if let Some(frames) = frames {
            builder = builder.frames(frames);
        }
        let info = Info {
            fps,
            ..Info::default()
        };
        let made = py.detach(|| document::Document::from_parts(builder.build()?, info));
        Ok(made?.into())
    }

    fn copy(&self, py: Python<'_>) -> Result<Self> {
        self.read(py, |document| document.try_clone().map(Self::from))
    }

    fn text(&self, py: Python<'_>) -> Result<String> {
        self.read(py, document::Document::to_toml)
    }

    fn save(&self, py: Python<'_>, file: PathBuf) -> Result<()> {
        self.write(py, |document| {
            document.save(&file)?;
            document.mark_saved();
            Ok::<_, Failure>(())
        })
    }

    fn same(&self, py: Python<'_>, other: &Self) -> Result<bool> {
        // One lock at a time: another thread may compare the same two in the other order.
        let (path, info) = other.read(py, |other| {
            Ok::<_, Failure>((other.path().try_clone()?, other.info().clone()))
        })?;
        self.read(py, |document| {
            Ok::<_, Failure>(*document.path() == path && *document.info() == info)
        })
    }

    fn point_count(&self, py: Python<'_>) -> Result<usize> {
        self.read(py, |document| {
            Ok::<_, Failure>(document.path().points.len())
        })
    }

    fn orientation_count(&self, py: Python<'_>, point: usize) -> Result<usize> {
        self.read(py, |document| {
            edits::point(document, point).map(|point| point.orientations.len())
        })
    }

    fn positions<'py>(&self, py: Python<'py>) -> Result<Bound<'py, PyArray2<f64>>> {
        let places = self.read(py, |document| {
            let points = document.path().points.iter();
            Ok::<_, Failure>(collected(points.map(|point| point.position)))
        })?;
        Ok(table(py, places.into_iter()))
    }

    fn position(&self, py: Python<'_>, point: usize) -> Result<[f64; 3]> {
        self.read(py, |document| {
            edits::point(document, point).map(|point| point.position.to_array())
        })
    }

    /// Applies an edit, by its name and its parameters.
    #[pyo3(signature = (name, **given))]
    fn edit(&self, py: Python<'_>, name: &str, given: Option<&Bound<'_, PyDict>>) -> PyResult<()> {
        let edit = edits::by_name(name, given)?;
        Ok(self.apply(py, edit)?)
    }

    fn property<'py>(&self, py: Python<'py>, name: &str) -> PyResult<Bound<'py, PyAny>> {
        let text = self.read(py, |document| document.property(name))?;
        values::from_toml(py, &text)
    }

    fn set_property(&self, py: Python<'_>, name: &str, value: &Bound<'_, PyAny>) -> PyResult<()> {
        let value = values::to_toml(value)?;
        Ok(self.write(py, |document| document.set_property(name, &value))?)
    }

    fn properties(&self, py: Python<'_>) -> Result<Vec<(String, String)>> {
        self.read(py, document::Document::properties)
    }

    fn space(&self, py: Python<'_>) -> Result<([f64; 3], f64, &'static str)> {
        self.read(py, |document| {
            let space = document.path().space;
            Ok::<_, Failure>((space.centre.to_array(), space.half_size, space.up.name()))
        })
    }

    fn set_space(
        &self,
        py: Python<'_>,
        centre: [f64; 3],
        half_size: f64,
        up: &str,
        fit: bool,
    ) -> Result<()> {
        let space = Space {
            centre: centre.into(),
            half_size,
            up: upright(up)?,
        };
        self.apply(py, Edit::SetSpace { space, fit })
    }

    fn frame_count(&self, py: Python<'_>) -> Result<usize> {
        self.read(py, |document| {
            Ok::<_, vides::Error>(document.sampler()?.frame_count())
        })
    }

    fn sample(
        &self,
        py: Python<'_>,
        first: usize,
        mut out: PyReadwriteArray2<'_, f64>,
    ) -> Result<()> {
        let rows = rows_mut(&mut out, WIDTH)?;
        self.read(py, |document| {
            let sampler = document.sampler()?;
            // Fails before anything is written.
            let count = rows.len() / WIDTH;
            if first == 0 || count > (sampler.frame_count() + 1).saturating_sub(first) {
                return Err(Failure::frames(first, count, sampler.frame_count()));
            }
            Ok(sampler.sample(first, Pose::of_numbers(rows))?)
        })
    }

    fn poses<'py>(
        &self,
        py: Python<'py>,
        frames: PyReadonlyArray1<'py, f64>,
    ) -> Result<Bound<'py, PyArray2<f64>>> {
        let frames = arrays::numbers(&frames);
        let poses = self.read(py, |document| {
            let mut poses = vec![Pose::default(); frames.len()];
            document.sampler()?.poses_at(&frames, &mut poses)?;
            Ok::<_, Failure>(poses)
        })?;
        Ok(table(py, poses.iter().map(arrays::row)))
    }

    fn motion<'py>(
        &self,
        py: Python<'py>,
        frames: PyReadonlyArray1<'py, f64>,
    ) -> Result<Bound<'py, PyArray2<f64>>> {
        let frames = arrays::numbers(&frames);
        let array = PyArray2::zeros(py, [frames.len(), 4], false);
        let mut room = array.readwrite();
        let (rows, _) = rows_mut(&mut room, 4)?.as_chunks_mut::<4>();
        self.read(py, |document| {
            let sampler = document.sampler()?;
            let mut motions = vec![Motion::default(); frames.len().min(MOTIONS)];
            for (frames, rows) in frames.chunks(MOTIONS).zip(rows.chunks_mut(MOTIONS)) {
                let motions = &mut motions[..frames.len()];
                sampler.motions_at(frames, motions)?;
                for (row, motion) in rows.iter_mut().zip(motions) {
                    let turning = motion.turning.to_degrees();
                    *row = [motion.distance, motion.speed, turning, motion.curvature];
                }
            }
            Ok::<_, Failure>(())
        })?;
        drop(room);
        Ok(array)
    }

    fn length(&self, py: Python<'_>) -> Result<f64> {
        self.read(py, |document| {
            document.timeline(vides::path::Timeline::length)
        })
    }

    fn sections(&self, py: Python<'_>) -> Result<Vec<SectionRow>> {
        self.read(py, |document| {
            let sampler = document.sampler()?;
            document.timeline(|timeline| {
                let row = |number| {
                    let section = timeline.section(number);
                    let (change, length) = match section.change {
                        Change::Position => ("position", timeline.segment_length(section.point)),
                        Change::View => ("view", 0.0),
                        Change::Roll => ("roll", 0.0),
                        Change::Zoom => ("zoom", 0.0),
                        Change::Nothing => ("nothing", 0.0),
                    };
                    (
                        section.point,
                        section.orientation,
                        change,
                        section.amount,
                        section.frames,
                        sampler.first_frame(number),
                        length,
                    )
                };
                (0..timeline.section_count())
                    .map(row)
                    .collect::<Vec<SectionRow>>()
            })
        })
    }

    fn check(&self, py: Python<'_>) -> PyResult<(Vec<Found>, Vec<String>)> {
        let document = self.read(py, document::Document::try_clone)?;
        interruptible(py, |go_on| {
            let clearance = document.clearance(None)?;
            let found = document.check_against(clearance.as_ref(), go_on)?;
            let notes = document.notes(clearance.as_ref(), true)?;
            let half_size = document.path().space.half_size;
            Ok((
                found.iter().map(|one| told(one, half_size)).collect(),
                notes.iter().map(ToString::to_string).collect(),
            ))
        })
    }

    fn fix(&self, py: Python<'_>) -> PyResult<Vec<Found>> {
        self.planned(py, |document, go_on| {
            let clearance = document.clearance(None)?;
            let mut fixed = Vec::new();
            let half_size = document.path().space.half_size;
            let mut tell = |finding: &Finding| fixed.push(told(finding, half_size));
            document.fix(clearance.as_ref(), &mut tell, go_on)?;
            let path = document.path().try_clone()?;
            Ok((Edit::ReplacePath(Box::new(path)), fixed))
        })
    }

    fn retime(
        &self,
        py: Python<'_>,
        seconds: f64,
        first: usize,
        last: usize,
        given: Vec<(String, Option<f64>)>,
    ) -> PyResult<(f64, planning::Rests)> {
        self.planned(py, |document, go_on| {
            planning::retimed(document, seconds, [first, last], &given, go_on)
        })
    }

    #[pyo3(signature = (clearance, radius, object))]
    fn avoid(
        &self,
        py: Python<'_>,
        clearance: f64,
        radius: f64,
        object: Option<planning::Given<'_>>,
    ) -> PyResult<planning::Detours> {
        let object = object.map(planning::Given::source).transpose()?;
        self.planned(py, |document, go_on| {
            planning::avoided(document, (clearance, radius), object, go_on)
        })
    }

    #[pyo3(signature = (margin, by, object))]
    fn keep_in_picture(
        &self,
        py: Python<'_>,
        margin: f64,
        by: &str,
        object: Option<planning::Given<'_>>,
    ) -> PyResult<(usize, f64, f64)> {
        let object = object.map(planning::Given::source).transpose()?;
        self.planned(py, |document, go_on| {
            planning::framed(document, (margin, by), object, go_on)
        })
    }

    fn steady(&self, py: Python<'_>, period: f64, within: f64) -> PyResult<(f64, f64)> {
        self.planned(py, |document, go_on| {
            planning::steadied(document, period, within, go_on)
        })
    }

    fn limits(&self, py: Python<'_>) -> Result<Vec<(String, f64)>> {
        self.read(py, |document| {
            let half_size = document.path().space.half_size;
            Ok::<_, Failure>(planning::named(&document.info().limits, half_size))
        })
    }

    fn set_limits(&self, py: Python<'_>, given: Vec<(String, Option<f64>)>) -> Result<()> {
        self.write(py, |document| {
            let half_size = document.path().space.half_size;
            let info = Info {
                limits: planning::limits(document.info().limits, &given, half_size)?,
                ..document.info().clone()
            };
            Ok::<_, Failure>(document.apply(Edit::SetInfo(Box::new(info)))?)
        })
    }

    #[pyo3(signature = (object))]
    fn set_object(&self, py: Python<'_>, object: Option<planning::Given<'_>>) -> Result<()> {
        let source = object.map(planning::Given::source).transpose()?;
        self.write(py, |document| {
            let object = source.map(planning::Source::object).transpose()?;
            let info = Info {
                object: object.unwrap_or_default(),
                ..document.info().clone()
            };
            Ok::<_, Failure>(document.apply(Edit::SetInfo(Box::new(info)))?)
        })
    }

    fn object_points<'py>(&self, py: Python<'py>) -> Result<Bound<'py, PyArray2<f64>>> {
        let places = self.read(py, |document| {
            let points = document.info().object.iter();
            Ok::<_, Failure>(collected(points.map(|point| point.position)))
        })?;
        Ok(table(py, places.into_iter()))
    }

    /// A scene with one camera on this path.
    fn scene(&self, py: Python<'_>) -> Result<Scene> {
        self.read(py, |document| document.scene_document().map(Scene::from))
    }

    fn svg(&self, py: Python<'_>, dark: bool) -> PyResult<String> {
        let document = self.read(py, document::Document::try_clone)?;
        interruptible(py, |go_on| {
            Ok(vides::plot::picture(&document, None, dark, go_on)?.into_svg())
        })
    }

    fn undo(&self, py: Python<'_>) -> Result<bool> {
        self.write(py, |document| Ok::<_, Failure>(document.undo()))
    }

    fn redo(&self, py: Python<'_>) -> Result<bool> {
        self.write(py, |document| Ok::<_, Failure>(document.redo()))
    }

    /// The up of an orientation, including the roll.
    fn up_at(&self, py: Python<'_>, point: usize, orientation: usize) -> Result<[f64; 3]> {
        self.read(py, |document| {
            document.up(point, orientation).map(DVec3::into)
        })
    }
}
