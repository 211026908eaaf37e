"""What is planned for a path, within limits."""

import math
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest

import vides


def line() -> vides.Path:
    """Two units long, in a space of half size 1."""
    path = vides.Path([[-1, 0, 0], [1, 0, 0]], look_at=(0, 0, -5))
    path.set_space((0, 0, 0), 1.0)
    return path


OFF: dict[str, Any] = {"turning": math.inf, "turning_acceleration": math.inf, "zoom": math.inf}


def test_a_line_is_flown_as_fast_as_its_limits_allow() -> None:
    path = line()
    done = path.retime(speed=0.5, acceleration=1, **OFF)
    # Speeding up, cruising, slowing down: length / speed + speed / acceleration.
    # From rest to rest; the last pose has a frame of its own.
    assert 4.5 - 1e-9 <= done.seconds - 1 / path.fps <= 4.5 + 1 / path.fps
    assert done.rests == () and path.frame_count == round(done.seconds * path.fps)
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
            path.retime(**wrong)
    for seconds in (0, -1, math.nan, math.inf, 1e300):
        with pytest.raises(vides.Error):
            path.retime(seconds)
    with pytest.raises(IndexError):
        path.retime(first=2)
    with pytest.raises(TypeError):
        path.retime("long")  # type: ignore[arg-type]
    assert path == before


Array = npt.NDArray[np.float64]

BALL = np.array([[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]], dtype=float)
FACES = [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]]


def outside(places: Array) -> Array:
    """At least so far places are from the octahedron |x| + |y| + |z| = 1: from the plane of its face."""
    return (np.abs(places).sum(axis=1) - 1) / math.sqrt(3)


def written(file: str = "ball.obj") -> str:
    with open(file, "w") as out:
        out.writelines(f"v {x} {y} {z}\n" for x, y, z in BALL)
        out.writelines("f " + " ".join(str(corner + 1) for corner in face) + "\n" for face in FACES)
    return file


def distances(places: Array) -> Array:
    """From places to the nearest of many on the faces, no less than the distance itself."""
    steps = np.linspace(0, 1, 60)
    u, v = (side.ravel() for side in np.meshgrid(steps, steps))
    u, v = u[u + v <= 1], v[u + v <= 1]
    near = np.full(len(places), np.inf)
    for face in FACES:
        a, b, c = BALL[face]
        spots = a + np.outer(u, b - a) + np.outer(v, c - a)
        near = np.minimum(near, np.linalg.norm(places[:, None] - spots, axis=2).min(axis=1))
    return near


@pytest.mark.parametrize("radius", [0.0, 0.2])
def test_a_way_is_led_clear_of_an_object(radius: float) -> None:
    path = vides.Path(np.array([[-4, 0.1, 0.05], [4, 0, 0]]), look_at=(0, 0, -9), frames=201)
    before = path.copy()
    by_file = path.copy()
    assert outside(path.sample().positions).min() < 0
    parts = path.avoid(0.5, radius, object=(BALL, FACES))
    assert len(parts) == 1 and parts[0].moved + parts[0].inserted >= 1
    places = path.evaluate(np.arange(1, 201, 0.25)).positions
    assert outside(places).min() > 0 and distances(places).min() >= 0.5 + radius - 1e-9
    assert path.frame_count == 201
    assert path.avoid(0.5, radius, object=(BALL, FACES)) == ()
    assert by_file.avoid(0.5, radius, object=written()) == parts
    own = before.copy()
    own.set_object("ball.obj")
    assert own.avoid(0.5, radius) == parts
    path.undo()
    path.undo()
    assert path == before


@pytest.mark.parametrize("by", ["zoom", "distance", "view"])
def test_every_corner_is_in_the_picture(by: str) -> None:
    look = (0.8, 0, 0) if by == "view" else (0, 0, 0)
    path = vides.Path([[-3, 1, 5], [0, 0, 4], [3, 0, 5]], look_at=look, frames=101, zoom=24 if by == "view" else 60)
    told = path.keep_in_picture(0.1, by, (BALL, FACES))  # type: ignore[arg-type]
    assert 0 < told.loosest <= told.tightest <= 1
    poses = path.evaluate(np.arange(1, 101, 0.25))
    right = np.cross(poses.view, poses.up)
    sides = [np.einsum("nmk,nk->nm", BALL[None] - poses.positions[:, None], axis) for axis in (right, poses.up, poses.view)]
    assert sides[2].min() > 0
    for side, film in zip(sides, (36, 24)):
        share = np.abs(side / sides[2]) * poses.zoom[:, None] / (0.5 * film)
        assert share.max() <= 0.8 + 1e-9


def test_a_shaken_flight_is_steady_and_its_ends_stay() -> None:
    random = np.random.default_rng(7)
    even = np.stack([np.linspace(0, 10, 101), np.zeros(101), np.zeros(101)], axis=1)
    shaken = even + random.normal(0, 0.02, even.shape)
    path = vides.Path(shaken, look_at=(5, 0, -20), frames=101)
    before = path.sample()
    bounded = path.copy()
    told = path.steady(1.5)
    after = path.sample()
    assert len(after) == 101
    np.testing.assert_allclose(after.positions[[0, -1]], before.positions[[0, -1]], atol=1e-9)
    noise = [np.abs(np.diff(poses.positions, 2, axis=0)).max() for poses in (before, after)]
    assert noise[1] < 0.1 * noise[0]
    went = np.linalg.norm(after.positions - before.positions, axis=1).max()
    assert told.furthest == pytest.approx(went, rel=1e-6)
    assert bounded.steady(1.5, within=0.03).furthest <= 0.03 < told.furthest


