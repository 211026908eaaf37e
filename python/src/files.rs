//! Files of other programs, and paths fitted to recorded poses.

use std::path::{Path, PathBuf};

use numpy::{PyArray1, PyArray2, PyReadonlyArray1, PyReadonlyArray2};
use pyo3::prelude::*;
use vides::document::{self, Info};
use vides::error::FromZero;
use vides::formats::{self, As, Format, Holds, Options, Recording, Report, Source, Times};
use vides::path::Up;
use vides::tools::fit::{
    Deviation, Options as FitOptions, Report as FitResult, Tolerance, fit as fit_poses, fit_points,
};

use crate::arrays;
use crate::document::{Document, upright};
use crate::error::{Failure, Result};
use crate::interrupt::interruptible;

/// The options of the command, by their long names.
pub(crate) type Choices = Vec<(String, String)>;

pub(crate) fn options(choices: &Choices) -> Result<Options> {
    let mut options = Options::default();
    for (name, value) in choices {
        options.set(name, value)?;
    }
    Ok(options)
}

pub(crate) fn format(name: Option<&str>) -> Result<Option<&'static Format>> {
    Ok(name.map(formats::by_name).transpose()?)
}

/// The format of the output. A format of several files is never chosen merely because the folder
/// exists.
pub(crate) fn format_for(file: &Path, named: Option<&'static Format>) -> Result<&'static Format> {
    match named {
        Some(format) => Ok(format),
        None if file.is_dir() => {
            let folders = formats::formats().iter().filter(|one| one.is_folder());
            let names: Vec<_> = folders
                .map(|one| format!("format={:?}", one.name))
                .collect();
            Err(Failure::argument(format!(
                "{} is a folder: name the format of several files that is written into it, {}",
                file.display(),
                names.join(" or ")
            )))
        }
        None => Ok(formats::by_target(file)?),
    }
}

pub(crate) fn losses(report: &Report) -> Vec<String> {
    report
        .losses()
        .iter()
        .map(|loss| FromZero(loss).to_string())
        .collect()
}

/// Converts a file, as `vides convert` does. Returns what the target cannot hold.
#[pyfunction]
#[pyo3(signature = (source, target, read_as, write_as, choices))]
pub(crate) fn convert(
    py: Python<'_>,
    source: PathBuf,
    target: PathBuf,
    read_as: Option<&str>,
    write_as: Option<&str>,
    choices: Choices,
) -> Result<Vec<String>> {
    let mut options = options(&choices)?;
    let from = format(read_as)?;
    let to = format_for(&target, format(write_as)?)
        .map_err(|failure| failure.with_format_as("target_format="))?;
    let same = |a: &PathBuf, b: &PathBuf| Some(a.canonicalize().ok()? == b.canonicalize().ok()?);
    if same(&source, &target) == Some(true) {
        let name = target.display();
        return Err(Failure::argument(format!(
            "{name}: the file would be replaced by what is made of it"
        )));
    }
    // If the target does not hold paths, the poses need not become one.
    if to.holds != Holds::Scene {
        options.as_ = options.as_.or(Some(As::Keys));
    }
    py.detach(|| {
        let mut imported = formats::import(&Source::open(&source)?, from, &options)
            .map_err(|error| Failure::from(error).with_format_as("source_format="))?;
        let warned = imported.document.warnings().iter();
        let mut told: Vec<String> = warned
            .map(|warning| FromZero(warning).to_string())
            .collect();
        imported.keep_times(to, &mut options);
        told.extend(losses(&imported.report));
        let report = formats::export(&imported.document, &target, to, &options, &mut |_, _| {})?;
        told.extend(losses(&report));
        Ok(told)
    })
}

/// Poses; their frames and seconds, if any; frames per second; the up axis; losses.
type Recorded<'py> = (
    Bound<'py, PyArray2<f64>>,
    Option<Bound<'py, PyArray1<f64>>>,
    Option<Bound<'py, PyArray1<f64>>>,
    Option<f64>,
    Option<&'static str>,
    Vec<String>,
);

