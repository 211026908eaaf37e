"""A path: made, edited, sampled."""

import copy
import gc
import pickle
import re
import weakref
from html.parser import HTMLParser
from pathlib import Path as File

import numpy as np
import pytest

import vides

POINTS = np.array([[3.0, 1.0, 0.0], [0.0, 2.0, 3.0], [-3.0, 1.0, 0.0], [0.0, 0.0, -3.0]])


@pytest.fixture
def path() -> vides.Path:
    return vides.Path(POINTS, look_at=(0, 0, 0), frames=200)


def test_a_hundred_points_in_twelve_lines() -> None:
    program = """
import numpy as np
import vides

t = np.linspace(0, 2 * np.pi, 100, endpoint=False)
knot = np.stack([(2 + np.cos(3 * t)) * np.cos(2 * t),
                 np.sin(3 * t), (2 + np.cos(3 * t)) * np.sin(2 * t)], axis=1)
path = vides.Path(knot, look_at=(0, 0, 0), closed=True, frames=1000)
samples = path.sample()
picture = path.plot()
"""
    names: dict[str, object] = {}
    exec(program, names)
    assert len(program.strip().splitlines()) <= 12
    samples = names["samples"]
    assert isinstance(samples, vides.Samples) and samples.array.shape == (1000, 10)
    assert str(names["picture"]).startswith("<svg")


def test_it_passes_through_its_points_and_looks_at_its_target(path: vides.Path) -> None:
    samples = path.sample()
    assert len(samples) == path.frame_count == 200
    frames = [1] + [s.first_frame - 1 + s.frames for s in path.sections]
    at = samples.array[np.array(frames) - 1]
    np.testing.assert_array_equal(at[:, :3], POINTS)
    toward = -samples.positions / np.linalg.norm(samples.positions, axis=1, keepdims=True)
    np.testing.assert_allclose(samples.view, toward, atol=1e-12)
    np.testing.assert_allclose(np.linalg.norm(samples.up, axis=1), 1, atol=1e-12)


def test_parts_are_views_of_one_array(path: vides.Path) -> None:
    samples = path.sample()
    assert samples.array.shape == (200, 10) and samples.array.dtype == np.float64
    assert samples.array.flags.c_contiguous and samples.array.flags.writeable
    for part, width in ((samples.positions, 3), (samples.view, 3), (samples.up, 3)):
        assert part.base is samples.array and part.shape == (200, width)
    assert samples.zoom.base is samples.array and samples.zoom.shape == (200,)
    samples.positions[3] = 7
    assert (samples.array[3, :3] == 7).all()
    assert np.asarray(samples) is samples.array
    assert samples[5:10].array.base is samples.array


def test_a_range_and_an_array_of_ones_own(path: vides.Path) -> None:
    whole = path.sample()
    part = path.sample(11, 20)
    np.testing.assert_array_equal(part.array, whole.array[10:20])
    np.testing.assert_array_equal(part.frames, np.arange(11, 21))
    room = np.full((10, 10), np.nan)
    assert path.sample(11, 20, out=room).array is room
    np.testing.assert_array_equal(room, part.array)
    np.testing.assert_array_equal(path.evaluate(np.arange(11, 21)).array, part.array)
    assert len(path.sample(5, 4)) == 0


def test_between_frames_it_is_near_its_neighbours(path: vides.Path) -> None:
    frames = np.linspace(1, 200, 5000)
    fine = path.evaluate(frames)
    step = np.linalg.norm(np.diff(fine.positions, axis=0), axis=1)
    assert step.sum() == pytest.approx(path.length, rel=1e-4)
    motion = path.motion(frames)
    assert motion[-1, 0] == pytest.approx(path.length, rel=1e-9)
    np.testing.assert_allclose(fine.seconds, (frames - 1) / 25)


def test_points_are_edited(path: vides.Path) -> None:
    path.points.append((1, 1, 1))
    assert len(path.points) == 5
    path.points[-1].position = np.array([2, 2, 2], dtype=np.float32)
    np.testing.assert_array_equal(path.positions[4], [2, 2, 2])
    del path.points[0]
    np.testing.assert_array_equal(path.points[0].position, POINTS[1])
    assert path.points[1] == path.points[1] != path.points[0]
    assert path.points.index(path.points[2]) == 2
    path.points.move(0, 3)
    np.testing.assert_array_equal(path.points[3].position, POINTS[1])
    assert [p.index for p in path.points[1:3]] == [1, 2]
    with pytest.raises(IndexError, match="there is no point 4"):
        path.points[4]
    while path.undo():
        pass
    np.testing.assert_array_equal(path.positions, POINTS)
    assert path.redo() and len(path.points) == 5


