"""Poses of a camera, one a row."""

from __future__ import annotations

import operator
import os
from collections.abc import Iterator
from typing import Any, ClassVar, Literal, overload

import numpy as np
import numpy.typing as npt

from . import _vides
from ._arrays import Array, doubles, str_or_none
from ._error import Error
from ._files import choices, path_of

Convention = Literal["opengl", "opencv", "ros", "vides"]
"""The meaning of a camera's axes; see :meth:`Samples.matrices`."""

# For x, y, z of the convention: the column of VIDES' camera (left, up, forward), and its sign.
_AXES: dict[str, tuple[tuple[int, int, int], tuple[int, int, int]]] = {
    "vides": ((0, 1, 2), (1, 1, 1)),
    "opengl": ((0, 1, 2), (-1, 1, -1)),
    "opencv": ((0, 1, 2), (-1, -1, 1)),
    "ros": ((2, 0, 1), (1, 1, 1)),
}


class Samples:
    """Camera poses in one array of doubles, shape (n, 10), as C's ``V_POSE``.

    ``positions``, ``view``, ``up`` and ``zoom`` are views of :attr:`array`: they copy nothing, and
    writing into them writes into the array. ``numpy.asarray(samples)`` is the array.
    ``frames`` (n,) are the frame numbers, ``fps`` is the frame rate, ``world_up`` the up axis of the
    world, ``"y"`` or ``"z"``, or ``None`` if unknown.

    >>> samples = Path().sample()
    >>> len(samples), samples.array.shape, samples.array.dtype
    (121, (121, 10), dtype('float64'))
    >>> samples.positions[0]
    array([-0.6,  0.2,  0.8])
    >>> samples.positions.base is samples.array
    True
    >>> float(samples[10:20].frames[0])
    11.0

    To save poses, fit a path and save it, ``Path.fit(samples).save("flight.csv")``, or save the
    array, ``numpy.savetxt("poses.txt", samples.array)``.
    """

    __slots__ = ("array", "fps", "frames", "world_up")

    array: Array
    """(n, 10): position x y z (``vrp``), view direction (``vpn``), up (``vup``), zoom in mm."""

    fps: float
    """Frames per second."""

    frames: Array
    """(n,): the frame number of each pose; the first of a path is 1."""

    world_up: str | None
    """The up axis of the world, ``"y"`` or ``"z"``: that of the path or the file, or the one that the
    file's format prescribes (``transforms.json``). ``None`` if unknown."""

    def __init__(
        self, array: npt.ArrayLike, fps: float = 25.0, frames: npt.ArrayLike | None = None
    ) -> None:
        """Poses from an array of shape (n, 10); an array of doubles is shared, not copied.

        ``frames`` are 1, 2, … by default. View and up must be perpendicular unit vectors, to a
        thousandth; the zoom must be from 1 to 2000.

        >>> Samples([[0, 0, 0, 0, 0, -1, 0, 1, 0, -3]])
        Traceback (most recent call last):
        vides.Error: poses[0]: zoom must lie between 1 and 2000, not -3
        """
        checked = doubles(array, (None, 10), "poses")
        _check(checked)
        # Strided arrays are shared, too.
        plain = type(array) is np.ndarray and array.dtype == np.float64
        self.array = array if plain and isinstance(array, np.ndarray) else checked
        if not (isinstance(fps, (int, float, np.number)) and 0 < fps <= 100_000):
            raise Error(f"fps must be greater than 0 and at most 100000, not {fps!r}", "range")
        self.fps = float(fps)
        count = len(self.array)
        self.frames = (
            np.arange(1.0, count + 1.0) if frames is None else doubles(frames, (count,), "frames")
        )
        self.world_up = None

    @classmethod
    def _of(cls, array: Array, fps: float, frames: Array, world_up: str | None) -> Samples:
        """Poses from the engine, which are not checked again."""
        made = cls.__new__(cls)
        made.array, made.fps, made.frames, made.world_up = array, fps, frames, world_up
        return made

    @classmethod
    def load(cls, file: str | os.PathLike[str], format: str | None = None, **options: object) -> Samples:
        """The poses in a file: TUM, KITTI, COLMAP, ``transforms.json``, CSV and others.

        ``format`` is a name of :func:`formats`; by default the content decides. ``options`` are
        those of :func:`convert`. If the file has seconds but no frame numbers, :attr:`frames` are
        computed from them, starting at 1; :attr:`fps` is the file's, or follows from its seconds.
        The world's axes are those of the file, and :attr:`world_up` is its up axis:
        ``transforms.json`` always has z up. Keyframes of nerfstudio are ignored; :meth:`Path.load` makes
        points of them.
        """
        array, frames, seconds, fps, up, _ = _vides.recording(path_of(file), str_or_none(format, "format"), choices(options))
        rate = 25.0 if fps is None else fps
        if frames is None and seconds is not None and len(seconds) > 0:
            frames = (seconds - seconds[0]) * rate + 1.0
        if frames is None:
            frames = np.arange(1.0, len(array) + 1.0)
        return cls._of(array, rate, frames, up)

    @classmethod
    def of(
        cls,
        positions: npt.ArrayLike,
        quaternions: npt.ArrayLike,
        zoom: npt.ArrayLike = 24.0,
        fps: float = 25.0,
        convention: Convention = "vides",
    ) -> Samples:
        """Poses from positions (n, 3), quaternions (n, 4) w x y z and zooms in mm, (n,) or one.

        The quaternions rotate from camera axes of the convention to the world.

        >>> samples = Path().sample()
        >>> again = Samples.of(samples.positions, samples.quaternions, samples.zoom)
        >>> bool(abs(again.array - samples.array).max() < 1e-12)
        True
        """
        places = doubles(positions, (None, 3), "positions")
        turns = doubles(quaternions, (len(places), 4), "quaternions")
        axes, signs = _convention(convention)
        zooms = np.broadcast_to(doubles(np.atleast_1d(zoom), (None,), "zoom"), (len(places),))
        # From VIDES' camera to the convention's; the inverse is applied to the quaternions.
        matrix = np.zeros((3, 3))
        for column, (axis, sign) in enumerate(zip(axes, signs)):
            matrix[axis, column] = sign
        turned = _product(turns, _quaternion(matrix.T))
        return cls(_vides.poses_of(places, turned, np.ascontiguousarray(zooms)), fps)

    @property
    def positions(self) -> Array:
        """(n, 3), in the world's lengths; a view of the array."""
        return self.array[:, 0:3]

    @property
    def view(self) -> Array:
        """(n, 3), unit vectors along which the camera looks; a view of the array."""
        return self.array[:, 3:6]

    @property
    def up(self) -> Array:
        """(n, 3), unit vectors perpendicular to :attr:`view`, up in the picture; a view of the array."""
        return self.array[:, 6:9]

    @property
    def zoom(self) -> Array:
        """(n,), focal lengths in mm for a picture of 36×24 mm, 1 to 2000; a view of the array."""
        return self.array[:, 9]

    @property
    def fov(self) -> Array:
        """(n,), vertical fields of view in degrees, 2·atan(12/zoom).

        >>> float(Path().sample().fov[0].round(3))
        53.13
        """
        return np.degrees(2.0 * np.arctan(12.0 / self.zoom))

    @property
    def seconds(self) -> Array:
        """(n,), the time of each pose; the first frame of the path is at 0.

        >>> Path().sample().seconds[:3]
        array([0.  , 0.04, 0.08])
        """
        return (self.frames - 1.0) / self.fps

    @property
    def quaternions(self) -> Array:
        """(n, 4), w x y z, as in C: they rotate (0, 0, 1) to the view and (0, 1, 0) to the up.

        In camera coordinates, +z is the view, +y is up, +x is left. Neighbours may differ in sign.
        """
        return _vides.quaternions(np.ascontiguousarray(self.array))

    def matrices(self, convention: Convention = "opengl") -> Array:
        """(n, 4, 4), camera to world, for column vectors: ``world = matrix @ camera``.

        ============  =======  =====  =========  ========================================
        convention    x is     y is   z is       used by
        ============  =======  =====  =========  ========================================
        ``opengl``    right    up     backwards  OpenGL, Blender, glTF, USD, nerfstudio
        ``opencv``    right    down   forward    OpenCV, COLMAP, Gaussian splatting, Open3D
        ``ros``       forward  left   up         ROS
        ``vides``     left     up     forward    this package's quaternions
        ============  =======  =====  =========  ========================================

        ``numpy.linalg.inv`` of these is world to camera.

        >>> matrix = Path().sample().matrices("opencv")[0]
        >>> matrix[:3, 2]  # looks along -z
        array([ 0.,  0., -1.])
        >>> matrix[:3, 3]  # stands here
        array([-0.6,  0.2,  0.8])
        """
        axes, signs = _convention(convention)
        return _vides.matrices(np.ascontiguousarray(self.array), axes, signs)

    def __len__(self) -> int:
        return len(self.array)

    @overload
    def __getitem__(self, index: slice) -> Samples: ...
    @overload
    def __getitem__(self, index: int) -> Array: ...

    def __getitem__(self, index: int | slice) -> Samples | Array:
        """A row of ten numbers; for a slice, samples that share the array."""
        if isinstance(index, slice):
            return Samples._of(self.array[index], self.fps, self.frames[index], self.world_up)
        row: Array = self.array[operator.index(index)]
        return row

    def __iter__(self) -> Iterator[Array]:
        return iter(self.array)

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> npt.NDArray[Any]:
        if copy:
            return np.array(self.array, dtype=dtype)
        return np.asarray(self.array, dtype=dtype)

    def __eq__(self, other: object) -> bool:
        """Whether poses, frames and frame rate are equal, number by number."""
        if not isinstance(other, Samples):
            return NotImplemented
        return (
            self.fps == other.fps
            and np.array_equal(self.frames, other.frames)
            and np.array_equal(self.array, other.array, equal_nan=True)
        )

    __hash__: ClassVar[None] = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        if len(self) == 0:
            return "<vides.Samples: none>"
        first, last = self.frames[0], self.frames[-1]
        return f"<vides.Samples: {len(self)} poses, frames {first:g} to {last:g}, {self.fps:g} a second>"


