"""What concerns several points at once: parts, matrices, arrays."""

import copy
import math
import pickle
from typing import Any

import numpy as np
import pytest

import vides

POINTS = np.array([[3.0, 1.0, 0.0], [0.0, 2.0, 3.0], [-3.0, 1.0, 0.0], [0.0, 0.0, -3.0], [1, 4, 2]])


@pytest.fixture
def path() -> vides.Path:
    return vides.Path(POINTS, look_at=(0, 0, 0), frames=200)


def test_a_slice_is_a_path(path: vides.Path) -> None:
    path.fps = 30
    path.points[2].zoom = 50
    part = path[1:4]
    np.testing.assert_array_equal(part.positions, POINTS[1:4])
    assert part.fps == 30 and part.points[1].zoom == 50 and len(path.points) == 5
    # It goes the same way.
    whole, one = path.sample(), part.sample()
    for place in one.positions[:: len(one) // 7]:
        assert np.linalg.norm(whole.positions - place, axis=1).min() < 0.1
    np.testing.assert_array_equal(path[-2:].positions, POINTS[-2:])
    assert path[:] is not path and len(path[:].points) == 5
    for wrong, said in ((slice(2, 3), "at least two"), (slice(0, 5, 2), "step must be 1"), (slice(4, 1), "two")):
        with pytest.raises(ValueError, match=said):
            path[wrong]
    with pytest.raises(TypeError, match=r"path\.points\[2\] is a point"):
        path[2]  # type: ignore[index]


MATRICES = [
    np.diag([2.0, 2, 2, 1]),
    np.diag([1e6, 1e6, 1e6, 1]),
    np.array([[0, 0, 1, 5], [0, 1, 0, -2], [-1, 0, 0, 3], [0, 0, 0, 1.0]]),
    np.array([[0, -0.5, 0, 1], [0.5, 0, 0, 0], [0, 0, 0.5, 0], [0, 0, 0, 1.0]]),
    np.diag([-1.0, 1, 1, 1]),
]


@pytest.mark.parametrize("matrix", MATRICES)
def test_a_matrix_takes_along_what_the_cameras_see(path: vides.Path, matrix: Any) -> None:
    before, text = path.sample(), path.to_str()
    path.transform(matrix)
    after = path.sample()
    size = np.abs(np.linalg.det(matrix[:3, :3])) ** (1 / 3)
    places = before.positions @ matrix[:3, :3].T + matrix[:3, 3]
    np.testing.assert_allclose(after.positions, places, atol=1e-9 * (1 + 5 * size))
    np.testing.assert_allclose(after.view, before.view @ matrix[:3, :3].T / size, atol=1e-9)
    assert not [found for found in path.check() if found.kind == "space"]
    assert path.undo() and path.to_str() == text and not path.undo()


def test_a_matrix_that_shears_is_refused(path: vides.Path) -> None:
    shear = np.eye(4)
    shear[0, 1] = 0.5
    project = np.eye(4)
    project[3, 0] = 1
    text = path.to_str()
    for wrong in (shear, project, np.zeros((4, 4)), np.full((4, 4), np.nan), np.eye(3)):
        with pytest.raises(ValueError):
            path.transform(wrong)
        assert path.to_str() == text


def test_each_point_looks_at_its_own_place(path: vides.Path) -> None:
    targets = POINTS + [[1, 0, 0], [0, 1, 0], [0, 0, 1], [-1, 0, 0], [0, -1, 0]]
    text = path.to_str()
    path.look_at(targets)
    assert [view.target for view in path.points] == [tuple(target) for target in targets]
    assert path.undo() and path.to_str() == text
    wrong = targets.copy()
    wrong[3] = POINTS[3]
    with pytest.raises(ValueError, match="point 3"):
        path.look_at(wrong)
    with pytest.raises(ValueError, match=r"one place \(3,\) or one for each point \(5, 3\), not \(4, 3\)"):
        path.look_at(targets[:4])
    assert path.to_str() == text
    made = vides.Path(POINTS, look_at=targets)
    assert made.points[4].target == tuple(targets[4]) and not made.undo()


def test_arrays_of_zooms_and_rolls(path: vides.Path) -> None:
    text = path.to_str()
    path.zooms = [20, 30, 40, 50, 60]
    assert [point.zoom for point in path.points] == [20, 30, 40, 50, 60] == path.zooms.tolist()
    assert path.undo() and path.to_str() == text
    path.zooms = 35
    assert set(path.zooms) == {35}
    path.rolls = [0, 10, 190, -30, 360]
    np.testing.assert_allclose(path.rolls, [0, 10, -170, -30, 0])
    for name, value, said in (
        ("zooms", [1, 2, 3], r"zooms must have the shape \(5,\), not \(3,\)"),
        ("zooms", [20, 30, 0, 40, 50], "point 2.*zoom must lie between 1 and 2000"),
        ("rolls", [0, 0, np.inf, 0, 0], r"rolls\[2\] is inf"),
        ("zooms", "wide", "zooms must be a number, not str"),
    ):
        before = path.to_str()
        with pytest.raises((ValueError, TypeError), match=said):
            setattr(path, name, value)
        assert path.to_str() == before
    with pytest.raises(ValueError, match="read-only"):
        path.zooms[0] = 3
    made = vides.Path(POINTS, zoom=[20, 30, 40, 50, 60], roll=7)
    assert made.zooms.tolist() == [20, 30, 40, 50, 60] and set(made.rolls) == {7.0}


def test_points_are_reached_at_their_times(path: vides.Path) -> None:
    wanted = np.array([0, 1, 1.48, 5, 5.04])
    text = path.to_str()
    path.times = wanted + 1e6
    np.testing.assert_allclose(path.times, wanted, atol=1e-9)
    np.testing.assert_allclose(path.evaluate(seconds=path.times).positions, POINTS, atol=1e-9)
    assert path.undo() and path.to_str() == text
    # A camera that rests and turns has its time at a point.
    path.points[1].hold = 10
    path.points[1].orientations.append().roll = 40
    path.times = [0, 2, 8, 9, 12]
    np.testing.assert_allclose(path.times, [0, 2, 8, 9, 12])
    for times, said in (
        ([0, 1, 1, 2, 3], r"times\[2\] is 1, not after 1"),
        ([0, 1, 1.2, 2, 3], "the camera cannot move from point 1 to 2: it needs"),
        ([0, 1, 2], "there are 5 points, and 3 times"),
        ([0, 1, 2, 3, np.nan], r"times\[4\] is nan"),
    ):
        before = path.to_str()
        with pytest.raises(ValueError, match=said):
            path.times = times
        assert path.to_str() == before
    made = vides.Path(POINTS, times=wanted, fps=50)
    np.testing.assert_allclose(made.times, wanted, atol=1e-9)
    assert made.frame_count == 5.04 * 50 + 1
    with pytest.raises(TypeError, match="either frames or times"):
        vides.Path(POINTS, times=wanted, frames=3)


def test_a_path_is_inserted(path: vides.Path) -> None:
    block = vides.Path([[0, 0, 0], [0, 1, 0], [0, 2, 0]], look_at=(9, 9, 9))
    text = path.to_str()
    path.insert_path(block, at=2)
    wanted = [*POINTS[:2], POINTS[1] + [0, 1, 0], POINTS[1] + [0, 2, 0], *POINTS[2:]]
    np.testing.assert_allclose(path.positions, wanted, atol=1e-12)
    assert path.undo() and path.to_str() == text
    path.insert_path(block, fit="none", with_targets=False)
    np.testing.assert_array_equal(path.positions[5:], block.positions)
    assert path.points[6].target == (9, 9, 9)
    path.insert_path(path)
    assert len(path.points) == 15
    for at in (0, 16, -15):
        with pytest.raises(ValueError, match=f"before point 1 to 15, not {0 if at == -15 else at}"):
            path.insert_path(block, at)
    with pytest.raises(ValueError, match='fit is one of "none", "move", "turn", "scale"'):
        path.insert_path(block, fit="tight")  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="path must be a Path, not list"):
        path.insert_path([1, 2])  # type: ignore[arg-type]