def test_properties_have_the_keys_of_files(path: vides.Path) -> None:
    point = path.points[1]
    point.zoom = 50
    assert point.zoom == point.orientations[0].zoom == 50
    second = point.orientations.append()
    second.roll = np.float32(30)
    assert [view.roll for view in point.orientations] == [0, 30]
    second.hold = np.int64(12)
    second.speed_curve = np.linspace(10, 100, 10)
    assert second.hold == 12 and second.speed_curve[-1] == 100
    point.own = {"tension": 0.5, "continuity": 0, "bias": -0.25}
    assert point.own == {"tension": 0.5, "continuity": 0.0, "bias": -0.25}
    point.name = 'a "name"'
    assert point.name == 'a "name"'
    point.name = None
    point.zoom = None
    assert point.zoom == 24 and not point.name
    path.title = "Ü\\\n"[:2]
    assert path.title == "Ü\\"
    path.closed = True
    assert path.closed is True and len(path.sections) == 5
    path.fps = 30
    assert path.sample().fps == 30


def test_an_unknown_attribute_is_told_with_the_one_that_is_meant(path: vides.Path) -> None:
    with pytest.raises(AttributeError, match="is zoom.* meant"):
        path.points[0].zooom = 3  # type: ignore[attr-defined]
    with pytest.raises(AttributeError, match="its points have"):
        path.zoom = 35  # type: ignore[attr-defined]
    with pytest.raises(AttributeError):
        path.nonsense  # type: ignore[attr-defined]
    assert not hasattr(path.points[0], "nonsense")


def test_files_and_copies(path: vides.Path, tmp_path: File) -> None:
    file = tmp_path / "flight.vid"
    assert path.save(file) == []
    again = vides.Path.load(file)
    assert again == path and again.sample().array.tobytes() == path.sample().array.tobytes()
    assert vides.Path.from_str(file.read_text()) == path
    for twin in (path.copy(), copy.deepcopy(path), pickle.loads(pickle.dumps(path))):
        assert twin == path
        twin.points[0].zoom = 99
        assert twin != path
    losses = path.save(tmp_path / "camera_path.json", fps=50)
    assert losses and all(isinstance(loss, str) for loss in losses)
    near = vides.Path.load(tmp_path / "camera_path.json", tolerance=0.01)
    # There z stands upright.
    assert near.up == "z"
    np.testing.assert_allclose(near.evaluate(1).positions, [[3, 0, 1]], atol=0.02)


@pytest.mark.parametrize("name", [f.name for f in vides.formats() if f.writes and f.name != "vid"])
def test_every_format_is_written(path: vides.Path, tmp_path: File, name: str) -> None:
    target = tmp_path / "out"
    path.save(target, format=name)
    assert target.exists()
    known = next(f for f in vides.formats() if f.name == name)
    if known.reads:
        again = vides.Path.load(target, format=name)
        assert np.abs(again.sample(1, 1).positions).max() < 10


def test_an_error_tells_place_and_line(tmp_path: File) -> None:
    file = tmp_path / "bad.vid"
    file.write_text("version = 1\n\nfps = -3\n")
    with pytest.raises(vides.Error) as caught:
        vides.Path.load(file)
    error = caught.value
    assert (error.kind, error.line) == ("format", 3)
    assert error.place is not None and "bad.vid" in error.place and "fps" in error.place
    assert "\n" not in str(error)
    again = pickle.loads(pickle.dumps(error))
    assert (str(again), again.kind, again.place, again.line) == (str(error), error.kind, error.place, 3)
    with pytest.raises(vides.Error, match="No such file") as missing:
        vides.Path.load(tmp_path / "missing.vid")
    assert missing.value.kind == "io"
    with pytest.raises(vides.Error, match="hold") as refused:
        vides.Path().points[1].hold = 10**9
    assert refused.value.place == "hold"


def test_tools_and_checks(path: vides.Path, tmp_path: File) -> None:
    mesh = tmp_path / "mesh.obj"
    mesh.write_text("v 0 0 90\nv 1 0 90\nv 0 1 90\nv 0 0 91\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n")
    path.set_object(mesh)
    path.scale(2)
    assert np.ptp(path.positions, axis=0).max() == pytest.approx(12)
    jerky = vides.Path(np.random.default_rng(1).uniform(-1, 1, (6, 3)), frames=30)
    found = jerky.check()
    assert found and all(f.text and f.first_frame >= 1 for f in found)
    path.reverse()
    path.set_frames(50)
    assert path.frame_count == 50


def test_the_total_is_shared_anew_after_a_point_moved() -> None:
    path = vides.Path([[0, 0, 0], [1, 0, 0], [2, 0, 0], [3, 0, 0]], curve="linear", frames=301)
    assert [section.frames for section in path.sections] == [100, 100, 100]
    path.points[1].position = (0.5, 0, 0)
    path.set_frames(301)
    assert [section.frames for section in path.sections] == [50, 150, 100]


