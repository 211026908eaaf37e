"""Right and wrong uses, as checkers of types see them: an ``ignore`` that is not needed is an error
of mypy, which runs over this file."""

import numpy as np
import pytest

import vides


def test_right_uses() -> None:
    path = vides.Path([[0, 0, 0], [1, 0, 0], [1, 1, 0]], look_at=np.ones((3, 3)), zoom=[30, 40, 50])
    point = path.points[0]
    zoom: float = point.zoom
    hold: int = point.orientations[0].hold
    point.zoom = np.float32(30)
    point.hold = np.int64(3)
    point.target = np.ones(3)
    point.roll = None
    path.curve = "cubic"
    path.fps = 30
    path.rolls = 5
    path.base_speeds = {"move_frames": 50}
    assert (zoom, hold) == (30, 0) and point.hold == 3 and path.title == ""
    part: vides.Path = path[0:2]
    part.insert_path(vides.Path.orbit(turns=2), at=1, fit="turn")
    scene = vides.Scene.of_path(part)
    scene["camera"].position = np.array([1.0, 2, 3])
    assert scene["camera"].position[0] == 1


def test_wrong_uses() -> None:
    path = vides.Path([[0, 0, 0], [1, 0, 0], [1, 1, 0]])
    point, node = path.points[0], vides.Scene().add("a")
    with pytest.raises(AttributeError, match="Point has no zooom: is zoom meant"):
        point.zooom = 30  # type: ignore[attr-defined]
    with pytest.raises(AttributeError, match="is roll meant"):
        point.rol  # type: ignore[attr-defined]
    with pytest.raises(AttributeError, match="is zoom meant"):
        point.orientations[0].zoom_mm = 30  # type: ignore[attr-defined]
    with pytest.raises(AttributeError, match="is frames meant"):
        path.sections[0].frame = 30  # type: ignore[attr-defined]
    with pytest.raises(AttributeError, match="its points have"):
        path.hold = 30  # type: ignore[attr-defined]
    with pytest.raises(AttributeError, match="is position meant"):
        node.postion = (1, 2, 3)  # type: ignore[attr-defined]
    with pytest.raises(ValueError):
        point.zoom = "wide"  # type: ignore[assignment]
    with pytest.raises(ValueError):
        path.curve = "round"  # type: ignore[assignment]
    with pytest.raises(TypeError):
        point.name = 3  # type: ignore[assignment]
    with pytest.raises(TypeError):
        vides.Path.orbit(radious=3)  # type: ignore[call-arg]
    with pytest.raises(ValueError):
        path.turn("w")  # type: ignore[arg-type]
    with pytest.raises(TypeError):
        path[2]  # type: ignore[index]
    with pytest.raises(AttributeError):
        point.index = 3  # type: ignore[misc]
