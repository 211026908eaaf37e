"""What COLMAP's own reader (pycolmap) makes of text models: images by their names."""

import math

import common
import numpy as np
import pycolmap


def work(job):
    model = pycolmap.Reconstruction(job["file"])
    frames = []
    for image in sorted(model.images.values(), key=lambda image: image.name):
        away = image.cam_from_world
        away = away() if callable(away) else away
        matrix = np.eye(4)
        matrix[:3] = away.inverse().matrix()
        camera = model.cameras[image.camera_id]
        focal = camera.focal_length_y
        frames.append(common.frame(matrix, 1, math.degrees(2 * math.atan(camera.height / 2 / focal))))
    return {"frames": frames}


common.run(work)
