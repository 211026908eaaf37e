"""Draws docs/theory/joints.svg with the engine of tests/oracles (pip install mpmath): joints.py FILE."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "tests/oracles"))

from reference import Path as Flight, SpeedCurve  # noqa: E402
from reference_cases import path, point, view  # noqa: E402

AROUND = 45  # frames about the joint
FACING, JOINED, INK, AXES = "#c77700", "#1f6fd6", "#1d2530", "#9aa4b2"
WIDTH, HEIGHT, LEFT, TOP = 340, 190, 40, 50
out = []


def text(x, y, words, color=INK, anchor="start"):
    out.append(f'<text x="{x:.1f}" y="{y:.1f}" fill="{color}" text-anchor="{anchor}">{words}</text>')


def line(places, color, width=1.8):
    points = " ".join(f"{x:.1f},{y:.1f}" for x, y in places)
    out.append(f'<polyline points="{points}" fill="none" stroke="{color}" stroke-width="{width}"/>')


def course(curves, works):
    """Frames from the joint, speeds and their changes per frame, of each section."""
    found, start = [], -float(works[0] / curves[0].mean)
    for curve, work in zip(curves, works):
        frames = float(work / curve.mean)
        rows = []
        for k in range(181):
            j, x = min(k // 20, 8), k / 20 - min(k // 20, 8)
            v, m = [float(a) for a in curve.v[j:j + 2]], [float(a) / 9 for a in curve.m[j:j + 2]]
            c, d = 3 * (v[1] - v[0]) - 2 * m[0] - m[1], 2 * (v[0] - v[1]) + m[0] + m[1]
            rows.append((start + frames * k / 180, v[0] + x * (m[0] + x * (c + x * d)),
                         9 * (m[0] + x * (2 * c + 3 * x * d)) / frames))
        found.append([row for row in rows if abs(row[0]) <= AROUND])
        start += frames
    return found


def main():
    ramps = [[20 + 10 * k / 3 for k in range(10)], [50 + 10 * k / 3 for k in range(10)], [50] * 10]
    case = path("ramp", "", [point((0.7 * k, 0, 0), view(speeds=ten)) for k, ten in enumerate(ramps)])
    sections = Flight(case).sections
    works = [s.work for s in sections]
    facing = [SpeedCurve(ramps[0], None, 50), SpeedCurve(ramps[1], 50, None)]
    courses = ((course(facing, works), FACING), (course([s.curve for s in sections], works), JOINED))
    first, last = -AROUND, AROUND
    for panel, (words, column, least, most) in enumerate((("speed", 1, 30, 80), ("change of the speed per frame", 2, 0, 0.8))):
        left = LEFT + panel * (WIDTH + 60)

        def place(frame, value):
            return left + WIDTH * (frame - first) / (last - first), TOP + HEIGHT * (most - value) / (most - least)

        line([place(first, most), place(first, least), place(last, least)], AXES, 1)
        line([place(0, most), place(0, least)], AXES, 0.6)
        text(left, TOP - 14, words)
        for value in (least, (least + most) / 2, most):
            text(left - 6, place(first, value)[1] + 5, f"{value:g}", AXES, "end")
        text(place(0, least)[0], TOP + HEIGHT + 20, "joint", AXES, "middle")
        for sections_of, color in courses:
            for rows in sections_of if column == 2 else [sum(sections_of, [])]:
                line([place(row[0], row[column]) for row in rows], color)
    text(LEFT + 130, TOP - 14, "by facing speeds", FACING)
    text(LEFT + 255, TOP - 14, "joined", JOINED)
    width, height = LEFT + 2 * WIDTH + 80, TOP + HEIGHT + 34
    Path(sys.argv[1]).write_text(
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" font-family="Ubuntu, sans-serif" '
        f'font-size="14">\n<rect width="{width}" height="{height}" fill="#fff"/>\n' + "\n".join(out) + "\n</svg>\n")
    ends = [[(rows[0][2], rows[-1][2]) for rows in c] for c, _ in courses]
    print("at the joint, per frame: by facing speeds %.4f, %.4f; joined %.4f, %.4f"
          % (ends[0][0][1], ends[0][1][0], ends[1][0][1], ends[1][1][0]), file=sys.stderr)


main()