def test_a_recording_is_fitted(path: vides.Path) -> None:
    recorded = path.sample()
    fitted = vides.Path.fit(recorded, tolerance=0.01)
    assert len(fitted.points) < 40
    off = np.linalg.norm(fitted.sample().positions - recorded.positions, axis=1)
    assert off.max() <= 0.0101
    noisy = recorded.array.copy()
    noisy[77, :3] += 2
    robust = vides.Path.fit(noisy, tolerance=0.01, robust=True)
    assert robust.losses == ("pose 77 is left out",)
    # A camera that turns on the spot has no diagonal.
    turns = np.repeat(recorded.array[:1], 30, axis=0)
    turns[:, 3:5] = [[np.sin(a), np.cos(a)] for a in np.linspace(0, 1, 30)]
    turns[:, 5:9] = [0, 0, 0, 1]
    assert vides.Path.fit(turns).frame_count == 30
    report = robust.fit_report
    assert report is not None and report.outliers == (77,) and report.poses == len(noisy)
    assert report.points == len(robust.points) and report.position[1] <= report.position[0] <= 0.01001
    assert report.better is None and report.text.startswith(f"{report.points} points for ")
    assert report.robust is None
    noisy[[20, 60, 90, 120, 160], 1] += 2
    followed = vides.Path.fit(noisy, tolerance=0.01).fit_report
    robust = vides.Path.fit(noisy, tolerance=0.01, robust=True)
    assert followed is not None and followed.robust == (6, len(robust.points))
    assert len(vides.Path.fit(recorded, points=5).points) <= 5 and path.fit_report is None


def test_pictures(path: vides.Path, tmp_path: File) -> None:
    picture = path.plot()
    assert picture._repr_svg_() == picture and picture.startswith("<svg")
    assert path.plot(dark=True) != picture
    path.title = '</title><script>alert("x")</script>'
    assert "<script" not in path.plot()
    # All of the page is one attribute's value: no tag but the frame's own.
    seen: list[tuple[str, dict[str, str | None]]] = []

    class Reader(HTMLParser):
        def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
            seen.append((tag, dict(attrs)))

    Reader().feed(path._repr_html_())
    ((tag, attributes),) = seen
    assert tag == "iframe" and attributes["sandbox"] == "allow-scripts"
    assert attributes["srcdoc"] == path.to_html() and "<script" in path.to_html()


def test_gone_paths() -> None:
    path = vides.Path()
    seen = weakref.ref(path)
    point, samples = path.points[1], path.sample()
    del path
    gc.collect()
    # A point keeps its path.
    assert seen() is not None and point.zoom == 24
    path = vides.Path(POINTS)
    last = path.points[3]
    del path.points[3]
    with pytest.raises(vides.Error, match="there is no point 3"):
        last.position
    with pytest.raises(vides.Error):
        last.zoom
    assert samples.array.shape == (121, 10)


def test_what_is_written_into_a_copy_is_not_lost_silently(path: vides.Path) -> None:
    with pytest.raises(ValueError, match="read-only"):
        path.points[0].position[1] = 5
    with pytest.raises(ValueError, match="read-only"):
        path.positions[:, 1] += 1
    with pytest.raises(TypeError):
        path.points[0].target[0] = 5  # type: ignore[index]
    path.positions = path.positions + [0, 1, 0]
    np.testing.assert_array_equal(path.positions, POINTS + [0, 1, 0])
    assert path.undo()
    np.testing.assert_array_equal(path.positions, POINTS)
    with pytest.raises(vides.Error, match="there are 4 points, and 3 positions"):
        path.positions = POINTS[:3]


def test_sections_are_edited(path: vides.Path) -> None:
    first = path.sections[0]
    first.frames = 77
    assert first.frames == 77 == path.sections[0].frames
    first.speed_curve = np.linspace(1, 100, 10)
    assert path.points[0].speed_curve == tuple(np.linspace(1, 100, 10))
    assert first.length == pytest.approx(path.length / 3, rel=0.5)
    path.base_speeds = {"zoom_frames": 42}
    assert path.base_speeds["zoom_frames"] == 42 and len(path.base_speeds) == 4
    path.presets = {"3": {"tension": 1.0, "continuity": 0.0, "bias": 0.0}}
    assert path.presets["3"]["tension"] == 1


def test_insert_counts_as_lists_do() -> None:
    path = vides.Path(POINTS)
    for at in (-1, -len(POINTS), 0, 2, len(POINTS)):
        wanted = [tuple(place) for place in POINTS]
        wanted.insert(at, (9.0, 9.0, 9.0))
        twin = path.copy()
        point = twin.points.insert(at, (9, 9, 9))
        assert [tuple(place) for place in twin.positions] == wanted
        assert tuple(point.position) == (9, 9, 9)
    views = path.points[0].orientations
    views[0].roll = 10
    views.append().roll = 20
    views.insert(-1).roll = 15
    assert [view.roll for view in views] == [10, 15, 20]
    for wrong in (-len(POINTS) - 1, len(POINTS) + 1):
        with pytest.raises(IndexError):
            path.points.insert(wrong, (0, 0, 0))


def test_points_are_compared() -> None:
    path = vides.Path(POINTS)
    assert path.points[0] == path.points[0] and path.points[0] != path.points[1]
    assert path.points[0] in path.points and path.points[0] != path.copy().points[0]
    path.base_speeds = path.presets = None
    assert path == vides.Path(POINTS)


def test_what_the_docstring_names_is_there() -> None:
    path = vides.Path()
    named = (vides.Path.__doc__ or "").split("the keys in ``.vid`` files:")[1].split(". Setting")[0]
    keys = re.findall("``(\\w+)``", named)
    assert len(keys) == 10
    for key in keys:
        getattr(path, key)
