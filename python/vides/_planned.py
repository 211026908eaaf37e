"""What is planned for a path, and a path that is planned from nothing."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Literal, NamedTuple, Union

import numpy.typing as npt

from . import _vides
from ._arrays import Array, Vector, corners, doubles, number, vector
from ._error import Error
from ._files import path_of
from ._points import Keyed, index_of
from ._told import Detour, Framed, Rest, Retimed, Steadied

if TYPE_CHECKING:
    from ._path import Axis, Path

Object = Union[str, "os.PathLike[str]", tuple[npt.ArrayLike, npt.ArrayLike]]
"""The file of a mesh (OBJ, PLY, STL, glTF), a ``.vid`` file with an object, or points (n, 3) and
triangles (m, 3) of their indices; without triangles the points count."""


def _given(object: Object) -> str | tuple[Array, list[list[int]]]:
    if not isinstance(object, (tuple, list)):
        return path_of(object)
    if len(object) != 2:
        raise Error(f"an object is a file, or points and triangles, not {len(object)} things")
    return doubles(object[0], (None, 3), "points"), corners(object[1], 3, "triangles")


class Planned(Keyed):
    """A path for which something is planned; each is one step of its history. Ctrl-C ends it."""

    __slots__ = ()

    _native: _vides.Document

    def retime(
        self,
        seconds: float | None = None,
        *,
        first: int = 0,
        last: int = -1,
        speed: float | None = None,
        acceleration: float | None = None,
        jerk: float | None = None,
        turning: float | None = None,
        turning_acceleration: float | None = None,
        zoom: float | None = None,
        crossing: float | None = None,
    ) -> Retimed:
        """Computes the pace anew, from point ``first`` to point ``last``; curve and views stay.

        As short as the limits allow, or in exactly so many ``seconds`` with the lowest peaks. It
        begins and ends at rest, unless the path is closed. Limits that are not given are the
        path's own (:meth:`Path.set_limits`); ``math.inf``: none. They count for a second: ``speed``, ``acceleration``
        and ``jerk`` of the camera's place in half sizes of the space, ``turning`` and
        ``turning_acceleration`` in degrees, ``zoom`` in mm; ``crossing`` is the least time in
        which a thing may cross the picture's width.

        >>> path = Path([[-1, 0, 0], [1, 0, 0]])
        >>> path.set_space((0, 0, 0), 1)
        >>> path.retime(speed=0.5, acceleration=1)
        Retimed(seconds=4.56, rests=())
        >>> path.retime(6).seconds
        6.0
        >>> try:
        ...     path.retime(1, speed=0.5)
        ... except Error as error:
        ...     print(error)
        1 s are too short: the limits allow it in 4.120 s
        """
        points = self._native.point_count()
        limits = {
            "speed": speed,
            "acceleration": acceleration,
            "jerk": jerk,
            "turning": turning,
            "turning_acceleration": turning_acceleration,
            "zoom": zoom,
            "crossing": crossing,
        }
        if seconds is not None and not number(seconds, "seconds") > 0:
            raise Error(f"seconds must be greater than 0, not {seconds}")
        took, rests = self._native.retime(
            0.0 if seconds is None else number(seconds, "seconds"),
            index_of(first, points, "point"),
            index_of(last, points, "point"),
            [(name, number(limit, name)) for name, limit in limits.items() if limit is not None],
        )
        return Retimed(took, tuple(Rest(*rest) for rest in rests))

    def avoid(self, clearance: float, radius: float = 0, object: Object | None = None) -> tuple[Detour, ...]:
        """Leads the way clear of an object, between frames too. Returns where it is another.

        The camera, with a sphere of ``radius`` around it, keeps the distance ``clearance``, both in
        the world's lengths. Few points are moved or put in; frames and targets stay. ``object`` is
        a file, or points (n, 3) and triangles (m, 3); without it, that of :meth:`set_object`.

        >>> path = Path([[-3, 0.1, 0], [3, 0, 0]], frames=101)
        >>> wall = [[0, -1, -1], [0, 1, -1], [0, 0, 1]], [[0, 1, 2]]
        >>> len(path.avoid(0.5, object=wall))
        1
        >>> path.avoid(0.5, object=wall)
        ()
        """
        rows = self._native.avoid(
            number(clearance, "clearance"),
            number(radius, "radius"),
            None if object is None else _given(object),
        )
        return tuple(Detour(*row) for row in rows)

    def keep_in_picture(
        self,
        margin: float = 0.1,
        by: Literal["zoom", "distance", "view"] = "zoom",
        object: Object | None = None,
    ) -> Framed:
        """Keeps an object whole in the picture at every frame and between.

        ``margin`` is the share of the picture's width, and of its height, that stays free at each
        side, from 0 to below 0.5. ``by`` says what may change: the zoom, the camera's distance
        along its view, or where it looks. ``object`` is as :meth:`avoid` has it.

        >>> path = Path([[-3, 0, 4], [3, 0, 5]], look_at=(0, 0, 0), frames=101)
        >>> ball = [[-1, 0, 0], [1, 0, 0], [0, 1, 0], [0, -1, 0]], [[0, 2, 1], [0, 1, 3]]
        >>> bool(path.keep_in_picture(object=ball).tightest <= 1)
        True
        """
        given = None if object is None else _given(object)
        return Framed(*self._native.keep_in_picture(number(margin, "margin"), by, given))

    def steady(self, seconds: float, within: float | None = None) -> Steadied:
        """Takes the shaking of a hand out of a recorded flight; its first and last pose stay.

        Half of a movement that takes ``seconds`` there and back stays, and hardly anything of
        quicker ones. No place goes farther than ``within``, in the world's lengths. A closed path
        comes back open; frames stay as many.

        >>> path = Path([[k, 0.1 * (-1) ** k, 0] for k in range(20)], look_at=(9, 0, -9), frames=96)
        >>> told = path.steady(2)
        >>> bool(told.furthest < 0.2 and abs(path.sample(30, 60).positions[:, 1]).max() < 0.02)
        True
        """
        if within is not None and not number(within, "within") > 0:
            raise Error(f"within must be greater than 0, not {within}", "range")
        told = self._native.steady(
            number(seconds, "seconds"), 0.0 if within is None else number(within, "within")
        )
        return Steadied(*told)


class Tour(NamedTuple):
    """A flight that shows an object, and what it shows. Shares are of areas, from 0 to 1."""

    path: Path
    """The flight, 25 frames a second, with the object."""
    coverage: float
    """The share that is shown of what can be seen."""
    surface: float
    """The share that is shown of the whole surface."""
    places: int
    """How many places show it."""
    distance: float
    """How far these are from the object."""
    length: float
    """The length of the way."""
    seconds: float
    """How long it takes, a whole number of frames."""
    left_out: float
    """Of the whole surface, what is seen from places that were not needed."""
    narrow: float
    """What may be seen, but from no place that was tried."""
    hidden: float
    """What cannot be seen."""


def tour(
    object: Object,
    seconds: float = 60,
    coverage: float = 0.95,
    distance: float | None = None,
    inside: bool = False,
    start: Vector | None = None,
    up: Axis = "y",
    stills: bool = False,
) -> Tour:
    """A flight that shows an object for which nobody has planned one.

    ``object`` is the file of a mesh, a ``.vid`` file with an object, or points (n, 3) and triangles
    (m, 3). ``coverage`` is the share, by area, of what can be seen that is shown; ``distance``, a
    length, how far the camera is from what it shows, found unless given. ``inside`` flies in the
    object's free space, not around it. It is a closed round, unless it has a ``start`` (3,).
    ``stills`` gives only the views that show it, one a frame, for pictures. Ctrl-C ends it.

    >>> corners = [[1, 1, 1], [-1, -1, 1], [-1, 1, -1], [1, -1, -1]]
    >>> shown = tour((corners, [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]), seconds=30)
    >>> shown.coverage >= 0.95, shown.seconds, shown.path.closed
    (True, 30.0, True)
    """
    from ._path import Path

    native, told = _vides.tour(
        _given(object),
        number(seconds, "seconds"),
        number(coverage, "coverage"),
        0.0 if distance is None else number(distance, "distance"),
        bool(inside),
        None if start is None else vector(start, "start"),
        up,
        bool(stills),
    )
    return Tour(Path._of(native), *told)
