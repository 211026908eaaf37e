"""The points, orientations and sections of a path."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, SupportsIndex, TypeVar, overload

from . import _vides
from ._arrays import Array, Vector, doubles, frozen, vector
from ._keyed import index_of, place_of
from ._properties import PointProperties, ViewProperties

if TYPE_CHECKING:
    from ._planned import Planned

_Item = TypeVar("_Item")


class Orientation(ViewProperties):
    """One camera orientation at a point: what the camera looks at, and how it moves on.

    Its properties are attributes: ``target`` or ``offset`` (x, y, z), ``roll`` (degrees), ``zoom``
    (mm, 1 to 2000), ``hold`` (frames), ``speed_curve`` (ten numbers, 1 to 100) and so on.
    ``help(vides.Orientation.zoom)`` tells meaning, unit and range of one. ``None`` restores a
    default. Values are copies: assign a whole one to change it.

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

    def __init__(self, path: Planned, point: int, at: int) -> None:
        self._owner = path
        self._point = point
        self._at = at

    def _document(self) -> _vides.Document:
        return self._owner._native

    def _prefix(self) -> str:
        return f"point.{self._point + 1}.view.{self._at + 1}."

    @property
    def up_vector(self) -> Array:
        """(3,): the camera's up, including the roll; a unit vector perpendicular to its view."""
        return frozen(self._document().up_at(self._point, self._at))

    def make_absolute(self, absolute: bool = True) -> None:
        """Makes the target a place in the world, or an offset from the point; the view is kept."""
        self._document().edit("set_absolute", point=self._point, at=self._at, absolute=bool(absolute))

    def __repr__(self) -> str:
        values = f"zoom {self.zoom:g}, roll {self.roll:g}"
        return f"<vides.Orientation {self._at} of point {self._point}: {values}>"


class _Sequence(Sequence[_Item]):
    """Counts from 0, negative indices from the end; slices return lists."""

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
        return self._item(index_of(index, len(self), self._what()))

    def __iter__(self) -> Iterator[_Item]:
        return (self._item(at) for at in range(len(self)))


class Orientations(_Sequence[Orientation]):
    """The orientations of a point, at least one, in the order in which the camera takes them."""

    __slots__ = ("_owner", "_point")

    def __init__(self, path: Planned, point: int) -> None:
        self._owner = path
        self._point = point

    def __len__(self) -> int:
        return self._owner._native.orientation_count(self._point)

    def _item(self, at: int) -> Orientation:
        return Orientation(self._owner, self._point, at)

    def _what(self) -> str:
        return "orientation"

    def insert(self, at: int) -> Orientation:
        """Inserts an orientation before index ``at``, a copy of the one before it. As in
        ``list.insert``, −1 inserts before the last.

        >>> path = Path()
        >>> path.points[0].orientations.append().roll = 90
        >>> [view.roll for view in path.points[0].orientations]
        [0.0, 90.0]
        """
        at = place_of(at, len(self))
        self._owner._native.edit("insert_orientation", point=self._point, at=at)
        return Orientation(self._owner, self._point, at)

    def append(self) -> Orientation:
        """Appends an orientation, a copy of the last one."""
        return self.insert(len(self))

    def __delitem__(self, at: int) -> None:
        at = index_of(at, len(self), "orientation")
        self._owner._native.edit("remove_orientation", point=self._point, at=at)

    def __repr__(self) -> str:
        return f"<vides.Orientations: {len(self)} of point {self._point}>"


