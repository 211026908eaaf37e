"""Draws docs/guides/clean-a-recording.svg, with a recording that it makes and the commands of that page:
clean.py VIDES FILE."""

import math
import random
import subprocess
import sys
import tempfile
from pathlib import Path

FPS, COUNT = 25, 250
RECORDED, FITTED, STEADY, INK = "#9aa4b2", "#c77700", "#1f6fd6", "#1d2530"
out = []


def recording():
    """A curve round the origin, carried by a hand (2 Hz) and measured with noise of 4 mm."""
    random.seed(5)
    rows = []
    for k in range(COUNT):
        turn = 1.6 * math.pi * k / COUNT
        hand = [0.012 * math.sin(4 * math.pi * k / FPS + phase) for phase in (0, 1, 2)]
        way = (1.5 * math.sin(turn), 0.2 * math.sin(2 * turn), math.cos(turn))
        place = [a + b + random.gauss(0, 0.004) for a, b in zip(way, hand)]
        rows.append([*place, *(-a for a in way), 0, 1, 0, 24])
    return rows


def line(places, color, width=1.5):
    points = " ".join(f"{x:.1f},{y:.1f}" for x, y in places)
    out.append(f'<polyline points="{points}" fill="none" stroke="{color}" stroke-width="{width}"/>')


def text(x, y, words, color=INK):
    out.append(f'<text x="{x:.1f}" y="{y:.1f}" fill="{color}">{words}</text>')


def speeds(poses):
    return [FPS * math.dist(a[:3], b[:3]) for a, b in zip(poses, poses[1:])]


def main():
    vides, file = sys.argv[1:]
    poses = recording()
    with tempfile.TemporaryDirectory() as folder:
        def run(*command):
            made = subprocess.run([Path(vides).resolve(), *command], cwd=folder, check=True, capture_output=True, text=True)
            return made.stdout, made.stderr

        rows = (" ".join(f"{number:.6f}" for number in pose) for pose in poses)
        Path(folder, "poses.txt").write_text("\n".join(rows) + "\n")
        _, told = run("fit", "poses.txt", "--tolerance", "0.02", "--angle", "1", "-o", "fitted.vid")
        run("steady", "fitted.vid", "--period", "1", "-o", "steady.vid")

        def sampled(name):
            numbers = [[float(word) for word in row.split()] for row in run("sample", name)[0].splitlines()
                       if not row.startswith("#")]
            return [row[-11:-1] if len(row) > 11 else row[-10:] for row in numbers]

        fitted, steady = sampled("fitted.vid"), sampled("steady.vid")
    print(told, file=sys.stderr)

    def above(pose):
        return 170 + 95 * pose[0], 150 + 95 * pose[2]

    for pose in poses[::2]:
        x, y = above(pose)
        out.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="1.6" fill="{RECORDED}"/>')
    line(map(above, fitted), FITTED)
    line(map(above, steady), STEADY)
    text(24, 24, "from above")
    text(360, 24, "speed over time")
    most = max(speeds(poses))
    for path, color, width in ((poses, RECORDED, 0.8), (fitted, FITTED, 1.5), (steady, STEADY, 1.8)):
        line(((360 + 400 * k / COUNT, 270 - 230 * speed / most) for k, speed in enumerate(speeds(path))), color, width)
    for k, (words, color) in enumerate((("recorded", RECORDED), ("fitted", FITTED), ("steady", STEADY))):
        text(500 + 90 * k, 24, words, color)
    Path(file).write_text(
        '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 780 290" font-family="Ubuntu, sans-serif" '
        'font-size="14">\n<rect width="780" height="290" fill="#fff"/>\n' + "\n".join(out) + "\n</svg>\n")


main()
