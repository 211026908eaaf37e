"""Matrices and quaternions, held against what a camera sees."""

import copy
import pickle
from pathlib import Path
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
    places, zooms = samples.positions[good], samples.zoom[good]
    again = vides.Samples.from_quaternions(places, q, zooms, 25, convention)
    np.testing.assert_allclose(again.array, samples.array[good], atol=1e-9)
    last = vides.Samples.from_quaternions(places, q[:, [1, 2, 3, 0]], zooms, 25, convention, scalar_first=False)
    np.testing.assert_array_equal(last.array, again.array)


def test_fields_of_view() -> None:
    array = np.tile([0, 0, 0, 0, 0, -1, 0, 1, 0, 24.0], (3, 1))
    array[:, 9] = 12, 24, 2000
    fov = vides.Samples(array).fov
    assert fov[0] == pytest.approx(90) and fov[2] == pytest.approx(0.6875, abs=1e-4)


def test_an_array_is_not_copied() -> None:
    array = vides.Path().sample(1, 4).array
    assert vides.Samples(array).array is array
    strided = np.concatenate([array, array])[::2]
    assert vides.Samples(strided).array is strided
    assert vides.Samples(array.astype(np.float32)).array.dtype == np.float64


def test_what_no_camera_has_is_refused() -> None:
    good = vides.Path().sample(1, 3).array
    for column, number, said in (
        (slice(3, 6), 0, r"poses\[1\]: view has the length 0"),
        (slice(6, 9), 0, r"poses\[1\]: up has the length 0"),
        (slice(6, 9), good[1, 3:6], r"poses\[1\]: view and up"),
        (slice(0, 10), np.nan, r"poses\[1, 0\] is nan"),
        (slice(9, 10), -3, r"poses\[1\]: zoom must lie between 1 and 2000, not -3"),
        (slice(9, 10), 2001, "2000"),
    ):
        array = good.copy()
        array[1, column] = number
        with pytest.raises(vides.Error, match=said):
            vides.Samples(array)
    # As rounded as files have them.
    vides.Samples(vides.Path(POSITIONS, look_at=(0, 0, 0)).sample().array.round(4))


POSITIONS = [[3, 1, 0], [0, 2, 3], [-3, 1, 0]]


def test_a_mask_is_not_lost() -> None:
    masked = np.ma.masked_equal(vides.Path().sample().array, 24.0)
    frames = np.ma.masked_array([1.0, 2.0], [False, True])
    positions = np.ma.masked_less(np.array(POSITIONS), 0)
    for call in (
        lambda: vides.Samples(masked),
        lambda: vides.Path(positions),
        lambda: vides.Path().evaluate(frames),
        lambda: vides.Path().evaluate(seconds=frames),
        lambda: vides.Scene().add("a").set_keys("roll", [1, 2], frames),
    ):
        with pytest.raises(vides.Error, match="is masked"):
            call()
    whole = np.ma.masked_array(vides.Path().sample().array)
    assert type(vides.Samples(whole).array) is np.ndarray


def test_the_same_numbers_are_equal() -> None:
    path = vides.Path()
    assert path.sample() == path.sample() and path.sample() != path.sample(2)
    other = path.sample()
    other.zoom[3] = 30
    assert other != path.sample() and other != path.sample().array.tolist()
    assert pickle.loads(pickle.dumps(other)) == other == copy.deepcopy(other)


@pytest.mark.parametrize("fps", [30, 25, 24000 / 1001])
def test_seconds_come_back_from_a_table(fps: float) -> None:
    path = vides.Path(POSITIONS, look_at=(0, 0, 0), frames=61, fps=fps)
    path.save("flight.csv")
    again = vides.Samples.load("flight.csv")
    np.testing.assert_allclose(again.seconds, path.sample().seconds, atol=1e-5)
    assert again.fps == pytest.approx(fps, rel=1e-6)