def test_copies_keep_their_attributes() -> None:
    recorded = vides.Path(POINTS[:4], look_at=(0, 0, 0), frames=200).sample()
    noisy = recorded.array.copy()
    noisy[77, :3] += 2
    path = vides.Path.fit(noisy, tolerance=0.01, robust=True)
    assert path.losses and path.fit_report is not None
    for twin in (path.copy(), copy.copy(path), copy.deepcopy(path), pickle.loads(pickle.dumps(path))):
        assert twin == path and twin.losses == path.losses and twin.fit_report == path.fit_report
    path.save("flight.chan")
    scene = vides.Scene.load("flight.chan")
    assert scene.losses and pickle.loads(pickle.dumps(scene)).losses == scene.losses
    upright = vides.Path(POINTS, up="z").sample()
    assert pickle.loads(pickle.dumps(upright)).world_up == "z"
    with pytest.raises(FileNotFoundError) as raised:
        vides.Path.load("missing.vid")
    again = pickle.loads(pickle.dumps(raised.value))
    assert isinstance(raised.value, vides.NoFile) and type(again) is vides.NoFile
    assert (again.errno, again.filename, again.place) == (2, raised.value.filename, raised.value.place)


def test_errors_are_those_of_python() -> None:
    path, scene = vides.Path(POINTS), vides.Scene()
    camera = scene.add("camera", "camera")
    for call, kind in (
        (lambda: setattr(path.points[0], "zoom", 0), ValueError),
        (lambda: vides.Path.from_str("fps = "), ValueError),
        (lambda: scene["came"], KeyError),
        (lambda: setattr(camera, "aim", "none"), KeyError),
        (lambda: scene.sample("none"), KeyError),
        (lambda: path.points[9], IndexError),
        (lambda: vides.Path.load("missing.vid"), FileNotFoundError),
        (lambda: path.save("missing/a.vid"), OSError),
    ):
        with pytest.raises(kind) as raised:
            call()
        assert isinstance(raised.value, vides.Error) and str(raised.value)[0] not in "'\""
    with pytest.raises(KeyError, match="there is no node 'camra': is 'camera' meant"):
        scene["camra"]


