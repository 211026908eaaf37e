"""Makes a path of few points of a recording in the TUM format: tum_fit.py FOLDER [RECORDING.txt]"""

import sys
from pathlib import Path

import numpy as np

import vides


def recording(file: Path) -> None:
    """A hand-held flight through a room: 'seconds x y z qx qy qz qw' a line, with some noise."""
    points = np.random.default_rng(4).uniform(-2, 2, (8, 3))
    samples = vides.Path(points, look_at=(0, 0, 0), frames=600, fps=30).sample()
    noise = np.random.default_rng(5).normal(0, 0.002, (600, 3))
    # TUM's cameras look along z, with y down, as OpenCV's.
    half_turn_about_z = np.array([0.0, 0.0, 0.0, 1.0])
    w, x, y, z = samples.quaternions.T
    a, b, c, d = half_turn_about_z
    turned = [
        w * a - x * b - y * c - z * d,
        w * b + x * a + y * d - z * c,
        w * c - x * d + y * a + z * b,
        w * d + x * c - y * b + z * a,
    ]
    rows = np.column_stack([samples.seconds, samples.positions + noise, *turned[1:], turned[0]])
    np.savetxt(file, rows, fmt="%.9f", header="timestamp tx ty tz qx qy qz qw")


def main(folder: str, file: str | None = None) -> vides.Path:
    if file is None:
        file = str(Path(folder, "recording.txt"))
        recording(Path(file))
    recorded = vides.Samples.load(file, format="tum", fps=30)
    path = vides.Path.fit(recorded, tolerance=0.02, angle=1)
    # Its times are rounded: the last one may lie a hair behind the path's last frame.
    flown = path.evaluate(recorded.frames.clip(1, path.frame_count))
    off = np.linalg.norm(flown.positions - recorded.positions, axis=1)
    print(f"{len(recorded)} poses are now {len(path.points)} points, at most {off.max():.4f} off")
    path.save(Path(folder, "fitted.vid"))
    return path


if __name__ == "__main__":
    main(*sys.argv[1:])
