"""Draws a surface along a path with matplotlib, in true perspective: matplotlib_surface.py FOLDER

matplotlib's own 3D axes know no place of a camera, only directions: here the points are
projected by the camera's matrix.
"""

import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import PolyCollection

import vides


def surface() -> np.ndarray:
    """(m, 4, 3): the corners of each patch, y up."""
    x, z = np.meshgrid(np.linspace(-2, 2, 41), np.linspace(-2, 2, 41))
    y = np.exp(-(x**2) - z**2) * np.cos(3 * x)
    grid = np.stack([x, y, z], axis=-1)
    corners = [grid[:-1, :-1], grid[1:, :-1], grid[1:, 1:], grid[:-1, 1:]]
    return np.stack(corners, axis=2).reshape(-1, 4, 3)


def main(folder: str, frames: int = 40) -> list[Path]:
    patches = surface()
    points = np.array([[3, 1.5, 3], [3, 2, -1], [0.5, 0.8, -1.2], [-2, 1, 1]])
    path = vides.Path(points, look_at=(0, 0.3, 0), frames=frames)

    samples = path.sample()
    world_to_camera = np.linalg.inv(samples.matrices("opencv"))
    # Half a picture's height is 1.
    scale = samples.zoom / 12
    written = []
    for number in range(0, len(samples), 10):
        turn, move = world_to_camera[number, :3, :3], world_to_camera[number, :3, 3]
        seen = patches @ turn.T + move
        depth = seen[..., 2]
        before = (depth > 0.05).all(axis=1)
        order = np.argsort(-depth[before].mean(axis=1))
        corners = seen[before][order]
        flat = scale[number] * corners[..., :2] / corners[..., 2:]
        heights = patches[before][order][..., 1].mean(axis=1)

        figure, axes = plt.subplots(figsize=(4, 3))
        axes.add_collection(PolyCollection(flat, array=heights, cmap="viridis", edgecolor="k", linewidth=0.1))
        # In OpenCV's picture y goes down.
        axes.set(xlim=(-4 / 3, 4 / 3), ylim=(1, -1), aspect="equal", xticks=[], yticks=[])
        file = Path(folder, f"surface-{number:04}.png")
        figure.savefig(file, dpi=100)
        plt.close(figure)
        written.append(file)
    return written


if __name__ == "__main__":
    main(sys.argv[1])
