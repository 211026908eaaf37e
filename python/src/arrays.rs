//! Poses and positions in numpy arrays, row by row: ten and three doubles in a row.

use numpy::ndarray::Array2;
use numpy::{
    PyArray1, PyArray2, PyArray3, PyArrayMethods, PyReadonlyArray1, PyReadonlyArray2,
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
    rows: impl ExactSizeIterator<Item = [f64; N]>,
) -> Bound<'py, PyArray2<f64>> {
    let count = rows.len();
    let mut numbers = Vec::with_capacity(count * N);
    numbers.extend(rows.flatten());
    let shaped = Array2::from_shape_vec((count, N), numbers);
    PyArray2::from_owned_array(py, shaped.unwrap_or_else(|_| Array2::zeros((0, N))))
}

/// N numbers computed from each pose of a contiguous array.
fn of_each<const N: usize>(
    py: Python<'_>,
    array: &PyReadonlyArray2<'_, f64>,
    made: impl Fn(&[f64; WIDTH]) -> [f64; N] + Sync,
) -> PyResult<Vec<f64>> {
    let shape = [array.shape()[0], array.shape()[1]];
    if shape[1] != WIDTH {
        return Err(wrong_shape(shape, WIDTH).into());
    }
    let (rows, _) = array.as_slice()?.as_chunks::<WIDTH>();
    Ok(py.detach(|| {
        let mut all = Vec::with_capacity(rows.len() * N);
        rows.iter()
            .for_each(|row| all.extend_from_slice(&made(row)));
        all
    }))
}

/// View and up of a pose.
fn axes(row: &[f64; WIDTH]) -> [DVec3; 2] {
    [3, 6].map(|k| DVec3::new(row[k], row[k + 1], row[k + 2]))
}

/// Quaternions w x y z of poses: they rotate (0, 0, 1) to the view and (0, 1, 0) to the up.
#[pyfunction]
pub(crate) fn quaternions<'py>(
    py: Python<'py>,
    array: PyReadonlyArray2<'py, f64>,
) -> PyResult<Bound<'py, PyArray2<f64>>> {
    let all = of_each(py, &array, |row| {
        let [view, up] = axes(row);
        let q = quaternion_from_view(view, up);
        [q.w, q.x, q.y, q.z]
    })?;
    PyArray1::from_vec(py, all).reshape((array.shape()[0], 4))
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
    let all = of_each(py, &array, |row| {
        let [view, up] = axes(row);
        let own = [up.cross(view), up, view];
        let [a, b, c] = [0, 1, 2].map(|k| own[columns[k]] * signs[k]);
        let [x, y, z] = [row[0], row[1], row[2]];
        [
            a.x, b.x, c.x, x, a.y, b.y, c.y, y, a.z, b.z, c.z, z, 0.0, 0.0, 0.0, 1.0,
        ]
    })?;
    PyArray1::from_vec(py, all).reshape((array.shape()[0], 4, 4))
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
