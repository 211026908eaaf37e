"""What is planned for a path, within limits."""

import math

import numpy as np
import pytest

import vides


def line() -> vides.Path:
    """Two units long, in a space of half size 1."""
    path = vides.Path([[-1, 0, 0], [1, 0, 0]], look_at=(0, 0, -5))
    path.set_space((0, 0, 0), 1.0)
    return path


OFF = {"turning": math.inf, "turning_acceleration": math.inf, "zoom": math.inf}


def test_a_line_is_flown_as_fast_as_its_limits_allow() -> None:
    path = line()
    done = path.retime(speed=0.5, acceleration=1, **OFF)
    # Speeding up, cruising, slowing down: length / speed + speed / acceleration.
    assert 4.5 - 1e-9 <= done.seconds <= 4.5 + 1 / path.fps
    assert done.rests == () and path.frame_count == round(done.seconds * path.fps) + 1
    places = path.evaluate(np.arange(1, path.frame_count, 0.05)).positions
    speed = np.linalg.norm(np.diff(places, axis=0), axis=1) * path.fps / 0.05
    assert 0.49 < speed.max() < 0.5 * 1.001
    bend = np.linalg.norm(np.diff(places, 2, axis=0), axis=1) * (path.fps / 0.05) ** 2
    assert bend.max() < 1.001


def test_a_given_time_is_kept_and_views_stay() -> None:
    path = vides.Path([[-1, 0, 0], [0, 1, 0], [1, 0, 0]], look_at=(0, 0, -3))
    before = path.copy()
    assert path.retime(20).seconds == 20.0
    assert path.undo() and path == before
    path.retime(20, first=1)
    assert path.sections[0].frames == before.sections[0].frames
    toward = np.array([0, 0, -3]) - path.sample().positions
    toward /= np.linalg.norm(toward, axis=1, keepdims=True)
    np.testing.assert_allclose(path.sample().view, toward, atol=1e-9)


def test_what_cannot_be_leaves_the_path_as_it_was() -> None:
    path = line()
    before = path.copy()
    with pytest.raises(vides.Error, match="too short"):
        path.retime(0.5, speed=0.5)
    for wrong in ({"speed": 0}, {"speed": -1}, {"speed": math.nan}, {"zoom": 0}):
        with pytest.raises(vides.Error):
            path.retime(**wrong)  # type: ignore[arg-type]
    for seconds in (0, -1, math.nan, math.inf, 1e300):
        with pytest.raises(vides.Error):
            path.retime(seconds)
    with pytest.raises(IndexError):
        path.retime(first=2)
    with pytest.raises(TypeError):
        path.retime("long")  # type: ignore[arg-type]
    assert path == before
