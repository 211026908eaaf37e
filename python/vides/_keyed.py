"""Attributes for the properties in the engine's table."""

from __future__ import annotations

import difflib
import functools
import operator
import re
from typing import TYPE_CHECKING, Any, SupportsIndex

from . import _vides
from ._arrays import str_of
from ._error import Error, NoIndex


def index_of(at: SupportsIndex, count: int, what: str) -> int:
    """The index from 0; negative ones count from the end."""
    number = operator.index(at)
    if not -count <= number < count:
        raise NoIndex(f"there is no {what} {number}: there are {count}, counted from 0", "range")
    return number % count


def place_of(at: SupportsIndex, count: int) -> int:
    """The index before which to insert into ``count`` items, counted as by ``list.insert``."""
    number = operator.index(at)
    if not -count <= number <= count:
        raise NoIndex(f"there is no place {number}: there are {count}, counted from 0", "range")
    return number + count if number < 0 else number


def bare_keys(*owners: str) -> list[str]:
    """The keys of paths, points or views, without units."""
    rows = _vides.keys()
    return [re.sub("_(mm|degrees|frames)$", "", row[1]) for row in rows if row[0] in owners]


@functools.cache
def _texts() -> frozenset[str]:
    return frozenset(row[1] for row in _vides.keys() if row[3] == "text")


class Keyed:
    """What has properties by name. Unknown names raise ``AttributeError`` with a suggestion."""

    __slots__ = ()

    def _document(self) -> _vides.Document:
        raise NotImplementedError

    def _prefix(self) -> str:
        """What is before a key in the engine's name of a property."""
        raise NotImplementedError

    def _get(self, name: str) -> Any:
        return self._document().property(self._prefix() + str_of(name, "name"))

    def _parts(self, name: str) -> Any:
        """A property that has parts, by their names."""
        keys = [key for key, _ in self._document().properties() if key.startswith(f"{name}.")]
        return {key[len(name) + 1 :]: self._get(key) for key in keys}

    def _put(self, name: str, value: object) -> None:
        """Sets a property; ``None`` restores the default."""
        if not isinstance(value, (str, type(None))) and str_of(name, "name") in _texts():
            raise TypeError(f"{name} must be a text, not {type(value).__name__}")
        try:
            self._document().set_property(self._prefix() + name, value)
        except Error as error:
            # In files points count from 1.
            sentence = str(error).removeprefix(self._prefix())
            place = name if error.place == self._prefix() + name else error.place
            raise type(error)(sentence, error.kind, place, error.line) from None

    if not TYPE_CHECKING:
        # Checkers of types would believe that every name exists.

        def __getattr__(self, name: str) -> Any:
            if name.startswith("_"):
                raise AttributeError(f"{type(self).__name__} has no {name}")
            raise self._unknown(name)

        def __setattr__(self, name: str, value: Any) -> None:
            if not hasattr(type(self), name):
                raise self._unknown(name)
            object.__setattr__(self, name, value)

    def _unknown(self, name: str) -> AttributeError:
        kind = type(self).__name__
        if kind == "Path" and name in bare_keys("point", "view"):
            return AttributeError(f"{kind} has no {name}: its points have", name=name, obj=self)
        near = difflib.get_close_matches(name, dir(self), 1, 0.7)
        meant = f": is {near[0]} meant?" if near else "; dir() lists what it has"
        return AttributeError(f"{kind} has no {name}{meant}", name=name, obj=self)

    def __eq__(self, other: object) -> bool:
        """Whether both are the same item of the same path."""
        return (
            type(other) is type(self)
            and isinstance(other, Keyed)
            and other._document() is self._document()
            and other._prefix() == self._prefix()
        )

    def __hash__(self) -> int:
        return hash((id(self._document()), self._prefix()))
