"""What nerfstudio's own loader makes of camera paths; its tensors are 32-bit."""

import json
import math

import common
from nerfstudio.cameras.camera_paths import get_path_from_json


def work(job):
    with open(job["file"]) as file:
        path = json.load(file)
    cameras = get_path_from_json(path)
    frames = []
    for n in range(cameras.camera_to_worlds.shape[0]):
        fov = 2 * math.atan(float(cameras.cy[n, 0]) / float(cameras.fy[n, 0]))
        frames.append(common.frame(cameras.camera_to_worlds[n].double().numpy(), -1, math.degrees(fov)))
    # As `ns-render camera-path` computes its rate.
    return {"frames": frames, "fps": len(frames) / path["seconds"]}


common.run(work)
