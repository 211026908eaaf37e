"""The results of the methods of a path, and lists of tools and properties."""

from __future__ import annotations

from typing import NamedTuple

from . import _vides


class Finding(NamedTuple):
    """Something that will look wrong in the film."""

    kind: str
    """The kind, a key of :attr:`Path.limits`."""
    first_frame: float
    """The first frame, from 1."""
    last_frame: float
    """The last frame."""
    point: int
    """The point at which the section begins."""
    orientation: int
    """The orientation of that point with which the section begins."""
    value: float
    """The worst value, in the unit of the limit."""
    limit: float
    """The limit, as in :attr:`Path.limits`."""
    text: str
    """The finding as a sentence."""
    remedy: str
    """What helps."""


class FitReport(NamedTuple):
    """How well a fitted path follows its poses, and what was found in them."""

    points: int
    """Points of the path."""
    poses: int
    """Poses of the recording."""
    position: tuple[float, float]
    """Greatest and RMS distance of the positions."""
    view: tuple[float, float]
    """Greatest and RMS angle of view and up, in degrees."""
    field_of_view: tuple[float, float]
    """Greatest and RMS deviation of the vertical field of view, in degrees."""
    noise: float
    """Estimated standard deviation of a coordinate's noise."""
    holds: int
    """Points at which the camera rests."""
    gaps: int
    """Times between poses that are more than five times as long as usual."""
    cuts: int
    """Poses at which the camera is suddenly elsewhere."""
    repeated: int
    """Poses at the time of the one before, which were dropped."""
    outliers: tuple[int, ...]
    """Indices of the poses that ``robust`` left out."""
    better: tuple[float, float, int] | None
    """Where more than a third of the poses became points: a tolerance and an angle that need at
    most half as many, and how many."""
    robust: tuple[int, int] | None
    """Where a few outliers cost at least a third of the points: how many ``robust`` leaves out, and
    the points that it then needs."""
    text: str
    """The report in sentences."""


class Property(NamedTuple):
    """A property of a path, a point, an orientation or a node."""

    owner: str
    """What has it: ``"path"``, ``"point"``, ``"view"`` (an orientation) or ``"node"``."""
    key: str
    """Its key in files; the attribute has no unit at the end."""
    does: str
    """What it is for."""
    kind: str
    """The type of its values."""
    unit: str
    """The unit of its numbers."""
    range: tuple[float, float] | None
    """The least and the greatest value, if they are fixed."""
    new: str
    """The default as in files; "" without a default."""


def properties() -> list[Property]:
    """All properties: rows of the table from which the attributes are made.

    >>> [(row.owner, row.unit, row.range) for row in properties() if row.key == "zoom_mm"]
    [('view', 'mm', (1.0, 2000.0)), ('node', 'mm', (1.0, 2000.0))]
    """
    return [Property(*row) for row in _vides.keys()]


class Rest(NamedTuple):
    """Where the camera rests after :meth:`Path.retime`, because curve or view has a kink there."""

    point: int
    """The point."""
    orientation: int
    """Its orientation."""
    limit: str
    """The limit that requires it: ``"acceleration"`` or ``"turning_acceleration"``."""


class Retimed(NamedTuple):
    """The result of :meth:`Path.retime`."""

    seconds: float
    """The new duration of the points, including holds."""
    rests: tuple[Rest, ...]
    """Where the camera rests because of a kink."""


class Detour(NamedTuple):
    """A part of a path that :meth:`Path.avoid` changed."""

    first: int
    """The point of the new path at which it begins."""
    last: int
    """The point of the new path at which it ends."""
    moved: int
    """The number of moved points."""
    inserted: int
    """The number of inserted points."""
    furthest: float
    """The greatest distance of these points from the path before."""


class Framed(NamedTuple):
    """The result of :meth:`Path.keep_in_picture`."""

    added: int
    """The number of points added to the curve."""
    tightest: float
    """The greatest share of the room within the margin that the object takes, at most 1."""
    loosest: float
    """The least share."""


class Steadied(NamedTuple):
    """The result of :meth:`Path.steady`."""

    furthest: float
    """The maximum distance that a position moved, in the world's lengths."""
    turned: float
    """The maximum angle that a view turned, in degrees."""


class SVG(str):
    """A picture as SVG text; notebooks display it.

    ``pathlib.Path("plot.svg").write_text(picture)`` saves it.
    """

    __slots__ = ()

    def _repr_svg_(self) -> str:
        return str(self)
