"""Flies a camera through a pyvista scene, off the screen: pyvista_flight.py FOLDER [FRAMES]"""

import sys
from pathlib import Path

import numpy as np
import pyvista

import vides


def main(folder: str, frames: int = 50) -> list[Path]:
    torus = pyvista.ParametricTorus(ringradius=2, crosssectionradius=0.5)
    torus["height"] = torus.points[:, 2]

    # Once through the ring and round it, looking at its middle; pyvista has z up.
    around = np.linspace(0, 2 * np.pi, 12, endpoint=False)
    points = np.stack([4 * np.cos(around), 1 + 3 * np.sin(around), 2 * np.sin(around)], axis=1)
    path = vides.Path(points, look_at=(0, 0, 0), up="z", closed=True, frames=frames)
    path.points[6].zoom = 50

    plotter = pyvista.Plotter(off_screen=True, window_size=[320, 240])
    plotter.add_mesh(torus, scalars="height", show_scalar_bar=False)
    written = path.render(plotter, folder)
    plotter.close()
    return written


if __name__ == "__main__":
    main(sys.argv[1], *map(int, sys.argv[2:]))