#[pyfunction]
#[pyo3(signature = (file, read_as, choices))]
pub(crate) fn recording<'py>(
    py: Python<'py>,
    file: PathBuf,
    read_as: Option<&str>,
    choices: Choices,
) -> Result<Recorded<'py>> {
    let (options, from) = (options(&choices)?, format(read_as)?);
    let (recording, report) = py.detach(|| {
        let mut report = Report::default();
        let source = Source::open(&file)?;
        let recording = formats::recording(&source, from, &options, &mut report)?;
        Ok::<_, Failure>((recording, report))
    })?;
    let fps = options.fps.or(recording.rate());
    let row = |numbers: Option<Vec<f64>>| numbers.map(|numbers| PyArray1::from_vec(py, numbers));
    Ok((
        arrays::table(py, recording.poses.iter().map(arrays::row)),
        row(recording.frames),
        row(recording.seconds),
        fps,
        options.up.or(recording.up).map(Up::name),
        losses(&report),
    ))
}

/// Writes poses, one a frame, or at their frames in formats whose poses have times. Returns what
/// the format cannot hold.
#[pyfunction]
#[pyo3(signature = (file, write_as, choices, poses, frames, fps, up))]
#[expect(clippy::too_many_arguments)]
pub(crate) fn save_poses(
    py: Python<'_>,
    file: PathBuf,
    write_as: Option<&str>,
    choices: Choices,
    poses: PyReadonlyArray2<'_, f64>,
    frames: PyReadonlyArray1<'_, f64>,
    fps: f64,
    up: Option<&str>,
) -> Result<Vec<String>> {
    let (mut options, to) = (options(&choices)?, format(write_as)?);
    let (poses, frames) = (arrays::poses(&poses)?, arrays::numbers(&frames));
    let up = up.map(upright).transpose()?;
    py.detach(|| {
        let to = format_for(&file, to)?;
        let recording = Recording {
            poses,
            first_frame: frames.first().copied(),
            frames: to.own_times.then_some(frames),
            fps: Some(fps),
            up,
            ..Recording::default()
        };
        if to.own_times && options.fps.is_none() && options.frames.is_none() {
            options.times = options.times.or(Some(Times::Own));
        }
        let keyed = Options {
            as_: Some(As::Keys),
            ..Options::default()
        };
        let mut report = Report::default();
        let document = recording.into_scene(&keyed, &mut report)?;
        let report = formats::export(&document, &file, to, &options, &mut |_, _| {})?;
        Ok(losses(&report))
    })
}

/// Points and poses; greatest and RMS deviation of position, view and field of view; noise; holds,
/// gaps, cuts, repeated times; a better tolerance with its angle and points; the outliers and the
/// points of a robust fit that is better; the text.
type FitReport = (
    [usize; 2],
    [[f64; 2]; 3],
    f64,
    [usize; 4],
    Option<(f64, f64, usize)>,
    Option<(usize, usize)>,
    String,
);

fn told(report: &FitResult) -> FitReport {
    let pair = |off: Deviation| [off.greatest, off.rms];
    (
        [report.points, report.poses],
        [report.position, report.view, report.lens].map(pair),
        report.noise,
        [report.holds, report.gaps, report.cuts, report.dropped],
        report
            .better
            .map(|(better, points)| (better.position, better.angle, points)),
        report.robust,
        report.to_string(),
    )
}

/// Fits a path to poses, of at most `points` points if that is given; also returns the indices of
/// the poses that were ignored, and the report.
#[pyfunction]
#[pyo3(signature = (poses, seconds, fps, tolerance, angle, up, robust, points))]
#[expect(clippy::too_many_arguments)]
pub(crate) fn fit(
    py: Python<'_>,
    poses: PyReadonlyArray2<'_, f64>,
    seconds: Option<PyReadonlyArray1<'_, f64>>,
    fps: f64,
    tolerance: Option<f64>,
    angle: f64,
    up: &str,
    robust: bool,
    points: Option<usize>,
) -> PyResult<(Document, Vec<usize>, FitReport)> {
    let poses = arrays::poses(&poses)?;
    let seconds = seconds.as_ref().map(arrays::numbers);
    let up = upright(up)?;
    interruptible(py, |go_on| {
        let options = FitOptions {
            up,
            robust,
            ..FitOptions::from(Tolerance {
                position: tolerance.unwrap_or(Tolerance::usual(&poses).position),
                angle,
            })
        };
        let seconds = seconds.as_deref();
        let fitted = match points {
            Some(points) => fit_points(&poses, seconds, fps, &options, points, go_on)?.0,
            None => fit_poses(&poses, seconds, fps, &options, go_on)?,
        };
        let report = told(&fitted.report);
        let info = Info {
            fps,
            ..Info::default()
        };
        let document = document::Document::from_parts(fitted.path, info)?;
        Ok((document.into(), fitted.left_out, report))
    })
}
