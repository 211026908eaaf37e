//! Poses and positions in numpy arrays, row by row: ten and three doubles in a row.

use numpy::ndarray::{Dimension, IntoDimension};
use numpy::{
    PyArray, PyArray2, PyArray3, PyArrayMethods, PyReadonlyArray1, PyReadonlyArray2,
    PyReadwriteArray2, PyUntypedArrayMethods,
};
use pyo3::prelude::*;
use vides::glam::DVec3;
use vides::math::orientation::{quaternion_from_view, view_from_quaternion};
use vides::path::Pose;

use crate::error::{Failure, Result};

/// The doubles of a pose.
pub(crate) const WIDTH: usize = 10;

pub(crate) fn row(pose: &Pose) -> [f64; WIDTH] {
    let ([a, b, c], [d, e, f], [g, h, i]) = (pose.vrp, pose.vpn, pose.vup);
    [a, b, c, d, e, f, g, h, i, pose.zoom]
}

fn pose(row: &[f64]) -> Option<Pose> {
    let &[a, b, c, d, e, f, g, h, i, zoom] = row else {
        return None;
    };
    Some(Pose {
        vrp: [a, b, c],
        vpn: [d, e, f],
        vup: [g, h, i],
        zoom,
    })
}

/// The rows of a writeable array.
pub(crate) fn rows_mut<'a>(
    array: &'a mut PyReadwriteArray2<'_, f64>,
    width: usize,
) -> Result<&'a mut [f64]> {
    let shape = [array.shape()[0], array.shape()[1]];
    if shape[1] != width {
        return Err(wrong_shape(shape, width));
    }
    array
        .as_slice_mut()
        .map_err(|_| Failure::argument("the array must be contiguous row by row (order C)"))
}

fn wrong_shape([rows, columns]: [usize; 2], width: usize) -> Failure {
    Failure::argument(format!(
        "the array must have the shape (n, {width}), not ({rows}, {columns})"
    ))
}

/// A copy of the rows of an array.
fn rows(array: &PyReadonlyArray2<'_, f64>, width: usize) -> Result<Vec<f64>> {
    let shape = [array.shape()[0], array.shape()[1]];
    if shape[1] != width {
        return Err(wrong_shape(shape, width));
    }
    Ok(array.as_array().iter().copied().collect())
}

pub(crate) fn places(array: &PyReadonlyArray2<'_, f64>) -> Result<Vec<DVec3>> {
    let numbers = rows(array, 3)?;
    let (places, _) = numbers.as_chunks::<3>();
    Ok(places.iter().map(|&place| place.into()).collect())
}

pub(crate) fn poses(array: &PyReadonlyArray2<'_, f64>) -> Result<Vec<Pose>> {
    let numbers = rows(array, WIDTH)?;
    Ok(numbers.chunks(WIDTH).filter_map(pose).collect())
}

pub(crate) fn numbers(array: &PyReadonlyArray1<'_, f64>) -> Vec<f64> {
    array.as_array().iter().copied().collect()
}

/// An array with N numbers in a row.
pub(crate) fn table<'py, const N: usize>(
    py: Python<'py>,
    rows: impl ExactSizeIterator<Item = [f64; N]> + Send,
) -> Bound<'py, PyArray2<f64>> {
    array_of(py, [rows.len(), N], rows, |row, to| *to = row)
}

/// An array of numpy's own memory, whose pages are large and so soon there. `write` fills each N
/// numbers, which are zero, in their place.
fn array_of<'py, D: Dimension, Row, const N: usize>(
    py: Python<'py>,
    shape: impl IntoDimension<Dim = D>,
    rows: impl Iterator<Item = Row> + Send,
    write: impl Fn(Row, &mut [f64; N]) + Sync,
) -> Bound<'py, PyArray<f64, D>> {
    let array = PyArray::zeros(py, shape, false);
    // A new array is contiguous.
    if let Ok(numbers) = array.readwrite().as_slice_mut() {
        let (room, _) = numbers.as_chunks_mut::<N>();
        py.detach(|| {
            room.iter_mut()
                .zip(rows)
                .for_each(|(to, row)| write(row, to))
        });
    }
    array
}

