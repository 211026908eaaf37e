"""Poses of a camera, one a row."""

from __future__ import annotations

import operator
import os
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any, ClassVar, Literal, Protocol, overload

import numpy as np
import numpy.typing as npt

from . import _vides
from ._arrays import Array, doubles, each, number, str_or_none
from ._error import Invalid
from ._files import choices, path_of

if TYPE_CHECKING:
    from typing_extensions import Self

Convention = Literal["opengl", "opencv", "ros", "vides"]
"""The meaning of a camera's axes; see :meth:`Samples.matrices`."""

# For x, y, z of the convention: the column of VIDES' camera (left, up, forward), and its sign.
_AXES: dict[str, tuple[tuple[int, int, int], tuple[int, int, int]]] = {
    "vides": ((0, 1, 2), (1, 1, 1)),
    "opengl": ((0, 1, 2), (-1, 1, -1)),
    "opencv": ((0, 1, 2), (-1, -1, 1)),
    "ros": ((2, 0, 1), (1, 1, 1)),
}


class Rotation(Protocol):
    """What is used of ``scipy.spatial.transform.Rotation``."""

    def as_matrix(self) -> npt.NDArray[Any]: ...


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

    :meth:`from_matrices`, :meth:`from_quaternions` and :meth:`from_rotation` make poses of what other
    programs have; :meth:`save` writes a file.
    """

    __slots__ = ("array", "fps", "frames", "losses", "start", "world_up")

    array: Array
    """(n, 10): position x y z (``vrp``), view direction (``vpn``), up (``vup``), zoom in mm."""

    fps: float
    """Frames per second."""

    frames: Array
    """(n,): the frame number of each pose; the first of a path is 1."""

    world_up: str | None
    """The up axis of the world, ``"y"`` or ``"z"``: that of the path or the file, or the one that the
    file's format prescribes (``transforms.json``). ``None`` if unknown."""

    losses: tuple[str, ...]
    """What :meth:`load` did not take from the file, or changed, a sentence each."""

    start: float
    """The time of frame 1 in the file, in seconds: ``samples.save("out.tum", start=samples.start)``
    writes times like those that were read. 0 if the file has none."""

    def __init__(
        self, array: npt.ArrayLike, fps: float = 25.0, frames: npt.ArrayLike | None = None
    ) -> None:
        """Poses from an array of shape (n, 10); an array of doubles is shared, not copied.

        ``frames`` are 1, 2, … by default. View and up must be perpendicular unit vectors, to a
        thousandth; the zoom must be from 1 to 2000.

        >>> Samples([[0, 0, 0, 0, 0, -1, 0, 1, 0, -3]])
        Traceback (most recent call last):
        vides.Invalid: poses[0]: zoom must lie between 1 and 2000, not -3
        """
        checked = doubles(array, (None, 10), "poses")
        _check(checked)
        # Strided arrays are shared, too.
        plain = type(array) is np.ndarray and array.dtype == np.float64
        self.array = array if plain and isinstance(array, np.ndarray) else checked
        if not (isinstance(fps, (int, float, np.number)) and 0 < fps <= 100_000):
            raise Invalid(f"fps must be greater than 0 and at most 100000, not {fps!r}", "range")
        self.fps = float(fps)
        count = len(self.array)
        self.frames = (
            np.arange(1.0, count + 1.0) if frames is None else doubles(frames, (count,), "frames")
        )
        self.world_up, self.losses, self.start = None, (), 0.0

    @classmethod
    def _of(
        cls,
        array: Array,
        fps: float,
        frames: Array,
        world_up: str | None,
        losses: Sequence[str] = (),
        start: float = 0.0,
    ) -> Self:
        """Poses from the engine, which are not checked again."""
        made = cls.__new__(cls)
        made.array, made.fps, made.frames, made.world_up = array, fps, frames, world_up
        made.losses, made.start = tuple(losses), start
        return made

    @classmethod
    def load(cls, file: str | os.PathLike[str], format: str | None = None, **options: object) -> Self:
        """The poses in a file: TUM, KITTI, COLMAP, ``transforms.json``, CSV and others.

        ``format`` is a name of :func:`formats`; by default the content decides. ``options`` are
        those of :func:`convert`. If the file has seconds but no frame numbers, :attr:`frames` are
        computed from them, starting at 1; :attr:`fps` is the file's, or follows from its seconds.
        The world's axes are those of the file, and :attr:`world_up` is its up axis:
        ``transforms.json`` always has z up. Keyframes of nerfstudio are ignored; :meth:`Path.load` makes
        points of them.
        """
        array, frames, seconds, fps, up, losses = _vides.recording(
            path_of(file), str_or_none(format, "format"), choices(options)
        )
        rate = 25.0 if fps is None else fps
        start = 0.0
        if frames is None and seconds is not None and len(seconds) > 0:
            start = float(seconds[0])
            frames = (seconds - start) * rate + 1.0
        if frames is None:
            frames = np.arange(1.0, len(array) + 1.0)
        return cls._of(array, rate, frames, up, losses, start)

    @classmethod
    def from_quaternions(
        cls,
        positions: npt.ArrayLike,
        quaternions: npt.ArrayLike,
        zoom: npt.ArrayLike = 24.0,
        fps: float = 25.0,
        convention: Convention = "vides",
        *,
        scalar_first: bool = True,
    ) -> Self:
        """Poses from positions (n, 3), quaternions (n, 4) w x y z and zooms in mm, (n,) or one.

        The quaternions rotate from camera axes of the convention to the world. With
        ``scalar_first=False`` they are x y z w, as those of SciPy, ROS and TUM files.

        >>> samples = Path().sample()
        >>> again = Samples.from_quaternions(samples.positions, samples.quaternions, samples.zoom)
        >>> bool(abs(again.array - samples.array).max() < 1e-12)
        True
        """
        places = doubles(positions, (None, 3), "positions")
        turns = doubles(quaternions, (len(places), 4), "quaternions")
        lengths = np.linalg.norm(turns, axis=1)
        for at in np.flatnonzero(~(abs(lengths - 1.0) <= 1e-3))[:1]:
            raise Invalid(f"quaternions[{at}] has the length {lengths[at]:g}: it must be 1", "range")
        if not scalar_first:
            turns = np.roll(turns, 1, axis=1)
        axes, signs = _convention(convention)
        # From VIDES' camera to the convention's; the inverse is applied to the quaternions.
        matrix = np.zeros((3, 3))
        for column, (axis, sign) in enumerate(zip(axes, signs)):
            matrix[axis, column] = sign
        turned = _product(turns, _quaternion(matrix.T))
        return cls(_vides.poses_of(places, turned, each(zoom, len(places), "zoom")), fps)

    @classmethod
    def from_rotation(
        cls,
        positions: npt.ArrayLike,
        rotation: Rotation,
        zoom: npt.ArrayLike = 24.0,
        fps: float = 25.0,
        convention: Convention = "opengl",
    ) -> Self:
        """Poses from positions (n, 3) and a ``scipy.spatial.transform.Rotation`` of n rotations, from
        camera axes of the convention to the world; ``zoom`` in mm, (n,) or one."""
        if not hasattr(rotation, "as_matrix"):
            kind = type(rotation).__name__
            raise TypeError(f"rotation must be a Rotation of SciPy, not {kind}; see from_quaternions()")
        places = doubles(positions, (None, 3), "positions")
        turns = np.asarray(rotation.as_matrix(), dtype=np.float64)
        turns = turns[np.newaxis] if turns.ndim == 2 else turns
        if len(turns) != len(places):
            raise Invalid(f"there are {len(places)} positions, and {len(turns)} rotations")
        matrices = np.tile(np.eye(4), (len(places), 1, 1))
        matrices[:, :3, :3], matrices[:, :3, 3] = turns, places
        return cls.from_matrices(matrices, zoom, fps, convention)

    @classmethod
    def from_matrices(
        cls,
        matrices: npt.ArrayLike,
        zoom: npt.ArrayLike | None = None,
        fps: float = 25.0,
        convention: Convention = "opengl",
        *,
        world_to_camera: bool = False,
        intrinsics: npt.ArrayLike | None = None,
        height: float | None = None,
    ) -> Self:
        """Poses from matrices (n, 4, 4) or (n, 3, 4), camera to world, for column vectors.

        With ``world_to_camera`` they are the inverse, as COLMAP's. ``zoom`` is in mm, (n,) or one, by
        default 24; instead, ``intrinsics`` (3, 3) or (n, 3, 3) with the ``height`` of the picture in
        pixels give it: 24 mm · f_y / height. The principal point is not used.

        >>> samples = Path().sample()
        >>> matrices = samples.world_to_camera("opencv")
        >>> again = Samples.from_matrices(matrices, convention="opencv", world_to_camera=True)
        >>> bool(abs(again.array - samples.array).max() < 1e-12)
        True
        """
        given = np.asanyarray(matrices)
        rows = 3 if given.ndim == 3 and given.shape[1] == 3 else 4
        array = doubles(matrices, (None, rows, 4), "matrices")
        turns, places = array[:, :3, :3], array[:, :3, 3]
        if rows == 4 and not np.allclose(array[:, 3], (0, 0, 0, 1), rtol=0, atol=1e-9):
            at = int(np.flatnonzero(~np.isclose(array[:, 3], (0, 0, 0, 1), rtol=0, atol=1e-9).all(axis=1))[0])
            raise Invalid(f"matrices[{at}]: the last row must be 0 0 0 1: vectors are columns")
        off = abs(turns @ turns.transpose(0, 2, 1) - np.eye(3)).max(axis=(1, 2), initial=0)
        for at in np.flatnonzero(~(off <= 1e-3) | (np.linalg.det(turns) < 0))[:1]:
            raise Invalid(f"matrices[{at}] is no rotation: it scales, shears or mirrors")
        if world_to_camera:
            turns = turns.transpose(0, 2, 1)
            places = -(turns @ places[:, :, np.newaxis])[:, :, 0]
        axes, signs = _convention(convention)
        own = np.empty_like(turns)
        for column, (axis, sign) in enumerate(zip(axes, signs)):
            own[:, :, axis] = sign * turns[:, :, column]
        if intrinsics is not None:
            if zoom is not None:
                raise TypeError("from_matrices() takes either zoom or intrinsics")
            zoom = _zoom(intrinsics, height, len(places))
        zooms = each(24.0 if zoom is None else zoom, len(places), "zoom")
        return cls(np.column_stack([places, own[:, :, 2], own[:, :, 1], zooms]), fps)

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

        :meth:`world_to_camera` has their inverses.

        >>> matrix = Path().sample().matrices("opencv")[0]
        >>> matrix[:3, 2]  # looks along -z
        array([ 0.,  0., -1.])
        >>> matrix[:3, 3]  # stands here
        array([-0.6,  0.2,  0.8])
        """
        axes, signs = _convention(convention)
        return _vides.matrices(np.ascontiguousarray(self.array), axes, signs)

    def world_to_camera(self, convention: Convention = "opencv") -> Array:
        """(n, 4, 4), world to camera, for column vectors: the inverses of :meth:`matrices`.

        >>> samples = Path().sample()
        >>> bool(np.allclose(samples.world_to_camera("ros") @ samples.matrices("ros"), np.eye(4)))
        True
        """
        inverse = self.matrices(convention)
        turns = inverse[:, :3, :3].transpose(0, 2, 1).copy()
        inverse[:, :3, 3] = -(turns @ inverse[:, :3, 3, np.newaxis])[:, :, 0]
        inverse[:, :3, :3] = turns
        return inverse

    def intrinsics(self, width: float, height: float) -> Array:
        """(n, 3, 3), K of a pinhole camera for pictures of so many pixels: the vertical field of view is
        :attr:`fov`, pixels are square, the principal point is the middle.

        ``K @ world_to_camera("opencv")[:, :3] @ (x, y, z, 1)`` is (u·w, v·w, w), with the pixel (u, v)
        from the left upper corner.

        >>> Path().sample().intrinsics(1920, 1080)[0].tolist()
        [[1080.0, 0.0, 960.0], [0.0, 1080.0, 540.0], [0.0, 0.0, 1.0]]
        """
        across, down = _pixels(width, "width"), _pixels(height, "height")
        k = np.zeros((len(self), 3, 3))
        k[:, 0, 0] = k[:, 1, 1] = self.zoom * (down / 24.0)
        k[:, 0, 2], k[:, 1, 2], k[:, 2, 2] = across / 2.0, down / 2.0, 1.0
        return k

    def projection(self, aspect: float, near: float = 0.1, far: float = 1000.0) -> Array:
        """(n, 4, 4), OpenGL's projection for pictures of ``aspect`` = width / height, with z from −1 at
        ``near`` to 1 at ``far``.

        >>> Path().sample().projection(16 / 9, 1, 10)[0].round(3).tolist()[0]
        [1.125, 0.0, 0.0, 0.0]
        """
        across, front, back = _pixels(aspect, "aspect"), number(near, "near"), number(far, "far")
        if not 0 < front < back < np.inf:
            raise Invalid(f"near and far must be lengths, 0 < near < far, not {front:g} and {back:g}", "range")
        made = np.zeros((len(self), 4, 4))
        made[:, 1, 1] = self.zoom / 12.0
        made[:, 0, 0] = made[:, 1, 1] / across
        made[:, 2, 2] = -(back + front) / (back - front)
        made[:, 2, 3] = -2.0 * back * front / (back - front)
        made[:, 3, 2] = -1.0
        return made

    def save(self, file: str | os.PathLike[str], format: str | None = None, **options: object) -> list[str]:
        """Writes the poses, one a frame, by ``format`` or by the file's name; see :meth:`Path.save`.

        Formats whose poses have times keep :attr:`seconds`, also between frames. Returns what the
        format cannot hold, a sentence each; :func:`options` lists the options.

        >>> import os, tempfile
        >>> samples = Path().sample()
        >>> with tempfile.TemporaryDirectory() as folder:
        ...     losses = samples.save(os.path.join(folder, "poses.csv"))
        ...     again = Samples.load(os.path.join(folder, "poses.csv"))
        >>> bool(abs(again.array - samples.array).max() < 1e-12)
        True
        """
        return _vides.save_poses(
            path_of(file),
            str_or_none(format, "format"),
            choices(options),
            np.ascontiguousarray(self.array),
            np.ascontiguousarray(self.frames),
            self.fps,
            self.world_up,
        )

    def __len__(self) -> int:
        return len(self.array)

    @overload
    def __getitem__(self, index: slice) -> Self: ...
    @overload
    def __getitem__(self, index: int) -> Array: ...

    def __getitem__(self, index: int | slice) -> Self | Array:
        """A row of ten numbers; for a slice, samples that share the array."""
        if isinstance(index, slice):
            return self._of(
                self.array[index], self.fps, self.frames[index], self.world_up, self.losses, self.start
            )
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
            raise Invalid(f"poses[{at}]: {name} has the length {lengths[at]:g}: it must be 1", "range")
    for at in np.flatnonzero(~(abs(np.sum(view * up, axis=1)) <= 1e-3))[:1]:
        raise Invalid(f"poses[{at}]: view and up must be perpendicular", "range")
    for at in np.flatnonzero(~((zoom >= 1.0) & (zoom <= 2000.0)))[:1]:
        raise Invalid(f"poses[{at}]: zoom must lie between 1 and 2000, not {zoom[at]:g}", "range")


def _pixels(value: float, name: str) -> float:
    """A number greater than 0."""
    given = number(value, name)
    if not 0 < given < np.inf:
        raise Invalid(f"{name} must be greater than 0, not {given:g}", "range")
    return given


def _zoom(intrinsics: npt.ArrayLike, height: float | None, count: int) -> Array:
    """The zooms of pinhole cameras K."""
    if height is None:
        raise TypeError("intrinsics need the height of the picture in pixels")
    one = np.ndim(intrinsics) == 2
    k = doubles(intrinsics, (3, 3) if one else (count, 3, 3), "intrinsics")
    zooms = np.atleast_1d(k[..., 1, 1]) * (24.0 / _pixels(height, "height"))
    return np.full(count, zooms[0]) if one else zooms


def _convention(name: str) -> tuple[tuple[int, int, int], tuple[int, int, int]]:
    try:
        return _AXES[name]
    except (KeyError, TypeError):
        raise Invalid(f"the convention is one of {', '.join(_AXES)}, not {name!r}") from None


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
