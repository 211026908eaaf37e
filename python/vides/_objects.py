"""Objects: files, meshes of other libraries, arrays."""

from __future__ import annotations

import os
from typing import Any, Protocol, Union

import numpy as np
import numpy.typing as npt

from ._arrays import Array, corners, doubles
from ._error import Invalid
from ._files import path_of


class _HasFaces(Protocol):
    """A mesh as of trimesh or Open3D's tensors."""

    @property
    def vertices(self) -> Any: ...
    @property
    def faces(self) -> Any: ...


class _HasPoints(Protocol):
    """A mesh as of pyvista."""

    @property
    def points(self) -> Any: ...
    @property
    def faces(self) -> Any: ...


Object = Union[str, "os.PathLike[str]", tuple[npt.ArrayLike, npt.ArrayLike], _HasFaces, _HasPoints]
"""The file of a mesh (OBJ, PLY, STL, glTF), a ``.vid`` file with an object, a mesh of trimesh
(``vertices``, ``faces``) or pyvista (``points``, ``faces``), or vertices (n, 3) and triangles (m, 3)
of their indices. Without triangles, the vertices are the object."""

Mesh = tuple[Array, list[list[int]]]
"""Vertices and triangles for the engine."""


def given(object: Object) -> str | Mesh:
    """An object for the engine: the name of a file, or vertices and triangles."""
    if isinstance(object, (str, os.PathLike)):
        return path_of(object)
    found = mesh(object)
    if found is None:
        kind = type(object).__name__
        raise TypeError(
            f"an object is a file, a mesh of trimesh or pyvista, or vertices and triangles, not {kind}"
        )
    return found


def mesh(object: Any) -> Mesh | None:
    """Vertices and triangles of a mesh; ``None`` if it is none."""
    if isinstance(object, (tuple, list)):
        if len(object) != 2:
            raise Invalid(f"an object has vertices and triangles, two arrays, not {len(object)}")
        return doubles(object[0], (None, 3), "vertices"), corners(object[1], 3, "triangles")
    faces = getattr(object, "faces", None)
    vertices = getattr(object, "vertices", None)
    if vertices is None:
        vertices = getattr(object, "points", None)
    if faces is None or vertices is None:
        return None
    triangles = np.asarray(faces)
    if triangles.ndim == 1:
        triangles = _triangles(triangles)
    return doubles(np.asarray(vertices), (None, 3), "vertices"), corners(triangles, 3, "triangles")


def _triangles(faces: npt.NDArray[Any]) -> npt.NDArray[Any]:
    """Fans of triangles, of faces in one row as pyvista has them: a number of corners, and those."""
    rows: list[tuple[int, int, int]] = []
    at = 0
    while at < len(faces):
        count = int(faces[at])
        face = [int(corner) for corner in faces[at + 1 : at + 1 + count]]
        if count < 3 or len(face) < count:
            raise Invalid(f"faces[{at}] is {count}: it must be the number of corners that follow, at least 3")
        rows += [(face[0], face[k], face[k + 1]) for k in range(1, count - 1)]
        at += count + 1
    return np.array(rows, dtype=np.int64).reshape(-1, 3)
