"""Eight flights, each with a picture, a page that plays it and its file: gallery.py VIDES FOLDER

The meshes and the recording are made here, so that nothing has to be downloaded.
"""
import math
import random
import shutil
import subprocess
import sys
from html import escape
from pathlib import Path

from reference import STYLE

ROOT = Path(__file__).resolve().parent.parent
GRID = """
main { display: grid; grid-template-columns: repeat(auto-fill, minmax(22rem, 1fr)); gap: 1.5rem }
body { max-width: 80rem } img { width: 100% } pre { white-space: pre-wrap }
"""


# ---- Meshes: vertices, and faces that count from 0 ----------------------------

def write_obj(file, *parts):
    """Writes meshes as one OBJ file."""
    with open(file, "w") as out:
        first = 1
        for vertices, faces in parts:
            out.writelines("v %.6g %.6g %.6g\n" % tuple(vertex) for vertex in vertices)
            out.writelines("f " + " ".join(str(first + k) for k in face) + "\n" for face in faces)
            first += len(vertices)


def grid(rows, columns, place, around=True):
    """A surface over a grid of two parameters from 0 to 1; `around` closes it both ways."""
    steps = (rows, columns) if around else (rows - 1, columns - 1)
    vertices = [place(row / steps[0], column / steps[1]) for row in range(rows) for column in range(columns)]
    number = lambda row, column: row % rows * columns + column % columns
    faces = [[number(row, column), number(row, column + 1), number(row + 1, column + 1), number(row + 1, column)]
             for row in range(steps[0]) for column in range(steps[1])]
    return vertices, faces


def knot(along, around):
    """A tube along a trefoil knot."""
    def centre(t):
        t *= 2 * math.pi
        return (math.sin(t) + 2 * math.sin(2 * t), -math.sin(3 * t), math.cos(t) - 2 * math.cos(2 * t))

    here, ahead = centre(along), centre(along + 1e-4)
    forward = unit([b - a for a, b in zip(here, ahead)])
    side = unit(cross(forward, (0, 1, 0)))
    over = cross(side, forward)
    angle = 2 * math.pi * around
    return [p + 0.45 * (math.cos(angle) * s + math.sin(angle) * o) for p, s, o in zip(here, side, over)]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def unit(v):
    length = math.hypot(*v)
    return [x / length for x in v]


def ball(centre, radius, rings=10):
    def place(down, round_):
        polar, angle = math.pi * (0.02 + 0.96 * down), 2 * math.pi * round_
        direction = (math.sin(polar) * math.cos(angle), math.cos(polar), math.sin(polar) * math.sin(angle))
        return [c + radius * d for c, d in zip(centre, direction)]
    return grid(rings, 2 * rings + 1, place, around=False)


def box(low, high):
    corners = [[(low, high)[k >> axis & 1][axis] for axis in range(3)] for k in range(8)]
    return corners, [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]


def house():
    """Two rooms and a corridor, with doors of one metre between them."""
    walls = [((0, 0, 0), (10, 3, 0.2)), ((0, 0, 7.8), (10, 3, 8)), ((0, 0, 0), (0.2, 3, 8)), ((9.8, 0, 0), (10, 3, 8)),
             ((4.9, 0, 0), (5.1, 3, 3.5)), ((4.9, 0, 4.5), (5.1, 3, 8)),
             ((5, 0, 4.9), (8, 3, 5.1)), ((9, 0, 4.9), (10, 3, 5.1)),
             ((0, -0.1, 0), (10, 0, 8)), ((1, 0, 5.5), (2.5, 0.8, 7)), ((6, 0, 1), (7.5, 0.9, 2)),
             ((5.5, 0, 6.6), (6.6, 1.2, 7.4))]
    return [box(low, high) for low, high in walls]