def _check(poses: Array) -> None:
    """Fails with the first pose that is not valid."""
    view, up, zoom = poses[:, 3:6], poses[:, 6:9], poses[:, 9]
    for name, vectors in (("view", view), ("up", up)):
        lengths = np.linalg.norm(vectors, axis=1)
        for at in np.flatnonzero(~(abs(lengths - 1.0) <= 1e-3))[:1]:
            raise Error(f"poses[{at}]: {name} has the length {lengths[at]:g}: it must be 1", "range")
    for at in np.flatnonzero(~(abs(np.sum(view * up, axis=1)) <= 1e-3))[:1]:
        raise Error(f"poses[{at}]: view and up must be perpendicular", "range")
    for at in np.flatnonzero(~((zoom >= 1.0) & (zoom <= 2000.0)))[:1]:
        raise Error(f"poses[{at}]: zoom must lie between 1 and 2000, not {zoom[at]:g}", "range")


def _convention(name: str) -> tuple[tuple[int, int, int], tuple[int, int, int]]:
    try:
        return _AXES[name]
    except (KeyError, TypeError):
        raise Error(f"the convention is one of {', '.join(_AXES)}, not {name!r}") from None


def _quaternion(matrix: Array) -> Array:
    """The quaternion of a matrix that permutes axes."""
    columns = _vides.quaternions(
        np.concatenate([np.zeros(3), matrix[:, 2], matrix[:, 1], [24.0]])[np.newaxis]
    )
    quaternion: Array = columns[0]
    return quaternion


def _product(a: Array, b: Array) -> Array:
    w, x, y, z = a.T
    s, i, j, k = b
    return np.stack(
        [
            w * s - x * i - y * j - z * k,
            w * i + x * s + y * k - z * j,
            w * j - x * k + y * s + z * i,
            w * k + x * j - y * i + z * s,
        ],
        axis=-1,
    )
