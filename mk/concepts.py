"""Draws docs/start/concepts.svg: concepts.py FILE."""

import math
import sys

AXES, PATH, SECTION, INK, TARGET = "#9aa4b2", "#c77700", "#1f6fd6", "#1d2530", "#c62f2f"
out = []


def image(x, y, z):
    """Where a place of the space, [-1, 1] each, is in the picture."""
    turn, tilt = math.radians(28), math.radians(18)
    side, depth = x * math.cos(turn) + z * math.sin(turn), z * math.cos(turn) - x * math.sin(turn)
    up = y * math.cos(tilt) - depth * math.sin(tilt)
    scale = 172 / (1 + 0.12 * -depth)
    return 390 + 1.3 * scale * side, 190 - 0.85 * scale * up


def line(places, color, width=1.0, fill="none", dashed=False):
    points = " ".join(f"{x:.1f},{y:.1f}" for x, y in places)
    dash = ' stroke-dasharray="5 4"' if dashed else ""
    out.append(f'<polyline points="{points}" fill="{fill}" stroke="{color}" stroke-width="{width}"{dash}/>')


def text(x, y, words, color=INK, anchor="start"):
    out.append(f'<text x="{x:.1f}" y="{y:.1f}" fill="{color}" text-anchor="{anchor}">{words}</text>')


def hermite(a, b, m, n, t):
    h = (2 * t**3 - 3 * t**2 + 1, t**3 - 2 * t**2 + t, 3 * t**2 - 2 * t**3, t**3 - t**2)
    return [sum(w * v[k] for w, v in zip(h, (a, m, b, n))) for k in range(3)]


def camera(at, looks, color=INK):
    """A camera's outline, from its place towards another."""
    (x, y), (u, v) = image(*at), image(*looks)
    length = math.hypot(u - x, v - y)
    dx, dy = (u - x) / length, (v - y) / length
    ends = [(x + 38 * dx - s * 15 * dy, y + 38 * dy + s * 15 * dx) for s in (-1, 1)]
    line([(x, y), *ends, (x, y)], color, 1.5)
    return x + 38 * dx, y + 38 * dy


def main():
    corner = lambda k: image(*(1 if k >> i & 1 else -1 for i in range(3)))
    for a in range(8):
        for b in range(a + 1, 8):
            if (a ^ b).bit_count() == 1:
                line([corner(a), corner(b)], AXES, dashed=0b001 in (a, b))
    x, y = corner(0b110)
    text(x + 8, y + 20, "space", "#5b6573")

    points = [(-0.95, -0.1, 0.3), (-0.15, 0.45, 0.65), (0.85, 0.1, 0.2)]
    ends = [(0.5, 1.2, 0.2), (0.9, 0.1, 0.0), (0.8, -0.9, -0.6)]
    target = (0.05, -0.55, -0.1)
    for k, color in enumerate((PATH, SECTION)):
        curve = [image(*hermite(points[k], points[k + 1], ends[k], ends[k + 1], t / 60)) for t in range(61)]
        line(curve, color, 3)
        out.extend(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3.5" fill="{color}"/>' for x, y in curve[6:60:6])
        if k:
            x, y = curve[24]
            text(x + 40, y - 14, "section from point 2 to 3", SECTION)

    # The object: a small pyramid below its target.
    base = [(target[0] + i, -1.0, target[2] + j) for i, j in ((-0.3, -0.3), (0.3, -0.3), (0.3, 0.3), (-0.3, 0.3))]
    for i in range(4):
        line([image(*base[i]), image(*base[(i + 1) % 4]), image(*target), image(*base[i])], "#5b6573", 1, "#dfe5ec")
    x, y = image(*base[2])
    text(x + 8, y, "object")
    camera(points[0], (-0.4, -0.3, 0.75))
    for point in points[1:]:
        line([camera(point, target), image(*target)], INK, 1, dashed=True)
    x, y = image(*target)
    out.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="4.5" fill="{TARGET}"/>')
    text(x + 14, y + 5, "target of two views", TARGET)

    for place in points:
        x, y = image(*place)
        line([(x - 7, y), (x + 7, y)], INK, 2)
        line([(x, y - 7), (x, y + 7)], INK, 2)
    x, y = image(*points[0])
    text(x - 10, y - 12, "point 1", anchor="middle")
    text(x + 4, y + 38, "view in a direction", anchor="middle")
    x, y = image(*points[1])
    text(x - 6, y - 14, "point 2, with a hold", anchor="end")
    x, y = image(*points[2])
    text(x + 12, y + 5, "point 3")

    left, top, keys = 90, 446, (1, 61, 86, 161)
    at = lambda frame: left + 3.6 * (frame - 1)
    for (a, b), color in zip(zip(keys, keys[1:]), (PATH, AXES, SECTION)):
        line([(at(a), top), (at(b), top)], color, 8)
    for frame in keys:
        x = at(frame)
        line([(x, top - 8), (x + 6, top), (x, top + 8), (x - 6, top), (x, top - 8)], INK, 1, INK)
        text(x, top + 26, str(frame), anchor="middle")
    text(at(73.5), top - 12, "hold", anchor="middle")
    text(at(161) + 16, top + 5, "frames")

    with open(sys.argv[1], "w", encoding="utf-8") as file:
        file.write('<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 780 490" font-family="Ubuntu, sans-serif" '
                   'font-size="14" role="img" aria-label="A path with its parts named">\n'
                   '<rect width="780" height="490" fill="#fff"/>\n' + "\n".join(out) + "\n</svg>\n")


if __name__ == "__main__":
    main()
