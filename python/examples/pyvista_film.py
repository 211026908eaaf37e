"""Makes a film of an orbit with pyvista and imageio: pyvista_film.py FLIGHT.gif [SECONDS]

A name that ends with .mp4 needs imageio-ffmpeg."""

import sys
import tempfile
from pathlib import Path

import imageio.v3 as imageio
import pyvista

import vides


def main(film: str, seconds: float = 4) -> Path:
    torus = pyvista.ParametricTorus(ringradius=2, crosssectionradius=0.5)
    path = vides.Path.orbit(object=torus, up="z", seconds=seconds, fps=20)
    plotter = pyvista.Plotter(off_screen=True, window_size=[320, 240])
    plotter.add_mesh(torus, color="orange")
    with tempfile.TemporaryDirectory() as folder:
        files = path.render(plotter, folder)
        imageio.imwrite(film, [imageio.imread(file) for file in files], duration=1000 / path.fps, loop=0)
    plotter.close()
    return Path(film)


if __name__ == "__main__":
    main(sys.argv[1], *map(float, sys.argv[2:]))
