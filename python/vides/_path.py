"""A camera path: its points, their orientations, the sections between them."""

from __future__ import annotations

import difflib
import html
import operator
import os
import re
from collections.abc import Iterator, Sequence
from typing import Any, Literal, NamedTuple, SupportsIndex, TypeVar, overload

import numpy as np
import numpy.typing as npt

from . import _vides
from ._arrays import Array, Vector, doubles, vector
from ._error import Error
from ._files import choices, path_of
from ._samples import Samples

Curve = Literal["tcb", "cubic", "linear"]
Axis = Literal["y", "z"]
_Item = TypeVar("_Item")


def _index(at: SupportsIndex, count: int, what: str) -> int:
    number = operator.index(at)
    if not -count <= number < count:
        raise IndexError(f"there is no {what} {number}: there are {count}, counted from 0")
    return number % count


class _Keyed:
    """Something whose properties have names that the engine's table lists."""

    __slots__ = ()

    def _document(self) -> _vides.Document:
        raise NotImplementedError

    def _prefix(self) -> str:
        raise NotImplementedError

    def __getattr__(self, name: str) -> Any:
        """A property by its key in files, with or without its unit; ``None`` where it is not set."""
        if name.startswith("_"):
            raise AttributeError(f"{type(self).__name__} has no {name}")
        try:
            return self._document().property(self._prefix() + name)
        except AttributeError:
            raise self._unknown(name) from None

    def __setattr__(self, name: str, value: Any) -> None:
        """Sets a property; ``None`` gives back what a new path has."""
        known = getattr(type(self), name, None)
        if name.startswith("_") or known is not None:
            object.__setattr__(self, name, value)
        else:
            try:
                self._document().set_property(self._prefix() + name, value)
            except AttributeError:
                raise self._unknown(name) from None
            except Error as error:
                # In files points count from 1.
                sentence = str(error).removeprefix(self._prefix())
                place = name if error.place == self._prefix() + name else error.place
                raise Error(sentence, error.kind, place, error.line) from None

    def _unknown(self, name: str) -> AttributeError:
        kind = type(self).__name__
        near = difflib.get_close_matches(name, dir(self), 1, 0.7)
        meant = f": is {near[0]} meant?" if near else "; dir() lists what it has"
        return AttributeError(f"{kind} has no {name}{meant}", name=name, obj=self)

    def __dir__(self) -> list[str]:
        return [*object.__dir__(self), *self._keys()]

    def _keys(self) -> list[str]:
        return []


def _bare_keys() -> list[str]:
    """Keys of orientations, without their units."""
    return [re.sub("_(mm|degrees|frames)$", "", row[0]) for row in _vides.keys()]


class Orientation(_Keyed):
    """One camera orientation at a point: what the camera looks at, and how it goes on.

    Its properties have the keys of ``.vid`` files, with or without their unit: ``target`` or
    ``offset`` (x, y, z), ``roll`` (degrees), ``zoom`` (mm, 1 to 2000), ``hold`` (frames),
    ``speed_curve`` (ten numbers, 1 to 100) and so on; :func:`vides.properties` lists them.

    >>> path = Path()
    >>> view = path.points[0].orientations[0]
    >>> view.zoom, view.roll, view.hold
    (24.0, 0.0, 0)
    >>> view.target = [0, 0, 0]
    >>> view.hold = 25
    >>> path.frame_count
    146
    """

    __slots__ = ("_owner", "_point", "_at")

    def __init__(self, path: Path, point: int, at: int) -> None:
        self._owner = path
        self._point = point
        self._at = at

    def _document(self) -> _vides.Document:
        return self._owner._native

    def _prefix(self) -> str:
        return f"point.{self._point + 1}.view.{self._at + 1}."

    def _keys(self) -> list[str]:
        return _bare_keys()

    @property
    def up_vector(self) -> Array:
        """(3,): the camera's up, roll included; a unit vector perpendicular to its view."""
        return np.array(self._document().up_at(self._point, self._at))

    def make_absolute(self, absolute: bool = True) -> None:
        """Makes the target a place of the world, or an offset from the point; the view stays."""
        self._document().edit("set_absolute", point=self._point, at=self._at, absolute=absolute)

    def __repr__(self) -> str:
        return f"<vides.Orientation {self._at} of point {self._point}>"


