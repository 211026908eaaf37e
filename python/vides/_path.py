"""A camera path."""

from __future__ import annotations

import html
import operator
import os
import pathlib
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, ClassVar, Literal

import numpy as np
import numpy.typing as npt

from . import _vides
from ._arrays import Array, axis, count, doubles, each, number, places, str_of, str_or_none, vector
from ._error import Invalid
from ._files import choices, path_of
from ._objects import Object, given
from ._points import Section
from ._rendered import Plotter, render
from ._samples import Samples
from ._shaped import Axis, Shaped
from ._told import SVG, Finding, FitReport

if TYPE_CHECKING:
    from typing_extensions import Self

Curve = Literal["tcb", "centripetal", "chordal", "cubic", "linear"]


class Path(Shaped):
    """A camera path: points in space, each with one or more camera orientations.

    Without arguments it is the path of a new window, with two points. Points and orientations count
    from 0, frames from 1.

    ``positions``, shape (n, 3) with n ≥ 2, are the points, in the world's lengths. The cameras look
    at ``look_at``, one place (3,) or one a point (n, 3), by default along −z, or −x if ``up`` is z.
    ``frames`` is the number of poses, ``n * fps`` for a film of n seconds; by default it follows
    from the base speeds. Instead, ``times`` (n,) are the seconds at which the camera reaches the
    points. ``zoom`` is a focal length in mm (24: a vertical field of view of 53°) and ``roll`` an
    angle in degrees, for all points or one a point (n,). ``curve`` is ``"tcb"``
    (Kochanek–Bartels), ``"centripetal"`` or ``"chordal"`` (the same, without loops where points are
    close together), ``"cubic"`` (a spline with continuous second derivatives) or ``"linear"``.

    >>> angles = np.linspace(0, 2 * np.pi, 100, endpoint=False)
    >>> circle = np.stack([3 * np.cos(angles), np.sin(3 * angles), 3 * np.sin(angles)], axis=1)
    >>> path = Path(circle, look_at=(0, 0, 0), closed=True, frames=500)
    >>> path.sample().positions.shape
    (500, 3)
    >>> path
    <vides.Path: 100 points, 500 frames, closed>

    Orbit an object, a mesh of trimesh or pyvista, a file, or vertices and triangles:

    >>> mesh = [[-1, 0, 0], [1, 0, 0], [0, 2, 0], [0, 0, 1]], [[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]]
    >>> orbit = Path.orbit(object=mesh, turns=2, seconds=20, fps=30)
    >>> orbit.zooms = 35
    >>> orbit.frame_count, [finding.text for finding in orbit.check()]
    (600, [])

    Clean a recording, here one that shakes: fit a path to its poses, then stabilise it.

    >>> t = np.arange(200)
    >>> poses = np.tile([0, 0, 0, 0, 0, -1, 0, 1, 0, 24.0], (200, 1))
    >>> poses[:, 0], poses[:, 1] = t / 50, 0.01 * np.sin(2 * t)
    >>> recorded = Path.fit(Samples(poses, fps=25), tolerance=0.005)
    >>> moved = recorded.steady(period=1, within=0.05)
    >>> clean = recorded.sample().positions
    >>> bool(abs(clean[25:-25, 1]).max() < 0.003), bool(moved.furthest <= 0.05)
    (True, True)

    Cameras for Gaussian splats: views that show an object, as OpenCV's matrices or a file.

    >>> views = tour(mesh, stills=True).path.sample()
    >>> world_to_camera = views.world_to_camera("opencv")
    >>> K = views.intrinsics(1920, 1080)
    >>> world_to_camera.shape[1:], K.shape[1:]
    ((4, 4), (3, 3))
    >>> losses = views.save("transforms.json", "nerfstudio", size=(1920, 1080))

    Properties of the whole path are attributes, with the names of the keys in ``.vid`` files:
    ``fps``, ``title``, ``comment``, ``closed``, ``curve``, ``orientation_mode``,
    ``zoom_mode``, ``first_frame``, ``base_speeds``, ``presets``. Setting ``fps`` keeps the number
    of frames, so the film gets faster or slower; :meth:`set_frames` sets the number of frames.

    >>> path.fps = 30
    >>> path.title = "Once around"
    >>> path.closed
    True
    >>> path.base_speeds["move_frames"]
    100.0
    >>> path.base_speeds = {"move_frames": 250}

    The speed of the camera is a property of the section that begins at a point: its ``frames``,
    and ``speed_curve``, ten speeds from its start to its end, or ``ease``. To slow down towards the
    third point:

    >>> path = Path([[0, 0, 0], [1, 0, 0], [2, 0, 0], [3, 0, 0]], frames=301)
    >>> path.points[1].speed_curve = [50, 50, 50, 45, 40, 35, 30, 25, 20, 15]
    >>> steps = path.motion([110, 190])[:, 1]  # way per frame
    >>> bool(steps[1] < steps[0] / 2)
    True
    """

    __slots__ = ("_native", "fit_report", "losses", "__weakref__")

    _native: _vides.Document
    losses: tuple[str, ...]
    """What could not be imported from another program's file."""
    fit_report: FitReport | None
    """How well the path follows the poses of :meth:`fit`; ``None`` for other paths."""

    def __init__(
        self,
        positions: npt.ArrayLike | None = None,
        *,
        look_at: npt.ArrayLike | None = None,
        up: Axis = "y",
        closed: bool = False,
        frames: int | None = None,
        times: npt.ArrayLike | None = None,
        zoom: npt.ArrayLike = 24.0,
        roll: npt.ArrayLike = 0.0,
        curve: Curve = "tcb",
        fps: float = 25.0,
    ) -> None:
        if positions is None:
            others = (look_at, up, closed, frames, times, zoom, roll, curve, fps)
            usual = (None, "y", False, None, None, 24.0, 0.0, "tcb", 25.0)
            if any(one is not other and (isinstance(one, np.ndarray) or one != other) for one, other in zip(others, usual)):
                raise Invalid("positions are missing: the other arguments require them")
            self._set(_vides.Document())
            return
        points = doubles(positions, (None, 3), "positions")
        if len(points) < 2:
            raise Invalid(f"a path needs at least two points, not {len(points)}", "range")
        if frames is not None and times is not None:
            raise TypeError("Path() takes either frames or times")
        zooms = each(zoom, len(points), "zoom")
        targets = None if look_at is None else places(look_at, len(points), "look_at")
        native = _vides.Document.through(
            points,
            None if targets is None else vector(targets[0], "look_at"),
            axis(up),
            bool(closed),
            None if frames is None else count(frames, "frames"),
            float(zooms[0]),
            str_of(curve, "curve"),
            number(fps, "fps"),
        )
        if targets is not None and len(targets) > 1:
            _vides.look_at(native, targets, None)
        if (zooms != zooms[0]).any():
            _vides.set_numbers(native, "zoom", zooms)
        rolls = each(roll, len(points), "roll")
        if rolls.any():
            _vides.set_numbers(native, "roll", rolls)
        if times is not None:
            _vides.set_times(native, doubles(times, (len(points),), "times"))
        self._set(native.copy())

    def _set(self, native: _vides.Document, losses: Sequence[str] = ()) -> None:
        object.__setattr__(self, "_native", native)
        object.__setattr__(self, "losses", tuple(losses))
        object.__setattr__(self, "fit_report", None)

    @classmethod
    def _of(cls, native: _vides.Document, losses: Sequence[str] = ()) -> Self:
        path = cls.__new__(cls)
        path._set(native, losses)
        return path

    def _document(self) -> _vides.Document:
        return self._native

    def _prefix(self) -> str:
        return ""

    # ---- Files --------------------------------------------------------------------------

    @classmethod
    def load(cls, file: str | os.PathLike[str], format: str | None = None, **options: object) -> Self:
        """The path in a ``.vid`` file or in another program's file.

        Poses are fitted by a path of few points, within ``tolerance`` (a length; by default 1/1000
        of the diagonal of their bounds) and ``angle`` (degrees, 0.5). :attr:`losses` lists what
        could not be imported. :func:`options` lists the other options; :class:`Scene` loads scenes.
        """
        name = path_of(file)
        if format in (None, "vid") and name.endswith(".vid") and not options:
            return cls._of(_vides.Document.load(name))
        given = {"as_": "path", **options}
        scene, losses = _vides.Scene.load(name, str_or_none(format, "format"), choices(given))
        return cls._of(scene.path(), losses)

    @classmethod
    def from_str(cls, text: str) -> Self:
        """The path in the text of a ``.vid`` file, as :meth:`to_str` returns it.

        >>> path = Path()
        >>> Path.from_str(path.to_str()) == path
        True
        """
        return cls._of(_vides.Document.from_text(str_of(text, "text")))

    def save(self, file: str | os.PathLike[str], format: str | None = None, **options: object) -> list[str]:
        """Writes a ``.vid`` file or another program's, by ``format`` or by the file's name.

        The file is replaced only when everything is written. Returns what the format cannot hold, a
        sentence each; :func:`options` lists the options. ``format="colmap"`` writes several files
        into a folder.

        The world's axes are unchanged, except for formats that prescribe an up axis: z in
        ``transforms.json`` (``nerfstudio``, ``transforms``). A path with y up is rotated for them by
        90° about x: (x, y, z) becomes (x, −z, y). Reading the file does not rotate it back.

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
        return self._native.scene().export(name, str_or_none(format, "format"), choices(options))

    def to_str(self) -> str:
        """The text of a ``.vid`` file."""
        return self._native.text()

    def copy(self) -> Self:
        """An independent copy, without the undo history."""
        twin = type(self)._of(self._native.copy(), self.losses)
        twin.fit_report = self.fit_report
        return twin

    __copy__ = copy

    def __deepcopy__(self, memo: object) -> Self:
        return self.copy()

    def __reduce__(self) -> tuple[Any, tuple[str], dict[str, Any]]:
        return type(self).from_str, (self.to_str(),), {"losses": self.losses, "fit_report": self.fit_report}

    def __setstate__(self, state: dict[str, Any]) -> None:
        for name, value in state.items():
            object.__setattr__(self, name, value)

    def __getitem__(self, part: slice) -> Self:
        """A part of the path, a path of its own: ``path[2:5]`` has the points 2, 3 and 4.

        >>> path = Path([[0, 0, 0], [1, 0, 0], [2, 1, 0], [3, 1, 0]], frames=301)
        >>> path[1:3].positions
        array([[1., 0., 0.],
               [2., 1., 0.]])
        """
        if not isinstance(part, slice):
            raise TypeError(f"a part of a path is a slice, path[2:5]; path.points[{part!r}] is a point")
        first, end, step = part.indices(len(self.points))
        if step != 1:
            raise Invalid(f"a part of a path has all its points: the step must be 1, not {step}")
        if end - first < 2:
            raise Invalid(f"a path needs at least two points: from {first} to before {end} it has too few", "range")
        return type(self)._of(_vides.extract(self._native, first, end - 1))

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Path):
            return NotImplemented
        return other is self or self._native.same(other._native)

    __hash__: ClassVar[None] = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        closed = ", closed" if self.closed else ""
        return f"<vides.Path: {len(self.points)} points, {self.frame_count} frames{closed}>"

    # ---- Poses --------------------------------------------------------------------------

    @property
    def frame_count(self) -> int:
        """The number of poses; their frames are 1 to this number."""
        return self._native.frame_count()

    @property
    def duration(self) -> float:
        """Seconds of the film: 300 frames at 30 fps are 10 s. The last frame begins one frame earlier.

        >>> Path().duration
        4.84
        """
        return self.frame_count / float(self.fps)

    @property
    def length(self) -> float:
        """Length of the path, in the world's lengths."""
        return self._native.length()

    @property
    def sections(self) -> list[Section]:
        """The sections from each orientation to the next, in the order of the flight.

        >>> [(section.point, section.change, section.frames) for section in Path().sections]
        [(0, 'position', 120)]
        """
        rows = enumerate(self._native.sections())
        return [Section(self, at, row) for at, row in rows]

    def sample(self, first: int = 1, last: int | None = None, out: Array | None = None) -> Samples:
        """The poses of the frames ``first`` to ``last``, both included; by default all.

        ``out`` is an array of doubles (n, 10), row by row, to fill instead of a new one; it has one
        row for each frame.

        >>> path = Path()
        >>> path.sample(11, 20)
        <vides.Samples: 10 poses, frames 11 to 20, 25 a second>
        """
        first = operator.index(first)
        last = self.frame_count if last is None else operator.index(last)
        rows = last + 1 - first
        if first < 1 or rows < 0:
            raise Invalid(f"frames {first} to {last}: the first must be at least 1 and at most the last", "range")
        if out is None:
            if last > self.frame_count:
                raise Invalid(f"there is no frame {last}: the frames are 1 to {self.frame_count}", "range")
            out = np.empty((rows, 10))
        elif not isinstance(out, np.ndarray) or out.dtype != np.float64 or out.shape != (rows, 10):
            what = f"{out.dtype} {out.shape}" if isinstance(out, np.ndarray) else type(out).__name__
            raise Invalid(f"out must be an array of float64 of the shape ({rows}, 10), not {what}")
        elif not (out.flags.c_contiguous and out.flags.writeable):
            raise Invalid("out must be writeable and contiguous row by row (order C)")
        self._native.sample(first, out)
        return Samples._of(out, float(self.fps), np.arange(first, last + 1.0), self.up)

    def evaluate(
        self, frames: npt.ArrayLike | None = None, *, seconds: npt.ArrayLike | None = None
    ) -> Samples:
        """The poses at any frames or seconds, in any order; frames may be fractional.

        Frame 1 begins at second 0, and the last frame ends at :attr:`duration`.

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
            last = self.frame_count
            # A little more than a frame, because of rounding in seconds.
            wanted[(wanted > last) & (wanted <= last + 1.0 + 1e-9 * last)] = last
        elif frames is not None and seconds is None:
            wanted = doubles(np.atleast_1d(frames), (None,), "frames")
        else:
            raise TypeError("evaluate() takes either frames or seconds")
        return Samples._of(self._native.poses(wanted), float(self.fps), wanted, self.up)

    def motion(self, frames: npt.ArrayLike) -> Array:
        """(n, 4): how the camera moves at frames, which may be fractional.

        The columns are the distance travelled; the distance per frame; the turning in degrees per
        frame; and the curvature (1/radius) of the path.

        >>> Path().motion([1, 121])[:, 0].round(6)
        array([0. , 1.2])
        """
        wanted = doubles(np.atleast_1d(frames), (None,), "frames")
        return self._native.motion(wanted)

    # ---- Tools --------------------------------------------------------------------------

    def check(self) -> list[Finding]:
        """Finds what will look wrong in the film: jerks, flips, collisions.

        Points count from 0, also in the sentences.

        >>> Path().check()
        []
        """
        return [Finding(*row) for row in self._native.check()[0]]

    def notes(self) -> list[str]:
        """Notes of :meth:`check`: what it does not check."""
        return self._native.check()[1]

    def fix(self) -> list[Finding]:
        """Fixes what :meth:`check` finds, as far as possible. Returns what was fixed."""
        return [Finding(*row) for row in self._native.fix()]

    @property
    def limits(self) -> dict[str, float]:
        """The limits of :meth:`check` by name, a copy; ``math.inf`` switches a kind off.

        :meth:`set_limits` sets them; the file keeps them. Units are the world's lengths, degrees,
        seconds and mm.

        >>> Path().limits["turning"]
        60.0
        """
        return dict(self._native.limits())

    def set_limits(self, **limits: float | None) -> None:
        """Sets limits of :meth:`check` and of planning, as one undo step.

        ``math.inf`` removes a limit, ``None`` restores the default.

        >>> path = Path()
        >>> path.set_limits(turning=20, speed=0.5)
        >>> path.limits["turning"], path.limits["speed"]
        (20.0, 0.5)
        """
        self._native.set_limits(
            [(name, None if limit is None else number(limit, name)) for name, limit in limits.items()]
        )

    def undo(self) -> bool:
        """Undoes the last change; false if there was none."""
        return self._native.undo()

    def redo(self) -> bool:
        """Restores the last change that was undone; false if there was none."""
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
        points: int | None = None,
    ) -> Self:
        """Fits a path of few points to recorded poses.

        ``poses`` are samples or an array (n, 10). ``seconds`` (n,) increase; the default is those of
        the samples. The path stays within ``tolerance`` of the positions (a length; by default
        1/1000 of the diagonal of their bounds), and within ``angle`` degrees of view, up and field
        of view. ``robust`` ignores outliers. With ``points``, the path has at most so many, within the
        least multiple of ``tolerance`` and ``angle`` that allows it. :attr:`fit_report` tells how
        well it follows. ``up`` is the up axis of the world; the default is that
        of the samples, or ``"y"``.

        >>> path = Path()
        >>> path.points.insert(1, (0, 0.6, 0.4))
        <vides.Point 1 at (0, 0.6, 0.4)>
        >>> recorded = path.sample()
        >>> fitted = Path.fit(recorded, tolerance=0.001)
        >>> bool(abs(fitted.sample().positions - recorded.positions).max() < 0.0011)
        True
        >>> Path.fit(recorded, points=4).fit_report.points
        4
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
            raise Invalid(f"at least two poses are required, not {len(array)}", "range")
        rate = 25.0 if fps is None else number(fps, "fps")
        upright = (known or "y") if up is None else axis(up)
        near = None if tolerance is None else number(tolerance, "tolerance")
        turned = number(angle, "angle")
        most = None if points is None else count(points, "points")
        native, left_out, told = _vides.fit(
            array, times, rate, near, turned, upright, bool(robust), most
        )
        path = cls._of(native, [f"pose {at} is left out" for at in left_out])
        (made, given), (position, view, field), noise, found, better, fewer, text = told
        holds, gaps, cuts, repeated = found
        report = FitReport(
            made, given, position, view, field, noise, holds, gaps, cuts, repeated,
            tuple(left_out), better, fewer, text,
        )  # fmt: skip
        path.fit_report = report
        return path

    # ---- The object ---------------------------------------------------------------------

    def set_object(self, object: Object | None) -> None:
        """Sets the object for display and checks; ``None`` removes it.

        It is a file (OBJ, PLY, STL, glTF), a mesh of trimesh or pyvista, or vertices (n, 3) and
        triangles (m, 3).
        """
        self._native.set_object(None if object is None else given(object))

    @property
    def object_points(self) -> Array:
        """(n, 3): the points of the path's object; a copy."""
        return self._native.object_points()

    # ---- Pictures -----------------------------------------------------------------------

    def plot(self, dark: bool = False) -> SVG:
        """An SVG with the path from three sides, the views on a sphere, and charts over the frames.

        Notebooks display it; ``pathlib.Path("plot.svg").write_text(path.plot())`` saves it. It is
        the picture of ``vides plot``, in which points count from 1.

        >>> Path().plot()[:4]
        '<svg'
        """
        return SVG(self._native.svg(bool(dark)))

    def render(
        self, plotter: Plotter, folder: str | os.PathLike[str], *, progress: bool = True
    ) -> list[pathlib.Path]:
        """Renders each frame with a ``pyvista.Plotter`` into ``folder``: ``00001.png`` and so on.

        Returns the files. A bar on standard error shows the progress. A film of them, with imageio::

            import imageio.v3 as imageio
            files = path.render(plotter, "frames")
            imageio.imwrite("flight.mp4", [imageio.imread(file) for file in files], fps=path.fps)
        """
        return render(self.sample(), plotter, pathlib.Path(path_of(folder)), bool(progress))

    def to_html(self, **options: object) -> str:
        """A page that plays the flight in a browser, offline; see :func:`options`."""
        page, _ = self._native.scene().render("html", choices(options))
        return bytes(page).decode()

    def _repr_html_(self) -> str:
        """The page in a sandboxed frame that can run only its own scripts."""
        page = html.escape(self.to_html(), quote=True)
        return (
            f'<iframe srcdoc="{page}" sandbox="allow-scripts" title="VIDES" '
            'style="width:100%;height:480px;border:0"></iframe>'
        )

    def _repr_svg_(self) -> str:
        return str(self.plot())

