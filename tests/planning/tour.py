"""Tours of meshes that others made, against rays: tour.py VIDES FOLDER MESH…

VIDES is the command. Each mesh (.off, or the name of one of pyvista's examples) gets a tour. Rays
of Embree (by trimesh) then count anew what the flight's places see, and what any of 10,000 random
places outside can see; `vides check` looks at the flight; the same is made a second time. The first
mesh is divided until it has a million triangles, to hold the time against as many rays. Ends with
status 1 if what is told is off by more than 2 %, less than 0.95 of what can be seen is shown,
something is found, the bytes differ, or the tour takes more than a tenth of the time of the rays.
"""

import os
import pathlib
import re
import subprocess
import sys
import time
import tomllib

import numpy as np
import trimesh

vides, folder = sys.argv[1], pathlib.Path(sys.argv[2])
folder.mkdir(parents=True, exist_ok=True)
LEAST = 0.1  # what is smaller in the picture than so much of its size at the tour's distance
RANDOM = 10_000


def loaded(name):
    if os.path.exists(name):
        return trimesh.load(name, process=False, force="mesh")
    import pyvista

    path = os.path.join(os.path.dirname(pyvista.__file__), "examples", name)
    return trimesh.load(path, process=False, force="mesh")


class Object:
    """A mesh whose triangles are seen from the outer side."""

    def __init__(self, mesh):
        self.mesh = mesh
        a, b, c = mesh.vertices[mesh.faces].transpose(1, 0, 2)
        normal = np.cross(b - a, c - a)
        length = np.linalg.norm(normal, axis=1)
        self.areas, self.middles = length / 2, (a + b + c) / 3
        self.normals = normal / np.maximum(length, 1e-300)[:, None]
        if np.sum(((self.middles - self.middles.mean(0)) * normal)) < 0:
            self.normals = -self.normals
        self.half = np.linalg.norm(np.ptp(mesh.vertices, axis=0)) / 2
        self.rays = trimesh.ray.ray_pyembree.RayMeshIntersector(mesh)

    def seen(self, eye, which):
        """Which of some triangles nothing hides from a place; how slanted and how far they are."""
        way = eye - self.middles[which]
        far = np.linalg.norm(way, axis=1)
        way /= far[:, None]
        slant = np.sum(way * self.normals[which], axis=1)
        seen = slant > 0.02
        at = np.flatnonzero(seen)
        start = self.middles[which[at]] + 1e-5 * self.half * way[at]
        met = self.rays.intersects_any(start, way[at])
        behind = np.flatnonzero(met)
        if len(behind):  # what is met may lie beyond the eye
            hits, rays, _ = self.rays.intersects_location(start[behind], way[at][behind], multiple_hits=False)
            away = np.full(len(behind), np.inf)
            away[rays] = np.linalg.norm(hits - start[behind][rays], axis=1)
            met[behind] = away < far[at][behind]
        seen[at[met]] = False
        return seen, slant, far


def shown(thing, path, distance):
    """The triangles that the points of a path show in pictures of 36 × 24 mm, 24 mm lens."""
    all_seen = np.zeros(len(thing.areas), bool)
    for point in path["point"]:
        eye = np.array(point["position"])
        for view in point["orientation"]:
            ahead = np.array(view["target"]) - eye
            ahead /= np.linalg.norm(ahead)
            right = np.cross(ahead, [0, 1, 0])
            right /= np.linalg.norm(right)
            way = thing.middles - eye
            depth = way @ ahead
            beside, above = np.abs(way @ right), np.abs(way @ np.cross(right, ahead))
            which = np.flatnonzero((depth > 0) & (beside < 0.75 * depth) & (above < 0.5 * depth))
            seen, slant, far = thing.seen(eye, which)
            large = slant * np.minimum(1, (distance / far) ** 2) > LEAST
            all_seen[which[seen & large]] = True
    return all_seen


def visible(thing, rng):
    """The triangles that any of many random places outside see."""
    found = np.zeros(len(thing.areas), bool)
    middle = thing.mesh.bounds.mean(0)
    for k in range(RANDOM):
        way = rng.normal(size=3)
        eye = middle + way / np.linalg.norm(way) * thing.half * (1 + 3 * rng.random())
        left = np.flatnonzero(~found)
        if len(left) > 3000 and k > 300:
            left = rng.choice(left, 3000, replace=False)
        if not len(left):
            break
        found[left[thing.seen(eye, left)[0]]] = True
    return found


def tour(mesh, name, *options):
    """The path's file, what was told, and the seconds that it took."""
    file, out = folder / f"{name}.ply", folder / f"{name}{''.join(options)}.vid"
    mesh.export(file)
    start = time.perf_counter()
    done = subprocess.run([vides, "tour", file, "-o", out, *options], capture_output=True, text=True)
    took = time.perf_counter() - start
    if done.returncode:
        sys.exit(f"{name}: {done.stderr}")
    return out, done.stderr, took


failed = 0
print("mesh | triangles | places | told | rays | of 10,000 places | findings | s")
for name in sys.argv[3:]:
    thing = Object(loaded(name))
    stem = pathlib.Path(name).stem
    out, said, took = tour(thing.mesh, stem)
    first = out.read_bytes()
    stills = tomllib.loads(tour(thing.mesh, stem, "--stills")[0].read_text())
    places = int(re.search(r": (\d+) places? show", said)[1])
    told = float(re.search(r"whole surface ([\d.]+) %", said)[1]) / 100
    distance = float(re.search(r"from a distance of ([\d.e+-]+)", said)[1])
    seen = shown(thing, stills, distance)
    can = visible(thing, np.random.default_rng(1))
    rays = thing.areas[seen].sum() / thing.areas.sum()
    share = thing.areas[seen & can].sum() / thing.areas[can].sum()
    found = subprocess.run([vides, "check", out], capture_output=True, text=True)
    same = tour(thing.mesh, stem)[0].read_bytes() == first
    good = abs(rays - told) <= 0.02 and share >= 0.95 and found.returncode == 0 and same
    failed += not good
    print(
        f"{stem} | {len(thing.areas)} | {places} | {told:.3f} | {rays:.3f} | {share:.3f} |",
        f"{found.stdout.strip() or 'none'} | {took:.2f}{'' if same else ' DIFFERENT BYTES'}",
        "" if good else " <--",
        flush=True,
    )

mesh = loaded(sys.argv[3])
while len(mesh.faces) < 1_000_000:
    mesh = mesh.subdivide()
mesh = trimesh.Trimesh(mesh.vertices, mesh.faces[:1_000_000], process=False)
_, said, took = tour(mesh, "million")
thing = Object(mesh)
# As many rays as triangles were held against pictures: those of a few, scaled.
pictures = 150
start = time.perf_counter()
for eye in np.eye(3):
    way = thing.mesh.bounds.mean(0) + 4 * thing.half * eye - thing.middles
    thing.rays.intersects_any(thing.middles + 1e-5 * way, way)
rays = (time.perf_counter() - start) / 3 * pictures
print(f"1,000,000 triangles: {took:.1f} s; as many rays by Embree, from {pictures} places: {rays:.1f} s")
failed += took > rays / 10
sys.exit(failed > 0)