def test_which_axis_stands_upright() -> None:
    path = vides.Path(POSITIONS, look_at=(0, 0, 0), frames=20)
    path.save("transforms.json", "nerfstudio")
    samples = vides.Samples.load("transforms.json")
    assert (path.sample().world_up, samples.world_up, samples[3:].world_up) == ("y", "z", "z")
    x, y, z = path.sample().positions.T
    np.testing.assert_allclose(samples.positions, np.stack([x, -z, y], 1), atol=1e-6)
    assert vides.Path.fit(samples).up == "z" and vides.Path.fit(samples, up="y").up == "y"
    path.save("poses.tum", "tum")
    assert vides.Samples.load("poses.tum").world_up is None


def test_samples_keep_what_their_file_told(tmp_path: Path) -> None:
    stamps = [1403636580.838, 1403636580.911, 1403636581.5, 1403636583.25]
    (tmp_path / "a.tum").write_text("".join(f"{t} {t - 1403636580} 0 0 0 0 0 1\n" for t in stamps))
    samples = vides.Samples.load(tmp_path / "a.tum")
    assert samples.start == samples[2:].start == pickle.loads(pickle.dumps(samples)).start == stamps[0]
    assert any("begin at" in loss for loss in samples.losses)
    samples.save(tmp_path / "b.tum", start=samples.start)
    rows = (tmp_path / "b.tum").read_text().splitlines()
    times = [float(row.split()[0]) for row in rows if not row.startswith("#")]
    np.testing.assert_allclose(times, stamps, atol=1e-5)
    assert vides.Samples(samples.array).losses == ()


def test_a_list_that_becomes_a_list_keeps_its_times(tmp_path: Path) -> None:
    stamps = [1403636580.838, 1403636580.911, 1403636581.5, 1403636583.25]
    (tmp_path / "a.tum").write_text("".join(f"{t} {t - 1403636580} 0 0 0 0 0 1\n" for t in stamps))
    told = vides.convert(tmp_path / "a.tum", tmp_path / "b.euroc")
    assert not any("begin at" in line for line in told)
    rows = (tmp_path / "b.euroc").read_text().splitlines()[1:]
    assert np.allclose([int(row.split(",")[0]) / 1e9 for row in rows], stamps, rtol=0, atol=5e-6)


class Turned:
    """As a rotation of SciPy."""

    def __init__(self, matrices: np.ndarray) -> None:
        self.matrices = matrices

    def as_matrix(self) -> np.ndarray:
        return self.matrices


@pytest.mark.parametrize("convention", get_args(Convention))
def test_poses_of_matrices(samples: vides.Samples, convention: Convention) -> None:
    matrices = samples.matrices(convention)
    for given in (matrices, matrices[:, :3]):
        again = vides.Samples.from_matrices(given, samples.zoom, convention=convention)
        np.testing.assert_allclose(again.array, samples.array, atol=1e-12)
    inverse = samples.world_to_camera(convention)
    np.testing.assert_allclose(inverse, np.linalg.inv(matrices), atol=1e-12)
    again = vides.Samples.from_matrices(inverse, samples.zoom, convention=convention, world_to_camera=True)
    np.testing.assert_allclose(again.array, samples.array, atol=1e-12)
    turned = Turned(matrices[:, :3, :3])
    again = vides.Samples.from_rotation(samples.positions, turned, samples.zoom, 25, convention)
    np.testing.assert_allclose(again.array, samples.array, atol=1e-12)


@pytest.mark.large
def test_rotations_of_scipy(samples: vides.Samples) -> None:
    from scipy.spatial.transform import Rotation

    turned = Rotation.from_matrix(samples.matrices("opencv")[:, :3, :3])
    again = vides.Samples.from_rotation(samples.positions, turned, samples.zoom, convention="opencv")
    np.testing.assert_allclose(again.array, samples.array, atol=1e-9)
    again = vides.Samples.from_quaternions(
        samples.positions, turned.as_quat(), samples.zoom, convention="opencv", scalar_first=False
    )
    np.testing.assert_allclose(again.array, samples.array, atol=1e-9)


