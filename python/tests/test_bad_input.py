"""What makes no sense raises an exception with a sentence, and changes nothing."""

import inspect
import os
import pickle
import random
import re
from collections.abc import Callable
from pathlib import Path as File
from typing import Any

import numpy as np
import pytest

import vides
from vides import _vides

from .conftest import MANY

CALLS = 1000 if MANY else 60


def nasty(rng: random.Random) -> Any:
    """One of many values that somebody may give by mistake."""
    table = np.arange(40.0).reshape(4, 10)
    frozen = table.copy()
    frozen.flags.writeable = False
    with_nan = np.full((3, 3), 1.0)
    with_nan[2, 1] = np.nan
    return rng.choice(
        [
            None, True, False, 0, 1, 2, -1, 3, 2**31, 2**63, -(2**70), 0.5, -1.5, 1e300, float("nan"),
            float("inf"), 1j, "", "x", "y", "z", "tcb", "turn", "camera", "position", "linear", "\0", "ü\ud800",
            "a\nb", "zoom", "/nowhere/at/all.vid", ".", "n" * 5000, b"", b"x", (), [], {}, [1, 2, 3], (0, 0, 0),
            [1, "a"], [[1], [2, 3]], {"x": 1}, {1: 2}, object(), lambda *_: 1, int, Ellipsis, slice(0, 1),
            np.zeros(3), np.zeros((3, 3)), np.zeros((3, 10)), table, table.T, table[::-1], table[:, ::2],
            np.asfortranarray(table), frozen, with_nan, np.zeros((0, 10)), np.zeros((0, 3)), np.zeros((2, 3), int),
            table.astype(np.float32), table.astype(">f8"), table.astype(complex), table.astype(str),
            np.array([object()]), np.array(3.0), np.float32(2), np.int8(-3), np.zeros((1, 1, 1)),
            np.full((3, 3), np.inf), np.ma.masked_array([1.0, 2, 3], [False, True, False]), vides.Path(), vides.Scene(),
            vides.Path().sample(1, 3), vides.Path().points, vides.Path().points[0],
        ]
    )  # fmt: skip


def path() -> vides.Path:
    return vides.Path([[0, 0, 0], [1, 0, 0], [1, 1, 0]], frames=20)


def scene() -> vides.Scene:
    made = vides.Scene.of_path(path())
    made.add("cube", "object").set_mesh((np.eye(3), []))
    return made


MAKERS: dict[str, Callable[[], Any]] = {
    "Path": path,
    "Points": lambda: path().points,
    "Point": lambda: path().points[1],
    "Orientations": lambda: path().points[1].orientations,
    "Orientation": lambda: path().points[1].orientations[0],
    "Section": lambda: path().sections[0],
    "Samples": lambda: path().sample(),
    "Scene": scene,
    "Node": lambda: scene()["cube"],
    "native Document": lambda: path()._native,
    "native Scene": lambda: scene()._native,
    "vides": lambda: vides,
    "native": lambda: _vides,
}

SAFE = {"__init_subclass__", "__subclasshook__", "__class__", "__new__", "__getattribute__", "__slots__",
        "__class_getitem__", "__subclasscheck__", "__instancecheck__", "__dict__", "__weakref__", "__doc__"}  # fmt: skip

CASES = [
    (owner, name)
    for owner, make in MAKERS.items()
    for name in sorted(set(dir(make())) | ({"zoom", "hold", "title", "position"} if "P" in owner else set()))
    if name not in SAFE and not (inspect.ismodule(make()) and name.startswith("_"))
    and not inspect.ismodule(inspect.getattr_static(make(), name, None))
]  # fmt: skip


