"""Rotations of cameras between conventions, by numpy alone.

`looks` says which camera: −1 looks along −z with +y up (OpenGL, glTF, USD, Blender), 1 along +z with
−y up (OpenCV, COLMAP, TUM). Quaternions are w x y z.
"""

from dataclasses import dataclass

import numpy as np


@dataclass
class Poses:
    """Of n frames: `position`, `view`, `up` (n, 3), `fov` (n), vertical in degrees, None where there is none."""

    position: np.ndarray
    view: np.ndarray
    up: np.ndarray
    fov: np.ndarray | None

    @classmethod
    def of(cls, frames):
        """Of a list of dictionaries as the importers print them."""
        column = [np.array([frame[name] for frame in frames], float).reshape(-1, 3) for name in ("position", "view", "up")]
        fov = [frame.get("fov") for frame in frames]
        return cls(*column, None if None in fov else np.array(fov, float))

    def turned(self, way):
        """In axes in which another one is upright."""
        return Poses(*(turn(value, way) for value in (self.position, self.view, self.up)), self.fov)


def turn(values, way):
    x, y, z = np.moveaxis(np.asarray(values, float), -1, 0)
    return np.stack({"": (x, y, z), "yz": (x, -z, y), "zy": (x, z, -y)}[way], -1)


def unit(values):
    return values / np.linalg.norm(values, axis=-1, keepdims=True)


def rotation(view, up, looks):
    """Camera to world, (n, 3, 3)."""
    view = unit(view)
    up = unit(up - view * np.sum(up * view, -1, keepdims=True))
    right = np.cross(view, up)
    return np.stack([right, -looks * up, looks * view], -1)


def of_matrices(matrices):
    """The quaternion of each matrix, by the largest of its four numbers (Shepperd 1978)."""
    result = np.empty((len(matrices), 4))
    for out, m in zip(result, matrices):
        squares = [np.trace(m), m[0, 0], m[1, 1], m[2, 2]]
        at = int(np.argmax(squares))
        if at == 0:
            out[:] = [1 + squares[0], m[2, 1] - m[1, 2], m[0, 2] - m[2, 0], m[1, 0] - m[0, 1]]
        else:
            i, j, k = (at - 1) % 3, at % 3, (at + 1) % 3
            out[0] = m[k, j] - m[j, k]
            out[1 + i] = 1 + m[i, i] - m[j, j] - m[k, k]
            out[1 + j] = m[j, i] + m[i, j]
            out[1 + k] = m[k, i] + m[i, k]
    return unit(result)


def quaternions(view, up, looks):
    return of_matrices(rotation(view, up, looks))


def one_hemisphere(values):
    """Signs chosen so that neighbours lie on the same side."""
    flips = np.sum(values[1:] * values[:-1], -1) < 0
    signs = np.concatenate([[1], np.cumprod(np.where(flips, -1, 1))])
    return values * signs[:, None]


def to_matrices(values):
    """The rotation matrix of each quaternion."""
    w, x, y, z = np.moveaxis(unit(np.asarray(values, float)), -1, 0)
    rows = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ]
    return np.moveaxis(np.array(rows), (0, 1), (-2, -1))


def about(axis, angle):
    """The matrix of a turn about x, y or z."""
    half = np.asarray(angle, float) / 2
    values = np.zeros((*half.shape, 4))
    values[..., 0], values[..., 1 + "xyz".index(axis)] = np.cos(half), np.sin(half)
    return to_matrices(values)


def of_euler(angles, order):
    """Turns about x, y, z by `angles`, in radians; the first axis of the order is done first."""
    result = np.eye(3)
    for axis in order:
        result = about(axis, angles[..., "xyz".index(axis)]) @ result
    return result


def euler(matrices, order):
    """The angles about x, y and z for `of_euler`."""
    first, second, third = ("xyz".index(axis) for axis in order)
    sign = 1 if order in ("xyz", "yzx", "zxy") else -1
    # R = A(third) A(second) A(first): the entry (third, first) is −sign·sin of the second angle.
    result = np.empty((len(matrices), 3))
    result[:, second] = np.arcsin(np.clip(-sign * matrices[:, third, first], -1, 1))
    result[:, first] = np.arctan2(sign * matrices[:, third, second], matrices[:, third, third])
    result[:, third] = np.arctan2(sign * matrices[:, second, first], matrices[:, first, first])
    return result


def poses(matrices, looks, position=None, fov=None):
    """Of camera-to-world matrices, 4 by 4 or 3 by 3."""
    matrices = np.asarray(matrices, float)
    place = matrices[:, :3, 3] if position is None else np.asarray(position, float)
    return Poses(place, looks * matrices[:, :3, 2], -looks * matrices[:, :3, 1], fov)