def test_pixels_of_a_pinhole_camera(samples: vides.Samples) -> None:
    samples.zoom[:] = np.linspace(20, 90, 150)
    width, height = 1920, 1080
    k = samples.intrinsics(width, height)
    # A place at the upper right corner of the picture: half the field of view up, as far as wide to the right.
    up = np.tan(np.radians(samples.fov) / 2)[:, np.newaxis]
    right = np.cross(samples.view, samples.up)
    corner = samples.positions + 7 * (samples.view + up * samples.up + up * width / height * right)
    seen = k @ samples.world_to_camera("opencv")[:, :3] @ np.c_[corner, np.ones(150)][..., np.newaxis]
    np.testing.assert_allclose(seen[:, :2, 0] / seen[:, 2:, 0], np.tile([width, 0.0], (150, 1)), atol=1e-6)
    np.testing.assert_allclose(seen[:, 2, 0], 7)
    projection = samples.projection(width / height, 2, 50)
    clip = projection @ samples.world_to_camera("opengl") @ np.c_[corner, np.ones(150)][..., np.newaxis]
    np.testing.assert_allclose(clip[:, :2, 0] / clip[:, 3:, 0], np.ones((150, 2)), atol=1e-9)
    for depth, z in ((2, -1), (50, 1)):
        ahead = samples.positions + depth * samples.view
        clip = projection @ samples.world_to_camera("opengl") @ np.c_[ahead, np.ones(150)][..., np.newaxis]
        np.testing.assert_allclose(clip[:, 2, 0] / clip[:, 3, 0], z, atol=1e-9)
    again = vides.Samples.from_matrices(samples.matrices("opencv"), convention="opencv", intrinsics=k, height=height)
    np.testing.assert_allclose(again.zoom, samples.zoom, rtol=1e-12)


@pytest.mark.parametrize("name", [f.name for f in vides.formats() if f.reads and f.writes and f.name != "vid"])
def test_poses_are_saved(samples: vides.Samples, name: str) -> None:
    samples.save("out", name)
    again = vides.Samples.load("out", name) if name not in SCENES else vides.Scene.load("out", name).sample().poses
    assert len(again) == 150
    off = again.positions - samples.positions
    # Some formats have z up, and turn the world.
    if samples.world_up == again.world_up or again.world_up is None:
        np.testing.assert_allclose(off, 0, atol=1e-4 * np.abs(samples.positions).max())
        np.testing.assert_allclose(again.view, samples.view, atol=1e-4)


# They have nodes, not a list of poses.
SCENES = {"gltf", "glb", "usda"}


def test_times_of_poses_are_saved() -> None:
    samples = vides.Path(POSITIONS, look_at=(0, 0, 0), frames=50).evaluate([1, 2.5, 3, 17.25, 50])
    assert samples.save("poses.tum", "tum") == ["the field of view is left out"]
    again = vides.Samples.load("poses.tum")
    np.testing.assert_allclose(again.seconds, samples.seconds, atol=1e-5)
    np.testing.assert_allclose(again.positions, samples.positions, atol=1e-6)
    with pytest.raises(FileNotFoundError):
        samples.save("missing/poses.csv")
    with pytest.raises(ValueError, match="poses|empty|no "):
        samples[:0].save("none.csv")


def test_motions_are_those_of_single_frames_in_any_order() -> None:
    path = vides.Path(RNG.uniform(-1, 1, (6, 3)), frames=200)
    frames = RNG.permutation(np.linspace(1, 200, 777))
    motions = path.motion(frames)
    alone = np.concatenate([path.motion(frame) for frame in frames])
    np.testing.assert_array_equal(motions, alone)
    with pytest.raises(vides.Error, match="201"):
        path.motion([5, 201, 300])