@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize(("owner", "name"), CASES)
def test_wrong_calls(owner: str, name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("DISPLAY", raising=False)
    rng = random.Random(f"{owner} {name}")
    make = MAKERS[owner]
    target = make()
    for number in range(CALLS):
        if number % 16 == 0:
            target = make()
        given = [nasty(rng) for _ in range(rng.choice([0, 1, 1, 1, 2, 2, 3, 4, 6, 9]))]
        named: dict[str, Any] = {}
        try:
            member = getattr(target, name)
            if callable(member):
                try:
                    parameters = list(inspect.signature(member).parameters)
                except (TypeError, ValueError):
                    parameters = []
                named = {key: nasty(rng) for key in parameters[len(given) :] if rng.random() < 0.4}
                member(*given, **named)
            elif given and not inspect.ismodule(target):
                setattr(target, name, given[0])
        except Exception as error:
            said(error, native=owner.startswith("native"))
    assert path() == path()


def said(error: Exception, native: bool) -> None:
    """Errors of ours are a sentence in one line, in words of Python's users."""
    if isinstance(error, vides.Error):
        assert str(error) and "\n" not in str(error) and error.kind
    assert "panicked" not in str(error)
    if not native:
        # The words of the layer below, which names an argument and then what is wrong with it.
        for inner in ("is not an instance of", "cannot be cast", r"argument '\w+': ", r"vides\._"):
            assert not re.search(inner, str(error)), error


POSITIONS = [
    ([1, 2, 3], r"positions must have the shape \(n, 3\), not \(3,\)"),
    (np.zeros((3, 2)), r"positions must have the shape \(n, 3\), not \(3, 2\)"),
    (np.zeros((3, 3)), "space|size|place"),
    ([[0, 0, 0], [1, 0, np.nan]], r"positions\[1, 2\] is nan"),
    ([[0, 0, 0]], "two"),
    ([[0, 0, 0], [1, 0]], "positions"),
]


@pytest.mark.parametrize(("positions", "said"), POSITIONS)
def test_positions(positions: Any, said: str) -> None:
    with pytest.raises(vides.Error, match=said):
        vides.Path(positions)


def test_types() -> None:
    for wrong in ("abc", [["a", "b", "c"]] * 2, np.zeros((2, 3), complex), [None, None]):
        with pytest.raises((TypeError, vides.Error)):
            vides.Path(wrong)  # type: ignore[arg-type]
    for wrong_frame in (1.5, "1", None, [1]):
        with pytest.raises(TypeError):
            vides.Path().sample(wrong_frame)  # type: ignore[arg-type]


def test_arrays_to_be_filled() -> None:
    path = vides.Path()
    frozen = np.zeros((121, 10))
    frozen.flags.writeable = False
    for wrong, said in (
        (np.zeros((120, 10)), "shape"),
        (np.zeros((121, 10), np.float32), "float64"),
        (np.zeros((121, 10), ">f8"), "float64"),
        (np.zeros((10, 121)).T, "order C"),
        (np.zeros((242, 10))[::2], "order C"),
        (np.zeros((121, 20))[:, ::2], "order C"),
        (frozen, "writeable"),
        ([[0.0] * 10] * 121, "array"),
    ):
        before = np.array(wrong)
        with pytest.raises(vides.Error, match=said):
            path.sample(out=wrong)  # type: ignore[arg-type]
        np.testing.assert_array_equal(before, wrong)
    for first, last in ((0, 5), (-1, 3), (1, 122), (5, 2), (200, 300)):
        with pytest.raises(vides.Error, match="frame"):
            path.sample(first, last)
    for frame in (0.5, 121.5, 0, -3):
        with pytest.raises(vides.Error, match="frame"):
            path.evaluate([1, frame])


def test_nothing_is_half_done() -> None:
    path = vides.Path([[0, 0, 0], [1, 0, 0], [1, 1, 0]])
    before = path.to_str()
    for change in (
        lambda: path.points.insert(1, (1, 2, np.nan)),
        lambda: setattr(path.points[0], "zoom", 0),
        lambda: setattr(path.points[0], "speed_curve", [50] * 9 + [200]),
        lambda: setattr(path, "fps", 0),
        lambda: setattr(path, "closed", "yes"),
        lambda: path.set_frames(1),
        lambda: path.repeat(10**9),
        lambda: path.set_space((0, 0, 0), -1),
        lambda: path.divide(7),
        lambda: path.points.move(0, 3),
        lambda: setattr(path, "up", "x"),
    ):
        with pytest.raises((vides.Error, IndexError)):
            change()
        assert path.to_str() == before
    file = "there.vid"
    path.save(file)
    os.chmod(".", 0o555)
    try:
        with pytest.raises(vides.Error):
            path.save("missing/there.vid")
    finally:
        os.chmod(".", 0o755)
    assert vides.Path.load(file) == path


def test_targets_are_set_at_once_or_not_at_all() -> None:
    """A target on point 2: no point is changed. Else all are, and one undo takes all back."""
    path = vides.Path([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], frames=50)
    path.points[1].orientations.append().roll = 20
    path.points[1].orientations.append().zoom = 50
    before = path.to_str()
    for look_at in (path.look_at, path.points[2].look_at):
        with pytest.raises(vides.Error, match="point 2.*target|target.*point 2") as raised:
            look_at((1, 1, 0))
        assert path.to_str() == before and raised.value.kind in ("argument", "range")
    for look_at in (path.look_at, path.points[1].look_at):
        look_at((3, 4, 5))
        assert all(view.target == (3, 4, 5) for view in path.points[1].orientations)
        changed = path.to_str()
        assert path.undo() and path.to_str() == before
        assert path.redo() and path.to_str() == changed and path.undo()
    gone = path.points[3]
    del path.points[3]
    with pytest.raises(IndexError):
        gone.look_at((3, 4, 5))


def test_what_takes_several_values_is_one_step() -> None:
    """Each call that changes several points or values is wholly done, and wholly taken back."""
    wall = [[0.5, -1, -1], [0.5, 1, -1], [0.5, 0, 1]], [[0, 1, 2]]
    changes: list[Callable[[vides.Path], object]] = [
        lambda path: setattr(path, "positions", path.positions * 2),
        lambda path: path.look_at((3, 4, 5)),
        lambda path: setattr(path, "base_speeds", {"move_frames": 7, "turn_frames": 8}),
        lambda path: setattr(path, "presets", {"0": {"tension": 0.5}, "3": {"bias": 0.5}}),
        lambda path: path.set_limits(turning=20, speed=3),
        lambda path: path.divide(0, 5),
        lambda path: path.set_frames(200),
        lambda path: path.set_space((1, 1, 1), 9, fit=True),
        lambda path: setattr(path, "up", "z"),
        lambda path: path.reverse(),
        lambda path: path.repeat(2),
        lambda path: path.turn("y", 30),
        lambda path: path.transform(np.diag([2, 2, 2, 1])),
        lambda path: path.insert_path(path),
        lambda path: path.look_at(path.positions + 1),
        lambda path: setattr(path, "zooms", [30, 40, 50, 60]),
        lambda path: setattr(path, "rolls", 5),
        lambda path: setattr(path, "times", [0, 1, 3, 4]),
        lambda path: path.set_object(wall),
        lambda path: path.retime(speed=0.5, acceleration=2),
        lambda path: path.avoid(0.2, object=wall),
        lambda path: path.steady(1),
        lambda path: path.fix(),
    ]
    for number, change in enumerate(changes):
        path = vides.Path([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], look_at=(5, 5, 5), frames=60)
        before = path.to_str()
        change(path)
        changed = path.to_str()
        assert changed != before or number == len(changes) - 1, number
        if changed != before:
            assert path.undo() and path.to_str() == before, number
            assert path.redo() and path.to_str() == changed, number
            path.undo()
        assert not path.undo(), number


def test_times_that_are_no_seconds_are_refused_at_once(tmp_path: File) -> None:
    poses = vides.Path().sample(1, 100)
    for step in (33e6, 1e30):
        with pytest.raises(vides.Error, match="times of the poses span .* frames") as raised:
            vides.Path.fit(poses, np.arange(100) * step)
        assert raised.value.kind == "limit"
    lines = [f"{k if k < 3 else 10**9} {k} 0 0 0 0 0 40" for k in range(4)]
    File("far.chan").write_text("\n".join(lines))
    for load in (vides.Path.load, vides.Scene.load):
        with pytest.raises(vides.Error, match="frames") as raised:
            load("far.chan")
        assert raised.value.kind == "limit"
    assert vides.Samples.load("far.chan").frames[-1] == 1e9


def test_the_system_refuses(tmp_path: File) -> None:
    for call in (
        lambda: vides.Path.load("missing.vid"),
        lambda: vides.Samples.load("missing.csv"),
        lambda: vides.Scene.load("missing.glb"),
        lambda: vides.Path().set_object("missing.obj"),
        lambda: vides.Path().save("missing/there.vid"),
        lambda: vides.Path().save("missing/there.csv"),
        lambda: vides.convert("missing.vid", "there.csv"),
    ):
        with pytest.raises(FileNotFoundError, match="missing.*: ") as raised:
            call()
        error = raised.value
        assert isinstance(error, vides.Error) and error.kind == "io" and error.errno == 2
        again = pickle.loads(pickle.dumps(error))
        assert str(again) == str(error) and isinstance(again, FileNotFoundError)
    with pytest.raises(OSError) as refused:
        vides.Path.load("/proc/self/mem")
    assert isinstance(refused.value, vides.Error)
    assert not isinstance(refused.value, FileNotFoundError)


def test_what_is_gone_is_an_index_error() -> None:
    path = vides.Path([[0, 0, 0], [1, 0, 0], [1, 1, 0]])
    last, view = path.points[2], path.points[0].orientations.append()
    del path.points[2], path.points[0].orientations[1]
    for call in (
        lambda: last.position,
        lambda: last.zoom,
        lambda: setattr(last, "zoom", 30),
        lambda: view.zoom,
        lambda: view.make_absolute(),
        lambda: view.up_vector,
        lambda: last.orientations[0],
    ):
        with pytest.raises(IndexError, match="there is no (point 2|orientation 1)") as raised:
            call()
        assert isinstance(raised.value, vides.Error)


COUNTS: list[tuple[Callable[[vides.Path], object], str]] = [
    (lambda path: vides.Path([[0, 0, 0], [1, 0, 0]], frames=-5), "^frames must lie"),
    (lambda path: vides.Path([[0, 0, 0], [1, 0, 0]], frames=2**70), "^frames must lie"),
    (lambda path: vides.Path([[0, 0, 0], [1, 0, 0]], frames=True), "^frames must be a whole"),
    (lambda path: vides.Path([[0, 0, 0], [1, 0, 0]], frames=2.5), "^frames must be a whole"),  # type: ignore[arg-type]
    (lambda path: vides.Path([[0, 0, 0], [1, 0, 0]], fps="a"), "^fps must be a number"),  # type: ignore[arg-type]
    (lambda path: vides.Path([[0, 0, 0], [1, 0, 0]], zoom=True), "^zoom must be a number"),
    (lambda path: path.set_frames(-3), "^frames must lie"),
    (lambda path: path.divide(-1), "^segment must lie"),
    (lambda path: path.divide(0, -1), "^points must lie"),
    (lambda path: path.divide(True), "^segment must be a whole"),
    (lambda path: path.insert_on_curve("x"), "^frame must be a number"),  # type: ignore[arg-type]
    (lambda path: setattr(path.points[0], "name", 5), "^name must be a text, not int"),
    (lambda path: setattr(path, "comment", True), "^comment must be a text, not bool"),
    (lambda path: vides.Path([[0, 0, 0], [1, 0, 0]], up=(0, 0, 1)), r'^up must be "y" or "z", not \(0, 0, 1\)'),  # type: ignore[arg-type]
    (lambda path: setattr(path, "up", [0, 0, 1]), r'^up must be "y" or "z", not \[0, 0, 1\]'),
    (lambda path: vides.Path([[0, 0, 0], [1, 0, 0]], curve=3), "^curve must be a text, not int"),  # type: ignore[arg-type]
    (lambda path: path.turn(1), "^axis must be a text, not int"),  # type: ignore[arg-type]
    (lambda path: path.set_space((0, 0, 0), "1"), "^half_size must be a number, not str"),  # type: ignore[arg-type]
]


@pytest.mark.parametrize(("call", "said"), COUNTS)
def test_numbers_are_called_by_their_names(call: Callable[[vides.Path], object], said: str) -> None:
    path = vides.Path()
    with pytest.raises((TypeError, vides.Error), match=said):
        call(path)
    assert path == vides.Path()


def test_a_folder_is_written_only_where_it_is_asked_for(tmp_path: File) -> None:
    target = tmp_path / "model"
    target.mkdir()
    for call in (
        lambda: vides.Path().save(target),
        lambda: vides.Path().save("."),
        lambda: vides.Scene.of_path(vides.Path()).save(target),
    ):
        with pytest.raises(vides.Error, match='is a folder: .*format="colmap"'):
            call()
    vides.Path().save("flight.vid")
    with pytest.raises(vides.Error, match="is a folder"):
        vides.convert("flight.vid", target)
    assert list(target.iterdir()) == []
    vides.Path().save(target, "colmap")
    assert len(list(target.iterdir())) == 3


def test_messages_speak_of_python() -> None:
    path = vides.Path()
    with pytest.raises(TypeError, match=r"^Path\.orbit\(\) got an unexpected keyword argument 'x'"):
        vides.Path.orbit(x=3)  # type: ignore[call-arg]
    path.save("flight.vid")
    File("odd.dat").write_bytes(b"\x00\x01")
    with pytest.raises(vides.Error, match="name it, with target_format="):
        vides.convert("flight.vid", "flight.foo")
    with pytest.raises(vides.Error, match="name it, with source_format="):
        vides.convert("odd.dat", "flight.csv")
    with pytest.raises(vides.Error, match="at least two poses"):
        vides.Path.fit(path.sample().array[:1], tolerance=0.01)
    # It leaps to and fro between whole frames, where no point can be: fitted as well as can be.
    leaps = path.sample().array.copy()
    leaps[::2, 1] += 1
    vides.Path.fit(leaps, np.arange(121) / 60, tolerance=0.01)
