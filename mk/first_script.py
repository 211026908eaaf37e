"""Draws docs/start/first-script.svg, what path.plot() shows of that page's path: first_script.py VIDES FILE."""

import math
import subprocess
import sys
import tempfile
from pathlib import Path


def main(vides, file):
    lines = ["version = 1", "closed = true"]
    for k in range(8):
        angle = k * math.pi / 4
        place = [3 * math.cos(angle), 1 + 0.3 * math.sin(2 * angle), 3 * math.sin(angle)]
        lines += ["[[point]]", f"position = {place}", "[[point.orientation]]", "target = [0.0, 0.0, 0.0]"]
    space = ["[space]", "centre = [0.0, 1.0, 0.0]", "half_size = 3.5"]
    with tempfile.TemporaryDirectory() as folder:
        path, exact = Path(folder) / "ring.vid", Path(folder) / "orbit.vid"
        path.write_text("\n".join(lines[:2] + space + lines[2:]) + "\n")
        subprocess.run([vides, "frames", path, "250", "-o", exact], check=True)
        subprocess.run([vides, "plot", exact, "-o", file], check=True)


if __name__ == "__main__":
    main(*sys.argv[1:])