class _Sequence(Sequence[_Item]):
    """Counted from 0, from the end below 0; slices give lists."""

    __slots__ = ()

    def _item(self, at: int) -> _Item:
        raise NotImplementedError

    def _what(self) -> str:
        raise NotImplementedError

    @overload
    def __getitem__(self, index: int) -> _Item: ...
    @overload
    def __getitem__(self, index: slice) -> list[_Item]: ...

    def __getitem__(self, index: int | slice) -> _Item | list[_Item]:
        if isinstance(index, slice):
            return [self._item(at) for at in range(*index.indices(len(self)))]
        return self._item(_index(index, len(self), self._what()))

    def __iter__(self) -> Iterator[_Item]:
        return (self._item(at) for at in range(len(self)))


class Orientations(_Sequence[Orientation]):
    """The orientations of a point in the order in which the camera takes them; at least one."""

    __slots__ = ("_owner", "_point")

    def __init__(self, path: Path, point: int) -> None:
        self._owner = path
        self._point = point

    def __len__(self) -> int:
        return self._owner._native.orientation_count(self._point)

    def _item(self, at: int) -> Orientation:
        return Orientation(self._owner, self._point, at)

    def _what(self) -> str:
        return "orientation"

    def insert(self, at: int) -> Orientation:
        """A new orientation before number ``at``: a copy of the one before it.

        >>> path = Path()
        >>> path.points[0].orientations.append().roll = 90
        >>> [view.roll for view in path.points[0].orientations]
        [0.0, 90.0]
        """
        at = _index(at, len(self) + 1, "place")
        self._owner._native.edit("insert_orientation", point=self._point, at=at)
        return Orientation(self._owner, self._point, at)

    def append(self) -> Orientation:
        """A new orientation behind the others: a copy of the last one."""
        return self.insert(len(self))

    def __delitem__(self, at: int) -> None:
        at = _index(at, len(self), "orientation")
        self._owner._native.edit("remove_orientation", point=self._point, at=at)

    def __repr__(self) -> str:
        return f"<vides.Orientations: {len(self)} of point {self._point}>"


class Point(_Keyed):
    """A support point: the camera passes through it.

    It is the point of this number: after one before it was removed, it is another.

    The properties of its first orientation are its own, too: ``point.zoom = 30``. Beside them it
    has ``position``, ``name``, ``preset`` (0 to 9) or ``own`` (``{"tension": 0.5}``) for the shape
    of the curve, and ``tangents``.

    >>> path = Path()
    >>> path.points[0].position = (-1, 0, 1)
    >>> path.points[0].position
    array([-1.,  0.,  1.])
    >>> path.points[0].zoom = 50
    >>> path.points[0].name = "start"
    """

    __slots__ = ("_owner", "_at")

    def __init__(self, path: Path, at: int) -> None:
        self._owner = path
        self._at = at

    def _document(self) -> _vides.Document:
        return self._owner._native

    def _prefix(self) -> str:
        return f"point.{self._at + 1}."

    def _keys(self) -> list[str]:
        return ["name", "own", "preset", "tangents", *_bare_keys()]

    @property
    def index(self) -> int:
        """Its number, counted from 0."""
        return self._at

    @property
    def position(self) -> Array:
        """(3,): where it lies; a copy, so assign a whole position."""
        return np.array(self._document().position(self._at))

    @position.setter
    def position(self, position: Vector) -> None:
        self._document().edit("set_position", at=self._at, position=vector(position, "position"))

    @property
    def orientations(self) -> Orientations:
        """Its orientations."""
        return Orientations(self._owner, self._at)

    def look_at(self, target: Vector) -> None:
        """Lets all its orientations look at a place of the world."""
        place = list(vector(target, "target"))
        for orientation in self.orientations:
            orientation.target = place

    def __repr__(self) -> str:
        x, y, z = self.position
        return f"<vides.Point {self._at} at ({x:g}, {y:g}, {z:g})>"


