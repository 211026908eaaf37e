"""The planning methods of a path, and tours."""

from __future__ import annotations

import contextlib
import inspect
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Literal, NamedTuple

from . import _vides
from ._arrays import Vector, axis, number, str_of, vector
from ._error import Error, Invalid
from ._keyed import Keyed, index_of
from ._objects import Object, given
from ._told import Detour, Framed, Rest, Retimed, Steadied

if TYPE_CHECKING:
    from ._path import Path
    from ._shaped import Axis

@contextlib.contextmanager
def progress(callback: Callable[[float], object]) -> Iterator[None]:
    """Within it, long calls of this thread report how far they are: planners, fits and checks.

    ``callback`` gets a share from 0 to 1, at most ten times a second and not in the first tenth of
    one; the share may fall where the work begins another round. An exception from it ends the call, which
    has then changed nothing, and goes on to you.

    >>> path = Path([[3, 1, 0], [0, 2, 3], [-3, 1, 0]], look_at=(0, 0, 0), frames=250)
    >>> with progress(lambda share: print(f"{share:.0%}")):
    ...     path.check()
    []
    """
    if not callable(callback):
        raise TypeError(f"callback must be a function, not {type(callback).__name__}")
    before = _vides.set_progress(callback)
    try:
        yield
    finally:
        _vides.set_progress(before)


class Planned(Keyed):
    """The planning methods of a path. Each call is one undo step; Ctrl-C stops it."""

    __slots__ = ()

    _native: _vides.Document

    def __init_subclass__(cls) -> None:
        """Makes errors and help name a function by its public class."""
        for base in cls.__mro__[1:-1]:
            for name, member in vars(base).items():
                function = getattr(member, "__func__", member)
                if base is not Keyed and inspect.isfunction(function):
                    function.__qualname__ = f"{cls.__name__}.{name}"

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
        """Recomputes the speed from point ``first`` to point ``last``; curve and views are kept.

        The path becomes as fast as the limits allow, or takes exactly ``seconds``, with the lowest
        peaks. It begins and ends at rest unless it is closed. Limits default to those of the path
        (:meth:`Path.set_limits`); ``math.inf`` removes one. Units are seconds and, for ``speed``,
        ``acceleration`` and ``jerk``, the world's lengths; for ``turning`` and
        ``turning_acceleration`` degrees; for ``zoom`` mm. ``crossing`` is the least number of
        seconds in which anything may cross the picture's width.

        >>> path = Path([[-1, 0, 0], [1, 0, 0]])
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
            raise Invalid(f"seconds must be greater than 0, not {seconds}")
        took, rests = self._native.retime(
            0.0 if seconds is None else number(seconds, "seconds"),
            index_of(first, points, "point"),
            index_of(last, points, "point"),
            [(name, number(limit, name)) for name, limit in limits.items() if limit is not None],
        )
        return Retimed(took, tuple(Rest(*rest) for rest in rests))

    def avoid(self, clearance: float, radius: float = 0, object: Object | None = None) -> tuple[Detour, ...]:
        """Moves the path away from an object, also between frames. Returns the parts that changed.

        The camera, with a sphere of ``radius`` around it, keeps the distance ``clearance``, both in
        the world's lengths. As few points as needed are moved or added; frames and targets are
        kept. ``object`` is a file, a mesh of trimesh or pyvista, or vertices (n, 3) and triangles
        (m, 3); the default is that of :meth:`set_object`.

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
            None if object is None else given(object),
        )
        return tuple(Detour(*row) for row in rows)

    def keep_in_picture(
        self,
        margin: float = 0.1,
        by: Literal["zoom", "distance", "view"] = "zoom",
        object: Object | None = None,
    ) -> Framed:
        """Keeps the whole object in the picture, at every frame and between frames.

        ``margin`` is the share of the picture's width and height that remains free at each side,
        at least 0 and less than 0.5. ``by`` is what may change: the zoom, the camera's distance
        along its view, or the direction of the view. ``object`` is as for :meth:`avoid`.

        >>> path = Path([[-3, 0, 4], [3, 0, 5]], look_at=(0, 0, 0), frames=101)
        >>> ball = [[-1, 0, 0], [1, 0, 0], [0, 1, 0], [0, -1, 0]], [[0, 2, 1], [0, 1, 3]]
        >>> bool(path.keep_in_picture(object=ball).tightest <= 1)
        True
        """
        around = None if object is None else given(object)
        return Framed(*self._native.keep_in_picture(number(margin, "margin"), str_of(by, "by"), around))

    def steady(self, period: float, within: float | None = None) -> Steadied:
        """Stabilises a recorded flight; its first and last pose are unchanged.

        ``period`` is the cut-off period in seconds: motion of this period is halved, faster motion is
        removed. ``within`` is the maximum distance that any position may move, in the world's
        lengths. A closed path becomes open; the number of frames is unchanged.

        >>> path = Path([[k, 0.1 * (-1) ** k, 0] for k in range(20)], look_at=(9, 0, -9), frames=96)
        >>> told = path.steady(2)
        >>> bool(told.furthest < 0.2 and abs(path.sample(30, 60).positions[:, 1]).max() < 0.02)
        True
        """
        if within is not None and not number(within, "within") > 0:
            raise Invalid(f"within must be greater than 0, not {within}", "range")
        told = self._native.steady(
            number(period, "period"), 0.0 if within is None else number(within, "within")
        )
        return Steadied(*told)


class Tour(NamedTuple):
    """A flight that shows an object, and how much it shows. Shares are of areas, from 0 to 1."""

    path: Path
    """The flight, at 25 fps, with the object."""
    coverage: float
    """The share of the visible surface that is shown."""
    surface: float
    """The share of the whole surface that is shown."""
    places: int
    """The number of views that show it."""
    distance: float
    """The distance of these views from the object."""
    length: float
    """The length of the path."""
    seconds: float
    """The duration, a whole number of frames."""
    left_out: float
    """The share of the whole surface that only views that were not needed show."""
    narrow: float
    """The share that may be visible, but from none of the views that were tried."""
    hidden: float
    """The share that is not visible from anywhere."""


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
    """Plans a flight that shows an object.

    ``object`` is a mesh file, a ``.vid`` file with an object, a mesh of trimesh or pyvista, or
    vertices (n, 3) and triangles (m, 3). ``coverage`` is the share of the visible surface, by area, to show. ``distance`` is the
    distance of the camera from what it shows; by default it is chosen to fit. ``inside`` flies
    inside the object, not around it. The flight is a closed round unless it has a ``start`` (3,).
    ``stills`` returns only the views that show the object, one a frame, for pictures. Ctrl-C stops
    it.

    >>> corners = [[1, 1, 1], [-1, -1, 1], [-1, 1, -1], [1, -1, -1]]
    >>> shown = tour((corners, [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]), seconds=30)
    >>> shown.coverage >= 0.95, shown.seconds, shown.path.closed
    (True, 30.0, True)
    """
    from ._path import Path

    native, told = _vides.tour(
        given(object),
        number(seconds, "seconds"),
        number(coverage, "coverage"),
        0.0 if distance is None else number(distance, "distance"),
        bool(inside),
        None if start is None else vector(start, "start"),
        axis(up),
        bool(stills),
    )
    return Tour(Path._of(native), *told)
