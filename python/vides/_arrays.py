"""Checks arrays and other arguments, and converts them for the engine."""

from __future__ import annotations

import operator
import reprlib
from collections.abc import Sequence
from typing import Any, SupportsFloat, SupportsIndex, Union

import numpy as np
import numpy.typing as npt

from ._error import Invalid

Array = npt.NDArray[np.float64]
"""An array of doubles."""

Vector = Union[Sequence[float], npt.NDArray[np.floating]]
"""Three numbers: x, y, z."""


def doubles(values: npt.ArrayLike, shape: tuple[int | None, ...], name: str) -> Array:
    """Finite doubles, row by row; ``None`` in the shape allows any number."""
    if isinstance(values, np.ma.MaskedArray) and np.ma.getmaskarray(values).any():
        at = tuple(int(k) for k in np.argwhere(np.ma.getmaskarray(values))[0])
        raise Invalid(f"{name}{list(at)} is masked: remove masked values with compressed()")
    try:
        array = np.asarray(values)
    except ValueError as error:
        raise Invalid(f"{name}: {error}") from None
    if array.dtype.kind not in "fiu" and array.size > 0:
        raise TypeError(f"{name} must be real numbers, not {array.dtype}")
    fits = array.ndim == len(shape) and all(
        wanted in (None, there) for wanted, there in zip(shape, array.shape)
    )
    if not fits:
        wanted = ", ".join("n" if side is None else str(side) for side in shape)
        comma = "," if len(shape) == 1 else ""
        raise Invalid(f"{name} must have the shape ({wanted}{comma}), not {array.shape}")
    array = np.ascontiguousarray(array, dtype=np.float64)
    if not np.isfinite(array).all():
        at = tuple(int(k) for k in np.argwhere(~np.isfinite(array))[0])
        raise Invalid(f"{name}{list(at)} is {array[at]}: all numbers must be finite")
    return array


def count(value: SupportsIndex, name: str) -> int:
    """A whole number, at least 0; no bool."""
    try:
        if isinstance(value, (bool, np.bool_)):
            raise TypeError
        number = operator.index(value)
    except TypeError:
        raise TypeError(f"{name} must be a whole number, not {type(value).__name__}") from None
    if not 0 <= number < 2**31:
        raise Invalid(f"{name} must lie between 0 and {2**31 - 1}, not {number}", "range")
    return number


def number(value: SupportsFloat, name: str) -> float:
    """A number; no bool and no text."""
    if isinstance(value, (bool, np.bool_, str)) or not hasattr(type(value), "__float__"):
        raise TypeError(f"{name} must be a number, not {type(value).__name__}")
    try:
        return float(value)
    except OverflowError as error:
        raise Invalid(f"{name}: {error}", "range") from None


def str_of(value: object, name: str) -> str:
    """A text."""
    if not isinstance(value, str):
        raise TypeError(f"{name} must be a text, not {type(value).__name__}")
    return value


def str_or_none(value: object, name: str) -> str | None:
    """A text or ``None``."""
    return None if value is None else str_of(value, name)


def axis(value: object) -> str:
    """The name of the up axis."""
    if not isinstance(value, str):
        raise TypeError(f'up must be "y" or "z", not {reprlib.repr(value)}')
    return value


def vector(values: Vector, name: str) -> tuple[float, float, float]:
    """Three finite numbers."""
    x, y, z = doubles(values, (3,), name)
    return float(x), float(y), float(z)


def each(values: npt.ArrayLike, count: int, name: str) -> Array:
    """One finite number for each of ``count`` points; one for all is repeated."""
    if np.ndim(values) == 0:
        # An array without sides is a number, too.
        values = np.full(count, number(values, name))  # type: ignore[arg-type]
    return doubles(values, (count,), name)


def places(values: npt.ArrayLike, count: int, name: str) -> Array:
    """Places, one for all (1, 3) or one for each of ``count`` points."""
    array = np.asanyarray(values)
    if array.ndim < 2:
        return doubles(values, (3,), name)[np.newaxis]
    if array.ndim == 2 and array.shape[1] == 3 and len(array) != count:
        raise Invalid(f"{name} must be one place (3,) or one for each point ({count}, 3), not {array.shape}")
    return doubles(values, (count, 3), name)


def frozen(values: npt.ArrayLike) -> Array:
    """A copy that is read only: anything written into it would be lost silently."""
    array = np.array(values, dtype=np.float64)
    array.flags.writeable = False
    return array


def corners(values: npt.ArrayLike, width: int, name: str) -> list[Any]:
    """Indices of points, ``width`` in a row."""
    array = np.asarray(values)
    if array.size == 0:
        return []
    if array.ndim != 2 or array.shape[1] != width or array.dtype.kind not in "iu":
        raise Invalid(f"{name} must be whole numbers of the shape (n, {width}), not {array.dtype} {array.shape}")
    if array.min() < 0 or array.max() >= 2**32:
        raise Invalid(f"{name} must be indices of points, from 0", "range")
    rows: list[Any] = array.tolist()
    return rows