# Caffeine, without its hydrogen: elements and places in ångström, in one plane but for the rings' bend.
ATOMS = [("N", 1.05, 0.00, -1.33), ("C", 2.18, 0.05, -0.55), ("N", 2.04, 0.08, 0.82), ("C", 0.77, 0.05, 1.43),
         ("C", -0.34, 0.00, 0.60), ("C", -0.20, -0.02, -0.76), ("N", -1.46, -0.06, -1.28), ("C", -2.29, -0.06, -0.22),
         ("N", -1.67, -0.03, 0.93), ("O", 3.29, 0.06, -1.07), ("O", 0.68, 0.07, 2.66), ("C", 1.17, -0.03, -2.79),
         ("C", 3.24, 0.12, 1.65), ("C", -1.83, -0.09, -2.68)]
RADII = {"C": 0.42, "N": 0.40, "O": 0.38}


def molecule():
    atoms = [ball(place, RADII[element]) for element, *place in ATOMS]
    bonds = []
    for k, (_, *a) in enumerate(ATOMS):
        for _, *b in ATOMS[:k]:
            if math.dist(a, b) < 1.6:
                bonds += [ball([p + (q - p) * t / 8 for p, q in zip(a, b)], 0.13, 5) for t in range(9)]
    return atoms + bonds


def height(x, y):
    """A valley between two ridges, in metres."""
    ridge = 900 * math.exp(-((y - 1400 - 300 * math.sin(x / 900)) / 500) ** 2)
    other = 700 * math.exp(-((y + 1300 + 250 * math.cos(x / 700)) / 450) ** 2)
    return 200 + ridge + other + 60 * math.sin(x / 210) * math.sin(y / 180) + x / 20


# ---- Flights made by hand -------------------------------------------------------

def vid(points, ahead, **more):
    """A path as text: points, and how far ahead on the path the camera looks."""
    text = ["version = 1", "fps = 25.0"] + [f"{key} = {value}" for key, value in more.items()]
    for point in points:
        text.append("\n[[point]]\nposition = [%g, %g, %g]" % tuple(point))
        text.append(f"\n[[point.orientation]]\nahead = {ahead}")
    return "\n".join(text) + "\n"


def recording(file):
    """A handheld walk around the knot: a pose each 25th of a second, with a hand that shakes."""
    hand = random.Random(1994)
    sway = [0.0] * 6
    with open(file, "w") as out:
        for frame in range(400):
            sway = [0.86 * s + hand.gauss(0, 0.012) for s in sway]
            angle = 1.5 * math.pi * frame / 399
            position = [6.5 * math.sin(angle) + sway[0], 1.5 + 0.5 * math.sin(3 * angle) + sway[1],
                        6.5 * math.cos(angle) + sway[2]]
            forward = unit([-position[0] + 3 * sway[3], -position[1] + 3 * sway[4], -position[2] + 3 * sway[5]])
            up = cross(unit(cross(forward, (0, 1, 0))), forward)
            out.write(" ".join("%.6f" % v for v in (*position, *forward, *up, 35)) + "\n")


# ---- The gallery ------------------------------------------------------------------

class Gallery:
    def __init__(self, vides, folder):
        self.vides, self.folder, self.parts = str(Path(vides).resolve()), Path(folder), []
        shutil.rmtree(folder, ignore_errors=True)
        self.folder.mkdir(parents=True)

    def flight(self, name, title, text, *commands, picture=None):
        """Makes a flight by commands of `vides`; the last one writes NAME.vid."""
        if picture:
            shutil.copyfile(picture, self.folder / Path(picture).name)
        else:
            commands = [*commands, f"plot {name}.vid -o {name}.svg"]
        commands = [*commands, f"convert {name}.vid {name}.html"]
        picture = Path(picture).name if picture else f"{name}.svg"
        for command in commands:
            subprocess.run([self.vides, *command.split()], cwd=self.folder, check=True)
        lines = "\n".join(f"vides {command}" for command in commands)
        self.parts.append(f'<section><h2>{title}</h2><a href="{name}.html"><img src="{picture}" alt="{title}"></a>'
                          f'<p>{text} <a href="{name}.html">Play it</a> · <a href="{name}.vid">{name}.vid</a></p>'
                          f"<pre>{escape(lines)}</pre></section>")

    def write(self):
        (self.folder / "index.html").write_text(f"""<!DOCTYPE html>
<html lang="en"><meta charset="utf-8"><meta name="viewport" content="width=device-width">
<title>VIDES: gallery</title><style>{STYLE}{GRID}</style>
<body><h1>Gallery</h1><p>Eight flights and the commands that made them. A picture opens the flight: Space plays it.</p>
<main>{"".join(self.parts)}</main></body></html>
""")