@pytest.mark.parametrize("size", [0.01, 1.0, 300.0])
def test_limits_are_lengths_of_the_world(size: float) -> None:
    path = vides.Path(np.array([[-1, 0, 0], [0.0, 0, 0], [1, 0, 0]]) * size, look_at=(0, 0, -5 * size))
    path.set_space((0, 0, 0), 7 * size)
    path.set_limits(speed=0.5 * size, acceleration=math.inf)
    assert path.limits["speed"] == pytest.approx(0.5 * size)
    path.set_frames(51)
    (found,) = [one for one in path.check() if one.kind == "speed"]
    # Two units in two seconds.
    assert found.value == pytest.approx(path.motion(np.arange(1, 51, 0.1))[:, 1].max() * 25, rel=0.01)
    assert found.kind in path.limits and found.limit == path.limits[found.kind]
    assert f"moves by {found.value:.3g}"[:12] in found.text and "half size" not in found.text
    took = path.retime(speed=0.25 * size, acceleration=math.inf, turning=math.inf, turning_acceleration=math.inf)
    # Two sections of whole frames, and a frame for the last pose.
    assert 8 - 1e-9 <= took.seconds <= 8 + 3 / 25 + 1e-9


def test_kinds_are_keys_of_the_limits() -> None:
    path = vides.Path([[-1, 0.01, 0], [1, 0.01, 0]], look_at=(0, 0, 0), frames=20)
    kinds = {found.kind for found in path.check()}
    assert kinds <= path.limits.keys() and any("_" in kind for kind in kinds)
