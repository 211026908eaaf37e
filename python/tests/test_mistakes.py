"""Plausible mistakes, and what is said of them."""

from pathlib import Path as File

import numpy as np
import pytest

import vides
from vides import __all__ as public

# A line each: the mistake; below it the exception of Python that it raises, and its sentence.
TABLE = File(__file__).with_name("mistakes.txt")


def rows() -> list[tuple[str, str, str]]:
    """Mistake, exception, sentence."""
    lines = TABLE.read_text().splitlines()
    return [(mistake, *said.strip().split(": ", 1)) for mistake, said in zip(lines[::2], lines[1::2])]  # type: ignore[misc]


def names() -> dict[str, object]:
    points = np.array([[0.0, 0, 0], [1, 0, 0], [1, 1, 0]])
    path = vides.Path(points, look_at=(0, 0, -5), frames=60)
    scene = vides.Scene.of_path(path)
    scene.add("ball", "object")
    corners = [[1, 1, 1], [-1, -1, 1], [-1, 1, -1], [1, -1, -1]]
    mesh = corners, [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]
    own = {"np": np, "P": points, "path": path, "scene": scene, "mesh": mesh, "samples": path.sample()}
    return {**{name: getattr(vides, name) for name in public}, **own}


def told(mistake: str) -> str:
    """The built-in exception that a mistake raises, and its sentence."""
    there = names()
    path, scene = there["path"], there["scene"]
    assert isinstance(path, vides.Path) and isinstance(scene, vides.Scene)
    before, scene_before = path.to_str(), scene.to_str()
    try:
        exec(mistake, there)
    except Exception as error:
        built_in = next(kind for kind in type(error).__mro__ if kind.__module__ == "builtins")
        # What fails changes nothing.
        assert (path.to_str(), scene.to_str()) == (before, scene_before)
        return f"{built_in.__name__}: {error}"
    return "nothing"


def test_there_are_many() -> None:
    assert len({mistake for mistake, _, _ in rows()}) >= 90


@pytest.mark.parametrize(("mistake", "kind", "sentence"), rows(), ids=[row[0][:50] for row in rows()])
@pytest.mark.filterwarnings("ignore")
def test_a_mistake_is_explained(mistake: str, kind: str, sentence: str) -> None:
    assert told(mistake) == f"{kind}: {sentence}"
