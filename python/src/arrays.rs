//! Poses and places in arrays of numpy: ten and three doubles a row, row by row.

use numpy::ndarray::Array2;
use numpy::{
    PyArray2, PyReadonlyArray1, PyReadonlyArray2, PyReadwriteArray2, PyUntypedArrayMethods,
};
use pyo3::prelude::*;
use vides::glam::DVec3;
use vides::math::orientation::{quaternion_from_view, view_from_quaternion};
use vides::path::Pose;

use crate::error::{Failure, Result};

/// Doubles of a pose.
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

/// The rows of an array that is written to.
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
        .map_err(|_| Failure::argument("the array must lie row by row without gaps (order C)"))
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

/// An array of rows of so many numbers.
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

/// Quaternions w x y z of poses: they take (0, 0, 1) to the view and (0, 1, 0) to the up.
#[pyfunction]
pub(crate) fn quaternions<'py>(
    py: Python<'py>,
    array: PyReadonlyArray2<'py, f64>,
) -> PyResult<Bound<'py, PyArray2<f64>>> {
    let poses = poses(&array)?;
    let all: Vec<[f64; 4]> = py.detach(|| {
        let turned = poses.iter().map(|pose| {
            let q = quaternion_from_view(pose.vpn.into(), pose.vup.into());
            [q.w, q.x, q.y, q.z]
        });
        turned.collect()
    });
    Ok(table(py, all.into_iter()))
}

/// Poses of places, quaternions w x y z and zooms.
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
