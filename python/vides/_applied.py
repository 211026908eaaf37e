"""How the tools of the engine's table are called."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from . import _vides
from ._arrays import axis, count, doubles, number, str_of
from ._keyed import index_of
from ._objects import Object, given
from ._planned import Planned

if TYPE_CHECKING:
    from typing_extensions import Self

    from ._path import Path


def _numbers(values: dict[str, Any]) -> dict[str, Any]:
    """Parameters for the engine: numbers, lists of them, names; without those that are ``None``."""
    made: dict[str, Any] = {}
    for name, value in values.items():
        called = name + "_" if name == "from" else name
        if name in ("axis", "about"):
            made[name] = str_of(value, called)
        elif isinstance(value, (bool, np.bool_)):
            made[name] = bool(value)
        elif name == "times":
            made[name] = count(value, called)
        elif name == "lattice":
            made[name] = doubles(value, (4, 4, 4, 3), called).ravel().tolist()
        elif name in ("around", "at", "by") and value is not None:
            made[name] = doubles(value, (3,), called).tolist()
        elif value is not None:
            made[name] = number(value, called)
    return made


class Applied(Planned):
    """Calls tools by name; the methods of the tools give names to their parameters."""

    __slots__ = ()

    @classmethod
    def _of(cls, native: _vides.Document) -> Self:
        raise NotImplementedError

    @classmethod
    def _made(cls, name: str, values: dict[str, Any], object: Object | None, up: str | None, fps: float) -> Self:
        native = _vides.made(
            name,
            _numbers(values),
            None if object is None else given(object),
            None if up is None else axis(up),
            number(fps, "fps"),
        )
        return cls._of(native)

    def _apply(self, name: str, values: dict[str, Any], other: Path | None = None) -> None:
        points = self._native.point_count()
        # The table counts points from 1.
        ends: dict[str, Any] = {
            key: index_of(values.pop(key), points, "point") + 1
            for key in ("first", "last")
            if key in values
        }
        native = native_of(other, "other") if name == "blend" else None
        _vides.apply(self._native, name, {**_numbers(values), **ends}, native)


def native_of(path: object, name: str) -> _vides.Document:
    """The engine's part of a path."""
    if not isinstance(path, Applied):
        raise TypeError(f"{name} must be a Path, not {type(path).__name__}")
    return path._native
