"""What a path tells of itself, and what there is to be used with it."""

from __future__ import annotations

import keyword
from typing import NamedTuple

from . import _vides


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
        name = name + "_" if keyword.iskeyword(name) else name
        numbers = "" if width == 1 else f", {width} numbers"
        return name, does + (f" ({unit})" if unit else "") + numbers

    return [
        Tool(name, does, block, dict(row(*parameter) for parameter in parameters))
        for name, does, block, parameters in _vides.tools()
    ]


class Property(NamedTuple):
    """A property of a path, a point, an orientation or a node."""

    owner: str
    """What has it: ``"path"``, ``"point"``, ``"view"``, an orientation, or ``"node"``."""
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
    new: str
    """What a new one has, as files write it; empty if nothing is set."""


def properties() -> list[Property]:
    """What there is to be set by its name, as the engine's table has it.

    >>> [(row.owner, row.unit, row.range) for row in properties() if row.key == "zoom_mm"]
    [('view', 'mm', (1.0, 2000.0)), ('node', 'mm', (1.0, 2000.0))]
    """
    return [Property(*row) for row in _vides.keys()]


class Rest(NamedTuple):
    """Where a pace that :meth:`Path.retime` computed rests, since curve or view has a kink there."""

    point: int
    """The point."""
    orientation: int
    """Its orientation."""
    limit: str
    """What does not allow to pass it: ``"acceleration"`` or ``"turning-acceleration"``."""


class Retimed(NamedTuple):
    """What :meth:`Path.retime` did."""

    seconds: float
    """How long the points take now, holds included."""
    rests: tuple[Rest, ...]
    """Where the pace rests though nobody asked for it."""


class Detour(NamedTuple):
    """A part of a path that :meth:`Path.avoid` made another way."""

    first: int
    """The point of the new path from which the way is new."""
    last: int
    """The point where it is the old one again."""
    moved: int
    """Points that were moved."""
    inserted: int
    """Points that were put in."""
    furthest: float
    """The farthest that any of these is from where the way was."""


class Framed(NamedTuple):
    """What :meth:`Path.keep_in_picture` did."""

    added: int
    """Points that were added to the curve."""
    tightest: float
    """The greatest share of the room within the margin that the object takes: at most 1."""
    loosest: float
    """The least share."""


class Steadied(NamedTuple):
    """What :meth:`Path.steady` did."""

    furthest: float
    """How far a place went at most, in the world's lengths."""
    turned: float
    """Degrees that a view turned at most."""


class SVG(str):
    """A picture as SVG text, which a notebook shows.

    ``pathlib.Path("plot.svg").write_text(picture)`` keeps it.
    """

    __slots__ = ()

    def _repr_svg_(self) -> str:
        return str(self)