/// The poses of a contiguous array.
fn pose_rows<'a>(array: &'a PyReadonlyArray2<'_, f64>) -> PyResult<&'a [[f64; WIDTH]]> {
    let shape = [array.shape()[0], array.shape()[1]];
    if shape[1] != WIDTH {
        return Err(wrong_shape(shape, WIDTH).into());
    }
    Ok(array.as_slice()?.as_chunks::<WIDTH>().0)
}

/// View and up of a pose.
fn axes(&[_, _, _, a, b, c, d, e, f, _]: &[f64; WIDTH]) -> [DVec3; 2] {
    [DVec3::new(a, b, c), DVec3::new(d, e, f)]
}

/// Quaternions w x y z of poses: they rotate (0, 0, 1) to the view and (0, 1, 0) to the up.
#[pyfunction]
pub(crate) fn quaternions<'py>(
    py: Python<'py>,
    array: PyReadonlyArray2<'py, f64>,
) -> PyResult<Bound<'py, PyArray2<f64>>> {
    let poses = pose_rows(&array)?;
    let write = |row: &[f64; WIDTH], to: &mut [f64; 4]| {
        let [view, up] = axes(row);
        let q = quaternion_from_view(view, up);
        (to[0], to[1], to[2], to[3]) = (q.w, q.x, q.y, q.z);
    };
    Ok(array_of(py, [poses.len(), 4], poses.iter(), write))
}

/// Camera-to-world matrices of poses. Column k is the column of (left, up, view) that `columns`
/// names, times its sign.
#[pyfunction]
pub(crate) fn matrices<'py>(
    py: Python<'py>,
    array: PyReadonlyArray2<'py, f64>,
    columns: [usize; 3],
    signs: [f64; 3],
) -> PyResult<Bound<'py, PyArray3<f64>>> {
    let poses = pose_rows(&array)?;
    let write = |row: &[f64; WIDTH], to: &mut [f64; 16]| {
        let [view, up] = axes(row);
        let own = [up.cross(view), up, view];
        for k in 0..3 {
            let axis = own[columns[k]] * signs[k];
            (to[k], to[4 + k], to[8 + k]) = (axis.x, axis.y, axis.z);
            to[4 * k + 3] = row[k];
        }
        to[15] = 1.0;
    };
    Ok(array_of(py, [poses.len(), 4, 4], poses.iter(), write))
}

/// Poses from positions, quaternions w x y z and zooms.
#[pyfunction]
pub(crate) fn poses_of<'py>(
    py: Python<'py>,
    positions: PyReadonlyArray2<'py, f64>,
    quaternions: PyReadonlyArray2<'py, f64>,
    zoom: PyReadonlyArray1<'py, f64>,
) -> PyResult<Bound<'py, PyArray2<f64>>> {
    let (places, turns) = (places(&positions)?, rows(&quaternions, 4)?);
    let (turns, _) = turns.as_chunks::<4>();
    let zoom = numbers(&zoom);
    if places.len() != turns.len() || places.len() != zoom.len() {
        return Err(
            Failure::argument("there must be as many positions as rotations and zooms").into(),
        );
    }
    let mut all = Vec::with_capacity(places.len());
    for (at, ((place, &[w, x, y, z]), zoom)) in places.iter().zip(turns).zip(zoom).enumerate() {
        let q = vides::glam::DQuat::from_xyzw(x, y, z, w);
        let length = q.length();
        if !(length.is_finite() && length > 0.0) {
            return Err(Failure::argument(format!(
                "pose {at}: the rotation is zero or not finite"
            ))
            .into());
        }
        let (view, up) = view_from_quaternion(q / length);
        all.push(row(&Pose {
            vrp: place.to_array(),
            vpn: view.to_array(),
            vup: up.to_array(),
            zoom,
        }));
    }
    Ok(table(py, all.into_iter()))
}