def main(vides, folder):
    gallery = Gallery(vides, folder)
    at = gallery.folder
    write_obj(at / "knot.obj", grid(240, 16, knot))
    write_obj(at / "house.obj", *house())
    write_obj(at / "caffeine.obj", *molecule())
    write_obj(at / "valley.obj", grid(90, 90, lambda u, v: [
        *(place := (-2500 + 5000 * u, -2500 + 5000 * v)), height(*place)], around=False))
    gallery.flight(
        "orbit", "Orbit an object", "One turn around the object, at a height of your choice.",
        "orbit --object knot.obj --height 2 --seconds 12 -o orbit.vid")
    gallery.flight(
        "tour", "A tour by itself", "VIDES finds views that show the whole surface and a short round through them.",
        "tour knot.obj --seconds 30 -o tour.vid")
    rooms = [(1.5, 1.6, 1.5), (3.2, 1.6, 3.2), (7.2, 1.6, 3.4), (8.2, 1.6, 6.4)]
    (at / "rooms.vid").write_text(vid(rooms, 1.0, **{"space": "{ centre = [5, 1.5, 4], half_size = 5.5 }",
                                                       "object": '{ file = "house.obj" }'}))
    gallery.flight(
        "house", "Through a house", "A path through two doors, moved so that the camera keeps 30 cm from every wall.",
        "avoid rooms.vid --clearance 0.3 -o clear.vid", "retime clear.vid --seconds 20 -o house.vid")
    gallery.flight(
        "dolly_zoom", "Dolly zoom", "The camera comes closer and zooms out; the object keeps its size.",
        "dolly-zoom --object knot.obj --seconds 6 -o dolly_zoom.vid")
    recording(at / "recording.txt")
    gallery.flight(
        "recorded", "A recording, cleaned", "A handheld recording of 400 poses, stabilised: few points, easy to edit.",
        "fit recording.txt --tolerance 0.02 --object knot.obj -o fitted.vid",
        "steady fitted.vid --period 2 -o recorded.vid")
    gallery.flight(
        "molecule", "A molecule", "A spiral around caffeine, zoomed so that the molecule fills the picture.",
        "spiral --object caffeine.obj --turns 1.5 --seconds 15 -o spiral.vid",
        "picture spiral.vid -o molecule.vid")
    track = [(-2200, -300), (-1200, 150), (-200, -150), (800, 200), (1800, -50)]
    over = [(x, y, height(x, y) + 260) for x, y in track]
    (at / "track.vid").write_text(vid(over, 300.0, **{
        "space": '{ centre = [0, 0, 600], half_size = 2600, up = "z" }', "object": '{ file = "valley.obj" }'}))
    gallery.flight(
        "terrain", "A flight over terrain", "Along a valley, in metres with z up; it stays 120 m above ground.",
        "avoid track.vid --clearance 120 -o above.vid", "retime above.vid --seconds 30 -o terrain.vid")
    shutil.copyfile(ROOT / "examples/car.vid", at / "scene.vid")
    gallery.flight("car", "A scene", "A car with turning wheels and lamps, an arm, a camera that aims at the car.",
                   "convert scene.vid car.vid", picture=ROOT / "docs/reference/scene.png")
    gallery.write()


if __name__ == "__main__":
    main(*sys.argv[1:])
