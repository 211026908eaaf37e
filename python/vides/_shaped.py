"""The shape of a path: its points, its space, and what changes several points at once."""

from __future__ import annotations

import operator
from typing import TYPE_CHECKING, Literal, SupportsIndex

import numpy as np
import numpy.typing as npt

from . import _vides
from ._applied import native_of
from ._arrays import Array, Vector, axis, count, doubles, each, frozen, number, places, str_of, vector
from ._error import Invalid
from ._keyed import index_of
from ._points import Points
from ._properties import PathProperties
from ._tools import Tools

if TYPE_CHECKING:
    from ._path import Path

Axis = Literal["y", "z"]


class Shaped(Tools, PathProperties):
    """The points of a path."""

    __slots__ = ()

    @property
    def points(self) -> Points:
        """Its points."""
        return Points(self)

    @property
    def positions(self) -> Array:
        """(n, 3): the positions of all points, a read-only copy. Assign an array to move them.

        >>> path = Path()
        >>> path.positions = path.positions * 2
        >>> path.positions[0]
        array([-1.2,  0.4,  1.6])
        """
        return frozen(self._native.positions())

    @positions.setter
    def positions(self, positions: npt.ArrayLike) -> None:
        _vides.set_positions(self._native, doubles(positions, (None, 3), "positions"))

    @property
    def zooms(self) -> Array:
        """(n,): the zoom of each point's first orientation in mm, 1 to 2000; a read-only copy. Assign
        an array, or one number for all points.

        >>> path = Path()
        >>> path.zooms = [24, 50]
        >>> path.zooms
        array([24., 50.])
        """
        return frozen(_vides.numbers(self._native, "zoom"))

    @zooms.setter
    def zooms(self, zooms: npt.ArrayLike) -> None:
        _vides.set_numbers(self._native, "zoom", each(zooms, len(self.points), "zooms"))

    @property
    def rolls(self) -> Array:
        """(n,): the roll of each point's first orientation in degrees, −180 to 180; a read-only copy.
        Assign an array, or one number for all points."""
        return frozen(_vides.numbers(self._native, "roll"))

    @rolls.setter
    def rolls(self, rolls: npt.ArrayLike) -> None:
        _vides.set_numbers(self._native, "roll", each(rolls, len(self.points), "rolls"))

    @property
    def times(self) -> Array:
        """(n,): the seconds at which the camera reaches each point, from 0; a read-only copy. Assigned
        times become whole frames; they may begin at any time.

        >>> path = Path([[0, 0, 0], [1, 0, 0], [3, 0, 0]])
        >>> path.times = [0, 1, 5]
        >>> path.times, path.frame_count
        (array([0., 1., 5.]), 126)
        """
        return frozen(_vides.times(self._native))

    @times.setter
    def times(self, times: npt.ArrayLike) -> None:
        _vides.set_times(self._native, doubles(times, (None,), "times"))

    @property
    def up(self) -> str:
        """The up axis, ``"y"`` or ``"z"``; setting it keeps all poses."""
        return self._native.space()[2]

    @up.setter
    def up(self, up: Axis) -> None:
        self._native.edit("change_up", up=axis(up))

    @property
    def space(self) -> tuple[Array, float]:
        """Centre (3,) and half the edge of the space, a cube; see :meth:`set_space`."""
        centre, half_size, _ = self._native.space()
        return np.array(centre), half_size

    def set_space(self, centre: Vector, half_size: float, fit: bool = False) -> None:
        """Sets the cube in which the path lies; with ``fit`` the path is mapped into it."""
        self._native.set_space(vector(centre, "centre"), number(half_size, "half_size"), self.up, bool(fit))

    def look_at(self, targets: npt.ArrayLike) -> None:
        """Makes all orientations look at one place (3,), or those of each point at its own (n, 3), as
        one undo step.

        >>> path = Path()
        >>> path.look_at((0, 0, 0))
        >>> path.look_at([[0, 0, 0], [0, 0.5, 0]])
        >>> path.points[1].target
        (0.0, 0.5, 0.0)
        """
        _vides.look_at(self._native, places(targets, len(self.points), "targets"), None)

    def transform(self, matrix: npt.ArrayLike) -> None:
        """Moves, turns, scales or mirrors the path with all it looks at, as one undo step.

        ``matrix`` (4, 4) is for column vectors: ``new = matrix @ (x, y, z, 1)``. It must not shear.
        The object and the limits are unchanged; the space grows if the path leaves it.

        >>> path = Path()
        >>> path.transform([[0, 0, 5, 1], [0, 5, 0, 0], [-5, 0, 0, 0], [0, 0, 0, 1]])
        >>> path.positions[0]
        array([5., 1., 3.])
        """
        rows = doubles(matrix, (4, 4), "matrix").tolist()
        _vides.transform(self._native, rows)

    def insert_path(
        self,
        path: Path,
        at: SupportsIndex | None = None,
        *,
        fit: Literal["none", "move", "turn", "scale"] = "move",
        with_targets: bool = True,
    ) -> None:
        """Inserts a path before point ``at``, at least 1; by default at the end.

        ``fit`` is how it is brought to the point before it: unchanged (``"none"``), moved, so that it
        begins there (its first point is that point), turned too, so that it goes on in the
        direction of travel, or also scaled, so that it ends at the next point. ``with_targets`` takes
        along what its cameras look at.

        >>> path = Path([[0, 0, 0], [4, 0, 0]], frames=101)
        >>> path.insert_path(Path([[0, 0, 0], [0, 0, -2], [2, 0, -2]]))
        >>> path.positions[-1]
        array([ 6.,  0., -2.])
        """
        points = len(self.points)
        number = points if at is None else operator.index(at)
        number += points if number < 0 else 0
        if not 1 <= number <= points:
            raise Invalid(f"a path is inserted before point 1 to {points}, not {number}", "range")
        _vides.insert_path(self._native, number - 1, native_of(path, "path"), str_of(fit, "fit"), bool(with_targets))

    def divide(self, segment: int, points: int = 1) -> None:
        """Adds 1 to 10 points on the curve between point ``segment`` and the next."""
        self._native.edit(
            "divide", segment=count(segment, "segment"), points=count(points, "points")
        )

    def insert_on_curve(self, frame: float) -> None:
        """Adds a point on the curve where the camera is at a frame; the flight is unchanged.

        The tangents that keep it unchanged are removed when their point or a neighbour moves.
        """
        self._native.edit("insert_on_curve", frame=number(frame, "frame"))

    def set_frames(self, frames: int, first: int = 0, last: int = -1) -> None:
        """Sets the exact number of poses from point ``first`` to point ``last``, both included.

        Sections share them by what they take at their speed, whatever they had; those with
        ``locked`` keep theirs.

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
