//! A scene: load, evaluate, edit, save.

use std::path::PathBuf;
use std::sync::{PoisonError, RwLock};

use numpy::{PyArray2, PyReadonlyArray1, PyReadonlyArray2, PyReadwriteArray2};
use pyo3::IntoPyObjectExt;
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use vides::document::{self, Info, SceneDocument};
use vides::error::FromZero;
use vides::formats::{self, Source};
use vides::glam::{DQuat, DVec3};
use vides::path::Space;
use vides::scene::{
    Camera, Channel, Extrapolation, FollowPath, Interpolation, Kind, Light, Mesh, Node, NodeState,
    Object, Track, Warnings,
};

use crate::arrays::{self, WIDTH, rows_mut, table};
use crate::document::{Document, upright};
use crate::error::{Failure, Result};
use crate::files::{Choices, format, format_for, losses, options};

/// The number of states that are computed at once.
const BLOCK: usize = 256;

/// A scene with its info.
#[pyclass(frozen, module = "vides._vides")]
pub(crate) struct Scene(RwLock<SceneDocument>);

impl From<SceneDocument> for Scene {
    fn from(document: SceneDocument) -> Self {
        Self(RwLock::new(document))
    }
}

/// Name, kind, parent, aim.
type NodeRow = (String, String, Option<usize>, Option<usize>);

/// Channel, interpolation, frames, values.
type TrackRow = (String, String, Vec<f64>, Vec<f64>);

/// Colours, intensities, cones and visibility of the nodes.
type Looks = (Vec<[f64; 3]>, Vec<f64>, Vec<[f64; 2]>, Vec<bool>);

/// World matrices row by row, poses, and the looks.
type States<'py> = (Bound<'py, PyArray2<f64>>, Bound<'py, PyArray2<f64>>, Looks);

impl Scene {
    pub(crate) fn read<R: Send, E: Into<Failure>>(
        &self,
        py: Python<'_>,
        look: impl FnOnce(&SceneDocument) -> Result<R, E> + Send,
    ) -> Result<R> {
        py.detach(|| {
            let document = self.0.read().unwrap_or_else(PoisonError::into_inner);
            look(&document).map_err(Into::into)
        })
    }

    fn write<R: Send, E: Into<Failure>>(
        &self,
        py: Python<'_>,
        change: impl FnOnce(&mut SceneDocument) -> Result<R, E> + Send,
    ) -> Result<R> {
        py.detach(|| {
            let mut document = self.0.write().unwrap_or_else(PoisonError::into_inner);
            change(&mut document).map_err(Into::into)
        })
    }
}

/// The rows of a matrix that is stored by columns.
fn rows(matrix: &[f64; 16]) -> [f64; 16] {
    std::array::from_fn(|at| matrix[at % 4 * 4 + at / 4])
}

fn kind(name: &str) -> Result<Kind> {
    Ok(match name {
        "group" => Kind::Group,
        "object" => Kind::Object(Object::default()),
        "camera" => Kind::Camera(Camera::default()),
        "directional" => Kind::Light(Light::Directional),
        "point" => Kind::Light(Light::Point),
        "spot" => Kind::Light(Light::Spot),
        _ => {
            return Err(Failure::argument(format!(
                "a node is a \"group\", an \"object\", a \"camera\" or a light: \"directional\", \
                 \"point\" or \"spot\", not {name:?}"
            )));
        }
    })
}

fn extrapolation(name: &str) -> Result<Extrapolation> {
    Extrapolation::named(name).ok_or_else(|| {
        Failure::argument(format!(
            "before and after must be \"hold\", \"repeat\", \"pingpong\" or \"offset\", not \
             {name:?}"
        ))
    })
}

/// The smoothest interpolation that fits a channel.
fn smoothest(channel: &Channel) -> Result<Interpolation> {
    let fits = |name: &&str| Interpolation::names(Some(channel)).any(|known| known == *name);
    let name = ["cubic", "catmull-rom"].into_iter().find(fits);
    Ok(Interpolation::parse(name.unwrap_or("step"))?)
}

/// Makes a warning an error: Python has no host functions that may fail.
fn told(warnings: Warnings) -> Result<()> {
    warnings
        .into_error()
        .map_or(Ok(()), |error| Err(error.into()))
}

