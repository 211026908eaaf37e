"""Matrices and quaternions, held against what a camera sees."""

from typing import get_args

import numpy as np
import pytest

import vides
from vides._samples import Convention

RNG = np.random.default_rng(5)


@pytest.fixture(params=["y", "z"])
def samples(request: pytest.FixtureRequest) -> vides.Samples:
    path = vides.Path(RNG.uniform(-5, 5, (7, 3)), up=request.param, frames=150)
    for point in path.points:
        point.target = RNG.uniform(-5, 5, 3)
        point.roll = RNG.uniform(-179, 179)
    return path.sample()


# In the camera's own coordinates: what lies ahead, to the right and above.
SEEN = {
    "opengl": ([0, 0, -1], [1, 0, 0], [0, 1, 0]),
    "opencv": ([0, 0, 1], [1, 0, 0], [0, -1, 0]),
    "ros": ([1, 0, 0], [0, -1, 0], [0, 0, 1]),
    "vides": ([0, 0, 1], [-1, 0, 0], [0, 1, 0]),
}


@pytest.mark.parametrize("convention", get_args(Convention))
def test_a_convention_says_where_things_are(samples: vides.Samples, convention: Convention) -> None:
    matrices = samples.matrices(convention)
    assert matrices.shape == (150, 4, 4)
    np.testing.assert_allclose(np.linalg.det(matrices[:, :3, :3]), 1, atol=1e-12)
    ahead, right, above = (np.array(axis, dtype=float) for axis in SEEN[convention])
    turn = matrices[:, :3, :3]
    np.testing.assert_allclose(turn @ ahead, samples.view, atol=1e-12)
    np.testing.assert_allclose(turn @ above, samples.up, atol=1e-12)
    np.testing.assert_allclose(turn @ right, np.cross(samples.view, samples.up), atol=1e-12)
    np.testing.assert_array_equal(matrices[:, :3, 3], samples.positions)
    np.testing.assert_array_equal(matrices[:, 3], np.tile([0, 0, 0, 1], (150, 1)))
    # A place that is straight ahead comes to lie there.
    place = samples.positions + 3 * samples.view
    seen = np.linalg.inv(matrices) @ np.c_[place, np.ones(150)][..., np.newaxis]
    np.testing.assert_allclose(seen[:, :3, 0], np.tile(3 * ahead, (150, 1)), atol=1e-9)


def rotated(q: np.ndarray, v: np.ndarray) -> np.ndarray:
    w, axis = q[:, :1], q[:, 1:]
    cross = np.cross(axis, v)
    return np.asarray(v + 2 * (w * cross + np.cross(axis, cross)))


def test_quaternions_turn_the_camera(samples: vides.Samples) -> None:
    q = samples.quaternions
    np.testing.assert_allclose(np.linalg.norm(q, axis=1), 1, atol=1e-12)
    np.testing.assert_allclose(rotated(q, np.array([0.0, 0, 1])), samples.view, atol=1e-12)
    np.testing.assert_allclose(rotated(q, np.array([0.0, 1, 0])), samples.up, atol=1e-12)


@pytest.mark.parametrize("convention", get_args(Convention))
def test_poses_of_quaternions(samples: vides.Samples, convention: Convention) -> None:
    matrices = samples.matrices(convention)[:, :3, :3]
    # By the trace, where it is far from 0; the other half of a turn is left out.
    w = np.sqrt(np.maximum(1 + np.trace(matrices, axis1=1, axis2=2), 0)) / 2
    good = w > 0.05
    m = matrices[good]
    axis = np.stack([m[:, 2, 1] - m[:, 1, 2], m[:, 0, 2] - m[:, 2, 0], m[:, 1, 0] - m[:, 0, 1]], 1)
    q = np.c_[w[good], axis / (4 * w[good, np.newaxis])]
    again = vides.Samples.of(samples.positions[good], q, samples.zoom[good], 25, convention)
    np.testing.assert_allclose(again.array, samples.array[good], atol=1e-9)


def test_fields_of_view() -> None:
    array = np.tile([0, 0, 0, 0, 0, -1, 0, 1, 0, 24.0], (3, 1))
    array[:, 9] = 12, 24, 2000
    fov = vides.Samples(array).fov
    assert fov[0] == pytest.approx(90) and fov[2] == pytest.approx(0.6875, abs=1e-4)


def test_an_array_is_not_copied() -> None:
    array = np.zeros((4, 10))
    assert vides.Samples(array).array is array
    assert vides.Samples(array.astype(np.float32)).array.dtype == np.float64
