"""Arrays as they are given: checked, and made what the engine takes."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Union

import numpy as np
import numpy.typing as npt

from ._error import Error

Array = npt.NDArray[np.float64]
"""An array of doubles."""

Vector = Union[Sequence[float], npt.NDArray[np.floating]]
"""Three numbers: x, y, z."""


def doubles(values: npt.ArrayLike, shape: tuple[int | None, ...], name: str) -> Array:
    """Finite doubles row by row; ``None`` in the shape is any number."""
    try:
        array = np.asarray(values)
    except ValueError as error:
        raise Error(f"{name}: {error}") from None
    if array.dtype.kind not in "fiu" and array.size > 0:
        raise TypeError(f"{name} must be real numbers, not {array.dtype}")
    fits = array.ndim == len(shape) and all(
        wanted in (None, there) for wanted, there in zip(shape, array.shape)
    )
    if not fits:
        wanted = ", ".join("n" if side is None else str(side) for side in shape)
        comma = "," if len(shape) == 1 else ""
        raise Error(f"{name} must have the shape ({wanted}{comma}), not {array.shape}")
    array = np.ascontiguousarray(array, dtype=np.float64)
    if not np.isfinite(array).all():
        at = tuple(int(k) for k in np.argwhere(~np.isfinite(array))[0])
        raise Error(f"{name}{list(at)} is {array[at]}: all numbers must be finite")
    return array


def vector(values: Vector, name: str) -> tuple[float, float, float]:
    """Three finite numbers."""
    x, y, z = doubles(values, (3,), name)
    return float(x), float(y), float(z)


def frozen(values: npt.ArrayLike) -> Array:
    """A copy that cannot be written into, since what is written would be lost without a word."""
    array = np.array(values, dtype=np.float64)
    array.flags.writeable = False
    return array