#[pymethods]
impl Scene {
    #[new]
    fn new() -> Result<Self> {
        Ok(SceneDocument::new(vides::scene::Scene::new(), Info::default())?.into())
    }

    /// Loads a scene; also returns the losses.
    #[staticmethod]
    #[pyo3(signature = (file, read_as, choices))]
    fn load(
        py: Python<'_>,
        file: PathBuf,
        read_as: Option<&str>,
        choices: Choices,
    ) -> Result<(Self, Vec<String>)> {
        let (from, options) = (format(read_as)?, options(&choices)?);
        py.detach(|| {
            let imported = formats::import(&Source::open(&file)?, from, &options)?;
            let warned = imported.document.warnings().iter();
            let mut told: Vec<String> = warned
                .map(|warning| FromZero(warning).to_string())
                .collect();
            told.extend(losses(&imported.report));
            Ok((imported.document.into(), told))
        })
    }

    #[staticmethod]
    fn from_text(py: Python<'_>, text: &str) -> Result<Self> {
        Ok(py.detach(|| SceneDocument::from_toml(text))?.into())
    }

    fn text(&self, py: Python<'_>) -> Result<String> {
        self.read(py, SceneDocument::to_toml)
    }

    fn copy(&self, py: Python<'_>) -> Result<Self> {
        self.read(py, |document| document.try_clone().map(Self::from))
    }

    fn save(&self, py: Python<'_>, file: PathBuf) -> Result<()> {
        self.read(py, |document| document.save(&file))
    }

    /// Exports to a file; returns the losses.
    #[pyo3(signature = (file, write_as, choices))]
    fn export(
        &self,
        py: Python<'_>,
        file: PathBuf,
        write_as: Option<&str>,
        choices: Choices,
    ) -> Result<Vec<String>> {
        let (to, options) = (format(write_as)?, options(&choices)?);
        self.read(py, |document| {
            let to = format_for(&file, to)?;
            let report = formats::export(document, &file, to, &options, &mut |_, _| {})?;
            Ok::<_, Failure>(losses(&report))
        })
    }

    /// Exports to memory.
    #[pyo3(signature = (write_as, choices))]
    fn render(
        &self,
        py: Python<'_>,
        write_as: &str,
        choices: Choices,
    ) -> Result<(Vec<u8>, Vec<String>)> {
        let (to, options) = (formats::by_name(write_as)?, options(&choices)?);
        self.read(py, |document| {
            let mut bytes = Vec::new();
            let report = formats::export_to(document, &mut bytes, to, &options, &mut |_, _| {})?;
            Ok::<_, Failure>((bytes, losses(&report)))
        })
    }

    fn nodes(&self, py: Python<'_>) -> Result<Vec<NodeRow>> {
        self.read(py, |document| {
            let nodes = document.scene.nodes().iter();
            let row = |node: &Node| {
                let kind = match &node.kind {
                    Kind::Light(light) => light.name(),
                    other => other.name(),
                };
                (node.name.clone(), kind.to_owned(), node.parent, node.aim)
            };
            Ok::<_, Failure>(nodes.map(row).collect())
        })
    }

    fn find(&self, py: Python<'_>, name: &str) -> Result<usize> {
        self.read(py, |document| {
            let at = document.scene.find(name);
            at.ok_or_else(|| Failure::from(formats::Error::NoNode(name.into())))
        })
    }

    #[pyo3(signature = (name, kind, parent=None))]
    fn add(&self, py: Python<'_>, name: &str, kind: &str, parent: Option<usize>) -> Result<usize> {
        let mut node = Node::new(name, self::kind(kind)?);
        node.parent = parent;
        self.write(py, |document| document.scene.add(node))
    }

    fn remove(&self, py: Python<'_>, node: usize) -> Result<()> {
        self.write(py, |document| document.scene.remove(node))
    }

    fn rename(&self, py: Python<'_>, node: usize, name: &str) -> Result<()> {
        self.write(py, |document| document.scene.set_name(node, name))
    }