class Points(_Sequence[Point]):
    """The points of a path; at least two.

    >>> path = Path()
    >>> path.points.insert(1, (0, 0.5, 0.5))
    <vides.Point 1 at (0, 0.5, 0.5)>
    >>> del path.points[0]
    >>> len(path.points)
    2
    """

    __slots__ = ("_owner",)

    def __init__(self, path: Path) -> None:
        self._owner = path

    def __len__(self) -> int:
        return self._owner._native.point_count()

    def _item(self, at: int) -> Point:
        return Point(self._owner, at)

    def _what(self) -> str:
        return "point"

    def insert(self, at: int, position: Vector) -> Point:
        """A new point before number ``at``; all but its name is as at the one before it."""
        at = _index(at, len(self) + 1, "place")
        self._owner._native.edit("insert_point", at=at, position=vector(position, "position"))
        return Point(self._owner, at)

    def append(self, position: Vector) -> Point:
        """A new point behind the last one."""
        return self.insert(len(self), position)

    def __delitem__(self, at: int) -> None:
        self._owner._native.edit("remove_point", at=_index(at, len(self), "point"))

    def move(self, source: int, to: int) -> None:
        """Gives a point another number; those between move up or down by one."""
        count = len(self)
        self._owner._native.edit(
            "move_point", source=_index(source, count, "point"), to=_index(to, count, "point")
        )

    def __repr__(self) -> str:
        return f"<vides.Points: {len(self)}>"


class Section(NamedTuple):
    """The way from one orientation to the next, at one point or on to the next point."""

    point: int
    """The point at which it begins."""
    orientation: int
    """The orientation of that point with which it begins; it has the section's speeds."""
    change: str
    """What changes: ``"position"``, ``"view"``, ``"roll"``, ``"zoom"`` or ``"nothing"``."""
    amount: float
    """By how much, in units of its base speed: half sizes, half turns, …"""
    frames: int
    """How many frames it takes; 0 if nothing changes."""
    first_frame: int
    """The first frame behind the orientation with which it begins."""
    length: float
    """Length of the way, in the world's lengths."""


class Finding(NamedTuple):
    """Something that will look wrong in the film."""

    kind: str
    """A name, as in ``vides check``."""
    first_frame: float
    """The first frame, from 1."""
    last_frame: float
    """The last frame."""
    point: int
    """The point at which the section begins."""
    orientation: int
    """The orientation of that point with which it begins."""
    value: float
    """The worst value."""
    limit: float
    """The limit."""
    text: str
    """The finding in a sentence."""
    remedy: str
    """What helps."""


class Tool(NamedTuple):
    """A tool of :meth:`Path.tool`."""

    name: str
    """What :meth:`Path.tool` takes."""
    does: str
    """What it does."""
    wants_path: bool
    """Whether it takes another path."""
    parameters: dict[str, str]
    """What it takes by name, and what that is."""


def tools() -> list[Tool]:
    """The tools of :meth:`Path.tool`.

    >>> [tool.name for tool in tools()][:3]
    ['orbit', 'spiral', 'arc']
    """

    def row(name: str, does: str, unit: str, width: int) -> tuple[str, str]:
        numbers = "" if width == 1 else f", {width} numbers"
        return name, does + (f" ({unit})" if unit else "") + numbers

    return [
        Tool(name, does, block, dict(row(*parameter) for parameter in parameters))
        for name, does, block, parameters in _vides.tools()
    ]


class Property(NamedTuple):
    """A property of an orientation."""

    key: str
    """Its key in files; its unit at the end may be left out."""
    does: str
    """What it is for."""
    kind: str
    """What its values are."""
    unit: str
    """What its numbers count."""
    range: tuple[float, float] | None
    """The least and the greatest, if they are fixed."""


