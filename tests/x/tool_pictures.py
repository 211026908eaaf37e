"""A picture of every tool for docs/reference/tools.md: tool_pictures.py VIDES OUT.svg

Each cell shows the path before in grey and what the tool makes of it in colour, with
some of the views, seen from one corner of the space.
"""

import csv
import io
import math
import os
import random
import subprocess
import sys
import tempfile

COLUMNS = 5
CELL = 190, 178
SCALE = 58
TURN, TILT = math.radians(28), math.radians(24)
MOVES = ("orbit", "spiral", "arc", "flyby", "approach", "dolly-zoom", "crane", "pan",
         "figure-eight")


class Cells:
    """Runs the command, and draws what comes of it."""

    def __init__(self, vides, folder):
        self.vides, self.folder = vides, folder
        self.cells = []

    def made(self, name, *arguments):
        """A path that the command makes."""
        file = os.path.join(self.folder, name + ".vid")
        subprocess.run([self.vides, *arguments, "-o", file], check=True)
        return file

    def poses(self, file):
        """The poses of a path: place and view."""
        text = subprocess.run([self.vides, "sample", file, "--format", "csv"], check=True,
                              capture_output=True, text=True).stdout
        lines = (line for line in io.StringIO(text) if not line.startswith("#"))
        rows = [list(map(float, row[1:11])) for row in list(csv.reader(lines))[1:]]
        return [(row[:3], row[3:6]) for row in rows]

    def add(self, name, after, before=None, dots=()):
        """A cell with a path, what it was before, and places that were given."""
        number = len(self.cells)
        left, top = number % COLUMNS * CELL[0], number // COLUMNS * CELL[1]
        middle = left + CELL[0] / 2, top + CELL[1] / 2 + 6

        def seen(place):
            x, y, z = place
            right = x * math.cos(TURN) + z * math.sin(TURN)
            depth = z * math.cos(TURN) - x * math.sin(TURN)
            down = depth * math.sin(TILT) - y * math.cos(TILT)
            return f"{middle[0] + SCALE * right:.1f},{middle[1] + SCALE * down:.1f}"

        def line(places, look):
            points = " ".join(seen(place) for place in places)
            return f'<polyline points="{points}" {look}/>'

        shapes = [f'<text x="{left + 10}" y="{top + 18}">{name}</text>',
                  line([(-1, -0.5, -1), (1, -0.5, -1), (1, -0.5, 1), (-1, -0.5, 1),
                        (-1, -0.5, -1)], 'class="floor"')]
        if before:
            shapes.append(line([place for place, _ in self.poses(before)][::3], 'class="before"'))
        shapes += [f'<circle cx="{x}" cy="{y}" r="1.1" class="dot"/>'
                   for x, y in (seen(place).split(",") for place in dots)]
        poses = self.poses(after)
        step = max(1, len(poses) // 14)
        for place, view in poses[::step]:
            end = [place[k] + 0.22 * view[k] for k in range(3)]
            shapes.append(line([place, end], 'class="view"'))
        thin = max(1, len(poses) // 150)
        kept = [place for place, _ in poses[:-1:thin]] + [poses[-1][0]]
        shapes.append(line(kept, 'class="after"'))
        x, y = seen(poses[0][0]).split(",")
        shapes.append(f'<circle cx="{x}" cy="{y}" r="2.6" class="begin"/>')
        self.cells.append("\n".join(shapes))

    def write(self, file):
        """All of them."""
        width = COLUMNS * CELL[0]
        height = -(-len(self.cells) // COLUMNS) * CELL[1]
        with open(file, "w", encoding="utf-8") as out:
            out.write(f'''<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}">
<style>
text {{ font: 13px sans-serif; fill: #20242c }}
polyline {{ fill: none }}
.floor {{ stroke: #d4d8e0 }} .before {{ stroke: #9aa2b0; stroke-width: 1.4 }}
.after {{ stroke: #c65b00; stroke-width: 2 }} .view {{ stroke: #0a62c4 }}
.begin {{ fill: #c65b00 }} .dot {{ fill: #6b7484 }}
</style>
<rect width="100%" height="100%" fill="#fcfcfd"/>
''' + "\n".join(self.cells) + "\n</svg>\n")


def recorded(file, hand):
    """Poses as somebody records them, with noise, or draws them; their places."""
    random.seed(4)
    places = []
    with open(file, "w", encoding="ascii") as out:
        for number in range(300):
            t = number / 299
            noise = 0.004 if hand else 0.0
            place = [-0.9 + 1.8 * t, 0.3 * math.sin(6.5 * t), 0.5 * math.cos(4 * t)]
            place = [value + random.uniform(-noise, noise) for value in place]
            turn = 0.9 * math.sin(4 * t) if hand else 0.0
            places.append(place)
            out.write(" ".join(f"{value:.6f}" for value in (
                *place, math.sin(turn), 0, -math.cos(turn), 0, 1, 0, 24)) + "\n")
    return places[::6]


def main(vides, picture):
    """Makes them."""
    with tempfile.TemporaryDirectory() as folder:
        cells = Cells(vides, folder)
        for move in MOVES:
            options = ["--seconds", "6"] if move != "pan" else []
            cells.add(move, cells.made(move, move, *options))
        poses = os.path.join(folder, "drawn.txt")
        places = recorded(poses, False)
        cells.add("draw", cells.made("draw", "fit", poses), dots=places)
        way = cells.made("way", "arc", "--radius", "0.8", "--from", "200",
                         "--to", "20", "--height", "0.3")
        high = cells.made("high", "turn", way, "--angle", "25", "--axis", "x")
        for name, arguments in (
                ("move", ("move", way, "--by", "0.3,0.3,0")),
                ("turn", ("turn", way, "--angle", "60")),
                ("scale", ("scale", way, "--factor", "0.5")),
                ("mirror", ("mirror", way, "--axis", "x")),
        ):
            cells.add(name, cells.made(name, *arguments), way)
        lattice = [c for k in range(4) for j in range(4) for i in range(4)
                   for c in ((i - 1.5) / 1.5, (j - 1.5) / 1.5 + (1.5 if i in (1, 2) else 0),
                             (k - 1.5) / 1.5)]
        for name, arguments in (
                ("taper", ("--axis", "x", "--r1", "0.3")), ("bulge", ("--axis", "x")),
                ("twist", ("--axis", "x", "--angle", "180")),
                ("bend", ("--axis", "z", "--angle", "120")),
                ("free-form", ("--lattice", ",".join(map(str, lattice))))):
            before = way if name == "bulge" else high
            cells.add(name.replace("-", " "), cells.made(name, name, before, *arguments), before)
        block = cells.made("block", "extract", way, "--first", "2", "--last", "4")
        cells.add("extract", block, way)
        short = cells.made("short", "scale", cells.made("8", "figure-eight", "--width", "0.5"),
                           "--factor", "0.6", "--with-targets")
        cells.add("insert", cells.made("insert", "insert", way, short, "--fit", "turn"), way)
        cells.add("reverse", cells.made("reverse", "reverse", way))
        step = cells.made("step", "scale", way, "--factor", "0.4", "--with-targets")
        step = cells.made("moved", "move", step, "--by", "-0.5,-0.2,0", "--with-targets")
        cells.add("repeat", cells.made("repeat", "repeat", step, "--times", "3"), step)
        other = cells.made("other", "mirror", way, "--axis", "z")
        cells.add("blend", cells.made("blend", "blend", way, other, "--weight", "0.4"), way)
        cells.add("frames", cells.made("frames", "frames", way, "--frames", "60"))
        poses = os.path.join(folder, "recorded.txt")
        places = recorded(poses, True)
        fitted = cells.made("fit", "fit", poses, "--tolerance", "0.02", "--angle", "1")
        cells.add("fit", fitted, dots=places)
        cells.write(picture)


if __name__ == "__main__":
    main(os.path.abspath(sys.argv[1]), sys.argv[2])
