"""Each example does what it says."""

import importlib.util
import json
from pathlib import Path as File
from types import ModuleType

import numpy as np
import pytest

import vides

HERE = File(__file__).resolve().parent.parent / "examples"


def example(name: str) -> ModuleType:
    spec = importlib.util.spec_from_file_location(name, HERE / f"{name}.py")
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_a_recording_becomes_a_path(tmp_path: File) -> None:
    path = example("tum_fit").main(str(tmp_path))
    assert len(path.points) < 100
    samples = vides.Path.load(tmp_path / "fitted.vid").sample()
    recorded = np.loadtxt(tmp_path / "recording.txt")
    off = np.linalg.norm(samples.positions - recorded[:, 1:4], axis=1)
    assert off.max() < 0.021
    # It looks at the middle, as the one that was recorded.
    toward = -samples.positions / np.linalg.norm(samples.positions, axis=1, keepdims=True)
    assert np.degrees(np.arccos(np.clip((toward * samples.view).sum(1), -1, 1))).max() < 1.5


def test_transforms_are_matrices_of_opengl(tmp_path: File) -> None:
    file = example("splat_transforms").main(str(tmp_path))
    content = json.loads(file.read_text())
    assert len(content["frames"]) == 120 and content["w"] == 800
    matrices = np.array([frame["transform_matrix"] for frame in content["frames"]])
    path = vides.Path.load(file, tolerance=0.001)
    # Straight ahead (−z) lies what the cameras look at.
    place, ahead = matrices[:, :3, 3], -matrices[:, :3, 2]
    toward = np.array([0, 0, 0.5]) - place
    toward /= np.linalg.norm(toward, axis=1, keepdims=True)
    np.testing.assert_allclose(ahead, toward, atol=1e-6)
    assert path.up == "z"


@pytest.mark.large
def test_a_camera_flies_through_pyvista(tmp_path: File) -> None:
    from PIL import Image

    files = example("pyvista_flight").main(str(tmp_path), 24)
    pictures = [np.asarray(Image.open(file).convert("RGB")).astype(int) for file in files]
    assert len(pictures) == 24 and pictures[0].shape == (240, 320, 3)
    # The ring is seen, and from elsewhere each time.
    for before, after in zip(pictures, pictures[1:]):
        assert before.std() > 5 and np.abs(before - after).mean() > 1


@pytest.mark.large
def test_a_film_is_made(tmp_path: File) -> None:
    import imageio.v3 as imageio

    film = imageio.imread(example("pyvista_film").main(str(tmp_path / "flight.gif"), 1)).astype(int)
    assert len(film) == 20
    assert all(np.abs(before - after).mean() > 1 for before, after in zip(film, film[1:]))


@pytest.mark.large
def test_a_surface_is_drawn_along_a_path(tmp_path: File) -> None:
    from PIL import Image

    files = example("matplotlib_surface").main(str(tmp_path))
    pictures = [np.asarray(Image.open(file).convert("RGB")).astype(int) for file in files]
    assert len(pictures) == 4
    for before, after in zip(pictures, pictures[1:]):
        assert before.std() > 5 and np.abs(before - after).mean() > 1