    /// Changes values of a node without keys, by name.
    #[pyo3(signature = (node, name, value))]
    fn set_rest(
        &self,
        py: Python<'_>,
        node: usize,
        name: &str,
        value: &Bound<'_, PyAny>,
    ) -> PyResult<()> {
        let mut changed = self.read(py, |document| document.scene.node(node).cloned())?;
        let rest = &mut changed.rest;
        match name {
            "position" => rest.position = value.extract::<[f64; 3]>()?.into(),
            "rotation" => {
                let [w, x, y, z] = value.extract()?;
                rest.rotation = DQuat::from_xyzw(x, y, z, w);
            }
            "scale" => rest.scale = value.extract::<[f64; 3]>()?.into(),
            "pivot" => changed.pivot = value.extract::<[f64; 3]>()?.into(),
            "visible" => rest.visible = value.extract()?,
            "zoom" => rest.zoom = value.extract()?,
            "roll" => rest.roll = value.extract()?,
            "colour" => rest.colour = value.extract()?,
            "intensity" => rest.intensity = value.extract()?,
            "cone" => rest.cone = value.extract()?,
            "aim_weight" => rest.aim_weight = value.extract()?,
            "aim" => changed.aim = value.extract()?,
            "parent" => changed.parent = value.extract()?,
            "near" | "far" => match &mut changed.kind {
                Kind::Camera(camera) if name == "near" => camera.near = value.extract()?,
                Kind::Camera(camera) => camera.far = value.extract()?,
                other => {
                    let other = other.name();
                    return Err(PyTypeError::new_err(format!("{other} has no {name}")));
                }
            },
            _ => return Err(PyTypeError::new_err(format!("a node has no {name}"))),
        }
        Ok(self.write(py, |document| document.scene.set_node(node, &changed))?)
    }

