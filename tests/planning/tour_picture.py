"""Draws the way of tours and what they show: tour_picture.py VIDES OUT.png MESH.ply TOUR.vid …"""

import subprocess
import sys

import numpy as np
import pyvista

pyvista.OFF_SCREEN = True
vides, out, pairs = sys.argv[1], sys.argv[2], sys.argv[3:]
ROWS, SHOWN = len(pairs) // 2, 5
picture = pyvista.Plotter(shape=(ROWS, SHOWN + 1), window_size=(1200, 135 * ROWS), border=False)
for row in range(ROWS):
    mesh, path = pyvista.read(pairs[2 * row]), pairs[2 * row + 1]
    text = subprocess.run([vides, "sample", path], capture_output=True, text=True, check=True).stdout
    lines = [line.split() for line in text.splitlines() if line and not line.startswith("#")]
    poses = np.array([[float(number) for number in line] for line in lines])[:, -10:]
    middle = (np.array(mesh.bounds[::2]) + np.array(mesh.bounds[1::2])) / 2
    far = np.linalg.norm(poses[:, :3] - middle, axis=1).max()
    for column in range(SHOWN + 1):
        picture.subplot(row, column)
        picture.add_mesh(mesh, color="tan")
        camera = picture.camera
        if column == 0:
            way = np.vstack([poses[:, :3], poses[:1, :3]])
            picture.add_mesh(pyvista.lines_from_points(way), color="firebrick", line_width=2)
            camera.position, camera.focal_point = middle + far * np.array([1.3, 1.2, 1.7]), middle
            camera.up, camera.view_angle = (0, 1, 0), 50
        else:
            pose = poses[(column - 1) * len(poses) // SHOWN]
            camera.position, camera.focal_point = pose[:3], pose[:3] + pose[3:6]
            camera.up, camera.view_angle = pose[6:9], 2 * np.degrees(np.arctan(12 / pose[9]))
        camera.clipping_range = (1e-3 * far, 20 * far)
picture.screenshot(out)
