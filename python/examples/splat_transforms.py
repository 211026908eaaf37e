"""Makes transforms.json of a flight, as trainers of splats and radiance fields read it:
splat_transforms.py FOLDER [FLIGHT.vid]"""

import json
import sys
from pathlib import Path

import numpy as np

import vides


def main(folder: str, flight: str | None = None) -> Path:
    if flight is None:
        # Two rounds at two heights, looking at what is to be learned.
        around = np.linspace(0, 4 * np.pi, 24)
        height = np.where(around < 2 * np.pi, 0.5, 1.5)
        points = np.stack([2 * np.cos(around), 2 * np.sin(around), height], axis=1)
        path = vides.Path(points, look_at=(0, 0, 0.5), up="z", frames=120)
    else:
        path = vides.Path.load(flight)
    file = Path(folder, "transforms.json")
    for loss in path.save(file, size=(800, 600)):
        print("not in the file:", loss)

    # What stands there are the matrices with the axes of OpenGL; add where your pictures lie.
    content = json.loads(file.read_text())
    for number, frame in enumerate(content["frames"]):
        frame["file_path"] = f"images/{number:04}.png"
    file.write_text(json.dumps(content, indent=1))
    return file


if __name__ == "__main__":
    print(main(*sys.argv[1:]))