def test_a_tour_shows_what_it_says() -> None:
    told = vides.tour((BALL, FACES), seconds=30, coverage=0.9)
    assert told.seconds == 30 == told.path.frame_count / told.path.fps
    assert told.path.closed and told.length == pytest.approx(told.path.length)
    assert 0.9 <= told.coverage <= 1 and told.hidden == pytest.approx(0, abs=1e-9)
    assert told.surface + told.left_out + told.narrow + told.hidden == pytest.approx(1)
    places = told.path.sample().positions
    assert outside(places).min() > 0
    # Each face has a place before its plane.
    shown = [np.max((places - BALL[face[0]]) @ np.sign(BALL[face].sum(axis=0))) > 0 for face in FACES]
    assert np.mean(shown) >= 0.9
    assert np.abs(told.path.object_points).max() == 1
    assert vides.tour(written(), seconds=30, coverage=0.9).coverage == told.coverage
    open_one = vides.tour((BALL, FACES), seconds=30, start=(0, 0, 6), up="z")
    assert not open_one.path.closed and open_one.path.up == "z"
    np.testing.assert_allclose(open_one.path.sample().positions[0], [0, 0, 6], atol=1e-9)


def test_bad_plans_are_refused_and_change_nothing() -> None:
    path = vides.Path(np.array([[-4, 0.1, 0], [0, 0.2, 3], [4, 0, 0]]), look_at=(0, 0, 0))
    before = path.copy()
    ball = (BALL, FACES)
    bad = (-1, math.nan, math.inf, 1e300)
    for number in (0, *bad):
        for call in (
            lambda: path.avoid(number, object=ball),
            lambda: path.steady(number),
            lambda: vides.tour(ball, seconds=number),
            lambda: vides.tour(ball, coverage=number),
        ):
            with pytest.raises(vides.Error):
                call()
    for number in (0, -1, math.nan, math.inf):
        with pytest.raises(vides.Error):
            path.steady(1, within=number)
    for number in bad:
        with pytest.raises(vides.Error):
            path.avoid(0.5, number, object=ball)
        with pytest.raises(vides.Error):
            path.keep_in_picture(number, object=ball)
        with pytest.raises(vides.Error):
            vides.tour(ball, distance=number)
    with pytest.raises(vides.Error, match="by is"):
        path.keep_in_picture(by="magic", object=ball)  # type: ignore[arg-type]
    for wrong in ((BALL, [[0, 1, 6]]), (BALL, [[0, 1]]), (BALL * math.nan, FACES), (BALL[:0], []), (BALL,), "none.obj"):
        for take in (lambda: path.avoid(0.5, object=wrong), lambda: path.keep_in_picture(object=wrong), lambda: vides.tour(wrong)):  # type: ignore[arg-type]
            with pytest.raises(vides.Error):
                take()
    for missing in (lambda: path.avoid(0.5), lambda: path.keep_in_picture(), lambda: vides.tour((BALL, []))):
        with pytest.raises(vides.Error):
            missing()
    with pytest.raises(TypeError):
        path.avoid("far", object=ball)  # type: ignore[arg-type]
    assert path == before


def test_limits_are_the_paths_own() -> None:
    path = line()
    fresh = path.limits
    assert fresh["speed"] == math.inf and fresh["turning"] == 60 and fresh["turning_acceleration"] == 300
    path.set_limits(speed=0.5, acceleration=1, turning=math.inf, turning_acceleration=math.inf, zoom=math.inf)
    assert path.limits == {**fresh, "speed": 0.5, "acceleration": 1, **OFF}
    # What is planned keeps them, and so does the file. The last pose has a frame of its own.
    rest_to_rest = path.retime().seconds - 1 / path.fps
    assert 4.5 - 1e-9 <= rest_to_rest <= 4.5 + 1 / path.fps
    assert vides.Path.from_str(path.to_str()).limits == path.limits
    assert "speed" not in {found.kind for found in path.check()}
    path.set_limits(speed=0.01)
    assert any(found.kind == "speed" for found in path.check())
    path.undo()
    path.set_limits(speed=None, acceleration=None, turning=None, turning_acceleration=None, zoom=None)
    assert path.limits == fresh
    for wrong in ({"speed": math.nan}, {"zoom": -1}, {"none": 1}, {"turning-acceleration": 1}):
        with pytest.raises(vides.Error):
            path.set_limits(**wrong)
    assert path.limits == fresh


def test_stills_are_the_views_of_a_tour() -> None:
    shown = vides.tour((BALL, FACES), stills=True)
    views = sum(len(point.orientations) for point in shown.path.points)
    assert shown.path.frame_count == views and shown.coverage >= 0.95
    assert shown.seconds == pytest.approx(views / shown.path.fps)
    assert outside(shown.path.sample().positions).min() > 0


def test_a_cure_is_one_step() -> None:
    path = vides.Path(np.array([[-4, 0.1, 0.05], [4, 0, 0]]), look_at=(0, 0, -9), frames=201)
    path.set_object(written())
    path.points[0].zoom = 30
    before = path.copy()
    assert "through" in {found.kind for found in path.check()} and path.fix()
    assert "through" not in {found.kind for found in path.check()}
    assert path.undo() and path == before
    assert path.undo() and path.points[0].zoom != 30