def properties() -> list[Property]:
    """The properties of orientations, as the engine's table has them.

    >>> [row for row in properties() if row.key == "zoom_mm"][0].range
    (1.0, 2000.0)
    """
    return [Property(*row) for row in _vides.keys()]


class SVG(str):
    """A picture as SVG text, which a notebook shows.

    ``pathlib.Path("plot.svg").write_text(picture)`` keeps it.
    """

    __slots__ = ()

    def _repr_svg_(self) -> str:
        return str(self)


class Path(_Keyed):
    """A camera path: points in space, each with one or more camera orientations.

    Without arguments it is the path with which a new window begins, of two points. Points and
    orientations count from 0, frames from 1, as they do in the window and in C.

    ``positions``, shape (n, 3) with n ≥ 2, are the points, in the world's lengths. Every camera
    looks at ``look_at`` (3,); without it along −z, or −x where z is ``up``. ``frames`` is how many
    poses there are in all; without it the base speeds say. ``zoom`` is a focal length in mm (24: a
    vertical field of view of 53°). ``curve`` is ``"tcb"`` (Kochanek–Bartels), ``"cubic"`` (a
    spline with continuous second derivatives) or ``"linear"``.

    >>> angles = np.linspace(0, 2 * np.pi, 100, endpoint=False)
    >>> circle = np.stack([3 * np.cos(angles), np.sin(3 * angles), 3 * np.sin(angles)], axis=1)
    >>> path = Path(circle, look_at=(0, 0, 0), closed=True, frames=500)
    >>> path.sample().positions.shape
    (500, 3)
    >>> path
    <vides.Path: 100 points, 500 frames, closed>

    What a ``.vid`` file says of the whole path is an attribute, by the key that it has there:
    ``fps``, ``title``, ``comment``, ``unit``, ``closed``, ``curve``, ``orientation_mode``,
    ``zoom_mode``, ``first_frame``, ``base_speeds``, ``presets``, ``limits``.

    >>> path.fps = 30
    >>> path.title = "Once around"
    >>> path.closed
    True
    """

    __slots__ = ("_native", "losses", "__weakref__")

    _native: _vides.Document
    losses: tuple[str, ...]
    """What was lost when it was read from another program's file."""

    def __init__(
        self,
        positions: npt.ArrayLike | None = None,
        *,
        look_at: Vector | None = None,
        up: Axis = "y",
        closed: bool = False,
        frames: int | None = None,
        zoom: float = 24.0,
        curve: Curve = "tcb",
        fps: float = 25.0,
    ) -> None:
        if positions is None:
            if (look_at, up, closed, frames, zoom, curve, fps) != (None, "y", False, None, 24.0, "tcb", 25.0):
                raise Error("positions are missing: the other arguments belong to them")
            native = _vides.Document()
        else:
            places = doubles(positions, (None, 3), "positions")
            if len(places) < 2:
                raise Error(f"a path leads through at least two points, not {len(places)}", "range")
            native = _vides.Document.through(
                places,
                None if look_at is None else vector(look_at, "look_at"),
                up,
                closed,
                frames,
                zoom,
                curve,
                fps,
            )
        self._set(native)

    def _set(self, native: _vides.Document, losses: Sequence[str] = ()) -> None:
        object.__setattr__(self, "_native", native)
        object.__setattr__(self, "losses", tuple(losses))

    @classmethod
    def _of(cls, native: _vides.Document, losses: Sequence[str] = ()) -> Path:
        path = cls.__new__(cls)
        path._set(native, losses)
        return path

    def _document(self) -> _vides.Document:
        return self._native

    def _prefix(self) -> str:
        return ""

    def _keys(self) -> list[str]:
        return sorted({name.split(".")[0] for name, _ in self._native.properties() if not name.startswith("point.")})

    # ---- Files --------------------------------------------------------------------------

    @classmethod
    def load(cls, file: str | os.PathLike[str], format: str | None = None, **options: object) -> Path:
        """The path in a ``.vid`` file, or in another program's file.

        Poses become a path of few points, within ``tolerance`` (a length, 1/1000 of the diagonal
        of their bounds unless given) and ``angle`` (degrees, 0.5). What was lost is in
        :attr:`losses`. Of other options see :func:`options`; of scenes :class:`Scene`.
        """
        name = path_of(file)
        if format in (None, "vid") and name.endswith(".vid") and not options:
            return cls._of(_vides.Document.load(name))
        given = {"as_": "path", **options}
        scene, losses = _vides.Scene.load(name, format, choices(given))
        return cls._of(scene.path(), losses)

    @classmethod
    def from_str(cls, text: str) -> Path:
        """The path in the text of a ``.vid`` file; :meth:`to_str` gives one.

        >>> path = Path()
        >>> Path.from_str(path.to_str()) == path
        True
        """
        return cls._of(_vides.Document.from_text(text))

    def save(self, file: str | os.PathLike[str], format: str | None = None, **options: object) -> list[str]:
        """Writes a ``.vid`` file, or another program's, as its name says or ``format``.

        The file is replaced only when the new one is whole. Returns what the format cannot hold, a
        sentence each; for options see :func:`options`.
        """
        name = path_of(file)
        if format in (None, "vid") and name.endswith(".vid") and not options:
            self._native.save(name)
            return []
        return self._native.scene().export(name, format, choices(options))

    def to_str(self) -> str:
        """The text of a ``.vid`` file."""
        return self._native.text()

    def copy(self) -> Path:
        """A path of its own, without the history."""
        return type(self)._of(self._native.copy(), self.losses)

    __copy__ = copy

    def __deepcopy__(self, memo: object) -> Path:
        return self.copy()

    def __reduce__(self) -> tuple[Any, tuple[str]]:
        return type(self).from_str, (self.to_str(),)

    def __eq__(self, other: object) -> bool:
        return self._native.same(other._native) if isinstance(other, Path) else NotImplemented

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        closed = ", closed" if self.closed else ""
        return f"<vides.Path: {len(self.points)} points, {self.frame_count} frames{closed}>"

    # ---- Points -------------------------------------------------------------------------

    @property
    def points(self) -> Points:
        """Its points."""
        return Points(self)

    @property
    def positions(self) -> Array:
        """(n, 3): a copy of the points' positions."""
        return self._native.positions()

    @property
    def up(self) -> str:
        """Which axis stands upright: ``"y"`` or ``"z"``; setting it keeps all poses."""
        return self._native.space()[2]

    @up.setter
    def up(self, up: Axis) -> None:
        self._native.edit("change_up", up=up)

    @property
    def space(self) -> tuple[Array, float]:
        """Centre (3,) and half the size of the movement space, a cube; see :meth:`set_space`."""
        centre, half_size, _ = self._native.space()
        return np.array(centre), half_size

    def set_space(self, centre: Vector, half_size: float, fit: bool = False) -> None:
        """Where the path lies in the world; with ``fit`` it is mapped into the new space."""
        self._native.set_space(vector(centre, "centre"), half_size, self.up, fit)

    def look_at(self, target: Vector) -> None:
        """Lets all orientations of all points look at a place.

        >>> path = Path()
        >>> path.look_at((0, 0, 0))
        >>> path.points[1].target
        [0.0, 0.0, 0.0]
        """
        for point in self.points:
            point.look_at(target)

    def divide(self, segment: int, points: int = 1) -> None:
        """New points on the curve between point ``segment`` and the next, 1 to 10 of them."""
        self._native.edit("divide", segment=segment, points=points)

    def insert_on_curve(self, frame: float) -> None:
        """A new point on the curve where the camera is at a frame; the flight stays as it is."""
        self._native.edit("insert_on_curve", frame=frame)

    def set_frames(self, frames: int, first: int = 0, last: int = -1) -> None:
        """Exactly so many poses from point ``first`` to point ``last``, both included.

        >>> path = Path()
        >>> path.set_frames(101)
        >>> path.frame_count
        101
        """
        count = len(self.points)
        self._native.edit(
            "fit_frames",
            first=_index(first, count, "point"),
            last=_index(last, count, "point"),
            frames=frames,
        )

    # ---- Poses --------------------------------------------------------------------------

    @property
    def frame_count(self) -> int:
        """How many poses there are; their frames are 1 to this number."""
        return self._native.frame_count()

    @property
    def duration(self) -> float:
        """Seconds from the first pose to the last.

        >>> Path().duration
        4.8
        """
        return (self.frame_count - 1) / float(self.fps)

    @property
    def length(self) -> float:
        """Length of the way, in the world's lengths."""
        return self._native.length()

    @property
    def sections(self) -> list[Section]:
        """The ways from each orientation to the next, in the order of the flight.

        >>> [(section.point, section.change, section.frames) for section in Path().sections]
        [(0, 'position', 120)]
        """
        return [Section(*row) for row in self._native.sections()]

    def sample(self, first: int = 1, last: int | None = None, out: Array | None = None) -> Samples:
        """The poses of the frames ``first`` to ``last``, both included; all unless given.

        ``out`` is an array of doubles (n, 10), row by row, that is filled in place of a new one;
        it needs as many rows as there are frames.

        >>> path = Path()
        >>> path.sample(11, 20)
        <vides.Samples: 10 poses, frames 11 to 20, 25 a second>
        """
        first = operator.index(first)
        last = self.frame_count if last is None else operator.index(last)
        count = last + 1 - first
        if first < 1 or count < 0:
            raise Error(f"frames {first} to {last} are wanted: the first is 1, and no later than the last", "range")
        if out is None:
            if last > self.frame_count:
                raise Error(f"there is no frame {last}: the frames are 1 to {self.frame_count}", "range")
            out = np.empty((count, 10))
        elif not isinstance(out, np.ndarray) or out.dtype != np.float64 or out.shape != (count, 10):
            what = f"{out.dtype} {out.shape}" if isinstance(out, np.ndarray) else type(out).__name__
            raise Error(f"out must be an array of float64 of the shape ({count}, 10), not {what}")
        elif not (out.flags.c_contiguous and out.flags.writeable):
            raise Error("out must be writeable and lie row by row without gaps (order C)")
        self._native.sample(first, out)
        return Samples(out, float(self.fps), np.arange(first, last + 1.0))

    def evaluate(self, frames: npt.ArrayLike) -> Samples:
        """The poses at any frames, whole or between two, in any order.

        >>> path = Path()
        >>> path.evaluate(1.5).positions.shape
        (1, 3)
        >>> path.evaluate([1, 30.25, 121]).frames
        array([  1.  ,  30.25, 121.  ])
        """
        wanted = doubles(np.atleast_1d(np.asarray(frames)), (None,), "frames")
        return Samples(self._native.poses(wanted), float(self.fps), wanted)

    def motion(self, frames: npt.ArrayLike) -> Array:
        """(n, 4), how the camera moves at frames, whole or between two.

        Length of the way so far; way per frame; degrees per frame by which the camera turns;
        curvature (one by the radius) of the way.

        >>> Path().motion([1, 121])[:, 0].round(6)
        array([0. , 1.2])
        """
        wanted = doubles(np.atleast_1d(np.asarray(frames)), (None,), "frames")
        return self._native.motion(wanted)

    # ---- Tools --------------------------------------------------------------------------

    def check(self) -> list[Finding]:
        """What will look wrong in the film: jerks, fast turns, what comes too near, and so on.

        >>> Path().check()
        []
        """
        return [Finding(*row) for row in self._native.check()[0]]

    def notes(self) -> list[str]:
        """What is to be told beside :meth:`check`: what was not looked at."""
        return self._native.check()[1]

    def fix(self) -> list[Finding]:
        """Mends what :meth:`check` finds, as far as that helps. Returns what was mended."""
        return [Finding(*row) for row in self._native.fix()]

    def tool(self, name: str, path: Path | None = None, **numbers: float | str | Sequence[float]) -> None:
        """Does what the tool of this name does, as one step; :func:`tools` lists them.

        Parameters that are not given are as the window suggests them. Points that a tool takes by
        ``first`` and ``last`` are counted from 1, as in the window.

        >>> path = Path()
        >>> path.tool("turn", axis="y", angle=90)
        >>> path.tool("repeat", times=2)
        >>> len(path.points)
        3
        """
        self._native.tool(name, dict(numbers), None if path is None else path._native)

    def reverse(self) -> None:
        """Flies it backwards."""
        self._native.edit("reverse")

    def undo(self) -> bool:
        """Takes back the last change; false if there is none."""
        return self._native.undo()

    def redo(self) -> bool:
        """Does again what was taken back; false if there is nothing."""
        return self._native.redo()

    @classmethod
    def fit(
        cls,
        poses: Samples | npt.ArrayLike,
        seconds: npt.ArrayLike | None = None,
        *,
        fps: float | None = None,
        tolerance: float | None = None,
        angle: float = 0.5,
        up: Axis = "y",
        robust: bool = False,
    ) -> Path:
        """A path of few points near recorded poses.

        ``poses`` are samples or an array (n, 10); ``seconds`` (n,) rise, and are those of the
        samples unless given. The path stays within ``tolerance`` of the positions (a length; 1/1000
        of the diagonal of their bounds unless given), and within ``angle`` degrees of view, up and
        field of view. ``robust`` leaves out poses that do not fit those around them.

        >>> path = Path()
        >>> path.points.insert(1, (0, 0.6, 0.4))
        <vides.Point 1 at (0, 0.6, 0.4)>
        >>> recorded = path.sample()
        >>> fitted = Path.fit(recorded, tolerance=0.001)
        >>> bool(abs(fitted.sample().positions - recorded.positions).max() < 0.0011)
        True
        """
        if isinstance(poses, Samples):
            array = doubles(poses.array, (None, 10), "poses")
            seconds = poses.seconds if seconds is None else seconds
            fps = poses.fps if fps is None else fps
        else:
            array = doubles(poses, (None, 10), "poses")
        times = None if seconds is None else doubles(seconds, (len(array),), "seconds")
        if len(array) < 2:
            raise Error(f"at least two poses are wanted, not {len(array)}", "range")
        if tolerance is None:
            tolerance = 1e-3 * float(np.linalg.norm(np.ptp(array[:, :3], axis=0)))
        rate = 25.0 if fps is None else float(fps)
        native, left_out = _vides.fit(array, times, rate, tolerance, angle, up, robust)
        losses = [f"pose {at} is left out" for at in left_out]
        return cls._of(native, losses)

    # ---- The object ---------------------------------------------------------------------

    def set_object(self, file: str | os.PathLike[str] | None) -> None:
        """Shows a mesh (OBJ, PLY, STL, glTF) with the path, and checks against it; none: nothing."""
        self._native.set_object(None if file is None else path_of(file))

    @property
    def object_points(self) -> Array:
        """(n, 3): the points of the object that is shown with the path; a copy."""
        return self._native.object_points()

    # ---- Pictures -----------------------------------------------------------------------

    def plot(self, dark: bool = False) -> SVG:
        """The way from three sides, the views on a sphere, and charts over the frames: an SVG.

        A notebook shows it; it is the picture of ``vides plot``.

        >>> Path().plot()[:4]
        '<svg'
        """
        return SVG(self._native.svg(dark))

    def to_html(self, **options: object) -> str:
        """A page that plays the flight in a browser, without a network; see :func:`options`."""
        page, _ = self._native.scene().render("html", choices(options))
        return bytes(page).decode()

    def _repr_html_(self) -> str:
        """The page in a frame that may run its own scripts and reach nothing else."""
        page = html.escape(self.to_html(), quote=True)
        return (
            f'<iframe srcdoc="{page}" sandbox="allow-scripts" title="VIDES" '
            'style="width:100%;height:480px;border:0"></iframe>'
        )

    def _repr_svg_(self) -> str:
        return str(self.plot())