class Point(PointProperties, ViewProperties):
    """A point: the camera passes through it.

    It refers to the point by its index, so after an earlier point is removed it refers to the next
    one.

    The properties of its first orientation are also its own: ``point.zoom = 30``. It also has
    ``position``, ``name``, ``preset`` (0 to 9) or ``own`` (``{"tension": 0.5}``) for the shape of
    the curve, and ``tangents``. ``help(vides.Point.zoom)`` tells meaning, unit and range of one.

    >>> path = Path()
    >>> path.points[0].position = (-1, 0, 1)
    >>> path.points[0].position
    array([-1.,  0.,  1.])
    >>> path.points[0].zoom = 50
    >>> path.points[0].name = "start"
    """

    __slots__ = ("_owner", "_at")

    def __init__(self, path: Planned, at: int) -> None:
        self._owner = path
        self._at = at

    def _document(self) -> _vides.Document:
        return self._owner._native

    def _prefix(self) -> str:
        return f"point.{self._at + 1}."

    @property
    def index(self) -> int:
        """Its index, from 0."""
        return self._at

    @property
    def position(self) -> Array:
        """(3,): its position, a read-only copy; assign a whole position to move the point."""
        return frozen(self._document().position(self._at))

    @position.setter
    def position(self, position: Vector) -> None:
        self._put("position", vector(position, "position"))

    @property
    def orientations(self) -> Orientations:
        """Its orientations."""
        return Orientations(self._owner, self._at)

    def look_at(self, target: Vector) -> None:
        """Makes all its orientations look at a place in the world, as one undo step."""
        _vides.look_at(self._document(), doubles(target, (3,), "target")[None], self._at)

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

    def __init__(self, path: Planned) -> None:
        self._owner = path

    def __len__(self) -> int:
        return self._owner._native.point_count()

    def _item(self, at: int) -> Point:
        return Point(self._owner, at)

    def _what(self) -> str:
        return "point"

    def insert(self, at: int, position: Vector) -> Point:
        """Inserts a point before index ``at``; everything else except the name is copied from the
        point before it. As in ``list.insert``, −1 inserts before the last."""
        at = place_of(at, len(self))
        self._owner._native.edit("insert_point", at=at, position=vector(position, "position"))
        return Point(self._owner, at)

    def append(self, position: Vector) -> Point:
        """Appends a point."""
        return self.insert(len(self), position)

    def __delitem__(self, at: int) -> None:
        self._owner._native.edit("remove_point", at=index_of(at, len(self), "point"))

    def move(self, source: int, to: int) -> None:
        """Moves a point to another index; those between move up or down by one."""
        count = len(self)
        self._owner._native.edit(
            "move_point", source=index_of(source, count, "point"), to=index_of(to, count, "point")
        )

    def __repr__(self) -> str:
        return f"<vides.Points: {len(self)}>"


class Section(ViewProperties):
    """The part of a path from one orientation to the next, at one point or on to the next point.

    It is a snapshot of the path at the time of the call. Its speed profile is a property of the
    orientation with which it begins, and can be set here: ``section.speed_curve = …``,
    ``section.ease = …``.

    >>> from vides import Path
    >>> section = Path([[0, 0, 0], [1, 0, 0], [1, 1, 0]]).sections[1]
    >>> section.speed_curve = [10, 20, 30, 40, 50, 50, 40, 30, 20, 10]
    >>> section.frames = 50
    >>> section
    <vides.Section: position from point 1, 50 frames>
    """

    __slots__ = ("_owner", "_at", "_row")
    _owner: Planned
    _at: int
    _row: tuple[int, int, str, float, int, int, float]

    def __init__(
        self, path: Planned, at: int, row: tuple[int, int, str, float, int, int, float]
    ) -> None:
        self._owner = path
        self._at = at
        self._row = row

    def _document(self) -> _vides.Document:
        return self._owner._native

    def _prefix(self) -> str:
        return f"point.{self.point + 1}.view.{self.orientation + 1}."

    @property
    def point(self) -> int:
        """The point at which it begins."""
        return self._row[0]

    @property
    def orientation(self) -> int:
        """The orientation of that point with which it begins."""
        return self._row[1]

    @property
    def change(self) -> str:
        """What changes: ``"position"``, ``"view"``, ``"roll"``, ``"zoom"`` or ``"nothing"``."""
        return self._row[2]

    @property
    def amount(self) -> float:
        """By how much, in units of its base speed: half the edge of the space, half turns, …"""
        return self._row[3]

    @property
    def frames(self) -> int:
        """The number of frames; 0 if nothing changes.

        Assign a number to fix it, or 0 to compute it from length and speeds again.
        """
        return self._row[4]

    @frames.setter
    def frames(self, frames: SupportsIndex | None) -> None:
        self._put("frames", frames)
        self._row = self._document().sections()[self._at]

    @property
    def first_frame(self) -> int:
        """The first frame after the orientation with which it begins."""
        return self._row[5]

    @property
    def length(self) -> float:
        """Its length, in the world's lengths."""
        return self._row[6]

    def __repr__(self) -> str:
        return f"<vides.Section: {self.change} from point {self.point}, {self.frames} frames>"
