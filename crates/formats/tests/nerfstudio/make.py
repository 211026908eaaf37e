"""Makes open.json and closed.json: files as the viewer of nerfstudio 1.1.5 saves them.

The camera path is what nerfstudio/viewer/render_panel.py computes, by the same libraries:
pip install splines scipy numpy
"""

import json
from pathlib import Path

import numpy as np
from scipy.interpolate import PchipInterpolator
from scipy.spatial.transform import Rotation
from splines import KochanekBartels
from splines.quaternion import KochanekBartels as Turning, UnitQuaternion

FPS, DEFAULT = 10, 2.0
PLACES = np.array([[1, 0, 0.2], [0.3, 0.9, 0.3], [-0.8, 0.6, 0.5], [-0.7, -0.7, 0.2], [0.4, -0.9, 0.1]])
TURNS = [Rotation.from_euler("xz", [80, angle], degrees=True) for angle in (90, 150, 230, 310, 370)]
FIELDS = [60.0, 50.0, 55.0, 70.0, 60.0]
SECONDS = [2.0, 1.0, None, 3.0, 1.5]


def camera(name, place, turn, field, digits):
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = turn.as_matrix(), place
    return {name: matrix.round(digits).flatten().tolist(), "fov": round(float(field), 4), "aspect": 16 / 9}


def make(name, loop, tension):
    steps = [DEFAULT if step is None else step for step in SECONDS]
    times = np.cumsum([0.0, *steps[1:]])
    shape = {"tcb": (tension, 0, 0), "endconditions": "closed" if loop else "natural"}
    if loop:
        times = np.append(times, times[-1] + steps[0])
        knots = np.concatenate([[times[-2] - times[-1]], times, [times[-1] + times[1]]])
        parameter = PchipInterpolator(knots, np.arange(-1, len(times) + 1))
    else:
        parameter = PchipInterpolator(times, np.arange(len(times)))
    places, fields = KochanekBartels(PLACES, **shape), KochanekBartels(FIELDS, **shape)
    turns = Turning([UnitQuaternion.from_unit_xyzw(turn.as_quat()) for turn in TURNS], **shape)

    def frame(index):
        t = min(float(parameter(index / FPS)), len(times) - 1)
        turn = turns.evaluate(t)
        turn = Rotation.from_quat([*turn.vector, turn.scalar])
        return camera("camera_to_world", places.evaluate(t), turn, fields.evaluate(t), 7)

    keys = [camera("matrix", *key, 12) for key in zip(PLACES, TURNS, FIELDS)]
    for key, step in zip(keys, SECONDS):
        key |= {"override_transition_enabled": step is not None, "override_transition_sec": step}
    # The viewer leaves out the last frame, in which the camera arrives.
    path = [frame(index) for index in range(round(times[-1] * FPS) + 1)]
    document = {
        "default_fov": 60.0,
        "default_transition_sec": DEFAULT,
        "keyframes": keys,
        "camera_type": "perspective",
        "render_height": 1080,
        "render_width": 1920,
        "fps": FPS,
        "seconds": float(times[-1]),
        "is_cycle": loop,
        "smoothness_value": tension,
        "camera_path": path,
    }
    Path(__file__).with_name(f"{name}.json").write_text(json.dumps(document) + "\n")


make("open", False, 0.3)
make("closed", True, 0.0)
