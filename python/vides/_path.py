"""A camera path."""

from __future__ import annotations

import html
import operator
import os
from collections.abc import Sequence
from typing import Any, ClassVar, Literal

import numpy as np
import numpy.typing as npt

from . import _vides
from ._arrays import Array, Vector, count, doubles, frozen, number, vector
from ._error import Error
from ._files import choices, path_of
from ._planned import Planned
from ._points import Points, Section, bare_keys, index_of
from ._samples import Samples
from ._told import SVG, Finding

Curve = Literal["tcb", "cubic", "linear"]
Axis = Literal["y", "z"]


class Path(Planned):
    """A camera path: points in space, each with one or more camera orientations.

    Without arguments it is the path with which a new window begins, of two points. Points and
    orientations count from 0, frames from 1, as they do in the window and in C.

    ``positions``, shape (n, 3) with n ≥ 2, are the points, in the world's lengths. Every camera
    looks at ``look_at`` (3,); without it along −z, or −x where z is ``up``. ``frames`` is how many
    poses there are in all; without it the base speeds say. The first is shown at second 0, so n
    seconds from the first to the last take ``frames=n * fps + 1``. ``zoom`` is a focal length in mm (24: a
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
    ``fps``, ``title``, ``comment``, ``closed``, ``curve``, ``orientation_mode``,
    ``zoom_mode``, ``first_frame``, ``base_speeds``, ``presets``. A path has its frames: another
    ``fps`` shows them faster or slower, :meth:`set_frames` brings it to a length.

    >>> path.fps = 30
    >>> path.title = "Once around"
    >>> path.closed
    True
    >>> path.base_speeds["move_frames"]
    100.0
    >>> path.base_speeds = {"move_frames": 250}

    How fast the camera goes is said of the section that begins at a point: its ``frames``, and of
    those ``speed_curve``, ten speeds from its start to its end, or ``ease``. Slowing down to the
    third point:

    >>> path = Path([[0, 0, 0], [1, 0, 0], [2, 0, 0], [3, 0, 0]], frames=301)
    >>> path.points[1].speed_curve = [50, 50, 50, 45, 40, 35, 30, 25, 20, 15]
    >>> steps = path.motion([110, 190])[:, 1]  # way per frame
    >>> bool(steps[1] < steps[0] / 2)
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
            others = (up, closed, frames, zoom, curve, fps)
            if look_at is not None or others != ("y", False, None, 24.0, "tcb", 25.0):
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
                None if frames is None else count(frames, "frames"),
                number(zoom, "zoom"),
                curve,
                number(fps, "fps"),
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

    def __getattr__(self, name: str) -> Any:
        value = super().__getattr__(name)
        if value is None:
            # One with parts, as base_speeds and presets have.
            parts = [key for key, _ in self._native.properties() if key.startswith(f"{name}.")]
            if parts:
                return {key[len(name) + 1 :]: self._native.property(key) for key in parts}
        return value

    def _keys(self) -> list[str]:
        return bare_keys("path")

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
        sentence each; for options see :func:`options`. Several files of ``format="colmap"`` are
        written into a folder.

        The world's axes stay as they are, but for formats that have an upright axis of their own:
        z in ``transforms.json`` (``nerfstudio``, ``transforms``). A path with y upright is turned
        for them by 90° about x: (x, y, z) becomes (x, −z, y), and is so when it is read again.

        >>> import os, tempfile
        >>> with tempfile.TemporaryDirectory() as folder:
        ...     file = os.path.join(folder, "transforms.json")
        ...     _ = Path().save(file, "nerfstudio")
        ...     samples = Samples.load(file)
        >>> samples.world_up, samples.positions[0].round(6)
        ('z', array([-0.6, -0.8,  0.2]))
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
        if not isinstance(other, Path):
            return NotImplemented
        return other is self or self._native.same(other._native)

    __hash__: ClassVar[None] = None  # type: ignore[assignment]

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
        """(n, 3): where the points lie; a copy that is read only. Assigning one moves all points.

        >>> path = Path()
        >>> path.positions = path.positions * 2
        >>> path.positions[0]
        array([-1.2,  0.4,  1.6])
        """
        return frozen(self._native.positions())

    @positions.setter
    def positions(self, positions: npt.ArrayLike) -> None:
        self._native.set_positions(doubles(positions, (None, 3), "positions"))

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
        (0.0, 0.0, 0.0)
        """
        for point in self.points:
            point.look_at(target)

    def divide(self, segment: int, points: int = 1) -> None:
        """New points on the curve between point ``segment`` and the next, 1 to 10 of them."""
        self._native.edit(
            "divide", segment=count(segment, "segment"), points=count(points, "points")
        )

    def insert_on_curve(self, frame: float) -> None:
        """A new point on the curve where the camera is at a frame; the flight stays as it is."""
        self._native.edit("insert_on_curve", frame=number(frame, "frame"))

    def set_frames(self, frames: int, first: int = 0, last: int = -1) -> None:
        """Exactly so many poses from point ``first`` to point ``last``, both included.

        >>> path = Path()
        >>> path.set_frames(101)
        >>> path.frame_count
        101
        """
        points = len(self.points)
        self._native.edit(
            "fit_frames",
            first=index_of(first, points, "point"),
            last=index_of(last, points, "point"),
            frames=count(frames, "frames"),
        )

    # ---- Poses --------------------------------------------------------------------------

    @property
    def frame_count(self) -> int:
        """How many poses there are; their frames are 1 to this number."""
        return self._native.frame_count()

    @property
    def duration(self) -> float:
        """Seconds from the first pose to the last: 300 frames at 30 a second are 9.967 s.

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
        rows = enumerate(self._native.sections())
        return [Section(self, at, row) for at, row in rows]

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
        rows = last + 1 - first
        if first < 1 or rows < 0:
            raise Error(f"frames {first} to {last} are wanted: the first is 1, and no later than the last", "range")
        if out is None:
            if last > self.frame_count:
                raise Error(f"there is no frame {last}: the frames are 1 to {self.frame_count}", "range")
            out = np.empty((rows, 10))
        elif not isinstance(out, np.ndarray) or out.dtype != np.float64 or out.shape != (rows, 10):
            what = f"{out.dtype} {out.shape}" if isinstance(out, np.ndarray) else type(out).__name__
            raise Error(f"out must be an array of float64 of the shape ({rows}, 10), not {what}")
        elif not (out.flags.c_contiguous and out.flags.writeable):
            raise Error("out must be writeable and lie row by row without gaps (order C)")
        self._native.sample(first, out)
        return Samples._of(out, float(self.fps), np.arange(first, last + 1.0), self.up)

    def evaluate(
        self, frames: npt.ArrayLike | None = None, *, seconds: npt.ArrayLike | None = None
    ) -> Samples:
        """The poses at any frames or seconds, whole or between two, in any order.

        Frame 1 is shown at second 0.

        >>> path = Path()
        >>> path.evaluate(1.5).positions.shape
        (1, 3)
        >>> path.evaluate([1, 30.25, 121]).frames
        array([  1.  ,  30.25, 121.  ])
        >>> path.evaluate(seconds=0.5).frames
        array([13.5])
        """
        if seconds is not None and frames is None:
            wanted = doubles(np.atleast_1d(seconds), (None,), "seconds") * self.fps + 1.0
        elif frames is not None and seconds is None:
            wanted = doubles(np.atleast_1d(frames), (None,), "frames")
        else:
            raise TypeError("evaluate() takes either frames or seconds")
        return Samples._of(self._native.poses(wanted), float(self.fps), wanted, self.up)

    def motion(self, frames: npt.ArrayLike) -> Array:
        """(n, 4), how the camera moves at frames, whole or between two.

        Length of the way so far; way per frame; degrees per frame by which the camera turns;
        curvature (one by the radius) of the way.

        >>> Path().motion([1, 121])[:, 0].round(6)
        array([0. , 1.2])
        """
        wanted = doubles(np.atleast_1d(frames), (None,), "frames")
        return self._native.motion(wanted)

    # ---- Tools --------------------------------------------------------------------------

    def check(self) -> list[Finding]:
        """What will look wrong in the film: jerks, fast turns, what comes too near, and so on.

        Points count from 0, in the sentences too.

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

    @property
    def limits(self) -> dict[str, float]:
        """Beyond which :meth:`check` finds something, by name; ``math.inf``: it is not looked for.

        A copy; :meth:`set_limits` sets them. They are kept in the file. Lengths are half sizes of
        the space, angles degrees, times seconds, and zooms mm.

        >>> Path().limits["turning"]
        60.0
        """
        return dict(self._native.limits())

    def set_limits(self, **limits: float | None) -> None:
        """Sets limits of :meth:`check`, within which what is planned stays, too; as one step.

        ``math.inf``: there is none. ``None``: that of a new path.

        >>> path = Path()
        >>> path.set_limits(turning=20, speed=0.5)
        >>> path.limits["turning"], path.limits["speed"]
        (20.0, 0.5)
        """
        self._native.set_limits(
            [(name, None if limit is None else number(limit, name)) for name, limit in limits.items()]
        )

    def tool(self, name: str, path: Path | None = None, **numbers: float | str | Sequence[float]) -> None:
        """Does what the tool of this name does, as one step; :func:`tools` lists them.

        Parameters that are not given are as the window suggests them. Points that a tool takes by
        ``first`` and ``last`` are counted from 1, as in the window.

        >>> path = Path()
        >>> path.tool("turn", axis="y", angle=90)
        >>> path.tool("repeat", times=2)
        >>> Path().tool("orbit", from_=90, seconds=8)
        >>> len(path.points)
        3
        """
        given = {key.rstrip("_"): number for key, number in numbers.items()}
        self._native.tool(name, given, None if path is None else path._native)

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
        up: Axis | None = None,
        robust: bool = False,
    ) -> Path:
        """A path of few points near recorded poses.

        ``poses`` are samples or an array (n, 10); ``seconds`` (n,) rise, and are those of the
        samples unless given. The path stays within ``tolerance`` of the positions (a length; 1/1000
        of the diagonal of their bounds unless given), and within ``angle`` degrees of view, up and
        field of view. ``robust`` leaves out poses that do not fit those around them. ``up`` is the
        axis of the world that stands upright: that of the samples unless given, else ``"y"``.

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
            known = poses.world_up
        else:
            array = doubles(poses, (None, 10), "poses")
            known = None
        times = None if seconds is None else doubles(seconds, (len(array),), "seconds")
        if len(array) < 2:
            raise Error(f"at least two poses are wanted, not {len(array)}", "range")
        if tolerance is None:
            tolerance = 1e-3 * float(np.linalg.norm(np.ptp(array[:, :3], axis=0)))
        rate = 25.0 if fps is None else float(fps)
        native, left_out = _vides.fit(array, times, rate, tolerance, angle, up or known or "y", robust)
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

        A notebook shows it; ``pathlib.Path("plot.svg").write_text(path.plot())`` keeps it. It is
        the picture of ``vides plot``, in which points count from 1.

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