    /// A value of a node without keys, by name; `None` if there is no such value.
    fn rest<'py>(
        &self,
        py: Python<'py>,
        node: usize,
        name: &str,
    ) -> PyResult<Option<Bound<'py, PyAny>>> {
        let node = self.read(py, |document| document.scene.node(node).cloned())?;
        let rest = &node.rest;
        Ok(Some(match (name, &node.kind) {
            ("position", _) => rest.position.to_array().into_bound_py_any(py)?,
            ("rotation", _) => {
                let q = rest.rotation;
                [q.w, q.x, q.y, q.z].into_bound_py_any(py)?
            }
            ("scale", _) => rest.scale.to_array().into_bound_py_any(py)?,
            ("pivot", _) => node.pivot.to_array().into_bound_py_any(py)?,
            ("visible", _) => rest.visible.into_bound_py_any(py)?,
            ("zoom", Kind::Camera(_)) => rest.zoom.into_bound_py_any(py)?,
            ("roll", Kind::Camera(_)) => rest.roll.into_bound_py_any(py)?,
            ("near", Kind::Camera(camera)) => camera.near.into_bound_py_any(py)?,
            ("far", Kind::Camera(camera)) => camera.far.into_bound_py_any(py)?,
            ("aim_weight", kind) if kind.looks() => rest.aim_weight.into_bound_py_any(py)?,
            ("colour", Kind::Light(_) | Kind::Object(_)) => rest.colour.into_bound_py_any(py)?,
            ("intensity", Kind::Light(_)) => rest.intensity.into_bound_py_any(py)?,
            ("cone", Kind::Light(_)) => rest.cone.into_bound_py_any(py)?,
            _ => return Ok(None),
        }))
    }

    /// The value of a channel at a frame.
    fn value(&self, py: Python<'_>, node: usize, channel: &str, frame: f64) -> Result<Vec<f64>> {
        let channel = Channel::parse(channel)?;
        self.read(py, |document| {
            let mut warnings = Warnings::default();
            let value = document.scene.value(node, &channel, frame, &mut warnings)?;
            told(warnings).map(|()| value)
        })
    }

    #[expect(clippy::too_many_arguments)]
    fn set_keys(
        &self,
        py: Python<'_>,
        node: usize,
        channel: &str,
        interpolation: Option<&str>,
        frames: PyReadonlyArray1<'_, f64>,
        values: PyReadonlyArray2<'_, f64>,
        shape: PyReadonlyArray1<'_, f64>,
        before: &str,
        after: &str,
    ) -> Result<()> {
        let values = values.as_array().iter().copied().collect();
        let channel = Channel::parse(channel)?;
        let interpolation = match interpolation {
            Some(name) => Interpolation::parse(name)?,
            None => smoothest(&channel)?,
        };
        let track = Track::new(
            channel,
            interpolation,
            arrays::numbers(&frames),
            values,
            arrays::numbers(&shape),
        )?;
        let track = track.with_extrapolation(extrapolation(before)?, extrapolation(after)?)?;
        self.write(py, |document| document.scene.set_track(node, track))
    }

    fn remove_keys(&self, py: Python<'_>, node: usize, channel: &str) -> Result<()> {
        let channel = Channel::parse(channel)?;
        self.write(py, |document| document.scene.remove_track(node, &channel))
    }

    /// For each track of a node: channel, interpolation, frames and values.
    fn tracks(&self, py: Python<'_>, node: usize) -> Result<Vec<TrackRow>> {
        self.read(py, |document| {
            let tracks = document.scene.node(node)?.keys().tracks().iter();
            let row = |track: &Track| {
                let names = (
                    track.channel().to_string(),
                    track.interpolation().to_string(),
                );
                (
                    names.0,
                    names.1,
                    track.frames().to_vec(),
                    track.values().to_vec(),
                )
            };
            Ok::<_, Failure>(tracks.map(row).collect())
        })
    }

    #[pyo3(signature = (node, path, start, beyond))]
    fn set_path(
        &self,
        py: Python<'_>,
        node: usize,
        path: Option<&Document>,
        start: f64,
        beyond: &str,
    ) -> Result<()> {
        let beyond = extrapolation(beyond)?;
        let follow = match path {
            Some(path) => {
                let path = path.read(py, |path| path.path().try_clone())?;
                Some(FollowPath::new(path, start, beyond)?)
            }
            None => None,
        };
        self.write(py, |document| document.scene.set_path(node, follow))
    }

    /// The path of a node, by default of the shown camera.
    #[pyo3(signature = (node=None))]
    fn path(&self, py: Python<'_>, node: Option<usize>) -> Result<Document> {
        self.read(py, |document| {
            let scene = &document.scene;
            let shown = node.or_else(|| scene.shown_camera());
            let at = shown.ok_or(vides::Error::from(vides::error::Refused::NoCamera))?;
            let node = scene.node(at)?;
            let none = || vides::error::Refused::NoPathOf((&node.name).into());
            let follow = node.path().ok_or_else(|| vides::Error::from(none()))?;
            let path = follow.path().try_clone()?;
            let made = document::Document::from_parts(path, document.info.clone())?;
            Ok::<_, Failure>(Document::from(made))
        })
    }

    fn set_mesh(
        &self,
        py: Python<'_>,
        node: usize,
        points: PyReadonlyArray2<'_, f64>,
        triangles: Vec<[u32; 3]>,
        lines: Vec<[u32; 2]>,
    ) -> Result<()> {
        let mesh = Mesh {
            points: arrays::places(&points)?,
            colours: Vec::new(),
            lines,
            triangles,
        };
        self.write(py, |document| document.scene.set_mesh(node, mesh))
    }

    fn load_mesh(&self, py: Python<'_>, node: usize, file: PathBuf) -> Result<()> {
        let (source, mesh) = py.detach(|| document::load_mesh(&file))?;
        self.write(py, |document| {
            document.scene.set_mesh_of(node, source, mesh)
        })
    }

    fn triangles(&self, py: Python<'_>, node: usize) -> Result<Vec<[u32; 3]>> {
        self.read(py, |document| {
            let object = document.scene.object(node)?;
            Ok::<_, Failure>(object.mesh().triangles.clone())
        })
    }

    fn vertices<'py>(
        &self,
        py: Python<'py>,
        node: usize,
        frame: f64,
    ) -> Result<Bound<'py, PyArray2<f64>>> {
        let points = self.read(py, |document| {
            let mut warnings = Warnings::default();
            let count = document.scene.object(node)?.mesh().points.len();
            let mut points = vec![DVec3::ZERO; count];
            document
                .scene
                .vertices(node, frame, &mut points, &mut warnings)?;
            told(warnings).map(|()| points)
        })?;
        Ok(table(py, points.iter().map(DVec3::to_array)))
    }

    #[getter]
    fn camera(&self, py: Python<'_>) -> Result<Option<usize>> {
        self.read(py, |document| {
            Ok::<_, Failure>(document.scene.shown_camera())
        })
    }

    #[setter]
    fn set_camera(&self, py: Python<'_>, node: Option<usize>) -> Result<()> {
        self.write(py, |document| document.scene.set_camera(node))
    }

    #[getter]
    fn range(&self, py: Python<'_>) -> Result<(f64, f64)> {
        self.read(py, |document| {
            Ok::<_, Failure>(document.scene.frame_range())
        })
    }

    #[setter]
    fn set_range(&self, py: Python<'_>, range: Option<(f64, f64)>) -> Result<()> {
        self.write(py, |document| document.scene.set_range(range))
    }

    #[getter]
    fn fps(&self, py: Python<'_>) -> Result<f64> {
        self.read(py, |document| Ok::<_, Failure>(document.info.fps))
    }

    #[setter]
    fn set_fps(&self, py: Python<'_>, fps: f64) -> Result<()> {
        self.write(py, |document| {
            let info = Info {
                fps,
                ..document.info.clone()
            };
            info.check(document.scene.space())?;
            document.info = info;
            Ok::<_, Failure>(())
        })
    }

    fn space(&self, py: Python<'_>) -> Result<([f64; 3], f64, &'static str)> {
        self.read(py, |document| {
            let space = document.scene.space();
            Ok::<_, Failure>((space.centre.to_array(), space.half_size, space.up.name()))
        })
    }

    fn set_space(&self, py: Python<'_>, centre: [f64; 3], half_size: f64, up: &str) -> Result<()> {
        let space = Space {
            centre: centre.into(),
            half_size,
            up: upright(up)?,
        };
        self.write(py, |document| document.scene.set_space(space))
    }

    fn states<'py>(&self, py: Python<'py>, frame: f64) -> Result<States<'py>> {
        let states = self.read(py, |document| {
            let mut warnings = Warnings::default();
            let mut states = vec![NodeState::default(); document.scene.nodes().len()];
            document.scene.evaluate(frame, &mut states, &mut warnings)?;
            told(warnings).map(|()| states)
        })?;
        let looks = (
            states.iter().map(|state| state.colour).collect(),
            states.iter().map(|state| state.intensity).collect(),
            states.iter().map(|state| state.cone).collect(),
            states.iter().map(|state| state.visible != 0).collect(),
        );
        Ok((
            table(py, states.iter().map(|state| rows(&state.matrix))),
            table(py, states.iter().map(|state| arrays::row(&state.pose))),
            looks,
        ))
    }

    /// The states of a node at regular frames, one for each row of the arrays: poses and world
    /// matrices by rows.
    fn sample(
        &self,
        py: Python<'_>,
        node: usize,
        first: f64,
        step: f64,
        mut poses: PyReadwriteArray2<'_, f64>,
        mut matrices: PyReadwriteArray2<'_, f64>,
    ) -> Result<()> {
        let (poses, matrices) = (rows_mut(&mut poses, WIDTH)?, rows_mut(&mut matrices, 16)?);
        self.read(py, |document| {
            let mut states = vec![NodeState::default(); BLOCK];
            let (poses, _) = poses.as_chunks_mut::<WIDTH>();
            let (matrices, _) = matrices.as_chunks_mut::<16>();
            let blocks = poses.chunks_mut(BLOCK).zip(matrices.chunks_mut(BLOCK));
            for (block, (poses, matrices)) in blocks.enumerate() {
                let states = &mut states[..poses.len()];
                let mut warnings = Warnings::default();
                #[expect(clippy::cast_precision_loss)]
                let from = first + step * (block * BLOCK) as f64;
                document
                    .scene
                    .sample(node, from, step, states, &mut warnings)?;
                told(warnings)?;
                for ((state, pose), matrix) in states.iter().zip(poses).zip(matrices) {
                    *pose = arrays::row(&state.pose);
                    *matrix = rows(&state.matrix);
                }
            }
            Ok::<_, Failure>(())
        })
    }
}
